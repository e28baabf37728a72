//! The camera, and where V points.

use crate::app::action::Action;
use crate::app::row::parameters;
use crate::app::state::AppState;
use crate::scene::Projection;
use crate::scene::camera::{EYE, FOV_Y, HEIGHT, PROJECTION, ROLL, TARGET, VIEWER};
use eframe::egui::{Button, Ui};

pub fn camera_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { shown, lit, .. } = state;
    let scene = &mut shown.scene;
    parameters(ui, lit, scene, &[&VIEWER, &PROJECTION]);
    let size = if scene.camera.projection == Projection::Perspective { &FOV_Y } else { &HEIGHT };
    parameters(ui, lit, scene, &[size, &ROLL, &EYE, &TARGET]);
    if ui.add(Button::new("Reset camera")).on_hover_text("As the scene was opened (key 0)").clicked() {
        state.ask(Action::ResetCamera);
    }
}
