//! The built-in shapes as polygons, with the normals of the true surface at every corner.
//!
//! In: an [`Object`]. Out: a [`Mesh`] whose points lie on the surface. `segments` counts polygons round the axis, `rings`
//! along it; azimuth runs from +z towards +x, so that it is counter-clockwise seen from +y.

mod count;
mod shapes;
mod teapot;

use super::balls::built_in;
use super::mesh::Mesh;
use super::sizes::{CONE, CYLINDER};
use crate::scene::{Object, ObjectKind};
pub use count::{divisions_for, triangles};

/// Returns the polygons of an object; an empty mesh for a model from a file, which brings its own.
///
/// | kind | polygons |
/// |---|---|
/// | sphere | `segments` × `rings` quads, triangles at the poles |
/// | torus | `segments` round the axis × `rings` round the tube |
/// | cylinder | `segments` × `rings` quads and two caps of `segments` sides |
/// | cone | `segments` × `rings` quads, triangles at the apex, and a base of `segments` sides |
/// | cube | each upright side `segments`/4 (at least 1) × `rings` quads, top and bottom `segments`/4 squared |
/// | plane | `segments` across (x) × `rings` down (y) |
/// | corrugated | `segments` slopes, each of `rings` strips from top to bottom |
/// | balls | three of 16 × 8, with a material each |
/// | polygons | those of the scene |
/// | teapot | each of its 32 patches `segments`/4 round × `rings`/4 along (at least 1; handle and spout 2 round), triangles at the poles |
///
/// Numbers of divisions that [`Scene::validate`](crate::scene::Scene) would reject are replaced by the nearest that it accepts.
pub fn tessellate(object: &Object) -> Mesh {
    let divisions = |number: u32, min: u32| number.clamp(min, Object::MAX_DIVISIONS);
    let segments = divisions(object.segments, 3);
    let rings = divisions(object.rings, 1);
    match object.kind {
        ObjectKind::Sphere => shapes::sphere(segments, rings.max(2)),
        ObjectKind::Torus => shapes::torus(segments, rings.max(3)),
        ObjectKind::Cylinder => shapes::frustum(&CYLINDER, segments, rings),
        ObjectKind::Cone => shapes::frustum(&CONE, segments, rings),
        ObjectKind::Cube => shapes::cube((segments / 4).max(1), rings),
        ObjectKind::Plane => shapes::plane(divisions(object.segments, 1), rings),
        ObjectKind::Corrugated => shapes::corrugated(divisions(object.segments, 2), rings),
        ObjectKind::Polygons => Mesh::from(&object.polygons()),
        ObjectKind::Teapot => teapot::teapot((rings / 4).max(1), (segments / 4).max(1)),
        ObjectKind::Balls => {
            built_in(object.kind).map_or_else(Mesh::default, |mesh| Mesh::clone(mesh))
        }
        ObjectKind::Obj => Mesh {
            starts: vec![0],
            ..Mesh::default()
        },
    }
}
