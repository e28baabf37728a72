//! Problems of a scene: what is wrong, where, and what was expected instead.

use crate::text::{nearest, text};
use std::fmt;

/// Everything that is wrong with a scene: one problem or more.
///
/// Displayed, each problem takes one line.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneError {
    problems: Vec<Problem>,
    unlisted: usize,
}

/// The most problems that are listed; the rest are counted.
const MOST_LISTED: usize = 100;

impl SceneError {
    /// Returns `Err` with the problems, or `Ok` if there are none.
    pub(super) fn check(
        unlocated: Vec<UnlocatedProblem>,
        mut place: impl FnMut(&UnlocatedProblem) -> ProblemLocation,
    ) -> Result<(), Self> {
        let unlisted = unlocated.len().saturating_sub(MOST_LISTED);
        let located = |problem: UnlocatedProblem| Problem {
            place: place(&problem),
            key: problem.key,
            cause: problem.cause,
        };
        let problems: Vec<Problem> = unlocated
            .into_iter()
            .take(MOST_LISTED)
            .map(located)
            .collect();
        if problems.is_empty() {
            Ok(())
        } else {
            Err(Self { problems, unlisted })
        }
    }

    /// Returns the problems in the order of their lines: at least one, at most the first hundred.
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }
}

impl std::error::Error for SceneError {}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, problem) in self.problems.iter().enumerate() {
            if i > 0 {
                writeln!(f)?;
            }
            write!(f, "{problem}")?;
        }
        match (
            self.unlisted,
            self.problems.last().map(|problem| &problem.place),
        ) {
            (0, _) => Ok(()),
            (more, Some(ProblemLocation::Line { file, .. })) => {
                write!(f, "\n{file}: {}", text!("problem-more", count = more))
            }
            (more, _) => write!(f, "\n{}", text!("problem-more", count = more)),
        }
    }
}

/// One thing that is wrong with a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// The place of the problem.
    pub place: ProblemLocation,
    /// The key as `--set` takes it, for example `light.0.position`; empty for a problem of the whole text.
    pub key: String,
    /// The fault.
    pub cause: Cause,
}

/// The place of a problem.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProblemLocation {
    /// A line of a text.
    Line {
        /// The text's name: its file's path, or a built-in scene's name.
        file: String,
        /// The line, counted from 1.
        line: usize,
    },
    /// An override, `KEY=VALUE`.
    Override(String),
    /// A scene without a text.
    Scene,
}

/// The cause of a problem.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cause {
    /// A key that its table does not have.
    UnknownKey {
        /// The keys that the table has.
        known: Vec<&'static str>,
    },
    /// A fault of a key: the words that follow the key in a message.
    Key(String),
    /// A fault of a text as a whole, in a sentence.
    Text(String),
}

impl Cause {
    /// Describes a value that the key cannot have, by its type or its number.
    pub(super) fn value(found: impl fmt::Display, expected: impl fmt::Display) -> Self {
        Self::Key(text!(
            "problem-value",
            found = found.to_string(),
            expected = expected.to_string()
        ))
    }

    pub(super) fn unknown_word(word: &str, known: &[&'static str]) -> Self {
        Self::Key(text!(
            "problem-unknown-word",
            found = quoted(word),
            expected = choices(word, known)
        ))
    }

    /// Describes a version of the file that this program does not read.
    pub(super) fn version(found: impl fmt::Display) -> Self {
        let (program, version) = (env!("CARGO_PKG_VERSION"), super::Scene::VERSION);
        Self::Text(text!(
            "problem-version",
            found = found.to_string(),
            version = version,
            program = program
        ))
    }
}

/// A problem before its place is known.
#[derive(Debug)]
pub struct UnlocatedProblem {
    /// The key; while a value is read, the part after the value's own key, for example `.2`.
    pub key: String,
    /// The byte of the text, if it is not the key's own.
    pub offset: Option<usize>,
    pub cause: Cause,
}

impl UnlocatedProblem {
    pub fn new(key: impl Into<String>, cause: Cause) -> Self {
        Self {
            key: key.into(),
            offset: None,
            cause,
        }
    }

    /// Creates a problem of the value that is being read.
    pub fn value(found: impl fmt::Display, expected: impl fmt::Display) -> Self {
        Self::new("", Cause::value(found, expected))
    }

    /// Describes the problem without its place.
    pub fn in_words(key: &str, cause: &Cause) -> String {
        let short = shortened(key);
        match cause {
            Cause::UnknownKey { known } => {
                let name = short.rsplit('.').next().unwrap_or(&short);
                let expected = choices(name, known);
                text!("problem-unknown-key", key = short, expected = expected)
            }
            Cause::Key(words) => format!("`{short}` {words}"),
            Cause::Text(sentence) => sentence.clone(),
        }
    }
}

impl Problem {
    /// Describes the problem without its place.
    pub fn words(&self) -> String {
        UnlocatedProblem::in_words(&self.key, &self.cause)
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            ProblemLocation::Line { file, line } => write!(f, "{file}:{line}: ")?,
            ProblemLocation::Override(assignment) => {
                write!(f, "--set {}: ", shortened(assignment))?;
            }
            ProblemLocation::Scene => {}
        }
        f.write_str(&self.words())
    }
}

/// Returns the words to choose from, with the one probably meant.
fn choices(word: &str, known: &[&'static str]) -> String {
    let meant = nearest(word, known.iter().copied());
    let expected = match known {
        [one] => text!("problem-expected", known = *one),
        _ => text!("problem-expected-one-of", known = known.join(", ")),
    };
    match meant {
        Some(meant) => text!("problem-did-you-mean", expected = expected, meant = meant),
        None => expected,
    }
}

/// Quotes a piece of the user's text, shortened and without control characters.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", shortened(text))
}

/// The longest piece of the user's text that a message repeats, in characters.
const LONGEST_QUOTE: usize = 80;

pub(super) fn shortened(text: &str) -> String {
    let mut short: String = text
        .chars()
        .take(LONGEST_QUOTE)
        .flat_map(char::escape_debug)
        .collect();
    if text.chars().nth(LONGEST_QUOTE).is_some() {
        short.push('…');
    }
    short
}
