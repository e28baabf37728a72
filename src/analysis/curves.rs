//! The curves of local illumination, sampled in double precision: the family cosⁿ φ, the attenuation f(d), the reflectance
//! W(θ) and the polar lobe.
//!
//! A scene and what was probed in it come in; out go [`Plot`]s, plain data with the scene's own values marked.

use super::perception::luminance;
use super::probe::{attenuation_law, clearest_pixel, exponent, probe};
use super::report::{About, Answer, Part, Report};
use super::{
    Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Probe, ProbeHit, Question,
    ReflectionLobe, Subject, Tag, Watch,
};
pub(crate) use crate::figure::short;
use crate::illumination::{Index, attenuation_at, half_width};
use crate::render::Renderer;
use crate::scene::{Attenuation, Distribution, Light, Reflectance, ReflectionModel, Rgb, Scene};
use crate::text;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::f64::consts::{FRAC_PI_2, SQRT_2};

/// The exponents that the course plots, their dashes, and the heights at which their curves carry their names: where there
/// is room between one curve and the next.
pub const COURSE: [f64; 4] = [5.0, 15.0, 45.0, 1005.0];
const DASHES: [Dash; 4] = [Dash::Long, Dash::Dashed, Dash::DashDot, Dash::Dotted];
const TAGS: [f64; 4] = [0.44, 0.36, 0.28, 0.05];
/// The angles at which the legend of W reads the curves, degrees.
pub const READ_AT: [f64; 3] = [0.0, 45.0, 80.0];
/// Samples of f, which crowd towards the light, and of W, which crowd near 90°: there the curves are steep.
const SAMPLES: [u32; 2] = [480, 360];
/// Columns and rows of the pixels among which the nearest and the farthest are sought.
const SEARCH: u32 = 40;
/// How far the axes of f reach beyond the scene's own distances and values.
const BEYOND: f64 = 1.2;
/// The course's highlight as a function of φ.
const LOBE: &str = "cosⁿφ";
/// Values of f from here on are seen on an axis that ends at 1.
const SEEN_BESIDE_ONE: f64 = 0.04;
/// Even steps of an angle in a right angle, a half of a degree each.
const EVEN: i32 = 180;
/// Steps in which a half-width is divided, and how many of them are sampled on each side: of the lobe, and of cosⁿ φ.
const FINE: [[i32; 2]; 2] = [[16, 80], [12, 60]];
/// The narrowest half-width that is sampled finely; a mirror's is none at all.
const NARROW: f64 = 1e-4;
/// Out of the plane by less than this, degrees, V counts as in it.
const IN_PLANE: f64 = 0.5;

/// The curves of local illumination.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CurvesQuestion {
    /// One plot; otherwise all that the scene has.
    pub kind: Option<PlotKind>,
    /// The pixel whose values are marked; otherwise the clearest one.
    pub pixel: Option<[u32; 2]>,
    /// The light whose attenuation and lobe are plotted; otherwise the first that the point faces.
    pub light: Option<usize>,
}

/// What the curves are of. The plots are made when they are asked for, in the language of the moment.
#[derive(Clone, Debug, Default)]
pub struct Curves {
    /// The pixel whose point the curves belong to.
    pub pixel: [u32; 2],
    /// The light whose attenuation is plotted, by its number from 0.
    pub light: usize,
    /// The plots that there are.
    pub kinds: Vec<PlotKind>,
    hit: Option<ProbeHit>,
    distances: Distances,
}

impl Curves {
    /// The curves that have something to say for `probe`, of a picture of `scene` that `renderer` has drawn, and a light.
    pub fn new(renderer: &Renderer, scene: &Scene, probe: &Probe, light: usize) -> Self {
        let mut curves = Self {
            pixel: probe.pixel,
            light,
            kinds: vec![],
            hit: probe.hit.clone(),
            distances: Distances::default(),
        };
        if let Some(source) = scene.lights.get(light) {
            let position = probe.hit.as_ref().map(|hit| hit.position);
            curves.distances = Distances::seen(renderer, scene, source, position);
        }
        curves.kinds = shown_kinds(scene, light);
        curves.kinds.retain(|kind| {
            *kind != PlotKind::Lobe
                || curves
                    .hit
                    .as_ref()
                    .is_some_and(|hit| ReflectionLobe::at(scene, hit, light).is_some())
        });
        curves
    }

