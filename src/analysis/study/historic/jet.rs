//! Numbers that know their derivatives: a function of the picture's x and y up to the second order.
//!
//! A [`Jet`] is a number type of the equation, so that L, f and all that is made of them have their Taylor expansion from the
//! one text of `illumination`.

use crate::illumination::Real;
use std::f64::consts::{LN_2, LOG2_E};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value and its derivatives at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Jet {
    pub v: f64,
    pub x: f64,
    pub y: f64,
    pub xx: f64,
    pub xy: f64,
    pub yy: f64,
}

impl Jet {
    pub fn new(v: f64) -> Self {
        Self { v, ..Self::default() }
    }

    /// A linear function with its value and slopes.
    pub fn linear(v: f64, x: f64, y: f64) -> Self {
        Self { v, x, y, ..Self::default() }
    }

    /// The expansion `dx`, `dy` pixels away.
    pub fn at(&self, dx: f64, dy: f64) -> f64 {
        self.v + self.x * dx + self.y * dy + 0.5 * (self.xx * dx * dx + self.yy * dy * dy) + self.xy * dx * dy
    }

    /// The value there, its difference to the pixel on the right, and the difference of the differences, which is the
    /// same everywhere.
    pub fn differences(&self, dx: f64, dy: f64) -> [f64; 3] {
        [self.at(dx, dy), self.x + self.xx * (dx + 0.5) + self.xy * dy, self.xx]
    }

    /// `f` of it, given f, f′ and f″ at its value.
    fn chain(self, [f, f1, f2]: [f64; 3]) -> Self {
        Self {
            v: f,
            x: f1 * self.x,
            y: f1 * self.y,
            xx: f1 * self.xx + f2 * self.x * self.x,
            xy: f1 * self.xy + f2 * self.x * self.y,
            yy: f1 * self.yy + f2 * self.y * self.y,
        }
    }
}

impl Add for Jet {
    type Output = Self;

    fn add(self, o: Self) -> Self {
        Self {
            v: self.v + o.v,
            x: self.x + o.x,
            y: self.y + o.y,
            xx: self.xx + o.xx,
            xy: self.xy + o.xy,
            yy: self.yy + o.yy,
        }
    }
}

impl Neg for Jet {
    type Output = Self;

    fn neg(self) -> Self {
        self * -1.0
    }
}

impl Sub for Jet {
    type Output = Self;

    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Mul for Jet {
    type Output = Self;

    fn mul(self, o: Self) -> Self {
        Self {
            v: self.v * o.v,
            x: self.x * o.v + self.v * o.x,
            y: self.y * o.v + self.v * o.y,
            xx: self.xx * o.v + 2.0 * self.x * o.x + self.v * o.xx,
            xy: self.xy * o.v + self.x * o.y + self.y * o.x + self.v * o.xy,
            yy: self.yy * o.v + 2.0 * self.y * o.y + self.v * o.yy,
        }
    }
}

impl Mul<f64> for Jet {
    type Output = Self;

    fn mul(self, k: f64) -> Self {
        Self { v: self.v * k, x: self.x * k, y: self.y * k, xx: self.xx * k, xy: self.xy * k, yy: self.yy * k }
    }
}

impl Div for Jet {
    type Output = Self;

    fn div(self, o: Self) -> Self {
        let inverse = 1.0 / o.v;
        self * o.chain([inverse, -inverse * inverse, 2.0 * inverse * inverse * inverse])
    }
}

impl Real for Jet {
    type Scalar = f64;
    type Mask = bool;

    fn constant(self, value: f64) -> Self {
        Self::new(value)
    }

    fn max(self, other: Self) -> Self {
        if other.v > self.v { other } else { self }
    }

    fn min(self, other: Self) -> Self {
        if other.v < self.v { other } else { self }
    }

    fn abs(self) -> Self {
        if self.v < 0.0 { -self } else { self }
    }

    fn floor(self) -> Self {
        Self::new(self.v.floor())
    }

    fn inverse_sqrt(self) -> Self {
        let v = self.v.max(f64::MIN_POSITIVE);
        let root = 1.0 / v.sqrt();
        self.chain([root, -0.5 * root / v, 0.75 * root / v / v])
    }

    fn exp2(self) -> Self {
        let power = self.v.exp2();
        self.chain([power, power * LN_2, power * LN_2 * LN_2])
    }

    fn log2(self) -> Self {
        let slope = LOG2_E / self.v;
        self.chain([self.v.log2(), slope, -slope / self.v])
    }

    fn log2_one_minus(t: Self) -> Self {
        let rest = 1.0 - t.v;
        t.chain([(-t.v).ln_1p() * LOG2_E, -LOG2_E / rest, -LOG2_E / (rest * rest)])
    }

    fn greater_than(self, other: Self) -> bool {
        self.v > other.v
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Every function against its differences.
    #[test]
    fn derivatives_are_those_of_the_functions() {
        type Function = fn(Jet, Jet) -> Jet;
        let functions: [Function; 6] = [
            |x, y| x * y * x - y,
            |x, y| x / (y * y),
            |x, y| (x * x + y).inverse_sqrt(),
            |x, y| (x * y).exp2(),
            |x, y| (x + y * y).log2(),
            |x, y| Jet::log2_one_minus(x * y * 0.1),
        ];
        let (x, y, h) = (0.7, 1.3, 1e-4);
        for (index, function) in functions.into_iter().enumerate() {
            let jet = function(Jet::linear(x, 1.0, 0.0), Jet::linear(y, 0.0, 1.0));
            let f = |dx: f64, dy: f64| function(Jet::new(x + dx), Jet::new(y + dy)).v;
            let expected = [
                f(0.0, 0.0),
                (f(h, 0.0) - f(-h, 0.0)) / (2.0 * h),
                (f(0.0, h) - f(0.0, -h)) / (2.0 * h),
                (f(h, 0.0) + f(-h, 0.0) - 2.0 * f(0.0, 0.0)) / (h * h),
                (f(h, h) + f(-h, -h) - f(h, -h) - f(-h, h)) / (4.0 * h * h),
                (f(0.0, h) + f(0.0, -h) - 2.0 * f(0.0, 0.0)) / (h * h),
            ];
            for (got, expected) in [jet.v, jet.x, jet.y, jet.xx, jet.xy, jet.yy].into_iter().zip(expected) {
                assert!((got - expected).abs() < 1e-6, "function {index}: {got} is not {expected}");
            }
        }
    }

    #[test]
    fn forward_differences_walk_along_the_expansion() {
        let jet = Jet { v: 0.5, x: 0.1, y: -0.2, xx: 0.03, xy: 0.01, yy: -0.02 };
        let [mut value, mut first, second] = jet.differences(-2.5, 1.5);
        for step in 0..6 {
            assert!((value - jet.at(f64::from(step) - 2.5, 1.5)).abs() < 1e-14);
            (value, first) = (value + first, first + second);
        }
    }
}
