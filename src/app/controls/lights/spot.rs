//! A spot light's cone.

use crate::app::row::{About, NumberRow, Rail, number};
use crate::app::symbol::{Lit, Symbol};
use crate::scene::Light;
use eframe::egui::Ui;

pub fn spot_ui(ui: &mut Ui, lit: &mut Lit, name: &str, light: &mut Light) {
    let (default, symbol) = (Light::default(), Some(Symbol::Light));
    let row_name = format!("{name} cone");
    let tip = "δ, the angle between the cone's axis and its edge; degrees, 0.1 to 90. Its edge in the picture can be dragged.";
    let about = About { letter: "δ", label: "cone", name: &row_name, tip, symbol, ..About::default() };
    let rail = Rail { limits: Light::CONE, decimals: 1, suffix: "°", ..Rail::linear(1.0..=90.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.cone }, &mut light.cone);

    let row_name = format!("{name} exponent");
    let tip = "e: inside the cone the intensity falls as (−L·D)^e, with the e-th power of the cosine of the angle to its axis. No unit, 0 (even) to 1000.";
    let about = About { letter: "e", label: "falls off", name: &row_name, tip, symbol, ..About::default() };
    let rail = Rail { limits: 0.0..=Light::MAX_EXPONENT, decimals: 2, ..Rail::logarithmic(0.0..=Light::MAX_EXPONENT) };
    number(ui, lit, &NumberRow { about, rail, default: default.exponent }, &mut light.exponent);

    let row_name = format!("{name} softness");
    let tip =
        "The outer part of the cone over which the light fades: 0 is a hard edge, 1 fades from the axis on. No unit.";
    let about = About { label: "Softness", name: &row_name, tip, symbol, ..About::default() };
    let rail = Rail { limits: 0.0..=1.0, ..Rail::linear(0.0..=1.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.softness }, &mut light.softness);
}
