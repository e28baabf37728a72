//! The picture that all others are measured against.

use crate::analysis::LinearPicture;
use crate::illumination::Equation;
use crate::render::Renderer;
use crate::scene::{Scene, ShadingMode, View};

/// Where N·V of the true surface is less, pixels see it too obliquely to count as inside: there polygons of any size are off
/// by the outline's own error.
pub const INSIDE: f64 = 0.2;

/// The exact picture of a scene.
#[derive(Debug)]
pub struct Exact {
    width: u32,
    pixels: Vec<[f32; 4]>,
    /// The pixels that show the object with N·V ≥ [`INSIDE`].
    pub inside: Vec<bool>,
}

impl Exact {
    /// Draws `scene` in exact mode: in double precision where a pixel's value is the equation's alone, rounded to single once it
    /// is found; as the engine draws it where rays add to it.
    pub fn new(renderer: &mut Renderer, scene: &Scene) -> Self {
        let mut scene = scene.clone();
        scene.shading.mode = ShadingMode::Exact;
        renderer.keep_linear(true);
        renderer.render(&scene);
        let [width, height] = scene.image.size;
        let mut pixels = renderer.linear().to_vec();
        let mut inside = vec![false; pixels.len()];
        let (equation, view) = (Equation::<f64>::new(&scene), View::new(&scene.camera, scene.image.size));
        for (index, (x, y)) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).enumerate() {
            if pixels[index][3] == 0.0 {
                continue;
            }
            let Some(evaluation) = renderer.evaluation(x, y) else { continue };
            inside[index] = evaluation.normal.dot(view.towards_eye(evaluation.position)) >= INSIDE;
            if renderer.mixture(x, y).is_none() {
                let [r, g, b] = evaluation.shown(&equation).as_vec3().to_array();
                pixels[index] = [r, g, b, pixels[index][3]];
            }
        }
        Self { width, pixels, inside }
    }

    /// The picture before the display: nothing is clamped.
    pub fn picture(&self) -> LinearPicture<'_> {
        LinearPicture { width: self.width, pixels: &self.pixels, clamps: false }
    }
}
