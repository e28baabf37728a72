//! The panels beside the picture: the equation filled in, the curves, the profile, the scene as code.

mod equation;
mod keys;
mod shapes;

use crate::common::hands::{
    built_in, drag, enter, named, open_view, picture_place, press, scene, undo, wait, window,
    window_looking, window_of,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, OutputCommand, Rect, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::analysis::ANALYSES;
use shading_lab::analysis::comparison::pane_areas;
use shading_lab::analysis::probe::{ProbeHit, probe};
use shading_lab::app::{App, Appearance, Profiles, ViewName};
use shading_lab::document::load_scene;
use shading_lab::export::{glsl_330, opengl_c, opengl_c_snippet};
use shading_lab::geometry::tessellate;
use shading_lab::render::Renderer;
use shading_lab::scene::{Compare, Reflectance, Rgb, ShadingMode, presets};
use std::path::Path;

#[test]
fn the_curves_have_a_tab_of_their_own_that_follows_the_scene() {
    let mut harness = window("attenuation");
    let titles = [
        english!("point-plot-attenuation"),
        &english!("point-plot-exponent", lobe = "cosⁿφ"),
        english!("point-plot-lobe"),
    ];
    assert_eq!(
        harness.state().state().window.appearance.view,
        ViewName::Curves,
        "the scene names its tab"
    );
    open_view(&mut harness, "view-equation");
    assert!(
        harness.query_by_label(titles[1]).is_none(),
        "the equation is shown"
    );
    open_view(&mut harness, "view-curves");
    assert_eq!(
        harness.state().state().window.appearance.view,
        ViewName::Curves
    );
    for title in titles {
        assert!(harness.query_by_label(title).is_some(), "{title}");
    }
    let constant = english!("choice-reflectance-constant");
    let reflectance = english!("point-plot-reflectance", substance = constant);
    assert!(
        harness.query_by_label(&reflectance).is_some(),
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
        .get_by_role_and_label(Role::Slider, named("material.n"))
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
    assert!(harness.state().state().window.appearance.overlay.lobe);
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

/// Returns the text in the dialog.
fn code(harness: &Harness<'_, App>) -> String {
    let view = harness.query_by_role_and_label(Role::MultilineTextInput, english!("code-text"));
    view.and_then(|view| view.accesskit_node().value())
        .unwrap_or_default()
}

#[test]
fn counts_in_the_bar_never_cover_one_another() {
    let settings = ["reflection.model=formula", "reflection.formula=3"].map(str::to_owned);
    for width in (880..1500).step_by(20) {
        let mut loaded = built_in("soft-shadow");
        loaded.scene = loaded.scene.with_overrides(&settings).expect("settings");
        let size = [width as f32, 800.0];
        let harness = window_looking(loaded, size, &Appearance::default(), |app| app);
        let places = |words: &'static str| {
            let all = harness.query_all_by_label_contains(words);
            all.map(move |node| (words, node.rect()))
        };
        let counts = ["evaluated", "triangles", "overflow", "skipped"];
        let mut texts: Vec<(&str, Rect)> = counts.into_iter().flat_map(places).collect();
        texts.retain(|(_, rect)| rect.min.y > 770.0);
        for (index, (words, rect)) in texts.iter().enumerate() {
            for (other, covered) in &texts[..index] {
                let both = rect.intersect(*covered);
                assert!(!both.is_positive(), "{words} over {other} at {width}");
            }
        }
        let overflows = texts.iter().any(|(words, _)| *words == "overflow");
        assert!(width < 1280 || overflows, "{texts:?} at {width}");
    }
}

#[test]
fn the_plan_has_a_tab_that_the_bar_opens() {
    let mut harness = window("sphere");
    let link = harness.get_by(|node| {
        node.label()
            .is_some_and(|label| label.ends_with(&english!("left-out", count = "")))
    });
    link.click_accesskit();
    harness.run();
    assert_eq!(
        harness.state().state().window.appearance.view,
        ViewName::Plan
    );
    let says = |harness: &Harness<'_, App>, text: &str| {
        harness.query_all_by_label_contains(text).next().is_some()
    };
    assert!(says(&harness, english!("render-why-closed-solid")));
    assert!(says(&harness, english!("engine-side-view")));
    assert!(says(
        &harness,
        &english!(
            "render-term-of-light",
            light = 1,
            term = english!("render-term-specular")
        )
    ));
    harness
        .get_by_role_and_label(Role::Slider, named("material.n"))
        .set_value_accesskit(3.0);
    harness.run();
    assert!(
        says(
            &harness,
            &format!("□ {}", english!("engine-stage-coverage"))
        ) && says(&harness, &format!("■ {}", english!("engine-stage-pixels")))
    );
}

/// Returns the text copied to the clipboard since the window was last run.
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
    let scene = scene(&harness).clone();
    let expected = opengl_c_snippet(&scene, &tessellate(&scene.object));
    assert_eq!(code(&harness), expected.parts[0].text);
    let mut limits = expected.limits.iter();
    let lobe = limits.find(|limit| limit.key == "export-limit-phong-lobe");
    let lobe = lobe.expect("what the calls do not say");
    harness.get_by_label_contains(&lobe.to_string());

    open_view(&mut harness, "code-shaders");
    assert!(wait(&mut harness, |harness| code(harness)
        .contains("gl_Position")));
    assert_eq!(code(&harness), glsl_330(&scene).parts[0].text);
    press(&mut harness, "export-fragment-shader");
    assert_eq!(code(&harness), glsl_330(&scene).parts[1].text);
    assert!(harness.query_by_label(english!("code-complete")).is_some());

    open_view(&mut harness, "code-program");
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
    let all = program.lines().count();
    let many = english!("code-first-lines", shown = 200, all = all);
    assert!(harness.query_by_label_contains(&many).is_some(), "{many}");
    harness
        .get_by_role_and_label(Role::Button, english!("copy"))
        .click_accesskit();
    harness.step();
    assert_eq!(copied(&harness), Some(program), "copying takes all of it");
    harness.run();
    harness.key_press(Key::Escape);
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::Tab, english!("code-shaders"))
            .is_none(),
        "the dialog has gone"
    );
}

