//! The points where the equation is evaluated, and the interpolation from vertices to pixels.

use super::choice::choices;
use super::material::NO_LIGHT;
use super::parameter::{Reason, table};
use super::symbol::Symbol;

table! {
    /// The points where the equation is evaluated, and the interpolation from vertices to pixels.
    pub struct Shading = [shading] in shading {
        /// The points where the equation is evaluated.
        MODE mode: ShadingMode = ShadingMode::Phong, Choice.symbol(Symbol::Normal);
        /// The source of a flat polygon's shade.
        FLAT_AT flat_at: FlatAt = FlatAt::Centre, Choice.symbol(Symbol::Normal).idle_if(&[NOT_FLAT]);
        /// The interpolation of values between vertices.
        INTERPOLATION interpolation: Interpolation = Interpolation::Perspective, Choice
            .symbol(Symbol::Normal).idle_if(&[NOT_INTERPOLATED]);
        /// A switch that makes Phong shading scale interpolated normals to unit length.
        RENORMALISE renormalise: bool = true, Switch.symbol(Symbol::Normal).idle_if(&[NOT_PHONG]);
        /// A switch that makes the object block light.
        SHADOWS shadows: bool = false, Switch.symbol(Symbol::Shadows).idle_if(&[NO_LIGHT]);
    }
}

const NOT_FLAT: Reason = (
    |scene, _| scene.shading.mode != ShadingMode::Flat,
    "idle-not-flat",
);
const NOT_INTERPOLATED: Reason = (
    |scene, _| matches!(scene.shading.mode, ShadingMode::Flat | ShadingMode::Exact),
    "idle-nothing-interpolated",
);
const NOT_PHONG: Reason = (
    |scene, _| scene.shading.mode != ShadingMode::Phong,
    "idle-not-phong",
);

choices! {
    /// The points where the illumination equation is evaluated.
    pub enum ShadingMode = "shading" {
        /// Evaluation once for each polygon.
        Flat = "flat";
        /// Evaluation at the vertices with the polygon's own normal; intensities are interpolated.
        Interpolated = "interpolated";
        /// Evaluation at the vertices with their normals; intensities are interpolated (Gouraud 1971).
        Gouraud = "gouraud";
        /// Evaluation at every pixel with the interpolated normal (Phong 1975).
        Phong = "phong";
        /// Evaluation at every pixel on the true surface, with its own normal and outline.
        Exact = "exact";
    }
}

choices! {
    /// The source of a flat polygon's one shade.
    pub enum FlatAt = "flat-at" {
        /// The intensity at the polygon's centre, with its own normal.
        Centre = "centre";
        /// The mean of the intensities at its vertices, with their normals.
        VertexMean = "vertex-mean";
        /// The intensity at its first vertex, as OpenGL may do.
        ProvokingVertex = "provoking-vertex";
    }
}

choices! {
    /// The interpolation of values between vertices.
    pub enum Interpolation = "interpolation" {
        /// Linear interpolation on the polygon in space.
        Perspective = "perspective";
        /// Linear interpolation on the triangle in the picture.
        Affine = "affine";
        /// Linear interpolation along the edges, then along the scan line, in the picture.
        Scanline = "scanline";
    }
}
