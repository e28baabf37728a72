//! Triangulation of polygons that a fan from their first corner would not cover.
//!
//! A polygon is drawn as a fan. A fan covers a convex polygon from any corner; on a concave one it may leave the outline.
//! Such a polygon remains one polygon with its corners in their order, and is covered by other triangles.

use earcut::Earcut;
use glam::DVec3;

/// Returns whether the fan from the first point covers a polygon with this area vector: none of its triangles is turned
/// over by more than `rounding`, the area by which corners on a straight edge may be off.
pub fn fan_covers(points: &[DVec3], area: DVec3, rounding: f64) -> bool {
    let Some((&first, rest)) = points.split_first() else {
        return true;
    };
    let normal = area.normalize_or_zero();
    rest.windows(2)
        .all(|pair| (pair[0] - first).cross(pair[1] - first).dot(normal) >= -2.0 * rounding)
}

/// Returns triangles that cover a polygon with this area vector, as corner numbers. They use every corner and have the
/// polygon's orientation.
pub fn triangles(points: &[DVec3], area: DVec3) -> Vec<[usize; 3]> {
    let coarse = coarse_triangles(points, area);
    let mut used = vec![false; points.len()];
    coarse.iter().flatten().for_each(|&k| used[k] = true);
    let mut fine = Vec::with_capacity(points.len().saturating_sub(2));
    for triangle in coarse {
        let ring = with_straight_corners(triangle, &used);
        let pairs = ring[1..].windows(2);
        fine.extend(pairs.map(|pair| [ring[0], pair[0], pair[1]]));
    }
    fine
}

/// Returns triangles with the polygon's orientation that cover it, seen along its normal. Corners on a straight edge may be
/// left out.
fn coarse_triangles(points: &[DVec3], area: DVec3) -> Vec<[usize; 3]> {
    let (u, v) = area.normalize_or(DVec3::Z).any_orthonormal_pair();
    let flat: Vec<[f64; 2]> = points
        .iter()
        .map(|point| point - points[0])
        .map(|offset| [offset.dot(u), offset.dot(v)])
        .collect();
    let mut corners: Vec<usize> = Vec::new();
    Earcut::new().earcut_slice(&flat, &[], &mut corners);
    let turned = |&[a, b, c]: &[usize; 3]| {
        let turn = (points[b] - points[a])
            .cross(points[c] - points[a])
            .dot(area);
        if turn < 0.0 { [a, c, b] } else { [a, b, c] }
    };
    corners.as_chunks::<3>().0.iter().map(turned).collect()
}

/// Returns the triangle together with the polygon's corners on its edges that no triangle uses, so that the neighbouring
/// polygon still shares them. It begins opposite an edge with such corners, so that a fan from there reaches them.
fn with_straight_corners(mut triangle: [usize; 3], used: &[bool]) -> Vec<usize> {
    let between = |from: usize, to: usize| {
        let after = (1..used.len()).map(move |k| (from + k) % used.len());
        let unused = after.clone().take_while(|&k| !used[k]).count();
        after
            .clone()
            .take(if after.clone().nth(unused) == Some(to) {
                unused
            } else {
                0
            })
    };
    if let Some(k) = (0..3).find(|&k| between(triangle[k], triangle[(k + 1) % 3]).next().is_some())
    {
        triangle.rotate_left((k + 2) % 3);
    }
    let [a, b, c] = triangle;
    [[a, b], [b, c], [c, a]]
        .into_iter()
        .flat_map(|[from, to]| std::iter::once(from).chain(between(from, to)))
        .collect()
}