    /// The plots.
    pub fn plots(&self, scene: &Scene) -> Vec<Plot> {
        let several = scene.lights.len() > 1;
        let plots = self.kinds.iter().filter_map(|kind| {
            let mut plot = self.plot(*kind, scene)?;
            if several && matches!(kind, PlotKind::Attenuation | PlotKind::Lobe) {
                plot.title = text!(
                    "point-plot-of-light",
                    title = plot.title,
                    light = self.light + 1
                );
            }
            Some(plot)
        });
        plots.collect()
    }

    fn plot(&self, kind: PlotKind, scene: &Scene) -> Option<Plot> {
        let hit = self.hit.as_ref();
        let terms = hit.and_then(|hit| hit.lights.get(self.light));
        match kind {
            PlotKind::Exponent => Some(exponent_plot(scene, terms.map(|terms| terms.phi))),
            PlotKind::Reflectance => {
                Some(reflectance_plot(scene, terms.map(|terms| terms.incidence)))
            }
            PlotKind::Attenuation => {
                let light = scene.lights.get(self.light)?;
                Some(attenuation_plot(light, &self.distances))
            }
            PlotKind::Lobe => lobe_plot(scene, hit?, self.light),
            _ => None,
        }
    }
}

impl Question for CurvesQuestion {
    type Answer = Curves;

    fn answer(&self, subject: &Subject, _: &dyn Watch<Curves>) -> Result<Curves, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        let probed = match self.pixel {
            Some([x, y]) => probe(&mut renderer, scene, x, y),
            None => clearest_pixel(&mut renderer, scene),
        };
        let (pixel, count) = (probed.pixel, scene.lights.len());
        let light = match self.light {
            Some(light) if light >= count => {
                return Err(if count == 0 {
                    text!("point-error-no-lights", light = light)
                } else {
                    text!("point-error-no-such-light", light = light, last = count - 1)
                });
            }
            Some(light) => light,
            None => {
                let hit = probed.hit.as_ref();
                hit.and_then(|hit| hit.lights.iter().position(|terms| terms.n_dot_l > 0.0))
                    .unwrap_or(0)
            }
        };
        let Some(kind) = self.kind else {
            return Ok(Curves::new(&renderer, scene, &probed, light));
        };
        let mut curves = Curves::new(&renderer, scene, &probed, light);
        curves.kinds = vec![kind];
        if curves.plot(kind, scene).is_some() {
            return Ok(curves);
        }
        let [x, y] = pixel;
        Err(match (kind, &probed.hit) {
            (PlotKind::Lobe, None) => text!("point-error-background", x = x, y = y),
            (PlotKind::Lobe, Some(_)) if light < count => {
                text!("point-error-behind", light = light, x = x, y = y)
            }
            _ => text!("point-error-no-light").to_owned(),
        })
    }
}

impl Answer for Curves {
    fn report(&self, about: &About<'_>) -> Report {
        let [x, y] = self.pixel;
        let mut report = Report::new(text!(
            "point-curves-title",
            scene = about.name,
            x = x,
            y = y
        ));
        for plot in self.plots(about.scene) {
            report.section("").push(Part::Plot(plot.into()));
        }
        report
    }

    fn json(&self, about: &About<'_>) -> Value {
        let plots = self.plots(about.scene);
        json!({ "pixel": self.pixel, "light": self.light, "plots": plots })
    }
}

/// The plot of that kind for `probe`, of a picture of `scene` that `renderer` has drawn, and the light of index `light`.
/// Nothing where there is nothing to plot: no such light, or for the lobe a light that does not reach the point.
pub fn plot(
    kind: PlotKind,
    renderer: &Renderer,
    scene: &Scene,
    probe: &Probe,
    light: usize,
) -> Option<Plot> {
    Curves::new(renderer, scene, probe, light).plot(kind, scene)
}

