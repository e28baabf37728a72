//! The highlight: its model, how wide it is, and how it depends on the angle of incidence.

use super::matching::matching_ui;
use super::no_highlight;
use crate::app::palette::{Term, term_text};
use crate::app::row::{About, NumberRow, Rail, choice, number, triple};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::scene::{Distribution, Material, Reflectance, Reflection, ReflectionModel, Scene};
use eframe::egui::Ui;

/// What the slider of n spans.
const EXPONENTS: std::ops::RangeInclusive<f64> = 0.1..=1e6;

/// n or m, and what makes the other models' highlights as wide.
pub fn width_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    if scene.reflection.model == ReflectionModel::CookTorrance {
        roughness_ui(ui, lit, scene);
    } else {
        exponent_ui(ui, lit, scene);
    }
    matching_ui(ui, lit, scene);
}

fn exponent_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let row = NumberRow {
        about: About {
            letter: "n",
            tint: Some(term_text(ui.visuals(), Term::Specular, scene.reflection.model)),
            label: "exponent",
            name: "n",
            tip: "n, the specular exponent: the greater, the smaller and sharper the highlight. No unit, any number from 0; ∞ is a mirror.",
            symbol: Some(Symbol::Exponent),
            idle: no_highlight(scene),
        },
        rail: Rail { limits: 0.0..=f64::INFINITY, decimals: 2, ..Rail::logarithmic(EXPONENTS) },
        default: Material::default().n,
    };
    number(ui, lit, &row, &mut scene.material.n);
}

fn roughness_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let tip = match scene.reflection.distribution {
        Distribution::Beckmann => {
            "m, the root mean square slope of the microfacets: the smaller, the smoother the surface. No unit, 0.001 to 1."
        }
        Distribution::Ggx => {
            "m, the width α of the microfacets' slopes: the smaller, the smoother the surface. No unit, 0.001 to 1."
        }
    };
    let row = NumberRow {
        about: About {
            letter: "m",
            tint: Some(term_text(ui.visuals(), Term::Specular, scene.reflection.model)),
            label: "roughness",
            name: "m roughness",
            tip,
            symbol: Some(Symbol::Facets),
            idle: no_highlight(scene),
        },
        rail: Rail { limits: Material::ROUGHNESS, ..Rail::logarithmic(Material::ROUGHNESS) },
        default: Material::default().roughness,
    };
    number(ui, lit, &row, &mut scene.material.roughness);
}

/// Which model it is, and what that asks for.
pub fn model_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let (idle, default) = (no_highlight(scene), Reflection::default());
    let about = About {
        label: "Highlight",
        name: "Reflection model",
        tip: "What the specular term measures: R against V (Phong 1975), N against H (Blinn 1977), or how many microfacets mirror the light (Cook and Torrance 1982).",
        symbol: Some(Symbol::Reflected),
        idle,
        ..About::default()
    };
    let choices = [
        (ReflectionModel::Phong, "Phong  (R·V)^n", "R is L mirrored at N"),
        (ReflectionModel::Blinn, "Blinn  (N·H)^n", "H is half-way between L and V"),
        (
            ReflectionModel::CookTorrance,
            "Cook–Torrance  D·G",
            "Microfacets: D of them mirror the light, G of those are lit and seen",
        ),
    ];
    choice(ui, lit, &about, default.model, &choices, &mut scene.reflection.model);
    if scene.reflection.model == ReflectionModel::CookTorrance {
        let about = About {
            letter: "D",
            label: "facets",
            name: "Microfacet distribution",
            tip: "D, how the microfacets' slopes are spread, and G, how they hide each other.",
            symbol: Some(Symbol::Masking),
            idle,
            ..About::default()
        };
        let choices = [
            (Distribution::Beckmann, "Beckmann", "Normally distributed slopes, between V-shaped cavities"),
            (Distribution::Ggx, "GGX", "A longer tail about the highlight (Walter et al. 2007), with Smith's G"),
        ];
        choice(ui, lit, &about, default.distribution, &choices, &mut scene.reflection.distribution);
    }
    reflectance_ui(ui, lit, scene);
}

fn reflectance_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let (idle, default, symbol) = (no_highlight(scene), Material::default(), Some(Symbol::Reflectance));
    let material = &mut scene.material;
    let about = About {
        letter: "W",
        label: "by angle",
        name: "W(θ) reflectance",
        tip: "W(θ), the part of the light that is reflected at the angle of incidence θ: 1, or Fresnel's formulas for a material. It multiplies Ks.",
        symbol,
        idle,
        ..About::default()
    };
    let choices = [
        (Reflectance::Constant, "constant", "1 at every angle, as Phong has it"),
        (Reflectance::Glass, "glass", "Crown glass N-BK7"),
        (Reflectance::Silver, "silver", "Johnson and Christy 1972"),
        (Reflectance::Gold, "gold", "Johnson and Christy 1972"),
        (Reflectance::Custom, "of η and k", "A complex index of refraction of your own"),
    ];
    choice(ui, lit, &about, default.reflectance, &choices, &mut material.reflectance);
    if material.reflectance == Reflectance::Custom {
        let tip = "η, the index of refraction for red, green and blue. No unit, 0.01 to 100.";
        let about =
            About { letter: "η", label: "index", name: "η index of refraction", tip, symbol, idle, tint: None };
        let rail = Rail { limits: Material::IOR, ..Rail::linear(0.0..=5.0) };
        triple(ui, lit, &about, &rail, default.ior, &mut material.ior);
        let tip =
            "k, the extinction coefficient for red, green and blue: 0 for what is clear, 2 to 5 for metals. No unit.";
        let about = About { letter: "k", label: "extinction", name: "k extinction", tip, symbol, idle, tint: None };
        let rail = Rail { limits: 0.0..=*Material::IOR.end(), ..Rail::linear(0.0..=5.0) };
        triple(ui, lit, &about, &rail, default.extinction, &mut material.extinction);
    }
}
