//! What each pixel sees, pixel by pixel, where polygons are hardly larger than pixels.
//!
//! A run of one or two pixels costs more to take up than to fill: how many rows a triangle has and how many pixels each cannot be
//! foretold. So where runs are short each pixel keeps what its intensity is made from, and when only intensities have changed
//! the band is a walk through its pixels, without a triangle's setup and without a branch.

use super::cover::{Band, BandPlace, Weights};
use super::fragments::{self, Block, Fragment};
use super::interpolate::{self, Sources};
use super::memory::room;
use super::plan::{Per, Plan};
use crate::scene::{FlatAt, Scene};
use fearless_simd::{f32x4, prelude::*};

/// Runs are short that have fewer pixels than this on average.
const SHORT: u64 = 3;

/// The pixel does not see the object.
const GAP: u32 = u32::MAX;

/// What a pixel's intensity is made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// The intensity of its face.
    Face,
    /// That of its face's first vertex.
    Vertex,
    /// A mixture of those of its triangle's vertices.
    Mixture,
}

impl Origin {
    /// The origin by a plan, where it is one that pixels can keep.
    pub fn of(scene: &Scene, plan: &Plan) -> Option<Self> {
        if plan.per == Per::Pixel || plan.scanline {
            return None;
        }
        match scene.shading.flat_at {
            _ if plan.carries => Some(Self::Mixture),
            FlatAt::Centre => Some(Self::Face),
            FlatAt::ProvokingVertex => Some(Self::Vertex),
            FlatAt::VertexMean => None,
        }
    }
}

/// The origins of a band's pixels, in rows of whole blocks.
#[derive(Default)]
pub(super) struct Fine {
    /// Faces or vertices, where one colours a pixel.
    points: Vec<u32>,
    mixtures: Vec<Mixture>,
}

/// What a pixel mixes of what three vertices carry.
#[derive(Clone, Copy, Debug)]
struct Mixture {
    vertices: [u32; 3],
    /// The weights of the second and the third; an array would be taken apart by shuffles.
    second: f32,
    third: f32,
}

impl Fine {
    /// Whether a band's pixels are better taken one by one.
    pub fn suits(band: &Band) -> bool {
        band.covered < SHORT * band.runs.len() as u64
    }

    /// Bytes, which grow with the pixels.
    pub fn room(&self) -> u64 {
        room(&self.points) + room(&self.mixtures)
    }

    /// Finds the origins of a band's pixels.
    #[inline(always)]
    pub fn find(&mut self, place: BandPlace, band: &Band, sources: Sources<'_>, origin: Origin) {
        match origin {
            Origin::Face => self.find_points(place, band, |triangle| sources.face(triangle)),
            Origin::Vertex => self.find_points(place, band, |triangle| sources.provoking_vertex(triangle)),
            Origin::Mixture => self.find_mixtures(place, band, sources),
        }
    }

    fn find_points(&mut self, place: BandPlace, band: &Band, point: impl Fn(u32) -> u32) {
        self.mixtures = Vec::new();
        let width = lay_out(&mut self.points, place, band, GAP);
        let mut last = (u32::MAX, 0);
        for run in &band.runs {
            if run.triangle != last.0 {
                last = (run.triangle, point(run.triangle));
            }
            let row = usize::from(run.row) * width;
            self.points[row + usize::from(run.x0)..row + usize::from(run.x1)].fill(last.1);
        }
    }

    fn find_mixtures(&mut self, place: BandPlace, band: &Band, sources: Sources<'_>) {
        self.points = Vec::new();
        let gap = Mixture { vertices: [GAP; 3], second: 0.0, third: 0.0 };
        let width = lay_out(&mut self.mixtures, place, band, gap);
        let mut last = (u32::MAX, [0; 3], Weights::new([[0, 0], [1, 0], [0, 1]]));
        for run in &band.runs {
            if run.triangle != last.0 {
                let vertices = sources.vertices(run.triangle);
                last = (run.triangle, vertices, Weights::new(sources.placed.corners(vertices)));
            }
            let row = usize::from(run.row) * width;
            let pixels = &mut self.mixtures[row + usize::from(run.x0)..row + usize::from(run.x1)];
            for (pixel, [second, third]) in pixels.iter_mut().zip(last.2.along(*run, place.y(*run))) {
                *pixel = Mixture { vertices: last.1, second, third };
            }
        }
    }

    /// Makes the fragments of a band from what is carried to its pixels. In each row all blocks of the extent are written.
    #[inline(always)]
    pub fn gather<S: Simd>(&self, simd: S, place: BandPlace, band: &Band, carried: &[Fragment], blocks: &mut [Block]) {
        let count = Block::count(place.width);
        let rows = band.extents.iter().zip(blocks.chunks_exact_mut(count));
        for ((extent, line), start) in rows.zip((0..).step_by(count * Block::PIXELS)) {
            let seen = Block::over(extent);
            let pixels = start + seen.start * Block::PIXELS..start + seen.end * Block::PIXELS;
            if self.mixtures.is_empty() {
                gather_row(simd, &mut line[seen], &self.points[pixels], carried);
            } else {
                gather_row(simd, &mut line[seen], &self.mixtures[pixels], carried);
            }
        }
    }
}

/// Gives a band's pixels room, those of each row's extent as gaps; returns the length of a row.
fn lay_out<T: Copy>(pixels: &mut Vec<T>, place: BandPlace, band: &Band, gap: T) -> usize {
    let width = Block::count(place.width) * Block::PIXELS;
    pixels.resize(width * band.extents.len(), gap);
    for (extent, line) in band.extents.iter().zip(pixels.chunks_exact_mut(width)) {
        let blocks = Block::over(extent);
        line[blocks.start * Block::PIXELS..blocks.end * Block::PIXELS].fill(gap);
    }
    width
}

/// What a pixel keeps of where its intensity comes from.
trait Gathered {
    /// The fragment, given what is carried.
    fn fragment<S: Simd>(&self, simd: S, carried: &[Fragment]) -> f32x4<S>;
}

#[inline(always)]
fn gather_row<S: Simd>(simd: S, line: &mut [Block], pixels: &[impl Gathered], carried: &[Fragment]) {
    for (block, pixels) in line.iter_mut().zip(pixels.chunks_exact(Block::PIXELS)) {
        for (first, four) in (0..).step_by(4).zip(pixels.chunks_exact(4)) {
            let four = [
                four[0].fragment(simd, carried),
                four[1].fragment(simd, carried),
                four[2].fragment(simd, carried),
                four[3].fragment(simd, carried),
            ];
            block.put_four(first, four);
        }
    }
}

/// A face or a vertex, which colours the pixel.
impl Gathered for u32 {
    #[inline(always)]
    fn fragment<S: Simd>(&self, simd: S, carried: &[Fragment]) -> f32x4<S> {
        f32x4::simd_from(simd, carried.get(*self as usize).copied().unwrap_or(fragments::GAP))
    }
}

impl Gathered for Mixture {
    #[inline(always)]
    fn fragment<S: Simd>(&self, simd: S, carried: &[Fragment]) -> f32x4<S> {
        if self.vertices[0] as usize >= carried.len() {
            return f32x4::simd_from(simd, fragments::GAP);
        }
        let differences = interpolate::differences(simd, carried, self.vertices);
        interpolate::mix(simd, differences, [self.second, self.third])
    }
}
