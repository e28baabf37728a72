//! Arithmetic of vectors that glam does not have: side by side in lanes, and angles that are exact where they are small.

use glam::DVec3;
use std::ops::{Add, Mul, Sub};

/// Returns a − b.
#[inline(always)]
pub fn sub<V: Copy + Sub<Output = V>>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Returns a·b, each product rounded, so that it is the same on every machine.
#[inline(always)]
pub fn dot<V: Copy + Add<Output = V> + Mul<Output = V>>(a: [V; 3], b: [V; 3]) -> V {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns a × b.
#[inline(always)]
pub fn cross<V: Copy + Mul<Output = V> + Sub<Output = V>>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [
        a[1] * b[2] - b[1] * a[2],
        a[2] * b[0] - b[2] * a[0],
        a[0] * b[1] - b[0] * a[1],
    ]
}

/// Returns the angle between two vectors, accurate for small ones as well.
pub fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b))
}
