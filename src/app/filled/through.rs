//! What comes through the surface, mixed with what it reflects.

use super::light::AT_PROBE;
use super::notation::{Notation, Vectors};
use super::outline::{Line, Opening, Says, fold_ui};
use super::table::Table;
use super::terms::Here;
use crate::app::state::AppState;
use crate::app::typeset::Place;
use crate::render::Transmission;
use eframe::egui::{RichText, Ui};
use glam::DVec3;

/// The mixture; nothing where the surface is opaque.
pub fn through_ui(ui: &mut Ui, state: &mut AppState, here: Here<'_>, notation: &Notation) {
    let (Some(product), Some(through)) = (here.mixture(), here.hit.transmission) else { return };
    let colour = notation.through();
    let counted = counts(&through);
    let line = Line { sign: "", name: "transparency", says: Says::Words(counted), colour, flat: false };
    fold_ui(ui, "transparency", &line, Opening { at_first: true, now: None }, |ui| {
        ui.label(RichText::new(directions(here, &through)).weak());
        // No vector stands in these letters.
        let none = DVec3::ZERO;
        let vectors = Vectors { n: none, l: none, r: none, v: none, h: none, exponent: String::new() };
        let columns = product.columns.iter().map(|column| (notation.head(column, colour, &vectors), column)).collect();
        let place = Place { id: ui.scope_id().with("mixture at the probe"), name: AT_PROBE };
        Table { name: "transparency", columns, value: product.value, colour }.ui(ui, state, place);
    });
}

/// How often the transmitted ray is bent and mirrored.
fn counts(through: &Transmission) -> String {
    let counted = |count: u32, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let refracted = counted(through.refractions, "refraction");
    match through.total_reflections {
        0 => refracted,
        totals => format!("{refracted}, {}", counted(totals, "total reflection")),
    }
}

/// Snell's law with this pixel's angles.
fn directions(here: Here<'_>, through: &Transmission) -> String {
    let eta = here.scene.transparency.ior;
    let (normal, view) = (here.hit.normal, here.hit.view);
    let seen = view.angle_between(normal).to_degrees();
    let seen = seen.min(180.0 - seen);
    match through.t {
        Some(t) => {
            let bent = transmitted_angle(normal, t).to_degrees();
            format!("V at {seen:.2}° to N, T at {bent:.2}°: η = {eta:.3}")
        }
        None => format!("V at {seen:.2}° to N, totally reflected: η = {eta:.3}"),
    }
}

/// The angle between T and the normal's line, radians.
pub fn transmitted_angle(normal: DVec3, t: DVec3) -> f64 {
    let angle = t.angle_between(normal);
    angle.min(std::f64::consts::PI - angle)
}
