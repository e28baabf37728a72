//! The window without a screen: controls are found by role and name, change the picture, and undo takes that back.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, OutputCommand, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{AccessKitNode, NodeT, Queryable};
use shading_lab::analysis::{ProbeHit, probe};
use shading_lab::app::{App, NumbersTab};
use shading_lab::document::load;
use shading_lab::export::{glsl_330, opengl_c, opengl_c_snippet};
use shading_lab::geometry::tessellate;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Distribution, LightKind, PatternKind, Reflectance, ReflectionModel, Rgb, Scene, ShadingMode, presets,
};
use std::path::Path;

fn window(scene: &str) -> Harness<'static, App> {
    let loaded = load(Path::new(scene)).expect("a built-in scene");
    let mut harness =
        Harness::builder().with_size([1280.0, 800.0]).with_max_steps(40).build_eframe(|cc| App::new(cc, loaded));
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

/// Clicks a button by its name.
fn press(harness: &mut Harness<'_, App>, name: &str) {
    harness.get_by_role_and_label(Role::Button, name).click_accesskit();
    harness.run();
}

/// Opens a section of the panel.
fn unfold(harness: &mut Harness<'_, App>, title: &str) {
    harness.get_by_role_and_label(Role::DisclosureTriangle, title).click_accesskit();
    harness.run();
}

/// Types a number into a field by its name.
fn enter(harness: &mut Harness<'_, App>, name: &str, value: f64) {
    harness.get_by_role_and_label(Role::SpinButton, name).set_value_accesskit(value);
    harness.run();
}

fn undo(harness: &mut Harness<'_, App>) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
}

