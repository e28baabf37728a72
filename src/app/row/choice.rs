//! Rows for one of several, and for on and off.

use super::{About, row};
use crate::app::symbol::Lit;
use crate::scene::ChoiceOption;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, ComboBox, Ui, WidgetInfo};

/// One of several options, each with its place, from a list that opens. Returns the place of another one chosen.
pub fn choice_of(
    ui: &mut Ui,
    lit: &mut Lit,
    about: &About<'_>,
    default: usize,
    options: &[(usize, &ChoiceOption)],
    present: usize,
) -> Option<usize> {
    let mut chosen = present;
    let reset = row(ui, lit, about, present != default, |ui| {
        let shown = options.iter().find(|(place, _)| *place == present).map_or("", |(_, option)| option.label);
        let list = ComboBox::from_id_salt(about.name()).selected_text(shown).width(ui.available_width()).height(420.0);
        let response = list.show_ui(ui, |ui| {
            for (place, option) in options {
                let response = ui.selectable_value(&mut chosen, *place, option.label);
                if !option.help.is_empty() {
                    response.on_hover_text(option.help);
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
    let wanted = if reset { default } else { chosen };
    (wanted != present).then_some(wanted)
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
