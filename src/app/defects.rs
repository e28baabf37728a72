//! The tab of the five defects of interpolated shading: what each is, how large it is in this scene, and a scene to try it in.

mod marks;

pub use marks::paint;

use super::action::Action;
use super::background::{ask, progress_ui};
use super::engine::Engine;
use super::look::NumbersTab;
use super::report::{ReportView, export_ui};
use super::state::AppState;
use crate::analysis::{About, Answer, DEFECTS, Defect, Defects, DefectsQuestion};
use crate::jobs::{Asked, Background};
use crate::scene::Scene;
use eframe::egui::{RichText, Ui};

/// What was last measured, and what is being measured.
#[derive(Debug, Default)]
pub struct Measured {
    found: Background<Asked<DefectsQuestion>>,
    view: ReportView,
}

impl Measured {
    /// The figures last measured.
    pub fn defects(&self) -> Option<&Defects> {
        self.found.answer().map(|found| &found.defects)
    }

    fn answer(&self) -> Option<(Box<dyn Answer>, Scene)> {
        Some((Box::new(self.found.answer()?.clone()), self.found.answered()?.subject().scene))
    }
}

/// Whether the tab is in sight.
pub fn shown(state: &AppState) -> bool {
    state.shows(NumbersTab::Defects)
}

/// The tab.
pub fn defects_ui(ui: &mut Ui, measured: &mut Measured, state: &mut AppState, engine: &Engine) {
    let size = engine.size;
    if size.contains(&0) {
        return;
    }
    let question = DefectsQuestion { pixel: Some(state.probe.pixel(size)) };
    let document = &state.shown;
    if ask(&mut measured.found, ui.ctx(), document, size, &question)
        && let Some(found) = measured.found.answer()
    {
        measured.view.set(found.report(&About { name: "", scene: &document.scene }));
    }
    ui.label("Five things that interpolation gets wrong, measured in the active picture.");
    if !progress_ui(ui, &measured.found, "Nothing is measured until the scene changes") && measured.found.stopped() {
        ui.label(RichText::new("Stopped. Measured again when the scene changes.").weak());
    }
    export_ui(ui, state, "defects", || measured.answer());
    ui.add_space(4.0);
    // What the scene is about comes first.
    let mut order: Vec<(usize, &Defect)> = DEFECTS.iter().enumerate().collect();
    order.sort_by_key(|(_, defect)| !is_open(state, defect));
    for (index, defect) in order {
        defect_ui(ui, measured, state, index, defect);
    }
}

/// Whether the built-in scene about a defect is open.
fn is_open(state: &AppState, defect: &Defect) -> bool {
    matches!(&state.document.origin, super::Origin::BuiltIn(name) if name == defect.scene)
}

fn defect_ui(ui: &mut Ui, measured: &mut Measured, state: &mut AppState, index: usize, defect: &Defect) {
    ui.separator();
    if measured.view.is_empty() {
        ui.label(RichText::new(defect.title).strong());
        ui.label("…");
    }
    measured.view.section_ui(ui, index);
    let open = is_open(state, defect);
    if open {
        ui.label(format!("Try: {}", defect.try_this));
    } else if ui.button(format!("Show “{}”", defect.title)).on_hover_text(defect.try_this).clicked() {
        state.ask(Action::OpenBuiltIn(defect.scene.to_owned()));
    }
    ui.add_space(6.0);
}
