//! Scenes as links: each scene is restored exactly, and no text does harm.

use crate::common::any_scene::{any_scene, everyday_scene};
use crate::common::dice::Dice;
use crate::common::program;
use crate::common::program::Folder;
use crate::common::tries::tries;
use crate::scene_round_trip::LAWS;
use glam::DVec2;
use rayon::prelude::*;
use shading_lab::figure::QrCode;
use shading_lab::link::{DEFAULTS, Link, Shown, VIEWS, Written, read, write};
use shading_lab::render::Frame;
use shading_lab::scene::parameter::Parameter;
use shading_lab::scene::{Light, ObjectKind, Pane, ReflectionModel, Scene, ShadingMode, presets};
use std::path::Path;
use std::{env, fs};

fn plain(scene: &Scene, origin: Option<&str>) -> String {
    let written = write("", scene, origin, &Shown::default());
    written.expect("a sound scene").link
}

/// Writes a link and reads it back; the scenes must agree bit by bit, except for models.
fn round_trip(scene: &Scene, origin: Option<&str>) -> String {
    let shown = Shown {
        view: Some("profile"),
        probe: Some(DVec2::new(0.1103, -0.25)),
        line: Some([DVec2::new(-0.4, 0.06), DVec2::new(0.4, -1.0)]),
        lesson: Some("mach-bands".to_owned()),
        step: Some(3),
        embed: true,
        controls: vec!["n".to_owned(), "light.0.position".to_owned()],
    };
    let Written { link, left_out } = write("https://example.org/lab/", scene, origin, &shown)
        .unwrap_or_else(|error| panic!("{error}\n{}", scene.to_toml()));
    assert!(
        link.is_ascii() && link.ends_with(|c: char| c.is_ascii_alphanumeric()),
        "{link}"
    );
    let back = read(&link).unwrap_or_else(|error| panic!("{error}\n{link}"));
    let mut sent = scene.clone();
    sent.object.path = None;
    if sent.object.kind == ObjectKind::Obj {
        assert_eq!(left_out, scene.object.path);
        sent.object = presets::link_base().object;
    }
    let differing: Vec<_> = sent
        .differences(&back.scene)
        .map(|(p, i)| p.key(i))
        .collect();
    assert!(differing.is_empty(), "{differing:?}\n{link}");
    assert!(sent == back.scene, "{link}");
    assert_eq!(back.shown, shown, "{link}");
    link
}

#[test]
fn a_few_settings_of_a_built_in_scene_are_a_short_and_readable_link() {
    let mut scene = presets::find("highlight").expect("built in").scene();
    scene.material.n = 50.0;
    scene.shading.mode = ShadingMode::Gouraud;
    let shown = Shown {
        view: Some("profile"),
        ..Shown::default()
    };
    for origin in [None, Some("highlight")] {
        let written = write("https://example.org/", &scene, origin, &shown).expect("sound");
        assert_eq!(
            written.link,
            "https://example.org/?scene=highlight&set=material.n=50&set=shading.mode=gouraud&view=profile"
        );
    }
    let mut scene = presets::find("sphere").expect("built in").scene();
    scene.lights[0].position = glam::DVec3::new(-2.0, 0.1, 3.5);
    scene.lights.push(Light {
        name: "Lamp 5".to_owned(),
        ..Light::default()
    });
    scene.material.color = glam::DVec3::new(1.0, 0.0, 1e-30);
    scene.compare.panes = vec![
        Pane::of(&["shading.mode=exact", "material.n=inf"]),
        Pane {
            name: "7".to_owned(),
            ..Pane::of(&["light.0.color=[1, 1, 0]"])
        },
    ];
    let link = plain(&scene, Some("sphere"));
    assert_eq!(
        link,
        "?scene=sphere&lights=2&pane=shading.mode=exact;material.n=inf&pane=light.0.color=%5B1,%201,%200%5D\
         &set=material.color=1,0,1e-30&set=compare.pane.1.name=%227%22&set=light.1.name=Lamp%205\
         &set=light.0.position=-2,0.1,3.5"
    );
    round_trip(&scene, Some("sphere"));
}

