//! Shapes: meshes of n-sided polygons, their vertex normals, and the true surfaces that they stand for.

mod bezier;
mod mesh;
mod obj;
mod primitives;
mod surface;
mod teapot;
mod topology;
mod vertex_normals;

pub use mesh::{Corner, Mesh, NO_NORMAL, VertexMesh};
pub use obj::{ObjError, read_obj};
pub use primitives::tessellate;
pub use surface::{Ray, Surface, SurfaceHit};
