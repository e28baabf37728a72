//! The window's tabs of error against run time, and of stiff and extreme cases.

use crate::common::hands::{
    built_in, enter, open_view, press, scene, undo, wait, window, window_of,
};
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::analysis::stability::stability_cases;
use shading_lab::analysis::study::Method;
use shading_lab::app::App;
use shading_lab::scene::{Choice, ObjectKind, ReflectionModel, ShadingMode};

#[test]
fn a_study_runs_stops_and_shows_its_settings_in_the_picture() {
    let mut harness = window("sphere");
    open_view(&mut harness, "view-study");
    for segments in ["16", "64", "128"] {
        press(&mut harness, segments);
    }
    for method in [
        "choice-method-flat-vertex-mean",
        "choice-method-phong-unnormalised",
        "choice-method-phong-scalar",
        "choice-method-angular",
    ] {
        press(&mut harness, method);
    }
    press(&mut harness, "3 ×");
    let about = english!("engine-study-about", frames = "|", time = "");
    let (about, _) = about.split_once('|').expect("a number");
    assert!(
        harness.query_by_label_contains(about).is_some(),
        "what it will do is said first"
    );
    press(&mut harness, "engine-measure");
    assert!(
        wait(&mut harness, |harness| harness
            .query_by_label(english!("report-again"))
            .is_some()),
        "it comes to its end"
    );
    let stale = |harness: &Harness<'_, App>| {
        harness
            .query_by_label_contains(english!("report-stale"))
            .is_some()
    };
    assert!(!stale(&harness));
    assert!(
        harness
            .query_by_label(english!("engine-study-plot"))
            .is_some(),
        "the plot is there"
    );
    let before = scene(&harness).clone();
    let eight = |method: &str| format!("{} 8×4", english!(method));
    press(&mut harness, &eight("choice-method-gouraud"));
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
    let taylor = eight("choice-method-taylor");
    press(&mut harness, &taylor);
    assert_eq!(
        *scene(&harness),
        after,
        "a historic method is no mode of the picture"
    );
    assert!(
        harness
            .query_by_label_contains(&english!("engine-study-not-shown", setting = taylor))
            .is_some()
    );
    undo(&mut harness);
    assert_eq!(*scene(&harness), before, "one step of undo");
    enter(&mut harness, "material.kd", 0.125);
    assert!(stale(&harness), "another material does");
    // Another study is stopped by hand and keeps its results.
    press(&mut harness, "27 ×");
    press(&mut harness, "512");
    press(&mut harness, "report-again");
    let flat = eight("choice-method-flat");
    assert!(wait(&mut harness, |harness| harness
        .query_by_label(&flat)
        .is_some()));
    press(&mut harness, "report-stop");
    assert!(wait(&mut harness, |harness| harness
        .query_by_label(english!("report-again"))
        .is_some()));
    assert!(harness.query_by_label(&flat).is_some());
    assert!(
        harness
            .query_by_label_contains(english!("report-stopped"))
            .is_some()
    );
}

#[test]
fn the_catalogue_is_drawn_and_a_case_opens_as_the_scene() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    open_view(&mut harness, "view-stability");
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
    let condition = english!("engine-condition-number", number = "10⁷", of = "|");
    let (condition, _) = condition.split_once('|').expect("what it is of");
    assert!(harness.query_by_label_contains(condition).is_some());
    press(&mut harness, "engine-open-case");
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

#[test]
fn a_study_of_an_own_law_asks_which_law_stands_beside_it() {
    let mut loaded = built_in("sphere");
    loaded.scene.reflection.model = ReflectionModel::Formula;
    loaded.scene.about.title = "Mine".to_owned();
    let mut harness = window_of(loaded);
    open_view(&mut harness, "view-study");
    for segments in ["16", "32", "64", "128"] {
        press(&mut harness, segments);
    }
    for method in Method::VALUES
        .iter()
        .filter(|method| **method != Method::Phong)
    {
        press(&mut harness, method.label());
    }
    press(&mut harness, "3 ×");
    press(&mut harness, "choice-reflection-model-blinn");
    press(&mut harness, "engine-measure");
    assert!(wait(&mut harness, |harness| harness
        .query_by_label(english!("report-again"))
        .is_some()));
    let row = |law: &str| {
        let law = if law == "Mine" {
            law.to_owned()
        } else {
            english!("engine-law", name = law)
        };
        let method = english!("choice-method-phong");
        english!("engine-law-method", law = law, method = method) + " 8×4"
    };
    let there = |harness: &Harness<'_, App>, law: &str| harness.query_by_label(&row(law)).is_some();
    assert!(there(&harness, "Mine") && there(&harness, "Blinn") && !there(&harness, "Phong"));
    press(&mut harness, &row("Blinn"));
    assert_eq!(scene(&harness).reflection.model, ReflectionModel::Blinn);
    assert!(
        harness
            .query_by_label_contains(english!("report-stale"))
            .is_none(),
        "the study is about this law too"
    );
    let offered = |harness: &Harness<'_, App>| {
        harness
            .query_by_label(english!("engine-study-reference"))
            .is_some()
    };
    assert!(!offered(&harness), "a built-in law stands for itself");
    undo(&mut harness);
    assert_eq!(scene(&harness).reflection.model, ReflectionModel::Formula);
    assert!(offered(&harness));
}
