//! The profile's line in the picture, with its two ends to drag. It shows while the profile's tab is open.

use super::super::lines::line;
use super::super::look::NumbersTab;
use super::super::place::Place;
use super::super::profile::Profiles;
use super::super::state::AppState;
use super::super::theme::TEXT;
use crate::analysis::{CURVE, lay_out_profile};
use eframe::egui::{Color32, Painter, Pos2, Stroke};
use glam::DVec2;

/// Radius of an end, points.
const RADIUS: f32 = 6.0;

/// Whether the line is in sight.
pub fn shown(state: &AppState) -> bool {
    state.shows(NumbersTab::Profile)
}

/// The end within `reach` of `at`, and where it is.
pub fn end_at(state: &AppState, place: Place, at: Pos2, reach: f32) -> Option<(usize, Pos2)> {
    let ends = state.line.pixels(place.size).map(|end| place.point(end));
    let near = ends.into_iter().enumerate().filter(|(_, end)| shown(state) && end.distance(at) <= reach);
    near.min_by(|a, b| a.1.distance(at).total_cmp(&b.1.distance(at)))
}

/// The curves above the line: what is there solid, what is perceived dashed, for the scene's own shading where it is taken.
fn curves(painter: &Painter, state: &AppState, place: Place) {
    let Some(taken) = state.own.get().and_then(Profiles::profile) else { return };
    let own = state.shown.scene.shading.mode;
    let Some(trace) = taken.traces.iter().find(|trace| trace.mode == own).or(taken.traces.first()) else { return };
    let side = f64::from(place.size[0].min(place.size[1]));
    let em = f64::from(TEXT * place.pixels_per_point);
    let Some(curves) = lay_out_profile(taken, trace, side, em) else { return };
    let draw = |points: &[DVec2], stroke: Stroke, dashes: &[f32]| {
        line(painter, points.iter().map(|point| place.exact_point(*point)), stroke, dashes);
    };
    let dark = Stroke::new(4.0, Color32::from_black_alpha(140));
    for tick in &curves.ticks {
        draw(tick, dark, &[]);
        draw(tick, Stroke::new(1.5, Color32::WHITE), &[]);
    }
    draw(&curves.perceived, dark, &[]);
    draw(&curves.perceived, Stroke::new(1.6, Color32::WHITE), &[6.0, 4.0]);
    draw(&curves.intensity, dark, &[]);
    let [r, g, b] = CURVE;
    draw(&curves.intensity, Stroke::new(2.0, Color32::from_rgb(r, g, b)), &[]);
}

/// Draws the line white on dark, so that it shows on any picture, and the profile above it.
pub fn paint(painter: &Painter, state: &AppState, place: Place, active: bool) {
    if !shown(state) {
        return;
    }
    if active {
        curves(painter, state, place);
    }
    let ends = state.line.pixels(place.size).map(|end| place.point(end));
    let dark = |width| Stroke::new(width, Color32::from_black_alpha(150));
    let white = |width| Stroke::new(width, Color32::WHITE);
    painter.line_segment(ends, dark(3.5));
    painter.line_segment(ends, white(1.5));
    for end in ends {
        painter.circle(end, RADIUS, Color32::from_black_alpha(110), dark(4.0));
        painter.circle_stroke(end, RADIUS, white(2.0));
    }
}
