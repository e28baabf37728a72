//! The program in scripts: its output, its files and its exit status.

mod analyses;
mod laws;
mod memory;
mod outputs;

use crate::common::program::{Folder, outside, pixels_of, size_of, sound};
use crate::common::value;
use serde_json::Value;
use shading_lab::scene::{Scene, ShadingMode, presets};
use std::fs;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Returns the message about a missing file; `kind` is the key of the expected kind.
fn missing(kind: &str) -> String {
    english!("document-no-such-file", expected = english!(kind))
}

#[test]
fn a_model_drawn_without_its_materials_says_so_once() {
    let folder = Folder::new("materials-of-a-model");
    folder.write("plain.obj", TRIANGLE);
    folder.write("red.obj", format!("mtllib red.mtl\nusemtl red\n{TRIANGLE}"));
    let missing = missing("document-library");
    let message = format!("red.obj:1: red.mtl: {missing}");
    let note = english!("cli-note", message = message) + "\n";
    for arguments in [
        &["check", "MODEL"][..],
        &["render", "MODEL", "-o", "a.png", "--size", "8x8"],
        &[
            "probe", "MODEL", "--pixel", "4,4", "--size", "8x8", "--json",
        ],
        &["explain", "MODEL"],
    ] {
        for (model, expected) in [("plain.obj", ""), ("red.obj", &note)] {
            let words: Vec<String> = arguments
                .iter()
                .map(|word| word.replace("MODEL", model))
                .collect();
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            let output = folder.run(&words);
            let errors = String::from_utf8_lossy(&output.stderr);
            assert_eq!(
                (output.status.code(), &*errors),
                (Some(0), expected),
                "{words:?}"
            );
        }
    }
    folder.write(
        "named.obj",
        format!("mtllib named.mtl\nusemtl red\n{TRIANGLE}"),
    );
    folder.write("named.mtl", "newmtl red\nKd 1 0 0\n");
    let json = folder.json(&["check", "named.obj", "--json"]);
    assert_eq!(json["materials"], serde_json::json!(["red"]));
    let listed = english!("cli-check-materials", names = "red");
    assert!(
        folder
            .prints(&["check", "named.obj"])
            .ends_with(&(listed + "\n"))
    );
    for (model, count) in [("plain.obj", 0), ("red.obj", 1)] {
        let output = folder.run(&["check", model, "--json"]);
        let object: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(
            object["warnings"].as_array().map(Vec::len),
            Some(count),
            "{model}"
        );
        assert_eq!(object["ok"], true);
    }
}

#[test]
fn every_built_in_scene_is_listed_and_drawn() {
    let folder = Folder::new("scenes");
    let listed = folder.prints(&["scenes"]);
    let json = folder.json(&["scenes", "--json"]);
    assert_eq!(listed.lines().count(), presets::ALL.len());
    for (i, preset) in presets::ALL.iter().enumerate() {
        assert!(
            listed
                .lines()
                .any(|line| line.starts_with(preset.name) && line.ends_with(preset.sentence()))
        );
        assert_eq!(json["scenes"][i]["name"], preset.name);
        assert_eq!(json["scenes"][i]["title"], preset.title());
        folder.prints(&["render", preset.name, "-o", "a.png", "--size", "48x32"]);
        assert_eq!(
            size_of(&folder.0.join("a.png")),
            (48, 32),
            "{}",
            preset.name
        );
        let pixels = pixels_of(&folder.0.join("a.png"));
        let background = &pixels[..3];
        assert!(
            pixels.chunks(3).any(|pixel| pixel != background),
            "{} shows nothing",
            preset.name
        );
    }
}

