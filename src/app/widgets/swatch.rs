//! Colours of a scene, as the textbooks' display shows them.

use crate::scene::Rgb;
use eframe::egui::{Color32, Rect, Response, Sense, StrokeKind, Ui, Vec2};

/// Returns a linear colour as the textbooks' display shows it.
pub fn display_colour(colour: Rgb) -> Color32 {
    let [r, g, b] = colour
        .to_array()
        .map(|value| (value.clamp(0.0, 1.0) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

/// Shows a colour that can be clicked: `shown` is the size of the visible part, in the middle of `size`.
pub fn swatch_ui(ui: &mut Ui, colour: Rgb, shown: Vec2, size: Vec2) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let rect = Rect::from_center_size(rect.center(), shown);
    let stroke = if response.hovered() || response.has_focus() {
        ui.visuals().widgets.hovered.fg_stroke
    } else {
        ui.visuals().window_stroke
    };
    let colour = display_colour(colour);
    ui.painter()
        .rect(rect, 4.0, colour, stroke, StrokeKind::Inside);
    response
}
