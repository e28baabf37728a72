//! How the factors of the terms are written: the textbooks' letters, in the colours of the picture, each with what it is
//! at this pixel.

use super::figure::{Figure, triple};
use crate::analysis::{Factor, TermColumn as Column};
use crate::app::palette::{Term, term_text, vector_text};
use crate::app::symbol::Symbol;
use crate::app::typeset::Piece;
use crate::figure::palette::Vector;
use crate::scene::ReflectionModel;
use eframe::egui::{Color32, Visuals};

/// Colours of the filled-in equation, and the model that its letters follow.
#[derive(Clone, Debug)]
pub struct Notation {
    visuals: Visuals,
    model: ReflectionModel,
}

impl Notation {
    pub fn new(visuals: &Visuals, model: ReflectionModel) -> Self {
        Self { visuals: visuals.clone(), model }
    }

    pub fn term(&self, term: Term) -> Color32 {
        term_text(&self.visuals, term, self.model)
    }

    pub fn through(&self) -> Color32 {
        vector_text(&self.visuals, Vector::T)
    }

    pub fn plain(&self) -> Color32 {
        self.visuals.text_color()
    }

    pub fn weak(&self) -> Color32 {
        self.visuals.weak_text_color()
    }

    pub fn strong(&self) -> Color32 {
        self.visuals.strong_text_color()
    }

    pub fn sign(&self, text: impl Into<std::borrow::Cow<'static, str>>) -> Piece {
        Piece::plain(text, self.plain())
    }

    /// A vector's letter, with its coordinates at the pixel.
    pub fn vector(&self, vector: Vector, symbol: Symbol, here: glam::DVec3) -> Piece {
        let [x, y, z] = here.to_array().map(|part| format!("{part:.3}").replace('-', "−"));
        let tip = format!("{}; {}.\nHere ({x}, {y}, {z}).", symbol.meaning(), symbol.unit());
        Piece::symbol(vector.letter(), "", symbol, vector_text(&self.visuals, vector)).explained(tip)
    }

    /// The head of a column: its factors side by side, in the colour of their term.
    pub fn head(&self, column: &Column, colour: Color32, vectors: &Vectors) -> Vec<Piece> {
        let here = if column.factors.len() == 1 { value_of(column) } else { product_of(column) };
        column.factors.iter().flat_map(|factor| self.factor(*factor, colour, vectors, &here)).collect()
    }

    fn factor(&self, factor: Factor, colour: Color32, vectors: &Vectors, here: &str) -> Vec<Piece> {
        let letter = |text, low, symbol: Symbol| {
            let tip = format!("{}; {}.\n{here}", symbol.meaning(), symbol.unit());
            vec![Piece::symbol(text, low, symbol, colour).explained(tip)]
        };
        let called = |text, symbol: Symbol, meaning: &str| {
            vec![Piece::symbol(text, "", symbol, colour).explained(format!("{meaning}.\n{here}"))]
        };
        match factor {
            Factor::Ka => letter("K", "a", Symbol::Ka),
            Factor::Od => letter("O", "d", Symbol::Od),
            Factor::Ia => letter("I", "a", Symbol::Ia),
            Factor::Ip => letter("I", "p", Symbol::Ip),
            Factor::Kd => letter("K", "d", Symbol::Kd),
            Factor::Ks => letter("K", "s", Symbol::Ks),
            Factor::Os => letter("O", "s", Symbol::Os),
            Factor::Reflectance => letter("W", "", Symbol::Reflectance),
            Factor::Attenuation => letter("f ", "", Symbol::Attenuation),
            Factor::Spot => {
                called("s ", Symbol::Light, "s: the part of its light that the spot sends this way, 0 to 1")
            }
            Factor::Lit => {
                called("lit ", Symbol::Shadows, "lit: the part of the light that nothing keeps away, 0 to 1")
            }
            Factor::Kt => letter("K", "t", Symbol::Kt),
            Factor::Itrans => letter("I", "trans", Symbol::Transmitted),
            Factor::Irefl => called("I", Symbol::Intensity, "Irefl: the reflected light, what the terms add up to")
                .into_iter()
                .map(|piece| Piece { low: "refl".into(), ..piece })
                .collect(),
            Factor::Kept => letter("s", "0", Symbol::Depth),
            Factor::Gone => [vec![self.sign("1 − ")], letter("s", "0", Symbol::Depth)].concat(),
            Factor::Idc => called("I", Symbol::Depth, "Idc: what intensities fade into")
                .into_iter()
                .map(|piece| Piece { low: "dc".into(), ..piece })
                .collect(),
            Factor::Intensity => called("I", Symbol::Intensity, "I: what the surface sends out, before it fades"),
            Factor::Opaque => [vec![self.sign("1 − ")], letter("K", "t", Symbol::Kt)].concat(),
            Factor::Facing => self.facing(vectors),
            Factor::Lobe if self.model == ReflectionModel::CookTorrance => {
                called("S", Symbol::Facets, "S: the microfacets that mirror the light to the viewer, π·D·G/(4·(N·V))")
            }
            Factor::Lobe => self.lobe(vectors, colour, "n"),
        }
    }

