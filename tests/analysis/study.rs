//! Error against run time: orders of convergence against theory, the historic methods, and the measuring loop itself.

use glam::DVec3;
use serde_json::Value;
use shading_lab::analysis::bench::CHANGES;
use shading_lab::analysis::report::{Column, Table, as_it_is, fixed};
use shading_lab::analysis::study::{
    Method, Setting, Study, StudyQuestion, fit_line, median_and_spread, order_of, pareto_front,
    student, study, study_plot,
};
use shading_lab::analysis::{Subject, Watch, unwatched};
use shading_lab::scene::{
    Choice, Interpolation, Light, LightKind, Overflow, Projection, Rgb, Scene, presets,
};
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Returns a matt sphere seen along −z, lit by parallel rays in the direction `towards`.
fn matt_sphere(towards: DVec3, projection: Projection) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [224, 224];
    scene.camera.eye = DVec3::new(0.0, 0.0, 4.0);
    scene.camera.target = DVec3::ZERO;
    scene.camera.projection = projection;
    scene.camera.height = 2.2;
    scene.material.ka = Rgb::ZERO;
    scene.material.ks = Rgb::ZERO;
    scene.material.kd = Rgb::ONE;
    scene.material.color = Rgb::ONE;
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        direction: towards,
        ..Light::default()
    }];
    scene
}

fn request(methods: &[Method], segments: &[u32], repeats: u32) -> StudyQuestion {
    let interpolations = vec![Interpolation::Perspective];
    StudyQuestion {
        methods: methods.to_vec(),
        segments: segments.to_vec(),
        interpolations,
        n: vec![],
        repeats,
        reference: None,
    }
}

fn measured(scene: &Scene, methods: &[Method], segments: &[u32]) -> Study {
    let subject = Subject::new(scene.clone());
    study(&subject, &request(methods, segments, 1), &unwatched)
}

/// Returns the order of convergence of the maximum error.
fn order(study: &Study, method: Method) -> f64 {
    for row in study.rows.iter().filter(|row| row.setting.method == method) {
        println!(
            "{:?} {:.4}: {:.6}, RMS {:.6}",
            row.setting, row.spacing, row.error_max, row.error_rms
        );
    }
    let series = study.series_of(method).expect("a series");
    println!("{series:?}");
    series.order.expect("an order").slope
}

/// Segment counts fine enough that the higher-order terms that the theory neglects are small.
const FINE: [u32; 5] = [24, 32, 48, 64, 96];

#[test]
fn without_a_terminator_flat_is_of_first_order_and_gouraud_and_phong_of_second() {
    for projection in [Projection::Orthographic, Projection::Perspective] {
        let scene = matt_sphere(DVec3::NEG_Z, projection);
        let study = measured(
            &scene,
            &[Method::Flat, Method::Gouraud, Method::Phong],
            &FINE,
        );
        for (method, expected, within) in [
            (Method::Flat, 1.0, 0.15),
            (Method::Gouraud, 2.0, 0.25),
            (Method::Phong, 2.0, 0.25),
        ] {
            let found = order(&study, method);
            assert!(
                (found - expected).abs() <= within,
                "{projection:?}, {method:?}: {found} is not {expected}"
            );
        }
    }
}

/// Checks that before the display values above 1 count in full, and as shown they count as 1 where the display clamps.
#[test]
fn errors_are_told_before_the_display_and_as_shown() {
    let mut scene = presets::find("sphere").expect("a scene").scene();
    scene.image.size = [512, 512];
    let row = |scene: &Scene| measured(scene, &[Method::Flat], &[32]).rows[0].clone();
    let clamped = row(&scene);
    assert!((clamped.error_rms - 0.0328).abs() < 1e-4, "{clamped:?}");
    assert!(
        (clamped.error_rms_shown - 0.0295).abs() < 1e-4,
        "{clamped:?}"
    );
    assert!(clamped.error_max_shown <= clamped.error_max);
    scene.display.overflow = Overflow::Scale;
    let scaled = row(&scene);
    assert_eq!(
        (scaled.error_rms_shown, scaled.error_max_shown),
        (scaled.error_rms, scaled.error_max)
    );
    scene.display.overflow = Overflow::Clamp;
    scene.material.ks = Rgb::ZERO;
    let matt = row(&scene);
    assert_eq!(
        (matt.error_rms_shown, matt.error_max_shown),
        (matt.error_rms, matt.error_max),
        "all of it below 1"
    );
}

