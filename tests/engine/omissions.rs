//! Steps that the plan leaves out: none would change a stored pixel.

use crate::common::tries::tries;
use glam::DVec3;
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use shading_lab::analysis::probe::probe;
use shading_lab::render::{Frame, Per, Renderer, Term};
use shading_lab::scene::{
    Attenuation, Backfacing, Choice, CuedBy, Distribution, Interpolation, Light, LightKind,
    NormalSource, ObjectKind, Projection, Reflectance, ReflectionModel, Rgb, Scene, ShadingMode,
    Viewer, presets,
};
use shading_lab::text::Message;

/// Draws the picture by the plan, and with everything left in.
fn both(scene: &Scene) -> (Frame, Frame) {
    let mut renderer = Renderer::default();
    let planned = renderer.render(scene).clone();
    renderer.leave_nothing_out(true);
    let all = renderer.render(scene).clone();
    (planned, all)
}

/// Returns how many pixels differ, and the first with both its colours.
fn difference(scene: &Scene) -> Option<String> {
    let (planned, all) = both(scene);
    let mut pairs = planned
        .pixels
        .iter()
        .zip(&all.pixels)
        .enumerate()
        .filter(|(_, (a, b))| a != b);
    let width = planned.width as usize;
    let (index, (a, b)) = pairs.next()?;
    Some(format!(
        "{} pixels, {},{}: planned {a:?}, all {b:?}",
        1 + pairs.count(),
        index % width,
        index / width
    ))
}

