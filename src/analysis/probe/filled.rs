//! The equation filled in at one pixel: every term with this pixel's numbers, adding up to the stored pixel.
//!
//! The report and the window lay out what is said here. A formula is a string with its letters in braces: `{Kd}` is a
//! letter, `{n}` a raised one, `{^40}` raises a number and `{=0.61}` is a result.

use super::letters::{Tone, exponent, specular_vector};
use super::products::{Here, LightHere, Product, TermColumn};
use super::{LightTerms, ZeroCause};
use crate::analysis::luminance;
use crate::figure::palette::Vector;
use crate::figure::{raised, short};
use crate::illumination::attenuation_at;
use crate::render::srgb;
use crate::scene::{
    Attenuation, CuedBy, DepthCueing, Encoding, FlatAt, LightKind, Overflow, Reflectance,
    ReflectionModel, Rgb, ShadingMode, Through, View,
};
use crate::text;
use glam::DVec3;

/// A normal whose length differs from 1 by more than this has not been made a unit vector.
const UNIT: f64 = 1e-6;
/// Below this a number with four decimals has lost its digits and is written with a power of ten; from `LARGE` on it is too
/// long to be written out.
const SMALL: f64 = 5e-4;
const LARGE: f64 = 1e5;

/// A piece of the filled-in equation.
#[derive(Clone, Debug, PartialEq)]
pub enum FilledPart {
    /// A remark, a sentence or two.
    Note(String),
    /// Where the equation is evaluated, if not once at the pixel.
    Evaluated(String),
    /// A line of letters.
    Formula(String),
    /// The name of a term, and its share of the pixel's luminance.
    Heading {
        /// The term's name.
        name: &'static str,
        /// The term's colour.
        tone: Tone,
        /// Its share, in percent; none where the pixel is black.
        share: Option<String>,
    },
    /// A product, factor by factor.
    Product {
        /// What it makes.
        name: String,
        /// Its columns.
        product: Product,
        /// The colour of its letters.
        letters: Tone,
        /// The colour of its value.
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
    /// + or =, or nothing.
    pub sign: &'static str,
    /// What is added.
    pub name: String,
    /// A formula that stands for the name; empty for none.
    pub letters: &'static str,
    /// What it comes to.
    pub value: LineValue,
    /// The colour of its value.
    pub tone: Tone,
    /// The light that it is about.
    pub light: Option<usize>,
    /// What the line is made of.
    pub parts: Vec<FilledPart>,
}

/// What a line comes to.
#[derive(Clone, Debug, PartialEq)]
pub enum LineValue {
    /// Red, green and blue, as they are written.
    Channels([String; 3]),
    /// Why there is no number, in a phrase.
    Words(String),
}

impl LineValue {
    fn sum(value: Rgb) -> Self {
        Self::Channels(value.to_array().map(digits))
    }

