//! W(θ): the part of the light that the surface reflects, by angle of incidence and per channel.

use super::{degrees, short};
use crate::analysis::{Axis, Curve, Dash, Ink, Mark, Plot, PlotKind};
use crate::illumination::Index;
use crate::scene::{Reflectance, ReflectionModel, Rgb, Scene};
use std::f64::consts::FRAC_PI_2;

/// The angles at which the legend reads the curves, degrees.
pub const READ_AT: [f64; 3] = [0.0, 45.0, 80.0];

/// Samples of each curve. The curves turn upwards near 90°, where the samples crowd.
const SAMPLES: u32 = 360;

/// W from straight down to grazing; `incidence` is the probe's angle, radians.
pub fn reflectance_plot(scene: &Scene, incidence: Option<f64>) -> Plot {
    let index = Index::of(&scene.material);
    let w = |theta: f64| {
        // cos 90° is 6·10⁻¹⁷ in double precision.
        let cosine = if theta >= FRAC_PI_2 - 1e-15 { 0.0 } else { theta.cos() };
        index.map_or(Rgb::ONE, |index| index.reflectance(cosine))
    };
    let thetas = (0..=SAMPLES).map(|i| {
        let left = 1.0 - f64::from(i) / f64::from(SAMPLES);
        FRAC_PI_2 * (1.0 - left * left.sqrt())
    });
    let thetas: Vec<f64> = thetas.collect();
    let channels: &[(&str, Dash)] = match index {
        Some(_) => &[("red", Dash::Solid), ("green", Dash::Dashed), ("blue", Dash::Dotted)],
        None => &[("all channels", Dash::Solid)],
    };
    let curves: Vec<Curve> = (0u8..)
        .zip(channels)
        .map(|(channel, (name, dash))| {
            let value = |theta: f64| w(theta)[usize::from(channel)];
            let ink = if index.is_some() { Ink::Channel(channel) } else { Ink::R };
            let points = thetas.iter().map(|theta| [theta.to_degrees(), value(*theta)]).collect();
            let notes = READ_AT.map(|angle| format!("{:.3}", value(angle.to_radians()))).to_vec();
            Curve { notes, dash: *dash, ..Curve::new(*name, points, ink) }
        })
        .collect();
    let marks = incidence.filter(|theta| (0.0..=FRAC_PI_2).contains(theta)).map(|theta| {
        let values: Vec<f64> = w(theta).to_array()[..curves.len()].to_vec();
        let texts: Vec<String> = values.iter().copied().map(short).collect();
        let label = format!("probe: W({}) = {}", degrees(theta), texts.join(", "));
        Mark { x: theta.to_degrees(), label, values: values.into_iter().enumerate().collect(), probe: true }
    });
    Plot {
        kind: PlotKind::Reflectance,
        title: format!("What {} reflects by angle", substance(scene)),
        note: note(scene, index),
        x: Axis::degrees("θ", 0.0, 90.0),
        y: Axis::new("W(θ)", 0.0, 1.0),
        marks: marks.into_iter().collect(),
        curves,
        legend: READ_AT.map(|angle| format!("W({angle}°)")).to_vec(),
        directions: vec![],
        borders: Vec::new(),
        points: vec![],
    }
}

fn substance(scene: &Scene) -> &'static str {
    match scene.material.reflectance {
        Reflectance::Glass => "glass",
        Reflectance::Silver => "silver",
        Reflectance::Gold => "gold",
        Reflectance::Constant | Reflectance::Custom => "the surface",
    }
}

/// The index, and which angle θ is.
fn note(scene: &Scene, index: Option<Index>) -> String {
    let Some(Index { eta, k }) = index else { return "W = 1: the specular coefficient is constant".into() };
    let between = if scene.reflection.model == ReflectionModel::Phong { "N and L" } else { "H and L" };
    let list = |values: Rgb| {
        let [r, g, b] = values.to_array().map(short);
        if r == g && g == b { r } else { format!("{r}, {g}, {b}") }
    };
    let k = if k == Rgb::ZERO { String::new() } else { format!("; k = {}", list(k)) };
    format!("Fresnel, η = {}{k}; θ between {between}", list(eta))
}
