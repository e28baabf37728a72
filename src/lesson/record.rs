//! The answers of a student in a lesson: the window keeps them and a hand-in carries them.

use super::kinds::short_answer;
use super::{Answer, Grade, Lesson};
use crate::text::text;
use serde::{Deserialize, Serialize};

/// The time, in seconds, from which on it is not shown: after a day it says nothing about how long the student
/// has thought.
const DAY: f64 = 86_400.0;

/// Every answer to the questions of a lesson.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The lesson's name.
    pub lesson: String,
    /// The seed of what is drawn at random.
    pub seed: u64,
    /// The answers, in the order of their steps.
    pub answers: Vec<Answered>,
}

/// The answer to the question of one step.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answered {
    /// The step, from 0.
    pub step: usize,
    /// The first answer that was given: the prediction.
    pub prediction: Answer,
    /// The last answer before the right one was shown.
    pub answer: Answer,
    /// The grade of the last answer.
    pub grade: Grade,
    /// The number of times that the right answer was asked for before it was found.
    pub looked_up: u32,
    /// The number of answers that were given.
    pub tries: u32,
    /// The time from when the question was first seen until the last answer, in seconds.
    pub seconds: f64,
}

impl Answered {
    /// Returns the first answer, if it was another one, and the last, in a few characters.
    pub fn short(&self) -> String {
        let [first, last] = [&self.prediction, &self.answer].map(short_answer);
        if self.prediction == self.answer {
            last
        } else {
            format!("{first} → {last}")
        }
    }
}

impl Record {
    /// Creates a record without answers.
    pub fn new(lesson: &str, seed: u64) -> Self {
        Self {
            lesson: lesson.to_owned(),
            seed,
            answers: Vec::new(),
        }
    }

    /// Returns the answer to a step's question.
    pub fn answer(&self, step: usize) -> Option<&Answered> {
        self.answers.iter().find(|answered| answered.step == step)
    }

    /// Puts an answer in its place; it replaces the one of the same step.
    pub fn put(&mut self, answered: Answered) {
        let after = self
            .answers
            .partition_point(|known| known.step < answered.step);
        match self.answers.get_mut(after) {
            Some(known) if known.step == answered.step => *known = answered,
            _ => self.answers.insert(after, answered),
        }
    }

    /// Keeps the answers that the questions of a lesson can have, each once and in order: anybody may have written a record.
    pub fn fit(&mut self, lesson: &Lesson) {
        let question = |step: usize| lesson.steps.get(step)?.question.as_ref();
        self.answers.retain(|answered| {
            question(answered.step).is_some_and(|question| {
                answered.prediction.fits(&question.kind) && answered.answer.fits(&question.kind)
            })
        });
        self.answers.sort_by_key(|answered| answered.step);
        self.answers.dedup_by_key(|answered| answered.step);
    }
}

/// Describes after how many tries and how long an answer was given, and how often the right one was looked up.
pub fn how_given(tries: u32, looked_up: u32, seconds: f64) -> Vec<String> {
    let mut parts = Vec::new();
    if tries > 1 {
        parts.push(text!("course-answers-tries", count = tries));
    }
    if looked_up > 0 {
        parts.push(text!("class-looked-up", count = looked_up));
    }
    if (1.0..DAY).contains(&seconds) {
        let seconds = format!("{seconds:.0}");
        parts.push(text!("course-answers-seconds", seconds = seconds));
    }
    parts
}
