//! The bars: on top menus and the shading modes side by side; at the bottom which stages the last change ran, what they cost, and
//! what was left out.

use super::action::Action;
use super::commands::SECTIONS;
use super::compare::VIEWS;
use super::engine::Engine;
use super::look::NumbersTab;
use super::plan::{grouped, left_out};
use super::state::AppState;
use super::theme::ThemeChoice;
use crate::analysis::stage_words;
use crate::render::StageRun;
use crate::scene::{Choice, ShadingMode, presets};
use eframe::egui::{Align, Button, Label, Layout, MenuBar, RichText, Sense, Ui};

/// Menus at the left, modes in the middle.
pub fn menus_ui(ui: &mut Ui, state: &mut AppState) {
    ui.add_space(3.0);
    MenuBar::new().ui(ui, |ui| {
        for menu in ["File", "Edit", "View", "Compare", "Help"] {
            ui.menu_button(menu, |ui| {
                ui.set_min_width(260.0);
                match menu {
                    "File" => _ = ui.menu_button("Built-in scenes", |ui| scenes_ui(ui, state)),
                    "Compare" => {
                        for (view, name, tip) in VIEWS {
                            let present = state.document.scene.compare.view == view;
                            if ui.radio(present, name).on_hover_text(tip).clicked() {
                                state.ask(Action::Compare(view));
                                ui.close();
                            }
                        }
                        ui.separator();
                    }
                    _ => {}
                }
                items_ui(ui, state, menu);
                if menu == "View" {
                    ui.separator();
                    let themes = [
                        ("System", ThemeChoice::System),
                        ("Dark", ThemeChoice::Dark),
                        ("Light", ThemeChoice::Light),
                    ];
                    for (text, theme) in themes {
                        ui.radio_value(&mut state.look.theme, theme, text);
                    }
                }
            });
        }
        ui.separator();
        modes_ui(ui, state);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let name = state.document.origin.name();
            let text = if state.modified() {
                format!("{name} *")
            } else {
                name
            };
            ui.label(RichText::new(text).weak());
        });
    });
    ui.add_space(3.0);
}

/// The commands of a menu.
fn items_ui(ui: &mut Ui, state: &mut AppState, menu: &str) {
    let Some(section) = SECTIONS.iter().find(|section| section.title == menu) else {
        return;
    };
    for command in &section.commands {
        let Some(action) = command.actions.first().filter(|_| !command.name.is_empty()) else {
            if command.keys.is_empty() {
                ui.separator();
            }
            continue;
        };
        if let Action::Show(switch) = action {
            ui.checkbox(switch(&mut state.look), command.name);
            continue;
        }
        // What would be undone and redone is named.
        let change = match action {
            Action::Undo => Some(state.history.undoable()),
            Action::Redo => Some(state.history.redoable()),
            _ => None,
        };
        let idle = change == Some(None);
        let text = format!("{} {}", command.name, change.flatten().unwrap_or_default());
        let button = Button::new(text.trim_end()).shortcut_text(command.keys);
        if ui.add_enabled(!idle, button).clicked() {
            state.ask(action.clone());
            ui.close();
        }
    }
}

/// The built-in scenes, a menu for each topic.
fn scenes_ui(ui: &mut Ui, state: &mut AppState) {
    for topic in presets::topics() {
        ui.menu_button(topic, |ui| {
            for preset in presets::ALL
                .iter()
                .filter(|preset| preset.about().topic == topic)
            {
                let about = preset.about();
                if ui
                    .button(&about.title)
                    .on_hover_text(&about.sentence)
                    .clicked()
                {
                    state.ask(Action::OpenBuiltIn(preset.name.to_owned()));
                    ui.close();
                }
            }
        });
    }
}

fn modes_ui(ui: &mut Ui, state: &mut AppState) {
    let shading = &state.shown.scene.shading;
    let present = (
        shading.mode,
        shading.renormalise || shading.mode != ShadingMode::Phong,
    );
    let modes = ShadingMode::VALUES
        .iter()
        .map(|mode| (*mode, true, mode.label(), mode.help()));
    let tip = "Phong shading without renormalising the interpolated normals";
    let modes = modes.chain([(ShadingMode::Phong, false, "Phong, not renormalised", tip)]);
    for (index, (mode, renormalise, name, tip)) in modes.enumerate() {
        let button = Button::selectable(
            present == (mode, renormalise),
            format!("{} {name}", index + 1),
        );
        if ui.add(button).on_hover_text(tip).clicked() {
            state.ask(Action::Shade { mode, renormalise });
        }
    }
}

/// The bar of stages.
pub fn stages_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    ui.add_space(2.0);
    ui.horizontal(|ui| {
        let report = engine.report();
        for run in &report.stages {
            stage_ui(ui, run);
        }
        ui.separator();
        let evaluations: u64 = report.stages.iter().map(|run| run.evaluations).sum();
        let ms = engine.nanoseconds() as f64 / 1e6;
        ui.label(RichText::new(format!("{ms:.1} ms")).monospace());
        if engine.coarser() > 1 {
            let text = format!("1/{} of the size while dragged", engine.coarser());
            ui.label(text).on_hover_text(
                "All of it would not keep up with the hand; it is drawn whole when you let go",
            );
        }
        // A notice takes the room of the counts; so does a narrow window.
        let room = if state.notice.is_none() {
            ui.available_width()
        } else {
            0.0
        };
        if room > 250.0 {
            let words = if evaluations == 1 {
                "evaluation"
            } else {
                "evaluations"
            };
            ui.label(format!("{} {words}", grouped(evaluations)));
        }
        if room > 530.0 {
            ui.label(RichText::new(format!("{} triangles", grouped(report.triangles))).weak());
        }
        if report.overflowing > 0 && room.min(ui.available_width()) > 250.0 {
            ui.label(format!("{} pixels above 1", grouped(report.overflowing)));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let omitted = left_out(engine, &state.look);
            let tip = "What does not run and why: opens the plan of the frame";
            if ui
                .link(format!("left out: {omitted}"))
                .on_hover_text(tip)
                .clicked()
            {
                state.show_tab(NumbersTab::Plan);
            }
            if let Some(notice) = &state.notice {
                ui.add(Label::new(RichText::new(notice).weak()).truncate());
            }
        });
    });
    ui.add_space(2.0);
}

fn stage_ui(ui: &mut Ui, run: &StageRun) {
    let (name, what) = stage_words(run.stage);
    let (text, time) = if run.ran {
        let (ms, evaluations) = (run.nanoseconds as f64 / 1e6, grouped(run.evaluations));
        (
            RichText::new(format!("■ {name}")).strong(),
            format!("ran for {ms:.2} ms, {evaluations} evaluations"),
        )
    } else {
        (
            RichText::new(format!("□ {name}")).weak(),
            "not run: nothing that it reads has changed".to_owned(),
        )
    };
    ui.add(Label::new(text).sense(Sense::hover()))
        .on_hover_text(format!("{what}\n{time}"));
}