    /// `(N·L)`.
    pub fn facing(&self, vectors: &Vectors) -> Vec<Piece> {
        vec![
            self.sign("("),
            self.vector(Vector::N, Symbol::Normal, vectors.n),
            self.sign("·"),
            self.vector(Vector::L, Symbol::Light, vectors.l),
            self.sign(")"),
        ]
    }

    /// `(R·V)^n` or `(N·H)^n`.
    pub fn lobe(&self, vectors: &Vectors, colour: Color32, n: &'static str) -> Vec<Piece> {
        let (first, second) = match self.model {
            ReflectionModel::Phong => (
                self.vector(Vector::R, Symbol::Reflected, vectors.r),
                self.vector(Vector::V, Symbol::Viewer, vectors.v),
            ),
            ReflectionModel::Blinn | ReflectionModel::CookTorrance => (
                self.vector(Vector::N, Symbol::Normal, vectors.n),
                self.vector(Vector::H, Symbol::Reflected, vectors.h),
            ),
        };
        let tip = format!("{}; no unit.\nHere {}.", Symbol::Exponent.meaning(), vectors.exponent);
        let exponent = Piece::symbol("", "", Symbol::Exponent, colour).raised(n).explained(tip);
        vec![self.sign("("), first, self.sign("·"), second, self.sign(")"), exponent]
    }

    /// `π D G / (4 N·V)`.
    pub fn microfacets(&self, vectors: &Vectors, colour: Color32) -> Vec<Piece> {
        vec![
            Piece::symbol("S", "", Symbol::Facets, colour),
            self.sign(" = "),
            Piece::plain("π ", colour),
            Piece::symbol("D ", "", Symbol::Facets, colour),
            Piece::symbol("G", "", Symbol::Masking, colour),
            self.sign(" / (4 "),
            self.vector(Vector::N, Symbol::Normal, vectors.n),
            self.sign("·"),
            self.vector(Vector::V, Symbol::Viewer, vectors.v),
            self.sign(")"),
        ]
    }

    /// `= value`, the value in strong type.
    pub fn result(&self, value: f64) -> [Piece; 2] {
        [self.sign(" = "), Piece::plain(Figure::new(value).text(), self.strong())]
    }
}

/// The vectors of one light at the pixel, and n as text. Where no vector stands in the letters it is empty.
#[derive(Clone, Debug, Default)]
pub struct Vectors {
    pub n: glam::DVec3,
    pub l: glam::DVec3,
    pub r: glam::DVec3,
    pub v: glam::DVec3,
    pub h: glam::DVec3,
    pub exponent: String,
}

fn value_of(column: &Column) -> String {
    let mean = if column.mean { ", the mean of all evaluations" } else { "" };
    format!("Here {}{mean}.", triple(column.values))
}

fn product_of(column: &Column) -> String {
    let mean = if column.mean { "The mean of the column's product" } else { "The column's product" };
    format!("{mean} is {} here.", triple(column.values))
}
