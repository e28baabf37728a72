//! Names and types in a formula: which name is which, and which operation takes which values.

use super::names::Names;
use super::operator::Operator;
use super::typed::{Line, Refusal, Term, Type, Typed};
use crate::expression::functions::{CONSTANTS, Function};
use crate::expression::problem::Problem;
use crate::expression::syntax::{Form, Node, Part};
use crate::text::{did_you_mean, excerpt, text};

/// The names that are known so far.
pub(super) struct Checker<'a> {
    text: &'a str,
    names: &'a Names,
    lines: Vec<Line>,
}

impl<'a> Checker<'a> {
    pub fn new(text: &'a str, names: &'a Names) -> Self {
        Self {
            text,
            names,
            lines: vec![],
        }
    }

    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Adds a line.
    pub fn add(&mut self, name: String, value: Typed) {
        let name = Some(name);
        self.lines.push(Line { name, value });
    }

    /// Returns the lines with the value at the end.
    pub fn finish(mut self, value: Typed) -> Vec<Line> {
        self.lines.push(Line { name: None, value });
        self.lines
    }

    /// Returns what a parser's problem is, in words.
    pub fn refusal(&self, problem: &Problem) -> Refusal {
        let meant = |name: &str| did_you_mean(name, self.known());
        (problem.at, problem.of_formula(self.text, &meant))
    }

    /// Returns every word that can be written at the place of a name.
    fn known(&self) -> Vec<&str> {
        let mut known: Vec<&str> = vec![];
        known.extend(self.lines.iter().filter_map(|line| line.name.as_deref()));
        known.extend(self.names.iter().map(|(name, _)| name));
        // Pushed, since a list is of one lifetime.
        for word in Names::functions().chain(CONSTANTS.iter().map(|(word, _)| *word)) {
            known.push(word);
        }
        known
    }

    /// Returns the value of a name: the last line that is called so, or a given name.
    fn find(&self, name: &str) -> Option<(Term, Type)> {
        let line = self
            .lines
            .iter()
            .rposition(|line| line.name.as_deref() == Some(name));
        if let Some(line) = line {
            return Some((Term::Line(line), self.lines[line].value.kind));
        }
        let index = self.names.exactly(name)?;
        Some((Term::Name(index), self.names.kind(index)))
    }

    fn vector(&self, name: &str) -> Option<Term> {
        self.find(name)
            .filter(|(_, kind)| *kind == Type::Vector)
            .map(|(term, _)| term)
    }

    /// Returns whether `a·b` is one term: a dot product of vectors, or a name.
    pub fn joins(&self, a: &str, b: &str) -> bool {
        let both = self.vector(a).is_some() && self.vector(b).is_some();
        both || self.names.product(a, b).is_some()
    }

    /// Returns the dot product of two names: of two vectors, or a number that is called so.
    fn product(&self, a: &str, b: &str, node: &Node) -> Option<Typed> {
        let of = |kind, term| Typed {
            kind,
            span: node.span.clone(),
            term,
        };
        if let (Some(first), Some(second)) = (self.vector(a), self.vector(b)) {
            let both = [first, second].map(|term| of(Type::Vector, term));
            return Some(of(Type::Number, Term::Call(Operator::Dot, Vec::from(both))));
        }
        let index = self.names.product(a, b)?;
        Some(of(Type::Number, Term::Name(index)))
    }

    /// Gives a part of the formula its type.
    pub fn check(&self, node: &Node) -> Result<Typed, Refusal> {
        match &node.form {
            Form::Number(number) => Ok(Typed {
                kind: Type::Number,
                span: node.span.clone(),
                term: Term::Number(*number),
            }),
            Form::Quantity(name, parts) => self.quantity(name, parts, node),
            Form::Call(function, arguments) => self.call(*function, arguments, node),
            Form::With(..) => Err(self.unknown("with", node)),
            Form::At(_) => Err(self.unknown("at", node)),
        }
    }

    fn unknown(&self, name: &str, node: &Node) -> Refusal {
        let meant = did_you_mean(name, self.known());
        let at = node.span.start;
        (
            at,
            text!("formula-unknown", name = excerpt(name), meant = meant),
        )
    }

    fn quantity(&self, name: &str, parts: &[Part], node: &Node) -> Result<Typed, Refusal> {
        let of = |(term, kind)| Typed {
            kind,
            span: node.span.clone(),
            term,
        };
        match parts {
            [] => {
                let pair = || {
                    let (a, b) = name.split_at_checked(1)?;
                    self.product(a, b, node)
                };
                let loosely = || {
                    let index = self.names.loosely(name)?;
                    Some(of((Term::Name(index), self.names.kind(index))))
                };
                let found = self.find(name).map(of).or_else(pair).or_else(loosely);
                found.ok_or_else(|| self.unknown(name, node))
            }
            [Part::Name(part)] => {
                let component = ["x", "y", "z"].iter().position(|axis| axis == part);
                if let (Some(vector), Some(axis)) = (self.vector(name), component) {
                    let inner = vec![of((vector, Type::Vector))];
                    let term = Term::Call(Operator::Component(axis), inner);
                    return Ok(of((term, Type::Number)));
                }
                let product = self.product(name, part, node);
                product.ok_or_else(|| self.unknown(&format!("{name}.{part}"), node))
            }
            _ => Err(self.unknown(&format!("{name}[…]"), node)),
        }
    }

