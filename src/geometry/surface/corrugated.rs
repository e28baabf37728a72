//! The corrugated sheet: planes met one after the other.

use super::unit_ray::{Meeting, UnitRay};
use crate::geometry::primitives::corrugated::{bend, normal};
use crate::geometry::primitives::sizes::{CORRUGATED_HALF_HEIGHT, CORRUGATED_HALF_WIDTH, CORRUGATED_RIDGE};

/// Follows the ray from slope to slope. Over each, its height above the sheet is linear in s, and where that changes its
/// sign the ray meets the slope. Over a ridge both neighbours use the same height, so that no ray slips between them.
pub fn corrugated(ray: &UnitRay, slopes: u32) -> Option<Meeting> {
    let (p, d) = (ray.origin, ray.direction);
    let mut reach = (ray.s_min, f64::INFINITY);
    for (position, speed, bound) in
        [(p.x, d.x, CORRUGATED_HALF_WIDTH), (p.y, d.y, CORRUGATED_HALF_HEIGHT), (p.z, d.z, CORRUGATED_RIDGE * WIDER)]
    {
        reach = within(reach, position, speed, bound)?;
    }
    let (mut s, end) = reach;
    let width = 2.0 * CORRUGATED_HALF_WIDTH / f64::from(slopes);
    let slope_at = |s: f64| {
        let slope = ((ray.at(s).x + CORRUGATED_HALF_WIDTH) / width).floor();
        slope.clamp(0.0, f64::from(slopes - 1)) as u32
    };
    let height = |s: f64, slope: u32| {
        let point = ray.at(s);
        let t = (point.x + CORRUGATED_HALF_WIDTH) / width - f64::from(slope);
        point.z - bend(slopes, slope, t).y
    };
    let mut slope = slope_at(s);
    let mut above = height(s, slope);
    loop {
        let next = if d.x > 0.0 { slope + 1 } else { slope };
        let border = if d.x == 0.0 { end } else { (bend(slopes, next, 0.0).x - p.x) / d.x };
        let last = border >= end || next == 0 || next == slopes;
        let until = if last { end } else { border.max(s) };
        let above_then = height(until, slope);
        if (above > 0.0) != (above_then > 0.0) {
            let met = s + (until - s) * (above / (above - above_then));
            if met > ray.s_min {
                return Some(Meeting { s: met, normal: normal(slopes, slope) });
            }
        }
        if last {
            return None;
        }
        slope = if d.x > 0.0 { slope + 1 } else { slope - 1 };
        (s, above) = (until, above_then);
    }
}

/// Lets rays begin before the ridges and end behind the troughs, so that those are met.
const WIDER: f64 = 1.0 + 1e-9;

/// The part of `reach` in which −bound ≤ position + s·speed ≤ bound.
fn within(reach: (f64, f64), position: f64, speed: f64, bound: f64) -> Option<(f64, f64)> {
    if speed == 0.0 {
        return (position.abs() <= bound).then_some(reach);
    }
    let (a, b) = ((-bound - position) / speed, (bound - position) / speed);
    let (low, high) = (reach.0.max(a.min(b)), reach.1.min(a.max(b)));
    (low <= high).then_some((low, high))
}
