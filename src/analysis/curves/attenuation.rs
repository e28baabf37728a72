//! f(d): how a light weakens with distance, with the scene's own distances.

use super::{effective, short};
use crate::analysis::{Axis, Curve, Ink, Mark, Plot, PlotKind};
use crate::illumination::attenuation_at;
use crate::render::Renderer;
use crate::scene::{Attenuation, Light, Scene};
use glam::DVec3;

/// Samples of the curve. They crowd towards the light, where the curve is steep.
const SAMPLES: u32 = 480;
/// Columns and rows of the pixels among which the nearest and the farthest are sought.
const SEARCH: u32 = 40;
/// How far the axes reach beyond the scene's own distances and values.
const BEYOND: f64 = 1.2;

/// Distances in a picture, from one light or, where the attenuation counts from there, from the viewer; world units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distances {
    /// The nearest and the farthest point seen.
    pub nearest: Option<f64>,
    pub farthest: Option<f64>,
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
        let middle = |i: u32, side: u32| (u64::from(2 * i + 1) * u64::from(side) / u64::from(2 * SEARCH)) as u32;
        let pixels = (0..SEARCH).flat_map(|y| (0..SEARCH).map(move |x| (x, y)));
        let points = pixels.filter_map(|(x, y)| renderer.evaluation(middle(x, width), middle(y, height)));
        // The probe's point is one of those seen.
        let seen = points.map(|evaluation| evaluation.position).chain(probe).map(distance);
        let (mut nearest, mut farthest) = (None, None);
        for d in seen.filter(|d| d.is_finite()) {
            nearest = Some(nearest.map_or(d, |least: f64| least.min(d)));
            farthest = Some(farthest.map_or(d, |most: f64| most.max(d)));
        }
        Self { nearest, farthest, probe: probe.map(distance).filter(|d| d.is_finite()) }
    }
}

/// f from the light itself to beyond what is seen.
pub fn attenuation_plot(light: &Light, distances: &Distances) -> Plot {
    let attenuation = effective(light);
    let f = |d: f64| attenuation_at(light, attenuation, d);
    let reach = distances.farthest.or(distances.probe).filter(|d| *d > 0.0).unwrap_or(1.0) * BEYOND;
    let points = (0..=SAMPLES).map(|i| {
        let share = f64::from(i) / f64::from(SAMPLES);
        let d = reach * share * share;
        [d, f(d)]
    });
    let marks = [("nearest", distances.nearest), ("probe", distances.probe), ("farthest", distances.farthest)];
    let marks: Vec<Mark> = marks
        .into_iter()
        .filter_map(|(name, d)| {
            let d = d?;
            let label = format!("{name}: f({}) = {}", short(d), short(f(d)));
            Some(Mark { x: d, label, values: vec![(0, f(d))], probe: name == "probe" })
        })
        .collect();
    // Near the light f may rise without bound; the axis ends where the scene's own values do.
    let greatest = marks.iter().map(|mark| f(mark.x)).fold(f64::NAN, f64::max);
    let top = if greatest.is_finite() && greatest > 0.0 { greatest } else { f(0.5 * reach) };
    let start = f(0.0);
    let top = if start <= 2.0 * top { start.max(top) } else { BEYOND * top };
    let from = if attenuation == Attenuation::Viewer { "viewer" } else { "light" };
    let symbol = if matches!(attenuation, Attenuation::Viewer | Attenuation::Light) { "r" } else { "d" };
    Plot {
        kind: PlotKind::Attenuation,
        title: "A light weakens with distance".into(),
        note: formula(light, attenuation),
        x: Axis::new(format!("{symbol}, distance from the {from}"), 0.0, reach),
        y: Axis::new(format!("f({symbol})"), 0.0, top),
        curves: vec![Curve::new("f", points.collect(), Ink::L)],
        legend: vec![],
        marks,
        directions: vec![],
        borders: Vec::new(),
        points: vec![],
    }
}

/// The law with this light's constants in it.
fn formula(light: &Light, attenuation: Attenuation) -> String {
    let (k, c1, c2, c3) = (short(light.k), short(light.c1), short(light.c2), short(light.c3));
    match attenuation {
        Attenuation::None if !light.kind.has_position() => {
            "f = 1: a directional light is equally far from everything".into()
        }
        Attenuation::None => "f = 1: this light does not weaken".into(),
        Attenuation::Viewer => format!("f = 1/(r + k), k = {k}, r from the viewer"),
        Attenuation::Light => format!("f = 1/(r + k), k = {k}, r from the light"),
        Attenuation::InverseSquare => "f = 1/d²".into(),
        Attenuation::Quadratic => format!("f = min(1, 1/({c1} + {c2} d + {c3} d²))"),
    }
}
