//! Small spheres of the named materials, drawn beside the window once somebody looks.

use crate::render::Renderer;
use crate::scene::materials::{NAMED, NamedMaterial};
use crate::scene::{Ambient, Camera, Image, Light, Object, ObjectKind, Reflection, ReflectionModel, Rgb, Scene};
use crate::scene::{Shading, ShadingMode};
use eframe::egui::{Color32, ColorImage, Context, TextureHandle, TextureId, TextureOptions, Vec2};
use glam::DVec3;
use std::fmt;
use std::sync::mpsc::{Receiver, channel};
use std::thread;

/// The side of a sphere's picture, points.
pub const SPHERE: f32 = 48.0;
/// The sphere with its name.
pub const CELL: Vec2 = Vec2::new(104.0, 72.0);

/// Samples a pixel of the pictures: 2 × 2.
const SAMPLES: u32 = 4;

/// The pictures of the named materials.
#[derive(Default)]
pub struct Gallery {
    /// In the order of [`NAMED`], as far as they have come.
    textures: Vec<TextureHandle>,
    work: Option<Receiver<ColorImage>>,
    /// Pixels on a side.
    side: u32,
}

impl fmt::Debug for Gallery {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Gallery of {} pictures", self.textures.len())
    }
}

impl Gallery {
    /// Begins to draw the pictures, or takes those that have come.
    pub fn prepare(&mut self, ctx: &Context) {
        let side = (SPHERE * ctx.pixels_per_point()).round().clamp(16.0, 512.0) as u32;
        if self.side != side {
            self.side = side;
            self.textures.clear();
            self.work = Some(draw(ctx, side));
        }
        let Some(work) = &self.work else { return };
        for image in work.try_iter() {
            let name = format!("material {}", self.textures.len());
            self.textures.push(ctx.load_texture(name, image, TextureOptions::LINEAR));
        }
        if self.textures.len() == NAMED.len() {
            self.work = None;
        }
    }

    /// The picture of a material, once it has come.
    pub fn texture(&self, named: &NamedMaterial) -> Option<TextureId> {
        let place = NAMED.iter().position(|other| other == named)?;
        self.textures.get(place).map(TextureHandle::id)
    }
}

/// Draws one after the other on a thread of its own.
fn draw(ctx: &Context, side: u32) -> Receiver<ColorImage> {
    let (sender, receiver) = channel();
    let ctx = ctx.clone();
    thread::spawn(move || {
        let mut renderer = Renderer::default();
        for named in NAMED {
            // Who has closed the window wants no more of them.
            if sender.send(picture(&mut renderer, named, side)).is_err() {
                return;
            }
            ctx.request_repaint();
        }
    });
    receiver
}

/// The sphere as OpenGL lights it: N against H, a distant light from above, little ambient light.
fn scene(named: &NamedMaterial, side: u32) -> Scene {
    Scene {
        image: Image { size: [side, side], background: Rgb::ZERO },
        camera: Camera { fov_y: 33.0, ..Camera::default() },
        object: Object { kind: ObjectKind::Sphere, ..Object::default() },
        material: named.material(),
        reflection: Reflection { model: ReflectionModel::Blinn, ..Reflection::default() },
        shading: Shading { mode: ShadingMode::Exact, ..Shading::default() },
        ambient: Ambient { color: Rgb::splat(0.4), ..Ambient::default() },
        lights: vec![Light { position: DVec3::new(-2.0, 2.5, 4.0), ..Light::default() }],
        ..Scene::default()
    }
}

/// The sphere, cut out by its own coverage.
fn picture(renderer: &mut Renderer, named: &NamedMaterial, side: u32) -> ColorImage {
    let frame = renderer.render_supersampled(&scene(named, side), SAMPLES, &mut |_| true);
    let mut white = scene(named, side);
    white.material = crate::scene::Material { ka: Rgb::ONE, kd: Rgb::ZERO, ks: Rgb::ZERO, ..named.material() };
    white.ambient.color = Rgb::ONE;
    let coverage = renderer.render_supersampled(&white, SAMPLES, &mut |_| true);
    let pixels = frame.pixels.iter().zip(&coverage.pixels);
    // The background is black, so the colours are multiplied by the coverage already.
    let pixels = pixels.map(|([r, g, b, _], [cover, ..])| Color32::from_rgba_premultiplied(*r, *g, *b, *cover));
    ColorImage::new([side as usize, side as usize], pixels.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_a_sphere_in_the_middle() {
        let image = picture(&mut Renderer::default(), &NAMED[10], 48);
        assert_eq!(image.size, [48, 48]);
        let at = |x: usize, y: usize| image.pixels[y * 48 + x];
        assert_eq!(at(0, 0), Color32::TRANSPARENT);
        let middle = at(24, 24);
        assert!(middle.a() == 255 && middle.r() > middle.g() && middle.g() > middle.b(), "gold: {middle:?}");
        for named in NAMED {
            assert_eq!(scene(named, 48).validate(), Ok(()));
        }
    }
}
