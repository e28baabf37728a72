//! The list of scalar operations of a formula, while it is made.

use super::code::Code;
use super::rate::Rate;
use std::collections::HashMap;
use std::ops::Range;

/// A scalar value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number that is known before a point is looked at, and how often it may change.
    Known(f64, Rate),
    /// The input or the operation of this index.
    Varying(u32),
}

/// A scalar operation, or an input: one without operands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operation {
    pub code: Option<Code>,
    pub operands: [Value; 3],
    pub rate: Rate,
    /// The part of the formula that it was made for first.
    pub origin: u32,
    pub sign: Sign,
}

/// The known bounds of a result's sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Any,
    NotNegative,
    NotPositive,
}

/// An operation that was done while the list was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Done {
    pub code: Code,
    pub rate: Rate,
    pub origin: u32,
}

type Key = (Code, [u64; 3]);

/// The list so far.
#[derive(Debug, Default)]
pub struct Builder {
    pub operations: Vec<Operation>,
    pub done: Vec<Done>,
    /// The spans of the parts of the formula that operations are made for.
    pub origins: Vec<Range<usize>>,
    /// The parts in which an operation was left out because it would change nothing.
    pub cut: Vec<u32>,
    /// The products of two unit vectors, which all have an angle.
    pub cosines: Vec<Value>,
    origin: u32,
    known: HashMap<Key, Value>,
}

impl Value {
    pub const ZERO: Self = Self::Known(0.0, Rate::Never);
    pub const ONE: Self = Self::Known(1.0, Rate::Never);

    pub fn literal(number: f64) -> Self {
        Self::Known(number, Rate::Never)
    }

    /// Returns the number, if it is known.
    pub fn known(self) -> Option<f64> {
        match self {
            Self::Known(number, _) => Some(number),
            Self::Varying(_) => None,
        }
    }

    fn is(self, number: f64) -> bool {
        self.known() == Some(number)
    }

    fn bits(self) -> u64 {
        match self {
            Self::Known(number, _) => number.to_bits(),
            // Bits of a NaN, which no number that is known has.
            Self::Varying(index) => 0xfff8_dead_0000_0000 | u64::from(index),
        }
    }
}

impl Builder {
    /// Notes that the following operations belong to a part of the formula; returns what they belonged to before.
    pub fn enter(&mut self, span: &Range<usize>) -> u32 {
        let before = self.origin;
        let place = self.origins.iter().position(|own| own == span);
        self.origin = place.unwrap_or_else(|| {
            self.origins.push(span.clone());
            self.origins.len() - 1
        }) as u32;
        before
    }

    /// Continues with the part that [`Self::enter`] has left.
    pub fn leave(&mut self, before: u32) {
        self.origin = before;
    }

    /// Notes that an operation changes nothing; returns its result.
    fn without_effect(&mut self, result: Value) -> Value {
        if !self.cut.contains(&self.origin) {
            self.cut.push(self.origin);
        }
        result
    }

    /// Adds an input.
    pub fn input(&mut self, rate: Rate) -> Value {
        self.input_of_sign(rate, Sign::Any)
    }

    /// Adds an input of which the sign is known.
    pub fn input_of_sign(&mut self, rate: Rate, sign: Sign) -> Value {
        self.push(Operation {
            code: None,
            operands: [Value::ZERO; 3],
            rate,
            origin: self.origin,
            sign,
        })
    }

    fn push(&mut self, operation: Operation) -> Value {
        self.operations.push(operation);
        Value::Varying(self.operations.len() as u32 - 1)
    }

    /// Returns how often a value changes.
    pub fn rate(&self, value: Value) -> Rate {
        match value {
            Value::Known(_, rate) => rate,
            Value::Varying(index) => self.operations[index as usize].rate,
        }
    }

    /// Returns the operation that gives a value.
    fn operation(&self, value: Value) -> Option<&Operation> {
        match value {
            Value::Known(..) => None,
            Value::Varying(index) => self.operations.get(index as usize),
        }
    }

    /// Returns the result of an operation: a number, a value that is there, or a new operation.
    pub fn apply(&mut self, code: Code, operands: [Value; 3]) -> Value {
        let used = code.operands();
        let rate = operands[..used]
            .iter()
            .map(|value| self.rate(*value))
            .fold(Rate::Never, Rate::join);
        let numbers: Vec<f64> = operands[..used].iter().filter_map(|v| v.known()).collect();
        if numbers.len() == used {
            return self.fold(code, &numbers, rate);
        }
        let mut operands = operands;
        let commutes = matches!(code, Code::Add | Code::Multiply | Code::Min | Code::Max);
        if commutes && operands[0].bits() > operands[1].bits() {
            operands.swap(0, 1);
        }
        let mut key = (code, operands.map(Value::bits));
        key.1[used..].fill(0);
        if let Some(value) = self.known.get(&key) {
            return *value;
        }
        let value = self.push(Operation {
            code: Some(code),
            operands,
            rate,
            origin: self.origin,
            sign: self.sign_of_result(code, operands),
        });
        self.known.insert(key, value);
        value
    }

