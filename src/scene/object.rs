//! The object: which shape, how finely it is made of polygons, and where its vertex normals come from.

use super::Shared;
use super::choice::choices;
use glam::DVec3;
use std::path::PathBuf;

#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    pub kind: ObjectKind,
    /// Polygons round the axis, 3 to [`Object::MAX_DIVISIONS`].
    pub segments: u32,
    /// Polygons along the axis, 1 to [`Object::MAX_DIVISIONS`] (a sphere and a torus need 2 and 3).
    pub rings: u32,
    pub normals: NormalSource,
    pub weighting: Weighting,
    /// The model's file, `kind = "obj"` only; in a scene file relative to that file.
    pub path: Option<PathBuf>,
    /// Whether a model is centred and scaled into the unit sphere, `kind = "obj"` only.
    pub fit: bool,
    /// Vertices that `faces` are made over, `kind = "polygons"` only; world.
    pub vertices: Shared<DVec3>,
    /// The vertices of each polygon by their numbers from 0, counter-clockwise from outside, `kind = "polygons"` only.
    pub faces: Shared<Shared<u32>>,
    /// The normal at each of `vertices`, of any length but zero, for `normals = "file"`; or none.
    pub vertex_normals: Shared<DVec3>,
}

impl Object {
    /// The finest tessellation in either direction: 4096 × 4096 quads are 33 million triangles.
    pub const MAX_DIVISIONS: u32 = 4096;
}

impl Default for Object {
    fn default() -> Self {
        Self {
            kind: ObjectKind::Sphere,
            segments: 32,
            rings: 16,
            normals: NormalSource::Averaged,
            weighting: Weighting::Equal,
            path: None,
            fit: true,
            vertices: Shared::default(),
            faces: Shared::default(),
            vertex_normals: Shared::default(),
        }
    }
}

choices! {
    /// The shapes. All but models and polygons fit into the unit sphere about the origin, the plane but for its corners. Their
    /// axis is y, but for the plane and the corrugated sheet, which face +z.
    pub enum ObjectKind {
        /// Radius 1.
        Sphere = "sphere", "sphere", "";
        /// Radius 0.7 of the ring, 0.3 of the tube.
        Torus = "torus", "torus", "";
        /// Radius 0.6, from y = −0.8 to 0.8, with caps.
        Cylinder = "cylinder", "cylinder", "";
        /// Radius 0.8 at y = −0.6, apex at y = 1, with a cap.
        Cone = "cone", "cone", "";
        /// Half an edge is 1/√3.
        Cube = "cube", "cube", "";
        /// The square −1 ≤ x, y ≤ 1 in the plane z = 0, facing +z.
        Plane = "plane", "plane", "";
        /// Newell's teapot.
        Teapot = "teapot", "teapot", "Martin Newell's, made of 32 patches";
        /// A sheet folded to and fro at ridges parallel to y, facing +z: −0.75 ≤ x ≤ 0.75, −0.65 ≤ y ≤ 0.65, between z = −0.1
        /// and 0.1. `segments` slopes, at least 2, the first rising from a trough at its left border.
        Corrugated = "corrugated", "corrugated sheet", "Folded to and fro: undivided slopes average to one normal";
        /// Polygons of the scene itself.
        Polygons = "polygons", "polygons", "The scene's own; their vertices can be dragged in the picture";
        /// A Wavefront OBJ model.
        Obj = "obj", "model from a file", "A Wavefront OBJ file";
    }
}

impl ObjectKind {
    /// Whether it faces +z, so that this is its axis; otherwise that is y.
    pub fn faces_viewer(self) -> bool {
        matches!(self, Self::Plane | Self::Corrugated)
    }

    /// Whether there is a true surface that the polygons stand for. A model and a scene's own polygons are all there is.
    pub fn has_surface(self) -> bool {
        !matches!(self, Self::Obj | Self::Polygons)
    }
}

choices! {
    /// Where vertex normals come from.
    pub enum NormalSource {
        Averaged = "averaged", "averaged", "The mean of the polygons that meet at the vertex";
        Exact = "exact", "true surface's", "Those of the surface that the polygons approximate";
        File = "file", "from the file", "As the model or the scene file gives them; averaged where it gives none";
        Facet = "facet", "each polygon's own", "No smoothing";
    }
}

choices! {
    /// The weight of each polygon in an averaged vertex normal.
    pub enum Weighting {
        Equal = "equal", "equal", "The same for each polygon (Gouraud 1971)";
        Area = "area", "by area", "The larger the polygon, the more";
        Angle = "angle", "by angle", "By the polygon's angle at the vertex (Thürmer and Wüthrich 1998)";
    }
}
