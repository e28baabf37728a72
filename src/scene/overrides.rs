//! Replacement of keys of a scene, as `--set` and the panes of a comparison do it.

use super::Scene;
use super::format::set;
use super::parameter::{Kind, Parameter};
use super::problem::{Cause, ProblemLocation, SceneError, UnlocatedProblem};
use crate::text::text;
use std::borrow::Cow;
use toml::Spanned;
use toml::de::{DeArray, DeValue};

impl Scene {
    /// Returns the scene with one key replaced by `KEY=VALUE`, as in `material.n=inf`, `light.0.position=[2,2,3]` or
    /// `shading.mode=gouraud`: tables and lists are addressed by names and numbers between dots, values are written as in
    /// the scene file, words also without quotation marks and lists of numbers without brackets.
    ///
    /// # Errors
    /// As [`Scene::parse`], at the place of the override.
    pub fn with_override(&self, assignment: &str) -> Result<Self, SceneError> {
        self.with_overrides(&[assignment])
    }

    /// Returns the scene with several keys replaced, one after the other. Only the final values need to agree with each other.
    ///
    /// # Errors
    /// As [`Scene::parse`], each at the place of the override at fault.
    pub fn with_overrides(&self, assignments: &[impl AsRef<str>]) -> Result<Self, SceneError> {
        let mut scene = self.clone();
        for assignment in assignments.iter().map(AsRef::as_ref) {
            SceneError::check(replace(&mut scene, assignment), |_| {
                ProblemLocation::Override(assignment.to_owned())
            })?;
        }
        SceneError::check(scene.range_problems(), |problem| {
            at_fault(&problem.key, assignments).map_or(ProblemLocation::Scene, |text| {
                ProblemLocation::Override(text.to_owned())
            })
        })?;
        Ok(scene)
    }
}

fn replace(scene: &mut Scene, assignment: &str) -> Vec<UnlocatedProblem> {
    let Some((key, value)) = key_and_value(assignment) else {
        let words = text!("problem-no-equals").to_owned();
        return vec![UnlocatedProblem::new("", Cause::Text(words))];
    };
    match value_of(key, value) {
        Ok(value) => set(scene, key, value),
        Err(cause) => vec![UnlocatedProblem::new(key, cause)],
    }
}

pub(super) fn key_and_value(assignment: &str) -> Option<(&str, &str)> {
    let (key, value) = assignment.split_once('=')?;
    let key = key.trim();
    (!key.is_empty()).then_some((key, value.trim()))
}

/// Parses the value of a key. That of lines, such as a formula, is a text even where it looks like a number.
fn value_of<'a>(key: &str, text: &'a str) -> Result<Spanned<DeValue<'a>>, Cause> {
    let parameter = Parameter::of_key(key).map(|(parameter, _)| &parameter.kind);
    if matches!(parameter, Some(Kind::Lines(..))) && !text.starts_with(['"', '\'']) {
        return Ok(plain(text));
    }
    parse_value(text)
}

fn plain(text: &str) -> Spanned<DeValue<'_>> {
    Spanned::new(0..0, DeValue::String(Cow::Borrowed(text)))
}

/// Parses a TOML value, a word without its quotation marks, or numbers without the brackets of their list.
pub(super) fn parse_value(text: &str) -> Result<Spanned<DeValue<'_>>, Cause> {
    match DeValue::parse(text) {
        Ok(value) => Ok(value),
        Err(error) if text.is_empty() || text.starts_with(['[', '{', '"', '\'']) => {
            Err(Cause::value(
                text!("found-not-a-value", message = error.message()),
                text!("expected-file-value"),
            ))
        }
        Err(_) => Ok(numbers(text).unwrap_or_else(|| plain(text))),
    }
}

/// Parses `2,2,3` as the list `[2,2,3]`: links, and some shells, do not take brackets literally.
fn numbers(text: &str) -> Option<Spanned<DeValue<'_>>> {
    let number = |text| {
        let value = DeValue::parse(text).ok()?;
        (value.get_ref().is_integer() || value.get_ref().is_float()).then_some(value)
    };
    let mut list = DeArray::new();
    for piece in text.split(',') {
        list.push(number(piece.trim())?);
    }
    Some(Spanned::new(0..0, DeValue::Array(list)))
}

/// Finds the last override related to `key`: of the key itself, of its table, of something inside it, or of anything.
fn at_fault<'a>(key: &str, assignments: &'a [impl AsRef<str>]) -> Option<&'a str> {
    let section = key.split('.').next().unwrap_or(key);
    let last = |wanted: &dyn Fn(&str) -> bool| {
        let mut texts = assignments.iter().rev().map(AsRef::as_ref);
        texts.find(|text| key_and_value(text).is_some_and(|(key, _)| wanted(key)))
    };
    last(&|set| is_inside(key, set) || is_inside(set, key))
        .or_else(|| last(&|set| is_inside(set, section)))
        .or_else(|| last(&|_| true))
}

/// Returns whether a key is `outer` or something inside it.
pub(super) fn is_inside(key: &str, outer: &str) -> bool {
    key.strip_prefix(outer)
        .is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
}
