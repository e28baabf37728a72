//! A handed-in picture opened in the window: its author, its lesson, each answer with its mark.

use super::lesson;
use crate::common::hands::{self, press, scene, wait};
use eframe::egui::Key;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::{App, Appearance, ViewName};
use shading_lab::document::load_scene;
use shading_lab::lesson::{ANSWERS_KEYWORD, Answer, Answered, Grade, Record, find, hand_in_bytes};
use shading_lab::picture::{SCENE_KEYWORD, read_texts, write_png};
use shading_lab::render::Frame;
use shading_lab::scene::Scene;
use std::path::{Path, PathBuf};

fn answered(step: usize, prediction: Answer, answer: Answer) -> Answered {
    let tries = if prediction == answer { 1 } else { 3 };
    Answered {
        step,
        prediction,
        answer,
        grade: Grade::default(),
        looked_up: 0,
        tries,
        seconds: 12.4,
    }
}

/// Returns a record of a wrong choice, a number that is correct finally, and a correct order.
fn record() -> Record {
    let mut record = Record::new("kinds", 5);
    record.put(answered(1, Answer::Choice(0), Answer::Choice(0)));
    record.put(answered(2, Answer::Value(0.9), Answer::Value(0.5)));
    let order = Answer::Order(vec![2, 1, 0]);
    record.put(answered(7, order.clone(), order));
    record
}

fn write(name: &str, bytes: &[u8]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, bytes).expect("a file");
    path
}

fn frame() -> Frame {
    Frame {
        width: 8,
        height: 8,
        pixels: vec![[10, 20, 30, 255]; 64],
    }
}

fn picture() -> Vec<u8> {
    hand_in_bytes(
        &frame(),
        &Scene::default(),
        &lesson(),
        &record(),
        "Ada Lovelace",
    )
    .expect("a picture")
}

fn opened(path: &Path) -> Harness<'static, App> {
    let loaded = load_scene(path).expect("a scene");
    hands::window_looking(loaded, [1280.0, 800.0], &Appearance::default(), |app| app)
}

fn show_course(harness: &mut Harness<'_, App>) {
    if !harness.state().state().window.shows(ViewName::Course) {
        hands::press_rail(harness, "course");
    }
}

/// Returns the window's message about the number of right answers.
fn right(right: usize, count: usize) -> String {
    english!("course-answers-right", right = right, count = count)
}

/// Counts the occurrences of a message in the window.
fn count(harness: &Harness<'_, App>, key: &str) -> usize {
    harness.query_all_by_label(english!(key)).count()
}

fn says(harness: &Harness<'_, App>, words: &str) -> bool {
    harness.query_all_by_label(words).next().is_some()
}

#[test]
fn who_answered_what_stands_beside_the_picture_with_its_marks() {
    let mut harness = opened(&write("handed-in.png", &picture()));
    assert!(wait(&mut harness, |harness| says(harness, &right(2, 8))));
    for words in [
        "Ada Lovelace",
        "Every kind of question",
        &english!("course-answers-question", number = 8),
    ] {
        assert!(says(&harness, words), "{words}");
    }
    assert_eq!(count(&harness, "course-mark-right"), 2);
    assert_eq!(count(&harness, "course-answers-wrong"), 1);
    // The first answer, the final one, and the right one.
    let tries = english!("course-answers-tries", count = 3);
    let tries = format!(
        "{tries} · {}",
        english!("course-answers-seconds", seconds = 12)
    );
    for words in ["0.900 units", "0.500 units", "Wider", &tries] {
        assert!(says(&harness, words), "{words}");
    }
    let right = count(&harness, "course-answers-solution");
    assert_eq!(right, 4, "where the answer is not right, and is no curve");

    // They belong to this picture.
    press(&mut harness, "scenes-next");
    show_course(&mut harness);
    assert!(!says(&harness, "Ada Lovelace") && says(&harness, "Ambient light"));
    hands::undo(&mut harness);
    show_course(&mut harness);
    assert!(says(&harness, "Ada Lovelace"));
    // One press leads to the lessons, and one back.
    press(&mut harness, "course-lessons");
    assert!(!says(&harness, "Ada Lovelace"));
    harness
        .get_by_label(english!("course-answers"))
        .click_accesskit();
    harness.run_ok();
    assert!(says(&harness, "Ada Lovelace"));
    assert_eq!(*scene(&harness), Scene::default());
}

#[test]
fn in_a_small_window_the_answers_are_in_sight_and_the_controls_a_step_away() {
    let loaded = load_scene(&write("handed-in-small.png", &picture())).expect("a scene");
    let appearance = Appearance::default();
    let mut harness = hands::window_looking(loaded, [1024.0, 768.0], &appearance, |app| app);
    assert!(wait(&mut harness, |harness| says(harness, &right(2, 8))));
    assert!(!harness.state().state().window.appearance.controls);
    harness.key_press(Key::F4);
    harness.run_ok();
    let appearance = &harness.state().state().window.appearance;
    assert!(appearance.controls && !appearance.views);
}

#[test]
fn answers_to_a_lesson_of_the_program_are_marked_as_well() {
    let lesson = find("diffuse").expect("a lesson").lesson();
    let record = Record::new("diffuse", 1);
    let bytes = hand_in_bytes(&frame(), &Scene::default(), &lesson, &record, "");
    let path = write("handed-in-empty.png", &bytes.expect("a picture"));
    let mut harness = opened(&path);
    let steps = lesson.steps.iter();
    let questions = steps.filter(|step| step.question.is_some()).count();
    let right = right(0, questions);
    assert!(wait(&mut harness, |harness| says(harness, &right)));
    assert!(says(&harness, "handed-in-empty.png"), "who gave no name");
    assert_eq!(count(&harness, "course-answers-none"), questions);
}

#[test]
fn answers_that_were_changed_do_not_count() {
    let path = write("handed-in-changed.png", &changed(&picture()));
    let harness = opened(&path);
    let why = english!("course-answers-void", why = english!("class-changed"));
    assert!(says(&harness, &why));
    // A picture without answers opens as usual.
    let mut plain = Vec::new();
    write_png(&mut plain, &frame(), Some(&Scene::default()), &[]).expect("a picture");
    let harness = opened(&write("plain.png", &plain));
    assert!(harness.state().state().course.shown_hand_in().is_none());
}

/// Changes the name in a picture.
fn changed(bytes: &[u8]) -> Vec<u8> {
    let wanted = [(ANSWERS_KEYWORD, 1 << 20), (SCENE_KEYWORD, 1 << 20)];
    let [answers, scene] = read_texts(std::io::Cursor::new(bytes), wanted).expect("texts");
    let answers = answers.expect("answers").replace("Ada", "Eve");
    let scene = scene.expect("a scene");
    let texts = [(ANSWERS_KEYWORD, &*answers), (SCENE_KEYWORD, &*scene)];
    let mut bytes = Vec::new();
    write_png(&mut bytes, &frame(), None, &texts).expect("a picture");
    bytes
}