/// Checks the orders at the terminator, where max(N·L, 0) has a corner. A polygon that lies across it interpolates over
/// the corner: off by its slope times the spacing. Phong's normals are interpolated before the clamp.
#[test]
fn at_the_terminator_gouraud_falls_to_first_order_and_phong_does_not() {
    let scene = matt_sphere(DVec3::new(-1.0, -0.3, -0.5), Projection::Orthographic);
    let study = measured(&scene, &[Method::Gouraud, Method::Phong], &FINE);
    let (gouraud, phong) = (order(&study, Method::Gouraud), order(&study, Method::Phong));
    assert!((gouraud - 1.0).abs() < 0.2, "{gouraud}");
    assert!(phong > 1.75, "{phong}");
}

#[test]
fn the_historic_methods_come_near_phong_shading_and_are_of_its_order() {
    let mut scene = matt_sphere(DVec3::new(-0.4, -0.3, -1.0), Projection::Orthographic);
    scene.material.ks = Rgb::splat(0.5);
    scene.material.n = 10.0;
    let methods = [
        Method::Phong,
        Method::PhongScalar,
        Method::Taylor,
        Method::Angular,
    ];
    let study = measured(&scene, &methods, &FINE);
    let of = |method: Method| {
        study
            .rows
            .iter()
            .filter(move |row| row.setting.method == method)
    };
    for (engine, scalar) in of(Method::Phong).zip(of(Method::PhongScalar)) {
        assert!(
            (engine.error_rms - scalar.error_rms).abs() < 1e-5,
            "{engine:?} {scalar:?}"
        );
        assert!(engine.outline_pixels.abs_diff(scalar.outline_pixels) <= 8);
        assert_eq!(
            engine.evaluations.abs_diff(scalar.evaluations) / 100,
            0,
            "{engine:?} {scalar:?}"
        );
    }
    for method in [Method::Taylor, Method::Angular] {
        for (phong, other) in of(Method::Phong).zip(of(method)) {
            assert!(
                (other.error_rms / phong.error_rms - 1.0).abs() < 0.05,
                "{phong:?} {other:?}"
            );
        }
        let found = order(&study, method);
        assert!((found - 2.0).abs() < 0.3, "{method:?}: {found}");
    }
    // Triangles are expanded, pixels are not.
    let (taylor, phong) = (
        of(Method::Taylor).next().expect("a row"),
        of(Method::Phong).next().expect("a row"),
    );
    assert!(10 * taylor.evaluations < phong.evaluations);
}

/// The sample counts of each row after each frame.
#[derive(Default)]
struct Seen(Mutex<Vec<Vec<u32>>>);

impl Watch<Study> for Seen {
    fn progress(&self, _: f32) -> bool {
        true
    }

    fn found(&self, study: &Study) {
        self.0
            .lock()
            .expect("a list")
            .push(study.rows.iter().map(|row| row.samples).collect());
    }
}

#[test]
fn settings_are_timed_in_turn() {
    let mut scene = matt_sphere(DVec3::NEG_Z, Projection::Orthographic);
    scene.image.size = [32, 32];
    let request = request(&[Method::Flat, Method::Taylor], &[8, 16], 3);
    let seen = Seen::default();
    let found = study(&Subject::new(scene.clone()), &request, &seen);
    let seen = seen.0.into_inner().expect("a list");
    assert!(found.complete && seen.len() == 12);
    assert_eq!(
        (&seen[1], &seen[3], &seen[5]),
        (&vec![1, 1], &vec![1; 4], &vec![2, 2, 1, 1])
    );
    assert_eq!(
        study_plot(&found),
        None,
        "a clock that stands still has no times to plot"
    );
}

#[test]
fn a_study_that_is_cancelled_keeps_what_it_has() {
    let mut scene = matt_sphere(DVec3::NEG_Z, Projection::Orthographic);
    scene.image.size = [32, 32];
    let frames = AtomicUsize::new(0);
    let three = |_: f32| frames.fetch_add(1, Ordering::Relaxed) < 2;
    let found = study(
        &Subject::new(scene.clone()),
        &StudyQuestion::default(),
        &three,
    );
    assert_eq!((found.rows.len(), found.complete), (3, false));
    assert_eq!(found.series.len(), 1);
}

