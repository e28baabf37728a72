//! Sorts triangles into bands of rows.
//!
//! Back faces, triangles without area and triangles that miss every pixel centre are dropped here, before anything is
//! set up for them. The lists are in the order of the triangles whatever the number of threads.

use super::clip::Clipped;
use super::grid::{BAND, Place, UNPLACED, doubled_area, first_centre};
use super::transform::Placed;
use crate::render::lens::Lens;
use crate::render::memory::{Holds, Memory, room};
use crate::render::model::Model;
use rayon::prelude::*;

/// Triangles that one task looks at.
const CHUNK: usize = 8192;

/// A list that the last picture filled to less than one part in so many gives back what it did not need: as a camera goes round,
/// each list would otherwise keep the room of its fullest picture.
const SLACK: usize = 4;

/// The triangles of each band.
#[derive(Default)]
pub struct Bins {
    chunks: Vec<Chunk>,
    used: usize,
    /// Triangles with a pixel centre in their bounds, back faces only where these are not dropped.
    pub candidates: u64,
}

#[derive(Default)]
struct Chunk {
    /// One list a band.
    bands: Vec<Vec<u32>>,
    /// Triangles for the clipper.
    clip: Vec<u32>,
    candidates: u64,
}

impl Bins {
    /// Sorts the model's triangles, clipping those that need it.
    pub fn run(
        &mut self,
        model: &Model,
        lens: &Lens,
        size: [u32; 2],
        cull: bool,
        placed: &mut Placed,
        clipped: &mut Clipped,
    ) {
        let bands = size[1].div_ceil(BAND) as usize;
        let count = model.triangles.len().div_ceil(CHUNK);
        self.used = count + 1;
        if self.chunks.len() < self.used {
            self.chunks.resize_with(self.used, Chunk::default);
        }
        let places = &placed.places;
        self.chunks[..count].par_iter_mut().zip(model.triangles.par_chunks(CHUNK)).enumerate().for_each(
            |(index, (chunk, triangles))| {
                chunk.reset(bands);
                for (i, triangle) in (index * CHUNK..).zip(triangles) {
                    chunk.sort_in(as_index(i), triangle.map(|v| places[v as usize]), size, cull);
                }
            },
        );
        clipped.clear();
        placed.places.truncate(model.padded_len());
        placed.keys.truncate(model.padded_len());
        for index in self.chunks[..count].iter().flat_map(|chunk| &chunk.clip) {
            clipped.add(lens, model, *index, placed);
        }
        let last = &mut self.chunks[count];
        last.reset(bands);
        for (i, triangle) in (model.triangles.len()..).zip(&clipped.triangles) {
            last.sort_in(as_index(i), triangle.map(|v| placed.places[v as usize]), size, cull);
        }
        self.candidates = self.chunks[..self.used].iter().map(|chunk| chunk.candidates).sum();
    }

    /// How many of the candidates show their back; `corners` gives a triangle's places. Counted anew at each call.
    pub fn backs(&self, corners: impl Fn(u32) -> [Place; 3] + Sync) -> u64 {
        let lists = self.chunks[..self.used].par_iter().flat_map_iter(|chunk| chunk.bands.iter().zip(0_i32..));
        let backs = lists.map(|(list, band)| {
            let first = |corners: [Place; 3]| {
                let top = corners.iter().map(|corner| corner[1]).min().unwrap_or(0);
                first_centre(top).max(0) / BAND.cast_signed() == band
            };
            // A triangle is in the list of every band that it reaches, and counted in the first.
            list.iter()
                .map(|&index| corners(index))
                .filter(|&corners| doubled_area(corners) > 0 && first(corners))
                .count()
        });
        backs.sum::<usize>() as u64
    }

    /// The triangles of band `band`, in ascending order.
    pub fn band(&self, band: usize) -> impl Iterator<Item = u32> {
        self.chunks[..self.used].iter().flat_map(move |chunk| chunk.bands[band].iter().copied())
    }
}

impl Chunk {
    fn reset(&mut self, bands: usize) {
        self.bands.resize_with(bands.max(self.bands.len()), Vec::new);
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
    fn sort_in(&mut self, index: u32, corners: [Place; 3], size: [u32; 2], cull: bool) {
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
            let (low, high) = (a[axis].min(b[axis]).min(c[axis]), a[axis].max(b[axis]).max(c[axis]));
            let limit = i32::try_from(size[axis]).unwrap_or(i32::MAX);
            first_centre(low).max(0)..first_centre(high).min(limit)
        };
        let (columns, rows) = (range(0), range(1));
        if columns.is_empty() || rows.is_empty() {
            return;
        }
        self.candidates += 1;
        #[expect(clippy::cast_sign_loss, reason = "rows start at 0 or later")]
        let (first, last) = (rows.start as u32 / BAND, (rows.end - 1) as u32 / BAND);
        for band in first..=last {
            self.bands[band as usize].push(index);
        }
    }
}

impl Holds for Bins {
    fn memory(&self) -> Memory {
        let lists = self.chunks.iter().flat_map(|chunk| chunk.bands.iter().chain([&chunk.clip]));
        Memory::of_triangles(lists.map(room).sum())
    }
}

fn as_index(i: usize) -> u32 {
    u32::try_from(i).unwrap_or(u32::MAX)
}
