//! Wavefront OBJ models in, meshes of n-sided polygons out.
//!
//! The file goes through [`Prepared`], which passes on only vertices, normals and faces, each checked and with the number
//! of its line at hand, so that an error says where it is; what it passes on is parsed by `tobj`.

use super::{Corner, Mesh, NO_NORMAL};
use glam::Vec3;
use std::io::{self, BufRead, Read};

/// The longest line that is read, in bytes, continuation lines included.
const LONGEST_LINE: usize = 1 << 20;
/// Bytes between two reports of progress.
const REPORT_EVERY: u64 = 1 << 20;

/// What is wrong with a model.
#[derive(Debug, thiserror::Error)]
#[error("{cause}")]
pub struct ObjError {
    /// Counted from 1; none where no one line is at fault.
    line: Option<u64>,
    cause: ObjCause,
}

/// Why a model cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ObjCause {
    #[error("cannot be read ({0}), expected a Wavefront OBJ model")]
    Io(io::Error),
    #[error("binary data, expected the text of a Wavefront OBJ model")]
    Binary,
    #[error("a line of over {LONGEST_LINE} bytes, expected shorter ones")]
    LongLine,
    #[error("{what} has {found} numbers, expected 3")]
    MissingNumber { what: &'static str, found: usize },
    #[error("\"{word}\" is not a number, expected a coordinate")]
    NotANumber { word: String },
    #[error("the coordinate {word} is not finite, expected a number below 3.4e38")]
    NotFinite { word: String },
    #[error("a face of {found} vertices, expected at least 3")]
    SmallFace { found: usize },
    #[error("\"{word}\" is not a corner of a face, expected v, v/vt, v//vn or v/vt/vn")]
    NotACorner { word: String },
    #[error("the {what} index {index} is out of range, expected 1 to {count} or -{count} to -1")]
    OutOfRange { what: &'static str, index: i64, count: usize },
    #[error("the model has no face, expected at least one line that begins with f")]
    NoFace,
    #[error("{0}, expected a Wavefront OBJ model")]
    Parser(tobj::LoadError),
}

impl ObjError {
    /// The line at fault, counted from 1.
    pub fn line(&self) -> Option<u64> {
        self.line
    }
}

/// Reads a model. `progress` is told now and then how many bytes have been read.
///
/// Groups, objects, materials, texture coordinates, lines and points are passed over: all faces make one mesh. Corners
/// keep the file's normals where it gives them.
///
/// # Errors
/// See [`ObjCause`].
pub fn read_obj(reader: impl BufRead, progress: &mut dyn FnMut(u64)) -> Result<Mesh, ObjError> {
    let mut prepared = Prepared::new(reader, progress);
    let options = tobj::LoadOptions { triangulate: false, single_index: false, ..Default::default() };
    let loaded = tobj::load_obj_buf(&mut prepared, &options, |_| Err(tobj::LoadError::OpenFileFailed));
    prepared.verdict()?;
    let (models, _) = loaded.map_err(|error| ObjError { line: None, cause: ObjCause::Parser(error) })?;
    let model = models.into_iter().next().ok_or(ObjError { line: None, cause: ObjCause::NoFace })?;
    Ok(assemble(model.mesh).with_closedness_detected())
}

fn assemble(mesh: tobj::Mesh) -> Mesh {
    let vectors = |numbers: &[f32]| -> Vec<Vec3> { numbers.chunks_exact(3).map(Vec3::from_slice).collect() };
    let positions = vectors(&mesh.positions);
    let mut normals = vectors(&mesh.normals);
    // Corners without a normal were given one of no length.
    let given: Vec<bool> = normals.iter().map(|n| n.length_squared() > 0.0).collect();
    normals.iter_mut().for_each(|n| *n = n.normalize_or(Vec3::Z));
    let corner = |(position, normal): (&u32, &u32)| {
        let has = given.get(*normal as usize).copied().unwrap_or(false);
        Corner { position: *position, normal: if has { *normal } else { NO_NORMAL } }
    };
    let corners: Vec<Corner> = mesh.indices.iter().zip(&mesh.normal_indices).map(corner).collect();
    let mut starts = vec![0];
    if mesh.face_arities.is_empty() {
        starts.extend((1..=corners.len() / 3).map(|face| u32::try_from(3 * face).unwrap_or(u32::MAX)));
    } else {
        starts.extend(mesh.face_arities.iter().scan(0, |end, arity| {
            *end += arity;
            Some(*end)
        }));
    }
    Mesh { positions, normals, starts, corners, ..Mesh::default() }
}

/// The lines that matter, rewritten one by one into the simplest form that means the same.
struct Prepared<'a, R> {
    reader: R,
    progress: &'a mut dyn FnMut(u64),
    read: u64,
    reported: u64,
    line: u64,
    /// The lines that the present logical line spans.
    raw: Vec<u8>,
    out: Vec<u8>,
    taken: usize,
    vertices: usize,
    normals: usize,
    faces: usize,
    /// The greatest index of a vertex and of a normal so far, and where: indices may point ahead.
    furthest: [(i64, u64); 2],
    error: Option<ObjError>,
}

