//! Single-precision SIMD lanes as a [`Real`].
//!
//! The elementary functions are the polynomials of the Cephes library (S. L. Moshier, *Methods and Programs for
//! Mathematical Functions*, 1989; `logf`, `exp2f`), evaluated in lanes.

use super::Real;
#[cfg(target_feature = "simd128")]
use fearless_simd::{Level, f32x4};
use fearless_simd::{f32x16, i32x16, mask32x16, prelude::*};
#[cfg(target_feature = "simd128")]
use std::arch::wasm32::{f32x4_pmax, f32x4_pmin};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The number of lanes in a vector.
pub const LANES: usize = 16;

/// The numbers 0, 1, 2 and so on.
pub const COUNT: [f32; LANES] = [
    0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0,
];

/// Sixteen numbers: one vector of AVX-512, two of AVX2, four of 128 bits.
///
/// The equation is a long chain in which each step waits for the last. Where vectors are narrower, several chains side by side
/// keep the machine busy, and work common to all lanes is done once for more of them.
#[derive(Clone, Copy, Debug)]
pub struct Lanes<S: Simd>(pub f32x16<S>);

impl<S: Simd> Lanes<S> {
    /// Returns a vector with the same number in every lane.
    #[inline(always)]
    pub fn splat(simd: S, value: f32) -> Self {
        Self(f32x16::simd_from(simd, value))
    }

    /// Loads the first [`LANES`] numbers of `values`.
    #[inline(always)]
    pub fn load(simd: S, values: &[f32]) -> Self {
        Self(f32x16::from_slice(simd, &values[..LANES]))
    }

    /// Returns the numbers 0, 1, 2 and so on.
    #[inline(always)]
    pub fn count_up(simd: S) -> Self {
        Self::load(simd, &COUNT)
    }

    #[inline(always)]
    fn bits(self) -> i32x16<S> {
        self.0.bitcast()
    }
}

macro_rules! forward {
    ($op:ident, $method:ident) => {
        impl<S: Simd> $op for Lanes<S> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($op::$method(self.0, other.0))
            }
        }
    };
}

forward!(Add, add);
forward!(Sub, sub);
forward!(Mul, mul);
forward!(Div, div);

impl<S: Simd> Mul<f32> for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: f32) -> Self {
        Self(self.0 * factor)
    }
}

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

/// Returns `x²` and `x⁴`. Polynomials are summed in pairs (Estrin's scheme), since in a long chain each sum would wait for
/// the last.
#[inline(always)]
fn powers<S: Simd>(x: Lanes<S>) -> (Lanes<S>, Lanes<S>) {
    let square = x * x;
    (square, square * square)
}

/// Returns `a·x + b`.
#[inline(always)]
fn line<S: Simd>(x: Lanes<S>, a: f32, b: f32) -> Lanes<S> {
    x.constant(a).mul_add(x, x.constant(b))
}

/// Returns `ln(1 + x)` for −0.293 ≤ x ≤ 0.415 (√½ ≤ 1 + x ≤ √2), relative error under 2·10⁻⁷ (Cephes `logf`).
#[inline(always)]
fn ln_one_plus<S: Simd>(x: Lanes<S>) -> Lanes<S> {
    const P: [f32; 9] = [
        7.037_683_6e-2,
        -1.151_461e-1,
        1.167_699_9e-1,
        -1.242_014_1e-1,
        1.424_932_3e-1,
        -1.666_805_7e-1,
        2.000_071_5e-1,
        -2.499_999_4e-1,
        3.333_333e-1,
    ];
    let (square, fourth) = powers(x);
    let low = line(x, P[5], P[6]).mul_add(square, line(x, P[7], P[8]));
    let high = line(x, P[1], P[2]).mul_add(square, line(x, P[3], P[4]));
    let p = fourth.mul_add(x.constant(P[0]), high).mul_add(fourth, low);
    (square * x).mul_add(p, square.mul_add(x.constant(-0.5), x))
}

/// Defines the functions that vectors have themselves.
macro_rules! in_lanes {
    ($($name:ident($($other:ident)?)),*) => {
        $(#[inline(always)]
        fn $name(self $(, $other: Self)?) -> Self {
            Self(self.0.$name($($other.0)?))
        })*
    };
}

