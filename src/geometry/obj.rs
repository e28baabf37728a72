//! Wavefront OBJ models.
//!
//! In: the file's bytes. Out: one [`Mesh`] of all its polygons, or the first error with its line. The file is read once,
//! line by line. The libraries of its materials are read last, so that `usemtl` may come before `mtllib`.
//!
//! Texture coordinates, groups, lines, points and free-form surfaces are ignored.

mod lines;
mod materials;

use super::mesh::{Corner, FAR, Mesh, NO_NORMAL};
use crate::text::text;
use glam::{DVec3, Vec3};
pub use lines::ObjError;
use lines::{Line, Lines, error_at, malformed, quoted};
pub use materials::OpenLibrary;
use materials::Uses;
use std::collections::HashMap;
use std::io::BufRead;

/// Reads a model without the libraries of its materials, see [`read_model`].
///
/// Vertices with equal coordinates become one point, so that averaging sees every face there; consecutive duplicate
/// corners, and faces that this leaves with fewer than three, are dropped; a concave polygon stays one, see
/// [`Mesh::with_concave_faces_cut`]. A single number after the coordinates of a vertex is its weight and divides them, three
/// are its colour, from 0 to 1. Normals are made unit vectors; one that is zero or not finite
/// counts as not given. Coordinates far from the origin are taken relative to the first vertex, in double precision.
///
/// Memory stays below six times the size of the file.
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
    read_model(reader, progress, &mut |_| {
        Err(text!(
            "document-no-such-file",
            expected = text!("document-library")
        ))
    })
}

/// Reads a model, reporting to `progress` now and then how many bytes have been read. The libraries of its materials are
/// asked for by name; what cannot be read of them is among [`Mesh::remarks`].
///
/// # Errors
/// [`ObjError`], with the line where there is one.
pub fn read_model(
    reader: impl BufRead,
    progress: &mut dyn FnMut(u64),
    open: OpenLibrary<'_>,
) -> Result<Mesh, ObjError> {
    let (mut lines, mut builder) = (Lines::new(reader, progress), Builder::default());
    builder.mesh.starts.push(0);
    while let Some(line) = lines.next()? {
        builder
            .line(&line)
            .map_err(|what| error_at(line.number, what))?;
    }
    if lines.bytes == 0 {
        return Err(ObjError::Empty);
    }
    let mesh = builder.finish(open);
    if mesh.face_count() == 0 {
        Err(ObjError::NoFace)
    } else if u32::try_from(mesh.corners.len()).is_err() {
        Err(ObjError::TooLarge)
    } else {
        Ok(mesh.with_concave_faces_cut().with_closedness_detected())
    }
}

/// The number of a vertex that no face has used.
const UNUSED: u32 = u32::MAX;

/// A model of the lines read so far. Errors are sentences.
#[derive(Default)]
struct Builder {
    mesh: Mesh,
    /// The vertices relative to the origin, each with the number of its point in the mesh once a face uses it.
    vertices: Vec<(Vec3, u32)>,
    /// The normals, each with its number in the mesh once a face uses it; zero vectors stand for useless ones.
    normals: Vec<(Vec3, u32)>,
    /// The point at each place, by the bits of its coordinates.
    points: HashMap<[u32; 3], u32>,
    materials: Uses,
    /// The colours of the vertices, each with its number in the mesh once a face uses it; empty while none has a colour.
    colors: Vec<(Vec3, u32)>,
}

