//! The representation of each type of value in a scene file.

use super::super::Shared;
use super::super::choice::Choice;
use super::super::problem::{Cause, UnlocatedProblem, quoted};
use crate::text::text;
use glam::DVec3;
use serde::Serialize;
use std::fmt::Debug;
use std::path::PathBuf;
use toml::de::{DeInteger, DeValue};
use toml::{Spanned, Value};

/// A type of value.
pub trait Datum: Clone + Debug + PartialEq + Serialize + 'static {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem>;
    /// Returns the value in a scene file; `None` where it is left out.
    fn value(&self) -> Option<Value> {
        Value::try_from(self).ok()
    }
    /// Returns whether two values are the same, for numbers bit by bit.
    fn same(&self, other: &Self) -> bool {
        self == other
    }
}

impl Datum for f64 {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        let (text, infinite) = match value.get_ref() {
            DeValue::Integer(number) => match integer(number) {
                #[expect(
                    clippy::cast_precision_loss,
                    reason = "a whole number in a file stands for a real one"
                )]
                Some(whole) => return Ok(whole as f64),
                None => (number.as_str(), false),
            },
            // `inf` and `nan` are accepted, digits too large to represent are not.
            DeValue::Float(number) => (number.as_str(), number.as_str().ends_with(['f', 'n'])),
            other => {
                return Err(UnlocatedProblem::value(
                    found(other),
                    text!("expected-number"),
                ));
            }
        };
        match text.parse::<f64>() {
            Ok(value) if value.is_finite() || infinite => Ok(value),
            _ => Err(UnlocatedProblem::value(
                text,
                text!("expected-number-in-range"),
            )),
        }
    }

    fn same(&self, other: &Self) -> bool {
        self.to_bits() == other.to_bits()
    }
}

impl Datum for u32 {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        let whole = |value: &DeValue<'_>| value.as_integer().and_then(integer)?.try_into().ok();
        scalar(value, whole, "expected-whole")
    }
}

impl Datum for bool {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        scalar(value, |value| value.as_bool(), "expected-bool")
    }
}

impl Datum for String {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        scalar(
            value,
            |value| value.as_str().map(str::to_owned),
            "expected-text",
        )
    }
}

impl Datum for Option<PathBuf> {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        scalar(
            value,
            |value| value.as_str().map(|path| Some(path.into())),
            "expected-path",
        )
    }

    fn value(&self) -> Option<Value> {
        self.as_ref()
            .map(|path| Value::String(path.to_string_lossy().into_owned()))
    }
}

impl<T: Choice + Debug + Serialize> Datum for T {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        let words: Vec<_> = T::OPTIONS.iter().map(|option| option.word).collect();
        let DeValue::String(word) = value.get_ref() else {
            return Err(UnlocatedProblem::value(
                found(value.get_ref()),
                text!("expected-one-of", words = words.join(", ")),
            ));
        };
        T::from_word(word)
            .ok_or_else(|| UnlocatedProblem::new("", Cause::unknown_word(word, &words)))
    }
}

impl Datum for DVec3 {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        array(value, "expected-three").map(Self::from_array)
    }

    fn same(&self, other: &Self) -> bool {
        self.to_array().map(f64::to_bits) == other.to_array().map(f64::to_bits)
    }
}

impl Datum for [f64; 2] {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        array(value, "expected-two")
    }

    fn same(&self, other: &Self) -> bool {
        self.map(f64::to_bits) == other.map(f64::to_bits)
    }
}

impl Datum for [u32; 2] {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        array(value, "expected-two-whole")
    }
}

impl<T: Datum> Datum for Shared<T> {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        list(value, "expected-list").map(Self::from)
    }

    fn same(&self, other: &Self) -> bool {
        self.is(other)
            || (self.len() == other.len() && self.iter().zip(other.iter()).all(|(a, b)| a.same(b)))
    }
}

/// Reads and writes the settings of a pane.
impl Datum for Vec<String> {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        list(value, "expected-settings")
    }
}

/// A value that another one replaces where it is missing; `"model"` in an override stands for none.
impl<T: Datum> Datum for Option<T> {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        if value.get_ref().as_str() == Some(NO_VALUE) {
            return Ok(None);
        }
        T::read(value).map(Some)
    }

    fn value(&self) -> Option<Value> {
        self.as_ref().and_then(Datum::value)
    }

    fn same(&self, other: &Self) -> bool {
        match (self, other) {
            (Some(a), Some(b)) => a.same(b),
            (a, b) => a.is_none() && b.is_none(),
        }
    }
}

