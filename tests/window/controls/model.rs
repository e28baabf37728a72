//! The materials of a model in the window: listed, chosen by pointing, changed in the scene.

use crate::common::hands::{
    choose, enter, named, picture_place, press, scene, settle, undo, window_looking, window_of,
};
use eframe::egui::Pos2;
use eframe::egui::accesskit::{Role, Toggled};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::{App, Appearance};
use shading_lab::document::{Loaded, load_scene};
use shading_lab::scene::{Camera, CompareView, MaterialSource, Pane, Rgb};
use std::path::Path;

/// Three squares side by side: red, green, and one that the library does not define.
const MODEL: &str = "mtllib three.mtl\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 3 0\nv 1 3 0\nv 2 3 0\nv 3 3 0\n\
    usemtl red plastic\nf 1 2 6 5\nusemtl 綠\nf 2 3 7 6\nusemtl\nf 3 4 8 7\n";
const LIBRARY: &str =
    "newmtl red plastic\nKd 0.8 0.1 0.1\nKs 0.5 0.5 0.5\nNs 20\nnewmtl 綠\nKd 0.1 0.7 0.1\n";

fn loaded(name: &str) -> Loaded {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("three.mtl"), LIBRARY).expect("a library");
    let path = folder.join("three.obj");
    std::fs::write(&path, MODEL).expect("a model");
    let mut loaded = load_scene(&path).expect("a model");
    loaded.scene.camera = Camera::default();
    loaded
}

fn model(name: &str) -> Harness<'static, App> {
    window_of(loaded(name))
}

/// Returns the name of the chosen material, of those in the list.
fn chosen(harness: &Harness<'_, App>) -> Vec<&'static str> {
    let all = ["red plastic", "綠", english!("controls-model-none")];
    let is_on = |name: &&str| {
        let line = harness.query_by_role_and_label(Role::Button, name);
        line.is_some_and(|line| line.accesskit_node().toggled() == Some(Toggled::True))
    };
    all.into_iter().filter(is_on).collect()
}

/// Clicks the picture at a part of its width, in the middle of its height.
fn click(harness: &mut Harness<'_, App>, part: f32) {
    let place = picture_place(harness);
    let at = Pos2::new(place.min.x + part * place.width(), place.center().y);
    harness.hover_at(at);
    harness.run_ok();
    harness.drag_at(at);
    harness.step();
    harness.drop_at(at);
    settle(harness);
}

#[test]
fn what_is_clicked_is_chosen_and_changed_in_the_scene() {
    let mut harness = model("window-model-materials");
    click(&mut harness, 0.5);
    assert_eq!(chosen(&harness), ["綠"]);
    let before = scene(&harness).clone();
    let place = picture_place(&harness);
    let side = 0.16 * place.height() / place.width();
    click(&mut harness, 0.5 - side);
    assert_eq!(chosen(&harness), ["red plastic"]);
    enter(&mut harness, "material.n", 5.0);
    let [change] = &scene(&harness).object.materials[..] else {
        panic!("{:?}", scene(&harness).object.materials)
    };
    assert_eq!((change.name.as_str(), change.n), ("red plastic", Some(5.0)));
    assert!(
        change.kd.is_none() && change.ks.is_none(),
        "the others stay the model's"
    );
    assert_eq!(scene(&harness).material, before.material);
    // Another one is chosen in the list, and the first keeps its change.
    press(&mut harness, "綠");
    assert_eq!(chosen(&harness), ["綠"]);
    enter(&mut harness, "material.kd", 0.35);
    let changed = scene(&harness).object.materials.clone();
    assert_eq!(changed.len(), 2);
    assert_eq!(
        changed[1].kd.map(|kd| kd.0),
        Some(Rgb::new(0.05, 0.35, 0.05))
    );
    undo(&mut harness);
    assert_eq!(scene(&harness).object.materials.len(), 1);
    undo(&mut harness);
    assert_eq!(*scene(&harness), before);
    // The button of a row takes the change away.
    enter(&mut harness, "material.kd", 0.35);
    press(
        &mut harness,
        &english!("controls-reset", name = named("material.kd")),
    );
    assert_eq!(*scene(&harness), before);
    // The third square has the scene's own material.
    click(&mut harness, 0.5 + side);
    assert_eq!(chosen(&harness), [english!("controls-model-none")]);
    enter(&mut harness, "material.kd", 0.35);
    assert_eq!(scene(&harness).object.materials, []);
    assert!(scene(&harness).material.kd != before.material.kd);
    assert_eq!(
        std::fs::read_to_string(
            Path::new(env!("CARGO_TARGET_TMPDIR")).join("window-model-materials/three.mtl")
        )
        .expect("a library"),
        LIBRARY
    );
}

#[test]
fn a_clicked_letter_opens_the_panel_which_shows_whose_it_is() {
    let mut stored = Appearance::default();
    (stored.controls, stored.views) = (false, false);
    let loaded = loaded("window-model-letter");
    let mut harness = window_looking(loaded, [1280.0, 800.0], &stored, |app| app);
    assert!(chosen(&harness).is_empty(), "the panel is closed");
    let letter = format!("Exponent {}", english!("in-equation"));
    harness.get_by_label(&letter).click();
    settle(&mut harness);
    assert_eq!(chosen(&harness).len(), 1);
}

#[test]
fn the_scenes_material_for_all_hides_the_list() {
    let mut harness = model("window-model-source");
    assert!(!chosen(&harness).is_empty());
    choose(&mut harness, "material.source", "scene");
    assert_eq!(scene(&harness).material.source, MaterialSource::Scene);
    assert!(chosen(&harness).is_empty());
    enter(&mut harness, "material.n", 5.0);
    assert_eq!(
        (
            scene(&harness).material.n,
            scene(&harness).object.materials.len()
        ),
        (5.0, 0)
    );
    undo(&mut harness);
    undo(&mut harness);
    assert!(!chosen(&harness).is_empty());
}

#[test]
fn a_change_in_one_pane_of_two_goes_to_both() {
    let mut loaded = loaded("window-model-panes");
    loaded.scene.compare.view = CompareView::Panes;
    loaded.scene.compare.panes = vec![Pane::of(&["shading.mode=flat"])];
    let mut harness = window_of(loaded);
    press(&mut harness, "red plastic");
    enter(&mut harness, "material.n", 5.0);
    let session = &harness.state().state().session;
    let of = |pane| session.panes.scene(pane).object.materials.clone();
    assert_eq!((of(0).len(), of(0)), (1, of(1)));
}

#[test]
fn a_term_is_switched_off_in_every_material_and_on_again() {
    let mut harness = model("window-model-terms");
    let before = scene(&harness).clone();
    let switch = |harness: &mut Harness<'_, App>| {
        let term = harness.get_by_role_and_label(Role::CheckBox, english!("term-diffuse"));
        term.click_accesskit();
        settle(harness);
    };
    switch(&mut harness);
    let changes = &scene(&harness).object.materials;
    let off: Vec<_> = changes
        .iter()
        .map(|change| change.kd.map(|kd| kd.0))
        .collect();
    assert_eq!(off, [Some(Rgb::ZERO); 2]);
    assert_eq!(scene(&harness).material.kd, Rgb::ZERO);
    switch(&mut harness);
    assert_eq!(*scene(&harness), before);
}
