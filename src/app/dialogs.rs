//! The dialogs of the window, and what becomes of their answers.

use super::action::Action;
use super::code::{self, Writer, code_ui};
use super::commands::COMMANDS;
use super::dialog::{Choice, Dialog, ExportForm, Pick, buttons, message_ui, path_field, path_ui, question_ui};
use super::files::Files;
use super::report;
use super::state::{AppState, Leaving};
use crate::scene::Image;
use eframe::egui::accesskit::Role;
use eframe::egui::{Context, DragValue, Grid, Id, Key, Modal, ProgressBar, RichText, ScrollArea, Ui, WidgetInfo};
use std::path::{Path, PathBuf};

/// Shows the dialog, if any, and how far work on a file has come.
pub fn dialog_ui(ctx: &Context, state: &mut AppState, files: &mut Files) {
    let browsing = state.dialog.is_some();
    if let Some((what, fraction)) = files.progress() {
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
            state.own.change(Writer::forget);
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
        targets(&dialog, state).iter().filter(|path| lost(path)).map(|path| path.display().to_string()).collect();
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
        Dialog::SaveAnswer { path, .. } => {
            if let Err(text) = report::save(state, Path::new(path.trim())) {
                state.dialog = Some(Dialog::message("The analysis was not saved", text));
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
        Dialog::SaveAnswer { path, format } => {
            let hint = format!("a name that ends in .{}", format.ending());
            path_ui(ui, "Save the analysis", "Save", path, &hint, Pick::SaveAnswer(*format))
        }
        Dialog::Export(form) => export_ui(ui, form),
        Dialog::Code(form) => {
            let mut writer = state.own.take();
            let choice = code_ui(ui, form, &mut writer, &state.document);
            state.own.put(writer);
            choice
        }
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
            for command in COMMANDS.iter().filter(|command| !command.keys.is_empty()) {
                if command.section != section {
                    section = command.section;
                    ui.label(RichText::new(section).strong());
                    ui.end_row();
                }
                ui.label(RichText::new(command.keys).monospace());
                ui.label(command.does);
                ui.end_row();
            }
        });
    });
    ui.add_space(12.0);
    if ui.button("Close").clicked() { Choice::Leave } else { Choice::Stay }
}

/// The files that accepting a dialog writes.
fn targets(dialog: &Dialog, state: &AppState) -> Vec<PathBuf> {
    match dialog {
        Dialog::Save { path } | Dialog::Export(ExportForm { path, .. }) | Dialog::SaveAnswer { path, .. } => {
            vec![PathBuf::from(path)]
        }
        Dialog::Code(form) => code::targets(state, form),
        _ => vec![],
    }
}
