//! What is about the object: shadows, the ground, the wall behind, and what the ambient light stands for.

use super::material::PATTERNS;
use crate::app::engine::Engine;
use crate::app::row::{About, NumberRow, Rail, choice, colour, number, row, toggle};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::scene::{Ambient, AmbientSource, Backdrop, GREATEST_LENGTH, Ground, Material, Pattern, PatternKind};
use crate::scene::{Rgb, Scene, Shading};
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, RichText, Ui, WidgetInfo};

pub fn surroundings_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let tip = "Whether what stands between a point and a light keeps the light away; the equation itself knows nothing of it.";
    let idle = scene.lights.is_empty().then_some("There is no light");
    let about = About { label: "Shadows", tip, symbol: Some(Symbol::Shadows), idle, ..About::default() };
    toggle(ui, lit, &about, Shading::default().shadows, &mut scene.shading.shadows);
    ambient_ui(ui, lit, scene);
    if scene.ambient.source != AmbientSource::Constant {
        fit_ui(ui, lit, &mut scene.ambient.color, engine.report().ambient_fit);
    }
    ground_ui(ui, lit, scene);
    backdrop_ui(ui, lit, &mut scene.backdrop);
}

fn ambient_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let constant = scene.ambient.source == AmbientSource::Constant;
    let dark = (scene.lights.is_empty()).then_some("There is no light that could be scattered");
    let about = About {
        letter: "Ia",
        label: "stands for",
        name: "Ambient source",
        tip: "What the light that comes from all sides is: the same everywhere, or what other surfaces have scattered once.",
        symbol: Some(Symbol::Bounce),
        idle: dark.filter(|_| constant),
        ..About::default()
    };
    let choices = [
        (AmbientSource::Constant, "a constant", "Ia everywhere"),
        (AmbientSource::Bounce, "one bounce", "Light that other surfaces of the scene have scattered once"),
        (AmbientSource::Split, "both, halved", "The constant in the left half of the picture, one bounce in the right"),
    ];
    choice(ui, lit, &about, Ambient::default().source, &choices, &mut scene.ambient.source);
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

fn ground_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let default = Ground::default();
    let no_ambient = (scene.ambient.color == Rgb::ZERO).then_some("Ia is black: there is no ambient light");
    let no_light = scene.lights.is_empty().then_some("There is no light");
    let ground = &mut scene.ground;
    let tip = "A level floor, which receives light and shadows and hides nothing.";
    let about = About { label: "Ground", tip, ..About::default() };
    toggle(ui, lit, &about, default.visible, &mut ground.visible);
    if !ground.visible {
        return;
    }
    let tip = "The floor's y coordinate; world units.";
    let about = About { letter: "y", label: "height", name: "Ground height", tip, ..About::default() };
    let rail = Rail { limits: -GREATEST_LENGTH..=GREATEST_LENGTH, ..Rail::linear(-3.0..=3.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.height }, &mut ground.height);
    let rows = [
        (
            "Ka",
            "ambient",
            "Ground Ka",
            "Ka of the floor. No unit, usually 0 to 1.",
            no_ambient,
            default.ka,
            &mut ground.ka,
        ),
        (
            "Kd",
            "diffuse",
            "Ground Kd",
            "Kd of the floor. No unit, usually 0 to 1.",
            no_light,
            default.kd,
            &mut ground.kd,
        ),
    ];
    for (letter, label, name, tip, idle, default, value) in rows {
        let about = About { letter, label, name, tip, idle, ..About::default() };
        let rail = Rail { limits: 0.0..=Material::MAX_COEFFICIENT, ..Rail::linear(0.0..=1.0) };
        number(ui, lit, &NumberRow { about, rail, default }, value);
    }
    let tip = "Od of the floor: red, green and blue, linear.";
    let about = About { letter: "Od", label: "colour", name: "Ground colour", tip, ..About::default() };
    colour(ui, lit, &about, default.color, &mut ground.color);
}

fn backdrop_ui(ui: &mut Ui, lit: &mut Lit, backdrop: &mut Backdrop) {
    let default = Backdrop::default();
    let tip = "A wall behind the object, upright to the viewing direction; between its pattern the background is seen.";
    let about = About { label: "Backdrop", tip, ..About::default() };
    choice(ui, lit, &about, default.pattern, &PATTERNS, &mut backdrop.pattern);
    if backdrop.pattern == PatternKind::None {
        return;
    }
    let tip = "The pattern's colour: red, green and blue, linear, whatever the light.";
    let about = About { label: "Colour", name: "Backdrop colour", tip, ..About::default() };
    colour(ui, lit, &about, default.color, &mut backdrop.color);
    let tip = "The width of one field; world units.";
    let about = About { label: "Field width", name: "Backdrop scale", tip, ..About::default() };
    let rail = Rail { limits: Pattern::SCALE, ..Rail::logarithmic(0.01..=4.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.scale }, &mut backdrop.scale);
    let tip = "How far the wall stands behind the camera's target; world units.";
    let about = About { label: "Distance", name: "Backdrop distance", tip, ..About::default() };
    let rail = Rail { limits: -GREATEST_LENGTH..=GREATEST_LENGTH, ..Rail::linear(0.0..=10.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.distance }, &mut backdrop.distance);
}
