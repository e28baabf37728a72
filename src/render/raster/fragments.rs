//! Fragments: the four numbers interpolated for each pixel, stored in blocks that SIMD kernels load directly.
//!
//! ```text
//!   row of a picture   │ block 0: 16 pixels             │ block 1                         │ …
//!                      │ a×16 │ b×16 │ c×16 │ key×16    │ a×16 │ …
//! ```
//!
//! A row starts with a block of its own; the part of its last block beyond the picture is never shown.

use crate::illumination::{COUNT, LANES, Lanes};
use fearless_simd::{f32x4, prelude::*};
use std::ops::Range;

/// The three carried numbers and the depth key.
pub type Fragment = [f32; 4];

/// The fragment of a pixel that does not show the object.
pub const GAP: Fragment = [0.0, 0.0, 0.0, f32::MIN];

const KEY: usize = 3;

/// The pixels of a block: as many as the kernels process at once.
const PIXELS: usize = LANES;

/// The length up to which runs are written number by number.
const SHORT: usize = 3;

/// The fragments of adjacent pixels, component by component.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Block {
    planes: [[f32; PIXELS]; 4],
}

impl Block {
    pub const GAP: Self = Self {
        planes: [
            [GAP[0]; PIXELS],
            [GAP[1]; PIXELS],
            [GAP[2]; PIXELS],
            [GAP[KEY]; PIXELS],
        ],
    };

    /// Returns the number of blocks in a row of `width` pixels.
    pub const fn count(width: u32) -> usize {
        (width as usize).div_ceil(PIXELS)
    }

    /// Returns the blocks of a row that contain these columns.
    pub fn over(columns: &Range<u32>) -> Range<usize> {
        if columns.is_empty() {
            0..0
        } else {
            columns.start as usize / PIXELS..Self::count(columns.end)
        }
    }

    #[inline(always)]
    pub fn load<S: Simd>(&self, simd: S) -> [Lanes<S>; 4] {
        let [a, b, c, key] = &self.planes;
        [
            Lanes::load(simd, a),
            Lanes::load(simd, b),
            Lanes::load(simd, c),
            Lanes::load(simd, key),
        ]
    }
}

#[inline(always)]
pub fn fragment(line: &[Block], x: usize) -> Fragment {
    let Block {
        planes: [a, b, c, key],
    } = &line[x / PIXELS];
    let x = x % PIXELS;
    [a[x], b[x], c[x], key[x]]
}

#[inline(always)]
pub fn put(line: &mut [Block], x: usize, fragment: Fragment) {
    for (plane, value) in line[x / PIXELS].planes.iter_mut().zip(fragment) {
        plane[x % PIXELS] = value;
    }
}

#[inline(always)]
pub fn open(blocks: &mut [Block]) {
    // Only the key of a gap is ever read.
    blocks
        .iter_mut()
        .for_each(|block| block.planes[KEY] = Block::GAP.planes[KEY]);
}

/// Returns whether a pixel with this fragment shows the object.
#[inline(always)]
pub fn is_seen(fragment: Fragment) -> bool {
    fragment[KEY] > GAP[KEY]
}

/// Fills the columns of a row with numbers that start at `start` and grow by `step` per pixel.
#[inline(always)]
pub fn fill<S: Simd>(
    simd: S,
    line: &mut [Block],
    columns: Range<usize>,
    start: f32x4<S>,
    step: f32x4<S>,
) {
    let Range { start: x0, end: x1 } = columns;
    if x1 - x0 <= SHORT {
        // A sliver's step may overflow, but it has no second pixel then.
        put(line, x0, start.into());
        let mut k = f32x4::splat(simd, 1.0);
        for x in x0 + 1..x1 {
            put(line, x, step.mul_add(k, start).into());
            k += 1.0;
        }
        return;
    }
    let (starts, steps): (Fragment, Fragment) = (start.into(), step.into());
    let starts = [
        splat(simd, starts[0]),
        splat(simd, starts[1]),
        splat(simd, starts[2]),
        splat(simd, starts[3]),
    ];
    let steps = [
        splat(simd, steps[0]),
        splat(simd, steps[1]),
        splat(simd, steps[2]),
        splat(simd, steps[3]),
    ];
    // In the machine's own vectors, since most runs are short.
    let lanes = <S::f32s as SimdBase<S>>::LEN;
    let count = S::f32s::from_slice(simd, &COUNT[..lanes]);
    // From the vector that contains the first pixel.
    let mut x = x0 / lanes * lanes;
    while x < x1 {
        let k = count + (x as f32 - x0 as f32);
        let planes = &mut line[x / PIXELS].planes;
        let columns = x % PIXELS..x % PIXELS + lanes;
        if x0 <= x && x + lanes <= x1 {
            for ((plane, start), step) in planes.iter_mut().zip(starts).zip(steps) {
                step.mul_add(k, start)
                    .store_slice(&mut plane[columns.clone()]);
            }
        } else {
            let inside = from_lane(simd, x0.saturating_sub(x)) & !from_lane(simd, x1 - x);
            for ((plane, start), step) in planes.iter_mut().zip(starts).zip(steps) {
                let plane = &mut plane[columns.clone()];
                let old: S::u32s = S::f32s::from_slice(simd, plane).bitcast();
                let new: S::u32s = step.mul_add(k, start).bitcast();
                // Not a select, of which the compiler makes a masked store: that is slow on some processors.
                let chosen: S::f32s = (new & inside | old & !inside).bitcast();
                chosen.store_slice(plane);
            }
        }
        x += lanes;
    }
}

