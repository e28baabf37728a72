//! Features that a target cannot express, put into words where they are shown: to a person in the program's language,
//! in the code in English.

use crate::text::{Value, filled};
use std::fmt::{self, Display, Formatter};

/// A sentence about a feature that a target cannot express.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Limit {
    /// Key of its message in the catalogue.
    pub key: &'static str,
    /// Variables of the message.
    pub values: Vec<(&'static str, String)>,
}

/// Makes a [`Limit`] from its message and the message's variables, in the form of `text!`.
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

/// Returns the limits whose condition holds.
pub(super) fn holding<const N: usize>(cases: [(bool, Limit); N]) -> Vec<Limit> {
    cases
        .into_iter()
        .filter_map(|(holds, limit)| holds.then_some(limit))
        .collect()
}
