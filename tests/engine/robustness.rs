//! Arbitrary scenes: each is refused with a reason, or drawn in finite numbers.

use crate::common::any_scene::{AnyScene, any_scene, everyday_scene};
use crate::common::reasons::Judge;
use crate::common::textbook::field_edge;
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use shading_lab::analysis::perception::luminance;
use shading_lab::analysis::probe::{Probe, ZeroCause, probe};
use shading_lab::analysis::profile::{ProfileQuestion, profile};
use shading_lab::render::{Renderer, srgb};
use shading_lab::scene::{
    Attenuation, Choice, Encoding, GREATEST_INTENSITY, Interpolation, Light, Material, ObjectKind,
    Overflow, PatternKind, Projection, ReflectionModel, Rgb, Scene, ShadingMode,
};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The outcome for a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fate {
    Drawn,
    Refused,
}

/// Draws the scene with this seed, or sees it refused; an error describes what went wrong.
fn examine(seed: u64) -> Result<Fate, String> {
    let any = any_scene(seed);
    let outcome = catch_unwind(AssertUnwindSafe(|| check_and_draw(&any))).unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<String>().cloned();
        Err(text
            .or(panic.downcast_ref::<&str>().map(|&text| text.to_owned()))
            .unwrap_or_default())
    });
    outcome.map_err(|what| format!("scene {seed}: {what}\n{}", any.scene.to_toml()))
}

fn check_and_draw(AnyScene { scene, model }: &AnyScene) -> Result<Fate, String> {
    if let Err(error) = scene.validate() {
        let named = error
            .problems()
            .iter()
            .all(|problem| !problem.key.is_empty());
        let explained = error
            .to_string()
            .lines()
            .all(|line| line.contains("expected"));
        return if named && explained {
            Ok(Fate::Refused)
        } else {
            Err(format!("refused by: {error}"))
        };
    }
    let model = match model {
        Ok(model) => model.clone(),
        Err(error) if error.is_empty() => return Err("a model refused without a reason".into()),
        Err(_) => return Ok(Fate::Refused),
    };
    let mut renderer = Renderer::default().with_model(model);
    for pane in 0..scene.pane_count() {
        let pane = scene
            .pane(pane)
            .map_err(|error| format!("pane {pane}: {error}"))?;
        draw(&mut renderer, &pane)?;
    }
    Ok(Fate::Drawn)
}

/// Draws a scene with every display setting, and probes it.
fn draw(renderer: &mut Renderer, scene: &Scene) -> Result<(), String> {
    renderer.keep_linear(true);
    renderer.render(scene);
    finite(renderer, "the picture")?;
    let [width, height] = scene.image.size;
    for [x, y] in [
        [width / 2, height / 2],
        [width / 3, height / 4],
        [width - 1, height - 1],
    ] {
        let probe = probe(renderer, scene, x, y);
        if let Some(what) = not_finite(&probe) {
            return Err(format!("the probe at {x},{y} has {what} in {probe:?}"));
        }
    }
    for &overflow in Overflow::VALUES {
        for &encoding in Encoding::VALUES {
            let mut shown = scene.clone();
            (shown.display.overflow, shown.display.encoding) = (overflow, encoding);
            for keep in [true, false] {
                renderer.keep_linear(keep);
                let opaque = renderer
                    .render(&shown)
                    .pixels
                    .iter()
                    .all(|pixel| pixel[3] == 255);
                let divisor = renderer.report().divisor;
                finite(renderer, &format!("{overflow:?}, {encoding:?}"))?;
                if !opaque || !(1.0..=f64::from(f32::MAX)).contains(&divisor) {
                    return Err(format!(
                        "{overflow:?}, {encoding:?}: divided by {divisor}, opaque: {opaque}"
                    ));
                }
            }
        }
    }
    renderer.render_supersampled(scene, 3, &mut |_| true);
    finite(renderer, "three samples a pixel")
}

