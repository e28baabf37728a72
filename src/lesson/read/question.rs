//! A step's question, of any kind.

use super::keys::{KeyReader, Keys};
use super::reader::{Block, Reader};
use crate::lesson::{Kind, Question};

impl Reader<'_> {
    /// Reads the block of a question.
    pub fn question(&mut self, block: &Block<'_>) -> Option<Question> {
        let keys: Keys = self.toml(block)?;
        let line = self.line(block.at);
        let mut reader = KeyReader {
            lesson: self,
            at: block.at,
        };
        let kind = Kind::read(&keys, &mut reader);
        let ask = reader.prose(keys.ask.as_ref());
        if ask.is_empty() {
            reader.missing("ask");
        }
        Some(Question {
            kind: kind?,
            ask,
            why: reader.prose(keys.why.as_ref()),
            term: keys.term,
            set: keys.set,
            line,
        })
    }
}
