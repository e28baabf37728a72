//! Where a scene's own law loses digits: the operation that a textbook names, and no other.

use crate::stability::program;
use glam::{DVec3, Vec3};
use shading_lab::analysis::stability::{HALF_A_CODE_VALUE, LawStability, law_stability};
use shading_lab::analysis::unwatched;
use shading_lab::geometry::tessellate;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Light, LightKind, ObjectKind, PatternKind, Projection, ReflectionModel, Rgb, Scene,
    ShadingMode, Viewer, presets,
};
use std::sync::Arc;

/// Side of the pictures, pixels.
const SIDE: u32 = 64;
/// Colour of a pixel where digits are lost, and of one where an operation is undefined.
const LOST: [u8; 4] = [255, 0, 255, 255];
const UNDEFINED: [u8; 4] = [255, 170, 0, 255];

/// Returns the unit sphere lit and seen from +z by parallel rays, of which the picture shows a square of this side about its
/// middle: there N·L = N·V = √(1 − r²) and R·V = 1 − 2r², r the distance from the axis.
fn sphere(formula: &str, side: f64) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [SIDE; 2];
    scene.object.kind = ObjectKind::Sphere;
    scene.shading.mode = ShadingMode::Exact;
    (scene.camera.eye, scene.camera.target) = (DVec3::new(0.0, 0.0, 4.0), DVec3::ZERO);
    scene.camera.up = DVec3::Y;
    (scene.camera.projection, scene.camera.viewer) = (Projection::Orthographic, Viewer::Infinite);
    scene.camera.height = side;
    scene.ambient.color = Rgb::ZERO;
    scene.lights = vec![towards(DVec3::NEG_Z)];
    with(scene, formula)
}

fn towards(direction: DVec3) -> Light {
    Light {
        kind: LightKind::Directional,
        direction,
        ..Light::default()
    }
}

fn with(mut scene: Scene, formula: &str) -> Scene {
    scene.reflection.model = ReflectionModel::Formula;
    scene.reflection.formula = formula.to_owned();
    scene.validate().expect("a law");
    scene
}

fn examined(scene: &Scene) -> LawStability {
    let mut renderer = Renderer::default();
    let law = law_stability(&mut renderer, scene, &unwatched).expect("a law");
    let count = |colour| {
        let marked = law.picture.pixels.iter().filter(|pixel| **pixel == colour);
        marked.count() as u64
    };
    // Every pixel that is off is marked, and has one operation.
    assert_eq!(count(LOST), law.single.off, "{law:?}");
    assert_eq!(
        law.losses.iter().map(|of| of.pixels).sum::<u64>(),
        law.single.off
    );
    assert_eq!(law.losses.is_empty(), law.single.error <= HALF_A_CODE_VALUE);
    for of in &law.losses {
        assert!(of.error > HALF_A_CODE_VALUE && of.error <= law.single.error);
        assert_eq!(law.picture.pixel(of.at[0], of.at[1]), Some([255, 0, 255]));
    }
    law
}

