//! Rows with a slider and a field for a number, and rows of several fields.

use super::expression::evaluate;
use super::layout::{About, BESIDE, FIELD, RESET, row, value_row};
use crate::app::widgets::fingers::{Held, hold};
use crate::app::widgets::focus::{aside, escaped, switch_named};
use crate::scene::Rgb;
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::style::HandleShape;
use eframe::egui::{
    Align, Button, DragValue, Layout, Rect, Response, Slider, SliderClamping, Stroke, StrokeKind,
    Tooltip, Ui, UiBuilder, WidgetInfo, vec2,
};
use std::cell::RefCell;
use std::ops::RangeInclusive;

/// The keys of the channels' names.
pub const CHANNELS: [&str; 3] = ["controls-red", "controls-green", "controls-blue"];
/// The keys of the axes' names.
pub const AXES: [&str; 3] = ["controls-x", "controls-y", "controls-z"];
/// The keys of the names of two lengths.
pub const SIDES: [&str; 2] = ["controls-width", "controls-height"];
/// Minimum width of a slider, of one whose range is not bounded, and of the field beside it, in points. A hand needs the
/// width: with less, a point of movement would change the exponent n by more than 6 %.
const SLIDER: f32 = 124.0;
const OPEN_SLIDER: f32 = 160.0;
const LEAST_FIELD: f32 = 50.0;
/// The step of a value with Shift, as a fraction of that without.
const FINE: f32 = 0.1;
/// Space between the parts of a row's control, in points.
const SPACE: f32 = 6.0;
/// Width kept for three fields, in points. If all numbers are negative, they take slightly more.
pub const FIELDS: f32 = 138.0;
/// Width of the switch that makes a number infinite, in points.
const INFINITY_SWITCH: f32 = 26.0;

/// The slider of a number, and the limits of its field.
#[derive(Clone, Debug)]
pub struct SliderRange {
    /// Range of the slider.
    pub span: RangeInclusive<f64>,
    /// Range of the field.
    pub limits: RangeInclusive<f64>,
    /// True if a number typed beyond the limits is left for the scene's validation to refuse, with its reason. Otherwise it
    /// becomes the nearest limit.
    pub refuses: bool,
    pub logarithmic: bool,
    /// Maximum number of digits after the decimal point.
    pub decimals: usize,
    pub suffix: &'static str,
}

impl SliderRange {
    /// Range of the narrow fields of colours.
    pub const SHORT: Self = Self {
        decimals: 2,
        ..Self::linear(0.0..=1.0)
    };

    /// Returns a linear slider over `span` with three decimals. Its field takes any finite number that is not negative.
    pub const fn linear(span: RangeInclusive<f64>) -> Self {
        Self {
            span,
            limits: 0.0..=f64::MAX,
            refuses: false,
            logarithmic: false,
            decimals: 3,
            suffix: "",
        }
    }

    /// Returns the width that a slider and its field need side by side, in points.
    pub fn room(&self) -> f32 {
        if self.is_open() {
            OPEN_SLIDER + LEAST_FIELD + INFINITY_SWITCH + 2.0 * SPACE
        } else {
            SLIDER + LEAST_FIELD + SPACE
        }
    }

    /// Returns `value` moved along the slider by a fraction of its length.
    pub fn moved(&self, value: f64, by: f64) -> f64 {
        let (from, to) = (*self.span.start(), *self.span.end());
        let moved = if self.logarithmic && from > 0.0 {
            value * (to / from).powf(by)
        } else {
            value + (to - from) * by
        };
        moved.clamp(from, to)
    }

    /// Returns whether the limits include infinity.
    fn is_open(&self) -> bool {
        *self.limits.end() == f64::INFINITY
    }

    /// Returns a logarithmic slider over `span`, otherwise like [`Self::linear`].
    pub fn logarithmic(span: RangeInclusive<f64>) -> Self {
        Self {
            logarithmic: true,
            ..Self::linear(span)
        }
    }
}

