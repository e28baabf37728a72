//! The line-by-line check of a model, which rewrites it in the plainest form: positions, normals and faces only, faces with
//! absolute numbers and in pieces.
//!
//! `tobj` reads the output. It has no line numbers, fills a missing normal with the one before, and keeps a hundred bytes
//! for each face until its object ends. Missing normals therefore refer to one of their own, (0, 0, 0), the first; and
//! objects end after [`PIECE`] corners.

use crate::geometry::mesh::FAR;
use crate::text::text;
use glam::DVec3;
use std::io::{self, BufRead, Read, Write};

/// The reason why a model could not be read. The message says what is wrong and what was expected, [`ObjError::line`] where.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ObjError {
    /// A failure to read the file or stream.
    #[error("{}", text!("obj-unreadable", error = .0.to_string()))]
    Read(#[from] io::Error),
    /// A line that is not Wavefront OBJ, or that refers to something that does not exist.
    #[error("{what}")]
    Line {
        /// The line, counted from 1.
        line: u64,
        /// A sentence that says what is wrong and what was expected.
        what: String,
    },
    /// An empty file.
    #[error("{}", text!("obj-empty"))]
    Empty,
    /// Points without a face.
    #[error("{}", text!("obj-no-face"))]
    NoFace,
    /// More points or corners than `u32` counts.
    #[error("{}", text!("obj-too-large", most = u32::MAX))]
    TooLarge,
    /// An error of `tobj` without a line.
    #[error("{}", text!("obj-refused", error = .0.to_string()))]
    Refused(tobj::LoadError),
}

impl ObjError {
    /// Returns the line, from 1, where it is known; for a continued line, the first.
    pub fn line(&self) -> Option<u64> {
        if let Self::Line { line, .. } = self {
            Some(*line)
        } else {
            None
        }
    }
}

/// The most corners in a piece, except for one large face: some megabytes of memory in `tobj`, and a little less than a
/// power of two, to which its lists grow.
const PIECE: usize = (1 << 17) - 64;

/// The number of bytes written before they are passed on.
const CHUNK: usize = 1 << 16;

/// The longest line, continuations included: a face of some 100 000 vertices. A longer line cannot belong to a model, and
/// would otherwise be read into memory as a whole.
const LONGEST: usize = 1 << 20;

/// The number of bytes between two reports of progress.
const PROGRESS_STEP: u64 = 1 << 18;

const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// A file as lines: continued ones joined, comments cut off, numbered from 1.
pub struct Lines<'a, R> {
    reader: R,
    progress: &'a mut dyn FnMut(u64),
    /// The line being put together.
    text: Vec<u8>,
    /// Lines read so far.
    count: u64,
    bytes: u64,
    told: u64,
}

/// One line.
struct Line<'a> {
    /// The number of the first of the lines joined.
    number: u64,
    /// The text without line end, comment and continuation marks.
    text: &'a [u8],
    /// True if the line ended in a line end, false if it ended with the file.
    ended: bool,
}

impl<'a, R: BufRead> Lines<'a, R> {
    pub fn new(reader: R, progress: &'a mut dyn FnMut(u64)) -> Self {
        Self {
            reader,
            progress,
            text: Vec::new(),
            count: 0,
            bytes: 0,
            told: 0,
        }
    }

    /// Reads the next line; `None` at the end of the file.
    fn next(&mut self) -> Result<Option<Line<'_>>, ObjError> {
        self.text.clear();
        let number = self.count + 1;
        let mut ended = true;
        while ended {
            let before = self.text.len();
            let limit = (LONGEST - before + 1) as u64;
            let read = self
                .reader
                .by_ref()
                .take(limit)
                .read_until(b'\n', &mut self.text)?;
            if read == 0 && before == 0 {
                (self.progress)(self.bytes);
                return Ok(None);
            }
            self.tell(read as u64);
            self.count += u64::from(read > 0);
            ended = self.text.ends_with(b"\n");
            self.text.truncate(self.text.len() - usize::from(ended));
            if self.text[before..].contains(&0) {
                return Err(not_text(number));
            }
            if self.text.len() > LONGEST {
                return Err(error_at(
                    number,
                    text!("obj-line-too-long", longest = LONGEST),
                ));
            }
            self.trim(before);
            if !(ended && self.text.ends_with(b"\\")) {
                break;
            }
            self.text.pop();
            self.text.push(b' ');
        }
        // Control characters that no text has; tab, form feed, escape and the end mark of old systems are let through.
        if self
            .text
            .iter()
            .any(|byte| matches!(byte, 0..=8 | 14..=25 | 28..=31))
        {
            return Err(not_text(number));
        }
        Ok(Some(Line {
            number,
            text: &self.text,
            ended,
        }))
    }

    fn tell(&mut self, read: u64) {
        self.bytes += read;
        if self.bytes - self.told >= PROGRESS_STEP {
            self.told = self.bytes;
            (self.progress)(self.bytes);
        }
    }

    /// Cuts byte order mark, comment and blanks from what was appended after `before`.
    fn trim(&mut self, before: usize) {
        if self.count == 1 && self.text.starts_with(BYTE_ORDER_MARK) {
            self.text.drain(..BYTE_ORDER_MARK.len());
        }
        if let Some(comment) = self.text[before..].iter().position(|&byte| byte == b'#') {
            self.text.truncate(before + comment);
        }
        while self.text.len() > before && self.text.last().is_some_and(u8::is_ascii_whitespace) {
            self.text.pop();
        }
    }
}

