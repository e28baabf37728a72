//! From a [`Scene`] to the text of a scene file.

use super::super::Scene;
use super::super::parameter::{Kind, List, Parameter};
use super::datum::value_text;
use toml::Value;

/// Tables that are left out where all of it has its default.
const OPTIONAL: [&str; 7] = ["about", "pattern", "transparency", "ground", "backdrop", "depth_cueing", "compare"];

pub fn write(scene: &Scene) -> String {
    let mut text = format!("# A scene of shading-lab\nversion = {}\n", scene.version);
    if scene.lights.is_empty() {
        text.push_str("light = []\n");
    }
    let mut tables: Vec<&str> = Parameter::all().filter_map(Parameter::table).collect();
    tables.dedup();
    for table in tables {
        let keys = || Parameter::all().filter(|parameter| parameter.table() == Some(table));
        match List::of(&format!("{table}.")) {
            Some(list) => {
                for index in 0..list.len(scene) {
                    section(&mut text, &format!("[[{}]]", list.key()), scene, index, keys());
                }
            }
            None if OPTIONAL.contains(&table) && keys().all(|key| key.value(scene, 0) == key.default()) => {}
            None => section(&mut text, &format!("[{table}]"), scene, 0, keys()),
        }
    }
    text
}

fn section(text: &mut String, head: &str, scene: &Scene, index: usize, keys: impl Iterator<Item = &'static Parameter>) {
    text.extend(["\n", head, "\n"]);
    for parameter in keys {
        let Some(value) = parameter.value(scene, index) else { continue };
        if is_left_out(parameter, &value, scene, index) {
            continue;
        }
        let name = parameter.key.rsplit('.').next().unwrap_or(parameter.key);
        text.extend([name, " = "]);
        match &value {
            // A list of lists has a line for each.
            Value::Array(list) if list.first().is_some_and(Value::is_array) => {
                text.push_str("[\n");
                list.iter().for_each(|element| text.extend(["    ", &value_text(element), ",\n"]));
                text.push(']');
            }
            value => text.push_str(&value_text(value)),
        }
        text.push('\n');
    }
}

/// Empty texts and lists are left out, and keys of a light that have their default and no effect.
fn is_left_out(parameter: &Parameter, value: &Value, scene: &Scene, index: usize) -> bool {
    let empty = match value {
        Value::String(text) => text.is_empty(),
        Value::Array(list) => list.is_empty(),
        _ => false,
    };
    let off = matches!(parameter.kind, Kind::Switch(_)) || (parameter.idle)(scene, index).is_some();
    empty || (parameter.of_light() && off && Some(value) == parameter.default().as_ref())
}
