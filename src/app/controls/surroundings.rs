//! What is about the object: shadows, the ground, the wall behind, and what the ambient light stands for.

use crate::app::engine::Engine;
use crate::app::row::{About, parameter, parameters, row};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::scene::material::AMBIENT_SOURCE;
use crate::scene::shading::SHADOWS;
use crate::scene::surroundings::{
    BACKDROP_COLOR, BACKDROP_DISTANCE, BACKDROP_PATTERN, BACKDROP_SCALE, GROUND_COLOR, GROUND_HEIGHT, GROUND_KA,
    GROUND_KD, GROUND_VISIBLE,
};
use crate::scene::{AmbientSource, PatternKind, Rgb};
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, RichText, Ui, WidgetInfo};

pub fn surroundings_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let AppState { shown, lit, .. } = state;
    let scene = &mut shown.scene;
    parameter(ui, lit, scene, &SHADOWS);
    parameter(ui, lit, scene, &AMBIENT_SOURCE);
    if scene.ambient.source != AmbientSource::Constant {
        fit_ui(ui, lit, &mut scene.ambient.color, engine.report().ambient_fit);
    }
    parameter(ui, lit, scene, &GROUND_VISIBLE);
    if scene.ground.visible {
        parameters(ui, lit, scene, &[&GROUND_HEIGHT, &GROUND_KA, &GROUND_KD, &GROUND_COLOR]);
    }
    parameter(ui, lit, scene, &BACKDROP_PATTERN);
    if scene.backdrop.pattern != PatternKind::None {
        parameters(ui, lit, scene, &[&BACKDROP_COLOR, &BACKDROP_SCALE, &BACKDROP_DISTANCE]);
    }
}

/// The constant that stands best for the bounce that is drawn, and a way to take it.
fn fit_ui(ui: &mut Ui, lit: &mut Lit, color: &mut Rgb, fit: Option<[f64; 3]>) {
    let about = About {
        letter: "Ia",
        label: "fits best",
        name: "Best ambient light",
        tip: "The constant Ia whose ambient term differs least from the light that other surfaces really throw here: least squares over the picture. Red, green, blue.",
        symbol: Some(Symbol::Ia),
        idle: fit.is_none().then_some("Ka is 0 where light is scattered: no constant makes a difference"),
        ..About::default()
    };
    row(ui, lit, &about, false, |ui| {
        let Some(fit) = fit.map(Rgb::from_array) else { return };
        let [r, g, b] = fit.to_array().map(|channel| format!("{channel:.3}"));
        let taken = (*color - fit).abs().max_element() < 5e-4;
        let button = ui.add_enabled(!taken, Button::new("take"));
        button.widget_info(|| WidgetInfo::labeled(Role::Button, !taken, "Take the best ambient light"));
        if button.on_hover_text("Makes it the constant Ia").clicked() {
            *color = (fit * 1e3).round() / 1e3;
        }
        ui.label(RichText::new(format!("{r} {g} {b}")).monospace());
    });
}
