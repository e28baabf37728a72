//! The window operated by keys alone: Tab, fields, the probe and the export; and the input that a field accepts.

use crate::common::hands;
use crate::common::hands::{TITLES, folded, named, picture, press, scene, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::App;
use shading_lab::scene::Rgb;

/// Presses keys as a keyboard does, each with the letter that it types.
fn type_text(harness: &mut Harness<'_, App>, text: &str) {
    for letter in text.chars() {
        if let Some(key) = Key::from_name(&letter.to_string()) {
            harness.event(Event::Key {
                key,
                physical_key: None,
                pressed: true,
                repeat: false,
                modifiers: Modifiers::NONE,
            });
        }
        harness.event(Event::Text(letter.to_string()));
        harness.run();
    }
}

fn key(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    harness.run();
}

/// Returns the name of the focused widget.
fn focused(harness: &Harness<'_, App>) -> Option<String> {
    harness
        .query_by(|node| node.is_focused())
        .and_then(|node| node.accesskit_node().label())
}

#[test]
fn from_the_start_keys_alone_change_n_move_the_probe_and_export() {
    let mut harness = folded("sphere");
    let before = picture(&harness);
    let mut stops = 0;
    while focused(&harness).as_deref() != Some(named("material.n")) {
        key(&mut harness, Key::Tab);
        stops += 1;
        assert!(
            stops <= 12,
            "no field of n after {stops} stops, at {:?}",
            focused(&harness)
        );
    }
    type_text(&mut harness, "10/2");
    key(&mut harness, Key::Enter);
    assert_eq!(scene(&harness).material.n, 5.0);
    assert!(picture(&harness) != before, "n changes the picture");
    // The probe, from wherever the focus is.
    key(&mut harness, Key::Tab);
    key(&mut harness, Key::F3);
    let probe = |harness: &Harness<'_, App>| harness.state().state().window.probe;
    key(&mut harness, Key::ArrowRight);
    // Now it is at a pixel's centre.
    let start = probe(&harness).0;
    harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowLeft);
    harness.run();
    assert!(probe(&harness).0.x < start.x, "an arrow moves the probe");
    for _ in 0..10 {
        key(&mut harness, Key::ArrowRight);
    }
    let moved = probe(&harness).0.distance(start);
    assert!(
        moved < 1e-9,
        "ten pixels back, ten times one forwards: {moved}"
    );
    // The export: a dialog whose field has the focus, and Enter.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run();
    let path = std::env::temp_dir().join(format!("shading-lab-keys-{}.png", std::process::id()));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.run();
    harness.event(Event::Text(path.display().to_string()));
    harness.run();
    key(&mut harness, Key::Enter);
    assert!(
        hands::wait(&mut harness, |_| path.is_file()),
        "no picture at {}",
        path.display()
    );
    std::fs::remove_file(path).expect("the picture");
}

#[test]
fn a_row_is_one_stop_and_shift_leads_back() {
    let mut harness = window("sphere");
    let (kd, kept) = (named("material.kd"), scene(&harness).material.kd);
    harness.get_by_role_and_label(Role::SpinButton, kd).focus();
    harness.run();
    type_text(&mut harness, "0.3");
    key(&mut harness, Key::Tab);
    assert_eq!(focused(&harness).as_deref(), Some(named("material.ks")));
    harness.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
    harness.run();
    assert_eq!(
        focused(&harness).as_deref(),
        Some(kd),
        "no slider and no ↺ between"
    );
    assert_eq!(scene(&harness).material.kd, Rgb::splat(0.3));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::R);
    harness.run();
    assert_eq!(scene(&harness).material.kd, kept, "Ctrl+R resets the row");
    key(&mut harness, Key::F10);
    assert_eq!(
        focused(&harness).as_deref(),
        Some(english!("controls-group-file")),
        "F10 leads to the menus"
    );
}

#[test]
fn a_field_takes_arithmetic_and_says_what_is_no_number() {
    let mut harness = window("sphere");
    let name = named("material.kd");
    let enter = |harness: &mut Harness<'_, App>, text: &str, end: Key| {
        harness
            .get_by_role_and_label(Role::SpinButton, name)
            .focus();
        harness.run();
        type_text(harness, text);
        key(harness, end);
        scene(harness).material.kd.x
    };
    let complains = |harness: &Harness<'_, App>, text: &str| {
        let complaint = english!("controls-field-wrong", text = text);
        harness.query_by_label_contains(&complaint).is_some()
    };
    assert_eq!(enter(&mut harness, "1/4", Key::Enter), 0.25);
    assert_eq!(enter(&mut harness, "sqrt(2)/2", Key::Tab), 0.5_f64.sqrt());
    assert_eq!(
        enter(&mut harness, "0.9", Key::Escape),
        0.5_f64.sqrt(),
        "Escape keeps the old value"
    );
    assert!(!complains(&harness, "0.9"));
    for (text, end) in [("half", Key::Enter), ("1/", Key::Tab), ("nan", Key::Enter)] {
        assert_eq!(enter(&mut harness, text, end), 0.5_f64.sqrt(), "{text}");
        assert!(complains(&harness, text), "{text} is said to be wrong");
    }
    assert_eq!(
        enter(&mut harness, "inf", Key::Enter),
        0.5_f64.sqrt(),
        "the scene refuses it"
    );
    assert_eq!(enter(&mut harness, "0.5", Key::Enter), 0.5);
    assert!(
        !complains(&harness, "nan"),
        "a number takes the complaint away"
    );
}

