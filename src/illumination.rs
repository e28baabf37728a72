//! The illumination equation, written once and evaluated in any number type.
//!
//! `I = ka·color·Ia + Σ f·Ip·(kd·color·(N·L) + ks·S)` per channel, over the lights with N·L > 0. [`Equation`] holds the
//! coefficients of a scene in single or double precision; [`Equation::illuminate`] evaluates it for as many points as the
//! number type [`Real`] has lanes: one for `f64` (the probe, the reference), sixteen for the widest vectors.

mod area;
mod equation;
mod fresnel;
mod lanes;
mod lobe;
mod matching;
mod microfacet;
mod pattern;
mod real;
mod shading_point;
mod snell;
mod source;
mod specular;
mod vector;

pub use area::{area_hull, area_rows, area_samples, rectangle_axes};
pub use equation::{Equation, LightAt, LightResponse, Reached};
pub use fresnel::Index;
pub use lanes::Lanes;
pub use lobe::Lobe;
pub use matching::{blinn_from_phong, half_width, phong_from_blinn, roughness_from_exponent};
pub use pattern::Fields;
pub use real::{Real, Scalar};
pub use shading_point::ShadingPoint;
pub use snell::{critical_angle, mirror, refract};
pub(crate) use source::direction;
pub use source::{BRIGHTEST, Falloff, Source, attenuation_at};
pub use specular::{
    Beckmann, BlinnChord, BlinnCosine, FormTask, Ggx, NoSpecular, PhongChord, PhongCosine, Specular, SpecularForm,
};
pub use vector::V3;
