//! The tab of the plan: every stage and term of the frame, how often it is evaluated, what the last change ran, and what is
//! left out and why.

use super::background::progress_ui;
use super::engine::Engine;
use super::look::Look;
use super::report::{Asking, ReportView, export_ui};
use super::state::AppState;
use crate::analysis::{About, Answer, BenchQuestion, FramePlan};
use eframe::egui::{Label, RichText, Ui};

/// Frames for each time that is measured.
const FRAMES: u32 = 30;

/// The report as last made, and of which picture.
#[derive(Default)]
pub struct PlanView {
    view: ReportView,
    made: Option<u64>,
    times: Asking<BenchQuestion>,
}

/// The tab.
pub fn plan_ui(ui: &mut Ui, own: &mut PlanView, state: &mut AppState, engine: &Engine) {
    let frame_plan = || FramePlan {
        terms: engine.terms().to_vec(),
        runs: engine.report().stages.clone(),
        measured: None,
    };
    if own.made != Some(engine.revision) {
        own.made = Some(engine.revision);
        let report = frame_plan().report(&About {
            name: "",
            scene: &state.document.scene,
        });
        own.view.set(report);
    }
    ui.label(format!(
        "{}, {} left out",
        own.view.title(),
        left_out(engine, &state.look)
    ));
    own.view.ui(ui);
    ui.separator();
    ui.label(RichText::new("window").strong());
    for (what, why) in not_shown(&state.look) {
        ui.add(Label::new(RichText::new(format!("left out: {what} — {why}")).weak()).wrap());
    }
    export_ui(ui, state, "explain", || {
        Some((Box::new(frame_plan()), engine.drawn()?.clone()))
    });
    ui.separator();
    times_ui(ui, &mut own.times, state, engine.size);
}

/// The times of a frame and of its stages, measured when asked for.
fn times_ui(ui: &mut Ui, times: &mut Asking<BenchQuestion>, state: &mut AppState, size: [u32; 2]) {
    times.receive();
    if !progress_ui(ui, &times.work, "Leaves the times unknown") {
        let tip =
            "Draws the active picture many times. Times are best while nothing else is touched";
        if ui.button("Measure times").on_hover_text(tip).clicked() {
            let question = BenchQuestion {
                frames: FRAMES,
                growth: false,
            };
            times.start(ui.ctx(), &state.shown, size, question);
        }
    }
    if let Some(Err(why)) = times.work.known() {
        ui.label(why);
    }
    if times.work.answer().is_some() {
        times.view.ui(ui);
        export_ui(ui, state, "bench", || times.latest());
    }
}

/// How much does not run: terms of the plan, and what of the window is not shown.
pub fn left_out(engine: &Engine, look: &Look) -> usize {
    engine
        .terms()
        .iter()
        .filter(|term| term.omitted.is_some())
        .count()
        + not_shown(look).len()
}

/// Panels that are closed and layers over the picture that are off: none of them is computed.
fn not_shown(look: &Look) -> Vec<(&'static str, &'static str)> {
    let over = &look.overlay;
    let (closed, off, bare) = ("closed", "off", "the vectors are off");
    let layer = |on: bool| (!on || !over.vectors).then_some(if over.vectors { off } else { bare });
    [
        ("controls", (!look.controls).then_some(closed)),
        ("numbers", (!look.numbers).then_some(closed)),
        ("stages", (!look.stages).then_some(closed)),
        (
            "other tabs of the numbers",
            look.numbers.then_some("not in sight"),
        ),
        ("vectors", (!over.vectors).then_some(off)),
        ("angles", layer(over.angles)),
        ("construction of R", layer(over.construction)),
        ("side view", layer(over.side_view)),
        ("lobe of reflection", layer(over.lobe)),
        ("handles", (!over.handles).then_some(off)),
    ]
    .into_iter()
    .filter_map(|(what, why)| Some((what, why?)))
    .collect()
}

/// Digits in groups of three.
pub fn grouped(value: u64) -> String {
    let digits = value.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push('\u{2009}');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_closed_or_off_is_named() {
        let mut look = Look::default();
        let names = |look: &Look| {
            not_shown(look)
                .iter()
                .map(|(what, _)| *what)
                .collect::<Vec<_>>()
        };
        assert!(names(&look).contains(&"lobe of reflection") && !names(&look).contains(&"vectors"));
        look.overlay.vectors = false;
        look.numbers = false;
        assert!(
            ["vectors", "angles", "numbers"]
                .iter()
                .all(|what| names(&look).contains(what))
        );
    }

    #[test]
    fn digits_are_grouped_from_the_right() {
        assert_eq!(
            (grouped(0), grouped(999)),
            ("0".to_owned(), "999".to_owned())
        );
        assert_eq!(grouped(1_234_567), "1\u{2009}234\u{2009}567");
    }
}
