//! A formula is typed, set as in a textbook while it is, checked by Enter, and told where it is wrong.

use super::{answered, draft, ready, revealed, tab_to, type_text, window_of, window_with};
use crate::common::hands::named;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, ImeEvent, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::App;
use shading_lab::lesson::{Answer, Lesson};

const LESSON: &str = r#"+++
lesson = 1
name = "formulas"
title = "Formulas"
+++

## The diffuse term

```step
scene = "matt"
```

```question
kind = "formula"
ask = "Write the diffuse term."
names = ["kd", "ip", "N·L"]
answer = "kd * ip * max(N·L, 0)"
why = "Three factors."
[[wrong]]
formula = "kd * ip * N·L"
says = "A light cannot take light away."
```
"#;

fn window() -> Harness<'static, App> {
    window_with(Lesson::read(LESSON, None).expect("a lesson"))
}

fn field(harness: &mut Harness<'_, App>) {
    tab_to(harness, Role::MultilineTextInput, "course-answer");
}

fn retype(harness: &mut Harness<'_, App>, text: &str) {
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    type_text(harness, text);
}

fn enter(harness: &mut Harness<'_, App>) {
    harness.key_press(Key::Enter);
    harness.run_ok();
    harness.run_ok();
}

fn shows(harness: &Harness<'_, App>, words: &str) -> bool {
    harness.query_by_label_contains(words).is_some()
}

#[test]
fn enter_checks_and_each_wrong_answer_is_told_why() {
    let mut harness = window();
    field(&mut harness);
    // What cannot be read is told below the field, with its place, and is no answer.
    type_text(&mut harness, "kd * jp");
    assert!(shows(&harness, "line 1, column 6") && draft(&harness).is_none());
    enter(&mut harness);
    assert!(answered(&harness).is_none());
    retype(&mut harness, "N·L*kd*ip");
    enter(&mut harness);
    assert!(shows(&harness, "A light cannot take light away."));
    retype(&mut harness, "kd * max(N·L, 0)");
    assert!(
        !shows(&harness, "A light cannot take light away."),
        "told of the last answer"
    );
    enter(&mut harness);
    let given = answered(&harness).expect("an answer");
    assert_eq!((given.grade.right, given.tries), (false, 2));
    assert!(shows(&harness, "expected is 0"), "a counterexample");
    // Undone in the field, not in the scene.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_ok();
    assert_ne!(
        draft(&harness),
        Some(Answer::Formula("kd * max(N·L, 0)".to_owned()))
    );
    retype(&mut harness, "max(0, NL)");
    harness.key_press_modifiers(Modifiers::SHIFT, Key::Enter);
    harness.run_ok();
    type_text(&mut harness, "* kd * ip");
    assert!(!revealed(&harness), "Shift+Enter begins a line");
    enter(&mut harness);
    let given = answered(&harness).expect("an answer");
    assert!(given.grade.right && revealed(&harness));
    assert_eq!(
        given.answer,
        Answer::Formula("max(0, NL)\n* kd * ip".to_owned())
    );
    assert!(shows(&harness, "Three factors."));
    assert!(shows(&harness, english!("course-formula-right")));
}

#[test]
fn names_are_put_where_the_cursor_is() {
    let mut harness = window();
    let typed = |harness: &Harness<'_, App>| {
        let field = harness.get_by_role(Role::MultilineTextInput);
        field.value().unwrap_or_default()
    };
    let put = |harness: &mut Harness<'_, App>, key: &str| {
        let name = english!("course-formula-put", key = key);
        harness
            .get_by_role_and_label(Role::Button, &name)
            .click_accesskit();
        harness.run_ok();
    };
    put(&mut harness, "kd");
    type_text(&mut harness, "*");
    put(&mut harness, "N·L");
    assert_eq!(typed(&harness), "kd*N·L");
    assert_eq!(draft(&harness), Some(Answer::Formula("kd*N·L".to_owned())));
    harness.key_press(Key::Home);
    harness.run_ok();
    put(&mut harness, "ip");
    type_text(&mut harness, "*");
    assert_eq!(
        draft(&harness),
        Some(Answer::Formula("ip*kd*N·L".to_owned()))
    );
    // By the pointer as well the field keeps the focus.
    let name = english!("course-formula-put", key = "kd");
    harness.get_by_role_and_label(Role::Button, &name).click();
    harness.run_ok();
    type_text(&mut harness, "*");
    assert_eq!(typed(&harness), "ip*kd*kd*N·L");
    harness.key_press(Key::Backspace);
    harness.key_press(Key::Backspace);
    harness.key_press(Key::Backspace);
    harness.run_ok();
    // Two names side by side stay two.
    harness.key_press(Key::End);
    harness.run_ok();
    put(&mut harness, "kd");
    assert_eq!(draft(&harness), None);
    assert!(shows(&harness, "kd"));
    let signs = english!("course-formula-put", key = "^");
    assert!(
        harness.query_by_label(&signs).is_none(),
        "a keyboard has signs"
    );
}

#[test]
fn a_phone_has_the_signs_beside_the_field() {
    let mut harness = window_of(
        Lesson::read(LESSON, None).expect("a lesson"),
        [390.0, 844.0],
    );
    ready(&mut harness);
    for key in ["N·L", "·", "^", "(", ")"] {
        let name = english!("course-formula-put", key = key);
        let button = harness.get_by_role_and_label(Role::Button, &name);
        let rect = button.rect();
        assert!(rect.min.x >= 0.0 && rect.max.x <= 390.0, "{key}: {rect}");
        assert!(rect.height() >= 20.0, "{key}: {rect}");
    }
}

#[test]
fn an_input_method_ends_its_word_by_enter_without_checking() {
    let mut harness = window();
    field(&mut harness);
    type_text(&mut harness, "kd * ip");
    let enter_key = Event::Key {
        key: Key::Enter,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let commit = Event::Ime(ImeEvent::Commit(String::new()));
    harness.input_mut().events.extend([commit, enter_key]);
    harness.step();
    harness.run_ok();
    assert!(answered(&harness).is_none());
    enter(&mut harness);
    assert!(answered(&harness).is_some());
    assert!(harness.query_by_label(named("course-check")).is_some());
}
