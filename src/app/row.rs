//! A row of the panel of controls: what it is called, the control, and the way back to its value as opened. The row of a
//! parameter says what the parameter's description says.
//!
//! Every control is reachable by keyboard and has an accessible name; its label carries the symbol of the equation in
//! the symbol's colour, and pointing at either lights up the other.

mod number;
mod widgets;

pub use number::{NumberRow, SliderRange, display, number, whole};
pub use widgets::{axes, swatch};

use super::focus::named;
use super::palette::vector_text;
use super::symbol::{Lit, Symbol};
use crate::analysis::specular_vector;
use crate::figure::palette::Vector;
use crate::scene::parameter::{Access, Kind, Limits, Parameter, Slider, defaults};
use crate::scene::{ChoiceOption, Rgb, Scene};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Button, Color32, Label, Layout, Rect, Response, RichText, Sense, Ui, UiBuilder, Vec2, pos2, vec2,
};
use number::{CHANNELS, channels_row, coefficient_slider, fields, slider_and_field, whole_slider};
use widgets::{choice, swatch_button, text, toggle};

/// Width of the labels of a panel's rows, points.
const LABEL: f32 = 104.0;
/// Width kept for the reset button, points.
const RESET: f32 = 24.0;
/// Width of a number's field, points.
pub const FIELD: f32 = 66.0;

/// What a row is about.
#[derive(Clone, Debug, Default)]
pub struct About<'a> {
    /// The letter in front of the label, as in the equation.
    pub letter: &'a str,
    /// The letter's colour; none is ordinary text.
    pub tint: Option<Color32>,
    /// The label in words.
    pub label: &'a str,
    /// The accessible name; the label where empty.
    pub name: &'a str,
    /// What it means, with its unit.
    pub tip: &'a str,
    /// The symbol of the equation that it controls.
    pub symbol: Option<Symbol>,
    /// Why the control has no effect at present.
    pub idle: Option<&'a str>,
}

impl About<'_> {
    /// The accessible name.
    pub fn name(&self) -> &str {
        if self.name.is_empty() { self.label } else { self.name }
    }
}

/// A row for a value, which `control` edits and resetting takes back to `default`.
pub fn value_row<T: PartialEq>(
    ui: &mut Ui,
    lit: &mut Lit,
    about: &About<'_>,
    default: T,
    value: &mut T,
    control: impl FnOnce(&mut Ui, &mut T),
) {
    if row(ui, lit, about, *value != default, |ui| control(ui, value)) {
        *value = default;
    }
}

/// Lays out one row and fills it with `control`. Returns whether the row is to be reset; the button for that
/// is shown where it has been `changed`.
pub fn row(ui: &mut Ui, lit: &mut Lit, about: &About<'_>, changed: bool, control: impl FnOnce(&mut Ui)) -> bool {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    if about.symbol.is_some() && ui.rect_contains_pointer(rect) {
        lit.next = about.symbol;
    }
    if about.symbol.is_some() && lit.now == about.symbol {
        let fill = ui.visuals().widgets.hovered.bg_fill.gamma_multiply(0.55);
        ui.painter().rect_filled(rect.expand2(vec2(6.0, 1.0)), 5.0, fill);
    }
    let reset_here = label(ui, about, changed, Rect::from_min_size(rect.min, vec2(LABEL, size.y)));
    let inner = Rect::from_min_max(pos2(rect.min.x + LABEL, rect.min.y), pos2(rect.max.x - RESET, rect.max.y));
    let mut child = part(ui, about.name(), inner, Layout::left_to_right(Align::Center));
    if about.idle.is_some() {
        child.disable();
    }
    control(&mut child);
    if let Some(reason) = about.idle {
        ui.interact(inner, ui.scope_id().with((about.name(), "idle")), Sense::hover()).on_hover_text(reason);
    }
    if let Some(symbol) = about.symbol.filter(|symbol| lit.seek == Some(*symbol)) {
        ui.scroll_to_rect(rect, Some(Align::Center));
        lit.next = Some(symbol);
        lit.seek = None;
    }
    let reset_rect = Rect::from_min_max(pos2(rect.max.x - RESET, rect.min.y), rect.max);
    (changed && reset(ui, about, reset_rect)) || reset_here
}

