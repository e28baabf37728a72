//! Rows with a slider and a field for a number.

use super::{About, FIELD, row};
use crate::app::focus;
use crate::app::symbol::Lit;
use crate::scene::Rgb;
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, DragValue, Response, Slider, SliderClamping, Ui, WidgetInfo, vec2};
use std::ops::RangeInclusive;

/// Width of the switch that makes a number infinite, points.
const INFINITY_SWITCH: f32 = 26.0;

/// The slider of a number and the limits of what may be typed.
#[derive(Clone, Debug)]
pub struct SliderRange {
    /// What the slider spans.
    pub span: RangeInclusive<f64>,
    /// What the field takes.
    pub limits: RangeInclusive<f64>,
    /// Whether a number typed beyond the limits is left for the scene's own check to refuse, with its reason; otherwise
    /// it becomes the nearest limit.
    pub refuses: bool,
    pub logarithmic: bool,
    /// Digits after the point at most.
    pub decimals: usize,
    pub suffix: &'static str,
}

impl SliderRange {
    /// A linear slider over `span`, with three decimals and no limit but to be finite and not negative.
    pub fn linear(span: RangeInclusive<f64>) -> Self {
        Self { span, limits: 0.0..=f64::MAX, refuses: false, logarithmic: false, decimals: 3, suffix: "" }
    }

    /// The same, logarithmic.
    pub fn logarithmic(span: RangeInclusive<f64>) -> Self {
        Self { logarithmic: true, ..Self::linear(span) }
    }
}

/// A row for one number; `default` is what resetting gives.
pub struct NumberRow<'a> {
    pub about: About<'a>,
    pub range: SliderRange,
    pub default: f64,
}

impl NumberRow<'_> {
    /// Whether infinity is one of the values, with a switch of its own.
    fn reaches_infinity(&self) -> bool {
        *self.range.limits.end() == f64::INFINITY
    }
}

/// A slider with a field.
pub fn number(ui: &mut Ui, lit: &mut Lit, spec: &NumberRow<'_>, value: &mut f64) {
    let changed = value.to_bits() != spec.default.to_bits();
    if row(ui, lit, &spec.about, changed, |ui| slider_and_field(ui, spec, value)) {
        *value = spec.default;
    }
}

/// A slider with a field for a whole number.
pub fn whole(ui: &mut Ui, lit: &mut Lit, spec: &NumberRow<'_>, value: &mut u32) {
    let mut real = f64::from(*value);
    number(ui, lit, spec, &mut real);
    // The limits keep it inside; the cast saturates.
    *value = real.round() as u32;
}

/// A coefficient of the material: one slider, which keeps the ratio of the channels, and with `channels` a field each.
pub fn coefficient(
    ui: &mut Ui,
    lit: &mut Lit,
    about: &About<'_>,
    range: &SliderRange,
    default: Rgb,
    channels: bool,
    value: &mut Rgb,
) {
    let largest = value.max_element();
    let mut scalar = largest;
    let spec = NumberRow { about: about.clone(), range: range.clone(), default: default.max_element() };
    if row(ui, lit, about, *value != default, |ui| slider_and_field(ui, &spec, &mut scalar)) {
        *value = default;
    } else if scalar.to_bits() != largest.to_bits() {
        let keeps_ratio = *value != Rgb::splat(largest) && largest > 0.0 && scalar > 0.0;
        *value = if keeps_ratio { *value * (scalar / largest) } else { Rgb::splat(scalar) };
    }
    if channels || *value != Rgb::splat(value.x) {
        let name = format!("{} per channel", about.name());
        let channels = About { letter: "", label: "", name: &name, ..about.clone() };
        row(ui, lit, &channels, false, |ui| three_fields(ui, about.name(), value));
    }
}

/// Red, green and blue as three fields.
pub fn three_fields(ui: &mut Ui, name: &str, value: &mut Rgb) {
    fields(ui, name, &SliderRange { decimals: 2, ..SliderRange::linear(0.0..=1.0) }, value);
}

