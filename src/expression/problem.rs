//! The faults of expressions and formulas, and their places.

use crate::text::{excerpt, text};

/// Maximum nesting depth of parentheses, signs, powers and calls.
pub(super) const DEPTH: usize = 64;
/// Longest text, in bytes.
pub(super) const MOST: usize = 4096;
/// Maximum number of consecutive operations, which are evaluated one inside the other: `1+1+1` has two.
pub(super) const CHAIN: usize = 256;

/// The place of a character in a text, each from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Position {
    /// The line.
    pub line: usize,
    /// The character of the line.
    pub column: usize,
}

impl Position {
    /// Returns the position of the byte `at` of `text`.
    pub(crate) fn of(text: &str, at: usize) -> Self {
        let before = &text[..at.min(text.len())];
        let line = before.rfind('\n').map_or(0, |end| end + 1);
        Self {
            line: 1 + before.matches('\n').count(),
            column: 1 + before[line..].chars().count(),
        }
    }
}

/// The reason why a formula is refused, and the place.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", text!("formula-at", line = .position.line, column = .position.column, problem = .message.clone()))]
#[non_exhaustive]
pub struct FormulaError {
    /// The place of the first character that is wrong.
    pub position: Position,
    /// The problem in words, with what was expected and what was probably meant.
    pub message: String,
}

/// The token that a parser expects at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Expected {
    Value,
    Operator,
    Sign(&'static str),
    Name,
    Quote,
}

impl Expected {
    fn words(self) -> String {
        match self {
            Self::Value => text!("formula-expected-value").to_owned(),
            Self::Operator => text!("formula-expected-operator").to_owned(),
            Self::Sign(sign) => text!("formula-expected-sign", sign = sign),
            Self::Name => text!("formula-expected-name").to_owned(),
            Self::Quote => text!("formula-expected-quote").to_owned(),
        }
    }
}

/// The problem.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Fault {
    Unexpected(Expected),
    Unknown(String),
    Arguments {
        name: String,
        expected: usize,
        count: usize,
    },
    TooLong,
    Nested(usize),
}

/// A problem at a byte of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Problem {
    pub at: usize,
    pub fault: Fault,
}

impl Problem {
    pub(super) fn new(at: usize, fault: Fault) -> Self {
        Self { at, fault }
    }

    /// Returns what is wrong, as the end of a sentence that begins with the expression.
    pub(super) fn of_expression(&self, text: &str) -> String {
        match &self.fault {
            Fault::Unexpected(_) => match text[self.at..].chars().next() {
                Some(found) => text!(
                    "expression-unexpected",
                    found = found.to_string(),
                    place = 1 + text[..self.at].chars().count()
                ),
                None => text!("expression-ends").to_owned(),
            },
            Fault::Unknown(name) => text!("expression-unknown", name = excerpt(name)),
            Fault::Arguments {
                name,
                expected,
                count,
            } => text!(
                "expression-arguments",
                name = excerpt(name),
                expected = *expected,
                count = *count
            ),
            Fault::TooLong => text!("expression-too-long", most = MOST),
            Fault::Nested(most) => text!("expression-nested", most = *most),
        }
    }

    /// Returns what is wrong with a formula, as a sentence; `meant` is appended to an unknown name.
    pub(super) fn of_formula(&self, text: &str, meant: &dyn Fn(&str) -> String) -> String {
        match &self.fault {
            Fault::Unexpected(expected) => {
                let expected = expected.words();
                match text[self.at..].chars().next() {
                    Some(found) => text!(
                        "formula-unexpected",
                        found = excerpt(&found.to_string()),
                        expected = expected
                    ),
                    None => text!("formula-ends", expected = expected),
                }
            }
            Fault::Unknown(name) => {
                text!("formula-unknown", name = excerpt(name), meant = meant(name))
            }
            Fault::Arguments {
                name,
                expected,
                count,
            } => text!(
                "formula-arguments",
                name = excerpt(name),
                expected = *expected,
                count = *count
            ),
            Fault::TooLong => text!("formula-too-long", most = MOST, count = text.len()),
            Fault::Nested(most) => text!("formula-nested", most = *most),
        }
    }
}
