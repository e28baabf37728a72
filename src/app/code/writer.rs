//! The texts, written beside the window: once for what is asked, and again when the scene has become another.

use super::super::document::Document;
use super::super::errand::Errand;
use super::form::Language;
use crate::export::{Export, Part, glsl_330, opengl_c, opengl_c_snippet};
use crate::geometry::tessellate;
use eframe::egui::Context;
use std::fmt;
use std::sync::Arc;

/// Lines that are shown of a program: its polygons, which fill the rest, are not for reading.
const PROGRAM_LINES: usize = 200;
/// Lines that are shown of other texts; only a scene of hundreds of lights has more.
const TEXT_LINES: usize = 2000;

impl Language {
    fn write(self, document: &Document) -> Result<Export, String> {
        let scene = &document.scene;
        let mesh = || document.model.clone().unwrap_or_else(|| Arc::new(tessellate(&scene.object)));
        match self {
            Self::Calls => Ok(opengl_c_snippet(scene, &mesh())),
            Self::Shaders => Ok(glsl_330(scene)),
            Self::Program => opengl_c(scene, &mesh()).map_err(|error| error.to_string()),
        }
    }

    fn shown_lines(self) -> usize {
        if self == Self::Program { PROGRAM_LINES } else { TEXT_LINES }
    }
}

/// A text, and what is shown of it.
pub struct Written {
    pub export: Export,
    /// Of each part of the export.
    pub shown: Vec<Shown>,
}

/// The beginning of a part.
#[derive(Debug, PartialEq, Eq)]
pub struct Shown {
    pub text: String,
    /// Lines of `text`.
    pub lines: usize,
    /// Lines that follow.
    pub hidden: usize,
}

impl Shown {
    fn of(part: &Part, most: usize) -> Self {
        let all = part.text.lines().count();
        let end = part.text.split_inclusive('\n').take(most).map(str::len).sum();
        let text = part.text.get(..end).unwrap_or_default().to_owned();
        Self { text, lines: all.min(most), hidden: all.saturating_sub(most) }
    }
}

type Answer = Result<Written, String>;

/// Writes one text at a time.
#[derive(Default)]
pub struct Writer {
    known: Option<(Question, Answer)>,
    work: Option<Errand<Question, Answer>>,
}

impl fmt::Debug for Writer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The text can be a hundred megabytes.
        write!(f, "Writer, known: {}, at work: {}", self.known.is_some(), self.work.is_some())
    }
}

struct Question {
    document: Document,
    language: Language,
}

impl Question {
    fn is(&self, document: &Document, language: Language) -> bool {
        let same = self.document.scene == document.scene && !self.document.model_differs(document);
        same && self.language == language
    }
}

impl Writer {
    /// The text of `document`, or why there is none; nothing as long as it is being written.
    pub fn ask(&mut self, ctx: &Context, document: &Document, language: Language) -> Option<Result<&Written, &str>> {
        self.take();
        let asked = |question: &Question| question.is(document, language);
        if !self.known.as_ref().is_some_and(|(known, _)| asked(known)) {
            self.known = None;
            if !self.work.as_ref().is_some_and(|work| asked(&work.question)) {
                self.work = Some(start(ctx, document.clone(), language));
            }
        }
        self.known()
    }

    /// What was last written.
    pub fn known(&self) -> Option<Result<&Written, &str>> {
        self.known.as_ref().map(|(_, answer)| answer.as_ref().map_err(String::as_str))
    }

    /// Gives back the room that a text takes.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    fn take(&mut self) {
        if let Some((question, answer)) = Errand::take(&mut self.work) {
            let answer = answer.unwrap_or_else(|| Err("Writing it ended without a result.".to_owned()));
            self.known = Some((question, answer));
        }
    }
}

fn start(ctx: &Context, document: Document, language: Language) -> Errand<Question, Answer> {
    let question = Question { document: document.clone(), language };
    Errand::new(ctx, question, move || {
        language.write(&document).map(|export| {
            let shown = export.parts.iter().map(|part| Shown::of(part, language.shown_lines())).collect();
            Written { export, shown }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_text_is_cut_after_whole_lines() {
        let part = |text: &str| Part { title: "C", ending: "c", text: text.to_owned() };
        let shown = |text, lines, hidden| Shown { text: String::from(text), lines, hidden };
        assert_eq!(Shown::of(&part("a\nb\nc\n"), 2), shown("a\nb\n", 2, 1));
        assert_eq!(Shown::of(&part("a\nb\nc"), 3), shown("a\nb\nc", 3, 0));
        assert_eq!(Shown::of(&part(""), 3), shown("", 0, 0));
    }

    #[test]
    fn a_text_is_kept_until_the_scene_or_the_language_is_another() {
        let (ctx, mut writer, mut document) = (Context::default(), Writer::default(), Document::default());
        let mut text = |document: &Document, language| {
            let place = |written: Result<&Written, &str>| written.expect("a text").export.parts[0].text.clone();
            let kept = writer.ask(&ctx, document, language).is_some();
            let written = std::iter::repeat_with(|| {
                std::thread::sleep(std::time::Duration::from_millis(1));
                writer.ask(&ctx, document, language).map(place)
            });
            (kept, written.take(20_000).flatten().next().expect("within seconds"))
        };
        let (kept, first) = text(&document, Language::Calls);
        assert!(!kept);
        assert_eq!(text(&document, Language::Calls), (true, first.clone()));
        document.scene.material.n = 17.0;
        let (kept, second) = text(&document, Language::Calls);
        assert!(!kept && second != first);
        let (kept, shaders) = text(&document, Language::Shaders);
        assert!(!kept && shaders.starts_with("#version 330"));
    }

    #[test]
    fn a_mesh_too_large_to_write_out_is_named() {
        let mut document = Document::default();
        (document.scene.object.segments, document.scene.object.rings) = (1024, 1024);
        let error = Language::Program.write(&document).map(|_| ()).expect_err("two million triangles");
        assert!(error.contains("triangles"), "{error}");
        assert!(Language::Calls.write(&document).is_ok());
    }
}
