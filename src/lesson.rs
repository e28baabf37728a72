//! Lessons: text, scenes and questions, step by step. `docs/lessons.md` has the format.
//!
//! A lesson is a text file in CommonMark with TOML inside. The right answers are not in it: the engine computes them from the
//! scene of the step, so that they stay right when a number is changed.

mod axes;
mod budget;
mod builtin;
mod check;
mod class;
mod class_record;
mod class_sheet;
mod control;
mod feedback;
mod grade;
mod hand_in;
mod hint;
mod html;
mod inventory;
mod kinds;
mod lab;
mod links;
mod page;
mod prose;
mod question;
mod read;
mod record;
mod stage;
mod words;
mod worksheet;

pub use axes::CurveAxes;
pub use budget::{Budget, TooHeavy};
#[cfg(target_arch = "wasm32")]
pub use builtin::take_texts;
pub use builtin::{BuiltIn, LESSONS, TOPICS, are_there, find, topic_name};
pub use check::check;
pub use class::{
    Class, ClassQuestion, Given, Group, Handed, Student, Unreadable, collect, lesson_of, mark,
    spread,
};
pub use class_record::{
    ClassHead, ClassLine, ClassRecord, ClassStudent, MAX_ROUNDS, Pace, Phase, RoundAnswer,
};
pub use class_sheet::class_sheet;
pub use control::{control_name, slider, value_of};
pub use grade::Grade;
pub use hand_in::{
    ANSWERS_KEYWORD, HandIn, HandInError, MAX_NAME, answer_parts, clean, hand_in, hand_in_bytes,
    read_hand_in,
};
pub use hint::{CurveFault, Hint, Side};
pub use inventory::{ItemStatistics, TestStatistics, normalised_gain};
pub use kinds::kind::AnyKind;
#[cfg(feature = "app")]
pub(crate) use kinds::ordinate;
pub use kinds::{
    Answer, AnswerKey, CURVE_POINTS, Choice, ChoiceOption, Curve, CurveOf, Extreme, FORMULA_SIGNS,
    Find, Formula, FormulaOf, Goal, Item, Kind, Match, MatchValues, Name, Order, Point, Quantity,
    RightIf, SameFormula, Settings, Solution, Value, Values, letter, picture_distance,
    short_answer, short_number,
};
#[cfg(any(feature = "app", feature = "class"))]
pub(crate) use kinds::{abscissa, with_unit};
pub use lab::{Lab, LabPlace};
pub use links::{may_open, without_closed_links};
#[cfg(any(feature = "app", feature = "class"))]
pub(crate) use page::blocks;
pub use prose::Prose;
pub use question::{Question, Wrong};
pub use read::keys::Term;
pub use record::{Answered, Record, how_given};
pub use stage::{OVERLAYS, Stage, Staged};
pub use words::{for_fingers, in_words, without_marks};
pub use worksheet::{Worksheet, worksheet};
#[cfg(feature = "class")]
pub(crate) use {
    control::{control_unit, long_control_name},
    hand_in::digest,
    html::{Element, Html, element},
    kinds::{
        kind::{Printed, counted},
        lettered_html,
    },
    page::inline,
    worksheet::{FilledStep, answer, stage_picture},
};

use crate::document::{LoadError, ending, read_text};
use crate::text::Message;
use std::fmt;
use std::path::{Path, PathBuf};

/// A lesson that has been read.
///
/// ```
/// use shading_lab::lesson::{Answer, Lab, LESSONS};
///
/// let lesson = LESSONS[0].lesson();
/// let (step, question) = lesson
///     .steps
///     .iter()
///     .find_map(|step| Some((step, step.question.as_ref()?)))
///     .expect("a lesson asks something");
///
/// // The engine works the answer out from the step's scene.
/// let staged = step.stage.load(None)?;
/// let lab = Lab::new(&staged);
/// let key = question.solve_all(lab.place(&staged), 1)?;
/// let grade = question.grade(&Answer::right(&key.right), &key, lab.place(&staged));
/// assert!(grade.expect("an answer of the right kind").right);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Lesson {
    /// The name: lower-case words with hyphens.
    pub name: String,
    /// Its title.
    pub title: String,
    /// The chapter that it belongs to.
    pub topic: String,
    /// The time that it takes, in minutes.
    pub minutes: u32,
    /// A sentence about it; may be empty.
    pub about: String,
    /// True for a test: answers are kept without feedback, and the last one counts.
    pub test: bool,
    /// Its steps, at least one.
    pub steps: Vec<Step>,
    /// The folder of the files that it names; none for a built-in lesson.
    pub folder: Option<PathBuf>,
    /// The file that it was read from, whole.
    pub source: String,
}