impl Builder {
    fn line(&mut self, line: &Line) -> Result<(), String> {
        let mut words = line
            .text
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty());
        match words.next() {
            Some(b"v") => self.position(line, words),
            Some(b"vn") => self.normal(words),
            Some(b"f" | b"fo") => self.face(line, words),
            Some(b"mtllib") => {
                self.materials
                    .library(after_keyword(line.text), line.number);
                Ok(())
            }
            Some(b"usemtl") => {
                self.materials
                    .material(after_keyword(line.text), line.number);
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn position<'w>(
        &mut self,
        line: &Line,
        mut words: impl Iterator<Item = &'w [u8]>,
    ) -> Result<(), String> {
        let (mut point, xyz) = vector(&mut words, "obj-coordinate", "obj-three-coordinates")?;
        let (first, more) = (words.next(), words.next());
        let color = more.map(|more| color_of([first, Some(more), words.next(), words.next()]));
        if let (Some(weight), None) = (first, more) {
            let weight = parse_number(weight, "obj-weight")?;
            if weight == 0.0 {
                return Err(text!("obj-weight-zero").to_owned());
            }
            point /= weight;
        }
        if color == Some(None) {
            let words = text!("obj-vertex-colours").to_owned();
            self.materials.remark(None, line.number, words);
        }
        self.color(color.flatten());
        if self.vertices.is_empty() && point.is_finite() && point.abs().max_element() > FAR {
            self.mesh.origin = point.round();
        }
        let relative = (point - self.mesh.origin).as_vec3();
        if let Some(k) = (0..3).find(|&k| !relative[k].is_finite()) {
            return Err(text!("obj-not-finite", word = quoted(xyz[k])));
        }
        // Adding zero makes −0 and 0 one.
        self.vertices.push((relative + 0.0, UNUSED));
        Ok(())
    }

    /// Notes the colour of the vertex to come; white beside others that have one.
    fn color(&mut self, color: Option<Vec3>) {
        if color.is_some() || !self.colors.is_empty() {
            self.colors.resize(self.vertices.len(), (Vec3::ONE, UNUSED));
            self.colors.push((color.unwrap_or(Vec3::ONE), UNUSED));
        }
    }

    fn normal<'w>(&mut self, mut words: impl Iterator<Item = &'w [u8]>) -> Result<(), String> {
        let (normal, _) = vector(&mut words, "obj-normal-component", "obj-three-components")?;
        let unit = normal.try_normalize().unwrap_or(DVec3::ZERO).as_vec3();
        self.normals.push((unit, NO_NORMAL));
        Ok(())
    }

    fn face<'w>(
        &mut self,
        line: &Line,
        words: impl Iterator<Item = &'w [u8]>,
    ) -> Result<(), String> {
        let mut corners = words
            .map(|word| self.corner(line, word))
            .collect::<Result<Vec<(Corner, usize)>, _>>()?;
        if corners.len() < 3 {
            return Err(text!("obj-few-vertices", count = corners.len()));
        }
        // A corner that repeats the one before is left out.
        corners.dedup_by_key(|(corner, _)| corner.position);
        while let [(first, _), .., (last, _)] = corners[..]
            && first.position == last.position
        {
            corners.pop();
        }
        if corners.len() >= 3 {
            if !self.colors.is_empty() {
                let before = self.mesh.corners.len();
                let white = self.mesh.corner_colors.len()..before;
                let white = white.map(|_| self.used_color(None)).collect::<Vec<_>>();
                self.mesh.corner_colors.extend(white);
                for (_, vertex) in &corners {
                    let color = self.used_color(Some(*vertex));
                    self.mesh.corner_colors.push(color);
                }
            }
            let corners = corners.into_iter().map(|(corner, _)| corner);
            self.mesh.corners.extend(corners);
            self.materials.face(self.mesh.face_count());
            self.mesh.starts.push(self.mesh.corners.len() as u32);
        }
        Ok(())
    }

    /// Reads a corner and the number of its vertex in the file.
    fn corner(&mut self, line: &Line, word: &[u8]) -> Result<(Corner, usize), String> {
        let mut fields = word.split(|&byte| byte == b'/');
        let [position, texture, normal] =
            [fields.next(), fields.next(), fields.next()].map(Option::unwrap_or_default);
        let empty_or_whole = |field: &[u8]| field.is_empty() || whole(field).is_some();
        // A file that ends behind a slash has been cut off.
        let cut_off = !line.ended && line.text.ends_with(b"/") && line.text.ends_with(word);
        let sound = whole(position).is_some() && empty_or_whole(texture) && empty_or_whole(normal);
        if fields.next().is_some() || cut_off || !sound {
            return Err(malformed(word, "obj-corner"));
        }
        let vertex = index("obj-no-such-vertex", position, self.vertices.len())?;
        let normal = if normal.is_empty() {
            NO_NORMAL
        } else {
            self.used_normal(index("obj-no-such-normal", normal, self.normals.len())?)
        };
        let position = self.point(vertex);
        Ok((Corner { position, normal }, vertex))
    }

    /// Returns the number in the mesh of the colour of a vertex of the file; of white without one.
    fn used_color(&mut self, vertex: Option<usize>) -> u32 {
        let mut white = (Vec3::ONE, UNUSED);
        let known = vertex.and_then(|vertex| self.colors.get_mut(vertex));
        let (color, number) = known.unwrap_or(&mut white);
        if *number == UNUSED {
            let colors = &mut self.mesh.colors;
            // Neighbours are often alike.
            if colors.last() != Some(color) {
                colors.push(*color);
            }
            *number = colors.len() as u32 - 1;
        }
        *number
    }

    /// Returns the number in the mesh of the point at a vertex of the file.
    fn point(&mut self, vertex: usize) -> u32 {
        let (position, point) = &mut self.vertices[vertex];
        if *point == UNUSED {
            let positions = &mut self.mesh.positions;
            *point = *self
                .points
                .entry(position.to_array().map(f32::to_bits))
                .or_insert_with(|| {
                    positions.push(*position);
                    positions.len() as u32 - 1
                });
        }
        *point
    }

    /// Returns the number in the mesh of a normal of the file.
    fn used_normal(&mut self, normal: usize) -> u32 {
        let (normal, number) = &mut self.normals[normal];
        if *number == NO_NORMAL && *normal != Vec3::ZERO {
            *number = self.mesh.normals.len() as u32;
            self.mesh.normals.push(*normal);
        }
        *number
    }

    fn finish(self, open: OpenLibrary<'_>) -> Mesh {
        let mut mesh = self.mesh;
        self.materials.resolve(&mut mesh, open);
        mesh.positions.shrink_to_fit();
        mesh.normals.shrink_to_fit();
        mesh.starts.shrink_to_fit();
        mesh.corners.shrink_to_fit();
        mesh.colors.shrink_to_fit();
        mesh.corner_colors.shrink_to_fit();
        mesh
    }
}

