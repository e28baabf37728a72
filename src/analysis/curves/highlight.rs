//! Falloff of the highlight with the angle φ between R and V, or α between N and H: the family of powers of its
//! cosine, and the polar lobe of a point.

use crate::analysis::lobe::{ReflectionLobe, Response};
use crate::analysis::probe::{ProbeHit, exponent};
use crate::figure::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Tag, short};
use crate::illumination::half_width;
use crate::scene::{Distribution, ReflectionModel, Scene};
use crate::text::{fixed, text};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// The exponents that the course plots, with their dashes and the heights at which their curves are named.
pub const COURSE: [f64; 4] = [5.0, 15.0, 45.0, 1005.0];
const DASHES: [Dash; 4] = [Dash::Long, Dash::Dashed, Dash::DashDot, Dash::Dotted];
const TAGS: [f64; 4] = [0.44, 0.36, 0.28, 0.05];
/// Number of even steps in a right angle, half a degree each.
const EVEN: i32 = 180;
/// Number of steps per half-width, and of steps sampled on each side: for the lobe, and for the cosine's powers.
pub(super) const FINE: [[i32; 2]; 2] = [[16, 80], [12, 60]];
/// Smallest half-width that is sampled finely; a mirror's is zero.
pub(super) const NARROW: f64 = 1e-4;
/// Largest angle between V and the plane at which V counts as lying in it, degrees.
pub(super) const IN_PLANE: f64 = 0.5;

/// Returns even angles from −90° to 90°, radians, and finer ones about some, each given with its half-width.
pub(super) fn angles(finer: &[(f64, f64)], [parts, count]: [i32; 2]) -> Vec<f64> {
    let mut angles: Vec<f64> = (-EVEN..=EVEN)
        .map(|i| FRAC_PI_2 * f64::from(i) / f64::from(EVEN))
        .collect();
    for (middle, half_width) in finer {
        let step = half_width / f64::from(parts);
        let near = (-count..=count).map(|i| middle + step * f64::from(i));
        angles.extend(near.filter(|angle| angle.abs() < FRAC_PI_2));
    }
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    angles
}

/// Plots the lobe cut by the plane of N and L, with the vectors: the light of index `light` that the point of `hit`
/// reflects to viewers there. Returns none where the light does not reach the surface from the front.
pub fn lobe_plot(scene: &Scene, hit: &ProbeHit, light: usize) -> Option<Plot> {
    let lobe = ReflectionLobe::at(scene, hit, light)?;
    let mirror = lobe.mirror_angle();
    let half_width = lobe_half_width(&lobe, scene).max(NARROW);
    let angles = angles(&[(mirror, half_width)], FINE[0]);
    let response = |angle: f64| {
        // R itself, not R to rounding: a mirror reflects in no other direction.
        let v = if angle == mirror {
            lobe.r
        } else {
            lobe.in_plane(angle)
        };
        (angle.to_degrees(), lobe.towards(v))
    };
    let responses: Vec<(f64, Response)> = angles.into_iter().map(response).collect();
    let points = |of: fn(Response) -> f64| -> Vec<[f64; 2]> {
        let point = |(angle, response): &(f64, Response)| [*angle, of(*response)];
        responses.iter().map(point).collect()
    };
    let total = points(Response::length);
    let most = total.iter().map(|[_, y]| *y).fold(0.0, f64::max);
    let (key, name) = if lobe.is_own_law() {
        ("law", text!("point-own-law"))
    } else {
        ("diffuse + specular", text!("point-both-terms"))
    };
    let mut curves = vec![
        Curve {
            notes: vec![short(most)],
            name: name.to_owned(),
            ..Curve::new(key, total, specular_ink(scene))
        },
        Curve {
            dash: Dash::Dashed,
            emphasised: false,
            notes: vec![short(lobe.towards(lobe.n).diffuse)],
            name: text!("point-diffuse").to_owned(),
            ..Curve::new("diffuse", points(|response| response.diffuse), Ink::L)
        },
    ];
    if lobe.is_own_law() {
        curves.truncate(1);
    }
    let top = if most > 0.0 && most.is_finite() {
        most
    } else {
        1.0
    };
    let axes = [
        Axis::degrees(text!("point-axis-from-normal"), -90.0, 90.0),
        Axis::new("I", 0.0, top),
    ];
    let out = out_of_plane(&lobe, lobe.v).abs();
    let at_v = short(lobe.towards(lobe.v).total());
    let mut note = text!("point-note-lobe", theta = degrees(mirror), intensity = at_v);
    if out >= IN_PLANE {
        note += text!("point-sentence-gap");
        note += &text!("point-note-out-of-plane", angle = format!("{out:.0}°"));
    }
    if responses.iter().any(|(_, response)| response.total() < 0.0) {
        note += text!("point-sentence-gap");
        note += text!("point-note-negative");
    }
    Some(Plot {
        legend: vec![text!("point-legend-greatest").to_owned()],
        directions: directions(&lobe),
        ..Plot::new(PlotKind::Lobe, text!("point-plot-lobe"), note, axes, curves)
    })
}

