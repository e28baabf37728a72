//! The live class in the lecturer's window: led by the keys of a remote, with the answers over one another.

use crate::common::hands::{self, decoded_code, press, wait};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::{App, Appearance, ViewName};
use shading_lab::class::{AnswerRequest, Live, LiveOptions, ServerOptions, Token};
use shading_lab::lesson::{Answer, CURVE_POINTS, Lesson, Phase, find};
use std::fs;
use std::net::{IpAddr, Ipv4Addr};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A folder of a test's own, which is removed with it.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let number = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!("shading-lab-class-{}-{number}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn lesson() -> Lesson {
    find("mach-bands").expect("a lesson").lesson()
}

fn live(folder: &Folder) -> Live {
    let options = LiveOptions {
        record: folder.0.join("class.jsonl"),
        server: ServerOptions {
            bind: IpAddr::from(Ipv4Addr::LOCALHOST),
            port: None,
            page: None,
        },
        url: None,
        own_pace: false,
        rehearse: 0,
        seed: 1,
    };
    Live::start(lesson(), &options).expect("a class")
}

/// Opens a window with a class.
fn window(folder: &Folder, size: [f32; 2], appearance: &Appearance) -> Harness<'static, App> {
    let loaded = hands::built_in("sphere");
    let mut harness = hands::window_looking(loaded, size, appearance, |app| {
        app.with_lesson(Some(lesson()), Some(1))
    });
    let ctx = harness.ctx.clone();
    harness.state_mut().teach(&ctx, live(folder));
    // The engine prepares the steps meanwhile, and tells the window of each.
    let prepared = wait(&mut harness, |harness| {
        let class = harness.state().state().course.class.as_ref();
        let room = class.expect("a class").live.room();
        (1..=room.lesson().steps.len()).all(|step| room.step(step).is_some())
    });
    assert!(prepared, "the steps are not prepared");
    hands::settle(&mut harness);
    harness
}

fn plain() -> Appearance {
    Appearance {
        smooth_edges: false,
        ..Appearance::default()
    }
}

fn phase(harness: &Harness<'_, App>) -> (usize, Phase, u32) {
    let class = harness.state().state().course.class.as_ref();
    let pace = class.expect("a class").live.room().pace();
    (pace.step, pace.phase, pace.round)
}

fn join(harness: &Harness<'_, App>, name: &str) -> Token {
    let class = harness.state().state().course.class.as_ref();
    let room = class.expect("a class").live.room();
    room.join(None, Some(name)).expect("a seat")
}

fn answer(harness: &Harness<'_, App>, token: Token, answer: Answer) {
    let (step, _, round) = phase(harness);
    let class = harness.state().state().course.class.as_ref();
    let room = class.expect("a class").live.room();
    let request = AnswerRequest {
        step,
        round,
        answer,
        sent: 0,
    };
    drop(room.answer(token, request).expect("it is open"));
}

fn turn(harness: &Harness<'_, App>, token: Token, step: usize) {
    let class = harness.state().state().course.class.as_ref();
    let room = class.expect("a class").live.room();
    room.turn(token, step).expect("a step");
}

/// Presses a key of the remote, and waits until the class's answers are graded.
fn remote(harness: &mut Harness<'_, App>, key: Key) {
    harness.key_press(key);
    hands::settle(harness);
    let graded = wait(harness, |harness| {
        let class = harness.state().state().course.class.as_ref();
        let seen = class.expect("a class").seen();
        let shown = matches!(seen.pace.phase, Phase::Spread | Phase::Explain);
        !shown || !seen.asks || seen.spread.is_some()
    });
    assert!(graded, "the answers are not graded");
    hands::settle(harness);
}

/// Switches a check box.
fn check(harness: &mut Harness<'_, App>, key: &str) {
    let name = english!(key);
    harness
        .get_by_role_and_label(Role::CheckBox, name)
        .click_accesskit();
    hands::settle(harness);
}

fn says(harness: &Harness<'_, App>, words: &str) -> bool {
    harness.query_all_by_label_contains(words).next().is_some()
}