#[test]
fn a_law_is_sent_as_it_was_typed() {
    let mut scene = presets::find("highlight").expect("built in").scene();
    scene.reflection.model = ReflectionModel::Formula;
    for law in LAWS {
        law.clone_into(&mut scene.reflection.formula);
        let link = round_trip(&scene, Some("highlight"));
        assert!(link.contains("&set=reflection.formula="), "{law}: {link}");
        // In a pane, whose settings are separated by semicolons.
        let setting = format!("reflection.formula={}", toml::Value::from(law));
        let mut compared = scene.clone();
        compared.compare.panes = vec![Pane::of(&["shading.mode=exact", &setting])];
        round_trip(&compared, Some("highlight"));
        let pane = compared.pane(1).expect("a pane");
        assert_eq!(pane.reflection.formula, law);
    }
    // The longest, of characters that take six bytes each in a link.
    scene.reflection.formula = format!("kd # {}", "·".repeat(1995));
    let link = round_trip(&scene, Some("highlight"));
    assert!(
        link.contains("#scene=") && link.len() < 2000,
        "{}",
        link.len()
    );
}

#[test]
fn every_built_in_scene_is_its_name() {
    assert_eq!(presets::ALL.len(), 54);
    for preset in presets::ALL {
        let scene = preset.scene();
        let link = format!("?scene={}", preset.name);
        assert_eq!(plain(&scene, None), link);
        assert_eq!(plain(&scene, Some(preset.name)), link);
        round_trip(&scene, None);
        let Link {
            name, scene: back, ..
        } = read(&link).expect("a link");
        assert_eq!((name.as_str(), back), (preset.name, scene));
    }
    assert_eq!(plain(&Scene::default(), None), format!("?scene={DEFAULTS}"));
    assert_eq!(read("?").expect("a link").scene, presets::link_base());
    assert_eq!(
        read("https://example.org/").expect("a link").name,
        presets::LINK_BASE
    );
}

/// Checks random scenes. With `SHADING_LAB_LINKS=FILE` the links are also written to that file, a line each, for the tests of the
/// web page.
#[test]
fn every_scene_comes_back_bit_by_bit() {
    let links: Vec<String> = (0..4000u64)
        .into_par_iter()
        .filter_map(|seed| {
            let scene = if seed % 4 == 0 {
                everyday_scene(seed).scene
            } else {
                any_scene(seed).scene
            };
            scene.validate().ok()?;
            round_trip(&scene, None);
            Some(plain(&scene, None))
        })
        .collect();
    assert!(links.len() >= 1000, "{}", links.len());
    if let Ok(file) = env::var("SHADING_LAB_LINKS") {
        fs::write(file, links.join("\n")).expect("a file for the links");
    }
}

/// Checks built-in scenes with some keys of another scene: these links stay readable.
#[test]
fn changed_built_in_scenes_come_back_bit_by_bit() {
    let parameters: Vec<_> = Parameter::all()
        .filter(|parameter| !["version", "object.path"].contains(&parameter.key))
        .collect();
    let readable = (0..1000u64)
        .into_par_iter()
        .filter(|seed| {
            let mut dice = Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
            let preset = &presets::ALL[(dice.unit() * 54.0) as usize];
            let (mut scene, other) = (preset.scene(), everyday_scene(*seed).scene);
            if dice.unit() < 0.3 {
                scene.lights.clone_from(&other.lights);
            }
            if dice.unit() < 0.3 {
                scene.compare.clone_from(&other.compare);
            }
            for _ in 0..(dice.unit() * 8.0) as usize {
                dice.of(&parameters).copy(&other, &mut scene, 0);
            }
            let sound = scene.validate().is_ok();
            sound && !round_trip(&scene, Some(preset.name)).contains('#')
        })
        .count();
    assert!(readable >= 300, "{readable}");
}

#[test]
fn what_does_not_fit_is_compressed() {
    let mut scene = presets::find("orientation").expect("built in").scene();
    scene.object.vertices_mut()[2].x = 1.25;
    let link = round_trip(&scene, Some("orientation"));
    let (readable, packed) = link.split_once('#').expect("a packed scene");
    assert!(readable.ends_with(
        "/?view=profile&probe=0.1103,-0.25&line=-0.4,0.06,0.4,-1&lesson=mach-bands&step=3&embed&controls=n,light.0.position"
    ));
    assert!(packed.len() < 1500, "{}", packed.len());
    assert!(
        packed
            .bytes()
            .all(|byte| byte.is_ascii_alphanumeric() || b"=-_".contains(&byte))
    );
    assert!(packed.ends_with(|last: char| last.is_ascii_alphanumeric()));
    scene.lights = vec![
        Light {
            name: "x".repeat(64),
            ..Light::default()
        };
        200
    ];
    assert!(round_trip(&scene, None).contains("/?view=profile"));
    // A link that ends with a full stop would lose it in a message.
    let mut scene = presets::link_base();
    scene.lights[0].name = "Sun.".to_owned();
    assert!(plain(&scene, None).ends_with("set=light.0.name=Sun%2E"));
    round_trip(&scene, None);
}

