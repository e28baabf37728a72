//! The dialogs of the window, and what becomes of their answers.

use super::action::Action;
use super::code::{self, Writer, code_ui};
use super::commands::SECTIONS;
use super::dialog::{Choice, Dialog, ExportForm, FileTask, buttons_ui, path_ui, question_ui};
use super::files::Files;
use super::focus::named;
use super::report;
use super::scenes::scenes_ui;
use super::state::{AppState, Leaving};
use crate::scene::Image;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Context, DragValue, Grid, Id, Key, Modal, ProgressBar, RichText, ScrollArea, Ui,
};
use std::path::{Path, PathBuf};

/// Shows the dialog, if any, and how far work on a file has come.
pub fn dialog_ui(ctx: &Context, state: &mut AppState, files: &mut Files) {
    let browsing = state.dialog.is_some();
    if let Some((what, fraction)) = files.progress() {
        let shown = Modal::new(Id::unique("progress")).show(ctx, |ui| {
            ui.set_width(420_f32.min(ctx.content_rect().width() - 48.0));
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
    let Some(mut dialog) = state.dialog.take() else {
        return;
    };
    let shown = Modal::new(Id::unique("dialog")).show(ctx, |ui| {
        let width: f32 = match dialog {
            Dialog::Keys => 620.0,
            Dialog::Scenes => (ctx.content_rect().width() - 64.0).min(1020.0),
            Dialog::Code(_) => code::width(ui),
            _ => 480.0,
        };
        ui.set_width(width.min(ctx.content_rect().width() - 48.0));
        contents_ui(ui, &mut dialog, state)
    });
    let leave = shown.should_close();
    match shown.inner {
        Choice::Browse => {
            files.pick(ctx, &mut dialog);
            state.dialog = Some(dialog);
        }
        Choice::Accept => accept(ctx, state, files, dialog),
        Choice::Back => {
            dialog.step_back();
            state.dialog = Some(dialog);
        }
        Choice::Stay if !leave || dialog.step_back() => state.dialog = Some(dialog),
        leaving => {
            if leaving == Choice::Discard {
                let unsaved = matches!(dialog, Dialog::Unsaved);
                state.ask(if unsaved {
                    Action::CloseUnsaved
                } else {
                    Action::DeleteLeft
                });
            }
            state.own.put(Writer::default());
            state.leaving = Leaving::No;
            ctx.request_repaint();
        }
    }
}

/// Does what a dialog asks for, once it is clear that no file is lost by it.
fn accept(ctx: &Context, state: &mut AppState, files: &mut Files, mut dialog: Dialog) {
    dialog.complete();
    let agreed = state.agreed.take();
    let targets = match &dialog {
        Dialog::File {
            task: FileTask::Open,
            ..
        } => vec![],
        Dialog::File { path, .. } => vec![PathBuf::from(path)],
        Dialog::Code(form) => code::targets(state, form),
        _ => vec![],
    };
    let lost = |path: &&PathBuf| {
        path.is_file() && !state.document.is_from(path) && agreed.as_ref() != Some(path)
    };
    let names: Vec<String> = targets
        .iter()
        .filter(lost)
        .map(|path| path.display().to_string())
        .collect();
    if names.is_empty() {
        perform(ctx, state, files, dialog);
    } else {
        state.dialog = Some(Dialog::Replace {
            names: names.join(" and "),
            then: Box::new(dialog),
        });
    }
    ctx.request_repaint();
}

fn perform(ctx: &Context, state: &mut AppState, files: &mut Files, dialog: Dialog) {
    match dialog {
        Dialog::File { task, path } => match task {
            FileTask::Open => state.ask(Action::OpenFile(PathBuf::from(path.trim()))),
            FileTask::SaveScene => state.ask(Action::SaveTo(PathBuf::from(path.trim()))),
            FileTask::Export(form) => files.export(ctx, state, form, PathBuf::from(path)),
            FileTask::SaveAnswer(_) => {
                if let Err(text) = report::save(state, Path::new(path.trim())) {
                    state.dialog = Some(Dialog::message("The analysis was not saved", text));
                }
            }
        },
        Dialog::Code(form) => code::save(state, form),
        Dialog::Replace { then, .. } => perform(ctx, state, files, *then),
        Dialog::Unsaved => {
            state.leaving = Leaving::OnceSaved;
            state.ask(Action::Save);
        }
        Dialog::Restore { .. } => state.ask(Action::Restore),
        Dialog::Message { .. } | Dialog::Scenes | Dialog::Keys | Dialog::About => {}
    }
}

fn contents_ui(ui: &mut Ui, dialog: &mut Dialog, state: &mut AppState) -> Choice {
    match dialog {
        Dialog::Message { title, text } => {
            question_ui(ui, title, text, &[("Close", Choice::Leave)])
        }
        Dialog::File { task, path } => file_ui(ui, task, path),
        Dialog::Code(form) => {
            let mut writer = state.own.take();
            let choice = code_ui(ui, form, &mut writer, &state.document);
            state.own.put(writer);
            choice
        }
        Dialog::Replace { names, .. } => {
            let text = format!("{names} exists already. What is in it will be lost.");
            question_ui(
                ui,
                "Replace the file?",
                &text,
                &[("Replace", Choice::Accept), ("Back", Choice::Back)],
            )
        }
        Dialog::Unsaved => {
            let title = format!("Save the changes to {}?", state.document.origin.name());
            let text = "They are lost if the window closes without saving.";
            let answers = [
                ("Save", Choice::Accept),
                ("Close without saving", Choice::Discard),
                ("Cancel", Choice::Leave),
            ];
            question_ui(ui, &title, text, &answers)
        }
        Dialog::Restore { name } => {
            let text = format!(
                "The last window ended without closing. Unsaved changes to {name} have been kept."
            );
            let answers = [
                ("Restore", Choice::Accept),
                ("Delete", Choice::Discard),
                ("Later", Choice::Leave),
            ];
            question_ui(ui, "Restore unsaved work?", &text, &answers)
        }
        Dialog::Scenes => scenes_ui(ui, state),
        Dialog::Keys => keys_ui(ui),
        Dialog::About => question_ui(
            ui,
            concat!("shading-lab ", env!("CARGO_PKG_VERSION")),
            "A laboratory for local illumination and polygon shading: the illumination equation, a rasterizer of its own, \
             and what both mean in numbers.",
            &[("Close", Choice::Leave)],
        ),
    }
}

fn file_ui(ui: &mut Ui, task: &mut FileTask, path: &mut String) -> Choice {
    let kind = task.file_kind();
    ui.heading(kind.title);
    if let FileTask::Export(form) = task {
        export_ui(ui, form);
    }
    ui.add_space(8.0);
    let entered = path_ui(ui, path, kind.example);
    ui.add_space(12.0);
    buttons_ui(
        ui,
        kind.verb,
        ("Cancel", Choice::Leave),
        !path.trim().is_empty(),
        entered,
    )
}

fn export_ui(ui: &mut Ui, form: &mut ExportForm) {
    ui.label(RichText::new("The scene goes with it: opening the picture brings it back.").weak());
    ui.add_space(8.0);
    let number_ui = |ui: &mut Ui, name: &str, value: &mut u32, most: u32| {
        named(
            ui.add(DragValue::new(value).range(1..=most)),
            Role::SpinButton,
            name,
        );
    };
    Grid::new("export")
        .num_columns(2)
        .spacing([16.0, 8.0])
        .show(ui, |ui| {
            ui.label("Size");
            ui.horizontal(|ui| {
                number_ui(ui, "Width", &mut form.size[0], Image::MAX_SIDE / 2);
                ui.label("×");
                number_ui(ui, "Height", &mut form.size[1], Image::MAX_SIDE / 2);
                ui.label("pixels");
            });
            ui.end_row();
            ui.label("Samples per pixel");
            number_ui(ui, "Samples per pixel", &mut form.samples, 1024);
            ui.end_row();
            ui.label("Vectors");
            ui.checkbox(&mut form.overlay, "as they are shown");
            ui.end_row();
        });
}

fn keys_ui(ui: &mut Ui) -> Choice {
    ui.heading("Keys and gestures");
    ui.add_space(8.0);
    ScrollArea::vertical()
        .max_height(440.0)
        .auto_shrink([false, true])
        .show(ui, |ui| {
            Grid::new("keys")
                .num_columns(2)
                .spacing([24.0, 6.0])
                .striped(true)
                .show(ui, |ui| {
                    for section in &*SECTIONS {
                        ui.label(RichText::new(section.title).strong());
                        ui.end_row();
                        for command in section
                            .commands
                            .iter()
                            .filter(|command| !command.does.is_empty())
                        {
                            ui.label(RichText::new(command.keys).monospace());
                            ui.label(command.does);
                            ui.end_row();
                        }
                    }
                });
        });
    ui.add_space(12.0);
    if ui.button("Close").clicked() {
        Choice::Leave
    } else {
        Choice::Stay
    }
}
