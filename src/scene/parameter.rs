//! Every key of a scene, described once: its names, unit, limits, default and help, and the field that holds its value.
//!
//! Validation, the window's controls, undo, `docs/scene-file.md` and `shading-lab parameters` all read this table. No other
//! place states a parameter's limits. Each parameter is a line of the `table!` that defines its struct, and a constant
//! beside it, for example `material::N`. Conditions on several parameters together are in `validation.rs`.
//!
#![doc = include_str!("../../docs/scene-file.md")]

pub use super::access::{Access, ChoiceField, Field, List};
use super::choice::ChoiceOption;
use super::format::{Coefficient, Datum, NO_VALUE, read_coefficient, value_text};
use super::problem::UnlocatedProblem;
use super::symbol::Symbol;
use super::{Rgb, Scene};
use crate::text::text;
use glam::DVec3;
use std::ops::RangeInclusive;
use std::sync::LazyLock;
use toml::de::DeValue;
use toml::{Spanned, Value};

/// The largest coordinate and length, world units: its square, and sums of such squares, stay far below the largest `f64`.
pub const GREATEST_LENGTH: f64 = 1e30;

/// The shortest nonzero length, world units: its square is still a normal number.
pub const LEAST_LENGTH: f64 = 1e-30;

/// The largest intensity of a light or of the background, in units of the display's white.
pub const GREATEST_INTENSITY: f64 = 1e30;

/// One key of a scene. Its texts for people are in the catalogue: its name, a label for its row in the window and a
/// sentence that says what it means.
///
/// ```
/// use shading_lab::scene::parameter::Parameter;
/// use shading_lab::scene::{Scene, material};
///
/// let n = Parameter::by_word("n").expect("a key");
/// assert_eq!((n.key, n.letter), ("material.n", "n"));
/// assert!(n.limits(&Scene::default()).expect("a number").contains(1e9));
/// assert_eq!(n.key, material::N.key);
///
/// let other = Scene::default().with_override("material.n=5")?;
/// let changed: Vec<_> = Scene::default().differences(&other).map(|(parameter, _)| parameter.key).collect();
/// assert_eq!(changed, ["material.n"]);
/// # Ok::<(), shading_lab::scene::SceneError>(())
/// ```
#[derive(Debug)]
pub struct Parameter {
    /// The key in the scene file, for example `material.n`. `light.N.` stands for the light of any number.
    pub key: &'static str,
    /// Its letter in the equation; empty where it has none.
    pub letter: &'static str,
    /// The symbol of the equation that it belongs to.
    pub symbol: Option<Symbol>,
    /// The unit; none for pure numbers, colours and everything that is not a number.
    pub unit: Option<Unit>,
    /// The kind of value, with access to it.
    pub kind: Kind,
    reasons: &'static [Reason],
}

