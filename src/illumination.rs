//! The illumination equation, written once and evaluated in any number type.
//!
//! `I = ka·color·Ia + Σ f·Ip·(kd·color·(N·L) + ks·S)` per channel, over the lights with N·L > 0. [`Equation`] holds the
//! coefficients of a scene in single or double precision; [`Equation::illuminate`] evaluates it for as many points as the
//! number type [`Real`] has lanes: one for `f64` (the probe, the reference), sixteen for the widest vectors.

mod equation;
mod formula;
mod fresnel;
mod lanes;
mod pattern;
mod real;
mod source;
mod specular;

pub(crate) use equation::SourcePart;
pub use equation::{Equation, LightAt, LightResponse, Reached};
pub(crate) use formula::{
    Code, GROUPS_TOGETHER, Incidence, LawOperations, LawScratch, LawSite, Operation, Value,
    lights_backs,
};
pub use formula::{
    Counterexample, Domain, FormulaFunction, LawLine, LawPart, LawValues, LineNumbers, Outcome,
    Rate, Unneeded, law_operations,
};
pub use fresnel::{Index, critical_angle, mirror, refract};
pub use lanes::{COUNT, LANES, Lanes};
pub use pattern::Fields;
pub use real::{Real, Scalar, V3};
pub(crate) use source::direction;
pub use source::{BRIGHTEST, Source, area_hull, area_samples, attenuation_at, rectangle_axes};
pub(crate) use specular::reflect;
pub use specular::{
    Lobe, ShadingPoint, SpecularForm, blinn_from_phong, half_width, phong_from_blinn,
    roughness_from_exponent,
};
