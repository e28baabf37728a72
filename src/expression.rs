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

#[derive(Clone, Debug, PartialEq)]
enum Node {
    Number(f64),
    Quantity(String, Vec<Part>),
    Call(Function, Vec<Self>),
    With(String, Box<Self>),
    At(Box<[Self; 3]>),
}

impl Node {
    fn parts(&self) -> &[Self] {
        match self {
            Self::Call(_, parts) => parts,
            Self::With(_, inner) => std::slice::from_ref(inner),
            Self::At(parts) => &**parts,
            Self::Number(_) | Self::Quantity(..) => &[],
        }
    }

    fn size(&self) -> usize {
        1 + self.parts().iter().map(Self::size).sum::<usize>()
    }

    /// Returns the number of operations evaluated one inside the other.
    fn depth(&self) -> usize {
        1 + self.parts().iter().map(Self::depth).max().unwrap_or(0)
    }
}

/// A function or an operator with its name, which no other has.
#[derive(Clone, Copy, Debug)]
struct Function(&'static str, Operation);

impl PartialEq for Function {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

#[derive(Clone, Copy, Debug)]
enum Operation {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
    Compare(fn(f64, f64) -> bool),
    And,
    Or,
    Not,
    /// Of the numbers of a list, at least one.
    List(fn(&[f64]) -> f64),
    /// Of the numbers of any arguments, at least one.
    All(fn(&[f64]) -> f64),
    Luminance,
    Dot,
}

use Operation::*;

const ADD: Function = Function("+", Two(|a, b| a + b));
const SUBTRACT: Function = Function("-", Two(|a, b| a - b));
const MULTIPLY: Function = Function("*", Two(|a, b| a * b));
const DIVIDE: Function = Function("/", Two(|a, b| a / b));
const POWER: Function = Function("^", Two(f64::powf));
const NEGATE: Function = Function("negate", One(|x| -x));
const SQRT: Function = Function("sqrt", One(f64::sqrt));
const AND: Function = Function("and", And);
const OR: Function = Function("or", Or);
const NOT: Function = Function("not", Not);

/// Functions called by name.
const NAMED: [Function; 18] = [
    SQRT,
    Function("abs", One(f64::abs)),
    Function(
        "min",
        All(|all| all.iter().copied().fold(f64::INFINITY, f64::min)),
    ),
    Function(
        "max",
        All(|all| all.iter().copied().fold(f64::NEG_INFINITY, f64::max)),
    ),
    Function("sum", All(|all| all.iter().sum())),
    Function(
        "mean",
        All(|all| all.iter().sum::<f64>() / all.len() as f64),
    ),
    Function("exp", One(f64::exp)),
    Function("log", One(f64::ln)),
    Function("round", One(f64::round)),
    Function("sin", One(|x| x.to_radians().sin())),
    Function("cos", One(|x| x.to_radians().cos())),
    Function("tan", One(|x| x.to_radians().tan())),
    Function("asin", One(|x| x.asin().to_degrees())),
    Function("acos", One(|x| x.acos().to_degrees())),
    Function("atan", One(|x| x.atan().to_degrees())),
    Function("luminance", Luminance),
    Function("dot", Dot),
    Function(
        "length",
        List(|all| all.iter().map(|x| x * x).sum::<f64>().sqrt()),
    ),
];

/// Comparisons by their signs; 0 and −0 are equal.
const COMPARISONS: [(&str, Function); 8] = [
    ("<=", Function("<=", Compare(|a, b| a <= b))),
    ("≤", Function("<=", Compare(|a, b| a <= b))),
    (">=", Function(">=", Compare(|a, b| a >= b))),
    ("≥", Function(">=", Compare(|a, b| a >= b))),
    ("==", Function("==", Compare(|a, b| a == b))),
    ("!=", Function("!=", Compare(|a, b| a != b))),
    ("<", Function("<", Compare(|a, b| a < b))),
    (">", Function(">", Compare(|a, b| a > b))),
];

impl Expression {
    /// Parses an expression; the error says what is wrong and where.
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
        let truth = |index: usize| values[index].truth();
        let value = match self.1 {
            Compare(holds) => return Ok(Value::Truth(holds(number(0)?, number(1)?))),
            And => return Ok(Value::Truth(truth(0)? && truth(1)?)),
            Or => return Ok(Value::Truth(truth(0)? || truth(1)?)),
            Not => return Ok(Value::Truth(!truth(0)?)),
            One(of) => of(number(0)?),
            Two(of) => of(number(0)?, number(1)?),
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
        };
        Ok(Value::Number(value))
    }

    /// Returns the number of its arguments where it is called by name; none if any number is allowed.
    fn arguments(self) -> Option<usize> {
        match self.1 {
            All(_) => None,
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

    /// Parses operands that operators of one rank join, from the left.
    fn joined(
        &mut self,
        depth: usize,
        operand: fn(&mut Self, usize) -> Result<Node, String>,
        operator: impl Fn(&mut Self) -> Option<Function>,
    ) -> Result<Node, String> {
        let mut node = operand(self, depth)?;
        while let Some(function) = operator(self) {
            node = Node::Call(function, vec![node, operand(self, depth)?]);
        }
        Ok(node)
    }

    fn either(&mut self, depth: usize) -> Result<Node, String> {
        self.joined(depth, Self::both, |rest| rest.word("or").then_some(OR))
    }

    fn both(&mut self, depth: usize) -> Result<Node, String> {
        self.joined(depth, Self::compared, |rest| {
            rest.word("and").then_some(AND)
        })
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
        let signs = [ADD, SUBTRACT, SUBTRACT];
        self.joined(depth, Self::product, |rest| {
            rest.sign(&["+", "-", "−"]).map(|sign| signs[sign])
        })
    }

    fn product(&mut self, depth: usize) -> Result<Node, String> {
        let signs = [MULTIPLY, MULTIPLY, MULTIPLY, DIVIDE, DIVIDE];
        self.joined(depth, Self::signed, |rest| {
            rest.sign(&["*", "×", "·", "/", "÷"])
                .map(|sign| signs[sign])
        })
    }

    fn signed(&mut self, depth: usize) -> Result<Node, String> {
        let depth = depth
            .checked_sub(1)
            .ok_or_else(|| text!("expression-nested", most = DEPTH))?;
        if self.word("not") {
            return Ok(Node::Call(NOT, vec![self.signed(depth)?]));
        }
        match self.sign(&["+", "-", "−"]) {
            Some(0) => self.signed(depth),
            Some(_) => Ok(Node::Call(NEGATE, vec![self.signed(depth)?])),
            None => self.power(depth),
        }
    }

    fn power(&mut self, depth: usize) -> Result<Node, String> {
        let base = self.operand(depth)?;
        match self.sign(&["^"]) {
            Some(_) => Ok(Node::Call(POWER, vec![base, self.signed(depth)?])),
            None => Ok(base),
        }
    }

    fn operand(&mut self, depth: usize) -> Result<Node, String> {
        match self.sign(&["(", "√", "∞", "π"]) {
            Some(0) => return self.closed(depth),
            Some(1) => {
                self.expect("(")?;
                return Ok(Node::Call(SQRT, vec![self.closed(depth)?]));
            }
            Some(2) => return Ok(Node::Number(f64::INFINITY)),
            Some(_) => return Ok(Node::Number(std::f64::consts::PI)),
            None => {}
        }
        match self.left().chars().next() {
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_ascii_alphabetic() => self.named(depth),
            _ => Err(self.unexpected()),
        }
    }

    /// Parses an expression and the parenthesis that closes it.
    fn closed(&mut self, depth: usize) -> Result<Node, String> {
        let inner = self.either(depth)?;
        self.expect(")")?;
        Ok(inner)
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
                return Ok(Node::With(settings, self.closed(depth)?.into()));
            }
            _ => {}
        }
        if !self.left().starts_with('(') {
            return Ok(Node::Quantity(name, self.parts()?));
        }
        self.at += 1;
        let mut arguments = vec![self.either(depth)?];
        while self.sign(&[","]).is_some() {
            arguments.push(self.either(depth)?);
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
        let Some(function) = NAMED.into_iter().find(|function| function.0 == name) else {
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
        let number = left[..length].parse().map_err(|_| self.unexpected())?;
        self.at += length;
        Ok(Node::Number(number))
    }
}
