//! Small spheres of the named materials, drawn in the background once somebody looks.

use super::background::wake;
use crate::analysis::Watch;
use crate::jobs::{Background, Work};
use crate::render::Renderer;
use crate::scene::materials::{NAMED, NamedMaterial};
use crate::scene::{Ambient, Camera, Image, Light, Object, ObjectKind, Reflection, ReflectionModel, Rgb, Scene};
use crate::scene::{Shading, ShadingMode};
use eframe::egui::{Color32, ColorImage, Context, TextureHandle, TextureId, TextureOptions, Vec2};
use glam::DVec3;
use std::fmt;

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
    work: Background<Spheres>,
}

impl fmt::Debug for Gallery {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Gallery of {} pictures", self.textures.len())
    }
}

/// The spheres in pictures of so many pixels on a side.
#[derive(PartialEq)]
struct Spheres(u32);

impl Work for Spheres {
    type Answer = Vec<ColorImage>;

    fn run(&self, watch: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let (mut renderer, mut pictures) = (Renderer::default(), Vec::new());
        for named in NAMED {
            pictures.push(picture(&mut renderer, named, self.0));
            watch.found(&pictures);
            if !watch.at(pictures.len() as f32 / NAMED.len() as f32) {
                break;
            }
        }
        Ok(pictures)
    }
}

impl Gallery {
    /// Begins to draw the pictures, or takes those that have come.
    pub fn prepare(&mut self, ctx: &Context) {
        let side = Spheres((SPHERE * ctx.pixels_per_point()).round().clamp(16.0, 512.0) as u32);
        self.work.keep_only(|known| *known == side);
        self.work.ask(wake(ctx), |known| *known == side, || Spheres(side.0));
        let pictures = self.work.answer().map_or(&[][..], Vec::as_slice);
        self.textures.truncate(pictures.len());
        for (index, image) in pictures.iter().enumerate().skip(self.textures.len()) {
            let name = format!("material {index}");
            self.textures.push(ctx.load_texture(name, image.clone(), TextureOptions::LINEAR));
        }
    }

    /// The picture of a material, once it has come.
    pub fn texture(&self, named: &NamedMaterial) -> Option<TextureId> {
        let place = NAMED.iter().position(|other| other == named)?;
        self.textures.get(place).map(TextureHandle::id)
    }
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