/// A rewritten model, to be read by `tobj`.
pub struct Prepared<'a, R> {
    lines: Lines<'a, R>,
    writer: Writer,
    /// The number of bytes of the writer's text already read.
    taken: usize,
    outcome: Result<(), ObjError>,
}

/// The facts in a model's file beside its polygons.
#[derive(Clone, Copy, Default)]
pub struct FileFacts {
    /// The point that positions are relative to.
    pub origin: DVec3,
    /// True if the file names a material or a library of materials.
    pub names_materials: bool,
}

#[derive(Default)]
struct Writer {
    text: Vec<u8>,
    positions: u64,
    normals: u64,
    faces: u64,
    corners_in_piece: usize,
    facts: FileFacts,
    /// The corners of a face: position, and normal or 0.
    corners: Vec<(u64, u64)>,
}

impl<'a, R: BufRead> Prepared<'a, R> {
    pub fn new(lines: Lines<'a, R>) -> Self {
        Self {
            lines,
            writer: Writer::default(),
            taken: 0,
            outcome: Ok(()),
        }
    }

    /// Returns the facts beside the polygons once the last byte is read, or the error.
    pub fn finish(self) -> Result<FileFacts, ObjError> {
        self.outcome?;
        if self.lines.bytes == 0 {
            return Err(ObjError::Empty);
        }
        if self.writer.faces == 0 {
            Err(ObjError::NoFace)
        } else {
            Ok(self.writer.facts)
        }
    }

    fn refill(&mut self) -> Result<(), ObjError> {
        self.taken = 0;
        self.writer.text.clear();
        while self.writer.text.len() < CHUNK {
            let Some(line) = self.lines.next()? else {
                break;
            };
            self.writer.line(&line)?;
        }
        Ok(())
    }
}

impl<R: BufRead> Read for Prepared<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.taken == self.writer.text.len() {
            self.outcome = self.refill();
            if self.outcome.is_err() {
                return Err(io::Error::other("refused"));
            }
        }
        let read = (&self.writer.text[self.taken..]).read(buffer)?;
        self.taken += read;
        Ok(read)
    }
}

impl Writer {
    fn line(&mut self, line: &Line) -> Result<(), ObjError> {
        let mut words = line
            .text
            .split(u8::is_ascii_whitespace)
            .filter(|word| !word.is_empty());
        match words.next() {
            Some(b"v") => self.position(line.number, words),
            Some(b"vn") => self.normal(line.number, words),
            Some(b"f" | b"fo") => self.face(line, words),
            Some(b"mtllib" | b"usemtl") => {
                self.facts.names_materials = true;
                Ok(())
            }
            _ => Ok(()),
        }
    }

