//! The picture along a line, between the pixels as well as at them, in double precision.
//!
//! A straight line through the picture meets each triangle in one interval, and the depth key is linear along it; so the
//! counterpart of coverage of a row of pixels is an ordering of intervals:
//!
//! ```text
//!   key        ____/‾‾‾‾          the nearer interval is visible; where two pass
//!      ‾‾‾‾‾‾‾‾___/____           through each other the line changes there
//!   line  ├───────┼──────┤        pieces
//! ```

use super::display::{Linear, display};
use super::frame::Frame;
use super::pipeline::Renderer;
use super::plan::{Inputs, Plan};
use super::reference::Evaluation;
use crate::render::raster::{GridPosition, SUBPIXELS, Triangles, UNPLACED, doubled_area};
use crate::scene::Scene;
use fearless_simd::Level;
use glam::DVec2;

/// The share of the line below which parts of it are roundings.
const LEAST: f64 = 1e-12;

/// A part of a line that shows one triangle: from `from` up to `to`, in units of the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    pub triangle: u32,
    pub face: u32,
    pub from: f64,
    pub to: f64,
}

/// A triangle's interval of the line, and its depth key at 0 and 1.
#[derive(Clone, Copy, Debug)]
struct Interval {
    triangle: u32,
    from: f64,
    to: f64,
    keys: [f64; 2],
}

impl Interval {
    fn key(&self, s: f64) -> f64 {
        self.keys[0] + s * (self.keys[1] - self.keys[0])
    }
}

impl Renderer {
    /// Returns the polygons visible along the line between two points of the last picture, in its order; the true surface has none.
    pub(crate) fn section(&self, from: DVec2, to: DVec2) -> Vec<Piece> {
        let Some(Inputs {
            plan, triangles, ..
        }) = self.last().filter(|last| !last.plan.true_surface)
        else {
            return Vec::new();
        };
        let count = triangles.model.triangles.len() + triangles.clipped.triangles.len();
        let ends = [from, to].map(|end| end * f64::from(SUBPIXELS));
        let meet = |triangle| meet(triangle, &triangles, plan, ends);
        let mut intervals: Vec<Interval> = (0..u32::try_from(count).unwrap_or(u32::MAX))
            .filter_map(meet)
            .collect();
        intervals.sort_by(|a, b| a.from.total_cmp(&b.from).then(a.triangle.cmp(&b.triangle)));
        visible(&intervals, |triangle| triangles.face(triangle))
    }

    /// Returns the evaluation at a point of a section's line, or beside it in the plane of `piece`. The true surface needs
    /// no piece.
    pub(crate) fn evaluation_at(
        &self,
        place: DVec2,
        piece: Option<&Piece>,
    ) -> Option<Evaluation<'_>> {
        let last = self.last()?;
        if last.plan.true_surface {
            return last.of_surface(place);
        }
        Some(last.of_triangle(piece?.triangle, place))
    }
}

/// Returns a linear picture as the display of `scene` stores it.
pub(crate) fn displayed(linear: &[Linear], scene: &Scene) -> Frame {
    let [width, height] = scene.image.size;
    let mut pixels = vec![[0; 4]; linear.len()];
    display(
        Level::new(),
        linear,
        width as usize,
        &scene.display,
        &mut pixels,
    );
    Frame {
        width,
        height,
        pixels,
    }
}

/// Returns twice the area of a point against an edge, positive to its right (y downwards).
fn side(a: GridPosition, b: GridPosition, p: DVec2) -> f64 {
    let [ax, ay, bx, by] = [a[0], a[1], b[0], b[1]].map(f64::from);
    (bx - ax) * (p.y - ay) - (by - ay) * (p.x - ax)
}

/// Intersects the line with a triangle that the plan draws.
fn meet(
    triangle: u32,
    triangles: &Triangles<'_>,
    plan: &Plan,
    ends: [DVec2; 2],
) -> Option<Interval> {
    let (vertices, corners) = (triangles.vertices(triangle), triangles.corners(triangle));
    if corners.iter().any(|corner| corner[0] == UNPLACED) {
        return None;
    }
    let area = doubled_area(corners);
    if area == 0 || (plan.cull && area > 0) {
        return None;
    }
    let inside = if area > 0 { 1.0 } else { -1.0 };
    let (mut from, mut to) = (0.0f64, 1.0f64);
    let mut weights = [[0.0; 3]; 2];
    for (i, weight) in [(0usize, 2usize), (1, 0), (2, 1)] {
        let (a, b) = (corners[i], corners[(i + 1) % 3]);
        // Taken in one order by both neighbours, so that they agree on where the line crosses.
        let (low, high, turned) = if a <= b {
            (a, b, inside)
        } else {
            (b, a, -inside)
        };
        let [e0, e1] = ends.map(|end| side(low, high, end));
        weights[0][weight] = e0 * turned;
        weights[1][weight] = e1 * turned;
        if e0 == 0.0 && e1 == 0.0 {
            // The line runs along the edge: left and top edges belong, as in `span`.
            let across = -f64::from(high[1] - low[1]) * turned;
            let down = f64::from(high[0] - low[0]) * turned;
            if !(across > 0.0 || (across == 0.0 && down > 0.0)) {
                return None;
            }
            continue;
        }
        let crossing = e0 / (e0 - e1);
        match (e0 * turned >= 0.0, e1 * turned >= 0.0) {
            (false, false) => return None,
            (true, false) => to = to.min(crossing),
            (false, true) => from = from.max(crossing),
            (true, true) => {}
        }
    }
    let keys = vertices.map(|v| f64::from(triangles.placed.keys[v as usize]));
    let size = area.unsigned_abs() as f64;
    let keys = weights.map(|w| (w[0] * keys[0] + w[1] * keys[1] + w[2] * keys[2]) / size);
    (to - from > LEAST).then_some(Interval {
        triangle,
        from,
        to,
        keys,
    })
}

