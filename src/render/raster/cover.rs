//! The triangle that each pixel shows: scan conversion of a band's triangles into horizontal runs of covered pixels. Where
//! the true surface is drawn, rays meet it instead, in double precision.

use super::fragments::{Block, Fragment, fragment, open, put};
use super::grid::{BAND, BandExtent, GridPosition, HALF, SUBPIXELS, scan};
use super::triangles::Triangles;
use crate::geometry::{RAYS_TOGETHER, Ray, Surface, SurfaceHit};
use crate::render::lens::{Lens, NEAR, pixel_centre};
use fearless_simd::Level;
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use std::ops::Range;

/// The pixels x0..x1 of a row, which show one triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run {
    pub triangle: u32,
    pub row: u16,
    pub x0: u16,
    pub x1: u16,
}

impl Run {
    /// Returns the pixel row, in a band that begins at row `first`.
    #[inline(always)]
    pub fn y(self, first: u32) -> i32 {
        (first + u32::from(self.row)) as i32
    }
}

/// The coverage stage's output for one band.
#[derive(Default)]
pub struct Band {
    pub place: BandExtent,
    /// The runs, sorted by row and x if a depth test was made; otherwise by triangle, without gaps in a row.
    pub runs: Vec<Run>,
    pub sorted: bool,
    /// For each row the pixels between the first and the last that show the object.
    pub extents: Vec<Range<u32>>,
    /// The number of pixels that show the object.
    pub covered: u64,
    /// The number of pixels that its triangles cover, including those hidden by another.
    pub drawn: u64,
}

/// The depth and triangle of each pixel of a band, for the depth test.
#[derive(Default)]
pub struct DepthScratch {
    keys: Vec<f32>,
    triangles: Vec<u32>,
    drawn: u64,
}

/// The triangle number of pixels without one.
const NONE: u32 = u32::MAX;

/// A triangle's barycentric coordinates as linear functions of the pixel.
#[derive(Clone, Copy)]
pub struct Weights {
    origin: GridPosition,
    e1: [f64; 2],
    e2: [f64; 2],
    inverse_area: f64,
    /// The change of the second and third weight to the next pixel on the right.
    pub step: [f32; 2],
}

impl Weights {
    #[inline(always)]
    pub fn new([a, b, c]: [GridPosition; 3]) -> Self {
        let e1 = [
            f64::from(b[0]) - f64::from(a[0]),
            f64::from(b[1]) - f64::from(a[1]),
        ];
        let e2 = [
            f64::from(c[0]) - f64::from(a[0]),
            f64::from(c[1]) - f64::from(a[1]),
        ];
        let inverse_area = 1.0 / (e1[0] * e2[1] - e1[1] * e2[0]);
        let pixel = f64::from(SUBPIXELS) * inverse_area;
        Self {
            origin: a,
            e1,
            e2,
            inverse_area,
            step: [(e2[1] * pixel) as f32, (-e1[1] * pixel) as f32],
        }
    }

    /// Returns the second and third weight at the centre of a pixel. The products are exact, so that inside the triangle no
    /// weight leaves 0..1 by more than a rounding, however thin it is.
    #[inline(always)]
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
    pub fn cover_directly(&mut self, shape: &Triangles<'_>, triangles: impl Iterator<Item = u32>) {
        self.begin(false);
        let place = self.place;
        let width = place.width as i32;
        for triangle in triangles {
            let corners = shape.corners(triangle);
            scan(
                corners,
                place.row_range(),
                width,
                #[inline(always)]
                |y, x0, x1| {
                    let row = y as u32 - place.first_row;
                    self.extend(row as usize, x0 as u32, x1 as u32);
                    self.runs.push(Run {
                        triangle,
                        row: row as u16,
                        x0: x0 as u16,
                        x1: x1 as u16,
                    });
                },
            );
        }
        self.drawn = self.covered;
    }

