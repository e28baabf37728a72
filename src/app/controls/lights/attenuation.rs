//! f: how a light weakens with distance.

use crate::app::row::{About, NumberRow, Rail, choice, number};
use crate::app::symbol::{Lit, Symbol};
use crate::scene::{Attenuation, Light, LightKind};
use eframe::egui::Ui;

pub fn attenuation_ui(ui: &mut Ui, lit: &mut Lit, name: &str, light: &mut Light, viewer_at_infinity: bool) {
    let default = Light::default();
    let tip = "f, how the light weakens. d is the distance to the light; a directional light has none.";
    let symbol = Some(Symbol::Attenuation);
    let row_name = format!("{name} attenuation");
    let idle = match (light.kind, light.attenuation) {
        (LightKind::Directional, Attenuation::Light | Attenuation::InverseSquare | Attenuation::Quadratic) => {
            Some("A directional light is infinitely far away; its distance weakens nothing")
        }
        _ => None,
    };
    let about = About { letter: "f", label: "weakens", name: &row_name, tip, symbol, idle: None, tint: None };
    let choices = [
        (Attenuation::None, "not at all", "f = 1"),
        (Attenuation::Viewer, "1/(r+k), r to the viewer", "The older textbooks' way"),
        (Attenuation::Light, "1/(r+k), r to the light", ""),
        (Attenuation::InverseSquare, "1/d²", "As light in empty space does"),
        (Attenuation::Quadratic, "1/(c1+c2·d+c3·d²)", "At most 1"),
    ];
    choice(ui, lit, &about, default.attenuation, &choices, &mut light.attenuation);
    let viewer_far = light.attenuation == Attenuation::Viewer && viewer_at_infinity;
    let idle = idle.or(viewer_far.then_some("f keeps to the distance of the eye, though V is taken as constant"));
    let constants: &mut [(&str, &str, &mut f64, f64)] = match light.attenuation {
        Attenuation::None | Attenuation::InverseSquare => &mut [],
        Attenuation::Viewer | Attenuation::Light => {
            &mut [("k", "the constant that keeps 1/(r + k) finite; world units", &mut light.k, default.k)]
        }
        Attenuation::Quadratic => &mut [
            ("c1", "the constant part; no unit", &mut light.c1, default.c1),
            ("c2", "the linear part; per world unit", &mut light.c2, default.c2),
            ("c3", "the quadratic part; per world unit squared", &mut light.c3, default.c3),
        ],
    };
    for (letter, tip, value, default) in constants {
        let row_name = format!("{name} {letter}");
        let idle = idle.filter(|_| !viewer_far);
        let about = About { letter, label: "constant", name: &row_name, tip, symbol, idle, tint: None };
        number(ui, lit, &NumberRow { about, rail: Rail::linear(0.0..=2.0), default: *default }, value);
    }
}
