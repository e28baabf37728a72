//! The memory that a renderer holds between frames.
//!
//! Counted is the room of its buffers, used or not, each under what it grows with. What does not grow (a scene, a plan, a
//! curved surface's patches, a list for each of the picture's bands of rows, and a band's depths for each thread) is not.

use super::clip::Clipped;
use super::model::Model;
use super::scan_line::EdgeTable;
use super::transform::Placed;
use crate::geometry::Mesh;
use std::iter::Sum;
use std::ops::Add;

/// Bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Memory {
    /// What grows with the vertices: their positions and normals, their places in the picture, and what they carry to the
    /// pixels.
    pub vertices: u64,
    /// What grows with the triangles: the polygons and their corners, lists of those in sight, and boxes about them where
    /// rays are followed.
    pub triangles: u64,
    /// What grows with the pixels: the picture, what each pixel was brought, and which triangles are seen.
    pub pixels: u64,
}

impl Memory {
    /// All of it, bytes.
    pub fn total(self) -> u64 {
        self.vertices + self.triangles + self.pixels
    }

    pub(super) fn of_vertices(vertices: u64) -> Self {
        Self { vertices, ..Self::default() }
    }

    pub(super) fn of_triangles(triangles: u64) -> Self {
        Self { triangles, ..Self::default() }
    }

    pub(super) fn of_pixels(pixels: u64) -> Self {
        Self { pixels, ..Self::default() }
    }
}

impl Add for Memory {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            vertices: self.vertices + other.vertices,
            triangles: self.triangles + other.triangles,
            pixels: self.pixels + other.pixels,
        }
    }
}

impl Sum for Memory {
    fn sum<I: Iterator<Item = Self>>(parts: I) -> Self {
        parts.fold(Self::default(), Add::add)
    }
}

/// The room of a buffer, bytes.
pub(super) fn room<T>(buffer: &Vec<T>) -> u64 {
    (buffer.capacity() * size_of::<T>()) as u64
}

/// The room of planes, bytes.
pub(super) fn room_of_planes<T>(planes: &[Vec<T>; 3]) -> u64 {
    planes.iter().map(room).sum()
}

/// What holds buffers.
pub(super) trait Holds {
    fn memory(&self) -> Memory;
}

impl Holds for Mesh {
    fn memory(&self) -> Memory {
        let vertices = room(&self.positions) + room(&self.normals) + room(&self.mirrored);
        Memory { vertices, triangles: room(&self.starts) + room(&self.corners), pixels: 0 }
    }
}

impl Holds for Model {
    fn memory(&self) -> Memory {
        let vertices = room_of_planes(&self.position) + room_of_planes(&self.normal);
        let triangles = room(&self.triangles) + room(&self.faces) + room(&self.starts) + room(&self.indices);
        Memory { vertices, triangles, pixels: 0 }
    }
}

impl Holds for Placed {
    fn memory(&self) -> Memory {
        let edges = self.edges.get().map_or(0, EdgeTable::room);
        Memory::of_vertices(room(&self.places) + room(&self.keys) + edges)
    }
}

impl Holds for Clipped {
    fn memory(&self) -> Memory {
        Memory::of_triangles(room(&self.cuts) + room(&self.triangles) + room(&self.parents))
    }
}
