//! Where a parameter's value lives in a scene.

use super::super::Scene;
use serde::Serialize;
use std::sync::OnceLock;
use toml::Value;

/// How a value is read and written. `usize` is the number of the light, for what belongs to lights.
pub struct Access<T: 'static> {
    pub get: fn(&Scene, usize) -> Option<&T>,
    pub get_mut: fn(&mut Scene, usize) -> Option<&mut T>,
}

impl<T: Serialize> Access<T> {
    pub(super) fn value(&self, scene: &Scene, index: usize) -> Option<Value> {
        Value::try_from((self.get)(scene, index)?).ok()
    }
}

impl<T> std::fmt::Debug for Access<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Access")
    }
}

/// The values of an enumeration, each with its label and what it means.
pub trait Options: Copy + PartialEq + Serialize + Sized + 'static {
    const OPTIONS: &'static [(Self, &'static str, &'static str)];

    /// What the value is called on screen.
    fn label(self) -> &'static str {
        Self::OPTIONS.iter().find(|(value, ..)| *value == self).map_or("", |(_, label, _)| label)
    }

    /// What the value means.
    fn help(self) -> &'static str {
        Self::OPTIONS.iter().find(|(value, ..)| *value == self).map_or("", |(.., help)| help)
    }
}

/// One value of a choice.
#[derive(Clone, Debug, PartialEq)]
pub struct ChoiceOption {
    /// As in a scene file.
    pub word: String,
    /// As on screen.
    pub label: &'static str,
    /// What it means; may be empty.
    pub help: &'static str,
}

/// How one of several is read and written, each by its place among the options.
#[derive(Debug)]
pub struct ChoiceAccess {
    pub chosen: fn(&Scene, usize) -> Option<usize>,
    pub choose: fn(&mut Scene, usize, usize),
    pub options: fn() -> &'static [ChoiceOption],
}

/// The options of `T` with the words that a scene file has for them, made once in `options`.
pub(super) fn options_of<T: Options>(options: &'static OnceLock<Vec<ChoiceOption>>) -> &'static [ChoiceOption] {
    options.get_or_init(|| {
        let word = |value: &T| match Value::try_from(value) {
            Ok(Value::String(word)) => word,
            other => unreachable!("a choice is written as a word, not {other:?}"),
        };
        let option = |&(ref value, label, help): &(T, _, _)| ChoiceOption { word: word(value), label, help };
        T::OPTIONS.iter().map(option).collect()
    })
}

/// The access to a field of a scene, or of one of its lights: `access!(material.n)`, `access!(light: cone)`.
macro_rules! access {
    (light: $field:ident) => {
        $crate::scene::parameter::Access {
            get: |scene, index| scene.lights.get(index).map(|light| &light.$field),
            get_mut: |scene, index| scene.lights.get_mut(index).map(|light| &mut light.$field),
        }
    };
    ($section:ident.$field:ident) => {
        $crate::scene::parameter::Access {
            get: |scene, _| Some(&scene.$section.$field),
            get_mut: |scene, _| Some(&mut scene.$section.$field),
        }
    };
}

/// A choice of one of the values of an enumeration, at a place as for [`access!`].
macro_rules! choice {
    ($kind:ty, $($place:tt)+) => {
        $crate::scene::parameter::Kind::Choice($crate::scene::parameter::ChoiceAccess {
            chosen: |scene, index| {
                const AT: $crate::scene::parameter::Access<$kind> =
                    $crate::scene::parameter::access::access!($($place)+);
                let present = (AT.get)(scene, index)?;
                <$kind as $crate::scene::parameter::Options>::OPTIONS.iter().position(|(value, ..)| value == present)
            },
            choose: |scene, index, option| {
                const AT: $crate::scene::parameter::Access<$kind> =
                    $crate::scene::parameter::access::access!($($place)+);
                let options = <$kind as $crate::scene::parameter::Options>::OPTIONS;
                if let (Some(place), Some((value, ..))) = ((AT.get_mut)(scene, index), options.get(option)) {
                    *place = *value;
                }
            },
            options: || {
                static OPTIONS: std::sync::OnceLock<Vec<$crate::scene::parameter::ChoiceOption>> =
                    std::sync::OnceLock::new();
                $crate::scene::parameter::access::options_of::<$kind>(&OPTIONS)
            },
        })
    };
}

pub(super) use {access, choice};