/// A step of a lesson.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Its title.
    pub title: String,
    /// CommonMark, with numbers that the engine fills in.
    pub text: Prose,
    /// The text that is shown once the question is answered; may be empty.
    pub after: Prose,
    /// The scene, and what is shown of it.
    pub stage: Stage,
    /// The question; none in a step that only shows.
    pub question: Option<Question>,
    /// The line of the file at which it begins, from 1.
    pub line: u64,
}

impl Step {
    /// Returns the properties of its question.
    pub(crate) fn asks(&self) -> Option<&dyn AnyKind> {
        self.question.as_ref().map(|question| question.kind.asks())
    }
}

/// The problems of a lesson.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LessonError {
    /// The problems, at least one, by their lines.
    pub problems: Vec<LessonProblem>,
}

/// A problem of a lesson.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LessonProblem {
    /// The line of the file, from 1.
    pub line: u64,
    /// A sentence that says what is wrong.
    pub words: String,
}

impl LessonProblem {
    pub(crate) fn new(line: u64, words: impl Into<String>) -> Self {
        let words = words.into();
        Self { line, words }
    }
}

impl From<LessonProblem> for LessonError {
    fn from(problem: LessonProblem) -> Self {
        Self {
            problems: vec![problem],
        }
    }
}

impl LessonError {
    pub(crate) fn one(line: u64, words: impl Into<String>) -> Self {
        LessonProblem::new(line, words).into()
    }

    /// Returns each line of what is wrong, with the line of the lesson that it is about.
    fn lines(&self) -> impl Iterator<Item = (u64, &str)> {
        let problems = self.problems.iter();
        problems.flat_map(|problem| problem.words.lines().map(|words| (problem.line, words)))
    }
}

impl std::error::Error for LessonError {}

impl fmt::Display for LessonError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<_> = self
            .lines()
            .map(|(line, words)| format!("{line}: {words}"))
            .collect();
        f.write_str(&lines.join("\n"))
    }
}

/// The reason why a lesson could not be opened. Displayed, each problem takes a line with the file and the line in it.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OpenError {
    /// Its file could not be read.
    #[error(transparent)]
    File(#[from] LoadError),
    /// Its text is wrong.
    #[error("{}", in_file(.path, .error))]
    Lesson {
        /// The file.
        path: PathBuf,
        /// The problems, line by line.
        error: LessonError,
    },
}

fn in_file(path: &Path, error: &LessonError) -> String {
    let lines: Vec<_> = error
        .lines()
        .map(|(line, words)| format!("{}:{line}: {words}", path.display()))
        .collect();
    lines.join("\n")
}

/// The kind of file that was expected.
const LESSON_FILE: Message = Message("lesson-file");

impl Lesson {
    /// Opens a lesson's file.
    ///
    /// # Errors
    /// A file that cannot be read, or what is wrong with its form.
    pub fn open(path: &Path) -> Result<Self, OpenError> {
        let source = read_text(path, LESSON_FILE, Self::MAX_TEXT)?;
        Self::read(&source, path.parent()).map_err(|error| OpenError::Lesson {
            path: path.to_owned(),
            error,
        })
    }

    /// Returns whether a file is a lesson, by its name.
    pub fn is_file(path: &Path) -> bool {
        ending(path).as_deref() == Some("md")
    }

    /// Opens a lesson's file and has the engine check it.
    ///
    /// # Errors
    /// As [`Self::open`], and what [`check`] says.
    pub fn open_checked(path: &Path) -> Result<Self, OpenError> {
        let lesson = Self::open(path)?;
        check(&lesson).map_err(|error| OpenError::Lesson {
            path: path.to_owned(),
            error,
        })?;
        Ok(lesson)
    }

    /// The maximum length of a file, in bytes.
    pub const MAX_TEXT: usize = 1 << 20;
    /// The most steps.
    pub const MAX_STEPS: usize = 100;
}
