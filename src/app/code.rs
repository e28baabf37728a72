//! The scene in other programs' words, to read, to copy and to save: calls of OpenGL, shaders, or a whole program in C.

pub mod form;
mod writer;

pub use writer::Writer;

use super::dialog::{Choice, Dialog, Pick, path_field};
use super::document::Document;
use super::state::AppState;
use crate::document::save_code;
use eframe::egui::accesskit::Role;
use eframe::egui::text::LayoutJob;
use eframe::egui::{Button, Frame, Label, RichText, ScrollArea, TextBuffer, TextEdit, TextStyle, Ui, WidgetInfo};
use form::{CodeForm, Language};
use std::path::{Path, PathBuf};
use writer::{Shown, Written};

/// Width of the dialog in a window that has room for it, points: a line of 100 characters.
const WIDTH: f32 = 920.0;
/// Height of the dialog's contents above its buttons in a window that has room for them, points.
const HEIGHT: f32 = 620.0;
/// Height that the dialog's buttons, margins and distance from the window's edges take, points.
const AROUND: f32 = 180.0;
/// The text has at least this height, points.
const LEAST_TEXT: f32 = 96.0;
/// Round the text, points.
const MARGIN: f32 = 8.0;
/// Height that the list of limits may have, points; a longer one is scrolled.
const LIMITS: f32 = 92.0;

/// The width of the dialog, points.
pub fn width(ui: &Ui) -> f32 {
    (ui.ctx().content_rect().width() - 64.0).clamp(0.0, WIDTH)
}

/// Writes the files that the form asks for; the dialog stays open and says what has become of it.
pub fn save(state: &mut AppState, mut form: CodeForm) {
    if let (Some(path), Some(Ok(written))) = (&form.path, state.own.get().and_then(Writer::known)) {
        let target = PathBuf::from(path.trim());
        form.message = Some(match save_code(&target, &written.export) {
            Ok(()) => {
                form.path = None;
                format!("saved {}", names(&target, written))
            }
            Err(error) => error.to_string(),
        });
    }
    state.dialog = Some(Dialog::Code(form));
}

/// The files that are written for `target`.
fn paths(target: &Path, written: &Written) -> Vec<PathBuf> {
    written.export.parts.iter().map(|part| written.export.path_of(part, target)).collect()
}

fn names(target: &Path, written: &Written) -> String {
    paths(target, written).iter().map(|path| path.display().to_string()).collect::<Vec<_>>().join(" and ")
}

/// The files that the form asks for.
pub fn targets(state: &AppState, form: &CodeForm) -> Vec<PathBuf> {
    match (&form.path, state.own.get().and_then(Writer::known)) {
        (Some(path), Some(Ok(written))) => paths(Path::new(path.trim()), written),
        _ => vec![],
    }
}

/// What the dialog shows.
pub fn code_ui(ui: &mut Ui, form: &mut CodeForm, writer: &mut Writer, document: &Document) -> Choice {
    ui.heading("The scene as code");
    ui.add_space(6.0);
    languages_ui(ui, form);
    ui.add_space(4.0);
    let bottom = ui.cursor().top() + HEIGHT.min(ui.ctx().content_rect().height() - AROUND);
    let answer = writer.ask(ui.ctx(), document, form.language);
    match &answer {
        None => drop(ui.label("Writing…")),
        Some(Err(reason)) => drop(ui.label(*reason)),
        Some(Ok(written)) => written_ui(ui, form, written, bottom),
    }
    // The tabs and the buttons stay where they are, whatever text there is.
    ui.add_space((bottom - ui.cursor().top()).max(0.0) + 8.0);
    let ready = answer.and_then(Result::ok);
    if let Some(message) = &form.message {
        ui.label(message);
    }
    if form.path.is_some() { path_ui(ui, form, ready) } else { buttons_ui(ui, form, ready, document) }
}

fn written_ui(ui: &mut Ui, form: &mut CodeForm, written: &Written, bottom: f32) {
    form.part = form.part.min(written.shown.len().saturating_sub(1));
    limits_ui(ui, &written.export.limits);
    let Some(shown) = written.shown.get(form.part) else { return };
    parts_ui(ui, form, written, shown);
    text_ui(ui, form, &shown.text, (bottom - ui.cursor().top() - 2.0 * MARGIN).max(LEAST_TEXT));
}

