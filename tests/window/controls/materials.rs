//! The material, the pattern and the object's surroundings, in the window.

use super::choice_changes_the_picture;
use crate::common::hands::{
    choose, enter, folded, named, picture, press, scene, undo, unfold, window, window_of,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::App;
use shading_lab::document::load_scene;
use shading_lab::scene::{Distribution, PatternKind, ReflectionModel, Rgb};
use std::path::Path;

#[test]
fn microfacets_have_a_roughness_instead_of_n() {
    let mut harness = window("sphere");
    let is_there = |harness: &Harness<'_, App>, name| {
        harness
            .query_by_role_and_label(Role::Slider, named(name))
            .is_some()
    };
    assert!(is_there(&harness, "material.n") && !is_there(&harness, "material.roughness"));
    choose(&mut harness, "reflection.model", "cook-torrance");
    assert!(!is_there(&harness, "material.n") && is_there(&harness, "material.roughness"));
    let before = picture(&harness);
    enter(&mut harness, "material.roughness", 0.5);
    let rough = picture(&harness);
    assert!(rough != before);
    choose(&mut harness, "reflection.distribution", "ggx");
    assert_eq!(scene(&harness).reflection.distribution, Distribution::Ggx);
    assert!(picture(&harness) != rough);
}

#[test]
fn another_model_with_an_equally_wide_highlight_is_one_step() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    press(
        &mut harness,
        &english!("controls-match-exponent", model = "Blinn"),
    );
    assert_eq!(scene(&harness).reflection.model, ReflectionModel::Blinn);
    assert!(
        (scene(&harness).material.n / before.material.n - 4.0).abs() < 0.1,
        "n = {}",
        scene(&harness).material.n
    );
    undo(&mut harness);
    assert_eq!(*scene(&harness), before);
    press(&mut harness, "controls-match-roughness");
    assert_eq!(
        scene(&harness).reflection.model,
        ReflectionModel::CookTorrance
    );
}

#[test]
fn the_reflectance_of_a_metal_changes_the_picture() {
    for entry in ["glass", "silver", "gold"] {
        choice_changes_the_picture("sphere", &[], "material.reflectance", entry);
    }
    let mut harness = window("sphere");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, named("material.extinction.red"))
            .is_none()
    );
    choose(&mut harness, "material.reflectance", "custom");
    let before = picture(&harness);
    enter(&mut harness, "material.extinction.red", 4.0);
    assert!(picture(&harness) != before);
}

#[test]
fn a_pattern_and_a_highlight_colour_change_the_picture() {
    let mut harness = window("sphere");
    let plain = picture(&harness);
    enter(&mut harness, "material.specular_color.green", 0.0);
    assert!(picture(&harness) != plain);
    undo(&mut harness);
    choose(&mut harness, "pattern.kind", "checker");
    assert_eq!(scene(&harness).pattern.kind, PatternKind::Checker);
    let coarse = picture(&harness);
    assert!(coarse != plain);
    enter(&mut harness, "pattern.scale", 0.1);
    assert!(picture(&harness) != coarse);
}

#[test]
fn transparency_and_surroundings_unfold() {
    let mut harness = folded("sphere");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, named("transparency.kt"))
            .is_none(),
        "the section is folded at first"
    );
    unfold(&mut harness, "controls-transparency");
    let index = harness.get_by_role_and_label(Role::SpinButton, named("transparency.ior"));
    assert!(
        index.accesskit_node().is_disabled(),
        "nothing is transmitted"
    );
    enter(&mut harness, "transparency.kt", 0.5);
    enter(&mut harness, "transparency.ior", 1.33);
    assert_eq!(
        (
            scene(&harness).transparency.kt,
            scene(&harness).transparency.ior
        ),
        (0.5, 1.33)
    );
    let symbol = format!("Transmitted {}", english!("in-equation"));
    assert!(
        harness
            .query_by_role_and_label(Role::Button, &symbol)
            .is_some()
    );
    unfold(&mut harness, "controls-surroundings");
    press(&mut harness, "shading.shadows.on");
    press(&mut harness, "ground.visible.on");
    enter(&mut harness, "ground.height", -0.5);
    choose(&mut harness, "backdrop.pattern", "stripes");
    enter(&mut harness, "backdrop.distance", 3.0);
    choose(&mut harness, "ambient.source", "bounce");
    let scene = scene(&harness);
    assert!(scene.shading.shadows && scene.ground.visible);
    assert_eq!((scene.ground.height, scene.backdrop.distance), (-0.5, 3.0));
    assert_eq!(scene.backdrop.pattern, PatternKind::Stripes);
    assert_eq!(scene.validate(), Ok(()));
}

#[test]
fn a_named_material_is_one_step() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    press(&mut harness, "controls-materials");
    press(&mut harness, "material-gold");
    assert_eq!(
        scene(&harness).material.ka,
        Rgb::new(0.24725, 0.1995, 0.0745)
    );
    assert_eq!(scene(&harness).material.n, 51.2);
    undo(&mut harness);
    assert_eq!(*scene(&harness), before);
}

#[test]
fn a_model_drawn_without_its_materials_says_so_until_it_is_dismissed_or_gone() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("window-materials-of-a-model");
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("red.obj");
    let model = "mtllib red.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(&path, model).expect("a model");
    let expected = english!("document-library");
    let missing = english!("document-no-such-file", expected = expected);
    let warning = &format!("red.obj:1: red.mtl: {missing}");
    let mut harness = window_of(load_scene(&path).expect("a model"));
    let says = |harness: &Harness<'_, App>| harness.query_by_label_contains(warning).is_some();
    // The warning outlasts four seconds, and a notice of four seconds takes precedence over it.
    harness.run_steps(40);
    assert!(says(&harness));
    harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::L);
    harness.step();
    harness.step();
    assert!(!says(&harness));
    harness.run_steps(40);
    assert!(says(&harness));
    press(&mut harness, "scenes-next");
    assert!(!says(&harness), "it speaks of what is not shown");
    undo(&mut harness);
    assert!(says(&harness));
    press(&mut harness, "dismiss");
    assert!(!says(&harness));
    harness.run_steps(4);
    assert!(!says(&harness), "once is enough");
}
