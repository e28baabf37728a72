//! The scan line in slow motion: the polygon under the probe, enlarged, walked through by hand or playing.

mod formula;
mod outline;
mod tables;
mod transport;
mod view;

pub use outline::paint;
pub use view::ScanView;

use super::drawing::drawing_ui;
use super::engine::Engine;
use super::plot::plot_style;
use super::report::export_ui;
use super::row::{About, NumberRow, SliderRange, number, whole};
use super::state::AppState;
use super::theme::TEXT;
use crate::analysis::{Scan, ScanStop};
use crate::figure::PlotStyle;
use eframe::egui::{Sense, Ui};

/// Size of letters in the drawing, in that of the window's text: its smallest are as large as that.
const LETTERS: f64 = 1.05;

/// The drawing takes at most this part of the panel's height: the formula below it is to be in sight.
const TALLEST: f32 = 0.46;

/// The scan line's tab.
pub fn scan_ui(ui: &mut Ui, view: &mut ScanView, state: &mut AppState, engine: &Engine) {
    view.update(engine, state.document.model.as_ref());
    view.play(ui.ctx());
    let style = PlotStyle { text: LETTERS * f64::from(TEXT), ..plot_style(ui) };
    let width = ui.available_width();
    // In a window that is all but closed, nothing is in sight.
    let tallest = TALLEST * ui.clip_rect().height().max(0.0);
    view.lay_out([width, tallest.min(width)], style);
    match view.scan() {
        Some(Ok(scan)) => {
            if let Some(drawing) = view.drawing() {
                drawing_ui(ui, drawing, Sense::hover(), || described(scan, view.step()));
            }
            ui.add_space(4.0);
            transport::transport_ui(ui, view, state);
            ui.add_space(6.0);
            formula::formula_ui(ui, view, state);
            tables::tables_ui(ui, view);
            export_ui(ui, state, "scanline", || {
                let scan = view.ready()?.clone();
                Some((Box::new(ScanStop { step: view.step(), scan }), engine.drawn()?.clone()))
            });
        }
        Some(Err(why)) => {
            ui.label(format!("It cannot be scanned: {why}."));
        }
        None => {
            ui.label("The probe sees the background. Double-click the object, or drag the ring onto it.");
        }
    }
    ui.add_space(8.0);
    settings_ui(ui, view, state);
}

/// The drawing in words, for those who do not see it.
fn described(scan: &Scan, step: usize) -> String {
    format!("Face {}, {} corners, enlarged; {}", scan.face, scan.corners.len(), scan.caption(step))
}

fn settings_ui(ui: &mut Ui, scan: &mut ScanView, state: &mut AppState) {
    let lit = &mut state.lit;
    let usual = ScanView::default();
    let about = About { label: "speed", name: "Scan speed", tip: "Steps a second while it plays.", ..About::default() };
    let range = SliderRange { limits: ScanView::SPEEDS, decimals: 1, ..SliderRange::logarithmic(ScanView::SPEEDS) };
    number(ui, lit, &NumberRow { about, range, default: usual.speed }, &mut scan.speed);
    let about = About { label: "rows", name: "Scan rows", tip: "Rows of enlarged pixels.", ..About::default() };
    let span = f64::from(*Scan::ROWS.start())..=f64::from(*Scan::ROWS.end());
    let range = SliderRange { limits: span.clone(), decimals: 0, ..SliderRange::linear(span) };
    whole(ui, lit, &NumberRow { about, range, default: f64::from(usual.rows) }, &mut scan.rows);
}
