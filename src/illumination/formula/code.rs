//! The scalar operations that a formula consists of, each over any [`Real`].

use crate::illumination::{Real, Scalar};

/// A scalar operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Code {
    /// `−a`
    Negate,
    /// `a + b`
    Add,
    /// `a − b`
    Subtract,
    /// `a·b`
    Multiply,
    /// `a·b + c`
    MultiplyAdd,
    /// `a·b − c`
    MultiplySubtract,
    /// `c − a·b`
    SubtractProduct,
    /// `a/b`, 0 where b is 0.
    Divide,
    /// The smaller.
    Min,
    /// The larger.
    Max,
    /// `|a|`
    Abs,
    /// The largest whole number not above a.
    Floor,
    /// `√a`, 0 where a is negative.
    Sqrt,
    /// `1/√a`, finite at 0.
    InverseSqrt,
    /// `2^a`
    Exp2,
    /// The base-2 logarithm, 0 where a is not positive.
    Log2,
    /// `a^b` for a ≥ 0; negative a count as 0.
    PowerOfPositive,
    /// `a^b`; 0 where a is negative and b not whole.
    Power,
    /// The sine, degrees.
    Sin,
    /// The cosine, degrees.
    Cos,
    /// The angle of a sine, degrees; 0 where there is none.
    Asin,
    /// The angle of a cosine, degrees; 0 where there is none.
    Acos,
    /// The angle of a tangent, degrees.
    Atan,
    /// 1 where a > b, otherwise 0.
    Greater,
    /// a, 0 where |a| ≤ b.
    Beyond,
}

/// Runs `$body` with the constant `$one` for the operation `$code`, so that the choice is made outside of a loop.
macro_rules! for_code {
    ($code:expr, $one:ident => $body:expr) => {
        $crate::illumination::formula::code::for_code!(@all $code, $one => $body;
            Negate Add Subtract Multiply MultiplyAdd MultiplySubtract SubtractProduct Divide Min Max Abs Floor Sqrt
            InverseSqrt Exp2 Log2 PowerOfPositive Power Sin Cos Asin Acos Atan Greater Beyond)
    };
    (@all $code:expr, $one:ident => $body:expr; $($name:ident)+) => {
        match $code {
            $(Code::$name => {
                const $one: Code = Code::$name;
                $body
            })+
        }
    };
}

pub(super) use for_code;

/// The smallest base of a power and argument of a logarithm, as in the specular factor.
const TINY: f64 = f32::MIN_POSITIVE as f64;

/// The distance by which rounding may take a sine or a cosine beyond ±1 without losing its angle.
const ROUNDED: f64 = 1.0 + 1e-6;

impl Code {
    /// Returns the number of its operands.
    pub fn operands(self) -> usize {
        match self {
            Self::Negate
            | Self::Abs
            | Self::Floor
            | Self::Sqrt
            | Self::InverseSqrt
            | Self::Exp2
            | Self::Log2
            | Self::Sin
            | Self::Cos
            | Self::Asin
            | Self::Acos
            | Self::Atan => 1,
            Self::MultiplyAdd | Self::MultiplySubtract | Self::SubtractProduct => 3,
            _ => 2,
        }
    }

    /// Returns whether there are operands for which it is undefined.
    pub(super) fn may_be_undefined(self) -> bool {
        matches!(
            self,
            Self::Divide
                | Self::Sqrt
                | Self::Log2
                | Self::PowerOfPositive
                | Self::Power
                | Self::Asin
                | Self::Acos
        )
    }

    /// Returns its result; operands that it does not have are ignored. Where it is undefined, the result is 0.
    #[inline(always)]
    pub fn apply<R: Real>(self, a: R, b: R, c: R) -> R {
        let (zero, one) = (a.number(0.0), a.number(1.0));
        match self {
            Self::Negate => -a,
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::MultiplyAdd => a.mul_add(b, c),
            Self::MultiplySubtract => a.mul_add(b, -c),
            Self::SubtractProduct => (-a).mul_add(b, c),
            Self::Divide => R::select(b.abs().greater_than(zero), a / b, zero),
            Self::Min => a.min(b),
            Self::Max => a.max(b),
            Self::Abs => a.abs(),
            Self::Floor => a.floor(),
            Self::Sqrt => a.max(zero).sqrt(),
            Self::InverseSqrt => a.inverse_sqrt(),
            Self::Exp2 => R::select(
                a.greater_than(a.number(R::Scalar::FAINTEST)),
                a.exp2(),
                zero,
            ),
            Self::Log2 => R::select(a.greater_than(zero), a.max(a.number(TINY)).log2(), zero),
            Self::PowerOfPositive => {
                let positive = a.greater_than(zero);
                if !R::any(positive) {
                    return power_of_zero(b);
                }
                let exponent = a.max(a.number(TINY)).log2() * b;
                let some = positive & exponent.greater_than(a.number(R::Scalar::FAINTEST));
                R::select(some, exponent.exp2(), power_of_zero(b))
            }
            Self::Power => {
                let exponent = a.abs().max(a.number(TINY)).log2() * b;
                let some = exponent.greater_than(a.number(R::Scalar::FAINTEST));
                let power = R::select(some, exponent.exp2(), zero);
                let half = b * a.number(0.5);
                let odd = half.greater_than(half.floor());
                let whole = R::select(odd, -power, power);
                let negative = R::select(b.greater_than(b.floor()), zero, whole);
                let other = R::select(zero.greater_than(a), negative, power_of_zero(b));
                R::select(a.greater_than(zero), power, other)
            }
            Self::Sin => a.sin_of_degrees(),
            Self::Cos => a.cos_of_degrees(),
            Self::Asin => {
                let angle = a.max(-one).min(one).asin_in_degrees();
                R::select(a.abs().greater_than(a.number(ROUNDED)), zero, angle)
            }
            Self::Acos => {
                let angle = a.max(-one).min(one).acos_in_degrees();
                R::select(a.abs().greater_than(a.number(ROUNDED)), zero, angle)
            }
            Self::Atan => a.atan_in_degrees(),
            Self::Greater => R::select(a.greater_than(b), one, zero),
            Self::Beyond => R::select(a.abs().greater_than(b), a, zero),
        }
    }

    /// Returns 1 where the operation is undefined for its operands, otherwise 0.
    #[inline(always)]
    pub fn undefined<R: Real>(self, a: R, b: R) -> R {
        let (zero, one) = (a.number(0.0), a.number(1.0));
        let is_zero = |x: R| R::select(x.abs().greater_than(zero), zero, one);
        let is_negative = |x: R| R::select(zero.greater_than(x), one, zero);
        match self {
            Self::Divide => is_zero(b),
            Self::Sqrt => is_negative(a),
            Self::Log2 => R::select(a.greater_than(zero), zero, one),
            Self::PowerOfPositive => is_negative(a).max(is_zero(a) * is_negative(b)),
            Self::Power => {
                let fraction = R::select(b.greater_than(b.floor()), one, zero);
                (is_negative(a) * fraction).max(is_zero(a) * is_negative(b))
            }
            Self::Asin | Self::Acos => {
                R::select(a.abs().greater_than(a.number(ROUNDED)), one, zero)
            }
            _ => zero,
        }
    }
}

/// Returns `0^b`: 1 for b = 0, otherwise 0.
#[inline(always)]
fn power_of_zero<R: Real>(b: R) -> R {
    let zero = b.number(0.0);
    R::select(b.abs().greater_than(zero), zero, b.number(1.0))
}
