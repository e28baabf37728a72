//! The shapes whose surface a ray meets in closed form, and the torus, whose meetings are the roots of a quartic.
//!
//! A convex solid is the intersection of simpler ones, and a ray passes through each of those in an interval. The ray is
//! inside the solid in the intersection of the intervals; its two ends are the meetings. So neighbouring parts of the
//! surface, a side and its cap, leave no crack between them.

use super::polynomial::depressed_quartic;
use crate::geometry::sizes::{
    CORRUGATED_HALF_HEIGHT, CORRUGATED_HALF_WIDTH, CORRUGATED_RIDGE, CUBE_HALF_EDGE, Frustum,
    TORUS_RING, TORUS_TUBE, corrugated_normal, corrugated_point,
};
use glam::DVec3;

/// A ray in the shapes' form: unit direction, origin nearest to the world's origin, `s` the length along it.
#[derive(Clone, Copy, Debug, Default)]
pub struct UnitRay {
    pub origin: DVec3,
    pub direction: DVec3,
    /// The length beyond which points count.
    pub s_min: f64,
}

/// A meeting with a shape: the length along the [`UnitRay`], and the normal, not yet of unit length.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    pub s: f64,
    pub normal: DVec3,
}

impl UnitRay {
    pub fn at(&self, s: f64) -> DVec3 {
        self.origin + s * self.direction
    }
}

/// The part of a ray inside a convex solid, with the face met at either end.
struct Inside<F> {
    enter: (f64, F),
    leave: (f64, F),
}

impl<F: Copy> Inside<F> {
    fn and(self, other: Self) -> Self {
        Self {
            enter: if other.enter.0 > self.enter.0 {
                other.enter
            } else {
                self.enter
            },
            leave: if other.leave.0 < self.leave.0 {
                other.leave
            } else {
                self.leave
            },
        }
    }

    /// Returns the first end beyond the ray's start.
    fn meeting(&self, ray: &UnitRay, normal: impl Fn(F, DVec3) -> DVec3) -> Option<Meeting> {
        if self.enter.0 > self.leave.0 {
            return None;
        }
        let (s, face) = [self.enter, self.leave]
            .into_iter()
            .find(|end| end.0 > ray.s_min && end.0.is_finite())?;
        Some(Meeting {
            s,
            normal: normal(face, ray.at(s)),
        })
    }
}

/// Returns the part of a ray with `low` ≤ `position` + s·`speed` ≤ `high`; the faces are named for `low` and `high`.
fn slab<F>(position: f64, speed: f64, low: (f64, F), high: (f64, F)) -> Option<Inside<F>> {
    if speed == 0.0 {
        let inside = low.0 <= position && position <= high.0;
        return inside.then_some(Inside {
            enter: (f64::NEG_INFINITY, low.1),
            leave: (f64::INFINITY, high.1),
        });
    }
    let at = |bound: f64| (bound - position) / speed;
    let (s_low, s_high) = ((at(low.0), low.1), (at(high.0), high.1));
    Some(if speed > 0.0 {
        Inside {
            enter: s_low,
            leave: s_high,
        }
    } else {
        Inside {
            enter: s_high,
            leave: s_low,
        }
    })
}

/// Returns the roots of a·s² + 2b·s + c, unordered, without the loss of digits of the school formula when b² ≫ ac (Press et
/// al., Numerical Recipes, 5.6).
///
/// A root that does not exist because a is zero is infinite. With a < 0 every ray at a cone has roots, so a negative
/// discriminant is rounding and taken as zero.
fn quadratic(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let discriminant = b * b - a * c;
    if discriminant < 0.0 && a > 0.0 {
        return None;
    }
    let q = -(b + discriminant.max(0.0).sqrt().copysign(b));
    if q == 0.0 {
        Some((0.0, 0.0))
    } else {
        Some((q / a, c / q))
    }
}

pub fn sphere(ray: &UnitRay) -> Option<Meeting> {
    let half_chord = (1.0 - ray.origin.length_squared()).sqrt();
    let s = [-half_chord, half_chord]
        .into_iter()
        .find(|s| *s > ray.s_min)?;
    Some(Meeting {
        s,
        normal: ray.at(s),
    })
}

pub fn plane(ray: &UnitRay) -> Option<Meeting> {
    let s = -ray.origin.z / ray.direction.z;
    let point = ray.at(s);
    (s > ray.s_min && point.x.abs() <= 1.0 && point.y.abs() <= 1.0).then_some(Meeting {
        s,
        normal: DVec3::Z,
    })
}

pub fn cube(ray: &UnitRay) -> Option<Meeting> {
    let along = |axis: DVec3| {
        let (position, speed) = (ray.origin.dot(axis), ray.direction.dot(axis));
        slab(
            position,
            speed,
            (-CUBE_HALF_EDGE, -axis),
            (CUBE_HALF_EDGE, axis),
        )
    };
    let inside = along(DVec3::X)?.and(along(DVec3::Y)?).and(along(DVec3::Z)?);
    inside.meeting(ray, |normal, _| normal)
}

#[derive(Clone, Copy)]
enum Part {
    Side,
    Top,
    Bottom,
}

