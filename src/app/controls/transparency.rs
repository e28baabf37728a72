//! Light through the surface.

use crate::app::row::parameters;
use crate::app::state::AppState;
use crate::scene::material::{KT, THROUGH, TRANSPARENCY_IOR};
use eframe::egui::Ui;

pub fn transparency_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { shown, lit, .. } = state;
    parameters(ui, lit, &mut shown.scene, &[&KT, &TRANSPARENCY_IOR, &THROUGH]);
}