/// A part of a row, laid out in `rect`, whose widgets keep their identity whatever rows come and go.
fn part(ui: &mut Ui, salt: impl std::hash::Hash + std::fmt::Debug, rect: Rect, layout: Layout) -> Ui {
    let mut child = ui.new_child(UiBuilder::new().scope_id(ui.scope_id().with(salt)).max_rect(rect).layout(layout));
    child.spacing_mut().item_spacing.x = 6.0;
    child
}

/// The label; a double click resets the row.
fn label(ui: &mut Ui, about: &About<'_>, changed: bool, rect: Rect) -> bool {
    let mut child = part(ui, (about.name(), "label"), rect, Layout::left_to_right(Align::Center));
    child.spacing_mut().item_spacing.x = 0.0;
    let mut response: Option<Response> = None;
    if !about.letter.is_empty() {
        let tint = about.tint.unwrap_or_else(|| child.visuals().strong_text_color());
        let letter =
            child.allocate_ui_with_layout(vec2(28.0, rect.height()), Layout::left_to_right(Align::Center), |ui| {
                ui.add(Label::new(RichText::new(about.letter).color(tint).strong()).sense(Sense::click()))
            });
        child.advance_cursor_after_rect(Rect::from_min_size(letter.response.rect.min, Vec2::new(28.0, rect.height())));
        response = Some(letter.inner);
    }
    if !about.label.is_empty() {
        let colour =
            if about.idle.is_some() { child.visuals().weak_text_color() } else { child.visuals().text_color() };
        let text = RichText::new(about.label).color(colour);
        let words = child.add(Label::new(text).truncate().sense(Sense::click()));
        response = Some(response.map_or(words.clone(), |letter| letter | words));
    }
    response.is_some_and(|response| response.on_hover_text(about.idle.unwrap_or(about.tip)).double_clicked() && changed)
}

fn reset(ui: &mut Ui, about: &About<'_>, rect: Rect) -> bool {
    let mut child = part(ui, (about.name(), "reset"), rect, Layout::right_to_left(Align::Center));
    let weak = child.visuals().weak_text_color();
    // For the pointer and for screen readers: Tab would stop at it between two fields.
    let button = Button::new(RichText::new("↺").color(weak)).frame(false).sense(Sense::CLICK);
    let response = child.add(button).on_hover_text("Back to the value as opened");
    named(response, Role::Button, &format!("Reset {}", about.name())).clicked()
}

/// A row for a parameter of the scene.
pub fn parameter(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, parameter: &'static Parameter) {
    parameter_with(ui, lit, scene, parameter, &View::default());
}

/// What a row shows otherwise than its parameter's description has it.
pub struct View {
    /// The number of the light that the parameter belongs to.
    pub index: usize,
    /// Whether coefficients always have a field for each channel.
    pub channels: bool,
    pub slider: Option<Slider>,
    /// The options that are offered; the present one always is.
    pub offered: fn(&Scene, &ChoiceOption) -> bool,
}

impl Default for View {
    fn default() -> Self {
        Self { index: 0, channels: false, slider: None, offered: |_, _| true }
    }
}

/// A row for a parameter, shown in a particular way.
pub fn parameter_with(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, parameter: &'static Parameter, view: &View) {
    let index = view.index;
    let (name, tip) = (parameter.full_name(index), tip(parameter, scene));
    let about = About {
        letter: parameter.letter,
        tint: tint(ui, scene, parameter),
        label: parameter.label,
        name: &name,
        tip: &tip,
        symbol: parameter.symbol,
        idle: (parameter.idle)(scene, index),
    };
    let (name, range) = (&*name, range(scene, parameter, view));
    let spec = |default| NumberRow { about: about.clone(), range: range.clone(), default };
    let mut row = Edited { ui, lit, scene, index, about: &about };
    match parameter.kind {
        Kind::Number(at, ..) => {
            row.edit(at, |ui, value, default| slider_and_field(ui, &spec(*default), value));
        }
        Kind::Whole(at, ..) => {
            row.edit(at, |ui, value, default| whole_slider(ui, &spec(f64::from(*default)), value));
        }
        Kind::Coefficient(at, ..) => {
            row.edit(at, |ui, value, default| coefficient_slider(ui, &spec(default.max_element()), value));
            if let Some(value) = (at.get_mut)(scene, index).filter(|value| view.channels || !is_grey(**value)) {
                channels_row(ui, lit, &about, value);
            }
        }
        Kind::Pair(at, ..) => row.edit(at, |ui, value, _| fields(ui, name, ["width", "height"], &range, value)),
        Kind::Channels(at, ..) => {
            row.edit(at, |ui, value, _| fields(ui, name, CHANNELS, &range, value.as_mut()));
        }
        Kind::Colour(at, _) => row.edit(at, |ui, value, _| {
            swatch_button(ui, name, value);
            fields(ui, name, CHANNELS, &SliderRange::SHORT, value.as_mut());
        }),
        Kind::Point(at) | Kind::Direction(at, _) => row.edit(at, |ui, value, _| axes(ui, name, value)),
        Kind::Choice(access) => {
            let opened = access.chosen(&lit.opened, index).or_else(|| access.chosen(defaults(), 0));
            let (Some(present), Some(default)) = (access.chosen(scene, index), opened) else { return };
            let options = access.options().iter().enumerate();
            let options =
                options.filter(|(place, option)| *place == present || (view.offered)(scene, option)).collect();
            let mut chosen = present;
            value_row(ui, lit, &about, default, &mut chosen, |ui, chosen| choice(ui, &about, options, chosen));
            if chosen != present {
                access.choose(scene, index, chosen);
            }
        }
        Kind::Switch(at) => row.edit(at, |ui, value, _| toggle(ui, name, value)),
        Kind::Text(at, longest) => row.edit(at, |ui, value, _| text(ui, &about, longest, value)),
        Kind::Other(..) => {}
    }
}

