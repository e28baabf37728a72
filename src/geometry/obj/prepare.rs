//! Checks a model line by line and writes it anew in the plainest form: positions, normals and faces only, faces with
//! absolute numbers and in pieces.
//!
//! `tobj` reads what comes out. It has no line numbers, fills a missing normal with the one before, and keeps a hundred
//! bytes for each face until its object ends; so normals that are missing get one of their own (0, 0, 0), the first, and
//! objects end after [`PIECE`] corners.

use super::error::{ObjError, quoted};
use super::lines::{Line, Lines};
use crate::geometry::mesh::FAR;
use glam::DVec3;
use std::io::{self, BufRead, Read, Write};

/// Most corners in a piece, but for one large face: some megabytes of memory in `tobj`, and a little less than a power of
/// two, to which its lists grow.
const PIECE: usize = (1 << 17) - 64;

/// Bytes written before they are passed on.
const CHUNK: usize = 1 << 16;

/// A model written anew, to be read by `tobj`.
pub struct Prepared<'a, R> {
    lines: Lines<'a, R>,
    writer: Writer,
    /// How much of the writer's text has been read.
    taken: usize,
    outcome: Result<(), ObjError>,
}

#[derive(Default)]
struct Writer {
    text: Vec<u8>,
    positions: u64,
    normals: u64,
    faces: u64,
    corners_in_piece: usize,
    origin: DVec3,
    /// The corners of a face: position, and normal or 0.
    corners: Vec<(u64, u64)>,
}

impl<'a, R: BufRead> Prepared<'a, R> {
    pub fn new(lines: Lines<'a, R>) -> Self {
        Self { lines, writer: Writer::default(), taken: 0, outcome: Ok(()) }
    }

    /// After the last byte: the origin that positions are relative to, or what was wrong.
    pub fn finish(self) -> Result<DVec3, ObjError> {
        self.outcome?;
        if self.lines.bytes() == 0 {
            return Err(ObjError::Empty);
        }
        if self.writer.faces == 0 { Err(ObjError::NoFace) } else { Ok(self.writer.origin) }
    }

    fn refill(&mut self) -> Result<(), ObjError> {
        self.taken = 0;
        self.writer.text.clear();
        while self.writer.text.len() < CHUNK {
            let Some(line) = self.lines.next()? else { break };
            self.writer.line(&line)?;
        }
        Ok(())
    }
}

impl<R: BufRead> BufRead for Prepared<'_, R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.taken >= self.writer.text.len() {
            self.outcome = self.refill();
            if self.outcome.is_err() {
                return Err(io::Error::other("the model is not sound"));
            }
        }
        Ok(&self.writer.text[self.taken..])
    }

    fn consume(&mut self, amount: usize) {
        self.taken += amount;
    }
}

impl<R: BufRead> Read for Prepared<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(buffer)?;
        self.consume(read);
        Ok(read)
    }
}

impl Writer {
    fn line(&mut self, line: &Line) -> Result<(), ObjError> {
        let mut words = line.text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        match words.next() {
            Some(b"v") => self.position(line.number, words),
            Some(b"vn") => self.normal(line.number, words),
            Some(b"f" | b"fo") => self.face(line, words),
            _ => Ok(()),
        }
    }

