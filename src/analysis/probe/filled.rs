//! The equation filled in at one pixel: every term with this pixel's numbers, adding up to the stored pixel.
//!
//! The report and the window lay out these parts. A formula is a string with its letters in braces: `{Kd}` is a
//! letter, `{n}` a superscript one, `{^40}` makes a number a superscript and `{=0.61}` is a result.

mod light;

use super::digits::{coordinates, digits, in_channels, triple};
use super::letters::{Tone, specular_vector};
use super::products::{Here, Product};
use crate::analysis::perception::luminance;
use crate::figure::palette::Vector;
use crate::illumination::{LawLine, LineNumbers};
use crate::render::srgb;
use crate::scene::{
    CuedBy, DepthCueing, Encoding, FlatAt, Overflow, Rgb, ShadingMode, Through, View,
};
use crate::text::{fixed, text};
use glam::DVec3;

/// A piece of the filled-in equation.
#[derive(Clone, Debug, PartialEq)]
#[expect(missing_docs, reason = "the variants tell what their fields are")]
pub enum FilledPart {
    /// A remark, a sentence or two.
    Note(String),
    /// The points at which the equation is evaluated, if not once at the pixel.
    Evaluated(String),
    /// A line of letters.
    Formula(String),
    /// A line of the scene's own law, with its value.
    OfLaw(LawLine),
    /// The name of a term, its colour, and its share of the pixel's luminance in percent; none where the pixel is
    /// black.
    Heading {
        name: &'static str,
        tone: Tone,
        share: Option<String>,
    },
    /// A product, factor by factor: the name of the result, the columns, and the colours of its letters and its value.
    Product {
        name: String,
        product: Product,
        letters: Tone,
        value: Tone,
    },
    /// A line of the sum.
    Line(FilledLine),
    /// The line under a written sum.
    Rule,
}

/// A line of the sum.
#[derive(Clone, Debug, PartialEq)]
pub struct FilledLine {
    /// The sign, + or =, or nothing.
    pub sign: &'static str,
    /// Name of the summand.
    pub name: String,
    /// A formula in place of the name; empty for none.
    pub letters: &'static str,
    /// The value of the line.
    pub value: LineValue,
    /// The colour of its value.
    pub tone: Tone,
    /// The light that the line is about.
    pub light: Option<usize>,
    /// The parts that the line is made of.
    pub parts: Vec<FilledPart>,
}

/// The value of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum LineValue {
    /// Red, green and blue, as text.
    Channels([String; 3]),
    /// The reason why there is no number, in a phrase.
    Words(String),
}

impl FilledPart {
    /// Creates a product with the colours of its letters and of its value.
    fn product(name: impl Into<String>, product: Product, [letters, value]: [Tone; 2]) -> Self {
        Self::Product {
            name: name.into(),
            product,
            letters,
            value,
        }
    }
}

impl LineValue {
    fn sum(value: Rgb) -> Self {
        Self::Channels(value.to_array().map(digits))
    }

    /// Returns the value in a phrase.
    pub fn words(&self) -> String {
        match self {
            Self::Channels([red, green, blue]) => in_channels([red, green, blue]),
            Self::Words(words) => words.clone(),
        }
    }
}

/// Returns the value of a line of a law in words.
pub fn law_words(line: &LawLine) -> String {
    match line.value {
        LineNumbers::Value(value) => triple(value),
        LineNumbers::Vector(v) => coordinates(v),
    }
}

/// Returns a line of a law as it is written, in one line.
pub fn law_text(line: &LawLine) -> String {
    match &line.name {
        Some(name) => format!("{name} = {}", line.formula),
        None => line.formula.clone(),
    }
}

/// The contribution of one term to the pixel's brightness.
#[derive(Clone, Debug, PartialEq)]
pub struct Share {
    /// Name of the term.
    pub name: String,
    /// Short name, for use where the full name does not fit.
    pub short: String,
    /// Colour of the term.
    pub tone: Tone,
    /// Luminance with which it enters the pixel.
    pub weight: f64,
}

/// Creates a line of the sum without letters, light and parts.
fn line(sign: &'static str, name: impl Into<String>, value: LineValue, tone: Tone) -> FilledLine {
    FilledLine {
        sign,
        name: name.into(),
        letters: "",
        value,
        tone,
        light: None,
        parts: vec![],
    }
}