/// Description of a row for one number. Resetting restores `default`.
pub struct NumberRow<'a> {
    pub about: About<'a>,
    pub range: SliderRange,
    pub default: f64,
}

impl<'a> NumberRow<'a> {
    /// Returns the row's description with the width that slider and field need.
    fn about(&self) -> About<'a> {
        About {
            room: self.range.room(),
            ..self.about.clone()
        }
    }
}

/// Shows a row with a slider and a field.
pub fn number(ui: &mut Ui, spec: &NumberRow<'_>, value: &mut f64) {
    value_row(ui, &spec.about(), spec.default, value, |ui, value| {
        slider_and_field(ui, spec, value);
    });
}

/// Shows a row with a slider and a field for a whole number.
pub fn whole(ui: &mut Ui, spec: &NumberRow<'_>, value: &mut u32) {
    let default = spec.default as u32;
    value_row(ui, &spec.about(), default, value, |ui, value| {
        whole_slider(ui, spec, value);
    });
}

/// Shows a slider and a field for a whole number.
pub fn whole_slider(ui: &mut Ui, spec: &NumberRow<'_>, value: &mut u32) {
    let mut real = f64::from(*value);
    slider_and_field(ui, spec, &mut real);
    // The limits keep it in range; the cast saturates.
    *value = real.round() as u32;
}

/// Shows a slider for the largest channel of a coefficient, which keeps the ratio of the channels.
pub fn coefficient_slider(ui: &mut Ui, spec: &NumberRow<'_>, value: &mut Rgb) {
    let largest = value.max_element();
    let mut scalar = largest;
    slider_and_field(ui, spec, &mut scalar);
    if scalar.to_bits() != largest.to_bits() {
        *value = scaled(*value, largest, scalar);
    }
}

/// Scales a coefficient whose largest channel is `from` so that it becomes `to`; from or to 0, all channels are equal.
pub fn scaled(value: Rgb, from: f64, to: f64) -> Rgb {
    let keeps_ratio = value != Rgb::splat(from) && from > 0.0 && to > 0.0;
    if keeps_ratio {
        value * (to / from)
    } else {
        Rgb::splat(to)
    }
}

/// Shows a field for each channel of a coefficient, below its slider.
pub fn channels_row(ui: &mut Ui, about: &About<'_>, value: &mut Rgb) {
    let name = text!("controls-per-channel", name = about.name());
    let channels = About {
        letter: "",
        label: "",
        name: &name,
        room: FIELDS,
        ..about.clone()
    };
    row(ui, &channels, false, |ui| {
        fields(
            ui,
            about.name(),
            CHANNELS,
            &SliderRange::SHORT,
            value.as_mut(),
        );
    });
}

/// Shows numbers side by side; `parts` are the keys of their names.
pub fn fields<const N: usize>(
    ui: &mut Ui,
    name: &str,
    parts: [&str; N],
    range: &SliderRange,
    values: &mut [f64; N],
) {
    // Four digits fit side by side, even in a narrow panel.
    let spacing = ui.spacing_mut();
    spacing.item_spacing.x = 4.0;
    spacing.button_padding.x = 2.0;
    let gaps = (N - 1) as f32 * spacing.item_spacing.x;
    let width = (ui.available_width() - gaps).max(0.0) / N as f32;
    ui.spacing_mut().interact_size.x = width;
    for (part, value) in parts.into_iter().zip(values) {
        field(ui, &format!("{name} {}", text!(part)), value, range, width);
    }
}

