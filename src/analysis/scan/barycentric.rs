//! What the scan line's values are compared with: barycentric weights on the triangles that the polygon is drawn as.

use super::data::{Rule, ScanCorner};
use glam::DVec2;

impl Rule {
    /// In words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Affine => "affine",
            Self::Perspective => "perspective-correct",
        }
    }
}

/// Weights over three corners, which add up to 1.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    pub corners: [usize; 3],
    pub affine: [f64; 3],
    /// On the triangle in space: the affine ones over the depths, made to add up to 1 again (Blinn 1992). The depths of an
    /// orthographic picture do not enter.
    pub perspective: [f64; 3],
}

/// Weights at a place of the grid, by the triangle of the fan that holds it; of a place on the border beside all of them by
/// the one that it leaves least. Nothing for a polygon without area.
pub fn weights(corners: &[ScanCorner], place: DVec2, orthographic: bool) -> Option<Weights> {
    let triangles = (1..corners.len().saturating_sub(1)).map(|k| [0, k, k + 1]);
    let weighted =
        triangles.filter_map(|triangle| Some((triangle, affine(triangle.map(|i| corners[i].place), place)?)));
    let least = |weights: &[f64; 3]| weights.iter().copied().fold(f64::INFINITY, f64::min);
    let (corners_of, affine) = weighted.max_by(|a, b| least(&a.1).total_cmp(&least(&b.1)))?;
    let mut perspective = affine;
    if !orthographic {
        let [a, b, c] = [0, 1, 2].map(|i: usize| affine[i] / corners[corners_of[i]].depth);
        perspective = [a, b, c].map(|weight| weight / (a + b + c));
    }
    Some(Weights { corners: corners_of, affine, perspective })
}

fn affine([a, b, c]: [DVec2; 3], place: DVec2) -> Option<[f64; 3]> {
    let area = (b - a).perp_dot(c - a);
    let (w1, w2) = ((place - a).perp_dot(c - a) / area, (b - a).perp_dot(place - a) / area);
    (w1.is_finite() && w2.is_finite()).then_some([1.0 - w1 - w2, w1, w2])
}
