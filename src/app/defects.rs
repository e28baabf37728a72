//! The tab of the five defects of interpolated shading: what each is, how large it is in this scene, and a scene to try it in;
//! and where they are in the picture.

use super::action::Action;
use super::background::progress_ui;
use super::engine::Engine;
use super::letter::letter;
use super::lines;
use super::look::NumbersTab;
use super::place::Place;
use super::report::{Asking, export_ui};
use super::state::AppState;
use crate::analysis::{DEFECTS, Defect, DefectsQuestion, NormalsQuestion, defect_marks};
use eframe::egui::{Align2, Color32, FontId, Painter, RichText, Stroke, Ui};

/// What the tab has measured.
#[derive(Default)]
pub struct DefectsView {
    measured: Asking<DefectsQuestion>,
    normal: Asking<NormalsQuestion>,
}

/// The tab.
pub fn defects_ui(ui: &mut Ui, view: &mut DefectsView, state: &mut AppState, engine: &Engine) {
    let DefectsView { measured, normal } = view;
    let size = engine.size;
    if size.contains(&0) {
        return;
    }
    measured.ask(
        ui.ctx(),
        &state.shown,
        size,
        &DefectsQuestion {
            pixel: Some(state.probe.pixel(size)),
        },
    );
    ui.label("Five things that interpolation gets wrong, measured in the active picture.");
    if !progress_ui(
        ui,
        &measured.work,
        "Nothing is measured until the scene changes",
    ) && measured.work.stopped()
    {
        ui.label(RichText::new("Stopped. Measured again when the scene changes.").weak());
    }
    export_ui(ui, state, "defects", || measured.latest());
    ui.add_space(4.0);
    // What the scene is about comes first.
    let mut order: Vec<(usize, &Defect)> = DEFECTS.iter().enumerate().collect();
    order.sort_by_key(|(_, defect)| !is_open(state, defect));
    for (index, defect) in order {
        ui.separator();
        if measured.view.is_empty() {
            ui.label(RichText::new(defect.title).strong());
            ui.label("…");
        }
        measured.view.section_ui(ui, index);
        if is_open(state, defect) {
            ui.label(format!("Try: {}", defect.try_this));
        } else if ui
            .button(format!("Show “{}”", defect.title))
            .on_hover_text(defect.try_this)
            .clicked()
        {
            state.ask(Action::OpenBuiltIn(defect.scene.to_owned()));
        }
        ui.add_space(6.0);
    }
    ui.separator();
    ui.collapsing("Where a vertex normal comes from", |ui| {
        normal_ui(ui, normal, state, size);
    });
}

/// The normal of the vertex that is lit up, or of the one next to the probe, with its faces and their weights.
fn normal_ui(
    ui: &mut Ui,
    normal: &mut Asking<NormalsQuestion>,
    state: &mut AppState,
    size: [u32; 2],
) {
    let question = NormalsQuestion {
        vertex: state.pointed.lit,
        pixel: Some(state.probe.pixel(size)),
    };
    normal.ask(ui.ctx(), &state.shown, size, &question);
    match normal.work.known() {
        None => _ = ui.label("…"),
        Some(Err(why)) => _ = ui.label(why),
        Some(Ok(_)) => normal.view.ui(ui),
    }
    export_ui(ui, state, "normals", || normal.latest());
}

/// Whether the built-in scene about a defect is open.
fn is_open(state: &AppState, defect: &Defect) -> bool {
    matches!(&state.document.origin, super::Origin::BuiltIn(name) if name == defect.scene)
}

/// Marks what was last measured in the active picture.
pub fn paint(painter: &Painter, state: &AppState, place: Place, font: &FontId) {
    let measured = state
        .own
        .get::<DefectsView>()
        .filter(|_| state.shows(NumbersTab::Defects));
    let Some(found) = measured.and_then(|view| view.measured.work.answer()) else {
        return;
    };
    let em = f64::from(font.size * place.pixels_per_point);
    for mark in defect_marks(&found.defects, em) {
        for stroke in [
            Stroke::new(4.0, Color32::from_black_alpha(160)),
            Stroke::new(1.8, Color32::WHITE),
        ] {
            for line in &mark.lines {
                lines::line(
                    painter,
                    line.iter().map(|point| place.exact_point(*point)),
                    stroke,
                    &[],
                );
            }
        }
        letter(
            painter,
            place.point(mark.label_at),
            Align2::CENTER_CENTER,
            &mark.label,
            font,
            Color32::WHITE,
        );
    }
}