/// Runs `study` on a built-in scene; returns its exit status and its two outputs.
pub fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_shading-lab"))
        .env_remove("LANGUAGE")
        .env("LC_ALL", "C")
        .arg("study")
        .args(arguments)
        .output()
        .expect("it runs");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("text");
    (
        output.status.code(),
        text(output.stdout),
        text(output.stderr),
    )
}

const SMALL: [&str; 7] = [
    "sphere",
    "--size",
    "64x64",
    "--segments",
    "8,16,32",
    "--repeats",
    "2",
];

#[test]
fn the_command_prints_the_keys_that_scripts_read() {
    let (status, out, err) = run(&[&SMALL[..], &["--json", "--n", "5,50"]].concat());
    assert_eq!((status, err.as_str()), (Some(0), ""));
    let value: Value = serde_json::from_str(&out).expect("JSON");
    let rows = value["rows"].as_array().expect("rows");
    // Nine methods, two without an interpolation, angular interpolation with one; three tessellations; two exponents.
    assert_eq!(rows.len(), (2 + 6 * 2 + 1) * 3 * 2);
    for row in rows {
        assert!(
            row["method"].is_string() && row["segments"].is_u64() && row["rings"].is_u64(),
            "{row}"
        );
        for key in [
            "error_rms",
            "error_max",
            "error_p99",
            "error_rms_shown",
            "error_max_shown",
            "time_ms",
            "spread_ms",
            "outline_rms",
            "n",
            "evaluations",
        ] {
            assert!(
                row[key].as_f64().is_some_and(|number| number >= 0.0),
                "{key} of {row}"
            );
        }
        assert!(
            row["time_ms"].as_f64() > Some(0.0)
                && row["error_rms"].as_f64() <= row["error_max"].as_f64()
        );
    }
    for method in Method::VALUES.iter().map(|method| method.word()) {
        assert!(
            value["orders"][method].is_f64() && value["order_confidence"][method].is_f64(),
            "{method}"
        );
    }
    assert_eq!(value["omitted"][0]["method"], "angular");
}

