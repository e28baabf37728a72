//! One key of a scene replaced, as `--set` does it.

use super::Scene;
use super::format::read;
use super::problem::{Cause, Place, Problem, SceneError};
use std::borrow::Cow;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

impl Scene {
    /// The scene with one key replaced by `KEY=VALUE`, as in `material.n=inf`, `light.0.position=[2,2,3]` or
    /// `shading.mode=gouraud`: tables and lists by names and numbers between dots, values as in the scene file, words
    /// also without quotation marks.
    ///
    /// # Errors
    /// As [`Scene::parse`], in the place of the override.
    pub fn with_override(&self, assignment: &str) -> Result<Self, SceneError> {
        self.with_overrides(&[assignment])
    }

    /// The scene with several keys replaced, one after the other. Their values need to agree at the end only.
    ///
    /// # Errors
    /// As [`Scene::parse`], each in the place of the override at fault.
    pub fn with_overrides(&self, assignments: &[impl AsRef<str>]) -> Result<Self, SceneError> {
        let mut scene = self.clone();
        for assignment in assignments {
            scene = scene.replaced(assignment.as_ref())?;
        }
        let problem = |(key, cause): (String, Cause)| {
            let place = at_fault(&key, assignments).map_or(Place::Scene, |text| Place::Override(text.to_owned()));
            Problem { place, key, cause }
        };
        SceneError::check(scene.range_problems().into_iter().map(problem).collect())?;
        Ok(scene)
    }

    /// One key replaced, ranges not looked at.
    fn replaced(&self, assignment: &str) -> Result<Self, SceneError> {
        let problem = |key: String, cause| Problem { place: Place::Override(assignment.to_owned()), key, cause };
        let (key, value) = key_and_value(assignment).ok_or_else(|| problem(String::new(), Cause::NotAnAssignment))?;
        let value = parse_value(value).map_err(|cause| problem(key.to_owned(), cause))?;
        let text = self.to_toml();
        let mut document = DeTable::parse(&text)
            .map_err(|error| problem(String::new(), Cause::Syntax(error.message().to_owned())))?
            .into_inner();
        insert(&mut document, key, value).map_err(|(key, cause)| problem(key, cause))?;
        let (scene, findings) = read(&document);
        SceneError::check(findings.into_iter().map(|finding| problem(finding.key, finding.cause)).collect())?;
        Ok(scene.unwrap_or_default())
    }
}

fn key_and_value(assignment: &str) -> Option<(&str, &str)> {
    let (key, value) = assignment.split_once('=')?;
    let key = key.trim();
    (!key.is_empty()).then_some((key, value.trim()))
}

/// A TOML value, or a word without its quotation marks.
fn parse_value(text: &str) -> Result<Spanned<DeValue<'_>>, Cause> {
    match DeValue::parse(text) {
        Ok(value) => Ok(value),
        Err(error) if text.is_empty() || text.starts_with(['[', '{', '"', '\'']) => Err(Cause::Value {
            found: format!("not a value ({})", error.message()),
            expected: "one as in a file".into(),
        }),
        Err(_) => Ok(Spanned::new(0..0, DeValue::String(Cow::Borrowed(text)))),
    }
}

/// Puts `value` at `key`. A table that does not exist is made, and found to be unknown when the document is read.
fn insert<'i>(document: &mut DeTable<'i>, key: &'i str, value: Spanned<DeValue<'i>>) -> Result<(), (String, Cause)> {
    let Some((tables, last)) = key.rsplit_once('.') else {
        document.insert(Spanned::new(0..0, key.into()), value);
        return Ok(());
    };
    let mut segments = tables.split('.');
    let first = segments.next().unwrap_or_default();
    let mut place = descend(document, first).get_mut();
    let mut so_far = first.to_owned();
    for segment in segments {
        place = part(place, &so_far, segment)?;
        so_far = format!("{so_far}.{segment}");
    }
    match place {
        DeValue::Table(table) => {
            table.insert(Spanned::new(0..0, last.into()), value);
        }
        other => *part(other, &so_far, last)? = value.into_inner(),
    }
    Ok(())
}

/// The part of `place` that `segment` names.
fn part<'a, 'i>(
    place: &'a mut DeValue<'i>,
    key: &str,
    segment: &'i str,
) -> Result<&'a mut DeValue<'i>, (String, Cause)> {
    match place {
        DeValue::Table(table) => Ok(descend(table, segment).get_mut()),
        DeValue::Array(list) => {
            let expected = || Cause::Value { found: "a list".into(), expected: "a number from 0 after it".into() };
            let index: usize = segment.parse().map_err(|_| (key.to_owned(), expected()))?;
            let count = list.len();
            let element = list.get_mut(index).ok_or((key.to_owned(), Cause::NoElement { index, count }))?;
            Ok(element.get_mut())
        }
        _ => Err((key.to_owned(), Cause::NoParts { part: segment.to_owned() })),
    }
}

fn descend<'a, 'i>(table: &'a mut DeTable<'i>, name: &'i str) -> &'a mut Spanned<DeValue<'i>> {
    table
        .entry(Spanned::new(0..0, Cow::Borrowed(name)))
        .or_insert_with(|| Spanned::new(0..0, DeValue::Table(DeTable::new())))
}

/// The last override that has to do with `key`: of the key itself, of its table, of something inside, or at all.
fn at_fault<'a>(key: &str, assignments: &'a [impl AsRef<str>]) -> Option<&'a str> {
    let inside = |inner: &str, outer: &str| {
        inner.strip_prefix(outer).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    let section = key.split('.').next().unwrap_or(key);
    let last = |wanted: &dyn Fn(&str) -> bool| {
        let mut texts = assignments.iter().rev().map(AsRef::as_ref);
        texts.find(|text| key_and_value(text).is_some_and(|(key, _)| wanted(key)))
    };
    last(&|set| inside(key, set) || inside(set, key))
        .or_else(|| last(&|set| inside(set, section)))
        .or_else(|| last(&|_| true))
}
