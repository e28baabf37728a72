//! A step's question, of any kind.

use super::keys::{KeyReader, Keys};
use super::reader::{Block, Reader};
use crate::lesson::{Kind, Question, Wrong};
use crate::text::text;

impl Reader<'_> {
    /// Reads the block of a question.
    pub fn question(&mut self, block: &Block<'_>) -> Option<Question> {
        let keys: Keys = self.toml(block)?;
        let line = self.line(block.at);
        let mut reader = KeyReader {
            lesson: self,
            at: block.at,
            whole: block.at,
        };
        let kind = Kind::read(&keys, &mut reader);
        let ask = reader.prose(keys.ask.as_ref());
        if ask.is_empty() {
            reader.missing("ask");
        }
        let kind = kind?;
        Some(Question {
            wrong: reader.wrong_models(&keys, &kind),
            kind,
            ask,
            why: reader.prose(keys.why.as_ref()),
            term: keys.term,
            set: keys.set,
            line,
        })
    }
}

impl KeyReader<'_, '_> {
    /// Reads the wrong models of a question: each is the question itself with some of its keys changed.
    fn wrong_models(&mut self, keys: &Keys, kind: &Kind) -> Vec<Wrong> {
        if keys.wrong.len() > Wrong::MOST {
            self.wrong(text!("lesson-many-wrong", most = Wrong::MOST));
            return Vec::new();
        }
        let mut models = Vec::new();
        for wrong in &keys.wrong {
            self.whole = self.at + wrong.says.span().start;
            let says = self.prose(Some(&wrong.says));
            if wrong.says.get_ref().trim().is_empty() {
                self.missing("says");
            }
            if kind.model_keys().is_empty() {
                self.wrong(text!("lesson-wrong-choice"));
                break;
            }
            if self.wrong_has(wrong, kind.model_keys())
                && let Some(kind) = Kind::read(&keys.of_wrong(wrong), self)
            {
                models.push(Wrong {
                    says,
                    kind,
                    set: keys.set.iter().chain(&wrong.set).cloned().collect(),
                    line: self.lesson.line(self.whole),
                });
            }
        }
        self.whole = self.at;
        models
    }
}
