//! Scan-converts the triangles of a band into horizontal runs of covered pixels.

use super::grid::{BandPlace, HALF, Place, SUBPIXELS};
use super::span::scan;
use super::triangles::Triangles;
use std::ops::Range;

/// Pixels x0..x1 of a row that see one triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    pub triangle: u32,
    /// Row within the band.
    pub row: u16,
    pub x0: u16,
    pub x1: u16,
}

impl Run {
    /// The pixel row, in a band that begins at row `first`.
    #[inline(always)]
    #[expect(clippy::cast_possible_wrap, reason = "pictures are at most 16384 pixels high")]
    pub fn y(self, first: u32) -> i32 {
        (first + u32::from(self.row)) as i32
    }
}

/// The coverage stage's output for one band.
#[derive(Default)]
pub struct Band {
    /// Sorted by row and x where a depth test was made; otherwise by triangle, without gaps in a row.
    pub runs: Vec<Run>,
    /// Whether a depth test was made.
    pub sorted: bool,
    /// For each row the pixels between the first and the last that see the object.
    pub extents: Vec<Range<u32>>,
    /// Pixels that see the object.
    pub covered: u64,
    /// Pixels that its triangles cover, those counted that another hides.
    pub drawn: u64,
}

/// Depth and triangle of each pixel of a band, for the depth test.
#[derive(Default)]
pub struct DepthScratch {
    keys: Vec<f32>,
    triangles: Vec<u32>,
    /// Pixels tested.
    drawn: u64,
}

/// No triangle is seen.
const NONE: u32 = u32::MAX;

/// A triangle's barycentric coordinates as linear functions of the pixel.
#[derive(Clone, Copy)]
pub struct Weights {
    origin: Place,
    e1: [f64; 2],
    e2: [f64; 2],
    inverse_area: f64,
    /// Change of the second and third weight to the next pixel on the right.
    pub step: [f32; 2],
}

impl Weights {
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "steps multiply single-precision values")]
    pub fn new([a, b, c]: [Place; 3]) -> Self {
        let e1 = [f64::from(b[0]) - f64::from(a[0]), f64::from(b[1]) - f64::from(a[1])];
        let e2 = [f64::from(c[0]) - f64::from(a[0]), f64::from(c[1]) - f64::from(a[1])];
        let inverse_area = 1.0 / (e1[0] * e2[1] - e1[1] * e2[0]);
        let pixel = f64::from(SUBPIXELS) * inverse_area;
        Self { origin: a, e1, e2, inverse_area, step: [(e2[1] * pixel) as f32, (-e1[1] * pixel) as f32] }
    }

    /// The second and third weight at the centre of a pixel. The products are exact, so that inside the triangle no
    /// weight leaves 0..1 by more than a rounding, however thin it is.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "weights multiply single-precision values")]
    pub fn at(&self, x: i32, y: i32) -> [f32; 2] {
        let px = f64::from(x * SUBPIXELS + HALF) - f64::from(self.origin[0]);
        let py = f64::from(y * SUBPIXELS + HALF) - f64::from(self.origin[1]);
        [
            ((px * self.e2[1] - py * self.e2[0]) * self.inverse_area) as f32,
            ((self.e1[0] * py - self.e1[1] * px) * self.inverse_area) as f32,
        ]
    }
}

impl Band {
    /// Covers the band by triangles of which no two overlap: no depth is needed.
    #[inline(always)]
    pub fn cover_directly(&mut self, place: BandPlace, shape: &Triangles<'_>, triangles: impl Iterator<Item = u32>) {
        self.begin_sorted(place, false);
        let width = as_i32(place.width);
        for triangle in triangles {
            let corners = shape.corners(triangle);
            scan(
                corners,
                place.row_range(),
                width,
                #[inline(always)]
                |y, x0, x1| {
                    let row = as_u32(y) - place.first_row;
                    let extent = &mut self.extents[row as usize];
                    extent.start = extent.start.min(as_u32(x0));
                    extent.end = extent.end.max(as_u32(x1));
                    self.covered += u64::from(as_u32(x1 - x0));
                    self.runs.push(Run { triangle, row: as_u16(as_i32(row)), x0: as_u16(x0), x1: as_u16(x1) });
                },
            );
        }
        self.drawn = self.covered;
    }

