//! Ka, Kd, Ks, n and Od, and the model of reflection.

use crate::app::palette::{Term, term_text};
use crate::app::row::{About, NumberRow, Rail, choice, coefficient, colour, number};
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::scene::{Backfacing, Material, ReflectionModel, Rgb, Scene};
use eframe::egui::Ui;

/// What the slider of n spans.
const EXPONENTS: std::ops::RangeInclusive<f64> = 0.1..=1e6;

pub fn material_ui(ui: &mut Ui, state: &mut AppState) {
    coefficients_ui(ui, state);
    exponent_ui(ui, state);
    let (default, lit) = (Material::default(), &mut state.lit);
    let scene = &mut state.document.scene;
    let about = About {
        letter: "Od",
        label: "colour",
        name: "Od surface colour",
        tip: "Od, the surface's own colour: red, green and blue, linear. It multiplies Ka and Kd.",
        symbol: Some(Symbol::Od),
        idle: (scene.material.ka == Rgb::ZERO && scene.material.kd == Rgb::ZERO)
            .then_some("Ka and Kd are 0, so the surface's own colour is not seen"),
        ..About::default()
    };
    colour(ui, lit, &about, default.color, &mut scene.material.color);
    reflection_ui(ui, state);
}

/// Why nothing that a light does can be seen.
fn dark(scene: &Scene) -> Option<&'static str> {
    (scene.lights.is_empty()).then_some("There is no light")
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

fn exponent_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let idle = dark(scene).or((scene.material.ks == Rgb::ZERO).then_some("Ks is 0, so n changes nothing"));
    let row = NumberRow {
        about: About {
            letter: "n",
            tint: Some(term_text(ui.visuals(), Term::Specular, scene.reflection.model)),
            label: "exponent",
            name: "n",
            tip: "n, the specular exponent: the greater, the smaller and sharper the highlight. No unit, any number from 0; ∞ is a mirror.",
            symbol: Some(Symbol::Exponent),
            idle,
        },
        rail: Rail { limits: 0.0..=f64::INFINITY, decimals: 2, ..Rail::logarithmic(EXPONENTS) },
        default: Material::default().n,
    };
    number(ui, lit, &row, &mut scene.material.n);
}

fn reflection_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let no_specular =
        (scene.material.ks == Rgb::ZERO).then_some("Ks is 0, so the model of the highlight changes nothing");
    let about = About {
        label: "Highlight",
        name: "Reflection model",
        tip: "What the specular term measures: R against V (Phong 1975), or N against H (Blinn 1977).",
        symbol: Some(Symbol::Reflected),
        idle: dark(scene).or(no_specular),
        ..About::default()
    };
    let choices = [
        (ReflectionModel::Phong, "Phong  (R·V)ⁿ", "R is L mirrored at N"),
        (ReflectionModel::Blinn, "Blinn  (N·H)ⁿ", "H is half-way between L and V"),
    ];
    choice(ui, lit, &about, ReflectionModel::Phong, &choices, &mut scene.reflection.model);
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
