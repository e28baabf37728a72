//! The illumination equation, written once and evaluated in any number type.
//!
//! `I = ka·color·Ia + Σ f·Ip·(kd·color·(N·L) + ks·S)` per channel, over the lights with N·L > 0. [`Equation`] holds the
//! coefficients of a scene in single or double precision; [`Equation::illuminate`] evaluates it for as many points as the
//! number type [`Real`] has lanes: one for `f64` (the probe, the reference), sixteen for the widest vectors.

mod equation;
mod lanes;
mod real;
mod source;
mod specular;
mod vector;

pub use equation::{Equation, LightResponse, Site};
pub use lanes::Lanes;
pub use real::{Real, Scalar};
pub use source::{Falloff, Source};
pub use specular::{
    BlinnChord, BlinnCosine, Exponent, FormTask, NoSpecular, PhongChord, PhongCosine, Specular, SpecularForm,
};
pub use vector::V3;