#[test]
fn code_is_saved_and_a_path_that_cannot_be_written_is_named() {
    let folder = std::env::temp_dir().join(format!("shading-lab-code-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    let mut harness = window("sphere");
    press(&mut harness, "controls-group-edit");
    press(&mut harness, "controls-command-code");
    open_view(&mut harness, "code-shaders");
    assert!(wait(&mut harness, |harness| !code(harness).is_empty()));
    let save_to = |harness: &mut Harness<'_, App>, path: &Path| {
        press(harness, "save-as");
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        harness.run();
        harness
            .get_by_role_and_label(Role::TextInput, english!("file"))
            .type_text(&path.display().to_string());
        harness.run();
        press(harness, "save");
    };
    save_to(&mut harness, &folder.join("no/such/ball.vert"));
    assert!(
        harness
            .query_by_label_contains(english!("document-target-no-folder"))
            .is_some()
    );
    harness.key_press(Key::Escape);
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::TextInput, english!("file"))
            .is_none(),
        "one step back"
    );
    save_to(&mut harness, &folder.join("ball.vert"));
    let saved = english!("saved", path = "");
    let said = harness.query_by_label_contains(&saved).is_some();
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

/// Probes at the window's probe, independently of the window.
fn probed(harness: &Harness<'_, App>) -> ProbeHit {
    let frame = harness.state().frame();
    let mut scene = scene(harness).clone();
    scene.image.size = [frame.width, frame.height];
    let [x, y] = harness.state().state().window.probe.pixel(scene.image.size);
    probe(&mut Renderer::default(), &scene, x, y)
        .hit
        .expect("the probe stands on the object")
}

/// Returns whether a plot is in sight, by its title.
fn plot(harness: &Harness<'_, App>, title: &str) -> bool {
    let mut plots = harness.query_all_by(|node| {
        node.label()
            .is_some_and(|label| label.starts_with(&format!("{};", named(title))))
    });
    plots.next().is_some()
}

