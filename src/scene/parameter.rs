//! Every key of a scene, described once: what it is called, its unit, limits, default and help, and where its value lives.
//!
//! Validation, the window's controls, undo, `docs/scene-file.md` and `shading-lab parameters` all read this table. No other
//! place states a parameter's limits. Each is a constant of its section: `parameter::material::N`. What several parameters must be together is in `validation.rs`.

mod access;
pub mod camera;
pub mod light;
pub mod material;
pub mod object;
pub mod shading;
pub mod surroundings;
mod symbol;

pub use access::{Access, ChoiceField, Field, List};
pub use symbol::Symbol;

use super::format::{Datum, Wrong, read_coefficient, value_text};
use super::{ChoiceOption, GREATEST_INTENSITY, GREATEST_LENGTH, Rgb, Scene};
use glam::DVec3;
use std::sync::LazyLock;
use toml::de::DeValue;
use toml::{Spanned, Value};

/// One key of a scene.
#[derive(Debug)]
pub struct Parameter {
    /// As in the scene file, for example `material.n`. `light.N.` stands for the light of any number.
    pub key: &'static str,
    /// Its letter in the equation; empty where it has none.
    pub letter: &'static str,
    /// The symbol of the equation that it belongs to.
    pub symbol: Option<Symbol>,
    /// What it is called.
    pub name: &'static str,
    /// A short form of the name for its row in the window.
    pub label: &'static str,
    /// Empty where it has none.
    pub unit: &'static str,
    /// What it means, in a sentence.
    pub help: &'static str,
    pub kind: Kind,
    /// Why it has no effect in a scene at present; for a light's parameters, on the light of this number.
    pub idle: fn(&Scene, usize) -> Option<&'static str>,
}

/// What values a parameter has, and where they live.
#[derive(Debug)]
pub enum Kind {
    Number {
        at: Access<f64>,
        limits: Limits,
        slider: Slider,
    },
    /// A whole number; its limits may depend on the scene.
    Whole {
        at: Access<u32>,
        limits: fn(&Scene) -> Limits,
        slider: Slider,
    },
    /// Two lengths.
    Pair {
        at: Access<[f64; 2]>,
        limits: Limits,
        slider: Slider,
    },
    /// RGB values, or one for all channels.
    Coefficient {
        at: Access<Rgb>,
        limits: Limits,
        slider: Slider,
    },
    /// RGB values that are no colour.
    Channels {
        at: Access<Rgb>,
        limits: Limits,
        slider: Slider,
    },
    Colour {
        at: Access<Rgb>,
        limits: Limits,
    },
    Point(Access<DVec3>),
    /// Any length but zero where `needed`.
    Direction {
        at: Access<DVec3>,
        needed: fn(&Scene, usize) -> bool,
    },
    Choice(&'static dyn ChoiceField),
    Switch(Access<bool>),
    Text {
        at: Access<String>,
        longest: usize,
    },
    /// What has its own checks and controls.
    Other {
        at: &'static dyn Field,
        kind: &'static str,
        limits: &'static str,
    },
}

/// The least and the greatest value that a scene may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    pub least: f64,
    pub greatest: f64,
}

impl Limits {
    pub const UNIT: Self = Self::new(0.0, 1.0);
    /// A length or a distance.
    pub const LENGTH: Self = Self::new(0.0, GREATEST_LENGTH);
    /// A coordinate.
    pub const COORDINATE: Self = Self::new(-GREATEST_LENGTH, GREATEST_LENGTH);
    pub const INTENSITY: Self = Self::new(0.0, GREATEST_INTENSITY);
    /// Any finite number.
    pub const FINITE: Self = Self::new(f64::MIN, f64::MAX);

    pub const fn new(least: f64, greatest: f64) -> Self {
        Self { least, greatest }
    }

    /// False for what is not a number.
    pub fn contains(self, value: f64) -> bool {
        (self.least..=self.greatest).contains(&value)
    }
}

/// What a slider spans. More can be typed, within the limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    pub from: f64,
    pub to: f64,
    pub logarithmic: bool,
    /// Digits after the point at most.
    pub decimals: usize,
}

impl Slider {
    pub const UNIT: Self = Self::linear(0.0, 1.0);

    pub const fn linear(from: f64, to: f64) -> Self {
        Self { from, to, logarithmic: false, decimals: 3 }
    }

    pub const fn logarithmic(from: f64, to: f64) -> Self {
        Self { from, to, logarithmic: true, decimals: 3 }
    }

    pub const fn decimals(self, decimals: usize) -> Self {
        Self { decimals, ..self }
    }
}

