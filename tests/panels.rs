//! What the window says beside the picture: the equation filled in, the curves, the profile, the scene as code.

#[path = "common/window.rs"]
mod hands;

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, OutputCommand, PointerButton, Pos2, Shape, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{AccessKitNode, NodeT, Queryable};
use glam::{DVec3, Vec3Swizzles};
use hands::{choose, drag, enter, folded, open_view, press, scene, undo, wait, window, window_of};
use shading_lab::analysis::{ANALYSES, ProbeHit, pane_areas, probe};
use shading_lab::app::{App, Look, Profiles, ViewName};
use shading_lab::document::load;
use shading_lab::export::{glsl_330, opengl_c, opengl_c_snippet};
use shading_lab::geometry::tessellate;
use shading_lab::render::Renderer;
use shading_lab::scene::{Compare, ObjectKind, Reflectance, Rgb, ShadingMode, View, presets};
use std::path::Path;

#[test]
fn the_curves_have_a_tab_of_their_own_that_follows_the_scene() {
    let mut harness = window("attenuation");
    let titles = [
        "Attenuation by distance",
        "Specular lobe cosⁿφ",
        "Reflected intensity by direction",
    ];
    assert_eq!(
        harness.state().state().look.view,
        ViewName::Curves,
        "the scene names its tab"
    );
    open_view(&mut harness, "Equation");
    assert!(
        harness.query_by_label(titles[1]).is_none(),
        "the equation is shown"
    );
    open_view(&mut harness, "Curves");
    assert_eq!(harness.state().state().look.view, ViewName::Curves);
    for title in titles {
        assert!(harness.query_by_label(title).is_some(), "{title}");
    }
    assert!(
        harness
            .query_by_label("Reflectance W(θ): constant")
            .is_some(),
        "W is constant"
    );
    let described = |harness: &Harness<'_, App>| {
        let plot = harness.get_by(|node| {
            node.role() == Role::Image && node.label().is_some_and(|label| label.contains("(R·V)ⁿ"))
        });
        plot.accesskit_node().label().unwrap_or_default()
    };
    let before = described(&harness);
    assert!(before.contains("probe: φ ="), "{before}");
    harness
        .get_by_role_and_label(Role::Slider, "n specular exponent")
        .set_value_accesskit(3.0);
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
    let mut gold = presets::find("attenuation")
        .expect("a built-in scene")
        .scene();
    gold.material.reflectance = Reflectance::Gold;
    gold.about.view.clear();
    std::fs::write(&path, gold.to_toml()).expect("a file for the test");
    let mut harness = window(&path.display().to_string());
    std::fs::remove_dir_all(&folder).expect("the test's own folder");
    for key in [Key::C, Key::B] {
        harness.key_press(key);
        harness.run();
    }
    assert!(harness.state().state().look.overlay.lobe);
    let plots: Vec<_> = harness
        .query_all_by(|node| {
            node.role() == Role::Image && node.label().is_some_and(|label| label.contains("; "))
        })
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
    view.and_then(|view| view.accesskit_node().value())
        .unwrap_or_default()
}

#[test]
fn the_plan_has_a_tab_that_the_bar_opens() {
    let mut harness = window("sphere");
    let link = harness.get_by(|node| {
        node.label()
            .is_some_and(|label| label.starts_with("left out: "))
    });
    link.click_accesskit();
    harness.run();
    assert_eq!(harness.state().state().look.view, ViewName::Plan);
    let says = |harness: &Harness<'_, App>, text: &str| {
        harness.query_all_by_label_contains(text).next().is_some()
    };
    assert!(says(&harness, "back faces — a closed solid hides them"));
    assert!(says(&harness, "side view — off"));
    assert!(says(&harness, "light 1: specular"));
    harness
        .get_by_role_and_label(Role::Slider, "n specular exponent")
        .set_value_accesskit(3.0);
    harness.run();
    assert!(says(&harness, "□ Coverage") && says(&harness, "kept") && says(&harness, "■ Pixels"));
}

fn tab(harness: &mut Harness<'_, App>, name: &str) {
    open_view(harness, name);
}

/// What was put on the clipboard since the window was last run.
fn copied(harness: &Harness<'_, App>) -> Option<String> {
    let text = |command: &OutputCommand| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    };
    harness
        .output()
        .platform_output
        .commands
        .iter()
        .find_map(text)
}

