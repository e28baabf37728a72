//! The scan line in slow motion: the polygon under the probe, enlarged, scanned step by step by hand or played.

mod view;

pub use view::ScanView;

use super::report::{export_ui, table_ui};
use crate::analysis::scan::{Carried, Mix, Scan, ScanLevel, ScanStop};
use crate::app::controls::row::{About, NumberRow, SliderRange, number, whole};
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests, Walk};
use crate::app::session::appearance::ViewName;
use crate::app::session::place::Place;
use crate::app::session::window::WindowState;
use crate::app::widgets::drawing::{colour_of, drawing_ui, plot_style};
use crate::app::widgets::fingers::{Held, hold};
use crate::app::widgets::heading::heading_ui;
use crate::app::widgets::letter::lettered;
use crate::app::widgets::lines::{cased, line, outline};
use crate::app::widgets::palette::{readable, vector_text};
use crate::app::widgets::symbol::Symbol;
use crate::app::widgets::theme::TEXT;
use crate::app::widgets::typeset::{self, Piece, run_ui};
use crate::figure::palette::{ALPHA, Vector};
use crate::figure::{PlotStyle, Set};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    Align, Button, Color32, FontId, Id, Label, Layout, Painter, RichText, Sense, Slider, Ui,
    Visuals, WidgetInfo, vec2,
};
use glam::DVec2;
use std::sync::Arc;

/// Font size in the drawing, relative to the window's: the drawing's smallest letters are as large as the window's text.
const DRAWN_LETTERS: f64 = 1.05;
/// Maximum height of the drawing, as a share of the panel's height, which keeps the formula below it visible.
const TALLEST: f32 = 0.46;
/// Height of a button, width of an arrow's button, space between parts, and space between two buttons, in points.
const HEIGHT: f32 = 28.0;
const ARROW: f32 = 28.0;
const GROUPS: f32 = 8.0;
const GAP: f32 = 3.0;
/// Font sizes of the formula and of its components, in points.
const FORMULA: f32 = 17.0;
const COMPONENT: f32 = 14.0;
/// Width from which the drawing is beside the rest, in points; its share of the width there; its minimum height, in points.
const WIDE: f32 = 620.0;
const DRAWN: f32 = 0.42;
const LEAST_DRAWING: f32 = 160.0;
/// Maximum widths of the controls and of the tables, and minimum width of a formula, in points.
const TRANSPORT: f32 = 480.0;
const TABLES: f32 = 340.0;
const CARD: f32 = 270.0;

/// Shows the view of the scan line.
pub fn scan_ui(
    ui: &mut Ui,
    view: &mut ScanView,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    view.update(engine, session.document().model.as_ref());
    view.play(ui.ctx());
    match view.scan() {
        Some(Ok(scan)) => {
            let scan = Arc::clone(scan);
            if ui.available_width() >= WIDE {
                wide_ui(ui, view, requests, &scan);
            } else {
                // In a window that is almost closed, nothing is visible.
                let tallest = TALLEST * ui.clip_rect().height().max(0.0);
                drawing_of(ui, view, &scan, tallest);
                ui.add_space(4.0);
                transport_ui(ui, view, requests, scan.last());
                ui.add_space(6.0);
                let found = scan.found(view.step());
                formula_ui(ui, &scan, view.step(), found.last());
                tables_ui(ui, &scan, view.step());
            }
            export_ui(ui, session, window, requests, "scanline", || {
                let answer = ScanStop {
                    step: view.step(),
                    scan: (*scan).clone(),
                };
                Some((Box::new(answer), engine.drawn()?.clone()))
            });
        }
        Some(Err(why)) => _ = ui.label(text!("line-scan-refused", why = why.as_str())),
        None => _ = ui.label(text!("line-scan-background")),
    }
    ui.add_space(8.0);
    settings_ui(ui, view);
}

/// Shows the drawing at the left; the controls, P, Q and the pixel side by side, and the tables at the right.
fn wide_ui(ui: &mut Ui, view: &mut ScanView, requests: &mut Requests, scan: &Scan) {
    let width = ui.available_width();
    let tallest = (ui.clip_rect().height() - 2.0 * GROUPS).max(LEAST_DRAWING);
    let drawn = (DRAWN * width).min(1.25 * tallest);
    ui.horizontal_top(|ui| {
        ui.allocate_ui_with_layout(vec2(drawn, tallest), Layout::top_down(Align::Min), |ui| {
            ui.set_width(drawn);
            drawing_of(ui, view, scan, tallest);
        });
        ui.add_space(2.0 * GROUPS);
        ui.vertical(|ui| {
            ui.allocate_ui_with_layout(
                vec2(ui.available_width().min(TRANSPORT), 0.0),
                Layout::top_down(Align::Min),
                |ui| transport_ui(ui, view, requests, scan.last()),
            );
            ui.add_space(6.0);
            let (step, found) = (view.step(), scan.found(view.step()));
            if found.is_empty() {
                formula_ui(ui, scan, step, None);
            } else {
                let count = ((ui.available_width() / CARD) as usize).clamp(1, found.len());
                ui.columns(count, |columns| {
                    let last = found.iter().skip(found.len() - count);
                    for (ui, mix) in columns.iter_mut().zip(last) {
                        ui.with_layout(Layout::top_down(Align::Min), |ui| {
                            formula_ui(ui, scan, step, Some(mix));
                        });
                    }
                });
            }
            // The last column of numbers takes the remaining width.
            ui.set_max_width(ui.available_width().min(TABLES));
            tables_ui(ui, scan, step);
        });
    });
}

