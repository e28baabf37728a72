//! The scene file: the errors of its reader, and the accuracy of its documentation.

mod faults;

use crate::common::value;
use glam::DVec3;
use shading_lab::scene::{
    Cause, Choice, Light, Material, ObjectKind, Rgb, Scene, SceneDescription, ShadingMode,
    materials, nearest, presets,
};

/// Returns all errors of reading `text` as the file `s.toml`, a line each.
fn objections(text: &str) -> String {
    Scene::parse(text, "s.toml")
        .expect_err("a mistake")
        .to_string()
}

#[track_caller]
fn assert_objections(text: &str, expected: &[&str]) {
    assert_eq!(
        objections(text).lines().collect::<Vec<_>>(),
        expected,
        "{text}"
    );
}

#[test]
fn an_empty_file_is_the_default_scene() {
    assert_eq!(Scene::parse("", "s.toml"), Ok(Scene::default()));
    assert_eq!(
        Scene::parse("\u{feff}version = 1\r\n", "s.toml"),
        Ok(Scene::default())
    );
}

#[test]
fn values_are_read_as_an_author_writes_them() {
    let text = "
        material = { ka = 1, kd = [0.25, 0, 1e-3], n = inf }
        camera.eye = [0, 0x10, 5_000]
        shading.mode = 'gouraud'
        [[light]]
        kind = \"directional\"
        [[light]]
    ";
    let scene = Scene::parse(text, "s.toml").expect("sound");
    assert_eq!(scene.material.ka, Rgb::ONE);
    assert_eq!(scene.material.kd, Rgb::new(0.25, 0.0, 0.001));
    assert_eq!(scene.material.n, f64::INFINITY);
    assert_eq!(scene.camera.eye, DVec3::new(0.0, 16.0, 5000.0));
    assert_eq!(scene.shading.mode, ShadingMode::Gouraud);
    assert_eq!(scene.lights.len(), 2);
    assert_eq!(scene.lights[1], Light::default());
    assert_eq!(
        Scene::parse("light = []", "s.toml")
            .expect("darkness")
            .lights,
        []
    );
}

#[test]
fn the_shapes_have_their_own_least_tessellation() {
    let read = |kind: &str, segments: u32, rings: u32| {
        Scene::parse(
            &format!("object = {{kind = '{kind}', segments = {segments}, rings = {rings}}}"),
            "",
        )
        .is_ok()
    };
    assert!(read("sphere", 3, 2) && !read("sphere", 3, 1) && !read("sphere", 2, 2));
    assert!(read("torus", 3, 3) && !read("torus", 3, 2));
    assert!(read("plane", 1, 1) && !read("plane", 0, 1) && !read("plane", 1, 0));
    assert!(read("cylinder", 3, 1) && !read("cylinder", 2, 1));
}

#[test]
fn no_text_takes_the_reader_down() {
    let deep = format!("a = {}", "[".repeat(200_000));
    let dotted = format!("{}a = 1", "a.".repeat(200_000));
    let long_key = format!("{} = 1", "k".repeat(100_000));
    let long_word = format!("shading.mode = '{}'", "w".repeat(100_000));
    let controls = "shading.mode = \"\\u001B[31m\\n\"".to_owned();
    for text in [deep, dotted, long_key, long_word, controls] {
        let message = objections(&text);
        assert!(message.starts_with("s.toml:1: "), "{message}");
        assert!(
            message.len() < 400 && !message.contains(['\n', '\u{1b}']),
            "{message:?}"
        );
    }
    assert_eq!(
        objections(&" ".repeat(Scene::MAX_TEXT + 1)),
        format!("s.toml:1: {}", english!("problem-too-long", limit = 4))
    );
    let unknown: String = (0..300_000).map(|i| format!("k{i}=1\n")).collect();
    let message = objections(&unknown);
    assert_eq!(message.lines().count(), 101);
    assert_eq!(
        message.lines().last(),
        Some(&*format!(
            "s.toml: {}",
            english!("problem-more", count = 299900)
        ))
    );
    let many = format!("light = [{}]", "{},".repeat(Scene::MAX_LIGHTS + 1));
    assert_eq!(
        objections(&many),
        value(
            "s.toml:1: `light`",
            &english!("found-list-of", count = 1001),
            &english!("range-at-most", count = 1000)
        )
    );
}