/// Looks at the window until `condition` holds.
fn wait(harness: &mut Harness<'_, App>, condition: impl Fn(&Harness<'_, App>) -> bool) -> bool {
    for _ in 0..500 {
        harness.run_ok();
        if condition(harness) {
            return true;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    false
}

#[test]
fn a_spot_lights_cone_is_typed() {
    let mut harness = window("sphere");
    assert!(harness.query_by_role_and_label(Role::SpinButton, "Light 1 cone").is_none(), "a point has no cone");
    choose(&mut harness, "Light 1 kind", "spot");
    for (name, value) in
        [("Light 1 cone", 6.0), ("Light 1 softness", 0.8), ("Light 1 exponent", 90.0), ("Light 1 direction x", -2.0)]
    {
        let before = picture(&harness);
        enter(&mut harness, name, value);
        assert!(picture(&harness) != before, "{name} = {value} changes nothing");
    }
    assert_eq!((scene(&harness).lights[0].kind, scene(&harness).lights[0].cone), (LightKind::Spot, 6.0));
    enter(&mut harness, "Light 1 cone", 500.0);
    assert_eq!(scene(&harness).lights[0].cone, 90.0, "a cone is at most a half-space");
}

#[test]
fn lights_are_muted_and_soloed() {
    let mut harness = window("three-lights");
    let all = picture(&harness);
    press(&mut harness, "Light 1 mute");
    let muted = picture(&harness);
    assert!(scene(&harness).lights[0].mute && muted != all);
    assert!(harness.query_by_role_and_label(Role::ComboBox, "Light 1 kind").is_some(), "its controls stay");
    press(&mut harness, "Reset Light 1");
    assert!(picture(&harness) == all);
    press(&mut harness, "Light 2");
    press(&mut harness, "Light 2 solo");
    assert!(scene(&harness).lights[1].solo);
    assert!(picture(&harness) != all && picture(&harness) != muted);
    undo(&mut harness);
    assert!(picture(&harness) == all);
}

#[test]
fn a_light_is_named() {
    let mut harness = window("sphere");
    let before = picture(&harness);
    harness.get_by_role_and_label(Role::TextInput, "Light 1 name").focus();
    harness.run();
    harness.get_by_role_and_label(Role::TextInput, "Light 1 name").type_text("Key\u{7} lamp");
    harness.run();
    assert_eq!(scene(&harness).lights[0].name, "Key lamp");
    assert!(harness.query_by_role_and_label(Role::Button, "Light 1, Key lamp").is_some(), "its chip says so");
    harness.get_by_role_and_label(Role::TextInput, "Light 1 name").type_text(&"x".repeat(100));
    harness.run();
    assert_eq!(scene(&harness).lights[0].name.chars().count(), 64);
    assert_eq!(scene(&harness).validate(), Ok(()));
    assert!(picture(&harness) == before, "a name is not seen");
}

#[test]
fn an_area_lights_points_and_their_error_are_shown() {
    let mut harness = window("sphere");
    choose(&mut harness, "Light 1 kind", "area");
    let shown = |text: &'static str| move |harness: &Harness<'_, App>| harness.query_by_label_contains(text).is_some();
    assert!(wait(&mut harness, shown("N = 16: error ")), "the error of the default");
    let before = picture(&harness);
    enter(&mut harness, "Light 1 samples", 1.0);
    assert!(picture(&harness) != before);
    assert!(wait(&mut harness, shown("N = 1: error ")), "the error of one point");
    choose(&mut harness, "Light 1 shape", "sphere");
    assert!(harness.query_by_role_and_label(Role::SpinButton, "Light 1 width").is_none(), "a sphere has no width");
    enter(&mut harness, "Light 1 radius", 1.5);
    assert_eq!(scene(&harness).lights[0].radius, 1.5);
    press(&mut harness, "Light 1 mute");
    assert!(wait(&mut harness, shown("does not reach the picture")), "a muted light has no error");
}

#[test]
fn microfacets_have_a_roughness_instead_of_n() {
    let mut harness = window("sphere");
    let is_there = |harness: &Harness<'_, App>, name| harness.query_by_role_and_label(Role::Slider, name).is_some();
    assert!(is_there(&harness, "n") && !is_there(&harness, "m roughness"));
    choose(&mut harness, "Reflection model", "Cook–Torrance  D·G");
    assert!(!is_there(&harness, "n") && is_there(&harness, "m roughness"));
    let before = picture(&harness);
    enter(&mut harness, "m roughness", 0.5);
    let rough = picture(&harness);
    assert!(rough != before);
    choose(&mut harness, "Microfacet distribution", "GGX");
    assert_eq!(scene(&harness).reflection.distribution, Distribution::Ggx);
    assert!(picture(&harness) != rough);
}

#[test]
fn another_model_with_an_equally_wide_highlight_is_one_step() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    press(&mut harness, "Match with Blinn's n");
    assert_eq!(scene(&harness).reflection.model, ReflectionModel::Blinn);
    assert!((scene(&harness).material.n / before.material.n - 4.0).abs() < 0.1, "n = {}", scene(&harness).material.n);
    undo(&mut harness);
    assert_eq!(*scene(&harness), before);
    press(&mut harness, "Match with a roughness");
    assert_eq!(scene(&harness).reflection.model, ReflectionModel::CookTorrance);
}

#[test]
fn the_reflectance_of_a_metal_changes_the_picture() {
    for entry in ["glass", "silver", "gold"] {
        choice_changes_the_picture("sphere", &[], "W(θ) reflectance", entry);
    }
    let mut harness = window("sphere");
    assert!(harness.query_by_role_and_label(Role::SpinButton, "k extinction red").is_none());
    choose(&mut harness, "W(θ) reflectance", "of η and k");
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
    let mut harness = window("sphere");
    assert!(harness.query_by_role_and_label(Role::SpinButton, "Kt").is_none(), "the section is folded at first");
    unfold(&mut harness, "Transparency");
    let index = harness.get_by_role_and_label(Role::SpinButton, "η relative index");
    assert!(index.accesskit_node().is_disabled(), "nothing is transmitted");
    enter(&mut harness, "Kt", 0.5);
    enter(&mut harness, "η relative index", 1.33);
    assert_eq!((scene(&harness).transparency.kt, scene(&harness).transparency.ior), (0.5, 1.33));
    assert!(harness.query_by_role_and_label(Role::Button, "Transmitted in the equation").is_some());
    unfold(&mut harness, "Surroundings");
    press(&mut harness, "Shadows on");
    press(&mut harness, "Ground on");
    enter(&mut harness, "Ground height", -0.5);
    choose(&mut harness, "Backdrop", "stripes");
    enter(&mut harness, "Backdrop distance", 3.0);
    choose(&mut harness, "Ambient source", "one bounce");
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
    assert_eq!(scene(&harness).material.ka, Rgb::new(0.24725, 0.1995, 0.0745));
    assert_eq!(scene(&harness).material.n, 51.2);
    undo(&mut harness);
    assert_eq!(*scene(&harness), before);
}

#[test]
fn the_pixels_above_one_are_counted() {
    let mut harness = window("flat-facets");
    enter(&mut harness, "Light 1 Ip red", 0.5);
    assert!(harness.query_by_label("No pixel is above 1").is_some());
    enter(&mut harness, "Light 1 Ip red", 3.0);
    assert!(harness.query_by_label_contains("pixels are above 1").is_some());
}

/// Drags from one place of the window to another.
fn drag(harness: &mut Harness<'_, App>, from: Pos2, to: Pos2) {
    harness.drag_at(from);
    harness.run();
    harness.hover_at(to);
    harness.run();
    harness.drop_at(to);
    harness.run();
}

#[test]
fn a_spot_lights_arrow_is_dragged() {
    let mut harness = window("sphere");
    choose(&mut harness, "Light 1 kind", "spot");
    let before = scene(&harness).clone();
    // The light has been aimed at the camera's target, so that its arrow ends in the picture's middle.
    let middle = harness.get_by_role_and_label(Role::Image, "Picture, phong shading").rect().center();
    drag(&mut harness, middle, middle + vec2(60.0, 20.0));
    let turned = scene(&harness).clone();
    assert!(turned.lights[0].direction.angle_between(before.lights[0].direction) > 0.02, "the arrow was turned");
    assert_eq!((turned.camera, turned.lights[0].position), (before.camera.clone(), before.lights[0].position));
    undo(&mut harness);
    assert_eq!(*scene(&harness), before, "a drag is one step");
    // Beside the handles the camera turns.
    drag(&mut harness, middle - vec2(0.0, 150.0), middle - vec2(50.0, 150.0));
    assert_eq!(scene(&harness).lights, before.lights);
    assert!(scene(&harness).camera != before.camera);
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

/// The text in the dialog.
fn code(harness: &Harness<'_, App>) -> String {
    let view = harness.query_by_role_and_label(Role::MultilineTextInput, "Code");
    view.and_then(|view| view.accesskit_node().value()).unwrap_or_default()
}

fn tab(harness: &mut Harness<'_, App>, name: &str) {
    harness.get_by_role_and_label(Role::Tab, name).click_accesskit();
    harness.run();
}

/// What was put on the clipboard since the window was last run.
fn copied(harness: &Harness<'_, App>) -> Option<String> {
    let text = |command: &OutputCommand| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    };
    harness.output().platform_output.commands.iter().find_map(text)
}

#[test]
fn the_scene_is_shown_as_code_in_three_ways() {
    let mut harness = window("three-lights");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::U);
    harness.run();
    assert!(wait(&mut harness, |harness| code(harness).contains("void set_up_lights(void)")), "{}", code(&harness));
    assert!(harness.query_by_label_contains("Phong's (R.V)^n").is_some(), "what the calls do not say");
    let scene = scene(&harness).clone();
    let expected = opengl_c_snippet(&scene, &tessellate(&scene.object));
    assert_eq!(code(&harness), expected.parts[0].text);

    tab(&mut harness, "GLSL 330");
    assert!(wait(&mut harness, |harness| code(harness).contains("gl_Position")));
    assert_eq!(code(&harness), glsl_330(&scene).parts[0].text);
    press(&mut harness, "fragment shader");
    assert_eq!(code(&harness), glsl_330(&scene).parts[1].text);
    assert!(harness.query_by_label("It expresses the scene completely.").is_some());

    tab(&mut harness, "Whole program in C");
    assert!(
        wait(&mut harness, |harness| code(harness).contains("eglInitialize") || code(harness).lines().count() == 200)
    );
    let program = opengl_c(&scene, &tessellate(&scene.object)).expect("a mesh of moderate size").parts[0].text.clone();
    assert_eq!(code(&harness).lines().count(), 200);
    assert!(program.starts_with(&code(&harness)));
    let many = format!("of {} lines", program.lines().count());
    assert!(harness.query_by_label_contains(&many).is_some(), "{many}");
    harness.get_by_role_and_label(Role::Button, "Copy").click_accesskit();
    harness.step();
    assert_eq!(copied(&harness), Some(program), "copying takes all of it");
    harness.run();
    harness.key_press(Key::Escape);
    harness.run();
    assert!(harness.query_by_role_and_label(Role::Tab, "GLSL 330").is_none(), "the dialog has gone");
}