#[test]
fn a_class_is_led_with_two_keys_and_asks_for_frames_only_when_something_happens() {
    let folder = Folder::new();
    let mut harness = window(&folder, [1280.0, 800.0], &plain());
    let address = harness.state().state().course.class.as_ref();
    let address = address.expect("a class").live.address().to_owned();
    assert_eq!(decoded_code(&harness), address);
    assert!(says(&harness, &english!("wall-joined", count = 0)));
    assert!(says(&harness, "The files of the web page"), "a sentence");
    assert!(!harness.ctx.has_requested_repaint(), "idle");

    let (ada, bob) = (join(&harness, "Ada"), join(&harness, "Bob"));
    assert!(harness.ctx.has_requested_repaint(), "somebody has joined");
    hands::settle(&mut harness);
    assert!(says(&harness, &english!("wall-joined", count = 2)));
    assert!(!harness.ctx.has_requested_repaint(), "idle again");

    // The first key leaves the address, the next ones show, explain and go on.
    remote(&mut harness, Key::PageDown);
    assert_eq!(phase(&harness), (1, Phase::Ask, 1));
    assert_eq!(decoded_code(&harness), address);
    assert!(says(&harness, "Tap the place"), "phones have no mouse");
    answer(&harness, ada, Answer::Point([0.2233, 0.0]));
    answer(&harness, bob, Answer::Point([0.0, 0.0]));
    hands::settle(&mut harness);
    assert!(says(
        &harness,
        &english!("wall-answered", answered = 2, joined = 2)
    ));
    assert!(
        !says(&harness, "Ada") && !says(&harness, "Bob"),
        "no names on the wall"
    );
    remote(&mut harness, Key::PageDown);
    assert_eq!(phase(&harness), (1, Phase::Spread, 1));
    assert!(says(&harness, &english!("wall-count", count = 2)));
    assert!(!says(
        &harness,
        &english!("wall-right-of", right = 1, count = 2)
    ));
    let why = "At the right edge the intensity";
    assert!(!says(&harness, why));

    // Asked again: both rounds are side by side.
    press(&mut harness, "wall-again");
    assert_eq!(phase(&harness), (1, Phase::Ask, 2));
    answer(&harness, bob, Answer::Point([0.2233, 0.01]));
    remote(&mut harness, Key::PageDown);
    let rounds = [1, 2].map(|round| english!("wall-round", round = round));
    assert!(
        rounds
            .iter()
            .all(|round| says(&harness, &format!("{round}: ")))
    );
    check(&mut harness, "wall-right");
    assert!(says(
        &harness,
        &english!("wall-right-of", right = 1, count = 1)
    ));
    remote(&mut harness, Key::PageDown);
    assert_eq!(phase(&harness), (1, Phase::Explain, 2));
    assert!(says(&harness, why));

    remote(&mut harness, Key::PageDown);
    assert_eq!(phase(&harness), (2, Phase::Ask, 1));
    let open = harness.state().state().course.open.as_ref();
    assert_eq!(
        open.map(|open| open.step),
        Some(1),
        "the picture goes on too"
    );
    remote(&mut harness, Key::PageUp);
    assert_eq!(phase(&harness), (1, Phase::Explain, 2), "as it was left");
    let view = harness.state().state().window.appearance.view;
    assert_eq!(view, ViewName::Class);
}

