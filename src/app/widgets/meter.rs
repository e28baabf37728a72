//! A share as a bar.

use eframe::egui::{Color32, Response, Sense, Stroke, StrokeKind, Ui, Vec2};

/// Radius of a bar's corners, in points.
const ROUND: f32 = 4.0;

/// Shows a bar whose part from the left, the `share` of 1, is filled.
pub fn meter_ui(ui: &mut Ui, size: Vec2, share: f32, colour: Color32) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let (painter, visuals) = (ui.painter(), ui.visuals());
    painter.rect_filled(rect, ROUND, visuals.extreme_bg_color);
    let filled = rect.with_max_x(rect.min.x + rect.width() * share);
    painter.rect_filled(filled, ROUND, colour);
    let line = Stroke::new(1.0, visuals.widgets.noninteractive.bg_stroke.color);
    painter.rect_stroke(rect, ROUND, line, StrokeKind::Inside);
    response
}
