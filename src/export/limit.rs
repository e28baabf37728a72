//! What a target cannot express, put into words where it is shown: to a person in the language of the program, in the code in
//! English.

use crate::text::{Value, filled};
use std::fmt::{self, Display, Formatter};

/// A sentence about what a target cannot express.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limit {
    /// Its message in the catalogue.
    pub key: &'static str,
    /// The message's variables.
    pub values: Vec<(&'static str, String)>,
}

/// A [`Limit`] by its message and the message's variables, as `text!` takes them.
macro_rules! limit {
    ($key:literal $(, $name:ident = $value:expr)*) => {
        $crate::export::Limit {
            key: $key,
            values: Vec::from([$((stringify!($name), $value.to_string())),*]),
        }
    };
}
pub(super) use limit;

impl Display for Limit {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let value = |(name, value): &(&'static str, String)| (*name, Value::from(value.clone()));
        let values: Vec<_> = self.values.iter().map(value).collect();
        f.write_str(&filled(self.key, &values))
    }
}

/// The limits whose condition holds.
pub(super) fn holding<const N: usize>(cases: [(bool, Limit); N]) -> Vec<Limit> {
    cases
        .into_iter()
        .filter_map(|(holds, limit)| holds.then_some(limit))
        .collect()
}