/// Returns the modes whose profiles were taken last.
fn modes_taken(harness: &Harness<'_, App>) -> Vec<ShadingMode> {
    let profiles: Option<&Profiles> = harness.state().state().window.own.get();
    let profile = profiles.and_then(Profiles::profile);
    profile.map_or(vec![], |profile| {
        profile.traces.iter().map(|trace| trace.mode).collect()
    })
}

/// Runs the window until the profile has been taken on its thread.
fn until_taken(harness: &mut Harness<'_, App>) {
    for _ in 0..400 {
        harness.run_ok();
        if plot(harness, "line-intensity-title") {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    panic!("no profile has come");
}

#[test]
fn the_profile_has_a_tab_whose_line_is_dragged_in_the_picture() {
    let mut harness = window("flat-facets");
    open_view(&mut harness, "view-profile");
    until_taken(&mut harness);
    assert_eq!(
        harness.state().state().window.appearance.view,
        ViewName::Profile
    );
    assert_eq!(modes_taken(&harness), [ShadingMode::Flat], "the picture's");
    let switch = |harness: &mut Harness<'_, App>, mode: &str| {
        harness
            .get_by_role_and_label(Role::CheckBox, named(mode))
            .click_accesskit();
        harness.run_ok();
    };
    let until = |harness: &mut Harness<'_, App>, modes: &[ShadingMode]| {
        wait(harness, |harness| modes_taken(harness) == modes)
    };
    switch(&mut harness, "choice-shading-phong");
    assert!(until(
        &mut harness,
        &[ShadingMode::Flat, ShadingMode::Phong]
    ));
    // A mode that the picture leaves stays in the comparison.
    harness.key_press(Key::Num3);
    assert!(until(
        &mut harness,
        &[ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong]
    ));
    switch(&mut harness, "choice-shading-flat");
    assert!(until(
        &mut harness,
        &[ShadingMode::Gouraud, ShadingMode::Phong]
    ));
    switch(&mut harness, "choice-shading-phong");
    assert!(until(&mut harness, &[ShadingMode::Gouraud]));
    harness.key_press(Key::Num1);
    harness.run_ok();
    // Flat shading has jumps instead of a slope.
    harness
        .get_by_label(english!("line-plot-slope"))
        .click_accesskit();
    assert!(wait(&mut harness, |harness| plot(
        harness,
        "line-jumps-title"
    )));
    // The position of the line's end, in the picture and in the state.
    let before = harness.state().state().window.line;
    let scene_before = scene(&harness).clone();
    let (width, height) = (
        harness.state().frame().width,
        harness.state().frame().height,
    );
    let rect = picture_place(&harness);
    let scale = rect.height() / height as f32;
    let [_, end] = before.pixels([width, height]);
    let at = rect.min + vec2(end.x as f32, end.y as f32) * scale;
    drag(&mut harness, at, at + vec2(-40.0, 30.0));
    let after = harness.state().state().window.line.pixels([width, height]);
    assert!(
        (after[1] - end - glam::DVec2::new(-40.0, 30.0) / f64::from(scale)).length() < 3.0,
        "{after:?} from {end}"
    );
    assert_eq!(*scene(&harness), scene_before, "the camera stays");
    let save = format!("{} ▾", english!("line-save"));
    harness.get_by_label(&save).click_accesskit();
    harness.run_ok();
    for ending in ["CSV…", "PNG…", "SVG…"] {
        assert!(harness.query_by_label(ending).is_some(), "{ending}");
    }
    harness
        .get_by_label(english!("report-copy"))
        .click_accesskit();
    harness.run_ok();
    assert!(harness.query_by_label("CSV…").is_none(), "the menu closes");
}