impl Parameter {
    /// A parameter without a letter or a unit, which always has an effect.
    const fn new(key: &'static str, name: &'static str, kind: Kind, help: &'static str) -> Self {
        let idle = |_: &Scene, _: usize| None;
        Self { key, letter: "", symbol: None, name, label: name, unit: "", help, kind, idle }
    }

    const fn label(self, label: &'static str) -> Self {
        Self { label, ..self }
    }

    const fn letter(self, letter: &'static str, symbol: Symbol) -> Self {
        Self { letter, symbol: Some(symbol), ..self }
    }

    const fn symbol(self, symbol: Symbol) -> Self {
        Self { symbol: Some(symbol), ..self }
    }

    const fn unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    const fn idle(self, idle: fn(&Scene, usize) -> Option<&'static str>) -> Self {
        Self { idle, ..self }
    }

    /// Every parameter, in the order of the scene file.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        let tables: [&[&Self]; 6] =
            [camera::ALL, object::ALL, material::ALL, shading::ALL, surroundings::ALL, light::ALL];
        tables.into_iter().flatten().copied()
    }

    /// Those in a table of the scene file and in the tables inside it.
    pub(super) fn in_table(table: &str) -> impl Iterator<Item = &'static Self> {
        Self::all().filter(move |parameter| {
            table.is_empty() || parameter.key.strip_prefix(table).is_some_and(|rest| rest.starts_with('.'))
        })
    }

    /// The names of the keys and the tables in a table of the scene file.
    pub(super) fn names_in(table: &str) -> Vec<&'static str> {
        let skipped = if table.is_empty() { 0 } else { table.len() + 1 };
        let mut names: Vec<_> =
            Self::in_table(table).filter_map(|parameter| parameter.key[skipped..].split('.').next()).collect();
        names.dedup();
        names
    }

    /// The table of the scene file that it stands in, for example `material` or `light.N`; none for the version.
    pub(super) fn table(&'static self) -> Option<&'static str> {
        self.key.rsplit_once('.').map(|(table, _)| table)
    }

    /// Whether each light has one of its own.
    pub fn of_light(&self) -> bool {
        self.list() == Some(List::Lights)
    }

    /// The list of which each element has one of its own.
    fn list(&self) -> Option<List> {
        List::of(self.key)
    }

    /// How many of it a scene has: one, or one for each light or pane.
    pub fn count(&self, scene: &Scene) -> usize {
        self.list().map_or(1, |list| list.len(scene))
    }

    /// The table of the scene file that it stands in, for example `material`.
    pub fn section(&self) -> &'static str {
        self.key.split('.').next().unwrap_or(self.key)
    }

    /// The key as `--set` takes it, for the light of number `index` where it is a light's.
    pub fn key(&self, index: usize) -> String {
        self.key.replacen(".N.", &format!(".{index}."), 1)
    }

    /// Its value, as a scene file holds it; none where the scene has no such light.
    pub fn value(&self, scene: &Scene, index: usize) -> Option<Value> {
        match &self.kind {
            Kind::Coefficient { at, .. } if is_grey(*(at.get)(scene, index)?) => (at.get)(scene, index)?.x.value(),
            _ => self.field().value(scene, index),
        }
    }

    /// Sets it to a value of a scene file; its limits are not looked at.
    pub(super) fn read(&self, scene: &mut Scene, index: usize, value: &Spanned<DeValue<'_>>) -> Result<(), Wrong> {
        match &self.kind {
            Kind::Coefficient { at, .. } => {
                let value = read_coefficient(value)?;
                (at.get_mut)(scene, index).into_iter().for_each(|place| *place = value);
                Ok(())
            }
            _ => self.field().read(scene, index, value),
        }
    }

    /// Sets it to what it is in another scene.
    pub fn copy(&self, from: &Scene, to: &mut Scene, index: usize) {
        self.field().copy(from, to, index);
    }

    /// Where its value lives.
    pub(super) fn field(&self) -> &dyn Field {
        match &self.kind {
            Kind::Number { at, .. } => at,
            Kind::Whole { at, .. } => at,
            Kind::Pair { at, .. } => at,
            Kind::Coefficient { at, .. } | Kind::Channels { at, .. } | Kind::Colour { at, .. } => at,
            Kind::Point(at) | Kind::Direction { at, .. } => at,
            Kind::Choice(at) => *at,
            Kind::Switch(at) => at,
            Kind::Text { at, .. } => at,
            Kind::Other { at, .. } => *at,
        }
    }

    /// Its value as the right side of `--set`.
    pub fn setting(&self, scene: &Scene, index: usize) -> String {
        match self.value(scene, index) {
            Some(Value::String(word)) if is_word(&word) => word,
            value => value.as_ref().map_or_else(String::new, value_text),
        }
    }

    /// Its value in a scene of nothing but defaults.
    pub fn default(&self) -> Option<Value> {
        self.value(defaults(), 0)
    }

    /// Whether two scenes agree in it, for numbers bit by bit.
    pub fn agrees(&self, a: &Scene, b: &Scene, index: usize) -> bool {
        self.field().agrees(a, b, index)
    }

    /// Its letter and its name, for the light of number `index` where it is a light's.
    pub fn full_name(&self, index: usize) -> String {
        match (self.of_light(), self.letter) {
            (true, _) => format!("Light {} {}", index + 1, self.name),
            (false, "") => self.name.to_owned(),
            (false, letter) => format!("{letter} {}", self.name),
        }
    }

    /// What its slider spans, where it has one.
    pub fn slider(&self) -> Option<Slider> {
        match self.kind {
            Kind::Number { slider, .. }
            | Kind::Whole { slider, .. }
            | Kind::Pair { slider, .. }
            | Kind::Coefficient { slider, .. }
            | Kind::Channels { slider, .. } => Some(slider),
            _ => None,
        }
    }

    /// What kind of value it has, in a word or two.
    pub fn kind_name(&self) -> &'static str {
        match self.kind {
            Kind::Number { .. } => "number",
            Kind::Whole { .. } => "whole number",
            Kind::Pair { .. } => "two numbers",
            Kind::Coefficient { .. } => "number or colour",
            Kind::Channels { .. } => "number per channel",
            Kind::Colour { .. } => "colour",
            Kind::Point(_) => "point",
            Kind::Direction { .. } => "direction",
            Kind::Choice(_) => "choice",
            Kind::Switch(_) => "switch",
            Kind::Text { .. } => "text",
            Kind::Other { kind, .. } => kind,
        }
    }

    /// The limits of a number, or of each number in it.
    pub fn limits(&self, scene: &Scene) -> Option<Limits> {
        match &self.kind {
            Kind::Number { limits, .. }
            | Kind::Pair { limits, .. }
            | Kind::Coefficient { limits, .. }
            | Kind::Channels { limits, .. }
            | Kind::Colour { limits, .. } => Some(*limits),
            Kind::Whole { limits, .. } => Some(limits(scene)),
            Kind::Point(_) | Kind::Direction { .. } => Some(Limits::COORDINATE),
            _ => None,
        }
    }

    /// Its default as a scene file has it; empty where it has none.
    pub fn default_text(&self) -> String {
        self.default().map_or_else(String::new, |value| plain(&value))
    }

    /// What it can be set to, in words.
    pub fn range_text(&self) -> String {
        match &self.kind {
            Kind::Other { limits, .. } => (*limits).to_owned(),
            Kind::Choice(_) => self.options().iter().map(|option| option.word).collect::<Vec<_>>().join(", "),
            Kind::Switch(_) => "true, false".to_owned(),
            Kind::Text { longest, .. } => format!("at most {longest} characters in one line"),
            Kind::Direction { .. } => "not zero".to_owned(),
            Kind::Point(_) => String::new(),
            _ => self.limits(defaults()).map_or_else(String::new, |limits| limits.to_string()),
        }
    }

    /// What it can be set to, where that is one of a few words.
    pub fn options(&self) -> &'static [ChoiceOption] {
        match &self.kind {
            Kind::Choice(choice) => choice.options(),
            _ => &[],
        }
    }
}

impl Scene {
    /// The parameters in which two scenes differ, each with the number of its light or pane.
    pub fn differences<'s>(&'s self, other: &'s Self) -> impl Iterator<Item = (&'static Parameter, usize)> {
        Parameter::all().flat_map(move |parameter| {
            let indices = 0..parameter.count(self).max(parameter.count(other));
            indices.filter(move |index| !parameter.agrees(self, other, *index)).map(move |index| (parameter, index))
        })
    }
}

/// Whether a text can stand without quotation marks.
fn is_word(text: &str) -> bool {
    !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-')
}

/// Whether a coefficient is the same in all channels.
pub(super) fn is_grey(value: Rgb) -> bool {
    value == Rgb::splat(value.x)
}

/// A scene of nothing but defaults.
pub fn defaults() -> &'static Scene {
    static DEFAULTS: LazyLock<Scene> = LazyLock::new(Scene::default);
    &DEFAULTS
}

/// A value as a scene's author would write it: no `.0` at whole numbers.
fn plain(value: &Value) -> String {
    match value {
        Value::Float(number) => number.to_string(),
        Value::Array(list) => format!("[{}]", list.iter().map(plain).collect::<Vec<_>>().join(", ")),
        value => value.to_string(),
    }
}