fn finite(renderer: &Renderer, what: &str) -> Result<(), String> {
    match renderer
        .linear()
        .iter()
        .flatten()
        .position(|v| !v.is_finite())
    {
        None => Ok(()),
        Some(at) => Err(format!(
            "{what}: {:?} at pixel {}",
            renderer.linear()[at / 4],
            at / 4
        )),
    }
}

/// Returns the name of a value of a probe that is not finite, if there is one.
fn not_finite(probe: &Probe) -> Option<&'static str> {
    let hit = probe.hit.as_ref()?;
    let mut vectors = vec![
        ("the point", hit.position),
        ("N", hit.normal),
        ("V", hit.view),
        ("the ambient term", hit.ambient),
        ("Irefl", hit.reflected),
        ("I", hit.intensity),
        ("the sum", hit.sum),
        ("the fit", probe.ambient_fit.unwrap_or(Rgb::ZERO)),
    ];
    let mut numbers = vec![("the depth", hit.depth), ("the divisor", hit.divisor)];
    if let Some(cue) = hit.cue {
        vectors.extend([("what is kept", cue.kept), ("the veil", cue.veil)]);
        numbers.push(("s0", cue.scale));
    }
    if let Some(through) = hit.transmission {
        vectors.extend([("what is seen through", through.seen)]);
    }
    for light in &hit.lights {
        vectors.extend([
            ("L", light.l),
            ("R", light.r),
            ("H", light.h),
            ("W", light.reflectance),
        ]);
        vectors.extend([
            ("the diffuse term", light.diffuse),
            ("the specular term", light.specular),
        ]);
        let angles = [
            ("N·L", light.n_dot_l),
            ("θ", light.theta),
            ("φ", light.phi),
            ("α", light.alpha),
            ("the incidence", light.incidence),
        ];
        numbers.extend(angles);
        numbers.extend([
            ("f", light.attenuation),
            ("the spot", light.spot),
            ("the part reached", light.reached),
        ]);
    }
    let vector = vectors.into_iter().find(|(_, value)| !value.is_finite());
    let number = numbers.into_iter().find(|(_, value)| !value.is_finite());
    vector
        .map(|(name, _)| name)
        .or(number.map(|(name, _)| name))
}

/// Examines scenes on all threads; returns how many of them were drawn.
fn examine_all(seeds: std::ops::Range<u64>) -> u64 {
    let count = seeds.end - seeds.start;
    let fates: Vec<Result<Fate, String>> = seeds
        .into_par_iter()
        .map(examine)
        .filter(|fate| *fate != Ok(Fate::Refused))
        .collect();
    let drawn = fates.iter().filter(|fate| fate.is_ok()).count() as u64;
    let wrong: Vec<String> = fates.into_iter().filter_map(Result::err).collect();
    println!(
        "{count} scenes: {drawn} drawn, {} refused, {} wrong",
        count - drawn - wrong.len() as u64,
        wrong.len()
    );
    assert!(
        wrong.is_empty(),
        "{} of {count} are wrong:\n{}",
        wrong.len(),
        wrong[..wrong.len().min(5)].join("\n")
    );
    drawn
}

/// Returns a scene with a thousand lights on the surface, each as bright as allowed, and a material of maximum coefficients.
fn blinding(model: ReflectionModel, mode: ShadingMode, attenuation: Attenuation) -> Scene {
    let most = Rgb::splat(Material::MAX_COEFFICIENT);
    let mut scene = Scene::default();
    scene.image.size = [16; 2];
    (scene.shading.mode, scene.reflection.model) = (mode, model);
    let roughness = *Material::ROUGHNESS.start();
    scene.material = Material {
        kd: most,
        ks: most,
        color: most,
        specular_color: most,
        roughness,
        ..scene.material
    };
    (scene.pattern.kind, scene.pattern.color) = (PatternKind::Checker, most);
    let color = Rgb::splat(GREATEST_INTENSITY);
    // On the sphere's point next to the eye.
    let light = Light {
        attenuation,
        position: DVec3::Z,
        color,
        k: 0.0,
        c1: 0.0,
        c2: 0.0,
        ..Light::default()
    };
    (scene.ambient.color, scene.lights) = (color, vec![light; Scene::MAX_LIGHTS]);
    scene
}