    fn call(&self, function: Function, arguments: &[Node], node: &Node) -> Result<Typed, Refusal> {
        let operator = Operator::of(function).ok_or_else(|| self.unknown(function.0, node))?;
        let name = |node: &Node| match &node.form {
            Form::Quantity(name, parts) if parts.is_empty() => Some(name.clone()),
            _ => None,
        };
        if let (Operator::Dot, [a, b]) = (operator, arguments)
            && let (Some(a), Some(b)) = (name(a), name(b))
            && let Some(product) = self.product(&a, &b, node)
        {
            return Ok(product);
        }
        let parts: Result<Vec<_>, _> = arguments.iter().map(|part| self.check(part)).collect();
        let parts = parts?;
        let dotted = function.0 == "·" && parts.iter().all(|part| part.kind == Type::Vector);
        let operator = if dotted { Operator::Dot } else { operator };
        let kind = self.kind(operator, &parts, node)?;
        Ok(Typed {
            kind,
            span: node.span.clone(),
            term: Term::Call(operator, parts),
        })
    }

    /// Returns the type of an operation's result.
    fn kind(&self, operator: Operator, parts: &[Typed], node: &Node) -> Result<Type, Refusal> {
        use Operator as Op;
        let is_vector = |part: &Typed| part.kind == Type::Vector;
        let type_if = |vector: bool| if vector { Type::Vector } else { Type::Number };
        match operator {
            Op::Add | Op::Subtract | Op::Mix => {
                let vectors = parts[..2].iter().filter(|part| is_vector(part)).count();
                if vectors == 1 {
                    return Err((node.span.start, self.words("formula-mixed", node)));
                }
                self.numbers(&parts[2..], node)?;
                Ok(type_if(vectors == 2))
            }
            Op::Negate => Ok(type_if(is_vector(&parts[0]))),
            Op::Multiply => match parts.iter().filter(|part| is_vector(part)).count() {
                0 => Ok(Type::Number),
                1 => Ok(Type::Vector),
                _ => Err((node.span.start, self.words("formula-two-vectors", node))),
            },
            Op::Divide => {
                self.numbers(&parts[1..], node)?;
                Ok(type_if(is_vector(&parts[0])))
            }
            Op::Dot | Op::Length | Op::Component(_) => {
                self.vectors(parts, node).map(|()| Type::Number)
            }
            Op::Cross | Op::Normalize => self.vectors(parts, node).map(|()| Type::Vector),
            Op::And | Op::Or | Op::Not => {
                match parts.iter().find(|part| part.kind != Type::Truth) {
                    Some(part) => Err((part.span.start, self.words("formula-no-truth", node))),
                    None => Ok(Type::Truth),
                }
            }
            Op::Less
            | Op::LessEqual
            | Op::Greater
            | Op::GreaterEqual
            | Op::Equal
            | Op::NotEqual => self.numbers(parts, node).map(|()| Type::Truth),
            _ => self.numbers(parts, node).map(|()| Type::Number),
        }
    }

    /// Checks that no value is a vector.
    fn numbers(&self, parts: &[Typed], node: &Node) -> Result<(), Refusal> {
        let Some(vector) = parts.iter().find(|part| part.kind == Type::Vector) else {
            return Ok(());
        };
        let name = &self.text[vector.span.clone()];
        let meant = ["N·L", "R·V", "N·H", "N·V"]
            .into_iter()
            .filter(|product| {
                let mut ends = product.split('·');
                let (a, b) = (ends.next().unwrap_or(""), ends.next().unwrap_or(""));
                (a == name || b == name) && self.joins(a, b)
            })
            .map(|product| text!("document-did-you-mean", name = product))
            .next()
            .unwrap_or_default();
        let message = text!(
            "formula-vector-for-number",
            part = excerpt(&self.text[node.span.clone()]),
            meant = meant
        );
        Err((vector.span.start, message))
    }

    /// Checks that every value is a vector.
    fn vectors(&self, parts: &[Typed], node: &Node) -> Result<(), Refusal> {
        match parts.iter().find(|part| part.kind != Type::Vector) {
            Some(part) => Err((
                part.span.start,
                self.words("formula-number-for-vector", node),
            )),
            None => Ok(()),
        }
    }

    /// Returns a message about a part of the formula.
    fn words(&self, message: &'static str, node: &Node) -> String {
        text!(message, part = excerpt(&self.text[node.span.clone()]))
    }
}
