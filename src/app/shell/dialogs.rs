//! The dialogs of the window, and the handling of their answers.

use super::code::{self, Writer, code_ui};
use super::commands::{Command, SECTIONS};
use super::dialog::{Dialog, ExportForm, FileTask};
use super::files::Files;
use super::film::film_ui;
use super::find::{Finder, find_ui};
use super::links;
use crate::app::controls::scenes::{Gallery, scenes_ui};
use crate::app::course::prose_ui;
use crate::app::session::action::Action;
#[cfg(feature = "class")]
use crate::app::session::action::ClassAction;
use crate::app::session::window::WindowState;
use crate::app::shell::state::{AppState, Leaving};
use crate::app::system;
use crate::app::views::report;
use crate::app::widgets::dialog::{Choice, both, buttons_ui, path_ui, question_ui};
use crate::app::widgets::focus::{heading, keep_in_sight, named, take_if_free};
use crate::app::widgets::theme::text_field;
use crate::lesson::MAX_NAME;
use crate::scene::Image;
use crate::text::{has, text};
#[cfg(feature = "class")]
use eframe::egui::RichText;
use eframe::egui::accesskit::Role;
use eframe::egui::{Context, DragValue, Grid, Id, Key, Label, Modal, ProgressBar, ScrollArea, Ui};
use egui_commonmark::CommonMarkCache;
use std::path::{Path, PathBuf};

