//! The bar on top: menus, and the shading modes side by side.

use super::action::{Action, Shown};
use super::compare::VIEWS;
use super::keys;
use super::look::NumbersTab;
use super::state::AppState;
use super::theme::ThemeChoice;
use crate::scene::parameter::Options;
use crate::scene::{ShadingMode, presets};
use eframe::egui::{Align, Button, Layout, MenuBar, RichText, Ui};

/// Menus at the left, modes in the middle.
pub fn menus_ui(ui: &mut Ui, state: &mut AppState) {
    ui.add_space(3.0);
    MenuBar::new().ui(ui, |ui| {
        ui.menu_button("File", |ui| file_ui(ui, state));
        ui.menu_button("Edit", |ui| edit_ui(ui, state));
        ui.menu_button("View", |ui| view_ui(ui, state));
        ui.menu_button("Compare", |ui| compare_ui(ui, state));
        ui.menu_button("Help", |ui| {
            item(ui, state, "Keys and gestures", Action::Keys);
            item(ui, state, "About", Action::About);
        });
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

fn item(ui: &mut Ui, state: &mut AppState, text: &str, action: Action) {
    let button = Button::new(text).shortcut_text(keys::of(&action));
    if ui.add(button).clicked() {
        state.ask(action);
        ui.close();
    }
}

fn check(ui: &mut Ui, state: &mut AppState, text: &str, shown: Shown) {
    let mut on = *state.flag(shown);
    if ui.checkbox(&mut on, text).clicked() {
        state.ask(Action::Show(shown));
    }
}

fn file_ui(ui: &mut Ui, state: &mut AppState) {
    ui.set_min_width(260.0);
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
    item(ui, state, "Open…", Action::Open);
    ui.separator();
    item(ui, state, "Save scene", Action::Save);
    item(ui, state, "Save scene as…", Action::SaveAs);
    item(ui, state, "Export picture…", Action::Export);
    ui.separator();
    item(ui, state, "Quit", Action::Quit);
}

fn edit_ui(ui: &mut Ui, state: &mut AppState) {
    ui.set_min_width(240.0);
    let step = |verb: &str, what: Option<&str>| what.map_or_else(|| verb.to_owned(), |what| format!("{verb} {what}"));
    let named = |verb, change: Option<&str>| (step(verb, change), change.is_some());
    let steps = [
        (named("Undo", state.history.undoable()), Action::Undo),
        (named("Redo", state.history.redoable()), Action::Redo),
    ];
    for ((text, possible), action) in steps {
        ui.add_enabled_ui(possible, |ui| item(ui, state, &text, action));
    }
    ui.separator();
    item(ui, state, "Copy picture", Action::CopyPicture);
    item(ui, state, "Code…", Action::Code);
    item(ui, state, "Reset camera", Action::ResetCamera);
}

fn view_ui(ui: &mut Ui, state: &mut AppState) {
    ui.set_min_width(260.0);
    for (text, shown) in [
        ("Controls", Shown::Controls),
        ("Numbers", Shown::Numbers),
        ("Stages", Shown::Stages),
        ("Vectors", Shown::Vectors),
        ("Angles", Shown::Angles),
        ("Construction of R", Shown::Construction),
        ("Side view", Shown::SideView),
        ("Lobe of reflection", Shown::Lobe),
        ("H always", Shown::HalfVector),
        ("Lights' handles", Shown::Handles),
        ("Face normals", Shown::FaceNormals),
        ("Vertex normals", Shown::VertexNormals),
    ] {
        check(ui, state, text, shown);
    }
    ui.checkbox(&mut state.look.channels, "A number for each channel");
    item(ui, state, "Next tab of the numbers", Action::SwitchTab);
    ui.separator();
    item(ui, state, "Picture alone", Action::Show(Shown::PictureAlone));
    item(ui, state, "Projector size", Action::Projector);
    item(ui, state, "Larger", Action::Larger);
    item(ui, state, "Smaller", Action::Smaller);
    ui.separator();
    for (text, theme) in
        [("As the desktop", ThemeChoice::System), ("Dark", ThemeChoice::Dark), ("Light", ThemeChoice::Light)]
    {
        if ui.radio(state.look.theme == theme, text).clicked() {
            state.ask(Action::Theme(theme));
        }
    }
}

fn compare_ui(ui: &mut Ui, state: &mut AppState) {
    ui.set_min_width(240.0);
    for (view, name, tip) in VIEWS {
        let present = state.document.scene.compare.view == view;
        if ui.radio(present, name).on_hover_text(tip).clicked() {
            state.ask(Action::Compare(view));
            ui.close();
        }
    }
    ui.separator();
    item(ui, state, "Next view", Action::NextView);
    item(ui, state, "Next pane", Action::NextPane);
    ui.separator();
    item(ui, state, "Panes and figures…", Action::Tab(NumbersTab::Compare));
    item(ui, state, "The five defects…", Action::Tab(NumbersTab::Defects));
}

fn modes_ui(ui: &mut Ui, state: &mut AppState) {
    let shading = &state.document.scene.shading;
    let (mode, renormalise) = (shading.mode, shading.renormalise);
    for (index, (choice, name, what)) in ShadingMode::OPTIONS.iter().enumerate() {
        let on = mode == *choice && (mode != ShadingMode::Phong || renormalise);
        let text = format!("{} {name}", index + 1);
        if ui.add(Button::selectable(on, text)).on_hover_text(*what).clicked() {
            state.ask(Action::Shade { mode: *choice, renormalise: true });
        }
    }
    let on = mode == ShadingMode::Phong && !renormalise;
    let tip = "Phong shading without renormalising the interpolated normals";
    if ui.add(Button::selectable(on, "6 Phong, not renormalised")).on_hover_text(tip).clicked() {
        state.ask(Action::Shade { mode: ShadingMode::Phong, renormalise: false });
    }
}
