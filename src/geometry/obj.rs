//! Wavefront OBJ models.
//!
//! In: the file's bytes. Out: one [`Mesh`] of all its polygons, or the first error with its line. The file is read once,
//! line by line: `prepare` checks every vertex, normal and face and rewrites them plainly for the crate `tobj`, which reads
//! them into pieces; this module joins the pieces over shared points.
//!
//! Texture coordinates, materials, groups, lines, points and free-form surfaces are ignored; [`Mesh::names_materials`]
//! records that there are materials, so that the caller can say so.

mod prepare;

use super::mesh::{Corner, Mesh, NO_NORMAL};
use glam::Vec3;
pub use prepare::ObjError;
use prepare::{FileFacts, Lines, Prepared};
use std::collections::HashMap;
use std::io::{BufRead, BufReader};

/// Reads a model, reporting to `progress` now and then how many bytes have been read.
///
/// Vertices with equal coordinates become one point, so that averaging sees every face there; consecutive duplicate
/// corners, and faces that this leaves with fewer than three, are dropped; a concave polygon stays one, see
/// [`Mesh::with_concave_faces_cut`]. A fourth number of a vertex is its weight and divides
/// the others, further ones are colours and are ignored. Normals are made unit vectors; one that is zero or not finite
/// counts as not given. Coordinates far from the origin are taken relative to the first vertex, in double precision.
///
/// Memory stays below six times the size of the file: `tobj` gets the faces in pieces.
///
/// # Examples
/// ```
/// use shading_lab::geometry::read_obj;
///
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// let mesh = read_obj(text.as_bytes(), &mut |_bytes| {})?;
/// assert_eq!((mesh.positions.len(), mesh.face_count()), (3, 1));
///
/// let error = read_obj("v 0 0 0\nf 1 2 3\n".as_bytes(), &mut |_| {}).expect_err("two points are missing");
/// assert_eq!(error.line(), Some(2));
/// # Ok::<(), shading_lab::geometry::ObjError>(())
/// ```
///
/// # Errors
/// [`ObjError`], with the line where there is one.
pub fn read_obj(reader: impl BufRead, progress: &mut dyn FnMut(u64)) -> Result<Mesh, ObjError> {
    let mut prepared = Prepared::new(Lines::new(reader, progress));
    // No piece names a material library, so this loader is never called.
    let no_materials = |_: &std::path::Path| Err(tobj::LoadError::ReadError);
    let loaded = tobj::load_obj_buf(
        &mut BufReader::new(&mut prepared),
        &tobj::LoadOptions::default(),
        no_materials,
    );
    let facts = prepared.finish()?;
    let (pieces, _) = loaded.map_err(ObjError::Refused)?;
    put_together(pieces, facts)
}

/// Joins all pieces into one mesh, with positions relative to the origin. Each piece is freed once it is in.
fn put_together(pieces: Vec<tobj::Model>, facts: FileFacts) -> Result<Mesh, ObjError> {
    let corners: usize = pieces.iter().map(|piece| piece.mesh.indices.len()).sum();
    if u32::try_from(corners).is_err() {
        return Err(ObjError::TooLarge);
    }
    let mut mesh = Mesh {
        origin: facts.origin,
        names_materials: facts.names_materials,
        starts: vec![0],
        ..Mesh::default()
    };
    mesh.corners.reserve_exact(corners);
    mesh.starts
        .reserve_exact(pieces.iter().map(|piece| face_count(&piece.mesh)).sum());
    // The point at each place, by the bits of its coordinates.
    let mut points = HashMap::new();
    for piece in pieces {
        add_piece(&mut mesh, &mut points, &piece.mesh);
    }
    mesh.positions.shrink_to_fit();
    mesh.normals.shrink_to_fit();
    mesh.starts.shrink_to_fit();
    if mesh.face_count() == 0 {
        Err(ObjError::NoFace)
    } else {
        Ok(mesh.with_concave_faces_cut().with_closedness_detected())
    }
}

fn add_piece(mesh: &mut Mesh, known: &mut HashMap<[u32; 3], u32>, piece: &tobj::Mesh) {
    let Mesh {
        positions,
        normals,
        starts,
        corners,
        ..
    } = mesh;
    let points: Vec<u32> = vectors(&piece.positions)
        .map(|position| {
            // Adding zero makes −0 and 0 one.
            let position = position + 0.0;
            *known
                .entry(position.to_array().map(f32::to_bits))
                .or_insert_with(|| {
                    positions.push(position);
                    positions.len() as u32 - 1
                })
        })
        .collect();
    let given: Vec<u32> = vectors(&piece.normals)
        .map(|normal| {
            if normal == Vec3::ZERO {
                return NO_NORMAL;
            }
            normals.push(normal);
            normals.len() as u32 - 1
        })
        .collect();
    let mut face = Vec::new();
    let mut begin = 0;
    for f in 0..face_count(piece) {
        let end = begin + piece.face_arities.get(f).map_or(3, |&arity| arity as usize);
        face.clear();
        face.extend((begin..end).map(|c| {
            Corner {
                position: points[piece.indices[c] as usize],
                normal: piece
                    .normal_indices
                    .get(c)
                    .map_or(NO_NORMAL, |&normal| given[normal as usize]),
            }
        }));
        begin = end;
        // A corner that repeats the one before is left out.
        face.dedup_by_key(|corner| corner.position);
        while face.len() > 1 && face.first().map(|c| c.position) == face.last().map(|c| c.position)
        {
            face.pop();
        }
        if face.len() >= 3 {
            corners.extend_from_slice(&face);
            starts.push(corners.len() as u32);
        }
    }
}

/// Returns the number of faces in a piece; its list of arities is empty if all are triangles.
fn face_count(piece: &tobj::Mesh) -> usize {
    if piece.face_arities.is_empty() {
        piece.indices.len() / 3
    } else {
        piece.face_arities.len()
    }
}

fn vectors(numbers: &[f32]) -> impl Iterator<Item = Vec3> {
    numbers.chunks_exact(3).map(Vec3::from_slice)
}
