//! The scene as source code, to read, to copy and to save: calls of OpenGL, shaders, or a whole program in C.
//! The text is written in the background, and again whenever the scene changes.

use super::dialog::{CodeForm, Dialog, Language};
use crate::analysis::Watch;
use crate::app::session::document::Document;
use crate::app::session::window::WindowState;
use crate::app::system;
use crate::app::widgets::background::wake;
use crate::app::widgets::dialog::{Choice, both, buttons_ui, path_ui};
use crate::app::widgets::focus::{heading, named, switch_named};
use crate::document::save_code;
use crate::export::{Export, Limit, Part, glsl_330_of_model, opengl_c, opengl_c_snippet};
use crate::geometry::{Mesh, tessellate};
use crate::jobs::{Background, Request, Work};
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::text::LayoutJob;
use eframe::egui::{
    Button, Context, Frame, Label, ScrollArea, TextBuffer, TextEdit, TextStyle, Ui,
};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The maximum number of lines displayed of a program: the rest is a list of polygons.
const PROGRAM_LINES: usize = 200;
/// The maximum number of lines displayed of other texts; only a scene with hundreds of lights has more.
const TEXT_LINES: usize = 2000;
/// The languages, with the names and the tips of their tabs.
const LANGUAGES: [(Language, &str, &str); 3] = [
    (Language::Calls, "code-calls", "code-calls-tip"),
    (Language::Shaders, "code-shaders", "code-shaders-tip"),
    (Language::Program, "code-program", "code-program-tip"),
];
/// The maximum width of the dialog, in points: a line of 100 characters.
const WIDTH: f32 = 920.0;
/// The maximum height of the dialog's contents above its buttons, in points.
const HEIGHT: f32 = 620.0;
/// The height taken by the dialog's buttons, its margins and its distance from the window's edges, in points.
const AROUND: f32 = 180.0;
/// The minimum height of the text, in points.
const LEAST_TEXT: f32 = 96.0;
/// The margin around the text, in points.
const MARGIN: f32 = 8.0;
/// The maximum height of the list of limits, in points; a longer one scrolls.
const LIMITS: f32 = 92.0;

fn write(language: Language, scene: &Scene, model: Option<&Arc<Mesh>>) -> Result<Export, String> {
    let mesh = || {
        model
            .cloned()
            .unwrap_or_else(|| Arc::new(tessellate(&scene.object)))
    };
    match language {
        Language::Calls => Ok(opengl_c_snippet(scene, &mesh())),
        Language::Shaders => Ok(glsl_330_of_model(scene, model.map(|mesh| &**mesh))),
        Language::Program => opengl_c(scene, &mesh()).map_err(|error| error.to_string()),
    }
}

/// An exported text, with the excerpts on display.
pub struct Written {
    pub export: Export,
    /// The excerpt of each part of the export.
    pub shown: Vec<Shown>,
}

impl Written {
    /// Returns the files that are written for `target`.
    fn paths(&self, target: &Path) -> Vec<PathBuf> {
        self.export
            .parts
            .iter()
            .map(|part| self.export.path_of(part, target))
            .collect()
    }

    fn names(&self, target: &Path) -> String {
        self.paths(target)
            .iter()
            .map(|path| path.display().to_string())
            .reduce(both)
            .unwrap_or_default()
    }
}

/// The beginning of a part.
#[derive(Debug, PartialEq, Eq)]
pub struct Shown {
    pub text: String,
    /// The number of lines in `text`.
    pub lines: usize,
    /// The number of lines that follow.
    pub hidden: usize,
}

impl Shown {
    fn of(part: &Part, most: usize) -> Self {
        let all = part.text.lines().count();
        Self {
            text: part.text.split_inclusive('\n').take(most).collect(),
            lines: all.min(most),
            hidden: all.saturating_sub(most),
        }
    }
}

impl Work for Request<Language> {
    type Answer = Arc<Written>;

    fn run(&self, _: &dyn Watch<Self::Answer>) -> Result<Self::Answer, String> {
        let language = self.question;
        let export = write(language, &self.scene, self.model.as_ref())?;
        let most = if language == Language::Program {
            PROGRAM_LINES
        } else {
            TEXT_LINES
        };
        let shown = export
            .parts
            .iter()
            .map(|part| Shown::of(part, most))
            .collect();
        Ok(Arc::new(Written { export, shown }))
    }
}

