//! The program as a script sees it: what it prints, what it writes, and how it ends.

use serde_json::Value;
use shading_lab::scene::{Scene, ShadingMode, presets};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder of a test's own, in which the program runs; removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli-{name}"));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a folder");
        Self(path)
    }

    fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.0.join(name), content).expect("a file");
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("a folder");
        let mut names: Vec<_> =
            entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_shading-lab"));
        command.current_dir(&self.0).args(arguments).stdin(Stdio::null());
        command
    }

    fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().expect("the program")
    }

    /// What a run prints that ends well.
    #[track_caller]
    fn prints(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!((output.status.code(), errors.as_str()), (Some(0), ""), "{arguments:?}");
        String::from_utf8(output.stdout).expect("UTF-8")
    }

    #[track_caller]
    fn json(&self, arguments: &[&str]) -> Value {
        serde_json::from_str(&self.prints(arguments)).expect("JSON")
    }

    /// A run that ends with `status`, says exactly `errors` on stderr and nothing on stdout.
    #[track_caller]
    fn fails(&self, arguments: &[&str], status: i32, errors: &[&str]) {
        let output = self.run(arguments);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(text.lines().collect::<Vec<_>>(), errors, "{arguments:?}");
        assert_eq!(output.status.code(), Some(status), "{arguments:?}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }

    /// A run that the reading of the arguments refuses.
    #[track_caller]
    fn refuses(&self, arguments: &[&str], expected: &str) {
        let output = self.run(arguments);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(text.starts_with("error: ") && text.contains(expected), "{arguments:?}: {text}");
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

fn size_of(png: &Path) -> (u32, u32) {
    let file = std::io::BufReader::new(fs::File::open(png).expect("a picture"));
    let reader = png::Decoder::new(file).read_info().expect("a header");
    reader.info().size()
}

fn pixels_of(png: &Path) -> Vec<u8> {
    let file = std::io::BufReader::new(fs::File::open(png).expect("a picture"));
    let mut reader = png::Decoder::new(file).read_info().expect("a header");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a small picture")];
    reader.next_frame(&mut pixels).expect("pixels");
    pixels
}

#[test]
fn every_built_in_scene_is_listed_and_drawn() {
    let folder = Folder::new("scenes");
    let listed = folder.prints(&["scenes"]);
    let json = folder.json(&["scenes", "--json"]);
    assert_eq!(listed.lines().count(), presets::ALL.len());
    for (i, preset) in presets::ALL.iter().enumerate() {
        assert!(listed.lines().any(|line| line.starts_with(preset.name) && line.ends_with(preset.description)));
        assert_eq!(json["scenes"][i]["name"], preset.name);
        assert_eq!(json["scenes"][i]["title"], preset.title);
        folder.prints(&["render", preset.name, "-o", "a.png", "--size", "48x32"]);
        assert_eq!(size_of(&folder.0.join("a.png")), (48, 32), "{}", preset.name);
        let pixels = pixels_of(&folder.0.join("a.png"));
        let background = &pixels[..3];
        assert!(pixels.chunks(3).any(|pixel| pixel != background), "{} shows nothing", preset.name);
    }
}

#[test]
fn named_materials_are_listed_and_applied() {
    let folder = Folder::new("materials");
    let listed = folder.prints(&["materials"]);
    let json = folder.json(&["materials", "--json"]);
    assert_eq!(listed.lines().count(), 24);
    assert!(listed.contains("ka [0.24725, 0.1995, 0.0745]") && listed.contains("n 51.2"), "{listed}");
    assert_eq!(json["materials"][10]["name"], "gold");
    assert_eq!(json["materials"][10]["kd"][1], 0.60648);
    // A key beside it goes over it, on either side of the command.
    for arguments in [
        &["render", "sphere", "-o", "a.png", "--material", "gold", "--set", "material.n=7"] as &[&str],
        &["--material", "gold", "render", "sphere", "-o", "a.png", "--set", "material.n=7"],
    ] {
        assert_eq!(folder.prints(arguments), "");
        let scene = shading_lab::document::load(&folder.0.join("a.png")).expect("an exported picture").scene;
        let gold = shading_lab::scene::materials::find("gold").expect("a named material").material();
        assert_eq!(scene.material, shading_lab::scene::Material { n: 7.0, ..gold });
    }
    let output = folder.run(&["render", "sphere", "-o", "a.png", "--material", "golld"]);
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(2) && text.contains("did you mean gold?"), "{text}");
}

#[test]
fn a_picture_restores_its_scene() {
    let folder = Folder::new("restore");
    folder.prints(&["render", "torus", "-o", "a.png", "--set", "material.n=7.25", "--size", "60x40"]);
    folder.prints(&["render", "a.png", "-o", "b.png"]);
    let (a, b) = (folder.0.join("a.png"), folder.0.join("b.png"));
    assert_eq!(fs::read(&a).expect("a picture"), fs::read(&b).expect("a picture"));
    let loaded = shading_lab::document::load(&a).expect("a scene");
    let mut expected = (presets::find("torus").expect("a scene").build)();
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
    folder.write("models/s.toml", "object = {kind = 'obj', path = 't.obj', fit = true}\nimage.size = [40, 40]\n");
    folder.prints(&["render", "models/s.toml", "-o", "a.png"]);
    folder.prints(&["render", "--size", "40x40", "-o", "b.png", "--set", "object={kind='obj', path='models/t.obj'}"]);
    let overridden = shading_lab::document::load(&folder.0.join("b.png")).expect("a scene");
    assert_eq!(overridden.scene.object.path, Some(folder.0.join("models/t.obj")));
    let elsewhere = Folder::new("model-elsewhere");
    let picture = folder.0.join("a.png");
    elsewhere.prints(&["render", picture.to_str().expect("Unicode"), "-o", "b.png"]);
    assert_eq!(fs::read(&picture).expect("a picture"), fs::read(elsewhere.0.join("b.png")).expect("a picture"));
    assert!(folder.prints(&["check", "models/t.obj"]).starts_with("models/t.obj: ok (Obj, 1 polygons"));
    fs::remove_file(folder.0.join("models/t.obj")).expect("a file");
    folder.fails(&["check", "models/s.toml"], 2, &["error: models/t.obj: no such file, expected an OBJ model"]);
    let model = folder.0.join("models/t.obj");
    let expected = format!("error: {}: no such file, expected an OBJ model", model.display());
    folder.fails(&["check", "a.png"], 2, &[&expected]);
}

#[test]
fn what_is_wrong_with_a_file_is_named_with_its_line() {
    let folder = Folder::new("check");
    folder.write("bad.toml", "[camera]\nfov_y = 400\nlens = 1\n[material]\nn = -1\n");
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
        "error: bad.toml:3: unknown key `camera.lens`, expected one of eye, target, up, roll, projection, fov_y, height, viewer",
        "error: bad.toml:5: `material.n` is -1, expected 0 or more (inf: a mirror)",
    ];
    folder.fails(&["check", "bad.toml"], 2, bad);
    folder.fails(&["render", "bad.toml", "-o", "a.png"], 2, bad);
    folder.fails(&["probe", "bad.toml", "--pixel", "1,1"], 2, bad);
    folder.fails(&["bench", "bad.toml"], 2, bad);
    folder.fails(&["bad.toml"], 2, bad);
    for (file, error) in [
        ("latin.toml", "latin.toml:2: not UTF-8, expected a text"),
        (
            "model.toml",
            "model.toml:2: `object.path` is missing, expected the path of a model since `object.kind` is \"obj\"",
        ),
        ("none.toml", "none.toml: no such file, expected a scene file"),
        ("none.obj", "none.obj: no such file, expected an OBJ model"),
        ("none.png", "none.png: no such file, expected a picture"),
        ("folder.toml", "folder.toml: a directory, expected a scene file"),
        ("folder", "folder: a directory, expected a .toml, .obj or .png file"),
        ("notes.txt", "notes.txt: an unknown kind of file, expected .toml, .obj or .png"),
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
        ("plain.png", "error: plain.png: not a sound PNG picture ("),
        ("bad.obj", "error: bad.obj:3: "),
        ("empty.obj", "error: empty.obj: "),
    ] {
        let output = folder.run(&["check", file]);
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(text.starts_with(beginning) && text.lines().count() == 1, "{text}");
        assert_eq!(output.status.code(), Some(2));
    }
    assert!(!folder.names().contains(&"a.png".to_owned()));
}

#[test]
fn a_sound_file_is_said_to_be_so() {
    let folder = Folder::new("sound");
    folder.write("s.toml", Scene::default().to_toml());
    assert_eq!(folder.prints(&["check", "s.toml"]), "s.toml: ok (Sphere, 1 light, Phong shading, 768×768)\n");
    folder.prints(&["render", "cube", "-o", "p.png", "--size", "8x8"]);
    assert!(folder.prints(&["check", "p.png"]).starts_with("p.png: ok (Cube"));
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
    let scene = shading_lab::document::load(&folder.0.join("a.png")).expect("a scene").scene;
    assert_eq!((scene.material.n, scene.shading.mode), (3.0, ShadingMode::Flat));
    folder.fails(
        &["render", "sphere", "-o", "b.png", "--set", "material.n=abc"],
        2,
        &["error: --set material.n=abc: `material.n` is \"abc\", expected a number"],
    );
    folder.fails(
        &["probe", "sphere", "--pixel", "1,1", "--set", "object.rings=1", "--set", "camera.fov_y=0"],
        2,
        &[
            "error: --set camera.fov_y=0: `camera.fov_y` is 0, expected 0.001 to 179 degrees",
            "error: --set object.rings=1: `object.rings` is 1, expected 2 to 4096",
        ],
    );
    folder.fails(&["--set", "material.n=1", "scenes"], 2, &["error: --set without a scene, expected `scenes` alone"]);
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
        (&["render", "sphere", "-o", "a.jpg"], "expected a name that ends in .png"),
        (&["render", "sphere", "-o", "a.png", "--size", "0x10"], "expected WIDTHxHEIGHT"),
        (&["render", "sphere", "-o", "a.png", "--size", "16384x16384"], "at most 134217728 pixels"),
        (&["render", "sphere", "-o", "a.png", "--samples", "0"], "0 is not in 1..=4096"),
        (&["render", "sphere", "-o", "a.png", "--overlay", "vector"], "did you mean vectors?"),
        (&["render", "sphere", "-o", "a.png", "--overlay", "vectors=1"], "expected X,Y"),
        (&["render", "sphere", "-o", "a.png", "--vertex", "1"], "--overlay"),
        (&["normals", "sphere", "--vertex", "-1"], "expected the number of a vertex"),
        (&["normals", "sphere", "--vertex", "1", "--pixel", "1,2"], "cannot be used with"),
        (&["probe", "sphere"], "--pixel"),
        (&["probe", "sphere", "--pixel", "-1,2"], "expected X,Y"),
        (&["bench", "sphere", "--frames", "0"], "0 is not in 1..=100000"),
        (&["bench", "sphere", "--threads", "0"], "0 is not in 1..=1024"),
        (&["check"], "FILE"),
        (&["--nonsense"], "--nonsense"),
    ] {
        folder.refuses(arguments, expected);
    }
    assert!(folder.names().is_empty());
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
        assert!(String::from_utf8_lossy(&output.stderr).starts_with("error: /proc/a.png: cannot be written ("));
        assert_eq!(folder.run(&["render", "sphere", "-o", "/dev/full", "--size", "8x8"]).status.code(), Some(1));
        assert_eq!(folder.run(&["render", "sphere", "-o", "/dev/null", "--size", "8x8"]).status.code(), Some(0));
    }
}