#[test]
fn a_key_is_overridden() {
    let scene = Scene::default();
    let set = |assignments: &[&str]| scene.with_overrides(assignments).expect("sound");
    assert_eq!(set(&["material.n=1005"]).material.n, 1005.0);
    assert_eq!(set(&["material.n = inf"]).material.n, f64::INFINITY);
    assert_eq!(
        set(&["shading.mode=gouraud"]).shading.mode,
        ShadingMode::Gouraud
    );
    assert_eq!(
        set(&["shading.mode=\"flat\""]).shading.mode,
        ShadingMode::Flat
    );
    assert_eq!(
        set(&["light.0.position=[2,2,3.5]"]).lights[0].position,
        DVec3::new(2.0, 2.0, 3.5)
    );
    assert_eq!(set(&["light.0.k=7"]).lights[0].k, 7.0);
    assert_eq!(
        set(&["camera.eye.1=-0.5"]).camera.eye,
        DVec3::new(0.0, -0.5, 4.0)
    );
    assert_eq!(set(&["light=[]"]).lights, []);
    assert_eq!(set(&["light=[{}, {kind='directional'}]"]).lights.len(), 2);
    assert_eq!(
        set(&["material={n=2}"]).material,
        Material {
            n: 2.0,
            ..Material::default()
        }
    );
    let model = set(&["object.kind=obj", "object.path=/models/a=b.obj"]).object;
    assert_eq!(
        (model.kind, model.path),
        (ObjectKind::Obj, Some("/models/a=b.obj".into()))
    );
    assert_eq!(
        set(&["camera.eye=[0,0,0]", "camera.target=[0,0,-1]"])
            .camera
            .target,
        DVec3::NEG_Z
    );
    assert_eq!(set(&[]), scene);
}

#[test]
fn a_scene_made_in_the_program_is_checked_too() {
    let mut scene = Scene::default();
    assert_eq!(scene.validate(), Ok(()));
    scene.material.n = f64::NAN;
    scene.camera.eye.x = f64::INFINITY;
    let error = scene.validate().expect_err("two numbers that are none");
    let keys: Vec<_> = error
        .problems()
        .iter()
        .map(|problem| problem.key.as_str())
        .collect();
    assert_eq!(keys, ["camera.eye", "material.n"]);
    let is_value = |cause: &Cause| matches!(cause, Cause::Key(words) if words.starts_with("is "));
    assert!(
        error
            .problems()
            .iter()
            .all(|problem| is_value(&problem.cause))
    );
}

#[test]
fn a_written_light_has_only_the_keys_that_it_reads_or_that_were_set() {
    let text = Scene::default().to_toml();
    let light = text.split("[[light]]\n").nth(1).expect("a light");
    assert_eq!(
        light,
        "kind = \"point\"\nposition = [2.0, 2.0, 3.0]\ncolor = [1.0, 1.0, 1.0]\nattenuation = \"none\"\n"
    );
}

const DOCUMENTATION: &str = include_str!("../../docs/scene-file.md");

#[test]
fn the_longest_polygons_survive_their_file() {
    let mut scene = Scene::default();
    let coordinate =
        |k: u32| -1.234_567_890_123_456_7e-5 * (f64::from(k) + 0.123_456_789_012_345_6);
    let vertices: Vec<DVec3> = (0..16_384)
        .map(|k| DVec3::new(coordinate(k), coordinate(k) * coordinate(k), -1.0 / 3.0))
        .collect();
    scene.object.vertices = vertices.into();
    scene.object.vertex_normals = scene.object.vertices.clone();
    scene.object.faces = (0..16_384u32)
        .map(|k| [0, 1, 2, 3].map(|c| (4 * k + c) % 16_381).to_vec().into())
        .collect();
    let text = scene.to_toml();
    assert!(text.len() < Scene::MAX_TEXT * 3 / 4, "{}", text.len());
}

#[test]
fn a_single_vertex_can_be_replaced() {
    let scene = Scene::default().with_overrides(&[
        "object.kind=polygons",
        "object.vertices=[[0,0,0],[1,0,0],[0,1,0]]",
        "object.faces=[[0,1,2]]",
    ]);
    let scene = scene
        .and_then(|scene| scene.with_override("object.vertices.2.1=3.5"))
        .expect("sound");
    assert_eq!(scene.object.vertices[2], DVec3::new(0.0, 3.5, 0.0));
}

#[test]
fn the_documented_scenes_are_sound() {
    let blocks: Vec<_> = DOCUMENTATION
        .split("```toml\n")
        .skip(1)
        .filter_map(|rest| rest.split("```").next())
        .collect();
    assert!(!blocks.is_empty());
    for block in blocks {
        let scene =
            Scene::parse(block, "scene-file.md").unwrap_or_else(|error| panic!("{error}\n{block}"));
        assert_ne!(scene, Scene::default());
    }
}

