//! The formula of what was found last, in the textbook's letters and filled in with its numbers.

use super::super::letter::lettered;
use super::super::palette::{readable, vector_text};
use super::super::state::AppState;
use super::super::symbol::Symbol;
use super::super::typeset::{Piece, Place, run_ui};
use super::ScanView;
use crate::analysis::{Carried, Mix, Scan, ScanPoint};
use crate::figure::Set;
use crate::figure::palette::{ALPHA, Vector};
use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    Color32, CornerRadius, FontId, Id, Label, Sense, Stroke, StrokeKind, Ui, Visuals, WidgetInfo, vec2,
};

/// Size of the formula's letters, points.
const LETTERS: f32 = 17.0;
/// Size of everything else, points.
const TEXT: f32 = 14.0;
/// Side of the swatch, points.
const SWATCH: f32 = 34.0;

/// What was found last, and how.
pub fn formula_ui(ui: &mut Ui, view: &ScanView, state: &mut AppState) {
    let Some(scan) = view.ready() else { return };
    let step = view.step();
    let point = scan.at(step);
    let (swatch, heading, weak) = heading(scan, &point);
    let mix = latest(scan, &point);
    let words = point.pixel.map(|pixel| scan.pixel_words(pixel)).unwrap_or_default();
    let carried = scan.carried;
    heading_ui(ui, swatch, &heading, &weak);
    if let Some(mix) = mix {
        if carried == Carried::Constant {
            ui.label("I is the polygon's own: nothing is interpolated.");
        } else {
            let pieces = pieces(&mix, carried, ui.visuals());
            run_ui(ui, state, &pieces, LETTERS, Place { id: Id::unique("scan formula"), name: "in the scan line" });
        }
        let plain = ui.visuals().text_color();
        lettered_ui(ui, &mix.alpha_text(), plain);
        if carried != Carried::Constant {
            for (index, name) in carried.components().into_iter().enumerate() {
                component_ui(ui, name, &mix.row(index));
            }
        }
    }
    if carried == Carried::Normal {
        for line in words.iter().take(2) {
            ui.label(line);
        }
    }
    ui.add_space(6.0);
}

/// The colour, what it is and where it lies.
fn heading(scan: &Scan, point: &ScanPoint<'_>) -> (Option<[u8; 3]>, String, String) {
    let y = point.line.y;
    if let Some(pixel) = point.pixel {
        let [r, g, b] = pixel.stored;
        return (Some(pixel.stored), format!("Pixel {}, {y}", pixel.x), format!("stored {r}, {g}, {b}"));
    }
    for (letter, crossing) in [("Q", point.q), ("P", point.p)] {
        if let Some(crossing) = crossing {
            let edge = scan.edge_name(crossing.edge);
            return (crossing.stored, format!("{letter} on {edge}"), format!("scan line {y}, x = {:.2}", crossing.x));
        }
    }
    let names: Vec<_> = point.line.active.iter().map(|edge| scan.edge_name(*edge)).collect();
    (None, format!("Scan line {y}"), format!("crosses {}", names.join(", ")))
}

fn latest(scan: &Scan, point: &ScanPoint<'_>) -> Option<Mix> {
    match (point.span, point.pixel, point.q, point.p) {
        (Some(span), Some(pixel), ..) => Some(scan.pixel_mix(span, pixel)),
        (_, None, Some(q), _) => Some(scan.crossing_mix(point.line, q, "Q")),
        (_, None, None, Some(p)) => Some(scan.crossing_mix(point.line, p, "P")),
        _ => None,
    }
}

fn heading_ui(ui: &mut Ui, swatch: Option<[u8; 3]>, heading: &str, weak: &str) {
    ui.horizontal(|ui| {
        let (rect, response) = ui.allocate_exact_size(vec2(SWATCH, SWATCH), Sense::hover());
        match swatch {
            Some([r, g, b]) => {
                ui.painter().rect_filled(rect, CornerRadius::same(5), Color32::from_rgb(r, g, b));
                let text = format!("colour {r}, {g}, {b}");
                response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &text));
            }
            None => {
                let stroke = Stroke::new(1.0, ui.visuals().weak_text_color());
                ui.painter().rect_stroke(rect, CornerRadius::same(5), stroke, StrokeKind::Inside);
            }
        }
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 1.0;
            let (strong, faint) = (ui.visuals().strong_text_color(), ui.visuals().weak_text_color());
            lettered_ui(ui, heading, strong);
            lettered_ui(ui, weak, faint);
        });
    });
}

/// `I` with P below the line `= (1−α)·I…`
fn pieces(mix: &Mix, carried: Carried, visuals: &Visuals) -> Vec<Piece> {
    let plain = visuals.text_color();
    let (letter, symbol, colour) = match carried {
        Carried::Normal => ("N", Symbol::Normal, vector_text(visuals, Vector::N)),
        Carried::Constant | Carried::Intensity => ("I", Symbol::Intensity, visuals.strong_text_color()),
    };
    let [r, g, b] = ALPHA;
    let yellow = readable(Color32::from_rgb(r, g, b), visuals.panel_fill);
    let alpha = || Piece::plain("α", yellow);
    let of = |name: &str| Piece::symbol(letter, ordinary(name), symbol, colour);
    let sign = |text: &'static str| Piece::plain(text, plain);
    let [a, b] = &mix.ends;
    vec![of(mix.of), sign(" = (1 − "), alpha(), sign(") · "), of(a), sign(" + "), alpha(), sign(" · "), of(b)]
}

/// Lowered digits as ordinary ones.
fn ordinary(name: &str) -> String {
    name.chars().map(|letter| Set::of(letter).letter).collect()
}

fn lettered_ui(ui: &mut Ui, text: &str, colour: Color32) {
    ui.add(Label::new(lettered(text, colour)).wrap());
}

/// A component's letter and its line of numbers, which begin below each other.
fn component_ui(ui: &mut Ui, name: &str, numbers: &str) {
    let (plain, weak) = (ui.visuals().text_color(), ui.visuals().weak_text_color());
    let format = |font_id, color| TextFormat { font_id, color, ..TextFormat::default() };
    let mut job = LayoutJob::default();
    job.append(&format!("{name}  "), 0.0, format(FontId::monospace(TEXT), weak));
    job.append(numbers, 0.0, format(FontId::proportional(TEXT), plain));
    ui.add(Label::new(job).wrap());
}
