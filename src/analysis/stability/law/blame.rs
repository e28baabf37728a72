//! The operation of a law that loses the digits.
//!
//! An operation loses digits where rounding one of its operands shows in the result, and rounding its own result does not: its
//! operands have the digits that are needed, and its result needs fewer. It amplifies what was a rounding error, by its condition
//! number (N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition 2002, section 1.6). In `1e5·(1 − c²)` near
//! c = 1 this is the subtraction: the product `c²` must be known to 10⁻⁸, the difference only to a few digits. It is not the factor
//! 10⁵: a product passes on relative errors as they are.
//!
//! The effect of rounding `v` on the result is `u·|v·∂result/∂v|`, of first order, with the unit roundoff u = 2⁻²⁴ of `f32`. The
//! derivatives for all operations come from one pass from the result back to the inputs (S. Linnainmaa, *Taylor expansion of
//! the accumulated rounding error*, BIT 16, 1976). An error shows if it is above an equal share of half a code value: if
//! all roundings were below it, so would be their sum.

use super::values::Values;
use crate::analysis::stability::HALF_A_CODE_VALUE;
use crate::analysis::stability::precise::{Precise, precise};
use crate::illumination::{Code, LawOperations, Operation, Real, Value};
use std::f64::consts::LN_2;
use std::ops::Range;

/// The unit roundoff of `f32`, half a unit in the last place of 1.
const ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;

/// An operation that loses digits.
#[derive(Clone, Copy, Debug)]
pub struct Blamed {
    index: usize,
    /// True if its operands' rounding shows in the result and its own does not.
    loses: bool,
    /// The effect of rounding an operand on the result, code values.
    effect: f64,
    /// The condition number.
    pub condition: f64,
}

/// The search for the operation.
pub struct Blame<'a> {
    operations: &'a LawOperations,
    /// The effect of one rounding that shows, code values.
    share: f64,
    /// The derivatives of the result with respect to the results of the operations, code values.
    slopes: Vec<f64>,
    worst: Option<Blamed>,
}

impl<'a> Blame<'a> {
    /// Begins the search in a sum of `parts` parts.
    pub fn new(operations: &'a LawOperations, parts: usize) -> Self {
        let roundings = operations.iter().count() * parts;
        Self {
            operations,
            share: HALF_A_CODE_VALUE / roundings.max(1) as f64,
            slopes: vec![],
            worst: None,
        }
    }

    /// Looks at the operations of a channel in one part; `coefficient` is the number of code values to 1.
    pub fn look(&mut self, channel: usize, coefficient: f64, values: &Values) {
        self.slopes.clear();
        self.slopes.resize(values.exact.len(), 0.0);
        if let Value::Varying(index) = self.operations.results[channel] {
            self.slopes[index as usize] = coefficient;
        }
        for (index, operation) in self.operations.iter().rev() {
            let slope = self.slopes[index];
            if slope == 0.0 || slope.is_nan() {
                continue;
            }
            if let Some(code) = operation.code {
                let found = self.weigh(index, operation, code, values);
                let order = |a: &Blamed, b: &Blamed| {
                    (a.loses.cmp(&b.loses)).then(a.effect.total_cmp(&b.effect))
                };
                self.worst = self.worst.into_iter().chain([found]).max_by(order);
            }
        }
    }

