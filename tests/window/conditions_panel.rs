//! The conditions for flat shading in the window: each has a button that meets it, and goes back.

use crate::common::hands::{open_view, press, scene, wait, window};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::App;
use shading_lab::scene::{LightKind, ObjectKind, Viewer};

/// Presses a button when it is there.
fn press_when_there(harness: &mut Harness<'_, App>, name: &str) {
    assert!(
        wait(harness, |harness| harness.query_by_label(name).is_some()),
        "{name}"
    );
    press(harness, name);
}

#[test]
fn each_condition_is_met_and_broken_by_its_button() {
    let mut harness = window("flat-facets");
    open_view(&mut harness, "Defects");
    let before = scene(&harness).clone();
    press_when_there(&mut harness, "Move the lights to infinity");
    press_when_there(&mut harness, "Move the viewer to infinity");
    press_when_there(&mut harness, "Draw a cube");
    let met = scene(&harness);
    assert!(
        met.lights
            .iter()
            .all(|light| light.kind == LightKind::Directional)
    );
    assert_eq!(met.camera.viewer, Viewer::Infinite);
    assert_eq!(met.object.kind, ObjectKind::Cube);
    assert!(wait(&mut harness, |harness| harness
        .query_all_by_label("Holds:")
        .count()
        == 4));
    press_when_there(&mut harness, "Bring the lights back");
    press_when_there(&mut harness, "Bring the viewer back");
    press_when_there(&mut harness, "Draw a curved object");
    assert_eq!(*scene(&harness), before);
}