#[test]
fn the_scene_is_shown_as_code_in_three_ways() {
    let mut harness = window("three-lights");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::U);
    harness.run();
    assert!(
        wait(&mut harness, |harness| code(harness)
            .contains("void set_up_lights(void)")),
        "{}",
        code(&harness)
    );
    assert!(
        harness.query_by_label_contains("Phong's (R.V)^n").is_some(),
        "what the calls do not say"
    );
    let scene = scene(&harness).clone();
    let expected = opengl_c_snippet(&scene, &tessellate(&scene.object));
    assert_eq!(code(&harness), expected.parts[0].text);

    tab(&mut harness, "GLSL 330");
    assert!(wait(&mut harness, |harness| code(harness)
        .contains("gl_Position")));
    assert_eq!(code(&harness), glsl_330(&scene).parts[0].text);
    press(&mut harness, "fragment shader");
    assert_eq!(code(&harness), glsl_330(&scene).parts[1].text);
    assert!(
        harness
            .query_by_label("The code expresses the whole scene.")
            .is_some()
    );

    tab(&mut harness, "Whole program in C");
    assert!(wait(&mut harness, |harness| code(harness)
        .contains("eglInitialize")
        || code(harness).lines().count() == 200));
    let program = opengl_c(&scene, &tessellate(&scene.object))
        .expect("a mesh of moderate size")
        .parts[0]
        .text
        .clone();
    assert_eq!(code(&harness).lines().count(), 200);
    assert!(program.starts_with(&code(&harness)));
    let many = format!("of {} lines", program.lines().count());
    assert!(harness.query_by_label_contains(&many).is_some(), "{many}");
    harness
        .get_by_role_and_label(Role::Button, "Copy")
        .click_accesskit();
    harness.step();
    assert_eq!(copied(&harness), Some(program), "copying takes all of it");
    harness.run();
    harness.key_press(Key::Escape);
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::Tab, "GLSL 330")
            .is_none(),
        "the dialog has gone"
    );
}

#[test]
fn code_is_saved_and_a_path_that_cannot_be_written_is_named() {
    let folder = std::env::temp_dir().join(format!("shading-lab-code-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    let mut harness = window("sphere");
    press(&mut harness, "Edit");
    press(&mut harness, "Code…");
    tab(&mut harness, "GLSL 330");
    assert!(wait(&mut harness, |harness| !code(harness).is_empty()));
    let save_to = |harness: &mut Harness<'_, App>, path: &Path| {
        press(harness, "Save…");
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.run();
        harness
            .get_by_role_and_label(Role::TextInput, "File")
            .type_text(&path.display().to_string());
        harness.run();
        press(harness, "Save");
    };
    save_to(&mut harness, &folder.join("no/such/ball.vert"));
    assert!(
        harness
            .query_by_label_contains("its folder does not exist")
            .is_some()
    );
    harness.key_press(Key::Escape);
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::TextInput, "File")
            .is_none(),
        "one step back"
    );
    save_to(&mut harness, &folder.join("ball.vert"));
    let said = harness.query_by_label_contains("Saved ").is_some();
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap_or_default();
    let saved = [read("ball.vert"), read("ball.frag")];
    std::fs::remove_dir_all(&folder).expect("the test's own folder");
    assert!(said);
    assert_eq!(
        saved.to_vec(),
        glsl_330(scene(&harness))
            .parts
            .iter()
            .map(|p| p.text.clone())
            .collect::<Vec<_>>()
    );
    assert!(!code(&harness).is_empty(), "the dialog stays");
}

/// The probe of the window, worked out apart from it.
fn probed(harness: &Harness<'_, App>) -> ProbeHit {
    let frame = harness.state().frame();
    let mut scene = scene(harness).clone();
    scene.image.size = [frame.width, frame.height];
    let [x, y] = harness.state().state().probe.pixel(scene.image.size);
    probe(&mut Renderer::default(), &scene, x, y)
        .hit
        .expect("the probe stands on the object")
}

/// A line of the filled-in equation that begins with `name`, without it.
fn line_of(harness: &Harness<'_, App>, name: &str) -> String {
    // A screen reader has the words of a label as its value.
    let text = |node: &AccessKitNode<'_>| node.label().or_else(|| node.value()).unwrap_or_default();
    let node = harness.get_by(|node| text(node).starts_with(name));
    text(&node.accesskit_node())[name.len()..].to_owned()
}

fn parsed(text: &str) -> f64 {
    text.trim()
        .replace('−', "-")
        .replace("×10⁻⁵", "e-5")
        .parse()
        .expect("a number")
}