/// Shows the enlarged polygon in the available width.
fn drawing_of(ui: &mut Ui, view: &mut ScanView, scan: &Scan, tallest: f32) {
    let style = PlotStyle {
        text: DRAWN_LETTERS * f64::from(TEXT),
        ..plot_style(ui)
    };
    let width = ui.available_width();
    view.lay_out([width, tallest.min(width)], style);
    let step = view.step();
    if let Some(drawing) = &view.drawing {
        let words = || {
            text!(
                "line-scan-drawing",
                face = scan.face,
                corners = scan.corners.len(),
                caption = scan.caption(step)
            )
        };
        drawing_ui(ui, drawing, Sense::hover(), words);
    }
}

fn settings_ui(ui: &mut Ui, scan: &mut ScanView) {
    let usual = ScanView::default();
    let about = About {
        label: text!("line-scan-speed"),
        name: text!("line-scan-speed.name"),
        tip: text!("line-scan-speed.tip"),
        ..About::default()
    };
    let range = SliderRange {
        limits: ScanView::SPEEDS,
        decimals: 1,
        ..SliderRange::logarithmic(ScanView::SPEEDS)
    };
    let row = NumberRow {
        about,
        range,
        default: usual.speed,
    };
    number(ui, &row, &mut scan.speed);
    let about = About {
        label: text!("line-scan-rows"),
        name: text!("line-scan-rows.name"),
        tip: text!("line-scan-rows.tip"),
        ..About::default()
    };
    let span = f64::from(*Scan::ROWS.start())..=f64::from(*Scan::ROWS.end());
    let range = SliderRange {
        limits: span.clone(),
        decimals: 0,
        ..SliderRange::linear(span)
    };
    let row = NumberRow {
        about,
        range,
        default: f64::from(usual.rows),
    };
    whole(ui, &row, &mut scan.rows);
}

/// Shows the buttons under the picture: by pixel, edge and line, forwards and back; play; and a slider over all steps.
fn transport_ui(ui: &mut Ui, view: &mut ScanView, requests: &mut Requests, last: usize) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        walk_ui(
            ui,
            requests,
            "|◀",
            text!("line-scan-first"),
            text!("line-scan-first.tip"),
            ARROW,
            Walk::First,
        );
        let (sign, name) = if view.is_playing() {
            ("■", text!("line-scan-pause"))
        } else {
            ("▶", text!("line-scan-play"))
        };
        walk_ui(
            ui,
            requests,
            &format!("{sign} {name}"),
            name,
            text!("line-scan-play.tip"),
            84.0,
            Walk::Play,
        );
        walk_ui(
            ui,
            requests,
            "▶|",
            text!("line-scan-last"),
            text!("line-scan-last.tip"),
            ARROW,
            Walk::Last,
        );
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let words = text!("line-scan-step-of", step = view.step(), last = last);
            ui.label(RichText::new(words).weak());
        });
    });
    let mut step = view.step();
    ui.spacing_mut().slider_width = ui.available_width();
    let slider = ui.add(Slider::new(&mut step, 0..=last).show_value(false));
    hold(&slider, Held::Slider);
    let (enabled, value) = (ui.is_enabled(), step);
    slider.widget_info(|| WidgetInfo::slider(enabled, value as f64, text!("line-scan-step")));
    if slider.changed() {
        view.go_to(step);
    }
    //  pixel    edge     line
    //  ◀  ▶    ◀  ▶    ◀  ▶
    let levels = [
        (
            ScanLevel::Pixel,
            text!("line-scan-level-pixel"),
            [
                text!("line-scan-pixel-back"),
                text!("line-scan-pixel-forward"),
            ],
            [",", "."],
        ),
        (
            ScanLevel::Edge,
            text!("line-scan-level-edge"),
            [
                text!("line-scan-edge-back"),
                text!("line-scan-edge-forward"),
            ],
            ["[", "]"],
        ),
        (
            ScanLevel::Line,
            text!("line-scan-level-line"),
            [
                text!("line-scan-line-back"),
                text!("line-scan-line-forward"),
            ],
            ["Page up", "Page down"],
        ),
    ];
    ui.columns(levels.len(), |columns| {
        for (ui, (level, word, names, keys)) in columns.iter_mut().zip(levels) {
            ui.spacing_mut().item_spacing = vec2(GAP, 1.0);
            ui.vertical_centered(|ui| ui.label(RichText::new(word).weak()));
            let width = 0.5 * (ui.available_width() - GAP);
            let walks = [("◀", Walk::Back(level)), ("▶", Walk::Forward(level))];
            ui.horizontal(|ui| {
                for ((sign, walk), (name, key)) in
                    walks.into_iter().zip(names.into_iter().zip(keys))
                {
                    let tip = format!("{name} ({key})");
                    walk_ui(ui, requests, sign, name, &tip, width, walk);
                }
            });
        }
    });
}

