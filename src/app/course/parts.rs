//! Parts shared by the views of a step.

use eframe::egui::{Label, RichText, Spinner, Ui};

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