/// The word for a value that is left to the model.
pub const NO_VALUE: &str = "model";

/// RGB values that are written as one number where they agree.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Coefficient(pub DVec3);

impl Datum for Coefficient {
    fn read(value: &Spanned<DeValue<'_>>) -> Result<Self, UnlocatedProblem> {
        read_coefficient(value).map(Self)
    }

    fn value(&self) -> Option<Value> {
        if is_grey(self.0) {
            self.0.x.value()
        } else {
            self.0.value()
        }
    }

    fn same(&self, other: &Self) -> bool {
        self.0.same(&other.0)
    }
}

/// Returns whether a coefficient is the same in all channels, bit by bit.
pub fn is_grey(value: DVec3) -> bool {
    let [r, g, b] = value.to_array().map(f64::to_bits);
    r == g && g == b
}

/// Reads a coefficient: one number for all channels, or three.
pub fn read_coefficient(value: &Spanned<DeValue<'_>>) -> Result<DVec3, UnlocatedProblem> {
    const EXPECTED: &str = "expected-coefficient";
    match value.get_ref() {
        DeValue::Array(_) => array(value, EXPECTED).map(DVec3::from_array),
        DeValue::Integer(_) | DeValue::Float(_) => f64::read(value).map(DVec3::splat),
        other => Err(UnlocatedProblem::value(found(other), text!(EXPECTED))),
    }
}

/// Reads one value, or reports what was `expected`, a message key, here and below.
fn scalar<T>(
    value: &Spanned<DeValue<'_>>,
    read: impl Fn(&DeValue<'_>) -> Option<T>,
    expected: &str,
) -> Result<T, UnlocatedProblem> {
    read(value.get_ref())
        .ok_or_else(|| UnlocatedProblem::value(found(value.get_ref()), text!(expected)))
}

fn list<T: Datum>(
    value: &Spanned<DeValue<'_>>,
    expected: &str,
) -> Result<Vec<T>, UnlocatedProblem> {
    let elements = value
        .get_ref()
        .as_array()
        .ok_or_else(|| UnlocatedProblem::value(found(value.get_ref()), text!(expected)))?;
    let element = |(i, element): (usize, &Spanned<DeValue<'_>>)| {
        T::read(element).map_err(|wrong| UnlocatedProblem {
            key: format!(".{i}{}", wrong.key),
            offset: wrong.offset.or(Some(element.span().start)),
            cause: wrong.cause,
        })
    };
    elements.iter().enumerate().map(element).collect()
}

fn array<T: Datum, const N: usize>(
    value: &Spanned<DeValue<'_>>,
    expected: &str,
) -> Result<[T; N], UnlocatedProblem> {
    let list = list(value, expected)?;
    let count = list.len();
    list.try_into()
        .map_err(|_| UnlocatedProblem::value(list_of(count), text!(expected)))
}

/// Returns the words for a list of `count`.
pub fn list_of(count: usize) -> String {
    text!("found-list-of", count = count)
}

/// Describes a value of a wrong type for a message.
pub fn found(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => quoted(text),
        DeValue::Integer(number) => number.to_string(),
        DeValue::Float(number) => number.to_string(),
        DeValue::Boolean(value) => value.to_string(),
        DeValue::Datetime(_) => text!("found-date").to_owned(),
        DeValue::Array(_) => text!("found-list").to_owned(),
        DeValue::Table(_) => text!("found-table").to_owned(),
    }
}

pub fn integer(number: &DeInteger<'_>) -> Option<i64> {
    i64::from_str_radix(number.as_str(), number.radix()).ok()
}

/// Returns a value as text in a scene file. Rust writes numbers as TOML does, extreme ones with an exponent.
pub fn value_text(value: &Value) -> String {
    match value {
        Value::Float(number) if number.is_nan() => "nan".to_owned(),
        Value::Float(number) => format!("{number:?}"),
        Value::Array(list) => format!(
            "[{}]",
            list.iter().map(value_text).collect::<Vec<_>>().join(", ")
        ),
        value => value.to_string(),
    }
}