/// A reason why a parameter has no effect: the condition, in the light of this number, and the message.
pub(super) type Reason = (fn(&Scene, usize) -> bool, &'static str);

/// The kind of a parameter's value, with access to it, the limits of a number and its slider.
#[derive(Debug)]
pub enum Kind {
    /// A number.
    Number(&'static Access<f64>, Limits, Slider),
    /// A whole number; its limits may depend on the scene.
    Whole(&'static Access<u32>, fn(&Scene) -> Limits, Slider),
    /// Two lengths.
    Pair(&'static Access<[f64; 2]>, Limits, Slider),
    /// RGB values, or one for all channels.
    Coefficient(&'static Access<Rgb>, Limits, Slider),
    /// RGB values that are not a colour.
    Channels(&'static Access<Rgb>, Limits, Slider),
    /// A linear colour, no channel negative.
    Colour(&'static Access<Rgb>, Limits),
    /// A point, world units.
    Point(&'static Access<DVec3>),
    /// A direction, of any length but zero where the condition requires it.
    Direction(&'static Access<DVec3>, fn(&Scene, usize) -> bool),
    /// One of a few words.
    Choice(&'static dyn ChoiceField),
    /// True or false.
    Switch(&'static Access<bool>),
    /// A line of at most this many characters.
    Text(&'static Access<String>, usize),
    /// Lines of at most this many characters together.
    Lines(&'static Access<String>, usize),
    /// A value with checks and controls of its own; the message that names its kind, and its limits in words.
    Other(&'static dyn Field, &'static str, fn() -> String),
}

/// The unit of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unit {
    /// Pixels of the picture.
    Pixels,
    /// Degrees of an angle.
    Degrees,
    /// World units, of a length.
    World,
    /// One over world units, as `c2` of an attenuation.
    PerWorld,
    /// One over world units squared, as `c3` of an attenuation.
    PerWorldSquared,
}

impl Unit {
    /// Returns its name in the current language.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pixels => text!("unit-pixels"),
            Self::Degrees => text!("unit-degrees"),
            Self::World => text!("unit-world"),
            Self::PerWorld => text!("unit-per-world"),
            Self::PerWorldSquared => text!("unit-per-world-squared"),
        }
    }
}

/// Defines a struct of a scene, which is a table of the scene file, and describes each of its keys: the parameter's
/// constant, the field with its type and default, and the kind with its limits and slider. Further properties follow as
/// calls:
///
/// `ROLL roll: f64 = 0.0, Number(Limits::FINITE, ANGLE).measured_in(Unit::Degrees);`
///
/// The key `camera.roll` has the messages `parameter-camera-roll`, `.label` and `.help`. `in material` names the field of
/// the scene that holds the struct; `in [lights]`, the list of such structs.
macro_rules! table {
    (
        $(#[$about:meta])*
        pub struct $struct:ident = $table:tt in $place:tt $(with ($(#[$other_detail:meta])* $other:ident: $other_type:ty = $none:expr))? {
            $(
                $(#[$detail:meta])*
                $NAME:ident $field:ident: $type:ty = $default:expr,
                $kind:ident $(($($argument:expr),+))? $(.$say:ident($($what:expr),+))*;
            )+
        }
    ) => {
        $(#[$about])*
        #[derive(Clone, Debug, PartialEq)]
        pub struct $struct {
            $(
                $(#[$detail])*
                #[doc = concat!("\n\n`", $crate::scene::parameter::table!(@key $table $field), "` in a scene file; by default `", stringify!($default), "`.")]
                pub $field: $type,
            )+
            $($(#[$other_detail])* pub $other: $other_type,)?
        }

        impl Default for $struct {
            fn default() -> Self {
                Self { $($field: $default,)+ $($other: $none,)? }
            }
        }

        $(
            #[doc = concat!("The key `", $crate::scene::parameter::table!(@key $table $field), "` of a scene file: [`", stringify!($struct), "::", stringify!($field), "`].")]
            pub static $NAME: $crate::scene::parameter::Parameter = $crate::scene::parameter::Parameter::new(
                $crate::scene::parameter::table!(@key $table $field),
                $crate::scene::parameter::Kind::$kind(
                    &$crate::scene::parameter::table!(@access $place $field)
                    $($(, $argument)+)?
                ),
            )$(.$say($($what),+))*;
        )+

        impl $struct {
            pub(super) const PARAMETERS: &'static [&'static $crate::scene::parameter::Parameter] = &[$(&$NAME),+];
        }
    };
    (@key [$($table:ident).+] $field:ident) => {
        concat!($(stringify!($table), ".",)+ stringify!($field))
    };
    (@access [$($list:ident).+] $field:ident) => {
        $crate::scene::parameter::Access {
            get: |scene, index| scene.$($list).+.get(index).map(|table| &table.$field),
            get_mut: |scene, index| scene.$($list).+.get_mut(index).map(|table| &mut table.$field),
        }
    };
    (@access $section:ident $field:ident) => {
        $crate::scene::parameter::Access {
            get: |scene, _| Some(&scene.$section.$field),
            get_mut: |scene, _| Some(&mut scene.$section.$field),
        }
    };
}

pub(super) use table;

static VERSION: Parameter = Parameter::new(
    "version",
    Kind::Other(
        &Access {
            get: |scene, _| Some(&scene.version),
            get_mut: |scene, _| Some(&mut scene.version),
        },
        "kind-whole",
        || Scene::VERSION.to_string(),
    ),
);

/// The smallest and the largest value that a scene may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The smallest value.
    pub least: f64,
    /// The largest value.
    pub greatest: f64,
}

impl Limits {
    /// The limits 0 to 1.
    pub const UNIT: Self = Self::new(0.0, 1.0);
    /// The limits of a length or a distance.
    pub const LENGTH: Self = Self::new(0.0, GREATEST_LENGTH);
    /// The limits of a coordinate.
    pub const COORDINATE: Self = Self::new(-GREATEST_LENGTH, GREATEST_LENGTH);
    /// The limits of the intensity of a light or of the background: 0 to [`GREATEST_INTENSITY`].
    pub const INTENSITY: Self = Self::new(0.0, GREATEST_INTENSITY);
    /// The limits of any finite number.
    pub const FINITE: Self = Self::new(f64::MIN, f64::MAX);

    /// Creates limits that include both ends.
    pub const fn new(least: f64, greatest: f64) -> Self {
        Self { least, greatest }
    }

    /// Returns the limits of a range.
    pub const fn within(range: &RangeInclusive<f64>) -> Self {
        Self::new(*range.start(), *range.end())
    }

    /// Returns whether a value is within the limits; false for NaN.
    pub fn contains(self, value: f64) -> bool {
        (self.least..=self.greatest).contains(&value)
    }
}

/// The range of a slider. Values beyond it can be typed, within the limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slider {
    /// Value at the left end.
    pub from: f64,
    /// Value at the right end.
    pub to: f64,
    /// True if equal distances multiply the value instead of adding to it.
    pub logarithmic: bool,
    /// The most digits after the point.
    pub decimals: usize,
}

impl Slider {
    /// A slider from 0 to 1.
    pub const UNIT: Self = Self::linear(0.0, 1.0);

    /// Creates a slider on which equal distances add equal amounts, with three decimals.
    pub const fn linear(from: f64, to: f64) -> Self {
        Self {
            from,
            to,
            logarithmic: false,
            decimals: 3,
        }
    }

    /// Creates a slider on which equal distances multiply by equal factors, with three decimals. `from` is above 0.
    pub const fn logarithmic(from: f64, to: f64) -> Self {
        Self {
            from,
            to,
            logarithmic: true,
            decimals: 3,
        }
    }

    /// Sets the most digits after the point.
    pub const fn decimals(self, decimals: usize) -> Self {
        Self { decimals, ..self }
    }
}

impl Parameter {
    /// Creates a parameter without a letter or a unit, which always has an effect.
    pub(super) const fn new(key: &'static str, kind: Kind) -> Self {
        Self {
            key,
            letter: "",
            symbol: None,
            unit: None,
            kind,
            reasons: &[],
        }
    }

    pub(super) const fn letter(self, letter: &'static str, symbol: Symbol) -> Self {
        Self {
            letter,
            symbol: Some(symbol),
            ..self
        }
    }

    pub(super) const fn symbol(self, symbol: Symbol) -> Self {
        Self {
            symbol: Some(symbol),
            ..self
        }
    }

    pub(super) const fn measured_in(self, unit: Unit) -> Self {
        Self {
            unit: Some(unit),
            ..self
        }
    }

    pub(super) const fn idle_if(self, reasons: &'static [Reason]) -> Self {
        Self { reasons, ..self }
    }

    /// Returns the reason why it has no effect in a scene at present, if any; for a light's parameters, in the light of this number.
    pub fn idle(&self, scene: &Scene, index: usize) -> Option<&'static str> {
        let mut reasons = self.reasons.iter();
        reasons
            .find(|(holds, _)| holds(scene, index))
            .map(|(_, reason)| text!(*reason))
    }

    /// Returns its name.
    pub fn name(&self) -> &'static str {
        self.message("")
    }

    /// Returns a short form of the name for its row in the window.
    pub fn label(&self) -> &'static str {
        self.message(".label")
    }

    /// Returns its meaning, in a sentence.
    pub fn help(&self) -> &'static str {
        self.message(".help")
    }

    fn message(&self, part: &str) -> &'static str {
        // A key of a model's material is called as the scene's own.
        let of_model = List::of(self.key) == Some(List::Materials);
        let key = match self.key.rsplit_once('.') {
            Some((_, "kt")) if of_model => "transparency.kt".to_owned(),
            Some((_, "relative_ior")) if of_model => "transparency.ior".to_owned(),
            Some((_, key)) if of_model && key != "name" => format!("material.{key}"),
            _ => self.key.to_owned(),
        };
        text!(&format!("parameter-{}{part}", key.replace('.', "-")))
    }

    /// Returns its unit; empty where it has none.
    pub fn unit(&self) -> &'static str {
        self.unit.map_or("", Unit::name)
    }

    /// Returns every parameter, in the order of the scene file.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        std::iter::once(&VERSION).chain(super::TABLES.iter().copied().flatten().copied())
    }

    /// Returns the parameters of a table of the scene file and of the tables inside it.
    pub(super) fn in_table(table: &str) -> impl Iterator<Item = &'static Self> {
        Self::all().filter(move |parameter| {
            table.is_empty()
                || parameter
                    .key
                    .strip_prefix(table)
                    .is_some_and(|rest| rest.starts_with('.'))
        })
    }

    /// Returns the names of the keys and the tables in a table of the scene file.
    pub(super) fn names_in(table: &str) -> Vec<&'static str> {
        let skipped = if table.is_empty() { 0 } else { table.len() + 1 };
        let mut names = vec![];
        let keys = Self::in_table(table).map(|parameter| &parameter.key[skipped..]);
        for name in keys.filter_map(|key| key.split('.').next()) {
            // A model's materials stand apart from the rest of their object.
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// Returns its table in the scene file, for example `material` or `light.N`; `None` for the version.
    pub(super) fn table(&'static self) -> Option<&'static str> {
        self.key.rsplit_once('.').map(|(table, _)| table)
    }

    /// Finds the parameter of a key as `--set` takes it, as in `material.n` or `light.0.k`, and the number of its light in the key.
    pub fn of_key(key: &str) -> Option<(&'static Self, Option<usize>)> {
        let index: Option<usize> = key.split('.').nth(1).and_then(|part| part.parse().ok());
        let mut all = Self::all();
        let parameter = all.find(|parameter| parameter.key(index.unwrap_or(0)) == key)?;
        Some((parameter, index))
    }

    /// Finds the parameter of a key, as in `material.n`, or of the last word of one, as in `n`.
    pub fn by_word(word: &str) -> Option<&'static Self> {
        // A word that could be several keys refers to the material's letter.
        let material = Self::all().filter(|parameter| parameter.section() == "material");
        let last = |parameter: &&Self| parameter.key.rsplit('.').next() == Some(word);
        let of_key = Self::of_key(word).map(|(parameter, _)| parameter);
        of_key
            .or_else(|| Self::all().find(|parameter| parameter.key == word))
            .or_else(|| material.chain(Self::all()).find(last))
    }

    /// Returns whether each light has one of its own.
    pub fn of_light(&self) -> bool {
        List::of(self.key) == Some(List::Lights)
    }

    /// Returns the number of its values in a scene: one, or one for each light or pane.
    pub fn count(&self, scene: &Scene) -> usize {
        List::of(self.key).map_or(1, |list| list.len(scene))
    }

    /// Returns its section of the scene file, for example `material`.
    pub fn section(&self) -> &'static str {
        self.key.split('.').next().unwrap_or(self.key)
    }

    /// Returns the key as `--set` takes it, for the light of number `index` where it is a light's.
    pub fn key(&self, index: usize) -> String {
        self.key.replacen(".N.", &format!(".{index}."), 1)
    }

    /// Returns its value in the form of a scene file; `None` where the scene has no such light.
    pub fn value(&self, scene: &Scene, index: usize) -> Option<Value> {
        match self.kind {
            Kind::Coefficient(at, ..) => Coefficient(*(at.get)(scene, index)?).value(),
            _ => self.field().value(scene, index),
        }
    }

    /// Sets it to a value of a scene file without checking its limits.
    pub(super) fn read(
        &self,
        scene: &mut Scene,
        index: usize,
        value: &Spanned<DeValue<'_>>,
    ) -> Result<(), UnlocatedProblem> {
        let Kind::Coefficient(at, ..) = self.kind else {
            return self.field().read(scene, index, value);
        };
        let value = read_coefficient(value)?;
        if let Some(place) = (at.get_mut)(scene, index) {
            *place = value;
        }
        Ok(())
    }

    /// Copies its value from another scene.
    pub fn copy(&self, from: &Scene, to: &mut Scene, index: usize) {
        self.field().copy(from, to, index);
    }

    pub(super) fn field(&self) -> &'static dyn Field {
        match self.kind {
            Kind::Number(at, ..) => at,
            Kind::Whole(at, ..) => at,
            Kind::Pair(at, ..) => at,
            Kind::Coefficient(at, ..) | Kind::Channels(at, ..) | Kind::Colour(at, _) => at,
            Kind::Point(at) | Kind::Direction(at, _) => at,
            Kind::Choice(at) => at,
            Kind::Switch(at) => at,
            Kind::Text(at, _) | Kind::Lines(at, _) => at,
            Kind::Other(at, ..) => at,
        }
    }

    /// Returns its value as the right side of `--set`.
    pub fn setting(&self, scene: &Scene, index: usize) -> String {
        match self.value(scene, index) {
            Some(Value::String(word)) if is_word(&word) => word,
            None if List::of(self.key) == Some(List::Materials) => NO_VALUE.to_owned(),
            value => value.as_ref().map_or_else(String::new, value_text),
        }
    }

    /// Returns its value in a scene of only defaults.
    pub fn default(&self) -> Option<Value> {
        self.value(defaults(), 0)
    }

    /// Returns whether two scenes agree in it, for numbers bit by bit.
    pub fn agrees(&self, a: &Scene, b: &Scene, index: usize) -> bool {
        self.field().agrees(a, b, index)
    }

    /// Returns its letter and its name, for the light of number `index` where it is a light's.
    pub fn full_name(&self, index: usize) -> String {
        match (self.of_light(), self.letter) {
            (true, _) => text!("parameter-of-light", number = index + 1, name = self.name()),
            (false, "") => self.name().to_owned(),
            (false, letter) => format!("{letter} {}", self.name()),
        }
    }

    /// Returns its slider, where it has one.
    pub fn slider(&self) -> Option<Slider> {
        match self.kind {
            Kind::Number(.., slider)
            | Kind::Whole(.., slider)
            | Kind::Pair(.., slider)
            | Kind::Coefficient(.., slider)
            | Kind::Channels(.., slider) => Some(slider),
            _ => None,
        }
    }

    /// Returns the kind of its value, in a word or two.
    pub fn kind_name(&self) -> &'static str {
        match self.kind {
            Kind::Number(..) => text!("kind-number"),
            Kind::Whole(..) => text!("kind-whole"),
            Kind::Pair(..) => text!("kind-pair"),
            Kind::Coefficient(..) => text!("kind-coefficient"),
            Kind::Channels(..) => text!("kind-channels"),
            Kind::Colour(..) => text!("kind-colour"),
            Kind::Point(_) => text!("kind-point"),
            Kind::Direction(..) => text!("kind-direction"),
            Kind::Choice(_) => text!("kind-choice"),
            Kind::Switch(_) => text!("kind-switch"),
            Kind::Text(..) => text!("kind-text"),
            Kind::Lines(..) => text!("kind-lines"),
            Kind::Other(_, kind, _) => text!(kind),
        }
    }

    /// Returns the limits of a number, or of each number in it.
    pub fn limits(&self, scene: &Scene) -> Option<Limits> {
        match self.kind {
            Kind::Number(_, limits, _)
            | Kind::Pair(_, limits, _)
            | Kind::Coefficient(_, limits, _)
            | Kind::Channels(_, limits, _)
            | Kind::Colour(_, limits) => Some(limits),
            Kind::Whole(_, limits, _) => Some(limits(scene)),
            Kind::Point(_) | Kind::Direction(..) => Some(Limits::COORDINATE),
            _ => None,
        }
    }

    /// Returns its default in the form of a scene file, of several lines the first with an ellipsis; empty where it has none.
    pub fn default_text(&self) -> String {
        let first_line = |value| match value {
            Value::String(text) => match text.split_once('\n') {
                Some((first, _)) => Value::String(format!("{first} …")),
                None => Value::String(text),
            },
            value => value,
        };
        self.default()
            .map_or_else(String::new, |value| plain(&first_line(value)))
    }

    /// Returns its options, where its value is one of a few words.
    pub fn options(&self) -> &'static [ChoiceOption] {
        match &self.kind {
            Kind::Choice(choice) => choice.options(),
            _ => &[],
        }
    }
}

impl Scene {
    /// Finds the parameters in which two scenes differ, each with the number of its light or pane.
    pub fn differences<'s>(
        &'s self,
        other: &'s Self,
    ) -> impl Iterator<Item = (&'static Parameter, usize)> {
        Parameter::all().flat_map(move |parameter| {
            let indices = 0..parameter.count(self).max(parameter.count(other));
            indices
                .filter(move |index| !parameter.agrees(self, other, *index))
                .map(move |index| (parameter, index))
        })
    }
}

/// Returns the limits of a list of at most `count` elements, in words.
pub(super) fn at_most(count: usize) -> String {
    text!("range-at-most", count = count)
}

/// Returns whether a text needs no quotation marks.
fn is_word(text: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '-';
    // `5` and `true` would be read as a number and a switch.
    !text.is_empty() && text.chars().all(plain) && DeValue::parse(text).is_err()
}

/// Returns a scene of only defaults.
pub fn defaults() -> &'static Scene {
    static DEFAULTS: LazyLock<Scene> = LazyLock::new(Scene::default);
    &DEFAULTS
}

/// Returns a value as a scene's author would write it: without `.0` at whole numbers.
fn plain(value: &Value) -> String {
    match value {
        Value::Float(number) => number.to_string(),
        Value::Array(list) => format!(
            "[{}]",
            list.iter().map(plain).collect::<Vec<_>>().join(", ")
        ),
        value => value.to_string(),
    }
}
