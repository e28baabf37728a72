//! The geometry stage's output: polygons, and a mesh as structures of arrays.

use super::face_materials::FaceMaterials;
use super::lens::DEEPEST;
use super::node::{Memory, capacity, capacity_of_planes};
use crate::geometry::{Mesh, VertexMesh, tessellate};
use crate::illumination::direction;
use crate::scene::{Camera, Object, Rgb, area_vector};
use glam::{DVec3, Vec3};
use std::collections::HashMap;
use std::sync::{Arc, OnceLock};

/// The multiple to which arrays are padded: the widest vector's lanes.
pub const PADDING: usize = 16;

/// The number of corners above which a face's centre and normal are stored, since a profile reads them at every point of its line.
const MANY: usize = 32;

/// Three planes of numbers, one for each component or channel.
pub type Planes = [Vec<f32>; 3];

/// A model's own polygons, or those of a shape. A shape's are freed once they are in the arrays, and made again on request.
#[derive(Default)]
pub struct MeshSource {
    pub mesh: OnceLock<Arc<Mesh>>,
    /// The shape that they are made from; `None` for a model.
    pub shape: Option<Object>,
}

impl MeshSource {
    pub fn mesh(&self) -> &Arc<Mesh> {
        self.mesh.get_or_init(|| {
            self.shape
                .as_ref()
                .map_or_else(Arc::default, |shape| Arc::new(tessellate(shape)))
        })
    }

    /// Frees a shape's polygons, unless they are shared.
    pub fn release(&mut self) {
        let shared = self
            .mesh
            .get()
            .is_some_and(|mesh| Arc::strong_count(mesh) > 1);
        if self.shape.is_some() && !shared {
            self.mesh.take();
        }
    }

    pub fn count(&self, memory: &mut Memory) {
        if let Some(mesh) = self.mesh.get() {
            memory.vertices +=
                capacity(&mesh.positions) + capacity(&mesh.normals) + capacity(&mesh.mirrored);
            memory.triangles += capacity(&mesh.starts)
                + capacity(&mesh.corners)
                + capacity(&mesh.cut)
                + capacity(&mesh.face_materials)
                + capacity(&mesh.corner_colors);
            memory.vertices += capacity(&mesh.colors);
        }
    }
}

/// A mesh for the kernels.
#[derive(Default)]
pub struct Model {
    /// The world position of (0, 0, 0) in the arrays.
    pub origin: DVec3,
    /// The number of vertices without the padding.
    pub vertex_count: usize,
    /// The radius about `origin` that holds every vertex, world units.
    pub radius: f64,
    /// The coordinates and normals of the vertices, padded by zeros.
    pub position: Planes,
    pub normal: Planes,
    /// The colours of the vertices that tint Od, padded; empty where they have none.
    pub tint: Planes,
    /// The vertices of each triangle, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    pub faces: Vec<u32>,
    /// The faces themselves: face f has the vertices `indices[starts[f]..starts[f + 1]]`.
    pub starts: Vec<u32>,
    pub indices: Vec<u32>,
    pub closed: bool,
    pub convex: bool,
    /// The materials of the faces.
    pub face_materials: FaceMaterials,
    /// The material of each vertex, an index into these; empty where all have the same.
    pub vertex_materials: Vec<u16>,
    /// The centre and normal of each face of many corners.
    pub large: OnceLock<HashMap<u32, [DVec3; 2]>>,
}

impl Model {
    pub fn new(mut mesh: VertexMesh) -> Self {
        mesh.starts.shrink_to_fit();
        mesh.corners.shrink_to_fit();
        let face_materials = FaceMaterials::of(&mesh);
        order_by_material(&mut mesh, &face_materials.faces);
        let vertex_materials = vertex_materials(&mesh, &face_materials.faces);
        let tint = tints(&mesh);
        let count = mesh.triangle_count();
        let (mut triangles, mut faces) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for face in 0..mesh.face_count() {
            triangles.extend(mesh.face_triangles(face));
            faces.resize(triangles.len(), face as u32);
        }
        Self {
            origin: mesh.origin,
            vertex_count: mesh.positions.len(),
            radius: mesh.radius(),
            position: planes(&mesh.positions),
            normal: planes(&mesh.normals),
            tint,
            triangles,
            faces,
            starts: mesh.starts,
            indices: mesh.corners,
            closed: mesh.closed,
            convex: mesh.convex,
            face_materials,
            vertex_materials,
            large: OnceLock::new(),
        }
    }