type Answer = Result<Arc<Written>, String>;

/// The background task that writes one text at a time.
pub type Writer = Background<Request<Language>>;

/// Returns the text of `document`, or the reason why there is none; `None` while it is being written.
fn ask<'a>(
    writer: &'a mut Writer,
    ctx: &Context,
    document: &Document,
    language: Language,
) -> Option<&'a Answer> {
    let Document { scene, model, .. } = document;
    let same =
        |asked: &Request<Language>| asked.is(&language, scene, model.as_ref(), scene.image.size);
    writer.keep_only(same);
    writer.ask(wake(ctx), same, || {
        Request::new(language, scene, model.as_ref(), scene.image.size)
    });
    writer.known()
}

/// Returns the width of the dialog, in points.
pub fn width(ui: &Ui) -> f32 {
    (ui.ctx().content_rect().width() - 64.0).clamp(0.0, WIDTH)
}

/// Returns the target path of the form, and the text to be written there.
fn asked<'a>(window: &'a WindowState, form: &CodeForm) -> Option<(PathBuf, &'a Written)> {
    let written = window.own.get().and_then(Writer::answer)?;
    Some((PathBuf::from(form.path.as_ref()?.trim()), written))
}

/// Writes the files that the form requests. Returns the dialog, which stays open and reports the result.
pub fn save(window: &WindowState, mut form: CodeForm) -> Dialog {
    if let Some((target, written)) = asked(window, &form) {
        form.message = Some(match save_code(&target, &written.export) {
            Ok(()) => {
                form.path = None;
                text!("saved", path = written.names(&target))
            }
            Err(error) => error.to_string(),
        });
    }
    Dialog::Code(form)
}

/// Returns the files that the form requests.
pub fn targets(window: &WindowState, form: &CodeForm) -> Vec<PathBuf> {
    asked(window, form).map_or(vec![], |(target, written)| written.paths(&target))
}

/// Shows the contents of the dialog.
pub fn code_ui(
    ui: &mut Ui,
    form: &mut CodeForm,
    writer: &mut Writer,
    (document, no_dialog): (&Document, bool),
) -> Choice {
    heading(ui, text!("code"));
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        for (language, title, what) in LANGUAGES {
            let (title, what) = (text!(title), text!(what));
            let on = form.language == language;
            let tab = switch_named(ui.add(Button::selectable(on, title)), Role::Tab, on, title);
            if tab.on_hover_text(what).clicked() && !on {
                *form = CodeForm {
                    language,
                    ..CodeForm::default()
                };
            }
        }
    });
    ui.add_space(4.0);
    let bottom = ui.cursor().top() + HEIGHT.min(ui.ctx().content_rect().height() - AROUND);
    let answer = ask(writer, ui.ctx(), document, form.language);
    match answer {
        None => _ = ui.label(text!("code-writing")),
        Some(Err(reason)) => _ = ui.label(reason),
        Some(Ok(written)) => {
            form.part = form.part.min(written.shown.len().saturating_sub(1));
            limits_ui(ui, &written.export.limits);
            if let Some(shown) = written.shown.get(form.part) {
                // The choice of parts, and the number of lines displayed.
                ui.horizontal(|ui| {
                    for (index, part) in written
                        .export
                        .parts
                        .iter()
                        .enumerate()
                        .filter(|_| written.shown.len() > 1)
                    {
                        ui.selectable_value(&mut form.part, index, part.title.text());
                    }
                    let Shown { lines, hidden, .. } = shown;
                    let text = match hidden {
                        0 => text!("code-lines", count = *lines),
                        _ => text!("code-first-lines", shown = *lines, all = lines + hidden),
                    };
                    ui.weak(text);
                });
                let height = (bottom - ui.cursor().top() - 2.0 * MARGIN).max(LEAST_TEXT);
                text_ui(ui, form, &shown.text, height);
            }
        }
    }
    // The tabs and the buttons stay in place, whatever the text.
    ui.add_space((bottom - ui.cursor().top()).max(0.0) + 8.0);
    let ready = answer.and_then(|answer| answer.as_deref().ok());
    if let Some(message) = &form.message {
        ui.label(message);
    }
    let Some(path) = &mut form.path else {
        return actions_ui(ui, form, ready, document);
    };
    let entered = path_ui(ui, path, form.language.file_kind().example, no_dialog);
    let sound = ready.filter(|_| !path.trim().is_empty());
    if let Some(written) = sound.filter(|written| written.export.parts.len() > 1) {
        let names = written.names(Path::new(path.trim()));
        ui.weak(text!("code-files", names = names));
    }
    buttons_ui(
        ui,
        text!("save"),
        (text!("back"), Choice::Back),
        sound.is_some(),
        entered,
    )
}

