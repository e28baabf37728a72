//! What a picture means in numbers.

pub mod curves;
mod lobe;
mod plot;
mod probe;
mod sampling;

pub use lobe::{ReflectionLobe, Response};
pub use plot::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Tag};
pub use probe::{LightTerms, Probe, ProbeHit, probe};
pub use sampling::{REFERENCE_SAMPLES, SamplingError, sampling_error, sampling_error_with};
