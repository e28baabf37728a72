//! The equation on top of the controls. Its symbols are the table of contents: pointing at one lights up what controls
//! it, clicking it brings that into view.

use super::palette::{Term, term_text, vector_text};
use super::state::AppState;
use super::symbol::Symbol;
use super::typeset::{Piece, Place, run_ui};
use crate::figure::palette::Vector;
use crate::scene::{Attenuation, CuedBy, Reflectance, ReflectionModel, Rgb, Scene};
use eframe::egui::{Color32, Ui, Visuals, vec2};

/// Size of the equation's letters, points.
const SIZE: f32 = 18.0;

/// The equation as `state`'s scene has it; what it leaves out is pale.
pub fn equation_ui(ui: &mut Ui, state: &mut AppState) {
    let pieces = pieces(&state.shown.scene, ui.visuals());
    let width = ui.available_width();
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing = vec2(0.0, 2.0);
        ui.set_max_width(width);
        ui.horizontal_wrapped(|ui| {
            for (number, group) in pieces.iter().enumerate() {
                let id = ui.scope_id().with(("symbol", number));
                run_ui(ui, state, group, SIZE, Place { id, name: "in the equation" });
            }
        });
    });
}

/// What a scene's equation looks like: the colours of its terms, and what it has.
struct Ink<'a> {
    scene: &'a Scene,
    visuals: &'a Visuals,
    plain: Color32,
    pale: Color32,
}

fn piece(text: &'static str, low: &'static str, symbol: Option<Symbol>, colour: Color32) -> Piece {
    Piece { low: low.into(), symbol, ..Piece::plain(text, colour) }
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
    if scene.depth_cueing.by != CuedBy::Off {
        groups.push(ink.fading());
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
        group.push(piece("", "", Some(Symbol::Exponent), colour).raised("n"));
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

    fn fading(&self) -> Vec<Piece> {
        let letter = |text, low| piece(text, low, Some(Symbol::Depth), self.plain);
        vec![
            self.plain("   seen: "),
            letter("s", "0"),
            self.plain(" I + (1 − "),
            letter("s", "0"),
            self.plain(") "),
            letter("I", "dc"),
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
