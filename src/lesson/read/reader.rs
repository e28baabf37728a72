//! The text of a lesson while it is read, and what is wrong with it.

use crate::lesson::LessonProblem;
use crate::text::{text, with_short_names};
use serde::de::DeserializeOwned;

/// A block of TOML and the offset at which it begins.
pub struct Block<'s> {
    pub text: &'s str,
    pub at: usize,
}

/// The text of a lesson, with the problems that were found in it so far.
pub struct Reader<'s> {
    pub source: &'s str,
    pub problems: Vec<LessonProblem>,
}

impl Reader<'_> {
    /// Returns the line of an offset, from 1.
    pub fn line(&self, offset: usize) -> u64 {
        let before = self.source.as_bytes().get(..offset).unwrap_or_default();
        1 + before.iter().filter(|byte| **byte == b'\n').count() as u64
    }

    /// Notes a problem at an offset.
    pub fn wrong(&mut self, offset: usize, words: impl Into<String>) {
        let line = self.line(offset);
        self.wrong_at(line, words);
    }

    /// Notes a problem in a line.
    pub fn wrong_at(&mut self, line: u64, words: impl Into<String>) {
        self.problems.push(LessonProblem::new(line, words));
    }

    /// Reads a block of TOML.
    pub fn toml<T: DeserializeOwned>(&mut self, block: &Block<'_>) -> Option<T> {
        // Of the end of a line with a carriage return, TOML takes both or none.
        match toml::from_str(block.text.trim_end_matches('\r')) {
            Ok(read) => Some(read),
            Err(error) => {
                let at = error.span().map_or(0, |span| span.start);
                self.wrong(
                    block.at + at,
                    text!("problem-toml", message = with_short_names(error.message())),
                );
                None
            }
        }
    }
}
