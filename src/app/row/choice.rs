//! Rows for one of several, and for on and off.

use super::{About, row};
use crate::app::symbol::Lit;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, ComboBox, Ui, WidgetInfo};

/// One of several: the value, what it is called, what it means.
pub type Choice<T> = (T, &'static str, &'static str);

/// One of several, from a list that opens.
pub fn choice<T: PartialEq + Copy>(
    ui: &mut Ui,
    lit: &mut Lit,
    about: &About<'_>,
    default: T,
    choices: &[Choice<T>],
    value: &mut T,
) {
    let reset = row(ui, lit, about, *value != default, |ui| {
        let shown = choices.iter().find(|(candidate, ..)| candidate == value).map_or("", |(_, label, _)| *label);
        let list = ComboBox::from_id_salt(about.name()).selected_text(shown).width(ui.available_width()).height(420.0);
        let response = list.show_ui(ui, |ui| {
            for (candidate, label, tip) in choices {
                let response = ui.selectable_value(value, *candidate, *label);
                if !tip.is_empty() {
                    response.on_hover_text(*tip);
                }
            }
        });
        let enabled = ui.is_enabled();
        response.response.widget_info(|| WidgetInfo {
            current_text_value: Some(shown.to_owned()),
            ..WidgetInfo::labeled(Role::ComboBox, enabled, about.name())
        });
        if !about.tip.is_empty() {
            response.response.on_hover_text(about.tip);
        }
    });
    if reset {
        *value = default;
    }
}

/// On or off.
pub fn toggle(ui: &mut Ui, lit: &mut Lit, about: &About<'_>, default: bool, value: &mut bool) {
    let reset = row(ui, lit, about, *value != default, |ui| {
        for (state, label) in [(true, "on"), (false, "off")] {
            let response = ui.add(Button::selectable(*value == state, label).min_size([44.0, 0.0].into()));
            let name = format!("{} {label}", about.name());
            let (enabled, selected) = (ui.is_enabled(), *value == state);
            response.widget_info(|| WidgetInfo::selected(Role::Button, enabled, selected, &name));
            if response.clicked() {
                *value = state;
            }
        }
    });
    if reset {
        *value = default;
    }
}
