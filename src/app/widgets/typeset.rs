//! Formulas set as in textbooks: italic letters with subscripts and superscripts, each symbol linked to its control.

use super::letter::{append, lettered};
use super::palette::vector_text;
use super::symbol::{self, Symbol};
use crate::figure::palette::Vector;
use crate::figure::{Base, Formula, Item, is_italic};
use crate::text::text;
use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{
    Align, Color32, CursorIcon, FontFamily, FontId, Galley, Id, Pos2, Rect, Response, Sense, Ui,
    Visuals, WidgetInfo, pos2, vec2,
};
use std::borrow::Cow;
use std::sync::Arc;

/// Distance from the middle of a run up to the top of its superscripts, in heights of the run.
const RAISED: f32 = 0.42;

/// A letter of formulas: its name in them, its text, its subscript, its symbol, and the key of its meaning if that
/// differs from its symbol's.
type Letter = (
    &'static str,
    &'static str,
    &'static str,
    Symbol,
    &'static str,
);
/// The exponent alone, in its place above the line.
const RAISED_EXPONENT: Letter = ("n", "", "", Symbol::Exponent, "");
const LETTERS: [Letter; 28] = [
    ("I", "I", "", Symbol::Intensity, ""),
    (
        "Irefl",
        "I",
        "refl",
        Symbol::Intensity,
        "point-letter-irefl",
    ),
    ("Ka", "K", "a", Symbol::Ka, ""),
    ("Od", "O", "d", Symbol::Od, ""),
    ("Ia", "I", "a", Symbol::Ia, ""),
    ("Σ", "Σ ", "", Symbol::Lights, ""),
    ("f", "f ", "", Symbol::Attenuation, ""),
    ("spot", "s ", "", Symbol::Light, "point-letter-s"),
    ("lit", "lit ", "", Symbol::Shadows, "point-letter-lit"),
    ("law", " law", "", Symbol::Reflected, "point-letter-law"),
    ("Ip", "I", "p", Symbol::Ip, ""),
    ("Kd", "K", "d", Symbol::Kd, ""),
    ("Ks", "K", "s", Symbol::Ks, ""),
    ("Os", "O", "s", Symbol::Os, ""),
    ("W", "W", "", Symbol::Reflectance, ""),
    ("S", "S", "", Symbol::Facets, "point-letter-facets"),
    ("D", "D ", "", Symbol::Facets, ""),
    ("G", "G", "", Symbol::Masking, ""),
    ("N", "N", "", Symbol::Normal, ""),
    ("L", "L", "", Symbol::Light, ""),
    ("R", "R", "", Symbol::Reflected, ""),
    ("V", "V", "", Symbol::Viewer, ""),
    ("H", "H", "", Symbol::Reflected, ""),
    ("Kt", "K", "t", Symbol::Kt, ""),
    ("It", "I", "t", Symbol::Transmitted, ""),
    ("Itrans", "I", "trans", Symbol::Transmitted, ""),
    ("s0", "s", "0", Symbol::Depth, ""),
    ("Idc", "I", "dc", Symbol::Depth, "point-letter-idc"),
];

/// Returns each letter of the formulas as text, with its symbol.
pub fn letters() -> impl Iterator<Item = (String, Symbol)> {
    let exponent = std::iter::once(("n".to_owned(), Symbol::Exponent));
    let others = LETTERS.iter();
    exponent
        .chain(others.map(|(_, text, low, symbol, _)| (format!("{}{low}", text.trim()), *symbol)))
}

/// Splits a formula whose letters stand in braces, as in [`Here::filled`](crate::analysis::probe::Here::filled), into
/// pieces. Letters have the `colour`, vectors their own. `here` returns the value of a letter at the pixel, or an empty
/// string.
pub fn formula(
    visuals: &Visuals,
    formula: &str,
    colour: Color32,
    here: impl Fn(&str) -> String,
) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let mut plain = String::new();
    for Item { base, high, .. } in Formula::read_or_verbatim(formula).items {
        match base {
            Base::Name(text) | Base::Signs(text) => plain.push_str(&text),
            Base::Group(inside) => {
                push_plain(visuals, &mut pieces, &mut plain);
                pieces.push(grouped(visuals, &inside.to_string(), colour, &here));
            }
        }
        if high.is_empty() {
            continue;
        }
        push_plain(visuals, &mut pieces, &mut plain);
        let high = high.to_string();
        if high == RAISED_EXPONENT.0 {
            pieces.push(Piece {
                high: high.into(),
                ..known(visuals, RAISED_EXPONENT, colour, &here)
            });
        } else if let Some(last) = pieces.last_mut() {
            last.high = high.into();
        }
    }
    push_plain(visuals, &mut pieces, &mut plain);
    pieces
}

