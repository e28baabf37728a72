//! The equation, filled in: every term with this pixel's numbers, adding up to the stored pixel.

mod fading;
mod figure;
mod light;
mod notation;
mod outline;
mod share;
mod stored;
mod table;
mod through;
mod working;

pub use through::to_line;

use super::palette::Term;
use super::state::AppState;
use super::symbol::Symbol;
use super::typeset::{Piece, Place};
use crate::analysis::{Here, LightTerms, ProbeHit};
use crate::scene::Scene;
use eframe::egui::{RichText, Ui, vec2};
use light::Part;
use notation::{Notation, Vectors};
use outline::{AT_PROBE, Line, Opening, Says, channels_ui, fold_ui, letters_ui, rule_ui};
use share::{bar_ui, shares};
use table::Table;

/// The whole formula at the probe.
pub fn filled_ui(ui: &mut Ui, state: &mut AppState, hit: &ProbeHit) {
    // What is pointed at is written to the state, while this is read.
    let scene = state.shown.scene.clone();
    let here = Here { scene: &scene, hit };
    let notation = Notation::new(ui.visuals(), scene.reflection.model);
    let shares = shares(here, &notation);
    let chosen = newly_chosen(ui, state.light);
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing = vec2(8.0, 2.0);
        bar_ui(ui, &shares);
        channels_ui(ui);
        ambient_ui(ui, state, here, &notation);
        for (index, light) in here.lights().enumerate() {
            let open = index == state.light;
            let opening = Opening { at_first: open, now: chosen.then_some(open) };
            Part { light, index, notation: &notation, shares: &shares }.ui(ui, state, opening);
        }
        rule_ui(ui);
        sum_ui(ui, state, here, &notation);
        stored::stored_ui(ui, &scene.display, hit, &notation);
    });
}

/// Whether another light is chosen than in the frame before. Its terms unfold then, and the others fold.
fn newly_chosen(ui: &Ui, light: usize) -> bool {
    let id = ui.scope_id().with("chosen light");
    ui.data_mut(|data| {
        let before = data.get_temp::<usize>(id);
        data.insert_temp(id, light);
        before != Some(light)
    })
}

fn ambient_ui(ui: &mut Ui, state: &mut AppState, here: Here<'_>, notation: &Notation) {
    let name = if here.hit.bounced { "one bounce" } else { "ambient" };
    let line = Line::new(name, Says::sum(here.hit.ambient), notation.strong());
    fold_ui(ui, "ambient", &line, Opening::OPEN, |ui| {
        if here.hit.bounced {
            let text = "Light that other surfaces scatter once stands in place of the constant, which would be:";
            ui.label(RichText::new(text).weak());
        }
        let product = here.ambient();
        let table = Table::new(name, &product, notation, notation.term(Term::Ambient), &Vectors::default());
        let place = Place { id: ui.scope_id().with("ambient at the probe"), name: AT_PROBE };
        let colour = if here.hit.bounced { notation.weak() } else { notation.strong() };
        Table { colour, ..table }.ui(ui, state, place);
    });
}

fn sum_ui(ui: &mut Ui, state: &mut AppState, here: Here<'_>, notation: &Notation) {
    let colour = notation.strong();
    let line = |name, value| Line { sign: "=", name, says: Says::sum(value), colour, flat: true, lettered: true };
    let letter = Piece::symbol("I", "", Symbol::Intensity, colour);
    if here.hit.transmission.is_some() {
        let reflected = Piece { low: "refl".into(), ..letter.clone() };
        letters_ui(ui, state, &line("I reflected", here.hit.reflected), &[reflected]);
        through::through_ui(ui, state, here, notation);
    }
    if here.hit.cue.is_some() {
        letters_ui(ui, state, &line("I before it fades", here.hit.intensity), std::slice::from_ref(&letter));
        fading::fading_ui(ui, state, here, notation);
        letters_ui(ui, state, &line("I with depth cueing", here.hit.sum), &[notation.sign("seen")]);
        return;
    }
    letters_ui(ui, state, &line("I", here.hit.sum), &[letter]);
}

/// How much of a light arrives, in words; nothing where it adds something and no shadows are drawn.
pub fn arriving_words(scene: &Scene, terms: &LightTerms) -> Option<String> {
    if let Some(why) = terms.why_nothing_in_short() {
        return Some(why.to_owned());
    }
    let hidden = 100.0 * (1.0 - terms.reached);
    scene.shading.shadows.then(|| if hidden > 0.0 { format!("{hidden:.1} % in shadow") } else { "in light".to_owned() })
}