    pub fn count(&self, memory: &mut Memory) {
        memory.vertices += capacity_of_planes(&self.position) + capacity_of_planes(&self.normal);
        memory.vertices += capacity_of_planes(&self.tint);
        memory.triangles += capacity(&self.triangles)
            + capacity(&self.faces)
            + capacity(&self.starts)
            + capacity(&self.indices)
            + capacity(&self.face_materials.faces);
        memory.vertices += capacity(&self.vertex_materials);
    }

    /// Returns the world units to one camera distance.
    pub fn unit(&self, camera: &Camera) -> f64 {
        let farthest = (self.origin - camera.eye).length() + self.radius;
        camera.distance().max(farthest / DEEPEST)
    }

    pub fn face_count(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    pub fn padded_len(&self) -> usize {
        self.position[0].len()
    }

    pub fn face(&self, face: u32) -> &[u32] {
        let face = face as usize;
        &self.indices[self.starts[face] as usize..self.starts[face + 1] as usize]
    }

    pub fn triangles_of(&self, face: u32) -> &[[u32; 3]] {
        let [begin, end] = [face, face + 1].map(|next| self.faces.partition_point(|f| *f < next));
        &self.triangles[begin..end]
    }

    /// Returns the position of a vertex relative to `origin`.
    pub fn place(&self, vertex: u32) -> Vec3 {
        vector_at(&self.position, vertex)
    }

    pub fn position(&self, vertex: u32) -> DVec3 {
        self.origin + vector_at(&self.position, vertex).as_dvec3()
    }

    pub fn normal(&self, vertex: u32) -> DVec3 {
        vector_at(&self.normal, vertex).as_dvec3()
    }

    /// Returns the colour of a vertex that tints Od.
    pub fn tint(&self, vertex: u32) -> Rgb {
        self.mean_tint(&[(vertex, 1.0)])
    }

    /// Returns the weighted mean of the colours of vertices; white where they have none.
    pub fn mean_tint(&self, vertices: &[(u32, f64)]) -> Rgb {
        if !self.is_tinted() {
            return Rgb::ONE;
        }
        let tint = |&(v, weight): &(u32, f64)| vector_at(&self.tint, v).as_dvec3() * weight;
        vertices.iter().map(tint).sum()
    }

    /// Returns the mean of the colours of a face's corners.
    pub fn face_tint(&self, face: u32) -> Rgb {
        let corners = self.face(face);
        let weight = 1.0 / corners.len().max(1) as f64;
        let corners: Vec<_> = corners.iter().map(|&v| (v, weight)).collect();
        self.mean_tint(&corners)
    }

    /// Returns whether vertices have colours.
    pub fn is_tinted(&self) -> bool {
        !self.tint[0].is_empty()
    }

    pub fn face_centre(&self, face: u32) -> DVec3 {
        self.of_large(face)
            .map_or_else(|| self.origin + self.mean(face), |[centre, _]| centre)
    }

    /// Returns the unit normal of a face by Newell's formula; zero for a face without area.
    pub fn face_normal(&self, face: u32) -> DVec3 {
        self.of_large(face)
            .map_or_else(|| self.newell(face), |[_, normal]| normal)
    }

    /// Returns the stored centre and normal of a face of many corners.
    fn of_large(&self, face: u32) -> Option<[DVec3; 2]> {
        let is_large = |face: &u32| self.face(*face).len() > MANY;
        if !is_large(&face) {
            return None;
        }
        let of = |face| (face, [self.origin + self.mean(face), self.newell(face)]);
        let large = self.large.get_or_init(|| {
            (0..self.face_count() as u32)
                .filter(is_large)
                .map(of)
                .collect()
        });
        large.get(&face).copied()
    }

    /// Returns the corners of a face relative to `origin`.
    fn corners(&self, face: u32) -> impl Iterator<Item = DVec3> {
        self.face(face)
            .iter()
            .map(move |&v| self.place(v).as_dvec3())
    }

    fn mean(&self, face: u32) -> DVec3 {
        self.corners(face).sum::<DVec3>() / self.face(face).len().max(1) as f64
    }

    fn newell(&self, face: u32) -> DVec3 {
        direction(area_vector(self.corners(face)))
    }
}

/// The vertices among which those of one material are put together: some thousands, which a core's cache holds.
const WINDOW: usize = 1 << 14;

/// Puts the vertices of each material together, so that they are read in their order where they are shaded.
fn order_by_material(mesh: &mut VertexMesh, face_materials: &[u16]) {
    if face_materials.is_empty() {
        return;
    }
    let materials = vertex_materials(mesh, face_materials);
    let mut order: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    for window in order.chunks_mut(WINDOW) {
        window.sort_by_key(|vertex| materials[*vertex as usize]);
    }
    let ordered = |vectors: &[Vec3]| order.iter().map(|old| vectors[*old as usize]).collect();
    (mesh.positions, mesh.normals) = (ordered(&mesh.positions), ordered(&mesh.normals));
    let mut places = vec![0; order.len()];
    for (new, old) in (0..).zip(&order) {
        places[*old as usize] = new;
    }
    for corner in &mut mesh.corners {
        *corner = places[*corner as usize];
    }
}

/// Returns the material of each vertex, which that of its faces is, padded as the vertices are.
fn vertex_materials(mesh: &VertexMesh, face_materials: &[u16]) -> Vec<u16> {
    if face_materials.is_empty() {
        return vec![];
    }
    let mut materials = vec![0; mesh.positions.len().next_multiple_of(PADDING)];
    for (face, material) in face_materials.iter().enumerate() {
        for vertex in mesh.face(face) {
            materials[*vertex as usize] = *material;
        }
    }
    materials
}

/// Returns the colour of each vertex, which that of its corners is.
fn tints(mesh: &VertexMesh) -> Planes {
    if mesh.corner_colors.is_empty() {
        return Planes::default();
    }
    let mut colors = vec![Vec3::ONE; mesh.positions.len()];
    for (corner, vertex) in mesh.corners.iter().enumerate() {
        colors[*vertex as usize] = mesh.corner_color(corner);
    }
    planes(&colors)
}

fn vector_at(planes: &Planes, vertex: u32) -> Vec3 {
    let v = vertex as usize;
    Vec3::new(planes[0][v], planes[1][v], planes[2][v])
}

fn planes(vectors: &[Vec3]) -> Planes {
    let padded = vectors.len().next_multiple_of(PADDING);
    [0, 1, 2].map(|axis| {
        let mut plane = Vec::with_capacity(padded);
        plane.extend(vectors.iter().map(|v| v[axis]));
        plane.resize(padded, 0.0);
        plane
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shapes_polygons_are_let_go_and_made_again_but_a_model_is_kept() {
        let mut source = MeshSource {
            shape: Some(Object::default()),
            ..MeshSource::default()
        };
        let first = Arc::clone(source.mesh());
        source.release();
        assert!(Arc::ptr_eq(&first, source.mesh()), "what is shared is kept");
        let (positions, corners) = (first.positions.clone(), first.corners.clone());
        drop(first);
        source.release();
        assert!(source.mesh.get().is_none());
        assert_eq!(
            (&source.mesh().positions, &source.mesh().corners),
            (&positions, &corners)
        );
        let model = Arc::new(tessellate(&Object::default()));
        let mut source = MeshSource {
            mesh: Arc::clone(&model).into(),
            shape: None,
        };
        source.release();
        assert!(Arc::ptr_eq(&model, source.mesh()));
    }
}
