//! A ray and a Bézier patch.
//!
//! Seen along the ray the patch is a map from (u, v) to the plane, with the ray at the plane's origin; where the map is
//! zero, they meet. The control points, projected too, bound the map and its derivatives. A cell of the patch is
//!
//! - dropped if its control points leave the origin outside their box;
//! - solved by Newton's iteration if its derivatives cannot make the Jacobian vanish, so that it meets the ray once at
//!   most (the mean value theorem, with the derivatives in a regular interval matrix);
//! - quartered otherwise. That happens only about the outline, where the ray grazes, and about a pole.

use crate::geometry::bezier::Patch;
use glam::DVec2;

/// Beyond its edge by so much of its size a cell still meets the ray, so that rounding opens no crack between cells.
const EDGE: f64 = 1e-9;

/// A cell that has been quartered so often is a point: 2⁻²⁴ of a leaf, below 10⁻⁸ of the pot.
const DEEPEST: u32 = 24;

/// Cells looked at before a patch is given up: far beyond what grazing needs, it only bounds the time.
const MOST_CELLS: u32 = 4096;

/// Reports every (u, v) at which a patch, projected along the ray to the plane with the ray at its origin, meets the ray.
pub fn meet(patch: &Patch<DVec2>, mut found: impl FnMut(f64, f64)) {
    let mut search = Search { cells: 0, found: &mut found };
    search.cell(patch, DVec2::ZERO, 1.0, 0);
}

struct Search<'a> {
    cells: u32,
    found: &'a mut dyn FnMut(f64, f64),
}

/// What Newton's iteration came to.
enum Newton {
    Root(DVec2),
    Elsewhere,
    Undecided,
}

impl Search<'_> {
    /// Searches the cell with lowest (u, v) = `corner` and of the given size in the parameters.
    fn cell(&mut self, patch: &Patch<DVec2>, corner: DVec2, size: f64, depth: u32) {
        self.cells += 1;
        if self.cells > MOST_CELLS || !may_hold_origin(patch) {
            return;
        }
        if depth == DEEPEST {
            return self.report(corner + 0.5 * size);
        }
        let outcome = if may_fold(patch) { Newton::Undecided } else { newton(patch) };
        match outcome {
            Newton::Root(uv) => self.report(corner + size * uv),
            Newton::Elsewhere => {}
            Newton::Undecided => {
                let half = 0.5 * size;
                let offsets = [(0.0, 0.0), (0.0, half), (half, 0.0), (half, half)].map(DVec2::from);
                for (quarter, offset) in patch.quarters().iter().zip(offsets) {
                    self.cell(quarter, corner + offset, half, depth + 1);
                }
            }
        }
    }

    fn report(&mut self, uv: DVec2) {
        let uv = uv.clamp(DVec2::ZERO, DVec2::ONE);
        (self.found)(uv.x, uv.y);
    }
}

/// Whether the origin lies in the box round the control points, and so perhaps in the patch.
fn may_hold_origin(patch: &Patch<DVec2>) -> bool {
    let first = patch.points[0];
    let (low, high) = patch.points.iter().fold((first, first), |(low, high), &p| (low.min(p), high.max(p)));
    // Rounding of the projection, which must not lose a ray along the edge of two patches.
    const ROUNDING: f64 = 1e-12;
    low.x <= ROUNDING && low.y <= ROUNDING && high.x >= -ROUNDING && high.y >= -ROUNDING
}

/// Whether the Jacobian may vanish, by the boxes round the differences of the control points in u and in v, which hold
/// the derivatives.
fn may_fold(patch: &Patch<DVec2>) -> bool {
    let p = &patch.points;
    let in_u = bounds((0..12).map(|k| p[k + 4] - p[k]));
    let in_v = bounds((0..16).filter(|k| k % 4 < 3).map(|k| p[k + 1] - p[k]));
    let (low, high) = product((in_u.0.x, in_u.1.x), (in_v.0.y, in_v.1.y));
    let (other_low, other_high) = product((in_u.0.y, in_u.1.y), (in_v.0.x, in_v.1.x));
    low - other_high <= 0.0 && high - other_low >= 0.0
}

