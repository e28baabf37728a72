//! The equation on top of the controls. Its symbols are the table of contents: pointing at one lights up what controls
//! it, clicking it brings that into view.

use super::palette::{Term, term_text, vector_text};
use super::state::AppState;
use super::symbol::Symbol;
use crate::figure::palette::Vector;
use crate::scene::{Attenuation, ReflectionModel, Rgb, Scene};
use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, Color32, CursorIcon, FontFamily, FontId, Sense, Ui, Visuals, WidgetInfo, vec2};

/// Size of the equation's letters, points.
const SIZE: f32 = 18.0;

/// A piece of the equation.
struct Piece {
    text: &'static str,
    /// Lowered letters behind the text.
    low: &'static str,
    /// Raised letters behind the text.
    high: &'static str,
    symbol: Option<Symbol>,
    colour: Color32,
}

/// The equation as `state`'s scene has it; what it leaves out is pale.
pub fn equation_ui(ui: &mut Ui, state: &mut AppState) {
    let pieces = pieces(&state.document.scene, ui.visuals());
    let width = ui.available_width();
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing = vec2(0.0, 2.0);
        ui.set_max_width(width);
        ui.horizontal_wrapped(|ui| {
            for (number, group) in pieces.iter().enumerate() {
                group_ui(ui, state, group, number);
            }
        });
    });
}

/// A run of pieces that stays on one line.
fn group_ui(ui: &mut Ui, state: &mut AppState, group: &[Piece], number: usize) {
    let galleys: Vec<_> = group.iter().map(|piece| ui.painter().layout_job(layout(piece))).collect();
    let width = galleys.iter().map(|galley| galley.size().x).sum();
    let height = SIZE * 1.6;
    let (rect, _) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    let mut x = rect.min.x;
    for (index, (piece, galley)) in group.iter().zip(galleys).enumerate() {
        let size = vec2(galley.size().x, height);
        let place = eframe::egui::Rect::from_min_size(eframe::egui::pos2(x, rect.min.y), size);
        x += size.x;
        if let Some(symbol) = piece.symbol {
            // A symbol may stand more than once.
            symbol_ui(ui, state, symbol, place, (number, index));
        }
        let top = place.center().y - galley.size().y / 2.0;
        ui.painter().galley(eframe::egui::pos2(place.min.x, top), galley, piece.colour);
    }
}

fn symbol_ui(ui: &mut Ui, state: &mut AppState, symbol: Symbol, place: eframe::egui::Rect, index: (usize, usize)) {
    let id = ui.scope_id().with(("symbol", symbol, index));
    let response = ui.interact(place, id, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{symbol:?} in the equation")));
    if response.hovered() || response.has_focus() {
        state.lit.next = Some(symbol);
        ui.ctx().set_cursor_icon(CursorIcon::PointingHand);
    }
    if response.clicked() {
        state.look.controls = true;
        state.lit.seek = Some(symbol);
    }
    if state.lit.now == Some(symbol) {
        let fill = ui.visuals().widgets.hovered.bg_fill;
        ui.painter().rect_filled(place.shrink2(vec2(0.0, 2.0)).expand2(vec2(1.0, 0.0)), 4.0, fill);
    }
    response.on_hover_text(symbol.meaning());
}

fn layout(piece: &Piece) -> LayoutJob {
    let mut job = LayoutJob::default();
    let format = |size: f32, valign: Align, italics: bool| TextFormat {
        font_id: FontId::new(size, FontFamily::Proportional),
        color: piece.colour,
        italics,
        valign,
        ..TextFormat::default()
    };
    let italics = piece.symbol.is_some() && piece.text != "Σ";
    job.append(piece.text, 0.0, format(SIZE, Align::Center, italics));
    if !piece.low.is_empty() {
        job.append(piece.low, 0.0, format(SIZE * 0.68, Align::BOTTOM, false));
    }
    if !piece.high.is_empty() {
        job.append(piece.high, 0.0, format(SIZE * 0.75, Align::TOP, true));
    }
    job
}

fn pieces(scene: &Scene, visuals: &Visuals) -> Vec<Vec<Piece>> {
    let model = scene.reflection.model;
    let material = &scene.material;
    let plain = visuals.text_color();
    let pale = visuals.weak_text_color().gamma_multiply(0.55);
    let unless = |absent: bool, colour: Color32| if absent { pale } else { colour };
    let dark = scene.lights.is_empty();
    let ambient = unless(material.ka == Rgb::ZERO || scene.ambient.color == Rgb::ZERO, plain);
    let no_diffuse = dark || material.kd == Rgb::ZERO;
    let no_specular = dark || material.ks == Rgb::ZERO;
    let diffuse = unless(no_diffuse, term_text(visuals, Term::Diffuse, model));
    let specular = unless(no_specular, term_text(visuals, Term::Specular, model));
    let letter = |vector: Vector, absent: bool| unless(absent, vector_text(visuals, vector));
    let attenuated = scene.lights.iter().any(|light| light.attenuation != Attenuation::None);
    let piece = |text, low, symbol, colour| Piece { text, low, high: "", symbol, colour };
    let (first, second, other) = match model {
        ReflectionModel::Blinn | ReflectionModel::CookTorrance => (Vector::N, Vector::H, Symbol::Reflected),
        ReflectionModel::Phong => (Vector::R, Vector::V, Symbol::Viewer),
    };
    let first_symbol = if model == ReflectionModel::Blinn { Symbol::Normal } else { Symbol::Reflected };
    vec![
        vec![
            piece("I", "", Some(Symbol::Intensity), visuals.strong_text_color()),
            piece(" = ", "", None, plain),
            piece("K", "a", Some(Symbol::Ka), ambient),
            piece("O", "d", Some(Symbol::Od), ambient),
            piece("I", "a", Some(Symbol::Ia), ambient),
        ],
        vec![
            piece(" + ", "", None, plain),
            piece("Σ ", "", Some(Symbol::Lights), unless(dark, plain)),
            piece("f ", "", Some(Symbol::Attenuation), unless(!attenuated, plain)),
            piece("I", "p", Some(Symbol::Ip), unless(dark, plain)),
            piece(" [", "", None, plain),
        ],
        vec![
            piece("K", "d", Some(Symbol::Kd), diffuse),
            piece("O", "d", Some(Symbol::Od), diffuse),
            piece("(", "", None, plain),
            piece("N", "", Some(Symbol::Normal), letter(Vector::N, no_diffuse)),
            piece("·", "", None, plain),
            piece("L", "", Some(Symbol::Light), letter(Vector::L, no_diffuse)),
            piece(")", "", None, plain),
        ],
        vec![
            piece(" + ", "", None, plain),
            piece("K", "s", Some(Symbol::Ks), specular),
            piece("(", "", None, plain),
            piece(first.letter(), "", Some(first_symbol), letter(first, no_specular)),
            piece("·", "", None, plain),
            piece(second.letter(), "", Some(other), letter(second, no_specular)),
            piece(")", "", None, plain),
            Piece { text: "", low: "", high: "n", symbol: Some(Symbol::Exponent), colour: specular },
            piece("]", "", None, plain),
        ],
    ]
}
