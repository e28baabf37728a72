//! A scene that becomes the target of a match.

use super::{go, ready, revealed};
use crate::common::hands::{self, press, scene};
use egui_kittest::Harness;
use shading_lab::app::App;
use shading_lab::document::{load_scene, save_scene};
use std::path::Path;

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
fn so_does_a_scene_from_a_file() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("target scene.toml");
    let built_in = hands::built_in("torus");
    let own = built_in.scene.with_overrides(&["material.n=77"]);
    save_scene(&path, &own.expect("settings")).expect("a file");
    let mut harness = hands::window_of(load_scene(&path).expect("a scene"));
    meet_target(&mut harness);
    assert_eq!(scene(&harness).material.n, 77.0);
}