    fn position<'w>(&mut self, line: u64, mut words: impl Iterator<Item = &'w [u8]>) -> Result<(), ObjError> {
        const EXPECTED: &str = "three coordinates x y z";
        let mut xyz = [&[][..]; 3];
        let mut point = DVec3::ZERO;
        for k in 0..3 {
            xyz[k] = words.next().ok_or(ObjError::TooFewNumbers { line, found: k, expected: EXPECTED })?;
            point[k] = number(line, xyz[k], "a coordinate")?;
        }
        if let (Some(weight), None) = (words.next(), words.next()) {
            point /= match number(line, weight, "a weight")? {
                0.0 => return Err(ObjError::ZeroWeight { line }),
                weight => weight,
            };
        }
        if self.positions == 0 && point.is_finite() && point.abs().max_element() > FAR {
            self.origin = point.round();
        }
        let relative = (point - self.origin).as_vec3();
        for k in 0..3 {
            if !relative[k].is_finite() {
                return Err(ObjError::NotFinite { line, word: quoted(xyz[k]) });
            }
        }
        self.positions += 1;
        self.write(format_args!("v {:e} {:e} {:e}\n", relative.x, relative.y, relative.z));
        Ok(())
    }

    fn normal<'w>(&mut self, line: u64, mut words: impl Iterator<Item = &'w [u8]>) -> Result<(), ObjError> {
        let mut normal = DVec3::ZERO;
        for k in 0..3 {
            let expected = "three components of a normal";
            let word = words.next().ok_or(ObjError::TooFewNumbers { line, found: k, expected })?;
            normal[k] = number(line, word, "a component of a normal")?;
        }
        if self.normals == 0 {
            // Faces so far have no normals; what they become must not have any either.
            self.end_piece();
            self.write(format_args!("vn 0 0 0\n"));
        }
        self.normals += 1;
        let unit = normal.try_normalize().unwrap_or(DVec3::ZERO).as_vec3();
        self.write(format_args!("vn {:e} {:e} {:e}\n", unit.x, unit.y, unit.z));
        Ok(())
    }

    fn face<'w>(&mut self, line: &Line, words: impl Iterator<Item = &'w [u8]>) -> Result<(), ObjError> {
        let mut corners = std::mem::take(&mut self.corners);
        corners.clear();
        for word in words {
            corners.push(self.corner(line, word)?);
        }
        if corners.len() < 3 {
            return Err(ObjError::TooFewCorners { line: line.number, found: corners.len() });
        }
        if self.corners_in_piece + corners.len() > PIECE {
            self.end_piece();
        }
        self.faces += 1;
        self.corners_in_piece += corners.len();
        self.write(format_args!("f"));
        for &(position, normal) in &corners {
            if self.normals == 0 {
                self.write(format_args!(" {position}"));
            } else {
                // The first normal written stands for none, so all others have moved up by one.
                self.write(format_args!(" {position}//{}", normal + 1));
            }
        }
        self.write(format_args!("\n"));
        self.corners = corners;
        Ok(())
    }

    /// The numbers, from 1, of the position and normal of a corner; 0 for no normal.
    fn corner(&self, line: &Line, word: &[u8]) -> Result<(u64, u64), ObjError> {
        const EXPECTED: &str = "a corner of a face, v, v/vt, v//vn or v/vt/vn with whole numbers";
        let malformed = || ObjError::Malformed { line: line.number, word: quoted(word), expected: EXPECTED };
        let mut fields = word.split(|&byte| byte == b'/');
        let position = fields.next().ok_or_else(malformed)?;
        let [texture, normal] = [fields.next(), fields.next()].map(Option::unwrap_or_default);
        let is_whole = |field: &[u8]| whole(field).is_some();
        let empty_or_whole = |field: &[u8]| field.is_empty() || is_whole(field);
        // A file that ends behind a slash has been cut off.
        let cut_off = !line.ended && line.text.ends_with(b"/") && line.text.ends_with(word);
        if fields.next().is_some()
            || cut_off
            || !is_whole(position)
            || !empty_or_whole(texture)
            || !empty_or_whole(normal)
        {
            return Err(malformed());
        }
        let position = absolute(line.number, "vertex", position, self.positions)?;
        let normal = if normal.is_empty() { 0 } else { absolute(line.number, "normal", normal, self.normals)? };
        Ok((position, normal))
    }

    fn end_piece(&mut self) {
        self.corners_in_piece = 0;
        self.write(format_args!("o\n"));
    }

    fn write(&mut self, text: std::fmt::Arguments) {
        // A Vec takes whatever is written.
        let _ = self.text.write_fmt(text);
    }
}

/// The number that a word stands for, finite or not.
fn number(line: u64, word: &[u8], expected: &'static str) -> Result<f64, ObjError> {
    let malformed = || ObjError::Malformed { line, word: quoted(word), expected };
    std::str::from_utf8(word).ok().and_then(|text| text.parse().ok()).ok_or_else(malformed)
}

/// Sign and digits of a whole number of any length; none if it is not one.
fn whole(field: &[u8]) -> Option<(bool, &[u8])> {
    let (negative, digits) = match field {
        [b'-', digits @ ..] => (true, digits),
        [b'+', digits @ ..] => (false, digits),
        digits => (false, digits),
    };
    (!digits.is_empty() && digits.iter().all(u8::is_ascii_digit)).then_some((negative, digits))
}

/// The number from 1 of the thing that a face names, of which `count` come before it.
fn absolute(line: u64, kind: &'static str, field: &[u8], count: u64) -> Result<u64, ObjError> {
    let resolved = whole(field).and_then(|(negative, digits)| {
        let number: u64 = std::str::from_utf8(digits).ok()?.parse().ok()?;
        let in_range = (1..=count).contains(&number);
        in_range.then(|| if negative { count + 1 - number } else { number })
    });
    resolved.ok_or_else(|| ObjError::OutOfRange { line, kind, index: quoted(field), count })
}
