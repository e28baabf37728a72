//! A typed formula becomes scalar operations.

use super::builder::{Builder, Value};
use super::code::Code;
use crate::expression::{Formula, Operator, Term, Typed};
use std::f64::consts::{LN_2, LOG2_E};

/// A number, or a vector's components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lowered {
    Number(Value),
    Vector([Value; 3]),
}

/// The values of a formula's names, made when they are first needed.
pub trait Inputs {
    /// Returns the value of the name of this index.
    fn name(&mut self, builder: &mut Builder, index: usize) -> Lowered;

    /// Returns the dot product of two names, where there is a shorter way than by their components.
    fn dot(&mut self, _: &mut Builder, _a: usize, _b: usize) -> Option<Value> {
        None
    }
}

/// Returns the values of a formula's lines, the last line's at the end.
pub fn lower(builder: &mut Builder, formula: &Formula, inputs: &mut dyn Inputs) -> Vec<Lowered> {
    let mut lower = Lower {
        builder,
        inputs,
        lines: vec![],
    };
    for line in formula.lines() {
        let value = lower.value(&line.value);
        lower.lines.push(value);
    }
    lower.lines
}

/// Returns the sum of the products of the components.
pub fn dot(builder: &mut Builder, a: [Value; 3], b: [Value; 3]) -> Value {
    let mut sum = builder.multiply(a[2], b[2]);
    for axis in [1, 0] {
        sum = builder.multiply_add(a[axis], b[axis], sum);
    }
    sum
}

/// Returns the unit vector; zero stays zero.
pub fn normalize(builder: &mut Builder, v: [Value; 3]) -> [Value; 3] {
    let square = dot(builder, v, v);
    let inverse = builder.function(Code::InverseSqrt, square);
    v.map(|part| builder.multiply(part, inverse))
}

struct Lower<'a> {
    builder: &'a mut Builder,
    inputs: &'a mut dyn Inputs,
    lines: Vec<Lowered>,
}

impl Lower<'_> {
    fn value(&mut self, part: &Typed) -> Lowered {
        match &part.term {
            Term::Number(number) => Lowered::Number(Value::literal(*number)),
            Term::Line(line) => self.lines[*line],
            Term::Name(index) => {
                let before = self.builder.enter(&part.span);
                let value = self.inputs.name(self.builder, *index);
                self.builder.leave(before);
                value
            }
            Term::Call(operator, parts) => {
                if let (Operator::Dot, [a, b]) = (operator, &**parts)
                    && let (Term::Name(a), Term::Name(b)) = (&a.term, &b.term)
                {
                    let before = self.builder.enter(&part.span);
                    let short = self.inputs.dot(self.builder, *a, *b);
                    self.builder.leave(before);
                    if let Some(value) = short {
                        return Lowered::Number(value);
                    }
                }
                let values: Vec<Lowered> = parts.iter().map(|part| self.value(part)).collect();
                let before = self.builder.enter(&part.span);
                let value = self.call(*operator, &values);
                self.builder.leave(before);
                value
            }
        }
    }

    fn call(&mut self, operator: Operator, values: &[Lowered]) -> Lowered {
        let vectors: Vec<[Value; 3]> = values.iter().filter_map(Lowered::vector).collect();
        let numbers: Vec<Value> = values.iter().filter_map(Lowered::number).collect();
        let build = &mut *self.builder;
        match (operator, &*vectors, &*numbers) {
            (Operator::Add, [a, b], _) => by_axis(|k| build.add(a[k], b[k])),
            (Operator::Subtract, [a, b], _) => by_axis(|k| build.subtract(a[k], b[k])),
            (Operator::Negate, [a], _) => by_axis(|k| build.negate(a[k])),
            (Operator::Multiply, [a], [factor]) => by_axis(|k| build.multiply(a[k], *factor)),
            (Operator::Divide, [a], [divisor]) => {
                let inverse = build.divide(Value::ONE, *divisor);
                by_axis(|k| build.multiply(a[k], inverse))
            }
            (Operator::Mix, [a, b], [t]) => by_axis(|k| {
                let way = build.subtract(b[k], a[k]);
                build.multiply_add(*t, way, a[k])
            }),
            (Operator::Dot, [a, b], _) => Lowered::Number(dot(build, *a, *b)),
            (Operator::Length, [a], _) => {
                let square = dot(build, *a, *a);
                Lowered::Number(build.function(Code::Sqrt, square))
            }
            (Operator::Normalize, [a], _) => Lowered::Vector(normalize(build, *a)),
            (Operator::Component(axis), [a], _) => Lowered::Number(a[axis]),
            (Operator::Cross, [a, b], _) => by_axis(|k| {
                let (next, last) = ((k + 1) % 3, (k + 2) % 3);
                let other = build.multiply(a[last], b[next]);
                let product = build.multiply(a[next], b[last]);
                build.subtract(product, other)
            }),
            _ => Lowered::Number(number_of(build, operator, &numbers)),
        }
    }
}

