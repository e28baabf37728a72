//! What a picture means in numbers.

mod probe;
mod sampling;

pub use probe::{LightTerms, Probe, ProbeHit, probe};
pub use sampling::{REFERENCE_SAMPLES, SamplingError, sampling_error, sampling_error_with};
