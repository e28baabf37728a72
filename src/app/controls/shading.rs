//! Where the equation is evaluated, and how values get from vertices to pixels.

use crate::app::row::parameter;
use crate::app::state::AppState;
use crate::scene::shading::{FLAT_AT, INTERPOLATION, RENORMALISE};
use crate::scene::{Choice, ShadingMode};
use eframe::egui::{RichText, Ui};

pub fn shading_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { shown, lit, .. } = state;
    let scene = &mut shown.scene;
    let mode = scene.shading.mode;
    let what = if mode == ShadingMode::Exact && !scene.object.kind.has_surface() {
        "There is no surface beyond these polygons: here Phong shading, evaluated in double precision"
    } else {
        mode.help()
    };
    ui.label(RichText::new(what).weak());
    for row in [&FLAT_AT, &INTERPOLATION, &RENORMALISE] {
        if (row.idle)(scene, 0).is_none() {
            parameter(ui, lit, scene, row);
        }
    }
}
