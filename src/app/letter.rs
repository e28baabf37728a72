//! Letters on a picture, with a dark edge that keeps them readable on any.

use eframe::egui::{Align2, Color32, FontId, Painter, Pos2, vec2};

/// Writes `text` with its `align` at `at`.
pub fn letter(painter: &Painter, at: Pos2, align: Align2, text: &str, font: &FontId, colour: Color32) {
    for shift in [vec2(-1.0, 0.0), vec2(1.0, 0.0), vec2(0.0, -1.0), vec2(0.0, 1.0), vec2(1.0, 1.0), vec2(-1.0, -1.0)] {
        painter.text(at + shift, align, text, font.clone(), Color32::from_black_alpha(200));
    }
    painter.text(at, align, text, font.clone(), colour);
}
