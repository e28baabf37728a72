//! Keys and the controls that they reach.

use crate::common::hands::{enter, named, press, scene, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, Shape};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::{App, Appearance};
use shading_lab::scene::Rgb;

/// Presses keys as a keyboard does, each with the letter that it types.
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
        .get_by_role_and_label(Role::SpinButton, named("material.kd"))
        .focus();
    harness.run();
    type_keys(&mut harness, "0.3");
    let reset = english!("controls-reset", name = named("material.kd"));
    harness.key_press(Key::Tab);
    harness.run();
    assert!(
        harness
            .query_by_role_and_label(Role::Button, &reset)
            .is_some(),
        "it has come to stand between"
    );
    assert!(
        harness
            .get_by_role_and_label(Role::SpinButton, named("material.ks"))
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
            .get_by_role_and_label(Role::SpinButton, named("material.ks"))
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
    press(&mut harness, &reset);
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
                .is_some_and(|name| name.starts_with(&english!("controls-reset", name = ""))),
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
        .get_by_role_and_label(Role::SpinButton, named("material.kd"))
        .focus();
    harness.run();
    // A dialog takes the keys from the field behind it.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    harness.run();
    type_keys(&mut harness, "13");
    assert_eq!(
        harness
            .get_by_role_and_label(Role::TextInput, english!("file"))
            .value()
            .as_deref(),
        Some("13")
    );
    harness.key_press(Key::Escape);
    harness.run();
    // The progress dialog of a file does so, too: a picture that takes long.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run();
    enter(&mut harness, "samples", 1024.0);
    harness
        .get_by_role_and_label(Role::Button, english!("export"))
        .click_accesskit();
    harness.run_steps(3);
    let working = |harness: &Harness<'_, App>| {
        harness
            .query_by_label_contains(&english!("drawing-file", path = ""))
            .is_some()
    };
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
                .query_by_role_and_label(Role::TextInput, english!("file"))
                .is_none(),
        "no dialog opens over it"
    );
    assert_eq!(
        (scene(&harness), &harness.state().state().window.appearance),
        (&before, &Appearance::default())
    );
    harness.key_press(Key::Escape);
    harness.run_steps(4);
    assert!(!working(&harness), "Escape cancels");
}
