//! A triangle in, the pixels whose centres it covers out, row by row.
//!
//! ```text
//!   row y      ·    ·  P━━━·━━━━·━━━Q    ·       a centre on the left edge belongs to the triangle,
//!                     ╱            ╲            one on the right edge to its neighbour; likewise the
//!   row y+1    ·    ╱━·━━━━·━━━━·━━━╲    ·       top belongs, the bottom does not
//! ```
//!
//! The crossing of an edge with a row's centre line is a fraction of integers under 2⁵³, rounded once, so its ceiling is
//! exact: two triangles that share an edge agree on it, and no pixel is covered twice or missed.

use super::transform::{HALF, Place, SUBPIXELS};
use std::ops::Range;

/// Twice the signed area of a triangle in fixed point; negative where the corners run counter-clockwise on the screen (y
/// downwards), which is how the outside of a closed model appears.
#[inline(always)]
pub(super) fn doubled_area([a, b, c]: [Place; 3]) -> i64 {
    let e1 = [i64::from(b[0]) - i64::from(a[0]), i64::from(b[1]) - i64::from(a[1])];
    let e2 = [i64::from(c[0]) - i64::from(a[0]), i64::from(c[1]) - i64::from(a[1])];
    e1[0] * e2[1] - e1[1] * e2[0]
}

/// The first pixel whose centre is not before `fixed`.
#[inline(always)]
pub(super) fn first_centre(fixed: i32) -> i32 {
    (fixed - HALF + SUBPIXELS - 1) >> super::transform::SUBPIXEL_BITS
}

/// An edge that runs downwards.
struct Edge {
    /// Crossing at centre line y (fixed point) is `(constant + slope·y)/divisor` pixels, less half a pixel.
    constant: f64,
    slope: f64,
    divisor: f64,
}

impl Edge {
    #[inline(always)]
    fn new(a: Place, b: Place) -> Self {
        let (dx, dy) = (f64::from(b[0]) - f64::from(a[0]), f64::from(b[1]) - f64::from(a[1]));
        Self {
            constant: (f64::from(a[0]) - f64::from(HALF)) * dy - f64::from(a[1]) * dx,
            slope: dx,
            divisor: dy * f64::from(SUBPIXELS),
        }
    }

    /// The first pixel of row `y` whose centre is not left of the edge.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "the guard band bounds it")]
    fn first_right(&self, y: i32) -> i32 {
        let line = f64::from(y * SUBPIXELS + HALF);
        ((self.slope * line + self.constant) / self.divisor).ceil() as i32
    }
}

/// Calls `emit(y, x0, x1)` for each row of `rows` in which the triangle covers the pixels x0..x1 of 0..`width`.
#[inline(always)]
pub(super) fn scan(corners: [Place; 3], rows: Range<i32>, width: i32, mut emit: impl FnMut(i32, i32, i32)) {
    let [top, middle, bottom] = sorted(corners);
    let long = Edge::new(top, bottom);
    let middle_is_right = doubled_area([top, middle, bottom]) > 0;
    for (from, to) in [(top, middle), (middle, bottom)] {
        let mut y = first_centre(from[1]).max(rows.start);
        let end = first_centre(to[1]).min(rows.end);
        if y >= end {
            continue;
        }
        let short = Edge::new(from, to);
        while y < end {
            let (l, s) = (long.first_right(y), short.first_right(y));
            let (x0, x1) = if middle_is_right { (l, s) } else { (s, l) };
            let (x0, x1) = (x0.max(0), x1.min(width));
            if x0 < x1 {
                emit(y, x0, x1);
            }
            y += 1;
        }
    }
}

/// Corners from top to bottom, those of one height from left to right.
#[inline(always)]
fn sorted([a, b, c]: [Place; 3]) -> [Place; 3] {
    let (a, b) = in_order(a, b);
    let (b, c) = in_order(b, c);
    let (a, b) = in_order(a, b);
    [a, b, c]
}

#[inline(always)]
fn in_order(a: Place, b: Place) -> (Place, Place) {
    if (b[1], b[0]) < (a[1], a[0]) { (b, a) } else { (a, b) }
}
