//! Settings in words, such as `shading.mode=gouraud`, and the possible values of a parameter.

use super::Scene;
use super::choice::Choice;
use super::object::ObjectKind;
use super::overrides::key_and_value;
use super::parameter::{Kind, Limits, Parameter, defaults};
use crate::text::{listed, text, with_minus};

/// Puts `KEY=VALUE` into words for people: the key's name, and the value's own word. Text that is not a setting stays as it is.
pub fn setting_words(setting: &str) -> String {
    let Some((key, written)) = key_and_value(setting) else {
        return setting.to_owned();
    };
    let written = written.trim_matches(['"', '\'']);
    let Some((parameter, light)) = Parameter::of_key(key) else {
        return format!("{key}: {written}");
    };
    let value = match &parameter.kind {
        Kind::Choice(choice) => choice
            .options()
            .iter()
            .find(|option| option.word == written)
            .map_or_else(|| written.to_owned(), |option| option.label().to_owned()),
        Kind::Switch(_) => match written {
            "true" => text!("report-on").to_owned(),
            "false" => text!("report-off").to_owned(),
            _ => written.to_owned(),
        },
        _ if written == "inf" => "∞".to_owned(),
        _ => with_minus(written),
    };
    let name = parameter.name();
    match light {
        Some(light) => text!(
            "report-setting-of-light",
            light = light + 1,
            name = name,
            value = value
        ),
        None => text!("report-setting", name = name, value = value),
    }
}

impl Parameter {
    /// Returns the possible values, in words.
    pub fn range_text(&self) -> String {
        match self.kind {
            Kind::Other(.., limits) => limits(),
            Kind::Choice(_) => self
                .options()
                .iter()
                .map(|option| option.word)
                .collect::<Vec<_>>()
                .join(", "),
            Kind::Switch(_) => ["true", "false"].join(", "),
            Kind::Text(_, longest) => text!("range-text", longest = longest),
            Kind::Lines(_, longest) => text!("range-lines", longest = longest),
            Kind::Direction(..) => text!("range-direction").to_owned(),
            Kind::Point(_) => String::new(),
            Kind::Whole(_, limits, _) => range_of_shapes(limits),
            _ => self
                .limits(defaults())
                .map_or_else(String::new, |limits| limits.to_string()),
        }
    }
}

/// Returns the limits of a whole number in words: those of most shapes, and the value from which the others count.
fn range_of_shapes(limits: fn(&Scene) -> Limits) -> String {
    let of = |kind: ObjectKind| {
        let mut scene = defaults().clone();
        scene.object.kind = kind;
        limits(&scene)
    };
    let all: Vec<Limits> = ObjectKind::VALUES.iter().copied().map(of).collect();
    let alike = |limits: &&Limits| all.iter().filter(|other| other == limits).count();
    let Some(usual) = all.iter().max_by_key(alike) else {
        return String::new();
    };
    let shapes = ObjectKind::OPTIONS.iter().map(|shape| shape.word);
    let others = shapes.zip(&all).filter(|(_, limits)| *limits != usual);
    let words = others.map(|(shape, limits)| {
        let least = limits.least.to_string();
        text!("range-of-shape", shape = shape, least = least)
    });
    listed(std::iter::once(usual.to_string()).chain(words))
}