    /// In a phrase.
    pub fn words(&self) -> String {
        match self {
            Self::Channels([red, green, blue]) => in_channels([red, green, blue]),
            Self::Words(words) => words.clone(),
        }
    }
}

/// What one term has in the pixel's brightness.
#[derive(Clone, Debug, PartialEq)]
pub struct Share {
    /// What the term is called.
    pub name: String,
    /// Where the full name does not fit.
    pub short: String,
    /// The term's colour.
    pub tone: Tone,
    /// Luminance, as it enters the pixel.
    pub weight: f64,
}

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
    /// The whole formula, from the ambient term to the stored pixel.
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
        let (name, value) = if self.hit.bounced {
            (text!("point-bounce"), Tone::Weak)
        } else {
            (text!("point-ambient"), Tone::Strong)
        };
        let note = text!("point-bounce-note");
        let mut parts = Vec::from_iter(self.hit.bounced.then(|| FilledPart::Note(note.into())));
        let (name, product) = (name.to_owned(), self.ambient());
        parts.push(FilledPart::Product {
            name: name.clone(),
            product,
            letters: Tone::Plain,
            value,
        });
        FilledLine {
            parts,
            ..line("", name, LineValue::sum(self.hit.ambient), Tone::Strong)
        }
    }

    /// What comes through the surface, mixed with what it reflects; nothing where it is opaque.
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
        // Snell's law with this pixel's angles: that of the line of sight, which V is not with a viewer at infinity, and that of T.
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
        let (name, tone) = (text!("point-transparency").to_owned(), Tone::Of(Vector::T));
        let table = FilledPart::Product {
            name: name.clone(),
            product,
            letters: tone,
            value: tone,
        };
        let parts = vec![FilledPart::Note(snell), table];
        Some(FilledLine {
            parts,
            ..line("", name, LineValue::Words(words), tone)
        })
    }

    /// What depth cueing leaves of the intensity, and what takes the place of the rest; nothing where there is none.
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
        let number = |value: f64, decimals| fixed(value, decimals);
        let scale = number(s0, 3);
        let found = if self.fades_at_points() {
            text!("point-cue-at-points", s0 = scale)
        } else if cueing.by == CuedBy::Vertex && self.scene.shading.mode != ShadingMode::Exact {
            let own = number(cueing.scale_at(self.hit.depth), 3);
            text!("point-cue-interpolated", s0 = scale, own = own)
        } else {
            text!(
                "point-cue-at-pixel",
                s0 = scale,
                front = number(*front, 2),
                back = number(*back, 2),
                front_scale = number(*front_scale, 2),
                back_scale = number(*back_scale, 2)
            )
        };
        let name = text!("point-depth-cueing").to_owned();
        let table = FilledPart::Product {
            name: name.clone(),
            product,
            letters: Tone::Plain,
            value: Tone::Strong,
        };
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

    /// From the sum to the stored pixel: what is above 1, the encoding, the rounding.
    fn stored_lines(self) -> Vec<FilledPart> {
        let (hit, display) = (self.hit, &self.scene.display);
        let step =
            |name: &str, value: LineValue| FilledPart::Line(line("", name, value, Tone::Plain));
        let (mut parts, mut shown) = (Vec::new(), Some(hit.sum.max(Rgb::ZERO)));
        match display.overflow {
            Overflow::Clamp if hit.sum.max_element() > 1.0 => {
                shown = shown.map(|sum| sum.min(Rgb::ONE));
                parts.push(step(
                    text!("point-clamped"),
                    LineValue::sum(shown.unwrap_or_default()),
                ));
            }
            Overflow::Mark if hit.sum.max_element() > 1.0 => {
                shown = None;
                parts.push(FilledPart::Note(text!("point-hatched").into()));
            }
            Overflow::Scale if hit.divisor > 1.0 => {
                shown = shown.map(|sum| sum / hit.divisor);
                let divisor = format!("{:.3}", hit.divisor);
                let note = text!("point-divided", divisor = divisor);
                let scaled = step(
                    text!("point-scaled"),
                    LineValue::sum(shown.unwrap_or_default()),
                );
                parts.extend([FilledPart::Note(note), scaled]);
            }
            Overflow::Clamp | Overflow::Mark | Overflow::Scale => {}
        }
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
        parts.push(FilledPart::Line(line(
            "=",
            text!("point-stored"),
            stored,
            Tone::Strong,
        )));
        parts
    }

    /// The terms' parts of the pixel, in the order of the equation.
    pub fn shares(self) -> Vec<Share> {
        let (hit, kt) = (self.hit, self.scene.transparency.kt);
        // What fades at vertices has no s0 of its own for each term: all have that of their sum.
        let left = hit.cue.map_or(1.0, |cue| {
            luminance(cue.kept) / luminance(hit.intensity).max(f64::MIN_POSITIVE)
        });
        let opaque = left
            * if hit.transmission.is_some() {
                1.0 - kt
            } else {
                1.0
            };
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
            parts.push(term(
                text!("point-diffuse"),
                &number,
                Tone::Of(Vector::L),
                light.diffuse,
            ));
            parts.push(term(
                text!("point-specular"),
                &number,
                Tone::Of(specular_vector(self.scene.reflection.model)),
                light.specular,
            ));
        }
        let through = hit
            .transmission
            .map(|through| left * kt * luminance(through.seen));
        parts.extend(
            through.map(|weight| part(text!("point-transmitted"), "", Tone::Of(Vector::T), weight)),
        );
        parts.extend(hit.cue.map(|cue| {
            part(
                text!("point-depth-cueing"),
                "",
                Tone::Weak,
                luminance(cue.veil),
            )
        }));
        parts
    }

    /// The point and the vectors that belong to no light, each with what it is.
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

    /// Where the equation is evaluated, if not at the pixel.
    pub fn places(self) -> Option<&'static str> {
        match (self.scene.shading.mode, self.scene.shading.flat_at) {
            (ShadingMode::Phong | ShadingMode::Exact, _) => None,
            (ShadingMode::Flat, FlatAt::Centre) => Some(text!("point-over-centre")),
            (ShadingMode::Flat, FlatAt::ProvokingVertex) => Some(text!("point-over-first-vertex")),
            _ => Some(text!("point-over-vertices")),
        }
    }
}