/// Shows the dialog, if any, and the progress of work on a file.
pub fn dialog_ui(ctx: &Context, state: &mut AppState, files: &mut Files) {
    let browsing = state.dialog.is_some();
    if let Some((what, fraction)) = files.progress() {
        let shown = Modal::new(Id::unique("progress")).show(ctx, |ui| {
            ui.set_width(420_f32.min(ctx.content_rect().width() - 48.0).max(0.0));
            ui.label(what);
            ui.add(ProgressBar::new(fraction).show_percentage());
            ui.add_space(6.0);
            ui.button(text!("cancel")).clicked()
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
    if let Dialog::LinkCode(code) = &dialog {
        if links::code_ui(ctx, code) {
            state.dialog = Some(dialog);
        }
        return;
    }
    let shown = Modal::new(Id::unique("dialog")).show(ctx, |ui| {
        let width: f32 = match dialog {
            Dialog::Keys | Dialog::Manual => 620.0,
            Dialog::Scenes => (ctx.content_rect().width() - 64.0).min(1020.0),
            Dialog::Code(_) => code::width(ui),
            _ => 480.0,
        };
        ui.set_width(width.min(ctx.content_rect().width() - 48.0).max(0.0));
        // In a low window a dialog scrolls.
        let most = ctx.content_rect().height() - 64.0;
        ScrollArea::vertical()
            .max_height(most)
            .min_scrolled_height(most)
            .auto_shrink([false, true])
            .show(ui, |ui| {
                let choice = contents_ui(ui, &mut dialog, state);
                keep_in_sight(ui);
                choice
            })
            .inner
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
                state.requests.ask(if unsaved {
                    Action::CloseUnsaved
                } else {
                    Action::DeleteLeft
                });
            }
            state.window.own.put(Writer::default());
            state.window.own.change(Gallery::leave);
            state.window.own.change(Finder::leave);
            state.window.own.put(SoughtKeys::default());
            state.leaving = Leaving::No;
            ctx.request_repaint();
        }
    }
}

/// Performs the request of a dialog, after asking whether to replace existing files.
fn accept(ctx: &Context, state: &mut AppState, files: &mut Files, mut dialog: Dialog) {
    dialog.complete();
    let agreed = state.agreed.take();
    let targets = match &dialog {
        _ if dialog.opens() => vec![],
        // A class goes on with the answers that are there.
        #[cfg(feature = "class")]
        Dialog::File {
            task: FileTask::Class,
            ..
        } => vec![],
        Dialog::File { path, .. } => vec![PathBuf::from(path)],
        Dialog::Code(form) => code::targets(&state.window, form),
        _ => vec![],
    };
    let lost = |path: &&PathBuf| {
        path.is_file() && !state.session.document().is_from(path) && agreed.as_ref() != Some(path)
    };
    let names = targets
        .iter()
        .filter(lost)
        .map(|path| path.display().to_string())
        .reduce(both);
    match names {
        None => perform(ctx, state, files, dialog),
        Some(names) => {
            let then = Box::new(dialog);
            state.dialog = Some(Dialog::Replace { names, then });
        }
    }
    ctx.request_repaint();
}

/// Performs the request of a dialog.
pub fn perform(ctx: &Context, state: &mut AppState, files: &mut Files, dialog: Dialog) {
    match dialog {
        Dialog::File { task, path } => match task {
            FileTask::Open if system::PAGE => _ = system::pick(true, &FileTask::Open.file_kind()),
            FileTask::Open => state
                .requests
                .ask(Action::OpenFile(PathBuf::from(path.trim()))),
            FileTask::SaveScene => state
                .requests
                .ask(Action::SaveTo(PathBuf::from(path.trim()))),
            FileTask::HandIn(name) => {
                let (document, course) = (state.session.document(), &mut state.course);
                files.hand_in(ctx, document, course, name, PathBuf::from(path));
            }
            #[cfg(feature = "class")]
            FileTask::Class => {
                let start = ClassAction::Start(PathBuf::from(path.trim()));
                state.requests.ask(Action::Class(start));
            }
            FileTask::Export(mut form) => {
                let (session, window, file) = (&state.session, &state.window, PathBuf::from(&path));
                if let Err(why) = files.export(ctx, session, window, &form, file) {
                    form.wrong = Some(why);
                    let task = FileTask::Export(form);
                    state.dialog = Some(Dialog::File { task, path });
                }
            }
            FileTask::SaveAnswer(_) => {
                if let Err(text) =
                    report::save(&mut state.session, &state.window, Path::new(path.trim()))
                {
                    state.dialog = Some(Dialog::message(text!("analysis-not-saved"), text));
                }
            }
        },
        Dialog::Code(form) => state.dialog = Some(code::save(&state.window, form)),
        Dialog::Replace { then, .. } => perform(ctx, state, files, *then),
        Dialog::Unsaved => {
            state.leaving = Leaving::OnceSaved;
            state.requests.ask(Action::Save);
        }
        Dialog::Restore { .. } => state.requests.ask(Action::Restore),
        Dialog::Page(form) => state.set_page(form),
        Dialog::Message { .. }
        | Dialog::LinkCode(_)
        | Dialog::Scenes
        | Dialog::Find
        | Dialog::Manual
        | Dialog::Keys
        | Dialog::About => {}
    }
}

fn contents_ui(ui: &mut Ui, dialog: &mut Dialog, state: &mut AppState) -> Choice {
    match dialog {
        Dialog::Message { title, text } => {
            question_ui(ui, title, text, &[(text!("close"), Choice::Leave)])
        }
        Dialog::File { task, path } => file_ui(ui, task, path, state),
        Dialog::Code(form) => {
            let mut writer = state.window.own.take();
            let choice = code_ui(
                ui,
                form,
                &mut writer,
                (state.session.document(), state.no_dialog),
            );
            state.window.own.put(writer);
            choice
        }
        Dialog::Replace { names, .. } => {
            let text = text!("replace-lost", names = names.as_str());
            question_ui(
                ui,
                text!("replace-file"),
                &text,
                &[
                    (text!("replace"), Choice::Accept),
                    (text!("back"), Choice::Back),
                ],
            )
        }
        Dialog::Unsaved => {
            let title = text!("unsaved", name = state.session.document().origin.name());
            let text = text!("unsaved-lost");
            let answers = [
                (text!("save"), Choice::Accept),
                (text!("close-unsaved"), Choice::Discard),
                (text!("cancel"), Choice::Leave),
            ];
            question_ui(ui, &title, text, &answers)
        }
        Dialog::Restore { name } => {
            let text = if system::PAGE {
                text!("restore-kept.page", name = name.as_str())
            } else {
                text!("restore-kept", name = name.as_str())
            };
            let answers = [
                (text!("restore"), Choice::Accept),
                (text!("delete"), Choice::Discard),
                (text!("later"), Choice::Leave),
            ];
            question_ui(ui, text!("restore-work"), &text, &answers)
        }
        Dialog::Page(form) => links::page_ui(ui, form, &mut state.requests),
        Dialog::LinkCode(_) => Choice::Leave,
        Dialog::Scenes => scenes_ui(ui, &mut state.window, &mut state.requests),
        Dialog::Find => find_ui(ui, &mut state.window, &mut state.requests),
        Dialog::Manual => manual_ui(ui, &mut state.window),
        Dialog::Keys => keys_ui(ui, &mut state.window),
        Dialog::About => question_ui(
            ui,
            concat!("shading-lab ", env!("CARGO_PKG_VERSION")),
            text!("about"),
            &[(text!("close"), Choice::Leave)],
        ),
    }
}

fn file_ui(ui: &mut Ui, task: &mut FileTask, path: &mut String, state: &AppState) -> Choice {
    let kind = task.file_kind();
    heading(ui, kind.title);
    if let FileTask::Export(form) = task {
        export_ui(ui, form, state.window.room);
        ui.add_space(8.0);
        film_ui(ui, &mut form.film, &state.session.document().scene, path);
        if let Some(wrong) = &form.wrong {
            ui.add_space(8.0);
            ui.colored_label(ui.visuals().error_fg_color, wrong);
        }
    }
    #[cfg(feature = "class")]
    if *task == FileTask::Class {
        ui.add(Label::new(RichText::new(text!("wall-file.sentence")).weak()).wrap());
    }
    if let FileTask::HandIn(name) = task {
        ui.weak(text!("course-hand-in.sentence"));
        ui.add_space(8.0);
        ui.horizontal(|ui| {
            ui.label(text!("course-hand-in-name"));
            let field = text_field(name)
                .char_limit(MAX_NAME)
                .desired_width(f32::INFINITY);
            let field = named(ui.add(field), Role::TextInput, text!("course-hand-in-name"));
            // The name is entered first if none is known.
            if name.is_empty() {
                take_if_free(&field);
            }
        });
    }
    ui.add_space(8.0);
    let entered = if !system::PAGE {
        path_ui(ui, path, kind.example, state.no_dialog)
    } else if ui.memory(|memory| memory.focused().is_none())
        && ui.input(|input| input.key_pressed(Key::Enter))
    {
        Choice::Accept
    } else {
        Choice::Stay
    };
    ui.add_space(12.0);
    buttons_ui(
        ui,
        kind.verb,
        (text!("cancel"), Choice::Leave),
        !path.trim().is_empty(),
        entered,
    )
}

/// Common sizes of pictures, in pixels; the first stands for the window's.
const PRESETS: [(&str, [u32; 2]); 4] = [
    ("preset-window", [0, 0]),
    ("1080p", [1920, 1080]),
    ("4K", [3840, 2160]),
    ("preset-square", [1024, 1024]),
];

fn export_ui(ui: &mut Ui, form: &mut ExportForm, window: [u32; 2]) {
    ui.weak(text!("export-scene"));
    ui.add_space(8.0);
    let number_ui = |ui: &mut Ui, name: &str, value: &mut u32, most: u32| {
        named(
            ui.add(DragValue::new(value).range(1..=most)),
            Role::SpinButton,
            name,
        )
        .changed()
    };
    let most = Image::MAX_SIDE / 2;
    ui.horizontal_wrapped(|ui| {
        for (name, size) in PRESETS {
            let size = if size == [0, 0] { window } else { size };
            let name = if has(name) { text!(name) } else { name };
            let tip = format!("{} × {}", size[0], size[1]);
            let button = ui.selectable_label(form.size == size, name);
            if button.on_hover_text(tip).clicked() {
                form.size = size;
                form.shape = form.shape.and(Some(shape(size)));
            }
        }
    });
    ui.add_space(4.0);
    Grid::new("export")
        .num_columns(2)
        .spacing([16.0, 8.0])
        .show(ui, |ui| {
            ui.label(text!("size"));
            ui.horizontal(|ui| {
                let [width, height] = &mut form.size;
                let wider = number_ui(ui, text!("width"), width, most);
                ui.label("×");
                let higher = number_ui(ui, text!("height"), height, most);
                ui.label(text!("pixels"));
                let fitting = |side: f64| (side.round() as u32).clamp(1, most);
                if let Some(shape) = form.shape {
                    if wider {
                        *height = fitting(f64::from(*width) / shape);
                    } else if higher {
                        *width = fitting(f64::from(*height) * shape);
                    }
                }
            });
            ui.end_row();
            ui.label("");
            let mut kept = form.shape.is_some();
            if ui.checkbox(&mut kept, text!("keep-shape")).changed() {
                form.shape = kept.then(|| shape(form.size));
            }
            ui.end_row();
            ui.label(text!("samples"))
                .on_hover_text(text!("samples-tip"));
            number_ui(ui, text!("samples"), &mut form.samples, 1024);
            ui.end_row();
            ui.label(text!("vectors"));
            ui.checkbox(&mut form.overlay, text!("vectors-shown"));
            ui.end_row();
        });
}

/// Returns the width over the height.
fn shape([width, height]: [u32; 2]) -> f64 {
    f64::from(width) / f64::from(height.max(1))
}

/// Shows the button below a text, which closes the dialog.
fn close_ui(ui: &mut Ui) -> Choice {
    ui.add_space(12.0);
    if ui.button(text!("close")).clicked() {
        Choice::Leave
    } else {
        Choice::Stay
    }
}

/// The manual of the window, whose lines on pictures and on the next page mean nothing here.
const MANUAL: &str = include_str!("../../../docs/window.md");

/// The formulas of the manual as laid out.
#[derive(Default)]
struct Manual(CommonMarkCache);

fn manual_ui(ui: &mut Ui, window: &mut WindowState) -> Choice {
    let lines = MANUAL.lines();
    let kept = lines.filter(|line| !line.starts_with("![") && !line.starts_with("Next:"));
    let text: Vec<_> = kept.collect();
    let height = ui.ctx().content_rect().height() - 140.0;
    ScrollArea::vertical()
        .max_height(height.max(80.0))
        .auto_shrink([false, true])
        .show(ui, |ui| {
            window
                .own
                .change(|manual: &mut Manual| _ = prose_ui(ui, &mut manual.0, &text.join("\n")));
        });
    close_ui(ui)
}

/// The text sought among the keys.
#[derive(Default)]
struct SoughtKeys(String);

fn keys_ui(ui: &mut Ui, window: &mut WindowState) -> Choice {
    let mut sought: SoughtKeys = window.own.take();
    heading(ui, text!("keys"));
    ui.add_space(8.0);
    let field = text_field(&mut sought.0)
        .hint_text(text!("keys-search"))
        .desired_width(f32::INFINITY);
    let field = named(ui.add(field), Role::SearchInput, text!("keys-search"));
    take_if_free(&field);
    ui.add_space(8.0);
    let wanted = sought.0.trim().to_lowercase();
    let is_sought = |command: &Command| {
        let does = command.does()?;
        let text = format!("{} {does}", command.keys()).to_lowercase();
        text.contains(&wanted).then_some(does)
    };
    let height = ui.ctx().content_rect().height() - 140.0;
    ScrollArea::vertical()
        .max_height(height.clamp(80.0, 440.0))
        .auto_shrink([false, true])
        .show(ui, |ui| {
            // In a narrow window, the effect of a key is below the key instead of beside it.
            let narrow = ui.available_width() < 480.0;
            Grid::new("keys")
                .num_columns(if narrow { 1 } else { 2 })
                .spacing([24.0, 6.0])
                .striped(!narrow)
                .show(ui, |ui| {
                    for section in &*SECTIONS {
                        if !section.commands.iter().any(|one| is_sought(one).is_some()) {
                            continue;
                        }
                        ui.strong(section.title());
                        ui.end_row();
                        for command in &section.commands {
                            let Some(does) = is_sought(command) else {
                                continue;
                            };
                            ui.monospace(command.keys());
                            if narrow {
                                ui.end_row();
                            }
                            ui.add(Label::new(does).wrap());
                            ui.end_row();
                        }
                    }
                });
        });
    window.own.put(sought);
    close_ui(ui)
}