    /// Covers the band by the nearest triangle at each pixel; of two at the same depth, by the first.
    #[inline(always)]
    pub fn cover_nearest(
        &mut self,
        shape: &Triangles<'_>,
        triangles: impl Iterator<Item = u32>,
        scratch: &mut DepthScratch,
    ) {
        self.begin(true);
        let place = self.place;
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

    /// Returns a band of one row whose pixels all show the object.
    pub fn of_one_row(width: u32) -> Self {
        Self {
            place: BandExtent {
                first_row: 0,
                rows: 1,
                width,
            },
            extents: std::iter::once(0..width).collect(),
            ..Self::default()
        }
    }

    /// Groups consecutive runs that show the same face, with that face.
    #[inline(always)]
    pub fn runs_by_face<'b>(
        &'b self,
        triangles: &'b Triangles<'_>,
    ) -> impl Iterator<Item = (u32, &'b [Run])> {
        let face = |run: &Run| triangles.face(run.triangle);
        let same = self
            .runs
            .chunk_by(move |a, b| a.triangle == b.triangle || face(a) == face(b));
        same.map(move |runs| (face(&runs[0]), runs))
    }

    fn begin(&mut self, sorted: bool) {
        self.runs.clear();
        self.sorted = sorted;
        (self.covered, self.drawn) = (0, 0);
        self.extents.clear();
        self.extents
            .resize(self.place.rows as usize, self.place.width..0);
    }

    /// Counts the pixels x0..x1 of a row as covered.
    #[inline(always)]
    fn extend(&mut self, row: usize, x0: u32, x1: u32) {
        let extent = &mut self.extents[row];
        (extent.start, extent.end) = (extent.start.min(x0), extent.end.max(x1));
        self.covered += u64::from(x1 - x0);
    }

    /// Turns a row of visible triangles into runs.
    #[inline(always)]
    fn collect(&mut self, row: u32, seen: &[u32]) {
        let mut x = 0;
        while x < seen.len() {
            let triangle = seen[x];
            let length = seen[x..].iter().take_while(|&&t| t == triangle).count();
            if triangle != NONE {
                let (x0, x1) = (x as u32, (x + length) as u32);
                self.extend(row as usize, x0, x1);
                self.runs.push(Run {
                    triangle,
                    row: row as u16,
                    x0: x0 as u16,
                    x1: x1 as u16,
                });
            }
            x += length;
        }
    }
}

impl DepthScratch {
    #[inline(always)]
    fn draw(&mut self, place: BandExtent, shape: &Triangles<'_>, triangle: u32) {
        let (corners, [a, b, c]) = (shape.corners(triangle), shape.vertices(triangle));
        let keys = [
            shape.placed.keys[a as usize],
            shape.placed.keys[b as usize],
            shape.placed.keys[c as usize],
        ];
        let weights = Weights::new(corners);
        let (d1, d2) = (keys[1] - keys[0], keys[2] - keys[0]);
        let step = weights.step[0] * d1 + weights.step[1] * d2;
        scan(
            corners,
            place.row_range(),
            place.width as i32,
            #[inline(always)]
            |y, x0, x1| {
                let [w1, w2] = weights.at(x0, y);
                let start = keys[0] + w1 * d1 + w2 * d2;
                let base = ((y as u32 - place.first_row) * place.width) as usize;
                let range = base + x0 as usize..base + x1 as usize;
                self.drawn += range.len() as u64;
                let depths = &mut self.keys[range.clone()];
                for (k, (depth, seen)) in depths
                    .iter_mut()
                    .zip(&mut self.triangles[range])
                    .enumerate()
                {
                    let key = start + k as f32 * step;
                    let nearer = key > *depth;
                    *depth = if nearer { key } else { *depth };
                    *seen = if nearer { triangle } else { *seen };
                }
            },
        );
    }
}

pub const ROWS: usize = BAND as usize;
/// The most bands that a thread takes at a time.
const BANDS_TOGETHER: usize = 3;