#[test]
fn the_equation_is_filled_in_with_the_numbers_of_the_probe() {
    let harness = window("teapot");
    let (hit, material) = (probed(&harness), &scene(&harness).material);
    let terms = [
        ("ambient", hit.ambient),
        ("diffuse 1", hit.lights[0].diffuse),
    ];
    for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
        for (term, value) in terms {
            let line = line_of(&harness, &format!("{term} {name}: "));
            let (product, shown) = line.split_once(" = ").expect("a product");
            assert!(
                (parsed(shown) - value[channel]).abs() < 6e-5,
                "{term} {name}: {line}"
            );
            let multiplied: f64 = product.split(" · ").map(parsed).product();
            assert!(
                (multiplied / value[channel] - 1.0).abs() < 2e-3,
                "{term} {name}: {line}"
            );
            assert!(
                product.contains(&format!("{:.2}", material.color[channel])),
                "Od stands in {line}"
            );
        }
    }
    let [r, g, b] = hit.sum.to_array();
    assert_eq!(
        line_of(&harness, "I 0."),
        format!("{r:.4} red, {g:.4} green, {b:.4} blue")[2..]
    );
    let [r, g, b] = hit.stored;
    assert_eq!(
        line_of(&harness, "stored "),
        format!("{r} red, {g} green, {b} blue")
    );
    assert!(
        harness
            .query_by_label_contains("transparency red")
            .is_none(),
        "the teapot is opaque"
    );
}

#[test]
fn a_silent_light_is_named_with_the_reason() {
    let mut harness = window("three-lights");
    let says = |harness: &Harness<'_, App>, light: &str| {
        line_of(harness, &format!("light {light} at the probe: "))
    };
    assert!(says(&harness, "1").ends_with("blue"));
    press(&mut harness, "Mute light 1");
    assert_eq!(says(&harness, "1"), "muted");
    assert!(
        harness
            .query_by_label_contains("It adds nothing: it is muted")
            .is_some(),
        "the chosen light is unfolded"
    );
    press(&mut harness, "Light 2");
    press(&mut harness, "Solo light 2");
    assert_eq!(
        (says(&harness, "1"), says(&harness, "3")),
        ("muted".into(), "not soloed".into())
    );
    let [r, g, b] =
        (probed(&harness).lights[1].diffuse + probed(&harness).lights[1].specular).to_array();
    assert_eq!(
        says(&harness, "2"),
        format!("{r:.4} red, {g:.4} green, {b:.4} blue")
    );
}

#[test]
fn a_light_that_nothing_reflects_is_not_said_to_be_in_shadow() {
    let mut harness = window("sphere");
    for name in ["Kd diffuse coefficient", "Ks specular coefficient"] {
        enter(&mut harness, name, 0.0);
    }
    let line = line_of(&harness, "light 1 at the probe: ");
    assert!(!line.contains("shadow"), "{line}");
    assert!(
        harness
            .query_by_label_contains("blocks the light")
            .is_none()
    );
    assert_eq!(line, "not reflected");
}

#[test]
fn the_mixture_with_transmitted_light_is_filled_in_where_there_is_any() {
    let harness = window("glass-ball");
    let hit = probed(&harness);
    let through = hit.transmission.expect("glass");
    let line = line_of(&harness, "transparency green: ");
    assert!(
        line.starts_with(&format!("0.15 · {:.3} + 0.85 · ", hit.reflected.y)),
        "{line}"
    );
    assert!(line.ends_with(&format!(" = {:.4}", hit.sum.y)), "{line}");
    assert!(
        line_of(&harness, "transparency at the probe: ")
            .starts_with(&through.refractions.to_string())
    );
    for opaque in ["sphere", "gold"] {
        assert!(
            folded(opaque)
                .query_by_label_contains("transparency")
                .is_none(),
            "{opaque}"
        );
    }
}

#[test]
fn lights_unfold_by_keyboard_and_their_symbols_lead_to_their_controls() {
    let mut harness = window("three-lights");
    let rows = |harness: &Harness<'_, App>, light: u32| {
        harness
            .query_by_label_contains(&format!("diffuse {light} red: "))
            .is_some()
    };
    assert!(
        rows(&harness, 1) && !rows(&harness, 2),
        "the chosen light is unfolded, the others are not"
    );
    harness
        .get_by(|node| {
            node.label()
                .is_some_and(|label| label.starts_with("light 2 at the"))
        })
        .focus();
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    assert!(rows(&harness, 1) && rows(&harness, 2));
    let count = harness
        .query_all_by_role_and_label(Role::Button, "Kd at the probe")
        .count();
    assert_eq!(count, 2, "a symbol stands in each light's terms");
    let second = harness
        .query_all_by_role_and_label(Role::Button, "Ip at the probe")
        .nth(2)
        .expect("light 2");
    second.click_accesskit();
    harness.run();
    assert_eq!(
        harness.state().state().light,
        1,
        "Ip of light 2 leads to the controls of light 2"
    );
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, "Light 2 kind")
            .is_some()
    );
    assert!(
        rows(&harness, 2) && !rows(&harness, 1),
        "another light has been chosen"
    );
}