impl Lowered {
    pub fn number(&self) -> Option<Value> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Vector(_) => None,
        }
    }

    pub fn vector(&self) -> Option<[Value; 3]> {
        match self {
            Self::Vector(value) => Some(*value),
            Self::Number(_) => None,
        }
    }
}

fn by_axis(mut of: impl FnMut(usize) -> Value) -> Lowered {
    Lowered::Vector([of(0), of(1), of(2)])
}

/// Returns the result of an operation on numbers, of which the types guarantee as many as it has.
fn number_of(build: &mut Builder, operator: Operator, numbers: &[Value]) -> Value {
    let at = |index: usize| numbers.get(index).copied().unwrap_or(Value::ZERO);
    let [a, b, c] = [at(0), at(1), at(2)];
    let literal = Value::literal;
    match operator {
        Operator::Negate => build.negate(a),
        Operator::Add => build.add(a, b),
        Operator::Subtract => build.subtract(a, b),
        Operator::Multiply | Operator::And => build.multiply(a, b),
        Operator::Divide => build.divide(a, b),
        Operator::Power => build.power(a, b),
        Operator::Min => reduce(numbers, |x, y| build.min(x, y)),
        Operator::Max => reduce(numbers, |x, y| build.max(x, y)),
        Operator::Or => build.max(a, b),
        Operator::Not => build.complement(a),
        Operator::Sum => reduce(numbers, |x, y| build.add(x, y)),
        Operator::Mean => {
            let sum = reduce(numbers, |x, y| build.add(x, y));
            build.divide(sum, literal(numbers.len() as f64))
        }
        Operator::Abs => build.function(Code::Abs, a),
        Operator::Sqrt => build.function(Code::Sqrt, a),
        Operator::Exp => {
            let power = build.multiply(literal(LOG2_E), a);
            build.function(Code::Exp2, power)
        }
        Operator::Log => {
            let log = build.function(Code::Log2, a);
            build.multiply(literal(LN_2), log)
        }
        Operator::Floor => build.function(Code::Floor, a),
        Operator::Round => {
            let raised = build.add(a, literal(0.5));
            build.function(Code::Floor, raised)
        }
        Operator::Sin => build.function(Code::Sin, a),
        Operator::Cos => build.function(Code::Cos, a),
        Operator::Tan => {
            let (sine, cosine) = (build.function(Code::Sin, a), build.function(Code::Cos, a));
            build.divide(sine, cosine)
        }
        Operator::Asin => build.function(Code::Asin, a),
        Operator::Acos => build.function(Code::Acos, a),
        Operator::Atan => build.function(Code::Atan, a),
        Operator::Clamp => {
            let raised = build.max(a, b);
            build.min(raised, c)
        }
        Operator::Mix => {
            let way = build.subtract(b, a);
            build.multiply_add(c, way, a)
        }
        Operator::Step => {
            let below = build.greater(a, b);
            build.complement(below)
        }
        Operator::Smoothstep => smoothstep(build, [a, b], c),
        Operator::Less => build.greater(b, a),
        Operator::Greater => build.greater(a, b),
        Operator::LessEqual => {
            let greater = build.greater(a, b);
            build.complement(greater)
        }
        Operator::GreaterEqual => {
            let less = build.greater(b, a);
            build.complement(less)
        }
        Operator::Equal => {
            let differ = differ(build, a, b);
            build.complement(differ)
        }
        Operator::NotEqual => differ(build, a, b),
        // Of vectors, and done above.
        _ => Value::ZERO,
    }
}

fn reduce(numbers: &[Value], of: impl FnMut(Value, Value) -> Value) -> Value {
    numbers.iter().copied().reduce(of).unwrap_or(Value::ZERO)
}

/// Returns 1 where a ≠ b, otherwise 0.
fn differ(build: &mut Builder, a: Value, b: Value) -> Value {
    let (more, less) = (build.greater(a, b), build.greater(b, a));
    build.add(more, less)
}

/// Returns Hermite's cubic between two edges: 0 below the first, 1 above the second.
fn smoothstep(build: &mut Builder, [low, high]: [Value; 2], x: Value) -> Value {
    let (way, length) = (build.subtract(x, low), build.subtract(high, low));
    let t = build.divide(way, length);
    let t = build.max(t, Value::ZERO);
    let t = build.min(t, Value::ONE);
    let square = build.multiply(t, t);
    let twice = build.multiply(Value::literal(2.0), t);
    let rest = build.subtract(Value::literal(3.0), twice);
    build.multiply(square, rest)
}
