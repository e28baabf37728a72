//! Polygons that a fan from their first corner would not cover.
//!
//! A polygon is drawn as a fan. That covers a convex one from any corner; of a concave one it may leave the outline. Such
//! a polygon begins at a corner from which it does not, if there is one, or else is cut into triangles.

use super::mesh::Corner;
use crate::scene::area_vector;
use earcut::Earcut;
use glam::DVec3;

/// Another first corner is looked for among as many as take this many steps, which is all of them up to some thousand.
const STEPS: usize = 1 << 24;

/// Gives `add` the polygon `face` in a form that fans cover: turned to begin elsewhere, or as triangles.
pub fn fan_or_triangles(
    face: &mut [Corner],
    at: impl Fn(&Corner) -> DVec3,
    mut add: impl FnMut(&[Corner]),
) {
    if face.len() == 3 {
        return add(face);
    }
    let points: Vec<DVec3> = face.iter().map(at).collect();
    let normal = area_vector(points.iter().copied());
    if normal == DVec3::ZERO {
        return add(face);
    }
    let mut firsts = (0..points.len()).take(1 + STEPS / points.len());
    if let Some(first) = firsts.find(|&first| fan_covers(&points, first, normal)) {
        face.rotate_left(first);
        return add(face);
    }
    let triangles = triangles(&points, normal);
    if triangles.is_empty() {
        return add(face);
    }
    let mut used = vec![false; face.len()];
    triangles.iter().flatten().for_each(|&k| used[k] = true);
    for triangle in triangles {
        let ring = with_straight_corners(triangle, &used);
        add(&ring.into_iter().map(|k| face[k]).collect::<Vec<_>>());
    }
}

/// Whether no triangle of the fan from point `first` is turned over.
fn fan_covers(points: &[DVec3], first: usize, normal: DVec3) -> bool {
    /// Corners on a straight edge make triangles without area, whose sign is rounding of single precision coordinates.
    const STRAIGHT: f64 = 1e-6;
    let least = -STRAIGHT * normal.length_squared();
    let rest = points[first + 1..].iter().chain(&points[..first]);
    let pairs = rest.clone().zip(rest.skip(1));
    pairs
        .into_iter()
        .all(|(a, b)| (a - points[first]).cross(b - points[first]).dot(normal) >= least)
}

/// Triangles that cover a polygon seen along its normal, turned as it is. Corners on a straight edge may be left out.
fn triangles(points: &[DVec3], normal: DVec3) -> Vec<[usize; 3]> {
    let (u, v) = normal.normalize_or(DVec3::Z).any_orthonormal_pair();
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
            .dot(normal);
        if turn < 0.0 { [a, c, b] } else { [a, b, c] }
    };
    corners.as_chunks::<3>().0.iter().map(turned).collect()
}

/// The triangle with the polygon's corners on its edges that no triangle uses, so that the polygon next to it still shares
/// them. It begins opposite an edge with such corners: a fan from there reaches them.
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