#[test]
fn every_way_of_evaluating_fills_the_equation_in() {
    let mut harness = window("soft-shadow");
    assert!(
        harness
            .query_by_label_contains("Evaluated at 64 points of the light")
            .is_some()
    );
    for key in [Key::Num1, Key::Num2, Key::Num3] {
        harness.key_press(key);
        harness.run();
        let (line, value) = (
            line_of(&harness, "diffuse 1 red: "),
            probed(&harness).lights[0].diffuse.x,
        );
        let (_, shown) = line.split_once(" = ").expect("a product");
        assert!((parsed(shown) - value).abs() < 6e-5, "{line}, {value}");
    }
}

/// Whether a plot is in sight, by its title.
fn plot(harness: &Harness<'_, App>, title: &str) -> bool {
    let mut plots = harness.query_all_by(|node| {
        node.label()
            .is_some_and(|label| label.starts_with(&format!("{title};")))
    });
    plots.next().is_some()
}

/// The modes whose profiles were taken last.
fn modes_taken(harness: &Harness<'_, App>) -> Vec<ShadingMode> {
    let profiles: Option<&Profiles> = harness.state().state().own.get();
    let profile = profiles.and_then(Profiles::profile);
    profile.map_or(vec![], |profile| {
        profile.traces.iter().map(|trace| trace.mode).collect()
    })
}

/// Runs the window until the profile has been taken on its thread.
fn until_taken(harness: &mut Harness<'_, App>) {
    for _ in 0..400 {
        harness.run_ok();
        if plot(harness, "Intensity and perceived brightness") {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    panic!("no profile has come");
}

#[test]
fn the_profile_has_a_tab_whose_line_is_dragged_in_the_picture() {
    let mut harness = window("flat-facets");
    open_view(&mut harness, "Profile");
    until_taken(&mut harness);
    assert_eq!(harness.state().state().look.view, ViewName::Profile);
    assert_eq!(modes_taken(&harness), [ShadingMode::Flat], "the picture's");
    let switch = |harness: &mut Harness<'_, App>, mode: &str| {
        harness
            .get_by_role_and_label(Role::CheckBox, mode)
            .click_accesskit();
        harness.run_ok();
    };
    let until = |harness: &mut Harness<'_, App>, modes: &[ShadingMode]| {
        wait(harness, |harness| modes_taken(harness) == modes)
    };
    switch(&mut harness, "Phong");
    assert!(until(
        &mut harness,
        &[ShadingMode::Flat, ShadingMode::Phong]
    ));
    switch(&mut harness, "Flat");
    harness.key_press(Key::Num3);
    assert!(until(
        &mut harness,
        &[ShadingMode::Gouraud, ShadingMode::Phong]
    ));
    switch(&mut harness, "Phong");
    assert!(until(&mut harness, &[ShadingMode::Gouraud]));
    harness.key_press(Key::Num1);
    harness.run_ok();
    // Flat shading has no slope but jumps.
    harness.get_by_label("Slope").click_accesskit();
    assert!(wait(&mut harness, |harness| plot(
        harness,
        "Jumps of the intensity"
    )));
    // The end of the line, where the picture and the state have it.
    let before = harness.state().state().line;
    let scene_before = scene(&harness).clone();
    let (width, height) = (
        harness.state().frame().width,
        harness.state().frame().height,
    );
    let rect = harness
        .get_by(|node| {
            node.label()
                .is_some_and(|label| label.starts_with("Picture,"))
        })
        .rect();
    let scale = rect.height() / height as f32;
    let [_, end] = before.pixels([width, height]);
    let at = rect.min + vec2(end.x as f32, end.y as f32) * scale;
    drag(&mut harness, at, at + vec2(-40.0, 30.0));
    let after = harness.state().state().line.pixels([width, height]);
    assert!(
        (after[1] - end - glam::DVec2::new(-40.0, 30.0) / f64::from(scale)).length() < 3.0,
        "{after:?} from {end}"
    );
    assert_eq!(*scene(&harness), scene_before, "the camera stays");
    harness.get_by_label("Save ▾").click_accesskit();
    harness.run_ok();
    for ending in ["CSV…", "PNG…", "SVG…"] {
        assert!(harness.query_by_label(ending).is_some(), "{ending}");
    }
}

