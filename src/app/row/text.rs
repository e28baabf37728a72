//! Rows for words, and for several switches in one.

use super::{About, row};
use crate::app::focus;
use crate::app::symbol::Lit;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, TextEdit, Ui, WidgetInfo};

/// A line of text of at most `most` characters, which may be empty.
pub fn text(ui: &mut Ui, lit: &mut Lit, about: &About<'_>, most: usize, default: String, value: &mut String) {
    let reset = row(ui, lit, about, *value != default, |ui| {
        let field =
            TextEdit::singleline(value).char_limit(most).hint_text("no name").desired_width(ui.available_width());
        let response = ui.add(field);
        focus::register(&response);
        let (enabled, shown) = (ui.is_enabled(), value.clone());
        response.widget_info(|| WidgetInfo {
            current_text_value: Some(shown.clone()),
            ..WidgetInfo::labeled(Role::TextInput, enabled, about.name())
        });
        if response.changed() {
            value.retain(|character| !character.is_control());
        }
        response.on_hover_text(about.tip);
    });
    if reset {
        *value = default;
    }
}

/// Switches side by side, each with its default; each is called what the row is called and its own name.
pub fn flags(ui: &mut Ui, lit: &mut Lit, about: &About<'_>, values: &mut [(&str, bool, &mut bool)]) {
    let changed = values.iter().any(|(_, default, value)| **value != *default);
    let reset = row(ui, lit, about, changed, |ui| {
        for (label, _, value) in &mut *values {
            let response =
                ui.add(Button::selectable(**value, *label).frame_when_inactive(true).min_size([58.0, 0.0].into()));
            let name = format!("{} {label}", about.name());
            let (enabled, selected) = (ui.is_enabled(), **value);
            response.widget_info(|| WidgetInfo::selected(Role::Button, enabled, selected, &name));
            if response.clicked() {
                **value = !**value;
            }
            response.on_hover_text(about.tip);
        }
    });
    if reset {
        values.iter_mut().for_each(|(_, default, value)| **value = *default);
    }
}
