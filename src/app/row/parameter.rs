//! The row of a parameter: a control for its kind of value; all that it says comes from the parameter's description.

use super::{
    About, NumberRow, SliderRange, choice_of, coefficient, colour, field_pair, number, text, toggle, triple, vector,
    whole,
};
use crate::app::palette::{Term, term_text, vector_text};
use crate::app::symbol::{Lit, Symbol};
use crate::figure::palette::Vector;
use crate::scene::parameter::{Access, Kind, Limits, Parameter, Slider, defaults};
use crate::scene::{ChoiceOption, Scene};
use eframe::egui::{Color32, Ui};

/// A row for a parameter of the scene.
pub fn parameter(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, parameter: &'static Parameter) {
    parameter_of(ui, lit, scene, 0, parameter);
}

/// A row for each of several parameters.
pub fn parameters(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, rows: &[&'static Parameter]) {
    for row in rows {
        parameter(ui, lit, scene, row);
    }
}

/// A row for a parameter of the light of number `index`.
pub fn parameter_of(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, index: usize, parameter: &'static Parameter) {
    parameter_with(ui, lit, scene, index, parameter, &View::default());
}

/// What a row shows otherwise than its parameter's description has it.
pub struct View {
    /// Whether coefficients always have a field for each channel.
    pub channels: bool,
    pub slider: Option<Slider>,
    /// The options that are offered; the present one always is.
    pub offered: fn(&Scene, &ChoiceOption) -> bool,
}

impl Default for View {
    fn default() -> Self {
        Self { channels: false, slider: None, offered: |_, _| true }
    }
}

/// A row for a parameter, shown in a particular way.
pub fn parameter_with(
    ui: &mut Ui,
    lit: &mut Lit,
    scene: &mut Scene,
    index: usize,
    parameter: &'static Parameter,
    view: &View,
) {
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
    let range = range(scene, parameter, view);
    match parameter.kind {
        Kind::Number(at, ..) => edit(at, lit, scene, index, |lit, value, default| {
            number(ui, lit, &NumberRow { about, range, default }, value);
        }),
        Kind::Whole(at, ..) => edit(at, lit, scene, index, |lit, value, default| {
            whole(ui, lit, &NumberRow { about, range, default: default.into() }, value);
        }),
        Kind::Pair(at, ..) => {
            edit(at, lit, scene, index, |lit, value, default| field_pair(ui, lit, &about, &range, default, value));
        }
        Kind::Coefficient(at, ..) => edit(at, lit, scene, index, |lit, value, default| {
            coefficient(ui, lit, &about, &range, default, view.channels, value);
        }),
        Kind::Channels(at, ..) => {
            edit(at, lit, scene, index, |lit, value, default| triple(ui, lit, &about, &range, default, value));
        }
        Kind::Colour(at, _) => {
            edit(at, lit, scene, index, |lit, value, default| colour(ui, lit, &about, default, value));
        }
        Kind::Point(at) | Kind::Direction(at, _) => {
            edit(at, lit, scene, index, |lit, value, default| vector(ui, lit, &about, default, value));
        }
        Kind::Choice(access) => {
            let opened = access.chosen(&lit.opened, index).or_else(|| access.chosen(defaults(), 0));
            let (Some(present), Some(default)) = (access.chosen(scene, index), opened) else { return };
            let options = access.options();
            let offered = |place: usize| place == present || (view.offered)(scene, &options[place]);
            let options: Vec<_> =
                (0..options.len()).filter(|place| offered(*place)).map(|place| (place, &options[place])).collect();
            if let Some(chosen) = choice_of(ui, lit, &about, default, &options, present) {
                access.choose(scene, index, chosen);
            }
        }
        Kind::Switch(at) => {
            edit(at, lit, scene, index, |lit, value, default| toggle(ui, lit, &about, default, value));
        }
        Kind::Text(at, longest) => {
            edit(at, lit, scene, index, |lit, value, default| text(ui, lit, &about, longest, default, value));
        }
        Kind::Other(..) => {}
    }
}

/// Hands over a value of the scene, with the one that resetting returns to: the default for a light that has been added.
fn edit<T: Clone>(
    at: &Access<T>,
    lit: &mut Lit,
    scene: &mut Scene,
    index: usize,
    change: impl FnOnce(&mut Lit, &mut T, T),
) {
    let opened = (at.get)(&lit.opened, index).or_else(|| (at.get)(defaults(), 0)).cloned();
    if let (Some(value), Some(opened)) = ((at.get_mut)(scene, index), opened) {
        change(lit, value, opened);
    }
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
        Symbol::Kd => Some(term_text(visuals, Term::Diffuse, model)),
        Symbol::Ks | Symbol::Exponent | Symbol::Facets => Some(term_text(visuals, Term::Specular, model)),
        Symbol::Kt | Symbol::Transmitted => Some(vector_text(visuals, Vector::T)),
        Symbol::Viewer => Some(vector_text(visuals, Vector::V)),
        Symbol::Light if parameter.letter == "L" || parameter.letter == "D" => Some(vector_text(visuals, Vector::L)),
        _ => None,
    }
}