#[test]
fn the_operation_that_loses_the_digits_is_named_and_no_other() {
    // The law, the side of the picture in which its value is between 0 and 1, and the operation.
    let cases = [
        ("1e5 * (1 - (N·L)^2)", 4e-3, "1 - (N·L)^2"),
        ("x = N·L\n1e5 * (1 - x*x)", 4e-3, "1 - x*x"),
        (
            "square = (N·L)^2\n0.5 * square^2 + 1e5 * (1 - square)",
            3e-3,
            "1 - square",
        ),
        // Neither the root, which halves the relative error, nor the factor.
        ("x = N·L\n1000 * sqrt(1 - x^2)", 1e-3, "1 - x^2"),
        // Not the cancellation in R·V = 2(N·L)(N·V) − L·V, which only triples the error.
        ("max(R·V, 0)^1000000", 3e-3, "max(R·V, 0)^1000000"),
        ("max(R·V, 0)^n", 3e-3, "max(R·V, 0)^n"),
        ("100 * acos(min(N·L, 1))", 2e-4, "acos(min(N·L, 1))"),
        ("100 * theta", 2e-4, "theta"),
        (
            "1e5 * (cos(theta)^2 + sin(theta)^2 - 1)",
            1.2,
            "cos(theta)^2 + sin(theta)^2 - 1",
        ),
        ("1e6 * (1 - N·L)", 2e-3, "1 - N·L"),
        ("1e6 * log(N·L)", 2e-3, "log(N·L)"),
    ];
    for (formula, side, operation) in cases {
        let mut scene = sphere(formula, side);
        scene.material.n = 1e6;
        let law = examined(&scene);
        println!(
            "{formula}: {} of {} pixels off by up to {}: {:?}",
            law.single.off, law.pixels, law.single.error, law.losses
        );
        let named: Vec<&str> = law.losses.iter().map(|of| of.operation.as_str()).collect();
        assert_eq!(named, [operation], "{formula}: {law:?}");
        assert_eq!(law.pixels, u64::from(SIDE * SIDE), "{formula}");
        assert!(law.single.off > 100, "{formula}: {}", law.single.off);
        assert_eq!(law.double.off, 0, "{formula}: {}", law.double.error);
        assert!(law.losses[0].condition > 1e4, "{formula}: {law:?}");
        assert!(law.undefined.is_empty(), "{formula}: {law:?}");
    }
}

#[test]
fn the_place_in_the_text_is_that_of_the_operation() {
    let law = examined(&sphere("x = N·L\ny = 2\n 1e5 * (1 - x*x)", 4e-3));
    let [loss] = &law.losses[..] else {
        panic!("{law:?}");
    };
    assert_eq!((loss.line, loss.column), (3, 9));
    // Near the axis 1 − c² is below the spacing of numbers near 1.
    let [x, y] = loss.at;
    assert!(x < SIDE && y < SIDE);
}

/// The condition number of the subtraction in 1 − c² is c²/(1 − c²), that of the power n: at the pixel of the worst error.
#[test]
fn condition_numbers_are_those_of_the_closed_forms() {
    let side = 4e-3;
    let radius = |[x, y]: [u32; 2]| {
        let from_middle =
            |place: u32| (f64::from(place) + 0.5 - f64::from(SIDE) / 2.0) * side / f64::from(SIDE);
        from_middle(x).hypot(from_middle(y))
    };
    let law = examined(&sphere("1e5 * (1 - (N·L)^2)", side));
    let r = radius(law.losses[0].at);
    let expected = (1.0 - r * r) / (r * r);
    let found = law.losses[0].condition;
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
    let mut scene = sphere("max(R·V, 0)^n", 3e-3);
    scene.material.n = 1e6;
    let found = examined(&scene).losses[0].condition;
    assert!((found / 1e6 - 1.0).abs() < 1e-12, "{found}");
}

#[test]
fn laws_of_the_textbook_lose_nothing() {
    let laws = [
        shading_lab::scene::Reflection::PHONG,
        "h = normalize(L + V)\nkd * od * max(N·L, 0) + ks * os * max(dot(N, h), 0)^n * (N·L > 0)",
        "kd * od * max(N·L, 0)",
        "kd * od * N·L",
        "(1 + N·L) / 2",
        "r = 2*(N·L)*N - L\nmax(dot(r, V), 0)^20",
        "t = max(R·V, 0)\nt / (20 - 20*t + t)",
    ];
    for formula in laws {
        for preset in ["sphere", "teapot", "three-lights", "balls"] {
            for mode in [ShadingMode::Gouraud, ShadingMode::Phong, ShadingMode::Flat] {
                let mut scene = presets::find(preset).expect("a built-in scene").scene();
                (scene.image.size, scene.shading.mode) = ([SIDE; 2], mode);
                scene.material.n = 20.0;
                let law = examined(&with(scene, formula));
                assert!(law.pixels > 500, "{preset}");
                assert!(
                    law.single.off == 0 && law.losses.is_empty() && law.undefined.is_empty(),
                    "{preset} {mode:?} {formula}: {law:?}"
                );
                assert!(law.single.error < 0.1 && law.double.error < 1e-6);
            }
        }
    }
}