/// The kinds of plot that have something to say: f only where there is a distance to count.
pub fn shown_kinds(scene: &Scene, light: usize) -> Vec<PlotKind> {
    let shown = |kind: &PlotKind| match kind {
        PlotKind::Attenuation => scene.lights.get(light).is_some_and(has_distance),
        PlotKind::Reflectance | PlotKind::Exponent | PlotKind::Lobe => true,
        _ => false,
    };
    PlotKind::ALL.into_iter().filter(shown).collect()
}

fn has_distance(light: &Light) -> bool {
    light.kind.has_position() || light.attenuation == Attenuation::Viewer
}

/// The law by which a light weakens: a directional one is equally far from everything, so that only the distance to the
/// viewer counts.
fn effective(light: &Light) -> Attenuation {
    if has_distance(light) {
        light.attenuation
    } else {
        Attenuation::None
    }
}

/// An angle in degrees with one decimal.
fn degrees(radians: f64) -> String {
    format!("{:.1}°", radians.to_degrees()).replace('-', "−")
}

/// The ink of what is specular.
fn specular_ink(scene: &Scene) -> Ink {
    if scene.reflection.model == ReflectionModel::Phong {
        Ink::R
    } else {
        Ink::H
    }
}

/// cos θ, 0 at a right angle: there the cosine is 6·10⁻¹⁷ in double precision.
fn cosine(theta: f64) -> f64 {
    if theta.abs() >= FRAC_PI_2 - 1e-15 {
        0.0
    } else {
        theta.cos()
    }
}

/// Angles from −90° to 90°, radians: even, and finer on both sides of some, each of which comes with its half-width.
fn angles(finer: &[(f64, f64)], [parts, count]: [i32; 2]) -> Vec<f64> {
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

/// Distances in a picture, from one light or, where the attenuation counts from there, from the viewer; world units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distances {
    /// The nearest and the farthest point seen.
    pub nearest: Option<f64>,
    /// The distance of the farthest point seen.
    pub farthest: Option<f64>,
    /// The distance of the point that the probe is at.
    pub probe: Option<f64>,
}

impl Distances {
    /// The distances in the picture of `scene` that `renderer` has drawn, to the nearest and the farthest of a grid of
    /// 40 × 40 pixels, and to the `probe`'s point. A directional light is nowhere and has none but those from the viewer.
    pub fn seen(renderer: &Renderer, scene: &Scene, light: &Light, probe: Option<DVec3>) -> Self {
        let from = match light.attenuation {
            Attenuation::Viewer => scene.camera.eye,
            _ if light.kind.has_position() => light.position,
            _ => return Self::default(),
        };
        let distance = |point: DVec3| (point - from).length();
        let [width, height] = [renderer.frame().width, renderer.frame().height];
        let middle = |i: u32, side: u32| {
            (u64::from(2 * i + 1) * u64::from(side) / u64::from(2 * SEARCH)) as u32
        };
        let pixels = (0..SEARCH).flat_map(|y| (0..SEARCH).map(move |x| (x, y)));
        let points =
            pixels.filter_map(|(x, y)| renderer.evaluation(middle(x, width), middle(y, height)));
        // The probe's point is one of those seen.
        let seen = points
            .map(|evaluation| evaluation.position)
            .chain(probe)
            .map(distance);
        let seen: Vec<f64> = seen.filter(|d| d.is_finite()).collect();
        Self {
            nearest: seen.iter().copied().reduce(f64::min),
            farthest: seen.iter().copied().reduce(f64::max),
            probe: probe.map(distance).filter(|d| d.is_finite()),
        }
    }
}

/// The laws of attenuation as functions of a distance, how they are written, and their dashes beside the present one. That
/// of the distance to the viewer is that of the distance to the light.
const LAWS: [(Attenuation, &str, Dash); 4] = [
    (Attenuation::None, "1", Dash::Dotted),
    (Attenuation::Light, "1/(r + k)", Dash::Long),
    (Attenuation::InverseSquare, "1/d²", Dash::Dashed),
    (Attenuation::Quadratic, "1/(c₁ + c₂d + c₃d²)", Dash::DashDot),
];

