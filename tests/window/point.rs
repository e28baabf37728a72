//! The vectors at the probed point: the construction of R and H from N, L and V, in numbers, in the drawing and in the window.

use crate::common::hands::{press, window};
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use glam::{DVec2, DVec3};
use shading_lab::analysis::probe::{ConstructionStep, Here, VectorsShown, draw_vectors, probe};
use shading_lab::figure::palette::contrast;
use shading_lab::figure::{Paper, PlotStyle};
use shading_lab::render::Renderer;
use shading_lab::scene::{Backfacing, Choice, Scene, presets};

/// Calls `check` for some pixels of built-in scenes with all kinds of lights, materials and normals.
fn each_point(mut check: impl FnMut(Here<'_>, &str)) {
    let mut renderer = Renderer::default();
    for name in [
        "sphere",
        "three-lights",
        "glass-ball",
        "teapot",
        "gold",
        "soft-shadow",
    ] {
        for &backfacing in Backfacing::VALUES {
            let mut scene = presets::find(name).expect("a scene").scene();
            scene.image.size = [48, 48];
            scene.reflection.backfacing = backfacing;
            for [x, y] in [[24, 24], [30, 18], [15, 30], [36, 36]] {
                if let Some(hit) = probe(&mut renderer, &scene, x, y).hit {
                    let here = Here {
                        scene: &scene,
                        hit: &hit,
                    };
                    check(here, &format!("{name} {backfacing:?} {x},{y}"));
                }
            }
        }
    }
}

fn every_view() -> Vec<VectorsShown> {
    let steps = ConstructionStep::ALL.map(VectorsShown::Step);
    [
        &[VectorsShown::Angles, VectorsShown::Construction][..],
        &steps,
    ]
    .concat()
}

#[test]
fn the_steps_arrive_at_the_r_and_h_of_the_equation() {
    let mut mirrored = 0;
    each_point(|here, what| {
        for light in here.lights() {
            let steps = light.construction();
            let made = |step| {
                steps
                    .iter()
                    .find(|worked| worked.step == step)
                    .map(|worked| worked.result)
            };
            let near = |made: DVec3, expected: DVec3| {
                assert!(
                    (made - expected).length() < 1e-9,
                    "{what}: {made} and {expected}"
                );
            };
            near(
                made(ConstructionStep::Cosine).expect("N and L"),
                DVec3::X
                    * light.terms.n_dot_l.abs().copysign(if light.turned() {
                        1.0
                    } else {
                        light.terms.n_dot_l
                    }),
            );
            let r = made(ConstructionStep::Mirror);
            assert_eq!(
                r.is_some(),
                light.terms.n_dot_l > 0.0 || light.turned(),
                "{what}"
            );
            if let Some(r) = r {
                near(r, light.terms.r);
                mirrored += 1;
            }
            near(
                made(ConstructionStep::Halfway).expect("L is not −V"),
                light.terms.h,
            );
        }
    });
    assert!(mirrored > 40, "{mirrored}");
}

#[test]
fn a_step_is_written_with_the_numbers_of_the_point() {
    let mut scene = Scene::default();
    scene.image.size = [48, 48];
    let mut hit = probe(&mut Renderer::default(), &scene, 24, 24)
        .hit
        .expect("the sphere");
    hit.normal = DVec3::Y;
    hit.view = DVec3::Y;
    hit.lights[0].l = DVec3::new(0.6, 0.8, 0.0);
    hit.lights[0].n_dot_l = 0.8;
    hit.lights[0].r = DVec3::new(-0.6, 0.8, 0.0);
    let here = Here {
        scene: &scene,
        hit: &hit,
    };
    let light = here.lights().next().expect("a light");
    let numbers: Vec<_> = light
        .construction()
        .into_iter()
        .map(|worked| worked.numbers)
        .collect();
    assert_eq!(numbers[0], ["0.0000 + 0.8000 + 0.0000", "0.8000"]);
    assert_eq!(
        numbers[1],
        ["0.8000 · (0.000, 1.000, 0.000)", "(0.000, 0.800, 0.000)"]
    );
    assert_eq!(
        numbers[2],
        [
            "(0.000, 0.800, 0.000) − (0.600, 0.800, 0.000)",
            "(−0.600, 0.000, 0.000)"
        ]
    );
    assert_eq!(
        numbers[3],
        [
            "(0.000, 0.800, 0.000) + (−0.600, 0.000, 0.000)",
            "(−0.600, 0.800, 0.000)"
        ]
    );
    assert_eq!(numbers[4][0], "(0.600, 1.800, 0.000)/1.8974");
    assert!(
        light.mirror_check().contains("|R| = 1.0000"),
        "{}",
        light.mirror_check()
    );
}

#[test]
fn letters_in_the_drawing_are_readable_apart_and_inside() {
    let mut drawn = 0;
    each_point(|here, what| {
        for shown in every_view() {
            for (paper, width) in [(Paper::LIGHT, 270.0), (Paper::DARK, 480.0)] {
                let style = PlotStyle {
                    paper,
                    text: 12.6,
                    titled: false,
                };
                let Some(drawing) = draw_vectors(here, 0, shown, width, &style) else {
                    continue;
                };
                assert!(
                    drawing.size.x <= width && drawing.size.y <= width * 1.001,
                    "{what}"
                );
                let boxes: Vec<_> = drawing
                    .texts
                    .iter()
                    .map(|text| {
                        assert!(
                            contrast(text.colour, paper.ground) >= 4.5,
                            "{what}: {text:?}"
                        );
                        let min = text.at - DVec2::new(text.align * text.width(), 0.6 * text.size);
                        (
                            min,
                            min + DVec2::new(text.width(), 0.6 * text.size),
                            &text.text,
                        )
                    })
                    .collect();
                for (index, (min, max, text)) in boxes.iter().enumerate() {
                    let inside =
                        min.cmpge(DVec2::splat(-1.0)).all() && max.cmple(drawing.size + 1.0).all();
                    assert!(inside, "{what} {shown:?}: “{text}” leaves the drawing");
                    for (other_min, other_max, other) in &boxes[index + 1..] {
                        let apart =
                            min.cmpge(*other_max - 1.0).any() || other_min.cmpge(*max - 1.0).any();
                        assert!(apart, "{what} {shown:?}: “{text}” and “{other}”");
                    }
                }
                drawn += boxes.len();
            }
        }
    });
    assert!(drawn > 1000, "{drawn}");
}

#[test]
fn the_steps_are_gone_through_in_the_window() {
    let mut harness = window("sphere");
    let says = |harness: &egui_kittest::Harness<'_, shading_lab::app::App>, text: &str| {
        harness.query_all_by_label_contains(text).next().is_some()
    };
    assert!(
        says(&harness, &english!("point-drawing", list = "")),
        "they are shown without being asked for"
    );
    for (step, line) in [
        ("1 of 5", "= 0."),
        ("2 of 5", "· ("),
        ("3 of 5", "− ("),
        ("4 of 5", "|R| = 1.0000"),
        ("5 of 5", ")/1."),
    ] {
        press(&mut harness, "point-next-step");
        assert!(says(&harness, step) && says(&harness, line), "{step}");
    }
    press(&mut harness, "point-previous-step");
    assert!(says(&harness, "4 of 5"));
    press(&mut harness, "point-all-steps");
    assert!(says(&harness, "|R| = 1.0000") && says(&harness, ")/1."));
    assert!(!says(&harness, "of 5"));
    let curves = harness
        .query_by_role_and_label(Role::DisclosureTriangle, english!("view-curves"))
        .is_some();
    assert!(curves, "the curves are folded below");
}
