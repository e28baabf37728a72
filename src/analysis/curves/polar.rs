//! The lobe cut by the plane of incidence: a polar plot of I(V), with the vectors.

use super::{degrees, highlight_half_width, short};
use crate::analysis::{Axis, Curve, Dash, Direction, Ink, Plot, PlotKind, ProbeHit, ReflectionLobe};
use crate::scene::{ReflectionModel, Scene};
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;

/// Even steps from −90° to 90°, a half of a degree each.
const EVEN: i32 = 360;
/// Steps in which the highlight's half-width is divided, and how many of them are sampled on each side of R.
const FINE: [i32; 2] = [16, 80];
/// The narrowest half-width that is sampled finely; a mirror's is none at all.
const NARROW: f64 = 1e-4;
/// Out of the plane by less than this, degrees, V counts as in it.
const IN_PLANE: f64 = 0.5;

/// What the point of `hit` reflects of the light of index `light`, for viewers in the plane of N and L; nothing where the
/// light does not reach the surface from the front.
pub fn lobe_plot(scene: &Scene, hit: &ProbeHit, light: usize) -> Option<Plot> {
    let lobe = ReflectionLobe::at(scene, hit, light)?;
    let angles = angles(lobe.mirror_angle(), highlight_half_width(scene).max(NARROW));
    let responses: Vec<_> = angles
        .iter()
        .map(|angle| {
            // R itself, not R to rounding: a mirror sends nothing elsewhere.
            let v = if *angle == lobe.mirror_angle() { lobe.r } else { lobe.in_plane(*angle) };
            (angle.to_degrees(), lobe.towards(v))
        })
        .collect();
    let most = responses.iter().map(|(_, response)| response.total()).fold(0.0, f64::max);
    let specular = if scene.reflection.model == ReflectionModel::Phong { Ink::R } else { Ink::H };
    let total = responses.iter().map(|(angle, response)| [*angle, response.total()]).collect();
    let diffuse = responses.iter().map(|(angle, response)| [*angle, response.diffuse]).collect();
    let at_v = lobe.towards(lobe.v).total();
    let curves = vec![
        Curve { notes: vec![short(most)], ..Curve::new("diffuse + specular", total, specular) },
        Curve {
            dash: Dash::Dashed,
            emphasised: false,
            notes: vec![short(lobe.towards(lobe.n).diffuse)],
            ..Curve::new("diffuse", diffuse, Ink::L)
        },
    ];
    Some(Plot {
        kind: PlotKind::Lobe,
        title: "What the point reflects to every side".into(),
        note: note(&lobe, at_v),
        x: Axis::degrees("angle from N", -90.0, 90.0),
        y: Axis::new("I", 0.0, if most > 0.0 && most.is_finite() { most } else { 1.0 }),
        curves,
        legend: vec!["greatest I".into()],
        marks: vec![],
        directions: directions(&lobe),
        borders: Vec::new(),
        points: vec![],
    })
}

fn note(lobe: &ReflectionLobe, at_v: f64) -> String {
    let out = out_of_plane(lobe, lobe.v);
    let aside = if out.abs() < IN_PLANE { String::new() } else { format!(", {:.0}° out of this plane", out.abs()) };
    let theta = degrees(lobe.mirror_angle());
    format!("in the plane of N and L, θ = {theta}; to the viewer I = {}{aside}", short(at_v))
}

/// Degrees between `vector` and the plane of incidence.
fn out_of_plane(lobe: &ReflectionLobe, vector: DVec3) -> f64 {
    vector.dot(lobe.n.cross(lobe.across)).clamp(-1.0, 1.0).asin().to_degrees()
}

/// N, L and R lie in the plane; V is shown by its shadow on it.
fn directions(lobe: &ReflectionLobe) -> Vec<Direction> {
    let vectors = [("N", lobe.n, Ink::N), ("L", lobe.l, Ink::L), ("R", lobe.r, Ink::R), ("V", lobe.v, Ink::V)];
    let seen = vectors.into_iter().map(|(letter, vector, ink)| {
        let (x, y) = (vector.dot(lobe.across), vector.dot(lobe.n));
        let out = out_of_plane(lobe, vector);
        let length = if out.abs() < IN_PLANE { 1.0 } else { x.hypot(y) };
        Direction { letter, angle: x.atan2(y).to_degrees(), length, ink }
    });
    // Below the surface there is nothing to point at.
    seen.filter(|direction| direction.angle.abs() <= 90.0 && direction.length.is_finite()).collect()
}

/// Angles from N, radians: even, and finer about the mirror direction.
fn angles(mirror: f64, half_width: f64) -> Vec<f64> {
    let mut angles: Vec<f64> =
        (-EVEN / 2..=EVEN / 2).map(|i| 2.0 * FRAC_PI_2 * f64::from(i) / f64::from(EVEN)).collect();
    let step = half_width / f64::from(FINE[0]);
    angles.extend((-FINE[1]..=FINE[1]).map(|i| mirror + step * f64::from(i)).filter(|angle| angle.abs() < FRAC_PI_2));
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    angles
}