/// Shows the features of the scene that the target cannot express, as prominently as the text itself.
fn limits_ui(ui: &mut Ui, limits: &[Limit]) {
    if limits.is_empty() {
        ui.weak(text!("code-complete"));
        return;
    }
    ui.weak(text!("code-limits"));
    ScrollArea::vertical()
        .id_salt("limits")
        .max_height(LIMITS)
        .auto_shrink([false, true])
        .show(ui, |ui| {
            for limit in limits {
                ui.horizontal_top(|ui| {
                    ui.label("•");
                    ui.add(Label::new(limit.to_string()).wrap());
                });
            }
        });
}

/// Shows the text: scrolled, not wrapped, selectable but read-only.
fn text_ui(ui: &mut Ui, form: &CodeForm, text: &str, height: f32) {
    let (font, colour) = (
        TextStyle::Monospace.resolve(ui.style()),
        ui.visuals().text_color(),
    );
    let mut unwrapped = |ui: &Ui, text: &dyn TextBuffer, _: f32| {
        let job = LayoutJob::simple(
            text.as_str().to_owned(),
            font.clone(),
            colour,
            f32::INFINITY,
        );
        ui.fonts_mut(|fonts| fonts.layout_job(job))
    };
    let well = Frame::new()
        .fill(ui.visuals().extreme_bg_color)
        .corner_radius(5)
        .inner_margin(MARGIN);
    well.show(ui, |ui| {
        let scroll = ScrollArea::both()
            .id_salt((form.language, form.part))
            .auto_shrink(false)
            .max_height(height);
        scroll.show(ui, |ui| {
            let mut buffer = text;
            let view = TextEdit::multiline(&mut buffer)
                .layouter(&mut unwrapped)
                .frame(Frame::NONE);
            let view = ui.add(view.cursor_at_end(false).desired_width(f32::INFINITY));
            named(view, Role::MultilineTextInput, text!("code-text"));
        });
    });
}

fn actions_ui(
    ui: &mut Ui,
    form: &mut CodeForm,
    ready: Option<&Written>,
    document: &Document,
) -> Choice {
    let mut choice = Choice::Stay;
    ui.horizontal(|ui| {
        let copy = ui.add_enabled(ready.is_some(), Button::new(text!("copy")));
        let save = ui.add_enabled(ready.is_some(), Button::new(text!("save-as")));
        if let Some(part) = ready.and_then(|written| written.export.parts.get(form.part)) {
            if copy.clicked() {
                ui.ctx().copy_text(part.text.clone());
                form.message = Some(text!("copied", what = part.title.text()));
            }
            if save.clicked() {
                form.path = Some(document.suggested(part.ending));
                form.message = None;
                // A web page downloads it at once.
                if system::PAGE {
                    choice = Choice::Accept;
                }
            }
        }
        if ui.button(text!("close")).clicked() {
            choice = Choice::Leave;
        }
    });
    choice
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::Message;

    #[test]
    fn a_long_text_is_cut_after_whole_lines() {
        let part = |text: &str| Part {
            title: Message("export-c"),
            ending: "c",
            text: text.to_owned(),
        };
        let shown = |text, lines, hidden| Shown {
            text: String::from(text),
            lines,
            hidden,
        };
        assert_eq!(Shown::of(&part("a\nb\nc\n"), 2), shown("a\nb\n", 2, 1));
        assert_eq!(Shown::of(&part("a\nb\nc"), 3), shown("a\nb\nc", 3, 0));
        assert_eq!(Shown::of(&part(""), 3), shown("", 0, 0));
    }
}
