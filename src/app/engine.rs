//! The engine behind the window: draws the scene, probes it, and keeps both as textures until something changes.

use super::document::same_model;
use super::state::{AppState, OverlayLook};
use crate::analysis::{Plot, Probe, curves, probe};
use crate::figure::{Halo, OverlayLayer, OverlayOptions, draw_overlay};
use crate::geometry::Mesh;
use crate::render::{Frame, Plan, Renderer, Report};
use crate::scene::{Image, Scene};
use eframe::egui::{Color32, ColorImage, Context, TextureHandle, TextureOptions};
use std::sync::{Arc, OnceLock};
use std::time::Instant;

/// Draws for the window.
pub struct Engine {
    renderer: Renderer,
    model: Option<Arc<Mesh>>,
    drawn: Option<Scene>,
    report: Report,
    picture: Option<TextureHandle>,
    probed: Option<([u32; 2], Probe)>,
    overlay: Option<Overlay>,
    revision: u64,
}

/// The overlay as last drawn, and what for.
struct Overlay {
    texture: TextureHandle,
    look: OverlayLook,
    light: usize,
    dark: bool,
    scale: f32,
}

impl Default for Engine {
    fn default() -> Self {
        Self {
            renderer: Renderer::with_clock(clock),
            model: None,
            drawn: None,
            report: Report::default(),
            picture: None,
            probed: None,
            overlay: None,
            revision: 0,
        }
    }
}

/// Nanoseconds since the first call.
fn clock() -> u64 {
    static START: OnceLock<Instant> = OnceLock::new();
    u64::try_from(START.get_or_init(Instant::now).elapsed().as_nanos()).unwrap_or(u64::MAX)
}

impl Engine {
    /// Brings picture, probe and overlay up to date for a picture of `size` pixels; what has not changed is kept.
    pub fn update(&mut self, ctx: &Context, state: &AppState, size: [u32; 2]) {
        let size = size.map(|side| side.clamp(1, Image::MAX_SIDE));
        let scene = &state.document.scene;
        let redrawn = self.draw(ctx, scene, state.document.model.as_ref(), size);
        let reprobed = self.probe(state, size, redrawn);
        if reprobed {
            // The panels beside the picture were laid out before it was drawn.
            ctx.request_repaint();
        }
        self.draw_overlay(ctx, state, reprobed);
    }

    fn draw(&mut self, ctx: &Context, scene: &Scene, model: Option<&Arc<Mesh>>, size: [u32; 2]) -> bool {
        let same_model = same_model(self.model.as_ref(), model);
        if same_model && self.drawn.as_ref().is_some_and(|drawn| same_picture(drawn, scene, size)) {
            return false;
        }
        if !same_model {
            self.model = model.cloned();
            self.renderer.set_model(self.model.clone());
        }
        let mut sized = scene.clone();
        sized.image.size = size;
        let image = image_of(self.renderer.render(&sized));
        self.report = self.renderer.report().clone();
        upload(ctx, &mut self.picture, "picture", image);
        self.drawn = Some(sized);
        true
    }

    fn probe(&mut self, state: &AppState, size: [u32; 2], redrawn: bool) -> bool {
        let pixel = state.probe.pixel(size);
        let Some(scene) = &self.drawn else { return false };
        if !redrawn && self.probed.as_ref().is_some_and(|(at, _)| *at == pixel) {
            return false;
        }
        self.revision += 1;
        self.probed = Some((pixel, probe(&mut self.renderer, scene, pixel[0], pixel[1])));
        true
    }

    fn draw_overlay(&mut self, ctx: &Context, state: &AppState, reprobed: bool) {
        let look = &state.look.overlay;
        let dark = is_dark(&state.document.scene);
        let scale = state.look.scale;
        let kept = self.overlay.as_ref().is_some_and(|overlay| {
            overlay.look == *look && overlay.light == state.light && overlay.dark == dark && overlay.scale == scale
        });
        if kept && !reprobed {
            return;
        }
        let mut options = overlay_options(look, state.light, &state.document.scene);
        options.scale = f64::from(scale);
        let (Some((_, probe)), Some(scene)) = (&self.probed, &self.drawn) else { return };
        let Some(image) = overlay_image(scene, probe, &options) else { return };
        let mut texture = self.overlay.take().map(|overlay| overlay.texture);
        upload(ctx, &mut texture, "overlay", image);
        self.overlay = texture.map(|texture| Overlay { texture, look: look.clone(), light: state.light, dark, scale });
    }

