//! The bar at the bottom: which stages the last change ran, what they cost, and what was left out.

use super::engine::Engine;
use super::look::NumbersTab;
use super::plan::{grouped, left_out};
use super::state::AppState;
use crate::analysis::stage_words;
use crate::render::StageRun;
use eframe::egui::{Align, Label, Layout, RichText, Sense, Ui};

/// The bar of stages.
pub fn stages_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    ui.add_space(2.0);
    ui.horizontal(|ui| {
        let report = engine.report();
        for run in &report.stages {
            stage_ui(ui, run);
        }
        ui.separator();
        let evaluations: u64 = report.stages.iter().map(|run| run.evaluations).sum();
        let ms = engine.nanoseconds() as f64 / 1e6;
        ui.label(RichText::new(format!("{ms:.1} ms")).monospace());
        if engine.coarser() > 1 {
            let text = format!("1/{} of the size while dragged", engine.coarser());
            ui.label(text)
                .on_hover_text("All of it would not keep up with the hand; it is drawn whole when you let go");
        }
        // A notice takes the room of the counts; so does a narrow window.
        let room = if state.notice.is_none() { ui.available_width() } else { 0.0 };
        if room > 250.0 {
            let words = if evaluations == 1 { "evaluation" } else { "evaluations" };
            ui.label(format!("{} {words}", grouped(evaluations)));
        }
        if room > 530.0 {
            ui.label(RichText::new(format!("{} triangles", grouped(report.triangles))).weak());
        }
        if report.overflowing > 0 && room.min(ui.available_width()) > 250.0 {
            ui.label(format!("{} pixels above 1", grouped(report.overflowing)));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            omissions_ui(ui, state, engine);
            if let Some(notice) = &state.notice {
                ui.add(Label::new(RichText::new(notice).weak()).truncate());
            }
        });
    });
    ui.add_space(2.0);
}

fn stage_ui(ui: &mut Ui, run: &StageRun) {
    let (name, what) = stage_words(run.stage);
    let text = if run.ran {
        RichText::new(format!("■ {name}")).strong()
    } else {
        RichText::new(format!("□ {name}")).weak()
    };
    let time = if run.ran {
        format!("{what}\nran for {:.2} ms, {} evaluations", run.nanoseconds as f64 / 1e6, grouped(run.evaluations))
    } else {
        format!("{what}\nnot run: nothing that it reads has changed")
    };
    ui.add(Label::new(text).sense(Sense::hover())).on_hover_text(time);
}

fn omissions_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let omitted = left_out(engine, &state.look);
    let tip = "What does not run and why: opens the plan of the frame";
    if ui.link(format!("left out: {omitted}")).on_hover_text(tip).clicked() {
        state.show_tab(NumbersTab::Plan);
    }
}