#[test]
fn a_thousand_blinding_lights_add_up_to_a_finite_number() {
    for model in [
        ReflectionModel::Phong,
        ReflectionModel::Blinn,
        ReflectionModel::CookTorrance,
    ] {
        for mode in [
            ShadingMode::Flat,
            ShadingMode::Gouraud,
            ShadingMode::Phong,
            ShadingMode::Exact,
        ] {
            for attenuation in [
                Attenuation::None,
                Attenuation::InverseSquare,
                Attenuation::Light,
                Attenuation::Quadratic,
            ] {
                let scene = blinding(model, mode, attenuation);
                assert_eq!(scene.validate(), Ok(()));
                let mut renderer = Renderer::default();
                assert_eq!(
                    draw(&mut renderer, &scene),
                    Ok(()),
                    "{model:?} {mode:?} {attenuation:?}"
                );
                renderer.keep_linear(true);
                renderer.render(&scene);
                let brightest = renderer
                    .linear()
                    .iter()
                    .flatten()
                    .copied()
                    .fold(0.0, f32::max);
                assert!(
                    f64::from(brightest) > GREATEST_INTENSITY,
                    "{model:?} {mode:?} {attenuation:?}: {brightest}"
                );
            }
        }
    }
}

#[test]
fn a_camera_of_any_size_draws_solids_of_size_one() {
    let modes = [
        ShadingMode::Flat,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Exact,
    ];
    for (exponent, mode) in (-29..=29).flat_map(|exponent| modes.map(|mode| (exponent, mode))) {
        let mut scene = Scene::default();
        let size = 10_f64.powi(exponent);
        (scene.image.size, scene.shading.mode) = ([16; 2], mode);
        (scene.camera.eye, scene.camera.target) = (
            DVec3::new(0.7, 0.9, 0.4) * size,
            DVec3::new(0.2, -0.1, 0.1) * size,
        );
        scene.camera.height = size;
        scene.camera.projection = if exponent % 2 == 0 {
            Projection::Perspective
        } else {
            Projection::Orthographic
        };
        (scene.object.segments, scene.object.rings) = (7, 5);
        scene.lights[0].attenuation = Attenuation::InverseSquare;
        for kind in [
            ObjectKind::Sphere,
            ObjectKind::Torus,
            ObjectKind::Cone,
            ObjectKind::Cube,
            ObjectKind::Plane,
        ] {
            scene.object.kind = kind;
            assert_eq!(scene.validate(), Ok(()));
            assert_eq!(
                draw(&mut Renderer::default(), &scene),
                Ok(()),
                "{kind:?}, {mode:?}, 1e{exponent}"
            );
        }
    }
}

#[test]
fn a_scene_is_refused_with_a_reason_or_drawn_in_finite_numbers() {
    let count = 3000;
    let drawn = examine_all(0..count);
    assert!(
        drawn > count / 2 && drawn < count,
        "{drawn} of {count} were drawn"
    );
}

/// Examines a million scenes on all cores, in some minutes: `cargo test --test engine robustness -- --ignored --nocapture`.
/// `ROBUSTNESS_SEEDS=FROM..TO` selects others.
#[test]
#[ignore = "takes minutes"]
fn a_million_scenes() {
    examine_all(seeds(0..1_000_000));
}

