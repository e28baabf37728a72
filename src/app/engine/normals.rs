//! Normals over the active pane: needles, cached until something moves, and the faces of the vertex under the pointer.

use super::pane::{PaneEngine, drawing, lettering, overlay_options, upload};
use crate::analysis::normals::{LitVertex, Needles, NormalField, SeenNormals};
use crate::analysis::overlay::{OverlayLayer, OverlayOptions, free_corners};
use crate::app::session::Session;
use crate::app::session::window::WindowState;
use crate::figure::Area;
use crate::scene::{Camera, Scene, ShadingMode, View};
use eframe::egui::{Context, TextureHandle, TextureOptions};
use glam::DVec2;

/// The drawings of the normals, and their inputs. Nothing is cached while none are shown.
#[derive(Default)]
pub struct NormalsDrawing {
    field: Option<NormalField>,
    seen: SeenNormals,
    drawn: Option<NeedlesKey>,
    needles: Option<TextureHandle>,
    lit: Option<(u32, TextureHandle)>,
    /// The areas that the letters of the highlighted vertex avoid, in pixels.
    covered: Vec<Area>,
}

/// The inputs of the needles besides the field.
#[derive(PartialEq)]
struct NeedlesKey {
    pane: usize,
    options: OverlayOptions,
    camera: Camera,
    size: [u32; 2],
    /// True for the true surface, which hides needles differently than its polygons do.
    exact: bool,
}

impl NormalsDrawing {
    /// Updates the needles to the picture of the active pane.
    pub fn update(
        &mut self,
        ctx: &Context,
        session: &Session,
        window: &mut WindowState,
        pane: usize,
        engine: &PaneEngine,
    ) {
        let Some(scene) = engine
            .drawn()
            .filter(|_| window.appearance.overlay.normals())
        else {
            if self.field.is_some() {
                *self = Self::default();
            }
            window.pointed.lit = None;
            return;
        };
        let renderer = engine.renderer();
        let kept = self
            .field
            .take_if(|field| field.holds(renderer, &scene.object));
        if kept.is_none() {
            let old = self.field.as_ref();
            if old.is_some_and(|field| !field.of_equal_mesh(renderer)) {
                // Its indices refer to other points.
                window.pointed.kept = None;
            }
            self.drawn = None;
        }
        let field = self
            .field
            .insert(kept.unwrap_or_else(|| NormalField::new(renderer, &scene.object)));
        let size = scene.image.size;
        let key = NeedlesKey {
            pane,
            options: options(ctx, session, window, scene, engine.coarser),
            camera: scene.camera.clone(),
            size,
            exact: scene.shading.mode == ShadingMode::Exact,
        };
        if self.drawn.as_ref() == Some(&key) {
            return;
        }
        self.seen = field.facing(&View::new(&scene.camera, size), size);
        let needles = Needles::new(size, scene, renderer, field, &key.options);
        if let Some(image) = drawing(size, |pixmap| needles.draw(pixmap)) {
            let options = TextureOptions::NEAREST;
            upload(ctx, &mut self.needles, "needles", image, options);
        }
        (self.drawn, self.lit) = (Some(key), None);
    }

    /// Keeps the letters of the highlighted vertex out of the areas `covered`, in pixels.
    pub fn avoid(&mut self, covered: Vec<Area>) {
        if self.covered != covered {
            (self.covered, self.lit) = (covered, None);
        }
    }

    /// Highlights the vertex `near` the pointer, a position and a radius in pixels, or else the kept one. A click keeps
    /// the vertex under the pointer.
    pub fn point_at(
        &mut self,
        ctx: &Context,
        session: &Session,
        window: &mut WindowState,
        engine: &PaneEngine,
        near: Option<(DVec2, f64)>,
        clicked: bool,
    ) {
        // While a downscaled picture is shown, something is dragged and nothing is pointed at.
        if engine.coarser > 1 {
            return;
        }
        let (Some(field), Some(scene)) = (&self.field, engine.drawn()) else {
            return;
        };
        let vertex =
            |(pixel, reach)| field.vertex_near(engine.renderer(), &self.seen, pixel, reach);
        let hovered = near.and_then(vertex).map(|vertex| vertex.index);
        if clicked {
            window.pointed.kept = hovered.and_then(|vertex| field.point_of(vertex));
        }
        let wanted = hovered
            .or_else(|| field.vertex_at(window.pointed.kept?))
            .or_else(|| {
                let at_probe = window.appearance.overlay.vertex;
                let place = at_probe.then(|| window.probe.centre(scene.image.size));
                Some(vertex((place?, f64::INFINITY))?.index)
            });
        window.pointed.lit = wanted;
        if self.lit.as_ref().map(|(vertex, _)| *vertex) == wanted {
            return;
        }
        let known = wanted.and_then(|number| field.vertex(number));
        let size = scene.image.size;
        let options = OverlayOptions {
            free_corners: free_corners(engine.renderer().frame()),
            covered: self.covered.clone(),
            ..options(ctx, session, window, scene, engine.coarser)
        };
        let laid = known.and_then(|vertex| LitVertex::new(size, scene, field, &vertex, &options));
        let mut texture = self.lit.take().map(|(_, texture)| texture);
        if let Some(image) = laid.and_then(|laid| drawing(size, |pixmap| laid.draw(pixmap))) {
            let options = TextureOptions::NEAREST;
            upload(ctx, &mut texture, "lit-vertex", image, options);
            self.lit = wanted.zip(texture);
        }
    }

    /// Returns the needles and the highlighted faces.
    pub fn textures(&self) -> [Option<&TextureHandle>; 2] {
        [
            self.needles.as_ref(),
            self.lit.as_ref().map(|(_, texture)| texture),
        ]
    }
}

/// Returns the options of needles, which are independent of the lights.
fn options(
    ctx: &Context,
    session: &Session,
    window: &WindowState,
    scene: &Scene,
    coarser: u32,
) -> OverlayOptions {
    let mut options = overlay_options(&window.appearance.overlay, session.light, scene);
    let vectors = OverlayLayer::Vectors;
    options
        .layers
        .retain(|layer| layer.of_needles() || *layer == vectors);
    OverlayOptions {
        light: None,
        scale: lettering(ctx, &window.appearance, scene.image.size, coarser),
        ..options
    }
}
