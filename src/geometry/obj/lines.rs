//! A file as lines: continued ones joined, comments cut off, numbered from 1.

use super::error::ObjError;
use std::io::BufRead;

/// The longest line, continuations included: a face of some 100 000 vertices. What is longer is no model, and would
/// otherwise be read into memory as a whole.
const LONGEST: usize = 1 << 20;

/// Progress is told whenever so many more bytes have been read.
const PROGRESS_STEP: u64 = 1 << 18;

const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

pub struct Lines<'a, R> {
    reader: R,
    progress: &'a mut dyn FnMut(u64),
    /// The line being put together.
    line: Vec<u8>,
    /// Lines read so far.
    count: u64,
    bytes: u64,
    told: u64,
}

/// One line.
pub struct Line<'a> {
    /// Of the first of the lines joined.
    pub number: u64,
    /// Without line end, comment and continuation marks.
    pub text: &'a [u8],
    /// Whether it ended in a line end, and not with the file.
    pub ended: bool,
}

impl<'a, R: BufRead> Lines<'a, R> {
    pub fn new(reader: R, progress: &'a mut dyn FnMut(u64)) -> Self {
        Self { reader, progress, line: Vec::new(), count: 0, bytes: 0, told: 0 }
    }

    /// Bytes read so far.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// The next line; none at the end of the file.
    pub fn next(&mut self) -> Result<Option<Line<'_>>, ObjError> {
        self.line.clear();
        let number = self.count + 1;
        let ended = loop {
            let before = self.line.len();
            let ended = self.append(number)?;
            if self.line.len() == before && !ended {
                if before == 0 {
                    (self.progress)(self.bytes);
                    return Ok(None);
                }
                break false;
            }
            self.count += 1;
            self.trim(before);
            if ended && self.line.last() == Some(&b'\\') {
                self.line.pop();
                self.line.push(b' ');
            } else {
                break ended;
            }
        };
        if self.line.iter().any(|&byte| is_binary(byte)) {
            return Err(ObjError::Binary { line: number });
        }
        Ok(Some(Line { number, text: &self.line, ended }))
    }

    /// Appends the bytes up to the next line end, which it leaves out; says whether there was one.
    fn append(&mut self, number: u64) -> Result<bool, ObjError> {
        loop {
            let buffer = match self.reader.fill_buf() {
                Err(error) if error.kind() == std::io::ErrorKind::Interrupted => continue,
                other => other?,
            };
            if buffer.is_empty() {
                return Ok(false);
            }
            let end = buffer.iter().position(|&byte| byte == b'\n');
            let text = &buffer[..end.unwrap_or(buffer.len())];
            // Known at the first zero byte, before a file without line ends is read through.
            if text.contains(&0) {
                return Err(ObjError::Binary { line: number });
            }
            if self.line.len() + text.len() > LONGEST {
                return Err(ObjError::TooLong { line: number, limit: LONGEST });
            }
            self.line.extend_from_slice(text);
            let used = text.len() + usize::from(end.is_some());
            self.reader.consume(used);
            self.tell(used as u64);
            if end.is_some() {
                return Ok(true);
            }
        }
    }

    fn tell(&mut self, used: u64) {
        self.bytes += used;
        if self.bytes - self.told >= PROGRESS_STEP {
            self.told = self.bytes;
            (self.progress)(self.bytes);
        }
    }

    /// Cuts byte order mark, comment and blanks from what was appended after `before`.
    fn trim(&mut self, before: usize) {
        if self.count == 1 && self.line.starts_with(BYTE_ORDER_MARK) {
            self.line.drain(..BYTE_ORDER_MARK.len());
        }
        if let Some(comment) = self.line[before..].iter().position(|&byte| byte == b'#') {
            self.line.truncate(before + comment);
        }
        while self.line.len() > before && self.line.last().is_some_and(u8::is_ascii_whitespace) {
            self.line.pop();
        }
    }
}

/// Control characters that no text has; tab, form feed, escape and the end mark of old systems are let through.
fn is_binary(byte: u8) -> bool {
    matches!(byte, 0..=8 | 14..=25 | 28..=31)
}
