//! The window without a screen: controls are found by role and name, change the picture, and undo takes that back.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::{App, NumbersTab};
use shading_lab::document::load;
use shading_lab::scene::{Reflectance, Scene, ShadingMode, presets};
use std::path::Path;

fn window(scene: &str) -> Harness<'static, App> {
    let loaded = load(Path::new(scene)).expect("a built-in scene");
    let mut harness = Harness::builder().with_size([1280.0, 800.0]).build_eframe(|cc| App::new(cc, loaded));
    harness.run();
    harness
}

fn picture(harness: &Harness<'_, App>) -> Vec<[u8; 4]> {
    harness.state().frame().pixels.clone()
}

fn scene<'h>(harness: &'h Harness<'_, App>) -> &'h Scene {
    &harness.state().state().document.scene
}

/// Sets a slider by its accessible name, sees the picture change, and takes it back.
fn slider_changes_the_picture(scene: &str, name: &str, value: f64) {
    let mut harness = window(scene);
    let before = picture(&harness);
    harness.get_by_role_and_label(Role::Slider, name).set_value_accesskit(value);
    harness.run();
    assert!(picture(&harness) != before, "{name} = {value} changes nothing in {scene}");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
    assert!(picture(&harness) == before, "undo of {name} does not bring the picture back");
}

#[test]
fn every_slider_of_the_material_changes_the_picture() {
    for (name, value) in [("Ka", 0.6), ("Kd", 0.2), ("Ks", 0.0), ("n", 3.0)] {
        slider_changes_the_picture("sphere", name, value);
    }
}

#[test]
fn tessellation_changes_the_picture() {
    slider_changes_the_picture("flat-facets", "Segments", 7.0);
    slider_changes_the_picture("flat-facets", "Rings", 5.0);
}

#[test]
fn keys_choose_the_shading_mode() {
    let modes = [
        (Key::Num1, ShadingMode::Flat, true),
        (Key::Num2, ShadingMode::Interpolated, true),
        (Key::Num3, ShadingMode::Gouraud, true),
        (Key::Num5, ShadingMode::Exact, true),
        (Key::Num6, ShadingMode::Phong, false),
        (Key::Num4, ShadingMode::Phong, true),
    ];
    let mut harness = window("torus");
    let mut seen = vec![picture(&harness)];
    for (key, mode, renormalise) in modes {
        harness.key_press(key);
        harness.run();
        assert_eq!((scene(&harness).shading.mode, scene(&harness).shading.renormalise), (mode, renormalise));
        seen.push(picture(&harness));
    }
    seen.sort();
    seen.dedup();
    assert_eq!(seen.len(), 6, "six ways of shading are six pictures, and the last is the first again");
}

#[test]
fn a_number_can_be_infinite() {
    let mut harness = window("sphere");
    let before = picture(&harness);
    harness.get_by_role_and_label(Role::Button, "n infinite").click_accesskit();
    harness.run();
    assert_eq!(scene(&harness).material.n, f64::INFINITY);
    assert!(picture(&harness) != before);
}

#[test]
fn lights_are_added_and_removed() {
    let mut harness = window("sphere");
    let before = picture(&harness);
    harness.get_by_role_and_label(Role::Button, "Add a light").click_accesskit();
    harness.run();
    assert_eq!(scene(&harness).lights.len(), 2);
    let lit = picture(&harness);
    assert!(lit != before, "another light changes the picture");
    harness.get_by_role_and_label(Role::Button, "Remove this light").click_accesskit();
    harness.run();
    assert!(picture(&harness) == before);
}

#[test]
fn a_control_without_effect_is_disabled() {
    let mut harness = window("sphere");
    harness.get_by_role_and_label(Role::Slider, "Ks").set_value_accesskit(0.0);
    harness.run();
    let n = harness.get_by_role_and_label(Role::Slider, "n");
    assert!(n.accesskit_node().is_disabled(), "n has no effect without Ks");
}

