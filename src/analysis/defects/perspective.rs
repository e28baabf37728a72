//! What interpolation in the picture does to what is linear in space.

use super::{Finding, nothing_interpolated};
use crate::analysis::{ErrorFigures, LinearPicture, error_figures};
use crate::render::Renderer;
use crate::scene::{Interpolation, Projection, Scene};
use serde::Serialize;

/// The perspective distortion.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PerspectiveDistortion {
    /// What is compared with perspective-correct interpolation: the scene's own, or affine where that is the scene's.
    pub interpolation: Interpolation,
    /// The difference over the picture.
    pub error: ErrorFigures,
}

pub(super) fn measure(renderer: &mut Renderer, scene: &Scene) -> Finding<PerspectiveDistortion> {
    if let Some(why) = nothing_interpolated(scene) {
        return Err(why);
    }
    if scene.camera.projection == Projection::Orthographic {
        return Err("a parallel projection distorts nothing");
    }
    let interpolation = match scene.shading.interpolation {
        Interpolation::Perspective => Interpolation::Affine,
        other => other,
    };
    let mut drawn = |interpolation| {
        let mut other = scene.clone();
        other.shading.interpolation = interpolation;
        renderer.keep_linear(true);
        renderer.render(&other);
        renderer.keep_linear(false);
        renderer.linear().to_vec()
    };
    let (own, correct) = (drawn(interpolation), drawn(Interpolation::Perspective));
    let picture = |pixels| LinearPicture { width: scene.image.size[0], pixels, clamps: scene.clamps() };
    Ok(PerspectiveDistortion { interpolation, error: error_figures(picture(&own), picture(&correct)) })
}