impl Here<'_> {
    /// Returns the whole formula, from the ambient term to the stored pixel.
    pub fn filled(self) -> Vec<FilledPart> {
        let shares = self.shares();
        let mut parts = vec![FilledPart::Line(self.ambient_line())];
        parts.extend(
            self.lights()
                .map(|light| FilledPart::Line(light.line(&shares))),
        );
        parts.push(FilledPart::Rule);
        let sum = |name: &str, letters, value| {
            FilledPart::Line(FilledLine {
                letters,
                ..line("=", name, LineValue::sum(value), Tone::Strong)
            })
        };
        if let Some(through) = self.through_line() {
            parts.extend([
                sum(text!("point-sum-reflected"), "{Irefl}", self.hit.reflected),
                FilledPart::Line(through),
            ]);
        }
        if let Some(fading) = self.fading_line() {
            parts.extend([
                sum(text!("point-sum-before-cueing"), "{I}", self.hit.intensity),
                FilledPart::Line(fading),
            ]);
            parts.push(sum(text!("point-sum-cued"), "", self.hit.sum));
        } else {
            parts.push(sum("I", "{I}", self.hit.sum));
        }
        parts.extend(self.stored_lines());
        parts
    }

    fn ambient_line(self) -> FilledLine {
        let (mut parts, mut name, mut value) = (vec![], text!("point-ambient"), Tone::Strong);
        if self.hit.bounced {
            parts.push(FilledPart::Note(text!("point-bounce-note").into()));
            (name, value) = (text!("point-bounce"), Tone::Weak);
        }
        let tones = [Tone::Plain, value];
        parts.push(FilledPart::product(name, self.ambient(), tones));
        FilledLine {
            parts,
            ..line("", name, LineValue::sum(self.hit.ambient), Tone::Strong)
        }
    }

    /// Returns the line for the light that comes through the surface; none where it is opaque.
    fn through_line(self) -> Option<FilledLine> {
        let (product, through) = (self.mixture()?, self.hit.transmission?);
        let refractions = through.refractions;
        let words = match through.total_reflections {
            0 => text!("point-refractions", refractions = refractions),
            totals => text!(
                "point-refractions-and-totals",
                refractions = refractions,
                totals = totals
            ),
        };
        // Snell's law with this pixel's angles: that of the line of sight, which V is not with a viewer at infinity,
        // and that of T.
        let sight = View::new(&self.scene.camera, self.scene.image.size);
        let view = sight.towards_eye(self.hit.position);
        let (normal, eta) = (self.hit.normal, self.scene.transparency.ior);
        let angle = to_line(normal, view).to_degrees();
        let leaves = view.dot(normal) < 0.0 && self.scene.transparency.through == Through::Solid;
        let degrees = |angle: f64| format!("{angle:.2}°");
        let (v, eta) = (degrees(angle), format!("{eta:.3}"));
        let snell = match through.t.map(|t| degrees(to_line(normal, t).to_degrees())) {
            Some(t) if leaves => text!("point-snell-out", v = v, t = t, eta = eta),
            Some(t) => text!("point-snell-in", v = v, t = t, eta = eta),
            None => text!("point-snell-total", v = v, eta = eta),
        };
        let (name, tone) = (text!("point-transparency"), Tone::Of(Vector::T));
        let table = FilledPart::product(name, product, [tone; 2]);
        let parts = vec![FilledPart::Note(snell), table];
        Some(FilledLine {
            parts,
            ..line("", name, LineValue::Words(words), tone)
        })
    }

    /// Returns the line for depth cueing, if there is any: what is kept of the intensity, and the colour in its place.
    fn fading_line(self) -> Option<FilledLine> {
        let (product, s0) = (self.fading()?, self.hit.cue?.scale);
        let cueing = &self.scene.depth_cueing;
        let DepthCueing {
            front,
            back,
            front_scale,
            back_scale,
            ..
        } = cueing;
        let scale = fixed(s0, 3);
        let found = if self.fades_at_points() {
            text!("point-cue-at-points", s0 = scale)
        } else if cueing.by == CuedBy::Vertex && self.scene.shading.mode != ShadingMode::Exact {
            let own = fixed(cueing.scale_at(self.hit.depth), 3);
            text!("point-cue-interpolated", s0 = scale, own = own)
        } else {
            text!(
                "point-cue-at-pixel",
                s0 = scale,
                front = fixed(*front, 2),
                back = fixed(*back, 2),
                front_scale = fixed(*front_scale, 2),
                back_scale = fixed(*back_scale, 2)
            )
        };
        let name = text!("point-depth-cueing");
        let table = FilledPart::product(name, product, [Tone::Plain, Tone::Strong]);
        let words = text!(
            "point-cue-left",
            percent = format!("{:.1}", 100.0 * s0),
            depth = format!("{:.3}", self.hit.depth)
        );
        let parts = vec![FilledPart::Note(found), table];
        Some(FilledLine {
            parts,
            ..line("", name, LineValue::Words(words), Tone::Strong)
        })
    }

    /// Returns the lines from the sum to the stored pixel: clamping above 1, encoding, rounding.
    fn stored_lines(self) -> Vec<FilledPart> {
        let (hit, display) = (self.hit, &self.scene.display);
        let step =
            |name: &str, value: LineValue| FilledPart::Line(line("", name, value, Tone::Plain));
        let (sum, overflows) = (hit.sum.max(Rgb::ZERO), hit.sum.max_element() > 1.0);
        let mut parts = Vec::new();
        let shown = match display.overflow {
            Overflow::Clamp if overflows => {
                let clamped = sum.min(Rgb::ONE);
                parts.push(step(text!("point-clamped"), LineValue::sum(clamped)));
                Some(clamped)
            }
            Overflow::Mark if overflows => {
                parts.push(FilledPart::Note(text!("point-hatched").into()));
                None
            }
            Overflow::Scale if hit.divisor > 1.0 => {
                let (scaled, divisor) = (sum / hit.divisor, format!("{:.3}", hit.divisor));
                parts.push(FilledPart::Note(text!("point-divided", divisor = divisor)));
                parts.push(step(text!("point-scaled"), LineValue::sum(scaled)));
                Some(scaled)
            }
            Overflow::Clamp | Overflow::Mark | Overflow::Scale => Some(sum),
        };
        if let Some(mut encoded) = shown {
            if display.encoding == Encoding::Srgb {
                encoded = Rgb::from_array(encoded.to_array().map(srgb));
                parts.push(step("sRGB", LineValue::sum(encoded)));
            }
            let codes = encoded
                .to_array()
                .map(|value| format!("{:.1}", 255.0 * value));
            parts.push(step("× 255", LineValue::Channels(codes)));
        }
        let stored = LineValue::Channels(hit.stored.map(|code| code.to_string()));
        let stored = line("=", text!("point-stored"), stored, Tone::Strong);
        parts.push(FilledPart::Line(stored));
        parts
    }

    /// Returns the contributions of the terms to the pixel, in the order of the equation.
    pub fn shares(self) -> Vec<Share> {
        let (hit, kt) = (self.hit, self.scene.transparency.kt);
        // Intensities that fade at vertices have no separate s0 for each term: all have that of their sum.
        let left = hit.cue.map_or(1.0, |cue| {
            luminance(cue.kept) / luminance(hit.intensity).max(f64::MIN_POSITIVE)
        });
        let reflected = if hit.transmission.is_some() {
            1.0 - kt
        } else {
            1.0
        };
        let opaque = left * reflected;
        let part = |name: &str, number: &str, tone, weight: f64| {
            let first = name.chars().next().unwrap_or_default();
            let short = format!("{first}{}", number.trim());
            Share {
                name: format!("{name}{number}"),
                short,
                tone,
                weight,
            }
        };
        let term = |name, number: &str, tone, value| {
            part(name, number, tone, (opaque * luminance(value)).max(0.0))
        };
        let mut parts = vec![term(text!("point-ambient"), "", Tone::Plain, hit.ambient)];
        if hit.bounced {
            text!("point-bounce").clone_into(&mut parts[0].name);
        }
        for (index, light) in hit.lights.iter().enumerate() {
            let number = if hit.lights.len() > 1 {
                format!(" {}", index + 1)
            } else {
                String::new()
            };
            let tone = Tone::Of(Vector::L);
            if light.law.is_some() {
                parts.push(term(text!("point-own-law"), &number, tone, light.diffuse));
                continue;
            }
            parts.push(term(text!("point-diffuse"), &number, tone, light.diffuse));
            let tone = Tone::Of(specular_vector(self.scene.reflection.model));
            parts.push(term(text!("point-specular"), &number, tone, light.specular));
        }
        if let Some(through) = hit.transmission {
            let (name, tone) = (text!("point-transmitted"), Tone::Of(Vector::T));
            parts.push(part(name, "", tone, left * kt * luminance(through.seen)));
        }
        if let Some(cue) = hit.cue {
            let name = text!("point-depth-cueing");
            parts.push(part(name, "", Tone::Weak, luminance(cue.veil)));
        }
        parts
    }

    /// Returns the point and the vectors that belong to no light, each with its description.
    pub fn vectors(self) -> Vec<(Option<Vector>, &'static str, DVec3)> {
        let hit = self.hit;
        let mut rows = vec![
            (None, text!("point-what-position"), hit.position),
            (Some(Vector::N), text!("point-what-n"), hit.normal),
            (Some(Vector::V), text!("point-what-v"), hit.view),
        ];
        let t = hit.transmission.and_then(|through| through.t);
        rows.extend(t.map(|t| (Some(Vector::T), text!("point-what-t"), t)));
        rows
    }

    /// Describes the points at which the equation is evaluated, if not the pixel.
    pub fn places(self) -> Option<&'static str> {
        match (self.scene.shading.mode, self.scene.shading.flat_at) {
            (ShadingMode::Phong | ShadingMode::Exact, _) => None,
            (ShadingMode::Flat, FlatAt::Centre) => Some(text!("point-over-centre")),
            (ShadingMode::Flat, FlatAt::ProvokingVertex) => Some(text!("point-over-first-vertex")),
            _ => Some(text!("point-over-vertices")),
        }
    }
}

/// Returns the angle between a vector and the normal's line, radians: 0 to a right angle.
fn to_line(normal: DVec3, vector: DVec3) -> f64 {
    let angle = vector.angle_between(normal);
    angle.min(std::f64::consts::PI - angle)
}