#[test]
fn a_model_stays_and_its_path_is_not_told() {
    let mut scene = presets::find("gold").expect("built in").scene();
    scene.object.kind = ObjectKind::Obj;
    scene.object.path = Some("/home/secret/bunny.obj".into());
    scene.material.n = 7.0;
    let written = write("", &scene, None, &Shown::default()).expect("a link");
    assert_eq!(
        written.left_out.as_deref(),
        Some(Path::new("/home/secret/bunny.obj"))
    );
    assert!(
        written.link.starts_with("?scene=gold&set=material.n=7"),
        "{}",
        written.link
    );
    let back = read(&written.link).expect("a link").scene;
    assert_eq!(
        (back.material.n, back.object.kind),
        (7.0, ObjectKind::Teapot)
    );
    // A model that is not shown does not count as left out.
    scene.object.kind = ObjectKind::Cone;
    let written = write("", &scene, None, &Shown::default()).expect("a link");
    assert_eq!(written.left_out, None);
    assert!(!written.link.contains("secret"));
    assert_eq!(read(&written.link).expect("a link").scene.object.path, None);
    // No link makes the program open a file.
    let asked = [
        "?set=object.path=/etc/passwd",
        "?set=object.kind=obj",
        "?set=object.kind=obj&set=object.path=a.obj",
    ];
    for link in asked {
        let error = read(link).expect_err("a file").to_string();
        assert!(
            error.contains("`object.path`") && error.contains(english!("link-no-file")),
            "{error}"
        );
    }
    let file = packed("version = 1\n[object]\npath = \"/etc/passwd\"\n");
    let error = read(&file).expect_err("a file").to_string();
    assert!(error.contains("`object.path`"), "{error}");
}

/// Returns a link that holds the text of a scene file.
fn packed(text: &str) -> String {
    format!(
        "#scene={}",
        base64(&miniz_oxide::deflate::compress_to_vec(text.as_bytes(), 9))
    )
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    let bits: Vec<u8> = bytes
        .iter()
        .flat_map(|byte| (0..8).rev().map(move |bit| byte >> bit & 1))
        .collect();
    let digit = |bits: &[u8]| {
        let value = (0..6).fold(0, |value, at| {
            value << 1 | bits.get(at).copied().unwrap_or(0)
        });
        char::from(DIGITS[usize::from(value)])
    };
    bits.chunks(6).map(digit).collect()
}

#[test]
fn what_others_append_and_wrap_does_not_matter() {
    let expected = read("?scene=gold&set=material.n=7&probe=0.5,0").expect("a link");
    for link in [
        "  <https://example.org/?scene=gold&set=material.n=7&probe=0.5,0>\n",
        "HTTPS://EXAMPLE.ORG/?utm_source=mail&scene=gold&fbclid=x%zz&set=material.n=7&probe=.5,0&gclid",
        "?scene=gold&&set=material.n%3D7&probe=0.5%2C0&",
        "?s%63ene=gold&set=material.n=+7+&probe=0.5,0#",
        "?scene=gold&set=material.n=7&probe=0.5,0#:~:text=gold",
    ] {
        assert_eq!(read(link).as_ref(), Ok(&expected), "{link}");
    }
    let list = read("?scene=gold&set=light.0.position=[1,%202,3]&set=about.title=a+b%2Bc")
        .expect("a link");
    assert_eq!(
        list.scene.lights[0].position,
        glam::DVec3::new(1.0, 2.0, 3.0)
    );
    assert_eq!(
        (list.scene.about.title.as_str(), list.name.as_str()),
        ("a b+c", "link")
    );
}

