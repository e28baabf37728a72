//! Shapes: meshes of n-sided polygons, their vertex normals, and the true surfaces that they stand for.

mod balls;
mod bezier;
mod buckets;
mod concave;
mod descent;
mod mesh;
mod mtl;
mod obj;
mod primitives;
mod sizes;
mod surface;
mod teapot;
mod vector;
mod vertex_normals;

pub use balls::built_in;
pub(crate) use buckets::Buckets;
pub(crate) use descent::{Descent, nearer_first};
pub use mesh::{Corner, Mesh, NO_NORMAL, VertexMesh};
pub use mtl::{ModelMaterial, NO_MATERIAL, Remark};
pub use obj::{ObjError, OpenLibrary, read_model, read_obj};
pub use primitives::{divisions_for, tessellate, triangles};
pub use surface::{RAYS_TOGETHER, Ray, Surface, SurfaceHit};
pub(crate) use vector::{angle, cross, dot, load, splat, sub};
pub use vertex_normals::{FaceShare, NormalOrigin, VertexShares};
