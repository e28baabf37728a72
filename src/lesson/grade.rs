//! The grade of an answer.

use super::Hint;
use serde::{Deserialize, Serialize};

/// The grade of an answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Grade {
    /// The answer is within the question's tolerance, and no nearer to a wrong model.
    pub right: bool,
    /// From 0 to 1; 0 of an answer that is nearer to a wrong model.
    pub score: f64,
    /// The distance from the right answer, in the question's own unit, where that has one.
    pub off: Option<f64>,
    /// The wrong model that the answer agrees with, from 0: of a choice the option.
    #[serde(default)]
    pub model: Option<usize>,
    /// The error of an answer that agrees with no wrong model.
    #[serde(default)]
    pub hint: Option<Hint>,
}

impl Grade {
    /// Returns full marks within the tolerance, none at twice that.
    pub(super) fn within(off: f64, tolerance: f64) -> Self {
        let slack = 1e-9 * tolerance;
        Self {
            right: off <= tolerance + slack,
            score: (2.0 - off / tolerance).clamp(0.0, 1.0),
            off: Some(off),
            ..Self::default()
        }
    }
}
