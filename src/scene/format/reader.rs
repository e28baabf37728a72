//! The step from parsed TOML to a [`Scene`]: each key is looked up in the table of parameters, which reads its value.

use super::super::Scene;
use super::super::parameter::{List, Parameter, defaults};
use super::super::problem::{Cause, UnlocatedProblem, shortened};
use super::datum::{found, integer};
use crate::text::text;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Reads a document into a scene, with everything found on the way. Limits are not checked.
pub fn read(document: &DeTable<'_>) -> (Scene, Vec<UnlocatedProblem>) {
    let mut scene = Scene::default();
    let mut reader = Reader {
        scene: &mut scene,
        problems: vec![],
    };
    match wrong_version(document) {
        Some(problem) => reader.problems.push(problem),
        None => reader.table(&Key::default(), document),
    }
    let problems = reader.problems;
    (scene, problems)
}

/// Returns the problem of another version: its keys mean nothing here, so its number is all that is reported.
fn wrong_version(document: &DeTable<'_>) -> Option<UnlocatedProblem> {
    let (key, value) = document.get_key_value("version")?;
    let DeValue::Integer(number) = value.get_ref() else {
        return None;
    };
    let known = integer(number) == Some(i64::from(Scene::VERSION));
    let problem = UnlocatedProblem::new("version", Cause::version(number));
    (!known).then(|| UnlocatedProblem {
        offset: Some(key.span().start),
        ..problem
    })
}

/// Sets a key of a scene to a value: a parameter, an element of its list (`camera.eye.1`), or a table or a list of tables,
/// all of which is replaced. Returns the problems of the value.
pub fn set(scene: &mut Scene, name: &str, value: Spanned<DeValue<'_>>) -> Vec<UnlocatedProblem> {
    let mut reader = Reader {
        scene,
        problems: vec![],
    };
    let mut key = Key::default();
    let mut parts = name.split('.');
    while let Some(part) = parts.next() {
        key = match key.node() {
            Node::Table => key.inside(part),
            Node::List(list) => match element(part, list.len(reader.scene)) {
                Ok(index) => key.element(index),
                Err(cause) => return key.problem(cause),
            },
            Node::Parameter(parameter) => {
                let whole = parameter
                    .value(reader.scene, key.index)
                    .map_or_else(String::new, |value| value.to_string());
                let Ok(mut whole) = DeValue::parse(&whole) else {
                    return vec![];
                };
                let path = std::iter::once(part).chain(parts);
                match element_of(whole.get_mut(), &key, path) {
                    Ok(place) => *place = value.into_inner(),
                    Err(problems) => return problems,
                }
                reader.value(&key, 0, &whole);
                return reader.problems;
            }
            Node::Unknown => break,
        };
    }
    match key.node() {
        Node::Unknown => {
            let table = key
                .pattern
                .rsplit_once('.')
                .map_or("", |(table, _)| table)
                .to_owned();
            return key.problem(Cause::UnknownKey {
                known: Parameter::names_in(&table),
            });
        }
        Node::Table => reader.clear(&key),
        Node::Parameter(_) | Node::List(_) => {}
    }
    reader.value(&key, 0, &value);
    reader.problems
}

/// Finds the element of a list, or of nested lists, that the rest of a key names.
fn element_of<'v, 'i, 'p>(
    mut value: &'v mut DeValue<'i>,
    key: &Key,
    path: impl Iterator<Item = &'p str>,
) -> Result<&'v mut DeValue<'i>, Vec<UnlocatedProblem>> {
    let mut key = key.clone();
    for part in path {
        let DeValue::Array(list) = value else {
            let words = text!("problem-single-value", part = shortened(part));
            return Err(key.problem(Cause::Key(words)));
        };
        let index = element(part, list.len()).map_err(|cause| key.problem(cause))?;
        value = list.get_mut(index).ok_or_else(Vec::new)?.get_mut();
        key = key.inside(part);
    }
    Ok(value)
}

/// Reads the number of an element of a list.
fn element(part: &str, count: usize) -> Result<usize, Cause> {
    let index = part
        .parse()
        .map_err(|_| Cause::value(text!("found-list"), text!("expected-index")))?;
    let expected = match count {
        _ if index < count => return Ok(index),
        0 => text!("expected-no-index").to_owned(),
        1 => text!("expected-only-index").to_owned(),
        _ => text!("range-between", least = 0, greatest = count - 1),
    };
    Err(Cause::Key(text!(
        "problem-no-element",
        index = index,
        expected = expected
    )))
}

