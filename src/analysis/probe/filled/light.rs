//! The contribution of one light to the filled-in equation.

use super::{FilledLine, FilledPart, LineValue, Share, line, to_line};
use crate::analysis::probe::digits::{coordinates, digits, percent};
use crate::analysis::probe::letters::{Tone, exponent, specular_vector};
use crate::analysis::probe::products::LightHere;
use crate::analysis::probe::{LightTerms, ZeroCause};
use crate::figure::palette::Vector;
use crate::figure::short;
use crate::illumination::attenuation_at;
use crate::scene::{Attenuation, LightKind, Reflectance, ReflectionModel};
use crate::text::{fixed, text};
use glam::DVec3;

/// Tolerance for the length of a unit vector; a normal that differs by more has not been normalised.
const UNIT: f64 = 1e-6;

impl LightHere<'_> {
    /// Returns the light's line of the sum, with its parts.
    pub(super) fn line(self, shares: &[Share]) -> FilledLine {
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
            if self.attenuates() {
                parts.push(FilledPart::Formula(self.attenuation_formula()));
            }
            if self.source.kind == LightKind::Spot {
                let (value, part) = (result(terms.spot), text!("point-spot-part"));
                parts.push(FilledPart::Formula(format!("{{spot}}{value}{part}")));
            }
        } else {
            let points = text!("point-over-samples", count = self.source.samples);
            let points = (self.source.kind == LightKind::Area).then_some(points.as_str());
            let over: Vec<&str> = points.into_iter().chain(self.here.places()).collect();
            parts.push(FilledPart::Evaluated(over.join(text!("point-and"))));
        }
        let told_by_cosine = terms.specular_zero == ZeroCause::MissesViewer.into();
        if let (Some(law), Some(product)) = (&terms.law, self.by_law()) {
            let weight = shares.get(1 + self.index).map_or(0.0, |share| share.weight);
            let (name, tone) = (text!("point-own-law"), Tone::Of(Vector::L));
            let share = percent(weight, whole);
            parts.push(FilledPart::Heading { name, tone, share });
            if law.undefined {
                parts.push(FilledPart::Note(text!("point-own-law-undefined").into()));
            }
            parts.extend(law.lines.iter().cloned().map(FilledPart::OfLaw));
            let name = format!("{name} {}", self.index + 1);
            parts.push(FilledPart::product(name, product, [tone; 2]));
            return parts;
        }
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
            if one && (zero.is_none() || told_by_cosine) {
                parts.push(FilledPart::Formula(formula));
            }
            parts.push(match zero {
                Some(why) => {
                    FilledPart::Note(text!("point-term-adds-nothing", term = name, why = why))
                }
                None => {
                    FilledPart::product(format!("{name} {}", self.index + 1), product, [tone; 2])
                }
            });
        }
        parts
    }

    /// Returns the values of those letters of the formulas that no column has.
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

    /// Returns the vectors of the light, each with its description.
    pub fn vectors(self) -> [(Option<Vector>, &'static str, DVec3); 3] {
        let LightTerms { l, r, h, .. } = *self.terms;
        [
            (Some(Vector::L), text!("point-what-l"), l),
            (Some(Vector::R), text!("point-what-r"), r),
            (Some(Vector::H), text!("point-what-h"), h),
        ]
    }

    /// Returns the angles and the factors that follow from them: names and values.
    pub fn angles(self) -> Vec<(String, String)> {
        let (scene, hit, terms) = (self.here.scene, self.here.hit, self.terms);
        let material = &scene.material;
        let degrees = |angle: f64| format!("{:.2}°", angle.to_degrees());
        let between =
            |letter: &str, a: &str, b: &str| text!("point-angle", letter = letter, a = a, b = b);
        let mut rows = vec![
            (between("θ", "N", "L"), degrees(terms.theta)),
            (between("φ", "R", "V"), degrees(terms.phi)),
            (between("α", "N", "H"), degrees(terms.alpha)),
            ("N·L".into(), fixed(terms.n_dot_l, 4)),
            ("f".into(), digits(terms.attenuation)),
        ];
        if scene.reflection.model == ReflectionModel::CookTorrance {
            rows.push(("m".into(), short(material.roughness)));
        } else {
            rows.push(("n".into(), exponent(material.n)));
        }
        if self.source.kind == LightKind::Spot {
            rows.push(("s".into(), digits(terms.spot)));
        }
        if material.reflectance != Reflectance::Constant {
            let other = if scene.reflection.model == ReflectionModel::Phong {
                "N"
            } else {
                "H"
            };
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

    /// Returns the distance that f depends on, world units.
    fn distance(self) -> f64 {
        let from = if self.source.attenuation == Attenuation::Viewer {
            self.here.scene.camera.eye
        } else {
            self.source.position
        };
        (from - self.here.hit.position).length()
    }

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

    fn lobe_formula(self) -> String {
        let model = self.here.scene.reflection.model;
        if model == ReflectionModel::CookTorrance {
            return format!(
                "{{S}} = π {{D}}{{G}} / (4 {{N}}·{{V}}){}",
                result(self.lobe())
            );
        }
        let (letters, cosine) = (self.lobe_letters(), self.lobe_cosine());
        let n = exponent(self.here.scene.material.n);
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
        // Neither the cosine of a small angle nor a high power of it can be read from four digits; the angle can.
        let power = if (self.here.hit.normal.length() - 1.0).abs() > UNIT {
            format!("{cosine:.4}^{{{n}}}")
        } else {
            let (_, angle) = self.terms.lobe_angle(model);
            format!("cos^{{{n}}} {:.2}°", angle.to_degrees())
        };
        format!("{letters} = {power}{}", result(self.lobe()))
    }
}

fn result(value: f64) -> String {
    format!(" = {{={}}}", digits(value))
}