#[test]
fn curves_choices_and_names_are_shown_when_the_lecturer_wants_them() {
    let folder = Folder::new();
    let mut harness = window(&folder, [1280.0, 800.0], &plain());
    let (ada, bob) = (join(&harness, "Ada"), join(&harness, "Bob"));
    for _ in 0..4 {
        remote(&mut harness, Key::PageDown);
    }
    assert_eq!(phase(&harness), (2, Phase::Ask, 1));
    let level = |value: f64| Answer::Curve(vec![Some(value); CURVE_POINTS]);
    answer(&harness, ada, level(0.4));
    answer(&harness, bob, level(0.6));
    remote(&mut harness, Key::PageDown);
    assert!(says(&harness, &english!("wall-count", count = 2)));
    press(&mut harness, "wall-students");
    assert!(!says(&harness, "Ada"));
    check(&mut harness, "wall-names");
    assert!(says(&harness, "Ada") && says(&harness, "Bob"));

    // At their own pace: one is ahead, until the class is together again.
    let elsewhere = english!("wall-elsewhere", count = 1);
    check(&mut harness, "wall-own-pace");
    turn(&harness, ada, 3);
    hands::settle(&mut harness);
    assert!(says(&harness, &elsewhere) && phase(&harness).0 == 2);
    check(&mut harness, "wall-own-pace");
    assert!(!says(&harness, &elsewhere));

    for _ in 0..5 {
        remote(&mut harness, Key::PageDown);
    }
    assert_eq!(phase(&harness), (4, Phase::Ask, 1));
    answer(&harness, ada, Answer::Choice(0));
    answer(&harness, bob, Answer::Choice(1));
    remote(&mut harness, Key::PageDown);
    let half = |right: &str| format!("1 (50 %){right}");
    let right = format!(" · {}", english!("course-mark-right"));
    let bars = |harness: &Harness<'_, App>, words: &str| {
        harness
            .query_all_by_role(Role::Image)
            .filter(|bar| bar.accesskit_node().label().as_deref() == Some(words))
            .count()
    };
    assert_eq!(bars(&harness, &half("")), 2);
    remote(&mut harness, Key::PageDown);
    assert_eq!(
        [bars(&harness, &half("")), bars(&harness, &half(&right))],
        [1, 1]
    );
    assert!(
        says(&harness, "You exchanged the two stripes"),
        "the wrong model"
    );
}

/// Chooses *Course > Teach a class…*.
fn open_menu(harness: &mut Harness<'_, App>) {
    let name = english!("controls-group-course");
    let menu = harness
        .query_all_by_role_and_label(Role::Button, name)
        .next();
    menu.expect("a menu").click_accesskit();
    hands::settle(harness);
    press(harness, "controls-command-teach");
}

#[test]
fn the_menu_teaches_the_open_lesson_with_its_answers_in_a_file() {
    let folder = Folder::new();
    let loaded = hands::built_in("sphere");
    let mut harness = hands::window_looking(loaded, [1280.0, 800.0], &plain(), |app| app);
    open_menu(&mut harness);
    assert!(says(&harness, english!("wall-choose")), "no lesson is open");
    let loaded = hands::built_in("sphere");
    let mut harness = hands::window_looking(loaded, [1280.0, 800.0], &plain(), |app| {
        app.with_lesson(Some(lesson()), Some(1))
    });
    open_menu(&mut harness);
    let file = folder.0.join("answers.jsonl");
    let field = harness.get_by_role_and_label(Role::TextInput, english!("file"));
    field.focus();
    harness.run_ok();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Text(file.display().to_string()));
    harness.run_ok();
    press(&mut harness, "wall-file.verb");
    hands::settle(&mut harness);
    assert!(says(&harness, &english!("wall-joined", count = 0)));
    assert!(says(&harness, "The files of the web page"), "a sentence");
    assert!(file.is_file());
    press(&mut harness, "wall-end");
    assert!(says(
        &harness,
        &english!("wall-teach", title = "Mach bands")
    ));
}

#[test]
fn everything_is_in_reach_on_a_projector_in_both_languages() {
    for language in shading_lab::text::Language::ALL {
        let folder = Folder::new();
        let appearance = Appearance {
            language: Some(language),
            projector: true,
            ..plain()
        };
        let mut harness = window(&folder, [1024.0, 768.0], &appearance);
        let of = |key| shading_lab::text::in_language(language, || shading_lab::text!(key));
        let count = shading_lab::text::in_language(language, || {
            shading_lab::text!("wall-count", count = 0)
        });
        let mut plots = 0;
        for _ in 0..8 {
            remote(&mut harness, Key::PageDown);
            let whole = harness.ctx.content_rect();
            let button = harness.get_by_role_and_label(Role::Button, of("wall-next"));
            let below = button.rect();
            assert!(whole.contains_rect(below), "{below} of {whole}");
            for plot in harness.query_all_by_role_and_label(Role::Image, &count) {
                let rect = plot.rect();
                assert!(whole.contains_rect(rect), "{rect} of {whole}");
                assert!(rect.max.y <= below.min.y, "{rect} is above {below}");
                assert!(rect.height() >= 0.25 * whole.height(), "{rect} of {whole}");
                plots += 1;
            }
        }
        assert!(plots >= 3, "{plots}");
    }
}
