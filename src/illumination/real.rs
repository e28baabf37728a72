//! The number type over which the equation is written, and vectors of it.

mod angles;

use std::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

/// A coefficient: `f32` for pictures, `f64` for the reference.
pub trait Scalar: Copy + PartialEq + PartialOrd + Default + Send + Sync + 'static {
    /// The grid that vertices are rounded to in the picture, pixels.
    const GRID: f64;
    /// The rounding error of a few operations on numbers near 1.
    const ROUNDING: f64;
    /// The base-2 logarithm of the least power in a formula that does not count as 0. Products with smaller ones would be subnormal
    /// numbers, for which processors take a hundred times longer.
    const FAINTEST: f64;

    /// Rounds to this type; values beyond its range become its largest.
    fn from_f64(value: f64) -> Self;

    /// Converts to double precision, exactly.
    fn to_f64(self) -> f64;
}

impl Scalar for f32 {
    const GRID: f64 = 1.0 / 256.0;
    const ROUNDING: f64 = 4e-7;
    const FAINTEST: f64 = -100.0;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        (value as f32).clamp(f32::MIN, f32::MAX)
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        f64::from(self)
    }
}

impl Scalar for f64 {
    const GRID: f64 = 0.0;
    const ROUNDING: f64 = 1e-13;
    const FAINTEST: f64 = -1000.0;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        value.clamp(f64::MIN, f64::MAX)
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
}

/// One or several real numbers on which the same operations run.
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
    /// The coefficient type of one lane.
    type Scalar: Scalar;
    /// One truth value for each lane.
    type Mask: Copy + BitAnd<Output = Self::Mask>;

    /// Returns the constant in every lane; `self` only gives the number of lanes.
    fn constant(self, value: Self::Scalar) -> Self;
    /// Returns `value`, rounded to this precision, in every lane; `self` only gives the number of lanes.
    #[inline(always)]
    fn number(self, value: f64) -> Self {
        self.constant(Self::Scalar::from_f64(value))
    }
    /// Returns `self · a + b`, fused where the machine can.
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    /// Returns the larger of two numbers, lane by lane.
    fn max(self, other: Self) -> Self;
    /// Returns the smaller of two numbers, lane by lane.
    fn min(self, other: Self) -> Self;
    /// Returns the magnitude.
    fn abs(self) -> Self;
    /// Returns the largest whole number that is not larger than `self`.
    fn floor(self) -> Self;
    /// Returns `1/√self` for `self` ≥ 0, to 3 units in the last place; finite at 0, so that a zero vector stays zero when
    /// multiplied by the inverse of its length.
    fn inverse_sqrt(self) -> Self;
    /// Returns `1/√self` for a number known to be 10⁻³⁶ at least.
    #[inline(always)]
    fn inverse_sqrt_of_sound(self) -> Self {
        self.inverse_sqrt()
    }
    /// Returns `2^self`; 0 or almost 0 below the range of exponents. Relative error 2·10⁻⁷ in single precision.
    fn exp2(self) -> Self;
    /// Returns the base-2 logarithm of a positive number, absolute error 2·10⁻⁷ times its size in single precision.
    fn log2(self) -> Self;
    /// Returns the base-2 logarithm of `1 − t` for 0 ≤ t ≤ 0.29, relative error 2·10⁻⁷ in single precision: no digits are
    /// lost as t → 0.
    fn log2_one_minus(t: Self) -> Self;
    /// Returns whether `self > other`, lane by lane; false for NaN.
    fn greater_than(self, other: Self) -> Self::Mask;
    /// Returns `if_true` where the mask holds, `if_false` elsewhere.
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self;
    /// Returns whether the mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;
    /// Returns the mask of `bits`, the lowest bit for the first lane.
    fn mask_of_bits(self, bits: u64) -> Self::Mask;
    /// Returns whether the mask of `bits` holds in no lane.
    fn holds_none(self, bits: u64) -> bool {
        !Self::any(self.mask_of_bits(bits))
    }

    /// Runs `work` with the instructions for numbers like `self`, whatever those of its caller are: in a function that is not compiled
    /// into its callers, `work` is.
    fn vectorize<T>(self, work: impl FnOnce() -> T) -> T {
        work()
    }

    /// Returns `√self` for `self` ≥ 0.
    #[inline(always)]
    fn sqrt(self) -> Self {
        self * self.inverse_sqrt()
    }

    /// Returns the sine of an angle in degrees, absolute error 3·10⁻⁷ in single precision up to some turns.
    #[inline(always)]
    fn sin_of_degrees(self) -> Self {
        angles::sin(self)
    }

    /// Returns the cosine of an angle in degrees, as exact as the sine.
    #[inline(always)]
    fn cos_of_degrees(self) -> Self {
        angles::sin(self + self.number(90.0))
    }

    /// Returns the angle in degrees whose sine is `self`, −1 to 1; relative error 5·10⁻⁷ in single precision.
    #[inline(always)]
    fn asin_in_degrees(self) -> Self {
        angles::asin(self)
    }

    /// Returns the angle in degrees whose cosine is `self`, −1 to 1; relative error 5·10⁻⁷ in single precision.
    #[inline(always)]
    fn acos_in_degrees(self) -> Self {
        angles::acos(self)
    }

    /// Returns the angle in degrees whose tangent is `self`; relative error 5·10⁻⁷ in single precision.
    #[inline(always)]
    fn atan_in_degrees(self) -> Self {
        angles::atan(self)
    }

    /// Returns `1/self` for `self` ≥ 0, finite at 0.
    #[inline(always)]
    fn reciprocal(self) -> Self {
        self.number(1.0) / self.max(self.number(SHORTEST_DIVISOR))
    }
}

