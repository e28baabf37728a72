//! Polygons that a fan from their first corner would not cover.
//!
//! A polygon is drawn as a fan. That covers a convex one from any corner; of a concave one it may leave the outline. Such
//! a polygon begins at a corner from which it does not, if there is one, or else is cut into triangles, ear by ear.

use super::Corner;
use crate::scene::area_vector;
use glam::DVec3;

/// Ears are looked for in polygons of at most so many corners, as that takes the cube of their number; larger ones that
/// no fan covers stay as they are.
const MOST_CORNERS: usize = 256;

/// Gives `add` the polygon `face` in a form that fans cover: turned to begin elsewhere, or as triangles.
pub fn fan_or_triangles(face: &mut [Corner], at: impl Fn(&Corner) -> DVec3, mut add: impl FnMut(&[Corner])) {
    if face.len() == 3 {
        return add(face);
    }
    let mut points: Vec<DVec3> = face.iter().map(at).collect();
    let normal = area_vector(points.iter().copied());
    if fan_covers(&points, normal) || normal == DVec3::ZERO || points.len() > MOST_CORNERS {
        return add(face);
    }
    for _ in 1..points.len() {
        points.rotate_left(1);
        face.rotate_left(1);
        if fan_covers(&points, normal) {
            return add(face);
        }
    }
    let mut corners: Vec<(Corner, DVec3)> = face.iter().copied().zip(points).collect();
    while corners.len() > 3 {
        let ear = (0..corners.len()).find(|&k| is_ear(&corners, k, normal)).unwrap_or(1);
        let [before, after] = neighbours(corners.len(), ear);
        add(&[corners[before].0, corners[ear].0, corners[after].0]);
        corners.remove(ear);
    }
    add(&[corners[0].0, corners[1].0, corners[2].0]);
}

/// Whether no triangle of the fan from the first point is turned over.
fn fan_covers(points: &[DVec3], normal: DVec3) -> bool {
    /// Corners on a straight edge make triangles without area, whose sign is rounding of single precision coordinates.
    const STRAIGHT: f64 = 1e-6;
    let least = -STRAIGHT * normal.length_squared();
    points[1..].windows(2).all(|pair| (pair[0] - points[0]).cross(pair[1] - points[0]).dot(normal) >= least)
}

fn neighbours(count: usize, k: usize) -> [usize; 2] {
    [(k + count - 1) % count, (k + 1) % count]
}

/// Whether the triangle of corner k and its neighbours lies in the polygon: it is not turned over, and no other corner is
/// inside it.
fn is_ear(corners: &[(Corner, DVec3)], k: usize, normal: DVec3) -> bool {
    let [before, after] = neighbours(corners.len(), k);
    let [a, b, c] = [before, k, after].map(|k| corners[k].1);
    let side = |p: DVec3, q: DVec3, r: DVec3| (q - p).cross(r - p).dot(normal);
    side(a, b, c) > 0.0
        && corners.iter().enumerate().all(|(other, &(_, p))| {
            let corner_itself = [before, k, after].contains(&other) || p == a || p == b || p == c;
            corner_itself || side(a, b, p) < 0.0 || side(b, c, p) < 0.0 || side(c, a, p) < 0.0
        })
}
