//! Which points the picture needs: vertices or faces of the polygons that may be seen in it.

use super::bins::Bins;
use super::interpolate::Sources;
use super::memory::{Holds, Memory, room};
use super::model::PADDING;
use super::plan::{Per, Plan};
use crate::scene::{FlatAt, Scene};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// What of a triangle in sight has to be evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Points {
    /// Its face.
    Face,
    /// Its face's first vertex.
    Provoking,
    /// Its own vertices.
    Vertices,
    /// All vertices of its face.
    Corners,
}

impl Points {
    /// The points at which a plan evaluates the equation; none where these are pixels.
    pub fn of(scene: &Scene, plan: &Plan) -> Option<Self> {
        match (plan.per, scene.shading.flat_at) {
            (Per::Face, _) => Some(Self::Face),
            (Per::Vertex, _) if plan.scanline => Some(Self::Corners),
            (Per::Vertex, _) if plan.carries => Some(Self::Vertices),
            (Per::Vertex, FlatAt::ProvokingVertex) => Some(Self::Provoking),
            (Per::Vertex, _) => Some(Self::Corners),
            _ => None,
        }
    }
}

/// A flag for each block of [`PADDING`] points: whether one of them is needed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Needed {
    blocks: Vec<bool>,
}

impl Needed {
    /// Points of a block: as many as vectors of any level divide.
    pub const BLOCK: usize = PADDING;

    /// All of `count` points.
    pub fn all(count: usize) -> Self {
        Self { blocks: vec![true; count.div_ceil(Self::BLOCK)] }
    }

    /// Those of `count` points that belong to triangles in sight.
    pub fn find(points: Points, count: usize, bins: &Bins, sources: &Sources<'_>) -> Self {
        let blocks: Vec<AtomicBool> = (0..count.div_ceil(Self::BLOCK)).map(|_| AtomicBool::new(false)).collect();
        let mark = |point: u32| blocks[point as usize / Self::BLOCK].store(true, Ordering::Relaxed);
        bins.lists().for_each(|list| {
            let mut last = u32::MAX;
            for &triangle in list {
                let face = sources.face(triangle);
                match points {
                    Points::Face => mark(face),
                    Points::Vertices => sources.own_vertices(triangle).into_iter().for_each(mark),
                    Points::Provoking if face != last => mark(sources.provoking_vertex(triangle)),
                    Points::Corners if face != last => sources.model.face(face).iter().copied().for_each(mark),
                    Points::Provoking | Points::Corners => {}
                }
                last = face;
            }
        });
        Self { blocks: blocks.into_iter().map(AtomicBool::into_inner).collect() }
    }

    /// Whether everything that `other` needs is in this.
    pub fn includes(&self, other: &Self) -> bool {
        self.blocks.len() == other.blocks.len()
            && self.blocks.iter().zip(&other.blocks).all(|(own, other)| own >= other)
    }

    /// The flags of the blocks from point `first` on.
    #[inline]
    pub fn from(&self, first: usize) -> &[bool] {
        &self.blocks[first / Self::BLOCK..]
    }

    /// Whether a point is in a block that is needed.
    pub fn has(&self, point: usize) -> bool {
        self.blocks.get(point / Self::BLOCK).copied().unwrap_or_default()
    }

    /// How many of `count` points are evaluated.
    pub fn evaluations(&self, count: usize) -> u64 {
        let points = |(block, _): (usize, &bool)| (count - block * Self::BLOCK).min(Self::BLOCK) as u64;
        self.blocks.iter().enumerate().filter(|(_, needed)| **needed).map(points).sum()
    }
}

impl Holds for Needed {
    fn memory(&self) -> Memory {
        // The intensities keep the flags that they were made with.
        Memory::of_triangles(2 * room(&self.blocks))
    }
}
