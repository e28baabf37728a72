//! The scan line in slow motion: the polygon under the probe, enlarged, walked through by hand or playing.

mod view;

pub use view::ScanView;

use super::action::{Action, Walk};
use super::drawing::{colour_of, drawing_ui, plot_style};
use super::engine::Engine;
use super::letter::lettered;
use super::lines::{line, outline};
use super::look::NumbersTab;
use super::palette::{readable, vector_text};
use super::place::Place;
use super::report::{export_ui, table_ui};
use super::row::{About, NumberRow, SliderRange, number, whole};
use super::state::AppState;
use super::symbol::Symbol;
use super::theme::TEXT;
use super::typeset::{self, Piece, run_ui};
use crate::analysis::{Carried, Mix, Scan, ScanLevel, ScanStop};
use crate::figure::palette::{ALPHA, Vector};
use crate::figure::{PlotStyle, Set};
use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    Align, Button, Color32, CornerRadius, FontId, Id, Label, Layout, Painter, RichText, Sense,
    Slider, Stroke, StrokeKind, TextStyle, Ui, Visuals, WidgetInfo, vec2,
};
use glam::DVec2;
use std::sync::Arc;

/// Size of letters in the drawing, in that of the window's text: its smallest are as large as that.
const DRAWN_LETTERS: f64 = 1.05;
/// The drawing takes at most this part of the panel's height: the formula below it is to be in sight.
const TALLEST: f32 = 0.46;
/// Height of a button, width of an arrow's button, and the space between the three groups; points.
const HEIGHT: f32 = 28.0;
const ARROW: f32 = 28.0;
const GROUPS: f32 = 8.0;
/// Size of the formula's letters, and of those of its components; side of the swatch. Points.
const FORMULA: f32 = 17.0;
const COMPONENT: f32 = 14.0;
const SWATCH: f32 = 34.0;

/// The scan line's tab.
pub fn scan_ui(ui: &mut Ui, view: &mut ScanView, state: &mut AppState, engine: &Engine) {
    view.update(engine, state.document.model.as_ref());
    view.play(ui.ctx());
    let style = PlotStyle {
        text: DRAWN_LETTERS * f64::from(TEXT),
        ..plot_style(ui)
    };
    let width = ui.available_width();
    // In a window that is all but closed, nothing is in sight.
    let tallest = TALLEST * ui.clip_rect().height().max(0.0);
    view.lay_out([width, tallest.min(width)], style);
    match view.scan() {
        Some(Ok(scan)) => {
            let (scan, step) = (Arc::clone(scan), view.step());
            if let Some(drawing) = &view.drawing {
                let words = || {
                    format!(
                        "Face {}, {} corners, enlarged; {}",
                        scan.face,
                        scan.corners.len(),
                        scan.caption(step)
                    )
                };
                drawing_ui(ui, drawing, Sense::hover(), words);
            }
            ui.add_space(4.0);
            transport_ui(ui, view, state, scan.last());
            ui.add_space(6.0);
            formula_ui(ui, &scan, view.step(), state);
            tables_ui(ui, &scan, view.step());
            export_ui(ui, state, "scanline", || {
                let answer = ScanStop {
                    step: view.step(),
                    scan: (*scan).clone(),
                };
                Some((Box::new(answer), engine.drawn()?.clone()))
            });
        }
        Some(Err(why)) => _ = ui.label(format!("It cannot be scanned: {why}.")),
        None => {
            _ = ui.label(
                "The probe sees the background. Double-click the object, or drag the ring onto it.",
            );
        }
    }
    ui.add_space(8.0);
    settings_ui(ui, view, state);
}

fn settings_ui(ui: &mut Ui, scan: &mut ScanView, state: &mut AppState) {
    let lit = &mut state.lit;
    let usual = ScanView::default();
    let about = About {
        label: "speed",
        name: "Scan speed",
        tip: "Steps a second while it plays.",
        ..About::default()
    };
    let range = SliderRange {
        limits: ScanView::SPEEDS,
        decimals: 1,
        ..SliderRange::logarithmic(ScanView::SPEEDS)
    };
    number(
        ui,
        lit,
        &NumberRow {
            about,
            range,
            default: usual.speed,
        },
        &mut scan.speed,
    );
    let about = About {
        label: "rows",
        name: "Scan rows",
        tip: "Rows of enlarged pixels.",
        ..About::default()
    };
    let span = f64::from(*Scan::ROWS.start())..=f64::from(*Scan::ROWS.end());
    let range = SliderRange {
        limits: span.clone(),
        decimals: 0,
        ..SliderRange::linear(span)
    };
    whole(
        ui,
        lit,
        &NumberRow {
            about,
            range,
            default: f64::from(usual.rows),
        },
        &mut scan.rows,
    );
}

