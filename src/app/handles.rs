//! What can be dragged in the picture: the lights' handles and, by the tab that is open, the profile's line by its two ends and a
//! ring by which the picture is turned.
//!
//! A point light's handle is where the light appears; it is dragged in the plane through the light that is parallel to
//! the picture. A directional light is nowhere, so its handle slides on a sphere about the camera's target: on the side
//! that faces the viewer it is filled, beyond it hollow, and pulled past the rim it goes round to the other side. A light
//! behind the viewer or outside the picture has a marker at the edge that points to it.
//!
//! The chosen light shows where it shines as well (see [`beam`]).

mod beam;
mod vertex;

pub use beam::{aim_at, cursor, open_to};
pub use vertex::{MOST, drag_to as drag_vertex, go, paint as paint_vertices, push as push_vertex};

use super::defects::shows_ring;
use super::letter::letter;
use super::look::NumbersTab;
use super::palette;
use super::place::{Place, ProbePoint, tidy};
use super::profile;
use super::row::swatch;
use super::state::{AppState, Grip};
use crate::figure::palette::Vector;
use crate::scene::{Camera, Light, LightKind, Scene, View};
use beam::MARGIN;
use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};
use glam::{DVec2, DVec3};

/// Radius of the sphere that directional lights' handles slide on, in heights of the picture at the target's depth.
const SPHERE: f64 = 0.42;
/// Radius of a handle, points.
const RADIUS: f32 = 8.0;

/// Radius of the ring, in the picture's shorter side.
const RING: f32 = 0.46;
/// Radius of the ring's knob, points.
const KNOB: f32 = 7.0;

/// How a light shows in the picture.
#[derive(Clone, Copy)]
enum Marker {
    /// A light with a place in the picture.
    Point,
    /// A directional light; `front` on the viewer's side of the sphere.
    Directional { front: bool },
    /// A light that is not in the picture; the unit vector points to where it is.
    Edge(Vec2),
}

/// Everything in the picture that the pointer can take hold of at a point, and where that is.
pub fn grips(state: &AppState, view: &View, place: Place) -> Vec<(Grip, Pos2)> {
    let mut grips = Vec::new();
    if state.shows(NumbersTab::Profile) {
        let ends = state.line.pixels(place.size).into_iter().enumerate();
        grips.extend(ends.map(|(end, pixel)| (Grip::LineEnd(end), place.point(pixel))));
    }
    if shows_ring(state) {
        grips.push((Grip::Roll, knob(state, place)));
    }
    if state.look.overlay.handles {
        let Scene { lights, camera, .. } = &state.shown.scene;
        let at = |light| marker(light, view, camera.target, place).0;
        grips.extend(
            lights
                .iter()
                .enumerate()
                .map(|(index, light)| (Grip::Light(index), at(light))),
        );
        grips.extend(
            beam::chosen(state, view)
                .into_iter()
                .flat_map(|beam| beam.grips(view, place)),
        );
        grips.extend(
            vertex::seen(state, view, place)
                .into_iter()
                .map(|(v, at)| (Grip::Vertex(v), at)),
        );
    }
    grips.push((Grip::Probe, place.point(state.probe.centre(place.size))));
    grips
}

/// Draws what is below the lights' handles: beams and outlines, the profile's line, the ring.
pub fn paint_below(painter: &Painter, state: &AppState, view: &View, place: Place, active: bool) {
    if state.look.overlay.handles {
        beam::paint(painter, state, view, place);
    }
    paint_tabs(painter, state, place, active);
}

/// Draws the lights' handles; that of the chosen light is emphasised.
pub fn paint(painter: &Painter, state: &AppState, view: &View, place: Place) {
    if !state.look.overlay.handles {
        return;
    }
    for (index, light) in state.shown.scene.lights.iter().enumerate() {
        let (at, marker) = marker(light, view, state.shown.scene.camera.target, place);
        paint_light(
            painter,
            index,
            at,
            marker,
            swatch(light.color),
            index == state.light,
        );
    }
    beam::chosen(state, view)
        .into_iter()
        .for_each(|beam| beam.paint_grips(painter, view, place));
}

/// Where a light's handle is, and how it shows.
fn marker(light: &Light, view: &View, target: DVec3, place: Place) -> (Pos2, Marker) {
    let directional = light.kind == LightKind::Directional;
    let world = if directional {
        target
            - light.direction.normalize_or(DVec3::NEG_Y) * sphere_radius(view, target, place.size)
    } else {
        light.position
    };
    let inner = place.rect.shrink(MARGIN * 0.5);
    let seen = view
        .project(world)
        .map(|(pixel, _)| place.point(pixel))
        .filter(|at| inner.contains(*at));
    let Some(at) = seen else {
        return at_edge(world, view, place);
    };
    let front = (world - target).dot(view.forward) <= 0.0;
    (
        at,
        if directional {
            Marker::Directional { front }
        } else {
            Marker::Point
        },
    )
}