/// Ends a run of letters and signs that are not symbols.
fn push_plain(visuals: &Visuals, pieces: &mut Vec<Piece>, plain: &mut String) {
    if !plain.is_empty() {
        pieces.push(Piece::plain(std::mem::take(plain), visuals.text_color()));
    }
}

/// Returns the piece for a group in braces: a letter by its name, or a result after `=`.
fn grouped(visuals: &Visuals, name: &str, colour: Color32, here: impl Fn(&str) -> String) -> Piece {
    if let Some(result) = name.strip_prefix('=') {
        return Piece::plain(result.to_owned(), visuals.strong_text_color());
    }
    match LETTERS.iter().find(|(known, ..)| *known == name) {
        Some(letter) => known(visuals, *letter, colour, here),
        None => Piece::plain(name.to_owned(), visuals.text_color()),
    }
}

/// Returns the piece of a known letter, with its value at the pixel in its tooltip.
fn known(
    visuals: &Visuals,
    (name, text, low, symbol, meaning): Letter,
    colour: Color32,
    here: impl Fn(&str) -> String,
) -> Piece {
    let colour = vector(name).map_or(colour, |vector| vector_text(visuals, vector));
    let meaning = if meaning.is_empty() {
        format!("{}; {}", symbol.meaning(), symbol.unit())
    } else {
        text!(meaning).to_owned()
    };
    let here = here(name);
    let tip = (!here.is_empty()).then(|| format!("{meaning}.\n{here}"));
    Piece {
        tip,
        ..Piece::symbol(text, low, symbol, colour)
    }
}

/// Returns the vector of this letter.
fn vector(letter: &str) -> Option<Vector> {
    let mut all = Vector::ALL.into_iter();
    all.find(|vector| vector.letter() == letter)
}

/// Returns a letter of the formulas by its name, such as `Ka` or `n`, in its own colour; `None` for an unknown name.
pub fn letter(visuals: &Visuals, name: &str) -> Option<Piece> {
    let exponent = ("n", "n", "", Symbol::Exponent, "");
    let known = LETTERS.iter().find(|(known, ..)| *known == name);
    let (_, text, low, symbol, meaning) = *known.or((name == "n").then_some(&exponent))?;
    let vector = match symbol {
        Symbol::Kd => Some(Vector::L),
        Symbol::Ks => Some(Vector::R),
        _ => vector(name),
    };
    let colour = vector.map_or(visuals.text_color(), |vector| vector_text(visuals, vector));
    let tip = (!meaning.is_empty()).then(|| text!(meaning).to_owned());
    Some(Piece {
        tip,
        ..Piece::symbol(text.trim_end(), low, symbol, colour)
    })
}

/// A letter, a sign or a number of a formula.
#[derive(Clone, Debug)]
pub struct Piece {
    pub text: Cow<'static, str>,
    /// The subscript after the text.
    pub low: Cow<'static, str>,
    /// The superscript after the text.
    pub high: Cow<'static, str>,
    pub symbol: Option<Symbol>,
    pub colour: Color32,
    /// The tooltip; the symbol's meaning if `None`.
    pub tip: Option<String>,
}

impl Piece {
    /// Creates a piece that is not a symbol: a sign, a bracket, a number, a word.
    pub fn plain(text: impl Into<Cow<'static, str>>, colour: Color32) -> Self {
        Self {
            text: text.into(),
            low: Cow::Borrowed(""),
            high: Cow::Borrowed(""),
            symbol: None,
            colour,
            tip: None,
        }
    }

