//! Where the equation is evaluated, and how values get from vertices to pixels.

use super::Scene;
use super::choice::choices;
use super::material::no_light;
use super::parameter::table;
use super::symbol::Symbol;
use crate::text::text;

table! {
    /// Where the equation is evaluated, and how values get from vertices to pixels.
    pub struct Shading = [shading] in shading {
        MODE mode: ShadingMode = ShadingMode::Phong, Choice.symbol(Symbol::Normal);
        FLAT_AT flat_at: FlatAt = FlatAt::Centre, Choice.symbol(Symbol::Normal).idle(not_flat);
        INTERPOLATION interpolation: Interpolation = Interpolation::Perspective, Choice
            .symbol(Symbol::Normal).idle(not_interpolated);
        RENORMALISE renormalise: bool = true, Switch.symbol(Symbol::Normal).idle(not_phong);
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
    /// Where the illumination equation is evaluated.
    pub enum ShadingMode = "shading" {
        Flat = "flat";
        Interpolated = "interpolated";
        Gouraud = "gouraud";
        Phong = "phong";
        Exact = "exact";
    }
}

choices! {
    /// Where a flat polygon takes its one shade from.
    pub enum FlatAt = "flat-at" {
        Centre = "centre";
        VertexMean = "vertex-mean";
        ProvokingVertex = "provoking-vertex";
    }
}

choices! {
    /// How values between vertices are found.
    pub enum Interpolation = "interpolation" {
        Perspective = "perspective";
        Affine = "affine";
        Scanline = "scanline";
    }
}