impl LightHere<'_> {
    /// The light's part of the sum.
    fn line(self, shares: &[Share]) -> FilledLine {
        let (terms, name) = (self.terms, self.source.name.trim());
        let number = self.index + 1;
        let name = if name.is_empty() {
            text!("point-light", number = number)
        } else {
            format!("{number} {name}")
        };
        let silent = terms
            .why_nothing_in_short()
            .map(|why| LineValue::Words(why.into()));
        let tone = if silent.is_some() {
            Tone::Weak
        } else {
            Tone::Strong
        };
        let value = silent.unwrap_or_else(|| LineValue::sum(terms.diffuse + terms.specular));
        let parts = match terms.why_nothing() {
            Some(why) => vec![FilledPart::Note(text!(
                "point-light-adds-nothing",
                why = why
            ))],
            None => self.parts(shares),
        };
        FilledLine {
            light: Some(self.index),
            parts,
            ..line("+", name, value, tone)
        }
    }

    fn parts(self, shares: &[Share]) -> Vec<FilledPart> {
        let (terms, mut parts) = (self.terms, Vec::new());
        let whole: f64 = shares.iter().map(|share| share.weight).sum();
        let one = self.is_one_product();
        if one {
            parts.extend(
                self.attenuates()
                    .then(|| FilledPart::Formula(self.attenuation_formula())),
            );
            let spot = || format!("{{spot}}{}{}", result(terms.spot), text!("point-spot-part"));
            parts
                .extend((self.source.kind == LightKind::Spot).then(|| FilledPart::Formula(spot())));
        } else {
            let points = text!("point-over-samples", count = self.source.samples);
            let points = (self.source.kind == LightKind::Area).then_some(points.as_str());
            let over: Vec<&str> = points.into_iter().chain(self.here.places()).collect();
            parts.push(FilledPart::Evaluated(over.join(text!("point-and"))));
        }
        let told_by_cosine = terms.specular_zero == ZeroCause::MissesViewer.into();
        let diffuse = (
            text!("point-diffuse"),
            Tone::Of(Vector::L),
            terms.why_no_diffuse(),
            self.facing_formula(),
            self.diffuse(),
        );
        let specular = (
            text!("point-specular"),
            Tone::Of(specular_vector(self.here.scene.reflection.model)),
            terms.why_no_specular(),
            self.lobe_formula(),
            self.specular(),
        );
        let own = shares.iter().skip(1 + 2 * self.index);
        for ((name, tone, zero, formula, product), share) in
            [diffuse, specular].into_iter().zip(own)
        {
            parts.push(FilledPart::Heading {
                name,
                tone,
                share: percent(share.weight, whole),
            });
            parts.extend(
                (one && (zero.is_none() || told_by_cosine)).then_some(FilledPart::Formula(formula)),
            );
            parts.push(match zero {
                Some(why) => {
                    FilledPart::Note(text!("point-term-adds-nothing", term = name, why = why))
                }
                None => {
                    let name = format!("{name} {}", self.index + 1);
                    FilledPart::Product {
                        name,
                        product,
                        letters: tone,
                        value: tone,
                    }
                }
            });
        }
        parts
    }

    /// What the letters of the formulas are here, for those that no column has.
    pub fn values(self) -> Vec<(&'static str, String)> {
        let vectors = self.vectors().into_iter().chain(self.here.vectors());
        let mut values: Vec<_> = vectors
            .filter_map(|(vector, _, v)| Some((vector?.letter(), coordinates(v))))
            .collect();
        values.push(("n", exponent(self.here.scene.material.n)));
        if self.attenuates() {
            let d = fixed(self.distance(), 4);
            let by = if self.source.attenuation == Attenuation::Viewer {
                text!("point-by-viewer", d = d)
            } else {
                text!("point-by-light", d = d)
            };
            values.push(("f", by));
        }
        values
    }

    /// The vectors of the light, each with what it is.
    pub fn vectors(self) -> [(Option<Vector>, &'static str, DVec3); 3] {
        let LightTerms { l, r, h, .. } = *self.terms;
        [
            (Some(Vector::L), text!("point-what-l"), l),
            (Some(Vector::R), text!("point-what-r"), r),
            (Some(Vector::H), text!("point-what-h"), h),
        ]
    }

    /// The angles and the factors that come from them: names and values.
    pub fn angles(self) -> Vec<(String, String)> {
        let (scene, hit, terms) = (self.here.scene, self.here.hit, self.terms);
        let (material, phong) = (
            &scene.material,
            scene.reflection.model == ReflectionModel::Phong,
        );
        let degrees = |angle: f64| format!("{:.2}°", angle.to_degrees());
        let between =
            |letter: &str, a: &str, b: &str| text!("point-angle", letter = letter, a = a, b = b);
        let mut rows = vec![(between("θ", "N", "L"), degrees(terms.theta))];
        if phong {
            let alpha = self.facing_normal().angle_between(terms.h);
            rows.push((between("φ", "R", "V"), degrees(terms.phi)));
            rows.push((between("α", "N", "H"), degrees(alpha)));
        } else {
            rows.push((between("φ", "N", "H"), degrees(terms.phi)));
        }
        rows.push(("N·L".into(), fixed(terms.n_dot_l, 4)));
        rows.push(("f".into(), digits(terms.attenuation)));
        if scene.reflection.model == ReflectionModel::CookTorrance {
            rows.push(("m".into(), short(material.roughness)));
        } else {
            rows.push(("n".into(), exponent(material.n)));
        }
        if self.source.kind == LightKind::Spot {
            rows.push(("s".into(), digits(terms.spot)));
        }
        if material.reflectance != Reflectance::Constant {
            let other = if phong { "N" } else { "H" };
            rows.push((between("W(θ)", "L", other), degrees(terms.incidence)));
        }
        if let Some(t) = hit.transmission.and_then(|through| through.t) {
            rows.push((between("θt", "T", "−N"), degrees(to_line(hit.normal, t))));
        }
        let light = || text!("point-light-row").to_owned();
        let hidden = 100.0 * (1.0 - terms.reached);
        if let Some(why) = terms.why_nothing_in_short() {
            rows.push((light(), why.to_owned()));
        } else if scene.shading.shadows {
            let state = if hidden > 0.0 {
                text!("point-part-in-shadow", percent = format!("{hidden:.1}"))
            } else {
                text!("point-in-light").to_owned()
            };
            rows.push((light(), state));
        }
        rows
    }

    /// The distance that f counts, world units.
    fn distance(self) -> f64 {
        let by_viewer = self.source.attenuation == Attenuation::Viewer;
        let from = if by_viewer {
            self.here.scene.camera.eye
        } else {
            self.source.position
        };
        (from - self.here.hit.position).length()
    }

    /// f, with the distance put in.
    fn attenuation_formula(self) -> String {
        let (light, d) = (self.source, self.distance());
        let formula = match light.attenuation {
            Attenuation::Viewer | Attenuation::Light => {
                format!(" = 1/(r + k) = 1/({d:.2} + {:.2})", light.k)
            }
            Attenuation::InverseSquare => format!(" = 1/d² = 1/{d:.2}²"),
            Attenuation::Quadratic if attenuation_at(light, Attenuation::Quadratic, d) < 1.0 => {
                let [c1, c2, c3] = [light.c1, light.c2, light.c3].map(short);
                format!(" = 1/({c1} + {c2}·{d:.2} + {c3}·{d:.2}²)")
            }
            Attenuation::Quadratic | Attenuation::None => {
                text!("point-law-clamped", d = format!("{d:.2}"))
            }
        };
        format!("{{f}}{formula}{}", result(self.terms.attenuation))
    }

    /// N·L as the cosine of θ.
    fn facing_formula(self) -> String {
        let theta = self.terms.theta.to_degrees();
        let sign = if self.turned() { "−" } else { "" };
        // The length of N in front of the cosine, where it is not 1.
        let length = self.here.hit.normal.length();
        let length = if (length - 1.0).abs() > UNIT {
            format!("{length:.3} ")
        } else {
            String::new()
        };
        format!(
            "{sign}{{N}}·{{L}} = {sign}{length}cos {theta:.2}°{}",
            result(self.facing())
        )
    }

    /// S from the cosine of φ.
    fn lobe_formula(self) -> String {
        let model = self.here.scene.reflection.model;
        if model == ReflectionModel::CookTorrance {
            return format!(
                "{{S}} = π {{D}}{{G}} / (4 {{N}}·{{V}}){}",
                result(self.lobe())
            );
        }
        let (letters, cosine, n) = (
            self.lobe_letters(),
            self.lobe_cosine(),
            exponent(self.here.scene.material.n),
        );
        if cosine <= 0.0 {
            let vector = if model == ReflectionModel::Phong {
                "R"
            } else {
                "H"
            };
            return format!(
                "{letters} = 0{}",
                text!("point-points-away", vector = vector)
            );
        }
        // Neither the cosine of a small φ nor a high power of it can be read from four digits; the angle can.
        let power = if (self.here.hit.normal.length() - 1.0).abs() > UNIT {
            format!("{cosine:.4}{{^{n}}}")
        } else {
            format!("cos{{^{n}}} {:.2}°", self.terms.phi.to_degrees())
        };
        format!("{letters} = {power}{}", result(self.lobe()))
    }
}