/// Returns the degrees between `vector` and the plane of incidence.
pub(super) fn out_of_plane(lobe: &ReflectionLobe, vector: DVec3) -> f64 {
    let sine = vector.dot(lobe.n.cross(lobe.across));
    sine.clamp(-1.0, 1.0).asin().to_degrees()
}

/// Returns the directions in the plot. N, L and R lie in the plane; V is represented by its projection onto it.
fn directions(lobe: &ReflectionLobe) -> Vec<Direction> {
    let vectors = [
        ("N", lobe.n, Ink::N),
        ("L", lobe.l, Ink::L),
        ("R", lobe.r, Ink::R),
        ("V", lobe.v, Ink::V),
    ];
    let seen = vectors.into_iter().map(|(letter, vector, ink)| {
        let (x, y) = (vector.dot(lobe.across), vector.dot(lobe.n));
        let length = if out_of_plane(lobe, vector).abs() < IN_PLANE {
            1.0
        } else {
            x.hypot(y)
        };
        Direction {
            letter,
            angle: x.atan2(y).to_degrees(),
            length,
            ink,
        }
    });
    // Directions below the surface are not drawn.
    seen.filter(|direction| direction.angle.abs() <= 90.0 && direction.length.is_finite())
        .collect()
}

/// Plots the falloff of the current highlight with the angle that its model measures, beside the course's exponents;
/// `angle` is the probe's, radians. Cook and Torrance's model, which has no exponent, has the curve D(α)/D(0). Returns none for
/// a law of the scene's own, whose highlight is whatever the formula says.
pub fn exponent_plot(scene: &Scene, angle: Option<f64>) -> Option<Plot> {
    let (falling, model) = (Falling::new(scene), scene.reflection.model);
    let finer: Vec<_> = COURSE
        .into_iter()
        .chain([falling.like_power()])
        .map(|n| (0.0, half_width(n)))
        .collect();
    let grid = angles(&finer, FINE[1]);
    let sampled = |falling: &Falling| {
        grid.iter()
            .map(|angle| [angle.to_degrees(), falling.at(*angle)])
            .collect::<Vec<_>>()
    };
    let (letter, between) = match model {
        ReflectionModel::Formula => return None,
        ReflectionModel::Phong => ("φ", ["R", "V"]),
        ReflectionModel::Blinn | ReflectionModel::CookTorrance => ("α", ["N", "H"]),
    };
    let (name, symbol, formula) = falling.words(letter, between);
    let present = Curve {
        name: text!("point-now", name = &name[..]),
        notes: vec![degrees(falling.half_width())],
        ..Curve::new(name, sampled(&falling), specular_ink(scene))
    };
    let heights = present.points.iter().map(|[_, y]| *y);
    let top = heights.fold(1.0, f64::max);
    let marks = angle
        .filter(|angle| angle.is_finite() && *angle <= FRAC_PI_2)
        .map(|angle| {
            let value = falling.at(angle);
            let probe = text!("point-mark-probe");
            let label = format!("{probe}: {letter} = {}, {}", degrees(angle), short(value));
            Mark {
                x: angle.to_degrees(),
                label,
                values: vec![(0, value)],
                probe: true,
            }
        });
    let mut curves = vec![present];
    for ((n, dash), height) in COURSE.into_iter().zip(DASHES).zip(TAGS) {
        let power = Falling::Power(n);
        if falling != power {
            let left = -height.powf(1.0 / n).acos().to_degrees();
            let tag = Tag {
                text: n.to_string(),
                at: [left, height],
            };
            curves.push(Curve {
                notes: vec![degrees(half_width(n))],
                emphasised: false,
                dash,
                tag: Some(tag),
                ..Curve::new(format!("n = {n}"), sampled(&power), Ink::Reference)
            });
        }
    }
    let [a, b] = between;
    let abscissa = text!("point-axis-lobe", letter = letter, a = a, b = b);
    let title = text!("point-plot-exponent", lobe = &*symbol);
    let axes = [
        Axis::degrees(abscissa, -90.0, 90.0),
        Axis::new(symbol, 0.0, top),
    ];
    Some(Plot {
        legend: vec![text!("point-legend-half-width").to_owned()],
        marks: marks.into_iter().collect(),
        ..Plot::new(PlotKind::Exponent, title, formula, axes, curves)
    })
}

