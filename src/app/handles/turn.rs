//! The ring about the picture by which it is turned. It shows while the tab of defects is open.

use super::super::defects::shown;
use super::super::place::Place;
use super::super::points::ProbePoint;
use super::super::state::AppState;
use eframe::egui::{Color32, Painter, Pos2, Stroke, vec2};
use glam::DVec2;

/// Radius of the ring, in the picture's shorter side.
const RADIUS: f32 = 0.46;
/// Radius of the knob, points.
const KNOB: f32 = 7.0;
/// Degrees between angles at which the ring catches while shift is not held.
const CATCH: f64 = 1.0;

fn radius(place: Place) -> f32 {
    RADIUS * place.rect.width().min(place.rect.height())
}

/// Where the knob is: at the right without roll, counter-clockwise with it.
fn knob(state: &AppState, place: Place) -> Pos2 {
    // Any number of turns is one of 360 degrees; single precision would not know where it ends.
    let angle = state.shown.scene.camera.roll.rem_euclid(360.0).to_radians() as f32;
    place.rect.center() + radius(place) * vec2(angle.cos(), -angle.sin())
}

/// The knob, if it is within `reach` of `at`.
pub fn near(state: &AppState, place: Place, at: Pos2, reach: f32) -> bool {
    shown(state) && knob(state, place).distance(at) <= reach
}

/// Turns the picture until the knob points at `at`; what the probe stands on is taken along.
pub fn drag_to(state: &mut AppState, place: Place, at: Pos2) {
    let way = at - place.rect.center();
    if way.length() < 1.0 {
        return;
    }
    let angle = f64::from((-way.y).atan2(way.x)).to_degrees().rem_euclid(360.0);
    let roll = (angle / CATCH).round() * CATCH;
    let turned = roll - state.shown.scene.camera.roll;
    state.shown.scene.camera.roll = roll;
    // Pixels count downwards, so that counter-clockwise is clockwise to them.
    state.probe = ProbePoint(DVec2::from_angle(-turned.to_radians()).rotate(state.probe.0));
}

/// Draws the ring and its knob.
pub fn paint(painter: &Painter, state: &AppState, place: Place) {
    if !shown(state) {
        return;
    }
    let centre = place.rect.center();
    painter.circle_stroke(centre, radius(place), Stroke::new(3.0, Color32::from_black_alpha(110)));
    painter.circle_stroke(centre, radius(place), Stroke::new(1.0, Color32::from_white_alpha(130)));
    let at = knob(state, place);
    painter.circle(at, KNOB, Color32::from_black_alpha(170), Stroke::new(3.5, Color32::from_black_alpha(150)));
    painter.circle_stroke(at, KNOB, Stroke::new(2.0, Color32::WHITE));
}
