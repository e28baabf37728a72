//! Arithmetic of vectors that glam does not have: side by side in lanes, and angles that are exact where they are small.

use fearless_simd::{Simd, SimdBase};
use glam::DVec3;
use std::ops::{Add, Mul, Sub};

#[inline(always)]
pub fn sub<V: Copy + Sub<Output = V>>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Returns a·b, each product rounded, so that it is the same on every machine.
#[inline(always)]
pub fn dot<V: Copy + Add<Output = V> + Mul<Output = V>>(a: [V; 3], b: [V; 3]) -> V {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
pub fn cross<V: Copy + Mul<Output = V> + Sub<Output = V>>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [
        a[1] * b[2] - b[1] * a[2],
        a[2] * b[0] - b[2] * a[0],
        a[0] * b[1] - b[0] * a[1],
    ]
}

/// Returns `v` in every lane.
#[inline(always)]
pub fn splat<S: Simd, V: SimdBase<S>>(simd: S, v: impl Into<[V::Element; 3]>) -> [V; 3] {
    let [x, y, z] = v.into();
    [V::splat(simd, x), V::splat(simd, y), V::splat(simd, z)]
}

/// Loads the vectors from `first` on, given component by component.
#[inline(always)]
pub fn load<S: Simd, V: SimdBase<S>>(
    simd: S,
    planes: &[impl AsRef<[V::Element]>; 3],
    first: usize,
) -> [V; 3] {
    let [x, y, z] = planes;
    [
        V::from_slice(simd, &x.as_ref()[first..first + V::LEN]),
        V::from_slice(simd, &y.as_ref()[first..first + V::LEN]),
        V::from_slice(simd, &z.as_ref()[first..first + V::LEN]),
    ]
}

/// Returns the angle between two vectors, accurate for small ones as well.
pub fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}
