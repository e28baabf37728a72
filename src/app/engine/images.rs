//! Pictures and overlays as textures of the window.

use crate::analysis::{Halo, OverlayLayer, OverlayOptions};
use crate::app::look::OverlayLook;
use crate::render::Frame;
use crate::scene::{Rgb, Scene};
use eframe::egui::{ColorImage, Context, ImageData, TextureHandle, TextureOptions};

/// What an overlay shows under `look` for the light of index `light`.
pub fn overlay_options(look: &OverlayLook, light: usize, scene: &Scene) -> OverlayOptions {
    let layers = [
        (look.vectors, OverlayLayer::Vectors),
        (look.vectors && look.angles, OverlayLayer::Angles),
        (look.vectors && look.construction, OverlayLayer::Construction),
        (look.vectors && look.lobe, OverlayLayer::Lobe),
        (look.vectors && look.side_view, OverlayLayer::SideView),
        (look.face_normals, OverlayLayer::FaceNormals),
        (look.vertex_normals, OverlayLayer::VertexNormals),
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
pub fn is_dark(scene: &Scene) -> bool {
    scene.image.background.dot(Rgb::new(0.2126, 0.7152, 0.0722)) < 0.4
}

/// A picture for the window.
pub fn image_of(frame: &Frame) -> ColorImage {
    let size = [frame.width as usize, frame.height as usize];
    // No alpha but 255 occurs.
    ColorImage::from_rgba_premultiplied(size, frame.pixels.as_flattened())
}

/// A picture of `size` pixels that `draw` puts on nothing.
pub fn drawing([width, height]: [u32; 2], draw: impl FnOnce(&mut tiny_skia::PixmapMut<'_>)) -> Option<ColorImage> {
    let mut pixmap = tiny_skia::Pixmap::new(width, height)?;
    draw(&mut pixmap.as_mut());
    Some(ColorImage::from_rgba_premultiplied([width as usize, height as usize], pixmap.data()))
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