/// Returns the angle between V and the middle of the lobe at which it has fallen to about a half, radians: measured on a lobe
/// of the scene's own law, and else that of the highlight.
pub fn lobe_half_width(lobe: &ReflectionLobe, scene: &Scene) -> f64 {
    if lobe.is_own_law() {
        lobe.half_width()
    } else {
        highlight_half_width(scene)
    }
}

/// Returns the angle between V and the middle of the highlight at which it has fallen to about a half, radians: exact
/// for Phong's model, and in the plane of incidence for those with N·H, where H turns half as fast as V. A law of the scene's
/// own has no highlight of that form; see [`lobe_half_width`].
pub fn highlight_half_width(scene: &Scene) -> f64 {
    let own = Falling::new(scene).half_width();
    if scene.reflection.model == ReflectionModel::Phong {
        own
    } else {
        2.0 * own
    }
}

/// Falloff of the highlight with the angle that its model measures.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Falling {
    Power(f64),
    Beckmann(f64),
    Ggx(f64),
}

impl Falling {
    fn new(scene: &Scene) -> Self {
        let m = scene.material.roughness;
        match (scene.reflection.model, scene.reflection.distribution) {
            (ReflectionModel::CookTorrance, Distribution::Beckmann) => Self::Beckmann(m),
            (ReflectionModel::CookTorrance, Distribution::Ggx) => Self::Ggx(m),
            _ => Self::Power(scene.material.n),
        }
    }

    /// Returns the value at an angle: 1 at 0, 0 beyond a right angle.
    fn at(self, angle: f64) -> f64 {
        let cosine = cosine(angle);
        match self {
            Self::Power(n) if n.is_infinite() => f64::from(u8::from(angle == 0.0)),
            Self::Power(n) => cosine.powf(n),
            Self::Beckmann(_) | Self::Ggx(_) if cosine == 0.0 => 0.0,
            Self::Beckmann(m) => (-(angle.tan() / m).powi(2)).exp() / cosine.powi(4),
            Self::Ggx(m) => (m * m / (m * m * cosine * cosine + angle.sin().powi(2))).powi(2),
        }
    }

    /// Returns the angle beyond which it stays below one half, radians.
    fn half_width(self) -> f64 {
        if let Self::Power(n) = self {
            return half_width(n);
        }
        // Above one half before, below after: a very rough Beckmann surface rises at first.
        let (mut above, mut below) = (0.0, FRAC_PI_2);
        for _ in 0..60 {
            let middle = 0.5 * (above + below);
            if self.at(middle) > 0.5 {
                above = middle;
            } else {
                below = middle;
            }
        }
        0.5 * (above + below)
    }

    /// Returns the exponent whose sampling suits it.
    fn like_power(self) -> f64 {
        match self {
            Self::Power(n) => n,
            Self::Beckmann(m) | Self::Ggx(m) => SQRT_2 / (m * m),
        }
    }

    /// Returns its parameter, the plotted quantity and the formula, in the letter of the angle between two vectors.
    fn words(self, letter: &str, [a, b]: [&str; 2]) -> (String, String, String) {
        let lobe = power(letter);
        let (m, note) = match self {
            Self::Power(n) => {
                let formula = format!("({a}·{b})ⁿ = {lobe}");
                return (format!("n = {}", exponent(n)), lobe, formula);
            }
            Self::Beckmann(m) => (
                m,
                text!(
                    "point-note-distribution",
                    lobe = lobe,
                    name = "Beckmann",
                    formula = format!("D = exp(−tan²{letter}/m²)/(m² cos⁴{letter})")
                ),
            ),
            Self::Ggx(m) => (
                m,
                text!(
                    "point-note-distribution",
                    lobe = lobe,
                    name = "GGX",
                    formula = format!("D = m²/(m² cos²{letter} + sin²{letter})²")
                ),
            ),
        };
        (
            format!("m = {}", short(m)),
            format!("D({letter})/D(0)"),
            note,
        )
    }
}

/// Formats the power of an angle's cosine.
fn power(letter: &str) -> String {
    format!("cosⁿ{letter}")
}

/// Formats an angle in degrees with one decimal.
pub fn degrees(radians: f64) -> String {
    format!("{}°", fixed(radians.to_degrees(), 1))
}

/// Returns the ink of the specular term.
pub fn specular_ink(scene: &Scene) -> Ink {
    if scene.reflection.model == ReflectionModel::Phong {
        Ink::R
    } else {
        Ink::H
    }
}

/// Returns cos θ, and 0 at a right angle, where the cosine is 6·10⁻¹⁷ in double precision.
pub fn cosine(theta: f64) -> f64 {
    if theta.abs() >= FRAC_PI_2 - 1e-15 {
        0.0
    } else {
        theta.cos()
    }
}
