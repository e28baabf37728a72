//! Numbers with their derivatives: a function of the picture's x and y up to the second order.
//!
//! A [`Jet`] is a number type of the equation, so that L, f and everything computed from them have their Taylor
//! expansion from the one code of `illumination`.

use crate::analysis::operators::operators;
use crate::illumination::Real;
use glam::{DVec2, DVec3};
use std::f64::consts::{LN_2, LOG2_E};

/// A value and its derivatives at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Jet {
    pub value: f64,
    /// First derivatives, ∂/∂x and ∂/∂y.
    pub slope: DVec2,
    /// Second derivatives, ∂²/∂x², ∂²/∂x∂y and ∂²/∂y².
    pub curve: DVec3,
}

impl Jet {
    /// Creates a linear function with its value and slopes.
    pub fn linear(value: f64, x: f64, y: f64) -> Self {
        Self {
            value,
            slope: DVec2::new(x, y),
            curve: DVec3::ZERO,
        }
    }

    /// Returns the value `offset` pixels away, its difference to the pixel on the right, and the constant second
    /// difference.
    pub fn differences(&self, offset: DVec2) -> [f64; 3] {
        let [dx, dy] = offset.to_array();
        let DVec3 {
            x: xx,
            y: xy,
            z: yy,
        } = self.curve;
        let value = self.value
            + self.slope.dot(offset)
            + 0.5 * (xx * dx * dx + yy * dy * dy)
            + xy * dx * dy;
        [value, self.slope.x + xx * (dx + 0.5) + xy * dy, xx]
    }

    /// Applies `f` by the chain rule, given f, f′ and f″ at its value.
    fn chain(self, [f, f1, f2]: [f64; 3]) -> Self {
        let curve = self.curve * f1 + crossed(self.slope, self.slope) * (0.5 * f2);
        Self {
            value: f,
            slope: self.slope * f1,
            curve,
        }
    }
}

/// Returns the contribution of two factors' slopes to the second derivatives of their product.
fn crossed(a: DVec2, b: DVec2) -> DVec3 {
    DVec3::new(2.0 * a.x * b.x, a.x * b.y + a.y * b.x, 2.0 * a.y * b.y)
}

operators! {
    Add::add for Jet: |a, b: Jet| Jet { value: a.value + b.value, slope: a.slope + b.slope, curve: a.curve + b.curve };
    Neg::neg for Jet: |a| a * -1.0;
    Sub::sub for Jet: |a, b: Jet| a + -b;
    Mul::mul for Jet: |a, b: Jet| Jet {
        value: a.value * b.value,
        slope: a.slope * b.value + b.slope * a.value,
        curve: a.curve * b.value + crossed(a.slope, b.slope) + b.curve * a.value,
    };
    Mul::mul for Jet: |a, k: f64| Jet { value: a.value * k, slope: a.slope * k, curve: a.curve * k };
    Div::div for Jet: |a, b: Jet| {
        let inverse = 1.0 / b.value;
        a * b.chain([inverse, -inverse * inverse, 2.0 * inverse * inverse * inverse])
    };
}

impl Real for Jet {
    type Scalar = f64;
    type Mask = bool;

    fn constant(self, value: f64) -> Self {
        Self {
            value,
            ..Self::default()
        }
    }

    fn max(self, other: Self) -> Self {
        if other.value > self.value {
            other
        } else {
            self
        }
    }

    fn min(self, other: Self) -> Self {
        if other.value < self.value {
            other
        } else {
            self
        }
    }

    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }

    fn floor(self) -> Self {
        self.constant(self.value.floor())
    }

    fn inverse_sqrt(self) -> Self {
        let v = self.value.max(f64::MIN_POSITIVE);
        let root = 1.0 / v.sqrt();
        self.chain([root, -0.5 * root / v, 0.75 * root / v / v])
    }

    fn exp2(self) -> Self {
        let power = self.value.exp2();
        self.chain([power, power * LN_2, power * LN_2 * LN_2])
    }

    fn log2(self) -> Self {
        let slope = LOG2_E / self.value;
        self.chain([self.value.log2(), slope, -slope / self.value])
    }

    fn log2_one_minus(t: Self) -> Self {
        let rest = 1.0 - t.value;
        t.chain([
            (-t.value).ln_1p() * LOG2_E,
            -LOG2_E / rest,
            -LOG2_E / (rest * rest),
        ])
    }

    fn greater_than(self, other: Self) -> bool {
        self.value > other.value
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

    /// Compares the derivatives of every function with its differences.
    #[test]
    fn derivatives_are_those_of_the_functions() {
        let functions: [fn(Jet, Jet) -> Jet; 6] = [
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
            let f = |dx: f64, dy: f64| {
                function(Jet::linear(x + dx, 0.0, 0.0), Jet::linear(y + dy, 0.0, 0.0)).value
            };
            let slope = DVec2::new(f(h, 0.0) - f(-h, 0.0), f(0.0, h) - f(0.0, -h)) / (2.0 * h);
            let xx = f(h, 0.0) + f(-h, 0.0) - 2.0 * f(0.0, 0.0);
            let xy = (f(h, h) + f(-h, -h) - f(h, -h) - f(-h, h)) / 4.0;
            let yy = f(0.0, h) + f(0.0, -h) - 2.0 * f(0.0, 0.0);
            let expected = Jet {
                value: f(0.0, 0.0),
                slope,
                curve: DVec3::new(xx, xy, yy) / (h * h),
            };
            let off = jet - expected;
            let errors = [
                off.value.abs(),
                off.slope.abs().max_element(),
                off.curve.abs().max_element(),
            ];
            assert!(
                errors.iter().all(|error| *error < 1e-6),
                "function {index}: {jet:?} is not {expected:?}"
            );
        }
    }

    #[test]
    fn forward_differences_walk_along_the_expansion() {
        let jet = Jet {
            value: 0.5,
            slope: DVec2::new(0.1, -0.2),
            curve: DVec3::new(0.03, 0.01, -0.02),
        };
        let [mut value, mut first, second] = jet.differences(DVec2::new(-2.5, 1.5));
        for step in 0..6 {
            let [there, ..] = jet.differences(DVec2::new(f64::from(step) - 2.5, 1.5));
            assert!((value - there).abs() < 1e-14);
            (value, first) = (value + first, first + second);
        }
    }
}
