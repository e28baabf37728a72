//! The questions of a lesson.

use super::read::keys::Term;
use super::{Answer, Grade, Kind, LabPlace, Prose, Solution};

/// A question, asked before its answer can be seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The kind of answer that it wants.
    pub kind: Kind,
    /// The question itself, with numbers that the engine fills in.
    pub ask: Prose,
    /// The reason why the answer is right; may be empty.
    pub why: Prose,
    /// The part of the equation that it is about.
    pub term: Option<Term>,
    /// Settings for the right answer alone.
    pub set: Vec<String>,
    /// The line of the file at which it begins, from 1.
    pub line: u64,
}

impl Question {
    /// Finds the right answer in the scene of a step; `seed` decides what is drawn at random.
    ///
    /// # Errors
    /// Why there is none, or why it is not the only one, in a sentence.
    pub fn solve(&self, place: LabPlace<'_>, seed: u64) -> Result<Solution, String> {
        let there = place.under(&self.set);
        let solution = there.and_then(|there| self.kind.solve(there, seed));
        // Where single places have no value they are passed over; that must not hide that the rest was never looked at.
        match place.refused() {
            Some(refused) => Err(refused.to_string()),
            None => solution,
        }
    }

    /// Grades an answer, once the right one is known; none of another kind of question.
    pub fn grade(&self, given: &Answer, right: &Solution, place: LabPlace<'_>) -> Option<Grade> {
        let place = place.under(&self.set).ok()?;
        self.kind.grade(given, right, place)
    }

    /// Returns the texts of its options or items, or the names of its axes.
    pub fn names(&self) -> Vec<&Prose> {
        let asks = self.kind.asks();
        [asks.options(), asks.axes()].concat()
    }
}
