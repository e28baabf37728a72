//! The conditions for flat shading in the window: each has a button that meets it and a way back.

use crate::common::hands::{named, open_view, press, scene, wait, window};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::App;
use shading_lab::scene::{LightKind, ObjectKind, Viewer};

/// Presses a button once it is there.
fn press_when_there(harness: &mut Harness<'_, App>, name: &str) {
    assert!(
        wait(harness, |harness| harness
            .query_by_label(named(name))
            .is_some()),
        "{name}"
    );
    press(harness, name);
}

#[test]
fn each_condition_is_met_and_broken_by_its_button() {
    let mut harness = window("flat-facets");
    open_view(&mut harness, "view-defects");
    let before = scene(&harness).clone();
    press_when_there(&mut harness, "picture-condition-light.meet");
    press_when_there(&mut harness, "picture-condition-viewer.meet");
    press_when_there(&mut harness, "picture-condition-surface.meet");
    let met = scene(&harness);
    assert!(
        met.lights
            .iter()
            .all(|light| light.kind == LightKind::Directional)
    );
    assert_eq!(met.camera.viewer, Viewer::Infinite);
    assert_eq!(met.object.kind, ObjectKind::Cube);
    assert!(wait(&mut harness, |harness| harness
        .query_all_by_label(english!("picture-holds"))
        .count()
        == 4));
    press_when_there(&mut harness, "picture-condition-light.break");
    press_when_there(&mut harness, "picture-condition-viewer.break");
    press_when_there(&mut harness, "picture-condition-surface.break");
    assert_eq!(*scene(&harness), before);
}
