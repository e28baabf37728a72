//! The handles in the picture: those of the lights, and, depending on the open tab, the two ends of the
//! profile's line and a ring that turns the picture.
//!
//! The handles are shown while the pointer is over the picture. [`light`] describes those of the lights; for
//! the chosen light, [`beam`] shows the direction too.

mod beam;
mod light;
mod vertex;

pub use beam::{aim_at, cursor, open_to};
pub use light::{REACH, apart, drag_light, put_light, scale_light, start};
pub use vertex::{drag_to as drag_vertex, paint as paint_vertices, push as push_vertex};

use crate::app::course::Course;
use crate::app::session::Session;
use crate::app::session::appearance::ViewName;
use crate::app::session::place::{Place, ProbePoint};
use crate::app::session::window::{Grip, WindowState};
use crate::app::views::defects::shows_ring;
use crate::app::views::profile;
use crate::app::widgets::lines::area;
use crate::figure::Area;
use crate::scene::View;
use eframe::egui::{Color32, Context, Painter, Pos2, Rect, Stroke, Vec2, vec2};
use glam::DVec2;

/// The size of the area that the ring round the probe covers, in points.
const PROBE: f32 = 16.0;
/// The radius of the ring, as a fraction of the picture's shorter side.
const RING: f32 = 0.46;
/// The radius of the ring's knob, in points.
const KNOB: f32 = 7.0;

/// Returns everything in the picture that the pointer can grab, with its position on the screen.
pub fn grips(
    session: &Session,
    window: &WindowState,
    course: &Course,
    view: &View,
    place: Place,
) -> Vec<(Grip, Pos2)> {
    let mut grips = Vec::new();
    if window.shows(ViewName::Profile) {
        let ends = window.line.pixels(place.size).into_iter().enumerate();
        grips.extend(ends.map(|(end, pixel)| (Grip::LineEnd(end), place.point(pixel))));
    }
    if shows_ring(session, window) {
        grips.push((Grip::Roll, knob(session, place)));
    }
    if window.appearance.overlay.handles {
        let lights = light::places(&session.shown.scene, view, place).into_iter();
        grips.extend(lights.zip(0..).map(|(at, index)| (Grip::Light(index), at)));
        if let Some(beam) = beam::chosen(session, view) {
            grips.extend(beam.grips(view, place));
        }
        let vertices = vertex::seen(session, view, place).into_iter();
        grips.extend(vertices.map(|(v, at)| (Grip::Vertex(v), at)));
    }
    if let Some(mark) = course.mark().filter(|_| course.asks_point()) {
        let pixel = ProbePoint(mark).centre(place.size);
        grips.push((Grip::Mark, place.point(pixel)));
    }
    grips.push((Grip::Probe, place.point(window.probe.centre(place.size))));
    grips
}

/// Returns the areas covered by the lights' handles with their numbers, by the probe and by the captions of
/// panes, in the picture's pixels.
pub fn covered(session: &Session, window: &WindowState, view: &View, place: Place) -> Vec<Area> {
    let mut covered = light::captions(session, place);
    if window.appearance.overlay.handles {
        covered.extend(light::covered(&session.shown.scene, view, place));
    }
    if window.appearance.overlay.vectors {
        let probe = place.point(window.probe.centre(place.size));
        covered.push(area(Rect::from_center_size(probe, Vec2::splat(PROBE))));
    }
    let pixels = |area: Area| {
        let [min, max] = [area.min, area.max].map(|at| place.exact_pixel(at));
        Area { min, max }
    };
    covered.into_iter().map(pixels).collect()
}

/// Returns whether the handles of lights are shown: while the pointer is over the picture or drags something,
/// and always on a touch screen and in a figure, whose reader looks for something to do.
pub fn visible(ctx: &Context, window: &WindowState, place: Place) -> bool {
    let near = || {
        ctx.input(|input| {
            let over = input.pointer.hover_pos();
            input.has_touch_screen() || over.is_some_and(|at| place.rect.contains(at))
        })
    };
    let always = window.drag.is_some() || window.embedded.is_some();
    window.appearance.overlay.handles && (always || near())
}

/// Draws everything below the lights' handles: beams, outlines and stems, the profile's line, the ring.
pub fn paint_below(
    painter: &Painter,
    session: &Session,
    window: &WindowState,
    view: &View,
    place: Place,
    active: bool,
) {
    if visible(painter.ctx(), window, place) {
        beam::paint(painter, session, view, place);
        light::paint_stem(painter, session, window, view, place);
    }
    profile::paint(painter, session, window, place, active);
    if shows_ring(session, window) {
        paint_ring(painter, session, place);
    }
}

/// Draws the lights' handles.
pub fn paint(
    painter: &Painter,
    session: &Session,
    window: &WindowState,
    view: &View,
    place: Place,
) {
    if visible(painter.ctx(), window, place) {
        light::paint(painter, session, window, view, place);
    }
}

fn ring(place: Place) -> f32 {
    RING * place.rect.width().min(place.rect.height())
}

/// Returns the position of the ring's knob: at the right without roll, counter-clockwise from there with it.
fn knob(session: &Session, place: Place) -> Pos2 {
    // Reduced to one turn, since single precision would lose the angle of many turns.
    let roll = session.shown.scene.camera.roll.rem_euclid(360.0);
    let angle = roll.to_radians() as f32;
    place.rect.center() + ring(place) * vec2(angle.cos(), -angle.sin())
}

/// Turns the picture by whole degrees until the knob points at `at`. The probe stays on the same point of the
/// scene.
pub fn turn_to(session: &mut Session, window: &mut WindowState, place: Place, at: Pos2) {
    let way = at - place.rect.center();
    if way.length() < 1.0 {
        return;
    }
    let roll = f64::from((-way.y).atan2(way.x))
        .to_degrees()
        .rem_euclid(360.0)
        .round();
    let turned = roll - session.shown.scene.camera.roll;
    session.shown.scene.camera.roll = roll;
    // Pixel rows count downwards, so that a counter-clockwise turn has a negative angle.
    window.probe = ProbePoint(DVec2::from_angle(-turned.to_radians()).rotate(window.probe.0));
}

/// Draws the ring and its knob.
fn paint_ring(painter: &Painter, session: &Session, place: Place) {
    let dark = |width, alpha| Stroke::new(width, Color32::from_black_alpha(alpha));
    let pale = Stroke::new(1.0, Color32::from_white_alpha(130));
    let (centre, radius) = (place.rect.center(), ring(place));
    painter.circle_stroke(centre, radius, dark(3.0, 110));
    painter.circle_stroke(centre, radius, pale);
    let at = knob(session, place);
    painter.circle(at, KNOB, Color32::from_black_alpha(170), dark(3.5, 150));
    painter.circle_stroke(at, KNOB, Stroke::new(2.0, Color32::WHITE));
}