/// Where a point of the scene is on the screen.
fn on_screen(harness: &Harness<'_, App>, world: DVec3) -> Pos2 {
    let rect = harness
        .get_by(|node| {
            node.label()
                .is_some_and(|label| label.starts_with("Picture,"))
        })
        .rect();
    let size = [
        harness.state().frame().width,
        harness.state().frame().height,
    ];
    let (pixel, _) = View::new(&scene(harness).camera, size)
        .project(world)
        .expect("in sight");
    // In the first of several panes, which begins where the picture does; a pixel is a point.
    rect.min + vec2(pixel.x as f32, pixel.y as f32)
}

#[test]
fn a_vertex_is_dragged_in_the_picture() {
    let mut harness = window("orientation");
    let before = scene(&harness).clone();
    let corner = before.object.vertices[2];
    let at = on_screen(&harness, corner);
    drag(&mut harness, at, at + vec2(-30.0, 25.0));
    let moved = scene(&harness).clone();
    let landed = on_screen(&harness, moved.object.vertices[2]);
    assert!(
        landed.distance(at + vec2(-30.0, 25.0)) < 3.0,
        "{landed} from {at}"
    );
    assert_eq!(
        (&moved.camera, &moved.lights),
        (&before.camera, &before.lights)
    );
    assert!(
        (moved.object.vertices[2].z - corner.z).abs() < 1e-9,
        "parallel to the picture"
    );
    undo(&mut harness);
    assert_eq!(*scene(&harness), before, "a drag is one step");
    // Across the opposite corner the square would cross itself.
    let opposite = on_screen(&harness, before.object.vertices[0]);
    drag(
        &mut harness,
        at,
        at + (opposite - at) * 1.05 + vec2(12.0, 0.0),
    );
    let stopped = scene(&harness);
    assert_eq!(stopped.validate(), Ok(()));
    assert!(
        stopped.object.vertices[2].distance(corner) > 0.5,
        "{}",
        stopped.object.vertices[2]
    );
    undo(&mut harness);
    // With Shift it leaves the picture's plane.
    harness.event(Event::PointerMoved(at));
    harness.event_modifiers(
        Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed: true,
            modifiers: Modifiers::SHIFT,
        },
        Modifiers::SHIFT,
    );
    // One frame alone: held for long without Shift it would be dragged without it.
    harness.step();
    harness.event_modifiers(Event::PointerMoved(at + vec2(0.0, -40.0)), Modifiers::SHIFT);
    harness.run();
    harness.event_modifiers(
        Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed: false,
            modifiers: Modifiers::SHIFT,
        },
        Modifiers::SHIFT,
    );
    harness.run();
    let vertex = scene(&harness).object.vertices[2];
    assert!(
        vertex.z > 0.05 && (vertex - corner).truncate().length() < 1e-2,
        "{vertex}"
    );
}

#[test]
fn polygons_are_counted_and_their_vertices_typed() {
    let mut harness = window("sphere");
    choose(&mut harness, "Object kind", "polygons");
    assert_eq!(
        scene(&harness).object.vertices.len(),
        4,
        "a quadrilateral to begin with"
    );
    assert_eq!(scene(&harness).validate(), Ok(()));
    assert!(harness.query_by_label("4 vertices, 1 face").is_some());
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, "Segments")
            .is_none()
    );
    enter(&mut harness, "Vertex", 2.0);
    enter(&mut harness, "Vertex position x", 1.25);
    assert_eq!(scene(&harness).object.vertices[2].x, 1.25);
    undo(&mut harness);
    assert_eq!(scene(&harness).object.vertices[2].x, 0.85);
    let mut harness = window("sphere");
    choose(&mut harness, "Object kind", "corrugated sheet");
    assert_eq!(scene(&harness).object.kind, ObjectKind::Corrugated);
    enter(&mut harness, "Segments", 2.0);
    assert_eq!(
        (scene(&harness).object.segments, scene(&harness).validate()),
        (2, Ok(()))
    );
    // What is too few for a ball becomes enough.
    let mut harness = window("vertex-normals");
    enter(&mut harness, "Segments", 2.0);
    choose(&mut harness, "Object kind", "sphere");
    assert_eq!(
        (scene(&harness).object.segments, scene(&harness).validate()),
        (3, Ok(()))
    );
}

