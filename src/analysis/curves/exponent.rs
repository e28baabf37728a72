//! The family cosⁿ φ: how the exponent narrows the highlight.

use super::{degrees, short};
use crate::analysis::{Axis, Curve, Dash, Ink, Mark, Plot, PlotKind, Tag};
use crate::illumination::half_width;
use crate::scene::{Distribution, ReflectionModel, Scene};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// The exponents that the course plots.
pub const COURSE: [f64; 4] = [5.0, 15.0, 45.0, 1005.0];

/// Even steps over the whole range, a half of a degree each.
const EVEN: i32 = 180;
/// Steps in which a lobe's half-width is divided, and how many of them are sampled on each side.
const FINE: [i32; 2] = [12, 60];
/// Heights at which the course's curves carry their names: where there is room between one curve and the next.
const TAGS: [f64; 4] = [0.44, 0.36, 0.28, 0.05];

/// The present falling of the highlight with φ, beside the course's exponents; `phi` is the probe's, radians.
///
/// For Cook and Torrance's model, which has no exponent, the present curve is the distribution of its microfacets, D(φ)/D(0).
pub fn exponent_plot(scene: &Scene, phi: Option<f64>) -> Plot {
    let falling = Falling::of(scene);
    let others = COURSE.into_iter().filter(|n| !matches!(falling, Falling::Power(own) if own == *n));
    let grid = grid(&[COURSE.as_slice(), &[falling.like_power()]].concat());
    let sampled = |falling: &Falling| grid.iter().map(|phi| [phi.to_degrees(), falling.at(*phi)]).collect::<Vec<_>>();
    let ink = if scene.reflection.model == ReflectionModel::Phong { Ink::R } else { Ink::H };
    let mut present = Curve::new(falling.name(), sampled(&falling), ink);
    present.notes = vec![degrees(falling.half_width())];
    let top = present.points.iter().fold(1.0, |top: f64, [_, y]| top.max(*y));
    let marks = phi.filter(|phi| phi.is_finite() && *phi <= FRAC_PI_2).map(|phi| {
        let value = falling.at(phi);
        let label = format!("probe: φ = {}, {}", degrees(phi), short(value));
        Mark { x: phi.to_degrees(), label, values: vec![(0, value)], probe: true }
    });
    let dashes = [Dash::Long, Dash::Dashed, Dash::DashDot, Dash::Dotted];
    let course = others.map(|n| {
        let index = COURSE.iter().position(|other| *other == n).unwrap_or(0);
        let mut curve = Curve::new(format!("n = {n}"), sampled(&Falling::Power(n)), Ink::Reference);
        (curve.notes, curve.emphasised, curve.dash) = (vec![degrees(half_width(n))], false, dashes[index]);
        let left = -TAGS[index].powf(1.0 / n).acos().to_degrees();
        curve.tag = Some(Tag { text: n.to_string(), at: [left, TAGS[index]] });
        curve
    });
    Plot {
        kind: PlotKind::Exponent,
        title: "The highlight falls with φ".into(),
        note: falling.formula(scene.reflection.model).into(),
        x: Axis::degrees(Falling::angle(scene.reflection.model), -90.0, 90.0),
        y: Axis::new(falling.symbol(), 0.0, top),
        curves: std::iter::once(present).chain(course).collect(),
        legend: vec!["half-width".into()],
        marks: marks.into_iter().collect(),
        directions: vec![],
        borders: Vec::new(),
        points: vec![],
    }
}

/// The angle between V and the middle of the highlight at which the specular term has fallen to about a half, radians:
/// exact for Phong's model, and in the plane of incidence for those that measure N·H, where H turns half as fast as V.
pub fn highlight_half_width(scene: &Scene) -> f64 {
    let own = Falling::of(scene).half_width();
    if scene.reflection.model == ReflectionModel::Phong { own } else { 2.0 * own }
}

/// How the highlight falls with φ.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Falling {
    Power(f64),
    Beckmann(f64),
    Ggx(f64),
}

