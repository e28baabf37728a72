//! What is asked or told in front of everything else.

use super::action::Action;
use super::code::{self, CodeForm, code_ui};
use super::files::{Files, Pick};
use super::keys::BINDINGS;
use super::profile;
use super::state::{AppState, Leaving};
use crate::scene::Image;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Button, Context, DragValue, Grid, Id, Key, Modal, ProgressBar, RichText, ScrollArea, TextEdit, Ui, WidgetInfo,
};
use std::path::{Path, PathBuf};

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
    SaveProfile {
        path: String,
        ending: &'static str,
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
        | Self::SaveProfile { path, .. }
        | Self::Export(ExportForm { path, .. }) = self
        {
            *path = picked;
        } else if let Self::Code(CodeForm { path: Some(path), .. }) = self {
            *path = picked;
        }
    }

    /// Leaves a question within the dialog; tells whether there was one.
    fn step_back(&mut self) -> bool {
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
    fn complete(&mut self) {
        match self {
            Self::Save { path } => complete(path, "toml", &[]),
            Self::Export(form) => complete(&mut form.path, "png", &[]),
            Self::SaveProfile { path, ending } => complete(path, ending, &["csv", "png", "svg"]),
            Self::Code(form) => form.complete(),
            _ => {}
        }
    }

    /// The files that accepting it writes.
    fn targets(&self, state: &AppState) -> Vec<PathBuf> {
        match self {
            Self::Save { path } | Self::Export(ExportForm { path, .. }) | Self::SaveProfile { path, .. } => {
                vec![PathBuf::from(path)]
            }
            Self::Code(form) => code::targets(state, form),
            _ => vec![],
        }
    }
}

/// Gives a path that ends neither in `usual` nor in one of `others` the usual ending.
pub fn complete(path: &mut String, usual: &str, others: &[&str]) {
    let trimmed = path.trim();
    let known = Path::new(trimmed)
        .extension()
        .is_some_and(|ending| [usual].iter().chain(others).any(|known| ending.eq_ignore_ascii_case(known)));
    let folder = trimmed.ends_with(std::path::is_separator);
    *path = if known || folder { trimmed.to_owned() } else { format!("{trimmed}.{usual}") };
}

/// Shows the dialog, if any, and how far work on a file has come.
pub fn dialog_ui(ctx: &Context, state: &mut AppState, files: &mut Files) {
    let browsing = state.dialog.is_some();
    if let Some((what, fraction)) = files.progress().map(|(what, fraction)| (what.to_owned(), fraction)) {
        let shown = Modal::new(Id::unique("progress")).show(ctx, |ui| {
            ui.set_width(420.0);
            ui.label(what);
            ui.add(ProgressBar::new(fraction).show_percentage());
            ui.add_space(6.0);
            ui.button("Cancel").clicked()
        });
        let escape = !browsing && ctx.input(|input| input.key_pressed(Key::Escape));
        if shown.inner || escape {
            files.cancel();
        }
        if !browsing {
            return;
        }
    }
    let Some(mut dialog) = state.dialog.take() else { return };
    let shown = Modal::new(Id::unique("dialog")).show(ctx, |ui| {
        ui.set_width(match dialog {
            Dialog::Keys => 620.0,
            Dialog::Code(_) => code::width(ui),
            _ => 480.0,
        });
        contents_ui(ui, &mut dialog, state)
    });
    let leave = shown.should_close();
    match shown.inner {
        Choice::Browse(pick) => {
            files.pick(ctx, pick);
            state.dialog = Some(dialog);
        }
        Choice::Accept => accept(ctx, state, files, dialog),
        Choice::Back => {
            dialog.step_back();
            state.dialog = Some(dialog);
        }
        Choice::Stay if !leave || dialog.step_back() => state.dialog = Some(dialog),
        Choice::Stay | Choice::Leave | Choice::Discard => {
            state.code.forget();
            state.leaving = Leaving::No;
            ctx.request_repaint();
        }
    }
}

/// Does what a dialog asks for, once it is clear that no file is lost by it.
fn accept(ctx: &Context, state: &mut AppState, files: &mut Files, mut dialog: Dialog) {
    dialog.complete();
    let agreed = files.take_agreed();
    let lost = |path: &PathBuf| path.is_file() && !state.document.is_from(path) && agreed.as_ref() != Some(path);
    let names: Vec<String> =
        dialog.targets(state).iter().filter(|path| lost(path)).map(|path| path.display().to_string()).collect();
    if names.is_empty() {
        perform(ctx, state, files, dialog);
    } else {
        state.dialog = Some(Dialog::Replace { names: names.join(" and "), then: Box::new(dialog) });
    }
    ctx.request_repaint();
}

fn perform(ctx: &Context, state: &mut AppState, files: &mut Files, dialog: Dialog) {
    match dialog {
        Dialog::Open { path } => state.ask(Action::OpenFile(PathBuf::from(path.trim()))),
        Dialog::Save { path } => state.ask(Action::SaveTo(PathBuf::from(path.trim()))),
        Dialog::Export(form) => files.export(ctx, state, &form),
        Dialog::Code(form) => code::save(state, form),
        Dialog::SaveProfile { path, .. } => {
            if let Err(text) = profile::save(state, Path::new(path.trim())) {
                state.dialog = Some(Dialog::message("The profile was not saved", text));
            }
        }
        Dialog::Replace { then, .. } => perform(ctx, state, files, *then),
        Dialog::Unsaved => {
            state.leaving = Leaving::OnceSaved;
            state.ask(Action::Save);
        }
        Dialog::Restore { .. } => state.ask(Action::Restore),
        Dialog::Message { .. } | Dialog::Keys | Dialog::About => {}
    }
}

