//! What is about the object: shadows, the ground, the wall behind, and what the ambient light stands for.

use super::material::PATTERNS;
use crate::app::row::{About, NumberRow, Rail, choice, colour, number, toggle};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::scene::{Ambient, AmbientSource, Backdrop, GREATEST_LENGTH, Ground, Material, Pattern, PatternKind};
use crate::scene::{Rgb, Scene, Shading};
use eframe::egui::Ui;

pub fn surroundings_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let tip = "Whether what stands between a point and a light keeps the light away; the equation itself knows nothing of it.";
    let idle = scene.lights.is_empty().then_some("There is no light");
    let about = About { label: "Shadows", tip, symbol: Some(Symbol::Shadows), idle, ..About::default() };
    toggle(ui, lit, &about, Shading::default().shadows, &mut scene.shading.shadows);
    ambient_ui(ui, lit, scene);
    ground_ui(ui, lit, scene);
    backdrop_ui(ui, lit, &mut scene.backdrop);
}

fn ambient_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let dark = (scene.material.ka == Rgb::ZERO).then_some("Ka is 0: the surface returns no ambient light");
    let about = About {
        letter: "Ia",
        label: "stands for",
        name: "Ambient source",
        tip: "What the light that comes from all sides is: the same everywhere, or what other surfaces have scattered once.",
        symbol: Some(Symbol::Bounce),
        idle: dark.or((scene.ambient.color == Rgb::ZERO).then_some("Ia is black: there is no ambient light")),
        ..About::default()
    };
    let choices = [
        (AmbientSource::Constant, "a constant", "Ia everywhere"),
        (AmbientSource::Bounce, "one bounce", "Light that other surfaces of the scene have scattered once"),
        (AmbientSource::Split, "both, halved", "The constant in the left half of the picture, one bounce in the right"),
    ];
    choice(ui, lit, &about, Ambient::default().source, &choices, &mut scene.ambient.source);
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
