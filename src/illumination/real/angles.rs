//! Sines and angles in single precision: the polynomials of the Cephes library (S. L. Moshier, *Methods and Programs for
//! Mathematical Functions*, 1989; `sinf`, `asinf`, `atanf`).

use super::Real;
use std::f64::consts::PI;

const DEGREES: f64 = 180.0 / PI;

/// Returns the polynomial with these coefficients, the highest power's first.
#[inline(always)]
fn polynomial<R: Real, const N: usize>(x: R, coefficients: [f64; N]) -> R {
    let mut sum = x.number(coefficients[0]);
    for coefficient in &coefficients[1..] {
        sum = sum.mul_add(x, x.number(*coefficient));
    }
    sum
}

/// Returns the sine of an angle in degrees. The quarter turn nearest to it is taken off first, in degrees, where that is exact.
#[inline(always)]
pub fn sin<R: Real>(angle: R) -> R {
    let (half, four) = (angle.number(0.5), angle.number(4.0));
    let quarters = angle.mul_add(angle.number(1.0 / 90.0), half).floor();
    let x = quarters.mul_add(angle.number(-90.0), angle) * angle.number(1.0 / DEGREES);
    let z = x * x;
    let odd = [-1.951_529_589_1e-4, 8.332_160_873_6e-3, -1.666_665_461_1e-1];
    let sine = (z * x).mul_add(polynomial(z, odd), x);
    let even = [2.443_315_711_8e-5, -1.388_731_625_5e-3, 4.166_664_568_3e-2];
    let cosine = (z * z).mul_add(
        polynomial(z, even),
        z.mul_add(z.number(-0.5), z.number(1.0)),
    );
    // 0, 1, 2 or 3.
    let quadrant = quarters - (quarters * angle.number(0.25)).floor() * four;
    let half_quadrant = (quadrant * half).floor();
    let is_odd = (quadrant - half_quadrant - half_quadrant).greater_than(half);
    let value = R::select(is_odd, cosine, sine);
    R::select(half_quadrant.greater_than(half), -value, value)
}

/// Returns the angle, radians, whose sine is `x`, 0 to ½.
#[inline(always)]
fn small_asin<R: Real>(x: R) -> R {
    let z = x * x;
    let p = [
        4.216_319_904_8e-2,
        2.418_131_104_9e-2,
        4.547_002_599_8e-2,
        7.495_300_268_6e-2,
        1.666_675_242_2e-1,
    ];
    (z * x).mul_add(polynomial(z, p), x)
}

/// Returns the angle, radians, whose cosine is `x`, 0 to 1: near 1 by the half angle, which keeps its digits.
#[inline(always)]
fn acos_of_positive<R: Real>(x: R) -> R {
    let (half, zero) = (x.number(0.5), x.number(0.0));
    let by_half = small_asin(((x.number(1.0) - x) * half).max(zero).sqrt());
    let direct = x.number(PI / 2.0) - small_asin(x.min(half));
    R::select(x.greater_than(half), by_half + by_half, direct)
}

/// Returns the angle in degrees whose cosine is `x`.
#[inline(always)]
pub fn acos<R: Real>(x: R) -> R {
    let angle = acos_of_positive(x.abs());
    let turned = x.number(PI) - angle;
    R::select(x.number(0.0).greater_than(x), turned, angle) * x.number(DEGREES)
}

/// Returns the angle in degrees whose sine is `x`: near 1 by the half angle of its complement.
#[inline(always)]
pub fn asin<R: Real>(x: R) -> R {
    let (size, half) = (x.abs(), x.number(0.5));
    let complement = x.number(PI / 2.0) - acos_of_positive(size.max(half));
    let small = small_asin(size.min(half));
    let angle = R::select(size.greater_than(half), complement, small);
    R::select(x.number(0.0).greater_than(x), -angle, angle) * x.number(DEGREES)
}

/// Returns the angle in degrees whose tangent is `x`.
#[inline(always)]
pub fn atan<R: Real>(x: R) -> R {
    let (size, one, zero) = (x.abs(), x.number(1.0), x.number(0.0));
    // tan(3π/8) and tan(π/8).
    let (steep, middle) = (
        size.greater_than(x.number(2.414_213_562_373)),
        size.greater_than(x.number(0.414_213_562_373)),
    );
    let reduced = R::select(
        steep,
        -one / size.max(one),
        R::select(middle, (size - one) / (size + one), size),
    );
    let offset = R::select(
        steep,
        x.number(PI / 2.0),
        R::select(middle, x.number(PI / 4.0), zero),
    );
    let z = reduced * reduced;
    let p = [
        8.053_744_495_38e-2,
        -1.387_768_560_32e-1,
        1.997_771_064_78e-1,
        -3.333_294_915_39e-1,
    ];
    let angle = offset + (z * reduced).mul_add(polynomial(z, p), reduced);
    R::select(zero.greater_than(x), -angle, angle) * x.number(DEGREES)
}