fn contents_ui(ui: &mut Ui, dialog: &mut Dialog, state: &mut AppState) -> Choice {
    match dialog {
        Dialog::Message { title, text } => message_ui(ui, title, text),
        Dialog::Open { path } => {
            let hint = "scene.toml, model.obj or picture.png";
            path_ui(ui, "Open a scene, a model or an exported picture", "Open", path, hint, Pick::Open)
        }
        Dialog::Save { path } => path_ui(ui, "Save the scene", "Save", path, "scene.toml", Pick::SaveScene),
        Dialog::SaveProfile { path, .. } => {
            path_ui(ui, "Save the profile", "Save", path, "profile.csv, .png or .svg", Pick::SaveProfile)
        }
        Dialog::Export(form) => export_ui(ui, form),
        Dialog::Code(form) => code_ui(ui, form, &mut state.code, &state.document),
        Dialog::Replace { names, .. } => {
            let text = format!("{names} exists already. What is in it will be lost.");
            question_ui(ui, "Replace the file?", &text, &[("Replace", Choice::Accept), ("Back", Choice::Back)])
        }
        Dialog::Unsaved => unsaved_ui(ui, state),
        Dialog::Restore { name } => restore_ui(ui, name, state),
        Dialog::Keys => keys_ui(ui),
        Dialog::About => message_ui(
            ui,
            concat!("shading-lab ", env!("CARGO_PKG_VERSION")),
            "A laboratory for local illumination and polygon shading: the illumination equation, a rasterizer of its own, \
             and what both mean in numbers.",
        ),
    }
}

/// A question with an answer a button.
fn question_ui(ui: &mut Ui, title: &str, text: &str, answers: &[(&str, Choice)]) -> Choice {
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

fn unsaved_ui(ui: &mut Ui, state: &mut AppState) -> Choice {
    let title = format!("Save the changes to {}?", state.document.name());
    let answers = [("Save", Choice::Accept), ("Close without saving", Choice::Discard), ("Cancel", Choice::Leave)];
    let choice = question_ui(ui, &title, "They are lost if the window closes without saving.", &answers);
    if choice == Choice::Discard {
        state.ask(Action::CloseUnsaved);
    }
    choice
}

fn restore_ui(ui: &mut Ui, name: &str, state: &mut AppState) -> Choice {
    let text = format!("The last window ended without closing. Unsaved changes to {name} have been kept.");
    let answers = [("Restore", Choice::Accept), ("Delete", Choice::Discard), ("Later", Choice::Leave)];
    let choice = question_ui(ui, "Restore unsaved work?", &text, &answers);
    if choice == Choice::Discard {
        state.ask(Action::DeleteLeft);
    }
    choice
}

fn message_ui(ui: &mut Ui, title: &str, text: &str) -> Choice {
    ui.heading(title);
    ui.add_space(8.0);
    ScrollArea::vertical().max_height(320.0).show(ui, |ui| ui.label(text));
    ui.add_space(12.0);
    let close = ui.button("Close");
    if close.clicked() || ui.input(|input| input.key_pressed(Key::Enter)) { Choice::Leave } else { Choice::Stay }
}

/// A field for a path, with the desktop's dialog a button away: there may be none.
fn path_ui(ui: &mut Ui, title: &str, verb: &str, path: &mut String, hint: &str, pick: Pick) -> Choice {
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

fn buttons(ui: &mut Ui, verb: &str, path: &str, entered: bool, browse: Option<Pick>) -> Choice {
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

fn export_ui(ui: &mut Ui, form: &mut ExportForm) -> Choice {
    ui.heading("Export the picture");
    ui.label(RichText::new("The scene goes with it: opening the picture brings it back.").weak());
    ui.add_space(8.0);
    Grid::new("export").num_columns(2).spacing([16.0, 8.0]).show(ui, |ui| {
        ui.label("Size");
        ui.horizontal(|ui| {
            side_ui(ui, "Width", &mut form.size[0]);
            ui.label("×");
            side_ui(ui, "Height", &mut form.size[1]);
            ui.label("pixels");
        });
        ui.end_row();
        ui.label("Samples per pixel");
        let samples = ui.add(DragValue::new(&mut form.samples).range(1..=1024));
        samples.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, "Samples per pixel"));
        ui.end_row();
        ui.label("Vectors");
        ui.checkbox(&mut form.overlay, "as they are shown");
        ui.end_row();
    });
    ui.add_space(8.0);
    let (entered, browse) = path_field(ui, &mut form.path, "picture.png");
    ui.add_space(12.0);
    buttons(ui, "Export", &form.path, entered, browse.then_some(Pick::SavePicture))
}

fn side_ui(ui: &mut Ui, name: &str, side: &mut u32) {
    let field = ui.add(DragValue::new(side).range(1..=Image::MAX_SIDE / 2));
    field.widget_info(|| WidgetInfo::labeled(Role::SpinButton, true, name));
}

fn keys_ui(ui: &mut Ui) -> Choice {
    ui.heading("Keys and gestures");
    ui.add_space(8.0);
    ScrollArea::vertical().max_height(440.0).auto_shrink([false, true]).show(ui, |ui| {
        Grid::new("keys").num_columns(2).spacing([24.0, 6.0]).striped(true).show(ui, |ui| {
            let mut section = "";
            for binding in BINDINGS {
                if binding.section != section {
                    section = binding.section;
                    ui.label(RichText::new(section).strong());
                    ui.end_row();
                }
                ui.label(RichText::new(binding.keys).monospace());
                ui.label(binding.does);
                ui.end_row();
            }
        });
    });
    ui.add_space(12.0);
    if ui.button("Close").clicked() { Choice::Leave } else { Choice::Stay }
}
