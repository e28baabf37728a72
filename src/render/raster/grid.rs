//! The fixed-point grid of positions in a picture, its bands of rows, and the pixels whose centres a triangle covers, row by row.
//!
//! ```text
//!   row y      ·    ·  P━━━·━━━━·━━━Q    ·       a centre on the left edge belongs to the triangle,
//!                     ╱            ╲            one on the right edge to its neighbour; likewise the
//!   row y+1    ·    ╱━·━━━━·━━━━·━━━╲    ·       top belongs, the bottom does not
//! ```
//!
//! The crossing of an edge with a row's centre line is a fraction of integers under 2⁵³, rounded once, so its ceiling is
//! exact: two triangles that share an edge agree on it, and no pixel is covered twice or missed.

use std::ops::Range;

/// The fractional bits of a position in the picture.
pub const SUBPIXEL_BITS: u32 = 8;
/// One pixel in fixed point.
pub const SUBPIXELS: i32 = 1 << SUBPIXEL_BITS;
/// Half a pixel in fixed point: the offset of a pixel's centre.
pub const HALF: i32 = SUBPIXELS / 2;

/// The guard band: positions reach this many pixels from the picture's corner. With 8 fractional bits they have 23 bits and
/// their products 47, so that `f64` carries the arithmetic of coverage exactly.
pub const GUARD: f64 = 32_000.0;

/// The x of a vertex without a position.
pub const UNPLACED: i32 = i32::MIN;

/// A position in fixed-point pixel coordinates, y downwards.
pub type GridPosition = [i32; 2];

/// Returns twice the signed area of a triangle in fixed point; negative where the corners run counter-clockwise on the
/// screen (y downwards), as on the outside of a closed model.
#[inline(always)]
pub fn doubled_area([a, b, c]: [GridPosition; 3]) -> i64 {
    let e1 = [
        i64::from(b[0]) - i64::from(a[0]),
        i64::from(b[1]) - i64::from(a[1]),
    ];
    let e2 = [
        i64::from(c[0]) - i64::from(a[0]),
        i64::from(c[1]) - i64::from(a[1]),
    ];
    e1[0] * e2[1] - e1[1] * e2[0]
}

/// Returns the first pixel whose centre is not before `fixed`.
#[inline(always)]
pub fn first_centre(fixed: i32) -> i32 {
    (fixed - HALF + SUBPIXELS - 1) >> SUBPIXEL_BITS
}

/// The rows of a band: its fragments, 16 bytes per pixel, stay in a core's own cache.
pub const BAND: u32 = 16;

#[derive(Clone, Copy, Default)]
pub struct BandExtent {
    pub first_row: u32,
    pub rows: u32,
    pub width: u32,
}

impl BandExtent {
    pub fn row_range(self) -> Range<i32> {
        self.first_row as i32..(self.first_row + self.rows) as i32
    }
}

/// An edge that runs downwards.
struct Edge {
    /// The constant of the crossing: at centre line y (fixed point) it is `(constant + slope·y)/divisor` pixels, less half a pixel.
    constant: f64,
    slope: f64,
    divisor: f64,
}

impl Edge {
    #[inline(always)]
    fn new(a: GridPosition, b: GridPosition) -> Self {
        let (dx, dy) = (
            f64::from(b[0]) - f64::from(a[0]),
            f64::from(b[1]) - f64::from(a[1]),
        );
        Self {
            constant: (f64::from(a[0]) - f64::from(HALF)) * dy - f64::from(a[1]) * dx,
            slope: dx,
            divisor: dy * f64::from(SUBPIXELS),
        }
    }

    /// Returns the first pixel of row `y` whose centre is not left of the edge.
    #[inline(always)]
    fn first_right(&self, y: i32) -> i32 {
        let line = f64::from(y * SUBPIXELS + HALF);
        ((self.slope * line + self.constant) / self.divisor).ceil() as i32
    }
}