    /// Covers the band by the nearest triangle at each pixel; of two at the same depth the first.
    #[inline(always)]
    pub fn cover_nearest(
        &mut self,
        place: BandPlace,
        shape: &Triangles<'_>,
        triangles: impl Iterator<Item = u32>,
        scratch: &mut DepthScratch,
    ) {
        self.begin_sorted(place, true);
        let pixels = (place.rows * place.width) as usize;
        scratch.keys.clear();
        scratch.keys.resize(pixels, f32::MIN);
        scratch.triangles.clear();
        scratch.triangles.resize(pixels, NONE);
        scratch.drawn = 0;
        for triangle in triangles {
            scratch.draw(place, shape, triangle);
        }
        self.drawn = scratch.drawn;
        for row in 0..place.rows {
            let start = (row * place.width) as usize;
            self.collect(row, &scratch.triangles[start..start + place.width as usize]);
        }
    }

    /// Triangles that are seen, counted again where another comes between.
    pub fn ink_count(&self) -> u64 {
        self.runs.chunk_by(|a, b| a.triangle == b.triangle).count() as u64
    }

    /// Forgets what was covered.
    pub fn begin(&mut self, place: BandPlace) {
        self.begin_sorted(place, true);
    }

    fn begin_sorted(&mut self, place: BandPlace, sorted: bool) {
        self.runs.clear();
        self.sorted = sorted;
        (self.covered, self.drawn) = (0, 0);
        self.extents.clear();
        self.extents.resize(place.rows as usize, place.width..0);
    }

    /// Turns a row of seen triangles into runs.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "pictures are at most 16384 pixels wide")]
    fn collect(&mut self, row: u32, seen: &[u32]) {
        let mut x = 0;
        while x < seen.len() {
            let triangle = seen[x];
            let length = seen[x..].iter().take_while(|&&t| t == triangle).count();
            if triangle != NONE {
                let (x0, x1) = (x as u32, (x + length) as u32);
                let extent = &mut self.extents[row as usize];
                extent.start = extent.start.min(x0);
                extent.end = x1;
                self.covered += length as u64;
                self.runs.push(Run { triangle, row: row as u16, x0: x0 as u16, x1: x1 as u16 });
            }
            x += length;
        }
    }
}

impl DepthScratch {
    #[inline(always)]
    fn draw(&mut self, place: BandPlace, shape: &Triangles<'_>, triangle: u32) {
        let (corners, [a, b, c]) = (shape.corners(triangle), shape.vertices(triangle));
        let keys = [shape.placed.keys[a as usize], shape.placed.keys[b as usize], shape.placed.keys[c as usize]];
        let weights = Weights::new(corners);
        let (d1, d2) = (keys[1] - keys[0], keys[2] - keys[0]);
        let step = weights.step[0] * d1 + weights.step[1] * d2;
        scan(
            corners,
            place.row_range(),
            as_i32(place.width),
            #[inline(always)]
            |y, x0, x1| {
                let [w1, w2] = weights.at(x0, y);
                let start = keys[0] + w1 * d1 + w2 * d2;
                let base = ((as_u32(y) - place.first_row) * place.width) as usize;
                let range = base + x0 as usize..base + x1 as usize;
                self.drawn += range.len() as u64;
                let depths = &mut self.keys[range.clone()];
                for (k, (depth, seen)) in depths.iter_mut().zip(&mut self.triangles[range]).enumerate() {
                    let key = start + k as f32 * step;
                    let nearer = key > *depth;
                    *depth = if nearer { key } else { *depth };
                    *seen = if nearer { triangle } else { *seen };
                }
            },
        );
    }
}

#[inline(always)]
#[expect(clippy::cast_sign_loss, reason = "pixel coordinates inside the picture")]
fn as_u32(v: i32) -> u32 {
    v as u32
}

#[inline(always)]
#[expect(clippy::cast_sign_loss, clippy::cast_possible_truncation, reason = "pictures are at most 16384 pixels wide")]
fn as_u16(v: i32) -> u16 {
    v as u16
}

#[inline(always)]
#[expect(clippy::cast_possible_wrap, reason = "pictures are at most 16384 pixels wide")]
fn as_i32(v: u32) -> i32 {
    v as i32
}