impl<'a, R: BufRead> Prepared<'a, R> {
    fn new(reader: R, progress: &'a mut dyn FnMut(u64)) -> Self {
        Self {
            reader,
            progress,
            read: 0,
            reported: 0,
            line: 0,
            raw: Vec::new(),
            // The first normal stands for none.
            out: b"vn 0 0 0\n".to_vec(),
            taken: 0,
            vertices: 0,
            normals: 0,
            faces: 0,
            furthest: [(0, 0); 2],
            error: None,
        }
    }

    /// What the whole file came to.
    fn verdict(&mut self) -> Result<(), ObjError> {
        (self.progress)(self.read);
        if let Some(error) = self.error.take() {
            return Err(error);
        }
        for (what, (index, line), count) in
            [("vertex", self.furthest[0], self.vertices), ("normal", self.furthest[1], self.normals)]
        {
            if usize::try_from(index).is_ok_and(|index| index > count) {
                return Err(ObjError { line: Some(line), cause: ObjCause::OutOfRange { what, index, count } });
            }
        }
        if self.faces == 0 {
            return Err(ObjError { line: None, cause: ObjCause::NoFace });
        }
        Ok(())
    }

    /// Reads on until there is something to pass on; leaves `out` empty at the end of the file.
    fn advance(&mut self) -> Result<(), ObjCause> {
        self.out.clear();
        self.taken = 0;
        while self.out.is_empty() && self.read_logical_line()? {
            let raw = std::mem::take(&mut self.raw);
            let result = self.rewrite(&raw);
            self.raw = raw;
            result?;
        }
        Ok(())
    }

    /// Reads a line and those that continue it; tells whether there was one.
    fn read_logical_line(&mut self) -> Result<bool, ObjCause> {
        self.raw.clear();
        loop {
            let limit = (LONGEST_LINE - self.raw.len()) as u64;
            let count = self.reader.by_ref().take(limit).read_until(b'\n', &mut self.raw).map_err(ObjCause::Io)?;
            if count == 0 {
                return if limit == 0 { Err(ObjCause::LongLine) } else { Ok(!self.raw.is_empty()) };
            }
            self.line += 1;
            self.count(count as u64);
            if self.raw.len() >= LONGEST_LINE {
                return Err(ObjCause::LongLine);
            }
            while self.raw.last().is_some_and(|byte| matches!(byte, b'\n' | b'\r')) {
                self.raw.pop();
            }
            if self.raw.last() != Some(&b'\\') {
                return Ok(true);
            }
            self.raw.pop();
            self.raw.push(b' ');
        }
    }

    fn count(&mut self, bytes: u64) {
        self.read += bytes;
        if self.read - self.reported >= REPORT_EVERY {
            self.reported = self.read;
            (self.progress)(self.read);
        }
    }

