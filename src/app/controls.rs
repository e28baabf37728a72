//! The panel of controls, in the order of the equation.

mod camera;
mod display;
mod lights;
mod material;
mod object;
mod shading;

pub use shading::MODES;

use super::equation::equation_ui;
use super::state::AppState;
use eframe::egui::{CollapsingHeader, RichText, ScrollArea, Ui};

/// The equation, and under it what its symbols stand for.
pub fn controls_ui(ui: &mut Ui, state: &mut AppState) {
    ui.add_space(6.0);
    equation_ui(ui, state);
    ui.add_space(4.0);
    ui.separator();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        section(ui, state, "Material", material::material_ui);
        section(ui, state, "Lights", lights::lights_ui);
        section(ui, state, "Shading", shading::shading_ui);
        section(ui, state, "Object", object::object_ui);
        section(ui, state, "Camera", camera::camera_ui);
        section(ui, state, "Display", display::display_ui);
        ui.add_space(12.0);
    });
}

/// A part of the panel that folds.
fn section(ui: &mut Ui, state: &mut AppState, title: &str, contents: fn(&mut Ui, &mut AppState)) {
    // A symbol that was clicked may live in a folded section.
    let open = state.lit.seek.map(|_| true);
    CollapsingHeader::new(RichText::new(title).strong()).id_salt(title).default_open(true).open(open).show_unindented(
        ui,
        |ui| {
            ui.add_space(1.0);
            contents(ui, state);
            ui.add_space(6.0);
        },
    );
}