/// f(d): how light is attenuated with distance, from the light itself to beyond what is seen, by the present law and by the
/// others with this light's constants.
pub fn attenuation_plot(light: &Light, distances: &Distances) -> Plot {
    let attenuation = effective(light);
    let f = |d: f64| attenuation_at(light, attenuation, d);
    let reach = distances
        .farthest
        .or(distances.probe)
        .filter(|d| *d > 0.0)
        .unwrap_or(1.0)
        * BEYOND;
    let points = |law: Attenuation| {
        let at = |i: u32| {
            let share = f64::from(i) / f64::from(SAMPLES[0]);
            let d = reach * share * share;
            [d, attenuation_at(light, law, d)]
        };
        (0..=SAMPLES[0]).map(at).collect::<Vec<_>>()
    };
    // The present law first.
    let mut laws = LAWS;
    laws.sort_by_key(|(law, ..)| *law != own_law(attenuation));
    let curves: Vec<Curve> = laws
        .into_iter()
        .enumerate()
        .map(|(index, (law, name, dash))| {
            let notes = distances
                .probe
                .map(|d| short(attenuation_at(light, law, d)));
            let curve = Curve {
                notes: notes.into_iter().collect(),
                ..Curve::new(name, points(law), Ink::L)
            };
            if index == 0 {
                return Curve {
                    name: text!("point-now", name = name),
                    ..curve
                };
            }
            Curve {
                ink: Ink::Reference,
                dash,
                emphasised: false,
                ..curve
            }
        })
        .collect();
    let marks = [
        (text!("point-mark-nearest"), distances.nearest, false),
        (text!("point-mark-probe"), distances.probe, true),
        (text!("point-mark-farthest"), distances.farthest, false),
    ];
    let marks = marks.into_iter().filter_map(|(name, d, probe)| {
        let d = d?;
        let counted = if probe { curves.len() } else { 1 };
        let values = laws[..counted]
            .iter()
            .enumerate()
            .map(|(index, (law, ..))| (index, attenuation_at(light, *law, d)));
        Some(Mark {
            x: d,
            label: format!("{name}: f({}) = {}", short(d), short(f(d))),
            values: values.collect(),
            probe,
        })
    });
    let marks: Vec<Mark> = marks.collect();
    // Near the light f may rise without bound; the axis ends where the scene's own values do, and at 1 where these are not
    // too small to be seen then.
    let greatest = marks.iter().map(|mark| f(mark.x)).fold(f64::NAN, f64::max);
    let top = if greatest.is_finite() && greatest > 0.0 {
        greatest
    } else {
        f(0.5 * reach)
    };
    let start = f(0.0);
    let top = if start <= 2.0 * top {
        start.max(top)
    } else {
        BEYOND * top
    };
    let top = if top >= SEEN_BESIDE_ONE {
        top.max(1.0)
    } else {
        top
    };
    let symbol = if matches!(attenuation, Attenuation::Viewer | Attenuation::Light) {
        "r"
    } else {
        "d"
    };
    let distance = if attenuation == Attenuation::Viewer {
        text!("point-axis-from-viewer", symbol = symbol)
    } else {
        text!("point-axis-from-light", symbol = symbol)
    };
    let axes = [
        Axis::new(distance, 0.0, reach),
        Axis::new(format!("f({symbol})"), 0.0, top),
    ];
    Plot {
        legend: Vec::from_iter(
            distances
                .probe
                .map(|_| text!("point-legend-at-probe").to_owned()),
        ),
        marks,
        ..Plot::new(
            PlotKind::Attenuation,
            text!("point-plot-attenuation"),
            text!("point-note-laws", law = attenuation_law(light)),
            axes,
            curves,
        )
    }
}

/// The entry of [`LAWS`] that has the values of a law.
fn own_law(law: Attenuation) -> Attenuation {
    if law == Attenuation::Viewer {
        Attenuation::Light
    } else {
        law
    }
}

