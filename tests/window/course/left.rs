//! A lesson that was left for another scene: its hiding, locking and drawing apply to its own scenes only.

use super::{go, ready, step, window};
use crate::common::hands::{self, press, scene};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::App;
use shading_lab::document::{load_scene, save_scene};
use std::path::Path;

const BACK: &str = "course-return";

/// A way to another scene.
type Way<'w> = dyn Fn(&mut Harness<'_, App>) + 'w;

/// Returns whether the lesson's locks hold, which must be the same everywhere.
fn hides(harness: &mut Harness<'_, App>) -> bool {
    hands::open_view(harness, "view-equation");
    let said = harness.query_by_label(english!("course-hidden")).is_some();
    let back = harness
        .query_by_role_and_label(Role::Button, english!(BACK))
        .is_some();
    let state = harness.state().state();
    assert_eq!((state.course.hides(), said), (said, said));
    assert_eq!(back, !said, "there is a way back where the lesson was left");
    said
}

/// Opens a scene from the gallery, by the key of its title.
fn choose_scene(harness: &mut Harness<'_, App>, title: &str) {
    press(harness, "controls-group-file");
    press(harness, "controls-command-scenes");
    press(harness, title);
    harness.run_ok();
}

fn paste(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(eframe::egui::Event::Paste(text.to_owned()));
    harness.run_ok();
    harness.run_ok();
}

fn open(harness: &mut Harness<'_, App>, path: &Path) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    harness.run_ok();
    let field = harness.get_by_role_and_label(Role::TextInput, english!("file"));
    field.type_text(&path.display().to_string());
    harness.run_ok();
    press(harness, "open");
    let title = path.file_name().expect("a name").to_string_lossy();
    assert!(hands::wait(harness, |harness| {
        harness.state().state().session.document().origin.name() == title
    }));
    harness.run_ok();
}

/// Opens step 1, from which on numbers are hidden until the question is answered.
fn at_the_choice() -> Harness<'static, App> {
    let mut harness = window();
    go(&mut harness, 1);
    assert!(hides(&mut harness));
    harness
}

#[test]
fn another_scene_shows_its_numbers_and_a_way_back() {
    let mut harness = at_the_choice();
    // The built-in scene that the step uses, too.
    choose_scene(&mut harness, "scene-sphere");
    assert_ne!(scene(&harness).material.n, 20.0);
    assert!(!hides(&mut harness));
    // The step's question is about its own scene.
    hands::press_rail(&mut harness, "course");
    assert!(
        harness
            .query_by_role_and_label(Role::RadioButton, "Wider")
            .is_none()
    );
    press(&mut harness, BACK);
    harness.run_ok();
    assert_eq!((step(&harness), scene(&harness).material.n), (1, 20.0));
    let wider = harness.get_by_role_and_label(Role::RadioButton, "Wider");
    wider.click();
    assert!(hides(&mut harness));
}

#[test]
fn every_way_to_another_scene_leaves_the_lesson_and_undo_returns_to_it() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("course-left");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("own.toml");
    save_scene(
        &file,
        &load_scene(Path::new("sphere")).expect("a scene").scene,
    )
    .expect("a file");
    let gallery = |harness: &mut Harness<'_, App>| choose_scene(harness, "scene-gold");
    let opened = |harness: &mut Harness<'_, App>| open(harness, &file);
    let link = |harness: &mut Harness<'_, App>| paste(harness, "?scene=gold&set=material.n=5");
    let ways: [(&str, &Way); 3] = [
        ("the gallery", &gallery),
        ("a file", &opened),
        ("a link", &link),
    ];
    for (way, go) in ways {
        let mut harness = at_the_choice();
        go(&mut harness);
        assert!(!hides(&mut harness), "{way}");
        hands::undo(&mut harness);
        assert!(hides(&mut harness), "undo of {way}");
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Y);
        hands::settle(&mut harness);
        assert!(!hides(&mut harness), "redo of {way}");
        // The lesson goes on.
        harness.key_press(Key::PageDown);
        harness.run_ok();
        ready(&mut harness);
        assert_eq!(step(&harness), 2, "{way}");
        assert!(harness.state().state().course.shows_step(), "{way}");
    }
}

#[test]
fn what_a_step_draws_and_locks_stays_with_its_scene() {
    let mut harness = window();
    go(&mut harness, 3);
    let state = |harness: &Harness<'_, App>| {
        let state = harness.state().state();
        let overlay = &state.window.appearance.overlay;
        let drawn = state.course.mark().is_some();
        (state.course.asks_point(), drawn, overlay.vectors)
    };
    let place = hands::picture_place(&harness).center();
    harness.hover_at(place);
    harness.drag_at(place);
    harness.drop_at(place);
    harness.run_ok();
    assert_eq!(state(&harness), (true, true, false));
    choose_scene(&mut harness, "scene-gold");
    assert_eq!(
        state(&harness),
        (false, false, true),
        "vectors as before the lesson"
    );
    let eye = scene(&harness).camera.eye;
    harness.key_press(Key::D);
    hands::settle(&mut harness);
    assert_ne!(scene(&harness).camera.eye, eye, "the camera is free");
    let link = harness.state().state().link().expect("a link").link;
    assert!(!link.contains("lesson="), "{link}");
    press(&mut harness, BACK);
    harness.run_ok();
    assert_eq!(
        state(&harness),
        (true, true, false),
        "the mark is there again"
    );
}
