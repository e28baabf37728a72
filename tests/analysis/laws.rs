//! A study of a scene's own law beside a reference law: the error of each, what the law alone changes, and the operations.

use crate::study::run;
use glam::DVec3;
use serde_json::Value;
use shading_lab::analysis::report::{Answer, Part, ReportContext};
use shading_lab::analysis::study::{Method, Study, StudyQuestion, StudyRow, study, study_plot};
use shading_lab::analysis::{Subject, unwatched};
use shading_lab::illumination::law_operations;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Interpolation, Light, LightKind, ObjectKind, Projection, ReflectionModel, Rgb, Scene,
    ShadingMode, presets,
};

/// R·V without R, as the papers count it.
const PHONG: &str = "kd*od*max(N·L, 0) + ks*os*max(2*(N·L)*(N·V) - L·V, 0)^n";
const SCHLICK: &str = "t = max(2*(N·L)*(N·V) - L·V, 0)\nkd*od*max(N·L, 0) + ks*os*t/(n - n*t + t)";

/// Returns a sphere without perspective whose law is the formula.
fn typed(formula: &str) -> Scene {
    let mut scene = presets::find("sphere").expect("a scene").scene();
    scene.image.size = [128, 128];
    scene.camera.projection = Projection::Orthographic;
    scene.material.n = 20.0;
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        direction: DVec3::new(-0.4, -0.3, -1.0),
        ..Light::default()
    }];
    scene.reflection.model = ReflectionModel::Formula;
    scene.reflection.formula = formula.to_owned();
    scene
}

fn question(methods: &[Method], reference: Option<ReflectionModel>) -> StudyQuestion {
    StudyQuestion {
        methods: methods.to_vec(),
        segments: vec![16, 64],
        interpolations: vec![Interpolation::Perspective],
        repeats: 1,
        reference,
        ..StudyQuestion::default()
    }
}

fn measured(scene: &Scene, methods: &[Method], reference: Option<ReflectionModel>) -> Study {
    let subject = Subject::new(scene.clone());
    study(&subject, &question(methods, reference), &unwatched)
}

fn of(study: &Study, law: ReflectionModel) -> Vec<&StudyRow> {
    let rows = study.rows.iter();
    rows.filter(|row| row.setting.law == Some(law)).collect()
}

/// Half a code value.
const HALF: f64 = 0.5 / 255.0;

#[test]
fn phongs_law_typed_has_the_errors_of_phongs_law() {
    let methods = [
        Method::Gouraud,
        Method::Phong,
        Method::PhongScalar,
        Method::Angular,
    ];
    let found = measured(&typed(PHONG), &methods, None);
    assert_eq!(found.reference, Some(ReflectionModel::Phong));
    let (own, phong) = (
        of(&found, ReflectionModel::Formula),
        of(&found, ReflectionModel::Phong),
    );
    assert_eq!((own.len(), phong.len()), (8, 8));
    for (own, phong) in own.into_iter().zip(phong) {
        assert_eq!(own.setting.method, phong.setting.method);
        assert!((own.error_rms - phong.error_rms).abs() < 1e-4, "{own:?}");
        assert!(own.law_rms.is_some_and(|rms| rms < 1e-4), "{own:?}");
        assert_eq!(phong.law_rms, None, "it is the reference");
        let total = |row: &StudyRow| row.operations.expect("counts").iter().sum::<u32>();
        assert_eq!(total(own), total(phong), "{own:?}");
    }
}

/// Checks the difference of two laws by a picture of each, over a plane that fills the middle of the picture, so that all of it counts.
#[test]
fn the_difference_of_two_laws_is_that_of_their_pictures() {
    let mut scene = typed(SCHLICK);
    scene.object.kind = ObjectKind::Plane;
    scene.camera.viewer = shading_lab::scene::Viewer::Local;
    scene.camera.projection = Projection::Perspective;
    scene.camera.eye = DVec3::new(0.0, 0.0, 4.0);
    scene.camera.target = DVec3::ZERO;
    let found = measured(&scene, &[Method::Phong], None);
    let row = &of(&found, ReflectionModel::Formula)[0];
    let picture = |model: ReflectionModel| {
        let mut drawn = scene.clone();
        (drawn.object.segments, drawn.object.rings) = (row.setting.segments, row.setting.rings);
        drawn.shading.mode = ShadingMode::Phong;
        drawn.reflection.model = model;
        let mut renderer = Renderer::default();
        renderer.keep_linear(true);
        renderer.render(&drawn);
        renderer.linear().to_vec()
    };
    let [own, phong] = [ReflectionModel::Formula, ReflectionModel::Phong].map(picture);
    let (mut sum, mut count) = (0.0, 0_u64);
    for (a, b) in own.iter().zip(&phong).filter(|(a, _)| a[3] > 0.0) {
        for channel in 0..3 {
            sum += f64::from(a[channel] - b[channel]).powi(2);
        }
        count += 1;
    }
    let expected = (sum / (3 * count) as f64).sqrt();
    let rms = row.law_rms.expect("another law");
    assert_eq!(row.interior_pixels, count);
    assert!(
        (rms / expected - 1.0).abs() < 1e-3,
        "{rms} is not {expected}"
    );
    assert!(rms > HALF, "the two differ visibly: {rms}");
    let blinn = measured(&scene, &[Method::Phong], Some(ReflectionModel::Blinn));
    let other = of(&blinn, ReflectionModel::Formula)[0]
        .law_rms
        .expect("another law");
    assert!((other - rms).abs() > HALF, "{other}: another reference");
}