#[test]
fn code_is_saved_and_a_path_that_cannot_be_written_is_named() {
    let folder = std::env::temp_dir().join(format!("shading-lab-code-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    let mut harness = window("sphere");
    press(&mut harness, "Edit");
    press(&mut harness, "Code… Ctrl + U");
    tab(&mut harness, "GLSL 330");
    assert!(wait(&mut harness, |harness| !code(harness).is_empty()));
    let save_to = |harness: &mut Harness<'_, App>, path: &Path| {
        press(harness, "Save…");
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.run();
        harness.get_by_role_and_label(Role::TextInput, "File").type_text(&path.display().to_string());
        harness.run();
        press(harness, "Save");
    };
    save_to(&mut harness, &folder.join("no/such/ball.vert"));
    assert!(harness.query_by_label_contains("its folder does not exist").is_some());
    harness.key_press(Key::Escape);
    harness.run();
    assert!(harness.query_by_role_and_label(Role::TextInput, "File").is_none(), "one step back");
    save_to(&mut harness, &folder.join("ball.vert"));
    let said = harness.query_by_label_contains("saved ").is_some();
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap_or_default();
    let saved = [read("ball.vert"), read("ball.frag")];
    std::fs::remove_dir_all(&folder).expect("the test's own folder");
    assert!(said);
    assert_eq!(saved.to_vec(), glsl_330(scene(&harness)).parts.iter().map(|p| p.text.clone()).collect::<Vec<_>>());
    assert!(!code(&harness).is_empty(), "the dialog stays");
}

/// The probe of the window, worked out apart from it.
fn probed(harness: &Harness<'_, App>) -> ProbeHit {
    let frame = harness.state().frame();
    let mut scene = scene(harness).clone();
    scene.image.size = [frame.width, frame.height];
    let [x, y] = harness.state().state().probe.pixel(scene.image.size);
    probe(&mut Renderer::default(), &scene, x, y).hit.expect("the probe stands on the object")
}

/// A line of the filled-in equation that begins with `name`, without it.
fn line_of(harness: &Harness<'_, App>, name: &str) -> String {
    // A screen reader has the words of a label as its value.
    let text = |node: &AccessKitNode<'_>| node.label().or_else(|| node.value()).unwrap_or_default();
    let node = harness.get_by(|node| text(node).starts_with(name));
    text(&node.accesskit_node())[name.len()..].to_owned()
}

fn parsed(text: &str) -> f64 {
    text.trim().replace('−', "-").replace("·10^", "e").parse().expect("a number")
}

#[test]
fn the_equation_is_filled_in_with_the_numbers_of_the_probe() {
    let harness = window("teapot");
    let (hit, material) = (probed(&harness), &scene(&harness).material);
    let terms = [("ambient", hit.ambient), ("diffuse 1", hit.lights[0].diffuse)];
    for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
        for (term, value) in terms {
            let line = line_of(&harness, &format!("{term} {name}: "));
            let (product, shown) = line.split_once(" = ").expect("a product");
            assert!((parsed(shown) - value[channel]).abs() < 6e-5, "{term} {name}: {line}");
            let multiplied: f64 = product.split(" · ").map(parsed).product();
            assert!((multiplied / value[channel] - 1.0).abs() < 2e-3, "{term} {name}: {line}");
            assert!(product.contains(&format!("{:.2}", material.color[channel])), "Od stands in {line}");
        }
    }
    let [r, g, b] = hit.sum.to_array();
    assert_eq!(line_of(&harness, "I 0."), format!("{r:.4} red, {g:.4} green, {b:.4} blue")[2..]);
    let [r, g, b] = hit.stored;
    assert_eq!(line_of(&harness, "stored "), format!("{r} red, {g} green, {b} blue"));
    assert!(harness.query_by_label_contains("transparency red").is_none(), "the teapot is opaque");
}