impl TermColumn {
    /// The factors in letters, side by side.
    pub fn formula(&self) -> String {
        self.factors.concat()
    }

    /// What they come to, in a sentence.
    pub fn words(&self) -> String {
        let values = triple(self.values);
        match (self.factors.len() == 1, self.mean) {
            (true, false) => text!("point-here", values = values),
            (true, true) => text!("point-here-mean", values = values),
            (false, false) => text!("point-here-product", values = values),
            (false, true) => text!("point-here-product-mean", values = values),
        }
    }
}

fn result(value: f64) -> String {
    format!(" = {{={}}}", digits(value))
}

/// The angle between a vector and the normal's line, radians: 0 to a right angle.
fn to_line(normal: DVec3, vector: DVec3) -> f64 {
    let angle = vector.angle_between(normal);
    angle.min(std::f64::consts::PI - angle)
}

/// What `part` is of the whole, in words; nothing where there is no light.
pub fn percent(part: f64, whole: f64) -> Option<String> {
    let share = 100.0 * part / whole;
    (whole > 0.0).then(|| {
        if share > 0.0 && share < 0.1 {
            "< 0.1 %".into()
        } else {
            format!("{share:.1} %")
        }
    })
}

/// A number with four digits behind the point, fewer where it is large; very small and very large ones with a power of ten.
pub fn digits(value: f64) -> String {
    with_decimals(value, decimals(value, 4))
}