impl Falling {
    fn of(scene: &Scene) -> Self {
        let m = scene.material.roughness;
        match (scene.reflection.model, scene.reflection.distribution) {
            (ReflectionModel::CookTorrance, Distribution::Beckmann) => Self::Beckmann(m),
            (ReflectionModel::CookTorrance, Distribution::Ggx) => Self::Ggx(m),
            _ => Self::Power(scene.material.n),
        }
    }

    /// 1 at φ = 0, 0 beyond a right angle.
    fn at(self, phi: f64) -> f64 {
        // cos 90° is 6·10⁻¹⁷ in double precision.
        let cosine = if phi.abs() >= FRAC_PI_2 - 1e-15 { 0.0 } else { phi.cos() };
        match self {
            Self::Power(n) if n.is_infinite() => f64::from(u8::from(phi == 0.0)),
            Self::Power(n) => cosine.powf(n),
            Self::Beckmann(_) | Self::Ggx(_) if cosine == 0.0 => 0.0,
            Self::Beckmann(m) => (-(phi.tan() / m).powi(2)).exp() / cosine.powi(4),
            Self::Ggx(a) => (a * a / (a * a * cosine * cosine + phi.sin().powi(2))).powi(2),
        }
    }

    /// Where it has fallen to one half for good, radians.
    fn half_width(self) -> f64 {
        let (Self::Beckmann(_) | Self::Ggx(_)) = self else { return half_width(self.like_power()) };
        // Above its half before, below after: a very rough Beckmann surface first rises.
        let (mut above, mut below) = (0.0, FRAC_PI_2);
        for _ in 0..60 {
            let middle = 0.5 * (above + below);
            if self.at(middle) > 0.5 { above = middle } else { below = middle }
        }
        0.5 * (above + below)
    }

    /// The exponent whose samples suit it.
    fn like_power(self) -> f64 {
        match self {
            Self::Power(n) => n,
            Self::Beckmann(m) | Self::Ggx(m) => SQRT_2 / (m * m),
        }
    }

    fn name(self) -> String {
        match self {
            Self::Power(n) if n.is_infinite() => "n = ∞, now".into(),
            Self::Power(n) => format!("n = {}, now", short_exponent(n)),
            Self::Beckmann(m) => format!("m = {}, now", short(m)),
            Self::Ggx(a) => format!("α = {}, now", short(a)),
        }
    }

    fn symbol(self) -> &'static str {
        if matches!(self, Self::Power(_)) { "cosⁿ φ" } else { "D(φ)/D(0)" }
    }

    fn formula(self, model: ReflectionModel) -> &'static str {
        match (self, model) {
            (Self::Power(_), ReflectionModel::Phong) => "(R·V)ⁿ = cosⁿ φ",
            (Self::Power(_), _) => "(N·H)ⁿ = cosⁿ φ",
            (Self::Beckmann(_), _) => "Beckmann’s D = exp(−tan² φ/m²)/(m² cos⁴ φ); beside it cosⁿ φ",
            (Self::Ggx(_), _) => "D = α²/(α² cos² φ + sin² φ)² (GGX); beside it cosⁿ φ",
        }
    }

    fn angle(model: ReflectionModel) -> &'static str {
        if model == ReflectionModel::Phong { "φ, between R and V" } else { "φ, between N and H" }
    }
}

/// Whole exponents without decimals.
fn short_exponent(n: f64) -> String {
    if n.fract() == 0.0 && n < 1e6 { n.to_string() } else { short(n) }
}

/// Angles from −90° to 90°, radians: even, and finer within each exponent's lobe.
fn grid(exponents: &[f64]) -> Vec<f64> {
    let mut half: Vec<f64> = (0..=EVEN).map(|i| FRAC_PI_2 * f64::from(i) / f64::from(EVEN)).collect();
    for n in exponents {
        let step = half_width(*n) / f64::from(FINE[0]);
        half.extend((1..=FINE[1]).map(|i| step * f64::from(i)).filter(|phi| *phi < FRAC_PI_2));
    }
    half.sort_by(f64::total_cmp);
    half.dedup();
    half.iter().rev().filter(|phi| **phi > 0.0).map(|phi| -phi).chain(half.iter().copied()).collect()
}
