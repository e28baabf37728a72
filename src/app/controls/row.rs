//! A row of the panel of controls: a label, a control, and a button that restores the value as opened.
//!
//! The row of a parameter follows the parameter's description. Every control can be reached by keyboard and has an accessible
//! name. Its label shows the symbol of the equation in the symbol's colour, and pointing at either highlights the other.

mod expression;
mod layout;
mod number;
mod widgets;

pub use expression::evaluate;
pub use layout::{About, row, value_row};
pub use number::{NumberRow, SliderRange, display, number, whole};
pub use widgets::axes;

use crate::analysis::probe::specular_vector;
use crate::app::widgets::letter::text_width;
use crate::app::widgets::palette::vector_text;
use crate::app::widgets::symbol::Symbol;
use crate::app::widgets::theme;
use crate::figure::palette::Vector;
use crate::scene::parameter::{Access, Kind, Limits, Parameter, Slider, Unit, defaults};
use crate::scene::{ChoiceOption, Rgb, Scene};
use eframe::egui::{Color32, Ui};
use number::{
    CHANNELS, FIELDS, SIDES, channels_row, coefficient_slider, fields, slider_and_field,
    whole_slider,
};
use widgets::{choice, swatch_button, text, toggle};

/// Width of three fields beside a swatch, and of a list's arrow with the space around its text, in points.
const SWATCHED: f32 = 166.0;
const LIST: f32 = 40.0;
/// Distance over which a dragged letter goes through the whole range of its slider, in points.
const PULL: f32 = 240.0;

/// Shows a row for a parameter of the scene.
pub fn parameter(ui: &mut Ui, initial: &Scene, scene: &mut Scene, parameter: &'static Parameter) {
    parameter_with(ui, initial, scene, parameter, &RowOptions::default());
}

/// Options of a row that its parameter's description does not set.
#[derive(Default)]
pub struct RowOptions {
    /// Index of the light that the parameter belongs to.
    pub index: usize,
    /// True if the row says which light it belongs to.
    pub numbered: bool,
    /// True if a slider has a line of its own. On a touch screen it always has.
    pub wide: bool,
    /// True if the label says what the parameter belongs to.
    pub in_full: bool,
    /// True if coefficients always have a field for each channel.
    pub channels: bool,
    pub slider: Option<Slider>,
    /// Filter of the options on offer, if not all are. The present option is always offered.
    pub offered: Option<fn(&Scene, &ChoiceOption) -> bool>,
}

/// Shows a row for a parameter as `options` describes.
pub fn parameter_with(
    ui: &mut Ui,
    initial: &Scene,
    scene: &mut Scene,
    parameter: &'static Parameter,
    options: &RowOptions,
) {
    let index = options.index;
    let (name, tip) = (parameter.full_name(index), tip(parameter, scene));
    let number = format!("L{}", index + 1);
    let about = About {
        letter: if options.numbered && parameter.letter.is_empty() {
            &number
        } else {
            parameter.letter
        },
        tint: tint(ui, scene, parameter),
        label: if options.in_full {
            &name
        } else {
            parameter.label()
        },
        name: &name,
        tip: &tip,
        symbol: parameter.symbol,
        parameter: Some(parameter),
        idle: parameter.idle(scene, index),
        room: room(ui, scene, parameter, options),
    };
    let (name, range) = (&*name, range(scene, parameter, options));
    let spec = |default| NumberRow {
        about: about.clone(),
        range: range.clone(),
        default,
    };
    let mut row = Edited {
        ui,
        initial,
        scene,
        index,
        about: &about,
    };
    match parameter.kind {
        Kind::Number(at, ..) => {
            row.edit(at, |ui, value, default| {
                slider_and_field(ui, &spec(*default), value);
            });
        }
        Kind::Whole(at, ..) => {
            row.edit(at, |ui, value, default| {
                whole_slider(ui, &spec(f64::from(*default)), value);
            });
        }
        Kind::Coefficient(at, ..) => {
            row.edit(at, |ui, value, default| {
                coefficient_slider(ui, &spec(default.max_element()), value);
            });
            if let Some(value) =
                (at.get_mut)(scene, index).filter(|value| options.channels || !is_grey(**value))
            {
                channels_row(ui, &about, value);
            }
        }
        Kind::Pair(at, ..) => row.edit(at, |ui, value, _| {
            fields(ui, name, SIDES, &range, value);
        }),
        Kind::Channels(at, ..) => {
            row.edit(at, |ui, value, _| {
                fields(ui, name, CHANNELS, &range, value.as_mut());
            });
        }
        Kind::Colour(at, _) => row.edit(at, |ui, value, _| {
            swatch_button(ui, name, value);
            fields(ui, name, CHANNELS, &SliderRange::SHORT, value.as_mut());
        }),
        Kind::Point(at) | Kind::Direction(at, _) => {
            row.edit(at, |ui, value, _| axes(ui, name, value));
        }
        Kind::Choice(access) => {
            let opened = access
                .chosen(initial, index)
                .or_else(|| access.chosen(defaults(), 0));
            let (Some(present), Some(default)) = (access.chosen(scene, index), opened) else {
                return;
            };
            let is_offered =
                |option: &ChoiceOption| options.offered.is_none_or(|offers| offers(scene, option));
            let choices = access.options().iter().enumerate();
            let choices = choices
                .filter(|(place, option)| *place == present || is_offered(option))
                .collect();
            let mut chosen = present;
            value_row(ui, &about, default, &mut chosen, |ui, chosen| {
                choice(ui, &about, choices, chosen);
            });
            if chosen != present {
                access.choose(scene, index, chosen);
            }
        }
        Kind::Switch(at) => row.edit(at, |ui, value, _| toggle(ui, name, value)),
        Kind::Text(at, longest) => row.edit(at, |ui, value, _| text(ui, &about, longest, value)),
        // A formula has an editor, see `law_ui`.
        Kind::Lines(..) | Kind::Other(..) => {}
    }
}

