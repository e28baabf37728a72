//! The window's tabs of error against run time, and of stiff and extreme cases.

use crate::common::hands::{enter, open_view, press, scene, undo, wait, window};
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::analysis::stability::stability_cases;
use shading_lab::app::App;
use shading_lab::scene::{ObjectKind, ShadingMode};

#[test]
fn a_study_runs_stops_and_shows_its_settings_in_the_picture() {
    let mut harness = window("sphere");
    open_view(&mut harness, "Study");
    for segments in ["16", "64", "128"] {
        press(&mut harness, segments);
    }
    for method in [
        "flat, vertex mean",
        "Phong, not unit",
        "Phong, scalar",
        "angular, scalar",
    ] {
        press(&mut harness, method);
    }
    press(&mut harness, "3 ×");
    assert!(
        harness.query_by_label_contains("Draws about").is_some(),
        "what it will do is said first"
    );
    press(&mut harness, "Measure");
    assert!(
        wait(&mut harness, |harness| harness
            .query_by_label("Measure again")
            .is_some()),
        "it comes to its end"
    );
    let stale = |harness: &Harness<'_, App>| {
        harness
            .query_by_label_contains("The scene has changed")
            .is_some()
    };
    assert!(!stale(&harness));
    assert!(
        harness.query_by_label("Error against run time").is_some(),
        "the plot is there"
    );
    let before = scene(&harness).clone();
    press(&mut harness, "Gouraud 8×4");
    let after = scene(&harness).clone();
    assert!(!stale(&harness), "a setting of its own changes nothing");
    assert_eq!(
        (
            after.shading.mode,
            after.object.segments,
            after.object.rings
        ),
        (ShadingMode::Gouraud, 8, 4)
    );
    press(&mut harness, "Taylor, scalar 8×4");
    assert_eq!(
        *scene(&harness),
        after,
        "a historic method is no mode of the picture"
    );
    assert!(
        harness
            .query_by_label_contains("it cannot be shown")
            .is_some()
    );
    undo(&mut harness);
    assert_eq!(*scene(&harness), before, "one step of undo");
    enter(&mut harness, "Kd diffuse coefficient", 0.125);
    assert!(stale(&harness), "another material does");
    // Another is stopped by hand and keeps what it has.
    press(&mut harness, "27 ×");
    press(&mut harness, "512");
    press(&mut harness, "Measure again");
    assert!(wait(&mut harness, |harness| harness
        .query_by_label("flat 8×4")
        .is_some()));
    press(&mut harness, "Stop");
    assert!(wait(&mut harness, |harness| harness
        .query_by_label("Measure again")
        .is_some()));
    assert!(harness.query_by_label("flat 8×4").is_some());
    assert!(
        harness
            .query_by_label_contains("results are incomplete")
            .is_some()
    );
}

#[test]
fn the_catalogue_is_drawn_and_a_case_opens_as_the_scene() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    open_view(&mut harness, "Stability");
    let last = stability_cases().last().expect("cases").title();
    assert!(
        wait(&mut harness, |harness| harness
            .query_by_role_and_label(Role::Button, last)
            .is_some()),
        "all are drawn"
    );
    let case = stability_cases()
        .find(|case| case.name == "far-from-the-origin")
        .expect("a case");
    press(&mut harness, case.title());
    assert!(
        harness.query_by_label_contains(case.naive()).is_some()
            && harness.query_by_label_contains(case.engine()).is_some()
    );
    assert!(
        harness
            .query_by_label_contains("Condition number 10⁷")
            .is_some()
    );
    press(&mut harness, "Open as scene");
    let opened = scene(&harness).clone();
    assert_eq!(
        (opened.object.kind, opened.image.size),
        (ObjectKind::Polygons, before.image.size)
    );
    assert_eq!(
        opened.object.vertices,
        case.scene().expect("a scene").object.vertices
    );
    undo(&mut harness);
    assert_eq!(*scene(&harness), before, "one step of undo");
}