#[test]
fn named_materials_are_listed_and_applied() {
    let folder = Folder::new("materials");
    let listed = folder.prints(&["materials"]);
    let json = folder.json(&["materials", "--json"]);
    assert_eq!(listed.lines().count(), 24);
    assert!(
        listed.contains("ka [0.24725, 0.1995, 0.0745]") && listed.contains("n 51.2"),
        "{listed}"
    );
    assert_eq!(json["materials"][10]["name"], "gold");
    assert_eq!(json["materials"][10]["kd"][1], 0.60648);
    // A separate key overrides the link's, on either side of the command.
    for arguments in [
        &[
            "render",
            "sphere",
            "-o",
            "a.png",
            "--material",
            "gold",
            "--set",
            "material.n=7",
        ] as &[&str],
        &[
            "--material",
            "gold",
            "render",
            "sphere",
            "-o",
            "a.png",
            "--set",
            "material.n=7",
        ],
    ] {
        assert_eq!(folder.prints(arguments), "");
        let scene = shading_lab::document::load_scene(&folder.0.join("a.png"))
            .expect("an exported picture")
            .scene;
        let gold = shading_lab::scene::materials::find("gold")
            .expect("a named material")
            .material();
        assert_eq!(
            scene.material,
            shading_lab::scene::Material { n: 7.0, ..gold }
        );
    }
    let output = folder.run(&["render", "sphere", "-o", "a.png", "--material", "golld"]);
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        output.status.code() == Some(2) && text.contains("did you mean gold?"),
        "{text}"
    );
}

#[test]
fn a_picture_restores_its_scene() {
    let folder = Folder::new("restore");
    folder.prints(&[
        "render",
        "torus",
        "-o",
        "a.png",
        "--set",
        "material.n=7.25",
        "--size",
        "60x40",
    ]);
    folder.prints(&["render", "a.png", "-o", "b.png"]);
    let (a, b) = (folder.0.join("a.png"), folder.0.join("b.png"));
    assert_eq!(
        fs::read(&a).expect("a picture"),
        fs::read(&b).expect("a picture")
    );
    let loaded = shading_lab::document::load_scene(&a).expect("a scene");
    let mut expected = presets::find("torus").expect("a scene").scene();
    expected.material.n = 7.25;
    expected.image.size = [60, 40];
    assert_eq!(loaded.scene, expected);
    assert_eq!(loaded.name, "a.png");
    assert_eq!(folder.names(), ["a.png", "b.png"]);
}

#[test]
fn a_picture_finds_its_model_again_from_elsewhere() {
    let folder = Folder::new("model");
    fs::create_dir_all(folder.0.join("models")).expect("a folder");
    folder.write("models/t.obj", TRIANGLE);
    folder.write(
        "models/s.toml",
        "object = {kind = 'obj', path = 't.obj', fit = true}\nimage.size = [40, 40]\n",
    );
    folder.prints(&["render", "models/s.toml", "-o", "a.png"]);
    folder.prints(&[
        "render",
        "--size",
        "40x40",
        "-o",
        "b.png",
        "--set",
        "object={kind='obj', path='models/t.obj'}",
    ]);
    let overridden = shading_lab::document::load_scene(&folder.0.join("b.png")).expect("a scene");
    assert_eq!(
        overridden.scene.object.path,
        Some(folder.0.join("models/t.obj"))
    );
    let elsewhere = Folder::new("model-elsewhere");
    let picture = folder.0.join("a.png");
    elsewhere.prints(&["render", picture.to_str().expect("Unicode"), "-o", "b.png"]);
    assert_eq!(
        fs::read(&picture).expect("a picture"),
        fs::read(elsewhere.0.join("b.png")).expect("a picture")
    );
    assert!(
        folder
            .prints(&["check", "models/t.obj"])
            .starts_with("models/t.obj: ")
    );
    fs::remove_file(folder.0.join("models/t.obj")).expect("a file");
    folder.fails(
        &["check", "models/s.toml"],
        2,
        &[&format!("models/t.obj: {}", missing("document-model"))],
    );
    let model = folder.0.join("models/t.obj");
    let expected = format!("{}: {}", model.display(), missing("document-model"));
    folder.fails(&["check", "a.png"], 2, &[&expected]);
}