    fn position<'w>(
        &mut self,
        line: u64,
        mut words: impl Iterator<Item = &'w [u8]>,
    ) -> Result<(), ObjError> {
        let (mut point, xyz) = vector(line, &mut words, "obj-coordinate", "obj-three-coordinates")?;
        if let (Some(weight), None) = (words.next(), words.next()) {
            point /= match parse_number(line, weight, "obj-weight")? {
                0.0 => {
                    return Err(error_at(line, text!("obj-weight-zero")));
                }
                weight => weight,
            };
        }
        if self.positions == 0 && point.is_finite() && point.abs().max_element() > FAR {
            self.facts.origin = point.round();
        }
        let relative = (point - self.facts.origin).as_vec3();
        if let Some(k) = (0..3).find(|&k| !relative[k].is_finite()) {
            let word = quoted(xyz[k]);
            return Err(error_at(line, text!("obj-not-finite", word = word)));
        }
        self.positions += 1;
        self.write(format_args!(
            "v {:e} {:e} {:e}\n",
            relative.x, relative.y, relative.z
        ));
        Ok(())
    }

    fn normal<'w>(
        &mut self,
        line: u64,
        mut words: impl Iterator<Item = &'w [u8]>,
    ) -> Result<(), ObjError> {
        let (normal, _) = vector(
            line,
            &mut words,
            "obj-normal-component",
            "obj-three-components",
        )?;
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

    fn face<'w>(
        &mut self,
        line: &Line,
        words: impl Iterator<Item = &'w [u8]>,
    ) -> Result<(), ObjError> {
        let mut corners = std::mem::take(&mut self.corners);
        corners.clear();
        for word in words {
            corners.push(self.corner(line, word)?);
        }
        if corners.len() < 3 {
            return Err(error_at(
                line.number,
                text!("obj-few-vertices", count = corners.len()),
            ));
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
                // The first normal written stands for a missing one, so all others have moved up by one.
                self.write(format_args!(" {position}//{}", normal + 1));
            }
        }
        self.write(format_args!("\n"));
        self.corners = corners;
        Ok(())
    }

    /// Returns the numbers, from 1, of the position and normal of a corner; 0 for no normal.
    fn corner(&self, line: &Line, word: &[u8]) -> Result<(u64, u64), ObjError> {
        let mut fields = word.split(|&byte| byte == b'/');
        let [position, texture, normal] =
            [fields.next(), fields.next(), fields.next()].map(Option::unwrap_or_default);
        let empty_or_whole = |field: &[u8]| field.is_empty() || whole(field).is_some();
        // A file that ends behind a slash has been cut off.
        let cut_off = !line.ended && line.text.ends_with(b"/") && line.text.ends_with(word);
        let sound = whole(position).is_some() && empty_or_whole(texture) && empty_or_whole(normal);
        if fields.next().is_some() || cut_off || !sound {
            return Err(malformed(line.number, word, "obj-corner"));
        }
        let position = absolute(line.number, "obj-no-such-vertex", position, self.positions)?;
        let normal = if normal.is_empty() {
            0
        } else {
            absolute(line.number, "obj-no-such-normal", normal, self.normals)?
        };
        Ok((position, normal))
    }

    fn end_piece(&mut self) {
        self.corners_in_piece = 0;
        self.write(format_args!("o\n"));
    }

    fn write(&mut self, text: std::fmt::Arguments) {
        // Writing to a `Vec` cannot fail.
        let _ = self.text.write_fmt(text);
    }
}

fn error_at(line: u64, what: impl Into<String>) -> ObjError {
    ObjError::Line {
        line,
        what: what.into(),
    }
}

fn not_text(line: u64) -> ObjError {
    error_at(line, text!("obj-not-text"))
}

/// Returns the error that says `word` is not what was `expected`.
fn malformed(line: u64, word: &[u8], expected: &str) -> ObjError {
    let expected = text!(expected);
    error_at(
        line,
        text!("obj-malformed", word = quoted(word), expected = expected),
    )
}

/// Quotes a word of the file for a message: as valid text of a limited length.
fn quoted(word: &[u8]) -> String {
    const LONGEST_QUOTE: usize = 40;
    let text = String::from_utf8_lossy(&word[..word.len().min(LONGEST_QUOTE)]);
    if word.len() > LONGEST_QUOTE {
        format!("{text}…")
    } else {
        text.into_owned()
    }
}

/// Reads three numbers, finite or not, and returns them with their words.
fn vector<'w>(
    line: u64,
    words: &mut impl Iterator<Item = &'w [u8]>,
    one: &str,
    three: &str,
) -> Result<(DVec3, [&'w [u8]; 3]), ObjError> {
    let mut xyz = [&[][..]; 3];
    let mut vector = DVec3::ZERO;
    for k in 0..3 {
        xyz[k] = words.next().ok_or_else(|| {
            error_at(
                line,
                text!("obj-few-numbers", count = k, expected = text!(three)),
            )
        })?;
        vector[k] = parse_number(line, xyz[k], one)?;
    }
    Ok((vector, xyz))
}

/// Reads a word as a number, finite or not.
fn parse_number(line: u64, word: &[u8], expected: &str) -> Result<f64, ObjError> {
    let number = std::str::from_utf8(word)
        .ok()
        .and_then(|text| text.parse().ok());
    number.ok_or_else(|| malformed(line, word, expected))
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

/// Resolves a reference in a face to a number from 1, where `count` items precede it; fails with the message `unknown` if
/// there is no such item.
fn absolute(line: u64, unknown: &str, field: &[u8], count: u64) -> Result<u64, ObjError> {
    let resolved = whole(field).and_then(|(negative, digits)| {
        let number: u64 = std::str::from_utf8(digits).ok()?.parse().ok()?;
        (1..=count)
            .contains(&number)
            .then(|| if negative { count + 1 - number } else { number })
    });
    resolved.ok_or_else(|| error_at(line, text!(unknown, number = quoted(field), count = count)))
}
