//! What each pixel sees, pixel by pixel, where polygons are hardly larger than pixels.
//!
//! A run of one or two pixels costs more to take up than to fill: how many rows a triangle has and how many pixels each cannot be
//! foretold. So where runs are short each pixel keeps what its intensity is made from, and when only intensities have changed
//! the band is a walk through its pixels, without a triangle's setup and without a branch.

use super::cover::{Band, BandPlace, Weights};
use super::fragments::{self, Block};
use super::interpolate::{self, Sources};
use super::memory::room;
use super::plan::{Per, Plan};
use super::points::Planes;
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
    /// Those of its triangle's three vertices.
    Triangle,
}

impl Origin {
    /// The origin by a plan, where it is one that pixels can keep.
    pub fn of(scene: &Scene, plan: &Plan) -> Option<Self> {
        if plan.per == Per::Pixel || plan.scanline {
            return None;
        }
        match scene.shading.flat_at {
            _ if plan.carries => Some(Self::Triangle),
            FlatAt::Centre => Some(Self::Face),
            FlatAt::ProvokingVertex => Some(Self::Vertex),
            FlatAt::VertexMean => None,
        }
    }
}

/// The origins of a band's pixels, in rows of whole blocks.
#[derive(Default)]
pub(super) struct Fine {
    /// Triangles, faces or vertices.
    indices: Vec<u32>,
    /// Those of a triangle's second and third vertex.
    weights: Vec<[f32; 2]>,
}

impl Fine {
    /// Whether a band's pixels are better taken one by one.
    pub fn suits(band: &Band) -> bool {
        band.covered < SHORT * band.runs.len() as u64
    }

    /// Bytes, which grow with the pixels.
    pub fn room(&self) -> u64 {
        room(&self.indices) + room(&self.weights)
    }

    /// Finds the origins of a band's pixels.
    #[inline(always)]
    pub fn find(&mut self, place: BandPlace, band: &Band, sources: Sources<'_>, origin: Origin) {
        let width = Block::count(place.width) * Block::PIXELS;
        let count = width * band.extents.len();
        self.indices.resize(count, GAP);
        self.weights.resize(if origin == Origin::Triangle { count } else { 0 }, [0.0; 2]);
        for (extent, line) in band.extents.iter().zip(self.indices.chunks_exact_mut(width)) {
            let blocks = Block::over(extent);
            line[blocks.start * Block::PIXELS..blocks.end * Block::PIXELS].fill(GAP);
        }
        let mut last = (u32::MAX, 0, Weights::new([[0, 0], [1, 0], [0, 1]]));
        for run in &band.runs {
            if run.triangle != last.0 {
                last.0 = run.triangle;
                match origin {
                    Origin::Face => last.1 = sources.face(run.triangle),
                    Origin::Vertex => last.1 = sources.provoking_vertex(run.triangle),
                    Origin::Triangle => {
                        last.1 = run.triangle;
                        last.2 = Weights::new(sources.placed.corners(sources.vertices(run.triangle)));
                    }
                }
            }
            let (_, index, weights) = &last;
            let row = usize::from(run.row) * width;
            let pixels = row + usize::from(run.x0)..row + usize::from(run.x1);
            self.indices[pixels.clone()].fill(*index);
            if origin == Origin::Triangle {
                for (out, at) in self.weights[pixels].iter_mut().zip(weights.along(*run, place.y(*run))) {
                    *out = at;
                }
            }
        }
    }

    /// Makes the fragments of a band: the intensities of faces or vertices where pixels have one origin, otherwise what a
    /// triangle's vertices carry. In each row all blocks of the extent are written.
    #[inline(always)]
    pub fn gather<S: Simd>(
        &self,
        simd: S,
        place: BandPlace,
        band: &Band,
        sources: Sources<'_>,
        intensity: &Planes,
        blocks: &mut [Block],
    ) {
        let count = Block::count(place.width);
        let rows = band.extents.iter().zip(blocks.chunks_exact_mut(count));
        for ((extent, line), start) in rows.zip((0..).step_by(count * Block::PIXELS)) {
            let seen = Block::over(extent);
            let pixels = start + seen.start * Block::PIXELS..start + seen.end * Block::PIXELS;
            let line = &mut line[seen];
            if self.weights.is_empty() {
                pick(line, &self.indices[pixels], intensity);
            } else {
                mix(simd, line, &self.indices[pixels.clone()], &self.weights[pixels], sources);
            }
        }
    }
}

/// Fragments of the intensities at `indices`.
#[inline(always)]
fn pick(line: &mut [Block], indices: &[u32], [r, g, b]: &Planes) {
    for (block, indices) in line.iter_mut().zip(indices.chunks_exact(Block::PIXELS)) {
        for (lane, &index) in indices.iter().enumerate() {
            let fragment = if index == GAP {
                fragments::GAP
            } else {
                let index = index as usize;
                [r[index], g[index], b[index], 1.0]
            };
            block.put(lane, fragment);
        }
    }
}

/// Fragments of what triangles' vertices carry, by their weights.
#[inline(always)]
fn mix<S: Simd>(simd: S, line: &mut [Block], indices: &[u32], weights: &[[f32; 2]], sources: Sources<'_>) {
    const QUADS: usize = Block::PIXELS / 4;
    for (quad, (index, weights)) in indices.chunks_exact(4).zip(weights.chunks_exact(4)).enumerate() {
        let four = [
            mixed(simd, index[0], weights[0], sources),
            mixed(simd, index[1], weights[1], sources),
            mixed(simd, index[2], weights[2], sources),
            mixed(simd, index[3], weights[3], sources),
        ];
        line[quad / QUADS].put_four(quad % QUADS * 4, four);
    }
}

#[inline(always)]
fn mixed<S: Simd>(simd: S, triangle: u32, weights: [f32; 2], sources: Sources<'_>) -> f32x4<S> {
    if triangle == GAP {
        return f32x4::simd_from(simd, fragments::GAP);
    }
    interpolate::mix(simd, sources.carried_from(simd, sources.vertices(triangle)), weights)
}