/// Shows a slider and a field, and a switch for infinity if the limits include it.
pub fn slider_and_field(ui: &mut Ui, spec: &NumberRow<'_>, value: &mut f64) {
    ui.spacing_mut().item_spacing.x = SPACE;
    let reaches_infinity = spec.range.is_open();
    let (least, switch) = if reaches_infinity {
        (OPEN_SLIDER, INFINITY_SWITCH + SPACE)
    } else {
        (SLIDER, 0.0)
    };
    let alone = spec.about.room.is_infinite();
    let room = ui.available_width() - SPACE - switch;
    let width = (room - least).clamp(LEAST_FIELD, FIELD);
    ui.spacing_mut().slider_width = if alone {
        ui.available_width()
    } else {
        (room - width).max(SLIDER)
    };
    if let Some(tint) = spec.about.tint {
        ui.visuals_mut().selection.bg_fill = tint;
    }
    let (range, name, tip, before) = (&spec.range, spec.about.name(), spec.about.tip, *value);
    let slider = Slider::new(value, range.span.clone())
        .show_value(false)
        .handle_shape(HandleShape::Rect { aspect_ratio: 0.5 })
        .clamping(SliderClamping::Edits)
        .logarithmic(range.logarithmic)
        .smart_aim(!range.logarithmic)
        .smallest_positive(range.span.start().max(1e-6));
    let response = ui.add(if range.decimals == 0 {
        slider.integer()
    } else {
        slider
    });
    if value.is_nan() {
        // A screen reader may send anything.
        *value = before;
    }
    if response.dragged() && ui.input(|input| input.modifiers.shift) {
        let moved = ui.input(|input| input.pointer.delta().x) / response.rect.width();
        *value = range.moved(before, f64::from(FINE * moved));
    } else if response.dragged() && range.logarithmic {
        // egui's own aim at round numbers would jump by more than a hand means.
        *value = rounded(*value);
    }
    let (enabled, shown) = (ui.is_enabled(), *value);
    response.widget_info(|| WidgetInfo::slider(enabled, shown, name));
    aside(&response);
    hold(&response, Held::Slider);
    response.on_hover_text(tip);
    let mut beside = alone.then(|| beside_label(ui, if reaches_infinity { BESIDE } else { FIELD }));
    let ui = beside.as_mut().unwrap_or(ui);
    field(ui, name, value, range, width).on_hover_text(tip);
    if reaches_infinity {
        let on = *value == f64::INFINITY;
        ui.spacing_mut().button_padding.x = 4.0;
        let button = ui.add(Button::selectable(on, "∞").min_size(vec2(INFINITY_SWITCH, 0.0)));
        let switch = text!("controls-infinite", name = name);
        let button = switch_named(button, Role::Button, on, &switch);
        aside(&button);
        let button = button.on_hover_text(text!("controls-infinite-tip"));
        if button.clicked() {
            let finite = if spec.default.is_finite() {
                spec.default
            } else {
                *range.span.end()
            };
            *value = if on { finite } else { f64::INFINITY };
        }
    }
}

/// Returns a child `Ui` of this width beside the label, above a slider that has a line of its own.
fn beside_label(ui: &mut Ui, width: f32) -> Ui {
    let line = ui.max_rect();
    let right = line.right_top() - vec2(RESET, 0.0);
    let rect = Rect::from_min_max(right - vec2(width, line.height()), right);
    ui.new_child(
        UiBuilder::new()
            .max_rect(rect)
            .layout(Layout::left_to_right(Align::Center)),
    )
}

/// Rounds a number to three significant digits.
fn rounded(value: f64) -> f64 {
    // By its digits, so that no 1.1400000000000001 stands in files and links.
    format!("{value:.2e}").parse().unwrap_or(value)
}

