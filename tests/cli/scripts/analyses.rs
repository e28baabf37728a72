//! The output of commands about a scene: probes, code, benchmarks, plans and tables.

use crate::common::program::{Folder, outside};
use serde_json::Value;
use shading_lab::render::SimdLevel;
use std::fs;

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
        english!("point-report-background", x = 0, y = 0) + "\n"
    );
    folder.fails(
        &["probe", "sphere", "--pixel", "768,0"],
        2,
        &[&outside("--pixel 768,0", "767,767")],
    );
}

#[test]
fn phi_lies_between_r_and_v_and_alpha_between_n_and_h_in_every_model() {
    let folder = Folder::new("probe-angles");
    let degrees = |a: [f64; 3], b: [f64; 3]| dot(a, b).clamp(-1.0, 1.0).acos().to_degrees();
    for (model, backfacing, lobe) in [
        ("phong", "clamp", "(R·V)^n = cos^40 "),
        ("blinn", "clamp", "(N·H)^n = cos^40 "),
        ("blinn", "flip", "(N·H)^n = cos^40 "),
        ("cook-torrance", "clamp", "S = "),
    ] {
        let sets = [
            format!("reflection.model={model}"),
            format!("reflection.backfacing={backfacing}"),
            "material.n=40".to_owned(),
            // From behind, where only the flipped normal is lit.
            format!(
                "light.0.position={}",
                if backfacing == "flip" {
                    "[3,1,-2]"
                } else {
                    "[2,2,3]"
                }
            ),
        ];
        let mut arguments = vec!["probe", "sphere", "--pixel", "330,310"];
        sets.iter().for_each(|set| arguments.extend(["--set", set]));
        let text = folder.prints(&arguments);
        arguments.push("--json");
        let probe = folder.json(&arguments);
        let light = &probe["lights"][0];
        let (mut n, h) = (vector(&probe["normal"]), vector(&light["h"]));
        if backfacing == "flip" {
            assert!(light["n_dot_l"].as_f64().expect("a cosine") < 0.0);
            n = n.map(|part| -part);
        }
        let alpha = light["alpha"].as_f64().expect("degrees");
        let phi = light["phi"].as_f64().expect("degrees");
        assert!((alpha - degrees(n, h)).abs() < 1e-4, "{model}: α {alpha}");
        let mirrored = degrees(vector(&light["r"]), vector(&probe["view"]));
        assert!((phi - mirrored).abs() < 1e-4, "{model}: φ {phi}");
        assert!((alpha - phi).abs() > 1.0, "the angles cannot be told apart");
        for line in [format!("{phi:.2}°  φ, "), format!("{alpha:.2}°  α, ")] {
            assert!(text.contains(&line), "{model}: {line}\n{text}");
        }
        let angle = if model == "phong" { phi } else { alpha };
        let lobe = match model {
            "cook-torrance" => lobe.to_owned(),
            _ if angle > 90.0 => {
                let away = english!("point-points-away", vector = "|");
                away.rsplit('|').next().unwrap_or_default().to_owned()
            }
            _ => format!("{lobe}{angle:.2}°"),
        };
        assert!(text.contains(&lobe), "{model}: {lobe}\n{text}");
    }
    let gold = ["--set", "material.reflectance=gold"];
    let text = folder.prints(&[&["probe", "sphere", "--pixel", "330,310"][..], &gold].concat());
    assert!(text.contains("Ks·W(θ)·(R·V)^n]"), "{text}");
    let text = folder.prints(&["probe", "three-lights", "--pixel", "384,500"]);
    for number in 0..=4 {
        let heading = text
            .lines()
            .any(|line| line.starts_with(&english!("point-light", number = number)));
        assert_eq!(heading, (1..=3).contains(&number), "light {number}\n{text}");
    }
    let one = ["--set", "light.0.kind=area", "--set", "light.0.samples=1"];
    let text = folder.prints(&[&["probe", "sphere", "--pixel", "384,384"][..], &one].concat());
    assert!(
        text.contains(&english!("point-over-samples", count = 1)),
        "{text}"
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
        words.contains("Kd·Od is 0")
            && words.contains("Ks·Os is 0")
            && !words.contains(english!("point-zero-in-shadow")),
        "{words}"
    );
    assert_eq!(light["diffuse_zero"], serde_json::json!(["coefficient"]));
    assert_eq!(light["reached"], 1.0);
    let (words, light) = at(
        "384,384",
        &["light.0.position=[0,0,-5]", "shading.shadows=true"],
    );
    assert!(words.contains(english!("point-zero-behind.why")), "{words}");
    assert_eq!(light["specular_zero"], serde_json::json!(["faces-away"]));
    let (words, light) = at("384,384", &["material.ks=0"]);
    let specular = english!("point-specular");
    let why = english!("render-why-ks-os-zero");
    let nothing = english!("point-term-adds-nothing", term = specular, why = why);
    assert!(
        words.contains(&nothing) && words.contains("N·L\n"),
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
    // Features that the target cannot express are no error, and do not disturb the text.
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
        program.contains(&english!("export-limit-shininess", n = 200))
            && program.contains("int main(")
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
    let text = &format!(
        "sphere: {}",
        english!("export-too-large", triangles = 2095104, most = 1000000)
    );
    folder.fails(
        &[&["code", "sphere", "--target", "c"][..], &large].concat(),
        2,
        &[text],
    );
    let no_folder = &format!("no/s.vert: {}", english!("document-target-no-folder"));
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
        text.contains(english!("engine-everything"))
            && text.contains(english!("engine-change-camera")),
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
            let words = english!("engine-no-simd-level", level = "|", available = "|");
            folder.refuses(&arguments, words.split('|').nth(1).unwrap_or_default());
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
        text.contains(english!("render-why-closed-solid"))
            && text.contains(english!("engine-saved")),
        "{text}"
    );
    folder.refuses(
        &["explain", "cube", "--frames", "0"],
        &english!("cli-expected-whole", low = 1, high = 100000),
    );
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
