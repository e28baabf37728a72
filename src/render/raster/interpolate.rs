//! Interpolation of the normal or the intensity and of the depth key at every covered pixel.
//!
//! Vertices carry four numbers to the pixels: three of a normal or an intensity, and the depth key.
//! For perspective-correct interpolation the three are multiplied by the key (1/depth), which makes them linear in the
//! picture; the kernels that read the fragments divide again where it matters.

use super::cover::{Band, Run, Weights};
use super::fragments::{self, Block, Fragment, join};
use super::grid::{BandExtent, HALF, SUBPIXELS};
use super::scan_line::{Crossing, Outlines, crossing_pair};
use super::triangles::Triangles;
use crate::illumination::{LANES, Lanes};
use fearless_simd::{Level, dispatch, f32x4, prelude::*};
use rayon::prelude::*;

/// The length below which an interpolated normal is mostly rounding: it is not normalised, so that normals that cancel stay
/// near zero.
pub const SHORTEST_NORMAL: f64 = 1e-4;

/// Fills `carried` with the values that each vertex carries, multiplied by its depth key if `by_key`, and that key.
pub fn carry(
    level: Level,
    planes: [&[f32]; 3],
    by_key: bool,
    triangles: &Triangles<'_>,
    carried: &mut Vec<Fragment>,
) {
    const CHUNK: usize = 4096;
    let Triangles {
        placed, clipped, ..
    } = triangles;
    let count = planes[0].len();
    carried.reserve_exact(count.saturating_sub(carried.len()));
    carried.resize(count, [0.0; 4]);
    carried.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, carried)| {
        dispatch!(level, simd => carry_chunk(simd, planes, by_key, &placed.keys, chunk * CHUNK, carried));
    });
    for (cut, key) in clipped.cuts.iter().zip(&placed.keys[carried.len()..]) {
        let factor = if by_key { *key } else { 1.0 };
        let [a, b, c] = planes.map(|plane| {
            let parts = cut.vertices.iter().zip(cut.weights);
            parts
                .map(|(&v, w)| f64::from(plane[v as usize]) * w)
                .sum::<f64>() as f32
                * factor
        });
        carried.push([a, b, c, *key]);
    }
}

#[inline(always)]
fn carry_chunk<S: Simd>(
    simd: S,
    [a, b, c]: [&[f32]; 3],
    by_key: bool,
    keys: &[f32],
    first: usize,
    carried: &mut [Fragment],
) {
    let one = Lanes::splat(simd, 1.0);
    for (start, carried) in (first..)
        .step_by(LANES)
        .zip(carried.chunks_exact_mut(LANES))
    {
        let key = Lanes::load(simd, &keys[start..]);
        let factor = if by_key { key } else { one };
        let (a, b) = (
            Lanes::load(simd, &a[start..]) * factor,
            Lanes::load(simd, &b[start..]) * factor,
        );
        let c = Lanes::load(simd, &c[start..]) * factor;
        join(simd, &[a, b, c, key], carried);
    }
}

/// Linear interpolation over the triangle, of values that are linear there: affine ones, or perspective ones times the key.
struct Barycentric<'a, S: Simd> {
    triangles: Triangles<'a>,
    carried: &'a [Fragment],
    triangle: u32,
    weights: Weights,
    origin: f32x4<S>,
    d1: f32x4<S>,
    d2: f32x4<S>,
}

impl<'a, S: Simd> Barycentric<'a, S> {
    #[inline(always)]
    fn new(simd: S, triangles: Triangles<'a>, carried: &'a [Fragment]) -> Self {
        let zero = f32x4::splat(simd, 0.0);
        let weights = Weights::new([[0, 0], [1, 0], [0, 1]]);
        Self {
            triangles,
            carried,
            triangle: u32::MAX,
            weights,
            origin: zero,
            d1: zero,
            d2: zero,
        }
    }

    #[inline(always)]
    fn take(&mut self, simd: S, triangle: u32) {
        if triangle != self.triangle {
            self.triangle = triangle;
            let [a, b, c] = self.triangles.vertices(triangle);
            self.weights = Weights::new(self.triangles.placed.corners([a, b, c]));
            self.origin = f32x4::simd_from(simd, self.carried[a as usize]);
            self.d1 = f32x4::simd_from(simd, self.carried[b as usize]) - self.origin;
            self.d2 = f32x4::simd_from(simd, self.carried[c as usize]) - self.origin;
        }
    }

    /// Returns the carried values where the second and third vertex have these weights.
    #[inline(always)]
    fn at(&self, simd: S, [w1, w2]: [f32; 2]) -> f32x4<S> {
        self.d1.mul_add(
            f32x4::splat(simd, w1),
            self.d2.mul_add(f32x4::splat(simd, w2), self.origin),
        )
    }
}

