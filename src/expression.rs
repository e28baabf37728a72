//! Arithmetic as typed by people: `1/3`, `2*pi`, `max(cos(x), 0)^n`, and questions about quantities such as
//! `probe.lights[0].phi < 30`. The caller defines the meaning of names.
//!
//! ```text
//!   either   = both { or both }
//!   both     = compared { and compared }
//!   compared = sum [ (< | <= | > | >= | == | !=) sum ]
//!   sum      = product { (+ | −) product }
//!   product  = signed { (* | /) signed }
//!   signed   = { + | − | not } power
//!   power    = value [ ^ signed ]
//!   value    = number | pi | inf | ( either ) | name ( either { , either } ) | quantity
//!   quantity = name { . name | [ number ] | [ "name" ] | [ * ] }
//! ```

use crate::text::{excerpt, text};
use std::cmp::Ordering;

/// Maximum nesting depth of parentheses, signs, powers and calls.
const DEPTH: usize = 64;
/// Longest text, in bytes.
const MOST: usize = 4096;
/// Maximum number of consecutive operations, which are evaluated one inside the other: `1+1+1` has two.
const CHAIN: usize = 256;

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

/// A step from a quantity to a part of it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// `.name`, or the list entry of that name: `["name"]`.
    Name(String),
    /// `[number]`, from 0.
    Index(usize),
    /// `[*]`: the following parts of every entry.
    All,
}

/// Meaning of the names in an expression.
pub trait Quantities {
    /// Returns the value of a quantity, given its name and the path to a part of it.
    ///
    /// # Errors
    /// The reason why there is none, in words.
    fn quantity(&self, name: &str, parts: &[Part]) -> Result<Value, String>;

