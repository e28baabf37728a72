//! The analyses against closed forms.

#[path = "../common/fixtures.rs"]
#[allow(dead_code, reason = "each program takes what it needs")]
#[macro_use]
mod common;

mod axes;
mod claims;
mod comparison;
mod conditions;
mod curves;
mod defects;
mod figure;
mod formula;
mod golden_figures;
mod jobs;
mod laws;
mod normals;
mod own_law_stability;
mod profile;
mod report;
mod sampling;
mod scan_conversion;
mod stability;
mod study;
mod terms;
mod travel;