#[test]
fn a_silent_light_is_named_with_the_reason() {
    let mut harness = window("three-lights");
    let says = |harness: &Harness<'_, App>, light: &str| line_of(harness, &format!("light {light} at the probe: "));
    assert!(says(&harness, "1").ends_with("blue"));
    press(&mut harness, "Light 1 mute");
    assert_eq!(says(&harness, "1"), "muted");
    assert!(harness.query_by_label_contains("It is muted: it adds nothing").is_some(), "the chosen light is unfolded");
    press(&mut harness, "Light 2");
    press(&mut harness, "Light 2 solo");
    assert_eq!((says(&harness, "1"), says(&harness, "3")), ("muted".into(), "another is soloed".into()));
    let [r, g, b] = (probed(&harness).lights[1].diffuse + probed(&harness).lights[1].specular).to_array();
    assert_eq!(says(&harness, "2"), format!("{r:.4} red, {g:.4} green, {b:.4} blue"));
}

#[test]
fn the_mixture_with_transmitted_light_is_filled_in_where_there_is_any() {
    let harness = window("glass-ball");
    let hit = probed(&harness);
    let through = hit.transmission.expect("glass");
    let line = line_of(&harness, "transparency green: ");
    assert!(line.starts_with(&format!("0.15 · {:.3} + 0.85 · ", hit.reflected.y)), "{line}");
    assert!(line.ends_with(&format!(" = {:.4}", hit.sum.y)), "{line}");
    assert!(line_of(&harness, "transparency at the probe: ").starts_with(&through.refractions.to_string()));
    for opaque in ["sphere", "gold"] {
        assert!(window(opaque).query_by_label_contains("transparency").is_none(), "{opaque}");
    }
}

