//! A student's hand-in, each answer of it graded.

use crate::lesson::{Answered, Budget, Grade, TooHeavy};

/// A hand-in that counts.
#[derive(Debug)]
pub struct Student {
    /// Its number among the files, from 0.
    pub index: usize,
    /// The file's name.
    pub file: String,
    /// The student's name; may be empty.
    pub name: String,
    pub(super) seed: u64,
    /// The work that grading the file may cause.
    pub(super) budget: Budget,
    /// The question, from 0, whose answer takes more than that, with the reason.
    pub(super) heavy: Option<(usize, TooHeavy)>,
    /// The answers, one entry per question.
    pub given: Vec<Option<Given>>,
}

/// An answer, graded.
#[derive(Clone, Debug)]
pub struct Given {
    /// The answer, with the tries before it.
    pub answered: Answered,
    /// The grade of the last answer; `None` if the question has no right answer.
    pub grade: Option<Grade>,
    /// The grade of the first answer.
    pub predicted: Option<Grade>,
}

impl Student {
    /// Counts the right answers.
    pub fn right(&self) -> usize {
        let right = |given: &&Option<Given>| given.as_ref().is_some_and(Given::is_right);
        self.given.iter().filter(right).count()
    }
}

impl Given {
    /// Returns whether it is right, within the question's tolerance.
    pub fn is_right(&self) -> bool {
        self.grade.is_some_and(|grade| grade.right)
    }
}
