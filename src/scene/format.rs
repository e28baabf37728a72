//! The scene file: TOML in, TOML out.
//!
//! Reading reports every unknown key and every value of a wrong type or, if there are none of these, out of range, with its line.
//! Writing a scene and reading it again gives the same scene, bit for bit.

mod datum;
mod reader;

use super::Scene;
use super::material::SOURCE;
use super::parameter::{Kind, List, Parameter, defaults};
use super::problem::{Cause, ProblemLocation, SceneError, UnlocatedProblem};
use crate::text::{text, with_short_names};
use reader::read;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use toml::de::{DeTable, DeValue};
use toml::{Spanned, Value};

pub use datum::Coefficient;
pub(super) use datum::{Datum, NO_VALUE, is_grey, list_of, read_coefficient, value_text};
pub(super) use reader::set;

/// Tables that are left out if all their keys have their defaults.
const OPTIONAL: [&str; 7] = [
    "about",
    "pattern",
    "transparency",
    "ground",
    "backdrop",
    "depth_cueing",
    "compare",
];

impl Scene {
    /// The version of the format that this program reads and writes.
    pub const VERSION: u32 = 1;

    /// The longest scene file, in bytes. A thousand lights with every key take a quarter of a megabyte; the parser needs up
    /// to a hundred times as much memory as the text.
    pub const MAX_TEXT: usize = 4 << 20;

    /// Reads a scene file's text. Messages call the file `name`.
    ///
    /// # Guarantees
    /// The scene is one that [`Scene::validate`] accepts.
    ///
    /// # Errors
    /// Not TOML, another version, unknown keys or words, values of a wrong type or out of range: each with its line.
    pub fn parse(text: &str, name: &str) -> Result<Self, SceneError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let (scene, mut problems) = match parsed(text) {
            Ok(document) => read_checked(document.get_ref()),
            Err(problem) => (Self::default(), vec![problem]),
        };
        problems.sort_by_key(|problem| problem.offset);
        SceneError::check(problems, |problem| ProblemLocation::Line {
            file: name.to_owned(),
            line: 1 + text
                .bytes()
                .take(problem.offset.unwrap_or(0))
                .filter(|byte| *byte == b'\n')
                .count(),
        })?;
        Ok(scene)
    }

    /// Returns the scene as the text of a scene file. Keys of a light that its kind and attenuation do not read are left
    /// out if they have their default.
    pub fn to_toml(&self) -> String {
        let mut text = format!("# A scene of shading-lab\nversion = {}\n", self.version);
        if self.lights.is_empty() {
            text.push_str("light = []\n");
        }
        let mut tables: Vec<&str> = Parameter::all().filter_map(Parameter::table).collect();
        tables.dedup();
        for table in tables {
            let keys = || Parameter::all().filter(|parameter| parameter.table() == Some(table));
            match List::of(&format!("{table}.")) {
                Some(list) => {
                    let head = format!("[[{}]]", list.key());
                    (0..list.len(self))
                        .for_each(|index| write_table(&mut text, &head, self, index, keys()));
                }
                None if OPTIONAL.contains(&table)
                    && keys().all(|key| key.agrees(self, defaults(), 0)) => {}
                None => write_table(&mut text, &format!("[{table}]"), self, 0, keys()),
            }
        }
        text
    }
}

/// Parses a scene file's text as TOML.
fn parsed(text: &str) -> Result<Spanned<DeTable<'_>>, UnlocatedProblem> {
    let problem = |offset, words| UnlocatedProblem {
        offset: Some(offset),
        ..UnlocatedProblem::new("", Cause::Text(words))
    };
    if text.len() > Scene::MAX_TEXT {
        let words = text!("problem-too-long", limit = Scene::MAX_TEXT >> 20);
        return Err(problem(0, words));
    }
    DeTable::parse(text).map_err(|error| {
        let words = text!("problem-toml", message = with_short_names(error.message()));
        problem(error.span().map_or(0, |span| span.start), words)
    })
}

/// Reads a document into a scene, with its problems: unknown keys and wrong types, and if all values can be read, their limits.
fn read_checked(document: &DeTable<'_>) -> (Scene, Vec<UnlocatedProblem>) {
    let (scene, mut problems) = read(document);
    let is_unknown = |problem: &UnlocatedProblem| matches!(problem.cause, Cause::UnknownKey { .. });
    if problems.iter().all(is_unknown) {
        let located = |problem: UnlocatedProblem| UnlocatedProblem {
            offset: Some(offset_of(document, &problem.key)),
            ..problem
        };
        problems.extend(scene.range_problems().into_iter().map(located));
    }
    (scene, problems)
}

fn write_table(
    text: &mut String,
    head: &str,
    scene: &Scene,
    index: usize,
    keys: impl Iterator<Item = &'static Parameter>,
) {
    text.extend(["\n", head, "\n"]);
    for parameter in keys {
        let Some(value) = parameter.value(scene, index) else {
            continue;
        };
        if is_left_out(parameter, &value, scene, index) {
            continue;
        }
        text.extend([
            parameter.key.rsplit('.').next().unwrap_or(parameter.key),
            " = ",
        ]);
        match &value {
            // A list of lists is written one to a line.
            Value::Array(list) if list.first().is_some_and(Value::is_array) => {
                text.push_str("[\n");
                list.iter()
                    .for_each(|element| text.extend(["    ", &value_text(element), ",\n"]));
                text.push(']');
            }
            value => text.push_str(&value_text(value)),
        }
        text.push('\n');
    }
}

/// Returns whether a value is left out: empty texts and lists, and keys of a light, or the source of a model's materials, that have
/// their default and no effect.
fn is_left_out(parameter: &Parameter, value: &Value, scene: &Scene, index: usize) -> bool {
    let empty = match value {
        Value::String(text) => text.is_empty(),
        Value::Array(list) => list.is_empty(),
        _ => false,
    };
    let off = matches!(parameter.kind, Kind::Switch(_)) || parameter.idle(scene, index).is_some();
    // Compared as texts, which distinguish 0 from −0.
    let default = || parameter.default().as_ref().map(value_text);
    let optional = parameter.of_light() || parameter.key == SOURCE.key;
    empty || (optional && off && Some(value_text(value)) == default())
}

/// Returns the offset of `key` in the document, or of the innermost enclosing table that is in it.
fn offset_of(document: &DeTable<'_>, key: &str) -> usize {
    let mut segments = key.split('.');
    let Some((name, mut value)) = segments
        .next()
        .and_then(|first| document.get_key_value(first))
    else {
        return 0;
    };
    let mut offset = name.span().start;
    for segment in segments {
        let inner = match value.get_ref() {
            DeValue::Table(table) => table
                .get_key_value(segment)
                .map(|(name, inner)| (name.span(), inner)),
            DeValue::Array(list) => segment
                .parse()
                .ok()
                .and_then(|i: usize| list.get(i))
                .map(|inner| (inner.span(), inner)),
            _ => None,
        };
        let Some((span, inner)) = inner else { break };
        (offset, value) = (span.start, inner);
    }
    offset
}

/// Serializes a scene as the text of its file.
impl Serialize for Scene {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.to_toml())
    }
}

impl<'de> Deserialize<'de> for Scene {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Self::parse(&text, "").map_err(serde::de::Error::custom)
    }
}
