//! The parts of a formula with their types.

use super::operator::Operator;
use std::ops::Range;

/// A problem at a byte of a formula, in words.
pub(super) type Refusal = (usize, String);

/// The type of a value in a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// A number.
    Number,
    /// The result of a comparison, 1 or 0 where a number is expected.
    Truth,
    /// A vector of three numbers.
    Vector,
}

/// A part of a formula with its type.
#[derive(Clone, Debug, PartialEq)]
pub struct Typed {
    /// The type of its value.
    pub kind: Type,
    /// The bytes of the text that it was read from.
    pub span: Range<usize>,
    /// Its value.
    pub term: Term,
}

/// The value of a part of a formula.
#[derive(Clone, Debug, PartialEq)]
pub enum Term {
    /// A number.
    Number(f64),
    /// The name of this index among the [`Names`](super::Names).
    Name(usize),
    /// The value of the line of this index.
    Line(usize),
    /// An operation on other parts.
    Call(Operator, Vec<Typed>),
}

/// A line of a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its name; none for the value at the end.
    pub name: Option<String>,
    /// Its value.
    pub value: Typed,
}