/// The bands of a picture from the top, with their fragments where these are stored.
#[derive(Clone, Copy)]
pub struct Coverage<'a> {
    pub size: [u32; 2],
    pub bands: &'a [Band],
    pub fragments: &'a [Block],
}

impl<'a> Coverage<'a> {
    /// Returns the bands, each with its fragments. Threads take a few at a time, since some show much more of the object than others.
    pub fn parts(self) -> impl IndexedParallelIterator<Item = (&'a Band, &'a [Block])> {
        let share = ROWS * Block::count(self.size[0]);
        let bands = self.bands.par_iter().with_max_len(BANDS_TOGETHER);
        bands.enumerate().map(move |(index, band)| {
            let fragments = &self.fragments[(index * share).min(self.fragments.len())..];
            (band, &fragments[..share.min(fragments.len())])
        })
    }

    pub fn fragment_at(self, [x, y]: [u32; 2]) -> Option<Fragment> {
        let count = Block::count(self.size[0]);
        let line = self
            .fragments
            .get(y as usize * count..(y as usize + 1) * count)?;
        (x < self.size[0]).then(|| fragment(line, x as usize))
    }

    pub fn triangle_at(self, [x, y]: [u32; 2]) -> Option<u32> {
        let runs = &self.bands.get((y / BAND) as usize)?.runs;
        let sees = |run: &&Run| {
            u32::from(run.row) == y % BAND && (u32::from(run.x0)..u32::from(run.x1)).contains(&x)
        };
        runs.iter().find(sees).map(|run| run.triangle)
    }
}

/// Returns the ray through a point in the picture; t counts camera distances.
fn ray_through(lens: &Lens, place: DVec2) -> Ray {
    let (point, direction) = lens.ray(place);
    Ray {
        origin: lens.world(point),
        direction: direction * lens.unit,
    }
}

/// Intersects the ray through a point in the picture with the surface; returns the point relative to the eye, in camera
/// distances, and the hit.
pub fn meet(lens: &Lens, surface: &Surface, place: DVec2) -> Option<(DVec3, SurfaceHit)> {
    let ray = ray_through(lens, place);
    let hit = surface.intersect(&ray, NEAR)?;
    Some((ray.origin + ray.direction * hit.t, hit))
}

pub fn meet_band(
    level: Level,
    lens: &Lens,
    surface: &Surface,
    band: &mut Band,
    fragments: &mut [Block],
) {
    /// The columns and rows intersected at a time: two squares of four pixels.
    const TILE: [usize; 2] = [4, 2];
    band.begin(true);
    let place = band.place;
    let [width, rows] = [place.width, place.rows].map(|count| count as usize);
    let blocks = Block::count(place.width);
    fragments.chunks_exact_mut(blocks).take(rows).for_each(open);
    let mut rays = Vec::with_capacity(RAYS_TOGETHER);
    for first_row in (0..rows).step_by(TILE[1]) {
        for first in (0..width).step_by(TILE[0]) {
            // Square by square.
            let pixel = |k: usize| [first + k % 2 + k / 4 * 2, first_row + k / 2 % 2];
            let pixels = || {
                (0..RAYS_TOGETHER)
                    .map(pixel)
                    .filter(|[x, row]| *x < width && *row < rows)
            };
            rays.clear();
            rays.extend(pixels().map(|[x, row]| {
                ray_through(lens, pixel_centre(x, place.first_row as usize + row))
            }));
            let hits = surface.intersect_all(level, &rays, NEAR);
            for ([x, row], hit) in pixels().zip(hits) {
                let Some(hit) = hit else {
                    continue;
                };
                let [nx, ny, nz] = hit.normal.as_vec3().to_array();
                let line = &mut fragments[row * blocks..(row + 1) * blocks];
                put(line, x, [nx, ny, nz, lens.key_from_depth(hit.t) as f32]);
                band.extend(row, x as u32, x as u32 + 1);
            }
        }
    }
}
