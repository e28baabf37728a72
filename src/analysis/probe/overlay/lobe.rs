//! The lobe of reflection about the probed point: a surface whose distance in each direction is the light reflected
//! to a viewer there.
//!
//! The pole of its net is R, where the highlight is: meridians run from R to the horizon, and parallels about R
//! become the horizon. The largest reflection is a little longer than a unit vector, so that R does not cover it.

use crate::analysis::curves::lobe_half_width;
use crate::analysis::lobe::ReflectionLobe;
use crate::analysis::overlay::Sketch;
use crate::figure::Shape;
use crate::figure::palette::Vector;
use crate::scene::{ReflectionModel, Scene};
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;

/// Length of the largest reflection, in unit vectors.
const LENGTH: f64 = 1.3;
/// Number of meridians and of parallels.
const NET: [u32; 2] = [24, 12];
/// Number of chords between neighbouring lines of the net.
const CHORDS: u32 = 4;
/// Parallels within `SKIRT` half-widths of R; the others are evenly spaced from there to the horizon.
const NEAR: u32 = 7;
const SKIRT: f64 = 2.4;
/// Maximum share of the angle to the horizon for the highlight.
const MOST: f64 = 0.6;
/// Number of steps from a point of the surface to the eye at which occlusion is tested.
const MARCH: u32 = 40;
/// Height of a point above the surface where those steps begin, in unit vectors.
const LIFT: f64 = 0.02;
/// Width of the lines, in the width of an arrow.
const WIDTH: f64 = 0.32;
/// Opacity of a line that the lobe itself hides, and of the surface.
const FAINT: [f64; 2] = [0.22, 0.1];

