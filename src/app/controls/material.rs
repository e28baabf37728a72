//! Ka, Kd, Ks, Od, Os and the pattern, and the model of reflection.

mod gallery;
mod matching;

use crate::app::row::{View, parameter, parameter_with, parameters};
use crate::app::state::AppState;
use crate::scene::material::{
    BACKFACING, COLOR, DISTRIBUTION, EXTINCTION, IOR, KA, KD, KS, MODEL, N, PATTERN_COLOR, PATTERN_KIND, PATTERN_SCALE,
    REFLECTANCE, ROUGHNESS, SPECULAR_COLOR,
};
use crate::scene::{PatternKind, Reflectance, ReflectionModel};
use eframe::egui::Ui;

pub fn material_ui(ui: &mut Ui, state: &mut AppState) {
    gallery::gallery_ui(ui, state);
    let view = View { channels: state.look.channels, ..View::default() };
    let AppState { shown, lit, .. } = state;
    let scene = &mut shown.scene;
    for row in [&KA, &KD, &KS] {
        parameter_with(ui, lit, scene, 0, row, &view);
    }
    let facets = scene.reflection.model == ReflectionModel::CookTorrance;
    parameter(ui, lit, scene, if facets { &ROUGHNESS } else { &N });
    matching::matching_ui(ui, lit, scene);
    parameters(ui, lit, scene, &[&COLOR, &SPECULAR_COLOR, &PATTERN_KIND]);
    if scene.pattern.kind != PatternKind::None {
        parameters(ui, lit, scene, &[&PATTERN_COLOR, &PATTERN_SCALE]);
    }
    parameter(ui, lit, scene, &MODEL);
    if scene.reflection.model == ReflectionModel::CookTorrance {
        parameter(ui, lit, scene, &DISTRIBUTION);
    }
    parameter(ui, lit, scene, &REFLECTANCE);
    if scene.material.reflectance == Reflectance::Custom {
        parameters(ui, lit, scene, &[&IOR, &EXTINCTION]);
    }
    parameter(ui, lit, scene, &BACKFACING);
}
