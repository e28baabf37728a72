//! What the window says beside the picture: the equation filled in, the curves, the profile, the scene as code.

#[path = "common/window.rs"]
mod hands;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, OutputCommand, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{AccessKitNode, NodeT, Queryable};
use hands::{drag, press, scene, wait, window};
use shading_lab::analysis::{ProbeHit, probe};
use shading_lab::app::{App, NumbersTab};
use shading_lab::export::{glsl_330, opengl_c, opengl_c_snippet};
use shading_lab::geometry::tessellate;
use shading_lab::render::Renderer;
use shading_lab::scene::{Reflectance, presets};
use std::path::Path;

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