#[test]
fn the_camera_is_rolled_and_put_back() {
    let mut harness = window("cube");
    let before = scene(&harness).clone();
    harness
        .get_by_role_and_label(Role::Slider, "Roll")
        .set_value_accesskit(90.0);
    harness.run();
    assert_eq!(scene(&harness).camera.roll, 90.0);
    // What is under the pointer follows it: to the right in the picture is upwards in the world.
    let middle = harness
        .get_by(|node| {
            node.label()
                .is_some_and(|label| label.starts_with("Picture,"))
        })
        .rect()
        .center();
    drag(
        &mut harness,
        middle + vec2(150.0, 150.0),
        middle + vec2(200.0, 150.0),
    );
    let turned = &scene(&harness).camera;
    assert_eq!(turned.roll, 90.0, "turning keeps the roll");
    assert!(
        turned.eye.y > before.camera.eye.y + 0.1
            && turned.eye.xz().angle_to(before.camera.eye.xz()).abs() < 0.05,
        "{turned:?}"
    );
    press(&mut harness, "Reset camera");
    assert_eq!(scene(&harness).camera, before.camera);
}

#[test]
fn one_number_cuts_every_shape_into_as_many_triangles() {
    let mut harness = window("sphere");
    let drawn =
        |harness: &Harness<'_, App>| tessellate(&scene(harness).object).triangle_count() as f64;
    for wanted in [6.0, 100.0, 7000.0, 150_000.0] {
        enter(&mut harness, "Triangles", wanted);
        let found = drawn(&harness);
        assert!(
            (found - wanted).abs() <= 2.0 * wanted.sqrt(),
            "{found} for {wanted}"
        );
        let field = harness.get_by_role_and_label(Role::SpinButton, "Triangles");
        assert_eq!(
            field.accesskit_node().numeric_value(),
            Some(found),
            "the field says what there is"
        );
    }
    let object = scene(&harness).object.clone();
    assert!(
        object.segments.abs_diff(2 * object.rings) <= 2,
        "polygons are about square: {object:?}"
    );
    assert!(
        harness
            .query_by_label_contains("polygons, ")
            .is_some_and(|node| {
                node.accesskit_node()
                    .value()
                    .or(node.accesskit_node().label())
                    .is_some_and(|text| text.contains("vertices"))
            })
    );
    // A slider's end, and numbers beyond what is typed sensibly.
    harness
        .get_by_role_and_label(Role::Slider, "Triangles")
        .set_value_accesskit(12.0);
    harness.run();
    assert_eq!(drawn(&harness), 12.0);
    enter(&mut harness, "Triangles", -5.0);
    assert_eq!(
        (
            scene(&harness).object.segments,
            scene(&harness).object.rings
        ),
        (3, 2)
    );
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
    assert!(drawn(&harness) > 6.0, "undone");
}

#[test]
fn the_teapot_is_cut_by_one_number_too() {
    let mut harness = window("teapot");
    for wanted in [128.0, 3000.0, 60_000.0] {
        enter(&mut harness, "Triangles", wanted);
        let found = tessellate(&scene(&harness).object).triangle_count() as f64;
        assert!(
            (found - wanted).abs() <= 16.0 * wanted.sqrt(),
            "{found} for {wanted}"
        );
    }
    press(&mut harness, "Reset Triangles");
    assert_eq!(
        (
            scene(&harness).object.segments,
            scene(&harness).object.rings
        ),
        (64, 64),
        "as opened"
    );
}

#[test]
fn the_defects_are_measured_and_the_picture_is_turned_about_the_probe() {
    let mut harness = window("orientation");
    open_view(&mut harness, "Defects");
    assert!(wait(&mut harness, |harness| harness
        .query_by_label("with barycentric weights")
        .is_some()));
    assert!(
        harness
            .query_by_label_contains("Not measured: a parallel projection")
            .is_some()
    );
    let picture = harness
        .get_by(|node| {
            node.label()
                .is_some_and(|label| label.starts_with("Picture,"))
        })
        .rect();
    // The first of two panes; its knob stands at the scene's 30 degrees.
    let [width, height] = pane_areas(2, [picture.width() as u32, picture.height() as u32])[0].size;
    let pane = eframe::egui::Rect::from_min_size(picture.min, vec2(width as f32, height as f32));
    let radius = 0.46 * pane.width().min(pane.height());
    let at = |degrees: f32| {
        pane.center() + radius * vec2(degrees.to_radians().cos(), -degrees.to_radians().sin())
    };
    let before = harness.state().state().probe.0;
    drag(&mut harness, at(30.0), at(120.0));
    assert_eq!(scene(&harness).camera.roll, 120.0);
    let after = harness.state().state().probe.0;
    assert!(
        (after - glam::DVec2::new(before.y, -before.x)).length() < 0.01,
        "{before} {after}"
    );
    undo(&mut harness);
    assert_eq!(scene(&harness).camera.roll, 30.0);
    press(&mut harness, "Example: Polygonal silhouette");
    let shown = |harness: &Harness<'_, App>| {
        harness
            .query_by_label_contains("pixels from the true outline")
            .is_some()
    };
    assert!(wait(&mut harness, shown));
}

