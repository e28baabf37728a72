//! A scene's own law over the direction of the viewer.

use super::highlight::{FINE, IN_PLANE, NARROW, angles, degrees, out_of_plane, specular_ink};
use crate::analysis::lobe::ReflectionLobe;
use crate::analysis::perception::luminance;
use crate::analysis::probe::ProbeHit;
use crate::figure::{Axis, Curve, Dash, Ink, Mark, Plot, PlotKind, short};
use crate::scene::{Attenuation, LightKind, Rgb, Scene};
use crate::text::text;

/// Half-widths about R at which the law is sampled more finely, radians, since nothing is known of its highlight.
const SCALES: [f64; 4] = [0.1, 1e-2, 1e-3, NARROW];
/// The channels' names in files, the keys of their names, and their dashes.
const CHANNELS: [(&str, &str, Dash); 3] = [
    ("red", "point-red", Dash::Solid),
    ("green", "point-green", Dash::Dashed),
    ("blue", "point-blue", Dash::Dotted),
];

/// Plots the value of the scene's own law at the point of `hit` and for the light of index `light`, cut by the plane of N and
/// L: one curve, or one for each channel where they differ. Returns none where the light does not reach the surface from
/// the front.
pub fn law_plot(scene: &Scene, hit: &ProbeHit, light: usize) -> Option<Plot> {
    // With f·Ip = 1 the engine's light is the value itself.
    let mut alone = scene.clone();
    let source = alone.lights.get_mut(light)?;
    (source.color, source.attenuation) = (Rgb::ONE, Attenuation::None);
    if source.kind == LightKind::Spot {
        source.kind = LightKind::Point;
    }
    let lobe = ReflectionLobe::at(&alone, hit, light)?;
    let mirror = lobe.mirror_angle();
    let angles = angles(&SCALES.map(|scale| (mirror, scale)), FINE[0]).into_iter();
    let values = angles.map(|angle| {
        let value = lobe.channels_towards(lobe.in_plane(angle));
        (angle.to_degrees(), value)
    });
    let values: Vec<(f64, Rgb)> = values.collect();
    let mut colors = values.iter().map(|(_, value)| *value);
    let is_grey = colors.all(|value| value == Rgb::splat(value.x));
    let points = |channel: usize| -> Vec<[f64; 2]> {
        let of = |(angle, value): &(f64, Rgb)| [*angle, value[channel]];
        values.iter().map(of).collect()
    };
    let curves: Vec<Curve> = if is_grey {
        vec![Curve {
            name: text!("point-own-law").to_owned(),
            ..Curve::new("law", points(0), specular_ink(scene))
        }]
    } else {
        let channels = (0u8..).zip(CHANNELS);
        let curve = |(channel, (key, name, dash)): (u8, (&str, &'static str, Dash))| Curve {
            name: text!(name).to_owned(),
            dash,
            ..Curve::new(key, points(usize::from(channel)), Ink::Channel(channel))
        };
        channels.map(curve).collect()
    };
    let all = values.iter().flat_map(|(_, value)| value.to_array());
    let (low, high) = all.fold((0.0, 0.0), |(low, high): (f64, f64), value| {
        (low.min(value), high.max(value))
    });
    let (low, high) = if Axis::can_span(low, high) {
        (low, high)
    } else {
        (0.0, 1.0)
    };
    let (seen, out) = (lobe.channels_towards(lobe.v), out_of_plane(&lobe, lobe.v));
    let value = short(luminance(seen));
    let theta = degrees(mirror);
    let mut note = text!("point-note-own-law", theta = theta, value = &*value);
    let at = lobe.v.dot(lobe.across).atan2(lobe.v.dot(lobe.n));
    let channels = 0..curves.len();
    let mark = Mark {
        x: at.to_degrees(),
        label: format!("{}: {value}", text!("point-mark-probe")),
        values: channels.map(|channel| (channel, seen[channel])).collect(),
        probe: true,
    };
    let in_plane = out.abs() < IN_PLANE;
    if !in_plane {
        note += text!("point-sentence-gap");
        let angle = format!("{:.0}°", out.abs());
        note += &text!("point-note-out-of-plane", angle = angle);
    }
    let axes = [
        Axis::degrees(text!("point-axis-from-normal"), -90.0, 90.0),
        Axis::new(text!("point-axis-factor"), low, high),
    ];
    let title = text!("point-plot-own-law");
    Some(Plot {
        marks: in_plane.then_some(mark).into_iter().collect(),
        ..Plot::new(PlotKind::Exponent, title, note, axes, curves)
    })
}