/// Returns the pixels of the whole sphere, from top left, that satisfy a condition on x and y.
fn pixels_where(side: f64, holds: impl Fn(f64, f64) -> bool) -> Vec<[u32; 2]> {
    let at = |place: u32| (f64::from(place) + 0.5 - f64::from(SIDE) / 2.0) * side / f64::from(SIDE);
    let all = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| [x, y]));
    all.filter(|[x, y]| at(*x).hypot(at(*y)) < 1.0 && holds(at(*x), -at(*y)))
        .collect()
}

#[test]
fn undefined_operations_are_counted_exactly() {
    let side = 2.2;
    // (the law, the operation, where it is undefined under light from +x)
    type Where = fn(f64, f64) -> bool;
    let cases: [(&str, &str, Where); 5] = [
        ("1/(N·L > 0)", "1/(N·L > 0)", |x, _| x < 0.0),
        ("kd * sqrt(N·L)", "sqrt(N·L)", |x, _| x < 0.0),
        ("log(N·L - 0.3)", "log(N·L - 0.3)", |x, _| x < 0.3),
        ("(N·L)^0.3", "(N·L)^0.3", |x, _| x < 0.0),
        ("asin(2 * N·L)/90", "asin(2 * N·L)", |x, _| x.abs() > 0.5),
    ];
    for (formula, operation, holds) in cases {
        let mut scene = sphere(formula, side);
        scene.lights = vec![towards(DVec3::NEG_X)];
        let law = examined(&scene);
        let expected = pixels_where(side, holds);
        let [undefined] = &law.undefined[..] else {
            panic!("{formula}: {law:?}");
        };
        assert_eq!(undefined.operation, operation);
        assert_eq!(undefined.pixels, expected.len() as u64, "{formula}");
        assert_eq!(Some(&undefined.at), expected.first(), "{formula}");
        assert_eq!(law.single.off, 0, "{formula}: 0 in all precisions");
        for [x, y] in &expected {
            let place = (y * SIDE + x) as usize;
            assert_eq!(law.picture.pixels[place], UNDEFINED, "{formula} {x} {y}");
        }
        let marked = law.picture.pixels.iter();
        assert_eq!(marked.filter(|p| **p == UNDEFINED).count(), expected.len());
        // What the result does not use is not evaluated.
        let unused = format!("unused = {formula}\nmax(N·L, 0)");
        scene.reflection.formula = unused;
        assert!(examined(&scene).undefined.is_empty());
    }
}

/// Od is the material's, that of a pattern in its place, and either times the colours of a model's vertices.
#[test]
fn the_colour_is_that_of_the_point() {
    let mut scene = sphere("N·L", 2.2);
    scene.object.segments = 16;
    scene.material.color = Rgb::splat(0.8);
    scene.pattern.color = Rgb::splat(0.5);
    let mut patterned = scene.clone();
    patterned.pattern.kind = PatternKind::Checker;
    let mut mesh = tessellate(&scene.object);
    mesh.colors = vec![Vec3::splat(0.25); mesh.positions.len()];
    mesh.corner_colors = mesh.corners.iter().map(|corner| corner.position).collect();
    let tinted = |scene: &Scene| {
        let mut scene = scene.clone();
        (scene.object.kind, scene.object.path) = (ObjectKind::Obj, Some("model.obj".into()));
        scene
    };
    let cases = [
        (tinted(&scene), [0.2, 0.2]),
        (tinted(&patterned), [0.125, 0.2]),
        (scene, [0.8, 0.8]),
        (patterned, [0.5, 0.8]),
    ];
    for (scene, colours) in cases {
        let mut renderer = Renderer::default().with_model(Some(Arc::new(mesh.clone())));
        let mut undefined_up_to = |bound: f64| {
            let scene = with(scene.clone(), &format!("1/(od > {bound})"));
            let law = law_stability(&mut renderer, &scene, &unwatched).expect("a law");
            let undefined: u64 = law.undefined.iter().map(|of| of.pixels).sum();
            undefined as f64 / law.pixels as f64
        };
        let [least, most] = colours;
        assert_eq!(undefined_up_to(least - 0.01), 0.0, "{colours:?}");
        assert_eq!(undefined_up_to(most + 0.01), 1.0, "{colours:?}");
        let between = undefined_up_to(least + 0.01);
        assert_eq!(between < 1.0, least < most, "{colours:?}: {between}");
        assert!(between > 0.2, "{colours:?}: {between}");
    }
}

