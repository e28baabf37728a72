//! The number type that the equation is written over, and vectors of it.

use std::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

/// A coefficient: `f32` for pictures, `f64` for the reference.
pub trait Scalar: Copy + PartialEq + PartialOrd + Default + Send + Sync + 'static {
    /// The grid that vertices are rounded to in the picture, pixels.
    const GRID: f64;
    /// Rounding error of a few operations on numbers near 1.
    const ROUNDING: f64;

    /// Rounds to this type; values beyond its range become its greatest.
    fn from_f64(value: f64) -> Self;
}

impl Scalar for f32 {
    const GRID: f64 = 1.0 / 256.0;
    const ROUNDING: f64 = 4e-7;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        (value as f32).clamp(f32::MIN, f32::MAX)
    }
}

impl Scalar for f64 {
    const GRID: f64 = 0.0;
    const ROUNDING: f64 = 1e-13;

    #[inline(always)]
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
    fn constant(self, value: Self::Scalar) -> Self;
    /// `value`, rounded to this precision, in every lane of `self`'s kind.
    #[inline(always)]
    fn number(self, value: f64) -> Self {
        self.constant(Self::Scalar::from_f64(value))
    }
    /// `self · a + b`, fused where the machine can.
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    /// The greater of two numbers, lane by lane.
    fn max(self, other: Self) -> Self;
    /// The lesser of two numbers, lane by lane.
    fn min(self, other: Self) -> Self;
    /// The magnitude.
    fn abs(self) -> Self;
    /// The greatest whole number that is not greater.
    fn floor(self) -> Self;
    /// `1/√self` for `self` ≥ 0, to 3 units in the last place; finite at 0, so that a zero vector stays zero when
    /// it is multiplied by the inverse of its length.
    fn inverse_sqrt(self) -> Self;
    /// The same for what is known to be 10⁻³⁶ at least.
    #[inline(always)]
    fn inverse_sqrt_of_sound(self) -> Self {
        self.inverse_sqrt()
    }
    /// `2^self`; 0 or almost 0 below the range of exponents. Relative error 2·10⁻⁷ in single precision.
    fn exp2(self) -> Self;
    /// Base-2 logarithm of a positive number, absolute error 2·10⁻⁷ times its size in single precision.
    fn log2(self) -> Self;
    /// Base-2 logarithm of `1 − t` for 0 ≤ t ≤ 0.29, relative error 2·10⁻⁷ in single precision: no digits are lost as
    /// t → 0.
    fn log2_one_minus(t: Self) -> Self;
    /// Whether `self > other`, lane by lane; false for NaN.
    fn greater_than(self, other: Self) -> Self::Mask;
    /// `if_true` where the mask holds, `if_false` elsewhere.
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self;
    /// Whether the mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;
    /// The truth values of as many lanes as there are, the lowest bit the first lane's.
    fn mask_of_bits(self, bits: u64) -> Self::Mask;
    /// Whether all of those truth values are false.
    fn holds_none(self, bits: u64) -> bool {
        !Self::any(self.mask_of_bits(bits))
    }

    /// `√self` for `self` ≥ 0.
    #[inline(always)]
    fn sqrt(self) -> Self {
        self * self.inverse_sqrt()
    }

    /// `1/self` for `self` ≥ 0, finite at 0.
    #[inline(always)]
    fn reciprocal(self) -> Self {
        self.number(1.0) / self.max(self.number(SHORTEST_DIVISOR))
    }
}

/// Smaller divisors are raised to this.
const SHORTEST_DIVISOR: f64 = 1e-20;

/// The functions that `f64` has itself.
macro_rules! from_std {
    ($($name:ident($($other:ident)?)),*) => {
        $(fn $name(self $(, $other: Self)?) -> Self {
            Self::$name(self $(, $other)?)
        })*
    };
}

impl Real for f64 {
    type Scalar = Self;
    type Mask = bool;

    fn constant(self, value: Self) -> Self {
        value
    }

    from_std!(max(other), min(other), abs(), floor(), exp2(), log2());

    fn inverse_sqrt(self) -> Self {
        1.0 / self.max(Self::MIN_POSITIVE).sqrt()
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
}

/// A vector of three [`Real`]s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct V3<R> {
    /// Component along x.
    pub x: R,
    /// Component along y.
    pub y: R,
    /// Component along z.
    pub z: R,
}

impl<R> V3<R> {
    /// From its components.
    #[inline(always)]
    pub const fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }
}

impl<R: Real> V3<R> {
    /// The same vector in every lane of `like`.
    #[inline(always)]
    pub fn constant(like: R, value: [R::Scalar; 3]) -> Self {
        Self::new(
            like.constant(value[0]),
            like.constant(value[1]),
            like.constant(value[2]),
        )
    }

    /// `x·x' + y·y' + z·z'`, by fused multiply and add where the machine has it.
    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        self.x
            .mul_add(other.x, self.y.mul_add(other.y, self.z * other.z))
    }

    /// Each component times `factor`.
    #[inline(always)]
    pub fn scale(self, factor: R) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }

    /// `self · factor + other`.
    #[inline(always)]
    pub fn scale_add(self, factor: R, other: Self) -> Self {
        Self::new(
            self.x.mul_add(factor, other.x),
            self.y.mul_add(factor, other.y),
            self.z.mul_add(factor, other.z),
        )
    }

    /// The unit vector; zero stays zero.
    #[inline(always)]
    pub fn normalised(self) -> Self {
        self.scale(self.dot(self).inverse_sqrt())
    }

    /// The unit vector, of vectors of at least √`shortest` ≥ 10⁻¹⁸ in length; shorter ones come out shorter.
    #[inline(always)]
    pub fn normalised_from(self, shortest: R) -> Self {
        self.scale(self.dot(self).max(shortest).inverse_sqrt_of_sound())
    }
}

impl<R: Real> Add for V3<R> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<R: Real> Sub for V3<R> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<R: Real> Neg for V3<R> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl From<glam::DVec3> for V3<f64> {
    fn from(v: glam::DVec3) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl From<V3<f64>> for glam::DVec3 {
    fn from(v: V3<f64>) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}
