//! The parts of a picture whose ambient light differs: one, or with `split` two halves.

use super::plan::Inputs;
use crate::illumination::{Equation, Scalar};
use crate::scene::{AmbientSource, Scene};
use std::ops::Range;

/// A range of a picture's columns, and the kind of ambient light there.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    pub columns: Range<usize>,
    /// True if light from other surfaces replaces the constant Ia.
    pub bounces: bool,
    /// The equation of each material in these columns; without an ambient term where light bounces.
    pub equations: Vec<Equation<f32>>,
}

impl Part {
    /// Returns the parts of the picture of `scene`, from left to right, with the lights of `equations`.
    pub fn all(scene: &Scene, equations: &[Equation<f32>]) -> Vec<Self> {
        let bouncing = bouncing(scene);
        let part = |columns: Range<usize>, bounces| Self {
            columns,
            bounces,
            equations: with_ambient(equations.to_vec(), !bounces),
        };
        let both = [part(0..bouncing.start, false), part(bouncing, true)];
        both.into_iter()
            .filter(|part| !part.columns.is_empty())
            .collect()
    }

    pub fn in_double(&self, inputs: &Inputs<'_>) -> Vec<Equation<f64>> {
        with_ambient(inputs.equations(), !self.bounces)
    }
}

/// Returns equations, with their ambient terms or without.
pub fn with_ambient<T: Scalar>(equations: Vec<Equation<T>>, ambient: bool) -> Vec<Equation<T>> {
    if ambient {
        return equations;
    }
    equations
        .into_iter()
        .map(Equation::without_ambient)
        .collect()
}

/// Returns the columns that show light from other surfaces.
pub fn bouncing(scene: &Scene) -> Range<usize> {
    let width = scene.image.size[0] as usize;
    match scene.ambient.source {
        AmbientSource::Constant => width..width,
        AmbientSource::Bounce => 0..width,
        AmbientSource::Split => width.div_ceil(2)..width,
    }
}