/// Returns what follows the keyword of a line.
fn after_keyword(line: &[u8]) -> &[u8] {
    let line = line.trim_ascii_start();
    let keyword = line.iter().position(u8::is_ascii_whitespace);
    line[keyword.unwrap_or(line.len())..].trim_ascii()
}

/// Reads three numbers, finite or not, and returns them with their words.
fn vector<'w>(
    words: &mut impl Iterator<Item = &'w [u8]>,
    one: &str,
    three: &str,
) -> Result<(DVec3, [&'w [u8]; 3]), String> {
    let mut xyz = [&[][..]; 3];
    let mut vector = DVec3::ZERO;
    for k in 0..3 {
        xyz[k] = words
            .next()
            .ok_or_else(|| text!("obj-few-numbers", count = k, expected = text!(three)))?;
        vector[k] = parse_number(xyz[k], one)?;
    }
    Ok((vector, xyz))
}

/// Returns the colour that these words give: three numbers from 0 to 1, as MeshLab writes them.
fn color_of<'w>(words: [Option<&'w [u8]>; 4]) -> Option<Vec3> {
    let channel = |word: Option<&'w [u8]>| {
        let number = parse_number(word?, "obj-coordinate").ok()?;
        (0.0..=1.0).contains(&number).then_some(number as f32)
    };
    let [r, g, b, None] = words else {
        return None;
    };
    Some(Vec3::new(channel(r)?, channel(g)?, channel(b)?))
}

fn parse_number(word: &[u8], expected: &str) -> Result<f64, String> {
    let number = std::str::from_utf8(word)
        .ok()
        .and_then(|text| text.parse().ok());
    number.ok_or_else(|| malformed(word, expected))
}

/// Splits a whole number of any length into sign and digits; `None` if it is not one.
fn whole(field: &[u8]) -> Option<(bool, &[u8])> {
    let (negative, digits) = match field {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    (!digits.is_empty() && digits.iter().all(u8::is_ascii_digit)).then_some((negative, digits))
}

/// Resolves a reference in a face to an index, where `count` items precede it; fails with the message `unknown` if there
/// is no such item.
fn index(unknown: &str, field: &[u8], count: usize) -> Result<usize, String> {
    let resolved = whole(field).and_then(|(negative, digits)| {
        let number: usize = std::str::from_utf8(digits).ok()?.parse().ok()?;
        (1..=count)
            .contains(&number)
            .then(|| if negative { count - number } else { number - 1 })
    });
    resolved.ok_or_else(|| text!(unknown, number = quoted(field), count = count))
}