#[test]
fn what_is_wrong_with_a_file_is_named_with_its_line() {
    let folder = Folder::new("check");
    folder.write(
        "bad.toml",
        "[camera]\nfov_y = 400\nlens = 1\n[material]\nn = -1\n",
    );
    folder.write("latin.toml", b"version = 1\n# caf\xe9\n");
    folder.write("model.toml", "\n[object]\nkind = 'obj'\n");
    folder.write("plain.png", b"\x89PNG\r\n\x1a\n");
    folder.write("notes.txt", "");
    folder.write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 x 0\nf 1 2 3\n");
    folder.write("empty.obj", "");
    fs::create_dir_all(folder.0.join("folder.toml")).expect("a folder");
    fs::create_dir_all(folder.0.join("folder")).expect("a folder");
    let degrees = english!("expected-degrees", range = "0.001 to 179");
    let keys = "eye, target, up, roll, projection, fov_y, height, framing, viewer";
    let keys = english!("problem-expected-one-of", known = keys);
    let bad: &[&str] = &[
        &value("bad.toml:2: `camera.fov_y`", "400", &degrees),
        &format!(
            "bad.toml:3: {}",
            english!("problem-unknown-key", key = "camera.lens", expected = keys)
        ),
        &value("bad.toml:5: `material.n`", "-1", "0 to inf"),
    ];
    folder.fails(&["check", "bad.toml"], 2, bad);
    folder.fails(&["render", "bad.toml", "-o", "a.png"], 2, bad);
    folder.fails(&["probe", "bad.toml", "--pixel", "1,1"], 2, bad);
    folder.fails(&["bench", "bad.toml"], 2, bad);
    folder.fails(&["bad.toml"], 2, bad);
    for (file, error) in [
        (
            "latin.toml",
            format!("latin.toml:2: {}", english!("document-not-utf-8")),
        ),
        (
            "model.toml",
            format!(
                "model.toml:2: `object.path` {}",
                english!("problem-path-missing")
            ),
        ),
        (
            "none.toml",
            format!("none.toml: {}", missing("document-scene-file")),
        ),
        (
            "none.obj",
            format!("none.obj: {}", missing("document-model")),
        ),
        (
            "none.png",
            format!("none.png: {}", missing("document-picture")),
        ),
        (
            "folder.toml",
            format!(
                "folder.toml: {}",
                english!(
                    "document-directory-not-file",
                    expected = english!("document-scene-file")
                )
            ),
        ),
        (
            "folder",
            format!("folder: {}", english!("document-directory")),
        ),
        (
            "notes.txt",
            format!("notes.txt: {}", english!("document-unknown-kind")),
        ),
        (
            "spere",
            format!(
                "spere: {}",
                english!(
                    "document-no-such-scene",
                    meant = english!("document-did-you-mean", name = "sphere")
                )
            ),
        ),
        (
            "zzz",
            format!("zzz: {}", english!("document-no-such-scene", meant = "")),
        ),
    ] {
        folder.fails(&["check", file], 2, &[&error]);
    }
    // The rest of these lines comes from the readers of those formats.
    for (file, beginning) in [
        ("plain.png", "plain.png: "),
        ("bad.obj", "bad.obj:3: "),
        ("empty.obj", "empty.obj: "),
    ] {
        let output = folder.run(&["check", file]);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(
            text.contains(beginning) && text.lines().count() == 1,
            "{text}"
        );
        assert_eq!(output.status.code(), Some(2));
    }
    assert!(!folder.names().contains(&"a.png".to_owned()));
}

#[test]
fn a_sound_file_is_said_to_be_so() {
    let folder = Folder::new("sound");
    folder.write("s.toml", Scene::default().to_toml());
    assert_eq!(folder.prints(&["check", "s.toml"]), sound("s.toml"));
    folder.prints(&["render", "cube", "-o", "p.png", "--size", "8x8"]);
    assert!(folder.prints(&["check", "p.png"]).starts_with("p.png: "));
}