#[test]
fn resetting_gives_every_kind_of_row_back_what_was_opened() {
    let reset = english!("controls-reset", name = "");
    for name in ["sphere", "brass", "spotlight"] {
        let harness = folded(name);
        let arrows = harness.query_all_by_role(Role::Button).filter(|button| {
            let label = button.accesskit_node().label().unwrap_or_default();
            label.starts_with(&reset) && label != english!("controls-reset-camera")
        });
        assert_eq!(
            arrows.count(),
            0,
            "an untouched scene has nothing to reset: {name}"
        );
    }
    let mut harness = window("spotlight");
    let before = scene(&harness).clone();
    for (field, value, reset) in [
        ("material.ks", 0.9, "material.ks"),
        ("material.color.green", 0.2, "material.color"),
        ("light.0.position.y", 9.0, "light.0.position"),
        ("object.segments", 9.0, "object.segments"),
    ] {
        hands::enter(&mut harness, field, value);
        assert!(*scene(&harness) != before, "{field}");
        let reset = english!("controls-reset", name = named(reset));
        press(&mut harness, &reset);
        assert_eq!(*scene(&harness), before, "{reset}");
        let left = harness.query_by_role_and_label(Role::Button, &reset);
        assert!(left.is_none(), "nothing is left to reset");
    }
    hands::choose(&mut harness, "reflection.backfacing", "flip");
    let reset = |key: &str| english!("controls-reset", name = named(key));
    press(&mut harness, &reset("reflection.backfacing"));
    press(&mut harness, "shading.shadows.off");
    press(&mut harness, &reset("shading.shadows"));
    assert_eq!(*scene(&harness), before);
}

#[test]
fn sections_open_where_the_scene_is_about_them() {
    let open = |harness: &Harness<'_, App>| -> Vec<&str> {
        harness
            .query_all_by_role(Role::DisclosureTriangle)
            .filter(|section| section.accesskit_node().data().is_expanded() == Some(true))
            .filter_map(|section| section.accesskit_node().label())
            .filter_map(|label| TITLES.into_iter().find(|key| label == named(key)))
            .collect()
    };
    for (name, expected) in [
        (
            "sphere",
            &["controls-material", "controls-lights", "controls-shading"][..],
        ),
        (
            "glass-ball",
            &["controls-material", "controls-transparency"],
        ),
        (
            "shadows",
            &[
                "controls-material",
                "controls-lights",
                "controls-surroundings",
            ],
        ),
    ] {
        assert_eq!(open(&folded(name)), expected, "{name}");
    }
}

#[test]
fn projector_size_follows_the_windows_height() {
    let mut harness = folded("sphere");
    for height in [800.0, 768.0, 1080.0] {
        harness.set_size(eframe::egui::vec2(1280.0, height));
        key(&mut harness, Key::F9);
        let text = harness.ctx.zoom_factor() * 14.0;
        assert!(
            (text - height / 28.0).abs() < 0.1,
            "{text} of {height} points: ordinary text is a 28th of the height"
        );
        let appearance = &harness.state().state().window.appearance;
        assert!(appearance.projector && !appearance.controls && !appearance.views);
        key(&mut harness, Key::F9);
        assert_eq!(harness.ctx.zoom_factor(), 1.0);
    }
}

#[test]
fn tab_through_fields_keeps_the_digits_that_are_not_shown() {
    let mut harness = window("attenuation");
    let before = scene(&harness).clone();
    assert!(
        before.lights[0].color.y == 0.4275,
        "the field shows 0.43 of {}",
        before.lights[0].color
    );
    let mut fields = Vec::new();
    for _ in 0..60 {
        key(&mut harness, Key::Tab);
        fields.extend(focused(&harness));
    }
    assert!(
        fields
            .iter()
            .any(|name| name.contains(english!("controls-green"))),
        "{fields:?}"
    );
    assert_eq!(scene(&harness), &before);
}

#[test]
fn shift_leads_back_the_way_that_tab_came() {
    let mut harness = window("attenuation");
    let focus = |harness: &Harness<'_, App>| harness.ctx.memory(|memory| memory.focused());
    let mut way = Vec::new();
    while way.len() < 200 {
        key(&mut harness, Key::Tab);
        let stop = (focus(&harness), focused(&harness));
        if way.first() == Some(&stop) {
            break;
        }
        way.push(stop);
    }
    assert!(way.len() > 10 && way.len() < 200, "{way:?}");
    let back: Vec<_> = way
        .iter()
        .map(|_| {
            harness.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
            harness.run();
            let stop = (focus(&harness), focused(&harness));
            way.iter().position(|one| *one == stop)
        })
        .collect();
    let expected: Vec<_> = (0..way.len()).rev().map(Some).collect();
    let names: Vec<_> = way.iter().map(|(_, name)| name).collect();
    assert_eq!(back, expected, "{names:?}");
}