/// RGB values within the limits of `range`.
pub fn triple(ui: &mut Ui, lit: &mut Lit, about: &About<'_>, range: &SliderRange, default: Rgb, value: &mut Rgb) {
    if row(ui, lit, about, *value != default, |ui| fields(ui, about.name(), range, value)) {
        *value = default;
    }
}

/// Two numbers side by side.
pub fn field_pair(
    ui: &mut Ui,
    lit: &mut Lit,
    about: &About<'_>,
    range: &SliderRange,
    default: [f64; 2],
    value: &mut [f64; 2],
) {
    let reset = row(ui, lit, about, *value != default, |ui| {
        let width = (ui.available_width() - ui.spacing().item_spacing.x).max(0.0) / 2.0;
        for (side, part) in ["width", "height"].into_iter().zip(value.iter_mut()) {
            field(ui, &format!("{} {side}", about.name()), part, range, width);
        }
    });
    if reset {
        *value = default;
    }
}

fn fields(ui: &mut Ui, name: &str, range: &SliderRange, value: &mut Rgb) {
    let width = (ui.available_width() - 2.0 * ui.spacing().item_spacing.x).max(0.0) / 3.0;
    for (channel, part) in ["red", "green", "blue"].into_iter().zip(value.as_mut()) {
        field(ui, &format!("{name} {channel}"), part, range, width);
    }
}

fn slider_and_field(ui: &mut Ui, spec: &NumberRow<'_>, value: &mut f64) {
    let space = ui.spacing().item_spacing.x;
    let switch = if spec.reaches_infinity() { INFINITY_SWITCH + space } else { 0.0 };
    ui.spacing_mut().slider_width = (ui.available_width() - FIELD - space - switch).max(40.0);
    if let Some(tint) = spec.about.tint {
        ui.visuals_mut().selection.bg_fill = tint;
    }
    let slider = slider(ui, spec, value);
    let field = field(ui, spec.about.name(), value, &spec.range, FIELD);
    if !spec.about.tip.is_empty() {
        slider.on_hover_text(spec.about.tip);
        field.on_hover_text(spec.about.tip);
    }
    if spec.reaches_infinity() {
        infinity_switch(ui, spec, value);
    }
}

fn infinity_switch(ui: &mut Ui, spec: &NumberRow<'_>, value: &mut f64) {
    let on = *value == f64::INFINITY;
    let button = Button::selectable(on, "∞").min_size(vec2(INFINITY_SWITCH, 0.0));
    let response = ui.scope(|ui| {
        ui.spacing_mut().button_padding.x = 4.0;
        ui.add(button)
    });
    let (enabled, name) = (ui.is_enabled(), format!("{} infinite", spec.about.name()));
    response.inner.widget_info(|| WidgetInfo::selected(Role::Button, enabled, on, &name));
    if response.inner.on_hover_text("Infinity: a mirror").clicked() {
        *value = if !on {
            f64::INFINITY
        } else if spec.default.is_finite() {
            spec.default
        } else {
            *spec.range.span.end()
        };
    }
}

fn slider(ui: &mut Ui, spec: &NumberRow<'_>, value: &mut f64) -> Response {
    let (range, before) = (&spec.range, *value);
    let mut slider = Slider::new(value, range.span.clone())
        .show_value(false)
        .clamping(SliderClamping::Edits)
        .logarithmic(range.logarithmic)
        .smallest_positive(range.span.start().max(1e-6));
    if range.decimals == 0 {
        slider = slider.integer();
    }
    let response = ui.add(slider);
    if value.is_nan() {
        // A screen reader may send anything.
        *value = before;
    }
    let (enabled, shown) = (ui.is_enabled(), *value);
    response.widget_info(|| WidgetInfo::slider(enabled, shown, spec.about.name()));
    response
}

