//! A model's file as lines, and its errors.

use crate::text::text;
use std::io::{self, BufRead, Read};

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
    count: u64,
    /// The number of bytes read.
    pub bytes: u64,
    told: u64,
}

pub struct Line<'a> {
    /// The number of the first of the lines joined.
    pub number: u64,
    /// The text without line end, comment and continuation marks.
    pub text: &'a [u8],
    /// True if the line ended in a line end, false if it ended with the file.
    pub ended: bool,
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
    pub fn next(&mut self) -> Result<Option<Line<'_>>, ObjError> {
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
        let mut from = before;
        while let Some(k) = self.text[from..].iter().position(|&byte| byte == b'#') {
            from += k;
            let keyword = self.text.trim_ascii_start();
            // Some exporters call a material `color_#ff8000`.
            let named = keyword.starts_with(b"usemtl") || keyword.starts_with(b"mtllib");
            if !named || from == 0 || self.text[from - 1].is_ascii_whitespace() {
                self.text.truncate(from);
            } else {
                from += 1;
            }
        }
        while self.text.len() > before && self.text.last().is_some_and(u8::is_ascii_whitespace) {
            self.text.pop();
        }
    }
}

pub fn error_at(line: u64, what: impl Into<String>) -> ObjError {
    ObjError::Line {
        line,
        what: what.into(),
    }
}

fn not_text(line: u64) -> ObjError {
    error_at(line, text!("obj-not-text"))
}

/// Returns the error that says `word` is not what was `expected`.
pub fn malformed(word: &[u8], expected: &str) -> String {
    text!(
        "obj-malformed",
        word = quoted(word),
        expected = text!(expected)
    )
}

/// Quotes a word of the file for a message: as valid text of a limited length.
pub fn quoted(word: &[u8]) -> String {
    const LONGEST_QUOTE: usize = 40;
    let text = String::from_utf8_lossy(&word[..word.len().min(LONGEST_QUOTE)]);
    if word.len() > LONGEST_QUOTE {
        format!("{text}…")
    } else {
        text.into_owned()
    }
}