    /// Returns the effect of an operation, and passes its slope on to its operands.
    fn weigh(
        &mut self,
        index: usize,
        operation: &Operation,
        code: Code,
        values: &Values,
    ) -> Blamed {
        let slope = self.slopes[index];
        let result = values.exact[index];
        let value = f64::from(result);
        let operands = operation
            .operands
            .map(|value| value.of(&values.exact, Precise::default()));
        let slopes = derivatives(code, operands, result);
        let (mut effect, mut condition) = (0.0_f64, 0.0_f64);
        for place in 0..code.operands() {
            let own = f64::from(operands[place]);
            // What is not a number comes from an operand that is 0, and has no relative error.
            let change = number(own * slopes[place]);
            let is_exact = match operation.operands[place] {
                Value::Known(known, _) => f64::from(known as f32) == known,
                Value::Varying(operand) => {
                    self.slopes[operand as usize] += number(slope * slopes[place]);
                    false
                }
            };
            if !is_exact {
                effect = effect.max(number(ROUNDOFF * (slope * change).abs()));
                condition = condition.max(number((change / value).abs()));
            }
        }
        let mut after = number(ROUNDOFF * (slope * value).abs());
        if matches!(code, Code::Greater | Code::Floor | Code::Beyond) {
            // A step has no derivative: it loses all digits where rounding takes it to the other side.
            let jump = (f64::from(values.single[index]) - value).abs();
            if jump > 0.0 {
                (effect, condition, after) = ((slope * jump).abs(), f64::INFINITY, 0.0);
            }
        }
        Blamed {
            index,
            loses: after <= self.share && effect > self.share,
            effect,
            condition,
        }
    }

    /// Returns the part of the formula whose operation loses the most digits.
    pub fn result(self) -> Option<(Range<usize>, Blamed)> {
        let worst = self.worst?;
        let mut all = self.operations.iter();
        let (_, operation) = all.find(|(index, _)| *index == worst.index)?;
        Some((self.operations.span(operation), worst))
    }
}

/// Returns the value, or 0 if it is not a number.
fn number(value: f64) -> f64 {
    if value.is_nan() { 0.0 } else { value }
}

/// Returns the derivatives of an operation with respect to its operands, 0 where there is none.
fn derivatives(code: Code, [a, b, _]: [Precise; 3], result: Precise) -> [f64; 3] {
    let degree = 1.0_f64.to_radians();
    let one = precise(1.0);
    let (x, y, value) = (f64::from(a), f64::from(b), f64::from(result));
    let of_one = |slope: f64| [slope, 0.0, 0.0];
    // Of an angle with respect to its sine, degrees.
    let angle = || (1.0 / degree) / f64::from((one - a * a).max(precise(0.0)).sqrt());
    let chosen = |first: bool| {
        if first {
            [1.0, 0.0, 0.0]
        } else {
            [0.0, 1.0, 0.0]
        }
    };
    match code {
        Code::Negate => of_one(-1.0),
        Code::Add => [1.0, 1.0, 0.0],
        Code::Subtract => [1.0, -1.0, 0.0],
        Code::Multiply => [y, x, 0.0],
        Code::MultiplyAdd => [y, x, 1.0],
        Code::MultiplySubtract => [y, x, -1.0],
        Code::SubtractProduct => [-y, -x, 1.0],
        Code::Divide if y != 0.0 => [1.0 / y, -value / y, 0.0],
        Code::Min => chosen(a <= b),
        Code::Max => chosen(a >= b),
        Code::Abs => of_one(x.signum()),
        Code::Beyond => of_one(1.0),
        Code::Sqrt if x >= 0.0 => of_one(0.5 / value),
        Code::InverseSqrt if x > 0.0 => of_one(-0.5 * value / x),
        Code::Exp2 => of_one(LN_2 * value),
        Code::Log2 if x > 0.0 => of_one(1.0 / (LN_2 * x)),
        Code::PowerOfPositive if x > 0.0 => [y * value / x, x.ln() * value, 0.0],
        Code::Power if x != 0.0 => [y * value / x, x.abs().ln() * value, 0.0],
        Code::Sin => of_one(degree * f64::from(a.cos_of_degrees())),
        Code::Cos => of_one(-degree * f64::from(a.sin_of_degrees())),
        Code::Asin => of_one(angle()),
        Code::Acos => of_one(-angle()),
        Code::Atan => of_one(1.0 / (degree * x.mul_add(x, 1.0))),
        _ => [0.0; 3],
    }
}