/// A field for one number, which takes its limits, `inf` and `∞`.
pub fn field(ui: &mut Ui, name: &str, value: &mut f64, range: &SliderRange, width: f32) -> Response {
    let size = vec2(width, ui.spacing().interact_size.y);
    let (decimals, before) = (range.decimals, *value);
    let speed =
        if range.logarithmic { value.abs().max(1e-3) * 0.01 } else { (range.span.end() - range.span.start()) * 0.002 };
    let allowed = if range.refuses { f64::MIN..=f64::INFINITY } else { range.limits.clone() };
    let widget = DragValue::new(value)
        .range(allowed)
        .clamp_existing_to_range(false)
        .speed(if decimals == 0 { speed.max(0.1) } else { speed })
        .suffix(range.suffix)
        .update_while_editing(false)
        .custom_formatter(move |value, _| display(value, decimals))
        .custom_parser(parse);
    let response = ui.add_sized(size, widget);
    focus::register(&response);
    // A screen reader's number comes past the widget's own allowed, and may be none.
    if value.is_nan() {
        *value = before;
    }
    if response.changed() && (!range.refuses || response.dragged()) {
        *value = value.clamp(*range.limits.start(), *range.limits.end());
    }
    let (enabled, shown) = (ui.is_enabled(), *value);
    response.widget_info(|| WidgetInfo { label: Some(name.to_owned()), ..WidgetInfo::drag_value(enabled, shown) });
    response
}

/// A number as fields show it: no more digits than mean something.
pub fn display(value: f64, decimals: usize) -> String {
    if value == f64::INFINITY {
        return "∞".to_owned();
    }
    let size = value.abs();
    // Near 0 the narrow fields of colours and vectors have one digit more, and short exponents.
    let narrow = decimals == 2 && size < 0.1;
    let decimals = if narrow { 3 } else { decimals };
    if narrow && size > 0.0 && size < 5e-4 {
        return format!("{value:.0e}");
    }
    if size >= 1e7 || (size > 0.0 && size < 0.5 * 10f64.powi(-(decimals.min(9) as i32))) {
        return format!("{value:.2e}");
    }
    let digits = match size {
        s if s >= 1000.0 => 0,
        s if s >= 100.0 => decimals.min(1),
        s if s >= 10.0 => decimals.min(2),
        _ => decimals,
    };
    let text = format!("{value:.digits$}");
    if digits > 2 && text.ends_with('0') { text[..text.len() - 1].to_owned() } else { text }
}

fn parse(text: &str) -> Option<f64> {
    let text = text.trim().replace(['\u{2009}', ' ', '°'], "").replace('−', "-").replace(',', ".");
    match text.as_str() {
        "∞" => Some(f64::INFINITY),
        _ => text.parse().ok().filter(|value: &f64| !value.is_nan()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_show_the_digits_that_mean_something() {
        for (value, decimals, text) in [
            (0.1, 3, "0.10"),
            (0.125, 3, "0.125"),
            (32.0, 2, "32.00"),
            (123.456, 2, "123.5"),
            (1005.0, 2, "1005"),
            (f64::INFINITY, 2, "∞"),
            (-1.5, 2, "-1.50"),
            (1e9, 2, "1.00e9"),
            (0.0, 3, "0.00"),
            (1e-7, 3, "1.00e-7"),
            (0.065, 2, "0.065"),
            (0.07, 2, "0.07"),
            (0.002, 2, "0.002"),
            (0.0, 2, "0.00"),
            (2e-4, 2, "2e-4"),
        ] {
            assert_eq!(display(value, decimals), text);
        }
    }

    #[test]
    fn what_is_shown_can_be_typed() {
        for value in [0.1, 32.0, 1005.0, f64::INFINITY, 1e9, -2.5] {
            assert_eq!(parse(&display(value, 3)), Some(value));
        }
        assert_eq!(parse("0,5"), Some(0.5));
        assert_eq!(parse("−3"), Some(-3.0));
        assert_eq!(parse("nan"), None);
        assert_eq!(parse("x"), None);
    }
}
