//! Interpolates the normal or the intensity and the depth key at every covered pixel.
//!
//! What is carried from the vertices to the pixels is four numbers: three of a normal or an intensity, and the depth key.
//! For perspective-correct interpolation the three are multiplied by the key (1/depth), which makes them linear in the
//! picture; the kernels that read the fragments divide again where it matters.

use super::cover::{Band, Run, Weights};
use super::fragments::{self, Block, Fragment, join};
use super::grid::{BandPlace, HALF, SUBPIXELS};
use super::scan_line::{Crossing, Outlines, crossing_pair};
use super::triangles::Triangles;
use crate::illumination::Lanes;
use fearless_simd::{Level, dispatch, f32x4, prelude::*};
use rayon::prelude::*;

/// An interpolated normal shorter than this has no direction: its rounding is 10⁻³ of it and more. It is not lengthened to 1,
/// so that normals which cancel out stay near zero.
pub const SHORTEST_NORMAL: f64 = 1e-4;

/// What the vertices are to carry.
#[derive(Clone, Copy)]
pub struct CarriedValues<'a> {
    /// One plane a component.
    pub planes: [&'a [f32]; 3],
    /// Whether they carry them multiplied by the depth key.
    pub by_key: bool,
}

impl CarriedValues<'_> {
    /// Fills `carried` with what each vertex carries, and its depth key.
    pub fn carry(&self, level: Level, carried: &mut Vec<Fragment>, triangles: &Triangles<'_>) {
        let Triangles { placed, clipped, .. } = triangles;
        const CHUNK: usize = 4096;
        let count = self.planes[0].len();
        carried.reserve_exact(count.saturating_sub(carried.len()));
        carried.resize(count, [0.0; 4]);
        carried.par_chunks_mut(CHUNK).enumerate().for_each(|(chunk, carried)| {
            dispatch!(level, simd => self.carry_chunk(simd, chunk * CHUNK, carried, &placed.keys));
        });
        for (cut, key) in clipped.cuts.iter().zip(&placed.keys[carried.len()..]) {
            let factor = if self.by_key { *key } else { 1.0 };
            let [a, b, c] = self.planes.map(|plane| {
                let parts = cut.vertices.iter().zip(cut.weights);
                parts.map(|(&v, w)| f64::from(plane[v as usize]) * w).sum::<f64>() as f32 * factor
            });
            carried.push([a, b, c, *key]);
        }
    }

    #[inline(always)]
    fn carry_chunk<S: Simd>(&self, simd: S, first: usize, carried: &mut [Fragment], keys: &[f32]) {
        let lanes = Lanes::<S>::LEN;
        let [a, b, c] = self.planes;
        let one = Lanes::splat(simd, 1.0);
        for (start, carried) in (first..).step_by(lanes).zip(carried.chunks_exact_mut(lanes)) {
            let key = Lanes::load(simd, &keys[start..]);
            let factor = if self.by_key { key } else { one };
            let values = [
                Lanes::load(simd, &a[start..]) * factor,
                Lanes::load(simd, &b[start..]) * factor,
                Lanes::load(simd, &c[start..]) * factor,
                key,
            ];
            join(simd, &values, carried);
        }
    }
}

/// How values are found inside a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Linear along the polygon's edges, then along the scan line.
    Scanline,
    /// Linear over the triangle: by a step from one pixel to the next.
    Steps,
}

/// Linear over the triangle (of values that are linear there: affine ones, or perspective ones times the key).
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
        Self { triangles, carried, triangle: u32::MAX, weights, origin: zero, d1: zero, d2: zero }
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

    /// What is carried to where the second and third vertex have these weights.
    #[inline(always)]
    fn at(&self, simd: S, [w1, w2]: [f32; 2]) -> f32x4<S> {
        self.d1.mul_add(f32x4::splat(simd, w1), self.d2.mul_add(f32x4::splat(simd, w2), self.origin))
    }
}

/// Linear along the polygon's edges to P and Q on the scan line, then linear from P to Q (Gouraud 1971).
struct Span {
    /// Places of P and Q.
    x: [f64; 2],
    /// What they carry.
    values: [[f64; 4]; 2],
}