/// Compares the probe with the stored pixels of an everyday scene; returns how many were compared, and the mistakes.
fn compare(seed: u64) -> (u32, Option<String>) {
    let AnyScene { mut scene, model } = everyday_scene(seed);
    let Ok(model) = model else { return (0, None) };
    // Where a law is undefined, pixels would be marked whatever their colour.
    if scene.reflection.is_own_law() && scene.display.overflow == Overflow::Mark {
        scene.display.overflow = Overflow::Clamp;
    }
    if scene.validate().is_err() {
        return (0, None);
    }
    let mut renderer = Renderer::default().with_model(model);
    let [width, height] = scene.image.size;
    let (mut compared, mut wrong) = (0, Vec::new());
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
            continue;
        };
        // Right next to the border between two fields any rounding changes the colour.
        if field_edge(&scene, hit.position, 2e-3) {
            continue;
        }
        compared += 1;
        let shown = hit.sum / hit.divisor;
        // Marked pixels have colours of their own.
        if scene.display.overflow == Overflow::Mark && shown.max_element() > 1.0 - 1e-4 {
            continue;
        }
        let code = |v: f64| {
            if scene.display.encoding == Encoding::Srgb {
                srgb(v.clamp(0.0, 1.0))
            } else {
                v
            }
        };
        let off =
            |k: usize| (255.0 * code(shown[k]).clamp(0.0, 1.0) - f64::from(hit.stored[k])).abs();
        let off = (0..3).map(off).fold(0.0, f64::max);
        if off > 1.0 {
            wrong.push(format!(
                "{x},{y}: off by {off:.2}, sum {}, stored {:?}",
                hit.sum, hit.stored
            ));
        }
    }
    let told = |wrong: Vec<String>| {
        let what = (
            scene.object.kind,
            scene.shading.mode,
            scene.shading.interpolation,
            scene.camera.projection,
        );
        let more = (
            scene.pattern.kind,
            scene.shading.shadows,
            scene.transparency.kt,
            scene.material.n,
        );
        format!(
            "scene {seed}, {what:?} {more:?}: {} of {compared}, {}",
            wrong.len(),
            wrong[0]
        )
    };
    (compared, (!wrong.is_empty()).then(|| told(wrong)))
}

/// Compares the profile along the middle row with the picture before the display, at the pixels' centres.
fn compare_profile(seed: u64) -> (u32, Option<String>) {
    let AnyScene { scene, model } = everyday_scene(seed);
    let Ok(model) = model else { return (0, None) };
    let [width, height] = scene.image.size;
    if scene.validate().is_err() || width < 2 {
        return (0, None);
    }
    let mut renderer = Renderer::default().with_model(model);
    let at = |x: f64| DVec2::new(x, f64::from(height / 2) + 0.5);
    let request = ProfileQuestion {
        modes: vec![scene.shading.mode],
        ..ProfileQuestion::new(at(0.0), at(f64::from(width)))
    };
    let taken = profile(&mut renderer, &scene, &request).expect("a line in the picture");
    renderer.keep_linear(true);
    renderer.render(&scene);
    let row: Vec<Rgb> = renderer
        .linear()
        .chunks(width as usize)
        .nth(height as usize / 2)
        .map_or(Vec::new(), |row| {
            row.iter()
                .map(|[r, g, b, _]| Rgb::new((*r).into(), (*g).into(), (*b).into()))
                .collect()
        });
    let centres = taken.samples.iter().zip(&taken.traces[0].intensity);
    let centres = centres.filter(|(sample, _)| (sample.x.fract() - 0.5).abs() < 1e-9);
    let (mut compared, mut wrong) = (0, None);
    for (sample, value) in centres {
        let hit = probe(&mut renderer, &scene, sample.x as u32, height / 2).hit;
        if hit.is_some_and(|hit| field_edge(&scene, hit.position, 2e-3)) {
            continue;
        }
        compared += 1;
        let expected = luminance(row[sample.x as usize]);
        if (value - expected).abs() > expected.max(1.0) / 255.0 {
            let what = (
                scene.object.kind,
                scene.shading.mode,
                scene.shading.interpolation,
            );
            wrong = Some(format!(
                "scene {seed}, {what:?}: {value} at {}, the picture has {expected}",
                sample.x
            ));
        }
    }
    (compared, wrong)
}

/// Compares the scenes with these seeds; returns the number of pixels compared, and the mistakes by scene.
fn compare_all(
    seeds: std::ops::Range<u64>,
    compare: impl Fn(u64) -> (u32, Option<String>) + Sync + Send,
) -> (u32, Vec<String>) {
    let compared: Vec<_> = seeds.into_par_iter().map(compare).collect();
    (
        compared.iter().map(|(count, _)| count).sum(),
        compared
            .into_iter()
            .filter_map(|(_, wrong)| wrong)
            .collect(),
    )
}