/// Numbers with their points below each other. Numbers that somebody has chosen have a few digits and show no more; others
/// show at least three that count, as far as there is room.
pub fn digits_below(values: Rgb) -> [String; 3] {
    let values = values.to_array();
    let is_short = |value: &f64, decimals: i32| {
        let scaled = value * 10f64.powi(decimals);
        value.abs() < 1e3 && (scaled - scaled.round()).abs() < 1e-6
    };
    let short = (2..=4).find(|decimals| values.iter().all(|value| is_short(value, *decimals)));
    let count = short.map_or_else(
        || {
            let needed = |value: &f64| {
                decimals(
                    *value,
                    if (SMALL..0.1).contains(&value.abs()) {
                        4
                    } else {
                        3
                    },
                )
            };
            let room = |value: &f64| decimals(*value, 4);
            values
                .iter()
                .map(needed)
                .max()
                .min(values.iter().map(room).min())
                .unwrap_or(4)
        },
        |decimals| decimals as usize,
    );
    values.map(|value| with_decimals(value, count))
}

/// Three numbers as text; one where they are equal.
fn triple(values: Rgb) -> String {
    let [red, green, blue] = digits_below(values);
    if red == green && green == blue {
        red
    } else {
        in_channels([&red, &green, &blue])
    }
}

fn in_channels([red, green, blue]: [&str; 3]) -> String {
    text!("point-channels", red = red, green = green, blue = blue)
}

/// Decimals behind the point of a number, `most` for one below 10.
fn decimals(value: f64, most: usize) -> usize {
    match value.abs() {
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        _ => most,
    }
}

fn with_decimals(value: f64, decimals: usize) -> String {
    let size = value.abs();
    if value == 0.0 || (SMALL..LARGE).contains(&size) || !size.is_finite() {
        return fixed(value, decimals);
    }
    let text = format!("{value:.1e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    minus(&format!("{digits}×10")) + &raised(power.parse().unwrap_or(0))
}

/// A number with so many decimals, a true minus sign, and none before a 0.
pub fn fixed(value: f64, decimals: usize) -> String {
    if value.is_infinite() {
        return if value > 0.0 { "∞" } else { "−∞" }.into();
    }
    let text = format!("{value:.decimals$}");
    let is_zero = !text.contains(|c: char| ('1'..='9').contains(&c) || c == 'N');
    minus(if is_zero {
        text.trim_start_matches('-')
    } else {
        &text
    })
}

/// A vector with three decimals.
pub fn coordinates(v: DVec3) -> String {
    let [x, y, z] = v.to_array().map(|part| fixed(part, 3));
    format!("({x}, {y}, {z})")
}

fn minus(text: &str) -> String {
    text.replace('-', "−")
}