#[test]
fn an_override_is_taken_before_and_after_the_command() {
    let folder = Folder::new("set");
    folder.prints(&[
        "--set",
        "material.n=3",
        "render",
        "sphere",
        "--set",
        "shading.mode=flat",
        "-o",
        "a.png",
        "--size",
        "9x9",
    ]);
    let scene = shading_lab::document::load_scene(&folder.0.join("a.png"))
        .expect("a scene")
        .scene;
    assert_eq!(
        (scene.material.n, scene.shading.mode),
        (3.0, ShadingMode::Flat)
    );
    folder.fails(
        &["render", "sphere", "-o", "b.png", "--set", "material.n=abc"],
        2,
        &[&value(
            "--set material.n=abc: `material.n`",
            "\"abc\"",
            english!("expected-number"),
        )],
    );
    folder.fails(
        &[
            "probe",
            "sphere",
            "--pixel",
            "1,1",
            "--set",
            "object.rings=1",
            "--set",
            "camera.fov_y=0",
        ],
        2,
        &[
            &value(
                "--set camera.fov_y=0: `camera.fov_y`",
                "0",
                &english!("expected-degrees", range = "0.001 to 179"),
            ),
            &value("--set object.rings=1: `object.rings`", "1", "2 to 4096"),
        ],
    );
    folder.fails(
        &["--set", "material.n=1", "scenes"],
        2,
        &[&english!("cli-set-without-scene", name = "scenes")],
    );
    folder.fails(
        &["sphere", "scenes"],
        2,
        &[english!("cli-scene-before-command")],
    );
}

#[test]
fn arguments_that_make_no_sense_are_refused() {
    let folder = Folder::new("usage");
    for (arguments, expected) in [
        (&["render", "sphere"][..], "--output"),
        (
            &["render", "sphere", "-o", "a.jpg"],
            english!("cli-expected-png"),
        ),
        (
            &["render", "sphere", "-o", "a.png", "--size", "0x10"],
            &english!("cli-expected-size", most = 16384),
        ),
        (
            &["render", "sphere", "-o", "a.png", "--size", "16384x16384"],
            &english!("cli-too-many-pixels", most = 134217728),
        ),
        (
            &["render", "sphere", "-o", "a.png", "--samples", "0"],
            &english!("cli-expected-whole", low = 1, high = 4096),
        ),
        (
            &["render", "sphere", "-o", "a.png", "--overlay", "vector"],
            "did you mean vectors?",
        ),
        (
            &["render", "sphere", "-o", "a.png", "--overlay", "vectors=1"],
            english!("cli-expected-pixel"),
        ),
        (
            &[
                "render",
                "sphere",
                "-o",
                "a.png",
                "--overlay",
                "vectors=-1,2",
            ],
            english!("cli-expected-pixel"),
        ),
        (
            &[
                "render",
                "sphere",
                "-o",
                "a.png",
                "--overlay",
                "vectors=1,angles",
            ],
            english!("cli-expected-pixel"),
        ),
        (
            &["render", "sphere", "-o", "a.png", "--overlay", "vectors,"],
            "expected vectors",
        ),
        (
            &[
                "render",
                "sphere",
                "-o",
                "a.png",
                "--overlay",
                "vectors,probe",
            ],
            english!("cli-probe-without-pixel"),
        ),
        (
            &["render", "sphere", "-o", "a.png", "--overlay", "probe=1,2"],
            english!("cli-pixel-alone"),
        ),
        (
            &[
                "render",
                "sphere",
                "-o",
                "a.png",
                "--overlay",
                "vectors=1,2,angles=3,4",
            ],
            english!("cli-two-pixels"),
        ),
        (
            &["render", "sphere", "-o", "a.png", "--vertex", "1"],
            "--overlay",
        ),
        (
            &["normals", "sphere", "--vertex", "-1"],
            english!("cli-expected-vertex"),
        ),
        (
            &["normals", "sphere", "--vertex", "1", "--pixel", "1,2"],
            &english!(
                "cli-conflict",
                argument = "--vertex <I>",
                other = "--pixel <X,Y>"
            ),
        ),
        (&["probe", "sphere"], "--pixel"),
        (
            &["probe", "sphere", "--pixel", "-1,2"],
            english!("cli-expected-pixel"),
        ),
        (
            &["bench", "sphere", "--frames", "0"],
            &english!("cli-expected-whole", low = 1, high = 100000),
        ),
        (
            &["bench", "sphere", "--threads", "0"],
            &english!("cli-expected-whole", low = 1, high = 1024),
        ),
        (&["check"], "FILE"),
        (&["--nonsense"], "--nonsense"),
    ] {
        folder.refuses(arguments, expected);
    }
    for size in [
        "",
        "x",
        "768",
        "5x0",
        "16385x1",
        "-1x5",
        "5x5x5",
        "99999999999x1",
    ] {
        folder.refuses(
            &["probe", "sphere", "--pixel=1,1", &format!("--size={size}")],
            "",
        );
    }
    folder.refuses(
        &["probe", "sphere", "--pixel=1,1", "--size=16384x8193"],
        &english!("cli-too-many-pixels", most = 134217728),
    );
    for pixel in ["", "3", "3,", "1.5,2", "1,2,3", "99999999999,1"] {
        folder.refuses(&["probe", "sphere", &format!("--pixel={pixel}")], "");
    }
    folder.refuses(
        &["probe", "sphere", "--size=3x4", "--pixel=3,3"],
        "0,0 to 2,3",
    );
    folder.refuses(
        &["probe", "sphere", "--size=3x4", "--pixel=2,4"],
        "0,0 to 2,3",
    );
    assert!(folder.names().is_empty());
}