/// Shows a field for one number, or for arithmetic that gives one.
///
/// Text that is not a number leaves the value unchanged, and the field says so until it is edited again.
pub fn field(
    ui: &mut Ui,
    name: &str,
    value: &mut f64,
    range: &SliderRange,
    width: f32,
) -> Response {
    let size = vec2(width, ui.spacing().interact_size.y);
    let (decimals, before) = (range.decimals, *value);
    let speed = if range.logarithmic {
        value.abs().max(1e-3) * 0.01
    } else {
        (range.span.end() - range.span.start()) * 0.002
    };
    let allowed = if range.refuses {
        f64::MIN..=f64::INFINITY
    } else {
        range.limits.clone()
    };
    let refused = RefCell::new(None);
    let dropped = escaped(ui.ctx());
    let parse = |text: &str| {
        if dropped {
            return None;
        }
        // A value left as displayed keeps the digits that are not shown.
        if text.trim() == display(before, decimals) {
            return Some(before);
        }
        let number = evaluate(text);
        if number.is_none() && !text.trim().is_empty() {
            refused.replace(Some(text.trim().to_owned()));
        }
        number
    };
    let widget = DragValue::new(value)
        .range(allowed)
        .clamp_existing_to_range(false)
        .speed(if decimals == 0 { speed.max(0.1) } else { speed })
        .suffix(range.suffix)
        .update_while_editing(false)
        .custom_formatter(move |value, _| display(value, decimals))
        .custom_parser(parse);
    let response = ui.add_sized(size, widget);
    hold(&response, Held::Field);
    // A number from a screen reader bypasses the widget's own filter and may be NaN.
    if value.is_nan() {
        *value = before;
    }
    if response.changed() && (!range.refuses || response.dragged()) {
        *value = value.clamp(*range.limits.start(), *range.limits.end());
    }
    let (enabled, shown) = (ui.is_enabled(), *value);
    response.widget_info(|| WidgetInfo {
        label: Some(name.to_owned()),
        ..WidgetInfo::drag_value(enabled, shown)
    });
    let edited = response.has_focus() || response.dragged() || shown.to_bits() != before.to_bits();
    wrong(&response, refused.into_inner(), edited);
    response
}

/// Marks a field whose text was `refused` with a red frame and the reason, until it is `edited` or something else is clicked.
fn wrong(response: &Response, refused: Option<String>, edited: bool) {
    let id = response.id.with("refused");
    let ctx = &response.ctx;
    let elsewhere = ctx.input(|input| input.pointer.any_pressed());
    if let Some(text) = refused {
        ctx.data_mut(|data| data.insert_temp(id, text));
    } else if edited || elsewhere {
        ctx.data_mut(|data| data.remove_temp::<String>(id));
    }
    let Some(text) = ctx.data(|data| data.get_temp::<String>(id)) else {
        return;
    };
    let visuals = &ctx.global_style().visuals;
    let stroke = Stroke::new(2.0, visuals.error_fg_color);
    let rect = response.rect.expand(1.0);
    ctx.layer_painter(response.layer_id)
        .with_clip_rect(response.interact_rect.expand(3.0))
        .rect_stroke(rect, 6.0, stroke, StrokeKind::Middle);
    let mut tip = Tooltip::always_open(ctx.clone(), response.layer_id, id, response.rect);
    tip.popup = tip.popup.width(220.0);
    tip.show(|ui| {
        ui.colored_label(
            ui.visuals().error_fg_color,
            text!("controls-field-wrong", text = shortened(&text)),
        );
        ui.label(text!("controls-field-accepts"));
    });
}

/// Shortens a text so that it fits beside a reason.
fn shortened(text: &str) -> String {
    const MOST: usize = 24;
    if text.chars().count() <= MOST {
        return text.to_owned();
    }
    text.chars().take(MOST).chain(['…']).collect()
}

/// Formats a number for a field, with significant digits only.
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
    if digits > 2 && text.ends_with('0') {
        text[..text.len() - 1].to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_show_the_digits_that_mean_something() {
        assert_eq!(
            [0.1, 0.125, 0.0, 1e-7].map(|n| display(n, 3)),
            ["0.10", "0.125", "0.00", "1.00e-7"]
        );
        let large = [32.0, 123.456, 1005.0, 1e9, f64::INFINITY, -1.5].map(|n| display(n, 2));
        assert_eq!(large, ["32.00", "123.5", "1005", "1.00e9", "∞", "-1.50"]);
        let small = [0.07, 0.065, 0.002, 2e-4, 0.0].map(|n| display(n, 2));
        assert_eq!(small, ["0.07", "0.065", "0.002", "2e-4", "0.00"]);
    }

    #[test]
    fn what_is_shown_can_be_typed() {
        for value in [0.1, 32.0, 1005.0, f64::INFINITY, 1e9, -2.5] {
            assert_eq!(evaluate(&display(value, 3)), Some(value));
        }
    }
}
