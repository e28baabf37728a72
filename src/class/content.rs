//! The engine's part in a class: the page of each step, its right answer, and the grades of the answers.

use super::files::StaticFile;
use super::page::{StepPage, step_page};
use crate::lesson::{Answer, Budget, ClassQuestion, Grade, Lab, Lesson, Question, Staged, counted};
use crate::text::text;
use std::mem;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, OnceLock};
use tokio::sync::watch;

/// A step as a class has it.
#[derive(Debug)]
pub struct StepContent {
    /// Its part of the phones' page; the pictures are in `pictures`.
    pub page: StepPage,
    /// Its pictures.
    pub(super) pictures: Vec<StaticFile>,
    /// Its question with the right answer and those of the wrong models; `None` if it asks nothing.
    pub asked: Option<ClassQuestion>,
}

/// The answers of a class to a step's question, as they are shown on the wall.
#[derive(Clone, Debug)]
pub struct Spread {
    /// The step, from 1.
    pub step: usize,
    /// The rounds, at least one.
    pub rounds: Vec<Round>,
}

/// The answers in a round.
#[derive(Clone, Debug, Default)]
pub struct Round {
    /// The answers, in the order in which the students first answered in this class.
    pub answers: Vec<Graded>,
}

/// An answer with its grade.
#[derive(Clone, Debug)]
pub struct Graded {
    /// The student's number, from 1.
    pub student: u32,
    /// The answer.
    pub answer: Answer,
    /// The grade; an answer that cannot be graded, such as half a curve, is not right.
    pub grade: Grade,
}

impl Round {
    /// Counts the right answers.
    pub fn right(&self) -> usize {
        let answers = self.answers.iter();
        answers.filter(|graded| graded.grade.right).count()
    }

    /// Returns the wrong models that answers agree with, each with how often; the most frequent first.
    pub fn models(&self) -> Vec<(usize, usize)> {
        let wrong = self.answers.iter().filter(|graded| !graded.grade.right);
        let mut models: Vec<usize> = wrong.filter_map(|graded| graded.grade.model).collect();
        // Of those with equal counts the first one comes first.
        models.sort_unstable();
        counted(models.into_iter())
    }
}

/// The steps of a lesson, each prepared once.
#[derive(Debug)]
pub struct Content {
    steps: Vec<OnceLock<Result<Arc<StepContent>, String>>>,
    ready: watch::Sender<()>,
}

impl Content {
    /// Creates the contents of a lesson's steps, none of them prepared.
    pub fn new(lesson: &Lesson) -> Self {
        Self {
            steps: lesson.steps.iter().map(|_| OnceLock::new()).collect(),
            ready: watch::Sender::new(()),
        }
    }

    /// Returns a step, from 1, once it is prepared; an error is what is wrong with it, in a sentence.
    pub fn step(&self, step: usize) -> Option<Result<Arc<StepContent>, String>> {
        self.steps.get(step.checked_sub(1)?)?.get().cloned()
    }

    /// Waits until a step, from 1, is prepared.
    pub async fn prepared(&self, step: usize) -> Result<Arc<StepContent>, String> {
        let mut ready = self.ready.subscribe();
        loop {
            if let Some(content) = self.step(step) {
                return content;
            }
            // The sender lives as long as this.
            let _ = ready.changed().await;
        }
    }

    /// Prepares a step, from 1, unless it is prepared.
    pub fn prepare(&self, lesson: &Lesson, seed: u64, step: usize) {
        let place = step.checked_sub(1).and_then(|index| self.steps.get(index));
        let Some(place) = place.filter(|place| place.get().is_none()) else {
            return;
        };
        // Whoever waits for the step is told, even after a panic.
        let content = catch_unwind(AssertUnwindSafe(|| step_content(lesson, seed, step - 1)));
        let content = content.unwrap_or_else(|_| Err(text!("render-job-ended").to_owned()));
        let _ = place.set(content.map(Arc::new));
        self.ready.send_replace(());
    }
}

/// Prepares a step, from 0.
fn step_content(lesson: &Lesson, seed: u64, index: usize) -> Result<StepContent, String> {
    let mut page = step_page(lesson, index, seed).map_err(|error| error.to_string())?;
    let pictures = mem::take(&mut page.pictures).into_iter();
    let pictures = pictures
        .map(|bytes| StaticFile::new(".png", bytes))
        .collect();
    let asked = match &lesson.steps[index].question {
        Some(question) => {
            let (staged, lab) = laboratory(lesson, index)?;
            let place = lab.place(&staged);
            Some(ClassQuestion::live(index, question, place, seed)?)
        }
        None => None,
    };
    Ok(StepContent {
        page,
        pictures,
        asked,
    })
}

/// Loads the scene of a step, from 0, into a lab.
fn laboratory(lesson: &Lesson, index: usize) -> Result<(Staged, Lab), String> {
    let staged = lesson.steps[index].stage.load(lesson.folder.as_deref());
    let staged = staged.map_err(|error| error.to_string())?;
    let lab = Lab::within(&staged, &Budget::of_file());
    Ok((staged, lab))
}

/// Grades the answers to the question of a step, from 1, round by round.
///
/// # Errors
/// The question has no right answer, in a sentence.
pub fn graded(
    lesson: &Lesson,
    content: &StepContent,
    step: usize,
    rounds: Vec<Vec<(u32, Answer)>>,
) -> Result<Spread, String> {
    let asked = content.asked.as_ref();
    let key = asked.and_then(|asked| asked.key.as_ref());
    let question: Option<&Question> = asked.and_then(|asked| asked.question(lesson));
    let (Some(key), Some(question)) = (key, question) else {
        return Err(text!("live-no-question").to_owned());
    };
    let (staged, lab) = laboratory(lesson, step - 1)?;
    let place = lab.place(&staged);
    let grade = |(student, answer): (u32, Answer)| {
        let grade = question.grade(&answer, key, place).unwrap_or_default();
        Graded {
            student,
            answer,
            grade,
        }
    };
    let round = |answers: Vec<(u32, Answer)>| Round {
        answers: answers.into_iter().map(grade).collect(),
    };
    let rounds = rounds.into_iter().map(round).collect();
    Ok(Spread { step, rounds })
}
