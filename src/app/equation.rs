//! The equation on top of the controls. Its symbols are the table of contents: pointing at one lights up what controls
//! it, clicking it brings that into view.

use super::palette::{Term, term_text, vector_text};
use super::state::AppState;
use super::symbol::Symbol;
use crate::figure::palette::Vector;
use crate::scene::{Attenuation, Reflectance, ReflectionModel, Rgb, Scene};
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

/// What a scene's equation looks like: the colours of its terms, and what it has.
struct Ink<'a> {
    scene: &'a Scene,
    visuals: &'a Visuals,
    plain: Color32,
    pale: Color32,
}

const fn piece(text: &'static str, low: &'static str, symbol: Option<Symbol>, colour: Color32) -> Piece {
    Piece { text, low, high: "", symbol, colour }
}

fn pieces(scene: &Scene, visuals: &Visuals) -> Vec<Vec<Piece>> {
    let (plain, pale) = (visuals.text_color(), visuals.weak_text_color().gamma_multiply(0.55));
    let ink = Ink { scene, visuals, plain, pale };
    let transparent = scene.transparency.kt > 0.0;
    let mut groups = vec![ink.ambient(transparent), ink.sum(), ink.diffuse()];
    groups.extend(ink.specular());
    if transparent {
        groups.push(ink.transmitted());
    }
    groups
}

impl Ink<'_> {
    fn unless(&self, absent: bool, colour: Color32) -> Color32 {
        if absent { self.pale } else { colour }
    }

    fn plain(&self, text: &'static str) -> Piece {
        piece(text, "", None, self.plain)
    }

    fn letter(&self, vector: Vector, symbol: Symbol, absent: bool) -> Piece {
        piece(vector.letter(), "", Some(symbol), self.unless(absent, vector_text(self.visuals, vector)))
    }

    fn dark(&self) -> bool {
        self.scene.lights.is_empty()
    }

    /// I and the ambient term; behind 1 − Kt where the surface is transparent.
    fn ambient(&self, transparent: bool) -> Vec<Piece> {
        let absent = self.scene.material.ka == Rgb::ZERO || self.scene.ambient.color == Rgb::ZERO;
        let colour = self.unless(absent, self.plain);
        let mut group =
            vec![piece("I", "", Some(Symbol::Intensity), self.visuals.strong_text_color()), self.plain(" = ")];
        if transparent {
            let sky = vector_text(self.visuals, Vector::T);
            group.extend([self.plain("(1 − "), piece("K", "t", Some(Symbol::Kt), sky), self.plain(") ( ")]);
        }
        group.extend([
            piece("K", "a", Some(Symbol::Ka), colour),
            piece("O", "d", Some(Symbol::Od), colour),
            piece("I", "a", Some(Symbol::Ia), colour),
        ]);
        group
    }

    fn sum(&self) -> Vec<Piece> {
        let attenuated = self.scene.lights.iter().any(|light| light.attenuation != Attenuation::None);
        let colour = self.unless(self.dark(), self.plain);
        vec![
            self.plain(" + "),
            piece("Σ ", "", Some(Symbol::Lights), colour),
            piece("f ", "", Some(Symbol::Attenuation), self.unless(!attenuated, self.plain)),
            piece("I", "p", Some(Symbol::Ip), colour),
            self.plain(" ["),
        ]
    }

    fn diffuse(&self) -> Vec<Piece> {
        let absent = self.dark() || self.scene.material.kd == Rgb::ZERO;
        let colour = self.unless(absent, term_text(self.visuals, Term::Diffuse, self.scene.reflection.model));
        vec![
            piece("K", "d", Some(Symbol::Kd), colour),
            piece("O", "d", Some(Symbol::Od), colour),
            self.plain("("),
            self.letter(Vector::N, Symbol::Normal, absent),
            self.plain("·"),
            self.letter(Vector::L, Symbol::Light, absent),
            self.plain(")"),
        ]
    }

    fn specular(&self) -> Vec<Vec<Piece>> {
        let (material, model) = (&self.scene.material, self.scene.reflection.model);
        let absent = self.dark() || material.ks == Rgb::ZERO;
        let colour = self.unless(absent, term_text(self.visuals, Term::Specular, model));
        let mut group = vec![self.plain(" + "), piece("K", "s", Some(Symbol::Ks), colour)];
        if material.specular_color != Rgb::ONE {
            group.push(piece("O", "s", Some(Symbol::Os), colour));
        }
        if material.reflectance != Reflectance::Constant {
            group.extend([piece(" W", "", Some(Symbol::Reflectance), colour), self.plain("(θ) ")]);
        }
        if model == ReflectionModel::CookTorrance {
            group.extend([piece(" π", "", None, colour), piece(" D", "", Some(Symbol::Facets), colour)]);
            group.push(piece(" G", "", Some(Symbol::Masking), colour));
            return vec![group, self.over_view(absent)];
        }
        let blinn = model == ReflectionModel::Blinn;
        let (first, second) = if blinn {
            (self.letter(Vector::N, Symbol::Normal, absent), self.letter(Vector::H, Symbol::Reflected, absent))
        } else {
            (self.letter(Vector::R, Symbol::Reflected, absent), self.letter(Vector::V, Symbol::Viewer, absent))
        };
        group.extend([self.plain("("), first, self.plain("·"), second, self.plain(")")]);
        group.push(Piece { text: "", low: "", high: "n", symbol: Some(Symbol::Exponent), colour });
        group.push(self.plain("]"));
        vec![group]
    }

    /// What the microfacets' term is divided by.
    fn over_view(&self, absent: bool) -> Vec<Piece> {
        vec![
            self.plain(" / (4 "),
            self.letter(Vector::N, Symbol::Normal, absent),
            self.plain("·"),
            self.letter(Vector::V, Symbol::Viewer, absent),
            self.plain(")]"),
        ]
    }

    fn transmitted(&self) -> Vec<Piece> {
        let sky = vector_text(self.visuals, Vector::T);
        vec![
            self.plain(" ) + "),
            piece("K", "t", Some(Symbol::Kt), sky),
            piece("I", "t", Some(Symbol::Transmitted), sky),
        ]
    }
}
