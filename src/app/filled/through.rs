//! What comes through the surface, mixed with what it reflects.

use super::notation::{Notation, Vectors};
use super::outline::{AT_PROBE, Line, Opening, Says, fold_ui};
use super::table::Table;
use crate::analysis::Here;
use crate::app::state::AppState;
use crate::app::typeset::Place;
use crate::render::Transmission;
use crate::scene::Through;
use eframe::egui::{RichText, Ui};
use glam::DVec3;

/// The mixture; nothing where the surface is opaque.
pub fn through_ui(ui: &mut Ui, state: &mut AppState, here: Here<'_>, notation: &Notation) {
    let (Some(product), Some(through)) = (here.mixture(), here.hit.transmission) else { return };
    let colour = notation.through();
    let line = Line::new("transparency", Says::Words(counts(&through)), colour);
    fold_ui(ui, "transparency", &line, Opening::OPEN, |ui| {
        ui.label(RichText::new(directions(here, &through)).weak());
        let place = Place { id: ui.scope_id().with("mixture at the probe"), name: AT_PROBE };
        Table::new("transparency", &product, notation, colour, &Vectors::default()).ui(ui, state, place);
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

/// Snell's law with this pixel's angles: that of V to N and that of T to −N.
fn directions(here: Here<'_>, through: &Transmission) -> String {
    let transparency = &here.scene.transparency;
    let (normal, view, eta) = (here.hit.normal, here.hit.view, transparency.ior);
    let angle = to_line(normal, view).to_degrees();
    let leaves = view.dot(normal) < 0.0 && transparency.through == Through::Solid;
    match through.t.map(|t| to_line(normal, t).to_degrees()) {
        Some(bent) if leaves => format!("Snell: {eta:.3} · sin {angle:.2}° = sin {bent:.2}°, of T"),
        Some(bent) => format!("Snell: sin {angle:.2}° = {eta:.3} · sin {bent:.2}°, of T"),
        None => format!("V at {angle:.2}° to N, η = {eta:.3}: total reflection, no T"),
    }
}

/// The angle between a vector and the normal's line, radians: 0 to a right angle.
pub fn to_line(normal: DVec3, vector: DVec3) -> f64 {
    let angle = vector.angle_between(normal);
    angle.min(std::f64::consts::PI - angle)
}
