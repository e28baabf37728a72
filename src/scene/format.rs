//! The scene file: TOML in, TOML out.
//!
//! Reading names every unknown key, every value of a wrong type or, where there is none, out of range, with its line.
//! Writing and reading again gives the same scene, bit for bit.

mod datum;
mod reader;
mod writer;

use super::Scene;
use super::problem::{Cause, Place, Problem, SceneError};
use reader::{Finding, read};
use toml::de::{DeTable, DeValue};

pub(super) use datum::{Datum, Wrong, read_coefficient, value_text};
pub(super) use reader::set;

impl Scene {
    /// The version of the format that this program reads and writes.
    pub const VERSION: u32 = 1;

    /// The longest scene file, in bytes. A thousand lights with every key take a quarter of a megabyte; the parser
    /// takes up to a hundred times the text.
    pub const MAX_TEXT: usize = 4 << 20;

    /// Reads a scene file's text. `name` stands for the file in messages.
    ///
    /// # Guarantees
    /// The scene is one that [`Scene::validate`] accepts.
    ///
    /// # Errors
    /// Not TOML, another version, unknown keys or words, values of a wrong type or out of range: each with its line.
    pub fn parse(text: &str, name: &str) -> Result<Self, SceneError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let at = |line: usize| Place::Line { file: name.to_owned(), line };
        if text.len() > Self::MAX_TEXT {
            return Err(Problem { place: at(1), key: String::new(), cause: Cause::TooLong }.into());
        }
        let document = DeTable::parse(text).map_err(|error| {
            let place = at(Lines::of(text).line_of(error.span().map_or(0, |span| span.start)));
            Problem { place, key: String::new(), cause: Cause::Syntax(error.message().to_owned()) }
        })?;
        let (scene, mut findings) = read(document.get_ref());
        if findings.iter().all(|finding| matches!(finding.cause, Cause::UnknownKey { .. })) {
            for (key, cause) in scene.range_problems() {
                findings.push(Finding { offset: offset_of(document.get_ref(), &key), key, cause });
            }
        }
        findings.sort_by_key(|finding| finding.offset);
        let mut lines = Lines::of(text);
        let mut placed = |Finding { offset, key, cause }| Problem { place: at(lines.line_of(offset)), key, cause };
        SceneError::check(findings.into_iter().map(&mut placed).collect())?;
        Ok(scene)
    }

    /// The scene as the text of a scene file. Keys of a light that its kind and attenuation do not read are left out
    /// where they have their default.
    pub fn to_toml(&self) -> String {
        writer::write(self)
    }
}

/// Counts lines, going through the text once however many are asked for in their order.
struct Lines<'a> {
    text: &'a [u8],
    offset: usize,
    line: usize,
}

impl<'a> Lines<'a> {
    fn of(text: &'a str) -> Self {
        Self { text: text.as_bytes(), offset: 0, line: 1 }
    }

    /// The line of a byte, counted from 1. Offsets must not decrease from call to call.
    fn line_of(&mut self, offset: usize) -> usize {
        let passed = self.text.get(self.offset..offset.min(self.text.len())).unwrap_or_default();
        self.line += passed.iter().filter(|&&byte| byte == b'\n').count();
        self.offset += passed.len();
        self.line
    }
}

/// Where `key` stands in the document, or the innermost table round it that does.
fn offset_of(document: &DeTable<'_>, key: &str) -> usize {
    let mut segments = key.split('.');
    let Some((name, mut value)) = segments.next().and_then(|first| document.get_key_value(first)) else { return 0 };
    let mut offset = name.span().start;
    for segment in segments {
        match value.get_ref() {
            DeValue::Table(table) => match table.get_key_value(segment) {
                Some((name, inner)) => (offset, value) = (name.span().start, inner),
                None => break,
            },
            DeValue::Array(list) => match segment.parse().ok().and_then(|i: usize| list.get(i)) {
                Some(inner) => (offset, value) = (inner.span().start, inner),
                None => break,
            },
            _ => break,
        }
    }
    offset
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_from_one() {
        let text = "a\nb\n\nc";
        let mut counted = Lines::of(text);
        let lines: Vec<_> = (0..=text.len() + 1).map(|offset| counted.line_of(offset)).collect();
        assert_eq!(lines, [1, 1, 2, 2, 3, 4, 4, 4]);
        let mut counted = Lines::of(text);
        assert_eq!([0, 5, 5, 9].map(|offset| counted.line_of(offset)), [1, 4, 4, 4]);
    }

    #[test]
    fn a_key_is_found_or_the_table_round_it() {
        let text = "[camera]\neye = [1, 2, 3]\n[[light]]\nk = 1\n[[light]]\nc1 = 2\n";
        let document = DeTable::parse(text).expect("sound TOML");
        let line = |key| Lines::of(text).line_of(offset_of(document.get_ref(), key));
        assert_eq!(line("camera.eye"), 2);
        assert_eq!(line("camera.up"), 1);
        assert_eq!(line("light.1.c1"), 6);
        assert_eq!(line("light.1.k"), 5);
        assert_eq!(line("material.n"), 1);
    }
}
