//! What depth cueing leaves of the intensity, and what takes the place of the rest.

use super::notation::{Notation, Vectors};
use super::outline::{AT_PROBE, Line, Opening, Says, fold_ui};
use super::table::Table;
use crate::analysis::Here;
use crate::app::state::AppState;
use crate::app::typeset::Place;
use crate::scene::{CuedBy, DepthCueing};
use eframe::egui::{RichText, Ui};

/// The fading; nothing where there is no depth cueing.
pub fn fading_ui(ui: &mut Ui, state: &mut AppState, here: Here<'_>, notation: &Notation) {
    let (Some(product), Some(cue)) = (here.fading(), here.hit.cue) else { return };
    let says = Says::Words(format!("{:.1} % left at depth {:.3}", 100.0 * cue.scale, here.hit.depth));
    let line = Line::new("depth cueing", says, notation.strong());
    fold_ui(ui, "depth cueing", &line, Opening::OPEN, |ui| {
        ui.label(RichText::new(found(here, cue.scale)).weak());
        let table = Table::new("depth cueing", &product, notation, notation.plain(), &Vectors::default());
        let place = Place { id: ui.scope_id().with("fading at the probe"), name: AT_PROBE };
        Table { colour: notation.strong(), ..table }.ui(ui, state, place);
    });
}

/// Where s0 comes from, with this pixel's numbers.
fn found(here: Here<'_>, s0: f64) -> String {
    let DepthCueing { front, back, front_scale, back_scale, by, .. } = here.scene.depth_cueing;
    if here.fades_at_points() {
        return format!("Intensities fade where the equation is evaluated; the mean of their s0 is {s0:.3}.");
    }
    let own = here.scene.depth_cueing.scale_at(here.hit.depth);
    if by == CuedBy::Vertex && !here.is_exact() {
        return format!("s0 = {s0:.3}, interpolated between the vertices; by the pixel's own depth {own:.3}.");
    }
    format!("s0 is {front_scale:.2} at {front:.2} and {back_scale:.2} at {back:.2}: here {s0:.3}.")
}
