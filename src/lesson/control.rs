//! The controls that questions are about: keys of the scene that have a slider.

use crate::scene::Scene;
use crate::scene::parameter::{Parameter, Slider, Unit, defaults};
use crate::text::text;

/// Returns the parameter of a key that has a slider, the light that it belongs to, and the slider.
pub fn slider(key: &str) -> Option<(&'static Parameter, usize, Slider)> {
    let (parameter, index) = Parameter::of_key(key)?;
    Some((parameter, index.unwrap_or(0), parameter.slider()?))
}

/// Returns the value of a key of a scene as a number; of a coefficient its largest channel.
///
/// # Errors
/// A key that has no slider, or no value in this scene.
pub fn value_of(scene: &Scene, key: &str) -> Result<f64, String> {
    let missing = || text!("lesson-no-value", name = key);
    let (parameter, index, _) = slider(key).ok_or_else(missing)?;
    let value = parameter.value(scene, index).ok_or_else(missing)?;
    match &value {
        toml::Value::Float(value) => Ok(*value),
        #[expect(
            clippy::cast_precision_loss,
            reason = "whole numbers of a slider are small"
        )]
        toml::Value::Integer(value) => Ok(*value as f64),
        toml::Value::Array(values) => {
            let values = values.iter().filter_map(toml::Value::as_float);
            values.reduce(f64::max).ok_or_else(missing)
        }
        _ => Err(missing()),
    }
}

/// Returns whether a key of a scene can be set to a number; what depends on the rest of the scene is not checked.
pub(super) fn settable_to(key: &str, value: f64) -> bool {
    let limits = slider(key).and_then(|(parameter, ..)| parameter.limits(defaults()));
    limits.is_some_and(|limits| limits.contains(value))
}

/// Returns the value at a fraction of a slider.
pub(super) fn along(slider: &Slider, fraction: f64) -> f64 {
    let value = if slider.logarithmic && slider.from > 0.0 {
        slider.from * (slider.to / slider.from).powf(fraction)
    } else {
        slider.from + (slider.to - slider.from) * fraction
    };
    settable(slider, value)
}

/// Returns the fraction of a slider at which a value is.
pub(super) fn share(slider: &Slider, value: f64) -> f64 {
    let (from, to) = (slider.from, slider.to);
    if slider.logarithmic && from > 0.0 {
        (value.max(from) / from).ln() / (to / from).ln()
    } else {
        (value - from) / (to - from)
    }
}

/// Returns a value as near as the slider can be set.
pub(super) fn settable(slider: &Slider, value: f64) -> f64 {
    if slider.decimals == 0 {
        value.round()
    } else {
        value
    }
}

/// Returns a control's name as its row in the window has it.
pub fn control_name(key: &str) -> String {
    let named = |(parameter, index, _): (&'static Parameter, usize, _)| {
        if parameter.letter.is_empty() {
            parameter.full_name(index)
        } else {
            parameter.letter.to_owned()
        }
    };
    slider(key).map_or_else(|| key.to_owned(), named)
}

/// Returns the unit of a control's value as numbers have it; empty where there is none.
pub(crate) fn control_unit(key: &str) -> &'static str {
    match Parameter::of_key(key).and_then(|(parameter, _)| parameter.unit) {
        Some(Unit::Degrees) => "°",
        Some(unit) => unit.name(),
        None => "",
    }
}

/// Returns a control's name for those who do not see its row: with its letter, unless that is its name.
pub(crate) fn long_control_name(key: &str) -> String {
    match Parameter::of_key(key).map(|(parameter, _)| parameter) {
        Some(parameter) if !["", parameter.name()].contains(&parameter.letter) => {
            format!("{} ({})", parameter.name(), parameter.letter)
        }
        Some(parameter) => parameter.name().to_owned(),
        None => key.to_owned(),
    }
}
