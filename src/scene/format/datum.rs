//! How each type of value stands in a scene file.

use super::super::Shared;
use super::super::choice::Choice;
use super::super::problem::{Cause, quoted};
use glam::DVec3;
use std::path::PathBuf;
use toml::de::{DeFloat, DeInteger, DeValue};
use toml::{Spanned, Value};

/// What is wrong with a value: where in it, and why.
#[derive(Debug)]
pub struct Wrong {
    /// What follows the value's own key, for example `.2`.
    pub path: String,
    /// The byte of the text, where that is not the key's own.
    pub offset: Option<usize>,
    pub cause: Cause,
}

impl From<Cause> for Wrong {
    fn from(cause: Cause) -> Self {
        Self { path: String::new(), offset: None, cause }
    }
}

impl Wrong {
    pub fn value(found: impl Into<String>, expected: impl Into<String>) -> Self {
        Cause::Value { found: found.into(), expected: expected.into() }.into()
    }
}

/// A type of value.
pub trait Datum: Clone + PartialEq + 'static {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong>;
    /// None where it is left out.
    fn value(&self) -> Option<Value>;
    /// Whether two are the same, for numbers bit by bit.
    fn same(&self, other: &Self) -> bool {
        self == other
    }
}

impl Datum for f64 {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        let (text, infinite) = match value.get_ref() {
            DeValue::Integer(number) => match integer(number) {
                #[expect(clippy::cast_precision_loss, reason = "a whole number in a file stands for a real one")]
                Some(whole) => return Ok(whole as f64),
                None => (number.as_str(), false),
            },
            DeValue::Float(number) => (number.as_str(), named(number)),
            other => return Err(Wrong::value(found(other), "a number")),
        };
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() || infinite => Ok(value),
            _ => Err(Wrong::value(text, "a number below 1.8e308 (or inf)")),
        }
    }

    fn value(&self) -> Option<Value> {
        Some(Value::Float(*self))
    }

    fn same(&self, other: &Self) -> bool {
        self.to_bits() == other.to_bits()
    }
}

impl Datum for u32 {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        let whole = value.get_ref().as_integer().and_then(integer).and_then(|whole| whole.try_into().ok());
        whole.ok_or_else(|| Wrong::value(found(value.get_ref()), "a whole number, 0 or more"))
    }

    fn value(&self) -> Option<Value> {
        Some(Value::Integer((*self).into()))
    }
}

impl Datum for bool {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        value.get_ref().as_bool().ok_or_else(|| Wrong::value(found(value.get_ref()), "true or false"))
    }

    fn value(&self) -> Option<Value> {
        Some(Value::Boolean(*self))
    }
}

impl Datum for String {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        text(value, "text in quotation marks")
    }

    fn value(&self) -> Option<Value> {
        Some(Value::String(self.clone()))
    }
}

impl Datum for Option<PathBuf> {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        text(value, "a path in quotation marks").map(|path| Some(path.into()))
    }

    fn value(&self) -> Option<Value> {
        self.as_ref().map(|path| Value::String(path.to_string_lossy().into_owned()))
    }
}

impl<T: Choice> Datum for T {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        let words = || T::OPTIONS.iter().map(|option| option.word).collect::<Vec<_>>();
        let DeValue::String(word) = value.get_ref() else {
            return Err(Wrong::value(found(value.get_ref()), format!("one of {}", words().join(", "))));
        };
        T::from_word(word).ok_or_else(|| Cause::UnknownWord { word: word.to_string(), known: words() }.into())
    }

    fn value(&self) -> Option<Value> {
        Some(Value::String(self.word().to_owned()))
    }
}

impl Datum for DVec3 {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        array(value, "a list of three numbers").map(Self::from_array)
    }

    fn value(&self) -> Option<Value> {
        written(&self.to_array())
    }

    fn same(&self, other: &Self) -> bool {
        self.to_array().map(f64::to_bits) == other.to_array().map(f64::to_bits)
    }
}

