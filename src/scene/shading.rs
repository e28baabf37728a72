//! The points where the equation is evaluated, and the interpolation from vertices to pixels.

use super::Scene;
use super::choice::choices;
use super::material::no_light;
use super::parameter::table;
use super::symbol::Symbol;
use crate::text::text;

table! {
    /// The points where the equation is evaluated, and the interpolation from vertices to pixels.
    pub struct Shading = [shading] in shading {
        /// The points where the equation is evaluated.
        MODE mode: ShadingMode = ShadingMode::Phong, Choice.symbol(Symbol::Normal);
        /// The source of a flat polygon's shade.
        FLAT_AT flat_at: FlatAt = FlatAt::Centre, Choice.symbol(Symbol::Normal).idle(not_flat);
        /// The interpolation of values between vertices.
        INTERPOLATION interpolation: Interpolation = Interpolation::Perspective, Choice
            .symbol(Symbol::Normal).idle(not_interpolated);
        /// A switch that makes Phong shading scale interpolated normals to unit length.
        RENORMALISE renormalise: bool = true, Switch.symbol(Symbol::Normal).idle(not_phong);
        /// A switch that makes the object block light.
        SHADOWS shadows: bool = false, Switch.symbol(Symbol::Shadows).idle(no_light);
    }
}

fn not_flat(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.shading.mode != ShadingMode::Flat).then(|| text!("idle-not-flat"))
}

fn not_interpolated(scene: &Scene, _: usize) -> Option<&'static str> {
    matches!(scene.shading.mode, ShadingMode::Flat | ShadingMode::Exact)
        .then(|| text!("idle-nothing-interpolated"))
}

fn not_phong(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.shading.mode != ShadingMode::Phong).then(|| text!("idle-not-phong"))
}

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
