//! Row controls for colours, points, choices, switches and text.

use super::layout::About;
use super::number::{AXES, CHANNELS, SliderRange, fields};
use crate::app::widgets::fingers::{Held, hold};
use crate::app::widgets::focus::{aside, named, switch_named};
use crate::app::widgets::swatch::swatch_ui;
use crate::app::widgets::theme::text_field;
use crate::scene::{ChoiceOption, Rgb};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Button, ComboBox, Label, Popup, PopupCloseBehavior, Slider, SliderClamping, Ui, WidgetInfo,
    vec2,
};
use glam::DVec3;

/// Preset colours, with the keys of their names.
const CHIPS: [(&str, Rgb); 10] = [
    ("controls-chip-white", Rgb::new(1.0, 1.0, 1.0)),
    ("controls-chip-grey", Rgb::new(0.5, 0.5, 0.5)),
    ("controls-chip-black", Rgb::new(0.0, 0.0, 0.0)),
    ("controls-chip-warm-white", Rgb::new(1.0, 0.85, 0.65)),
    ("controls-chip-cool-white", Rgb::new(0.75, 0.87, 1.0)),
    ("controls-chip-red", Rgb::new(0.9, 0.3, 0.2)),
    ("controls-chip-yellow", Rgb::new(0.9, 0.75, 0.2)),
    ("controls-chip-green", Rgb::new(0.3, 0.7, 0.35)),
    ("controls-chip-blue", Rgb::new(0.25, 0.45, 0.9)),
    ("controls-chip-violet", Rgb::new(0.65, 0.35, 0.8)),
];

/// Shows a swatch that opens sliders.
pub fn swatch_button(ui: &mut Ui, name: &str, value: &mut Rgb) {
    // As high as its row, for fingers; the visible part is lower.
    let size = vec2(26.0, ui.spacing().interact_size.y);
    let response = swatch_ui(ui, *value, vec2(26.0, 20.0), size);
    let label = text!("controls-swatch", name = name);
    let response =
        named(response, Role::Button, &label).on_hover_text(text!("controls-swatch-tip"));
    aside(&response);
    Popup::menu(&response)
        .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
        .show(|ui| picker(ui, name, value));
}

fn picker(ui: &mut Ui, name: &str, value: &mut Rgb) {
    ui.spacing_mut().slider_width = 170.0;
    let channels = CHANNELS.map(|key| text!(key));
    for (channel, part) in channels.into_iter().zip(value.as_mut()) {
        ui.horizontal(|ui| {
            ui.add_sized(vec2(44.0, 20.0), Label::new(channel));
            let slider = Slider::new(part, 0.0..=1.0)
                .show_value(false)
                .clamping(SliderClamping::Edits);
            let response = ui.add(slider);
            hold(&response, Held::Slider);
            let shown = *part;
            response.widget_info(|| {
                WidgetInfo::slider(
                    true,
                    shown,
                    text!("controls-channel-slider", name = name, channel = channel),
                )
            });
            ui.monospace(format!("{shown:.2}"));
        });
    }
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (label, chip) in CHIPS {
            let size = vec2(22.0, 22.0);
            let label = text!(label);
            let response = named(swatch_ui(ui, chip, size, size), Role::Button, label);
            if response.on_hover_text(label).clicked() {
                *value = chip;
            }
        }
    });
}

/// Shows a field for each axis of a point or a direction.
pub fn axes(ui: &mut Ui, name: &str, value: &mut DVec3) {
    let range = SliderRange {
        limits: -1e15..=1e15,
        decimals: 2,
        ..SliderRange::linear(-5.0..=5.0)
    };
    fields(ui, name, AXES, &range, value.as_mut());
}

/// Shows a drop-down list of several options, each given with its index.
pub fn choice(
    ui: &mut Ui,
    about: &About<'_>,
    options: Vec<(usize, &ChoiceOption)>,
    chosen: &mut usize,
) {
    let shown = options
        .iter()
        .find(|(place, _)| *place == *chosen)
        .map_or("", |(_, option)| option.label());
    let list = ComboBox::from_id_salt(about.name())
        .selected_text(shown)
        .width(ui.available_width())
        .truncate()
        .height(420.0);
    let response = list.show_ui(ui, |ui| {
        for (place, option) in options {
            let response = ui.selectable_value(chosen, place, option.label());
            response.on_hover_text(option.help());
        }
    });
    let enabled = ui.is_enabled();
    response.response.widget_info(|| WidgetInfo {
        current_text_value: Some(shown.to_owned()),
        ..WidgetInfo::labeled(Role::ComboBox, enabled, about.name())
    });
    response.response.on_hover_text(about.tip);
}

/// Shows a switch between on and off.
pub fn toggle(ui: &mut Ui, name: &str, value: &mut bool) {
    let [on, off] = [text!("controls-on"), text!("controls-off")];
    for (state, label) in [(true, on), (false, off)] {
        let chosen = *value == state;
        let button = ui.add(Button::selectable(chosen, label).min_size(vec2(44.0, 0.0)));
        // Tab stops only at the option that is not chosen.
        if chosen {
            aside(&button);
        }
        if switch_named(button, Role::Button, chosen, &format!("{name} {label}")).clicked() {
            *value = state;
        }
    }
}

/// Shows a text field of at most `longest` characters, which may be empty.
pub fn text(ui: &mut Ui, about: &About<'_>, longest: usize, value: &mut String) {
    let field = text_field(value)
        .char_limit(longest)
        .hint_text(text!("controls-no-name"))
        .desired_width(ui.available_width());
    let response = ui.add(field);
    let (enabled, shown) = (ui.is_enabled(), value.clone());
    response.widget_info(|| WidgetInfo {
        current_text_value: Some(shown.clone()),
        ..WidgetInfo::labeled(Role::TextInput, enabled, about.name())
    });
    if response.changed() {
        value.retain(|character| !character.is_control());
    }
    response.on_hover_text(about.tip);
}