    /// The picture's texture.
    pub fn picture(&self) -> Option<&TextureHandle> {
        self.picture.as_ref()
    }

    /// The overlay's texture, as large as the picture; none where nothing is to be drawn.
    pub fn overlay(&self) -> Option<&TextureHandle> {
        self.overlay.as_ref().filter(|overlay| overlay.look.vectors).map(|overlay| &overlay.texture)
    }

    /// The picture as last drawn.
    pub fn frame(&self) -> &Frame {
        self.renderer.frame()
    }

    /// What drawing the picture last did.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// The plan of the picture.
    pub fn plan(&self) -> Option<&Plan> {
        self.renderer.plan()
    }

    /// Grows whenever the picture or the probe has changed.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// The curves at the probe and of the light of index `light`, those that say something.
    pub fn plots(&self, light: usize) -> Vec<Plot> {
        let (Some(scene), Some((_, probe))) = (&self.drawn, &self.probed) else { return vec![] };
        let plot = |kind| curves::plot(kind, &self.renderer, scene, probe, light);
        curves::telling(scene, light).into_iter().filter_map(plot).collect()
    }

    /// The equation at the probe.
    pub fn probed(&self) -> Option<&Probe> {
        self.probed.as_ref().map(|(_, probe)| probe)
    }
}

/// Whether `drawn` is a picture of `scene` at `size` pixels.
fn same_picture(drawn: &Scene, scene: &Scene, size: [u32; 2]) -> bool {
    if drawn.image.size != size {
        return false;
    }
    // The size in the scene is that of exported pictures.
    let mut sized = scene.clone();
    sized.image.size = size;
    sized == *drawn
}

/// What an overlay shows under `look` for the light of index `light`.
pub fn overlay_options(look: &OverlayLook, light: usize, scene: &Scene) -> OverlayOptions {
    let layers = [
        (look.vectors, OverlayLayer::Vectors),
        (look.vectors && look.angles, OverlayLayer::Angles),
        (look.vectors && look.construction, OverlayLayer::Construction),
        (look.vectors && look.lobe, OverlayLayer::Lobe),
        (look.vectors && look.side_view, OverlayLayer::SideView),
    ];
    OverlayOptions {
        layers: layers.into_iter().filter(|(shown, _)| *shown).map(|(_, layer)| layer).collect(),
        light: (light < scene.lights.len()).then_some(light),
        half_vector: look.half_vector,
        halo: if is_dark(scene) { Halo::Dark } else { Halo::Light },
        ..OverlayOptions::default()
    }
}

/// Whether the picture's background is dark.
fn is_dark(scene: &Scene) -> bool {
    scene.image.background.dot(crate::scene::Rgb::new(0.2126, 0.7152, 0.0722)) < 0.4
}

fn image_of(frame: &Frame) -> ColorImage {
    let pixels = frame.pixels.iter().map(|[r, g, b, _]| Color32::from_rgb(*r, *g, *b)).collect();
    ColorImage::new([frame.width as usize, frame.height as usize], pixels)
}

fn overlay_image(scene: &Scene, probe: &Probe, options: &OverlayOptions) -> Option<ColorImage> {
    let [width, height] = scene.image.size;
    let mut pixmap = tiny_skia::Pixmap::new(width, height)?;
    draw_overlay(&mut pixmap.as_mut(), scene, probe, options);
    Some(ColorImage::from_rgba_premultiplied([width as usize, height as usize], pixmap.data()))
}

fn upload(ctx: &Context, texture: &mut Option<TextureHandle>, name: &str, image: ColorImage) {
    match texture {
        Some(texture) => texture.set(image, TextureOptions::NEAREST),
        None => *texture = Some(ctx.load_texture(name, image, TextureOptions::NEAREST)),
    }
}
