//! The polygons that a scene gives itself.

use crate::geometry::concave::fan_or_triangles;
use crate::geometry::mesh::{Corner, FAR, Mesh, NO_NORMAL};
use crate::scene::{Object, Polygons};
use glam::DVec3;

/// Faces share the points that they name by the same number, and no others: a vertex upon another, or upon an edge, is a
/// vertex of its own. Faces that name an unknown vertex, or fewer than three, are left out; a concave one is turned or cut
/// as a model's is.
pub fn polygons(object: &Object) -> Mesh {
    let Polygons { vertices, faces, normals } = object.polygons();
    let origin = match vertices.first() {
        Some(first) if first.is_finite() && first.abs().max_element() > FAR => first.round(),
        _ => DVec3::ZERO,
    };
    let mut mesh = Mesh { origin, starts: vec![0], ..Mesh::default() };
    mesh.positions = vertices.iter().map(|vertex| (vertex - origin).as_vec3()).collect();
    if normals.len() == vertices.len() {
        mesh.normals = normals.iter().map(|normal| normal.normalize_or(DVec3::Z).as_vec3()).collect();
    }
    let given = !mesh.normals.is_empty();
    let corner = |&v: &u32| Corner { position: v, normal: if given { v } else { NO_NORMAL } };
    for face in faces.iter().filter(|face| face.len() >= 3 && face.iter().all(|&v| (v as usize) < vertices.len())) {
        let mut face: Vec<Corner> = face.iter().map(corner).collect();
        fan_or_triangles(
            &mut face,
            |corner| vertices[corner.position as usize] - origin,
            |polygon| {
                mesh.corners.extend_from_slice(polygon);
                mesh.starts.push(mesh.corners.len() as u32);
            },
        );
    }
    mesh.with_closedness_detected()
}