#[test]
fn the_picture_is_shown_as_it_is_perceived() {
    let mut harness = window("mach-bands");
    open_view(&mut harness, "Profile");
    let checkbox = "Picture as perceived";
    let perceived = |harness: &Harness<'_, App>| {
        harness
            .state()
            .state()
            .own
            .get::<Profiles>()
            .is_some_and(|profiles| profiles.perceived.is_some())
    };
    assert!(!perceived(&harness));
    harness
        .get_by_role_and_label(Role::CheckBox, checkbox)
        .click_accesskit();
    assert!(wait(&mut harness, perceived));
    // A surround wider than any picture is refused with a reason.
    harness.get_by_label("Viewing ▾").click_accesskit();
    harness.run();
    enter(&mut harness, "Pixel density", 40.0);
    enter(&mut harness, "Distance", 5000.0);
    assert!(wait(&mut harness, |harness| harness
        .query_by_label_contains("allows at most 256")
        .is_some()));
}

/// Presses keys as a keyboard does: each with the letter that it types.
fn type_keys(harness: &mut Harness<'_, App>, text: &str) {
    for letter in text.chars() {
        let key = Key::from_name(&letter.to_string()).expect("a key");
        let event = |pressed| Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: Modifiers::NONE,
        };
        harness.event(event(true));
        harness.event(Event::Text(letter.to_string()));
        harness.event(event(false));
        harness.run();
    }
}

#[test]
fn tab_goes_from_field_to_field_and_the_keys_with_it() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    harness
        .get_by_role_and_label(Role::SpinButton, "Kd diffuse coefficient")
        .focus();
    harness.run();
    type_keys(&mut harness, "0.3");
    harness.key_press(Key::Tab);
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::Button, "Reset Kd diffuse coefficient")
            .is_some(),
        "it has come to stand between"
    );
    assert!(
        harness
            .get_by_role_and_label(Role::SpinButton, "Ks specular coefficient")
            .is_focused()
    );
    type_keys(&mut harness, "0.6");
    harness.key_press(Key::Tab);
    harness.run();
    type_keys(&mut harness, "5");
    harness.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
    harness.run();
    assert!(
        harness
            .get_by_role_and_label(Role::SpinButton, "Ks specular coefficient")
            .is_focused(),
        "Shift leads back"
    );
    harness.key_press(Key::Enter);
    harness.run();
    let mut expected = before.clone();
    (
        expected.material.kd,
        expected.material.ks,
        expected.material.n,
    ) = (Rgb::splat(0.3), Rgb::splat(0.6), 5.0);
    assert_eq!(
        *scene(&harness),
        expected,
        "what was typed is in its fields and nowhere else"
    );
    press(&mut harness, "Reset Kd diffuse coefficient");
    assert_eq!(
        scene(&harness).material.kd,
        before.material.kd,
        "a screen reader still reaches it"
    );
}

#[test]
fn what_has_the_focus_is_plain_to_see_and_keeps_its_keys() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    for _ in 0..60 {
        harness.key_press(Key::Tab);
        harness.run();
        let Some(id) = harness.ctx.memory(|memory| memory.focused()) else {
            continue;
        };
        let name = harness
            .query_by(|node| node.is_focused())
            .map(|node| node.accesskit_node().label());
        type_keys(&mut harness, "3");
        assert_eq!(
            scene(&harness).shading,
            before.shading,
            "{name:?} lets a key go to a shortcut"
        );
        let rect = harness
            .ctx
            .read_response(id)
            .expect("what has the focus")
            .interact_rect;
        let rings = |shape: &Shape| match shape {
            Shape::Rect(ring) => {
                ring.stroke.width >= 2.0
                    && ring.rect.contains_rect(rect)
                    && rect.expand(4.0).contains_rect(ring.rect)
            }
            _ => false,
        };
        let seen = harness
            .output()
            .shapes
            .iter()
            .any(|clipped| rings(&clipped.shape));
        assert!(
            seen || !rect.is_positive(),
            "no ring round {name:?} at {rect:?}"
        );
        assert!(
            !name
                .flatten()
                .is_some_and(|name| name.starts_with("Reset ")),
            "the way back is no stop of Tab"
        );
        harness.key_press(Key::Escape);
        harness.run();
        harness.ctx.memory_mut(|memory| memory.request_focus(id));
        harness.run();
    }
}

