//! Three components in any number type.

use super::Real;
use std::ops::{Add, Neg, Sub};

/// A vector of three [`Real`]s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct V3<R> {
    pub x: R,
    pub y: R,
    pub z: R,
}

impl<R> V3<R> {
    #[inline(always)]
    pub const fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }
}

impl<R: Real> V3<R> {
    /// The same vector in every lane of `like`.
    #[inline(always)]
    pub fn constant(like: R, value: [R::Scalar; 3]) -> Self {
        Self::new(like.constant(value[0]), like.constant(value[1]), like.constant(value[2]))
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        self.x.mul_add(other.x, self.y.mul_add(other.y, self.z * other.z))
    }

    #[inline(always)]
    pub fn scale(self, factor: R) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }

    /// `self · factor + other`.
    #[inline(always)]
    pub fn scale_add(self, factor: R, other: Self) -> Self {
        Self::new(self.x.mul_add(factor, other.x), self.y.mul_add(factor, other.y), self.z.mul_add(factor, other.z))
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
