//! Wavefront OBJ models.
//!
//! In: the file's bytes. Out: one [`Mesh`] of all its polygons, or what is wrong in which line. Three steps:
//!
//! 1. `lines` joins continued lines, counts them and refuses what is not text;
//! 2. `prepare` checks every vertex, normal and face and writes them anew, plainly, for
//! 3. the crate `tobj`, which reads them into pieces; `assemble` puts these together.
//!
//! Texture coordinates, materials, groups, lines, points and free-form surfaces are passed over.

mod assemble;
mod error;
mod lines;
mod prepare;

use super::mesh::Mesh;
pub use error::ObjError;
use lines::Lines;
use prepare::Prepared;
use std::io::BufRead;

/// Reads a model; `progress` is told now and then how many bytes have been read.
///
/// Vertices with equal coordinates become one point, so that averaging sees every face there; duplicate corners in a row
/// and faces that this leaves with fewer than three are dropped; a polygon whose fan from its first corner would leave
/// its outline begins at another corner, or is cut into triangles. A fourth number of a vertex is its weight and divides
/// the others, further ones are colours and passed over. Normals are made unit vectors; one that is zero or not finite
/// counts as not given. Coordinates far from the origin are taken relative to the first vertex, in double precision.
///
/// Memory stays below six times the size of the file: `tobj` gets the faces in pieces.
///
/// # Errors
/// [`ObjError`], with the line where there is one.
pub fn read_obj(reader: impl BufRead, progress: &mut dyn FnMut(u64)) -> Result<Mesh, ObjError> {
    let mut prepared = Prepared::new(Lines::new(reader, progress));
    // No piece names a material library, so the loader of those is never asked.
    let loaded = tobj::load_obj_buf(&mut prepared, &tobj::LoadOptions::default(), |_| Err(tobj::LoadError::ReadError));
    let origin = prepared.finish()?;
    let (models, _) = loaded.map_err(ObjError::Refused)?;
    assemble::mesh(models, origin)
}
