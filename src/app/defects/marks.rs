//! Where the defects are in the picture.

use super::super::letter::letter;
use super::super::lines;
use super::super::place::Place;
use super::super::state::AppState;
use super::{Measured, shown};
use crate::analysis::defect_marks;
use eframe::egui::{Align2, Color32, FontId, Painter, Stroke};

/// Marks what was last measured in the active picture.
pub fn paint(painter: &Painter, state: &AppState, place: Place, font: &FontId) {
    let Some(defects) = state.own.get().and_then(Measured::defects).filter(|_| shown(state)) else { return };
    let em = f64::from(font.size * place.pixels_per_point);
    for mark in defect_marks(defects) {
        for stroke in [Stroke::new(4.0, Color32::from_black_alpha(160)), Stroke::new(1.8, Color32::WHITE)] {
            for line in mark.lines(em) {
                lines::line(painter, line.map(|end| place.exact_point(end)), stroke, &[]);
            }
            if let Some(radius) = mark.ring(em) {
                painter.circle_stroke(place.point(mark.ends[0]), radius as f32 / place.pixels_per_point, stroke);
            }
        }
        let at = place.point(mark.label_at(em));
        letter(painter, at, Align2::CENTER_CENTER, &mark.label, font, Color32::WHITE);
    }
}