    /// Does an operation on numbers at once.
    fn fold(&mut self, code: Code, numbers: &[f64], rate: Rate) -> Value {
        let at = |index: usize| numbers.get(index).copied().unwrap_or(0.0);
        let key = (code, std::array::from_fn(|index| at(index).to_bits()));
        let result = code.apply(at(0), at(1), at(2));
        let result = if result.is_nan() { 0.0 } else { result };
        let known = Value::Known(result, rate);
        if self.known.insert(key, known).is_none() && rate != Rate::Never {
            let origin = self.origin;
            self.done.push(Done { code, rate, origin });
        }
        known
    }

    fn one(&mut self, code: Code, a: Value) -> Value {
        self.apply(code, [a, Value::ZERO, Value::ZERO])
    }

    fn two(&mut self, code: Code, a: Value, b: Value) -> Value {
        self.apply(code, [a, b, Value::ZERO])
    }

    /// Returns `−a`.
    pub fn negate(&mut self, a: Value) -> Value {
        match self.operation(a) {
            Some(Operation {
                code: Some(Code::Negate),
                operands,
                ..
            }) => operands[0],
            _ => self.one(Code::Negate, a),
        }
    }

    /// Returns the factors of a product that varies.
    fn factors(&self, value: Value) -> Option<[Value; 2]> {
        match self.operation(value) {
            Some(Operation {
                code: Some(Code::Multiply),
                operands: [a, b, _],
                ..
            }) => Some([*a, *b]),
            _ => None,
        }
    }

    /// Returns `a + b`, with a product multiplied and added at once.
    pub fn add(&mut self, a: Value, b: Value) -> Value {
        if a.is(0.0) {
            return self.without_effect(b);
        }
        if b.is(0.0) {
            return self.without_effect(a);
        }
        if let Some([p, q]) = self.factors(a) {
            return self.apply(Code::MultiplyAdd, [p, q, b]);
        }
        if let Some([p, q]) = self.factors(b) {
            return self.apply(Code::MultiplyAdd, [p, q, a]);
        }
        self.two(Code::Add, a, b)
    }

    /// Returns `a − b`, with a product multiplied and subtracted at once.
    pub fn subtract(&mut self, a: Value, b: Value) -> Value {
        if b.is(0.0) {
            return a;
        }
        // Of a product, multiplying and subtracting at once would leave the product's rounding error.
        if a == b {
            return self.without_effect(Value::ZERO);
        }
        if a.is(0.0) {
            return self.negate(b);
        }
        if let Some([p, q]) = self.factors(a) {
            return self.apply(Code::MultiplySubtract, [p, q, b]);
        }
        if let Some([p, q]) = self.factors(b) {
            return self.apply(Code::SubtractProduct, [p, q, a]);
        }
        self.two(Code::Subtract, a, b)
    }

    /// Returns `a·b`. Numbers of the frame that multiply one after the other are multiplied first.
    pub fn multiply(&mut self, a: Value, b: Value) -> Value {
        if a.is(0.0) || b.is(0.0) {
            return self.without_effect(Value::ZERO);
        }
        if a.is(1.0) {
            return self.without_effect(b);
        }
        if b.is(1.0) {
            return self.without_effect(a);
        }
        if let (Some(_), Some([p, q])) = (a.known(), self.factors(b))
            && let Some((known, other)) = known_first(p, q)
        {
            let both = self.multiply(a, known);
            return self.multiply(both, other);
        }
        if b.known().is_some() && a.known().is_none() {
            return self.multiply(b, a);
        }
        self.two(Code::Multiply, a, b)
    }

    /// Returns `a·b + c`.
    pub fn multiply_add(&mut self, a: Value, b: Value, c: Value) -> Value {
        let product = self.multiply(a, b);
        self.add(product, c)
    }

    /// Returns `a/b`; a division by a number is a multiplication where that is exact.
    pub fn divide(&mut self, a: Value, b: Value) -> Value {
        if a.is(0.0) {
            return self.without_effect(Value::ZERO);
        }
        if b.is(1.0) {
            return self.without_effect(a);
        }
        match b {
            Value::Known(number, rate) if number != 0.0 && a.known().is_none() => {
                let inverse = self.fold(Code::Divide, &[1.0, number], rate);
                self.multiply(a, inverse)
            }
            _ => self.two(Code::Divide, a, b),
        }
    }

    pub fn min(&mut self, a: Value, b: Value) -> Value {
        if a == b { a } else { self.two(Code::Min, a, b) }
    }

    pub fn max(&mut self, a: Value, b: Value) -> Value {
        let covers = |one, other| self.is_never_negative(one) && self.is_never_positive(other);
        if a == b || covers(a, b) {
            return a;
        }
        if covers(b, a) {
            return b;
        }
        self.two(Code::Max, a, b)
    }

