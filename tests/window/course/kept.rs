//! A test: answers are kept as they are made, without a word about them.

use super::{answered, choose, go, lesson, next, revealed, step, window_with};
use crate::common::hands::{self, scene};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::App;
use shading_lab::lesson::{Answer, Grade, Lesson};

fn has(harness: &Harness<'_, App>, key: &str) -> bool {
    harness.query_by_label(english!(key)).is_some()
}

fn pick(harness: &mut Harness<'_, App>, option: &str) {
    harness
        .get_by_role_and_label(Role::RadioButton, option)
        .click();
    harness.run_ok();
    harness.run_ok();
}

#[test]
fn a_test_keeps_the_last_answer_and_says_nothing_of_it() {
    let mut harness = window_with(Lesson {
        test: true,
        ..lesson()
    });
    go(&mut harness, 1);
    assert!(has(&harness, "course-not-kept") && !has(&harness, "course-check"));
    pick(&mut harness, "Wider");
    let given = answered(&harness).expect("an answer");
    assert_eq!(given.answer, Answer::Choice(0));
    assert_eq!((given.tries, given.grade), (1, Grade::default()));
    assert!(has(&harness, "course-kept") && !has(&harness, "course-show-answer"));
    let right = "Narrower: $(R·V)^n$ falls faster, and that is seen as a smaller spot on the ball";
    pick(&mut harness, right);
    let given = answered(&harness).expect("an answer");
    // The last answer is the prediction: nothing was said of the one before.
    assert_eq!(
        [given.prediction, given.answer],
        [Answer::Choice(1), Answer::Choice(1)]
    );
    assert_eq!((given.tries, given.grade), (1, Grade::default()));
    assert!(!revealed(&harness) && harness.state().state().course.hides());
    let before = scene(&harness).clone();
    harness.key_press(Key::Num1);
    harness.run_ok();
    assert_eq!(*scene(&harness), before, "the scene stays locked");

    // What is not touched is not answered: neither an order as it lies there nor a control as it stands.
    let settings = lesson().steps.iter().position(|step| {
        let question = step.question.as_ref();
        question.is_some_and(|question| question.kind.name() == "settings")
    });
    let settings = settings.expect("a question with a control");
    let mut hints = 0;
    while step(&harness) < lesson().steps.len() - 1 {
        next(&mut harness);
        harness.run_ok();
        assert!(answered(&harness).is_none(), "step {}", step(&harness));
        // No hint speaks of checking.
        assert!(!has(&harness, "course-curve") && !has(&harness, "course-settings"));
        hints += ["course-curve.test", "course-settings.test"]
            .iter()
            .filter(|key| has(&harness, key))
            .count();
    }
    assert_eq!(hints, 3, "two curves and a control");
    while step(&harness) > settings {
        harness.key_press_modifiers(Modifiers::NONE, Key::PageUp);
        harness.run_ok();
        super::ready(&mut harness);
    }
    hands::enter(&mut harness, "material.n", 55.0);
    harness.run_ok();
    let given = answered(&harness).expect("an answer");
    assert_eq!(given.answer, Answer::Settings(55.0));

    go(&mut harness, lesson().steps.len() - 1);
    choose(&mut harness, "course-test-end");
    let asked = lesson()
        .steps
        .iter()
        .filter(|step| step.question.is_some())
        .count();
    let count = english!("course-test-count", answered = 2, count = asked);
    harness.get_by_label(&count);
    assert!(has(&harness, "course-test-missing") && !has(&harness, "course-mark-right"));
    assert!(!has(&harness, "course-answers-wrong"));
    choose(&mut harness, "course-finish");
    harness.get_by_label(&count);
}
