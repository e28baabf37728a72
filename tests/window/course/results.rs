//! The end of a lesson: its results, and the way to hand them in.

use super::{choose, go, ready, said, step, tab_to, type_text, window};
use crate::common::hands::{press, wait};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::App;
use std::path::Path;

#[test]
fn a_lesson_ends_with_its_results_and_hands_in_by_keyboard_alone() {
    let mut harness = window();
    go(&mut harness, 1);
    harness
        .get_by_role_and_label(Role::RadioButton, "Wider")
        .click();
    harness.run_ok();
    press(&mut harness, "course-check");
    press(&mut harness, "course-show-answer");
    let last = 8;
    go(&mut harness, last);
    harness.key_press(Key::PageDown);
    harness.run_ok();
    let results = |harness: &Harness<'_, App>| {
        let open = harness.state().state().course.open.as_ref();
        open.is_some_and(|open| open.results.is_some())
    };
    assert!(results(&harness));
    let count = english!(
        "course-results-count",
        answered = 1,
        count = 8,
        right = 0,
        first = 0,
        looked = 1
    );
    harness.get_by_label(&count);
    let graded = |harness: &mut Harness<'_, App>| {
        let number = english!("course-answers-question", number = 8);
        wait(harness, |harness| harness.query_by_label(&number).is_some())
    };
    assert!(graded(&mut harness));
    // The right answer is shown where it was looked up, and nowhere else.
    let right = english!("course-answers-solution");
    assert_eq!(harness.query_all_by_label(right).count(), 1);
    // What was not right leads back to its step.
    let again = english!("course-results-again");
    harness.get_by_label(again);
    harness
        .get_by_role_and_label(Role::Link, "3. Value")
        .click_accesskit();
    harness.run_ok();
    ready(&mut harness);
    assert!(!results(&harness));
    assert_eq!(step(&harness), 2);
    go(&mut harness, last);
    harness.key_press(Key::PageDown);
    harness.run_ok();
    harness.key_press(Key::PageUp);
    harness.run_ok();
    assert!(!results(&harness) && step(&harness) == last);
    harness.key_press(Key::PageDown);
    harness.run_ok();
    // The button has the focus: Enter, the name, Enter.
    harness.key_press(Key::Enter);
    harness.run_ok();
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("course-by-keyboard.png");
    let _ = std::fs::remove_file(&path);
    tab_to(&mut harness, Role::TextInput, "course-hand-in-name");
    type_text(&mut harness, "Ada");
    tab_to(&mut harness, Role::TextInput, "file");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    type_text(&mut harness, path.to_str().expect("a path"));
    harness.key_press(Key::Enter);
    harness.run_ok();
    // The window says so a little after the file is there.
    let told = english!("course-handed-in", path = path.display().to_string());
    assert!(wait(&mut harness, |harness| said(harness) == Some(&*told)));
    assert!(path.exists() && harness.state().state().dialog.is_none());
    // The list says how far it is done.
    harness.key_press(Key::PageDown);
    harness.run_ok();
    let far = english!("course-answers-right", right = 0, count = 8);
    let listed = |harness: &Harness<'_, App>| harness.query_by_label(&far).is_some();
    assert!(wait(&mut harness, listed));
}

#[test]
fn a_lesson_without_answers_does_not_look_like_a_success() {
    let mut harness = window();
    go(&mut harness, 8);
    choose(&mut harness, "course-results");
    harness.get_by_label(english!("course-results-none"));
    let hand_in = english!("controls-command-hand-in");
    assert!(
        harness
            .query_by_role_and_label(Role::Button, hand_in)
            .is_none()
    );
    choose(&mut harness, "course-finish");
    let own = harness.state().state().course.kept.record("kinds");
    assert!(own.is_none());
    let done = format!("Every kind of question {}", english!("course-done"));
    assert!(harness.query_by_label(&done).is_none());
}