#[test]
fn a_bad_link_is_refused_by_its_key_and_place() {
    let bomb = packed(&"# \n".repeat(1 << 20));
    assert!(bomb.len() < 10_000, "{}", bomb.len());
    let cut = packed("version = 1\n[material]\nn = 5\n");
    let many = format!("?{}", "set=material.n=5&".repeat(600));
    let said = |key: &str| english!("problem-value", found = "|", expected = english!(key));
    let meant = |name: &str| english!("document-did-you-mean", name = name);
    let negative = packed("version = 1\n[material]\nn = -5\n");
    let long = format!("?{}", "x".repeat(3 << 20));
    for (link, place, words) in [
        ("?scene=higlight", "2 scene", &*meant("highlight")),
        (
            "https://a.b/?scene=gold&set=material.n=-1",
            "25 material.n",
            "-1",
        ),
        ("?set=material.q=1", "2 material.q", "ka, kd, ks"),
        (
            "?set=material.kd=1&set=material.n=word",
            "20 material.n",
            "word",
        ),
        ("?set=material.n", "2 set", english!("problem-no-equals")),
        ("?set", "2 set", english!("problem-no-equals")),
        ("?高=光&scnee=gold", "2 高", "scene, lights, pane"),
        ("?scnee=gold", "2 scnee", &meant("scene")),
        (
            "?scene=gold&scene=brass",
            "13 scene",
            english!("link-twice"),
        ),
        ("?scene=gold%", "12 scene", english!("link-not-encoded")),
        (
            "?set=about.title=%ff",
            "6 set",
            english!("link-not-encoded"),
        ),
        ("?set=%4", "6 set", english!("link-not-encoded")),
        ("?set=ab%zz", "8 set", english!("link-not-encoded")),
        ("?set=%+1", "6 set", english!("link-not-encoded")),
        ("?set=%é", "6 set", english!("link-not-encoded")),
        ("?lights=1001", "2 lights", "0 to 1000"),
        ("?lights=-1", "2 lights", "\"-1\""),
        ("?pane=camera.fov_y=20", "2 compare.pane.0.set.0", "fov_y"),
        (
            "?scene=gold&pane=nothing=1",
            "13 compare.pane.0.set.0",
            "`nothing`",
        ),
        ("?view=profil", "2 view", "equation"),
        ("?probe=1", "2 probe", &said("link-expected-probe")),
        ("?probe=nan,inf", "2 probe", "\"nan,inf\""),
        ("?line=1,2,3,4,5", "2 line", &said("link-expected-line")),
        ("?embed=perhaps", "2 embed", &said("expected-bool")),
        ("?controls=n,<script>", "2 controls", "64"),
        ("#part", "2 #part", english!("link-unknown-fragment")),
        (
            "?set=material.n=5#scene=AAAA",
            "2 set",
            english!("link-beside-file"),
        ),
        ("#scene=ab+/", "2 #scene", english!("link-not-base64")),
        ("#scene=Z", "2 #scene", english!("link-not-base64")),
        ("#scene=Zm 9", "2 #scene", english!("link-not-base64")),
        (
            &cut[..cut.len() - 8],
            "2 #scene",
            english!("link-not-packed"),
        ),
        (&bomb, "2 #scene", "1024"),
        (&negative, "2 material.n", "-5"),
        (&packed("version = 1\n[material\n"), "2 #scene", "2"),
        (&packed("version = 2"), "2 version", "2"),
        (&many, "2 scene", "8 KiB"),
        (&long, "1 scene", "2048 KiB"),
    ] {
        let start = &link[..link.len().min(100)];
        let found = read(link).expect_err(start);
        let problem = &found.problems[0];
        assert_eq!(
            format!("{} {}", problem.position, problem.key),
            place,
            "{start}"
        );
        let words = words.split('|').next_back().unwrap_or_default();
        assert!(problem.words.contains(words), "{start}\n{found}\n{words}");
    }
    let found = read("?set").expect_err("no value");
    let words = &*found.problems[0].words;
    let line = english!("link-problem", position = 2, words = words);
    assert_eq!(found.to_string(), line);
}

