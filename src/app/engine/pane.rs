//! One pane's picture, drawn and probed, and cached until something changes.
//!
//! If drawing at full resolution would not keep up with the pointer, a downscaled picture is drawn while the pointer is
//! held. It has a renderer of its own, so that the full picture's stages stay cached.

use crate::analysis::comparison::LinearPicture;
use crate::analysis::overlay::{Halo, OverlayLayer, OverlayOptions, overlay_letters};
use crate::analysis::probe::{Probe, pixel_beside_highlight, probe};
use crate::app::session::appearance::{Appearance, Overlays};
use crate::app::session::document::same_model;
use crate::app::widgets::theme::TEXT;
use crate::geometry::Mesh;
use crate::jobs::{at_once, nanoseconds};
use crate::render::{DrawTime, Frame, FrameReport, Renderer, coarser_size};
use crate::scene::{Rgb, Scene};
use eframe::egui::{ColorImage, Context, ImageData, TextureHandle, TextureOptions};
use std::sync::Arc;

/// The time for which the pixels of a picture are shaded before the window answers again, nanoseconds.
const SLICE: u64 = 200_000_000;

/// A renderer, and the last picture that it drew.
struct Drawing {
    renderer: Renderer,
    model: Option<Arc<Mesh>>,
    drawn: Option<Scene>,
    /// The tables of the scene file that had changed before it.
    changed: Vec<&'static str>,
    linear: bool,
    report: FrameReport,
}

impl Default for Drawing {
    fn default() -> Self {
        Self {
            renderer: Renderer::with_clock(nanoseconds),
            model: None,
            drawn: None,
            changed: vec![],
            linear: false,
            report: FrameReport::default(),
        }
    }
}

impl Drawing {
    /// Returns whether the last picture is that of `wanted` at `size` pixels, finished or not; the size in a scene is that of
    /// exported pictures.
    fn is_of(&self, wanted: &Wanted<'_>, size: [u32; 2]) -> bool {
        let sized = self
            .drawn
            .as_ref()
            .is_some_and(|drawn| drawn.image.size == size);
        let same = same_model(self.model.as_ref(), wanted.model) && self.linear == wanted.linear;
        sized && same && self.changed_parts(wanted.scene).is_empty()
    }

    /// Returns the tables of a scene file in which a scene differs from the one drawn last, as far as the picture
    /// depends on them.
    fn changed_parts(&self, scene: &Scene) -> Vec<&'static str> {
        let Some(drawn) = &self.drawn else {
            return vec!["all"];
        };
        let differences = drawn
            .differences(scene)
            .filter(|(parameter, _)| parameter.key != "image.size");
        let mut parts: Vec<_> = differences
            .map(|(parameter, _)| parameter.section())
            .collect();
        parts.retain(|part| !["about", "compare"].contains(part));
        parts.dedup();
        parts
    }

    /// Returns whether the last picture is that of `wanted` at `size` pixels, to its last row.
    fn shows(&self, wanted: &Wanted<'_>, size: [u32; 2]) -> bool {
        self.renderer.is_finished() && self.is_of(wanted, size)
    }

    /// Draws the picture, or goes on with it, for a while, unless it is already drawn.
    fn draw(&mut self, wanted: &Wanted<'_>, size: [u32; 2]) {
        if self.shows(wanted, size) {
            return;
        }
        let before = if self.is_of(wanted, size) {
            self.report.nanoseconds
        } else {
            self.changed = self.changed_parts(wanted.scene);
            0
        };
        if !same_model(self.model.as_ref(), wanted.model) {
            self.model = wanted.model.cloned();
            self.renderer.set_model(self.model.clone());
        }
        self.linear = wanted.linear;
        self.renderer.keep_linear(wanted.linear);
        let mut sized = wanted.scene.clone();
        sized.image.size = size;
        let renderer = &mut self.renderer;
        at_once(|| _ = renderer.render_for(&sized, SLICE));
        self.report = self.renderer.report().clone();
        self.report.nanoseconds += before;
        self.drawn = Some(sized);
    }
}

/// The picture that a pane is to show.
pub struct Wanted<'a> {
    pub scene: &'a Scene,
    pub model: Option<&'a Arc<Mesh>>,
    /// The size at full resolution, pixels.
    pub size: [u32; 2],
    /// True if the linear picture, before the display, is kept too.
    pub linear: bool,
}

/// The number of images: one is shown while another is filled.
const IMAGES: usize = 2;

