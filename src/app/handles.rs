//! The lights' handles in the picture.
//!
//! A point light's handle is where the light appears; it is dragged in the plane through the light that is parallel to
//! the picture. A directional light is nowhere, so its handle slides on a sphere about the camera's target: on the side
//! that faces the viewer it is filled, beyond it hollow, and pulled past the rim it goes round to the other side. A light
//! behind the viewer or outside the picture has a marker at the edge that points to it.
//!
//! The chosen light shows where it shines as well (see [`beam`]).

mod beam;
mod handle;

pub use handle::Handle;

pub mod line;
pub mod turn;
pub mod vertex;

pub use beam::{aim_at, cursor, open_to, paint};

use super::letter::letter;
use super::palette;
use super::place::Place;
use super::row::swatch;
use super::state::AppState;
use crate::figure::palette::Vector;
use crate::scene::{Camera, Light, LightKind, Rgb, View};
use beam::Beam;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};
use glam::{DVec2, DVec3};
use handle::MARGIN;

/// Radius of the sphere that directional lights' handles slide on, in heights of the picture at the target's depth.
const SPHERE: f64 = 0.42;
/// Radius of a handle, points.
const RADIUS: f32 = 8.0;
/// Radius of the handles of a light's axis and edge, points.
const SMALL: f32 = 5.0;

/// A handle in its place on the screen.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// Index of the light in the scene.
    pub index: usize,
    pub at: Pos2,
    pub handle: Handle,
    pub colour: Rgb,
}

/// The handles of every light.
pub fn place(state: &AppState, view: &View, place: Place) -> Vec<Placed> {
    if !state.look.overlay.handles {
        return Vec::new();
    }
    let target = state.shown.scene.camera.target;
    let lights = state.shown.scene.lights.iter().enumerate();
    let mut placed: Vec<_> = lights.map(|(index, light)| place_one(index, light, view, target, place)).collect();
    if let Some(light) = state.shown.scene.lights.get(state.light) {
        let parts = Beam::of(light, view, target).into_iter().flat_map(|beam| beam.handles(view, place));
        placed.extend(parts.map(|(at, handle)| Placed { index: state.light, at, handle, colour: light.color }));
    }
    placed
}

fn place_one(index: usize, light: &Light, view: &View, target: DVec3, place: Place) -> Placed {
    let world = match light.kind {
        LightKind::Point | LightKind::Spot | LightKind::Area => light.position,
        LightKind::Directional => on_sphere(light, view, target, place.size),
    };
    let inner = place.rect.shrink(MARGIN * 0.5);
    let seen = view.project(world).map(|(pixel, _)| place.point(pixel)).filter(|at| inner.contains(*at));
    let (at, handle) = match (seen, light.kind) {
        (Some(at), LightKind::Point | LightKind::Spot | LightKind::Area) => (at, Handle::Point),
        (Some(at), LightKind::Directional) => {
            (at, Handle::Directional { front: (world - target).dot(view.forward) <= 0.0 })
        }
        (None, _) => at_edge(world, view, place),
    };
    Placed { index, at, handle, colour: light.color }
}

/// `light` moved, or turned if it is directional, to where its handle is as far as can be from those of `lights`: in the
/// upper part of the picture and halfway between the viewer and what is looked at, so that this is lit.
pub fn apart(light: Light, lights: &[Light], camera: &Camera, size: [u32; 2]) -> Light {
    let view = View::new(camera, size);
    let [width, height] = size.map(f64::from);
    let rect = Rect::from_min_size(Pos2::ZERO, vec2(width as f32, height as f32));
    let place = Place { rect, size, pixels_per_point: 1.0 };
    let handle = |light: &Light| place_one(0, light, &view, camera.target, place).at;
    let taken: Vec<Pos2> = lights.iter().map(handle).collect();
    let depth = 0.5 * camera.distance();
    let unit = view.world_per_pixel(depth);
    let moved = |pixel: DVec2| {
        let position = tidy(view.unproject(pixel, depth), unit);
        match light.kind {
            LightKind::Directional => Light { direction: camera.target - position, ..light.clone() },
            LightKind::Point | LightKind::Spot | LightKind::Area => Light { position, ..light.clone() },
        }
    };
    // More places than lights: not all of them are taken.
    let count = 4 + (f64::from(u32::try_from(lights.len()).unwrap_or(u32::MAX))).sqrt() as u32;
    let share = |index: u32| (f64::from(index) + 0.5) / f64::from(count);
    let places = (0..count * count).map(|index| {
        DVec2::new(width * (0.1 + 0.8 * share(index % count)), height * (0.1 + 0.5 * share(index / count)))
    });
    let room = |light: &Light| taken.iter().map(|at| at.distance(handle(light))).fold(f32::INFINITY, f32::min);
    let found = places.map(moved).min_by(|a, b| room(b).total_cmp(&room(a)));
    found.filter(|light| light.position.is_finite() && light.direction.is_finite()).unwrap_or(light.clone())
}