    /// Returns `1 − a`.
    pub fn complement(&mut self, a: Value) -> Value {
        self.subtract(Value::ONE, a)
    }

    /// Returns 1 where a > b, otherwise 0.
    pub fn greater(&mut self, a: Value, b: Value) -> Value {
        if self.is_never_positive(a) && self.is_never_negative(b) {
            return Value::ZERO;
        }
        self.two(Code::Greater, a, b)
    }

    /// Returns a, 0 where |a| ≤ b.
    pub fn beyond(&mut self, a: Value, b: Value) -> Value {
        self.two(Code::Beyond, a, b)
    }

    /// Returns a function of one number.
    pub fn function(&mut self, code: Code, a: Value) -> Value {
        if code == Code::Abs && self.is_never_negative(a) {
            return a;
        }
        self.one(code, a)
    }

    /// Returns whether a value cannot be below 0.
    fn is_never_negative(&self, value: Value) -> bool {
        match value {
            Value::Known(number, _) => number >= 0.0,
            Value::Varying(_) => self.has_sign(value, Sign::NotNegative),
        }
    }

    /// Returns whether a value cannot be above 0.
    fn is_never_positive(&self, value: Value) -> bool {
        match value {
            Value::Known(number, _) => number <= 0.0,
            Value::Varying(_) => self.has_sign(value, Sign::NotPositive),
        }
    }

    fn has_sign(&self, value: Value, sign: Sign) -> bool {
        self.operation(value).is_some_and(|own| own.sign == sign)
    }

    /// Returns what is known of the sign of an operation's result.
    fn sign_of_result(&self, code: Code, [a, b, _]: [Value; 3]) -> Sign {
        let [a_is, b_is] = [a, b].map(|value| self.is_never_negative(value));
        let [a_not, b_not] = [a, b].map(|value| self.is_never_positive(value));
        let not_negative = match code {
            Code::Abs
            | Code::Sqrt
            | Code::InverseSqrt
            | Code::Exp2
            | Code::PowerOfPositive
            | Code::Greater
            | Code::Acos => true,
            Code::Max => a.known().is_some_and(|a| a >= 0.0) || b.known().is_some_and(|b| b >= 0.0),
            Code::Min | Code::Divide => a_is && b_is,
            Code::Multiply => a == b || (a_is && b_is),
            Code::Beyond => a_is,
            _ => false,
        };
        let not_positive = match code {
            Code::Min => a_not || b_not,
            Code::Beyond => a_not,
            Code::Multiply => a_is && b_not || a_not && b_is,
            _ => false,
        };
        match (not_negative, not_positive) {
            (true, _) => Sign::NotNegative,
            (_, true) => Sign::NotPositive,
            _ => Sign::Any,
        }
    }

    /// Returns `a^b`: small whole powers by multiplication.
    pub fn power(&mut self, a: Value, b: Value) -> Value {
        let Some(exponent) = b.known() else {
            let positive = self.is_never_negative(a);
            let code = if positive {
                Code::PowerOfPositive
            } else {
                Code::Power
            };
            return self.two(code, a, b);
        };
        match exponent {
            0.0 => self.without_effect(Value::ONE),
            1.0 => self.without_effect(a),
            0.5 => self.one(Code::Sqrt, a),
            -1.0 => self.divide(Value::ONE, a),
            2.0 => self.two(Code::Multiply, a, a),
            3.0 => {
                let square = self.two(Code::Multiply, a, a);
                self.two(Code::Multiply, square, a)
            }
            4.0 => {
                let square = self.two(Code::Multiply, a, a);
                self.two(Code::Multiply, square, square)
            }
            _ => {
                let even = exponent.is_finite() && exponent % 2.0 == 0.0;
                let odd = exponent.is_finite() && exponent % 2.0 != 0.0 && exponent.fract() == 0.0;
                let base = if even { self.function(Code::Abs, a) } else { a };
                let signed = odd && !self.is_never_negative(a);
                let code = if signed {
                    Code::Power
                } else {
                    Code::PowerOfPositive
                };
                self.two(code, base, b)
            }
        }
    }

    /// Returns whether there are operands for which an operation is undefined.
    pub fn may_be_undefined(&self, operation: &Operation) -> bool {
        let [a, b, _] = operation.operands;
        match operation.code {
            Some(Code::PowerOfPositive) => !self.is_never_negative(a) || !self.is_never_negative(b),
            Some(Code::Sqrt) => !self.is_never_negative(a),
            Some(Code::Asin | Code::Acos) => !self.cosines.contains(&a),
            Some(code) => code.may_be_undefined(),
            None => false,
        }
    }
}

/// Returns the factor that is a number, and the other.
fn known_first(a: Value, b: Value) -> Option<(Value, Value)> {
    match (a.known(), b.known()) {
        (Some(_), None) => Some((a, b)),
        (None, Some(_)) => Some((b, a)),
        _ => None,
    }
}
