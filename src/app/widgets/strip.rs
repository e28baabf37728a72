//! A strip to draw on, as wide as the panel.

use eframe::egui::{Rect, Response, Sense, Ui, vec2};

/// Allocates a strip `height` points high and as wide as what is left of the line.
pub fn strip(ui: &mut Ui, height: f32, sense: Sense) -> (Rect, Response) {
    ui.allocate_exact_size(vec2(ui.available_width(), height), sense)
}