#[test]
fn keys_turn_the_camera_and_move_the_probe() {
    let mut harness = window("sphere");
    let before = scene(&harness).camera.eye;
    harness.key_press(Key::D);
    harness.run();
    assert!(scene(&harness).camera.eye.distance(before) > 0.1);
    assert!((scene(&harness).camera.eye.length() - before.length()).abs() < 1e-9, "turning keeps the distance");
    let probe = harness.state().state().probe;
    harness.key_press(Key::ArrowLeft);
    harness.run();
    assert!(harness.state().state().probe != probe);
}

#[test]
fn a_file_that_cannot_be_opened_says_so_and_changes_nothing() {
    let folder = std::env::temp_dir().join(format!("shading-lab-window-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    let path = folder.join("broken.toml");
    std::fs::write(&path, "version = 1\n[material]\nn = -3\n").expect("a file for the test");
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    harness.run();
    harness.get_by_role_and_label(Role::TextInput, "File").type_text(&path.display().to_string());
    harness.run();
    harness.get_by_role_and_label(Role::Button, "Open").click_accesskit();
    let mut shown = false;
    for _ in 0..200 {
        harness.run_ok();
        shown = harness.query_by_label_contains("broken.toml:3").is_some();
        if shown {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    std::fs::remove_dir_all(&folder).expect("the test's own folder");
    assert!(shown, "the dialog names the file and the line");
    assert!(*scene(&harness) == before, "the scene is left alone");
}

/// Chooses an entry of a list by the names of both.
fn choose(harness: &mut Harness<'_, App>, list: &str, entry: &str) {
    harness.get_by_role_and_label(Role::ComboBox, list).scroll_to_me();
    harness.run();
    harness.get_by_role_and_label(Role::ComboBox, list).click_accesskit();
    harness.run();
    harness.get_by_role_and_label(Role::Button, entry).click_accesskit();
    harness.run();
}

/// Makes a choice, sees the picture change, and takes it back.
fn choice_changes_the_picture(scene: &str, prepare: &[Key], list: &str, entry: &str) {
    let mut harness = window(scene);
    for key in prepare {
        harness.key_press(*key);
        harness.run();
    }
    let before = picture(&harness);
    choose(&mut harness, list, entry);
    assert!(picture(&harness) != before, "{list}: {entry} changes nothing in {scene}");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
    assert!(picture(&harness) == before, "undo of {list} does not bring the picture back");
}

#[test]
fn controls_appear_where_they_have_an_effect() {
    let mut harness = window("cone");
    assert!(harness.query_by_role_and_label(Role::ComboBox, "Weighting").is_none(), "exact normals have no weights");
    choose(&mut harness, "Vertex normals", "averaged");
    let equal = picture(&harness);
    choose(&mut harness, "Weighting", "by angle");
    assert!(picture(&harness) != equal);

    assert!(harness.query_by_role_and_label(Role::SpinButton, "Height").is_none());
    choose(&mut harness, "Projection", "orthographic");
    assert!(harness.query_by_role_and_label(Role::SpinButton, "Field of view").is_none());
    let near = picture(&harness);
    harness.get_by_role_and_label(Role::SpinButton, "Height").set_value_accesskit(5.0);
    harness.run();
    assert!(picture(&harness) != near);
}

#[test]
fn every_choice_changes_the_picture() {
    let choices: [(&str, &[Key], &str, &str); 15] = [
        ("sphere", &[], "Reflection model", "Blinn  (N·H)^n"),
        ("sphere", &[], "Back-facing policy", "turn N about"),
        ("sphere", &[], "Light 1 kind", "directional"),
        ("sphere", &[], "Light 1 attenuation", "1/d²"),
        ("sphere", &[], "Object kind", "torus"),
        ("cylinder", &[], "Vertex normals", "each polygon's own"),
        ("cone", &[], "Vertex normals", "averaged"),
        ("sphere", &[], "Projection", "orthographic"),
        ("sphere", &[], "Viewer", "at infinity"),
        ("sphere", &[], "Overflow", "hatched"),
        ("sphere", &[], "Overflow", "scale the picture"),
        ("sphere", &[], "Encoding", "sRGB"),
        ("attenuation", &[Key::Num1], "Flat at", "at the first corner"),
        ("highlight", &[Key::Num3], "Interpolation", "affine"),
        ("torus", &[Key::Num3], "Interpolation", "scan line"),
    ];
    for (scene, prepare, list, entry) in choices {
        println!("{scene}: {list}: {entry}");
        choice_changes_the_picture(scene, prepare, list, entry);
    }
}

#[test]
fn typed_numbers_change_the_picture() {
    let fields = [
        ("Od surface colour red", 0.1),
        ("Ia ambient light red", 0.0),
        ("Light 1 position x", -3.0),
        ("Light 1 Ip green", 0.2),
        ("Field of view", 70.0),
        ("Eye x", 3.0),
        ("Target y", 0.4),
        ("Background blue", 0.9),
    ];
    for (name, value) in fields {
        let mut harness = window("sphere");
        let before = picture(&harness);
        harness.get_by_role_and_label(Role::SpinButton, name).set_value_accesskit(value);
        harness.run();
        assert!(picture(&harness) != before, "{name} = {value} changes nothing");
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        harness.run();
        assert!(picture(&harness) == before, "undo of {name} does not bring the picture back");
    }
}

#[test]
fn the_curves_have_a_tab_of_their_own_that_follows_the_scene() {
    let mut harness = window("attenuation");
    let titles =
        ["A light weakens with distance", "The highlight falls with φ", "What the point reflects to every side"];
    assert!(harness.query_by_role_and_label(Role::Tab, "Equation").is_some());
    assert!(harness.query_by_label(titles[1]).is_none(), "the equation is shown first");
    harness.get_by_role_and_label(Role::Tab, "Curves").click_accesskit();
    harness.run();
    assert_eq!(harness.state().state().look.tab, NumbersTab::Curves);
    for title in titles {
        assert!(harness.query_by_label(title).is_some(), "{title}");
    }
    assert!(harness.query_by_label("What gold reflects by angle").is_none(), "W is constant");
    let described = |harness: &Harness<'_, App>| {
        let plot = harness
            .get_by(|node| node.role() == Role::Image && node.label().is_some_and(|label| label.contains("(R·V)ⁿ")));
        plot.accesskit_node().label().unwrap_or_default()
    };
    let before = described(&harness);
    assert!(before.contains("probe: φ ="), "{before}");
    harness.get_by_role_and_label(Role::Slider, "n").set_value_accesskit(3.0);
    harness.run();
    assert!(described(&harness) != before, "the probe's value follows n");
    harness.key_press(Key::C);
    harness.run();
    assert!(harness.query_by_label(titles[1]).is_none());
}

#[test]
fn a_curve_is_read_under_the_pointer_without_a_missing_letter() {
    let folder = std::env::temp_dir().join(format!("shading-lab-curves-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    let path = folder.join("gold.toml");
    let mut gold = (presets::find("attenuation").expect("a built-in scene").build)();
    gold.material.reflectance = Reflectance::Gold;
    std::fs::write(&path, gold.to_toml()).expect("a file for the test");
    let mut harness = window(&path.display().to_string());
    std::fs::remove_dir_all(&folder).expect("the test's own folder");
    for key in [Key::C, Key::B] {
        harness.key_press(key);
        harness.run();
    }
    assert!(harness.state().state().look.overlay.lobe);
    let plots: Vec<_> = harness
        .query_all_by(|node| node.role() == Role::Image && node.label().is_some_and(|label| label.contains("; ")))
        .map(|node| node.rect())
        .collect();
    assert_eq!(plots.len(), 4, "f, the family, W and the lobe");
    for rect in plots {
        for share in [0.3, 0.6] {
            harness.hover_at(rect.min + rect.size() * share);
            harness.run();
        }
    }
}