#[test]
fn samples_soften_the_outline_only() {
    let folder = Folder::new("samples");
    for (samples, name) in [("1", "a.png"), ("16", "b.png")] {
        let set = "--set=material={ka=1, kd=0, ks=0, color=[1,1,1]}";
        folder.prints(&["render", "sphere", "-o", name, "--size", "40x40", "--samples", samples, set]);
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
    assert_eq!(render("probe.png", &["--overlay", "vectors,angles,probe=100,80"]), vectors);
    assert_ne!(render("chosen.png", &["--overlay", "vectors,angles"]), plain);
    let lights = render("lights.png", &["--overlay", "lights"]);
    assert!(plain != vectors && plain != lights && vectors != elsewhere);
    // The scene inside knows nothing of them.
    assert_eq!(render("again.png", &["--set", "version=1"]), plain);
    folder.prints(&["render", "vectors.png", "-o", "restored.png"]);
    assert_eq!(pixels_of(&folder.0.join("restored.png")), plain);
    folder.fails(
        &["render", "sphere", "-o", "x.png", "--overlay", "vectors=0,0"],
        2,
        &["error: --overlay 0,0: the background, expected a pixel that shows the object"],
    );
    folder.fails(
        &["render", "sphere", "-o", "x.png", "--size", "9x9", "--overlay", "vectors=9,0"],
        2,
        &["error: --overlay 9,0: outside the picture, expected 0,0 to 8,8"],
    );
}

fn vector(value: &Value) -> [f64; 3] {
    let numbers = value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number"));
    numbers.collect::<Vec<_>>().try_into().expect("three numbers")
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[test]
fn a_probe_adds_up_to_its_pixel() {
    let folder = Folder::new("probe");
    for mode in ["flat", "interpolated", "gouraud", "phong", "exact"] {
        let set = format!("shading.mode={mode}");
        let probe = folder.json(&["probe", "three-lights", "--pixel", "384,500", "--set", &set, "--json"]);
        assert_eq!(probe["pixel"], serde_json::json!([384, 500]));
        let lights = probe["lights"].as_array().expect("a list");
        assert_eq!(lights.len(), 3);
        let (ambient, sum) = (vector(&probe["ambient"]), vector(&probe["sum"]));
        for channel in 0..3 {
            let terms =
                lights.iter().map(|light| vector(&light["diffuse"])[channel] + vector(&light["specular"])[channel]);
            let total = ambient[channel] + terms.sum::<f64>();
            assert!((total - sum[channel]).abs() < 1e-9, "{mode}: {total} {}", sum[channel]);
            let stored = probe["stored"][channel].as_f64().expect("a number");
            assert!((255.0 * sum[channel].min(1.0) - stored).abs() <= 0.51, "{mode}: {stored}");
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
            assert!((phi - dot(vector(&light["r"]), view)).abs() < 1e-3, "{mode}");
        }
        for key in ["position", "depth", "face"] {
            assert!(!probe[key].is_null() || (mode, key) == ("exact", "face"), "{mode} {key}");
        }
    }
    assert_eq!(
        folder.json(&["probe", "sphere", "--pixel", "0,0", "--json"]),
        serde_json::json!({"pixel": [0, 0], "hit": false})
    );
    assert_eq!(folder.prints(&["probe", "sphere", "--pixel", "0,0"]), "pixel (0, 0) shows the background\n");
    folder.fails(
        &["probe", "sphere", "--pixel", "768,0"],
        2,
        &["error: --pixel 768,0: outside the picture, expected 0,0 to 767,767"],
    );
}

#[test]
fn a_probe_in_words_has_the_numbers_of_the_probe_in_json() {
    let folder = Folder::new("probe-text");
    for scene in ["sphere", "blinn", "infinite", "attenuation", "highlight", "flat-facets"] {
        let arguments = ["probe", scene, "--pixel", "384,384"];
        let text = folder.prints(&arguments);
        let probe = folder.json(&[&arguments[..], &["--json"]].concat());
        for (channel, name) in ["red", "green", "blue"].iter().enumerate() {
            let sum = vector(&probe["sum"])[channel];
            let stored = probe["stored"][channel].as_u64().expect("a code value");
            let expected = format!("  {name:6}{sum:10.4}  -> {stored:>3}");
            assert!(text.lines().any(|line| line == expected), "{scene}: {expected}\n{text}");
        }
        let ambient = vector(&probe["ambient"])[0];
        let expected = format!(" = {ambient:10.4}");
        assert!(text.lines().any(|line| line.starts_with("  red ") && line.ends_with(&expected)), "{scene}\n{text}");
    }
}

#[test]
fn a_scene_is_written_as_code() {
    let folder = Folder::new("code");
    let shaders = folder.prints(&["code", "sphere", "--language", "glsl"]);
    assert_eq!(shaders.matches("#version 330 core").count(), 2);
    folder.prints(&["code", "sphere", "--language", "glsl", "-o", "s.glsl"]);
    let parts = ["s.vert", "s.frag"].map(|name| fs::read_to_string(folder.0.join(name)).expect("a shader"));
    assert!(parts.iter().all(|part| part.starts_with("#version 330 core\n") && shaders.contains(part)));
    // What cannot be said is no error, and does not get into the text's way.
    let set = ["--set", "shading.mode=gouraud", "--set", "reflection.model=blinn", "--set", "material.n=200"];
    let output = folder.run(&[&["code", "cube", "--language", "c", "-o", "cube.c"][..], &set].concat());
    assert_eq!(String::from_utf8_lossy(&output.stderr), "note: n = 200: GL_SHININESS goes up to 128.\n");
    assert_eq!((output.status.code(), output.stdout.len()), (Some(0), 0));
    let program = fs::read_to_string(folder.0.join("cube.c")).expect("a program");
    assert!(program.contains("n = 200: GL_SHININESS goes up to 128.") && program.contains("int main("));
    let snippet = folder.run(&[&["code", "cube"][..], &set].concat()).stdout;
    assert!(String::from_utf8_lossy(&snippet).contains("glMaterialf(") && snippet.len() < 8000);
    assert_eq!(folder.names(), ["cube.c", "s.frag", "s.vert"]);
    let large = ["--set", "object.segments=1024", "--set", "object.rings=1024"];
    let text = "error: sphere: 2095104 triangles to write out, expected at most 1000000: a coarser mesh, or c-snippet";
    folder.fails(&[&["code", "sphere", "--language", "c"][..], &large].concat(), 2, &[text]);
    let no_folder = "error: no/s.vert: its folder does not exist, expected a file in an existing folder";
    folder.fails(&["code", "sphere", "--language", "glsl", "-o", "no/s"], 1, &[no_folder]);
}

#[test]
fn a_benchmark_names_every_figure() {
    let folder = Folder::new("bench");
    let bench = folder.json(&["bench", "sphere", "--frames", "3", "--threads", "2", "--size", "64x48", "--json"]);
    assert_eq!(bench["threads"], 2);
    assert_eq!(bench["size"], serde_json::json!([64, 48]));
    assert_eq!(bench["triangles"], 2 * 192 * 95);
    assert!(bench["full"]["median_ms"].as_f64().expect("a time") > 0.0);
    for change in ["light", "n", "ka", "camera", "tessellation"] {
        assert!(bench["changes"][change]["median_ms"].as_f64().expect("a time") > 0.0, "{change}");
    }
    let stages = bench["stages"].as_object().expect("stages");
    for stage in ["geometry", "transform", "coverage", "pixel-shading", "display"] {
        assert!(stages[stage]["median_ms"].is_number(), "{stage}");
    }
    let memory = &bench["memory"];
    for each in ["bytes_per_vertex", "bytes_per_triangle", "bytes_per_pixel", "total_bytes"] {
        assert!(memory[each].as_f64().expect("bytes") > 0.0, "{each}");
    }
    assert!(bench["growth"].is_null());
    let dark = folder.json(&["bench", "sphere", "--frames", "1", "--size", "8x8", "--set", "light=[]", "--json"]);
    assert!(dark["changes"]["light"]["median_ms"].is_null());
    let text = folder.prints(&["bench", "cube", "--frames", "1", "--size", "8x8"]);
    assert!(text.contains("everything") && text.contains("camera"), "{text}");
}

#[test]
fn the_plan_of_a_frame_is_explained() {
    let folder = Folder::new("explain");
    let set = ["--set", "material.ks=0", "--set", "light.0.mute=true", "--size", "64x48", "--frames", "2"];
    let told = folder.json(&[&["explain", "sphere", "--json"][..], &set].concat());
    let terms = told["terms"].as_array().expect("terms");
    for term in terms {
        let (per, omitted) = (term["per"].as_str().expect("how often"), &term["omitted"]);
        assert!(["frame", "face", "vertex", "pixel", "none"].contains(&per), "{term}");
        assert!(term["name"].is_string() && term["evaluations"].is_u64(), "{term}");
        assert_eq!(omitted.is_string(), per == "none", "{term}");
    }
    let muted = terms.iter().find(|term| term["name"] == "light 1: diffuse").expect("the light's term");
    assert_eq!(muted["omitted"], "it is muted");
    assert!(told["saved"]["evaluations"]["ratio"].as_f64().expect("a ratio") > 1.0);
    assert!(told["saved"]["time"]["all_ms"].as_f64().expect("a time") > 0.0);
    assert!(told["stages"]["coverage"]["share"].as_f64().expect("a share") <= 1.0);
    assert!(told["changes"]["camera"].as_array().expect("stages").contains(&serde_json::json!("coverage")));
    assert_eq!(told["changes"]["tessellation"][0], "geometry");
    let text = folder.prints(&[&["explain", "sphere", "--csv", "plan.csv"][..], &set].concat());
    assert!(text.is_empty());
    let rows = fs::read_to_string(folder.0.join("plan.csv")).expect("the rows");
    assert_eq!(rows.lines().count(), 1 + terms.len());
    let text = folder.prints(&["explain", "cube", "--frames", "1", "--size", "8x8"]);
    assert!(text.contains("left out: a closed solid hides them") && text.contains("work saved"), "{text}");
    folder.refuses(&["explain", "cube", "--frames", "0"], "0 is not in 1..=100000");
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

#[test]
fn curves_are_drawn_written_and_told() {
    let folder = Folder::new("curves");
    let attenuated = ["attenuation", "--set", "image.size=[120,120]", "--set", "material.reflectance=glass"];
    let with = |more: &[&'static str]| [&["curves"], &attenuated[..], more].concat();
    folder.prints(&with(&["-o", "all.png", "--size", "640x400", "--dark"]));
    assert_eq!(size_of(&folder.0.join("all.png")), (640, 400));
    assert!(pixels_of(&folder.0.join("all.png")).iter().any(|code| *code > 200), "light lines on a dark ground");
    folder.prints(&with(&["--kind", "lobe", "-o", "lobe.svg", "--csv", "lobe.csv"]));
    let svg = fs::read_to_string(folder.0.join("lobe.svg")).expect("a figure");
    assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>") && svg.contains("diffuse + specular"));
    let csv = fs::read_to_string(folder.0.join("lobe.csv")).expect("a table");
    assert!(csv.starts_with("plot,curve,x,y\nlobe,diffuse + specular,-90,") && csv.lines().count() > 500);
    assert!(csv.lines().all(|line| line.split(',').count() == 4));
    folder.prints(&with(&["--kind", "exponent", "-o", "family.csv"]));
    let csv = fs::read_to_string(folder.0.join("family.csv")).expect("a table");
    assert!(csv.contains("exponent,n = 1005,0,1\n") && csv.contains("exponent,n = 20,0,1\n"));
    let told = folder.prints(&with(&[]));
    assert!(told.contains("half-width") && told.contains("farthest: f(") && told.contains("W(80°)"), "{told}");
    assert_eq!(folder.names(), ["all.png", "family.csv", "lobe.csv", "lobe.svg"]);
}

#[test]
fn curves_are_the_probes_own() {
    let folder = Folder::new("curves-json");
    let at = ["attenuation", "--set", "image.size=[120,120]", "--pixel", "70,50", "--json"];
    let curves = folder.json(&[&["curves"], &at[..]].concat());
    let probe = folder.json(&[&["probe"], &at[..]].concat());
    assert_eq!(curves["pixel"], probe["pixel"]);
    let kinds: Vec<_> = curves["plots"].as_array().expect("plots").iter().map(|plot| plot["kind"].clone()).collect();
    assert_eq!(kinds, ["attenuation", "exponent", "lobe"]);
    let marks = curves["plots"][0]["marks"].as_array().expect("marks");
    let mark = marks.iter().find(|mark| mark["probe"] == true).expect("the probe's");
    let (f, expected) = (mark["values"][0][1].as_f64(), probe["lights"][0]["attenuation"].as_f64());
    assert!((f.expect("f") - expected.expect("f")).abs() < 1e-9, "{f:?} {expected:?}");
}

#[test]
fn curves_that_cannot_be_are_refused() {
    let folder = Folder::new("curves-refused");
    folder.refuses(&["curves", "sphere", "-o", "curves.gif"], ".png, .svg or .csv");
    folder.refuses(&["curves", "sphere", "--kind", "shadow"], "possible values");
    folder.fails(
        &["curves", "sphere", "--light", "1"],
        2,
        &["error: --light 1: no such light in the scene, which has 0 to 0"],
    );
    folder.fails(
        &["curves", "sphere", "--pixel", "768,0"],
        2,
        &["error: --pixel 768,0: outside the picture, expected 0,0 to 767,767"],
    );
    folder.fails(
        &["curves", "sphere", "--kind", "lobe", "--pixel", "0,0", "-o", "lobe.png"],
        2,
        &["error: pixel 0,0 shows the background, expected one that shows the object"],
    );
    folder.fails(
        &["curves", "sphere", "--kind", "attenuation", "--set", "light=[]"],
        2,
        &["error: the scene has no light, expected one"],
    );
    folder.fails(
        &["curves", "sphere", "--kind", "lobe", "--set", "light.0.position=[0,0,-5]", "--pixel", "380,380"],
        2,
        &["error: light 0 does not reach pixel 380,380 from the front, expected one that does"],
    );
    assert!(folder.names().is_empty());
}

#[test]
fn a_profile_has_every_mode_at_every_pixel_centre() {
    let folder = Folder::new("profile");
    let line = ["profile", "sphere", "--from", "100.5,300.5", "--to", "140.5,300.5", "--json"];
    let object = folder.json(&line);
    let samples = object["samples"].as_array().expect("a list");
    for x in 100..=140 {
        let centre = f64::from(x) + 0.5;
        let sample = samples.iter().find(|sample| sample["x"].as_f64().is_some_and(|at| (at - centre).abs() < 1e-9));
        let sample = sample.unwrap_or_else(|| panic!("{centre}"));
        assert_eq!(sample["y"], 300.5);
        for mode in ["flat", "gouraud", "phong", "exact"] {
            for key in ["", "_slope", "_perceived"] {
                assert!(sample[format!("{mode}{key}")].is_f64(), "{mode}{key}: {sample}");
            }
        }
    }
    assert_eq!((samples[0]["t"].as_f64(), samples[samples.len() - 1]["t"].as_f64()), (Some(0.0), Some(1.0)));
    let phong = folder.json(&[&line[..], &["--modes", "phong"]].concat());
    assert!(phong["samples"][0].get("gouraud").is_none() && phong["samples"][0]["phong"].is_f64());
    let probed = folder.json(&["probe", "sphere", "--pixel", "300,300", "--json"]);
    let there = folder.json(&[
        "profile",
        "sphere",
        "--from",
        "300.5,300.5",
        "--to",
        "301.5,300.5",
        "--modes",
        "phong",
        "--json",
    ]);
    let sum: Vec<f64> = probed["sum"].as_array().expect("three").iter().filter_map(Value::as_f64).collect();
    let expected = 0.2126 * sum[0] + 0.7152 * sum[1] + 0.0722 * sum[2];
    assert!((there["samples"][0]["phong"].as_f64().expect("a number") - expected).abs() < 1e-9);
}

#[test]
fn a_profile_is_written_as_table_plot_and_picture() {
    let folder = Folder::new("profile-files");
    let line = ["profile", "flat-facets", "--from", "100,300", "--to", "600,310.5"];
    let text = folder.prints(&line);
    assert!(text.starts_with("x,y,t,flat,flat_slope,flat_perceived,gouraud,"), "{}", &text[..80]);
    folder.prints(
        &[&line[..], &["-o", "plot.png", "--csv", "rows.csv", "--picture", "seen.png", "--size", "640x480"]].concat(),
    );
    folder.prints(&[&line[..], &["-o", "plot.svg", "--dark", "--response", "response-normalisation"]].concat());
    assert_eq!(folder.names(), ["plot.png", "plot.svg", "rows.csv", "seen.png"]);
    folder.prints(&[
        "render",
        "flat-facets",
        "--overlay",
        "profile",
        "--from",
        "9,9",
        "--to",
        "400,300",
        "-o",
        "over.png",
    ]);
    folder.prints(&["render", "flat-facets", "--overlay", "vectors,profile", "-o", "over.png"]);
}

#[test]
fn a_profile_along_no_line_is_refused() {
    let folder = Folder::new("profile-refused");
    let with = |from, to, more: &[&'static str]| [&["profile", "sphere", "--from", from, "--to", to], more].concat();
    let outside = "error: --from 0,0 --to 769,3: outside the picture, expected 0,0 to 768,768";
    folder.fails(&with("0,0", "769,3", &[]), 2, &[outside]);
    let nowhere = "error: --from 5,5 --to 5,5: both ends of the line are at one place, expected two";
    folder.fails(&with("5,5", "5,5", &[]), 2, &[nowhere]);
    let narrow = "error: --surround 0.01: expected more than the centre's 0.04";
    folder.fails(&with("0,0", "5,5", &["--surround", "0.01"]), 2, &[narrow]);
    folder.fails(
        &with("0,0", "5,5", &["--viewing-distance", "NaN"]),
        2,
        &["error: --viewing-distance NaN: expected 100 to 5000"],
    );
    let wide = ["--picture", "a.png", "--surround", "2", "--viewing-distance", "5000"];
    let error = "error: --surround 2: 660 pixels, expected at most 256 for --picture";
    folder.fails(&with("0,0", "5,5", &wide), 2, &[error]);
    folder.refuses(&with("0,0", "x,5", &[]), "expected X,Y in pixels");
    folder.refuses(&with("0,0", "inf,5", &[]), "expected X,Y in pixels");
    folder.refuses(
        &with("0,0", "5,5", &["--modes", "flat,fong"]),
        "expected flat, interpolated, gouraud, phong or exact",
    );
    folder.refuses(&["render", "sphere", "-o", "a.png", "--from", "1,1"], "--to");
    assert!(folder.names().is_empty());
}

#[test]
fn a_polygon_is_scanned_as_text_as_data_and_as_a_figure() {
    let folder = Folder::new("scanline");
    let gouraud = ["--set", "shading.mode=gouraud", "--set", "shading.interpolation=affine"];
    let scanline = |arguments: &[&'static str]| [&["scanline", "flat-facets"], &gouraud[..], arguments].concat();
    let text = folder.prints(&scanline(&["--line", "7"]));
    for words in ["I(P) = (1−α)·I(", "I = (1−α)·I(P) + α·I(Q)", "scan line 7, ", "dx/dy", "active"] {
        assert!(text.contains(words), "{words} in {text}");
    }
    let object = folder.json(&scanline(&["--json", "--rows", "24", "--step", "last"]));
    assert_eq!(object["grid"]["rows"], 24);
    assert_eq!(object["step"], object["steps"].as_array().map_or(0, Vec::len) - 1);
    assert_eq!((&object["carried"], &object["compared"]), (&"intensity".into(), &"affine".into()));
    let pixels: usize = object["lines"].as_array().expect("lines").iter().flat_map(scanned).count();
    assert_eq!(folder.prints(&scanline(&["--rows", "24", "--csv", "pixels.csv"])), "");
    let table = fs::read_to_string(folder.0.join("pixels.csv")).expect("the table");
    assert_eq!(table.lines().count(), pixels + 1);
    assert!(table.starts_with("y,x,p_x,q_x,alpha_p,alpha_q,alpha,value_r,value_g,value_b,barycentric_r,"));
    folder.prints(&scanline(&["-o", "step.png", "--size", "640x440", "--dark"]));
    folder.prints(&scanline(&["-o", "step.svg", "--face", "120", "--step", "40"]));
    let svg = fs::read_to_string(folder.0.join("step.svg")).expect("the figure");
    assert!(svg.contains("Gouraud shading, face 120") && svg.contains("<polygon"));
    let png = fs::read(folder.0.join("step.png")).expect("the figure");
    assert!(png.starts_with(b"\x89PNG"));
    assert_eq!(folder.names(), ["pixels.csv", "step.png", "step.svg"]);
    let refuses = |arguments: &[&'static str], error: &str| folder.fails(&scanline(arguments), 2, &[error]);
    refuses(&["--face", "9999"], "error: no face 9999 in the object, expected 0 to 287");
    refuses(&["--rows", "5"], "error: 5 rows, expected 8 to 64");
    refuses(&["--pixel", "0,0"], "error: pixel 0,0 shows the background, expected one that shows the object");
    refuses(
        &["--face", "120", "--line", "0"],
        "error: --line 0: not a scan line of the polygon, expected 1 to 14 or last",
    );
    refuses(&["--face", "120", "--step", "9999"], "error: --step 9999: no such step, expected 0 to 230 or last");
}

fn scanned(line: &Value) -> impl Iterator<Item = &Value> {
    let spans = line["spans"].as_array().into_iter().flatten();
    spans.flat_map(|span| span["pixels"].as_array().into_iter().flatten())
}

#[test]
fn a_vertex_normal_is_told_with_the_faces_that_it_comes_from() {
    let folder = Folder::new("normals");
    let cube = ["cube", "--set", "object={kind=\"cube\",segments=4,rings=1,normals=\"averaged\",weighting=\"angle\"}"];
    let normals = |more: &[&'static str]| [&["normals"], &cube[..], more].concat();
    let told = folder.json(&normals(&["--vertex", "0", "--json"]));
    assert_eq!((&told["vertices"], &told["faces"], &told["weight_unit"]), (&8.into(), &6.into(), &"degrees".into()));
    let faces = told["vertex"]["faces"].as_array().expect("faces");
    assert_eq!((faces.len(), told["vertex"]["origin"].as_str()), (3, Some("averaged")));
    for face in faces {
        let number = |key: &str| face[key].as_f64().expect("a number");
        assert!((number("share") - 1.0 / 3.0).abs() < 1e-6 && (number("weight") - 90.0).abs() < 1e-5);
        assert!((number("angle") - 54.735_61).abs() < 1e-4);
    }
    let text = folder.prints(&normals(&["--vertex", "0"]));
    assert!(text.starts_with("cube: vertex 0 of 8, at ("), "{text}");
    assert!(text.contains("the mean of 3 faces, weighted by angle") && text.contains("of length 0.5774"), "{text}");
    // Next to the place where it appears, and in the same words.
    let nearest = folder.json(&normals(&["--pixel", "400,310", "--json"]));
    let number = nearest["vertex"]["vertex"].as_u64().expect("a number").to_string();
    assert_eq!(
        folder.json(&[&["normals"], &cube[..], &["--vertex", &number, "--json"]].concat())["vertex"],
        nearest["vertex"]
    );
    assert_eq!(folder.prints(&normals(&["--csv", "a.csv"])), "");
    let table = fs::read_to_string(folder.0.join("a.csv")).expect("a table");
    assert_eq!((table.lines().count(), table.lines().next()), (4, Some("face,share,weight,angle,nx,ny,nz")));
    let exact = folder.prints(&["normals", "cube", "--set", "object.normals=exact"]);
    assert!(exact.contains("the true surface's"), "{exact}");
    let outside = ["error: --vertex 8: no such vertex, expected 0 to 7"];
    folder.fails(&normals(&["--vertex", "8"]), 2, &outside);
    folder.fails(
        &normals(&["--pixel", "9999,0"]),
        2,
        &["error: --pixel: outside the picture, expected 0,0 to 767,767"],
    );
    let away = normals(&["--set", "camera.target=[0,0,9]", "--set", "camera.eye=[0,0,4]"]);
    let unseen = "error: no vertex is seen in the picture, expected --vertex or a camera that sees the object";
    folder.fails(&away, 2, &[unseen]);

    let render = |name: &str, more: &[&str]| {
        folder.prints(&[&["render"], &cube[..], &["-o", name, "--size", "160x160"], more].concat());
        pixels_of(&folder.0.join(name))
    };
    let plain = render("plain.png", &[]);
    let mut drawn = vec![plain];
    for list in ["face-normals", "vertex-normals", "face-normals,vertex-normals", "vertex-normals,lights"] {
        drawn.push(render("over.png", &["--overlay", list]));
    }
    drawn.push(render("lit.png", &["--overlay", "vertex-normals", "--vertex", &number]));
    let count = drawn.len();
    drawn.sort();
    drawn.dedup();
    assert_eq!(drawn.len(), count, "each drawing is another");
    let refused = |more: &[&'static str]| [&["render"], &cube[..], &["-o", "x.png"], more].concat();
    folder.fails(&refused(&["--overlay", "vertex-normals", "--vertex", "8"]), 2, &outside);
    let without = ["error: --vertex without normals, expected --overlay vertex-normals"];
    folder.fails(&refused(&["--overlay", "lights", "--vertex", "1"]), 2, &without);
    // An object of which nothing is seen has no needles, and that is no error.
    folder.prints(&refused(&["--overlay", "vertex-normals", "--set", "camera.target=[0,0,9]"]));
}
