//! How the factors that a light has besides the coefficients are found: distances and angles put into their formulas.

use super::notation::{Notation, Vectors};
use crate::analysis::LightHere;
use crate::app::palette::Term;
use crate::app::row::display;
use crate::app::symbol::Symbol;
use crate::app::typeset::Piece;
use crate::illumination::attenuation_at;
use crate::scene::{Attenuation, Light, LightKind, ReflectionModel};

/// Lines of formulas.
#[derive(Clone, Debug, Default)]
pub struct Working {
    /// How much of the light arrives, for both terms.
    pub arriving: Vec<Vec<Piece>>,
    pub diffuse: Vec<Vec<Piece>>,
    pub specular: Vec<Vec<Piece>>,
}

/// A normal whose length differs from 1 by more than this has not been made a unit vector.
const UNIT: f64 = 1e-6;

/// The lines of one light; none where its terms are sums, which have no factors of their own.
pub fn working(light: LightHere<'_>, vectors: &Vectors, notation: &Notation) -> Working {
    if !light.is_one_product() {
        return Working::default();
    }
    let mut arriving = Vec::new();
    if light.attenuates() {
        arriving.push(attenuation(light, notation));
    }
    if light.source.kind == LightKind::Spot {
        let letter = Piece::symbol("s", "", Symbol::Light, notation.plain());
        let [sign, value] = notation.result(light.terms.spot);
        let meaning = "s: the part of its light that the spot sends this way, by the angle to its axis";
        arriving.push(vec![letter.explained(meaning.to_owned()), sign, value, notation.sign(", the spot's part")]);
    }
    Working {
        arriving,
        diffuse: vec![facing(light, vectors, notation)],
        specular: vec![lobe(light, vectors, notation)],
    }
}

/// f, with the distance put in.
fn attenuation(light: LightHere<'_>, notation: &Notation) -> Vec<Piece> {
    let (source, position) = (light.source, light.here.hit.position);
    let to_light = (source.position - position).length();
    let to_viewer = (light.here.scene.camera.eye - position).length();
    let rational = |r: f64| format!(" = 1/(r + k) = 1/({r:.2} + {:.2})", source.k);
    let (formula, distance) = match source.attenuation {
        Attenuation::Viewer => (rational(to_viewer), ("r to the viewer", to_viewer)),
        Attenuation::Light => (rational(to_light), ("r to the light", to_light)),
        Attenuation::InverseSquare => (format!(" = 1/d² = 1/{to_light:.2}²"), ("d to the light", to_light)),
        Attenuation::Quadratic | Attenuation::None => {
            (quadratic(source, to_light), ("min(1, 1/(c1 + c2·d + c3·d²)), d to the light", to_light))
        }
    };
    let (what, r) = distance;
    let tip = format!("{}.\nHere by {what}, {r:.4} world units.", Symbol::Attenuation.meaning());
    let mut line =
        vec![Piece::symbol("f", "", Symbol::Attenuation, notation.plain()).explained(tip), notation.sign(formula)];
    line.extend(notation.result(light.terms.attenuation));
    line
}

fn quadratic(source: &Light, d: f64) -> String {
    let [c1, c2, c3] = [source.c1, source.c2, source.c3].map(|c| display(c, 3));
    if attenuation_at(source, Attenuation::Quadratic, d) < 1.0 {
        format!(" = 1/({c1} + {c2}·{d:.2} + {c3}·{d:.2}²)")
    } else {
        format!(", at most 1 (d = {d:.2})")
    }
}

/// N·L as the cosine of θ.
fn facing(light: LightHere<'_>, vectors: &Vectors, notation: &Notation) -> Vec<Piece> {
    let theta = light.terms.theta.to_degrees();
    let mut line = notation.facing(vectors);
    // Without its brackets.
    line.remove(0);
    line.pop();
    if light.turned() {
        line.insert(0, notation.sign("−"));
    }
    let sign = if light.turned() { "−" } else { "" };
    line.push(notation.sign(format!(" = {sign}{}cos {theta:.2}°", length(vectors))));
    line.extend(notation.result(light.facing()));
    line
}

/// The length of N in front of a cosine, where it is not 1.
fn length(vectors: &Vectors) -> String {
    let length = vectors.n.length();
    if (length - 1.0).abs() > UNIT { format!("{length:.3} ") } else { String::new() }
}

/// S from the cosine of φ.
fn lobe(light: LightHere<'_>, vectors: &Vectors, notation: &Notation) -> Vec<Piece> {
    let colour = notation.term(Term::Specular);
    let model = light.here.scene.reflection.model;
    if model == ReflectionModel::CookTorrance {
        let mut line = notation.microfacets(vectors, colour);
        line.extend(notation.result(light.lobe()));
        return line;
    }
    let mut line = notation.lobe(vectors, colour, "n");
    let cosine = light.lobe_cosine();
    if cosine <= 0.0 {
        let away = if model == ReflectionModel::Phong { " = 0: R points away" } else { " = 0: H points away" };
        line.push(notation.sign(away));
        return line;
    }
    // Neither the cosine of a small φ nor a high power of it can be read from four digits; the angle can.
    let phi = light.terms.phi.to_degrees();
    line.push(notation.sign(" = "));
    if (vectors.n.length() - 1.0).abs() > UNIT {
        line.push(notation.sign(format!("{cosine:.4}")).raised(vectors.exponent.clone()));
    } else {
        line.push(notation.sign("cos").raised(short(&vectors.exponent)));
        line.push(notation.sign(format!(" {phi:.2}°")));
    }
    line.extend(notation.result(light.lobe()));
    line
}

/// Without zeros that end a fraction.
fn short(number: &str) -> String {
    if number.contains('.') && !number.contains('e') {
        number.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        number.to_owned()
    }
}
