//! The table of parameters: complete, equal to the documentation, and with the limits that scenes are held to.

use crate::common::program::Folder;
use shading_lab::scene::parameter::{Kind, Parameter};
use shading_lab::scene::{
    FaceMaterial, Material, MaterialOverride, MaterialSource, Pane, Reflectance, Rgb, Scene,
    SceneDescription, presets,
};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::{env, fs};
use toml::Value;

/// Returns a scene in which every key has a value and is written.
fn full() -> Scene {
    let mut scene = Scene::default();
    let text = || "text".to_owned();
    scene.about = SceneDescription {
        title: text(),
        sentence: text(),
        topic: text(),
        view: text(),
    };
    (
        scene.pattern.scale,
        scene.transparency.kt,
        scene.ground.visible,
    ) = (1.0, 0.5, true);
    scene.image.size = [30, 20];
    (
        scene.backdrop.scale,
        scene.depth_cueing.front,
        scene.compare.gain,
    ) = (1.0, 2.0, 2.0);
    scene.object.path = Some("model.obj".into());
    scene.object.vertices = vec![glam::DVec3::ZERO].into();
    scene.object.faces = vec![vec![0].into()].into();
    scene.object.vertex_normals = vec![glam::DVec3::Z].into();
    scene.lights[0].name = "Lamp".into();
    scene.compare.name = "First".to_owned();
    scene.compare.panes = vec![Pane {
        name: "Other".into(),
        set: vec!["material.n=2".into()],
    }];
    scene.material.source = MaterialSource::Scene;
    let whole = Material {
        ka: Rgb::ONE,
        kd: Rgb::ONE,
        ks: Rgb::ONE,
        n: 2.0,
        color: Rgb::ONE,
        specular_color: Rgb::ZERO,
        roughness: 0.5,
        reflectance: Reflectance::Gold,
        ior: Rgb::ONE,
        extinction: Rgb::ONE,
        source: MaterialSource::Model,
    };
    let whole = FaceMaterial {
        material: whole,
        kt: 0.5,
        relative_ior: 2.0,
    };
    let change = MaterialOverride::between("red", &FaceMaterial::default(), &whole);
    scene.object.materials = vec![change];
    scene
}

/// Returns the file of a scene.
fn written(scene: &Scene) -> Value {
    Value::Table(scene.to_toml().parse().expect("TOML"))
}

fn keys(value: &Value, key: &str, found: &mut BTreeSet<String>) {
    let inside = |name: &str| {
        if key.is_empty() {
            name.to_owned()
        } else {
            format!("{key}.{name}")
        }
    };
    match value {
        Value::Table(table) => table
            .iter()
            .for_each(|(name, value)| keys(value, &inside(name), found)),
        Value::Array(list) if !list.is_empty() && list.iter().all(Value::is_table) => {
            keys(&list[0], &inside("N"), found);
        }
        _ => assert!(found.insert(key.to_owned()), "{key} twice"),
    }
}

