//! The intersection of a ray with a Bézier patch.
//!
//! Seen along the ray the patch is a map from (u, v) to the plane, with the ray at the plane's origin; where the map is
//! zero, they meet. The control points, projected too, bound the map and its derivatives. A cell of the patch is
//!
//! - dropped if its control points leave the origin outside their box;
//! - solved by Newton's iteration if its derivatives cannot make the Jacobian vanish, so that it meets the ray once at
//!   most (the mean value theorem, with the derivatives in a regular interval matrix);
//! - halved otherwise, across its larger extent in the plane. That happens only near the outline, where the ray grazes, and
//!   near a pole, where it separates rings: halving round the pole would separate nothing.

use crate::geometry::bezier::Patch;
use glam::DVec2;

/// The part of its size by which a ray may pass a cell's edge and still meet it, so that rounding opens no crack between cells.
pub const EDGE: f64 = 1e-9;

/// The extent in the plane, in world units, up to which a cell counts as a point.
const POINT: f64 = 1e-11;

/// The most cells examined for a patch: far more than grazing needs, it only bounds the time.
const MOST_CELLS: u32 = 4096;

/// Reports every (u, v) at which a patch, projected along the ray to the plane with the ray at its origin, meets the ray.
pub fn meet(patch: &Patch<DVec2>, mut found: impl FnMut(f64, f64)) {
    let mut search = Search {
        cells: 0,
        found: &mut found,
    };
    search.cell(patch, DVec2::ZERO, DVec2::ONE);
}

struct Search<'a> {
    cells: u32,
    found: &'a mut dyn FnMut(f64, f64),
}

enum Newton {
    Root(DVec2),
    Elsewhere,
    Undecided,
}

impl Search<'_> {
    /// Searches the cell with lowest (u, v) = `corner` and of the given size in the parameters.
    fn cell(&mut self, patch: &Patch<DVec2>, corner: DVec2, size: DVec2) {
        self.cells += 1;
        let (low, high) = bounds(patch.points.into_iter());
        if self.cells > MOST_CELLS || !holds_origin(low, high) {
            return;
        }
        if (high - low).max_element() <= POINT {
            return self.report(corner + 0.5 * size);
        }
        let slopes = Slopes::of(patch);
        let outcome = if slopes.may_fold() {
            Newton::Undecided
        } else {
            newton(patch)
        };
        match outcome {
            Newton::Root(uv) => self.report(corner + size * uv),
            Newton::Elsewhere => {}
            Newton::Undecided => {
                let (axis, parts) = if slopes.u_is_longer() {
                    (DVec2::X, patch.halves_in_u())
                } else {
                    (DVec2::Y, patch.halves_in_v())
                };
                let half = size - 0.5 * size * axis;
                self.cell(&parts[0], corner, half);
                self.cell(&parts[1], corner + half * axis, half);
            }
        }
    }

    fn report(&mut self, uv: DVec2) {
        let uv = uv.clamp(DVec2::ZERO, DVec2::ONE);
        (self.found)(uv.x, uv.y);
    }
}

/// Returns whether the origin lies in the box round the control points, and so perhaps in the patch.
fn holds_origin(low: DVec2, high: DVec2) -> bool {
    /// The rounding of the projection, which must not lose a ray along the edge of two patches.
    const ROUNDING: f64 = 1e-12;
    low.max_element() <= ROUNDING && high.min_element() >= -ROUNDING
}

/// Boxes round the differences of the control points in u and in v: three times these hold the derivatives.
struct Slopes {
    in_u: (DVec2, DVec2),
    in_v: (DVec2, DVec2),
}

impl Slopes {
    fn of(patch: &Patch<DVec2>) -> Self {
        let p = &patch.points;
        Self {
            in_u: bounds((0..12).map(|k| p[k + 4] - p[k])),
            in_v: bounds((0..16).filter(|k| k % 4 < 3).map(|k| p[k + 1] - p[k])),
        }
    }

    fn may_fold(&self) -> bool {
        let (u, v) = (&self.in_u, &self.in_v);
        let (low, high) = product((u.0.x, u.1.x), (v.0.y, v.1.y));
        let (other_low, other_high) = product((u.0.y, u.1.y), (v.0.x, v.1.x));
        low - other_high <= 0.0 && high - other_low >= 0.0
    }

    fn u_is_longer(&self) -> bool {
        let extent = |bounds: &(DVec2, DVec2)| bounds.0.abs().max(bounds.1.abs()).max_element();
        extent(&self.in_u) >= extent(&self.in_v)
    }
}

fn bounds(vectors: impl Iterator<Item = DVec2>) -> (DVec2, DVec2) {
    vectors.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), v| {
        (low.min(v), high.max(v))
    })
}

fn product(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let products = [a.0 * b.0, a.0 * b.1, a.1 * b.0, a.1 * b.1];
    (
        products.iter().copied().fold(f64::INFINITY, f64::min),
        products.iter().copied().fold(f64::NEG_INFINITY, f64::max),
    )
}

/// Runs Newton's iteration from the middle of a cell that cannot fold.
fn newton(patch: &Patch<DVec2>) -> Newton {
    const STEPS: usize = 10;
    /// The step after which the next would be of the order of its square, which is rounding.
    const CONVERGED: f64 = 1e-8;
    /// The distance from the middle beyond which the bounds on the derivatives say nothing.
    const STRAYED: f64 = 1.0;
    let mut uv = DVec2::splat(0.5);
    for _ in 0..STEPS {
        let jet = patch.jet(uv.x, uv.y);
        let step = DVec2::new(
            jet.point.perp_dot(jet.along_v),
            jet.along_u.perp_dot(jet.point),
        ) / jet.along_u.perp_dot(jet.along_v);
        uv -= step;
        let distance = (uv - 0.5).abs().max_element();
        // Also false where the step is not a number.
        let near = distance <= STRAYED;
        if !near {
            return Newton::Undecided;
        }
        if step.abs().max_element() < CONVERGED {
            return if distance <= 0.5 + EDGE {
                Newton::Root(uv)
            } else {
                Newton::Elsewhere
            };
        }
    }
    Newton::Undecided
}

#[cfg(test)]
mod tests {
    use super::meet;
    use crate::geometry::bezier::Patch;
    use glam::DVec2;
    use std::array;

    #[test]
    fn a_patch_that_the_ray_runs_in_ends() {
        let points = array::from_fn(|k| DVec2::new(0.0, (k / 4) as f64 / 3.0 - 0.5));
        let mut found = 0;
        meet(&Patch { points }, |_, _| found += 1);
        assert!(found < 5000);
    }
}
