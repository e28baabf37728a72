//! A formula over given names: lines `name = …` and one value at the end, with numbers and vectors, whose types are checked.
//!
//! ```text
//!   formula = { name = either newline } either
//! ```
//!
//! A line that begins with an operator continues the line above; `#` and `//` begin comments. A middle dot between two
//! vectors is their dot product and binds them closer than any operator: `N·L^2` is the square of `N·L`.

mod names;
mod operator;
mod typed;
mod types;

pub use names::Names;
pub use operator::Operator;
pub use typed::{Line, Term, Type, Typed};

use super::parser::Rest;
use super::problem::{DEPTH, Expected, FormulaError, Position};
use crate::text::text;
use std::ops::Range;
use typed::Refusal;
use types::Checker;

/// A formula whose names are known and whose types agree.
///
/// # Guarantees
/// It has at least one line; all lines but the last have names, and the last is a number or a truth value. A line refers only
/// to lines before it. It has at most [`Formula::MOST_OPERATIONS`] operations.
///
/// ```
/// use shading_lab::expression::{Formula, Names};
///
/// let names = Names::new(&["kd", "N·L"], &[]);
/// assert!(Formula::read("kd * max(N·L, 0)", &names).is_ok());
/// let error = Formula::read("kd *\n max(N·K, 0)", &names).unwrap_err();
/// assert_eq!((error.position.line, error.position.column), (2, 6));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    text: String,
    lines: Vec<Line>,
}

impl Formula {
    /// The longest text, in characters.
    pub const MOST_CHARACTERS: usize = 2000;
    /// The most operators and calls.
    pub const MOST_OPERATIONS: usize = 256;

    /// Reads a formula over `names`; the error says where it is wrong, what was expected there, and the nearest name.
    pub fn read(text: &str, names: &Names) -> Result<Self, FormulaError> {
        Self::read_with(text, names, |value| value.kind != Type::Vector)
    }

    /// Reads a formula as [`Self::read`] does, whose value may also be a vector.
    pub fn read_value(text: &str, names: &Names) -> Result<Self, FormulaError> {
        Self::read_with(text, names, |_| true)
    }

    fn read_with(
        text: &str,
        names: &Names,
        fits: fn(&Typed) -> bool,
    ) -> Result<Self, FormulaError> {
        read(text, names, fits)
            .map(|lines| Self {
                text: text.to_owned(),
                lines,
            })
            .map_err(|(at, message)| FormulaError {
                position: Position::of(text, at),
                message,
            })
    }

    /// Returns the text that it was read from.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Returns its lines, the value last.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// Returns whether a name appears in it whose index among the given names `holds`.
    pub fn names_any(&self, holds: &dyn Fn(usize) -> bool) -> bool {
        self.any_term(&|term| matches!(term, Term::Name(index) if holds(*index)))
    }

    /// Returns whether it has an operation that `holds`.
    pub(crate) fn calls_any(&self, holds: &dyn Fn(&Operator) -> bool) -> bool {
        self.any_term(&|term| matches!(term, Term::Call(operator, _) if holds(operator)))
    }

    fn any_term(&self, holds: &dyn Fn(&Term) -> bool) -> bool {
        fn any(part: &Typed, holds: &dyn Fn(&Term) -> bool) -> bool {
            let within = match &part.term {
                Term::Call(_, parts) => &parts[..],
                _ => &[],
            };
            holds(&part.term) || within.iter().any(|part| any(part, holds))
        }
        self.lines.iter().any(|line| any(&line.value, holds))
    }

    /// Returns the text of one of its parts.
    pub fn text_of(&self, part: &Typed) -> &str {
        with_parentheses(&self.text, part.span.clone())
    }
}

/// Returns a part of a formula with the parentheses at its ends, which the part itself leaves out.
pub(crate) fn with_parentheses(formula: &str, mut span: Range<usize>) -> &str {
    let signs = without_comments(formula);
    let part = signs.get(span.clone()).unwrap_or_default();
    let (mut open, mut closed) = (0, 0);
    for sign in part.chars() {
        match sign {
            '(' => open += 1,
            ')' if open > 0 => open -= 1,
            ')' => closed += 1,
            _ => {}
        }
    }
    for _ in 0..open {
        let rest = signs.get(span.end..).and_then(|rest| rest.find(')'));
        span.end += rest.map_or(0, |more| more + 1);
    }
    for _ in 0..closed {
        let before = signs.get(..span.start).and_then(|text| text.rfind('('));
        span.start = before.unwrap_or(span.start);
    }
    formula.get(span).unwrap_or_default().trim()
}

