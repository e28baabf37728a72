//! Where the equation is evaluated, and how values get from vertices to pixels.

use super::Scene;
use super::choice::choices;
use super::material::no_light;
use super::parameter::table;
use super::symbol::Symbol;

table! {
    /// Where the equation is evaluated, and how values get from vertices to pixels.
    pub struct Shading = "shading" in shading {
        MODE mode: ShadingMode = ShadingMode::Phong, Choice, "Shading mode",
            "Where the illumination equation is evaluated.".symbol(Symbol::Normal);
        FLAT_AT flat_at: FlatAt = FlatAt::Centre, Choice, "Flat at",
            "Where the one intensity of a flat polygon is evaluated."
            .label("Evaluated at").symbol(Symbol::Normal).idle(not_flat);
        INTERPOLATION interpolation: Interpolation = Interpolation::Perspective, Choice, "Interpolation",
            "How values between vertices are found.".symbol(Symbol::Normal).idle(not_interpolated);
        RENORMALISE renormalise: bool = true, Switch, "Renormalise",
            "Whether Phong shading makes interpolated normals unit vectors again.".symbol(Symbol::Normal).idle(not_phong);
        SHADOWS shadows: bool = false, Switch, "Shadows",
            "Whether surfaces between a point and a light block the light. The equation itself does not include shadows."
            .symbol(Symbol::Shadows).idle(no_light);
    }
}

fn not_flat(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.shading.mode != ShadingMode::Flat)
        .then_some("Only flat shading has one intensity a polygon")
}

fn not_interpolated(scene: &Scene, _: usize) -> Option<&'static str> {
    matches!(scene.shading.mode, ShadingMode::Flat | ShadingMode::Exact)
        .then_some("This shading interpolates nothing")
}

fn not_phong(scene: &Scene, _: usize) -> Option<&'static str> {
    (scene.shading.mode != ShadingMode::Phong).then_some("Only Phong shading interpolates normals")
}

choices! {
    /// Where the illumination equation is evaluated.
    pub enum ShadingMode {
        Flat = "flat", "Flat", "The equation once per polygon";
        Interpolated = "interpolated", "Interpolated", "The equation at each polygon's vertices with the polygon's own normal; the intensity is interpolated";
        Gouraud = "gouraud", "Gouraud", "The equation at the vertices with the vertex normals; the intensity is interpolated (Gouraud 1971)";
        Phong = "phong", "Phong", "The equation at every pixel with the interpolated normal (Phong 1975)";
        Exact = "exact", "Exact", "The equation at every pixel of the true surface, with its own normal and outline";
    }
}

choices! {
    /// Where a flat polygon takes its one shade from.
    pub enum FlatAt {
        Centre = "centre", "the centre", "The mean of the vertices, with the polygon's own normal";
        VertexMean = "vertex-mean", "vertices, averaged", "The mean of the intensities at the vertices, with the vertex normals";
        ProvokingVertex = "provoking-vertex", "the first vertex", "The intensity at the first vertex, as OpenGL may do";
    }
}

choices! {
    /// How values between vertices are found.
    pub enum Interpolation {
        Perspective = "perspective", "perspective-correct", "Linear on the polygon in space";
        Affine = "affine", "affine", "Linear on the triangle in the picture";
        Scanline = "scanline", "scan line", "Linear along the edges, then along the scan line, in the picture";
    }
}
