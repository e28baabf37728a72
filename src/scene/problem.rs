//! What can be wrong with a scene, where, and what was expected instead.

use super::nearest::nearest;
use std::fmt;

/// Everything that is wrong with a scene: one problem or more.
///
/// Displayed, each problem takes one line.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneError {
    problems: Vec<Problem>,
    unlisted: usize,
}

/// Most problems that are listed; the rest are counted.
const MOST_LISTED: usize = 100;

impl SceneError {
    /// `Err` with the problems, or `Ok` where there are none.
    pub(super) fn check(mut problems: Vec<Problem>) -> Result<(), Self> {
        let unlisted = problems.len().saturating_sub(MOST_LISTED);
        problems.truncate(MOST_LISTED);
        if problems.is_empty() { Ok(()) } else { Err(Self { problems, unlisted }) }
    }

    /// At least one, and the first hundred at most, in the order of their lines.
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }
}

impl From<Problem> for SceneError {
    fn from(problem: Problem) -> Self {
        Self { problems: vec![problem], unlisted: 0 }
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
        match (self.unlisted, self.problems.last().map(|problem| &problem.place)) {
            (0, _) => Ok(()),
            (more, Some(Place::Line { file, .. })) => write!(f, "\n{file}: {more} more problems, expected none"),
            (more, _) => write!(f, "\n{more} more problems, expected none"),
        }
    }
}

/// One thing that is wrong with a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    pub place: Place,
    /// The key as `--set` takes it, for example `light.0.position`; empty where the whole text is meant.
    pub key: String,
    pub cause: Cause,
}

/// Where a problem was met.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// In a text, at a line counted from 1.
    Line { file: String, line: usize },
    /// In an override, `KEY=VALUE`.
    Override(String),
    /// In a scene without a text.
    Scene,
}

/// What is wrong.
#[derive(Clone, Debug, PartialEq)]
pub enum Cause {
    /// The text is not TOML; the parser's words.
    Syntax(String),
    /// The text is longer than [`Scene::MAX_TEXT`](super::Scene::MAX_TEXT) bytes.
    TooLong,
    /// The file's version is not one that this program reads.
    Version { found: String },
    /// No such key in a table; the keys that it has.
    UnknownKey { known: Vec<&'static str> },
    /// A choice that is not offered; the words that are.
    UnknownWord { word: String, known: Vec<&'static str> },
    /// A value that cannot be what the key means, by its type or by its number.
    Value { found: String, expected: String },
    /// A value, or its absence, that does not go with those of other keys.
    Conflict { is: &'static str, expected: &'static str },
    /// An override that is not `KEY=VALUE`.
    NotAnAssignment,
    /// An override of something inside a value that has no parts.
    NoParts { part: String },
    /// An override of an element beyond the end of a list of `count`.
    NoElement { index: usize, count: usize },
    /// Whatever else a type objects to.
    Other(String),
}

impl Problem {
    /// What is wrong, without the place.
    pub(super) fn in_words(&self) -> String {
        struct Words<'a>(&'a Problem);
        impl fmt::Display for Words<'_> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.cause.describe(f, &shortened(&self.0.key))
            }
        }
        Words(self).to_string()
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Place::Line { file, line } => write!(f, "{file}:{line}: ")?,
            Place::Override(assignment) => write!(f, "--set {}: ", shortened(assignment))?,
            Place::Scene => {}
        }
        self.cause.describe(f, &shortened(&self.key))
    }
}

impl Cause {
    fn describe(&self, f: &mut fmt::Formatter<'_>, key: &str) -> fmt::Result {
        match self {
            Self::Syntax(message) => write!(f, "{message}"),
            Self::TooLong => write!(f, "longer than {} MiB, expected a scene", super::Scene::MAX_TEXT >> 20),
            Self::Version { found } => {
                let program = env!("CARGO_PKG_VERSION");
                let version = super::Scene::VERSION;
                write!(f, "`version` is {found}, expected {version}: shading-lab {program} reads version {version}, ")?;
                write!(f, "for a later one take a later shading-lab")
            }
            Self::UnknownKey { known } => {
                write!(f, "unknown key `{key}`, ")?;
                choices(f, key.rsplit('.').next().unwrap_or(key), known)
            }
            Self::UnknownWord { word, known } => {
                write!(f, "`{key}` is {}, ", quoted(word))?;
                choices(f, word, known)
            }
            Self::Value { found, expected } => write!(f, "`{key}` is {found}, expected {expected}"),
            Self::Conflict { is, expected } => write!(f, "`{key}` {is}, expected {expected}"),
            Self::NotAnAssignment => write!(f, "no `=` after a key, expected KEY=VALUE, for example material.n=50"),
            Self::NoParts { part } => {
                write!(f, "`{key}` is a single value, expected no `{}` after it", shortened(part))
            }
            Self::NoElement { index, count } => {
                write!(f, "`{key}` has no element {index}, expected ")?;
                match count {
                    0 => write!(f, "none, since it is empty"),
                    1 => write!(f, "0, its only one"),
                    _ => write!(f, "0 to {}", count - 1),
                }
            }
            Self::Other(message) => write!(f, "`{key}`: {message}"),
        }
    }
}

/// The words to choose from, with the one probably meant.
fn choices(f: &mut fmt::Formatter<'_>, word: &str, known: &[&'static str]) -> fmt::Result {
    write!(f, "expected {}{}", if known.len() > 1 { "one of " } else { "" }, known.join(", "))?;
    match nearest(word, known.iter().copied()) {
        Some(meant) => write!(f, " (did you mean {meant}?)"),
        None => Ok(()),
    }
}

/// A piece of the user's text in quotation marks, short and without control characters.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", shortened(text))
}

/// The longest piece of the user's text that a message repeats, in characters.
const LONGEST_QUOTE: usize = 80;

fn shortened(text: &str) -> String {
    let mut short: String = text.chars().take(LONGEST_QUOTE).flat_map(char::escape_debug).collect();
    if text.chars().nth(LONGEST_QUOTE).is_some() {
        short.push('…');
    }
    short
}