/// Returns the parameter that a letter of the equation stands for: one with a slider that has an effect.
pub fn of_letter(scene: &Scene, symbol: Symbol, index: usize) -> Option<&'static Parameter> {
    Parameter::all().find(|parameter| {
        parameter.symbol == Some(symbol)
            && parameter.slider().is_some()
            && parameter.idle(scene, index).is_none()
    })
}

/// Changes the number behind a letter of the equation that is dragged sideways by `points`, as its slider would. Returns the
/// parameter that the letter stands for and its value, if it is one number that has an effect.
pub fn pull(
    scene: &mut Scene,
    symbol: Symbol,
    index: usize,
    points: f32,
) -> Option<(&'static Parameter, String)> {
    let parameter = of_letter(scene, symbol, index)?;
    let options = RowOptions {
        index,
        ..RowOptions::default()
    };
    let (range, by) = (range(scene, parameter, &options), f64::from(points / PULL));
    match parameter.kind {
        Kind::Number(at, ..) => {
            let value = (at.get_mut)(scene, index)?;
            *value = range.moved(*value, by);
            Some((parameter, display(*value, range.decimals)))
        }
        Kind::Coefficient(at, ..) => {
            let value = (at.get_mut)(scene, index)?;
            let largest = value.max_element();
            let moved = range.moved(largest, by);
            *value = number::scaled(*value, largest, moved);
            Some((parameter, display(moved, range.decimals)))
        }
        _ => None,
    }
}

/// A row that edits a value of the scene.
struct Edited<'a> {
    ui: &'a mut Ui,
    initial: &'a Scene,
    scene: &'a mut Scene,
    index: usize,
    about: &'a About<'a>,
}

impl Edited<'_> {
    /// Shows the row.
    ///
    /// `control` gets the value and the one that resetting restores, which is the default for an added light.
    fn edit<T: Clone + PartialEq>(
        &mut self,
        at: &Access<T>,
        control: impl FnOnce(&mut Ui, &mut T, &T),
    ) {
        let opened = (at.get)(self.initial, self.index)
            .or_else(|| (at.get)(defaults(), 0))
            .cloned();
        if let (Some(value), Some(opened)) = ((at.get_mut)(self.scene, self.index), opened) {
            let default = opened.clone();
            value_row(self.ui, self.about, opened, value, |ui, value| {
                control(ui, value, &default);
            });
        }
    }
}

/// Returns the width that a parameter's control needs, in points.
fn room(ui: &Ui, scene: &Scene, parameter: &Parameter, options: &RowOptions) -> f32 {
    match parameter.kind {
        Kind::Number(..) | Kind::Whole(..) | Kind::Coefficient(..) => {
            if options.wide || theme::is_touch(ui) {
                f32::INFINITY
            } else {
                range(scene, parameter, options).room()
            }
        }
        Kind::Colour(..) => SWATCHED,
        Kind::Point(_) | Kind::Direction(..) | Kind::Channels(..) => FIELDS,
        Kind::Choice(access) => access.chosen(scene, options.index).map_or(0.0, |chosen| {
            let option = access.options().get(chosen);
            option.map_or(0.0, |option| text_width(ui, option.label())) + LIST
        }),
        _ => 0.0,
    }
}

fn is_grey(value: Rgb) -> bool {
    value == Rgb::splat(value.x)
}

/// Returns the slider of a parameter, with the limits and the unit of its field.
fn range(scene: &Scene, parameter: &Parameter, options: &RowOptions) -> SliderRange {
    let slider = options
        .slider
        .or(parameter.slider())
        .unwrap_or(Slider::UNIT);
    let Limits { least, greatest } = parameter.limits(scene).unwrap_or(Limits::FINITE);
    SliderRange {
        span: slider.from.max(least)..=slider.to,
        limits: least..=greatest,
        refuses: true,
        logarithmic: slider.logarithmic,
        decimals: slider.decimals,
        suffix: if parameter.unit == Some(Unit::Degrees) {
            "°"
        } else {
            ""
        },
    }
}

/// Returns the help text with letter, unit and range.
fn tip(parameter: &Parameter, scene: &Scene) -> String {
    let letter = if parameter.letter.is_empty() {
        String::new()
    } else {
        format!("{}: ", parameter.letter)
    };
    let limits = parameter
        .limits(scene)
        .filter(|limits| parameter.slider().is_some() && limits.greatest <= 1e6);
    let range = limits.map_or_else(String::new, |limits| format!("{limits} "));
    let about = format!("{range}{}", parameter.unit());
    let about = if about.trim().is_empty() {
        String::new()
    } else {
        format!(" ({})", about.trim())
    };
    format!("{letter}{}{about}", parameter.help())
}

/// Returns the colour of the term or the vector that a parameter belongs to.
fn tint(ui: &Ui, scene: &Scene, parameter: &Parameter) -> Option<Color32> {
    let (visuals, model) = (ui.visuals(), scene.reflection.model);
    match parameter.symbol? {
        Symbol::Kd => Some(vector_text(visuals, Vector::L)),
        Symbol::Ks | Symbol::Exponent | Symbol::Facets => {
            Some(vector_text(visuals, specular_vector(model)))
        }
        Symbol::Kt | Symbol::Transmitted => Some(vector_text(visuals, Vector::T)),
        Symbol::Viewer => Some(vector_text(visuals, Vector::V)),
        Symbol::Light if parameter.letter == "L" || parameter.letter == "D" => {
            Some(vector_text(visuals, Vector::L))
        }
        _ => None,
    }
}
