//! The engine behind the window: draws the panes, probes them, and caches the results as textures until something
//! changes.

mod normals;
mod pane;
mod refined;

use crate::analysis::comparison::{
    Brightest, ErrorFigures, PaneFigures, brightest, difference_picture, difference_scale,
    error_figures,
};
use crate::analysis::curves::Curves;
use crate::analysis::normals::NormalField;
use crate::analysis::overlay::{OverlayOptions, free_corners};
use crate::analysis::probe::{Overlay, Probe};
use crate::analysis::scan::{Scan, ScanError, scan_drawn};
use crate::app::session::Session;
use crate::app::session::appearance::{Overlays, ViewName};
use crate::app::session::place::ProbePoint;
use crate::app::session::window::WindowState;
use crate::figure::Area;
use crate::geometry::Mesh;
use crate::render::{DrawTime, Frame, FrameReport, Term, transmits};
use crate::scene::{AmbientSource, CompareView, DifferenceKind, Image, Scene};
use crate::text;
use crate::text::Language;
use eframe::egui::{Context, TextureHandle, TextureOptions};
use glam::DVec2;
pub use pane::{drawing, image_of, overlay_options, upload};
#[cfg(target_arch = "wasm32")]
pub use refined::Supersampled;

use normals::NormalsDrawing;
use pane::{PaneEngine, Wanted, is_dark, lettering};
use refined::Refined;
#[cfg(not(target_arch = "wasm32"))]
use refined::Supersampled;
use std::cell::OnceCell;

/// The expected time to draw a picture from which on it waits for the next frame, nanoseconds.
const LONG: u64 = 50_000_000;

/// The pictures of the window: panes, probes and overlays.
#[derive(Default)]
pub struct Engine {
    /// The engines of the panes, by pane index; the active one always exists.
    panes: Vec<PaneEngine>,
    /// The indices of the shown panes.
    pub shown: Vec<usize>,
    active: usize,
    /// The size of each pane at full resolution, pixels.
    pub size: [u32; 2],
    /// The figures of the shown panes, in their order; the reference has no error. Empty if nothing is compared.
    pub figures: Vec<PaneFigures>,
    /// The reference pane of the figures, and the language of the panes' names in them.
    measured: Option<(usize, Language)>,
    /// The difference picture as last drawn, and its parameters.
    difference: Option<(TextureHandle, (DifferenceKind, f64, f32))>,
    overlay: Option<DrawnOverlay>,
    normals: NormalsDrawing,
    refined: Refined,
    terms: OnceCell<Vec<Term>>,
    /// True if a picture that takes long waits for the next frame.
    deferred: bool,
    /// A counter that increases whenever a picture or the probe has changed.
    pub revision: u64,
}

/// Returns whether each pixel of a scene may take many rays.
fn takes_rays(scene: &Scene, model: Option<&Mesh>) -> bool {
    let transparent = transmits(scene, model);
    scene.shading.shadows || transparent || scene.ambient.source != AmbientSource::Constant
}

/// The overlay as last drawn, and its inputs.
struct DrawnOverlay {
    texture: TextureHandle,
    overlay: Overlay,
    size: [u32; 2],
    /// The overlays, with the light's index, whether the background is dark, the scale of the letters, and the areas
    /// that handles cover.
    appearance: (Overlays, usize, bool, f64, Vec<Area>),
}

impl Engine {
    pub fn new() -> Self {
        Self {
            panes: vec![PaneEngine::default()],
            ..Self::default()
        }
    }

