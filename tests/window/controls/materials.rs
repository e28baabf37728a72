//! The material, the pattern and what surrounds the object, in the window.

use super::choice_changes_the_picture;
use crate::common::hands::{
    choose, enter, folded, picture, press, scene, undo, unfold, window, window_of,
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
            .query_by_role_and_label(Role::Slider, name)
            .is_some()
    };
    assert!(is_there(&harness, "n specular exponent") && !is_there(&harness, "m roughness"));
    choose(&mut harness, "Reflection model", "Cook–Torrance  D·G");
    assert!(!is_there(&harness, "n specular exponent") && is_there(&harness, "m roughness"));
    let before = picture(&harness);
    enter(&mut harness, "m roughness", 0.5);
    let rough = picture(&harness);
    assert!(rough != before);
    choose(&mut harness, "D microfacet distribution", "GGX");
    assert_eq!(scene(&harness).reflection.distribution, Distribution::Ggx);
    assert!(picture(&harness) != rough);
}

#[test]
fn another_model_with_an_equally_wide_highlight_is_one_step() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    press(&mut harness, "Equivalent exponent for Blinn");
    assert_eq!(scene(&harness).reflection.model, ReflectionModel::Blinn);
    assert!(
        (scene(&harness).material.n / before.material.n - 4.0).abs() < 0.1,
        "n = {}",
        scene(&harness).material.n
    );
    undo(&mut harness);
    assert_eq!(*scene(&harness), before);
    press(&mut harness, "Equivalent roughness");
    assert_eq!(
        scene(&harness).reflection.model,
        ReflectionModel::CookTorrance
    );
}

#[test]
fn the_reflectance_of_a_metal_changes_the_picture() {
    for entry in ["glass", "silver", "gold"] {
        choice_changes_the_picture("sphere", &[], "W reflectance by angle", entry);
    }
    let mut harness = window("sphere");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, "k extinction red")
            .is_none()
    );
    choose(&mut harness, "W reflectance by angle", "custom η and k");
    let before = picture(&harness);
    enter(&mut harness, "k extinction red", 4.0);
    assert!(picture(&harness) != before);
}

#[test]
fn a_pattern_and_a_highlight_colour_change_the_picture() {
    let mut harness = window("sphere");
    let plain = picture(&harness);
    enter(&mut harness, "Os highlight colour green", 0.0);
    assert!(picture(&harness) != plain);
    undo(&mut harness);
    choose(&mut harness, "Pattern", "checker");
    assert_eq!(scene(&harness).pattern.kind, PatternKind::Checker);
    let coarse = picture(&harness);
    assert!(coarse != plain);
    enter(&mut harness, "Pattern scale", 0.1);
    assert!(picture(&harness) != coarse);
}

#[test]
fn transparency_and_surroundings_unfold() {
    let mut harness = folded("sphere");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, "Kt transparency")
            .is_none(),
        "the section is folded at first"
    );
    unfold(&mut harness, "Transparency");
    let index = harness.get_by_role_and_label(Role::SpinButton, "η relative index");
    assert!(
        index.accesskit_node().is_disabled(),
        "nothing is transmitted"
    );
    enter(&mut harness, "Kt transparency", 0.5);
    enter(&mut harness, "η relative index", 1.33);
    assert_eq!(
        (
            scene(&harness).transparency.kt,
            scene(&harness).transparency.ior
        ),
        (0.5, 1.33)
    );
    assert!(
        harness
            .query_by_role_and_label(Role::Button, "Transmitted in the equation")
            .is_some()
    );
    unfold(&mut harness, "Surroundings");
    press(&mut harness, "Shadows on");
    press(&mut harness, "Ground on");
    enter(&mut harness, "Ground height", -0.5);
    choose(&mut harness, "Backdrop", "stripes");
    enter(&mut harness, "Backdrop distance", 3.0);
    choose(&mut harness, "Ia ambient source", "one bounce");
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
    press(&mut harness, "Materials");
    press(&mut harness, "Gold");
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
    let warning = "red.obj: drawn with the scene's material";
    let mut harness = window_of(load_scene(&path).expect("a model"));
    let says = |harness: &Harness<'_, App>| harness.query_by_label_contains(warning).is_some();
    // Not for four seconds only, and what is said for four seconds goes before it.
    harness.run_steps(40);
    assert!(says(&harness));
    harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::L);
    harness.step();
    harness.step();
    assert!(!says(&harness));
    harness.run_steps(40);
    assert!(says(&harness));
    press(&mut harness, "Next scene");
    assert!(!says(&harness), "it speaks of what is not shown");
    undo(&mut harness);
    assert!(says(&harness));
    press(&mut harness, "Dismiss");
    assert!(!says(&harness));
    harness.run_steps(4);
    assert!(!says(&harness), "once is enough");
}