/// The name of a table, a list or a value.
#[derive(Clone, Default)]
struct Key {
    /// The key in messages and for `--set`, for example `light.1.k`.
    text: String,
    /// The key in the table of parameters, for example `light.N.k`.
    pattern: String,
    /// The number of the light or pane.
    index: usize,
}

/// The item that a key refers to.
enum Node {
    Parameter(&'static Parameter),
    List(List),
    Table,
    Unknown,
}

impl Key {
    fn inside(&self, name: &str) -> Self {
        let join = |table: &str| {
            // A name without letters is not a key, and not the whole scene.
            if table.is_empty() && !name.is_empty() {
                name.to_owned()
            } else {
                format!("{table}.{name}")
            }
        };
        Self {
            text: join(&self.text),
            pattern: join(&self.pattern),
            index: self.index,
        }
    }

    fn element(&self, index: usize) -> Self {
        Self {
            text: format!("{}.{index}", self.text),
            pattern: format!("{}.N", self.pattern),
            index,
        }
    }

    fn problem(&self, cause: Cause) -> Vec<UnlocatedProblem> {
        vec![UnlocatedProblem::new(&self.text, cause)]
    }

    fn node(&self) -> Node {
        if self.pattern.is_empty() {
            return Node::Table;
        }
        let mut inside = Parameter::in_table(&self.pattern);
        match inside.next() {
            None => Parameter::all()
                .find(|parameter| parameter.key == self.pattern)
                .map_or(Node::Unknown, Node::Parameter),
            Some(parameter) => match List::of(parameter.key) {
                Some(list) if list.key() == self.pattern => Node::List(list),
                _ => Node::Table,
            },
        }
    }
}

struct Reader<'s> {
    scene: &'s mut Scene,
    problems: Vec<UnlocatedProblem>,
}

impl Reader<'_> {
    fn table(&mut self, key: &Key, table: &DeTable<'_>) {
        for (name, value) in table {
            let (offset, inner) = (name.span().start, key.inside(name.get_ref()));
            if name.get_ref().contains('.') || matches!(inner.node(), Node::Unknown) {
                let cause = Cause::UnknownKey {
                    known: Parameter::names_in(&key.pattern),
                };
                self.problems.push(UnlocatedProblem {
                    offset: Some(offset),
                    key: inner.text,
                    cause,
                });
            } else {
                self.value(&inner, offset, value);
            }
        }
    }

    fn value(&mut self, key: &Key, offset: usize, value: &Spanned<DeValue<'_>>) {
        let read = match (key.node(), value.get_ref()) {
            (Node::Parameter(parameter), _) => parameter.read(self.scene, key.index, value),
            (Node::List(list), DeValue::Array(elements)) => {
                list.renew(self.scene, elements.len());
                for (index, element) in elements.iter().enumerate() {
                    self.value(&key.element(index), element.span().start, element);
                }
                Ok(())
            }
            (Node::List(_), other) => Err(UnlocatedProblem::value(
                found(other),
                text!("expected-tables"),
            )),
            (_, DeValue::Table(table)) => {
                self.table(key, table);
                Ok(())
            }
            (_, other) => Err(UnlocatedProblem::value(
                found(other),
                text!("expected-table"),
            )),
        };
        if let Err(wrong) = read {
            self.problems.push(UnlocatedProblem {
                offset: wrong.offset.or(Some(offset)),
                key: format!("{}{}", key.text, wrong.key),
                cause: wrong.cause,
            });
        }
    }

    /// Gives everything in a table its default.
    fn clear(&mut self, key: &Key) {
        for parameter in Parameter::in_table(&key.pattern) {
            match List::of(parameter.key) {
                Some(List::Lights) => self.scene.lights[key.index] = Default::default(),
                Some(List::Panes) if key.pattern == "compare" => self.scene.compare.panes.clear(),
                Some(List::Panes) => self.scene.compare.panes[key.index] = Default::default(),
                Some(List::Materials) if key.pattern == "object" => {
                    self.scene.object.materials.clear();
                }
                Some(List::Materials) => {
                    self.scene.object.materials[key.index] = Default::default();
                }
                None => parameter.field().copy(defaults(), self.scene, 0),
            }
        }
    }
}
