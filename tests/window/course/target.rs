//! A scene that becomes the target of a match.

use super::{answered, go, ready, revealed};
use crate::common::hands::{self, named, press, scene};
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::App;
use shading_lab::document::{load_scene, save_scene};
use std::path::Path;
use std::time::Duration;

/// Makes a scene of Kd 0.9 the target of a match, and meets it.
fn meet_target(harness: &mut Harness<'_, App>) {
    hands::enter(harness, "material.kd", 0.9);
    press(harness, "controls-group-file");
    press(harness, "controls-command-set-target");
    harness.run_ok();
    ready(harness);
    assert_eq!(scene(harness).material.kd.x, 0.5);
    hands::enter(harness, "material.kd", 0.9);
    press(harness, "course-check");
    assert!(revealed(harness));
}

#[test]
fn the_scene_in_view_becomes_the_target_of_a_match() {
    let mut harness = hands::window("sphere");
    meet_target(&mut harness);
    go(&mut harness, 3);
    let open = harness.state().state().course.open.as_ref();
    assert_eq!(open.expect("a lesson").lesson.steps.len(), 4);
}

#[test]
fn a_click_on_check_counts_whatever_appears_in_the_same_frame() {
    let mut harness = hands::window("sphere");
    hands::enter(&mut harness, "material.kd", 0.9);
    press(&mut harness, "controls-group-file");
    harness
        .get_by_role_and_label(Role::Button, named("controls-command-set-target"))
        .click_accesskit();
    // The distance is measured from the first frame in which the button can be pressed; it becomes known in the next one.
    let check = named("course-check");
    while harness
        .query_by_role_and_label(Role::Button, check)
        .is_none_or(|button| button.accesskit_node().is_disabled())
    {
        harness.step();
    }
    std::thread::sleep(Duration::from_secs(1));
    harness
        .get_by_role_and_label(Role::Button, check)
        .click_accesskit();
    harness.step();
    assert!(answered(&harness).is_some());
}

#[test]
fn so_does_a_scene_from_a_file() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("target scene.toml");
    let built_in = hands::built_in("torus");
    let own = built_in.scene.with_overrides(&["material.n=77"]);
    save_scene(&path, &own.expect("settings")).expect("a file");
    let mut harness = hands::window_of(load_scene(&path).expect("a scene"));
    meet_target(&mut harness);
    assert_eq!(scene(&harness).material.n, 77.0);
}