    /// Creates a symbol with a subscript, which may be empty.
    pub fn symbol(
        text: &'static str,
        low: impl Into<Cow<'static, str>>,
        symbol: Symbol,
        colour: Color32,
    ) -> Self {
        Self {
            low: low.into(),
            symbol: Some(symbol),
            ..Self::plain(text, colour)
        }
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
        let italics = is_italic(self.text.trim());
        append(&mut job, &self.text, &format(size, Align::Center, italics));
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

/// Returns the text of the pieces for a screen reader.
pub fn spoken(pieces: &[Piece]) -> String {
    let each = pieces.iter().map(|piece| {
        let high = if piece.high.is_empty() {
            String::new()
        } else {
            format!("^{}", piece.high)
        };
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

/// The identity of a run in a panel.
#[derive(Clone, Copy, Debug)]
pub struct RunId<'a> {
    pub id: Id,
    /// The suffix of the symbols' accessible names.
    pub name: &'a str,
}

impl<'a> Run<'a> {
    /// Lays out `pieces` in letters of `size` points.
    pub fn new(ui: &Ui, pieces: &'a [Piece], size: f32) -> Self {
        let galleys = pieces
            .iter()
            .map(|piece| ui.painter().layout_job(piece.layout(size)))
            .collect();
        Self {
            pieces,
            galleys,
            height: size * 1.6,
        }
    }

    pub fn width(&self) -> f32 {
        self.galleys.iter().map(|galley| galley.size().x).sum()
    }

    /// Paints the run from `left`, the middle of its left side. Its symbols highlight their controls.
    pub fn paint(&self, ui: &Ui, left: Pos2, place: RunId<'_>) {
        let mut x = left.x;
        for (index, (piece, galley)) in self.pieces.iter().zip(&self.galleys).enumerate() {
            let size = vec2(galley.size().x, self.height);
            let rect = Rect::from_min_size(pos2(x, left.y - self.height / 2.0), size);
            x += size.x;
            if let Some(symbol) = piece.symbol {
                // A symbol may appear more than once.
                let id = place.id.with((symbol, index));
                symbol_ui(ui, piece, symbol, rect, RunId { id, ..place });
            }
            let top = if piece.text.is_empty() {
                // Alone in its row, it has no base above which to rise.
                rect.center().y - self.height * RAISED
            } else {
                rect.center().y - galley.size().y / 2.0
            };
            ui.painter()
                .galley(pos2(rect.min.x, top), Arc::clone(galley), piece.colour);
        }
    }
}

/// Shows a run of pieces on a single line.
pub fn run_ui(ui: &mut Ui, pieces: &[Piece], size: f32, place: RunId<'_>) -> Response {
    let run = Run::new(ui, pieces, size);
    let (rect, response) = ui.allocate_exact_size(vec2(run.width(), run.height), Sense::hover());
    run.paint(ui, rect.left_center(), place);
    response
}

fn symbol_ui(ui: &Ui, piece: &Piece, symbol: Symbol, rect: Rect, place: RunId<'_>) {
    let response = ui.interact(rect, place.id, Sense::click_and_drag());
    response.widget_info(|| {
        WidgetInfo::labeled(Role::Button, true, format!("{symbol:?} {}", place.name))
    });
    if response.hovered() || response.has_focus() || response.dragged() {
        symbol::light_up(ui.ctx(), symbol);
        ui.ctx().set_cursor_icon(if response.dragged() {
            CursorIcon::ResizeHorizontal
        } else {
            CursorIcon::PointingHand
        });
    }
    if response.dragged() {
        symbol::pull(ui.ctx(), symbol, response.drag_delta().x);
    }
    if response.clicked() {
        symbol::click(ui.ctx(), symbol, rect);
    }
    if symbol::is_lit(ui.ctx(), symbol) {
        let fill = ui.visuals().widgets.hovered.bg_fill;
        let lit = rect.shrink2(vec2(0.0, 2.0)).expand2(vec2(1.0, 0.0));
        ui.painter().rect_filled(lit, 4.0, fill);
    }
    let tip = piece.tip.as_deref().unwrap_or(symbol.meaning());
    response.on_hover_ui(|ui| _ = ui.label(lettered(tip, ui.visuals().text_color())));
}