#[test]
fn a_material_by_its_name_is_that_material() {
    let folder = Folder::new("each-material");
    for named in shading_lab::scene::materials::NAMED {
        folder.prints(&[
            "render",
            "sphere",
            "-o",
            "a.png",
            "--size",
            "4x4",
            "--material",
            named.name,
        ]);
        let scene = shading_lab::document::load_scene(&folder.0.join("a.png"))
            .expect("an exported picture")
            .scene;
        assert_eq!(scene.material, named.material(), "{}", named.name);
    }
}

#[test]
fn samples_soften_the_outline_only() {
    let folder = Folder::new("samples");
    for (samples, name) in [("1", "a.png"), ("16", "b.png")] {
        let set = "--set=material={ka=1, kd=0, ks=0, color=[1,1,1]}";
        folder.prints(&[
            "render",
            "sphere",
            "-o",
            name,
            "--size",
            "40x40",
            "--samples",
            samples,
            set,
        ]);
    }
    let values = |name| {
        let mut values = pixels_of(&folder.0.join(name));
        values.sort_unstable();
        values.dedup();
        values.len()
    };
    // The background has three values, the white sphere one more.
    assert_eq!(values("a.png"), 4);
    assert!(values("b.png") > 10);
}

#[test]
fn overlays_are_drawn_where_they_can_be() {
    let folder = Folder::new("overlay");
    let render = |name: &str, more: &[&str]| {
        let mut arguments = vec!["render", "sphere", "--size", "200x200", "-o", name];
        arguments.extend(more);
        folder.prints(&arguments);
        pixels_of(&folder.0.join(name))
    };
    let plain = render("plain.png", &[]);
    let vectors = render("vectors.png", &["--overlay", "vectors=100,80,angles"]);
    let elsewhere = render("elsewhere.png", &["--overlay", "vectors=120,120,angles"]);
    assert_eq!(
        render("probe.png", &["--overlay", "vectors,angles,probe=100,80"]),
        vectors
    );
    assert_ne!(
        render("chosen.png", &["--overlay", "vectors,angles"]),
        plain
    );
    let lights = render("lights.png", &["--overlay", "lights"]);
    assert!(plain != vectors && plain != lights && vectors != elsewhere);
    // The embedded scene does not contain the overlays.
    assert_eq!(render("again.png", &["--set", "version=1"]), plain);
    folder.prints(&["render", "vectors.png", "-o", "restored.png"]);
    assert_eq!(pixels_of(&folder.0.join("restored.png")), plain);
    folder.fails(
        &[
            "render",
            "sphere",
            "-o",
            "x.png",
            "--overlay",
            "vectors=0,0",
        ],
        2,
        &[&english!("cli-background", what = "--overlay 0,0")],
    );
    folder.fails(
        &[
            "render",
            "sphere",
            "-o",
            "x.png",
            "--size",
            "9x9",
            "--overlay",
            "vectors=9,0",
        ],
        2,
        &[&outside("--overlay 9,0", "8,8")],
    );
}
