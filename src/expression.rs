//! Arithmetic as typed by people: `1/3`, `2*pi`, `max(cos(x), 0)^n`, and questions about quantities such as
//! `probe.lights[0].phi < 30`. The caller defines the meaning of names.
//!
//! ```text
//!   either   = both { or both }
//!   both     = compared { and compared }
//!   compared = sum [ (< | <= | > | >= | == | !=) sum ]
//!   sum      = product { (+ | −) product }
//!   product  = signed { (* | · | /) signed }
//!   signed   = { + | − | not } power
//!   power    = value [ ^ signed | ² | ³ ]
//!   value    = number | pi | inf | ( either ) | name ( either { , either } ) | quantity
//!   quantity = name { . name | [ number ] | [ "name" ] | [ * ] }
//! ```
//!
//! Formulas ([`Formula`]) are the same with lines and types: of numbers and vectors whose names are given.

mod formula;
mod functions;
mod parser;
mod problem;
mod syntax;

pub use formula::{Formula, Line, Names, Operator, Term, Type, Typed};
pub use problem::{FormulaError, Position};
pub use syntax::Part;

pub(crate) use formula::with_parentheses;
pub(crate) use functions::in_name;

use crate::text::{excerpt, text};
use functions::Function;
use functions::Operation::*;
use glam::DVec3;
use parser::Rest;
use problem::{CHAIN, DEPTH, Expected, Fault, MOST, Problem};
use syntax::{Form, Node};

/// The value of an expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// The result of a comparison.
    Truth(bool),
    /// A list, from `[*]`.
    List(Vec<Self>),
}

/// Meaning of the names in an expression.
pub trait Quantities {
    /// Returns the value of a quantity, given its name and the path to a part of it, or the reason why there is none.
    fn quantity(&self, name: &str, parts: &[Part]) -> Result<Value, String>;

    /// Calls `todo` with the quantities under other settings; an error for invalid settings, or that of `todo`.
    fn with(&self, settings: &str, todo: Todo<'_>) -> Result<Value, String>;

    /// Calls `todo` with the quantities at another place; an error is that of `todo`.
    fn at(&self, x: f64, y: f64, todo: Todo<'_>) -> Result<Value, String>;
}

/// A subexpression to evaluate elsewhere.
pub type Todo<'t> = &'t dyn Fn(&dyn Quantities) -> Result<Value, String>;

/// Numbers alone, without any names.
struct Plain;

impl Quantities for Plain {
    fn quantity(&self, name: &str, _: &[Part]) -> Result<Value, String> {
        Err(text!("expression-unknown", name = excerpt(name)))
    }

    fn with(&self, _: &str, _: Todo<'_>) -> Result<Value, String> {
        self.quantity("with", &[])
    }

    fn at(&self, _: f64, _: f64, _: Todo<'_>) -> Result<Value, String> {
        self.quantity("at", &[])
    }
}

/// A parsed expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression(Node);

impl Expression {
    /// Parses an expression; the error says what is wrong and where.
    pub fn read(text: &str) -> Result<Self, String> {
        parse(text).map_err(|problem| problem.of_expression(text))
    }

    /// Returns the number of its numbers, quantities and operations.
    pub fn size(&self) -> usize {
        self.0.size()
    }

    /// Evaluates the expression with the meaning of its names; an error for unknown quantities, and for operations on
    /// values for which they are not defined.
    pub fn value(&self, quantities: &dyn Quantities) -> Result<Value, String> {
        value(&self.0, quantities)
    }

    /// Evaluates the expression as [`Self::value`], to a number; an error also for one that is not finite.
    pub fn number(&self, quantities: &dyn Quantities) -> Result<f64, String> {
        let number = self.value(quantities)?.number()?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(text!("expression-not-finite").to_owned())
        }
    }

    /// Returns whether the expression is true; an error also for a value that is neither true nor false.
    pub fn holds(&self, quantities: &dyn Quantities) -> Result<bool, String> {
        self.value(quantities)?.truth()
    }
}

/// Evaluates arithmetic; none if the text is not arithmetic, or its value is not a number.
///
/// ```
/// use shading_lab::expression::arithmetic;
///
/// assert_eq!(arithmetic("2*(3 + 4)"), Some(14.0));
/// assert_eq!(arithmetic("2*("), None);
/// ```
pub fn arithmetic(text: &str) -> Option<f64> {
    match Expression::read(text).ok()?.value(&Plain).ok()? {
        Value::Number(number) => Some(number).filter(|number| !number.is_nan()),
        _ => None,
    }
}

impl Value {
    fn number(&self) -> Result<f64, String> {
        match self {
            Self::Number(number) => Ok(*number),
            Self::Truth(holds) => Ok(f64::from(u8::from(*holds))),
            Self::List(_) => Err(text!("expression-list").to_owned()),
        }
    }