/// W(θ): the part of the light that the surface reflects, from straight down to grazing; `incidence` is the probe's angle,
/// radians.
pub fn reflectance_plot(scene: &Scene, incidence: Option<f64>) -> Plot {
    let index = Index::of(&scene.material);
    let w = |theta: f64| index.map_or(Rgb::ONE, |index| index.reflectance(cosine(theta)));
    let thetas = (0..=SAMPLES[1]).map(|i| {
        let left = 1.0 - f64::from(i) / f64::from(SAMPLES[1]);
        FRAC_PI_2 * (1.0 - left * left.sqrt())
    });
    let thetas: Vec<f64> = thetas.collect();
    let channels: &[(&str, &str, Dash)] = match index {
        Some(_) => &[
            ("red", text!("point-red"), Dash::Solid),
            ("green", text!("point-green"), Dash::Dashed),
            ("blue", text!("point-blue"), Dash::Dotted),
        ],
        None => &[("constant", text!("point-constant"), Dash::Solid)],
    };
    let sampled = |value: &dyn Fn(f64) -> f64| {
        let at = |theta: &f64| [theta.to_degrees(), value(*theta)];
        let notes = READ_AT.map(|angle| format!("{:.3}", value(angle.to_radians())));
        (thetas.iter().map(at).collect::<Vec<_>>(), notes.to_vec())
    };
    let own = (0u8..).zip(channels).map(|(channel, (key, name, dash))| {
        let (points, notes) = sampled(&|theta| w(theta)[usize::from(channel)]);
        let ink = if index.is_some() {
            Ink::Channel(channel)
        } else {
            specular_ink(scene)
        };
        Curve {
            notes,
            dash: *dash,
            name: text!("point-now", name = *name),
            ..Curve::new(*key, points, ink)
        }
    });
    let present = scene.material.reflectance;
    let others = SUBSTANCES
        .into_iter()
        .filter(|(kind, ..)| *kind != present)
        .map(|(kind, key, other, dash, [at, aside])| {
            let value = |theta: f64| {
                luminance(other.map_or(Rgb::ONE, |index| index.reflectance(cosine(theta))))
            };
            let (points, notes) = sampled(&value);
            let name = substance(kind);
            let tag = Tag {
                text: name.to_owned(),
                at: [at, value(at.to_radians()) + aside],
            };
            Curve {
                notes,
                dash,
                emphasised: false,
                name: name.to_owned(),
                tag: Some(tag),
                ..Curve::new(key, points, Ink::Reference)
            }
        });
    let curves: Vec<Curve> = own.chain(others).collect();
    let marks = incidence
        .filter(|theta| (0.0..=FRAC_PI_2).contains(theta))
        .map(|theta| {
            let values: Vec<f64> = w(theta).to_array()[..channels.len()].to_vec();
            let texts: Vec<String> = values.iter().copied().map(short).collect();
            let probe = text!("point-mark-probe");
            let label = format!("{probe}: W({}) = {}", degrees(theta), texts.join(", "));
            Mark {
                x: theta.to_degrees(),
                label,
                values: values.into_iter().enumerate().collect(),
                probe: true,
            }
        });
    let axes = [
        Axis::degrees(text!("point-axis-theta"), 0.0, 90.0),
        Axis::new("W(θ)", 0.0, 1.0),
    ];
    let title = text!("point-plot-reflectance", substance = substance(present));
    Plot {
        legend: READ_AT.map(|angle| format!("W({angle}°)")).to_vec(),
        marks: marks.into_iter().collect(),
        ..Plot::new(
            PlotKind::Reflectance,
            title,
            reflectance_note(scene, index),
            axes,
            curves,
        )
    }
}

/// A substance: its reflectance, key, index of refraction and dash, and where its curve carries its name: an angle in degrees,
/// and how far above the curve.
type Substance = (Reflectance, &'static str, Option<Index>, Dash, [f64; 2]);

/// The substances that are plotted beside the present one.
const SUBSTANCES: [Substance; 4] = [
    (
        Reflectance::Constant,
        "constant",
        None,
        Dash::Dotted,
        [14.0, -0.02],
    ),
    (
        Reflectance::Glass,
        "glass",
        Some(Index::GLASS),
        Dash::Dashed,
        [40.0, 0.06],
    ),
    (
        Reflectance::Silver,
        "silver",
        Some(Index::SILVER),
        Dash::Long,
        [40.0, -0.03],
    ),
    (
        Reflectance::Gold,
        "gold",
        Some(Index::GOLD),
        Dash::DashDot,
        [40.0, -0.06],
    ),
];

fn substance(reflectance: Reflectance) -> &'static str {
    match reflectance {
        Reflectance::Constant => text!("point-constant"),
        Reflectance::Glass => text!("point-glass"),
        Reflectance::Silver => text!("point-silver"),
        Reflectance::Gold => text!("point-gold"),
        Reflectance::Custom => text!("point-custom"),
    }
}