#[test]
fn lights_unfold_by_keyboard_and_their_symbols_lead_to_their_controls() {
    let mut harness = window("three-lights");
    let rows = |harness: &Harness<'_, App>, light: u32| {
        harness.query_by_label_contains(&format!("diffuse {light} red: ")).is_some()
    };
    assert!(rows(&harness, 1) && !rows(&harness, 2), "the chosen light is unfolded, the others are not");
    harness.get_by(|node| node.label().is_some_and(|label| label.starts_with("light 2 at the"))).focus();
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert!(rows(&harness, 1) && rows(&harness, 2));
    let count = harness.query_all_by_role_and_label(Role::Button, "Kd at the probe").count();
    assert_eq!(count, 2, "a symbol stands in each light's terms");
    let second = harness.query_all_by_role_and_label(Role::Button, "Ip at the probe").nth(2).expect("light 2");
    second.click_accesskit();
    harness.run();
    assert_eq!(harness.state().state().light, 1, "Ip of light 2 leads to the controls of light 2");
    assert!(harness.query_by_role_and_label(Role::ComboBox, "Light 2 kind").is_some());
    assert!(rows(&harness, 2) && !rows(&harness, 1), "another light has been chosen");
}

#[test]
fn every_way_of_evaluating_fills_the_equation_in() {
    let mut harness = window("soft-shadow");
    assert!(harness.query_by_label_contains("A sum over 64 points of the light").is_some());
    for key in [Key::Num1, Key::Num2, Key::Num3] {
        harness.key_press(key);
        harness.run();
        let (line, value) = (line_of(&harness, "diffuse 1 red: "), probed(&harness).lights[0].diffuse.x);
        let (_, shown) = line.split_once(" = ").expect("a product");
        assert!((parsed(shown) - value).abs() < 6e-5, "{line}, {value}");
    }
}

/// Runs the window until the profile has been taken on its thread.
fn until_taken(harness: &mut Harness<'_, App>) {
    for _ in 0..400 {
        harness.run_ok();
        if harness.query_by_label("The bands: what the eye adds").is_some() {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    panic!("no profile has come");
}

#[test]
fn the_profile_has_a_tab_whose_line_is_dragged_in_the_picture() {
    let mut harness = window("flat-facets");
    harness.get_by_role_and_label(Role::Tab, "Profile").click_accesskit();
    until_taken(&mut harness);
    assert_eq!(harness.state().state().look.tab, NumbersTab::Profile);
    for title in ["Gouraud: what is there and what is seen", "The slope, which jumps where bands are seen"] {
        assert!(harness.query_by_label(title).is_some(), "{title}");
    }
    assert!(harness.query_by_label("Flat: what is there and what is seen").is_none());
    harness.get_by_label("Flat").click_accesskit();
    harness.run_ok();
    for _ in 0..400 {
        if harness.query_by_label("Flat: what is there and what is seen").is_some() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
        harness.run_ok();
    }
    assert!(harness.query_by_label("Flat: what is there and what is seen").is_some());
    // The end of the line, where the picture and the state have it.
    let before = harness.state().state().line;
    let scene_before = scene(&harness).clone();
    let (width, height) = (harness.state().frame().width, harness.state().frame().height);
    let rect = harness.get_by(|node| node.label().is_some_and(|label| label.starts_with("Picture,"))).rect();
    let scale = rect.height() / height as f32;
    let [_, end] = before.pixels([width, height]);
    let at = rect.min + vec2(end.x as f32, end.y as f32) * scale;
    drag(&mut harness, at, at + vec2(-40.0, 30.0));
    let after = harness.state().state().line.pixels([width, height]);
    assert!((after[1] - end - glam::DVec2::new(-40.0, 30.0) / f64::from(scale)).length() < 3.0, "{after:?} from {end}");
    assert_eq!(*scene(&harness), scene_before, "the camera stays");
    for ending in ["CSV…", "PNG…", "SVG…"] {
        assert!(harness.query_by_label(ending).is_some(), "{ending}");
    }
}
