//! Which keys of a scene differ from another's.

use crate::scene::Scene;
use crate::scene::parameter::Parameter;
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

/// The keys whose values differ. Of lists of lights that are not as long as each other, none.
pub fn changes(before: &Scene, after: &Scene) -> Vec<Change> {
    let lights = if before.lights.len() == after.lights.len() { before.lights.len() } else { 0 };
    let of_scene = Parameter::all().filter(|parameter| !["version", "compare"].contains(&parameter.section()));
    let change = |parameter: &Parameter, index: usize| {
        let value = |scene| parameter.value(scene, index).unwrap_or_else(|| Value::String(String::new()));
        Change { key: parameter.key(index), before: value(before), after: value(after) }
    };
    of_scene
        .flat_map(|parameter| {
            let count = if parameter.of_light() { lights } else { 1 };
            let differs = move |index: &usize| !parameter.agrees(before, after, *index);
            (0..count).filter(differs).map(move |index| change(parameter, index))
        })
        .collect()
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
            let before = preset.scene();
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