/// The index of refraction, and which angle θ is.
fn reflectance_note(scene: &Scene, index: Option<Index>) -> String {
    let Some(Index { eta, k }) = index else {
        return text!("point-note-constant").to_owned();
    };
    let list = |values: Rgb| {
        let [r, g, b] = values.to_array().map(short);
        if r == g && g == b {
            r
        } else {
            format!("{r}, {g}, {b}")
        }
    };
    let k = if k == Rgb::ZERO {
        String::new()
    } else {
        format!("; k = {}", list(k))
    };
    let vector = if scene.reflection.model == ReflectionModel::Phong {
        "N"
    } else {
        "H"
    };
    text!(
        "point-note-fresnel",
        index = format!("η = {}{k}", list(eta)),
        vector = vector
    )
}

/// The lobe cut by the plane of incidence, with the vectors: what the point of `hit` reflects of the light of index
/// `light`, for viewers in the plane of N and L. Nothing where the light does not reach the surface from the front.
pub fn lobe_plot(scene: &Scene, hit: &ProbeHit, light: usize) -> Option<Plot> {
    let lobe = ReflectionLobe::at(scene, hit, light)?;
    let mirror = lobe.mirror_angle();
    let angles = angles(
        &[(mirror, highlight_half_width(scene).max(NARROW))],
        FINE[0],
    );
    let responses = angles.into_iter().map(|angle| {
        // R itself, not R to rounding: a mirror sends nothing elsewhere.
        let v = if angle == mirror {
            lobe.r
        } else {
            lobe.in_plane(angle)
        };
        (angle.to_degrees(), lobe.towards(v))
    });
    let responses: Vec<_> = responses.collect();
    let most = responses
        .iter()
        .map(|(_, response)| response.total())
        .fold(0.0, f64::max);
    let total = responses
        .iter()
        .map(|(angle, response)| [*angle, response.total()])
        .collect();
    let diffuse = responses
        .iter()
        .map(|(angle, response)| [*angle, response.diffuse])
        .collect();
    let curves = vec![
        Curve {
            notes: vec![short(most)],
            name: text!("point-both-terms").to_owned(),
            ..Curve::new("diffuse + specular", total, specular_ink(scene))
        },
        Curve {
            dash: Dash::Dashed,
            emphasised: false,
            notes: vec![short(lobe.towards(lobe.n).diffuse)],
            name: text!("point-diffuse").to_owned(),
            ..Curve::new("diffuse", diffuse, Ink::L)
        },
    ];
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
    Some(Plot {
        legend: vec![text!("point-legend-greatest").to_owned()],
        directions: directions(&lobe),
        ..Plot::new(PlotKind::Lobe, text!("point-plot-lobe"), note, axes, curves)
    })
}

/// Degrees between `vector` and the plane of incidence.
fn out_of_plane(lobe: &ReflectionLobe, vector: DVec3) -> f64 {
    vector
        .dot(lobe.n.cross(lobe.across))
        .clamp(-1.0, 1.0)
        .asin()
        .to_degrees()
}

/// N, L and R lie in the plane; V is shown by its shadow on it.
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
    // Below the surface there is nothing to point at.
    seen.filter(|direction| direction.angle.abs() <= 90.0 && direction.length.is_finite())
        .collect()
}