/// Returns the words between backquotes.
fn quoted(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

#[test]
fn the_manual_names_every_built_in_scene_under_its_topic() {
    let manual = include_str!("../../docs/command-line.md");
    for preset in presets::ALL {
        let row = manual
            .lines()
            .find(|line| line.starts_with(&format!("| {} |", preset.topic_title())));
        let named = row.is_some_and(|row| quoted(row).contains(&preset.name));
        assert!(
            named,
            "{} is not named under {}",
            preset.name,
            preset.topic_title()
        );
    }
}

#[test]
fn every_scene_is_read_and_survives_its_file() {
    for preset in presets::ALL {
        let scene = preset.scene();
        assert_eq!(
            Scene::parse(&scene.to_toml(), preset.name),
            Ok(scene),
            "{}",
            preset.name
        );
    }
}

#[test]
fn every_name_is_its_own_and_every_scene_says_what_it_is_about() {
    let files =
        std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes")).expect("a folder");
    assert_eq!(files.count(), presets::ALL.len(), "every file is listed");
    for preset in presets::ALL {
        assert!(
            preset
                .name
                .chars()
                .all(|c| c.is_ascii_lowercase() || c == '-'),
            "{}",
            preset.name
        );
        let SceneDescription {
            title,
            sentence,
            topic,
            view,
        } = preset.about();
        assert!(std::ptr::eq(
            presets::find(preset.name).expect("listed"),
            preset
        ));
        assert!(
            !title.is_empty() && sentence.ends_with('.') && !topic.is_empty(),
            "{}",
            preset.name
        );
        assert_eq!(
            view.is_empty(),
            preset.name == presets::DEFAULT,
            "{}",
            preset.name
        );
    }
    let mut sorted = presets::topics();
    sorted.sort_unstable();
    sorted.dedup();
    assert_eq!(
        sorted.len(),
        presets::topics().len(),
        "scenes of a topic stand together"
    );
}

#[test]
fn every_shape_without_a_file_is_shown() {
    let shapes: Vec<_> = presets::ALL
        .iter()
        .map(|preset| preset.scene().object.kind)
        .collect();
    for kind in ObjectKind::VALUES
        .iter()
        .filter(|kind| **kind != ObjectKind::Obj)
    {
        assert!(shapes.contains(kind), "{kind:?}");
    }
}

#[test]
fn every_material_is_sound_and_survives_its_file() {
    assert_eq!(materials::NAMED.len(), 4 * materials::OF_A_KIND);
    for named in materials::NAMED {
        let scene = Scene {
            material: named.material(),
            ..Scene::default()
        };
        assert_eq!(scene.validate(), Ok(()), "{}", named.name);
        assert_eq!(
            Scene::parse(&scene.to_toml(), named.name),
            Ok(scene),
            "{}",
            named.name
        );
    }
}

#[test]
fn every_material_is_found_by_its_name_and_by_its_numbers() {
    for named in materials::NAMED {
        assert!(
            named
                .name
                .chars()
                .all(|c| c.is_ascii_lowercase() || c == '-'),
            "{}",
            named.name
        );
        assert_eq!(materials::find(named.name), Some(named));
        assert_eq!(
            materials::recognise(&named.material()),
            Some(named),
            "{}",
            named.name
        );
    }
    assert_eq!(materials::recognise(&Material::default()), None);
}

#[test]
fn the_numbers_are_the_published_ones() {
    let gold = materials::find("gold")
        .expect("a named material")
        .material();
    assert_eq!((gold.ka, gold.n), (Rgb::new(0.24725, 0.1995, 0.0745), 51.2));
    let pearl = materials::find("pearl")
        .expect("a named material")
        .material();
    assert_eq!((pearl.kd, pearl.n), (Rgb::new(1.0, 0.829, 0.829), 11.264));
}

#[test]
fn the_nearest_word_is_found_and_a_distant_one_is_not() {
    let known = ["flat", "interpolated", "gouraud", "phong", "exact"];
    assert_eq!(nearest("gouraux", known), Some("gouraud"));
    assert_eq!(nearest("Pohng", known), Some("phong"));
    assert_eq!(nearest("inter", known), Some("interpolated"));
    assert_eq!(nearest("toon", known), None);
    assert_eq!(nearest("", known), None);
    assert_eq!(nearest("x", ["k"]), None);
    assert_eq!(nearest(&"p".repeat(1 << 20), known), None);
}
