//! The torus: a quartic in the length along the ray.

use super::polynomial::depressed_quartic;
use super::unit_ray::{Meeting, UnitRay};
use crate::geometry::primitives::sizes::{TORUS_RING, TORUS_TUBE};
use glam::DVec3;

/// The surface is (|p|² + R² − r²)² = 4R²(x² + z²). With p = o + s·d, |d| = 1 and o·d = 0, |p|² is |o|² + s², and the
/// cubic term of the quartic in s vanishes.
pub fn torus(ray: &UnitRay) -> Option<Meeting> {
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
    Some(Meeting { s, normal: point - ring })
}

/// Widens the search so that rounding at its ends loses no root.
const MARGIN: f64 = 1e-9;
