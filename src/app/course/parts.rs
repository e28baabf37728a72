//! Parts shared by the views of a step.

use crate::app::widgets::palette::vector_text;
use crate::figure::palette::Vector;
use eframe::egui::{Color32, Label, Rect, RichText, Spinner, Stroke, Ui};

pub fn error_ui(ui: &mut Ui, why: &str) {
    let words = RichText::new(why).color(ui.visuals().error_fg_color);
    ui.add(Label::new(words).wrap());
}

pub fn waiting_ui(ui: &mut Ui, words: &str) {
    ui.horizontal(|ui| {
        ui.add(Spinner::new().size(14.0));
        ui.label(RichText::new(words).weak());
    });
}

/// Returns the colour of right answers.
pub fn right_colour(ui: &Ui) -> Color32 {
    vector_text(ui.visuals(), Vector::V)
}

/// Draws a cross that fills `room`.
pub fn cross(ui: &Ui, room: Rect, colour: Color32) {
    let stroke = Stroke::new(1.8, colour);
    ui.painter()
        .line_segment([room.left_top(), room.right_bottom()], stroke);
    ui.painter()
        .line_segment([room.right_top(), room.left_bottom()], stroke);
}
