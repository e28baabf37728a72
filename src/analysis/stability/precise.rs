//! Double-double numbers, 106 bits as the unevaluated sum of two `f64`, and vectors of them.
//!
//! They are [`Real`](crate::illumination::Real) numbers, so that whatever is written over these is evaluated in 106 bits as well.
//!
//! The algorithms are those of T. J. Dekker (*A Floating-Point Technique for Extending the Available Precision*, 1971)
//! and of Y. Hida, X. S. Li and D. H. Bailey (*Algorithms for Quad-Double Precision Floating Point Arithmetic*, 2001).
//! Relative errors are a few 10⁻³² for the operations and below 10⁻²⁹ for the functions, in the range of exponents of
//! an `f64`.

mod real;

use crate::analysis::operators::operators;
use glam::DVec3;

/// A double-double number.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Precise {
    hi: f64,
    lo: f64,
}

/// Converts an `f64` exactly.
pub const fn precise(value: f64) -> Precise {
    Precise { hi: value, lo: 0.0 }
}

/// Returns the sum of two numbers with its rounding error; the first must be the larger in magnitude.
fn quick_sum(a: f64, b: f64) -> Precise {
    let hi = a + b;
    with_error(hi, b - (hi - a))
}

/// Returns the sum of a number and its rounding error; infinity and NaN have none.
fn with_error(hi: f64, lo: f64) -> Precise {
    let lo = if hi.is_finite() { lo } else { 0.0 };
    Precise { hi, lo }
}

/// Returns the sum of two numbers with its rounding error.
fn sum(a: f64, b: f64) -> Precise {
    let hi = a + b;
    let part = hi - a;
    with_error(hi, (a - (hi - part)) + (b - part))
}

/// Returns the product of two numbers with its rounding error.
fn product(a: f64, b: f64) -> Precise {
    let hi = a * b;
    with_error(hi, a.mul_add(b, -hi))
}

impl Precise {
    const PI: Self = Self {
        hi: std::f64::consts::PI,
        lo: 1.224_646_799_147_353_2e-16,
    };
    const LN_2: Self = Self {
        hi: std::f64::consts::LN_2,
        lo: 2.319_046_813_846_299_6e-17,
    };

    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return precise(if self.hi < 0.0 { f64::NAN } else { 0.0 });
        }
        let inverse = 1.0 / self.hi.sqrt();
        let root = self.hi * inverse;
        sum(root, (self - product(root, root)).hi * (inverse * 0.5))
    }

    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    pub fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    /// Computes eˣ: Taylor's series of x/512 after whole powers of 2 are taken out, squared nine times.
    pub fn exp(self) -> Self {
        const SQUARINGS: i32 = 9;
        let power = (self.hi / Self::LN_2.hi).round();
        if power < -1000.0 {
            return precise(0.0);
        }
        if power > 1023.0 {
            return precise(f64::INFINITY);
        }
        let rest = (self - Self::LN_2 * power) * 0.5_f64.powi(SQUARINGS);
        // eʳ − 1, so that squaring loses nothing: (1 + s)² − 1 = 2s + s².
        let mut less_one = precise(0.0);
        let mut term = precise(1.0);
        for k in 1..12_u32 {
            term = term * rest / precise(f64::from(k));
            less_one = less_one + term;
        }
        for _ in 0..SQUARINGS {
            less_one = less_one * 2.0 + less_one * less_one;
        }
        (less_one + precise(1.0)) * 2.0_f64.powi(power as i32)
    }

    /// Computes the natural logarithm of a positive number by Newton's iteration, to 10⁻³² times its size or 1.
    pub fn ln(self) -> Self {
        let mut x = precise(self.hi.ln());
        for _ in 0..2 {
            x = x + self * (-x).exp() - precise(1.0);
        }
        x
    }

    /// Computes sine and cosine of an angle of at most a few radians, by Taylor's series.
    pub fn sin_cos(self) -> (Self, Self) {
        let mut sums = [precise(0.0); 2];
        let mut term = precise(1.0);
        for k in 0..48 {
            let part = if k % 4 < 2 { term } else { -term };
            sums[k % 2] = sums[k % 2] + part;
            term = term * self / precise((k + 1) as f64);
        }
        let [cosine, sine] = sums;
        (sine, cosine)
    }

    /// Returns the largest whole number that is not larger.
    pub fn floor(self) -> Self {
        let whole = self.hi.floor();
        if whole == self.hi {
            quick_sum(whole, self.lo.floor())
        } else {
            precise(whole)
        }
    }

    /// Computes the angle of the unit vector (`x`, `y`), radians: that in `f64`, corrected by the sine of its error.
    pub fn angle(y: Self, x: Self) -> Self {
        let near = precise(y.hi.atan2(x.hi));
        let (sine, cosine) = near.sin_cos();
        near + (y * cosine - x * sine)
    }

    /// Converts degrees to radians.
    pub fn to_radians(self) -> Self {
        self * Self::PI / precise(180.0)
    }

    /// Converts radians to degrees.
    pub fn to_degrees(self) -> Self {
        self * precise(180.0) / Self::PI
    }
}