/// Linear interpolation along the polygon's edges to P and Q on the scan line, then from P to Q (Gouraud 1971).
struct Span {
    x: [f64; 2],
    values: [[f64; 4]; 2],
}

impl Span {
    fn new([p, q]: [&Crossing; 2], carried: &[Fragment]) -> Self {
        let value = |crossing: &Crossing| {
            let [a, b] = crossing.ends.map(|v| carried[v as usize]);
            [0, 1, 2, 3].map(|k| {
                (1.0 - crossing.alpha) * f64::from(a[k]) + crossing.alpha * f64::from(b[k])
            })
        };
        Self {
            x: [p.x, q.x],
            values: [value(p), value(q)],
        }
    }

    /// Returns the value in column `x`, the step to the next pixel, and the column up to which they hold, at most `end`.
    /// Beside P and Q a pixel has their value, so that none leaves the range between them.
    fn from<S: Simd>(&self, simd: S, x: u16, end: u16) -> (f32x4<S>, f32x4<S>, u16) {
        let ([xp, xq], [p, q]) = (self.x, self.values);
        let pixel = f64::from(SUBPIXELS);
        let centre = f64::from(x) * pixel + f64::from(HALF);
        // A span of zero length has one value, P's.
        let per_unit = if xq > xp { 1.0 / (xq - xp) } else { 0.0 };
        let t = ((centre - xp) * per_unit).clamp(0.0, 1.0);
        let start = [0, 1, 2, 3].map(|k| (p[k] + t * (q[k] - p[k])) as f32);
        let step = [0, 1, 2, 3].map(|k| (per_unit * pixel * (q[k] - p[k])) as f32);
        let inside = centre >= xp;
        let last = if inside {
            ((xq - f64::from(HALF)) / pixel).floor() as i32
        } else {
            0
        };
        let until = last
            .saturating_add(1)
            .clamp(i32::from(x) + 1, i32::from(end)) as u16;
        (
            f32x4::simd_from(simd, start),
            f32x4::simd_from(simd, step),
            until,
        )
    }
}

/// Fills the fragments of a band, rows of `place.width`: linearly over each triangle by a step from one pixel to the next,
/// or along the polygon's edges and then along the scan line. In each row all pixels of the extent are written.
#[inline(always)]
pub fn interpolate<S: Simd>(
    simd: S,
    band: &Band,
    (triangles, carried): (Triangles<'_>, &[Fragment]),
    scanline: bool,
    fragments: &mut [Block],
) {
    open_gaps(band, fragments);
    let BandExtent {
        first_row, width, ..
    } = band.place;
    let count = Block::count(width);
    let line = |run: &Run| usize::from(run.row) * count..(usize::from(run.row) + 1) * count;
    if !scanline {
        let mut rule = Barycentric::new(simd, triangles, carried);
        for run in &band.runs {
            rule.take(simd, run.triangle);
            let [s1, s2] = rule.weights.step;
            let start = rule.at(simd, rule.weights.at(i32::from(run.x0), run.y(first_row)));
            let step = rule.d1.mul_add(s1, rule.d2 * s2);
            fragments::fill(
                simd,
                &mut fragments[line(run)],
                usize::from(run.x0)..usize::from(run.x1),
                start,
                step,
            );
        }
        return;
    }
    let mut outlines = Outlines::new(triangles, band);
    for run in &band.runs {
        let line = &mut fragments[line(run)];
        let crossings = outlines.crossings(run.triangle, run.y(first_row));
        let mut x = run.x0;
        while x < run.x1 {
            let centre = f64::from(i32::from(x) * SUBPIXELS + HALF);
            // A row that shows the polygon crosses its outline.
            let Some(pair) = crossing_pair(crossings, centre) else {
                break;
            };
            let (start, step, end) = Span::new(pair, carried).from(simd, x, run.x1);
            fragments::fill(simd, line, usize::from(x)..usize::from(end), start, step);
            x = end;
        }
    }
}

/// Makes the pixels of the extents gaps where no run may fill them.
#[inline(always)]
fn open_gaps(band: &Band, fragments: &mut [Block]) {
    let count = Block::count(band.place.width);
    for (extent, line) in band
        .extents
        .iter()
        .zip(fragments.chunks_mut(count))
        .filter(|(extent, _)| !extent.is_empty())
    {
        let blocks = Block::over(extent);
        if band.sorted {
            fragments::open(&mut line[blocks]);
        } else {
            // There are no gaps between runs.
            fragments::open(&mut line[blocks.start..=blocks.start]);
            fragments::open(&mut line[blocks.end - 1..blocks.end]);
        }
    }
}
