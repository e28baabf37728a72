//! The panel of controls, in the order of the equation.

mod camera;
mod depth_cueing;
mod display;
mod lights;
mod material;
mod object;
mod shading;
mod surroundings;
mod transparency;
mod triangles;

use super::engine::Engine;
use super::equation::equation_ui;
use super::state::AppState;
use super::symbol::Symbol;
use eframe::egui::{CollapsingHeader, RichText, ScrollArea, Ui};

/// The equation, and under it what its symbols stand for.
pub fn controls_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    ui.add_space(6.0);
    equation_ui(ui, state);
    ui.add_space(4.0);
    ui.separator();
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        section(ui, state, "Material", &[], material::material_ui);
        section(ui, state, "Transparency", &[Symbol::Kt, Symbol::Transmitted], transparency::transparency_ui);
        section(ui, state, "Lights", &[], lights::lights_ui);
        section(ui, state, "Surroundings", &[Symbol::Shadows, Symbol::Bounce], |ui, state| {
            surroundings::surroundings_ui(ui, state, engine);
        });
        section(ui, state, "Shading", &[], shading::shading_ui);
        section(ui, state, "Object", &[], |ui, state| object::object_ui(ui, state, engine));
        section(ui, state, "Camera", &[], camera::camera_ui);
        section(ui, state, "Display", &[], |ui, state| {
            display::display_ui(ui, state, engine);
            depth_cueing::depth_cueing_ui(ui, state);
        });
        ui.add_space(12.0);
    });
}

/// A part of the panel that folds. One that begins folded names the symbols that it holds; it opens when one of them is
/// clicked in the equation.
fn section(
    ui: &mut Ui,
    state: &mut AppState,
    title: &str,
    folded_with: &[Symbol],
    contents: impl FnOnce(&mut Ui, &mut AppState),
) {
    // A symbol that was clicked may live in a folded section.
    let sought = |symbol: &Symbol| folded_with.is_empty() || folded_with.contains(symbol);
    let open = state.lit.seek.filter(sought).map(|_| true);
    let header = CollapsingHeader::new(RichText::new(title).strong()).id_salt(title);
    header.default_open(folded_with.is_empty()).open(open).show_unindented(ui, |ui| {
        ui.add_space(1.0);
        contents(ui, state);
        ui.add_space(6.0);
    });
}