#[test]
fn the_command_writes_table_and_plot_and_refuses_what_it_does_not_know() {
    let folder = std::env::temp_dir().join(format!("shading-lab-study-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let [csv, svg, png] =
        ["rows.csv", "plot.svg", "plot.png"].map(|name| folder.join(name).display().to_string());
    let few = [&SMALL[..], &["--methods", "flat,gouraud,taylor"]].concat();
    let (status, out, err) = run(&[&few[..], &["--csv", &csv, "-o", &svg]].concat());
    assert_eq!((status, out.as_str(), err.as_str()), (Some(0), "", ""));
    let table = std::fs::read_to_string(&csv).expect("a table");
    assert_eq!(table.lines().count(), 1 + (1 + 2 + 2) * 3);
    assert!(
        table
            .lines()
            .nth(1)
            .is_some_and(|line| line.starts_with("flat,8,4,none,")),
        "{table}"
    );
    let plot = std::fs::read_to_string(&svg).expect("a plot");
    assert!(
        plot.contains(english!("engine-front"))
            && plot.contains(&english!(
                "engine-method-affine",
                method = english!("choice-method-gouraud")
            ))
    );
    assert_eq!(run(&[&few[..], &["-o", &png]].concat()).0, Some(0));
    assert!(std::fs::metadata(&png).is_ok_and(|file| file.len() > 1000));
    std::fs::remove_dir_all(&folder).expect("the folder goes");
    let (status, out, _) = run(&few);
    assert!(
        status == Some(0) && out.contains(english!("engine-order")),
        "{out}"
    );
    for wrong in [
        ["--methods", "gourand"],
        ["--n", "-1"],
        ["--segments", "2"],
        ["-o", "rows.gif"],
    ] {
        assert_eq!(run(&[&SMALL[..1], &wrong].concat()).0, Some(2), "{wrong:?}");
    }
    let cook = [
        "sphere",
        "--set",
        "reflection.model=cook-torrance",
        "--methods",
        "taylor",
    ];
    assert!(run(&cook).2.contains(english!("engine-cannot-cosine")));
}

#[test]
fn a_line_is_found_with_its_confidence() {
    // Montgomery's kind of example, worked by hand: x̄ = 3, ȳ = 4, Sxx = 10, Sxy = 8, residuals' squares 3.6.
    let points = [[1.0, 2.0], [2.0, 4.0], [3.0, 5.0], [4.0, 4.0], [5.0, 5.0]];
    let fit = fit_line(&points).expect("five points");
    assert!(
        (fit.slope - 0.6).abs() < 1e-12 && (fit.offset - 2.2).abs() < 1e-12,
        "{fit:?}"
    );
    let expected = 3.182 * (2.4_f64 / 3.0 / 10.0).sqrt();
    assert!(
        (fit.confidence - expected).abs() < 1e-12,
        "{fit:?} is not {expected}"
    );
}

#[test]
fn a_power_is_its_order_and_what_is_rounding_is_left_out() {
    let power = |h: f64| (h, 3.0 * h.powi(2));
    let fit = order_of([0.5, 0.25, 0.125, 1e-9].map(power)).expect("three points");
    assert!(
        (fit.slope - 2.0).abs() < 1e-12 && fit.confidence < 1e-6 && fit.points == 3,
        "{fit:?}"
    );
    assert_eq!(order_of([power(0.5), power(0.1)]), None);
    assert_eq!(order_of([power(0.5), power(0.5), power(0.5)]), None);
}

#[test]
fn students_t_goes_on_beyond_its_table() {
    for (freedom, expected) in [
        (1, 12.706),
        (30, 2.042),
        (31, 2.0395),
        (60, 2.0003),
        (1000, 1.9623),
    ] {
        assert!(
            (student(freedom) - expected).abs() < 1e-3,
            "{freedom}: {}",
            student(freedom)
        );
    }
}

#[test]
fn the_front_is_what_nothing_beats() {
    let points = [
        [1.0, 9.0],
        [2.0, 5.0],
        [2.0, 6.0],
        [3.0, 5.0],
        [4.0, 1.0],
        [4.0, 1.0],
        [9.0, 2.0],
        [0.1, f64::NAN],
    ];
    assert_eq!(
        pareto_front(&points),
        [true, true, false, false, true, true, false, false]
    );
    assert!(pareto_front(&[]).is_empty());
}

#[test]
fn a_setting_is_loaded_into_the_scene_unless_it_is_historic() {
    let mut scene = Scene::default();
    let interpolation = Some(Interpolation::Affine);
    let setting = Setting {
        method: Method::PhongUnnormalised,
        segments: 12,
        rings: 7,
        interpolation,
        n: 9.0,
        law: None,
    };
    assert!(setting.load(&mut scene));
    assert_eq!(
        (scene.object.segments, scene.object.rings, scene.material.n),
        (12, 7, 9.0)
    );
    assert!(!scene.shading.renormalise && scene.shading.interpolation == Interpolation::Affine);
    let before = scene.clone();
    assert!(
        !Setting {
            method: Method::Taylor,
            n: 3.0,
            ..setting
        }
        .load(&mut scene)
    );
    assert_eq!(scene, before);
}

#[test]
fn what_the_scalar_text_cannot_draw_is_said() {
    let mut plain = matt_sphere(DVec3::NEG_Z, Projection::Perspective);
    plain.image.size = [8, 8];
    let omitted = |scene: &Scene| -> Vec<Method> {
        let scalar = [Method::PhongScalar, Method::Taylor, Method::Angular];
        measured(scene, &scalar, &[8])
            .omitted
            .iter()
            .map(|omission| omission.method)
            .collect()
    };
    assert_eq!(omitted(&plain), [Method::Angular], "in perspective");
    plain.camera.projection = Projection::Orthographic;
    for (change, left_out) in [
        ("camera.roll=1", &[][..]),
        (
            "shading.shadows=true",
            &[Method::PhongScalar, Method::Taylor, Method::Angular],
        ),
        (
            "backdrop.pattern=checker",
            &[Method::PhongScalar, Method::Taylor, Method::Angular],
        ),
        (
            "transparency.kt=0.5",
            &[Method::PhongScalar, Method::Taylor, Method::Angular],
        ),
        ("reflection.model=cook-torrance", &[Method::Taylor]),
        ("pattern.kind=stripes", &[Method::Taylor]),
    ] {
        let mut changed = plain
            .clone()
            .with_overrides(&[change])
            .expect("a sound scene");
        // If interpolation ignores perspective, equal angles are as good as any.
        changed.shading.interpolation = Interpolation::Affine;
        assert_eq!(omitted(&changed), left_out, "{change}");
    }
}

/// Checks the table of a report: in files, numbers have all digits and fields are quoted only if they must be; for
/// people, columns have one width.
#[test]
fn a_table_is_written_for_files_and_for_people() {
    let columns = [
        Column::both("name", "name", as_it_is),
        Column::both("value", "size", fixed::<2>),
        Column::key("code"),
        Column::shown("note", as_it_is),
    ];
    let mut table = Table::new(columns);
    table
        .rows
        .push(vec!["n = 1".into(), 1e-7.into(), 3_u32.into(), "a".into()]);
    table.rows.push(vec![
        "a \"b\", c".into(),
        f64::INFINITY.into(),
        None::<u32>.into(),
        "b".into(),
    ]);
    assert_eq!(
        table.text(),
        "  name      size  note\n  n = 1     0.00  a\n  a \"b\", c   inf  b\n"
    );
    table.rows.push(vec![
        "".into(),
        "two\nlines".into(),
        0_u64.into(),
        "".into(),
    ]);
    let expected =
        "name,value,code\nn = 1,0.0000001,3\n\"a \"\"b\"\", c\",inf,\n,\"two\nlines\",0\n";
    assert_eq!(table.to_csv(), expected);
}

/// Checks the changes whose frames `bench` times.
#[test]
fn every_change_changes_one_thing_and_leaves_the_scene_sound() {
    let mut far = Scene::default();
    far.lights[0].position = DVec3::splat(1e20);
    let mut mirror = Scene::default();
    mirror.material.n = f64::INFINITY;
    let lit = presets::ALL
        .iter()
        .map(|preset| preset.scene())
        .filter(|scene| !scene.lights.is_empty());
    for scene in lit.chain([far, mirror]) {
        for (name, change) in CHANGES {
            let frames = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0].map(|number| {
                let mut changed = scene.clone();
                change(&mut changed, number).expect("a light");
                changed
            });
            for pair in frames.windows(2) {
                let [a, b] = pair else {
                    unreachable!("windows of two")
                };
                assert_ne!(a, b, "{name}");
                assert_eq!(a.validate(), Ok(()), "{name}");
                let parts = [
                    a.lights != b.lights,
                    a.material.n != b.material.n,
                    a.material.ka != b.material.ka,
                    a.camera != b.camera,
                    a.object != b.object,
                ];
                assert_eq!(
                    parts.iter().filter(|&&differs| differs).count(),
                    1,
                    "{name}"
                );
            }
        }
    }
    assert_eq!(
        CHANGES[0].1(
            &mut Scene {
                lights: vec![],
                ..Scene::default()
            },
            1.0
        ),
        None
    );
}

#[test]
fn what_makes_no_difference_is_measured_once() {
    let mut scene = Scene::default();
    scene.image.size = [4, 4];
    let request = StudyQuestion {
        segments: vec![32, 8, 8],
        repeats: 1,
        ..StudyQuestion::default()
    };
    let found = study(&Subject::new(scene.clone()), &request, &unwatched);
    let count = |method| {
        found
            .rows
            .iter()
            .filter(|row| row.setting.method == method)
            .count()
    };
    assert_eq!(
        [
            Method::Flat,
            Method::Gouraud,
            Method::Taylor,
            Method::Angular
        ]
        .map(count),
        [2, 4, 4, 2]
    );
    assert_eq!(found.omitted.len(), 1, "{:?}", found.omitted);
    let [coarse, fine] = [0, 1].map(|row: usize| found.rows[row].setting);
    assert_eq!((coarse.segments, coarse.rings, fine.segments), (8, 4, 32));
    scene.camera.projection = Projection::Orthographic;
    let found = study(&Subject::new(scene.clone()), &request, &unwatched);
    assert_eq!(
        (found.rows.len(), found.omitted.len()),
        (2 * Method::VALUES.len(), 0)
    );
}

#[test]
fn the_middle_of_samples_is_their_median_and_quartiles() {
    for (samples, expected) in [
        (
            &mut [5_000_000, 1_000_000, 3_000_000, 2_000_000, 4_000_000][..],
            (3.0, 2.0),
        ),
        (&mut [2_000_000, 1_000_000], (1.5, 0.5)),
        (
            &mut [4_000_000, 1_000_000, 2_000_000, 3_000_000],
            (2.5, 1.5),
        ),
        (&mut [7_000_000], (7.0, 0.0)),
        (&mut [], (0.0, 0.0)),
    ] {
        assert_eq!(median_and_spread(samples), expected);
    }
}