/// Intersects a ray with a cylinder or a cone. The side is x² + z² = ρ² with a radius ρ that is linear in y; that of a cone
/// is a double cone, whose upper half touches the solid's height in the apex only.
pub fn frustum(shape: &Frustum, ray: &UnitRay) -> Option<Meeting> {
    let (p, d, slope) = (ray.origin, ray.direction, shape.slope());
    let radius = shape.top + slope * (shape.high - p.y);
    let a = d.x * d.x + d.z * d.z - slope * slope * d.y * d.y;
    let b = p.x * d.x + p.z * d.z + slope * radius * d.y;
    let c = p.x * p.x + p.z * p.z - radius * radius;
    let side = if a == 0.0 && slope == 0.0 {
        (c <= 0.0).then_some((f64::NEG_INFINITY, f64::INFINITY))?
    } else {
        let (s0, s1) = quadratic(a, b, c)?;
        let (low, high) = (s0.min(s1), s0.max(s1));
        if a > 0.0 {
            (low, high)
        } else if d.y < 0.0 {
            // Steeper than the side: inside the upper half before the first root, inside the lower after the last finite one.
            (if high.is_finite() { high } else { low }, f64::INFINITY)
        } else {
            (f64::NEG_INFINITY, if low.is_finite() { low } else { high })
        }
    };
    let side = Inside {
        enter: (side.0, Part::Side),
        leave: (side.1, Part::Side),
    };
    let height = slab(p.y, d.y, (shape.low, Part::Bottom), (shape.high, Part::Top))?;
    side.and(height).meeting(ray, |part, point| match part {
        Part::Side => DVec3::new(point.x, slope * point.x.hypot(point.z), point.z),
        Part::Top => DVec3::Y,
        Part::Bottom => DVec3::NEG_Y,
    })
}

/// Intersects a ray with the torus, whose surface is (|p|² + R² − r²)² = 4R²(x² + z²). With p = o + s·d, |d| = 1 and o·d =
/// 0, |p|² is |o|² + s², and the cubic term of the quartic in s vanishes.
pub fn torus(ray: &UnitRay) -> Option<Meeting> {
    /// The widening of the search, so that rounding at its ends loses no root.
    const MARGIN: f64 = 1e-9;
    const FOUR_RING_SQUARED: f64 = 4.0 * TORUS_RING * TORUS_RING;
    let (p, d) = (ray.origin, ray.direction);
    if p.length_squared() > 1.0 {
        return None;
    }
    // The torus lies in the unit sphere and between two planes; only there are roots worth the search.
    let half_chord = (1.0 - p.length_squared()).sqrt() + MARGIN;
    let (mut low, mut high) = (-half_chord, half_chord);
    if d.y != 0.0 {
        let middle = -p.y / d.y;
        let reach = TORUS_TUBE / d.y.abs() + MARGIN;
        (low, high) = (low.max(middle - reach), high.min(middle + reach));
    }
    if low >= high {
        return None;
    }
    let k = p.length_squared() + TORUS_RING * TORUS_RING - TORUS_TUBE * TORUS_TUBE;
    let c2 = 2.0 * k - FOUR_RING_SQUARED * (d.x * d.x + d.z * d.z);
    let c1 = -2.0 * FOUR_RING_SQUARED * (p.x * d.x + p.z * d.z);
    let c0 = k * k - FOUR_RING_SQUARED * (p.x * p.x + p.z * p.z);
    let roots = depressed_quartic(c2, c1, c0, low, high);
    let s = *roots.as_slice().iter().find(|s| **s > ray.s_min)?;
    let point = ray.at(s);
    let ring = DVec3::new(point.x, 0.0, point.z).normalize_or_zero() * TORUS_RING;
    Some(Meeting {
        s,
        normal: point - ring,
    })
}

/// Intersects a ray with the corrugated sheet, following it from slope to slope. Over each slope the ray's height above the
/// sheet is linear in s, and where the height changes sign the ray meets the slope. Over a ridge both neighbours use the
/// same height, so that no ray slips between them.
pub fn corrugated(ray: &UnitRay, slopes: u32) -> Option<Meeting> {
    /// The factor by which rays begin before the ridges and end behind the troughs, so that those are met.
    const WIDER: f64 = 1.0 + 1e-9;
    let (p, d) = (ray.origin, ray.direction);
    let part =
        |position: f64, speed: f64, bound: f64| slab(position, speed, (-bound, ()), (bound, ()));
    let sheet = part(p.x, d.x, CORRUGATED_HALF_WIDTH)?.and(part(p.y, d.y, CORRUGATED_HALF_HEIGHT)?);
    let inside = sheet.and(part(p.z, d.z, CORRUGATED_RIDGE * WIDER)?);
    let (mut s, end) = (inside.enter.0.max(ray.s_min), inside.leave.0);
    if s > end {
        return None;
    }
    let width = 2.0 * CORRUGATED_HALF_WIDTH / f64::from(slopes);
    let slope_at = |s: f64| {
        let slope = ((ray.at(s).x + CORRUGATED_HALF_WIDTH) / width).floor();
        slope.clamp(0.0, f64::from(slopes - 1)) as u32
    };
    let height = |s: f64, slope: u32| {
        let point = ray.at(s);
        let t = (point.x + CORRUGATED_HALF_WIDTH) / width - f64::from(slope);
        point.z - corrugated_point(slopes, slope, t).y
    };
    let mut slope = slope_at(s);
    let mut above = height(s, slope);
    loop {
        let next = if d.x > 0.0 { slope + 1 } else { slope };
        let border = if d.x == 0.0 {
            end
        } else {
            (corrugated_point(slopes, next, 0.0).x - p.x) / d.x
        };
        let last = border >= end || next == 0 || next == slopes;
        let until = if last { end } else { border.max(s) };
        let above_then = height(until, slope);
        if (above > 0.0) != (above_then > 0.0) {
            let met = s + (until - s) * (above / (above - above_then));
            if met > ray.s_min {
                return Some(Meeting {
                    s: met,
                    normal: corrugated_normal(slopes, slope),
                });
            }
        }
        if last {
            return None;
        }
        slope = if d.x > 0.0 { slope + 1 } else { slope - 1 };
        (s, above) = (until, above_then);
    }
}