#[test]
fn every_built_in_scene_is_the_same_in_every_mode() {
    let mut wrong = Vec::new();
    for preset in presets::ALL {
        for &mode in ShadingMode::VALUES {
            let mut scene = preset.scene();
            scene.image.size = [96, 96];
            scene.shading.mode = mode;
            if let Some(difference) = difference(&scene) {
                wrong.push(format!("{} {mode:?}: {difference}", preset.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

fn pick<T: Clone + std::fmt::Debug + 'static>(values: &[T]) -> impl Strategy<Value = T> + use<T> {
    prop::sample::select(values.to_vec())
}

fn part() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.0), 3 => 0.0..1.2_f64]
}

fn colour() -> impl Strategy<Value = Rgb> {
    prop_oneof![1 => Just(Rgb::ZERO), 2 => Just(Rgb::ONE), 3 => (part(), part(), part()).prop_map(|(r, g, b)| Rgb::new(r, g, b))]
}

fn place(reach: f64) -> impl Strategy<Value = DVec3> {
    (-reach..reach, -reach..reach, -reach..reach).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn light() -> impl Strategy<Value = Light> {
    let kind = pick(&[
        LightKind::Point,
        LightKind::Directional,
        LightKind::Spot,
        LightKind::Spot,
        LightKind::Area,
    ]);
    let falloff = pick(&[
        Attenuation::None,
        Attenuation::None,
        Attenuation::Viewer,
        Attenuation::Light,
        Attenuation::Quadratic,
        Attenuation::InverseSquare,
    ]);
    let switched = (0..8_u8, 0..12_u8);
    (
        kind,
        place(6.0),
        place(1.0),
        colour(),
        falloff,
        2.0..70.0_f64,
        part(),
        switched,
    )
        .prop_map(
            |(kind, position, direction, color, attenuation, cone, softness, (muted, soloed))| {
                Light {
                    kind,
                    position,
                    direction: if direction.length() > 0.01 {
                        direction
                    } else {
                        DVec3::NEG_Y
                    },
                    color,
                    attenuation,
                    cone,
                    softness: softness.min(1.0),
                    samples: 5,
                    mute: muted == 0,
                    solo: soloed == 0,
                    ..Light::default()
                }
            },
        )
}

/// Generates scenes with much to leave out.
fn scene() -> impl Strategy<Value = Scene> {
    let shapes: Vec<_> = ObjectKind::VALUES
        .iter()
        .copied()
        .filter(|kind| kind.has_surface())
        .collect();
    let kind = pick(&shapes);
    let normals = pick(&[
        NormalSource::Averaged,
        NormalSource::Exact,
        NormalSource::Facet,
    ]);
    let object = (
        kind,
        3..24_u32,
        3..16_u32,
        normals,
        place(4.5),
        any::<[bool; 4]>(),
    );
    let material = (
        colour(),
        colour(),
        colour(),
        pick(&[0.0, 1.0, 7.5, 40.0, 64.0, 300.0, 1e5]),
        colour(),
    );
    let models = pick(&[
        ReflectionModel::Phong,
        ReflectionModel::Blinn,
        ReflectionModel::CookTorrance,
    ]);
    let law = (
        models,
        pick(Distribution::VALUES),
        pick(&[Reflectance::Constant, Reflectance::Gold]),
    );
    let rule = pick(Interpolation::VALUES);
    let shading = (pick(ShadingMode::VALUES), rule, any::<[bool; 5]>(), part());
    (
        object,
        material,
        law,
        shading,
        prop::collection::vec(light(), 0..4),
    )
        .prop_map(
            |((kind, segments, rings, normals, eye, around), material, law, shading, lights)| {
                let mut scene = Scene::default();
                scene.image.size = [32, 32];
                (scene.object.kind, scene.object.segments, scene.object.rings) =
                    (kind, segments, rings);
                scene.object.normals = normals;
                scene.camera.eye = if eye.length() > 0.5 {
                    eye
                } else {
                    DVec3::new(0.3, 0.2, 3.0)
                };
                scene.camera.projection = if around[0] {
                    Projection::Perspective
                } else {
                    Projection::Orthographic
                };
                scene.camera.viewer = if around[1] {
                    Viewer::Local
                } else {
                    Viewer::Infinite
                };
                (scene.shading.shadows, scene.ground.visible) = (around[2], around[2] && around[3]);
                let m = &mut scene.material;
                (m.ka, m.kd, m.ks, m.n, m.color) = material;
                (
                    scene.reflection.model,
                    scene.reflection.distribution,
                    scene.material.reflectance,
                ) = law;
                let (mode, interpolation, [renormalise, flip, cued, _, _], kt) = shading;
                (scene.shading.mode, scene.shading.interpolation) = (mode, interpolation);
                scene.shading.renormalise = renormalise;
                scene.reflection.backfacing = if flip {
                    Backfacing::Flip
                } else {
                    Backfacing::Clamp
                };
                scene.depth_cueing.by = if cued { CuedBy::Pixel } else { CuedBy::Off };
                scene.transparency.kt = if kt > 0.9 { 0.5 } else { 0.0 };
                scene.lights = lights;
                scene
            },
        )
}

fn random_scenes(cases: u32) {
    let config = ProptestConfig {
        cases,
        max_global_rejects: 10 * cases,
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let mut runner =
        TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let result = runner.run(&scene(), |scene| {
        prop_assume!(scene.validate().is_ok());
        let difference = difference(&scene);
        prop_assert!(difference.is_none(), "{difference:?}\n{}", scene.to_toml());
        Ok(())
    });
    assert!(
        result.is_ok(),
        "{}",
        result
            .err()
            .map(|error| error.to_string())
            .unwrap_or_default()
    );
}

#[test]
fn ten_thousand_random_scenes_are_the_same() {
    random_scenes(tries(10_000) as u32);
}

fn terms(scene: &Scene) -> Vec<Term> {
    let mut renderer = Renderer::default();
    renderer.render(scene);
    renderer.terms()
}

/// Finds a term of a light, counted from 1, by the key of its name; light 0 is the whole picture.
fn find<'a>(terms: &'a [Term], light: usize, part: &str) -> &'a Term {
    let (light, name) = (light.checked_sub(1), english!(part));
    terms
        .iter()
        .find(|term| term.name.light() == light && term.name.part() == name)
        .unwrap_or_else(|| panic!("no {name}"))
}

#[test]
fn reasons_and_counts_are_those_of_the_scene() {
    let mut scene = Scene {
        lights: vec![Light::default(); 3],
        ..Scene::default()
    };
    scene.image.size = [64, 64];
    scene.material.ks = Rgb::ZERO;
    scene.lights[1].mute = true;
    scene.lights[2] = Light {
        kind: LightKind::Spot,
        position: DVec3::new(0.0, 5.0, 0.0),
        direction: DVec3::Y,
        ..Light::default()
    };
    let mut renderer = Renderer::default();
    renderer.render(&scene);
    let (terms, covered) = (renderer.terms(), renderer.report().covered);
    assert_eq!(
        find(&terms, 2, "N·L").omitted,
        Some(Message("render-why-muted"))
    );
    assert_eq!(
        find(&terms, 3, "N·L").omitted,
        Some(Message("render-why-cone-misses"))
    );
    assert_eq!(
        find(&terms, 1, "render-term-specular").omitted,
        Some(Message("render-why-ks-zero"))
    );
    assert_eq!(
        find(&terms, 1, "render-term-attenuation").omitted,
        Some(Message("render-why-constant-attenuation"))
    );
    let diffuse = find(&terms, 1, "render-term-diffuse");
    assert_eq!((diffuse.per, diffuse.evaluations), (Per::Pixel, covered));
    assert_eq!(
        find(&terms, 0, "render-term-back-faces").omitted,
        Some(Message("render-why-closed-solid"))
    );
    renderer.leave_nothing_out(true);
    renderer.render(&scene);
    let all = renderer.terms();
    assert!(
        find(&all, 0, "render-term-back-faces").evaluations > 100
            && find(&all, 0, "render-term-coverage").evaluations > 3 * covered / 2
    );
    assert_eq!(find(&all, 2, "render-term-specular").evaluations, covered);
    assert!(
        terms
            .iter()
            .all(|term| term.omitted.is_none() || (term.per == Per::None && term.evaluations == 0))
    );
}

/// Rows of a band of the picture.
const BAND: u32 = 16;

/// Counts how often another face begins along the rows of the bands, from the faces that the pixels see; bands of a convex solid
/// are filled face by face.
fn faces_begun(renderer: &mut Renderer, scene: &Scene, convex: bool) -> u64 {
    let [width, height] = scene.image.size;
    let mut count = 0;
    for first in (0..height).step_by(BAND as usize) {
        let rows = first..height.min(first + BAND);
        let pixels = rows.flat_map(|y| (0..width).map(move |x| (x, y)));
        let mut faces: Vec<u32> = pixels
            .filter_map(|(x, y)| probe(renderer, scene, x, y).hit?.face)
            .collect();
        if convex {
            faces.sort_unstable();
        }
        faces.dedup();
        count += faces.len() as u64;
    }
    count
}

#[test]
fn flat_shading_rounds_once_for_each_polygon_that_begins() {
    let scene = |settings: &[&str]| {
        let flat = ["shading.mode=flat", "image.size=[48,40]"];
        let settings = [&flat[..], settings].concat();
        Scene::default()
            .with_overrides(&settings)
            .expect("settings")
    };
    let one = [
        "object.kind=plane",
        "object.segments=1",
        "object.rings=1",
        "image.size=[64,64]",
    ];
    for (settings, convex, expected) in [
        (&one[..], false, Some(4)),
        (&["object.kind=torus", "object.segments=9"], false, None),
        (
            &[
                "object.kind=corrugated",
                "object.segments=4",
                "object.rings=1",
                "shading.flat_at=vertex-mean",
            ],
            false,
            None,
        ),
        (&["object.kind=sphere", "object.segments=7"], true, None),
    ] {
        let scene = scene(settings);
        let mut renderer = Renderer::default();
        renderer.render(&scene);
        let term = find(&renderer.terms(), 0, "render-term-rounding").clone();
        let begun = faces_begun(&mut renderer, &scene, convex);
        assert_eq!(
            (term.per, term.evaluations),
            (Per::Face, begun),
            "{settings:?}"
        );
        assert!(expected.is_none_or(|expected| expected == begun), "{begun}");
    }
}

#[test]
fn an_area_light_counts_each_of_its_samples_and_gouraud_its_vertices() {
    let mut scene = Scene::default();
    scene.shading.mode = ShadingMode::Gouraud;
    scene.lights[0] = Light {
        kind: LightKind::Area,
        samples: 7,
        ..scene.lights[0].clone()
    };
    let mut renderer = Renderer::default();
    renderer.render(&scene);
    let vertices = renderer.report().vertices;
    let diffuse = find(&renderer.terms(), 1, "render-term-diffuse").clone();
    assert_eq!(
        (diffuse.per, diffuse.evaluations),
        (Per::Vertex, 7 * vertices)
    );
    scene.lights.clear();
    assert!(
        terms(&scene).iter().any(|term| term.name.to_string() == "V"
            && term.omitted == Some(Message("render-why-no-light")))
    );
}

/// Checks that a coefficient is said to be 0 only if it is.
#[test]
fn what_is_left_out_is_not_laid_on_a_coefficient_that_is_not_zero() {
    let mut scene = Scene::default();
    scene.image.size = [32, 32];
    scene.lights[0].color = Rgb::new(1.0, 0.0, 0.0);
    scene.material.specular_color = Rgb::new(0.0, 1.0, 0.0);
    let why = |scene: &Scene, light, part: &str| find(&terms(scene), light, part).omitted;
    assert_eq!(
        why(&scene, 1, "render-term-specular"),
        Some(Message("render-why-no-specular-colour"))
    );
    assert_eq!(
        why(&scene, 1, "render-term-cone"),
        Some(Message("render-why-no-spotlight"))
    );
    scene.material.specular_color = Rgb::ZERO;
    assert_eq!(
        why(&scene, 1, "render-term-specular"),
        Some(Message("render-why-ks-os-zero"))
    );
    scene.material.specular_color = Rgb::ONE;
    scene.material.color = Rgb::ZERO;
    assert_eq!(
        why(&scene, 1, "render-term-diffuse"),
        Some(Message("render-why-kd-od-zero"))
    );
    assert_eq!(
        why(&scene, 0, "render-term-ambient"),
        Some(Message("render-why-ka-zero"))
    );
    scene.material.ks = Rgb::ZERO;
    assert_eq!(
        (why(&scene, 0, "V"), why(&scene, 0, "render-term-shadows")),
        (
            Some(Message("render-why-no-light")),
            Some(Message("render-why-switched-off"))
        )
    );
    assert_eq!(
        why(&scene, 1, "render-term-specular"),
        Some(Message("render-why-not-reflected"))
    );
}