#[test]
fn any_text_is_a_scene_or_is_refused_by_a_key() {
    let mut own = presets::find("orientation").expect("built in").scene();
    own.object.vertices_mut()[2].x = 1.25;
    let packed = plain(&own, None);
    let sound = [
        "?scene=highlight&set=material.n=50&set=shading.mode=gouraud&view=profile",
        "https://example.org/lab/?scene=sphere&lights=3&pane=shading.mode=exact;material.n=inf&set=light.2.position=-2,0.1,3.5",
        "?scene=defaults&set=about.title=%E9%AB%98%E5%85%89&probe=0.1,-0.2&line=0,0,1,1&embed&controls=n,ks",
        "?scene=soft-shadow&set=light.0.color=%5B1,1,0%5D&set=light=%5B%5D&set=about=%7B%7D&utm_source=x",
        &packed,
    ];
    const PIECES: [&str; 26] = [
        "&",
        "=",
        "?",
        "#",
        "%",
        "%00",
        "%F0%9F",
        ";",
        ",",
        "..",
        "[",
        "{",
        "\"",
        "'''",
        "inf",
        "nan",
        "-1",
        "1e999",
        "99999999999999999999",
        "set=",
        "object.path=x",
        "lights=1000",
        "compare.pane=[{set=[\"a=b\"]}]",
        "scene=",
        "é",
        "\u{0}",
    ];
    (0..tries(5000)).into_par_iter().for_each(|seed| {
        let mut dice = Dice(seed.wrapping_mul(0xd134_2543_de82_ef95));
        let mut link: Vec<char> = dice.of(&sound).chars().collect();
        for _ in 0..1 + (dice.unit() * dice.unit() * 8.0) as usize {
            let [mut from, mut to] = [(); 2].map(|()| (dice.unit() * link.len() as f64) as usize);
            if dice.unit() < 0.7 {
                to = from + (dice.unit() * 3.0) as usize;
            }
            if from > to {
                (from, to) = (to, from);
            }
            let to = to.min(link.len());
            let piece: Vec<char> = match (dice.unit() * 4.0) as usize {
                0 => vec![],
                1 => dice.of(&PIECES).chars().collect(),
                2 => link[from..to].repeat(2),
                _ => vec![char::from_u32((dice.unit() * 300.0) as u32).unwrap_or('x')],
            };
            link.splice(from..to, piece);
        }
        let link: String = link.into_iter().collect();
        match read(&link) {
            Ok(Link { scene, .. }) => assert_eq!(scene.validate(), Ok(()), "{link}"),
            Err(error) => {
                assert!(!error.problems.is_empty(), "{link}");
                for problem in &error.problems {
                    assert!(
                        !problem.key.is_empty() && problem.words.contains('`'),
                        "{link}\n{problem:?}"
                    );
                    assert!(
                        (1..=link.chars().count() + 1).contains(&problem.position),
                        "{link}\n{problem:?}"
                    );
                }
            }
        }
    });
}

#[test]
fn views_are_called_as_built_in_scenes_call_them() {
    for preset in presets::ALL
        .iter()
        .filter(|preset| !preset.view().is_empty())
    {
        assert!(VIEWS.contains(&preset.view()), "{}", preset.view());
    }
}

/// Decodes the QR code in a picture as a reader sees it, by luminance from 0 to 1.
fn decoded(frame: &Frame) -> String {
    let [width, height] = [frame.width, frame.height].map(|side| side as usize);
    let mut image = rqrr::PreparedImage::prepare_from_greyscale(width, height, |x, y| {
        frame.pixels[y * width + x][0]
    });
    let [code] = &image.detect_grids()[..] else {
        panic!("one code")
    };
    code.decode().expect("a readable code").1
}

#[test]
fn a_qr_code_is_read_back() {
    let long = format!(
        "https://example.org/?scene=gold&set=about.sentence={}",
        "x".repeat(900)
    );
    for text in [
        "https://example.org/?scene=highlight&set=material.n=50&view=profile",
        "?scene=gold",
        &long,
    ] {
        let code = QrCode::new(text).expect("short enough");
        assert_eq!(
            decoded(&code.drawing(6.0).to_frame().expect("a picture")),
            text
        );
    }
    assert_eq!(
        QrCode::new(&"x".repeat(2953)).map(|code| code.side()),
        Some(177 + 8)
    );
    assert_eq!(QrCode::new(&"x".repeat(2954)), None);
}

