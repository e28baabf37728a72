//! Text with numbers in it that the engine computes: `{{ EXPRESSION | DIGITS }}`.

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

impl Prose {
    /// Reads a text that begins in a line of a file.
    ///
    /// # Errors
    /// A number that cannot be read: its line, and what is wrong.
    pub(super) fn read(text: &str, line: u64) -> Result<Self, (u64, String)> {
        let mut pieces = Vec::new();
        let (mut rest, mut line) = (text, line);
        let lines = |text: &str| text.matches('\n').count() as u64;
        while let Some((before, after)) = rest.split_once("{{") {
            line += lines(before);
            let Some((inside, behind)) = after.split_once("}}") else {
                return Err((line, text!("lesson-number-open").to_owned()));
            };
            let (value, digits) = match inside.rsplit_once('|') {
                Some((value, digits)) => {
                    let digits = digits.trim().parse().ok().filter(|digits| *digits <= 9);
                    let wrong = || (line, text!("lesson-number-digits").to_owned());
                    (value, digits.ok_or_else(wrong)?)
                }
                None => (inside, 2),
            };
            let value = Expression::read(value.trim())
                .map_err(|words| (line, text!("lesson-number", words = words)))?;
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
    /// A number that has no value: its line, and why.
    pub fn filled(&self, quantities: &dyn Quantities) -> Result<String, (u64, String)> {
        let mut filled = String::new();
        for (text, number) in &self.pieces {
            filled.push_str(text);
            if let Some(number) = number {
                let value = number.value.number(quantities);
                let value =
                    value.map_err(|words| (number.line, text!("lesson-number", words = words)))?;
                filled.push_str(&fixed(value, number.digits));
            }
        }
        Ok(filled)
    }
}