fn walk_ui(
    ui: &mut Ui,
    requests: &mut Requests,
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
        requests.ask(Action::Scan(walk));
    }
}

/// Shows a finding: its colour, name, position and meaning, then its formulas, filled in with its numbers.
fn formula_ui(ui: &mut Ui, scan: &Scan, step: usize, mix: Option<&Mix<'_>>) {
    let line = scan.at(step).line;
    let Some(mix) = mix else {
        let edges = text!("line-scan-active-edges", edges = scan.active_edges(line));
        heading_ui(ui, None, |ui| {
            lines_ui(ui, &text!("line-scan-line", y = line.y), &edges);
        });
        ui.add_space(6.0);
        return;
    };
    let place = match mix.pixel.map(|pixel| pixel.stored) {
        Some([r, g, b]) => text!("line-scan-stored", r = r, g = g, b = b),
        None => text!("line-scan-place", y = line.y, x = format!("{:.2}", mix.x)),
    };
    heading_ui(ui, mix.stored, |ui| lines_ui(ui, &mix.name, &place));
    let (plain, weak) = (ui.visuals().text_color(), ui.visuals().weak_text_color());
    lettered_ui(ui, &mix.definition(), weak);
    lettered_ui(ui, &mix.alpha_formula(), plain);
    lettered_ui(ui, &mix.alpha_text(), plain);
    ui.add_space(3.0);
    if scan.carried == Carried::Constant {
        ui.label(text!("line-scan-not-interpolated"));
    } else {
        let place = typeset::RunId {
            id: Id::unique(("scan-formula", mix.of)),
            name: text!("line-scan-formula"),
        };
        run_ui(ui, &pieces(mix, scan.carried, ui.visuals()), FORMULA, place);
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

/// Returns the pieces of the formula of a mix, such as `I = (1−α)·I…` with P as the subscript of the first `I`.
fn pieces(mix: &Mix<'_>, carried: Carried, visuals: &Visuals) -> Vec<Piece> {
    let plain = visuals.text_color();
    let (symbol, colour) = match carried {
        Carried::Normal => (Symbol::Normal, vector_text(visuals, Vector::N)),
        Carried::Constant | Carried::Intensity => (Symbol::Intensity, visuals.strong_text_color()),
    };
    let yellow = readable(colour_of(ALPHA, 1.0), visuals.panel_fill);
    let alpha = || Piece::plain("α", yellow);
    // Subscript digits become ordinary ones.
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

/// Shows a heading and the text below it.
fn lines_ui(ui: &mut Ui, heading: &str, below: &str) {
    let visuals = ui.visuals();
    let (strong, weak) = (visuals.strong_text_color(), visuals.weak_text_color());
    lettered_ui(ui, heading, strong);
    lettered_ui(ui, below, weak);
}

fn lettered_ui(ui: &mut Ui, text: &str, colour: Color32) {
    ui.add(Label::new(lettered(text, colour)).wrap());
}

/// Shows a component's letter and its line of numbers. The numbers of all components are aligned below each other.
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

/// Shows the tables: P, Q and the pixel with their values, the result of barycentric interpolation, and the edge table.
fn tables_ui(ui: &mut Ui, scan: &Scan, step: usize) {
    let point = scan.at(step);
    if point.p.is_some() {
        table_ui(ui, "scan-found", &scan.found_table(step), false);
        if point.pixel.is_some() {
            ui.label(RichText::new(scan.compared.name()).weak());
        }
        ui.add_space(8.0);
    }
    ui.label(RichText::new(text!("line-scan-edge-table-active")).strong());
    table_ui(ui, "scan-edges", &scan.edge_table(step), false);
}

/// Outlines the polygon in the picture and marks the part that the scan line has reached, white on dark, so that both are visible
/// on any picture.
pub fn paint(painter: &Painter, window: &WindowState, place: Place) {
    let Some(view) = window
        .own
        .get::<ScanView>()
        .filter(|_| window.shows(ViewName::ScanLine))
    else {
        return;
    };
    let Some(scan) = view.ready() else { return };
    let at = |grid: DVec2| place.exact_point(scan.grid.to_picture(grid));
    let corners: Vec<DVec2> = scan.corners.iter().map(|corner| at(corner.place)).collect();
    for stroke in cased([4.0, 1.75], [150, 255]) {
        outline(painter, &corners, stroke);
    }
    let point = scan.at(view.step());
    let Some(span) = point.span else { return };
    let ends = [span.p.x, span.q.x].map(|x| at(DVec2::new(x, point.line.centre_y())));
    for stroke in cased([3.0, 1.25], [150, 255]) {
        line(painter, ends, stroke, &[]);
    }
}