/// Checks that a law's own difference stays, however fine the mesh, while the reference's error goes.
#[test]
fn no_mesh_is_fine_enough_for_another_law() {
    let found = measured(&typed(SCHLICK), &[Method::Phong], None);
    let (own, phong) = (
        of(&found, ReflectionModel::Formula)[1],
        of(&found, ReflectionModel::Phong)[1],
    );
    let rms = own.law_rms.expect("another law");
    assert!((own.error_rms / rms - 1.0).abs() < 0.05, "{own:?}");
    assert!(phong.error_rms < 0.1 * own.error_rms, "{phong:?}");
}

#[test]
fn operations_are_those_of_the_laws_code() {
    let count = |formula: &str| law_operations(&typed(formula)).expect("a law");
    // N·L: 3 multiplications and 2 additions; a factor of the frame.
    assert_eq!(count("kd*od*max(N·L, 0)"), [2, 4, 0, 0]);
    // N·V as well, 2(N·L)(N·V) less L·V; both factors, the power, the sum.
    assert_eq!(count(PHONG), [6, 10, 0, 1]);
    // The power goes; n − n·t + t takes a multiplication and two additions, and divides.
    assert_eq!(count(SCHLICK), [8, 11, 1, 0]);
    // A power of small whole exponent is a product.
    assert_eq!(count("max(N·L, 0)^2"), [2, 4, 0, 0]);
    // H is the same everywhere, of N alone nothing is.
    assert_eq!(count("length(normalize(L + V))"), [0; 4]);
    assert_eq!(count("acos(N·L)/90"), [2, 4, 0, 1]);
    assert_eq!(count("sqrt(abs(N·L))/(1 + N·V)"), [5, 6, 2, 0]);
    let broken = law_operations(&typed("max(N, 0)"));
    assert!(broken.is_err(), "{broken:?}");
    // The channel that needs most counts: of black, red and green, nothing is left.
    let mut blue = typed(PHONG);
    blue.material.kd = Rgb::new(0.0, 0.0, 0.5);
    blue.material.ks = Rgb::new(0.0, 0.0, 0.5);
    assert_eq!(law_operations(&blue), Ok([6, 10, 0, 1]));
}

#[test]
fn taylors_method_draws_no_law_of_ones_own() {
    let found = measured(&typed(SCHLICK), &[Method::Taylor], None);
    let omitted: Vec<_> = found
        .omitted
        .iter()
        .map(|own| (own.method, own.law))
        .collect();
    assert_eq!(omitted, [(Method::Taylor, Some(ReflectionModel::Formula))]);
    assert_eq!(
        found.omitted[0].reason.text(),
        english!("engine-cannot-cosine")
    );
    assert!(of(&found, ReflectionModel::Formula).is_empty());
    assert_eq!(of(&found, ReflectionModel::Phong).len(), 2);
}

#[test]
fn one_law_is_measured_as_before() {
    let plain = presets::find("sphere").expect("a scene").scene();
    let mut own = plain.clone();
    own.reflection.model = ReflectionModel::Formula;
    for (scene, reference) in [
        (&plain, None),
        (&plain, Some(ReflectionModel::Phong)),
        (&own, Some(ReflectionModel::Formula)),
    ] {
        let found = measured(scene, &[Method::Flat], reference);
        assert_eq!((found.rows.len(), found.reference), (2, None));
        let row = &found.rows[0];
        assert_eq!((row.setting.law, row.law_rms), (None, None));
        let title = found.title(&row.setting);
        assert_eq!(title, format!("{} 16×8", english!("choice-method-flat")));
    }
}

