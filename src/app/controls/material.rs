//! Ka, Kd, Ks, Od, Os and the pattern, and the model of reflection.

mod gallery;
mod highlight;
mod matching;
mod pattern;

use crate::app::palette::{Term, term_text};
use crate::app::row::{About, NumberRow, Rail, choice, coefficient, colour};
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::scene::{Backfacing, Material, Rgb, Scene};
use eframe::egui::Ui;

pub use pattern::PATTERNS;

pub fn material_ui(ui: &mut Ui, state: &mut AppState) {
    gallery::gallery_ui(ui, state);
    coefficients_ui(ui, state);
    highlight::width_ui(ui, state);
    colours_ui(ui, state);
    pattern::pattern_ui(ui, state);
    highlight::model_ui(ui, state);
    backfacing_ui(ui, state);
}

/// Why nothing that a light does can be seen.
fn dark(scene: &Scene) -> Option<&'static str> {
    (scene.lights.is_empty()).then_some("There is no light")
}

/// Why the specular term is not seen.
fn no_highlight(scene: &Scene) -> Option<&'static str> {
    dark(scene).or((scene.material.ks == Rgb::ZERO).then_some("Ks is 0: there is no highlight"))
}

/// Why the surface's own colour is not seen.
fn colourless(scene: &Scene) -> Option<&'static str> {
    (scene.material.ka == Rgb::ZERO && scene.material.kd == Rgb::ZERO)
        .then_some("Ka and Kd are 0, so the surface's own colour is not seen")
}

fn colours_ui(ui: &mut Ui, state: &mut AppState) {
    let (default, AppState { document, lit, .. }) = (Material::default(), state);
    let scene = &mut document.scene;
    let about = About {
        letter: "Od",
        label: "colour",
        name: "Od surface colour",
        tip: "Od, the surface's own colour: red, green and blue, linear. It multiplies Ka and Kd.",
        symbol: Some(Symbol::Od),
        idle: colourless(scene),
        ..About::default()
    };
    colour(ui, lit, &about, default.color, &mut scene.material.color);
    let about = About {
        letter: "Os",
        label: "highlight",
        name: "Os highlight colour",
        tip: "Os, the colour of the highlight: red, green and blue, linear. It multiplies Ks; white leaves the light its own colour, as on plastics.",
        symbol: Some(Symbol::Os),
        idle: no_highlight(scene),
        ..About::default()
    };
    colour(ui, lit, &about, default.specular_color, &mut scene.material.specular_color);
}

fn coefficients_ui(ui: &mut Ui, state: &mut AppState) {
    let channels = state.look.channels;
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let (model, default) = (scene.reflection.model, Material::default());
    let tint = |ui: &Ui, term| Some(term_text(ui.visuals(), term, model));
    let no_ambient = (scene.ambient.color == Rgb::ZERO).then_some("Ia is black: there is no ambient light");
    let no_light = dark(scene);
    let rows = [
        (
            About {
                letter: "Ka",
                tint: None,
                label: "ambient",
                name: "Ka",
                tip: "Ka, the ambient coefficient: how much of the ambient light the surface returns. No unit, usually 0 to 1.",
                symbol: Some(Symbol::Ka),
                idle: no_ambient,
            },
            default.ka.x,
            &mut scene.material.ka,
        ),
        (
            About {
                letter: "Kd",
                tint: tint(ui, Term::Diffuse),
                label: "diffuse",
                name: "Kd",
                tip: "Kd, the diffuse coefficient: how much light the surface scatters evenly to all sides, by N·L (Lambert). No unit, usually 0 to 1.",
                symbol: Some(Symbol::Kd),
                idle: no_light,
            },
            default.kd.x,
            &mut scene.material.kd,
        ),
        (
            About {
                letter: "Ks",
                tint: tint(ui, Term::Specular),
                label: "specular",
                name: "Ks",
                tip: "Ks, the specular coefficient: how much light the surface returns about the mirror direction. No unit, usually 0 to 1.",
                symbol: Some(Symbol::Ks),
                idle: no_light,
            },
            default.ks.x,
            &mut scene.material.ks,
        ),
    ];
    for (about, default, value) in rows {
        coefficient(ui, lit, &NumberRow { about, rail: Rail::linear(0.0..=1.0), default }, channels, value);
    }
}

fn backfacing_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let about = About {
        label: "If N·L < 0",
        name: "Back-facing policy",
        tip: "What a light does that stands behind the surface.",
        symbol: Some(Symbol::Normal),
        idle: dark(scene),
        ..About::default()
    };
    let choices = [
        (Backfacing::Clamp, "no light", "The light contributes nothing"),
        (Backfacing::Flip, "turn N about", "The normal is turned towards the light: a two-sided surface"),
    ];
    choice(ui, lit, &about, Backfacing::Clamp, &choices, &mut scene.reflection.backfacing);
}
