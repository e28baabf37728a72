//! The bar on top: menus, and the shading modes side by side.

use super::action::{Action, Shown};
use super::commands::COMMANDS;
use super::compare::VIEWS;
use super::state::AppState;
use super::theme::ThemeChoice;
use crate::scene::{Choice, ShadingMode, presets};
use eframe::egui::{Align, Button, Layout, MenuBar, RichText, Ui};

/// Menus at the left, modes in the middle.
pub fn menus_ui(ui: &mut Ui, state: &mut AppState) {
    ui.add_space(3.0);
    MenuBar::new().ui(ui, |ui| {
        for menu in ["File", "Edit", "View", "Compare", "Help"] {
            ui.menu_button(menu, |ui| {
                ui.set_min_width(260.0);
                match menu {
                    "File" => scenes_ui(ui, state),
                    "Compare" => compare_ui(ui, state),
                    _ => {}
                }
                items_ui(ui, state, menu);
                if menu == "View" {
                    themes_ui(ui, state);
                }
            });
        }
        ui.separator();
        modes_ui(ui, state);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let name = state.document.name();
            let text = if state.modified() { format!("{name} *") } else { name };
            ui.label(RichText::new(text).weak());
        });
    });
    ui.add_space(3.0);
}

/// The commands of a menu.
fn items_ui(ui: &mut Ui, state: &mut AppState, menu: &str) {
    for command in COMMANDS.iter().filter(|command| command.section == menu) {
        let Some(action) = command.asks_for() else {
            if command.is_line() {
                ui.separator();
            }
            continue;
        };
        if command.name.is_empty() {
            continue;
        }
        if let Action::Show(shown) = action
            && *shown != Shown::PictureAlone
        {
            if ui.checkbox(&mut state.flag(*shown).clone(), command.name).clicked() {
                state.ask(action.clone());
            }
            continue;
        }
        // What would be undone and redone is named.
        let change = match action {
            Action::Undo => Some(state.history.undoable()),
            Action::Redo => Some(state.history.redoable()),
            _ => None,
        };
        let text = [command.name, change.flatten().unwrap_or_default()].join(" ");
        let button = Button::new(text.trim_end()).shortcut_text(command.keys);
        if ui.add_enabled(change != Some(None), button).clicked() {
            state.ask(action.clone());
            ui.close();
        }
    }
}

fn scenes_ui(ui: &mut Ui, state: &mut AppState) {
    ui.menu_button("Built-in scenes", |ui| {
        for topic in presets::topics() {
            ui.menu_button(topic, |ui| {
                for preset in presets::ALL.iter().filter(|preset| preset.about().topic == topic) {
                    let about = preset.about();
                    if ui.button(&about.title).on_hover_text(&about.sentence).clicked() {
                        state.ask(Action::OpenBuiltIn(preset.name.to_owned()));
                        ui.close();
                    }
                }
            });
        }
    });
}

fn themes_ui(ui: &mut Ui, state: &mut AppState) {
    ui.separator();
    for (text, theme) in [("System", ThemeChoice::System), ("Dark", ThemeChoice::Dark), ("Light", ThemeChoice::Light)] {
        if ui.radio(state.look.theme == theme, text).clicked() {
            state.ask(Action::Theme(theme));
        }
    }
}

fn compare_ui(ui: &mut Ui, state: &mut AppState) {
    for (view, name, tip) in VIEWS {
        let present = state.document.scene.compare.view == view;
        if ui.radio(present, name).on_hover_text(tip).clicked() {
            state.ask(Action::Compare(view));
            ui.close();
        }
    }
    ui.separator();
}

fn modes_ui(ui: &mut Ui, state: &mut AppState) {
    let shading = &state.shown.scene.shading;
    let (mode, renormalise) = (shading.mode, shading.renormalise);
    for (index, choice) in ShadingMode::VALUES.iter().enumerate() {
        let on = mode == *choice && (mode != ShadingMode::Phong || renormalise);
        let text = format!("{} {}", index + 1, choice.label());
        if ui.add(Button::selectable(on, text)).on_hover_text(choice.help()).clicked() {
            state.ask(Action::Shade { mode: *choice, renormalise: true });
        }
    }
    let on = mode == ShadingMode::Phong && !renormalise;
    let tip = "Phong shading without renormalising the interpolated normals";
    if ui.add(Button::selectable(on, "6 Phong, not renormalised")).on_hover_text(tip).clicked() {
        state.ask(Action::Shade { mode: ShadingMode::Phong, renormalise: false });
    }
}
