//! Answers that were handed in, graded by the engine in the background.

use crate::analysis::Watch;
use crate::analysis::codec::Codec;
use crate::app::session::document::CoursePart;
use crate::jobs::{Background, Work};
use crate::lesson::{
    Answer, ClassQuestion, Given, Grade, HandIn, HandInError, Lesson, Question, are_there,
    lesson_of, mark, short_answer,
};
use crate::text::text;
use egui_commonmark::CommonMarkCache;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::sync::Arc;

/// The answers handed in with the document, shown beside their picture.
pub struct HandedIn {
    pub answers: Arc<Result<HandIn, HandInError>>,
    pub work: Background<Marking>,
    pub markdown: CommonMarkCache,
    /// True if the list of lessons is shown instead.
    pub closed: bool,
    /// True until the answers have been shown once.
    pub fresh: bool,
}

impl HandedIn {
    /// Returns the answers of a document, if it has any.
    pub fn of(part: &CoursePart) -> Option<Self> {
        let CoursePart::HandIn(answers) = part else {
            return None;
        };
        Some(Self::with(Arc::clone(answers)))
    }

    /// Returns answers that are to be graded.
    pub fn with(answers: Arc<Result<HandIn, HandInError>>) -> Self {
        Self {
            answers,
            work: Background::default(),
            markdown: CommonMarkCache::default(),
            closed: false,
            fresh: true,
        }
    }

    /// Returns whether the answers are those of a document.
    pub fn is_of(&self, part: &CoursePart) -> bool {
        matches!(part, CoursePart::HandIn(answers) if Arc::ptr_eq(answers, &self.answers))
    }
}

/// The task of grading answers.
#[derive(Serialize, Deserialize)]
pub struct Marking {
    answers: HandIn,
    lesson: Result<LessonText, String>,
}

/// A lesson as it is sent to a worker.
#[derive(Serialize, Deserialize)]
struct LessonText {
    source: String,
    folder: Option<PathBuf>,
    /// True if the lesson came with the hand-in; it then may not open any file.
    foreign: bool,
}

/// A hand-in with its grades.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Marked {
    /// The lesson's title.
    pub title: String,
    /// The number of right answers.
    pub right: usize,
    pub questions: Vec<MarkedQuestion>,
}

/// A question with the student's answer.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MarkedQuestion {
    pub ask: String,
    pub given: Option<MarkedAnswer>,
    /// The right answer; `None` if there is no single one, or if finding it failed.
    pub right: Option<String>,
    /// The reason why there is no right answer.
    pub failure: Option<String>,
}

/// An answer in words.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct MarkedAnswer {
    pub words: String,
    /// The first answer, if it differs.
    pub first: Option<String>,
    /// The explanation of the wrong model that the first answer agrees with, or else the last.
    pub model: Option<String>,
    pub grade: Option<Grade>,
    pub tries: u32,
    pub looked_up: u32,
    pub seconds: f64,
}

impl Marking {
    /// Creates the task of grading `answers`, or `None` while the program's lessons are not loaded; `own` is
    /// the lesson opened from a file.
    pub fn of(answers: &HandIn, own: Option<&Lesson>) -> Option<Self> {
        let own = own.filter(|own| answers.is_of(own));
        let found = match own {
            Some(own) => Ok((own.clone(), false)),
            None if are_there() => lesson_of(answers, None),
            None => return None,
        };
        Some(Self {
            answers: answers.clone(),
            lesson: found.map(|(lesson, foreign)| LessonText {
                source: lesson.source,
                folder: lesson.folder,
                foreign,
            }),
        })
    }
}

impl Work for Marking {
    type Answer = Marked;

    const CODECS: Option<(Codec<Self>, Codec<Marked>)> = Some((Codec::plain(), Codec::plain()));

    fn run(&self, watch: &dyn Watch<Marked>) -> Result<Marked, String> {
        let text = self.lesson.as_ref().map_err(Clone::clone)?;
        let lesson = Lesson::read(&text.source, text.folder.as_deref());
        let lesson = lesson.map_err(|error| error.to_string())?;
        let count = lesson.steps.len() as f32;
        let mut done = 0.0;
        let mut progress = || {
            done += 1.0;
            // After a cancellation nobody reads the answer.
            let _ = watch.progress(done / count);
        };
        let group = mark(self.answers.clone(), lesson, text.foreign, &mut progress)?;
        let none = || text!("render-job-ended").to_owned();
        let student = group.students.first().ok_or_else(none)?;
        let questions = group.questions.iter().zip(&student.given);
        Ok(Marked {
            title: group.lesson.title.clone(),
            right: student.right(),
            questions: questions
                .map(|(asked, given)| marked(asked, asked.question(&group.lesson), given.as_ref()))
                .collect(),
        })
    }
}

fn marked(
    asked: &ClassQuestion,
    question: Option<&Question>,
    given: Option<&Given>,
) -> MarkedQuestion {
    let words = |answer: &Answer| match question {
        Some(question) => question.kind.words(answer, &asked.options),
        None => short_answer(answer),
    };
    let given = given.map(|given| {
        let answered = &given.answered;
        let mut grades = [given.predicted, given.grade].into_iter().flatten();
        let model = grades.find_map(|grade| grade.model);
        MarkedAnswer {
            words: words(&answered.answer),
            first: (answered.prediction != answered.answer).then(|| words(&answered.prediction)),
            model: model.and_then(|model| asked.says.get(model).cloned()),
            grade: given.grade,
            tries: answered.tries,
            looked_up: answered.looked_up,
            seconds: answered.seconds,
        }
    });
    MarkedQuestion {
        ask: asked.ask.clone(),
        given,
        right: asked
            .solution()
            .filter(|_| !question.is_some_and(|question| question.kind.asks().is_drawn()))
            .map(|solution| words(&Answer::right(solution))),
        failure: asked.failure.clone(),
    }
}
