//! The grade of an answer.

use serde::{Deserialize, Serialize};

/// The grade of an answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Grade {
    /// The answer is within the question's tolerance.
    pub right: bool,
    /// From 0 to 1.
    pub score: f64,
    /// The distance from the right answer, in the question's own unit, where that has one.
    pub off: Option<f64>,
}

impl Grade {
    /// Returns full marks or none.
    pub(super) fn of(right: bool) -> Self {
        Self {
            right,
            score: f64::from(u8::from(right)),
            off: None,
        }
    }

    /// Returns full marks within the tolerance, none at twice that.
    pub(super) fn within(off: f64, tolerance: f64) -> Self {
        let slack = 1e-9 * tolerance;
        Self {
            right: off <= tolerance + slack,
            score: (2.0 - off / tolerance).clamp(0.0, 1.0),
            off: Some(off),
        }
    }
}