    /// Updates pictures, probes and the overlay for panes of `size` pixels each; keeps what has not changed. With
    /// `smooth`, edges are antialiased when nothing changes.
    pub fn update(
        &mut self,
        ctx: &Context,
        session: &Session,
        window: &mut WindowState,
        size: [u32; 2],
        smooth: bool,
    ) {
        let size = size.map(|side| side.clamp(1, Image::MAX_SIDE));
        let shown = session.document().scene.shown_panes();
        let count = shown.iter().max().map_or(1, |last| last + 1);
        let before = self.active;
        self.active = session.panes.active.min(count - 1);
        self.panes.resize_with(count, PaneEngine::default);
        let several = shown.len() > 1;
        let pixel = window.probe.pixel(size);
        let model = session.document().model.as_ref();
        let (mut redrawn, mut reprobed) = (false, false);
        let wanted: Vec<(usize, Wanted<'_>)> = shown
            .iter()
            .map(|&pane| {
                (
                    pane,
                    Wanted {
                        scene: session.panes.scene(pane),
                        model,
                        size,
                        linear: several,
                    },
                )
            })
            .collect();
        // While something is dragged, the pictures keep up with the pointer, at a lower resolution if necessary.
        let held = ctx.input(|input| input.pointer.any_down());
        let expected = wanted
            .iter()
            .map(|(pane, wanted)| self.panes[*pane].expected(wanted))
            .fold(DrawTime::default(), |all, time| all + time);
        let coarser = if held { expected.coarseness() } else { 1 };
        // A click is answered first: what is clicked is seen before a picture that takes long is drawn.
        let is_long = |(pane, wanted): &(usize, Wanted<'_>)| {
            let cost = self.panes[*pane].expected(wanted).whole;
            cost > LONG || (cost > 0 && takes_rays(wanted.scene, model.map(|model| &**model)))
        };
        let defers = !held && !self.deferred && wanted.iter().any(is_long);
        self.deferred = defers;
        if defers {
            ctx.request_repaint();
            return;
        }
        self.size = size;
        for (pane, wanted) in &wanted {
            let engine = &mut self.panes[*pane];
            let drawn = engine.draw(ctx, wanted, coarser);
            reprobed |= engine.probe(pixel, drawn);
            redrawn |= drawn;
        }
        if self.panes[self.active].is_finished()
            && std::mem::take(&mut window.seek_highlight)
            && let Some(pixel) = self.panes[self.active].beside_highlight()
        {
            window.probe = ProbePoint::at(pixel, size);
            self.panes[self.active].probe(pixel, false);
            reprobed = true;
        }
        redrawn |= self.shown != shown;
        self.shown = shown;
        reprobed |= before != self.active;
        let measured = Some((session.document().scene.reference_pane(), text::language()));
        if redrawn || self.measured != measured {
            self.measure(&session.document().scene);
            self.measured = measured;
        }
        self.draw_difference(ctx, session, window, redrawn);
        if reprobed || redrawn {
            self.revision += 1;
            self.terms.take();
            // The panels beside the picture were laid out before it was drawn.
            ctx.request_repaint();
        }
        self.draw_overlay(ctx, session, window, reprobed);
        self.normals
            .update(ctx, session, window, self.active, &self.panes[self.active]);
        self.refine(ctx, session, window, redrawn, smooth);
    }

    /// Antialiases the edges of the pictures when nothing changes, unless something over them shows pixels.
    fn refine(
        &mut self,
        ctx: &Context,
        session: &Session,
        window: &WindowState,
        redrawn: bool,
        smooth: bool,
    ) {
        let pixels = window.appearance.overlay.normals()
            || self.difference.is_some()
            || window.shows(ViewName::ScanLine);
        let shown = || self.shown.iter().map(|&pane| &self.panes[pane]);
        let cost = shown().map(PaneEngine::greatest_cost).sum();
        let triangles = shown().map(|pane| pane.report().triangles).sum();
        let coarse = shown().any(|pane| pane.coarser != 1);
        let refines = smooth && !pixels && !coarse && Refined::affords(cost, triangles);
        if redrawn || !refines {
            self.refined.forget();
        }
        if !refines {
            return;
        }
        let Self {
            refined,
            shown,
            panes,
            ..
        } = self;
        refined.update(ctx, |alive| Supersampled {
            panes: shown
                .iter()
                .filter_map(|&pane| Some((pane, panes[pane].drawn()?.clone())))
                .collect(),
            model: session.document().model.clone(),
            alive,
        });
    }

    /// Returns whether the pictures are those of the session's scenes as they are now, to their last row.
    pub fn is_up_to_date(&self, session: &Session) -> bool {
        let mut shown = self.shown.iter();
        shown.all(|&pane| self.panes[pane].shows_all_of(session.panes.scene(pane)))
    }

    /// Returns the samples per pixel of the pictures shown.
    pub fn samples(&self) -> u32 {
        self.refined.samples.max(1)
    }

    /// Highlights the faces of the vertex `near` the pointer, a position and a radius in pixels, or else those of the
    /// kept vertex. A click keeps the vertex under the pointer.
    pub fn point_at(
        &mut self,
        ctx: &Context,
        session: &Session,
        window: &mut WindowState,
        near: Option<(DVec2, f64)>,
        clicked: bool,
    ) {
        let letters = self.overlay.iter().flat_map(|drawn| &drawn.overlay.labels);
        self.normals
            .avoid(letters.map(|label| label.area).collect());
        let pane = &self.panes[self.active];
        self.normals
            .point_at(ctx, session, window, pane, near, clicked);
    }

    fn measure(&mut self, scene: &Scene) {
        self.figures.clear();
        if self.shown.len() < 2 {
            return;
        }
        let last = scene.reference_pane();
        let Some(reference) = self.panes.get(last).and_then(PaneEngine::linear) else {
            return;
        };
        for &pane in &self.shown {
            let Some(picture) = self.panes[pane].linear() else {
                continue;
            };
            let coarser = self.panes[pane].coarser;
            let in_whole = |at: [u32; 2]| at.map(|v| v * coarser + coarser / 2);
            let error = (pane != last).then(|| error_figures(picture, reference));
            let error = error.map(|error| ErrorFigures {
                at: error.at.map(in_whole),
                ..error
            });
            let brightest = brightest(picture).map(|b| Brightest {
                at: in_whole(b.at),
                ..b
            });
            self.figures.push(PaneFigures {
                pane,
                name: scene.pane_name(pane),
                brightest,
                error,
            });
        }
    }

    fn draw_difference(
        &mut self,
        ctx: &Context,
        session: &Session,
        window: &WindowState,
        redrawn: bool,
    ) {
        let compare = &session.document().scene.compare;
        let (&[first, last], CompareView::Difference) = (&self.shown[..], compare.view) else {
            self.difference = None;
            return;
        };
        let appearance = (compare.difference, compare.gain, window.appearance.scale);
        let drawn = self.difference.as_ref().map(|(_, drawn)| drawn);
        if !redrawn && drawn == Some(&appearance) {
            return;
        }
        let (Some(a), Some(b)) = (self.panes[first].linear(), self.panes[last].linear()) else {
            return;
        };
        let mut frame = difference_picture(a, b, compare.difference, compare.gain);
        let em = f64::from(ctx.pixels_per_point()) * f64::from(crate::app::widgets::theme::TEXT);
        let em = em / f64::from(self.panes[first].coarser);
        let size = [frame.width, frame.height];
        difference_scale(size, compare.difference, compare.gain, em).draw_over(&mut frame);
        let mut texture = self.difference.take().map(|(texture, _)| texture);
        let (image, options) = (image_of(&frame), TextureOptions::NEAREST);
        upload(ctx, &mut texture, "difference", image, options);
        self.difference = texture.map(|texture| (texture, appearance));
    }

    fn draw_overlay(
        &mut self,
        ctx: &Context,
        session: &Session,
        window: &WindowState,
        reprobed: bool,
    ) {
        let scene = &session.shown.scene;
        let scale = lettering(ctx, &window.appearance, self.size, 1);
        let appearance = (
            window.appearance.overlay.clone(),
            session.light,
            is_dark(scene),
            scale,
            window.covered.clone(),
        );
        let drawn = self.overlay.as_ref().map(|drawn| &drawn.appearance);
        if !reprobed && drawn == Some(&appearance) {
            return;
        }
        let (size, pane) = (self.size, self.active());
        let options = OverlayOptions {
            scale,
            covered: appearance.4.clone(),
            free_corners: free_corners(pane.renderer().frame()),
            ..overlay_options(&appearance.0, session.light, scene)
        };
        let (Some((_, probe)), Some(scene)) = (&pane.probed, pane.drawn()) else {
            return;
        };
        let overlay = Overlay::new(size, scene, probe, &options);
        let drawn = self.overlay.take();
        // Most sliders move no vector.
        let same = drawn
            .as_ref()
            .is_some_and(|drawn| drawn.size == size && drawn.overlay == overlay);
        let mut texture = drawn.map(|drawn| drawn.texture);
        if let Some(image) = (!same)
            .then(|| drawing(size, |pixmap| overlay.draw(pixmap)))
            .flatten()
        {
            upload(ctx, &mut texture, "overlay", image, TextureOptions::NEAREST);
        }
        self.overlay = texture.map(|texture| DrawnOverlay {
            texture,
            overlay,
            size,
            appearance,
        });
    }

    fn active(&self) -> &PaneEngine {
        &self.panes[self.active]
    }

    /// Returns a pane's picture, or the difference picture.
    pub fn picture(&self, pane: usize) -> Option<&TextureHandle> {
        let difference = self.difference.as_ref().map(|(texture, _)| texture);
        difference
            .or_else(|| self.refined.picture(pane))
            .or_else(|| self.panes.get(pane)?.picture.as_ref())
    }

    /// Returns the layers over the active pane's picture, from the bottom up: needles, vectors, and highlighted faces.
    pub fn overlays(&self) -> [Option<&TextureHandle>; 3] {
        let [needles, lit] = self.normals.textures();
        let overlay = self
            .overlay
            .as_ref()
            .filter(|overlay| overlay.appearance.0.vectors)
            .map(|overlay| &overlay.texture);
        [needles, overlay, lit]
    }

    /// Returns the pane of the side view of the vectors, in the active pane's pixels.
    pub fn side_view(&self) -> Option<Area> {
        let overlay = self.overlay.as_ref()?;
        overlay
            .overlay
            .side_view
            .filter(|_| overlay.appearance.0.vectors)
    }

    /// Returns the active pane's picture as last drawn.
    pub fn frame(&self) -> &Frame {
        self.active().renderer().frame()
    }

    /// Returns the report of the active pane's last drawing.
    pub fn report(&self) -> &FrameReport {
        self.active().report()
    }

    /// Returns the time that drawing the shown panes last took, nanoseconds.
    pub fn nanoseconds(&self) -> u64 {
        self.shown
            .iter()
            .filter_map(|&pane| self.panes.get(pane))
            .map(|pane| pane.report().nanoseconds)
            .sum()
    }

    /// Returns the downscale factor of the pictures shown: above 1 while something is dragged and full resolution would
    /// not keep up.
    pub fn coarser(&self) -> u32 {
        self.active().coarser
    }

    /// Returns the plan of the active pane's picture, term by term; computed on first use.
    pub fn terms(&self) -> &[Term] {
        self.terms.get_or_init(|| self.active().renderer().terms())
    }

    /// Returns the materials of the active pane's model, each with its evaluations.
    pub fn material_counts(&self) -> Vec<(String, u64)> {
        self.active().renderer().material_counts()
    }

    /// Returns the curves that apply at the probe, for the light of index `light`.
    pub fn curves(&self, light: usize) -> Option<Curves> {
        let pane = self.active();
        let ((_, probe), scene) = (pane.probed.as_ref()?, pane.drawn()?);
        Some(Curves::new(pane.renderer(), scene, probe, light))
    }

    /// Returns the active pane's scene as last drawn, in the picture's size.
    pub fn drawn(&self) -> Option<&Scene> {
        self.active().drawn()
    }

    /// Returns the polygon under the probe.
    pub fn probed_face(&self) -> Option<u32> {
        let pane = self.active();
        let (pixel, probe) = pane.probed.as_ref()?;
        let [x, y] = pixel.map(|v| v / pane.coarser);
        let face = probe.hit.as_ref()?.face;
        face.or_else(|| pane.renderer().polygon_at(x, y))
    }

    /// Scans a polygon of the picture in this many rows.
    pub fn scan(&self, face: u32, rows: u32) -> Option<Result<Scan, ScanError>> {
        let (renderer, scene) = (self.active().renderer(), self.drawn()?);
        Some(scan_drawn(renderer, scene, face, rows))
    }

    /// Sets `known` to the normals of the active pane's picture, unless it already holds them.
    pub fn update_field(&self, known: &mut Option<NormalField>) {
        let renderer = self.active().renderer();
        let Some(scene) = self.drawn() else { return };
        let same = |field: &NormalField| field.holds(renderer, &scene.object);
        if !known.as_ref().is_some_and(same) {
            *known = Some(NormalField::new(renderer, &scene.object));
        }
    }

    /// Returns the probe of the active pane, with the equation at its pixel.
    pub fn probed(&self) -> Option<&Probe> {
        self.active().probed.as_ref().map(|(_, probe)| probe)
    }
}
