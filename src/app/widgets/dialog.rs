//! The widgets that all dialogs share.

use super::focus::named;
use super::theme::text_field;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Key, Label, RichText, ScrollArea, Ui};
use std::path::PathBuf;

/// The kind of file that a dialog asks for.
pub struct FileKind {
    pub title: &'static str,
    /// What the button says.
    pub verb: &'static str,
    /// What the desktop's own dialog calls such files.
    pub files: &'static str,
    /// What their names may end in; anything where empty.
    pub endings: &'static [&'static str],
    /// A name with the usual ending.
    pub example: &'static str,
}

/// What became of the desktop's own dialog for a file.
pub enum Picked {
    #[cfg_attr(
        target_arch = "wasm32",
        allow(dead_code, reason = "a page has no paths")
    )]
    File(PathBuf),
    /// It was cancelled.
    Nothing,
    /// The desktop has none.
    NoDialog,
}

/// What the user has decided.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Choice {
    Stay,
    Leave,
    Accept,
    /// The desktop's own dialog for the file.
    Browse,
    /// To the question before.
    Back,
    /// Leave, and let go of what the question is about.
    Discard,
}

/// Two names in one sentence.
pub fn both(first: String, second: String) -> String {
    text!("and", first = first, second = second)
}

/// A question or a message with a button for each answer; Enter gives the only one.
pub fn question_ui(ui: &mut Ui, title: &str, text: &str, answers: &[(&str, Choice)]) -> Choice {
    ui.heading(title);
    ui.add_space(8.0);
    ScrollArea::vertical()
        .max_height(320.0)
        .show(ui, |ui| ui.label(text));
    ui.add_space(12.0);
    let enter = answers.len() == 1 && ui.input(|input| input.key_pressed(Key::Enter));
    let given = |ui: &mut Ui, answer: &str| ui.button(answer).clicked() || enter;
    let chosen = ui.horizontal(|ui| {
        answers
            .iter()
            .filter(|(answer, _)| given(ui, answer))
            .last()
    });
    chosen.inner.map_or(Choice::Stay, |(_, choice)| *choice)
}

/// A field for a path, with the desktop's dialog a button away; where there turned out to be none, it says so. Accepts when Enter is
/// pressed in it.
pub fn path_ui(ui: &mut Ui, path: &mut String, hint: &str, no_dialog: bool) -> Choice {
    let mut choice = Choice::Stay;
    ui.horizontal(|ui| {
        let field = text_field(path)
            .hint_text(hint)
            .desired_width((ui.available_width() - 92.0).max(0.0));
        let field = named(ui.add(field), Role::TextInput, text!("file"));
        if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
            choice = Choice::Accept;
        } else if !field.has_focus() && ui.memory(|memory| memory.focused().is_none()) {
            field.request_focus();
        }
        if ui
            .button(text!("browse"))
            .on_hover_text(text!("browse-tip"))
            .clicked()
        {
            choice = Choice::Browse;
        }
    });
    if no_dialog {
        let words = RichText::new(text!("browse-none")).color(ui.visuals().error_fg_color);
        ui.add(Label::new(words).wrap());
    }
    choice
}

/// The buttons below a path; what `entered` chose holds where the path is `ready`.
pub fn buttons_ui(
    ui: &mut Ui,
    verb: &str,
    back: (&str, Choice),
    ready: bool,
    entered: Choice,
) -> Choice {
    let mut choice = if entered == Choice::Accept && !ready {
        Choice::Stay
    } else {
        entered
    };
    ui.horizontal(|ui| {
        if ui.add_enabled(ready, Button::new(verb)).clicked() {
            choice = Choice::Accept;
        }
        if ui.button(back.0).clicked() {
            choice = back.1;
        }
    });
    choice
}