fn bounds(vectors: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    vectors.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

/// The product of two intervals.
fn product(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let products = [a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1];
    (products.iter().copied().fold(f64::INFINITY, f64::min), products.iter().copied().fold(f64::NEG_INFINITY, f64::max))
}

/// Newton's iteration from the middle of a cell that cannot fold.
fn newton(patch: &Patch<DVec2>) -> Newton {
    const STEPS: usize = 10;
    /// After a step as short as this the next would be of the order of its square, which is rounding.
    const CONVERGED: f64 = 1e-8;
    /// Farther from the middle than this the bounds on the derivatives tell nothing.
    const STRAYED: f64 = 1.0;
    let mut uv = DVec2::splat(0.5);
    for _ in 0..STEPS {
        let jet = patch.jet(uv.x, uv.y);
        let step = DVec2::new(jet.point.perp_dot(jet.along_v), jet.along_u.perp_dot(jet.point))
            / jet.along_u.perp_dot(jet.along_v);
        uv -= step;
        let distance = (uv - 0.5).abs().max_element();
        if distance.is_nan() || distance > STRAYED {
            return Newton::Undecided;
        }
        if step.abs().max_element() < CONVERGED {
            return if distance <= 0.5 + EDGE { Newton::Root(uv) } else { Newton::Elsewhere };
        }
    }
    Newton::Undecided
}

#[cfg(test)]
mod tests {
    use super::meet;
    use crate::geometry::bezier::Patch;
    use glam::DVec2;

    /// The map (u, v) → (x, y) given at the control points of the polynomials themselves.
    fn patch(map: impl Fn(f64, f64) -> DVec2) -> Patch<DVec2> {
        let mut points = [DVec2::ZERO; 16];
        for (k, point) in points.iter_mut().enumerate() {
            *point = map((k / 4) as f64 / 3.0, (k % 4) as f64 / 3.0);
        }
        Patch { points }
    }

    fn roots(patch: &Patch<DVec2>) -> Vec<DVec2> {
        let mut roots = Vec::new();
        meet(patch, |u, v| roots.push(DVec2::new(u, v)));
        roots.sort_by(|a, b| a.x.total_cmp(&b.x));
        roots.dedup_by(|a, b| a.distance(*b) < 1e-6);
        roots
    }

    #[test]
    fn an_affine_patch_is_met_once_or_not_at_all() {
        let hit = roots(&patch(|u, v| DVec2::new(2.0 * u - 0.6, v - u)));
        assert!(hit.len() == 1 && hit[0].distance(DVec2::new(0.3, 0.3)) < 1e-12);
        assert!(roots(&patch(|u, v| DVec2::new(2.0 * u - 0.6, v - u + 0.5))).is_empty());
    }

    #[test]
    fn a_folded_patch_is_met_twice() {
        // x = (u − ½)² − ¹⁄₁₆ vanishes at u = ¼ and ¾: as a cubic Bézier polynomial, by its blossom.
        let x = [0.1875, -0.145_833_333_333_333_33, -0.145_833_333_333_333_33, 0.1875];
        let folded = patch(|u, v| DVec2::new(x[(3.0 * u).round() as usize], v - 0.4));
        let roots = roots(&folded);
        assert_eq!(roots.len(), 2);
        assert!(roots[0].distance(DVec2::new(0.25, 0.4)) < 1e-12 && roots[1].distance(DVec2::new(0.75, 0.4)) < 1e-12);
    }

    #[test]
    fn a_patch_that_the_ray_runs_in_ends() {
        let mut found = 0;
        meet(&patch(|u, _| DVec2::new(0.0, u - 0.5)), |_, _| found += 1);
        assert!(found < 5000);
    }
}
