//! What is asked or told in front of everything else, and the widgets that all dialogs share.

use super::code::form::{CodeForm, Language};
use super::paths::complete_path;
use crate::analysis::Format;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Key, ScrollArea, TextEdit, Ui, WidgetInfo};

/// A dialog.
#[derive(Clone, Debug, PartialEq)]
pub enum Dialog {
    Message {
        title: String,
        text: String,
    },
    Open {
        path: String,
    },
    Save {
        path: String,
    },
    Export(ExportForm),
    Code(CodeForm),
    /// Where to save the answer of an analysis.
    SaveAnswer {
        path: String,
        format: Format,
    },
    /// Whether to replace files that exist, before what another dialog asks for is done.
    Replace {
        names: String,
        then: Box<Self>,
    },
    /// Whether to save before the window closes.
    Unsaved,
    /// Whether to restore unsaved work that was left behind.
    Restore {
        name: String,
    },
    Keys,
    About,
}

/// How a picture is to be exported.
#[derive(Clone, Debug, PartialEq)]
pub struct ExportForm {
    pub size: [u32; 2],
    pub samples: u32,
    /// With the vectors as they are shown.
    pub overlay: bool,
    pub path: String,
}

/// What the user has decided.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Choice {
    Stay,
    Leave,
    Accept,
    Browse(Pick),
    /// To the question before.
    Back,
    /// Leave, and let go of what the question is about.
    Discard,
}

impl Dialog {
    /// A message, for example an error.
    pub fn message(title: &str, text: String) -> Self {
        Self::Message { title: title.to_owned(), text }
    }

    /// Takes over a path that was picked elsewhere.
    pub fn take_path(&mut self, picked: String) {
        if let Self::Open { path }
        | Self::Save { path }
        | Self::SaveAnswer { path, .. }
        | Self::Export(ExportForm { path, .. }) = self
        {
            *path = picked;
        } else if let Self::Code(CodeForm { path: Some(path), .. }) = self {
            *path = picked;
        }
    }

    /// Leaves a question within the dialog; tells whether there was one.
    pub fn step_back(&mut self) -> bool {
        match self {
            Self::Code(form) => form.step_back(),
            Self::Replace { then, .. } => {
                *self = std::mem::replace(&mut **then, Self::About);
                true
            }
            _ => false,
        }
    }

    /// Gives the file that is to be written an ending that the program reads, where its name has none.
    pub fn complete(&mut self) {
        match self {
            Self::Save { path } => complete_path(path, "toml", &[]),
            Self::Export(form) => complete_path(&mut form.path, "png", &[]),
            Self::SaveAnswer { path, format } => {
                complete_path(path, format.ending(), &["csv", "png", "svg", "json"]);
            }
            Self::Code(form) => form.complete(),
            _ => {}
        }
    }
}

/// Which dialog of the desktop's is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pick {
    Open,
    SaveScene,
    SavePicture,
    SaveCode(Language),
    SaveAnswer(Format),
}

/// A question with an answer a button.
pub fn question_ui(ui: &mut Ui, title: &str, text: &str, answers: &[(&str, Choice)]) -> Choice {
    ui.heading(title);
    ui.add_space(8.0);
    ui.label(text);
    ui.add_space(12.0);
    ui.horizontal(|ui| {
        let mut choice = Choice::Stay;
        for (answer, meaning) in answers {
            if ui.button(*answer).clicked() {
                choice = *meaning;
            }
        }
        choice
    })
    .inner
}

pub fn message_ui(ui: &mut Ui, title: &str, text: &str) -> Choice {
    ui.heading(title);
    ui.add_space(8.0);
    ScrollArea::vertical().max_height(320.0).show(ui, |ui| ui.label(text));
    ui.add_space(12.0);
    let close = ui.button("Close");
    if close.clicked() || ui.input(|input| input.key_pressed(Key::Enter)) { Choice::Leave } else { Choice::Stay }
}

/// A field for a path, with the desktop's dialog a button away: there may be none.
pub fn path_ui(ui: &mut Ui, title: &str, verb: &str, path: &mut String, hint: &str, pick: Pick) -> Choice {
    ui.heading(title);
    ui.add_space(8.0);
    let (entered, browse) = path_field(ui, path, hint);
    ui.add_space(12.0);
    buttons(ui, verb, path, entered, browse.then_some(pick))
}

/// The field; tells whether Enter was pressed in it, and whether the desktop's dialog is asked for.
pub fn path_field(ui: &mut Ui, path: &mut String, hint: &str) -> (bool, bool) {
    ui.horizontal(|ui| {
        let field = TextEdit::singleline(path).hint_text(hint).desired_width((ui.available_width() - 92.0).max(0.0));
        let field = ui.add(field);
        let enabled = ui.is_enabled();
        field.widget_info(|| WidgetInfo::labeled(Role::TextInput, enabled, "File"));
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if !field.has_focus() && !entered && ui.memory(|memory| memory.focused().is_none()) {
            field.request_focus();
        }
        let browse = ui.button("Browse…").on_hover_text("The desktop's own dialog, where it has one").clicked();
        (entered, browse)
    })
    .inner
}

pub fn buttons(ui: &mut Ui, verb: &str, path: &str, entered: bool, browse: Option<Pick>) -> Choice {
    let ready = !path.trim().is_empty();
    let mut choice = browse.map_or(Choice::Stay, Choice::Browse);
    ui.horizontal(|ui| {
        if ui.add_enabled(ready, Button::new(verb)).clicked() || (ready && entered) {
            choice = Choice::Accept;
        }
        if ui.button("Cancel").clicked() {
            choice = Choice::Leave;
        }
    });
    choice
}