#[test]
fn every_key_of_a_full_scene_file_stands_in_the_table_once() {
    let listed: BTreeSet<_> = Parameter::all()
        .map(|parameter| parameter.key.to_owned())
        .collect();
    assert_eq!(
        listed.len(),
        Parameter::all().count(),
        "a key stands in the table twice"
    );
    let mut expected = BTreeSet::new();
    keys(&written(&full()), "", &mut expected);
    // Only the keys that a light's kind reads are written; `tests/engine/scene_round_trip.rs` covers the others.
    assert!(
        expected.is_subset(&listed),
        "{:?}",
        expected.difference(&listed).collect::<Vec<_>>()
    );
    let missing: Vec<_> = listed
        .difference(&expected)
        .filter(|key| !key.starts_with("light.N."))
        .collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// Returns the numbers and words in the fields of a scene, by the names of the fields: `light.k` stands for every light.
fn fields(scene: &Scene) -> BTreeMap<String, String> {
    let mut fields = BTreeMap::<String, String>::new();
    let mut path: Vec<String> = vec![];
    for line in format!("{scene:#?}").lines() {
        let (depth, text) = ((line.len() - line.trim_start().len()) / 4, line.trim());
        path.resize(depth, String::new());
        if text.trim_matches([')', ']', '}', ',']).is_empty() {
            continue;
        }
        let (name, value) = text
            .split_once(": ")
            .filter(|(name, _)| !name.contains('"'))
            .unwrap_or(("", text));
        let one = [
            ("lights", "light"),
            ("panes", "pane"),
            ("materials", "material"),
        ];
        let name = one
            .iter()
            .find(|(list, _)| *list == name)
            .map_or(name, |(_, one)| one);
        path.push(name.to_owned());
        let key = path
            .iter()
            .filter(|name| !name.is_empty())
            .cloned()
            .collect::<Vec<_>>()
            .join(".");
        fields.entry(key).or_default().push_str(value);
    }
    fields
}

#[test]
fn its_access_reaches_the_field_of_its_key() {
    let (scene, mut plain) = (full(), Scene::default());
    plain.object.materials = vec![MaterialOverride::default()];
    for parameter in Parameter::all() {
        let mut other = scene.clone();
        match &parameter.kind {
            Kind::Number(at, ..) => *(at.get_mut)(&mut other, 0).expect("a value") += 0.5,
            Kind::Whole(at, ..) => *(at.get_mut)(&mut other, 0).expect("a value") += 1,
            Kind::Pair(at, ..) => (at.get_mut)(&mut other, 0).expect("a value")[0] += 0.5,
            Kind::Coefficient(at, ..) | Kind::Channels(at, ..) | Kind::Colour(at, _) => {
                (at.get_mut)(&mut other, 0).expect("a value").x += 0.5;
            }
            Kind::Point(at) | Kind::Direction(at, _) => {
                (at.get_mut)(&mut other, 0).expect("a value").x += 0.5;
            }
            Kind::Switch(at) => *(at.get_mut)(&mut other, 0).expect("a value") ^= true,
            Kind::Text(at, _) | Kind::Lines(at, _) => {
                (at.get_mut)(&mut other, 0).expect("a value").push('x');
            }
            Kind::Other(..) => parameter.copy(&plain, &mut other, 0),
            // `--set` accepts every word of a choice, and the word selects its option.
            Kind::Choice(choice) => {
                let before = choice.chosen(&scene, 0).expect("a value");
                for (place, option) in parameter.options().iter().enumerate() {
                    choice.choose(&mut other, 0, place);
                    assert_eq!(choice.chosen(&other, 0), Some(place), "{}", parameter.key);
                    assert_eq!(
                        parameter.value(&other, 0),
                        Some(Value::String(option.word.to_owned()))
                    );
                }
                choice.choose(&mut other, 0, (before + 1) % parameter.options().len());
            }
        }
        let (before, after) = (fields(&scene), fields(&other));
        let changed: Vec<_> = before
            .iter()
            .filter(|(name, value)| after.get(*name) != Some(value))
            .collect();
        let key = parameter.key.replace(".N.", ".");
        let unchanged = ["version", "compare.pane.set"].contains(&&*key);
        assert!(unchanged || !changed.is_empty(), "{key}");
        assert!(
            changed
                .iter()
                .all(|(name, _)| **name == key || name.starts_with(&format!("{key}."))),
            "{key}: {changed:?}"
        );
    }
}

#[test]
fn a_scene_is_held_to_the_limits_of_the_table() {
    let scene = Scene::default();
    for parameter in Parameter::all() {
        let Some(limits) = parameter.limits(&scene) else {
            continue;
        };
        let (least, greatest) = (limits.least, limits.greatest);
        let beyond = [
            least - least.abs().max(1.0),
            greatest + greatest.abs().max(1.0),
            f64::NAN,
        ];
        for value in [least, greatest].into_iter().chain(beyond) {
            let mut other = scene.clone();
            let sound = (least..=greatest).contains(&value);
            match &parameter.kind {
                Kind::Number(at, ..) => *(at.get_mut)(&mut other, 0).expect("a light") = value,
                // There are no negative whole numbers to be refused.
                Kind::Whole(..) if least == 0.0 && !sound && value.is_nan() | (value < 0.0) => {
                    continue;
                }
                Kind::Whole(at, ..) => {
                    *(at.get_mut)(&mut other, 0).expect("a light") = value as u32;
                }
                Kind::Pair(at, ..) => (at.get_mut)(&mut other, 0).expect("a light")[1] = value,
                Kind::Coefficient(at, ..) | Kind::Channels(at, ..) | Kind::Colour(at, _) => {
                    (at.get_mut)(&mut other, 0).expect("a light").y = value;
                }
                _ => continue,
            }
            let key = parameter.key(0);
            let named = other.validate().is_err_and(|error| {
                error.problems().iter().any(|problem| {
                    problem.key == key && problem.to_string().contains(&limits.to_string())
                })
            });
            assert_eq!(named, !sound, "{key} = {value}");
        }
    }
}

#[test]
fn every_default_can_be_set() {
    for parameter in Parameter::all().filter(|parameter| !parameter.key.starts_with("compare.pane"))
    {
        let Some(default) = parameter.default() else {
            continue;
        };
        let scene = Scene::default().with_override(&format!("{}={default}", parameter.key(0)));
        assert_eq!(scene, Ok(Scene::default()), "{}", parameter.key);
    }
}

#[test]
fn scenes_agree_in_what_is_equal_and_differ_in_what_is_not() {
    for preset in presets::ALL {
        let scene = preset.scene();
        assert!(
            Parameter::all().all(|parameter| parameter.agrees(&scene, &scene, 0)),
            "{}",
            preset.name
        );
        let mut other = scene.clone();
        other.material.n = -0.0;
        other.camera.eye.z += 1e-9;
        let differ: Vec<_> = Parameter::all()
            .filter(|parameter| !parameter.agrees(&scene, &other, 0))
            .map(|parameter| parameter.key)
            .collect();
        assert_eq!(differ, ["camera.eye", "material.n"], "{}", preset.name);
    }
}

#[test]
fn the_command_lists_every_parameter() {
    let folder = Folder::new("parameters");
    let text = folder.prints(&["parameters"]);
    let json = folder.json(&["parameters", "--json"]);
    let listed = json["parameters"].as_array().expect("a list");
    assert_eq!(listed.len(), Parameter::all().count());
    for (object, parameter) in listed.iter().zip(Parameter::all()) {
        assert_eq!(object["key"], parameter.key);
        assert!(
            text.lines()
                .any(|line| line.split(' ').next() == Some(parameter.key)),
            "{}",
            parameter.key
        );
        for key in [
            "symbol", "name", "unit", "kind", "limits", "default", "choices", "help",
        ] {
            assert!(object.get(key).is_some(), "{}: no {key}", parameter.key);
        }
        assert!(
            !parameter.name().is_empty() && parameter.help().ends_with('.'),
            "{}",
            parameter.key
        );
    }
    let n = listed
        .iter()
        .find(|object| object["key"] == "material.n")
        .expect("n");
    assert_eq!(
        (&n["symbol"], &n["default"], &n["limits"]),
        (&"n".into(), &32.0.into(), &serde_json::json!([0.0, null]))
    );
}

/// Returns the rows of the sections `names` as the documentation has them.
fn table(names: &str) -> String {
    let mut text = "| key | default | range | meaning |\n|---|---|---|---|\n".to_owned();
    let in_section = |parameter: &&Parameter| {
        names
            .split(' ')
            .any(|name| parameter.key.split('.').next() == Some(name))
    };
    for parameter in Parameter::all().filter(in_section) {
        let code = |text: &str| {
            if text.is_empty() {
                String::new()
            } else {
                format!("`{text}`")
            }
        };
        let range = match parameter.options() {
            [] => parameter.range_text(),
            options => {
                let option = |option: &shading_lab::scene::ChoiceOption| {
                    format!("{}: {}", code(option.word), option.help())
                };
                options.iter().map(option).collect::<Vec<_>>().join("; ")
            }
        };
        let key = parameter
            .key
            .strip_prefix("light.N.")
            .unwrap_or(parameter.key);
        let letter = if parameter.letter.is_empty() {
            String::new()
        } else {
            format!("{}: ", parameter.letter)
        };
        let unit = parameter
            .unit
            .map_or_else(String::new, |unit| format!(" ({})", unit.name()));
        let default = code(&parameter.default_text());
        let range = range.replace('|', "\\|");
        let _ = writeln!(
            text,
            "| `{key}` | {default} | {range} | {letter}{}{unit} |",
            parameter.help()
        );
    }
    text
}

/// Compares the tables with the documentation. `UPDATE_DOCS=true` rewrites them, and the test still fails that once.
#[test]
fn the_documentation_has_the_table() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scene-file.md");
    let present = fs::read_to_string(path).expect("docs/scene-file.md");
    let mut wanted = String::new();
    let mut sections = present.split("<!-- parameters: ");
    wanted.push_str(sections.next().unwrap_or_default());
    for section in sections {
        let (names, rest) = section.split_once(" -->").expect("the names of sections");
        let (_, rest) = rest.split_once("<!-- end -->").expect("the end of a table");
        let _ = write!(
            wanted,
            "<!-- parameters: {names} -->\n{}<!-- end -->{rest}",
            table(names)
        );
    }
    if present != wanted && env::var_os("UPDATE_DOCS").is_some() {
        fs::write(path, &wanted).expect("docs/scene-file.md");
    }
    assert!(
        present == wanted,
        "docs/scene-file.md is stale: run UPDATE_DOCS=true cargo test --test engine parameters"
    );
}
