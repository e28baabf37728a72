//! Settings in the shortest form that `--set` takes, for links and for the lines of lessons.

use super::Scene;
use super::format::value_text;
use super::overrides::parse_value;
use super::parameter::{List, Parameter};
use toml::Value;
use toml::de::DeValue;

impl Parameter {
    /// Returns its value as the right side of `--set`, as short as possible: without `.0` at whole numbers, lists of
    /// numbers without brackets. `None` where it has no value, and for lists of anything else, which need a scene file.
    pub fn short_setting(&self, scene: &Scene, index: usize) -> Option<String> {
        let value = self.value(scene, index)?;
        let Value::Array(list) = &value else {
            return Some(short(&value));
        };
        let numbers = list
            .iter()
            .all(|element| element.is_float() || element.is_integer());
        let text = list.iter().map(short).collect::<Vec<_>>().join(",");
        numbers.then(|| match list.len() {
            0 | 1 => format!("[{text}]"),
            _ => text,
        })
    }
}

impl Scene {
    /// Returns the settings, as `--set` takes them, that turn `base` into this scene, bit by bit. Where the two have
    /// different numbers of lights, panes or changed materials, that list begins anew. A model's path cannot be removed.
    pub fn settings_from(&self, base: &Self) -> Vec<String> {
        let (mut base, mut settings) = (base.clone(), Vec::new());
        for list in List::ALL {
            let count = list.len(self);
            if list.len(&base) != count {
                list.renew(&mut base, count);
                settings.push(format!("{}=[{}]", list.key(), vec!["{}"; count].join(", ")));
            }
        }
        settings.extend(base.differences(self).map(|(parameter, index)| {
            let value = parameter.short_setting(self, index);
            let value = value.unwrap_or_else(|| parameter.setting(self, index));
            format!("{}={value}", parameter.key(index))
        }));
        settings
    }
}

fn short(value: &Value) -> String {
    let text = value_text(value);
    match value {
        // A whole number has no negative zero.
        Value::Float(_) => match text.strip_suffix(".0") {
            Some(whole) if whole != "-0" => whole.to_owned(),
            _ => text,
        },
        Value::String(word) if is_bare(word) => word.clone(),
        _ => text,
    }
}

/// Returns whether a text is read as itself without quotation marks.
fn is_bare(text: &str) -> bool {
    let read = parse_value(text).ok();
    let itself =
        read.is_some_and(|value| matches!(value.get_ref(), DeValue::String(read) if read == text));
    itself && text.trim() == text
}