/// The buttons under the picture: by pixel, edge and line, forwards and back; play; and a slider over all steps.
fn transport_ui(ui: &mut Ui, view: &mut ScanView, state: &mut AppState, last: usize) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        walk_ui(
            ui,
            state,
            "|◀",
            "First step",
            "To the beginning (Home)",
            ARROW,
            Walk::First,
        );
        let (text, name) = if view.is_playing() {
            ("■ Pause", "Pause")
        } else {
            ("▶ Play", "Play")
        };
        walk_ui(
            ui,
            state,
            text,
            name,
            "Plays step by step, or pauses (Space)",
            84.0,
            Walk::Play,
        );
        walk_ui(
            ui,
            state,
            "▶|",
            "Last step",
            "To the end (End)",
            ARROW,
            Walk::Last,
        );
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.label(RichText::new(format!("step {} of {last}", view.step())).weak());
        });
    });
    let mut step = view.step();
    ui.spacing_mut().slider_width = ui.available_width();
    let slider = ui.add(Slider::new(&mut step, 0..=last).show_value(false));
    let (enabled, value) = (ui.is_enabled(), step);
    slider.widget_info(|| WidgetInfo::slider(enabled, value as f64, "Scan step"));
    if slider.changed() {
        view.go_to(step);
    }
    // ◀ pixel ▶  ◀ edge ▶  ◀ line ▶
    let middle = ((ui.available_width() - 2.0 * GROUPS) / 3.0 - 2.0 * ARROW).max(0.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        let levels = [
            (ScanLevel::Pixel, "pixel", "Pixel", ", ."),
            (ScanLevel::Edge, "edge", "Edge", "[ ]"),
            (ScanLevel::Line, "line", "Line", "Page up, Page down"),
        ];
        for (index, (level, word, name, keys)) in levels.into_iter().enumerate() {
            if index > 0 {
                ui.add_space(GROUPS);
            }
            let tip = |way: &str| format!("A {word} {way} ({keys})").replace("A e", "An e");
            walk_ui(
                ui,
                state,
                "◀",
                &format!("{name} back"),
                &tip("back"),
                ARROW,
                Walk::Back(level),
            );
            ui.allocate_ui_with_layout(
                vec2(middle, HEIGHT),
                Layout::top_down(Align::Center),
                |ui| {
                    ui.set_min_size(vec2(middle, HEIGHT));
                    ui.add_space(0.5 * (HEIGHT - ui.text_style_height(&TextStyle::Body)));
                    ui.label(word);
                },
            );
            walk_ui(
                ui,
                state,
                "▶",
                &format!("{name} forward"),
                &tip("forwards"),
                ARROW,
                Walk::Forward(level),
            );
        }
    });
}

fn walk_ui(
    ui: &mut Ui,
    state: &mut AppState,
    text: &str,
    name: &str,
    tip: &str,
    width: f32,
    walk: Walk,
) {
    let response = ui.add(Button::new(text).min_size(vec2(width, HEIGHT)));
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    if response.on_hover_text(tip).clicked() {
        state.ask(Action::Scan(walk));
    }
}

/// What was found last: its colour, its name and where it lies, then its formula, filled in with its numbers.
fn formula_ui(ui: &mut Ui, scan: &Scan, step: usize, state: &mut AppState) {
    let line = scan.at(step).line;
    let Some(mix) = scan.found(step).pop() else {
        heading_ui(
            ui,
            None,
            &format!("Scan line {}", line.y),
            &format!("crosses {}", scan.active_edges(line)),
        );
        ui.add_space(6.0);
        return;
    };
    let place = match mix.pixel.map(|pixel| pixel.stored) {
        Some([r, g, b]) => format!("stored {r}, {g}, {b}"),
        None => format!("scan line {}, x = {:.2}", line.y, mix.x),
    };
    heading_ui(ui, mix.stored, &mix.name, &place);
    let plain = ui.visuals().text_color();
    if scan.carried == Carried::Constant {
        ui.label("I is the polygon's own: nothing is interpolated.");
        lettered_ui(ui, &mix.alpha_text(), plain);
    } else {
        let place = typeset::Place {
            id: Id::unique("scan formula"),
            name: "in the scan line",
        };
        run_ui(
            ui,
            state,
            &pieces(&mix, scan.carried, ui.visuals()),
            FORMULA,
            place,
        );
        lettered_ui(ui, &mix.alpha_text(), plain);
        for (index, name) in scan.carried.components().into_iter().enumerate() {
            component_ui(ui, name, &mix.row(index));
        }
    }
    for words in mix
        .pixel
        .map(|pixel| scan.intensity_words(pixel))
        .unwrap_or_default()
    {
        ui.label(words);
    }
    ui.add_space(6.0);
}

