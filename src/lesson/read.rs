//! A lesson's file, read with the line of everything that is wrong.

pub(super) mod keys;
mod question;
mod reader;
mod stage;

use super::stage::Stage;
use super::{Lesson, LessonError, Prose, Step};
use crate::text::{excerpt, text};
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd};
use reader::{Block, Reader};
use serde::Deserialize;
use std::path::Path;
use toml::Spanned;

/// The version of the format.
const VERSION: u32 = 1;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    lesson: Spanned<u32>,
    name: Spanned<String>,
    title: String,
    #[serde(default)]
    topic: String,
    #[serde(default)]
    minutes: u32,
    #[serde(default)]
    about: String,
    #[serde(default)]
    test: bool,
}

impl Lesson {
    /// Reads a lesson; `folder` is where the files lie that it names.
    ///
    /// # Errors
    /// Everything that is wrong with its form, each with its line. What the engine finds wrong, [`super::check`] says.
    pub fn read(source: &str, folder: Option<&Path>) -> Result<Self, LessonError> {
        if source.len() > Self::MAX_TEXT {
            let words = text!("lesson-too-long", most = Self::MAX_TEXT >> 20);
            return Err(LessonError::one(1, words));
        }
        let mut reader = Reader {
            source,
            problems: Vec::new(),
        };
        let lesson = reader.lesson(folder);
        match lesson {
            Some(lesson) if reader.problems.is_empty() => Ok(lesson),
            _ => Err(LessonError {
                problems: reader.problems,
            }),
        }
    }
}

/// The text between a heading and the next one.
struct RawStep<'s> {
    title: String,
    at: usize,
    /// The pieces of text about the blocks.
    pieces: Vec<(usize, usize)>,
    /// The number of pieces in front of the question.
    before: Option<usize>,
    stage: Option<Block<'s>>,
    question: Option<Block<'s>>,
}

impl<'s> Reader<'s> {
    fn lesson(&mut self, folder: Option<&Path>) -> Option<Lesson> {
        let (block, body) = self.head()?;
        let head: Head = self.toml(&block)?;
        if *head.lesson.get_ref() != VERSION {
            let at = block.at + head.lesson.span().start;
            self.wrong(at, text!("lesson-version", version = VERSION));
        }
        let name = head.name.get_ref();
        let sound = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        if name.is_empty() || name.len() > 64 || !name.chars().all(sound) {
            self.wrong(block.at + head.name.span().start, text!("lesson-name"));
        }
        let steps = self.split(body);
        if steps.is_empty() {
            self.wrong(body, text!("lesson-no-steps"));
        }
        if steps.len() > Lesson::MAX_STEPS {
            let words = text!("lesson-many-steps", most = Lesson::MAX_STEPS);
            self.wrong(body, words);
            return None;
        }
        let mut before = Stage::default();
        let mut read = Vec::new();
        for step in steps {
            let problems = self.problems.len();
            let step = self.step(step, &before);
            // A block that cannot be read may have the scene.
            if read.is_empty() && step.stage.scene.is_empty() && self.problems.len() == problems {
                self.wrong_at(step.line, text!("lesson-no-scene"));
            }
            before.clone_from(&step.stage);
            read.push(step);
        }
        Some(Lesson {
            name: head.name.into_inner(),
            title: head.title,
            topic: head.topic,
            minutes: if head.minutes == 0 { 10 } else { head.minutes },
            about: head.about,
            test: head.test,
            steps: read,
            folder: folder.map(Path::to_owned),
            source: self.source.to_owned(),
        })
    }

    /// Finds the TOML between two lines `+++`, and the begin of what follows.
    fn head(&mut self) -> Option<(Block<'s>, usize)> {
        let source = self.source;
        let start = source.len() - source.trim_start_matches('\u{feff}').trim_start().len();
        let rest = source[start..].strip_prefix("+++").unwrap_or_default();
        let Some((text, body)) = rest.split_once("\n+++") else {
            self.wrong(start, text!("lesson-no-head"));
            return None;
        };
        let at = source.len() - rest.len();
        Some((Block { text, at }, source.len() - body.len()))
    }