/// Zeros, then ones.
const EDGE: [u32; 2 * LANES] = {
    let mut edge = [0; 2 * LANES];
    let mut lane = LANES;
    while lane < 2 * LANES {
        edge[lane] = u32::MAX;
        lane += 1;
    }
    edge
};

/// Returns ones in the lanes from `first` on, and zeros in those before.
#[inline(always)]
fn from_lane<S: Simd>(simd: S, first: usize) -> S::u32s {
    let lanes = <S::u32s as SimdBase<S>>::LEN;
    let start = LANES - first.min(lanes);
    S::u32s::from_slice(simd, &EDGE[start..start + lanes])
}

/// Interleaves the planes of one vector, one for each component, into four numbers per pixel.
#[inline(always)]
pub fn join<S: Simd>(simd: S, planes: &[Lanes<S>; 4], pixels: &mut [[f32; 4]]) {
    let [r, g, b, a] = planes;
    let [r, g, b, a] = [
        r.0.as_slice(),
        g.0.as_slice(),
        b.0.as_slice(),
        a.0.as_slice(),
    ];
    for (quad, start) in pixels.chunks_exact_mut(4).zip((0..).step_by(4)) {
        let vectors = [
            f32x4::from_slice(simd, &r[start..start + 4]),
            f32x4::from_slice(simd, &g[start..start + 4]),
            f32x4::from_slice(simd, &b[start..start + 4]),
            f32x4::from_slice(simd, &a[start..start + 4]),
        ];
        f32x4::store_four_interleaved(vectors, quad.as_flattened_mut());
    }
}

#[inline(always)]
fn splat<S: Simd>(simd: S, value: f32) -> S::f32s {
    S::f32s::simd_from(simd, value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    #[test]
    fn a_run_fills_its_columns_and_no_others() {
        let runs = [
            (0, 1),
            (2, 4),
            (3, 7),
            (5, 21),
            (0, 48),
            (15, 17),
            (16, 32),
            (31, 47),
            (17, 48),
        ];
        for (level, (x0, x1)) in [Level::new(), Level::baseline()]
            .into_iter()
            .flat_map(|l| runs.map(|run| (l, run)))
        {
            let mut line = [Block::GAP; 3];
            // A sliver of one pixel has its start whatever the step.
            let first = if x1 == x0 + 1 { f32::INFINITY } else { 0.5 };
            dispatch!(level, simd => {
                let start = f32x4::simd_from(simd, [1.0, 2.0, 3.0, 4.0]);
                fill(simd, &mut line, x0..x1, start, f32x4::simd_from(simd, [first, -1.0, 0.0, 2.0]));
            });
            for x in 0..48 {
                let k = x as f32 - x0 as f32;
                let inside = [1.0 + 0.5 * k, 2.0 - k, 3.0, 4.0 + 2.0 * k];
                let expected = if (x0..x1).contains(&x) { inside } else { GAP };
                assert_eq!(fragment(&line, x), expected, "{x0}..{x1} at {x}");
            }
            open(&mut line);
            assert!((0..48).all(|x| !is_seen(fragment(&line, x))));
        }
    }
}
