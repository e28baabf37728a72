//! The memory that a renderer holds between frames.
//!
//! Counted is the room of its buffers, used or not, each under what it grows with. What does not grow (a scene, a plan, a
//! curved surface's patches, a list for each of the picture's bands of rows, and a band's depths for each thread) is not.

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

    pub fn of_vertices(vertices: u64) -> Self {
        Self { vertices, ..Self::default() }
    }

    pub fn of_triangles(triangles: u64) -> Self {
        Self { triangles, ..Self::default() }
    }

    pub fn of_pixels(pixels: u64) -> Self {
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
pub fn room<T>(buffer: &Vec<T>) -> u64 {
    (buffer.capacity() * size_of::<T>()) as u64
}

/// The room of planes, bytes.
pub fn room_of_planes<T>(planes: &[Vec<T>; 3]) -> u64 {
    planes.iter().map(room).sum()
}

/// What holds buffers.
pub trait Holds {
    fn memory(&self) -> Memory;
}
