//! The object: which shape, how finely it is made of polygons, and where its vertex normals come from.

use super::Shared;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Object {
    pub kind: ObjectKind,
    /// Polygons round the axis, 3 to [`Object::MAX_DIVISIONS`].
    pub segments: u32,
    /// Polygons along the axis, 1 to [`Object::MAX_DIVISIONS`] (a sphere and a torus need 2 and 3).
    pub rings: u32,
    pub normals: NormalSource,
    pub weighting: Weighting,
    /// The model's file, `kind = "obj"` only; in a scene file relative to that file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<PathBuf>,
    /// Whether a model is centred and scaled into the unit sphere, `kind = "obj"` only.
    pub fit: bool,
    /// Vertices that `faces` are made over, `kind = "polygons"` only; world.
    #[serde(skip_serializing_if = "is_empty")]
    pub vertices: Shared<DVec3>,
    /// The vertices of each polygon by their numbers from 0, counter-clockwise from outside, `kind = "polygons"` only.
    #[serde(skip_serializing_if = "is_empty")]
    pub faces: Shared<Shared<u32>>,
    /// The normal at each of `vertices`, of any length but zero, for `normals = "file"`; or none.
    #[serde(skip_serializing_if = "is_empty")]
    pub vertex_normals: Shared<DVec3>,
}

impl Object {
    /// The finest tessellation in either direction: 4096 × 4096 quads are 33 million triangles.
    pub const MAX_DIVISIONS: u32 = 4096;
}

fn is_empty<T>(list: &[T]) -> bool {
    list.is_empty()
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

/// The shapes. All but models and polygons fit into the unit sphere about the origin, the plane but for its corners. Their
/// axis is y, but for the plane and the corrugated sheet, which face +z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ObjectKind {
    /// Radius 1.
    Sphere,
    /// Radius 0.7 of the ring, 0.3 of the tube.
    Torus,
    /// Radius 0.6, from y = −0.8 to 0.8, with caps.
    Cylinder,
    /// Radius 0.8 at y = −0.6, apex at y = 1, with a cap.
    Cone,
    /// Half an edge is 1/√3.
    Cube,
    /// The square −1 ≤ x, y ≤ 1 in the plane z = 0, facing +z.
    Plane,
    /// Newell's teapot.
    Teapot,
    /// A sheet folded to and fro at ridges parallel to y, facing +z: −0.75 ≤ x ≤ 0.75, −0.65 ≤ y ≤ 0.65, between z = −0.1
    /// and 0.1. `segments` slopes, at least 2, the first rising from a trough at its left border.
    Corrugated,
    /// A Wavefront OBJ model.
    Obj,
    /// Polygons of the scene itself.
    Polygons,
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

/// Where vertex normals come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NormalSource {
    /// The mean of the normals of the polygons that meet at the vertex.
    Averaged,
    /// The true surface's.
    Exact,
    /// The model file's, where it has them; averaged where it has none.
    File,
    /// Each polygon's own.
    Facet,
}

/// The weight of each polygon in an averaged vertex normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Weighting {
    /// One each (Gouraud 1971).
    Equal,
    /// By the polygon's area.
    Area,
    /// By the polygon's interior angle at the vertex (Thürmer and Wüthrich 1998).
    Angle,
}
