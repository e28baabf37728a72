//! Puts a mesh together face by face.

use crate::geometry::mesh::{Corner, Mesh};
use glam::DVec3;

/// A mesh under construction about the world's origin.
pub(crate) struct Builder {
    mesh: Mesh,
}

impl Builder {
    /// Room for so many points and for so many faces of four corners.
    pub fn with_capacity(points: usize, faces: usize) -> Self {
        let mut mesh = Mesh::default();
        mesh.positions.reserve_exact(points);
        mesh.normals.reserve(points);
        mesh.starts.reserve_exact(faces + 1);
        mesh.corners.reserve_exact(4 * faces);
        mesh.starts.push(0);
        Self { mesh }
    }

    /// Adds a point and returns its index.
    pub fn position(&mut self, position: DVec3) -> u32 {
        self.mesh.positions.push(position.as_vec3());
        self.mesh.positions.len() as u32 - 1
    }

    /// Adds a normal, of unit length, and returns its index.
    pub fn normal(&mut self, normal: DVec3) -> u32 {
        self.mesh.normals.push(normal.as_vec3());
        self.mesh.normals.len() as u32 - 1
    }

    /// Adds a face with `(position, normal)` at each corner, counter-clockwise from outside.
    pub fn face(&mut self, corners: impl IntoIterator<Item = (u32, u32)>) {
        self.mesh.corners.extend(corners.into_iter().map(|(position, normal)| Corner { position, normal }));
        self.mesh.starts.push(self.mesh.corners.len() as u32);
    }

    /// Adds the quads of a grid, row by row: between columns i, i + 1 and rows j, j + 1 of the corners that `at(i, j)` gives.
    pub fn grid(&mut self, columns: u32, rows: u32, at: impl Fn(u32, u32) -> (u32, u32)) {
        for j in 0..rows {
            for i in 0..columns {
                self.face([at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)]);
            }
        }
    }

    /// Points at which the shape is cut out of one that goes on as its mirror image in x.
    pub fn mirror(&mut self, points: impl IntoIterator<Item = u32>) {
        self.mesh.mirrored.extend(points);
    }

    pub fn finish(mut self, closed: bool, convex: bool) -> Mesh {
        (self.mesh.closed, self.mesh.convex) = (closed, convex);
        self.mesh
    }
}
