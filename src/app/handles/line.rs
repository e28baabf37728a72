//! The profile's line in the picture, with its two ends to drag. It shows while the profile's tab is open.

use super::super::picture::Place;
use super::super::state::{AppState, NumbersTab};
use eframe::egui::{Color32, Painter, Pos2, Stroke};
use glam::DVec2;

/// Radius of an end, points.
const RADIUS: f32 = 6.0;

/// Where the profile is taken: both ends from the picture's middle in units of its height, like the probe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileLine(pub [DVec2; 2]);

impl Default for ProfileLine {
    fn default() -> Self {
        Self([DVec2::new(-0.4, 0.06), DVec2::new(0.4, 0.06)])
    }
}

impl ProfileLine {
    /// Both ends in a picture of `size` pixels, kept inside.
    pub fn pixels(self, size: [u32; 2]) -> [DVec2; 2] {
        let size = DVec2::from_array(size.map(f64::from));
        self.0.map(|end| (end * size.y + 0.5 * size).clamp(DVec2::ZERO, size))
    }

    /// Puts an end at a place of a picture of `size` pixels.
    pub fn put(&mut self, end: usize, pixel: DVec2, size: [u32; 2]) {
        let size = DVec2::from_array(size.map(|side| f64::from(side.max(1))));
        if let Some(end) = self.0.get_mut(end) {
            *end = (pixel.clamp(DVec2::ZERO, size) - 0.5 * size) / size.y;
        }
    }
}

fn shown(state: &AppState) -> bool {
    state.look.numbers && !state.picture_alone && state.look.tab == NumbersTab::Profile
}

/// The end within `reach` of `at`, and where it is.
pub fn end_at(state: &AppState, place: Place, at: Pos2, reach: f32) -> Option<(usize, Pos2)> {
    let ends = state.line.pixels(place.size).map(|end| place.point(end));
    let near = ends.into_iter().enumerate().filter(|(_, end)| shown(state) && end.distance(at) <= reach);
    near.min_by(|a, b| a.1.distance(at).total_cmp(&b.1.distance(at)))
}

/// Draws the line white on dark, so that it shows on any picture.
pub fn paint(painter: &Painter, state: &AppState, place: Place) {
    if !shown(state) {
        return;
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
