//! The names that a formula may use.

use super::typed::Type;
use crate::expression::functions::{CONSTANTS, NAMED, in_name};

/// The names that a formula may use, each a number or a vector.
///
/// A number may be the dot product of two letters, `N·L`: it is found as `N·L`, `L·N`, `NL`, `N.L` and `dot(N, L)`. Greek
/// letters and subscripts are read as letters and digits, and letters in either case where that is unambiguous.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Names(Vec<(String, Type)>);

/// Words of the grammar.
const WORDS: [&str; 4] = ["and", "or", "not", "with"];

impl Names {
    /// Creates the list of names: the numbers first, in this order, then the vectors.
    pub fn new(numbers: &[&str], vectors: &[&str]) -> Self {
        let numbers = numbers.iter().map(|name| (plain(name), Type::Number));
        let vectors = vectors.iter().map(|name| (plain(name), Type::Vector));
        Self(numbers.chain(vectors).collect())
    }

    /// Returns whether a text can be the name of a number: a letter, then letters, digits and `_`, or two such names with
    /// a middle dot between them.
    pub fn is_name(name: &str) -> bool {
        let word = |word: &str| {
            let plain = plain(word);
            let letter = plain.starts_with(|c: char| c.is_ascii_alphabetic());
            letter && !plain.contains('·') && word.chars().all(|c| in_name(c).is_some())
        };
        let words: Vec<&str> = name.split('·').collect();
        (1..=2).contains(&words.len())
            && words.into_iter().all(word)
            && !Self::is_reserved(&plain(name))
    }

    /// Returns the names and their types.
    pub fn iter(&self) -> impl Iterator<Item = (&str, Type)> {
        self.0.iter().map(|(name, kind)| (&**name, *kind))
    }

    /// Returns the number of names.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns whether there are no names.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns whether a name belongs to the grammar, so that no line can have it.
    pub(super) fn is_reserved(name: &str) -> bool {
        let mut constants = CONSTANTS.iter().map(|(constant, _)| *constant);
        constants.any(|constant| constant == name)
            || Self::functions().any(|function| function == name)
            || WORDS.contains(&name)
    }

    /// Returns the names of the functions.
    pub(super) fn functions() -> impl Iterator<Item = &'static str> {
        let formulas_have = |function: &&'static str| *function != "luminance";
        NAMED
            .into_iter()
            .map(|function| function.0)
            .filter(formulas_have)
    }

    /// Returns the index of a name.
    pub(super) fn exactly(&self, name: &str) -> Option<usize> {
        self.0.iter().position(|(own, _)| own == name)
    }

    /// Returns the index of the only name that is equal but for its case and its `_`; none for single letters, whose case
    /// tells them apart.
    pub(super) fn loosely(&self, name: &str) -> Option<usize> {
        let bare = |name: &str| name.replace('_', "").to_lowercase();
        let sought = bare(name);
        let mut found = (0..self.0.len()).filter(|index| bare(&self.0[*index].0) == sought);
        let only = found.next().filter(|_| found.next().is_none())?;
        (sought.chars().count() > 1).then_some(only)
    }

    /// Returns the index of the number that is called the dot product of two names, in either order.
    pub(super) fn product(&self, a: &str, b: &str) -> Option<usize> {
        self.exactly(&format!("{a}·{b}"))
            .or_else(|| self.exactly(&format!("{b}·{a}")))
    }

    /// Returns the type of the name of this index.
    pub(super) fn kind(&self, index: usize) -> Type {
        self.0[index].1
    }
}

/// Returns a name as it is read: with names of Greek letters and plain digits.
fn plain(name: &str) -> String {
    let read = |c: char| in_name(c).unwrap_or_else(|| c.to_string());
    name.chars().filter(|c| *c != ' ').map(read).collect()
}
