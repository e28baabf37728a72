//! What a picture means in numbers.

pub mod curves;
mod lobe;
mod perception;
mod plot;
mod probe;
mod profile;
mod sampling;

pub use lobe::{ReflectionLobe, Response};
pub use perception::{Perception, ResponseModel, Viewing, blur_line, blur_picture};
pub use plot::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Tag};
pub use probe::{LightTerms, Probe, ProbeHit, probe};
pub use profile::{
    Border, Corner, Profile, ProfileError, ProfileRequest, Sample, Trace, luminance, perceived_picture, profile,
    profile_plots,
};
pub use sampling::{REFERENCE_SAMPLES, SamplingError, sampling_error, sampling_error_with};
