//! The state of the class as a student is told it, and the reasons why a request is refused.

use crate::lesson::{Answer, Pace};
use serde::Serialize;

/// The class as one student sees it, who may be at a step of their own.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OwnPace {
    /// The step and phase of the class.
    #[serde(flatten)]
    pub pace: Pace,
    /// The number of steps.
    pub steps: usize,
    /// The lecturer's step, if the student may be at another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lecturer: Option<usize>,
    /// The student's answer in this round.
    pub answered: Option<Answer>,
}

/// The reason why a request is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// It does not come from a student of this class.
    NoStudent,
    /// The step or its round is not open.
    NotOpen(Box<OwnPace>),
    /// The answer does not fit the question.
    Unfit,
    /// The requests come too fast.
    TooFast,
    /// There are as many students as there may be.
    Full,
    /// The lecturer has not shown it yet.
    NotYet,
    /// There is no such step.
    NoStep,
    /// It cannot be read.
    Malformed,
    /// It is too long.
    TooLong,
    /// It took too long.
    TooSlow,
    /// The step cannot be shown, in a sentence.
    Problem(String),
    /// Something failed on this machine, in a sentence.
    Failed(String),
}
