//! Parts shared by the views of a step.

use eframe::egui::{Frame, Label, Margin, RichText, Spinner, Stroke, Ui};

/// Returns the frame of a question.
pub fn card(ui: &Ui) -> Frame {
    let colour = ui.visuals().widgets.noninteractive.bg_stroke.color;
    Frame::new()
        .stroke(Stroke::new(1.0, colour))
        .corner_radius(8.0)
        .inner_margin(Margin::same(10))
}

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