    /// Splits the text into steps, by the headings of the second level.
    fn split(&mut self, body: usize) -> Vec<RawStep<'s>> {
        let source = self.source;
        let mut steps: Vec<RawStep<'s>> = Vec::new();
        let mut heading: Option<usize> = None;
        let mut title = String::new();
        let parser = Parser::new_ext(&source[body..], Options::ENABLE_TABLES).into_offset_iter();
        let mut depth = 0usize;
        // The fenced block at hand: its info string, its start, and the range of its text.
        let mut fence: Option<(String, usize, Option<_>)> = None;
        for (event, span) in parser {
            let (start, end) = (body + span.start, body + span.end);
            match event {
                Event::Start(Tag::Heading {
                    level: HeadingLevel::H2,
                    ..
                }) if depth == 0 => {
                    if let Some(step) = steps.last_mut()
                        && let Some(piece) = step.pieces.last_mut()
                    {
                        piece.1 = start;
                    }
                    heading = Some(start);
                    title.clear();
                }
                Event::End(TagEnd::Heading(HeadingLevel::H2)) => {
                    if let Some(at) = heading.take() {
                        steps.push(RawStep {
                            title: std::mem::take(&mut title),
                            at,
                            pieces: vec![(end, source.len())],
                            before: None,
                            stage: None,
                            question: None,
                        });
                    }
                }
                Event::Text(text) | Event::Code(text) if heading.is_some() => title.push_str(&text),
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) if depth == 0 => {
                    fence = Some((info.trim().to_owned(), start, None));
                    depth += 1;
                }
                Event::Text(text) if fence.is_some() => {
                    if let Some((_, _, inside)) = &mut fence {
                        let (first, _) = inside.unwrap_or((start, start));
                        *inside = Some((first, start + text.len()));
                    }
                }
                Event::End(TagEnd::CodeBlock) if fence.is_some() => {
                    depth -= 1;
                    if let Some((info, at, inside)) = fence.take() {
                        self.block(&mut steps, &info, (at, end), inside);
                    }
                }
                Event::Start(_) => depth += 1,
                Event::End(_) => depth = depth.saturating_sub(1),
                _ => {}
            }
        }
        steps
    }

    /// Takes a fenced block of the last step.
    fn block(
        &mut self,
        steps: &mut [RawStep<'s>],
        info: &str,
        (start, end): (usize, usize),
        inside: Option<(usize, usize)>,
    ) {
        let (from, to) = inside.unwrap_or((end, end));
        let to = to.min(self.source.len());
        let block = Block {
            text: self.source.get(from..to).unwrap_or_default(),
            at: from,
        };
        if info != "step" && info != "question" {
            // Other blocks are code to show, but not those that have a lesson's keys.
            let table = block.text.parse::<toml::Table>().unwrap_or_default();
            if info != "toml"
                && ["kind", "ask", "scene"]
                    .iter()
                    .any(|key| table.contains_key(*key))
            {
                self.wrong(start, text!("lesson-unknown-block", name = excerpt(info)));
            }
            return;
        }
        let Some(step) = steps.last_mut() else {
            self.wrong(start, text!("lesson-block-outside"));
            return;
        };
        if let Some(piece) = step.pieces.last_mut() {
            piece.1 = start;
        }
        let place = match info {
            "step" => &mut step.stage,
            _ => {
                step.before = Some(step.pieces.len());
                &mut step.question
            }
        };
        step.pieces.push((end, self.source.len()));
        if place.replace(block).is_some() {
            self.wrong(start, text!("lesson-block-twice", name = info));
        }
    }

    /// Reads pieces of text as one.
    fn prose(&mut self, pieces: &[(usize, usize)]) -> Prose {
        // Lines are counted as they stand in the file: blocks are left out, not their lines.
        let mut text = String::new();
        let mut at = pieces.first().map_or(0, |piece| piece.0);
        let first = self.line(at);
        for &(from, to) in pieces {
            let skipped = self.line(from).saturating_sub(self.line(at));
            text.extend(std::iter::repeat_n('\n', skipped as usize));
            text.push_str(self.source.get(from..to).unwrap_or_default());
            at = to;
        }
        Prose::read(&text, first).unwrap_or_else(|problem| {
            self.problems.push(problem);
            Prose::default()
        })
    }

    fn step(&mut self, raw: RawStep<'s>, before: &Stage) -> Step {
        let (text, after) = raw.pieces.split_at(raw.before.unwrap_or(raw.pieces.len()));
        let (text, after) = (self.prose(text), self.prose(after));
        let line = self.line(raw.at);
        let mut stage = Stage {
            // What can be read off is not predicted.
            hide: raw.question.is_some(),
            line_number: line,
            ..before.clone()
        };
        if let Some(block) = &raw.stage {
            self.stage(block, &mut stage);
        }
        let question = raw.question.as_ref().and_then(|block| self.question(block));
        Step {
            title: raw.title,
            text,
            after,
            stage,
            question,
            line,
        }
    }
}