impl From<Precise> for f64 {
    fn from(value: Precise) -> Self {
        value.hi + value.lo
    }
}

operators! {
    Add::add for Precise: |a, b: Precise| {
        let (high, low) = (sum(a.hi, b.hi), sum(a.lo, b.lo));
        let once = quick_sum(high.hi, high.lo + low.hi);
        quick_sum(once.hi, once.lo + low.lo)
    };
    Neg::neg for Precise: |a| Precise { hi: -a.hi, lo: -a.lo };
    Sub::sub for Precise: |a, b: Precise| a + -b;
    Mul::mul for Precise: |a, b: Precise| {
        let high = product(a.hi, b.hi);
        quick_sum(high.hi, high.lo + (a.hi * b.lo + a.lo * b.hi))
    };
    Mul::mul for Precise: |a, factor: f64| a * precise(factor);
    Div::div for Precise: |a, b: Precise| {
        let first = a.hi / b.hi;
        if !first.is_finite() || !b.hi.is_finite() {
            return precise(first);
        }
        let rest = a - b * first;
        let second = rest.hi / b.hi;
        let third = (rest - b * second).hi / b.hi;
        quick_sum(first, second) + precise(third)
    };
    Add::add for Precise3: |a, b: Precise3| Precise3(std::array::from_fn(|k| a.0[k] + b.0[k]));
    Sub::sub for Precise3: |a, b: Precise3| Precise3(std::array::from_fn(|k| a.0[k] - b.0[k]));
    Neg::neg for Precise3: |a| Precise3(a.0.map(|v| -v));
    Mul::mul for Precise3: |a, factor: Precise| Precise3(a.0.map(|v| v * factor));
}

/// A vector of three double-double numbers.
#[derive(Clone, Copy, Debug)]
pub struct Precise3(pub [Precise; 3]);

impl Precise3 {
    pub fn new(v: DVec3) -> Self {
        Self(v.to_array().map(precise))
    }

    pub fn dot(self, other: Self) -> Precise {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub fn length(self) -> Precise {
        self.dot(self).sqrt()
    }

    /// Returns the unit vector; zero stays zero.
    pub fn unit(self) -> Self {
        let length = self.length();
        if length > precise(0.0) {
            self * (precise(1.0) / length)
        } else {
            self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the maximum relative error of `found` against `truth` over a few thousand numbers of all sizes.
    fn worst(found: impl Fn(Precise) -> Precise, truth: impl Fn(Precise) -> Precise) -> f64 {
        let number = |i: i32| {
            (precise(f64::from(i)) + precise(0.37) / precise(7.0)) * 2.0_f64.powi(i % 60 - 30)
        };
        let error = |x: Precise| f64::from((found(x) - truth(x)) / truth(x)).abs();
        (1..3000).map(|i| error(number(i))).fold(0.0, f64::max)
    }

    #[test]
    fn operations_functions_and_vectors_have_thirty_digits() {
        let (one, third) = (precise(1.0), precise(1.0) / precise(3.0));
        assert!(worst(|x| x / third * third, |x| x) < 1e-30);
        assert!(worst(|x| x.sqrt() * x.sqrt(), |x| x) < 1e-30);
        assert!(
            worst(|x| x + third - third, |x| x) < 1e-20,
            "what is small beside 1/3 loses its last digits"
        );
        assert_eq!(precise(6.0) / precise(-3.0), precise(-2.0));
        let small = |x: Precise| x / (x + one) * 3.0;
        assert!(worst(|x| small(x).exp() * (-small(x)).exp(), |_| one) < 1e-29);
        assert!(worst(|x| (x + one).ln().exp(), |x| x + one) < 1e-29);
        let circle = |(sine, cosine): (Precise, Precise)| sine * sine + cosine * cosine;
        assert!(worst(|x| circle(small(x).sin_cos()), |_| one) < 1e-29);
        // e to 32 digits, and the sine of 30 degrees.
        let e = Precise {
            hi: std::f64::consts::E,
            lo: 1.445_646_891_729_250_2e-16,
        };
        assert!(f64::from(one.exp() - e).abs() < 1e-30);
        let (half, _) = precise(30.0).to_radians().sin_cos();
        assert!(f64::from(half - precise(0.5)).abs() < 1e-30);
        let v = Precise3::new(DVec3::new(1e-15, 3e7, -0.2)).unit();
        assert!(f64::from(v.length() - one).abs() < 1e-30);
        assert!(f64::from(v.dot(v.cross(Precise3::new(DVec3::ONE)))).abs() < 1e-30);
        assert_eq!(Precise3::new(DVec3::ZERO).unit().length(), precise(0.0));
    }
}