/// Returns a formula with spaces in place of its comments, byte for byte.
fn without_comments(formula: &str) -> String {
    let mut text = String::with_capacity(formula.len());
    for line in formula.split_inclusive('\n') {
        let begins = |at: &usize| line[*at..].starts_with('#') || line[*at..].starts_with("//");
        let mut places = line.char_indices().map(|(at, _)| at);
        let at = places.find(begins).unwrap_or(line.len());
        text.push_str(&line[..at]);
        text.extend(std::iter::repeat_n(' ', line.len() - at));
    }
    text
}

/// Reads the lines of a formula; `fits` tells whether the value at the end may be of its type.
fn read(text: &str, names: &Names, fits: fn(&Typed) -> bool) -> Result<Vec<Line>, Refusal> {
    let characters = text.chars().count();
    if characters > Formula::MOST_CHARACTERS {
        let most = text.char_indices().nth(Formula::MOST_CHARACTERS);
        let at = most.map_or(0, |(at, _)| at);
        return Err((
            at,
            text!(
                "formula-too-long",
                most = Formula::MOST_CHARACTERS,
                count = characters
            ),
        ));
    }
    let mut checker = Checker::new(text, names);
    let mut at = 0;
    let mut operations = 0;
    loop {
        let name = name_of_line(text, &mut at, &checker)?;
        let joins = |a: &str, b: &str| checker.joins(a, b);
        let mut rest = rest_of(text, at, &joins);
        let read = rest.either(DEPTH);
        let node = read.map_err(|problem| checker.refusal(&problem))?;
        let end = node.span.end;
        operations += node.operations();
        if operations > Formula::MOST_OPERATIONS {
            let most = Formula::MOST_OPERATIONS;
            return Err((node.span.start, text!("formula-operations", most = most)));
        }
        rest.space();
        at = rest.at;
        // A separator, or else what follows was expected to be an operator.
        let ends_line = text[end..at].contains('\n') || rest.sign(&[";"]).is_some();
        let separated = at == text.len() || ends_line;
        at = rest.at;
        let unexpected = rest.unexpected(Expected::Operator);
        let value = checker.check(&node)?;
        match name {
            Some(name) if separated => checker.add(name, value),
            None if separated && only_space(text, at) => {
                if !fits(&value) {
                    let words = text!("formula-result-vector").to_owned();
                    return Err((value.span.start, words));
                }
                return Ok(checker.finish(value));
            }
            None if separated => {
                let at = value.span.start;
                return Err((at, text!("formula-line-without-name").to_owned()));
            }
            _ => return Err(checker.refusal(&unexpected)),
        }
    }
}

fn rest_of<'a>(text: &'a str, at: usize, joins: &'a dyn Fn(&str, &str) -> bool) -> Rest<'a> {
    Rest {
        text,
        at,
        joins,
        comments: true,
    }
}

fn only_space(text: &str, at: usize) -> bool {
    let mut rest = rest_of(text, at, &|_, _| false);
    rest.space();
    rest.left().is_empty()
}

/// Reads `name =` at the beginning of a line; none if the line has no name.
fn name_of_line(
    text: &str,
    at: &mut usize,
    checker: &Checker<'_>,
) -> Result<Option<String>, Refusal> {
    let mut rest = rest_of(text, *at, &|_, _| false);
    rest.space();
    let begins = rest.at;
    if rest.left().is_empty() {
        let message = if checker.is_empty() {
            "formula-empty"
        } else {
            "formula-no-value"
        };
        return Err((begins, text!(message).to_owned()));
    }
    let name = rest.name();
    let named = !name.is_empty() && rest.sign(&["=="]).is_none() && rest.sign(&["="]).is_some();
    if !named {
        *at = begins;
        return Ok(None);
    }
    *at = rest.at;
    if name.starts_with(|c: char| c.is_ascii_digit() || c == '_') || Names::is_reserved(&name) {
        return Err((begins, text!("formula-name-taken", name = name)));
    }
    Ok(Some(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parentheses_in_comments_are_not_those_of_a_part() {
        let formula = "(kd # (Lambert, für ☀\n + Od) * 2 // )";
        let at = |text: &str| formula.find(text).expect("a part of the formula");
        let sum = with_parentheses(formula, at("kd")..at(") * 2"));
        assert_eq!(sum, "kd # (Lambert, für ☀\n + Od");
        let product = with_parentheses(formula, at("kd")..at(" //"));
        assert_eq!(product, &formula[..at(" //")]);
    }
}
