//! Symbols of the lights: a sun for one that has a position, parallel rays for one that only has a direction.

use crate::analysis::overlay::Sketch;
use crate::figure::palette::Vector;
use crate::figure::{Area, Shape};
use crate::scene::{Light, LightKind, View};
use glam::DVec2;

/// Distance of parallel rays from the picture's middle, in the pane's shorter side.
const RAYS_AT: f64 = 0.4;
/// Length of the rays when they lie in the picture's plane, in text sizes.
const RAYS_LENGTH: f64 = 3.2;
/// Share of their full length below which rays are shown from the front or from behind.
const HEAD_ON: f64 = 0.17;
/// Outer radius of a sun, and reach of the pointer beside one outside the picture, in its disc's radii.
const SUN: [f64; 2] = [1.95, 3.1];

/// Number of lights beyond which only the chosen one is lettered.
pub const LETTERED: usize = 24;

/// A light's symbol in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct LightHandle {
    /// Index of the light in the scene.
    pub light: usize,
    /// The symbol's middle.
    pub pixel: DVec2,
    /// True if the light itself is outside the picture or behind the eye; the symbol then is at the edge.
    pub outside: bool,
}

/// Draws the lights of a scene; `chosen` is drawn larger. Several are numbered from 1.
pub(super) fn draw(
    sketch: &mut Sketch,
    lights: &[Light],
    chosen: Option<usize>,
) -> Vec<LightHandle> {
    let mut handles = Vec::new();
    for (index, light) in lights.iter().enumerate() {
        let size = if chosen == Some(index) { 1.25 } else { 1.0 };
        let radius = 0.4 * sketch.style.text * size;
        let draw = if light.kind == LightKind::Directional {
            draw_rays
        } else {
            draw_sun
        };
        let (pixel, outside) = draw(sketch, light, radius);
        if lights.len() > 1 && (lights.len() <= LETTERED || chosen == Some(index)) {
            let aside = (sketch.view.centre - pixel).normalize_or_zero();
            let clearance = SUN[0] * radius + 0.1 * sketch.style.text;
            let (number, colour) = ((index + 1).to_string(), Vector::L.colour());
            sketch.letter(number, size, colour, pixel, aside, clearance);
        }
        handles.push(LightHandle {
            light: index,
            pixel,
            outside,
        });
    }
    handles
}

/// Draws a sun; returns its position, and whether the light itself is elsewhere.
fn draw_sun(sketch: &mut Sketch, light: &Light, radius: f64) -> (DVec2, bool) {
    let (wanted, behind) = whereabouts(&sketch.view, light, sketch.pane);
    let margin = (SUN[0] * radius).min(0.5 * (sketch.pane.max - sketch.pane.min).min_element());
    let seen = sketch.pane.inset(margin);
    let outside = behind || seen.nearest(wanted) != wanted;
    let pixel = if outside {
        on_edge(sketch, wanted, SUN[1] * radius)
    } else {
        wanted
    };
    let line = 0.7 * sketch.style.line;
    for eighth in 0..8 {
        let way = DVec2::from_angle(f64::from(eighth) * std::f64::consts::FRAC_PI_4);
        let ray = vec![pixel + way * 1.4 * radius, pixel + way * SUN[0] * radius];
        sketch
            .shapes
            .push(Shape::line(ray, line, Vector::L.colour()));
    }
    if outside {
        let way = (wanted - sketch.view.centre).normalize_or_zero();
        let tip = pixel + way * SUN[1] * radius;
        let head = Shape::arrow_head(tip, way, 0.9 * radius, Vector::L.colour());
        sketch.shapes.push(head);
    }
    // The light's hue at full brightness, so that a dim light can still be found.
    let brightest = light.color.max_element();
    let scale = if brightest > 0.0 && brightest.is_finite() {
        255.0 / brightest
    } else {
        0.0
    };
    let hue = light
        .color
        .to_array()
        .map(|channel| (channel * scale).round().clamp(0.0, 255.0) as u8);
    sketch.shapes.push(Shape::disc(pixel, radius, hue));
    sketch
        .shapes
        .push(Shape::ring(pixel, radius, line, Vector::L.colour()).plain());
    (pixel, outside)
}

/// Returns the position of a light in the picture, far out on its side if it is behind the eye, and whether it is.
fn whereabouts(view: &View, light: &Light, pane: Area) -> (DVec2, bool) {
    if let Some((pixel, _)) = view.project(light.position) {
        return (pixel, false);
    }
    let from_eye = light.position - view.eye;
    let aside = DVec2::new(from_eye.dot(view.right), -from_eye.dot(view.up)).try_normalize();
    let far = 2.0 * (pane.max - pane.min).length();
    (view.centre + aside.unwrap_or(DVec2::NEG_Y) * far, true)
}

/// Returns the point at which the line from the pane's middle to `point` comes within `margin` of its edge.
fn on_edge(sketch: &Sketch, point: DVec2, margin: f64) -> DVec2 {
    let centre = sketch.pane.centre();
    let reach = ((sketch.pane.max - sketch.pane.min) * 0.5 - margin).max(DVec2::ZERO);
    let way = point - centre;
    let share = (reach / way.abs().max(DVec2::splat(f64::MIN_POSITIVE)))
        .min_element()
        .min(1.0);
    centre + way * share
}

/// Draws parallel rays; returns their position, and whether the light itself is elsewhere.
fn draw_rays(sketch: &mut Sketch, light: &Light, radius: f64) -> (DVec2, bool) {
    let style = sketch.style;
    let direction = (light.direction / light.direction.abs().max_element()).normalize_or_zero();
    let flat = DVec2::new(
        direction.dot(sketch.view.right),
        -direction.dot(sketch.view.up),
    );
    let reach = RAYS_AT * (sketch.pane.max - sketch.pane.min).min_element();
    let pixel = sketch.pane.centre() - flat * reach;
    if flat.length() < HEAD_ON {
        let towards_eye = direction.dot(sketch.view.forward) < 0.0;
        sketch.draw_end_on(pixel, 1.5 * radius, towards_eye, Vector::L.colour());
        return (pixel, false);
    }
    let (along, half) = (flat.normalize(), flat * 0.5 * RAYS_LENGTH * radius / 0.4);
    for side in [-1.0, 0.0, 1.0] {
        let middle = pixel + along.perp() * side * 1.3 * radius;
        let width = if side == 0.0 {
            style.line
        } else {
            0.6 * style.line
        };
        let ends = [middle - half, middle + half];
        let head = (4.5 * width).min(half.length());
        let arrow = Shape::arrow(ends, along, width, head, Vector::L.colour());
        sketch.shapes.extend(arrow);
    }
    (pixel, false)
}
