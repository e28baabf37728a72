//! Where the equation is evaluated, and how values get from vertices to pixels.

use super::super::{Scene, ShadingMode};
use super::access::access;
use super::{Kind, Parameter, Symbol};

pub(super) const ALL: &[&Parameter] = &[&MODE, &FLAT_AT, &INTERPOLATION, &RENORMALISE, &SHADOWS];

pub static MODE: Parameter = Parameter::new(
    "shading.mode",
    "Shading mode",
    Kind::Choice(&access!(shading.mode)),
    "Where the illumination equation is evaluated.",
)
.symbol(Symbol::Normal);

pub static FLAT_AT: Parameter = Parameter::new(
    "shading.flat_at",
    "Flat at",
    Kind::Choice(&access!(shading.flat_at)),
    "Where the one intensity of a flat polygon is evaluated.",
)
.label("Evaluated at")
.symbol(Symbol::Normal)
.idle(|scene, _| (scene.shading.mode != ShadingMode::Flat).then_some("Only flat shading has one intensity a polygon"));

pub static INTERPOLATION: Parameter = Parameter::new(
    "shading.interpolation",
    "Interpolation",
    Kind::Choice(&access!(shading.interpolation)),
    "How values between vertices are found.",
)
.symbol(Symbol::Normal)
.idle(|scene, _| not_interpolated(scene));

fn not_interpolated(scene: &Scene) -> Option<&'static str> {
    matches!(scene.shading.mode, ShadingMode::Flat | ShadingMode::Exact).then_some("This shading interpolates nothing")
}

pub static RENORMALISE: Parameter = Parameter::new(
    "shading.renormalise",
    "Renormalise",
    Kind::Switch(access!(shading.renormalise)),
    "Whether Phong shading makes interpolated normals unit vectors again.",
)
.symbol(Symbol::Normal)
.idle(|scene, _| (scene.shading.mode != ShadingMode::Phong).then_some("Only Phong shading interpolates normals"));

pub static SHADOWS: Parameter = Parameter::new(
    "shading.shadows",
    "Shadows",
    Kind::Switch(access!(shading.shadows)),
    "Whether surfaces between a point and a light block the light. The equation itself does not include shadows.",
)
.symbol(Symbol::Shadows)
.idle(|scene: &Scene, _| super::material::no_light(scene));
