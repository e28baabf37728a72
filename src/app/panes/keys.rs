//! Which keys of a scene differ from another's.

use crate::scene::{Compare, Scene};
use toml::Value;

/// A key whose value has changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// As `--set` takes it.
    pub key: String,
    before: Value,
    after: Value,
}

impl Change {
    /// The value it had, as `--set` takes it.
    pub fn before_text(&self) -> String {
        text(&self.before)
    }

    /// The value it has, as `--set` takes it.
    pub fn after_text(&self) -> String {
        text(&self.after)
    }
}

fn text(value: &Value) -> String {
    match value {
        Value::String(word) if word.chars().all(|c| c.is_ascii_alphanumeric() || c == '-') && !word.is_empty() => {
            word.clone()
        }
        value => value.to_string(),
    }
}

/// What a scene holds, but for what it compares and for lights that the other has not.
fn value(scene: &Scene, lights: usize) -> Option<Value> {
    let mut plain = Scene { compare: Compare::default(), ..scene.clone() };
    plain.lights.truncate(lights);
    Value::try_from(&plain).ok()
}

/// The keys whose values differ. Of lists of lights that are not as long as each other, those that both have.
pub fn changes(before: &Scene, after: &Scene) -> Vec<Change> {
    let lights = if before.lights.len() == after.lights.len() { before.lights.len() } else { 0 };
    let mut found = Vec::new();
    if let (Some(before), Some(after)) = (value(before, lights), value(after, lights)) {
        collect(&before, &after, "", &mut found);
    }
    found
}

fn collect(before: &Value, after: &Value, key: &str, found: &mut Vec<Change>) {
    let inside = |name: &str| if key.is_empty() { name.to_owned() } else { format!("{key}.{name}") };
    match (before, after) {
        (Value::Table(a), Value::Table(b)) => {
            for (name, after) in b {
                match a.get(name) {
                    Some(before) => collect(before, after, &inside(name), found),
                    None => {
                        let (before, after) = (Value::String(String::new()), after.clone());
                        found.push(Change { key: inside(name), before, after });
                    }
                }
            }
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() && b.iter().all(Value::is_table) => {
            for (index, (before, after)) in a.iter().zip(b).enumerate() {
                collect(before, after, &inside(&index.to_string()), found);
            }
        }
        (a, b) if same(a, b) => {}
        (a, b) => found.push(Change { key: key.to_owned(), before: a.clone(), after: b.clone() }),
    }
}

/// Whether two values are the same, bit for bit where they are numbers.
fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Float(a), Value::Float(b)) => a.to_bits() == b.to_bits(),
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b)),
        (a, b) => a == b,
    }
}

/// `scene` with the changes made.
pub fn replaced(scene: &Scene, changes: &[Change]) -> Option<Scene> {
    if changes.is_empty() {
        return None;
    }
    let mut document = Value::try_from(scene).ok()?;
    for change in changes {
        let mut place = &mut document;
        let mut names = change.key.split('.').peekable();
        while let Some(name) = names.next() {
            place = match place {
                Value::Table(table) if names.peek().is_none() => {
                    table.insert(name.to_owned(), change.after.clone());
                    break;
                }
                Value::Table(table) => table.get_mut(name)?,
                Value::Array(list) => list.get_mut(name.parse::<usize>().ok()?)?,
                _ => return None,
            };
        }
    }
    document.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{NormalSource, presets};

    #[test]
    fn what_has_changed_is_named_and_makes_the_one_scene_into_the_other() {
        for preset in presets::ALL {
            let before = (preset.build)();
            let mut after = before.clone();
            after.material.n = f64::INFINITY;
            after.material.ka.y += 0.125;
            after.object.normals = NormalSource::Facet;
            after.camera.eye.z += 1.0 / 3.0;
            if let Some(light) = after.lights.first_mut() {
                light.position.x += 0.1;
            }
            let found = changes(&before, &after);
            let settings: Vec<String> = found.iter().map(|c| format!("{}={}", c.key, c.after_text())).collect();
            assert_eq!(before.with_overrides(&settings).as_ref(), Ok(&after), "{settings:?}");
            assert_eq!(replaced(&before, &found), Some(after.clone()), "{}", preset.name);
            assert_eq!(changes(&after, &after), []);
        }
    }
}