/// Where a directional light's handle is in the world.
fn on_sphere(light: &Light, view: &View, target: DVec3, size: [u32; 2]) -> DVec3 {
    target - light.direction.normalize_or(DVec3::NEG_Y) * sphere_radius(view, target, size)
}

fn sphere_radius(view: &View, target: DVec3, size: [u32; 2]) -> f64 {
    let depth = (target - view.eye).dot(view.forward);
    SPHERE * f64::from(size[0].min(size[1])) * view.world_per_pixel(depth)
}

/// The marker of a light that is not in the picture.
fn at_edge(world: DVec3, view: &View, place: Place) -> (Pos2, Handle) {
    let from_eye = world - view.eye;
    let across = vec2(from_eye.dot(view.right) as f32, -from_eye.dot(view.up) as f32);
    let way = if across.length() > 0.0 && across.is_finite() { across.normalized() } else { vec2(0.0, -1.0) };
    let half = place.rect.size() / 2.0 - vec2(MARGIN, MARGIN);
    let reach = (half.x.max(1.0) / way.x.abs().max(1e-6)).min(half.y.max(1.0) / way.y.abs().max(1e-6));
    (place.rect.center() + way * reach, Handle::Edge(way))
}

/// The handle within `reach` of `at`, the nearest first.
pub fn nearest(handles: &[Placed], at: Pos2, reach: f32) -> Option<Placed> {
    let near = handles.iter().filter(|placed| placed.at.distance(at) <= reach);
    near.min_by(|a, b| a.at.distance(at).total_cmp(&b.at.distance(at))).copied()
}

/// Moves light `index` so that its handle is at `pixel`.
pub fn drag_to(state: &mut AppState, index: usize, view: &View, pixel: DVec2) {
    let target = state.shown.scene.camera.target;
    let Some(light) = state.shown.scene.lights.get_mut(index) else { return };
    match light.kind {
        LightKind::Point | LightKind::Spot | LightKind::Area => {
            let own = (light.position - view.eye).dot(view.forward);
            // A light behind the viewer comes into the picture beside the target.
            let depth = if own > 0.0 { own } else { (target - view.eye).dot(view.forward) };
            let wanted = view.unproject(pixel, depth);
            if wanted.is_finite() {
                light.position = tidy(wanted, view.world_per_pixel(depth));
            }
        }
        LightKind::Directional => turn_to(light, view, target, pixel),
    }
}

/// Turns a directional light so that its handle is at `pixel`.
fn turn_to(light: &mut Light, view: &View, target: DVec3, pixel: DVec2) {
    let size = [view.centre.x as u32 * 2, view.centre.y as u32 * 2];
    let radius = sphere_radius(view, target, size);
    let depth = (target - view.eye).dot(view.forward);
    let offset = (view.unproject(pixel, depth) - target) / radius;
    let (x, y) = (offset.dot(view.right), offset.dot(view.up));
    let length = x.hypot(y);
    let towards_viewer = light.direction.dot(view.forward) >= 0.0;
    // Past the rim the handle goes round to the other side.
    let (length_on, front) =
        if length <= 1.0 { (length, towards_viewer) } else { ((2.0 - length).max(0.0), !towards_viewer) };
    let front = if length > 1.0 { !front || !towards_viewer } else { front };
    let scale = if length > 0.0 { length_on.min(1.0) / length } else { 0.0 };
    let (x, y) = (x * scale, y * scale);
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    let l = view.right * x + view.up * y - view.forward * if front { z } else { -z };
    let direction = -l;
    if direction.is_finite() && direction.length() > 0.5 {
        light.direction = tidy(direction, 1e-3);
    }
}

