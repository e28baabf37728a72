//! The triangles of a picture, their positions in it, and the bands of rows that they reach.
//!
//! Back faces, triangles without area and triangles that miss every pixel centre are dropped before any setup. The lists
//! are in the order of the triangles whatever the number of threads.

use super::clip::{Clipped, Cut};
use super::grid::{BAND, GridPosition, UNPLACED, doubled_area, first_centre};
use super::transform::Placed;
use crate::render::lens::Lens;
use crate::render::model::Model;
use crate::render::node::{Memory, capacity};
use fearless_simd::Level;
use rayon::prelude::*;

/// The triangles that one task examines.
const CHUNK: usize = 8192;

/// The divisor of a list's capacity below which its memory is freed, since it would otherwise keep that of its fullest picture.
const SLACK: usize = 4;

/// The model's triangles placed in a picture, clipped and sorted into bands.
#[derive(Default)]
pub struct PlacedTriangles {
    pub placed: Placed,
    pub clipped: Clipped,
    chunks: Vec<Chunk>,
    used: usize,
    /// The number of triangles with a pixel centre in their bounds; back faces count only where they are not dropped.
    pub candidates: u64,
}

#[derive(Default)]
struct Chunk {
    bands: Vec<Vec<u32>>,
    /// The triangles for the clipper.
    clip: Vec<u32>,
    candidates: u64,
}

impl PlacedTriangles {
    /// Places the model's triangles in a picture of `size` pixels; `cull` drops back faces.
    pub fn run(&mut self, level: Level, lens: &Lens, model: &Model, size: [u32; 2], cull: bool) {
        let Self {
            placed,
            clipped,
            chunks,
            used,
            candidates,
        } = self;
        placed.run(level, lens, model, size[1]);
        let bands = size[1].div_ceil(BAND) as usize;
        let count = model.triangles.len().div_ceil(CHUNK);
        *used = count + 1;
        chunks.resize_with(chunks.len().max(*used), Chunk::default);
        let (own, rest) = chunks.split_at_mut(count);
        let places = &placed.places;
        own.par_iter_mut()
            .zip(model.triangles.par_chunks(CHUNK))
            .enumerate()
            .for_each(|(index, (chunk, triangles))| {
                chunk.reset(bands);
                for (i, triangle) in (index * CHUNK..).zip(triangles) {
                    chunk.sort_in(i as u32, triangle.map(|v| places[v as usize]), size, cull);
                }
            });
        clipped.clear();
        for index in own.iter().flat_map(|chunk| &chunk.clip) {
            clipped.add(lens, model, *index, placed);
        }
        rest[0].reset(bands);
        for (i, triangle) in (model.triangles.len()..).zip(&clipped.triangles) {
            rest[0].sort_in(
                i as u32,
                triangle.map(|v| placed.places[v as usize]),
                size,
                cull,
            );
        }
        *candidates = chunks[..*used].iter().map(|chunk| chunk.candidates).sum();
    }

    /// Counts the candidates that show their back, anew at each call.
    pub fn backs(&self, model: &Model) -> u64 {
        let triangles = self.triangles(model);
        let lists = self.chunks[..self.used]
            .par_iter()
            .flat_map_iter(|chunk| chunk.bands.iter().zip(0_i32..));
        let backs = lists.map(|(list, band)| {
            // A triangle is in the list of every band that it reaches, and counted in the first.
            let first = |corners: [GridPosition; 3]| {
                let top = corners.iter().map(|corner| corner[1]).min().unwrap_or(0);
                first_centre(top).max(0) / BAND.cast_signed() == band
            };
            let corners = list.iter().map(|&index| triangles.corners(index));
            corners
                .filter(|&corners| doubled_area(corners) > 0 && first(corners))
                .count()
        });
        backs.sum::<usize>() as u64
    }