/// Returns the seeds that the environment names, or `usual`.
fn seeds(usual: std::ops::Range<u64>) -> std::ops::Range<u64> {
    let named = std::env::var("ROBUSTNESS_SEEDS").ok();
    let named = named.as_deref().and_then(|text| text.split_once(".."));
    named.map_or(usual, |(from, to)| {
        let [from, to] =
            [from, to].map(|number| number.parse().expect("FROM..TO in whole numbers"));
        from..to
    })
}

#[test]
fn the_probe_says_what_is_stored_in_any_scene() {
    let (compared, wrong) = compare_all(seeds(0..400), compare);
    assert!(
        compared > 10_000 && wrong.is_empty(),
        "{compared} pixels, {} scenes: {wrong:#?}",
        wrong.len()
    );
}

#[test]
fn the_profile_passes_through_the_pixels_of_any_scene() {
    let (compared, wrong) = compare_all(seeds(0..400), compare_profile);
    assert!(
        compared > 2000 && wrong.is_empty(),
        "{compared} pixels, {} scenes: {wrong:#?}",
        wrong.len()
    );
}

/// Probes a scene at some pixels and checks the reasons where a light adds nothing; returns the causes met.
fn check_reasons(seed: u64) -> Result<Vec<ZeroCause>, String> {
    let AnyScene { mut scene, model } = any_scene(seed);
    // Interpolation along scan lines takes intensities from corners other than a triangle's.
    scene.shading.interpolation = Interpolation::Perspective;
    scene.shading.shadows |= seed.is_multiple_of(2);
    let Ok(model) = model else {
        return Ok(Vec::new());
    };
    if scene.validate().is_err() || scene.lights.len() > 10 {
        return Ok(Vec::new());
    }
    let mut renderer = Renderer::default().with_model(model.clone());
    let judge = Judge::new(&scene, model.as_deref());
    let [width, height] = scene.image.size;
    let mut met = Vec::new();
    for (x, y) in (0..height)
        .step_by(5)
        .flat_map(|y| (0..width).step_by(3).map(move |x| (x, y)))
    {
        let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
            continue;
        };
        for (index, (light, terms)) in scene.lights.iter().zip(&hit.lights).enumerate() {
            let checked = judge.check(&hit, light, terms);
            met.extend(checked.map_err(|what| {
                format!(
                    "scene {seed}, {x},{y}, light {index}: {what}\n{terms:?}\n{:?} {:?}\n{}",
                    hit.position,
                    hit.normal,
                    scene.to_toml()
                )
            })?);
        }
    }
    Ok(met)
}

/// Checks random scenes that show their object: every reason that the probe gives for a light that adds nothing must be the real
/// one.
#[test]
fn every_reason_for_a_light_that_adds_nothing_is_the_real_one() {
    let outcomes: Vec<_> = (0..6000).into_par_iter().map(check_reasons).collect();
    let wrong: Vec<_> = outcomes
        .iter()
        .filter_map(|outcome| outcome.as_ref().err())
        .collect();
    assert!(
        wrong.is_empty(),
        "{} scenes, the first: {}",
        wrong.len(),
        wrong[0]
    );
    let met: Vec<_> = outcomes
        .into_iter()
        .flatten()
        .filter(|met| !met.is_empty())
        .collect();
    let scenes = met.len();
    let count = |cause| met.iter().flatten().filter(|met| **met == cause).count();
    let counts = [
        ZeroCause::Muted,
        ZeroCause::NotSoloed,
        ZeroCause::Black,
        ZeroCause::Coefficient,
        ZeroCause::FacesAway,
        ZeroCause::OutsideCone,
        ZeroCause::InShadow,
        ZeroCause::MissesViewer,
    ]
    .map(|cause| (cause, count(cause)));
    assert!(
        scenes >= 1000 && counts.iter().all(|(_, count)| *count >= 100),
        "{scenes} scenes, {counts:?}"
    );
}
