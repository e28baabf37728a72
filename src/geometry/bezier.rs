//! Bicubic Bézier patches.

use glam::{DVec2, DVec3};
use std::ops::{Add, Mul, Sub};

/// The control points of a patch: points of the plane or of space.
pub(crate) trait Point:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<f64, Output = Self>
{
}
impl Point for DVec2 {}
impl Point for DVec3 {}

/// S(u, v) = Σᵢⱼ Bᵢ(u)·Bⱼ(v)·`points[4i + j]` for 0 ≤ u, v ≤ 1, with Bernstein's cubic polynomials B.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch<P> {
    pub points: [P; 16],
}

/// A point of a patch with its partial derivatives.
pub(crate) struct Jet<P> {
    pub point: P,
    pub along_u: P,
    pub along_v: P,
}

/// A parameter, or several in lanes.
pub(crate) trait Parameter:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Mul<f64, Output = Self>
{
}
impl<T> Parameter for T where
    T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Mul<f64, Output = T>
{
}

/// Returns Bernstein's cubic polynomials at `t`; `s` is 1 − `t`.
#[inline(always)]
pub(crate) fn bernstein<T: Parameter>(t: T, s: T) -> [T; 4] {
    [s * s * s, s * 3.0 * s * t, s * 3.0 * t * t, t * t * t]
}

/// Returns the derivatives of Bernstein's cubic polynomials at `t`; `s` is 1 − `t`.
#[inline(always)]
pub(crate) fn bernstein_slopes<T: Parameter>(t: T, s: T) -> [T; 4] {
    [
        s * -3.0 * s,
        s * 3.0 * (s - t * 2.0),
        t * 3.0 * (s * 2.0 - t),
        t * 3.0 * t,
    ]
}

fn blend<P: Point>(points: [P; 4], weights: &[f64; 4]) -> P {
    points[0] * weights[0]
        + points[1] * weights[1]
        + points[2] * weights[2]
        + points[3] * weights[3]
}

/// Returns the point at `t` on the cubic with four control points.
pub(crate) fn on_curve<P: Point>(points: [P; 4], t: f64) -> P {
    blend(points, &bernstein(t, 1.0 - t))
}

/// Cuts a cubic in the middle (de Casteljau).
fn halves<P: Point>([a, b, c, d]: [P; 4]) -> [[P; 4]; 2] {
    let middle = |p: P, q: P| (p + q) * 0.5;
    let (ab, bc, cd) = (middle(a, b), middle(b, c), middle(c, d));
    let (abc, bcd) = (middle(ab, bc), middle(bc, cd));
    let centre = middle(abc, bcd);
    [[a, ab, abc, centre], [centre, bcd, cd, d]]
}

impl<P: Point> Patch<P> {
    pub fn map<Q: Point>(&self, f: impl FnMut(P) -> Q) -> Patch<Q> {
        Patch {
            points: self.points.map(f),
        }
    }

    fn row(&self, i: usize) -> [P; 4] {
        let p = &self.points[4 * i..4 * i + 4];
        [p[0], p[1], p[2], p[3]]
    }

    fn column(&self, j: usize) -> [P; 4] {
        [
            self.points[j],
            self.points[4 + j],
            self.points[8 + j],
            self.points[12 + j],
        ]
    }

    fn weighted(&self, u: &[f64; 4], v: &[f64; 4]) -> P {
        blend([0, 1, 2, 3].map(|i| blend(self.row(i), v)), u)
    }

    pub fn at(&self, u: f64, v: f64) -> P {
        self.weighted(&bernstein(u, 1.0 - u), &bernstein(v, 1.0 - v))
    }

    /// Returns the point at (u, v) with ∂S/∂u and ∂S/∂v.
    pub fn jet(&self, u: f64, v: f64) -> Jet<P> {
        let (bv, dv) = (bernstein(v, 1.0 - v), bernstein_slopes(v, 1.0 - v));
        let rows = [0, 1, 2, 3].map(|i| blend(self.row(i), &bv));
        let row_slopes = [0, 1, 2, 3].map(|i| blend(self.row(i), &dv));
        let bu = bernstein(u, 1.0 - u);
        Jet {
            point: blend(rows, &bu),
            along_u: blend(rows, &bernstein_slopes(u, 1.0 - u)),
            along_v: blend(row_slopes, &bu),
        }
    }

    /// Returns the quarters with u below and above ½, and within each v below and above ½.
    pub fn quarters(&self) -> [Self; 4] {
        let [low, high] = self.halves_in_u();
        let [low_low, low_high] = low.halves_in_v();
        let [high_low, high_high] = high.halves_in_v();
        [low_low, low_high, high_low, high_high]
    }

    /// Returns the halves with u below and above ½.
    pub fn halves_in_u(&self) -> [Self; 2] {
        let (mut low, mut high) = (*self, *self);
        for j in 0..4 {
            let [a, b] = halves(self.column(j));
            for i in 0..4 {
                (low.points[4 * i + j], high.points[4 * i + j]) = (a[i], b[i]);
            }
        }
        [low, high]
    }

    /// Returns the halves with v below and above ½.
    pub fn halves_in_v(&self) -> [Self; 2] {
        let (mut low, mut high) = (*self, *self);
        for i in 0..4 {
            let [a, b] = halves(self.row(i));
            low.points[4 * i..4 * i + 4].copy_from_slice(&a);
            high.points[4 * i..4 * i + 4].copy_from_slice(&b);
        }
        [low, high]
    }
}

impl Patch<DVec3> {
    /// Returns the unit vector along ∂S/∂v × ∂S/∂u at (u, v).
    ///
    /// Where a row of control points has collapsed to a pole, ∂S/∂v vanishes like u·∂²S/∂u∂v, and the normal tends to the
    /// direction of ∂²S/∂u∂v × ∂S/∂u.
    pub fn normal(&self, u: f64, v: f64) -> DVec3 {
        /// The squared length below which the product is only rounding, for patches of a size about 1.
        const VANISHED: f64 = 1e-24;
        let jet = self.jet(u, v);
        let normal = jet.along_v.cross(jet.along_u);
        if normal.length_squared() > VANISHED {
            return normal.normalize();
        }
        let twist = self.weighted(&bernstein_slopes(u, 1.0 - u), &bernstein_slopes(v, 1.0 - v));
        twist.cross(jet.along_u).normalize_or(DVec3::Y)
    }
}
