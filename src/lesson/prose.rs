//! Text with numbers in it that the engine computes: `{{ EXPRESSION | DIGITS }}`.

use super::LessonProblem;
use crate::expression::{Expression, Quantities};
use crate::text::{fixed, text};

/// A text with numbers to be filled in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Prose {
    /// A piece of text, and the number that follows it.
    pieces: Vec<(String, Option<Number>)>,
}

#[derive(Clone, Debug, PartialEq)]
struct Number {
    value: Expression,
    /// After the point.
    digits: usize,
    line: u64,
}

/// Returns the problem of a number in a line.
fn problem(line: u64, words: String) -> LessonProblem {
    LessonProblem::new(line, text!("lesson-number", words = words))
}

impl Prose {
    /// Reads a text that begins in a line of a file.
    ///
    /// # Errors
    /// A number that cannot be read.
    pub(super) fn read(text: &str, line: u64) -> Result<Self, LessonProblem> {
        let mut pieces = Vec::new();
        let (mut rest, mut line) = (text, line);
        let lines = |text: &str| text.matches('\n').count() as u64;
        while let Some((before, after)) = rest.split_once("{{") {
            line += lines(before);
            let Some((inside, behind)) = after.split_once("}}") else {
                return Err(LessonProblem::new(line, text!("lesson-number-open")));
            };
            let (value, digits) = match inside.rsplit_once('|') {
                Some((value, digits)) => {
                    let digits = digits.trim().parse().ok().filter(|digits| *digits <= 9);
                    let wrong = || LessonProblem::new(line, text!("lesson-number-digits"));
                    (value, digits.ok_or_else(wrong)?)
                }
                None => (inside, 2),
            };
            let value = Expression::read(value.trim()).map_err(|words| problem(line, words))?;
            let number = Number {
                value,
                digits,
                line,
            };
            pieces.push((before.to_owned(), Some(number)));
            line += lines(inside);
            rest = behind;
        }
        pieces.push((rest.to_owned(), None));
        Ok(Self { pieces })
    }

    /// Returns whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.pieces
            .iter()
            .all(|(text, number)| number.is_none() && text.trim().is_empty())
    }

    /// Returns the text without its numbers.
    pub fn plain(&self) -> String {
        self.pieces.iter().map(|(text, _)| &**text).collect()
    }

    /// Returns the text with its numbers.
    ///
    /// # Errors
    /// A number that has no value.
    pub fn filled(&self, quantities: &dyn Quantities) -> Result<String, LessonProblem> {
        let mut filled = String::new();
        for (text, number) in &self.pieces {
            filled.push_str(text);
            if let Some(number) = number {
                let value = number.value.number(quantities);
                let value = value.map_err(|words| problem(number.line, words))?;
                filled.push_str(&fixed(value, number.digits));
            }
        }
        Ok(filled)
    }
}
