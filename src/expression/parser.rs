//! The parser of expressions and of formulas, by recursive descent.

use super::functions::{
    ADD, AND, COMPARISONS, CONSTANTS, DIVIDE, DOT, Function, MIDDLE_DOT, MULTIPLY, NAMED, NEGATE,
    NOT, OR, POWER, SQRT, SUBTRACT, in_name,
};
use super::problem::{DEPTH, Expected, Fault, Problem};
use super::syntax::{Form, Node, Part};

/// The unread rest of a text.
pub(super) struct Rest<'a> {
    pub text: &'a str,
    /// The first byte that is not yet read.
    pub at: usize,
    /// Tells whether a middle dot between two names makes them one term, as in `N·L`.
    pub joins: &'a dyn Fn(&str, &str) -> bool,
    /// True if `#` and `//` begin comments up to the end of the line.
    pub comments: bool,
}

type Parsed<T> = Result<T, Problem>;

impl<'a> Rest<'a> {
    pub(super) fn left(&self) -> &'a str {
        &self.text[self.at..]
    }

    /// Skips space, and comments in a formula.
    pub(super) fn space(&mut self) {
        loop {
            self.at = self.text.len() - self.left().trim_start().len();
            if !(self.comments && (self.left().starts_with('#') || self.left().starts_with("//"))) {
                return;
            }
            self.at += self.left().find('\n').unwrap_or(self.left().len());
        }
    }

    pub(super) fn unexpected(&self, expected: Expected) -> Problem {
        Problem::new(self.at, Fault::Unexpected(expected))
    }

    /// Takes one of several signs; returns its index among them.
    pub(super) fn sign(&mut self, signs: &[&str]) -> Option<usize> {
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

    fn expect(&mut self, sign: &'static str) -> Parsed<()> {
        self.sign(&[sign])
            .map(|_| ())
            .ok_or_else(|| self.unexpected(Expected::Sign(sign)))
    }

    fn node(&self, from: usize, form: Form) -> Node {
        // Space behind an operand is read in search of an operator, and ends with the line.
        let end = from + self.text[from..self.at].trim_end().len();
        Node {
            span: from..end,
            form,
        }
    }

    fn call(&self, from: usize, function: Function, arguments: Vec<Node>) -> Node {
        self.node(from, Form::Call(function, arguments))
    }

    /// Parses operands that operators of one rank join, from the left.
    fn joined(
        &mut self,
        depth: usize,
        operand: fn(&mut Self, usize) -> Parsed<Node>,
        operator: impl Fn(&mut Self) -> Option<Function>,
    ) -> Parsed<Node> {
        let mut node = operand(self, depth)?;
        while let Some(function) = operator(self) {
            let (from, right) = (node.span.start, operand(self, depth)?);
            let span = from..right.span.end;
            let form = Form::Call(function, vec![node, right]);
            node = Node { span, form };
        }
        Ok(node)
    }

    pub(super) fn either(&mut self, depth: usize) -> Parsed<Node> {
        self.joined(depth, Self::both, |rest| rest.word("or").then_some(OR))
    }

    fn both(&mut self, depth: usize) -> Parsed<Node> {
        self.joined(depth, Self::compared, |rest| {
            rest.word("and").then_some(AND)
        })
    }

    fn compared(&mut self, depth: usize) -> Parsed<Node> {
        let node = self.sum(depth)?;
        match self.sign(&COMPARISONS.map(|(sign, _)| sign)) {
            Some(place) => {
                let (from, right) = (node.span.start, self.sum(depth)?);
                let span = from..right.span.end;
                let form = Form::Call(COMPARISONS[place].1, vec![node, right]);
                Ok(Node { span, form })
            }
            None => Ok(node),
        }
    }

    fn sum(&mut self, depth: usize) -> Parsed<Node> {
        let signs = [ADD, SUBTRACT, SUBTRACT];
        self.joined(depth, Self::product, |rest| {
            rest.sign(&["+", "-", "−"]).map(|sign| signs[sign])
        })
    }

    fn product(&mut self, depth: usize) -> Parsed<Node> {
        let signs = [
            MULTIPLY, MULTIPLY, MIDDLE_DOT, MIDDLE_DOT, MIDDLE_DOT, DIVIDE, DIVIDE,
        ];
        self.joined(depth, Self::signed, |rest| {
            rest.sign(&["*", "×", "·", "⋅", "•", "/", "÷"])
                .map(|sign| signs[sign])
        })
    }

    fn signed(&mut self, depth: usize) -> Parsed<Node> {
        self.space();
        let from = self.at;
        let depth = depth
            .checked_sub(1)
            .ok_or_else(|| Problem::new(from, Fault::Nested(DEPTH)))?;
        if self.word("not") {
            let inner = self.signed(depth)?;
            return Ok(self.call(from, NOT, vec![inner]));
        }
        match self.sign(&["+", "-", "−"]) {
            Some(0) => self.signed(depth),
            Some(_) => {
                let inner = self.signed(depth)?;
                Ok(self.call(from, NEGATE, vec![inner]))
            }
            None => self.power(depth),
        }
    }

    fn power(&mut self, depth: usize) -> Parsed<Node> {
        let base = self.operand(depth)?;
        let from = base.span.start;
        match self.sign(&["^", "**", "²", "³"]) {
            Some(0..=1) => {
                let exponent = self.signed(depth)?;
                Ok(self.call(from, POWER, vec![base, exponent]))
            }
            Some(sign) => {
                let exponent = self.node(self.at, Form::Number(sign as f64));
                Ok(self.call(from, POWER, vec![base, exponent]))
            }
            None => Ok(base),
        }
    }

    fn operand(&mut self, depth: usize) -> Parsed<Node> {
        self.space();
        let from = self.at;
        match self.sign(&["(", "√", "∞", "π"]) {
            Some(0) => return self.closed(depth),
            Some(1) => {
                self.expect("(")?;
                let inner = self.closed(depth)?;
                return Ok(self.call(from, SQRT, vec![inner]));
            }
            Some(2) => return Ok(self.node(from, Form::Number(f64::INFINITY))),
            Some(_) => return Ok(self.node(from, Form::Number(std::f64::consts::PI))),
            None => {}
        }
        match self.left().chars().next() {
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c != '_' && in_name(c).is_some() => self.named(depth),
            _ => Err(self.unexpected(Expected::Value)),
        }
    }

    /// Parses an expression and the parenthesis that closes it.
    fn closed(&mut self, depth: usize) -> Parsed<Node> {
        let mut inner = self.either(depth)?;
        self.expect(")")?;
        inner.span.end = inner.span.end.max(self.at - 1);
        Ok(inner)
    }

    /// Parses the letters of a name, as [`in_name`] reads them; empty if there is none.
    pub(super) fn name(&mut self) -> String {
        let mut name = String::new();
        while let Some(c) = self.left().chars().next() {
            let Some(read) = in_name(c) else { break };
            name += &read;
            self.at += c.len_utf8();
        }
        name
    }

    /// Parses a middle dot and a second name, where both make one term.
    fn joined_name(&mut self, name: &str) -> Option<String> {
        let from = self.at;
        if self.sign(&["·", "⋅", "•"]).is_some() {
            self.space();
            let other = self.name();
            if !other.is_empty() && !self.left().starts_with('(') && (self.joins)(name, &other) {
                return Some(other);
            }
        }
        self.at = from;
        None
    }

    /// Parses a constant, a function or a quantity.
    fn named(&mut self, depth: usize) -> Parsed<Node> {
        let from = self.at;
        let name = self.name();
        if let Some((_, value)) = CONSTANTS.iter().find(|(constant, _)| *constant == name) {
            return Ok(self.node(from, Form::Number(*value)));
        }
        if name == "with" && self.left().trim_start().starts_with('(') {
            self.expect("(")?;
            let settings = self.quoted()?;
            self.expect(",")?;
            let inner = self.closed(depth)?;
            return Ok(self.node(from, Form::With(settings, inner.into())));
        }
        if !self.left().starts_with('(') {
            let first = self.at;
            if let Some(other) = self.joined_name(&name) {
                let quantity = |span, name| Node {
                    span,
                    form: Form::Quantity(name, vec![]),
                };
                let both = vec![quantity(from..first, name), quantity(first..self.at, other)];
                return Ok(self.call(from, DOT, both));
            }
            let parts = self.parts()?;
            return Ok(self.node(from, Form::Quantity(name, parts)));
        }
        self.at += 1;
        let mut arguments = vec![self.either(depth)?];
        while self.sign(&[","]).is_some() {
            arguments.push(self.either(depth)?);
        }
        if self.sign(&[")"]).is_none() {
            return Err(self.unexpected(Expected::Sign(")")));
        }
        self.called(from, name, arguments)
    }

    /// Returns the call of the function `name` that begins at the byte `from`.
    fn called(&self, from: usize, name: String, arguments: Vec<Node>) -> Parsed<Node> {
        let count = arguments.len();
        let wrong = |name: String, expected: usize| {
            let fault = Fault::Arguments {
                name,
                expected,
                count,
            };
            Err(Problem::new(from, fault))
        };
        if name == "at" {
            return match <[Node; 3]>::try_from(arguments) {
                Ok(parts) => Ok(self.node(from, Form::At(parts.into()))),
                Err(_) => wrong(name, 3),
            };
        }
        let Some(function) = NAMED.into_iter().find(|function| function.0 == name) else {
            return Err(Problem::new(from, Fault::Unknown(name)));
        };
        match function.arguments() {
            Some(expected) if expected != count => wrong(name, expected),
            _ => Ok(self.call(from, function, arguments)),
        }
    }

    fn quoted(&mut self) -> Parsed<String> {
        let quote = ["\"", "'"];
        let found = self
            .sign(&quote)
            .ok_or_else(|| self.unexpected(Expected::Quote))?;
        let Some((inside, _)) = self.left().split_once(quote[found]) else {
            self.at = self.text.len();
            return Err(self.unexpected(Expected::Quote));
        };
        let inside = inside.to_owned();
        self.at += inside.len() + 1;
        Ok(inside)
    }

    fn parts(&mut self) -> Parsed<Vec<Part>> {
        let mut parts = Vec::new();
        loop {
            if self.left().starts_with('.') {
                self.at += 1;
                let name = self.name();
                if name.is_empty() {
                    return Err(self.unexpected(Expected::Name));
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
                    Part::Index(index.map_err(|_| self.unexpected(Expected::Value))?)
                });
                self.expect("]")?;
            } else {
                return Ok(parts);
            }
        }
    }

    /// Parses digits with at most one point, and an exponent where digits follow the `e`.
    fn number(&mut self) -> Parsed<Node> {
        let (from, left) = (self.at, self.left());
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
        let number = left[..length]
            .parse()
            .map_err(|_| self.unexpected(Expected::Value))?;
        self.at += length;
        Ok(self.node(from, Form::Number(number)))
    }
}
