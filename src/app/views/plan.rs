//! The view of the plan: every stage and term of the frame, how often it is evaluated, what the last change ran, and what is left
//! out and why.

use super::report::{Offer, Pending, ReportView, export_ui};
use super::study::duration;
use crate::analysis::bench::BenchQuestion;
use crate::analysis::plan::FramePlan;
use crate::analysis::{Answer, ReportContext};
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::appearance::Appearance;
use crate::app::session::window::WindowState;
use crate::text::text;
use eframe::egui::{RichText, Ui};

/// Frames drawn for each measured time, and the approximate number of these times: one for everything, and one for each change.
const FRAMES: u32 = 30;
const ROUNDS: f64 = 5.0;

/// The report as last made, and the picture that it is about.
#[derive(Default)]
pub struct PlanView {
    view: ReportView,
    made: Option<(u64, Appearance)>,
    times: Pending<BenchQuestion>,
}

/// Shows the view of the plan.
pub fn plan_ui(
    ui: &mut Ui,
    own: &mut PlanView,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let frame_plan = || FramePlan {
        terms: engine.terms().to_vec(),
        runs: engine.report().stages.clone(),
        materials: engine.material_counts(),
        measured: None,
    };
    let made = own.made.as_ref();
    let same = made.is_some_and(|(revision, appearance)| {
        *revision == engine.revision && *appearance == window.appearance && own.view.is_current()
    });
    if !same {
        own.made = Some((engine.revision, window.appearance.clone()));
        let mut report = frame_plan().report(&ReportContext {
            name: "",
            scene: &session.document().scene,
        });
        let section = report.section(text!("engine-window"));
        for (what, why) in not_shown(&window.appearance) {
            section.note(text!(
                "engine-left-out",
                names = text!(what),
                reason = text!(why)
            ));
        }
        own.view.set(report);
    }
    ui.label(text!("engine-plan-intro"));
    let summary = text!(
        "engine-plan-summary",
        total = own.view.title(),
        count = left_out(engine, &window.appearance)
    );
    ui.label(RichText::new(summary).strong());
    ui.label(RichText::new(text!("engine-plan-signs")).weak());
    export_ui(ui, session, window, requests, "explain", || {
        Some((Box::new(frame_plan()), engine.drawn()?.clone()))
    });
    ui.add_space(6.0);
    own.view.ui(ui);
    ui.add_space(8.0);
    ui.separator();
    times_ui(ui, &mut own.times, session, window, requests, engine);
}

/// Shows the times of a frame and of its stages, measured on request.
fn times_ui(
    ui: &mut Ui,
    times: &mut Pending<BenchQuestion>,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    times.receive();
    ui.label(RichText::new(text!("engine-times")).strong());
    let seconds = engine.nanoseconds() as f64 * 1e-9 * f64::from(FRAMES) * ROUNDS;
    let about = text!(
        "engine-times-about",
        frames = FRAMES,
        time = duration(seconds)
    );
    let offer = Offer {
        about: &about,
        start: text!("engine-measure-times"),
        problem: None,
        stale: times.is_stale(&session.shown, |a, b| a == b),
    };
    if times.state_ui(ui, &offer) {
        let question = BenchQuestion {
            frames: FRAMES,
            growth: false,
            simd: None,
        };
        times.start(ui.ctx(), &session.shown, engine.size, question);
    }
    if times.work.answer().is_some() {
        ui.label(RichText::new(times.view.title()).weak());
        times.view.ui(ui);
        export_ui(ui, session, window, requests, "bench", || times.latest());
    }
}

/// Returns the number of parts that do not run: terms of the plan, and parts of the window that are not shown.
pub fn left_out(engine: &Engine, appearance: &Appearance) -> usize {
    engine
        .terms()
        .iter()
        .filter(|term| term.omitted.is_some())
        .count()
        + not_shown(appearance).len()
}

/// Lists closed panels and layers over the picture that are off, by the keys of their names and of the reasons.
///
/// None of them is computed.
fn not_shown(appearance: &Appearance) -> Vec<(&'static str, &'static str)> {
    let over = &appearance.overlay;
    let (closed, off) = ("engine-closed", "engine-off");
    let layer = |on: bool| {
        let why = if over.vectors {
            off
        } else {
            "engine-no-vectors"
        };
        (!on || !over.vectors).then_some(why)
    };
    [
        ("engine-controls", (!appearance.controls).then_some(closed)),
        ("engine-views", (!appearance.views).then_some(closed)),
        ("engine-stages", (!appearance.stages).then_some(closed)),
        (
            "engine-other-views",
            appearance.views.then_some("engine-not-in-sight"),
        ),
        ("engine-vectors", (!over.vectors).then_some(off)),
        ("engine-angles", layer(over.angles)),
        ("engine-construction", layer(over.construction)),
        ("engine-side-view", layer(over.side_view)),
        ("engine-lobe", layer(over.lobe)),
        ("engine-handles", (!over.handles).then_some(off)),
    ]
    .into_iter()
    .filter_map(|(what, why)| Some((what, why?)))
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_closed_or_off_is_named() {
        let mut appearance = Appearance::default();
        let names = |appearance: &Appearance| {
            not_shown(appearance)
                .iter()
                .map(|(what, _)| *what)
                .collect::<Vec<_>>()
        };
        assert!(
            names(&appearance).contains(&"engine-lobe")
                && !names(&appearance).contains(&"engine-vectors")
        );
        appearance.overlay.vectors = false;
        appearance.views = false;
        assert!(
            ["engine-vectors", "engine-angles", "engine-views"]
                .iter()
                .all(|what| names(&appearance).contains(what))
        );
    }
}
