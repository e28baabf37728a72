//! What a picture means in numbers.

mod probe;

pub use probe::{LightTerms, Probe, ProbeHit, probe};