#[test]
fn a_scene_without_an_own_law_has_nothing_to_examine_and_work_can_be_stopped() {
    let mut renderer = Renderer::default();
    let refused = law_stability(&mut renderer, &Scene::default(), &unwatched);
    assert!(refused.is_err_and(|why| why.contains("reflection.model")));
    let scene = sphere("N·L", 2.2);
    let whole = examined(&scene).pixels;
    let part = law_stability(&mut renderer, &scene, &|share| share < 0.5).expect("a law");
    assert!(0 < part.pixels && part.pixels < whole, "{}", part.pixels);
}

/// Every shading mode, several lights with shadows, materials of a model: the pixels that are off have an operation.
#[test]
fn every_pixel_that_is_off_has_an_operation_in_any_scene() {
    let mut lost = 0;
    for preset in presets::ALL {
        let mut scene = preset.scene();
        scene.image.size = [48, 48];
        let law = examined(&with(scene, "1e5 * ((1 + N·L) - 1 - N·L)"));
        lost += law.single.off;
    }
    assert!(lost > 0);
}

#[test]
fn the_command_line_examines_the_law_of_a_scene() {
    let folder = std::env::temp_dir().join(format!("shading-lab-law-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = |name: &str| folder.join(name).to_str().expect("Unicode").to_owned();
    let scene = sphere("1e5 * (1 - (N·L)^2)", 4e-3);
    std::fs::write(path("law.toml"), scene.to_toml()).expect("a file");
    let (status, out, err) = program(&["stability", &path("law.toml"), "--json"]);
    assert_eq!((status, err.as_str()), (Some(0), ""));
    let told: serde_json::Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!(told["cases"].as_array().map(Vec::len), Some(0));
    let loss = &told["law"]["losses"][0];
    assert_eq!(loss["operation"], "1 - (N·L)^2");
    assert_eq!(loss["pixels"], told["law"]["single"]["off"]);

    let (picture, table) = (path("law.png"), path("law.csv"));
    let words = [
        "stability",
        &path("law.toml"),
        "-o",
        &picture,
        "--csv",
        &table,
    ];
    assert_eq!(program(&words), (Some(0), String::new(), String::new()));
    let table = std::fs::read_to_string(&table).expect("a table");
    assert_eq!(table.lines().count(), 2);
    assert!(table.starts_with("kind,operation,line,column,pixels,error,condition,x,y"));
    let opened = shading_lab::document::load_scene(std::path::Path::new(&picture));
    assert_eq!(opened.expect("a picture with its scene").scene, scene);

    let (status, out, _) = program(&["stability", &path("law.toml")]);
    assert!(status == Some(0) && out.contains("1 - (N·L)^2"), "{out}");
    // A scene of another model, and cases of a scene, are refused.
    let (status, out, err) = program(&["stability", "teapot"]);
    assert_eq!((status, out.as_str()), (Some(2), ""));
    assert!(err.contains("reflection.model"), "{err}");
    let (status, ..) = program(&["stability", "teapot", "--case", "w-0"]);
    assert_eq!(status, Some(2));
    let _ = std::fs::remove_dir_all(&folder);
}