#[test]
fn the_command_prints_links_and_every_command_reads_them() {
    let folder = Folder::new("link");
    let link =
        "https://example.org/lab/?scene=highlight&set=material.n=50&set=shading.mode=gouraud\n";
    let settings = ["--set", "material.n=50", "--set=shading.mode=gouraud"];
    let base = "https://example.org/lab/?old#x";
    let printed = folder.prints(&[&["link", "highlight", "--url", base][..], &settings].concat());
    assert_eq!(printed, link);
    assert_eq!(
        folder.prints(&[
            "--url",
            base,
            "link",
            "highlight",
            settings[0],
            settings[1],
            settings[2]
        ]),
        link
    );
    // A changed link keeps the view.
    let changed = folder.prints(&[
        "link",
        &format!("{}&view=plan", link.trim()),
        "--set",
        "material.n=inf",
    ]);
    assert_eq!(
        changed,
        "?scene=highlight&set=material.n=inf&set=shading.mode=gouraud&view=plan\n"
    );
    let object = folder.json(&["link", "gold", "--json"]);
    assert_eq!(
        object,
        serde_json::json!({"link": "?scene=gold", "length": 11, "left_out": null})
    );
    folder.prints(&[
        "link",
        "gold",
        "--url=http://localhost:8000",
        "-o",
        "code.png",
    ]);
    folder.prints(&[
        "link",
        "gold",
        "--url=http://localhost:8000",
        "-o",
        "code.svg",
    ]);
    let (width, height) = program::size_of(&folder.0.join("code.png"));
    let pixels = program::pixels_of(&folder.0.join("code.png"));
    let pixels = pixels
        .as_chunks::<3>()
        .0
        .iter()
        .map(|&[r, g, b]| [r, g, b, 255])
        .collect();
    assert_eq!(
        decoded(&Frame {
            width,
            height,
            pixels
        }),
        "http://localhost:8000?scene=gold"
    );
    // Every command takes a link.
    let scene = "?scene=sphere&set=image.size=32,32&set=material.n=5&view=study";
    let same = ["--set", "image.size=[32,32]", "--set", "material.n=5"];
    let probed = folder.prints(&["probe", scene, "--pixel=16,16", "--json"]);
    assert_eq!(
        probed,
        folder.prints(&[&["probe", "sphere", "--pixel=16,16", "--json"][..], &same].concat())
    );
    let checked = folder.prints(&["check", "https://example.org/?scene=defaults"]);
    assert_eq!(
        checked,
        program::sound("https://example.org/?scene=defaults")
    );
    folder.prints(&["render", scene, "-o", "picture.png"]);
    assert_eq!(program::size_of(&folder.0.join("picture.png")), (32, 32));
    // A model is left out.
    folder.write(
        "tetra.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\n",
    );
    let output = folder.run(&["link", "tetra.obj"]);
    let note = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        note.contains(&english!(
            "link-model-stays",
            path = folder.0.join("tetra.obj").display().to_string()
        )),
        "{note}"
    );
    assert!(output.status.success() && output.stdout.starts_with(b"?scene="));
}

#[test]
fn the_command_refuses_what_is_no_link() {
    let folder = Folder::new("no-link");
    folder.fails(
        &["check", "?scene=gold&set=material.n=-1"],
        2,
        &[&read("?scene=gold&set=material.n=-1")
            .expect_err("wrong")
            .to_string()],
    );
    folder.fails(
        &["link", "?sceen=gold"],
        2,
        &[&read("?sceen=gold").expect_err("wrong").to_string()],
    );
    folder.refuses(
        &["link", "gold", "--url", "example.org"],
        english!("link-no-page"),
    );
    folder.refuses(
        &["link", "gold", "-o", "code.jpg"],
        english!("cli-expected-qr"),
    );
    folder.refuses(
        &["--url=https://a.b", "check", "gold"],
        english!("cli-url-before-command"),
    );
    let corner = |at: u32| {
        let (y, x) = (f64::from(at) * 0.0314).sin_cos();
        format!("[{x}, {y}, 0.0],")
    };
    let corners: String = (0..200).map(corner).collect();
    let face: Vec<u32> = (0..200).collect();
    folder.write(
        "own.toml",
        format!("version = 1\n[object]\nkind = \"polygons\"\nvertices = [{corners}]\nfaces = [{face:?}]\n"),
    );
    let long = ["link", "own.toml", "-o", "c.png"];
    let words = english!("cli-too-long-for-qr", length = "|");
    folder.refuses(&long, words.split('|').next_back().unwrap_or_default());
    assert_eq!(folder.names(), ["own.toml"]);
}