#[test]
fn the_defects_are_measured_and_the_picture_is_turned_about_the_probe() {
    let mut harness = window("orientation");
    open_view(&mut harness, "view-defects");
    assert!(wait(&mut harness, |harness| harness
        .query_by_label(english!("picture-orientation-barycentric"))
        .is_some()));
    assert!(
        harness
            .query_by_label_contains(english!("picture-missing-parallel"))
            .is_some()
    );
    let picture = picture_place(&harness);
    // The first of two panes; its knob is at the scene's 30 degrees.
    let [width, height] = pane_areas(2, [picture.width() as u32, picture.height() as u32])[0].size;
    let pane = Rect::from_min_size(picture.min, vec2(width as f32, height as f32));
    let radius = 0.46 * pane.width().min(pane.height());
    let at = |degrees: f32| {
        pane.center() + radius * vec2(degrees.to_radians().cos(), -degrees.to_radians().sin())
    };
    let before = harness.state().state().window.probe.0;
    drag(&mut harness, at(30.0), at(120.0));
    assert_eq!(scene(&harness).camera.roll, 120.0);
    let after = harness.state().state().window.probe.0;
    assert!(
        (after - glam::DVec2::new(before.y, -before.x)).length() < 0.01,
        "{before} {after}"
    );
    undo(&mut harness);
    assert_eq!(scene(&harness).camera.roll, 30.0);
    let silhouette = english!("picture-silhouette");
    let example = english!("picture-example-of", name = silhouette);
    press(&mut harness, &example);
    let shown = |harness: &Harness<'_, App>| {
        harness
            .query_by_label_contains(&english!("picture-silhouette-distance", at = ""))
            .is_some()
    };
    assert!(wait(&mut harness, shown));
}

#[test]
fn the_picture_is_shown_as_it_is_perceived() {
    let mut harness = window("mach-bands");
    open_view(&mut harness, "view-profile");
    let checkbox = english!("line-picture-perceived");
    let perceived = |harness: &Harness<'_, App>| {
        harness
            .state()
            .state()
            .window
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
    let viewing = format!("{} ▾", english!("line-viewing"));
    harness.get_by_label(&viewing).click_accesskit();
    harness.run();
    enter(&mut harness, "line-density", 40.0);
    enter(&mut harness, "line-distance", 5000.0);
    assert!(wait(&mut harness, |harness| harness
        .query_by_label_contains("allows at most 256")
        .is_some()));
}

#[test]
fn a_profile_of_any_height_is_clipped_to_its_pane() {
    for bright in [1e4, 1e8, 1e30] {
        let mut loaded = load_scene(Path::new("mach-bands")).expect("a built-in scene");
        loaded.scene.lights[0].color = Rgb::splat(bright);
        loaded.scene.compare = Compare::default();
        let mut harness = window_of(loaded);
        open_view(&mut harness, "view-profile");
        assert!(wait(&mut harness, |harness| harness
            .state()
            .state()
            .window
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
        ("view-equation", "", &["probe"]),
        ("view-curves", "", &["curves"]),
        ("view-profile", "line-save", &["profile"]),
        ("view-scan-line", "", &["scanline"]),
        ("view-compare", "picture-view-panes", &["compare"]),
        (
            "view-defects",
            "picture-vertex-normal",
            &["defects", "normals"],
        ),
        ("view-defects", "picture-conditions", &["conditions"]),
        ("view-plan", "engine-measure-times", &["explain", "bench"]),
        ("view-study", "engine-measure", &["study"]),
        ("view-stability", "", &["stability"]),
    ];
    let mut harness = window("sphere");
    let mut exported = Vec::new();
    for (name, button, analyses) in tabs {
        open_view(&mut harness, name);
        let button = match button {
            "line-save" => format!("{} ▾", named(button)),
            _ => named(button).to_owned(),
        };
        if !button.is_empty() {
            harness.get_by_label(&button).click_accesskit();
        }
        let copied = |harness: &mut Harness<'_, App>, analysis: &str| {
            (0..harness.query_all_by_label(english!("report-copy")).count()).any(|index| {
                let button = harness
                    .query_all_by_label(english!("report-copy"))
                    .nth(index);
                button.expect("a button").click_accesskit();
                harness.run_ok();
                let copied = english!("report-copied", name = analysis);
                harness.state().state().session.said() == Some(&*copied)
            })
        };
        for analysis in analyses {
            let any = (0..2000).any(|_| {
                std::thread::sleep(std::time::Duration::from_millis(10));
                harness.run_ok();
                // A click closes a menu, even before there is an answer.
                if harness
                    .query_all_by_label(english!("report-copy"))
                    .next()
                    .is_none()
                    && !button.is_empty()
                {
                    let button = harness.query_all_by_label(&button).next();
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
