//! The grade of an answer.

use super::Hint;
use serde::{Deserialize, Serialize};

/// The grade of an answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Grade {
    /// True if the answer is within the question's tolerance, and no nearer to a wrong model.
    pub right: bool,
    /// The score, from 0 to 1; 0 for an answer that is nearer to a wrong model.
    pub score: f64,
    /// The distance from the right answer, in the question's own unit, where that has one.
    pub off: Option<f64>,
    /// The index of the wrong model that the answer agrees with; for a choice, that of the option.
    #[serde(default)]
    pub model: Option<usize>,
    /// The error of an answer that agrees with no wrong model.
    #[serde(default)]
    pub hint: Option<Hint>,
}

impl Grade {
    /// Grades by the distance from the right answer: full marks at that, none at twice the tolerance.
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
