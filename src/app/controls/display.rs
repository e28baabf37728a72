//! From intensities to the screen.

use crate::app::engine::Engine;
use crate::app::plan::grouped;
use crate::app::row::{parameter, parameters};
use crate::app::state::AppState;
use crate::scene::camera::{BACKGROUND, ENCODING, OVERFLOW};
use eframe::egui::{RichText, Ui};

pub fn display_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let AppState { shown, lit, .. } = state;
    let scene = &mut shown.scene;
    parameter(ui, lit, scene, &OVERFLOW);
    overflow_ui(ui, engine.report().overflowing);
    parameters(ui, lit, scene, &[&ENCODING, &BACKGROUND]);
}

/// How many pixels the policy is about.
fn overflow_ui(ui: &mut Ui, pixels: u64) {
    let text = match pixels {
        0 => "No pixel is above 1".to_owned(),
        1 => "1 pixel is above 1".to_owned(),
        many => format!("{} pixels are above 1", grouped(many)),
    };
    ui.label(RichText::new(text).weak());
}