/// Checks that a row that is shown in the picture leaves the study's results valid, and another law does not.
#[test]
fn a_study_is_about_its_two_laws() {
    let scene = typed(SCHLICK);
    let found = measured(&scene, &[Method::Phong], None);
    let asked = question(&[Method::Phong], None);
    let mut shown = scene.clone();
    assert!(
        of(&found, ReflectionModel::Phong)[0]
            .setting
            .load(&mut shown)
    );
    assert_eq!(shown.reflection.model, ReflectionModel::Phong);
    assert!(asked.same(&scene, &shown));
    shown.reflection.model = ReflectionModel::Blinn;
    assert!(!asked.same(&scene, &shown));
    assert!(!asked.same(&scene, &typed(PHONG)));
    let alone = question(&[Method::Phong], Some(ReflectionModel::Formula));
    shown.reflection.model = ReflectionModel::Phong;
    assert!(!alone.same(&scene, &shown));
}

#[test]
fn points_and_front_have_the_laws_name() {
    let mut scene = typed(SCHLICK);
    scene.about.title = "Highlight by a fraction".to_owned();
    let mut found = measured(&scene, &[Method::Phong], None);
    let front = |study: &Study| {
        let plot = study_plot(study).expect("a plot");
        let points: Vec<_> = plot.points.iter().map(|point| point.name.clone()).collect();
        (plot.curves[0].name.clone(), points.join("; "))
    };
    for (index, row) in found.rows.iter_mut().enumerate() {
        row.time_ms = 1.0 + index as f64;
        row.pareto = row.setting.law == Some(ReflectionModel::Phong);
    }
    let (name, points) = front(&found);
    assert_eq!(name, english!("engine-front"));
    assert!(points.contains(&scene.about.title), "{points}");
    found.rows[0].pareto = true;
    let own = english!("engine-front-law", law = scene.about.title.as_str());
    assert_eq!(front(&found).0, own);
    // A built-in scene's title is not the name of a law that is typed into it.
    let mut changed = scene.clone();
    changed.about.title = presets::find("sphere")
        .expect("a scene")
        .scene()
        .about
        .title;
    assert_eq!(measured(&changed, &[Method::Phong], None).own_law, "");
    assert_eq!(found.own_law, scene.about.title);
}

#[test]
fn tables_and_files_have_the_law_and_its_operations() {
    let scene = typed(SCHLICK);
    let found = measured(&scene, &[Method::Phong], None);
    let about = ReportContext {
        name: "own",
        scene: &scene,
    };
    let report = found.report(&about);
    let parts = report.sections.iter().flat_map(|section| &section.parts);
    let table = parts.into_iter().find_map(|part| match part {
        Part::Table(table) => Some(table),
        _ => None,
    });
    let table = table.expect("a table");
    let (heads, rows, _) = table.for_people(0);
    let place = |head: &str| heads.iter().position(|own| *own == head).expect("a column");
    let powers: Vec<_> = rows.iter().map(|row| row[place("x^n")].as_str()).collect();
    assert_eq!(powers, ["0", "0", "1", "1"]);
    let csv = table.to_csv();
    let mut lines = csv.lines();
    let ends = |line: Option<&str>, end: &str| line.is_some_and(|line| line.ends_with(end));
    assert!(
        ends(
            lines.next(),
            ",law,law_rms,additions,multiplications,divisions,powers"
        ),
        "{csv}"
    );
    assert!(ends(lines.next(), ",14,17,3,0"), "{csv}");
    assert!(ends(lines.nth(1), ",phong,,12,16,2,1"), "{csv}");
    let value = found.value(&about);
    assert_eq!(value["reference"], "phong");
    assert_eq!(value["rows"][0]["law"], "formula");
    assert_eq!(value["rows"][0]["operations"]["divisions"], 3);
    assert_eq!(value["rows"][2]["law_rms"], Value::Null);
    assert_eq!(value["pixel_cost"]["phong"]["multiplications"], 16);
}

#[test]
fn the_command_takes_a_reference() {
    let scene = [
        "sphere",
        "--size",
        "32x32",
        "--segments",
        "8",
        "--repeats",
        "1",
        "--methods",
        "phong",
        "--interpolation",
        "perspective",
        "--json",
        "--set",
        "reflection.model=formula",
    ];
    let with = |more: &[&str]| run(&[&scene[..], more].concat());
    for (reference, laws) in [
        (&[][..], &["formula", "phong"][..]),
        (&["--reference", "blinn"], &["formula", "blinn"]),
    ] {
        let (status, out, err) = with(reference);
        assert_eq!((status, err.as_str()), (Some(0), ""));
        let value: Value = serde_json::from_str(&out).expect("JSON");
        let rows = value["rows"].as_array().expect("rows");
        let found: Vec<_> = rows.iter().filter_map(|row| row["law"].as_str()).collect();
        assert_eq!(found, laws);
    }
    let (status, out, _) = with(&["--reference", "formula"]);
    let value: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(
        (status, value["rows"].as_array().map(Vec::len)),
        (Some(0), Some(1))
    );
    assert_eq!(with(&["--reference", "lambert"]).0, Some(2));
}