#[test]
fn keys_go_to_what_stands_in_front() {
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    harness
        .get_by_role_and_label(Role::SpinButton, "Kd diffuse coefficient")
        .focus();
    harness.run();
    // A dialog takes the keys from the field behind it.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    harness.run();
    type_keys(&mut harness, "13");
    assert_eq!(
        harness
            .get_by_role_and_label(Role::TextInput, "File")
            .value()
            .as_deref(),
        Some("13")
    );
    harness.key_press(Key::Escape);
    harness.run();
    // So does the progress of work on a file: a picture that takes its time.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run();
    enter(&mut harness, "Samples per pixel", 1024.0);
    harness
        .get_by_role_and_label(Role::Button, "Export")
        .click_accesskit();
    harness.run_steps(3);
    let working = |harness: &Harness<'_, App>| harness.query_by_label_contains("Drawing").is_some();
    assert!(working(&harness));
    for key in [Key::Num1, Key::C, Key::A, Key::V, Key::F4, Key::Delete] {
        harness.key_press(key);
        harness.run_steps(2);
    }
    harness.key_press_modifiers(Modifiers::COMMAND, Key::N);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    harness.run_steps(4);
    assert!(
        working(&harness)
            && harness
                .query_by_role_and_label(Role::TextInput, "File")
                .is_none(),
        "no dialog opens over it"
    );
    assert_eq!(
        (scene(&harness), &harness.state().state().look),
        (&before, &Look::default())
    );
    harness.key_press(Key::Escape);
    harness.run_steps(4);
    assert!(!working(&harness), "Escape cancels");
}

#[test]
fn a_profile_of_any_height_is_clipped_to_its_pane() {
    for bright in [1e4, 1e8, 1e30] {
        let mut loaded = load(Path::new("mach-bands")).expect("a built-in scene");
        loaded.scene.lights[0].color = Rgb::splat(bright);
        loaded.scene.compare = Compare::default();
        let mut harness = window_of(loaded);
        open_view(&mut harness, "Profile");
        assert!(wait(&mut harness, |harness| harness
            .state()
            .state()
            .own
            .get()
            .and_then(Profiles::profile)
            .is_some()));
        harness.run();
        let shapes = harness.output().shapes.len();
        assert!(shapes < 5000, "{bright}: {shapes} shapes");
    }
}

#[test]
fn every_analysis_is_exported_from_its_tab() {
    let tabs: [(&str, &str, &[&str]); 10] = [
        ("Equation", "", &["probe"]),
        ("Curves", "", &["curves"]),
        ("Profile", "Save ▾", &["profile"]),
        ("Scan line", "", &["scanline"]),
        ("Compare", "Panes", &["compare"]),
        (
            "Defects",
            "Where a vertex normal comes from",
            &["defects", "normals"],
        ),
        ("Defects", "When is flat shading exact?", &["conditions"]),
        ("Plan", "Measure times", &["explain", "bench"]),
        ("Study", "Measure", &["study"]),
        ("Stability", "", &["stability"]),
    ];
    let mut harness = window("sphere");
    let mut exported = Vec::new();
    for (name, button, analyses) in tabs {
        tab(&mut harness, name);
        if !button.is_empty() {
            harness.get_by_label(button).click_accesskit();
        }
        let copied = |harness: &mut Harness<'_, App>, analysis: &str| {
            (0..harness.query_all_by_label("Copy text").count()).any(|index| {
                let button = harness.query_all_by_label("Copy text").nth(index);
                button.expect("a button").click_accesskit();
                harness.run_ok();
                harness
                    .state()
                    .state()
                    .notice
                    .as_ref()
                    .is_some_and(|notice| *notice == format!("Copied: {analysis}"))
            })
        };
        for analysis in analyses {
            let any = (0..2000).any(|_| {
                std::thread::sleep(std::time::Duration::from_millis(10));
                harness.run_ok();
                // A menu closes by a click, also before there is an answer.
                if harness.query_all_by_label("Copy text").next().is_none() && !button.is_empty() {
                    let button = harness.query_all_by_label(button).next();
                    button
                        .into_iter()
                        .for_each(|button| button.click_accesskit());
                    harness.run_ok();
                }
                copied(&mut harness, analysis)
            });
            assert!(any, "{name}: {analysis}");
            exported.push(*analysis);
        }
    }
    assert!(
        ANALYSES
            .iter()
            .all(|analysis| exported.contains(&analysis.name))
            && exported.len() == ANALYSES.len()
    );
}