/// `light` moved, or turned if it is directional, to where its handle is as far as can be from those of `lights`: in the
/// upper part of the picture and halfway between the viewer and what is looked at, so that this is lit.
pub fn apart(light: Light, lights: &[Light], camera: &Camera, size: [u32; 2]) -> Light {
    let view = View::new(camera, size);
    let [width, height] = size.map(f64::from);
    let rect = Rect::from_min_size(Pos2::ZERO, vec2(width as f32, height as f32));
    let place = Place {
        rect,
        size,
        pixels_per_point: 1.0,
    };
    let handle = |light: &Light| marker(light, &view, camera.target, place).0;
    let taken: Vec<Pos2> = lights.iter().map(handle).collect();
    let depth = 0.5 * camera.distance();
    let unit = view.world_per_pixel(depth);
    let moved = |pixel: DVec2| {
        let position = tidy(view.unproject(pixel, depth), unit);
        if light.kind == LightKind::Directional {
            Light {
                direction: camera.target - position,
                ..light.clone()
            }
        } else {
            Light {
                position,
                ..light.clone()
            }
        }
    };
    // More places than lights: not all of them are taken.
    let count = 4 + (f64::from(u32::try_from(lights.len()).unwrap_or(u32::MAX))).sqrt() as u32;
    let share = |index: u32| (f64::from(index) + 0.5) / f64::from(count);
    let places = (0..count * count).map(|index| {
        DVec2::new(
            width * (0.1 + 0.8 * share(index % count)),
            height * (0.1 + 0.5 * share(index / count)),
        )
    });
    let room = |light: &Light| {
        taken
            .iter()
            .map(|at| at.distance(handle(light)))
            .fold(f32::INFINITY, f32::min)
    };
    let found = places.map(moved).min_by(|a, b| room(b).total_cmp(&room(a)));
    found
        .filter(|light| light.position.is_finite() && light.direction.is_finite())
        .unwrap_or(light.clone())
}

fn sphere_radius(view: &View, target: DVec3, size: [u32; 2]) -> f64 {
    let depth = (target - view.eye).dot(view.forward);
    SPHERE * f64::from(size[0].min(size[1])) * view.world_per_pixel(depth)
}

/// The marker of a light that is not in the picture.
fn at_edge(world: DVec3, view: &View, place: Place) -> (Pos2, Marker) {
    let from_eye = world - view.eye;
    let across = vec2(
        from_eye.dot(view.right) as f32,
        -from_eye.dot(view.up) as f32,
    );
    let way = if across.length() > 0.0 && across.is_finite() {
        across.normalized()
    } else {
        vec2(0.0, -1.0)
    };
    let half = place.rect.size() / 2.0 - vec2(MARGIN, MARGIN);
    let reach =
        (half.x.max(1.0) / way.x.abs().max(1e-6)).min(half.y.max(1.0) / way.y.abs().max(1e-6));
    (place.rect.center() + way * reach, Marker::Edge(way))
}

/// Moves light `index` so that its handle is at `pixel`.
pub fn drag_light(scene: &mut Scene, index: usize, view: &View, pixel: DVec2) {
    let Scene { lights, camera, .. } = scene;
    let (Some(light), target) = (lights.get_mut(index), camera.target) else {
        return;
    };
    if light.kind == LightKind::Directional {
        turn_light(light, view, target, pixel);
        return;
    }
    let own = (light.position - view.eye).dot(view.forward);
    // A light behind the viewer comes into the picture beside the target.
    let depth = if own > 0.0 {
        own
    } else {
        (target - view.eye).dot(view.forward)
    };
    let wanted = view.unproject(pixel, depth);
    if wanted.is_finite() {
        light.position = tidy(wanted, view.world_per_pixel(depth));
    }
}

/// Turns a directional light so that its handle is at `pixel`.
fn turn_light(light: &mut Light, view: &View, target: DVec3, pixel: DVec2) {
    let size = [view.centre.x as u32 * 2, view.centre.y as u32 * 2];
    let radius = sphere_radius(view, target, size);
    let depth = (target - view.eye).dot(view.forward);
    let offset = (view.unproject(pixel, depth) - target) / radius;
    let (x, y) = (offset.dot(view.right), offset.dot(view.up));
    let length = x.hypot(y);
    // Past the rim the handle comes round on the side of the viewer.
    let front = length > 1.0 || light.direction.dot(view.forward) >= 0.0;
    let scale = if length > 1.0 {
        (2.0 - length).max(0.0) / length
    } else {
        1.0
    };
    let (x, y) = (x * scale, y * scale);
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    let direction = view.forward * if front { z } else { -z } - view.right * x - view.up * y;
    if direction.is_finite() && direction.length() > 0.5 {
        light.direction = tidy(direction, 1e-3);
    }
}

