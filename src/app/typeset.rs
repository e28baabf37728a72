//! Formulas as the textbooks set them: italic letters with lowered and raised ones, each symbol a way to its control.

use super::state::AppState;
use super::symbol::Symbol;
use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    Align, Color32, CursorIcon, FontFamily, FontId, Galley, Id, Pos2, Rect, Response, Sense, Ui, WidgetInfo, pos2, vec2,
};
use std::borrow::Cow;
use std::sync::Arc;

/// How far above the middle of a run the top of raised letters lies, in heights of the run.
const RAISED: f32 = 0.42;

/// A letter, a sign or a number of a formula.
#[derive(Clone, Debug)]
pub struct Piece {
    pub text: Cow<'static, str>,
    /// Lowered letters behind the text.
    pub low: Cow<'static, str>,
    /// Raised letters behind the text.
    pub high: Cow<'static, str>,
    pub symbol: Option<Symbol>,
    pub colour: Color32,
    /// What is said where the pointer rests on it; the symbol's meaning without.
    pub tip: Option<String>,
}

impl Piece {
    /// What is no symbol: a sign, a bracket, a number, a word.
    pub fn plain(text: impl Into<Cow<'static, str>>, colour: Color32) -> Self {
        Self { text: text.into(), low: Cow::Borrowed(""), high: Cow::Borrowed(""), symbol: None, colour, tip: None }
    }

    /// A symbol with a lowered letter, which may be empty.
    pub fn symbol(text: &'static str, low: impl Into<Cow<'static, str>>, symbol: Symbol, colour: Color32) -> Self {
        Self { low: low.into(), symbol: Some(symbol), ..Self::plain(text, colour) }
    }

    /// The same with `high` raised behind it.
    pub fn raised(self, high: impl Into<Cow<'static, str>>) -> Self {
        Self { high: high.into(), ..self }
    }

    /// The same, explained by `tip`.
    pub fn explained(self, tip: String) -> Self {
        Self { tip: Some(tip), ..self }
    }

    fn layout(&self, size: f32) -> LayoutJob {
        let mut job = LayoutJob::default();
        let format = |size: f32, valign: Align, italics: bool| TextFormat {
            font_id: FontId::new(size, FontFamily::Proportional),
            color: self.colour,
            italics,
            valign,
            ..TextFormat::default()
        };
        // Letters are slanted, words and the sign of a sum are not.
        let italics = self.symbol.is_some() && self.text.trim() != "Σ" && self.text.trim().chars().count() <= 1;
        job.append(&self.text, 0.0, format(size, Align::Center, italics));
        if !self.low.is_empty() {
            job.append(&self.low, 0.0, format(size * 0.68, Align::BOTTOM, false));
        }
        if !self.high.is_empty() {
            let letter = self.high.starts_with(char::is_alphabetic);
            job.append(&self.high, 0.0, format(size * 0.75, Align::TOP, letter));
        }
        job
    }
}

/// What a run of pieces reads, for a screen reader.
pub fn spoken(pieces: &[Piece]) -> String {
    let each = pieces.iter().map(|piece| {
        let high = if piece.high.is_empty() { String::new() } else { format!("^{}", piece.high) };
        format!("{}{}{high}", piece.text, piece.low)
    });
    each.collect()
}

/// Pieces side by side, laid out but not yet placed.
pub struct Run<'a> {
    pieces: &'a [Piece],
    galleys: Vec<Arc<Galley>>,
    height: f32,
}

/// Which run of a panel it is.
#[derive(Clone, Copy, Debug)]
pub struct Place<'a> {
    pub id: Id,
    /// Behind the symbols' accessible names.
    pub name: &'a str,
}

impl<'a> Run<'a> {
    /// Lays out `pieces` in letters of `size` points.
    pub fn new(ui: &Ui, pieces: &'a [Piece], size: f32) -> Self {
        let galleys = pieces.iter().map(|piece| ui.painter().layout_job(piece.layout(size))).collect();
        Self { pieces, galleys, height: size * 1.6 }
    }

    pub fn width(&self) -> f32 {
        self.galleys.iter().map(|galley| galley.size().x).sum()
    }

    pub fn height(&self) -> f32 {
        self.height
    }

    /// Paints the run from `left`, the middle of its left side. Its symbols light up what controls them.
    pub fn paint(&self, ui: &mut Ui, state: &mut AppState, left: Pos2, place: Place<'_>) {
        let mut x = left.x;
        for (index, (piece, galley)) in self.pieces.iter().zip(&self.galleys).enumerate() {
            let size = vec2(galley.size().x, self.height);
            let rect = Rect::from_min_size(pos2(x, left.y - self.height / 2.0), size);
            x += size.x;
            if let Some(symbol) = piece.symbol {
                // A symbol may stand more than once.
                symbol_ui(ui, state, piece, symbol, rect, Place { id: place.id.with((symbol, index)), ..place });
            }
            let top = if piece.text.is_empty() {
                // Alone in its row it has nothing to be raised above.
                rect.center().y - self.height * RAISED
            } else {
                rect.center().y - galley.size().y / 2.0
            };
            ui.painter().galley(pos2(rect.min.x, top), Arc::clone(galley), piece.colour);
        }
    }
}

/// Adds a run of pieces that stays on one line.
pub fn run_ui(ui: &mut Ui, state: &mut AppState, pieces: &[Piece], size: f32, place: Place<'_>) -> Response {
    let run = Run::new(ui, pieces, size);
    let (rect, response) = ui.allocate_exact_size(vec2(run.width(), run.height()), Sense::hover());
    run.paint(ui, state, rect.left_center(), place);
    response
}

fn symbol_ui(ui: &mut Ui, state: &mut AppState, piece: &Piece, symbol: Symbol, rect: Rect, place: Place<'_>) {
    let response = ui.interact(rect, place.id, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{symbol:?} {}", place.name)));
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
        ui.painter().rect_filled(rect.shrink2(vec2(0.0, 2.0)).expand2(vec2(1.0, 0.0)), 4.0, fill);
    }
    response.on_hover_text(piece.tip.as_deref().unwrap_or(symbol.meaning()));
}
