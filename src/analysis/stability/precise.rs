//! Vectors of double-double numbers: 106 bits, the unevaluated sum of two `f64` (T. J. Dekker, *A Floating-Point Technique
//! for Extending the Available Precision*, 1971).

use glam::DVec3;
use std::ops::{Add, Mul, Neg, Sub};
use twofloat::TwoFloat;

/// A vector of three double-double numbers.
#[derive(Clone, Copy, Debug)]
pub struct Precise3(pub [TwoFloat; 3]);

/// A double-double number of an `f64`, exactly.
pub fn precise(value: f64) -> TwoFloat {
    TwoFloat::from(value)
}

impl Precise3 {
    pub fn new(v: DVec3) -> Self {
        Self(v.to_array().map(precise))
    }

    pub fn dot(self, other: Self) -> TwoFloat {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub fn length(self) -> TwoFloat {
        self.dot(self).sqrt()
    }

    /// The unit vector; zero stays zero.
    pub fn unit(self) -> Self {
        let length = self.length();
        if length > precise(0.0) { self * (precise(1.0) / length) } else { self }
    }
}

impl Add for Precise3 {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}

impl Sub for Precise3 {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a - x, b - y, c - z])
    }
}

impl Neg for Precise3 {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|v| -v))
    }
}

impl Mul<TwoFloat> for Precise3 {
    type Output = Self;

    fn mul(self, factor: TwoFloat) -> Self {
        Self(self.0.map(|v| v * factor))
    }
}