/// Orders intervals, sorted by their beginnings, by depth.
fn visible(intervals: &[Interval], face: impl Fn(u32) -> u32) -> Vec<Piece> {
    let mut breaks: Vec<f64> = intervals
        .iter()
        .flat_map(|interval| [interval.from, interval.to])
        .collect();
    breaks.sort_by(f64::total_cmp);
    breaks.dedup_by(|b, a| *b - *a <= LEAST);
    let mut pieces: Vec<Piece> = Vec::new();
    let mut active: Vec<Interval> = Vec::new();
    let mut rest = intervals.iter().peekable();
    for pair in breaks.windows(2) {
        let (mut from, end) = (pair[0], pair[1]);
        let middle = 0.5 * (from + end);
        active.retain(|interval| interval.to > middle);
        while let Some(interval) = rest.next_if(|interval| interval.from < middle) {
            if interval.to > middle {
                active.push(*interval);
            }
        }
        // Each iteration ends at the nearest point where another triangle comes before the visible one.
        while let Some(seen) = nearest(&active, from, end) {
            let to = overtaken(&active, &seen, from, end);
            match pieces.last_mut() {
                Some(last) if last.triangle == seen.triangle && from - last.to <= LEAST => {
                    last.to = to;
                }
                _ => pieces.push(Piece {
                    triangle: seen.triangle,
                    face: face(seen.triangle),
                    from,
                    to,
                }),
            }
            from = to;
            if end - from <= LEAST {
                break;
            }
        }
    }
    pieces
}

/// Returns the interval visible just after `from`.
fn nearest(active: &[Interval], from: f64, end: f64) -> Option<Interval> {
    let just_after = from + 1e-6 * (end - from);
    let order = |a: &&Interval, b: &&Interval| {
        a.key(just_after)
            .total_cmp(&b.key(just_after))
            .then(b.triangle.cmp(&a.triangle))
    };
    active.iter().max_by(order).copied()
}

/// Returns the point where another interval comes before `seen`, at most `end`.
fn overtaken(active: &[Interval], seen: &Interval, from: f64, end: f64) -> f64 {
    let passes = active
        .iter()
        .filter(|other| other.key(end) > seen.key(end))
        .map(|other| {
            let before = seen.key(from) - other.key(from);
            let after = other.key(end) - seen.key(end);
            from + (end - from) * (before / (before + after)).clamp(0.0, 1.0)
        });
    passes
        .filter(|at| at - from > 1e-6 * (end - from))
        .fold(end, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_interval_is_seen_gaps_stay_gaps_and_those_that_pass_through_each_other_change_there()
     {
        let of = |(triangle, from, to, keys)| Interval {
            triangle,
            from,
            to,
            keys,
        };
        let seen = |intervals: &[(u32, f64, f64, [f64; 2])]| -> Vec<(u32, f64, f64)> {
            let intervals: Vec<Interval> = intervals.iter().copied().map(of).collect();
            visible(&intervals, |triangle| triangle)
                .iter()
                .map(|piece| (piece.triangle, piece.from, piece.to))
                .collect()
        };
        let apart = [
            (0, 0.0, 0.5, [1.0, 1.0]),
            (1, 0.25, 0.375, [2.0, 2.0]),
            (2, 0.75, 1.0, [1.0, 1.0]),
        ];
        assert_eq!(
            seen(&apart),
            [
                (0, 0.0, 0.25),
                (1, 0.25, 0.375),
                (0, 0.375, 0.5),
                (2, 0.75, 1.0)
            ]
        );
        let crossing = [(0, 0.0, 1.0, [2.0, 0.0]), (1, 0.0, 1.0, [0.0, 2.0])];
        assert_eq!(seen(&crossing), [(0, 0.0, 0.5), (1, 0.5, 1.0)]);
    }
}