fn heading_ui(ui: &mut Ui, swatch: Option<[u8; 3]>, heading: &str, weak: &str) {
    ui.horizontal(|ui| {
        let (rect, response) = ui.allocate_exact_size(vec2(SWATCH, SWATCH), Sense::hover());
        let round = CornerRadius::same(5);
        if let Some([r, g, b]) = swatch {
            ui.painter()
                .rect_filled(rect, round, Color32::from_rgb(r, g, b));
            response.widget_info(|| {
                WidgetInfo::labeled(Role::Image, true, format!("colour {r}, {g}, {b}"))
            });
        } else {
            let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
            ui.painter()
                .rect_stroke(rect, round, stroke, StrokeKind::Inside);
        }
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 1.0;
            let (strong, faint) = (
                ui.visuals().strong_text_color(),
                ui.visuals().weak_text_color(),
            );
            lettered_ui(ui, heading, strong);
            lettered_ui(ui, weak, faint);
        });
    });
}

/// `I` with P below the line `= (1−α)·I…`
fn pieces(mix: &Mix<'_>, carried: Carried, visuals: &Visuals) -> Vec<Piece> {
    let plain = visuals.text_color();
    let (symbol, colour) = match carried {
        Carried::Normal => (Symbol::Normal, vector_text(visuals, Vector::N)),
        Carried::Constant | Carried::Intensity => (Symbol::Intensity, visuals.strong_text_color()),
    };
    let yellow = readable(colour_of(ALPHA, 1.0), visuals.panel_fill);
    let alpha = || Piece::plain("α", yellow);
    // Lowered digits as ordinary ones.
    let ordinary = |name: &str| {
        name.chars()
            .map(|letter| Set::of(letter).letter)
            .collect::<String>()
    };
    let of = |name: &str| Piece::symbol(carried.letter(), ordinary(name), symbol, colour);
    let sign = |text: &'static str| Piece::plain(text, plain);
    let [a, b] = &mix.ends;
    vec![
        of(mix.of),
        sign(" = (1 − "),
        alpha(),
        sign(") · "),
        of(a),
        sign(" + "),
        alpha(),
        sign(" · "),
        of(b),
    ]
}

fn lettered_ui(ui: &mut Ui, text: &str, colour: Color32) {
    ui.add(Label::new(lettered(text, colour)).wrap());
}

/// A component's letter and its line of numbers, which begin below each other.
fn component_ui(ui: &mut Ui, name: &str, numbers: &str) {
    let (plain, weak) = (ui.visuals().text_color(), ui.visuals().weak_text_color());
    let format = |font_id, color| TextFormat {
        font_id,
        color,
        ..TextFormat::default()
    };
    let mut job = LayoutJob::default();
    job.append(
        &format!("{name}  "),
        0.0,
        format(FontId::monospace(COMPONENT), weak),
    );
    job.append(numbers, 0.0, format(FontId::proportional(COMPONENT), plain));
    ui.add(Label::new(job).wrap());
}

/// The tables: P, Q and the pixel with their values, what barycentric interpolation gives, and the edge table.
fn tables_ui(ui: &mut Ui, scan: &Scan, step: usize) {
    let point = scan.at(step);
    if point.p.is_some() {
        table_ui(ui, "scan found", &scan.found_table(step), false);
        if point.pixel.is_some() {
            ui.label(RichText::new(scan.compared.name()).weak());
        }
        ui.add_space(8.0);
    }
    ui.label(RichText::new("Edge table").strong());
    table_ui(ui, "scan edges", &scan.edge_table(step), false);
}

/// Outlines the polygon in the picture, with the part of it that the scan line has reached, white on dark, so that it shows on
/// any picture.
pub fn paint(painter: &Painter, state: &AppState, place: Place) {
    let Some(view) = state
        .own
        .get::<ScanView>()
        .filter(|_| state.shows(NumbersTab::ScanLine))
    else {
        return;
    };
    let Some(scan) = view.ready() else { return };
    let at = |grid: DVec2| place.exact_point(scan.grid.to_picture(grid));
    let strokes = |widths: [f32; 2]| {
        [
            (widths[0], Color32::from_black_alpha(150)),
            (widths[1], Color32::WHITE),
        ]
        .map(Stroke::from)
    };
    let corners: Vec<DVec2> = scan.corners.iter().map(|corner| at(corner.place)).collect();
    for stroke in strokes([4.0, 1.75]) {
        outline(painter, &corners, stroke);
    }
    let point = scan.at(view.step());
    let Some(span) = point.span else { return };
    let ends = [span.p.x, span.q.x].map(|x| at(DVec2::new(x, point.line.at())));
    for stroke in strokes([3.0, 1.25]) {
        line(painter, ends, stroke, &[]);
    }
}