    fn rewrite(&mut self, raw: &[u8]) -> Result<(), ObjCause> {
        let raw = if self.line == 1 { raw.strip_prefix(b"\xef\xbb\xbf").unwrap_or(raw) } else { raw };
        if raw.contains(&0) {
            return Err(ObjCause::Binary);
        }
        // A comment may be in any encoding; what counts is plain ASCII.
        let end = raw.iter().position(|&byte| byte == b'#').unwrap_or(raw.len());
        let text = String::from_utf8_lossy(&raw[..end]);
        let mut words = text.split_ascii_whitespace();
        match words.next() {
            Some("v") => {
                self.vertices += 1;
                self.vector("v", "a vertex", words)
            }
            Some("vn") => {
                self.normals += 1;
                self.vector("vn", "a normal", words)
            }
            Some("f") => {
                self.faces += 1;
                self.face(words)
            }
            _ => Ok(()),
        }
    }

    fn vector<'t>(
        &mut self,
        keyword: &str,
        what: &'static str,
        words: impl Iterator<Item = &'t str>,
    ) -> Result<(), ObjCause> {
        self.out.extend_from_slice(keyword.as_bytes());
        let mut found = 0;
        for word in words.take(3) {
            let number: f32 = word.parse().map_err(|_| ObjCause::NotANumber { word: shown(word) })?;
            if !number.is_finite() {
                return Err(ObjCause::NotFinite { word: shown(word) });
            }
            self.out.push(b' ');
            self.out.extend_from_slice(word.as_bytes());
            found += 1;
        }
        self.out.push(b'\n');
        if found == 3 { Ok(()) } else { Err(ObjCause::MissingNumber { what, found }) }
    }

    fn face<'t>(&mut self, words: impl Iterator<Item = &'t str>) -> Result<(), ObjCause> {
        use io::Write;
        self.out.push(b'f');
        let mut found = 0;
        for word in words {
            let mut parts = word.split('/');
            let vertex = parts.next().unwrap_or_default();
            let normal = parts.nth(1).filter(|part| !part.is_empty());
            let vertex = self.index(0, "vertex", word, vertex)?;
            let normal = normal.map(|part| self.index(1, "normal", word, part)).transpose()?;
            // One more because of the normal that stands for none.
            let normal = normal.map_or(1, |index| index + 1);
            write!(self.out, " {vertex}//{normal}").map_err(ObjCause::Io)?;
            found += 1;
        }
        self.out.push(b'\n');
        if found >= 3 { Ok(()) } else { Err(ObjCause::SmallFace { found }) }
    }

    /// An index counted from 1, whichever way the file counts.
    fn index(&mut self, list: usize, what: &'static str, word: &str, part: &str) -> Result<i64, ObjCause> {
        let index: i64 = part.parse().map_err(|_| ObjCause::NotACorner { word: shown(word) })?;
        let count = if list == 0 { self.vertices } else { self.normals };
        let absolute = if index < 0 { index.saturating_add_unsigned(count as u64 + 1) } else { index };
        if absolute < 1 || absolute >= i64::from(u32::MAX) {
            return Err(ObjCause::OutOfRange { what, index, count });
        }
        if absolute > self.furthest[list].0 {
            self.furthest[list] = (absolute, self.line);
        }
        Ok(absolute)
    }
}

/// A word of the file as an error shows it.
fn shown(word: &str) -> String {
    word.chars().take(40).flat_map(char::escape_debug).collect()
}

impl<R: BufRead> Read for Prepared<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let ready = self.fill_buf()?;
        let count = ready.len().min(buffer.len());
        buffer[..count].copy_from_slice(&ready[..count]);
        self.consume(count);
        Ok(count)
    }
}

impl<R: BufRead> BufRead for Prepared<'_, R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken == self.out.len() && self.error.is_none() {
            if let Err(cause) = self.advance() {
                let line = (!matches!(cause, ObjCause::Io(_))).then_some(self.line);
                self.error = Some(ObjError { line, cause });
            }
        }
        if self.error.is_some() {
            return Err(io::ErrorKind::InvalidData.into());
        }
        Ok(&self.out[self.taken..])
    }

    fn consume(&mut self, count: usize) {
        self.taken += count;
    }
}