impl Datum for [f64; 2] {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        array(value, "a list of two numbers")
    }

    fn value(&self) -> Option<Value> {
        written(self)
    }

    fn same(&self, other: &Self) -> bool {
        self.map(f64::to_bits) == other.map(f64::to_bits)
    }
}

impl Datum for [u32; 2] {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        array(value, "a list of two whole numbers")
    }

    fn value(&self) -> Option<Value> {
        written(self)
    }
}

impl<T: Datum> Datum for Shared<T> {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        list(value, "a list").map(Self::from)
    }

    fn value(&self) -> Option<Value> {
        written(self)
    }

    fn same(&self, other: &Self) -> bool {
        self.is(other) || (self.len() == other.len() && self.iter().zip(other.iter()).all(|(a, b)| a.same(b)))
    }
}

/// The settings of a pane.
impl Datum for Vec<String> {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, Wrong> {
        list(value, "a list of settings in quotation marks, as in [\"shading.mode=exact\"]")
    }

    fn value(&self) -> Option<Value> {
        written(self)
    }
}

/// A coefficient: one number for all channels, or three.
pub fn read_coefficient(value: &Spanned<DeValue<'_>>) -> Result<DVec3, Wrong> {
    const EXPECTED: &str = "a number or [red, green, blue]";
    match value.get_ref() {
        DeValue::Array(_) => array(value, EXPECTED).map(DVec3::from_array),
        DeValue::Integer(_) | DeValue::Float(_) => f64::read(value).map(DVec3::splat),
        other => Err(Wrong::value(found(other), EXPECTED)),
    }
}

fn text(value: &Spanned<DeValue<'_>>, expected: &str) -> Result<String, Wrong> {
    value.get_ref().as_str().map(str::to_owned).ok_or_else(|| Wrong::value(found(value.get_ref()), expected))
}

fn list<T: Datum>(value: &Spanned<DeValue<'_>>, expected: &str) -> Result<Vec<T>, Wrong> {
    let Some(elements) = value.get_ref().as_array() else {
        return Err(Wrong::value(found(value.get_ref()), expected));
    };
    let element = |(i, element): (usize, &Spanned<DeValue<'_>>)| {
        T::read(element).map_err(|wrong| Wrong {
            path: format!(".{i}{}", wrong.path),
            offset: wrong.offset.or(Some(element.span().start)),
            cause: wrong.cause,
        })
    };
    elements.iter().enumerate().map(element).collect()
}

fn array<T: Datum, const N: usize>(value: &Spanned<DeValue<'_>>, expected: &str) -> Result<[T; N], Wrong> {
    let list = list(value, expected)?;
    let count = list.len();
    list.try_into().map_err(|_| Wrong::value(format!("a list of {count}"), expected))
}

fn written<T: Datum>(list: &[T]) -> Option<Value> {
    Some(Value::Array(list.iter().filter_map(T::value).collect()))
}

/// A value of a wrong type, as a message repeats it.
pub fn found(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => quoted(text),
        DeValue::Integer(number) => number.to_string(),
        DeValue::Float(number) => number.to_string(),
        DeValue::Boolean(value) => value.to_string(),
        DeValue::Datetime(_) => "a date".to_owned(),
        DeValue::Array(_) => "a list".to_owned(),
        DeValue::Table(_) => "a table of keys".to_owned(),
    }
}

pub fn integer(number: &DeInteger<'_>) -> Option<i64> {
    i64::from_str_radix(number.as_str(), number.radix()).ok()
}

/// Whether a float is written as `inf` or `nan`, not as digits too large to hold.
fn named(number: &DeFloat<'_>) -> bool {
    number.as_str().ends_with("inf") || number.as_str().ends_with("nan")
}

/// A value as it stands in a scene file. Rust writes numbers as TOML does, extreme ones with an exponent.
pub fn value_text(value: &Value) -> String {
    match value {
        Value::Float(number) if number.is_nan() => "nan".to_owned(),
        Value::Float(number) => format!("{number:?}"),
        Value::Array(list) => format!("[{}]", list.iter().map(value_text).collect::<Vec<_>>().join(", ")),
        value => value.to_string(),
    }
}
