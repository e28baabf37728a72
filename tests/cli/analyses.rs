//! The analyses on the command line: curves, profiles, the scan line and vertex normals.

use crate::common::program::{Folder, outside, pixels_of, size_of};
use serde_json::Value;
use std::fs;

#[test]
fn curves_are_drawn_written_and_told() {
    let folder = Folder::new("curves");
    let attenuated = [
        "attenuation",
        "--set",
        "image.size=[120,120]",
        "--set",
        "material.reflectance=glass",
    ];
    let with = |more: &[&'static str]| [&["curves"], &attenuated[..], more].concat();
    folder.prints(&with(&["-o", "all.png", "--size", "640x400", "--dark"]));
    assert_eq!(size_of(&folder.0.join("all.png")), (640, 400));
    assert!(
        pixels_of(&folder.0.join("all.png"))
            .iter()
            .any(|code| *code > 200),
        "light lines on a dark ground"
    );
    folder.prints(&with(&[
        "--kind", "lobe", "-o", "lobe.svg", "--csv", "lobe.csv",
    ]));
    let svg = fs::read_to_string(folder.0.join("lobe.svg")).expect("a figure");
    assert!(
        svg.starts_with("<svg ")
            && svg.trim_end().ends_with("</svg>")
            && svg.contains("diffuse + specular")
    );
    let csv = fs::read_to_string(folder.0.join("lobe.csv")).expect("a table");
    assert!(
        csv.starts_with("plot,curve,x,y\nlobe,diffuse + specular,-90,")
            && csv.lines().count() > 500
    );
    assert!(csv.lines().all(|line| line.split(',').count() == 4));
    folder.prints(&with(&["--kind", "exponent", "-o", "family.csv"]));
    let csv = fs::read_to_string(folder.0.join("family.csv")).expect("a table");
    assert!(csv.contains("exponent,n = 1005,0,1\n") && csv.contains("exponent,n = 20,0,1\n"));
    let told = folder.prints(&with(&[]));
    assert!(
        told.contains("half-width") && told.contains("farthest: f(") && told.contains("W(80°)"),
        "{told}"
    );
    assert_eq!(
        folder.names(),
        ["all.png", "family.csv", "lobe.csv", "lobe.svg"]
    );
}

#[test]
fn curves_are_the_probes_own() {
    let folder = Folder::new("curves-json");
    let at = [
        "attenuation",
        "--set",
        "image.size=[120,120]",
        "--pixel",
        "70,50",
        "--json",
    ];
    let curves = folder.json(&[&["curves"], &at[..]].concat());
    let probe = folder.json(&[&["probe"], &at[..]].concat());
    assert_eq!(curves["pixel"], probe["pixel"]);
    let kinds: Vec<_> = curves["plots"]
        .as_array()
        .expect("plots")
        .iter()
        .map(|plot| plot["kind"].clone())
        .collect();
    assert_eq!(kinds, ["attenuation", "exponent", "reflectance", "lobe"]);
    let marks = curves["plots"][0]["marks"].as_array().expect("marks");
    let mark = marks
        .iter()
        .find(|mark| mark["probe"] == true)
        .expect("the probe's");
    let (f, expected) = (
        mark["values"][0][1].as_f64(),
        probe["lights"][0]["attenuation"].as_f64(),
    );
    assert!(
        (f.expect("f") - expected.expect("f")).abs() < 1e-9,
        "{f:?} {expected:?}"
    );
}

#[test]
fn lights_are_counted_from_1_by_people_and_from_0_in_keys() {
    let folder = Folder::new("curves-lights");
    for number in 1..=3 {
        let light = number.to_string();
        let arguments = ["curves", "three-lights", "--light", &light];
        let text = folder.prints(&arguments);
        assert!(text.contains(&format!(", light {number}\n")), "{text}");
        let object = folder.json(&[&arguments[..], &["--json"]].concat());
        assert_eq!(object["light"], number - 1);
    }
    // A true minus sign, and none before a zero.
    let text = folder.prints(&["curves", "sphere", "--pixel", "230,384"]);
    let angles: Vec<&str> = text
        .lines()
        .filter(|line| line.ends_with("° from N"))
        .collect();
    assert!(
        angles.len() == 4
            && angles
                .iter()
                .all(|line| !line.contains("-") && !line.contains("−0.0°")),
        "{angles:?}"
    );
}

#[test]
fn curves_that_cannot_be_are_refused() {
    let folder = Folder::new("curves-refused");
    folder.refuses(
        &["curves", "sphere", "-o", "curves.gif"],
        ".png, .svg or .csv",
    );
    folder.refuses(
        &["curves", "sphere", "--kind", "shadow"],
        "expected attenuation, exponent, reflectance or lobe",
    );
    folder.fails(
        &["curves", "three-lights", "--light", "4"],
        2,
        &[&english!("point-error-no-such-light", light = 4, last = 3)],
    );
    folder.refuses(
        &["curves", "three-lights", "--light", "0"],
        "expected a whole number from 1 to",
    );
    folder.fails(
        &["curves", "sphere", "--pixel", "768,0"],
        2,
        &[&outside("--pixel 768,0", "767,767")],
    );
    folder.fails(
        &[
            "curves", "sphere", "--kind", "lobe", "--pixel", "0,0", "-o", "lobe.png",
        ],
        2,
        &[&english!("point-error-background", x = 0, y = 0)],
    );
    folder.fails(
        &[
            "curves",
            "sphere",
            "--kind",
            "attenuation",
            "--set",
            "light=[]",
        ],
        2,
        &[english!("point-error-no-light")],
    );
    folder.fails(
        &[
            "curves",
            "sphere",
            "--kind",
            "lobe",
            "--set",
            "light.0.position=[0,0,-5]",
            "--pixel",
            "380,380",
        ],
        2,
        &[&english!("point-error-behind", light = 1, x = 380, y = 380)],
    );
    assert!(folder.names().is_empty());
}

#[test]
fn a_profile_has_every_mode_at_every_pixel_centre() {
    let folder = Folder::new("profile");
    let line = [
        "profile",
        "sphere",
        "--from",
        "100.5,300.5",
        "--to",
        "140.5,300.5",
        "--json",
    ];
    let object = folder.json(&line);
    let samples = object["samples"].as_array().expect("a list");
    for x in 100..=140 {
        let centre = f64::from(x) + 0.5;
        let sample = samples.iter().find(|sample| {
            sample["x"]
                .as_f64()
                .is_some_and(|at| (at - centre).abs() < 1e-9)
        });
        let sample = sample.unwrap_or_else(|| panic!("{centre}"));
        assert_eq!(sample["y"], 300.5);
        for mode in ["flat", "gouraud", "phong", "exact"] {
            for key in ["", "_slope", "_perceived"] {
                assert!(
                    sample[format!("{mode}{key}")].is_f64(),
                    "{mode}{key}: {sample}"
                );
            }
        }
    }
    assert_eq!(
        (
            samples[0]["t"].as_f64(),
            samples[samples.len() - 1]["t"].as_f64()
        ),
        (Some(0.0), Some(1.0))
    );
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
    let sum: Vec<f64> = probed["sum"]
        .as_array()
        .expect("three")
        .iter()
        .filter_map(Value::as_f64)
        .collect();
    let expected = 0.2126 * sum[0] + 0.7152 * sum[1] + 0.0722 * sum[2];
    assert!((there["samples"][0]["phong"].as_f64().expect("a number") - expected).abs() < 1e-9);
}

#[test]
fn a_profile_is_written_as_table_plot_and_picture() {
    let folder = Folder::new("profile-files");
    let line = [
        "profile",
        "flat-facets",
        "--from",
        "100,300",
        "--to",
        "600,310.5",
    ];
    let text = folder.prints(&line);
    assert!(
        text.starts_with("x,y,t,distance,flat,flat_slope,flat_perceived,gouraud,"),
        "{}",
        &text[..90]
    );
    folder.prints(
        &[
            &line[..],
            &[
                "-o",
                "plot.png",
                "--csv",
                "rows.csv",
                "--picture",
                "seen.png",
                "--size",
                "640x480",
            ],
        ]
        .concat(),
    );
    folder.prints(
        &[
            &line[..],
            &[
                "-o",
                "plot.svg",
                "--dark",
                "--response",
                "response-normalisation",
            ],
        ]
        .concat(),
    );
    assert_eq!(
        folder.names(),
        ["plot.png", "plot.svg", "rows.csv", "seen.png"]
    );
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
    folder.prints(&[
        "render",
        "flat-facets",
        "--overlay",
        "vectors,profile",
        "-o",
        "over.png",
    ]);
}

#[test]
fn a_profile_along_no_line_is_refused() {
    let folder = Folder::new("profile-refused");
    let with = |from, to, more: &[&'static str]| {
        [&["profile", "sphere", "--from", from, "--to", to], more].concat()
    };
    let outside = &outside("--from 0,0 --to 769,3", "768,768");
    folder.fails(&with("0,0", "769,3", &[]), 2, &[outside]);
    let nowhere = &format!("--from 5,5 --to 5,5: {}", english!("line-error-no-length"));
    folder.fails(&with("5,5", "5,5", &[]), 2, &[nowhere]);
    let narrow = &english!("cli-surround-too-small", surround = "0.01", centre = "0.04");
    folder.fails(&with("0,0", "5,5", &["--surround", "0.01"]), 2, &[narrow]);
    folder.fails(
        &with("0,0", "5,5", &["--viewing-distance", "NaN"]),
        2,
        &[&english!(
            "cli-outside-range",
            argument = "--viewing-distance",
            value = "NaN",
            low = 100,
            high = 5000
        )],
    );
    let wide = [
        "--picture",
        "a.png",
        "--surround",
        "2",
        "--viewing-distance",
        "5000",
    ];
    let error = &english!(
        "cli-surround-too-large",
        surround = 2,
        pixels = 660,
        most = 256
    );
    folder.fails(&with("0,0", "5,5", &wide), 2, &[error]);
    folder.refuses(&with("0,0", "x,5", &[]), english!("cli-expected-place"));
    folder.refuses(&with("0,0", "inf,5", &[]), english!("cli-expected-place"));
    folder.refuses(
        &with("0,0", "5,5", &["--modes", "flat,fong"]),
        "expected flat, interpolated, gouraud, phong or exact",
    );
    folder.refuses(
        &["render", "sphere", "-o", "a.png", "--from", "1,1"],
        "--to",
    );
    assert!(folder.names().is_empty());
}

#[test]
fn a_polygon_is_scanned_as_text_as_data_and_as_a_figure() {
    let folder = Folder::new("scanline");
    let gouraud = [
        "--set",
        "shading.mode=gouraud",
        "--set",
        "shading.interpolation=affine",
    ];
    let scanline = |arguments: &[&'static str]| {
        [&["scanline", "flat-facets"], &gouraud[..], arguments].concat()
    };
    let text = folder.prints(&scanline(&["--line", "7"]));
    for words in [
        "I(P) = (1−α)·I(",
        "I = (1−α)·I(P) + α·I(Q)",
        "scan line 7, ",
        "dx/dy",
        "active",
    ] {
        assert!(text.contains(words), "{words} in {text}");
    }
    let object = folder.json(&scanline(&["--json", "--rows", "24", "--step", "last"]));
    assert_eq!(object["grid"]["rows"], 24);
    assert_eq!(
        object["step"],
        object["steps"].as_array().map_or(0, Vec::len) - 1
    );
    assert_eq!(
        (&object["carried"], &object["compared"]),
        (&"intensity".into(), &"affine".into())
    );
    let pixels: usize = object["lines"]
        .as_array()
        .expect("lines")
        .iter()
        .flat_map(scanned)
        .count();
    assert_eq!(
        folder.prints(&scanline(&["--rows", "24", "--csv", "pixels.csv"])),
        ""
    );
    let table = fs::read_to_string(folder.0.join("pixels.csv")).expect("the table");
    assert_eq!(table.lines().count(), pixels + 1);
    assert!(
        table.starts_with(
            "y,x,p_x,q_x,alpha_p,alpha_q,alpha,value_r,value_g,value_b,barycentric_r,"
        )
    );
    folder.prints(&scanline(&[
        "-o", "step.png", "--size", "640x440", "--dark",
    ]));
    folder.prints(&scanline(&[
        "-o", "step.svg", "--face", "120", "--step", "40",
    ]));
    let svg = fs::read_to_string(folder.0.join("step.svg")).expect("the figure");
    assert!(svg.contains("Gouraud shading, face 120") && svg.contains("<polygon"));
    let png = fs::read(folder.0.join("step.png")).expect("the figure");
    assert!(png.starts_with(b"\x89PNG"));
    assert_eq!(folder.names(), ["pixels.csv", "step.png", "step.svg"]);
    let refuses =
        |arguments: &[&'static str], error: &str| folder.fails(&scanline(arguments), 2, &[error]);
    refuses(
        &["--face", "9999"],
        &english!("line-scan-error-no-face", face = 9999, last = 287),
    );
    refuses(
        &["--rows", "5"],
        &english!("line-scan-error-rows", rows = 5, low = 8, high = 64),
    );
    refuses(
        &["--pixel", "0,0"],
        &english!("point-error-background", x = 0, y = 0),
    );
    refuses(
        &["--face", "120", "--line", "0"],
        &english!("line-scan-error-line", y = 0, first = 1, last = 14),
    );
    refuses(
        &["--face", "120", "--step", "9999"],
        &english!("line-scan-error-step", step = 9999, last = 230),
    );
}

fn scanned(line: &Value) -> impl Iterator<Item = &Value> {
    let spans = line["spans"].as_array().into_iter().flatten();
    spans.flat_map(|span| span["pixels"].as_array().into_iter().flatten())
}

#[test]
fn a_vertex_normal_is_told_with_the_faces_that_it_comes_from() {
    let folder = Folder::new("normals");
    let cube = [
        "cube",
        "--set",
        "object={kind=\"cube\",segments=4,rings=1,normals=\"averaged\",weighting=\"angle\"}",
    ];
    let normals = |more: &[&'static str]| [&["normals"], &cube[..], more].concat();
    let told = folder.json(&normals(&["--vertex", "0", "--json"]));
    assert_eq!(
        (&told["vertices"], &told["faces"], &told["weight_unit"]),
        (&8.into(), &6.into(), &"degrees".into())
    );
    let faces = told["vertex"]["faces"].as_array().expect("faces");
    assert_eq!(
        (faces.len(), told["vertex"]["origin"].as_str()),
        (3, Some("averaged"))
    );
    for face in faces {
        let number = |key: &str| face[key].as_f64().expect("a number");
        assert!(
            (number("share") - 1.0 / 3.0).abs() < 1e-6 && (number("weight") - 90.0).abs() < 1e-5
        );
        assert!((number("angle") - 54.735_61).abs() < 1e-4);
    }
    let text = folder.prints(&normals(&["--vertex", "0"]));
    assert!(
        text.starts_with(&english!(
            "picture-vertex",
            scene = "cube",
            number = 0,
            count = 8,
            at = "("
        )),
        "{text}"
    );
    assert!(
        text.contains(&english!(
            "picture-normal-averaged",
            count = 3,
            weights = english!("picture-weighted-by-angle")
        )) && text.contains("of length 0.5774"),
        "{text}"
    );
    // Next to its position in the picture, and in the same words.
    let nearest = folder.json(&normals(&["--pixel", "400,310", "--json"]));
    let number = nearest["vertex"]["vertex"]
        .as_u64()
        .expect("a number")
        .to_string();
    assert_eq!(
        folder.json(&[&["normals"], &cube[..], &["--vertex", &number, "--json"]].concat())["vertex"],
        nearest["vertex"]
    );
    assert_eq!(folder.prints(&normals(&["--csv", "a.csv"])), "");
    let table = fs::read_to_string(folder.0.join("a.csv")).expect("a table");
    assert_eq!(
        (table.lines().count(), table.lines().next()),
        (4, Some("face,share,weight,angle,nx,ny,nz"))
    );
    let exact = folder.prints(&["normals", "cube", "--set", "object.normals=exact"]);
    assert!(
        exact.contains(english!("picture-normal-of-surface")),
        "{exact}"
    );
    let beyond = &*english!("picture-no-vertex", number = 8, last = 7);
    folder.fails(&normals(&["--vertex", "8"]), 2, &[beyond]);
    folder.fails(
        &normals(&["--pixel", "9999,0"]),
        2,
        &[&outside("--pixel 9999,0", "767,767")],
    );
    let away = normals(&[
        "--set",
        "camera.target=[0,0,9]",
        "--set",
        "camera.eye=[0,0,4]",
    ]);
    let unseen = english!("picture-no-vertex-seen");
    folder.fails(&away, 2, &[unseen]);

    let render = |name: &str, more: &[&str]| {
        folder.prints(
            &[
                &["render"],
                &cube[..],
                &["-o", name, "--size", "160x160"],
                more,
            ]
            .concat(),
        );
        pixels_of(&folder.0.join(name))
    };
    let plain = render("plain.png", &[]);
    let mut drawn = vec![plain];
    for list in [
        "face-normals",
        "vertex-normals",
        "face-normals,vertex-normals",
        "vertex-normals,lights",
    ] {
        drawn.push(render("over.png", &["--overlay", list]));
    }
    drawn.push(render(
        "lit.png",
        &["--overlay", "vertex-normals", "--vertex", &number],
    ));
    let count = drawn.len();
    drawn.sort();
    drawn.dedup();
    assert_eq!(drawn.len(), count, "each drawing is another");
    let refused = |more: &[&'static str]| [&["render"], &cube[..], &["-o", "x.png"], more].concat();
    folder.fails(
        &refused(&["--overlay", "vertex-normals", "--vertex", "8"]),
        2,
        &[beyond],
    );
    let without = [english!("cli-vertex-without-normals")];
    folder.fails(
        &refused(&["--overlay", "lights", "--vertex", "1"]),
        2,
        &without,
    );
    // An object of which nothing is visible has no needles, and that is no error.
    folder.prints(&refused(&[
        "--overlay",
        "vertex-normals",
        "--set",
        "camera.target=[0,0,9]",
    ]));
}
