//! The triangles of a picture, and where they lie in it.

use super::bins::Bins;
use super::clip::{Clipped, Cut};
use super::grid::Place;
use super::transform::Placed;
use crate::render::lens::Lens;
use crate::render::memory::{Holds, Memory};
use crate::render::model::Model;
use fearless_simd::Level;

/// The model's triangles placed in a picture, clipped and sorted into bands.
#[derive(Default)]
pub struct PlacedTriangles {
    pub placed: Placed,
    pub clipped: Clipped,
    pub bins: Bins,
}

impl PlacedTriangles {
    /// Places the model's triangles in a picture of `size` pixels; back faces are dropped where `cull` says so.
    pub fn run(&mut self, level: Level, lens: &Lens, model: &Model, size: [u32; 2], cull: bool) {
        self.placed.run(level, lens, model, size[1]);
        self.bins.run(model, lens, size, cull, &mut self.placed, &mut self.clipped);
    }

    pub fn triangles<'a>(&'a self, model: &'a Model) -> Triangles<'a> {
        Triangles { model, clipped: &self.clipped, placed: &self.placed }
    }
}

impl Holds for PlacedTriangles {
    fn memory(&self) -> Memory {
        self.placed.memory() + self.clipped.memory() + self.bins.memory()
    }
}

/// The triangles of a picture: the model's, after them the pieces that clipping made.
#[derive(Clone, Copy)]
pub struct Triangles<'a> {
    pub model: &'a Model,
    pub clipped: &'a Clipped,
    pub placed: &'a Placed,
}

impl Triangles<'_> {
    /// Vertices of a triangle of the model or of the clipper.
    #[inline(always)]
    pub fn vertices(&self, triangle: u32) -> [u32; 3] {
        let own = self.model.triangles.len();
        match self.model.triangles.get(triangle as usize) {
            Some(vertices) => *vertices,
            None => self.clipped.triangles[triangle as usize - own],
        }
    }

    /// The places of a triangle's vertices.
    #[inline(always)]
    pub fn corners(&self, triangle: u32) -> [Place; 3] {
        self.placed.corners(self.vertices(triangle))
    }

    /// Whether a triangle is a piece that clipping made.
    #[inline(always)]
    pub fn is_piece(&self, triangle: u32) -> bool {
        triangle as usize >= self.model.triangles.len()
    }

    /// What a vertex is made from that clipping made.
    pub fn cut(&self, vertex: u32) -> Option<&Cut> {
        self.clipped.cuts.get((vertex as usize).wrapping_sub(self.model.padded_len()))
    }

    /// The model's triangle: that which a piece that clipping made is part of.
    #[inline(always)]
    pub fn whole(&self, triangle: u32) -> usize {
        let (index, own) = (triangle as usize, self.model.triangles.len());
        if index < own { index } else { self.clipped.parents[index - own] as usize }
    }

    /// The face that a triangle belongs to.
    #[inline(always)]
    pub fn face(&self, triangle: u32) -> u32 {
        self.model.faces[self.whole(triangle)]
    }

    /// The vertex that a triangle's face is coloured by where one of them colours it: the face's first.
    #[inline(always)]
    pub fn provoking_vertex(&self, triangle: u32) -> u32 {
        self.model.face(self.face(triangle)).first().copied().unwrap_or_default()
    }
}