/// A pane with renderers of its own, so that each pane's stages stay cached.
#[derive(Default)]
pub struct PaneEngine {
    whole: Drawing,
    /// The downscaled picture, while something is dragged.
    draft: Option<Drawing>,
    /// The downscale factor of the picture shown; 0 before anything is drawn.
    pub coarser: u32,
    /// The time of a picture after a change of these parts.
    costs: Vec<(Vec<&'static str>, DrawTime)>,
    pub picture: Option<TextureHandle>,
    /// The images of the pictures, at most [`IMAGES`].
    images: Vec<Arc<ColorImage>>,
    pub probed: Option<([u32; 2], Probe)>,
}

impl PaneEngine {
    /// Returns the expected time to draw `wanted`: that after the last change of the same parts, or else the longest; 0 if it is
    /// already drawn.
    pub fn expected(&self, wanted: &Wanted<'_>) -> DrawTime {
        let parts = self.whole.changed_parts(wanted.scene);
        if parts.is_empty() {
            return DrawTime::default();
        }
        self.time_of(&parts)
    }

    fn time_of(&self, parts: &[&'static str]) -> DrawTime {
        let known = self.costs.iter().find(|(known, _)| known == parts);
        let longest = || self.costs.iter().max_by_key(|(_, time)| time.whole);
        known
            .or_else(longest)
            .map_or_else(DrawTime::default, |(_, time)| *time)
    }

    /// Returns the maximum time that a picture at full resolution took, nanoseconds.
    pub fn greatest_cost(&self) -> u64 {
        let all = self.costs.iter().map(|(_, time)| time.whole);
        all.max().unwrap_or(0)
    }

    /// Updates the picture, downscaled by the factor `coarser`; returns whether the picture shown has changed.
    pub fn draw(&mut self, ctx: &Context, wanted: &Wanted<'_>, coarser: u32) -> bool {
        let size = coarser_size(wanted.size, coarser);
        if self.coarser == coarser && self.shown().shows(wanted, size) {
            return false;
        }
        self.coarser = coarser;
        if coarser > 1 {
            let draft = self.draft.get_or_insert_default();
            // The first picture of a size prepares more than those after it.
            let first = draft.drawn.as_ref().map(|drawn| drawn.image.size) != Some(size);
            draft.renderer.stand_in(coarser);
            draft.draw(wanted, size);
            let took = draft.report.nanoseconds;
            let parts = self.whole.changed_parts(wanted.scene);
            let time = self.time_of(&parts).after(coarser, took);
            // Not every stage scales with the picture: if it is still too slow, the next one is drawn coarser.
            if !first && time.coarseness() > coarser {
                self.remember(parts, time);
            }
        } else if !self.whole.shows(wanted, size) {
            self.whole.draw(wanted, size);
            let parts = self.whole.changed.clone();
            // The next drag may be of anything else.
            if parts.contains(&"all") || parts.contains(&"object") {
                self.draft = None;
            }
            let whole = self.whole.report.nanoseconds;
            self.remember(parts, DrawTime { whole, fixed: 0 });
        }
        // A downscaled picture is magnified smoothly.
        let options = if coarser > 1 {
            TextureOptions::LINEAR
        } else {
            TextureOptions::NEAREST
        };
        let image = self.image();
        upload(ctx, &mut self.picture, "picture", image, options);
        true
    }

    /// Returns an image of the picture shown, reusing an earlier image if possible.
    fn image(&mut self) -> Arc<ColorImage> {
        // The last picture's image may still be on its way to the texture.
        let free = self
            .images
            .iter_mut()
            .position(|image| Arc::get_mut(image).is_some());
        let mut image = free.map_or_else(Arc::default, |index| self.images.swap_remove(index));
        let frame = self.shown().renderer.frame();
        let size = [frame.width as usize, frame.height as usize];
        match Arc::get_mut(&mut image).filter(|image| image.size == size) {
            Some(image) => image
                .as_raw_mut()
                .copy_from_slice(frame.pixels.as_flattened()),
            None => image = Arc::new(image_of(frame)),
        }
        self.images.truncate(IMAGES - 1);
        self.images.push(Arc::clone(&image));
        image
    }

    fn remember(&mut self, parts: Vec<&'static str>, time: DrawTime) {
        self.costs.retain(|(known, _)| *known != parts);
        self.costs.push((parts, time));
    }

    fn shown(&self) -> &Drawing {
        self.draft
            .as_ref()
            .filter(|_| self.coarser > 1)
            .unwrap_or(&self.whole)
    }

    /// Updates the probe at a pixel of the full picture, once that is finished; returns whether that was necessary.
    pub fn probe(&mut self, pixel: [u32; 2], redrawn: bool) -> bool {
        if !redrawn && self.probed.as_ref().is_some_and(|(at, _)| *at == pixel) {
            return false;
        }
        let drawing = match &mut self.draft {
            Some(draft) if self.coarser > 1 => draft,
            _ => &mut self.whole,
        };
        let finished = drawing.renderer.is_finished();
        let Some(scene) = drawing.drawn.as_ref().filter(|_| finished) else {
            return false;
        };
        let [x, y] = pixel.map(|v| v / self.coarser);
        let mut probe = probe(&mut drawing.renderer, scene, x, y);
        probe.pixel = pixel;
        self.probed = Some((pixel, probe));
        true
    }

    /// Returns a pixel of the full picture beside its highlight.
    pub fn beside_highlight(&mut self) -> Option<[u32; 2]> {
        let Drawing {
            renderer, drawn, ..
        } = &mut self.whole;
        pixel_beside_highlight(renderer, drawn.as_ref()?)
    }

    /// Returns whether the picture shown is finished.
    pub fn is_finished(&self) -> bool {
        self.renderer().is_finished()
    }

    /// Returns whether the picture shown is that of `scene`, to its last row.
    pub fn shows_all_of(&self, scene: &Scene) -> bool {
        self.is_finished() && self.shown().changed_parts(scene).is_empty()
    }

    /// Returns the renderer of the picture shown.
    pub fn renderer(&self) -> &Renderer {
        &self.shown().renderer
    }

    /// Returns the scene of the picture shown, in that picture's size.
    pub fn drawn(&self) -> Option<&Scene> {
        self.shown().drawn.as_ref()
    }

    /// Returns the report of drawing the picture shown.
    pub fn report(&self) -> &FrameReport {
        &self.shown().report
    }

    /// Returns the linear picture shown, before the display.
    pub fn linear(&self) -> Option<LinearPicture<'_>> {
        let drawing = self.shown();
        let finished = drawing.linear && drawing.renderer.is_finished();
        let scene = drawing.drawn.as_ref().filter(|_| finished)?;
        Some(LinearPicture {
            width: scene.image.size[0],
            pixels: drawing.renderer.linear(),
            clamps: scene.clamps(),
        })
    }
}

/// Returns the options of an overlay with this `appearance`, for the light of index `light`.
pub fn overlay_options(appearance: &Overlays, light: usize, scene: &Scene) -> OverlayOptions {
    let on = |layer: bool| appearance.vectors && layer;
    let layers = [
        (appearance.vectors, OverlayLayer::Vectors),
        (on(appearance.angles), OverlayLayer::Angles),
        (on(appearance.construction), OverlayLayer::Construction),
        (on(appearance.lobe), OverlayLayer::Lobe),
        (on(appearance.side_view), OverlayLayer::SideView),
        (appearance.face_normals, OverlayLayer::FaceNormals),
        (appearance.vertex_normals, OverlayLayer::VertexNormals),
    ];
    OverlayOptions {
        layers: layers
            .into_iter()
            .filter(|(shown, _)| *shown)
            .map(|(_, layer)| layer)
            .collect(),
        light: (light < scene.lights.len()).then_some(light),
        half_vector: appearance.half_vector,
        side_view_where_needed: appearance.side_view_where_needed,
        side_view_angles: appearance.angles,
        side_view_enlarged: appearance.side_view_enlarged,
        halo: if is_dark(scene) {
            Halo::Dark
        } else {
            Halo::Light
        },
        ..OverlayOptions::default()
    }
}

/// Returns the scale of letters over a picture of `size` pixels, each of which covers `coarser` pixels of the screen.
/// At projector size they are at least as large as the window's own text.
pub fn lettering(ctx: &Context, appearance: &Appearance, size: [u32; 2], coarser: u32) -> f64 {
    let own = f64::from(appearance.scale);
    if !appearance.projector {
        return own;
    }
    let text = f64::from(TEXT * ctx.pixels_per_point()) / f64::from(coarser);
    own.max(text / overlay_letters(f64::from(size[0].min(size[1]))))
}

/// Returns whether the picture's background is dark.
pub fn is_dark(scene: &Scene) -> bool {
    scene.image.background.dot(Rgb::new(0.2126, 0.7152, 0.0722)) < 0.4
}

/// Converts a picture for the window.
pub fn image_of(frame: &Frame) -> ColorImage {
    let size = [frame.width as usize, frame.height as usize];
    // Alpha is always 255.
    ColorImage::from_rgba_premultiplied(size, frame.pixels.as_flattened())
}

/// Returns a picture that `draw` paints on a transparent background, `width` by `height` pixels.
pub fn drawing(
    [width, height]: [u32; 2],
    draw: impl FnOnce(&mut tiny_skia::PixmapMut<'_>),
) -> Option<ColorImage> {
    let mut pixmap = tiny_skia::Pixmap::new(width, height)?;
    draw(&mut pixmap.as_mut());
    Some(ColorImage::from_rgba_premultiplied(
        [width as usize, height as usize],
        pixmap.data(),
    ))
}

pub fn upload(
    ctx: &Context,
    texture: &mut Option<TextureHandle>,
    name: &str,
    image: impl Into<ImageData>,
    options: TextureOptions,
) {
    match texture {
        Some(texture) => texture.set(image, options),
        None => *texture = Some(ctx.load_texture(name, image, options)),
    }
}
