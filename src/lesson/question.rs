//! The questions of a lesson.

use super::read::keys::Term;
use super::{Answer, AnswerKey, Grade, Kind, LabPlace, Prose, Solution};
use crate::text::text;

/// A question, asked before its answer can be seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The kind of answer that it wants.
    pub kind: Kind,
    /// The question itself, with numbers that the engine fills in.
    pub ask: Prose,
    /// The reason why the answer is right; may be empty.
    pub why: Prose,
    /// The beliefs of students who are wrong.
    pub wrong: Vec<Wrong>,
    /// The part of the equation that it is about.
    pub term: Option<Term>,
    /// Settings for the right answer alone.
    pub set: Vec<String>,
    /// The line of the file at which it begins, from 1.
    pub line: u64,
}

/// A wrong model: a misconception, with the answer that it leads to.
#[derive(Clone, Debug, PartialEq)]
pub struct Wrong {
    /// A sentence that names the misconception.
    pub says: Prose,
    /// The question whose right answer is the wrong one.
    pub kind: Kind,
    /// Settings for its answer.
    pub set: Vec<String>,
    /// The line of the file at which it begins, from 1.
    pub line: u64,
}

impl Wrong {
    /// The most wrong models of a question.
    pub const MOST: usize = 8;
}

impl Question {
    /// Finds the right answer in the scene of a step; `seed` decides what is drawn at random.
    ///
    /// # Errors
    /// The reason why there is none, or not only one, in a sentence.
    pub fn solve(&self, place: LabPlace<'_>, seed: u64) -> Result<Solution, String> {
        let there = place.under(&self.set);
        let solution = there.and_then(|there| self.kind.solve(there, seed));
        unless_refused(place, solution)
    }

    /// Finds the right answer and those of the wrong models.
    ///
    /// # Errors
    /// The reason why one of them is missing, in a sentence.
    pub fn solve_all(&self, place: LabPlace<'_>, seed: u64) -> Result<AnswerKey, String> {
        let right = self.solve(place, seed)?;
        let wrong = self.wrong.iter().enumerate();
        let wrong = wrong.map(|(index, wrong)| {
            let named = |words| text!("lesson-wrong", number = index + 1, words = words);
            wrong.solve(place, seed).map_err(named)
        });
        Ok(AnswerKey {
            right,
            wrong: wrong.collect::<Result<_, _>>()?,
        })
    }

    /// Grades an answer, once the right one and those of the wrong models are known; none of another kind of question.
    pub fn grade(&self, given: &Answer, key: &AnswerKey, place: LabPlace<'_>) -> Option<Grade> {
        let place = place.under(&self.set).ok()?;
        self.kind.grade(given, key, place)
    }

    /// Returns the texts of its options or items, or the names of its axes.
    pub fn names(&self) -> Vec<&Prose> {
        let asks = self.kind.asks();
        [asks.options(), asks.axes()].concat()
    }

    /// Returns what is said of each wrong model; of a choice what is said of each option.
    pub fn says(&self) -> Vec<&Prose> {
        match &self.kind {
            Kind::Choice(choice) => choice.options.iter().map(|option| &option.says).collect(),
            _ => self.wrong.iter().map(|wrong| &wrong.says).collect(),
        }
    }

    /// Returns whether it explains a wrong model.
    pub fn knows_wrong(&self) -> bool {
        self.says().iter().any(|says| !says.is_empty())
    }
}

impl Wrong {
    /// Finds its answer in the scene of a step.
    ///
    /// # Errors
    /// The reason why there is none, in a sentence.
    pub fn solve(&self, place: LabPlace<'_>, seed: u64) -> Result<Solution, String> {
        let there = place.under(&self.set);
        let solution = there.and_then(|there| self.kind.solve_wrong(there, seed));
        unless_refused(place, solution)
    }
}

/// Passes a solution on unless work was refused: single places without a value are passed over, which must not hide that
/// the rest was never looked at.
fn unless_refused(
    place: LabPlace<'_>,
    solution: Result<Solution, String>,
) -> Result<Solution, String> {
    match place.refused() {
        Some(refused) => Err(refused.to_string()),
        None => solution,
    }
}