    /// Returns the triangles of band `band`, in ascending order.
    pub fn band(&self, band: usize) -> impl Iterator<Item = u32> {
        self.chunks[..self.used]
            .iter()
            .flat_map(move |chunk| chunk.bands[band].iter().copied())
    }

    pub fn count(&self, memory: &mut Memory) {
        self.placed.count(memory);
        self.clipped.count(memory);
        let lists = self
            .chunks
            .iter()
            .flat_map(|chunk| chunk.bands.iter().chain([&chunk.clip]));
        memory.triangles += lists.map(capacity).sum::<u64>();
    }

    pub fn triangles<'a>(&'a self, model: &'a Model) -> Triangles<'a> {
        Triangles {
            model,
            clipped: &self.clipped,
            placed: &self.placed,
        }
    }
}

impl Chunk {
    fn reset(&mut self, bands: usize) {
        self.bands
            .resize_with(bands.max(self.bands.len()), Vec::new);
        for list in &mut self.bands {
            if list.capacity() > SLACK * list.len().max(SLACK) {
                list.shrink_to_fit();
            }
            list.clear();
        }
        self.clip.clear();
        self.candidates = 0;
    }

    #[inline]
    fn sort_in(&mut self, index: u32, corners: [GridPosition; 3], size: [u32; 2], cull: bool) {
        let [a, b, c] = corners;
        if a[0] == UNPLACED || b[0] == UNPLACED || c[0] == UNPLACED {
            self.clip.push(index);
            return;
        }
        let area = doubled_area(corners);
        if area == 0 || (cull && area > 0) {
            return;
        }
        let range = |axis: usize| {
            let (low, high) = (
                a[axis].min(b[axis]).min(c[axis]),
                a[axis].max(b[axis]).max(c[axis]),
            );
            let limit = i32::try_from(size[axis]).unwrap_or(i32::MAX);
            first_centre(low).max(0)..first_centre(high).min(limit)
        };
        let (columns, rows) = (range(0), range(1));
        if columns.is_empty() || rows.is_empty() {
            return;
        }
        self.candidates += 1;
        let (first, last) = (rows.start as u32 / BAND, (rows.end - 1) as u32 / BAND);
        for band in first..=last {
            self.bands[band as usize].push(index);
        }
    }
}

/// The triangles of a picture: the model's, followed by the pieces made by clipping.
#[derive(Clone, Copy)]
pub struct Triangles<'a> {
    pub model: &'a Model,
    pub clipped: &'a Clipped,
    pub placed: &'a Placed,
}

impl Triangles<'_> {
    /// Returns the vertices of a triangle of the model or of the clipper.
    #[inline(always)]
    pub fn vertices(&self, triangle: u32) -> [u32; 3] {
        let own = self.model.triangles.len();
        match self.model.triangles.get(triangle as usize) {
            Some(vertices) => *vertices,
            None => self.clipped.triangles[triangle as usize - own],
        }
    }

    #[inline(always)]
    pub fn corners(&self, triangle: u32) -> [GridPosition; 3] {
        self.placed.corners(self.vertices(triangle))
    }

    /// Returns whether a triangle is a piece made by clipping.
    #[inline(always)]
    pub fn is_piece(&self, triangle: u32) -> bool {
        triangle as usize >= self.model.triangles.len()
    }

    /// Returns the origin of a vertex made by clipping.
    pub fn cut(&self, vertex: u32) -> Option<&Cut> {
        self.clipped
            .cuts
            .get((vertex as usize).wrapping_sub(self.model.padded_len()))
    }

    /// Returns the model's triangle: for a piece made by clipping, the triangle that it is part of.
    #[inline(always)]
    pub fn whole(&self, triangle: u32) -> usize {
        let (index, own) = (triangle as usize, self.model.triangles.len());
        if index < own {
            index
        } else {
            self.clipped.parents[index - own] as usize
        }
    }

    #[inline(always)]
    pub fn face(&self, triangle: u32) -> u32 {
        self.model.faces[self.whole(triangle)]
    }
}
