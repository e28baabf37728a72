//! Names of the parts of a frame's plan.

use crate::render::{Per, Stage};
use crate::text::text;

/// Returns a stage's name and description.
pub fn stage_words(stage: Stage) -> (&'static str, &'static str) {
    let [name, what] = match stage {
        Stage::Geometry => ["engine-stage-geometry", "engine-stage-geometry.tip"],
        Stage::Transform => ["engine-stage-transform", "engine-stage-transform.tip"],
        Stage::Coverage => ["engine-stage-coverage", "engine-stage-coverage.tip"],
        Stage::Rays => ["engine-stage-rays", "engine-stage-rays.tip"],
        Stage::VertexShading => ["engine-stage-vertices", "engine-stage-vertices.tip"],
        Stage::Interpolation => [
            "engine-stage-interpolation",
            "engine-stage-interpolation.tip",
        ],
        Stage::PixelShading => ["engine-stage-pixels", "engine-stage-pixels.tip"],
        Stage::Display => ["engine-stage-display", "engine-stage-display.tip"],
    };
    (text!(name), text!(what))
}

/// Returns the name of a rate of evaluation.
pub fn per_words(per: Per) -> &'static str {
    match per {
        Per::Frame => text!("engine-each-frame"),
        Per::Light => text!("engine-each-light"),
        Per::Face => text!("engine-each-face"),
        Per::Vertex => text!("engine-each-vertex"),
        Per::Pixel => text!("engine-each-pixel"),
        Per::None => "",
    }
}
