//! Attenuation of light with distance: f(d), by the current law and by the others.

use crate::analysis::probe::attenuation_law;
use crate::figure::{Axis, Curve, Dash, Ink, Mark, Plot, PlotKind, short};
use crate::illumination::attenuation_at;
use crate::render::Renderer;
use crate::scene::{Attenuation, Light, Scene};
use crate::text;
use glam::DVec3;

/// Number of samples of f; they crowd towards the light, where f is steep.
const SAMPLES: u32 = 480;
/// Columns and rows of the pixel grid that is searched for the nearest and the farthest point.
const SEARCH: u32 = 40;
/// Extent of the axes of f relative to the scene's own distances and values.
const BEYOND: f64 = 1.2;
/// Smallest value of f that is visible on an axis that ends at 1.
const SEEN_BESIDE_ONE: f64 = 0.04;

/// Returns whether f has a distance to depend on.
pub fn has_distance(light: &Light) -> bool {
    light.kind.has_position() || light.attenuation == Attenuation::Viewer
}

/// Distances in a picture from one light, or from the viewer where the attenuation counts from there; world units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distances {
    /// Distance of the nearest visible point.
    pub nearest: Option<f64>,
    /// Distance of the farthest visible point.
    pub farthest: Option<f64>,
    /// Distance of the probed point.
    pub probe: Option<f64>,
}

impl Distances {
    /// Finds the distances in the picture that `renderer` has drawn: to the nearest and the farthest of 40 × 40 pixels,
    /// and to the `probe`'s point. A directional light has only distances from the viewer.
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
        let seen =
            pixels.filter_map(|(x, y)| renderer.evaluation(middle(x, width), middle(y, height)));
        let points = seen.map(|evaluation| evaluation.position);
        // The probed point is one of the visible points.
        let distances = points.chain(probe).map(distance);
        let seen: Vec<f64> = distances.filter(|d| d.is_finite()).collect();
        Self {
            nearest: seen.iter().copied().reduce(f64::min),
            farthest: seen.iter().copied().reduce(f64::max),
            probe: probe.map(distance).filter(|d| d.is_finite()),
        }
    }
}

/// The laws of attenuation as functions of a distance, with their formulas and their dashes beside the current one.
const LAWS: [(Attenuation, &str, Dash); 4] = [
    (Attenuation::None, "1", Dash::Dotted),
    (Attenuation::Light, "1/(r + k)", Dash::Long),
    (Attenuation::InverseSquare, "1/d²", Dash::Dashed),
    (Attenuation::Quadratic, "1/(c₁ + c₂d + c₃d²)", Dash::DashDot),
];

/// Plots f(d) from the light to beyond the visible points, by the current law and by the others with its constants.
pub fn attenuation_plot(light: &Light, distances: &Distances) -> Plot {
    // A directional light is equally far from everything: only the distance to the viewer counts.
    let attenuation = if has_distance(light) {
        light.attenuation
    } else {
        Attenuation::None
    };
    let f = |d: f64| attenuation_at(light, attenuation, d);
    let farthest = distances.farthest.or(distances.probe);
    let reach = farthest.filter(|d| *d > 0.0).unwrap_or(1.0) * BEYOND;
    let at = |law: Attenuation, i: u32| {
        let share = f64::from(i) / f64::from(SAMPLES);
        let d = reach * share * share;
        [d, attenuation_at(light, law, d)]
    };
    let points = |law: Attenuation| (0..=SAMPLES).map(|i| at(law, i)).collect::<Vec<_>>();
    // The current law comes first; that of the distance to the viewer has the values of the distance to the light.
    let own = if attenuation == Attenuation::Viewer {
        Attenuation::Light
    } else {
        attenuation
    };
    let mut laws = LAWS;
    laws.sort_by_key(|(law, ..)| *law != own);
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
    let marks = marks.into_iter().filter_map(|(name, x, probe)| {
        let x = x?;
        let label = format!("{name}: f({}) = {}", short(x), short(f(x)));
        let values = laws.iter().map(|(law, ..)| attenuation_at(light, *law, x));
        let values = values.enumerate();
        Some(Mark {
            x,
            label,
            values: values.take(if probe { laws.len() } else { 1 }).collect(),
            probe,
        })
    });
    let marks: Vec<Mark> = marks.collect();
    // Near the light f may grow without bound; the axis ends at the scene's own largest value, or at 1 if those
    // values are large enough to be seen then.
    let max = marks.iter().map(|mark| f(mark.x)).fold(f64::NAN, f64::max);
    let top = if max.is_finite() && max > 0.0 {
        max
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
    let legend = distances
        .probe
        .map(|_| text!("point-legend-at-probe").to_owned());
    let title = text!("point-plot-attenuation");
    let note = text!("point-note-laws", law = attenuation_law(light));
    Plot {
        legend: legend.into_iter().collect(),
        marks,
        ..Plot::new(PlotKind::Attenuation, title, note, axes, curves)
    }
}
