//! Pictures that take long: they are drawn in parts, between which the window answers.

use crate::common::hands::{built_in, named, picture, scene, unfold_all, window_looking};
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::{App, Appearance};
use shading_lab::render::Renderer;
use shading_lab::scene::ReflectionModel;

/// Runs frames until the picture is that of the scene; returns their number.
fn frames_until_finished(harness: &mut Harness<'_, App>) -> usize {
    let mut expected = None;
    for frames in 1..500 {
        harness.step();
        let frame = harness.state().frame();
        let size = [frame.width, frame.height];
        let expected = expected.get_or_insert_with(|| {
            let mut scene = scene(harness).clone();
            scene.image.size = size;
            Renderer::default().render(&scene).clone()
        });
        if picture(harness) == expected.pixels {
            return frames;
        }
    }
    panic!("the picture is not finished");
}

#[test]
fn a_picture_that_takes_long_is_drawn_in_parts_and_given_up_for_another() {
    let mut loaded = built_in("soft-shadow");
    loaded.scene.shading.shadows = false;
    let law = &mut loaded.scene.reflection;
    law.model = ReflectionModel::Formula;
    law.formula = format!("a = N·L\n{}a", "a = tan(a)\n".repeat(170));
    let appearance = Appearance {
        smooth_edges: false,
        ..Appearance::default()
    };
    let mut harness = window_looking(loaded, [1280.0, 800.0], &appearance, |app| app);
    unfold_all(&mut harness);
    harness.step();
    let slider = |harness: &Harness<'_, App>, value| {
        let slider = harness.get_by_role_and_label(Role::Slider, named("material.ka"));
        slider.set_value_accesskit(value);
    };
    slider(&harness, 0.4);
    let frames = frames_until_finished(&mut harness);
    assert!(frames > 3, "drawn in {frames} frames");
    // Given up after a part, for one that is drawn to its end.
    slider(&harness, 0.9);
    harness.step();
    harness.step();
    slider(&harness, 0.1);
    let frames = frames_until_finished(&mut harness);
    assert!(frames > 3, "drawn in {frames} frames");
    assert_eq!(scene(&harness).material.ka.x, 0.1);
}
