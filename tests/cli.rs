//! The program as a script sees it: what it prints, what it writes, and how it ends.

#[path = "common/program.rs"]
mod program;

use program::{Folder, pixels_of, size_of};
use serde_json::Value;
use shading_lab::render::SimdLevel;
use shading_lab::scene::{Scene, ShadingMode, presets};
use std::fs;
use std::process::Stdio;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

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
    // A key beside it goes over it, on either side of the command.
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
        let scene = shading_lab::document::load(&folder.0.join("a.png"))
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
    let loaded = shading_lab::document::load(&a).expect("a scene");
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
    let overridden = shading_lab::document::load(&folder.0.join("b.png")).expect("a scene");
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
            .starts_with("models/t.obj: ok (model from a file, 1 polygon,")
    );
    fs::remove_file(folder.0.join("models/t.obj")).expect("a file");
    folder.fails(
        &["check", "models/s.toml"],
        2,
        &["error: models/t.obj: no such file, expected an OBJ model"],
    );
    let model = folder.0.join("models/t.obj");
    let expected = format!(
        "error: {}: no such file, expected an OBJ model",
        model.display()
    );
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
    let bad: &[&str] = &[
        "error: bad.toml:2: `camera.fov_y` is 400, expected 0.001 to 179 degrees",
        "error: bad.toml:3: unknown key `camera.lens`, expected one of eye, target, up, roll, projection, fov_y, height, framing, viewer",
        "error: bad.toml:5: `material.n` is -1, expected 0 to inf",
    ];
    folder.fails(&["check", "bad.toml"], 2, bad);
    folder.fails(&["render", "bad.toml", "-o", "a.png"], 2, bad);
    folder.fails(&["probe", "bad.toml", "--pixel", "1,1"], 2, bad);
    folder.fails(&["bench", "bad.toml"], 2, bad);
    folder.fails(&["bad.toml"], 2, bad);
    for (file, error) in [
        (
            "latin.toml",
            "latin.toml:2: not UTF-8, expected a text file",
        ),
        (
            "model.toml",
            "model.toml:2: `object.path` is missing, expected the path of a model since `object.kind` is \"obj\"",
        ),
        (
            "none.toml",
            "none.toml: no such file, expected a scene file",
        ),
        ("none.obj", "none.obj: no such file, expected an OBJ model"),
        ("none.png", "none.png: no such file, expected a picture"),
        (
            "folder.toml",
            "folder.toml: a directory, expected a scene file",
        ),
        (
            "folder",
            "folder: a directory, expected a .toml, .obj or .png file",
        ),
        (
            "notes.txt",
            "notes.txt: an unknown kind of file, expected .toml, .obj or .png",
        ),
        (
            "spere",
            "spere: no built-in scene of that name, expected a .toml, .obj or .png file or a name \
             (did you mean sphere?); see `shading-lab scenes`",
        ),
        (
            "zzz",
            "zzz: no built-in scene of that name, expected a .toml, .obj or .png file or a name; see `shading-lab scenes`",
        ),
    ] {
        folder.fails(&["check", file], 2, &[&format!("error: {error}")]);
    }
    // The rest of these lines is the words of the readers of those formats.
    for (file, beginning) in [
        ("plain.png", "error: plain.png: not a valid PNG picture ("),
        ("bad.obj", "error: bad.obj:3: "),
        ("empty.obj", "error: empty.obj: "),
    ] {
        let output = folder.run(&["check", file]);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(
            text.starts_with(beginning) && text.lines().count() == 1,
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
    assert_eq!(
        folder.prints(&["check", "s.toml"]),
        "s.toml: ok (sphere, 1 light, Phong shading, 768×768)\n"
    );
    folder.prints(&["render", "cube", "-o", "p.png", "--size", "8x8"]);
    assert!(
        folder
            .prints(&["check", "p.png"])
            .starts_with("p.png: ok (cube")
    );
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
    let scene = shading_lab::document::load(&folder.0.join("a.png"))
        .expect("a scene")
        .scene;
    assert_eq!(
        (scene.material.n, scene.shading.mode),
        (3.0, ShadingMode::Flat)
    );
    folder.fails(
        &["render", "sphere", "-o", "b.png", "--set", "material.n=abc"],
        2,
        &["error: --set material.n=abc: `material.n` is \"abc\", expected a number"],
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
            "error: --set camera.fov_y=0: `camera.fov_y` is 0, expected 0.001 to 179 degrees",
            "error: --set object.rings=1: `object.rings` is 1, expected 2 to 4096",
        ],
    );
    folder.fails(
        &["--set", "material.n=1", "scenes"],
        2,
        &["error: --set without a scene, expected `scenes` alone"],
    );
    folder.fails(
        &["sphere", "scenes"],
        2,
        &["error: a scene before the command, expected it after: shading-lab COMMAND SCENE"],
    );
}

