//! The number type that the equation is written over.

use std::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

/// A coefficient: `f32` for pictures, `f64` for the reference.
pub trait Scalar: Copy + PartialEq + PartialOrd + Default + Send + Sync + 'static {
    /// What places are rounded to in the picture, pixels: vertices lie on a grid where this type shades them.
    const GRID: f64;
    /// What a few operations leave of 0, beside 1.
    const ROUNDING: f64;

    /// Rounds to this type; values beyond its range become its greatest.
    fn from_f64(value: f64) -> Self;
}

impl Scalar for f32 {
    const GRID: f64 = 1.0 / 256.0;
    const ROUNDING: f64 = 4e-7;

    #[expect(clippy::cast_possible_truncation, reason = "rounding to single precision is what is asked for")]
    fn from_f64(value: f64) -> Self {
        (value as f32).clamp(f32::MIN, f32::MAX)
    }
}

impl Scalar for f64 {
    const GRID: f64 = 0.0;
    const ROUNDING: f64 = 1e-13;

    fn from_f64(value: f64) -> Self {
        value.clamp(f64::MIN, f64::MAX)
    }
}

/// One or several real numbers that are computed with alike.
///
/// Nothing here yields a NaN from finite input as long as nothing overflows.
pub trait Real:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Mul<Self::Scalar, Output = Self>
{
    /// One lane's coefficient type.
    type Scalar: Scalar;
    /// One truth value a lane.
    type Mask: Copy + BitAnd<Output = Self::Mask>;

    /// The constant in every lane; `self` only tells how many lanes there are.
    #[must_use]
    fn constant(self, value: Self::Scalar) -> Self;
    /// `self · a + b`, fused where the machine can.
    #[must_use]
    fn mul_add(self, a: Self, b: Self) -> Self;
    #[must_use]
    fn max(self, other: Self) -> Self;
    #[must_use]
    fn min(self, other: Self) -> Self;
    #[must_use]
    fn abs(self) -> Self;
    /// The greatest whole number that is not greater.
    #[must_use]
    fn floor(self) -> Self;
    /// `1/√self` for `self` ≥ 0, to 3 units in the last place; finite at 0, so that a zero vector stays zero when
    /// it is multiplied by the inverse of its length.
    #[must_use]
    fn inverse_sqrt(self) -> Self;
    /// The same for what is known to be 10⁻³⁶ at least.
    #[inline(always)]
    #[must_use]
    fn inverse_sqrt_of_sound(self) -> Self {
        self.inverse_sqrt()
    }
    /// `2^self`; 0 or almost 0 below the range of exponents. Relative error 2·10⁻⁷ in single precision.
    #[must_use]
    fn exp2(self) -> Self;
    /// Base-2 logarithm of a positive number, absolute error 2·10⁻⁷ times its size in single precision.
    #[must_use]
    fn log2(self) -> Self;
    /// Base-2 logarithm of `1 − t` for 0 ≤ t ≤ 0.29, relative error 2·10⁻⁷ in single precision: no digits are lost as
    /// t → 0.
    #[must_use]
    fn log2_one_minus(t: Self) -> Self;
    #[must_use]
    fn greater_than(self, other: Self) -> Self::Mask;
    #[must_use]
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self;
    fn any(mask: Self::Mask) -> bool;
    /// The truth values of as many lanes as there are, the lowest bit the first lane's.
    #[must_use]
    fn mask_of_bits(self, bits: u64) -> Self::Mask;
    /// Whether all of those truth values are false.
    fn holds_none(self, bits: u64) -> bool;

    /// `√self` for `self` ≥ 0.
    #[inline(always)]
    #[must_use]
    fn sqrt(self) -> Self {
        self * self.inverse_sqrt()
    }

    /// `1/self` for `self` ≥ 0, finite at 0.
    #[inline(always)]
    #[must_use]
    fn reciprocal(self) -> Self {
        let one = self.constant(Self::Scalar::from_f64(1.0));
        one / self.max(self.constant(Self::Scalar::from_f64(SHORTEST_DIVISOR)))
    }
}

/// What is smaller is lifted to this before anything is divided by it.
const SHORTEST_DIVISOR: f64 = 1e-20;

impl Real for f64 {
    type Scalar = Self;
    type Mask = bool;

    fn constant(self, value: Self) -> Self {
        value
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }

    fn max(self, other: Self) -> Self {
        Self::max(self, other)
    }

    fn min(self, other: Self) -> Self {
        Self::min(self, other)
    }

    fn abs(self) -> Self {
        Self::abs(self)
    }

    fn floor(self) -> Self {
        Self::floor(self)
    }

    fn inverse_sqrt(self) -> Self {
        1.0 / self.max(Self::MIN_POSITIVE).sqrt()
    }

    fn exp2(self) -> Self {
        Self::exp2(self)
    }

    fn log2(self) -> Self {
        Self::log2(self)
    }

    fn log2_one_minus(t: Self) -> Self {
        (-t).ln_1p() * std::f64::consts::LOG2_E
    }

    fn greater_than(self, other: Self) -> bool {
        self > other
    }

    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }

    fn any(mask: bool) -> bool {
        mask
    }

    fn mask_of_bits(self, bits: u64) -> bool {
        bits & 1 == 1
    }

    fn holds_none(self, bits: u64) -> bool {
        bits & 1 == 0
    }
}