/// Moves light `index` towards the viewer by `step` of its distance (a negative step moves it away); a directional
/// light has no depth.
pub fn push(state: &mut AppState, index: usize, view: &View, step: f64) {
    let target = state.shown.scene.camera.target;
    let Some(light) = state.shown.scene.lights.get_mut(index) else { return };
    if light.kind.has_position() {
        let unit = (target - view.eye).length().max(1e-6);
        let moved = light.position - view.forward * (step * unit);
        if moved.is_finite() {
            light.position = tidy(moved, unit * 1e-3);
        }
    }
}

/// `v` rounded to the decimal place below `step`, so that no digits are shown that the hand did not mean.
fn tidy(v: DVec3, step: f64) -> DVec3 {
    let unit = 10f64.powf(step.max(1e-12).log10().floor());
    let rounded = (v / unit).round() * unit;
    // Multiplying by a negative power of ten leaves a trail of digits; dividing by the positive one does not.
    if unit < 1.0 { (v * (1.0 / unit).round()).round() / (1.0 / unit).round() } else { rounded }
}

impl Handle {
    /// Draws a handle; the `chosen` light's is emphasised.
    pub fn paint(painter: &Painter, placed: &Placed, chosen: bool) {
        let orange = palette::vector(Vector::L);
        let ring = if chosen { Stroke::new(2.5, orange) } else { Stroke::new(1.5, orange.gamma_multiply(0.8)) };
        let halo = Stroke::new(ring.width + 2.5, Color32::from_black_alpha(150));
        match placed.handle {
            Self::Point => {
                painter.circle_stroke(placed.at, RADIUS, halo);
                painter.circle(placed.at, RADIUS, swatch(placed.colour), ring);
            }
            Self::Directional { front } => {
                rays(painter, placed.at, halo, ring);
                painter.circle_stroke(placed.at, RADIUS - 1.5, halo);
                let fill = if front { swatch(placed.colour) } else { Color32::from_black_alpha(120) };
                painter.circle(placed.at, RADIUS - 1.5, fill, ring);
            }
            Self::Edge(way) => arrow(painter, placed.at, way, swatch(placed.colour), halo, ring),
            Self::Aim { .. } | Self::Rim(_) => {
                painter.circle_stroke(placed.at, SMALL, halo);
                painter.circle(placed.at, SMALL, orange, Stroke::new(1.0, Color32::BLACK));
                return;
            }
        }
        number(painter, placed, chosen);
    }
}

/// The rays of a sun.
fn rays(painter: &Painter, at: Pos2, halo: Stroke, ring: Stroke) {
    for stroke in [halo, ring] {
        for k in 0..8u8 {
            let way = Vec2::angled(f32::from(k) * std::f32::consts::FRAC_PI_4);
            painter.line_segment([at + way * (RADIUS + 1.5), at + way * (RADIUS + 6.0)], stroke);
        }
    }
}

fn arrow(painter: &Painter, at: Pos2, way: Vec2, fill: Color32, halo: Stroke, ring: Stroke) {
    let side = way.rot90();
    let points = vec![at + way * 11.0, at - way * 7.0 + side * 9.0, at - way * 7.0 - side * 9.0];
    painter.add(Shape::closed_line(points.clone(), halo));
    painter.add(Shape::convex_polygon(points, fill, ring));
}

fn number(painter: &Painter, placed: &Placed, chosen: bool) {
    let text = format!("L{}", placed.index + 1);
    let font = FontId::proportional(if chosen { 15.0 } else { 14.0 });
    let offset = match placed.handle {
        Handle::Edge(way) => -way * 24.0,
        Handle::Point => vec2(0.0, RADIUS + 11.0),
        Handle::Directional { .. } => vec2(0.0, RADIUS + 15.0),
        Handle::Aim { .. } | Handle::Rim(_) => return,
    };
    let at = placed.at + offset;
    let colour = palette::readable(palette::vector(Vector::L), Color32::BLACK);
    letter(painter, at, Align2::CENTER_CENTER, &text, &font, colour);
}
