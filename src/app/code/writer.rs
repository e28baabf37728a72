//! The texts, written in the background: once for what is asked, and again when the scene has become another.

use super::super::background::wake;
use super::super::document::Document;
use super::form::Language;
use crate::analysis::Watch;
use crate::export::{Export, Part, glsl_330, opengl_c, opengl_c_snippet};
use crate::geometry::{Mesh, tessellate};
use crate::jobs::{Asked, Background, Work};
use crate::scene::Scene;
use eframe::egui::Context;
use std::sync::Arc;

/// Lines that are shown of a program: its polygons, which fill the rest, are not for reading.
const PROGRAM_LINES: usize = 200;
/// Lines that are shown of other texts; only a scene of hundreds of lights has more.
const TEXT_LINES: usize = 2000;

impl Language {
    fn write(self, scene: &Scene, model: Option<&Arc<Mesh>>) -> Result<Export, String> {
        let mesh = || model.cloned().unwrap_or_else(|| Arc::new(tessellate(&scene.object)));
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

impl Work for Asked<Language> {
    type Answer = Arc<Written>;

    fn run(&self, _: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let language = self.question;
        let export = language.write(&self.scene, self.model.as_ref())?;
        let shown = export.parts.iter().map(|part| Shown::of(part, language.shown_lines())).collect();
        Ok(Arc::new(Written { export, shown }))
    }
}

/// Writes one text at a time.
#[derive(Debug, Default)]
pub struct Writer(Background<Asked<Language>>);

impl Writer {
    /// The text of `document`, or why there is none; nothing as long as it is being written.
    pub fn ask(&mut self, ctx: &Context, document: &Document, language: Language) -> Option<Result<&Written, &str>> {
        let Document { scene, model, .. } = document;
        let same = |asked: &Asked<Language>| asked.is(&language, scene, model.as_ref(), scene.image.size);
        self.0.keep_only(same);
        self.0.ask(wake(ctx), same, || Asked::new(language, scene, model.as_ref(), scene.image.size));
        self.known()
    }

    /// What was last written.
    pub fn known(&self) -> Option<Result<&Written, &str>> {
        self.0.known().map(|answer| answer.as_ref().map(|written| &**written).map_err(String::as_str))
    }

    /// Gives back the room that a text takes.
    pub fn forget(&mut self) {
        *self = Self::default();
    }
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
        let error = Language::Program.write(&document.scene, None).map(|_| ()).expect_err("two million triangles");
        assert!(error.contains("triangles"), "{error}");
        assert!(Language::Calls.write(&document.scene, None).is_ok());
    }
}