/// Calls `emit(y, x0, x1)` for each row of `rows` in which the triangle covers the pixels x0..x1 of 0..`width`.
#[inline(always)]
pub fn scan(
    corners: [GridPosition; 3],
    rows: Range<i32>,
    width: i32,
    mut emit: impl FnMut(i32, i32, i32),
) {
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

/// Returns the corners from top to bottom, those of one height from left to right.
#[inline(always)]
fn sorted([a, b, c]: [GridPosition; 3]) -> [GridPosition; 3] {
    let (a, b) = in_order(a, b);
    let (b, c) = in_order(b, c);
    let (a, b) = in_order(a, b);
    [a, b, c]
}

#[inline(always)]
fn in_order(a: GridPosition, b: GridPosition) -> (GridPosition, GridPosition) {
    if (b[1], b[0]) < (a[1], a[0]) {
        (b, a)
    } else {
        (a, b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::properties;
    use proptest::prelude::*;

    /// Counts how often each pixel of a square picture is covered.
    fn counts(triangles: &[[GridPosition; 3]], side: i32) -> Vec<u32> {
        let mut counts = vec![0; (side * side) as usize];
        for triangle in triangles {
            scan(*triangle, 0..side, side, |y, x0, x1| {
                counts[(y * side + x0) as usize..(y * side + x1) as usize]
                    .iter_mut()
                    .for_each(|c| *c += 1);
            });
        }
        counts
    }

    #[test]
    fn centres_on_left_and_top_edges_belong_to_the_triangle() {
        // Corners at pixel centres: the left and the top edge run exactly through centres.
        let at = |x: i32, y: i32| [x * SUBPIXELS + HALF, y * SUBPIXELS + HALF];
        let covered = counts(&[[at(1, 1), at(5, 1), at(1, 5)]], 7);
        let art: String = covered
            .iter()
            .map(|count| if *count > 0 { '#' } else { '.' })
            .collect();
        assert_eq!(
            art,
            ".......".to_owned()
                + ".####.."
                + ".###..."
                + ".##...."
                + ".#....."
                + "......."
                + "......."
        );
        let between = counts(&[[[130, 130], [380, 130], [255, 380]]], 4);
        assert!(
            between.iter().all(|&count| count == 0),
            "a triangle between centres covers nothing"
        );
    }

    proptest! {
        #![proptest_config(properties::config(file!()))]

        /// Checks that a fan about any inner point covers each pixel of a rectangle exactly once.
        #[test]
        fn a_fan_covers_every_pixel_once(
            hub in (1..16_i32 * 256, 1..16_i32 * 256),
            rim in prop::collection::vec(0..16_i32 * 256, 0..12),
        ) {
            let side = 16 * SUBPIXELS;
            let mut border: Vec<GridPosition> = vec![[0, 0], [side, 0], [side, side], [0, side]];
            for (i, &t) in rim.iter().enumerate() {
                border.push([[t, 0], [side, t], [t, side], [0, t]][i % 4]);
            }
            let angle = |p: &GridPosition| f64::from(p[1] - hub.1).atan2(f64::from(p[0] - hub.0));
            border.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
            let triangles: Vec<_> = (0..border.len())
                .map(|i| [[hub.0, hub.1], border[i], border[(i + 1) % border.len()]])
                .collect();
            let covered = counts(&triangles, 16);
            prop_assert!(covered.iter().all(|&c| c == 1), "{:?}", covered);
        }

        /// Checks that the triangles of a strip of points, however it is joined, neither overlap nor leave gaps.
        #[test]
        fn a_grid_of_any_points_covers_every_pixel_once(moves in prop::collection::vec((-500..500_i32, -500..500_i32), 9), turns in prop::collection::vec(any::<bool>(), 16)) {
            let cell = 4 * SUBPIXELS;
            let place = |i: usize, j: usize| -> GridPosition {
                let inner = (1..4).contains(&i) && (1..4).contains(&j);
                let (dx, dy) = if inner { moves[(j - 1) * 3 + i - 1] } else { (0, 0) };
                [i as i32 * cell + dx, j as i32 * cell + dy]
            };
            let mut triangles = Vec::new();
            for j in 0..4 {
                for i in 0..4 {
                    let [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
                    if turns[j * 4 + i] { triangles.extend([[a, b, c], [a, c, d]]) } else { triangles.extend([[a, b, d], [b, c, d]]) }
                }
            }
            // Moves under half a cell keep every triangle's orientation in nearly all draws; the others are not a grid.
            prop_assume!(triangles.iter().all(|t| doubled_area(*t) > 0));
            let covered = counts(&triangles, 16);
            prop_assert!(covered.iter().all(|&c| c == 1), "{:?}", covered);
        }
    }
}