    fn truth(&self) -> Result<bool, String> {
        match self {
            Self::Truth(holds) => Ok(*holds),
            _ => Err(text!("expression-no-truth").to_owned()),
        }
    }

    fn of_numbers(numbers: &[f64]) -> Self {
        Self::List(numbers.iter().copied().map(Self::Number).collect())
    }

    /// Returns the numbers of a list, or a single number.
    fn numbers(&self) -> Result<Vec<f64>, String> {
        match self {
            Self::List(values) => values.iter().map(Self::number).collect(),
            value => Ok(vec![value.number()?]),
        }
    }
}

fn parse(text: &str) -> Result<Expression, Problem> {
    if text.len() > MOST {
        return Err(Problem::new(0, Fault::TooLong));
    }
    let mut rest = Rest {
        text,
        at: 0,
        joins: &|_, _| false,
        comments: false,
    };
    let node = rest.either(DEPTH)?;
    rest.space();
    if rest.at < text.len() {
        return Err(rest.unexpected(Expected::Operator));
    }
    if node.depth() > CHAIN {
        return Err(Problem::new(0, Fault::Nested(CHAIN)));
    }
    Ok(Expression(node))
}

fn value(node: &Node, quantities: &dyn Quantities) -> Result<Value, String> {
    match &node.form {
        Form::Number(number) => Ok(Value::Number(*number)),
        Form::Quantity(name, parts) => quantities.quantity(name, parts),
        Form::Call(function, arguments) => {
            let values: Result<Vec<_>, _> = arguments
                .iter()
                .map(|node| value(node, quantities))
                .collect();
            function.apply(&values?)
        }
        Form::With(settings, inner) => quantities.with(settings, &|there| value(inner, there)),
        Form::At(parts) => {
            let [x, y, inner] = &**parts;
            let [x, y] =
                [x, y].map(|node| value(node, quantities).and_then(|value| value.number()));
            quantities.at(x?, y?, &|there| value(inner, there))
        }
    }
}

impl Function {
    /// Applies the function to its arguments, whose number the parser has checked.
    fn apply(self, values: &[Value]) -> Result<Value, String> {
        let number = |index: usize| values[index].number();
        let truth = |index: usize| values[index].truth();
        let value = match self.1 {
            Compare(holds) => return Ok(Value::Truth(holds(number(0)?, number(1)?))),
            And => return Ok(Value::Truth(truth(0)? && truth(1)?)),
            Or => return Ok(Value::Truth(truth(0)? || truth(1)?)),
            Not => return Ok(Value::Truth(!truth(0)?)),
            One(of) => of(number(0)?),
            Two(of) => of(number(0)?, number(1)?),
            Three(of) => of(number(0)?, number(1)?, number(2)?),
            List(of) | All(of) => {
                let lists: Result<Vec<_>, _> = values.iter().map(Value::numbers).collect();
                let numbers = lists?.concat();
                if numbers.is_empty() {
                    return Err(text!("expression-empty").to_owned());
                }
                of(&numbers)
            }
            Luminance => weighted(&values[0].numbers()?, &[0.2126, 0.7152, 0.0722])?,
            Dot => weighted(&values[0].numbers()?, &values[1].numbers()?)?,
            Cross => {
                let [a, b] = [three(&values[0])?, three(&values[1])?];
                return Ok(Value::of_numbers(&a.cross(b).to_array()));
            }
            Normalize => {
                let v = three(&values[0])?.normalize_or_zero();
                return Ok(Value::of_numbers(&v.to_array()));
            }
        };
        Ok(Value::Number(value))
    }
}

/// Returns a list of three numbers as a vector.
fn three(value: &Value) -> Result<DVec3, String> {
    let numbers = value.numbers()?;
    let three = <[f64; 3]>::try_from(numbers.as_slice())
        .map_err(|_| text!("expression-length", a = numbers.len(), b = 3))?;
    Ok(DVec3::from_array(three))
}

fn weighted(a: &[f64], b: &[f64]) -> Result<f64, String> {
    if a.len() != b.len() {
        return Err(text!("expression-length", a = a.len(), b = b.len()));
    }
    Ok(a.iter().zip(b).map(|(a, b)| a * b).sum())
}