/// The present falling of the highlight with φ, beside the course's exponents; `phi` is the probe's, radians.
///
/// For Cook and Torrance's model, which has no exponent, the present curve is the distribution of its microfacets, D(φ)/D(0).
pub fn exponent_plot(scene: &Scene, phi: Option<f64>) -> Plot {
    let (falling, model) = (Falling::new(scene), scene.reflection.model);
    let finer: Vec<_> = COURSE
        .into_iter()
        .chain([falling.like_power()])
        .map(|n| (0.0, half_width(n)))
        .collect();
    let grid = angles(&finer, FINE[1]);
    let sampled = |falling: &Falling| {
        grid.iter()
            .map(|phi| [phi.to_degrees(), falling.at(*phi)])
            .collect::<Vec<_>>()
    };
    let (name, symbol, formula) = falling.words(model);
    let notes = vec![degrees(falling.half_width())];
    let present = Curve {
        name: text!("point-now", name = &name[..]),
        notes,
        ..Curve::new(name, sampled(&falling), specular_ink(scene))
    };
    let top = present
        .points
        .iter()
        .fold(1.0, |top: f64, [_, y]| top.max(*y));
    let marks = phi
        .filter(|phi| phi.is_finite() && *phi <= FRAC_PI_2)
        .map(|phi| {
            let value = falling.at(phi);
            let probe = text!("point-mark-probe");
            let label = format!("{probe}: φ = {}, {}", degrees(phi), short(value));
            Mark {
                x: phi.to_degrees(),
                label,
                values: vec![(0, value)],
                probe: true,
            }
        });
    let mut curves = vec![present];
    for ((n, dash), height) in COURSE.into_iter().zip(DASHES).zip(TAGS) {
        if falling != Falling::Power(n) {
            let left = -height.powf(1.0 / n).acos().to_degrees();
            curves.push(Curve {
                notes: vec![degrees(half_width(n))],
                emphasised: false,
                dash,
                tag: Some(Tag {
                    text: n.to_string(),
                    at: [left, height],
                }),
                ..Curve::new(
                    format!("n = {n}"),
                    sampled(&Falling::Power(n)),
                    Ink::Reference,
                )
            });
        }
    }
    let angle = if model == ReflectionModel::Phong {
        text!("point-axis-phi", a = "R", b = "V")
    } else {
        text!("point-axis-phi", a = "N", b = "H")
    };
    let axes = [
        Axis::degrees(angle, -90.0, 90.0),
        Axis::new(symbol, 0.0, top),
    ];
    Plot {
        legend: vec![text!("point-legend-half-width").to_owned()],
        marks: marks.into_iter().collect(),
        ..Plot::new(
            PlotKind::Exponent,
            text!("point-plot-exponent", lobe = LOBE),
            formula,
            axes,
            curves,
        )
    }
}

/// The angle between V and the middle of the highlight at which the specular term has fallen to about a half, radians:
/// exact for Phong's model, and in the plane of incidence for those that measure N·H, where H turns half as fast as V.
pub fn highlight_half_width(scene: &Scene) -> f64 {
    let own = Falling::new(scene).half_width();
    if scene.reflection.model == ReflectionModel::Phong {
        own
    } else {
        2.0 * own
    }
}

/// How the highlight falls with φ.
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

    /// 1 at φ = 0, 0 beyond a right angle.
    fn at(self, phi: f64) -> f64 {
        let cosine = cosine(phi);
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
        if let Self::Power(n) = self {
            return half_width(n);
        }
        // Above its half before, below after: a very rough Beckmann surface first rises.
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

    /// The exponent whose samples suit it.
    fn like_power(self) -> f64 {
        match self {
            Self::Power(n) => n,
            Self::Beckmann(m) | Self::Ggx(m) => SQRT_2 / (m * m),
        }
    }

    /// Its parameter, what is plotted, and the formula.
    fn words(self, model: ReflectionModel) -> (String, &'static str, String) {
        let vectors = if model == ReflectionModel::Phong {
            "(R·V)ⁿ = cosⁿφ"
        } else {
            "(N·H)ⁿ = cosⁿφ"
        };
        match self {
            Self::Power(n) => (format!("n = {}", exponent(n)), "cosⁿφ", vectors.to_owned()),
            Self::Beckmann(m) => (
                format!("m = {}", short(m)),
                "D(φ)/D(0)",
                text!(
                    "point-note-distribution",
                    lobe = LOBE,
                    name = "Beckmann",
                    formula = "D = exp(−tan²φ/m²)/(m² cos⁴φ)"
                ),
            ),
            Self::Ggx(a) => (
                format!("α = {}", short(a)),
                "D(φ)/D(0)",
                text!(
                    "point-note-distribution",
                    lobe = LOBE,
                    name = "GGX",
                    formula = "D = α²/(α² cos²φ + sin²φ)²"
                ),
            ),
        }
    }
}
