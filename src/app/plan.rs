//! The tab of the plan: every stage and term of the frame, how often it is evaluated, what the last change ran, and what is
//! left out and why.

use super::engine::Engine;
use super::look::Look;
use super::state::AppState;
use crate::render::{Per, Stage, Term};
use eframe::egui::{Align, Grid, Label, Layout, RichText, Ui, WidgetText, vec2};

/// Height of a table's rows, points.
const ROW: f32 = 20.0;
/// Widths of what is said of a term, points: how often, and how many times.
const WIDTHS: [f32; 2] = [48.0, 84.0];
/// Between two columns, points.
const GAP: f32 = 4.0;

/// The tab.
pub fn plan_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let terms = engine.terms();
    let report = engine.report();
    let total: u64 = terms.iter().map(|term| term.evaluations).sum();
    let omitted = left_out(engine, &state.look);
    ui.label(format!("{} evaluations a frame, {omitted} left out", grouped(total)));
    ui.label(RichText::new("■ ran after the last change   □ kept from before").weak());
    for stage in stages(terms) {
        ui.separator();
        let run = report.stages.iter().find(|run| run.stage == stage);
        let (ran, time) = match run {
            Some(run) if run.ran => (true, format!("{:.2} ms", run.nanoseconds as f64 / 1e6)),
            Some(_) => (false, "kept".to_owned()),
            None => (false, "not needed".to_owned()),
        };
        header_ui(ui, stage, ran, &time);
        let of_stage = || terms.iter().filter(move |term| term.stage == stage);
        table_ui(ui, stage, of_stage().filter(|term| term.omitted.is_none()));
        for (names, reason) in by_reason(of_stage()) {
            left_out_ui(ui, &names.join(", "), reason);
        }
    }
    window_ui(ui, &state.look);
}

/// How much does not run: terms of the plan, and what of the window is not shown.
pub fn left_out(engine: &Engine, look: &Look) -> usize {
    engine.terms().iter().filter(|term| term.omitted.is_some()).count() + not_shown(look).len()
}

/// The stages in their order.
fn stages(terms: &[Term]) -> Vec<Stage> {
    let mut stages: Vec<Stage> = terms.iter().map(|term| term.stage).collect();
    stages.dedup();
    stages
}

fn header_ui(ui: &mut Ui, stage: Stage, ran: bool, time: &str) {
    let (name, what) = words(stage);
    ui.horizontal(|ui| {
        let text = RichText::new(format!("{} {name}", if ran { "■" } else { "□" })).strong();
        ui.label(text).on_hover_text(what);
        let time = RichText::new(time).monospace();
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(if ran { time } else { time.weak() }));
    });
}

fn table_ui<'a>(ui: &mut Ui, stage: Stage, terms: impl Iterator<Item = &'a Term>) {
    let mut terms = terms.peekable();
    if terms.peek().is_none() {
        return;
    }
    let room = (ui.available_width() - WIDTHS[0] - WIDTHS[1] - 2.0 * GAP).max(100.0);
    Grid::new(("plan", stage)).num_columns(3).spacing([GAP, 0.0]).min_row_height(ROW).show(ui, |ui| {
        for term in terms {
            cell(ui, RichText::new(&term.name), Align::Min, room, term.note);
            cell(ui, RichText::new(per(term.per)).weak(), Align::Min, WIDTHS[0], None);
            cell(ui, RichText::new(grouped(term.evaluations)).monospace(), Align::Max, WIDTHS[1], None);
            ui.end_row();
        }
    });
}

fn cell(ui: &mut Ui, text: impl Into<WidgetText>, align: Align, width: f32, tip: Option<&str>) {
    ui.allocate_ui_with_layout(vec2(width, ROW), Layout::top_down(align), |ui| {
        ui.set_min_width(width);
        let response = ui.add(Label::new(text).truncate());
        if let Some(tip) = tip {
            response.on_hover_text(tip);
        }
    });
}

/// What is left out, the terms that have one reason together.
fn by_reason<'a>(terms: impl Iterator<Item = &'a Term>) -> Vec<(Vec<&'a str>, &'static str)> {
    let mut groups: Vec<(Vec<&str>, &'static str)> = Vec::new();
    for (term, reason) in terms.filter_map(|term| Some((term, term.omitted?))) {
        // Of several parts of one light only the first names it.
        let (light, part) = term.name.split_once(": ").unwrap_or(("", &term.name));
        match groups.last_mut().filter(|(names, known)| *known == reason && names[0].split(": ").next() == Some(light))
        {
            Some((names, _)) if !light.is_empty() => names.push(part),
            _ => match groups.iter_mut().find(|(_, known)| *known == reason && light.is_empty()) {
                Some((names, _)) => names.push(&term.name),
                None => groups.push((vec![&term.name], reason)),
            },
        }
    }
    groups
}

fn left_out_ui(ui: &mut Ui, what: &str, reason: &str) {
    ui.add(Label::new(RichText::new(format!("left out: {what} — {reason}")).weak()).wrap());
}

/// What of the window itself costs nothing now.
fn window_ui(ui: &mut Ui, look: &Look) {
    ui.separator();
    ui.label(RichText::new("window").strong());
    for (what, why) in not_shown(look) {
        left_out_ui(ui, what, why);
    }
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
        ("other tabs of the numbers", look.numbers.then_some("not in sight")),
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

fn per(per: Per) -> &'static str {
    match per {
        Per::Frame => "frame",
        Per::Face => "face",
        Per::Vertex => "vertex",
        Per::Pixel => "pixel",
        Per::None => "",
    }
}

/// A stage's name and what it does.
pub fn words(stage: Stage) -> (&'static str, &'static str) {
    match stage {
        Stage::Geometry => ("geometry", "Tessellation and vertex normals"),
        Stage::Transform => ("transform", "Vertices to the picture; clipping; back faces"),
        Stage::Coverage => ("coverage", "Which polygon each pixel sees"),
        Stage::Rays => ("rays", "Shadows, what is seen through the object, light from other surfaces"),
        Stage::VertexShading => ("vertices", "The equation at vertices or faces"),
        Stage::Interpolation => ("interpolation", "Normals or intensities to the pixels"),
        Stage::PixelShading => ("pixels", "The equation at pixels"),
        Stage::Display => ("display", "Intensities to stored values"),
    }
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
        let names = |look: &Look| not_shown(look).iter().map(|(what, _)| *what).collect::<Vec<_>>();
        assert!(names(&look).contains(&"lobe of reflection") && !names(&look).contains(&"vectors"));
        look.overlay.vectors = false;
        look.numbers = false;
        assert!(["vectors", "angles", "numbers"].iter().all(|what| names(&look).contains(what)));
    }

    #[test]
    fn digits_are_grouped_from_the_right() {
        assert_eq!((grouped(0), grouped(999)), ("0".to_owned(), "999".to_owned()));
        assert_eq!(grouped(1_234_567), "1\u{2009}234\u{2009}567");
    }
}