fn languages_ui(ui: &mut Ui, form: &mut CodeForm) {
    ui.horizontal(|ui| {
        for language in Language::ALL {
            let on = form.language == language;
            let tab = ui.add(Button::selectable(on, language.title())).on_hover_text(language.what());
            let enabled = tab.enabled();
            tab.widget_info(|| WidgetInfo::selected(Role::Tab, enabled, on, language.title()));
            if tab.clicked() && !on {
                *form = CodeForm { language, ..CodeForm::default() };
            }
        }
    });
}

/// What the target cannot say, as plainly as the text itself.
fn limits_ui(ui: &mut Ui, limits: &[String]) {
    if limits.is_empty() {
        ui.label(RichText::new("It expresses the scene completely.").weak());
        return;
    }
    ui.label(RichText::new("What it does not express:").weak());
    ScrollArea::vertical().id_salt("limits").max_height(LIMITS).auto_shrink([false, true]).show(ui, |ui| {
        for limit in limits {
            ui.horizontal_top(|ui| {
                ui.label("•");
                ui.add(Label::new(limit).wrap());
            });
        }
    });
}

/// The parts to choose from, and how much of the text is seen.
fn parts_ui(ui: &mut Ui, form: &mut CodeForm, written: &Written, shown: &Shown) {
    ui.horizontal(|ui| {
        if written.export.parts.len() > 1 {
            for (index, part) in written.export.parts.iter().enumerate() {
                ui.selectable_value(&mut form.part, index, part.title);
            }
        }
        let Shown { lines, hidden, .. } = shown;
        let text = match hidden {
            0 => format!("{lines} lines"),
            _ => format!("the first {lines} of {} lines; copying and saving take them all", lines + hidden),
        };
        ui.label(RichText::new(text).weak());
    });
}

/// The text: scrolled, not wrapped, to be selected but not changed.
fn text_ui(ui: &mut Ui, form: &CodeForm, text: &str, height: f32) {
    let (font, colour) = (TextStyle::Monospace.resolve(ui.style()), ui.visuals().text_color());
    let mut unwrapped = |ui: &Ui, text: &dyn TextBuffer, _: f32| {
        let job = LayoutJob::simple(text.as_str().to_owned(), font.clone(), colour, f32::INFINITY);
        ui.fonts_mut(|fonts| fonts.layout_job(job))
    };
    let well = Frame::new().fill(ui.visuals().extreme_bg_color).corner_radius(5).inner_margin(MARGIN);
    well.show(ui, |ui| {
        let scroll = ScrollArea::both().id_salt((form.language, form.part)).auto_shrink(false).max_height(height);
        scroll.show(ui, |ui| {
            let mut buffer = text;
            let view = TextEdit::multiline(&mut buffer).layouter(&mut unwrapped).frame(Frame::NONE);
            let view = ui.add(view.cursor_at_end(false).desired_width(f32::INFINITY));
            let enabled = view.enabled();
            view.widget_info(|| WidgetInfo::labeled(Role::MultilineTextInput, enabled, "Code"));
        });
    });
}

fn buttons_ui(ui: &mut Ui, form: &mut CodeForm, ready: Option<&Written>, document: &Document) -> Choice {
    let mut choice = Choice::Stay;
    ui.horizontal(|ui| {
        let copy = ui.add_enabled(ready.is_some(), Button::new("Copy"));
        let save = ui.add_enabled(ready.is_some(), Button::new("Save…"));
        if let Some(part) = ready.and_then(|written| written.export.parts.get(form.part)) {
            if copy.clicked() {
                ui.ctx().copy_text(part.text.clone());
                form.message = Some(format!("copied the {}", part.title));
            }
            if save.clicked() {
                form.path = Some(document.suggested(part.ending));
                form.message = None;
            }
        }
        if ui.button("Close").clicked() {
            choice = Choice::Leave;
        }
    });
    choice
}

/// Asks where to save.
fn path_ui(ui: &mut Ui, form: &mut CodeForm, ready: Option<&Written>) -> Choice {
    let Some(path) = &mut form.path else { return Choice::Stay };
    let (entered, browse) = path_field(ui, path, form.language.suggestion());
    let sound = ready.filter(|_| !path.trim().is_empty());
    if let Some(written) = sound.filter(|written| written.export.parts.len() > 1) {
        ui.label(RichText::new(format!("Writes {}", names(Path::new(path.trim()), written))).weak());
    }
    let mut choice = if browse { Choice::Browse(Pick::SaveCode(form.language)) } else { Choice::Stay };
    ui.horizontal(|ui| {
        if ui.add_enabled(sound.is_some(), Button::new("Save")).clicked() || (sound.is_some() && entered) {
            choice = Choice::Accept;
        }
        if ui.button("Back").clicked() {
            form.path = None;
        }
    });
    choice
}