#[test]
fn arguments_that_make_no_sense_are_refused() {
    let folder = Folder::new("usage");
    for (arguments, expected) in [
        (&["render", "sphere"][..], "--output"),
        (
            &["render", "sphere", "-o", "a.jpg"],
            "expected a name that ends in .png",
        ),
        (
            &["render", "sphere", "-o", "a.png", "--size", "0x10"],
            "expected WIDTHxHEIGHT",
        ),
        (
            &["render", "sphere", "-o", "a.png", "--size", "16384x16384"],
            "at most 134217728 pixels",
        ),
        (
            &["render", "sphere", "-o", "a.png", "--samples", "0"],
            "expected a whole number from 1 to 4096",
        ),
        (
            &["render", "sphere", "-o", "a.png", "--overlay", "vector"],
            "did you mean vectors?",
        ),
        (
            &["render", "sphere", "-o", "a.png", "--overlay", "vectors=1"],
            "expected X,Y",
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
            "expected X,Y",
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
            "expected X,Y",
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
            "expected probe=X,Y",
        ),
        (
            &["render", "sphere", "-o", "a.png", "--overlay", "probe=1,2"],
            "a pixel alone",
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
            "two different pixels",
        ),
        (
            &["render", "sphere", "-o", "a.png", "--vertex", "1"],
            "--overlay",
        ),
        (
            &["normals", "sphere", "--vertex", "-1"],
            "expected the number of a vertex",
        ),
        (
            &["normals", "sphere", "--vertex", "1", "--pixel", "1,2"],
            "cannot be used with",
        ),
        (&["probe", "sphere"], "--pixel"),
        (&["probe", "sphere", "--pixel", "-1,2"], "expected X,Y"),
        (
            &["bench", "sphere", "--frames", "0"],
            "expected a whole number from 1 to 100000",
        ),
        (
            &["bench", "sphere", "--threads", "0"],
            "expected a whole number from 1 to 1024",
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
        "at most 134217728 pixels",
    );
    for pixel in ["", "3", "3,", "1.5,2", "1,2,3", "99999999999,1"] {
        folder.refuses(&["probe", "sphere", &format!("--pixel={pixel}")], "");
    }
    folder.refuses(
        &["probe", "sphere", "--size=3x4", "--pixel=3,3"],
        "expected 0,0 to 2,3",
    );
    folder.refuses(
        &["probe", "sphere", "--size=3x4", "--pixel=2,4"],
        "expected 0,0 to 2,3",
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
        let scene = shading_lab::document::load(&folder.0.join("a.png"))
            .expect("an exported picture")
            .scene;
        assert_eq!(scene.material, named.material(), "{}", named.name);
    }
}

#[test]
fn a_target_that_cannot_be_written_is_a_failure_and_leaves_nothing() {
    let folder = Folder::new("target");
    fs::create_dir_all(folder.0.join("d.png")).expect("a folder");
    folder.fails(
        &["render", "sphere", "-o", "no/such/a.png", "--size", "8x8"],
        1,
        &["error: no/such/a.png: its folder does not exist, expected a file in an existing folder"],
    );
    folder.fails(
        &["render", "sphere", "-o", "d.png", "--size", "8x8"],
        1,
        &["error: d.png: a directory, expected a file to write"],
    );
    assert_eq!(folder.names(), ["d.png"]);
    if cfg!(target_os = "linux") {
        // No file can be made there, not even by the superuser.
        let output = folder.run(&["render", "sphere", "-o", "/proc/a.png", "--size", "8x8"]);
        assert_eq!(output.status.code(), Some(1));
        assert!(
            String::from_utf8_lossy(&output.stderr)
                .starts_with("error: /proc/a.png: cannot be written (")
        );
        assert_eq!(
            folder
                .run(&["render", "sphere", "-o", "/dev/full", "--size", "8x8"])
                .status
                .code(),
            Some(1)
        );
        assert_eq!(
            folder
                .run(&["render", "sphere", "-o", "/dev/null", "--size", "8x8"])
                .status
                .code(),
            Some(0)
        );
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
    // The scene inside knows nothing of them.
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
        &["error: --overlay 0,0: this pixel shows the background, expected one that shows the object"],
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
        &["error: --overlay 9,0: outside the picture, expected 0,0 to 8,8"],
    );
}

fn vector(value: &Value) -> [f64; 3] {
    let numbers = value
        .as_array()
        .expect("a list")
        .iter()
        .map(|x| x.as_f64().expect("a number"));
    numbers
        .collect::<Vec<_>>()
        .try_into()
        .expect("three numbers")
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[test]
fn a_probe_adds_up_to_its_pixel() {
    let folder = Folder::new("probe");
    for mode in ["flat", "interpolated", "gouraud", "phong", "exact"] {
        let set = format!("shading.mode={mode}");
        let probe = folder.json(&[
            "probe",
            "three-lights",
            "--pixel",
            "384,500",
            "--set",
            &set,
            "--json",
        ]);
        assert_eq!(probe["pixel"], serde_json::json!([384, 500]));
        let lights = probe["lights"].as_array().expect("a list");
        assert_eq!(lights.len(), 3);
        let (ambient, sum) = (vector(&probe["ambient"]), vector(&probe["sum"]));
        for channel in 0..3 {
            let terms = lights.iter().map(|light| {
                vector(&light["diffuse"])[channel] + vector(&light["specular"])[channel]
            });
            let total = ambient[channel] + terms.sum::<f64>();
            assert!(
                (total - sum[channel]).abs() < 1e-9,
                "{mode}: {total} {}",
                sum[channel]
            );
            let stored = probe["stored"][channel].as_f64().expect("a number");
            assert!(
                (255.0 * sum[channel].min(1.0) - stored).abs() <= 0.51,
                "{mode}: {stored}"
            );
        }
        let (normal, view) = (vector(&probe["normal"]), vector(&probe["view"]));
        for light in lights {
            let l = vector(&light["l"]);
            assert_eq!(light["kind"], "point");
            assert!((light["n_dot_l"].as_f64().expect("a number") - dot(normal, l)).abs() < 1e-9);
            let cosine = dot(normal, l) / dot(normal, normal).sqrt();
            let theta = light["theta"].as_f64().expect("degrees").to_radians().cos();
            let phi = light["phi"].as_f64().expect("degrees").to_radians().cos();
            assert!((theta - cosine).abs() < 1e-6, "{mode}");
            assert!(
                (phi - dot(vector(&light["r"]), view)).abs() < 1e-3,
                "{mode}"
            );
        }
        for key in ["position", "depth", "face"] {
            assert!(
                !probe[key].is_null() || (mode, key) == ("exact", "face"),
                "{mode} {key}"
            );
        }
    }
    assert_eq!(
        folder.json(&["probe", "sphere", "--pixel", "0,0", "--json"]),
        serde_json::json!({"pixel": [0, 0], "hit": false})
    );
    assert_eq!(
        folder.prints(&["probe", "sphere", "--pixel", "0,0"]),
        "pixel (0, 0) shows the background\n"
    );
    folder.fails(
        &["probe", "sphere", "--pixel", "768,0"],
        2,
        &["error: --pixel 768,0: outside the picture, expected 0,0 to 767,767"],
    );
}

#[test]
fn a_light_that_adds_nothing_says_why() {
    let folder = Folder::new("probe-why");
    let at = |pixel: &str, sets: &[&str]| {
        let mut arguments = vec!["probe", "sphere", "--pixel", pixel];
        sets.iter().for_each(|set| arguments.extend(["--set", set]));
        let words = folder.prints(&arguments);
        arguments.push("--json");
        (words, folder.json(&arguments)["lights"][0].clone())
    };
    let black = ["material.kd=0", "material.ks=0"];
    let (words, light) = at("384,384", &black);
    assert!(
        words.contains("adds nothing: Kd·Od is 0, and Ks·Os is 0") && !words.contains("in shadow"),
        "{words}"
    );
    assert_eq!(light["diffuse_zero"], serde_json::json!(["coefficient"]));
    assert_eq!(light["reached"], 1.0);
    let (words, light) = at(
        "384,384",
        &["light.0.position=[0,0,-5]", "shading.shadows=true"],
    );
    assert!(
        words.contains("adds nothing: the light is behind the surface, N·L ≤ 0"),
        "{words}"
    );
    assert_eq!(light["specular_zero"], serde_json::json!(["faces-away"]));
    let (words, light) = at("384,384", &["material.ks=0"]);
    assert!(
        words.contains("specular adds nothing: Ks·Os is 0") && words.contains("N·L\n"),
        "{words}"
    );
    assert_eq!(
        (&light["diffuse_zero"], &light["specular_zero"]),
        (&serde_json::json!([]), &serde_json::json!(["coefficient"]))
    );
}

#[test]
fn a_probe_in_words_has_the_numbers_of_the_probe_in_json() {
    let folder = Folder::new("probe-text");
    for scene in [
        "sphere",
        "blinn",
        "infinite",
        "attenuation",
        "highlight",
        "flat-facets",
    ] {
        let arguments = ["probe", scene, "--pixel", "384,384"];
        let text = folder.prints(&arguments);
        let probe = folder.json(&[&arguments[..], &["--json"]].concat());
        for (channel, name) in ["red", "green", "blue"].iter().enumerate() {
            let sum = vector(&probe["sum"])[channel];
            let stored = probe["stored"][channel].as_u64().expect("a code value");
            let expected = [name.to_string(), format!("{sum:.4}"), stored.to_string()];
            let fits = |line: &str| {
                line.split_whitespace()
                    .eq(expected.iter().map(String::as_str))
            };
            assert!(text.lines().any(fits), "{scene}: {expected:?}\n{text}");
        }
        let ambient = format!("  {:.4}", vector(&probe["ambient"])[0]);
        let row = |line: &str| line.starts_with("  red ") && line.ends_with(&ambient);
        assert!(text.lines().any(row), "{scene}: {ambient}\n{text}");
    }
}

#[test]
fn a_scene_is_written_as_code() {
    let folder = Folder::new("code");
    let shaders = folder.prints(&["code", "sphere", "--target", "glsl"]);
    assert_eq!(shaders.matches("#version 330 core").count(), 2);
    folder.prints(&["code", "sphere", "--target", "glsl", "-o", "s.glsl"]);
    let parts =
        ["s.vert", "s.frag"].map(|name| fs::read_to_string(folder.0.join(name)).expect("a shader"));
    assert!(
        parts
            .iter()
            .all(|part| part.starts_with("#version 330 core\n") && shaders.contains(part))
    );
    // What cannot be said is no error, and does not get into the text's way.
    let set = [
        "--set",
        "shading.mode=gouraud",
        "--set",
        "reflection.model=blinn",
        "--set",
        "material.n=200",
    ];
    let output =
        folder.run(&[&["code", "cube", "--target", "c", "-o", "cube.c"][..], &set].concat());
    assert_eq!(
        String::from_utf8_lossy(&output.stderr),
        "note: n = 200: GL_SHININESS goes up to 128.\n"
    );
    assert_eq!((output.status.code(), output.stdout.len()), (Some(0), 0));
    let program = fs::read_to_string(folder.0.join("cube.c")).expect("a program");
    assert!(
        program.contains("n = 200: GL_SHININESS goes up to 128.") && program.contains("int main(")
    );
    let snippet = folder.run(&[&["code", "cube"][..], &set].concat()).stdout;
    assert!(String::from_utf8_lossy(&snippet).contains("glMaterialf(") && snippet.len() < 8000);
    assert_eq!(folder.names(), ["cube.c", "s.frag", "s.vert"]);
    let large = [
        "--set",
        "object.segments=1024",
        "--set",
        "object.rings=1024",
    ];
    let text = "error: sphere: 2095104 triangles to write, expected at most 1000000: use a coarser mesh, or c-snippet";
    folder.fails(
        &[&["code", "sphere", "--target", "c"][..], &large].concat(),
        2,
        &[text],
    );
    let no_folder =
        "error: no/s.vert: its folder does not exist, expected a file in an existing folder";
    folder.fails(
        &["code", "sphere", "--target", "glsl", "-o", "no/s"],
        1,
        &[no_folder],
    );
}

#[test]
fn a_benchmark_names_every_figure() {
    let folder = Folder::new("bench");
    let bench = folder.json(&[
        "bench",
        "sphere",
        "--frames",
        "3",
        "--threads",
        "2",
        "--size",
        "64x48",
        "--json",
    ]);
    assert_eq!(bench["threads"], 2);
    assert_eq!(bench["size"], serde_json::json!([64, 48]));
    assert_eq!(bench["triangles"], 2 * 192 * 95);
    assert!(bench["full"]["median_ms"].as_f64().expect("a time") > 0.0);
    for change in ["light", "n", "ka", "camera", "tessellation"] {
        assert!(
            bench["changes"][change]["median_ms"]
                .as_f64()
                .expect("a time")
                > 0.0,
            "{change}"
        );
    }
    let stages = bench["stages"].as_object().expect("stages");
    for stage in [
        "geometry",
        "transform",
        "coverage",
        "pixel-shading",
        "display",
    ] {
        assert!(stages[stage]["median_ms"].is_number(), "{stage}");
    }
    let memory = &bench["memory"];
    for each in [
        "bytes_per_vertex",
        "bytes_per_triangle",
        "bytes_per_pixel",
        "total_bytes",
    ] {
        assert!(memory[each].as_f64().expect("bytes") > 0.0, "{each}");
    }
    assert!(bench["growth"].is_null());
    let dark = folder.json(&[
        "bench", "sphere", "--frames", "1", "--size", "8x8", "--set", "light=[]", "--json",
    ]);
    assert!(dark["changes"]["light"]["median_ms"].is_null());
    let text = folder.prints(&["bench", "cube", "--frames", "1", "--size", "8x8"]);
    assert!(
        text.contains("everything") && text.contains("camera"),
        "{text}"
    );
}

#[test]
fn a_benchmark_runs_at_the_level_that_is_asked_for() {
    let folder = Folder::new("bench-simd");
    let available = SimdLevel::available();
    for level in SimdLevel::ALL {
        let word = serde_json::to_value(level).expect("a word");
        let simd = word.as_str().expect("a word");
        let arguments = [
            "bench", "sphere", "--frames", "1", "--size", "8x8", "--json", "--simd", simd,
        ];
        if available.iter().any(|(name, _)| name == level) {
            assert_eq!(folder.json(&arguments)["simd"], word);
        } else {
            folder.refuses(&arguments, "not on this machine");
        }
    }
    folder.refuses(&["bench", "sphere", "--simd", "avx"], "expected avx512");
}

#[test]
fn the_plan_of_a_frame_is_explained() {
    let folder = Folder::new("explain");
    let set = [
        "--set",
        "material.ks=0",
        "--set",
        "light.0.mute=true",
        "--size",
        "64x48",
        "--frames",
        "2",
    ];
    let told = folder.json(&[&["explain", "sphere", "--json"][..], &set].concat());
    let terms = told["terms"].as_array().expect("terms");
    for term in terms {
        let (per, omitted) = (term["per"].as_str().expect("how often"), &term["omitted"]);
        assert!(
            ["frame", "face", "vertex", "pixel", "none"].contains(&per),
            "{term}"
        );
        assert!(
            term["name"].is_string() && term["evaluations"].is_u64(),
            "{term}"
        );
        assert_eq!(omitted.is_string(), per == "none", "{term}");
    }
    let muted = terms
        .iter()
        .find(|term| term["name"] == "light 1: diffuse")
        .expect("the light's term");
    assert_eq!(muted["omitted"], "muted");
    assert!(
        told["saved"]["evaluations"]["ratio"]
            .as_f64()
            .expect("a ratio")
            > 1.0
    );
    assert!(told["saved"]["time"]["all_ms"].as_f64().expect("a time") > 0.0);
    assert!(
        told["stages"]["coverage"]["share"]
            .as_f64()
            .expect("a share")
            <= 1.0
    );
    assert!(
        told["changes"]["camera"]
            .as_array()
            .expect("stages")
            .contains(&serde_json::json!("coverage"))
    );
    assert_eq!(told["changes"]["tessellation"][0], "geometry");
    let text = folder.prints(&[&["explain", "sphere", "--csv", "plan.csv"][..], &set].concat());
    assert!(text.is_empty());
    let rows = fs::read_to_string(folder.0.join("plan.csv")).expect("the rows");
    assert_eq!(rows.lines().count(), 1 + terms.len());
    let text = folder.prints(&["explain", "cube", "--frames", "1", "--size", "8x8"]);
    assert!(
        text.contains("a closed solid hides them") && text.contains("Work saved"),
        "{text}"
    );
    folder.refuses(
        &["explain", "cube", "--frames", "0"],
        "expected a whole number from 1 to 100000",
    );
}

#[test]
fn an_output_that_nobody_reads_is_no_failure() {
    let folder = Folder::new("pipe");
    let mut child = folder
        .command(&["probe", "sphere", "--pixel", "384,384", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("an end");
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
}

/// What is written to a closed pipe: quietly nothing.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_is_the_output_is_written_to_it() {
    let folder = Folder::new("stdout");
    let explain = [
        "explain",
        "cube",
        "--frames",
        "1",
        "--size",
        "8x8",
        "--csv",
        "/dev/stdout",
    ];
    assert!(
        folder
            .prints(&explain)
            .starts_with("stage,name,per,evaluations,omitted,note\n")
    );
    let render = ["render", "cube", "--size", "8x8", "-o", "/dev/stdout"];
    assert!(folder.run(&render).stdout.starts_with(b"\x89PNG"));
    for arguments in [&explain[..], &render] {
        let mut child = folder
            .command(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("an end");
        assert_eq!(String::from_utf8_lossy(&output.stderr), "");
        assert_eq!(output.status.code(), Some(0));
    }
    // A file that the output goes to keeps what it holds already, and its place.
    folder.write("log", "before\n");
    let log = fs::OpenOptions::new()
        .append(true)
        .open(folder.0.join("log"))
        .expect("a file");
    assert!(
        folder
            .command(&explain)
            .stdout(log)
            .status()
            .expect("an end")
            .success()
    );
    let text = fs::read_to_string(folder.0.join("log")).expect("a text");
    assert!(text.starts_with("before\nstage,name"), "{text}");
    assert_eq!(folder.names(), ["log"]);
}

#[test]
fn tables_have_a_field_for_each_column_whatever_the_words() {
    let folder = Folder::new("tables");
    let fields = |name: &str| -> Vec<Vec<String>> {
        let mut reader = csv::Reader::from_path(folder.0.join(name)).expect("a table");
        let row =
            |row: Result<csv::StringRecord, csv::Error>| row.expect("a row as long as the first");
        reader
            .records()
            .map(|next| row(next).iter().map(str::to_owned).collect())
            .collect()
    };
    folder.prints(&[
        "explain", "checker", "--frames", "1", "--size", "8x8", "--csv", "a.csv",
    ]);
    assert!(
        fields("a.csv")
            .iter()
            .any(|row| row[1] == "light 1: diffuse")
    );
    let text = fs::read_to_string(folder.0.join("a.csv")).expect("a text");
    assert!(
        text.contains(",light 1: diffuse,") && !text.contains("\"\""),
        "only what needs quotes has them: {text}"
    );
    let pane = [
        "--pane",
        "light.0.position=[1,2,3]",
        "--pane",
        "shading.mode=\"flat\"",
    ];
    folder.prints(
        &[
            &["compare", "cube", "--size", "8x8", "--csv", "b.csv"][..],
            &pane,
        ]
        .concat(),
    );
    let names: Vec<String> = fields("b.csv").iter().map(|row| row[0].clone()).collect();
    assert!(
        names.iter().any(|name| name.contains("[1,2,3]")),
        "{names:?}"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_write_leaves_nothing() {
    let folder = Folder::new("interrupted");
    // A shell starts what runs in its background with this signal ignored, and so is the program then.
    let ignored = |signal: &str| signal == "INT" && ignored_signals() & 0b10 != 0;
    for signal in ["INT", "TERM", "KILL"]
        .into_iter()
        .filter(|signal| !ignored(signal))
    {
        // Compressing takes long enough to be met.
        let render = ["render", "checker", "--size", "700x700", "-o", "a.png"];
        let mut child = folder
            .command(&render)
            .stderr(Stdio::null())
            .spawn()
            .expect("the program");
        let writes = |pid: u32| {
            let open = fs::read_dir(format!("/proc/{pid}/fd"))
                .into_iter()
                .flatten()
                .flatten();
            open.filter_map(|entry| fs::read_link(entry.path()).ok())
                .any(|file| file.starts_with(&folder.0))
        };
        while !writes(child.id()) {
            assert!(
                child.try_wait().expect("its state").is_none(),
                "it ended before it wrote"
            );
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        // The shell's own: a bare system has no program of that name.
        let kill = std::process::Command::new("sh")
            .args(["-c", &format!("kill -s {signal} {}", child.id())])
            .status();
        assert!(kill.expect("kill").success() && !child.wait().expect("an end").success());
        assert!(folder.names().is_empty(), "{signal}: {:?}", folder.names());
    }
}

/// The signals that this process ignores, a bit each.
#[cfg(target_os = "linux")]
fn ignored_signals() -> u64 {
    let status = fs::read_to_string("/proc/self/status").expect("a status");
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    u64::from_str_radix(mask.expect("a mask").trim(), 16).expect("a number")
}

#[cfg(target_os = "linux")]
#[test]
fn files_keep_their_mode_links_lead_on_and_any_name_will_do() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::new("names");
    let render = |target: &OsStr| {
        let output = folder
            .command(&["render", "cube", "--size", "8x8", "-o"])
            .arg(target)
            .output();
        let output = output.expect("the program");
        assert_eq!(
            (
                output.status.code(),
                String::from_utf8_lossy(&output.stderr).as_ref()
            ),
            (Some(0), "")
        );
    };
    folder.write("secret.png", "");
    fs::set_permissions(
        folder.0.join("secret.png"),
        PermissionsExt::from_mode(0o600),
    )
    .expect("a mode");
    render(OsStr::new("secret.png"));
    let mode = fs::metadata(folder.0.join("secret.png"))
        .expect("a file")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o600);
    fs::create_dir(folder.0.join("elsewhere")).expect("a folder");
    symlink("elsewhere/real.png", folder.0.join("link.png")).expect("a link");
    render(OsStr::new("link.png"));
    assert!(
        fs::symlink_metadata(folder.0.join("link.png"))
            .expect("a link")
            .is_symlink()
    );
    assert_eq!(size_of(&folder.0.join("elsewhere/real.png")), (8, 8));
    let long = format!("{}.png", "a".repeat(240));
    render(OsStr::new(&long));
    let latin = OsStr::from_bytes(b"caf\xe9.png");
    render(latin);
    // What is written is read again, by commands that read and by those that write tables.
    for arguments in [
        &["check"][..],
        &["profile", "--from", "0,4", "--to", "8,4", "-o"],
    ] {
        let target: &OsStr = if arguments.len() > 1 {
            OsStr::from_bytes(b"\xe9.csv")
        } else {
            latin
        };
        let output = folder
            .command(arguments)
            .arg(target)
            .output()
            .expect("the program");
        assert_eq!(
            output.status.code(),
            Some(0),
            "{arguments:?}: {}",
            String::from_utf8_lossy(&output.stderr)
        );
    }
    assert!(folder.0.join(OsStr::from_bytes(b"\xe9.csv")).is_file());
}

/// The system lets the process have so much memory only.
#[cfg(target_os = "linux")]
#[test]
fn a_picture_that_memory_is_too_short_for_is_a_failure() {
    let folder = Folder::new("memory");
    let limited = format!(
        "ulimit -v 800000; exec {} \"$@\"",
        env!("CARGO_BIN_EXE_shading-lab")
    );
    let render = |more: &[&str]| {
        let mut command = std::process::Command::new("sh");
        command
            .current_dir(&folder.0)
            .env_remove("LANGUAGE")
            .env("LC_ALL", "C")
            .args(["-c", &limited, "sh", "render", "cube", "-o", "a.png"])
            .args(more);
        command.output().expect("a shell")
    };
    let output = render(&["--size", "16384x8192", "--samples", "2"]);
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        text.starts_with(
            "error: a picture of 16384×8192 pixels needs about 1488 MB of memory, which is not available"
        ),
        "{text}"
    );
    assert_eq!((output.status.code(), folder.names().len()), (Some(1), 0));
    assert_eq!(
        render(&["--size", "64x64", "--samples", "2"]).status.code(),
        Some(0)
    );
}
