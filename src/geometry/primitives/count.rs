//! The number of triangles of a tessellation, and the tessellation with about a given number.

use crate::geometry::sizes::{CYLINDER, TORUS_RING, TORUS_TUBE};
use crate::scene::{Object, ObjectKind};
use std::f64::consts::TAU;

/// Returns the number of triangles of a built-in shape without making them; 0 for a model from a file or a scene's own polygons.
pub fn triangles(object: &Object) -> u64 {
    triangle_count(object.kind, object.segments, object.rings)
}

/// Returns the segments and rings by which a shape has as nearly as possible `wanted` triangles whose polygons are about as
/// wide as high: at most one row of polygons too many or too few, within an object's limits.
pub fn divisions_for(kind: ObjectKind, wanted: u64) -> [u32; 2] {
    let least = Object {
        kind,
        ..Object::default()
    };
    let [min_segments, min_rings] = [least.min_segments(), least.min_rings()];
    let beside = |rings: u32| {
        let segments = (f64::from(rings) * segments_per_ring(kind)).round();
        (segments as u32).clamp(min_segments, Object::MAX_DIVISIONS)
    };
    let rings = first(min_rings, |rings| {
        triangle_count(kind, beside(rings), rings) >= wanted
    });
    // The two rows on either side of the wanted number, each with the segments that come nearest to it.
    let candidates = [rings.saturating_sub(1).max(min_rings), rings]
        .into_iter()
        .flat_map(|rings| {
            let segments = first(min_segments, |segments| {
                triangle_count(kind, segments, rings) >= wanted
            });
            [
                [segments.saturating_sub(1).max(min_segments), rings],
                [segments, rings],
            ]
        });
    let off = |[segments, rings]: &[u32; 2]| {
        (
            triangle_count(kind, *segments, *rings).abs_diff(wanted),
            segments.abs_diff(beside(*rings)),
        )
    };
    candidates
        .min_by_key(off)
        .unwrap_or([min_segments, min_rings])
}

/// Returns the smallest number from `least` on for which `holds`, which must hold for all larger ones; the largest number
/// if there is none.
fn first(least: u32, holds: impl Fn(u32) -> bool) -> u32 {
    let (mut low, mut high) = (least, Object::MAX_DIVISIONS);
    while low < high {
        let middle = low.midpoint(high);
        if holds(middle) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}

/// Returns the number of polygons round the axis for each one along it, where they are about as wide as high.
fn segments_per_ring(kind: ObjectKind) -> f64 {
    match kind {
        ObjectKind::Torus => TORUS_RING / TORUS_TUBE,
        ObjectKind::Cylinder => TAU * CYLINDER.bottom / (CYLINDER.high - CYLINDER.low),
        ObjectKind::Sphere | ObjectKind::Cone => 2.0,
        // Counted round all four sides.
        ObjectKind::Cube => 4.0,
        ObjectKind::Plane
        | ObjectKind::Teapot
        | ObjectKind::Corrugated
        | ObjectKind::Balls
        | ObjectKind::Obj
        | ObjectKind::Polygons => 1.0,
    }
}

fn triangle_count(kind: ObjectKind, segments: u32, rings: u32) -> u64 {
    let limited = |number: u32, least: u32| u64::from(number.clamp(least, Object::MAX_DIVISIONS));
    let (s, r) = (limited(segments, 3), limited(rings, 1));
    match kind {
        ObjectKind::Sphere => 2 * s * (r.max(2) - 1),
        ObjectKind::Torus => 2 * s * r.max(3),
        ObjectKind::Cylinder => 2 * s * r + 2 * (s - 2),
        ObjectKind::Cone => s * (2 * r - 1) + (s - 2),
        ObjectKind::Cube => {
            let n = (s / 4).max(1);
            8 * n * r + 4 * n * n
        }
        ObjectKind::Plane => 2 * limited(segments, 1) * r,
        ObjectKind::Teapot => {
            let (round, along) = ((s / 4).max(1), (r / 4).max(1));
            // 24 patches of the body, lid and rim, 8 of which run into a pole, and 8 of the handle and the spout.
            2 * along * (24 * round + 8 * round.max(2)) - 8 * round
        }
        ObjectKind::Corrugated => 2 * limited(segments, 2) * r,
        ObjectKind::Balls => 3 * (2 * 16 * 7),
        ObjectKind::Obj | ObjectKind::Polygons => 0,
    }
}
