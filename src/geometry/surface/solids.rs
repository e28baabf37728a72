//! The sphere, cylinder, cone, cube and plane in closed form.
//!
//! A convex solid is the common part of simpler ones, and a ray passes through each of those in an interval. The common
//! part of the intervals is where it is inside; its two ends are the meetings. So neighbouring parts of the surface, a
//! side and its cap, leave no crack between them.

use super::unit_ray::{Meeting, UnitRay};
use crate::geometry::primitives::sizes::{
    CONE_APEX, CONE_BASE, CONE_RADIUS, CUBE_HALF_EDGE, CYLINDER_HALF_HEIGHT, CYLINDER_RADIUS,
};
use glam::DVec3;

/// The part of a ray inside a convex solid, with the face met at either end.
struct Inside<F> {
    enter: (f64, F),
    leave: (f64, F),
}

impl<F: Copy> Inside<F> {
    fn and(self, other: Self) -> Self {
        Self {
            enter: if other.enter.0 > self.enter.0 { other.enter } else { self.enter },
            leave: if other.leave.0 < self.leave.0 { other.leave } else { self.leave },
        }
    }

    /// The first end beyond the ray's beginning.
    fn meeting(&self, ray: &UnitRay, normal: impl Fn(F, DVec3) -> DVec3) -> Option<Meeting> {
        if self.enter.0 > self.leave.0 {
            return None;
        }
        let (s, face) = [self.enter, self.leave].into_iter().find(|end| end.0 > ray.s_min && end.0.is_finite())?;
        Some(Meeting { s, normal: normal(face, ray.at(s)) })
    }
}

/// The part of a ray with `low` ≤ `position` + s·`speed` ≤ `high`; the faces are named for `low` and `high`.
fn slab<F>(position: f64, speed: f64, low: (f64, F), high: (f64, F)) -> Option<Inside<F>> {
    if speed == 0.0 {
        let inside = low.0 <= position && position <= high.0;
        return inside.then_some(Inside { enter: (f64::NEG_INFINITY, low.1), leave: (f64::INFINITY, high.1) });
    }
    let at = |bound: f64| (bound - position) / speed;
    let (s_low, s_high) = ((at(low.0), low.1), (at(high.0), high.1));
    Some(if speed > 0.0 { Inside { enter: s_low, leave: s_high } } else { Inside { enter: s_high, leave: s_low } })
}

/// The roots of a·s² + 2b·s + c, unordered, without the loss of digits that the school formula has when b² ≫ ac (Press
/// et al., Numerical Recipes, 5.6). A root that does not exist because a is zero is infinite. With a < 0 there are roots
/// for every ray at a cone, so a negative discriminant is rounding and taken as zero.
fn quadratic(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let discriminant = b * b - a * c;
    if discriminant < 0.0 && a > 0.0 {
        return None;
    }
    let q = -(b + discriminant.max(0.0).sqrt().copysign(b));
    if q == 0.0 { Some((0.0, 0.0)) } else { Some((q / a, c / q)) }
}

pub fn sphere(ray: &UnitRay) -> Option<Meeting> {
    let half_chord = (1.0 - ray.origin.length_squared()).sqrt();
    let s = [-half_chord, half_chord].into_iter().find(|s| *s > ray.s_min)?;
    Some(Meeting { s, normal: ray.at(s) })
}

pub fn plane(ray: &UnitRay) -> Option<Meeting> {
    let s = -ray.origin.z / ray.direction.z;
    let point = ray.at(s);
    (s > ray.s_min && point.x.abs() <= 1.0 && point.y.abs() <= 1.0).then_some(Meeting { s, normal: DVec3::Z })
}

pub fn cube(ray: &UnitRay) -> Option<Meeting> {
    let along = |axis: DVec3| {
        let (position, speed) = (ray.origin.dot(axis), ray.direction.dot(axis));
        slab(position, speed, (-CUBE_HALF_EDGE, -axis), (CUBE_HALF_EDGE, axis))
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

pub fn cylinder(ray: &UnitRay) -> Option<Meeting> {
    let (p, d) = (ray.origin, ray.direction);
    let a = d.x * d.x + d.z * d.z;
    let b = p.x * d.x + p.z * d.z;
    let c = p.x * p.x + p.z * p.z - CYLINDER_RADIUS * CYLINDER_RADIUS;
    let round = if a == 0.0 {
        (c <= 0.0).then_some((f64::NEG_INFINITY, f64::INFINITY))?
    } else {
        let (s0, s1) = quadratic(a, b, c)?;
        (s0.min(s1), s0.max(s1))
    };
    let side = Inside { enter: (round.0, Part::Side), leave: (round.1, Part::Side) };
    let height = slab(p.y, d.y, (-CYLINDER_HALF_HEIGHT, Part::Bottom), (CYLINDER_HALF_HEIGHT, Part::Top))?;
    side.and(height).meeting(ray, |part, point| match part {
        Part::Side => DVec3::new(point.x, 0.0, point.z),
        Part::Top => DVec3::Y,
        Part::Bottom => DVec3::NEG_Y,
    })
}

/// The side is x² + z² = k²·(1 − y)² with k the slope; that is a double cone, whose upper half touches y ≤ 1 in the apex
/// only.
pub fn cone(ray: &UnitRay) -> Option<Meeting> {
    const SLOPE: f64 = CONE_RADIUS / (CONE_APEX - CONE_BASE);
    let (p, d) = (ray.origin, ray.direction);
    let depth = CONE_APEX - p.y;
    let a = d.x * d.x + d.z * d.z - SLOPE * SLOPE * d.y * d.y;
    let b = p.x * d.x + p.z * d.z + SLOPE * SLOPE * depth * d.y;
    let c = p.x * p.x + p.z * p.z - SLOPE * SLOPE * depth * depth;
    let (s0, s1) = quadratic(a, b, c)?;
    let (low, high) = (s0.min(s1), s0.max(s1));
    let side = if a > 0.0 {
        (low, high)
    } else if d.y < 0.0 {
        // Steeper than the side: inside the upper half before the first root, inside the lower after the last finite one.
        (if high.is_finite() { high } else { low }, f64::INFINITY)
    } else {
        (f64::NEG_INFINITY, if low.is_finite() { low } else { high })
    };
    let side = Inside { enter: (side.0, Part::Side), leave: (side.1, Part::Side) };
    let height = slab(p.y, d.y, (CONE_BASE, Part::Bottom), (CONE_APEX, Part::Top))?;
    side.and(height).meeting(ray, |part, point| match part {
        Part::Side => {
            let radial = point.x.hypot(point.z);
            DVec3::new(point.x, SLOPE * radial, point.z)
        }
        Part::Top => DVec3::Y,
        Part::Bottom => DVec3::NEG_Y,
    })
}
