//! The light whose controls are shown.

use super::area;
use crate::app::row::{About, flags, parameter_of};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::scene::light::{
    ATTENUATION, C1, C2, C3, COLOR, CONE, DIRECTION, EXPONENT, EXTENT, K, KIND, NAME, POSITION, RADIUS, SAMPLES, SHAPE,
    SOFTNESS, viewer_far,
};
use crate::scene::{Attenuation, Light, LightKind, Scene};
use eframe::egui::{RichText, Ui};
use glam::DVec3;

pub fn light_ui(ui: &mut Ui, state: &mut AppState) {
    let (index, AppState { shown, lit, sampling, .. }) = (state.light, state);
    let scene = &mut shown.scene;
    parameter_of(ui, lit, scene, index, &NAME);
    switches_ui(ui, lit, scene, index);
    kind_ui(ui, lit, scene, index);
    // What its kind and its shape do not use is not shown.
    for row in [&POSITION, &DIRECTION, &CONE, &EXPONENT, &SOFTNESS, &SHAPE, &EXTENT, &RADIUS, &SAMPLES] {
        if (row.idle)(scene, index).is_none() {
            parameter_of(ui, lit, scene, index, row);
        }
    }
    if scene.lights.get(index).is_some_and(|light| light.kind == LightKind::Area) {
        area::error_ui(ui, sampling, shown, index);
    }
    let scene = &mut shown.scene;
    parameter_of(ui, lit, scene, index, &COLOR);
    parameter_of(ui, lit, scene, index, &ATTENUATION);
    let constants: &[_] = match scene.lights.get(index).map(|light| light.attenuation) {
        Some(Attenuation::Viewer | Attenuation::Light) => &[&K],
        Some(Attenuation::Quadratic) => &[&C1, &C2, &C3],
        _ => &[],
    };
    for row in constants {
        parameter_of(ui, lit, scene, index, row);
    }
    if viewer_far(scene, index) {
        ui.label(RichText::new("f uses the distance to the eye, though V is constant").weak());
    }
}

/// Mute and solo in one row.
fn switches_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, index: usize) {
    let Some(light) = scene.lights.get_mut(index) else { return };
    let name = format!("Light {}", index + 1);
    let tip = "A muted light is off. While any light is soloed, only soloed lights are on.";
    let about = About { label: "Switch", name: &name, tip, symbol: Some(Symbol::Lights), ..About::default() };
    let (mute, solo) = lit.opened.lights.get(index).map_or((false, false), |light| (light.mute, light.solo));
    flags(ui, lit, &about, &mut [("mute", mute, &mut light.mute), ("solo", solo, &mut light.solo)]);
}

fn kind_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, index: usize) {
    let target = scene.camera.target;
    let before = scene.lights.get(index).is_some_and(Light::has_direction);
    parameter_of(ui, lit, scene, index, &KIND);
    let Some(light) = scene.lights.get_mut(index) else { return };
    // A light that has never been aimed is aimed at what the camera looks at.
    let default = Light::default();
    let unaimed = light.direction == default.direction && light.position != default.position;
    let aim = target - light.position;
    if !before && light.has_direction() && light.kind.has_position() && unaimed && aim != DVec3::ZERO {
        light.direction = aim;
    }
}
