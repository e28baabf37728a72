//! Rows for colours and for points and directions.

use super::number::{SliderRange, field, three_fields};
use super::{About, row};
use crate::app::symbol::Lit;
use crate::scene::Rgb;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Color32, Popup, PopupCloseBehavior, Sense, Slider, SliderClamping, StrokeKind, Ui, WidgetInfo, vec2,
};
use glam::DVec3;

/// Colours worth a click.
const CHIPS: [(&str, Rgb); 10] = [
    ("White", Rgb::new(1.0, 1.0, 1.0)),
    ("Grey", Rgb::new(0.5, 0.5, 0.5)),
    ("Black", Rgb::new(0.0, 0.0, 0.0)),
    ("Warm white", Rgb::new(1.0, 0.85, 0.65)),
    ("Cool white", Rgb::new(0.75, 0.87, 1.0)),
    ("Red", Rgb::new(0.9, 0.3, 0.2)),
    ("Yellow", Rgb::new(0.9, 0.75, 0.2)),
    ("Green", Rgb::new(0.3, 0.7, 0.35)),
    ("Blue", Rgb::new(0.25, 0.45, 0.9)),
    ("Violet", Rgb::new(0.65, 0.35, 0.8)),
];

/// A linear colour as the textbooks' display shows it.
pub fn swatch(colour: Rgb) -> Color32 {
    let [r, g, b] = colour.to_array().map(|value| (value.clamp(0.0, 1.0) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

/// A colour: a swatch that opens sliders, and a field for each channel.
pub fn colour(ui: &mut Ui, lit: &mut Lit, about: &About<'_>, default: Rgb, value: &mut Rgb) {
    let reset = row(ui, lit, about, *value != default, |ui| {
        swatch_button(ui, about.name(), value);
        three_fields(ui, about.name(), value);
    });
    if reset {
        *value = default;
    }
}

fn swatch_button(ui: &mut Ui, name: &str, value: &mut Rgb) {
    let (rect, response) = ui.allocate_exact_size(vec2(26.0, 20.0), Sense::click());
    let stroke = if response.hovered() || response.has_focus() {
        ui.visuals().widgets.hovered.fg_stroke
    } else {
        ui.visuals().window_stroke
    };
    ui.painter().rect(rect, 4.0, swatch(*value), stroke, StrokeKind::Inside);
    let (enabled, label) = (ui.is_enabled(), format!("{name} colour"));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, &label));
    let response = response.on_hover_text("Choose a colour");
    Popup::menu(&response).close_behavior(PopupCloseBehavior::CloseOnClickOutside).show(|ui| picker(ui, name, value));
}

fn picker(ui: &mut Ui, name: &str, value: &mut Rgb) {
    ui.spacing_mut().slider_width = 170.0;
    for (channel, part) in ["red", "green", "blue"].into_iter().zip(value.as_mut()) {
        ui.horizontal(|ui| {
            ui.add_sized(vec2(44.0, 20.0), eframe::egui::Label::new(channel));
            let slider = Slider::new(part, 0.0..=1.0).show_value(false).clamping(SliderClamping::Edits);
            let response = ui.add(slider);
            let shown = *part;
            response.widget_info(|| WidgetInfo::slider(true, shown, format!("{name} {channel} slider")));
            ui.label(eframe::egui::RichText::new(format!("{shown:.2}")).monospace());
        });
    }
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (label, chip) in CHIPS {
            let (rect, response) = ui.allocate_exact_size(vec2(22.0, 22.0), Sense::click());
            ui.painter().rect(rect, 4.0, swatch(chip), ui.visuals().window_stroke, StrokeKind::Inside);
            response.widget_info(|| WidgetInfo::labeled(Role::Button, true, label));
            if response.on_hover_text(label).clicked() {
                *value = chip;
            }
        }
    });
}

/// A point or a direction: a field for each axis.
pub fn vector(ui: &mut Ui, lit: &mut Lit, about: &About<'_>, default: DVec3, value: &mut DVec3) {
    let reset = row(ui, lit, about, *value != default, |ui| {
        let width = (ui.available_width() - 2.0 * ui.spacing().item_spacing.x).max(0.0) / 3.0;
        let range = SliderRange { limits: -1e15..=1e15, decimals: 2, ..SliderRange::linear(-5.0..=5.0) };
        for (axis, part) in ["x", "y", "z"].into_iter().zip(value.as_mut()) {
            field(ui, &format!("{} {axis}", about.name()), part, &range, width);
        }
    });
    if reset {
        *value = default;
    }
}