    /// Calls `todo` with the quantities under other settings.
    ///
    /// # Errors
    /// Invalid settings, or the error of `todo`.
    fn with(&self, settings: &str, todo: Todo<'_>) -> Result<Value, String>;

    /// Calls `todo` with the quantities at another place.
    ///
    /// # Errors
    /// The error of `todo`.
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

#[derive(Clone, Debug, PartialEq)]
enum Node {
    Number(f64),
    Quantity(String, Vec<Part>),
    Call(Function, Vec<Self>),
    With(String, Box<Self>),
    At(Box<[Self; 3]>),
}

impl Node {
    fn size(&self) -> usize {
        let all = |parts: &[Self]| parts.iter().map(Self::size).sum();
        1 + match self {
            Self::Call(_, parts) => all(parts),
            Self::With(_, inner) => inner.size(),
            Self::At(parts) => all(&**parts),
            _ => 0,
        }
    }

    /// Returns the number of operations evaluated one inside the other.
    fn depth(&self) -> usize {
        let deepest = |parts: &[Self]| parts.iter().map(Self::depth).max().unwrap_or(0);
        1 + match self {
            Self::Call(_, parts) => deepest(parts),
            Self::With(_, inner) => inner.depth(),
            Self::At(parts) => deepest(&**parts),
            _ => 0,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Function {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negate,
    Less,
    AtMost,
    Greater,
    AtLeast,
    Equal,
    Differs,
    And,
    Or,
    Not,
    Abs,
    Sqrt,
    Min,
    Max,
    Sum,
    Mean,
    Exp,
    Log,
    Round,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Luminance,
    Dot,
    Length,
}

use Function::*;

/// Functions called by name.
const NAMED: [(&str, Function); 18] = [
    ("abs", Abs),
    ("sqrt", Sqrt),
    ("min", Min),
    ("max", Max),
    ("sum", Sum),
    ("mean", Mean),
    ("exp", Exp),
    ("log", Log),
    ("round", Round),
    ("sin", Sin),
    ("cos", Cos),
    ("tan", Tan),
    ("asin", Asin),
    ("acos", Acos),
    ("atan", Atan),
    ("luminance", Luminance),
    ("dot", Dot),
    ("length", Length),
];

const COMPARISONS: [(&str, Function); 8] = [
    ("<=", AtMost),
    ("≤", AtMost),
    (">=", AtLeast),
    ("≥", AtLeast),
    ("==", Equal),
    ("!=", Differs),
    ("<", Less),
    (">", Greater),
];

impl Expression {
    /// Parses an expression.
    ///
    /// # Errors
    /// A description of the error, with its position in the text.
    pub fn read(text: &str) -> Result<Self, String> {
        if text.len() > MOST {
            return Err(text!("expression-too-long", most = MOST));
        }
        let mut rest = Rest { text, at: 0 };
        let node = rest.either(DEPTH)?;
        rest.space();
        if rest.at < text.len() {
            return Err(rest.unexpected());
        }
        if node.depth() > CHAIN {
            return Err(text!("expression-nested", most = CHAIN));
        }
        Ok(Self(node))
    }

    /// Returns the number of its numbers, quantities and operations.
    pub fn size(&self) -> usize {
        self.0.size()
    }

    /// Evaluates the expression with the meaning of its names.
    ///
    /// # Errors
    /// Unknown quantities, and operations on values for which they are not defined.
    pub fn value(&self, quantities: &dyn Quantities) -> Result<Value, String> {
        value(&self.0, quantities)
    }

    /// Evaluates the expression to a number.
    ///
    /// # Errors
    /// As [`Self::value`], or a value that is not a finite number.
    pub fn number(&self, quantities: &dyn Quantities) -> Result<f64, String> {
        let number = self.value(quantities)?.number()?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(text!("expression-not-finite").to_owned())
        }
    }

    /// Returns whether the expression is true.
    ///
    /// # Errors
    /// As [`Self::value`], or a value that is neither true nor false.
    pub fn holds(&self, quantities: &dyn Quantities) -> Result<bool, String> {
        match self.value(quantities)? {
            Value::Truth(holds) => Ok(holds),
            _ => Err(text!("expression-no-truth").to_owned()),
        }
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

    /// Returns the numbers of a list, or a single number.
    fn numbers(&self) -> Result<Vec<f64>, String> {
        match self {
            Self::List(values) => values.iter().map(Self::number).collect(),
            value => Ok(vec![value.number()?]),
        }
    }
}

fn value(node: &Node, quantities: &dyn Quantities) -> Result<Value, String> {
    match node {
        Node::Number(number) => Ok(Value::Number(*number)),
        Node::Quantity(name, parts) => quantities.quantity(name, parts),
        Node::Call(function, arguments) => {
            let values: Result<Vec<_>, _> = arguments
                .iter()
                .map(|node| value(node, quantities))
                .collect();
            function.apply(&values?)
        }
        Node::With(settings, inner) => quantities.with(settings, &|there| value(inner, there)),
        Node::At(parts) => {
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
        let truth = |index: usize| match &values[index] {
            Value::Truth(holds) => Ok(*holds),
            _ => Err(text!("expression-no-truth").to_owned()),
        };
        let all = || -> Result<Vec<f64>, String> {
            let lists: Result<Vec<_>, _> = values.iter().map(Value::numbers).collect();
            let numbers = lists?.concat();
            if numbers.is_empty() {
                return Err(text!("expression-empty").to_owned());
            }
            Ok(numbers)
        };
        Ok(match self {
            Less => Value::Truth(number(0)? < number(1)?),
            AtMost => Value::Truth(number(0)? <= number(1)?),
            Greater => Value::Truth(number(0)? > number(1)?),
            AtLeast => Value::Truth(number(0)? >= number(1)?),
            // 0 and −0 are equal.
            Equal => Value::Truth(number(0)?.partial_cmp(&number(1)?) == Some(Ordering::Equal)),
            Differs => Value::Truth(number(0)?.partial_cmp(&number(1)?) != Some(Ordering::Equal)),
            And => Value::Truth(truth(0)? && truth(1)?),
            Or => Value::Truth(truth(0)? || truth(1)?),
            Not => Value::Truth(!truth(0)?),
            _ => Value::Number(match self {
                Add => number(0)? + number(1)?,
                Subtract => number(0)? - number(1)?,
                Multiply => number(0)? * number(1)?,
                Divide => number(0)? / number(1)?,
                Power => number(0)?.powf(number(1)?),
                Negate => -number(0)?,
                Abs => number(0)?.abs(),
                Sqrt => number(0)?.sqrt(),
                Exp => number(0)?.exp(),
                Log => number(0)?.ln(),
                Round => number(0)?.round(),
                Sin => number(0)?.to_radians().sin(),
                Cos => number(0)?.to_radians().cos(),
                Tan => number(0)?.to_radians().tan(),
                Asin => number(0)?.asin().to_degrees(),
                Acos => number(0)?.acos().to_degrees(),
                Atan => number(0)?.atan().to_degrees(),
                Min => all()?.into_iter().fold(f64::INFINITY, f64::min),
                Max => all()?.into_iter().fold(f64::NEG_INFINITY, f64::max),
                Sum => all()?.into_iter().sum(),
                Mean => {
                    let numbers = all()?;
                    numbers.iter().sum::<f64>() / numbers.len() as f64
                }
                Luminance => weighted(&values[0].numbers()?, &[0.2126, 0.7152, 0.0722])?,
                Dot => weighted(&values[0].numbers()?, &values[1].numbers()?)?,
                _ => all()?.iter().map(|x| x * x).sum::<f64>().sqrt(),
            }),
        })
    }

    /// Returns the number of its arguments; none if any number is allowed.
    fn arguments(self) -> Option<usize> {
        match self {
            Min | Max | Sum | Mean => None,
            Dot => Some(2),
            _ => Some(1),
        }
    }
}

fn weighted(a: &[f64], b: &[f64]) -> Result<f64, String> {
    if a.len() != b.len() {
        return Err(text!("expression-length", a = a.len(), b = b.len()));
    }
    Ok(a.iter().zip(b).map(|(a, b)| a * b).sum())
}

/// The rest of the text.
struct Rest<'a> {
    text: &'a str,
    at: usize,
}

impl Rest<'_> {
    fn left(&self) -> &str {
        &self.text[self.at..]
    }

    fn space(&mut self) {
        self.at = self.text.len() - self.left().trim_start().len();
    }

    fn unexpected(&self) -> String {
        let place = 1 + self.text[..self.at].chars().count();
        match self.left().chars().next() {
            Some(found) => text!(
                "expression-unexpected",
                found = found.to_string(),
                place = place
            ),
            None => text!("expression-ends").to_owned(),
        }
    }

    /// Takes one of several signs; returns its index among them.
    fn sign(&mut self, signs: &[&str]) -> Option<usize> {
        self.space();
        let place = signs
            .iter()
            .position(|sign| self.left().starts_with(sign))?;
        self.at += signs[place].len();
        Some(place)
    }

    /// Takes a word that stands alone.
    fn word(&mut self, word: &str) -> bool {
        self.space();
        let follows = |rest: &str| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_');
        let found = self.left().strip_prefix(word).is_some_and(follows);
        self.at += if found { word.len() } else { 0 };
        found
    }

    fn expect(&mut self, sign: &str) -> Result<(), String> {
        self.sign(&[sign])
            .map(|_| ())
            .ok_or_else(|| self.unexpected())
    }

    fn either(&mut self, depth: usize) -> Result<Node, String> {
        let mut node = self.both(depth)?;
        while self.word("or") {
            node = Node::Call(Or, vec![node, self.both(depth)?]);
        }
        Ok(node)
    }

    fn both(&mut self, depth: usize) -> Result<Node, String> {
        let mut node = self.compared(depth)?;
        while self.word("and") {
            node = Node::Call(And, vec![node, self.compared(depth)?]);
        }
        Ok(node)
    }

    fn compared(&mut self, depth: usize) -> Result<Node, String> {
        let node = self.sum(depth)?;
        match self.sign(&COMPARISONS.map(|(sign, _)| sign)) {
            Some(place) => Ok(Node::Call(
                COMPARISONS[place].1,
                vec![node, self.sum(depth)?],
            )),
            None => Ok(node),
        }
    }

    fn sum(&mut self, depth: usize) -> Result<Node, String> {
        let mut node = self.product(depth)?;
        while let Some(sign) = self.sign(&["+", "-", "−"]) {
            let function = if sign == 0 { Add } else { Subtract };
            node = Node::Call(function, vec![node, self.product(depth)?]);
        }
        Ok(node)
    }

    fn product(&mut self, depth: usize) -> Result<Node, String> {
        let mut node = self.signed(depth)?;
        while let Some(sign) = self.sign(&["*", "×", "·", "/", "÷"]) {
            let function = if sign < 3 { Multiply } else { Divide };
            node = Node::Call(function, vec![node, self.signed(depth)?]);
        }
        Ok(node)
    }

    fn signed(&mut self, depth: usize) -> Result<Node, String> {
        let depth = deeper(depth)?;
        if self.word("not") {
            return Ok(Node::Call(Not, vec![self.signed(depth)?]));
        }
        match self.sign(&["+", "-", "−"]) {
            Some(0) => self.signed(depth),
            Some(_) => Ok(Node::Call(Negate, vec![self.signed(depth)?])),
            None => self.power(depth),
        }
    }

    fn power(&mut self, depth: usize) -> Result<Node, String> {
        let base = self.operand(depth)?;
        match self.sign(&["^"]) {
            Some(_) => Ok(Node::Call(Power, vec![base, self.signed(depth)?])),
            None => Ok(base),
        }
    }

    fn operand(&mut self, depth: usize) -> Result<Node, String> {
        self.space();
        match self.left().chars().next() {
            Some('(') => {
                self.at += 1;
                let inner = self.either(depth)?;
                self.expect(")")?;
                Ok(inner)
            }
            Some('√') => {
                self.at += '√'.len_utf8();
                self.expect("(")?;
                let inner = self.either(depth)?;
                self.expect(")")?;
                Ok(Node::Call(Sqrt, vec![inner]))
            }
            Some('∞') => {
                self.at += '∞'.len_utf8();
                Ok(Node::Number(f64::INFINITY))
            }
            Some('π') => {
                self.at += 'π'.len_utf8();
                Ok(Node::Number(std::f64::consts::PI))
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_ascii_alphabetic() => self.named(depth),
            _ => Err(self.unexpected()),
        }
    }

    fn name(&mut self) -> String {
        let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let end = self.left().find(|c| !word(c));
        let name = self.left()[..end.unwrap_or(self.left().len())].to_owned();
        self.at += name.len();
        name
    }

    /// Parses a constant, a function or a quantity.
    fn named(&mut self, depth: usize) -> Result<Node, String> {
        let begins = self.at;
        let name = self.name();
        match &*name {
            "pi" => return Ok(Node::Number(std::f64::consts::PI)),
            "inf" | "infinity" => return Ok(Node::Number(f64::INFINITY)),
            "with" => {
                self.expect("(")?;
                let settings = self.quoted()?;
                self.expect(",")?;
                let inner = self.either(depth)?;
                self.expect(")")?;
                return Ok(Node::With(settings, inner.into()));
            }
            _ => {}
        }
        if !self.left().starts_with('(') {
            return Ok(Node::Quantity(name, self.parts()?));
        }
        let mut arguments = Vec::new();
        self.at += 1;
        loop {
            arguments.push(self.either(depth)?);
            if self.sign(&[","]).is_none() {
                break;
            }
        }
        self.expect(")")?;
        let count = arguments.len();
        let wrong = |expected: usize| {
            Err(text!(
                "expression-arguments",
                name = excerpt(&name),
                expected = expected,
                count = count
            ))
        };
        if name == "at" {
            return match <[Node; 3]>::try_from(arguments) {
                Ok(parts) => Ok(Node::At(parts.into())),
                Err(_) => wrong(3),
            };
        }
        let Some((_, function)) = NAMED.into_iter().find(|(known, _)| *known == name) else {
            self.at = begins;
            return Err(text!("expression-unknown", name = excerpt(&name)));
        };
        match function.arguments() {
            Some(expected) if expected != count => wrong(expected),
            _ => Ok(Node::Call(function, arguments)),
        }
    }

    fn quoted(&mut self) -> Result<String, String> {
        let quote = ["\"", "'"];
        let found = self.sign(&quote).ok_or_else(|| self.unexpected())?;
        let Some((inside, _)) = self.left().split_once(quote[found]) else {
            self.at = self.text.len();
            return Err(self.unexpected());
        };
        let inside = inside.to_owned();
        self.at += inside.len() + 1;
        Ok(inside)
    }

    fn parts(&mut self) -> Result<Vec<Part>, String> {
        let mut parts = Vec::new();
        loop {
            if self.left().starts_with('.') {
                self.at += 1;
                let name = self.name();
                if name.is_empty() {
                    return Err(self.unexpected());
                }
                parts.push(name.parse().map_or(Part::Name(name), Part::Index));
            } else if self.left().starts_with('[') {
                self.at += 1;
                self.space();
                parts.push(if self.sign(&["*"]).is_some() {
                    Part::All
                } else if self.left().starts_with(['"', '\'']) {
                    Part::Name(self.quoted()?)
                } else {
                    let index = self.name().parse();
                    Part::Index(index.map_err(|_| self.unexpected())?)
                });
                self.expect("]")?;
            } else {
                return Ok(parts);
            }
        }
    }

    /// Parses digits with at most one point, and an exponent where digits follow the `e`.
    fn number(&mut self) -> Result<Node, String> {
        let left = self.left();
        let digits =
            |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let mut length = digits(left);
        if left[length..].starts_with('.') {
            length += 1 + digits(&left[length + 1..]);
        }
        if let Some(exponent) = left[length..].strip_prefix(['e', 'E']) {
            let sign = usize::from(exponent.starts_with(['+', '-']));
            let count = digits(&exponent[sign..]);
            length += if count > 0 { 1 + sign + count } else { 0 };
        }
        let number = left[..length].parse();
        let number = number.map_err(|_| self.unexpected())?;
        self.at += length;
        Ok(Node::Number(number))
    }
}

fn deeper(depth: usize) -> Result<usize, String> {
    depth
        .checked_sub(1)
        .ok_or_else(|| text!("expression-nested", most = DEPTH))
}
