//! Shapes: meshes of n-sided polygons, their vertex normals, and the true surfaces that they stand for.

mod mesh;

pub use mesh::{Corner, Mesh, NO_NORMAL, VertexMesh};
