//! Puts the pieces that `tobj` read together to one mesh over shared points.

use super::error::ObjError;
use crate::geometry::concave::fan_or_triangles;
use crate::geometry::mesh::{Corner, Mesh, NO_NORMAL};
use glam::{DVec3, Vec3};
use std::collections::HashMap;

/// The mesh of all pieces, with positions relative to `origin`. Each piece is let go once it is in.
pub fn mesh(pieces: Vec<tobj::Model>, origin: DVec3) -> Result<Mesh, ObjError> {
    let corners: usize = pieces.iter().map(|piece| piece.mesh.indices.len()).sum();
    if u32::try_from(corners).is_err() {
        return Err(ObjError::TooLarge);
    }
    let mut assembly = Assembly { mesh: Mesh { origin, starts: vec![0], ..Mesh::default() }, points: HashMap::new() };
    assembly.mesh.corners.reserve_exact(corners);
    assembly.mesh.starts.reserve_exact(pieces.iter().map(|piece| face_count(&piece.mesh)).sum());
    for piece in pieces {
        assembly.add(&piece.mesh);
    }
    let mut mesh = assembly.mesh;
    mesh.positions.shrink_to_fit();
    mesh.normals.shrink_to_fit();
    mesh.starts.shrink_to_fit();
    if mesh.face_count() == 0 { Err(ObjError::NoFace) } else { Ok(mesh.with_closedness_detected()) }
}

struct Assembly {
    mesh: Mesh,
    /// The point at each place, by the bits of its coordinates.
    points: HashMap<[u32; 3], u32>,
}

impl Assembly {
    fn add(&mut self, piece: &tobj::Mesh) {
        let points: Vec<u32> = vectors(&piece.positions).map(|position| self.point(position)).collect();
        let normals: Vec<u32> = vectors(&piece.normals).map(|normal| self.normal(normal)).collect();
        let mut face = Vec::new();
        let mut begin = 0;
        for f in 0..face_count(piece) {
            let end = begin + piece.face_arities.get(f).map_or(3, |&arity| arity as usize);
            face.clear();
            face.extend((begin..end).map(|c| Corner {
                position: points[piece.indices[c] as usize],
                normal: piece.normal_indices.get(c).map_or(NO_NORMAL, |&normal| normals[normal as usize]),
            }));
            begin = end;
            self.add_face(&mut face);
        }
    }

    fn point(&mut self, position: Vec3) -> u32 {
        // Adding zero makes −0 and 0 one.
        let position = position + 0.0;
        let positions = &mut self.mesh.positions;
        *self.points.entry(position.to_array().map(f32::to_bits)).or_insert_with(|| {
            positions.push(position);
            positions.len() as u32 - 1
        })
    }

    fn normal(&mut self, normal: Vec3) -> u32 {
        if normal == Vec3::ZERO {
            return NO_NORMAL;
        }
        self.mesh.normals.push(normal);
        self.mesh.normals.len() as u32 - 1
    }

    /// Adds a face without the corners that repeat the one before, if three are left.
    fn add_face(&mut self, face: &mut Vec<Corner>) {
        face.dedup_by_key(|corner| corner.position);
        while face.len() > 1 && face.first().map(|c| c.position) == face.last().map(|c| c.position) {
            face.pop();
        }
        if face.len() < 3 {
            return;
        }
        let mesh = &mut self.mesh;
        let positions = &mesh.positions;
        fan_or_triangles(
            face,
            |corner| positions[corner.position as usize].as_dvec3(),
            |polygon| {
                mesh.corners.extend_from_slice(polygon);
                mesh.starts.push(mesh.corners.len() as u32);
            },
        );
    }
}

/// Faces of a piece, which lists no arities where all are triangles.
fn face_count(piece: &tobj::Mesh) -> usize {
    if piece.face_arities.is_empty() { piece.indices.len() / 3 } else { piece.face_arities.len() }
}

fn vectors(numbers: &[f32]) -> impl Iterator<Item = Vec3> {
    numbers.chunks_exact(3).map(Vec3::from_slice)
}
