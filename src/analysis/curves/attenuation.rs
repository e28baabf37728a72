//! How light weakens with distance: f(d), by the present law and by the others.

use crate::analysis::probe::attenuation_law;
use crate::figure::{Axis, Curve, Dash, Ink, Mark, Plot, PlotKind, short};
use crate::illumination::attenuation_at;
use crate::render::Renderer;
use crate::scene::{Attenuation, Light, Scene};
use crate::text;
use glam::DVec3;

/// Samples of f, which crowd towards the light: there it is steep.
const SAMPLES: u32 = 480;
/// Columns and rows of the pixels among which the nearest and the farthest are sought.
const SEARCH: u32 = 40;
/// How far the axes of f reach beyond the scene's own distances and values.
const BEYOND: f64 = 1.2;
/// Values of f from here on are seen on an axis that ends at 1.
const SEEN_BESIDE_ONE: f64 = 0.04;

/// Whether there is a distance for f to count.
pub fn has_distance(light: &Light) -> bool {
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
            let share = f64::from(i) / f64::from(SAMPLES);
            let d = reach * share * share;
            [d, attenuation_at(light, law, d)]
        };
        (0..=SAMPLES).map(at).collect::<Vec<_>>()
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