/// Moves light `index` towards the viewer by `step` of its distance (a negative step moves it away); a directional
/// light has no depth.
pub fn push_light(scene: &mut Scene, index: usize, view: &View, step: f64) {
    let unit = (scene.camera.target - view.eye).length().max(1e-6);
    let Some(light) = scene
        .lights
        .get_mut(index)
        .filter(|light| light.kind.has_position())
    else {
        return;
    };
    let moved = light.position - view.forward * (step * unit);
    if moved.is_finite() {
        light.position = tidy(moved, unit * 1e-3);
    }
}

fn paint_light(
    painter: &Painter,
    index: usize,
    at: Pos2,
    marker: Marker,
    colour: Color32,
    chosen: bool,
) {
    let orange = palette::vector(Vector::L);
    let ring = if chosen {
        Stroke::new(2.5, orange)
    } else {
        Stroke::new(1.5, orange.gamma_multiply(0.8))
    };
    let halo = Stroke::new(ring.width + 2.5, Color32::from_black_alpha(150));
    let number = match marker {
        Marker::Point => {
            painter.circle_stroke(at, RADIUS, halo);
            painter.circle(at, RADIUS, colour, ring);
            vec2(0.0, RADIUS + 11.0)
        }
        Marker::Directional { front } => {
            // The rays of a sun.
            for stroke in [halo, ring] {
                for k in 0..8u8 {
                    let way = Vec2::angled(f32::from(k) * std::f32::consts::FRAC_PI_4);
                    painter.line_segment(
                        [at + way * (RADIUS + 1.5), at + way * (RADIUS + 6.0)],
                        stroke,
                    );
                }
            }
            painter.circle_stroke(at, RADIUS - 1.5, halo);
            let fill = if front {
                colour
            } else {
                Color32::from_black_alpha(120)
            };
            painter.circle(at, RADIUS - 1.5, fill, ring);
            vec2(0.0, RADIUS + 15.0)
        }
        Marker::Edge(way) => {
            let side = way.rot90();
            let points = vec![
                at + way * 11.0,
                at - way * 7.0 + side * 9.0,
                at - way * 7.0 - side * 9.0,
            ];
            painter.add(Shape::closed_line(points.clone(), halo));
            painter.add(Shape::convex_polygon(points, colour, ring));
            -way * 24.0
        }
    };
    let font = FontId::proportional(if chosen { 15.0 } else { 14.0 });
    let text = palette::readable(orange, Color32::BLACK);
    letter(
        painter,
        at + number,
        Align2::CENTER_CENTER,
        &format!("L{}", index + 1),
        &font,
        text,
    );
}

fn ring(place: Place) -> f32 {
    RING * place.rect.width().min(place.rect.height())
}

/// The ring's knob: at the right without roll, counter-clockwise with it.
fn knob(state: &AppState, place: Place) -> Pos2 {
    // Any number of turns is one of 360 degrees; single precision would not know where it ends.
    let angle = state.shown.scene.camera.roll.rem_euclid(360.0).to_radians() as f32;
    place.rect.center() + ring(place) * vec2(angle.cos(), -angle.sin())
}

/// Turns the picture by whole degrees until the knob points at `at`; what the probe stands on is taken along.
pub fn turn_to(state: &mut AppState, place: Place, at: Pos2) {
    let way = at - place.rect.center();
    if way.length() < 1.0 {
        return;
    }
    let roll = f64::from((-way.y).atan2(way.x))
        .to_degrees()
        .rem_euclid(360.0)
        .round();
    let turned = roll - state.shown.scene.camera.roll;
    state.shown.scene.camera.roll = roll;
    // Pixels count downwards, so that counter-clockwise is clockwise to them.
    state.probe = ProbePoint(DVec2::from_angle(-turned.to_radians()).rotate(state.probe.0));
}

/// Draws the profile's line; and the ring.
fn paint_tabs(painter: &Painter, state: &AppState, place: Place, active: bool) {
    profile::paint(painter, state, place, active);
    let dark = |width, alpha| Stroke::new(width, Color32::from_black_alpha(alpha));
    let white = |width| Stroke::new(width, Color32::WHITE);
    if shows_ring(state) {
        let centre = place.rect.center();
        painter.circle_stroke(centre, ring(place), dark(3.0, 110));
        painter.circle_stroke(
            centre,
            ring(place),
            Stroke::new(1.0, Color32::from_white_alpha(130)),
        );
        let at = knob(state, place);
        painter.circle(at, KNOB, Color32::from_black_alpha(170), dark(3.5, 150));
        painter.circle_stroke(at, KNOB, white(2.0));
    }
}
