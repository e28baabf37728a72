//! Reflectance of a surface at each angle of incidence: W(θ), of the current substance and of others.

use super::highlight::{cosine, degrees, specular_ink};
use crate::analysis::perception::luminance;
use crate::figure::{Axis, Curve, Dash, Ink, Mark, Plot, PlotKind, Tag, short};
use crate::illumination::Index;
use crate::scene::{Reflectance, ReflectionModel, Rgb, Scene};
use crate::text;
use std::f64::consts::FRAC_PI_2;

/// Number of samples of W; they crowd near 90°, where W is steep.
const SAMPLES: u32 = 360;
/// Angles at which the legend of W reads the curves, degrees.
pub const READ_AT: [f64; 3] = [0.0, 45.0, 80.0];

/// Plots W(θ), the fraction of light reflected, by the angle of incidence; `incidence` is the probe's, radians.
pub fn reflectance_plot(scene: &Scene, incidence: Option<f64>) -> Plot {
    let index = Index::of(&scene.material);
    let w = |theta: f64| index.map_or(Rgb::ONE, |index| index.reflectance(cosine(theta)));
    let thetas = (0..=SAMPLES).map(|i| {
        let left = 1.0 - f64::from(i) / f64::from(SAMPLES);
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
            let (probe, texts) = (text!("point-mark-probe"), texts.join(", "));
            let label = format!("{probe}: W({}) = {texts}", degrees(theta));
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
    let note = reflectance_note(scene, index);
    Plot {
        legend: READ_AT.map(|angle| format!("W({angle}°)")).to_vec(),
        marks: marks.into_iter().collect(),
        ..Plot::new(PlotKind::Reflectance, title, note, axes, curves)
    }
}

/// Reflectance, key, index of refraction, dash, and the place of the curve's name: degrees, and height above it.
type Substance = (Reflectance, &'static str, Option<Index>, Dash, [f64; 2]);

/// The substances that are plotted beside the current one.
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

/// Returns the name of a substance.
fn substance(reflectance: Reflectance) -> &'static str {
    match reflectance {
        Reflectance::Constant => text!("point-constant"),
        Reflectance::Glass => text!("point-glass"),
        Reflectance::Silver => text!("point-silver"),
        Reflectance::Gold => text!("point-gold"),
        Reflectance::Custom => text!("point-custom"),
    }
}

/// Describes the index of refraction and the angle that θ stands for.
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