/// Draws the surface of the lobe as a net of lines over a faint skin; nothing where no light is reflected.
pub(super) fn draw(sketch: &Sketch, lobe: &ReflectionLobe, scene: &Scene) -> Vec<Shape> {
    let peak = peak_of(lobe, scene);
    if peak.is_nan() || peak <= 0.0 || !peak.is_finite() {
        return vec![];
    }
    let surface = Surface {
        sketch,
        lobe,
        unit: peak / LENGTH,
        skirt: SKIRT * lobe_half_width(lobe, scene),
    };
    let specular = if scene.reflection.model == ReflectionModel::Phong {
        Vector::R.colour()
    } else {
        Vector::H.colour()
    };
    let [meridians, parallels] = NET;
    // The inside of the silhouette, faintly.
    let mut skin = Vec::new();
    for (i, j) in (0..meridians).flat_map(|i| (0..parallels).map(move |j| (i, j))) {
        let place = |(i, j): (u32, u32)| {
            let direction = surface.direction(i * CHORDS, j * CHORDS);
            direction * surface.reach(direction)
        };
        let corners = sketch.ends([(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(place));
        skin.extend(corners.map(|corners| Shape::area(corners, specular).faded(FAINT[1]).plain()));
    }
    let along = |i| {
        (0..=parallels * CHORDS)
            .map(move |j| (i * CHORDS, j))
            .collect()
    };
    let round = |j| {
        (0..=meridians * CHORDS)
            .map(move |i| (i, j * CHORDS))
            .collect()
    };
    let lines: Vec<Vec<(u32, u32)>> = (0..meridians)
        .map(along)
        .chain((1..=parallels).map(round))
        .collect();
    let (mut hidden, mut shown) = (Vec::new(), Vec::new());
    for line in lines {
        let knots: Vec<Knot> = line.into_iter().map(|(i, j)| surface.knot(i, j)).collect();
        for run in runs(&knots) {
            let Knot { seen, bright, .. } = run[0];
            let points = run.iter().filter_map(|knot| knot.place).collect();
            let colour = if bright { specular } else { Vector::L.colour() };
            let line = Shape::line(points, WIDTH * sketch.style.line, colour);
            if seen {
                shown.push(line);
            } else {
                hidden.push(line.faded(FAINT[0]).plain());
            }
        }
    }
    [skin, hidden, shown].concat()
}

/// Draws the lobe in the plane of incidence, for a sketch that looks across it: the length in each direction is the light
/// reflected to a viewer there.
pub(super) fn draw_section(sketch: &Sketch, lobe: &ReflectionLobe, scene: &Scene) -> Vec<Shape> {
    let unit = peak_of(lobe, scene) / LENGTH;
    if unit.is_nan() || unit <= 0.0 || !unit.is_finite() {
        return vec![];
    }
    let mut angles: Vec<f64> = angles(lobe, scene)
        .filter(|angle| angle.abs() <= FRAC_PI_2)
        .collect();
    angles.sort_by(f64::total_cmp);
    let directions = angles.into_iter().map(|angle| lobe.in_plane(angle));
    let Some(outline) = sketch.ends(directions.map(|v| v * (lobe.towards(v).length() / unit)))
    else {
        return vec![];
    };
    let colour = Vector::L.colour();
    let inside = Shape::area(outline.clone(), colour).faded(2.0 * FAINT[1]);
    let outline = Shape::line(outline, 2.0 * WIDTH * sketch.style.line, colour);
    vec![inside.plain(), outline.plain()]
}

/// Finds the largest reflection, which lies in the plane of incidence.
fn peak_of(lobe: &ReflectionLobe, scene: &Scene) -> f64 {
    let in_plane = angles(lobe, scene).map(|angle| lobe.in_plane(angle));
    in_plane
        .chain([lobe.r])
        .map(|v| lobe.towards(v).total())
        .fold(0.0, f64::max)
}

/// Returns angles from N in the plane of incidence, radians: every degree, and finer ones about the highlight.
fn angles(lobe: &ReflectionLobe, scene: &Scene) -> impl Iterator<Item = f64> {
    let (fine, mirror) = (lobe_half_width(lobe, scene) / 8.0, lobe.mirror_angle());
    let even = (-90..=90).map(|i| f64::from(i).to_radians());
    even.chain((-16..=16).map(move |i| mirror + fine * f64::from(i)))
}

/// A point of the net.
#[derive(Clone, Copy)]
struct Knot {
    place: Option<DVec2>,
    /// True if no part of the lobe hides the point.
    seen: bool,
    /// True if the highlight is brighter there than the diffuse light.
    bright: bool,
}

struct Surface<'a> {
    sketch: &'a Sketch,
    lobe: &'a ReflectionLobe,
    /// Length that represents a unit vector.
    unit: f64,
    /// Angle about R within which the net is finer, radians.
    skirt: f64,
}

impl Surface<'_> {
    /// Returns the direction of a place of the net: `i` chords around R and `j` chords away from it.
    fn direction(&self, i: u32, j: u32) -> DVec3 {
        let [meridians, parallels] = NET;
        let turn = std::f64::consts::TAU * f64::from(i) / f64::from(meridians * CHORDS);
        let (n, r) = (self.lobe.n, self.lobe.r);
        // Perpendicular to R: one in the plane of incidence, one in the surface.
        let level = n.cross(self.lobe.across);
        let rise = level.cross(r);
        let (sine, cosine) = turn.sin_cos();
        let aside = rise * cosine + level * sine;
        // The horizon is where N·(R cos α + aside sin α) = 0.
        let horizon = n.dot(r).atan2(-n.dot(aside));
        let skirt = self.skirt.min(MOST * horizon);
        let step = f64::from(j) / f64::from(CHORDS);
        let (near, all) = (f64::from(NEAR), f64::from(parallels));
        let angle = if step <= near {
            skirt * step / near
        } else {
            skirt + (horizon - skirt) * (step - near) / (all - near)
        };
        let (sine, cosine) = angle.sin_cos();
        let direction = r * cosine + aside * sine;
        // On the horizon itself, rounding must not push the direction below the surface.
        (direction - n * n.dot(direction).min(0.0)).normalize_or(r)
    }

    /// Returns the distance of the surface in a direction, in unit vectors.
    fn reach(&self, direction: DVec3) -> f64 {
        self.lobe.towards(direction).length() / self.unit
    }

    fn knot(&self, i: u32, j: u32) -> Knot {
        let direction = self.direction(i, j);
        let response = self.lobe.towards(direction);
        let point = direction * (response.length() / self.unit);
        Knot {
            place: self.sketch.end(point),
            seen: self.is_seen(point),
            bright: response.specular > response.diffuse,
        }
    }

    /// Returns whether the line from `point` to the eye stays outside the lobe, which is star-shaped.
    fn is_seen(&self, point: DVec3) -> bool {
        let world = self.sketch.position + point * self.sketch.length;
        let towards = self.sketch.view.towards_eye(world);
        (0..MARCH).all(|step| {
            let way = LIFT + 2.0 * LENGTH * f64::from(step) / f64::from(MARCH);
            let place = point + towards * way;
            let far = place.length();
            far >= LENGTH || far >= self.reach(place / far.max(f64::MIN_POSITIVE))
        })
    }
}

/// Returns runs of knots that look alike, each with the first knot of the next, so that lines stay connected.
fn runs(knots: &[Knot]) -> Vec<&[Knot]> {
    let look = |knot: &Knot| (knot.seen, knot.bright);
    let (mut runs, mut start) = (Vec::new(), 0);
    for end in 1..=knots.len() {
        if end == knots.len() || look(&knots[end]) != look(&knots[start]) {
            runs.push(&knots[start..knots.len().min(end + 1)]);
            start = end;
        }
    }
    runs
}