/// The smallest divisor; smaller ones are raised to it.
const SHORTEST_DIVISOR: f64 = 1e-20;

/// Defines the functions that `f32` and `f64` have themselves.
macro_rules! from_std {
    ($($name:ident($($other:ident)?)),*) => {
        $(fn $name(self $(, $other: Self)?) -> Self {
            Self::$name(self $(, $other)?)
        })*
    };
}

/// Implements [`Real`] for number types of the standard library, by its own functions.
macro_rules! real_of_std {
    ($($real:ident),*) => {$(
        impl Real for $real {
            type Scalar = Self;
            type Mask = bool;

            fn constant(self, value: Self) -> Self {
                value
            }

            from_std!(max(other), min(other), abs(), floor(), exp2(), log2());

            fn sin_of_degrees(self) -> Self {
                // The quarter turn nearest to it is taken off first, in degrees, where that is exact.
                let quarters = (self / 90.0).round();
                let (sine, cosine) = quarters.mul_add(-90.0, self).to_radians().sin_cos();
                match quarters.rem_euclid(4.0) as u8 {
                    0 => sine,
                    1 => cosine,
                    2 => -sine,
                    _ => -cosine,
                }
            }

            fn cos_of_degrees(self) -> Self {
                (self + 90.0).sin_of_degrees()
            }

            fn asin_in_degrees(self) -> Self {
                self.asin().to_degrees()
            }

            fn acos_in_degrees(self) -> Self {
                self.acos().to_degrees()
            }

            fn atan_in_degrees(self) -> Self {
                self.atan().to_degrees()
            }

            fn inverse_sqrt(self) -> Self {
                1.0 / self.max(Self::MIN_POSITIVE).sqrt()
            }

            fn log2_one_minus(t: Self) -> Self {
                (-t).ln_1p() * std::$real::consts::LOG2_E
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
    )*};
}

real_of_std!(f32, f64);

/// A vector of three [`Real`]s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct V3<R> {
    /// The component along x.
    pub x: R,
    /// The component along y.
    pub y: R,
    /// The component along z.
    pub z: R,
}

impl<R> V3<R> {
    /// Creates a vector from its components.
    #[inline(always)]
    pub const fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }
}

impl<R: Real> V3<R> {
    /// Returns the same vector in every lane of `like`.
    #[inline(always)]
    pub fn constant(like: R, value: [R::Scalar; 3]) -> Self {
        Self::new(
            like.constant(value[0]),
            like.constant(value[1]),
            like.constant(value[2]),
        )
    }

    /// Returns the component of this index: x, y, or z.
    #[inline(always)]
    pub fn axis(self, index: usize) -> R {
        match index {
            0 => self.x,
            1 => self.y,
            _ => self.z,
        }
    }

    /// Returns `x·x' + y·y' + z·z'`, by fused multiply and add where the machine has it.
    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        self.x
            .mul_add(other.x, self.y.mul_add(other.y, self.z * other.z))
    }

    /// Multiplies each component by `factor`.
    #[inline(always)]
    pub fn scale(self, factor: R) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }

    /// Returns `self · factor + other`.
    #[inline(always)]
    pub fn scale_add(self, factor: R, other: Self) -> Self {
        Self::new(
            self.x.mul_add(factor, other.x),
            self.y.mul_add(factor, other.y),
            self.z.mul_add(factor, other.z),
        )
    }

    /// Returns the unit vector; zero stays zero.
    #[inline(always)]
    pub fn normalised(self) -> Self {
        self.scale(self.dot(self).inverse_sqrt())
    }

    /// Returns the unit vector of a vector at least √`shortest` ≥ 10⁻¹⁸ long; shorter vectors give shorter results.
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
