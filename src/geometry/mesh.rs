//! Meshes of n-sided polygons.

use glam::{DVec3, Vec3};

/// A corner of a polygon: which point, and which given normal there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Index into [`Mesh::positions`].
    pub position: u32,
    /// Index into [`Mesh::normals`], or [`NO_NORMAL`].
    pub normal: u32,
}

/// A corner without a given normal.
pub const NO_NORMAL: u32 = u32::MAX;

/// Polygons over shared points, as the shape or the file gives them.
///
/// Polygons are counter-clockwise seen from outside. Faces that meet at a point share its position, creases included,
/// so that averaging sees them all; `normals` may give each corner its own.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// World position of (0, 0, 0) in `positions`: large offsets stay in double precision.
    pub origin: DVec3,
    /// Distinct points, relative to `origin`.
    pub positions: Vec<Vec3>,
    /// Unit normals: the true surface's at the corners, or the file's.
    pub normals: Vec<Vec3>,
    /// Face f has the corners `corners[starts[f]..starts[f + 1]]`; one entry more than faces.
    pub starts: Vec<u32>,
    pub corners: Vec<Corner>,
    /// Every edge has a face on either side and the faces point outwards, so that from outside no back face is seen.
    pub closed: bool,
    /// Closed and convex: from outside no two front faces cover the same pixel.
    pub convex: bool,
}

/// A mesh ready to be shaded: a vertex is a point with one normal.
#[derive(Clone, Debug, Default)]
pub struct VertexMesh {
    /// World position of (0, 0, 0) in `positions`.
    pub origin: DVec3,
    /// One per vertex, relative to `origin`.
    pub positions: Vec<Vec3>,
    /// One per vertex, unit.
    pub normals: Vec<Vec3>,
    /// Face f has the vertices `indices[starts[f]..starts[f + 1]]`.
    pub starts: Vec<u32>,
    pub indices: Vec<u32>,
    /// Radius of a sphere about `origin` that holds every position.
    pub radius: f64,
    pub closed: bool,
    pub convex: bool,
}
