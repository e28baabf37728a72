//! How many triangles a tessellation has, and which tessellation has about so many.

use crate::scene::{Object, ObjectKind};
use std::f64::consts::TAU;

/// Triangles of a built-in shape, without making them; none of a model from a file or of a scene's own polygons.
pub fn triangles(object: &Object) -> u64 {
    of(object.kind, object.segments, object.rings)
}

/// Segments and rings by which a shape has as nearly as possible `wanted` triangles whose polygons are about as wide as
/// high: at most one row of polygons too many or too few, within what an object may have.
pub fn divisions_for(kind: ObjectKind, wanted: u64) -> [u32; 2] {
    let least = Object { kind, ..Object::default() };
    let [min_segments, min_rings] = [least.min_segments(), least.min_rings()];
    let beside = |rings: u32| {
        let segments = (f64::from(rings) * segments_per_ring(kind)).round();
        (segments as u32).clamp(min_segments, Object::MAX_DIVISIONS)
    };
    let rings = first(min_rings, |rings| of(kind, beside(rings), rings) >= wanted);
    // Of the two rows on either side of the wanted number, with the segments that come nearest to it.
    let candidates = [rings.saturating_sub(1).max(min_rings), rings].into_iter().flat_map(|rings| {
        let segments = first(min_segments, |segments| of(kind, segments, rings) >= wanted);
        [[segments.saturating_sub(1).max(min_segments), rings], [segments, rings]]
    });
    let off = |[segments, rings]: &[u32; 2]| {
        (of(kind, *segments, *rings).abs_diff(wanted), segments.abs_diff(beside(*rings)))
    };
    candidates.min_by_key(off).unwrap_or([min_segments, min_rings])
}

/// The least number from `least` on for which `holds`, which does for all greater ones; the greatest there is if none.
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

/// How many polygons there are round the axis to one along it, where they are about as wide as high.
fn segments_per_ring(kind: ObjectKind) -> f64 {
    match kind {
        ObjectKind::Torus => super::TORUS_RING / super::TORUS_TUBE,
        ObjectKind::Cylinder => TAU * super::CYLINDER_RADIUS / (2.0 * super::CYLINDER_HALF_HEIGHT),
        ObjectKind::Sphere | ObjectKind::Cone => 2.0,
        // Counted round all four sides.
        ObjectKind::Cube => 4.0,
        ObjectKind::Plane | ObjectKind::Teapot | ObjectKind::Corrugated | ObjectKind::Obj | ObjectKind::Polygons => 1.0,
    }
}

fn of(kind: ObjectKind, segments: u32, rings: u32) -> u64 {
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
        ObjectKind::Obj | ObjectKind::Polygons => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::tessellate;

    const KINDS: [ObjectKind; 8] = [
        ObjectKind::Sphere,
        ObjectKind::Torus,
        ObjectKind::Cylinder,
        ObjectKind::Cone,
        ObjectKind::Cube,
        ObjectKind::Plane,
        ObjectKind::Teapot,
        ObjectKind::Corrugated,
    ];

    #[test]
    fn triangles_are_counted_as_they_are_made() {
        for kind in KINDS {
            for segments in [1, 3, 4, 7, 8, 12, 33] {
                for rings in [1, 2, 3, 5, 8, 13] {
                    let object = Object { kind, segments, rings, ..Object::default() };
                    let made = tessellate(&object).triangle_count() as u64;
                    assert_eq!(triangles(&object), made, "{kind:?} {segments} × {rings}");
                }
            }
        }
    }

    #[test]
    fn any_number_of_triangles_comes_near() {
        for kind in KINDS {
            let smallest = divisions_for(kind, 0);
            let least = of(kind, smallest[0], smallest[1]);
            let mut before = 0;
            for step in 0..400 {
                let wanted = (1.05_f64.powi(step) as u64).max(least);
                if wanted > 20_000_000 {
                    break;
                }
                let [segments, rings] = divisions_for(kind, wanted);
                let object = Object { kind, segments, rings, ..Object::default() };
                let found = triangles(&object);
                // Half a row, or four of them where only every fourth division counts.
                let row = if matches!(kind, ObjectKind::Cube | ObjectKind::Teapot) { 16.0 } else { 2.0 };
                let slack = row * (wanted as f64).sqrt() + 64.0;
                assert!(found.abs_diff(wanted) as f64 <= slack, "{kind:?}: {found} for {wanted}");
                assert!(found >= before, "{kind:?}: {found} after {before}");
                before = found;
                let scene = crate::scene::Scene { object, ..crate::scene::Scene::default() };
                assert_eq!(scene.validate(), Ok(()));
            }
        }
        assert_eq!(divisions_for(ObjectKind::Sphere, 0), [3, 2]);
        assert_eq!(divisions_for(ObjectKind::Sphere, u64::MAX), [Object::MAX_DIVISIONS; 2]);
    }
}