impl Span {
    fn new([p, q]: [&Crossing; 2], carried: &[Fragment]) -> Self {
        let value = |crossing: &Crossing| {
            let [a, b] = crossing.ends.map(|v| carried[v as usize]);
            [0, 1, 2, 3].map(|k| (1.0 - crossing.alpha) * f64::from(a[k]) + crossing.alpha * f64::from(b[k]))
        };
        Self { x: [p.x, q.x], values: [value(p), value(q)] }
    }

    /// From the pixel in column `x` on: the value there, the step to the next pixel, and the column where they end to hold, at
    /// most `end`. Beside P and Q a pixel has their value, so that none leaves the range between them.
    fn from<S: Simd>(&self, simd: S, x: u16, end: u16) -> (f32x4<S>, f32x4<S>, u16) {
        let ([xp, xq], [p, q]) = (self.x, self.values);
        let pixel = f64::from(SUBPIXELS);
        let centre = f64::from(x) * pixel + f64::from(HALF);
        // A span of no length has one value, P's.
        let per_unit = if xq > xp { 1.0 / (xq - xp) } else { 0.0 };
        let t = ((centre - xp) * per_unit).clamp(0.0, 1.0);
        let start = [0, 1, 2, 3].map(|k| (p[k] + t * (q[k] - p[k])) as f32);
        let step = [0, 1, 2, 3].map(|k| (per_unit * pixel * (q[k] - p[k])) as f32);
        let inside = centre >= xp;
        let last = if inside { ((xq - f64::from(HALF)) / pixel).floor() as i32 } else { 0 };
        let until = last.saturating_add(1).clamp(i32::from(x) + 1, i32::from(end)) as u16;
        (f32x4::simd_from(simd, start), f32x4::simd_from(simd, step), until)
    }
}

/// Fills the fragments of a band, rows of `place.width`. In each row all pixels of the extent are written.
#[inline(always)]
pub fn interpolate<S: Simd>(
    simd: S,
    place: BandPlace,
    band: &Band,
    (triangles, carried): (Triangles<'_>, &[Fragment]),
    rule: Rule,
    fragments: &mut [Block],
) {
    open_gaps(place, band, fragments);
    let count = Block::count(place.width);
    let line = |run: &Run| usize::from(run.row) * count..(usize::from(run.row) + 1) * count;
    if rule == Rule::Steps {
        let mut rule = Barycentric::new(simd, triangles, carried);
        for run in &band.runs {
            rule.take(simd, run.triangle);
            let [s1, s2] = rule.weights.step;
            let start = rule.at(simd, rule.weights.at(i32::from(run.x0), run.y(place.first_row)));
            let step = rule.d1.mul_add(s1, rule.d2 * s2);
            fragments::fill(simd, &mut fragments[line(run)], usize::from(run.x0)..usize::from(run.x1), start, step);
        }
        return;
    }
    let mut outlines = Outlines::new(triangles, place, band.sorted);
    for run in &band.runs {
        let line = &mut fragments[line(run)];
        let crossings = outlines.crossings(run.triangle, run.y(place.first_row));
        let mut x = run.x0;
        while x < run.x1 {
            let centre = f64::from(i32::from(x) * SUBPIXELS + HALF);
            // A row that sees the polygon crosses its outline.
            let Some(pair) = crossing_pair(crossings, centre) else { break };
            let (start, step, end) = Span::new(pair, carried).from(simd, x, run.x1);
            fragments::fill(simd, line, usize::from(x)..usize::from(end), start, step);
            x = end;
        }
    }
}

/// Makes those pixels of the extents gaps that no run may fill.
#[inline(always)]
fn open_gaps(place: BandPlace, band: &Band, fragments: &mut [Block]) {
    let count = Block::count(place.width);
    for (extent, line) in band.extents.iter().zip(fragments.chunks_mut(count)).filter(|(extent, _)| !extent.is_empty())
    {
        let blocks = Block::over(extent);
        if band.sorted {
            fragments::open(&mut line[blocks]);
        } else {
            // Runs leave no gaps between them.
            fragments::open(&mut line[blocks.start..=blocks.start]);
            fragments::open(&mut line[blocks.end - 1..blocks.end]);
        }
    }
}