/// A row about a value of the scene.
struct Edited<'a> {
    ui: &'a mut Ui,
    lit: &'a mut Lit,
    scene: &'a mut Scene,
    index: usize,
    about: &'a About<'a>,
}

impl Edited<'_> {
    /// Shows the row. `control` gets the value and the one that resetting returns to: the default for a light that has been added.
    fn edit<T: Clone + PartialEq>(&mut self, at: &Access<T>, control: impl FnOnce(&mut Ui, &mut T, &T)) {
        let opened = (at.get)(&self.lit.opened, self.index).or_else(|| (at.get)(defaults(), 0)).cloned();
        if let (Some(value), Some(opened)) = ((at.get_mut)(self.scene, self.index), opened) {
            let default = opened.clone();
            value_row(self.ui, self.lit, self.about, opened, value, |ui, value| control(ui, value, &default));
        }
    }
}

fn is_grey(value: Rgb) -> bool {
    value == Rgb::splat(value.x)
}

/// The slider of a parameter, with the limits and the unit of its field.
fn range(scene: &Scene, parameter: &Parameter, view: &View) -> SliderRange {
    let slider = view.slider.or(parameter.slider()).unwrap_or(Slider::UNIT);
    let Limits { least, greatest } = parameter.limits(scene).unwrap_or(Limits::FINITE);
    SliderRange {
        span: slider.from.max(least)..=slider.to,
        limits: least..=greatest,
        refuses: true,
        logarithmic: slider.logarithmic,
        decimals: slider.decimals,
        suffix: if parameter.unit == "degrees" { "°" } else { "" },
    }
}

/// The help with letter, unit and range.
fn tip(parameter: &Parameter, scene: &Scene) -> String {
    let letter = if parameter.letter.is_empty() { String::new() } else { format!("{}: ", parameter.letter) };
    let limits = parameter.limits(scene).filter(|limits| parameter.slider().is_some() && limits.greatest <= 1e6);
    let range = limits.map_or_else(String::new, |limits| format!("{limits} "));
    let about = format!("{range}{}", parameter.unit);
    let about = if about.trim().is_empty() { String::new() } else { format!(" ({})", about.trim()) };
    format!("{letter}{}{about}", parameter.help)
}

/// The colour of the term or the vector that a parameter belongs to.
fn tint(ui: &Ui, scene: &Scene, parameter: &Parameter) -> Option<Color32> {
    let (visuals, model) = (ui.visuals(), scene.reflection.model);
    match parameter.symbol? {
        Symbol::Kd => Some(vector_text(visuals, Vector::L)),
        Symbol::Ks | Symbol::Exponent | Symbol::Facets => Some(vector_text(visuals, specular_vector(model))),
        Symbol::Kt | Symbol::Transmitted => Some(vector_text(visuals, Vector::T)),
        Symbol::Viewer => Some(vector_text(visuals, Vector::V)),
        Symbol::Light if parameter.letter == "L" || parameter.letter == "D" => Some(vector_text(visuals, Vector::L)),
        _ => None,
    }
}
