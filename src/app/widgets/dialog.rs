//! Widgets shared by all dialogs.

use super::focus::{heading, named, take_if_free};
use super::theme::text_field;
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Key, Label, RichText, ScrollArea, Ui};
use std::path::PathBuf;

/// The kind of file that a dialog asks for.
pub struct FileKind {
    pub title: &'static str,
    /// The label of the button.
    pub verb: &'static str,
    /// The name of such files in the desktop's own dialog.
    pub files: &'static str,
    /// The accepted file extensions; any if empty.
    pub endings: &'static [&'static str],
    /// A file name with the usual extension.
    pub example: &'static str,
}

/// The outcome of the desktop's own file dialog.
pub enum Picked {
    #[cfg_attr(
        target_arch = "wasm32",
        allow(dead_code, reason = "a page has no paths")
    )]
    File(PathBuf),
    /// The user cancelled the dialog.
    Nothing,
    /// The desktop has no such dialog.
    NoDialog,
}

/// The user's choice in a dialog.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Choice {
    Stay,
    Leave,
    Accept,
    /// The desktop's own dialog for the file.
    Browse,
    /// The previous question.
    Back,
    /// Leaving, and discarding what the question is about.
    Discard,
}

/// Joins two names by "and".
pub fn both(first: String, second: String) -> String {
    text!("and", first = first, second = second)
}

/// Shows a question or a message with a button for each answer. If there is only one answer, Enter chooses it.
pub fn question_ui(ui: &mut Ui, title: &str, text: &str, answers: &[(&str, Choice)]) -> Choice {
    heading(ui, title);
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

/// Shows a field for a path, with a button for the desktop's dialog, and says so if the desktop has none. Accepts when
/// Enter is pressed in the field.
pub fn path_ui(ui: &mut Ui, path: &mut String, hint: &str, no_dialog: bool) -> Choice {
    let mut choice = Choice::Stay;
    ui.horizontal(|ui| {
        let field = text_field(path)
            .hint_text(hint)
            .desired_width((ui.available_width() - 92.0).max(0.0));
        let field = named(ui.add(field), Role::TextInput, text!("file"));
        if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
            choice = Choice::Accept;
        } else {
            take_if_free(&field);
        }
        let browse = ui.button(text!("browse"));
        if browse.on_hover_text(text!("browse-tip")).clicked() {
            choice = Choice::Browse;
        }
    });
    if no_dialog {
        let words = RichText::new(text!("browse-none")).color(ui.visuals().error_fg_color);
        ui.add(Label::new(words).wrap());
    }
    choice
}

/// Shows the buttons below a path. `entered` is the choice made in the path's field; accepting requires that the path
/// is `ready`.
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