/// Defines functions by intrinsics on four lanes. WebAssembly's own `max` and `min` handle NaN and the sign of 0, which
/// costs a PC eight instructions; these cost one.
#[cfg(target_feature = "simd128")]
macro_rules! in_fours {
    ($($name:ident $intrinsic:ident),*) => {
        $(#[inline(always)]
        fn $name(self, other: Self) -> Self {
            let simd = self.0.token();
            let Level::WasmSimd128(wasm) = simd.level() else {
                return Self(self.0.$name(other.0));
            };
            let (a, b): ([f32; LANES], [f32; LANES]) = (self.0.into(), other.0.into());
            let mut all = [0.0; LANES];
            for ((a, b), four) in a.chunks_exact(4).zip(b.chunks_exact(4)).zip(all.chunks_exact_mut(4)) {
                let [a, b] = [a, b].map(|four| f32x4::from_slice(wasm, four).into());
                let chosen: f32x4<_> = $intrinsic(a, b).simd_into(wasm);
                chosen.store_slice(four);
            }
            Self(f32x16::simd_from(simd, all))
        })*
    };
}

impl<S: Simd> Real for Lanes<S> {
    type Scalar = f32;
    type Mask = mask32x16<S>;

    #[inline(always)]
    fn constant(self, value: f32) -> Self {
        Self(f32x16::simd_from(self.0.token(), value))
    }

    #[inline(always)]
    fn vectorize<T>(self, work: impl FnOnce() -> T) -> T {
        self.0.token().vectorize(work)
    }

    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        Self(self.0.mul_add(a.0, b.0))
    }

    #[cfg(not(target_feature = "simd128"))]
    in_lanes!(max(other), min(other));
    #[cfg(target_feature = "simd128")]
    in_fours!(max f32x4_pmax, min f32x4_pmin);

    in_lanes!(abs(), floor());

    #[inline(always)]
    fn inverse_sqrt(self) -> Self {
        // Smaller squares would overflow the square of the inverse root.
        self.max(self.constant(1e-36)).inverse_sqrt_of_sound()
    }

    /// Takes the bits' halved exponent as a first guess, then three Newton steps. Each squares the relative error 3.4·10⁻²
    /// (times 1.5): 2·10⁻³, 5·10⁻⁶, rounding. No level's own estimate is used, so all give the same digits.
    #[inline(always)]
    fn inverse_sqrt_of_sound(self) -> Self {
        let simd = self.0.token();
        let halved: i32x16<S> = self.bits() >> 1;
        let guess = i32x16::simd_from(simd, 0x5f37_59df) - halved;
        let mut y = Self(guess.bitcast());
        let half = self * -0.5;
        for _ in 0..3 {
            y = y * half.mul_add(y * y, y.constant(1.5));
        }
        y
    }

    #[inline(always)]
    fn exp2(self) -> Self {
        const P: [f32; 6] = [
            1.535_336_2e-4,
            1.339_887_4e-3,
            9.618_437e-3,
            5.550_332_5e-2,
            2.402_264_8e-1,
            6.931_472e-1,
        ];
        let clamped = self.max(self.constant(-126.0)).min(self.constant(126.0));
        let whole = Self((clamped.0 + 0.5).floor());
        let x = clamped - whole;
        let (square, fourth) = powers(x);
        let low = line(x, P[2], P[3]).mul_add(square, line(x, P[4], P[5]));
        let p = line(x, P[0], P[1]).mul_add(fourth, low);
        let mantissa = p.mul_add(x, x.constant(1.0));
        // Added to 2²³, a whole number is the lowest bits of the sum; the rest is shifted out.
        let biased: i32x16<S> = (whole.0 + (127.0 + 8_388_608.0)).bitcast();
        mantissa * Self((biased << 23).bitcast())
    }

    #[inline(always)]
    fn log2(self) -> Self {
        let simd = self.0.token();
        let bits = self.bits();
        // Shifted so that the mantissa falls into √½..√2, where the polynomial is good and log2(1) is exactly 0.
        let shifted = bits - i32x16::simd_from(simd, 0x3f35_04f3);
        let exponent = shifted >> 23;
        let mantissa = bits - (exponent << 23);
        let x = Self(mantissa.bitcast()) - self.constant(1.0);
        ln_one_plus(x).mul_add(
            x.constant(std::f32::consts::LOG2_E),
            Self(f32x16::float_from(exponent)),
        )
    }

    #[inline(always)]
    fn log2_one_minus(t: Self) -> Self {
        ln_one_plus(-t) * std::f32::consts::LOG2_E
    }

    #[inline(always)]
    fn greater_than(self, other: Self) -> Self::Mask {
        self.0.simd_gt(other.0)
    }

    #[inline(always)]
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self {
        Self(mask.select(if_true.0, if_false.0))
    }

    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        mask.any_true()
    }

    #[inline(always)]
    fn mask_of_bits(self, bits: u64) -> Self::Mask {
        mask32x16::from_bitmask(self.0.token(), bits)
    }

    #[inline(always)]
    fn holds_none(self, bits: u64) -> bool {
        bits << (64 - LANES) == 0
    }
}
