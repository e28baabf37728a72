//! The course in the window: a lesson with each kind of question, completed by mouse and by keyboard alone.

mod formula;
mod handed_in;
mod kept;
mod left;
mod results;
mod target;

use crate::common::hands;
use crate::common::hands::{named, picture_place, press, scene, wait};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, OpenUrl, OutputCommand, Pos2, Style, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::{App, Appearance, ViewName};
use shading_lab::lesson::{Answer, Answered, Lesson, find, read_hand_in};
use shading_lab::scene::ShadingMode;
use std::path::Path;

fn lesson() -> Lesson {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/lessons/kinds.md");
    Lesson::open_checked(&path).expect("a lesson")
}

/// Opens a window with the lesson.
fn window() -> Harness<'static, App> {
    window_with(lesson())
}

fn window_with(lesson: Lesson) -> Harness<'static, App> {
    window_of(lesson, [1280.0, 800.0])
}

fn window_of(lesson: Lesson, size: [f32; 2]) -> Harness<'static, App> {
    let appearance = Appearance {
        smooth_edges: false,
        ..Appearance::default()
    };
    let loaded = hands::built_in("sphere");
    let mut harness = hands::window_looking(loaded, size, &appearance, |app| {
        app.with_lesson(Some(lesson), Some(5))
    });
    ready(&mut harness);
    harness
}

/// Waits until the step's texts and its answer are known.
fn ready(harness: &mut Harness<'_, App>) {
    let known = wait(harness, |harness| {
        let course = &harness.state().state().course;
        let known = course.open.as_ref().and_then(|open| open.known());
        known.is_some_and(|known| {
            let known = known.as_ref().expect("texts");
            known.key.as_ref().is_some_and(|key| {
                assert!(key.is_ok() || known.ask.is_empty(), "{key:?}");
                true
            })
        })
    });
    assert!(known, "the step is not ready");
    harness.run_ok();
}

fn step(harness: &Harness<'_, App>) -> usize {
    let course = &harness.state().state().course;
    course.open.as_ref().expect("a lesson").step
}

fn next(harness: &mut Harness<'_, App>) {
    harness.key_press(Key::PageDown);
    harness.run_ok();
    ready(harness);
}

fn go(harness: &mut Harness<'_, App>, to: usize) {
    while step(harness) < to {
        next(harness);
    }
}

fn answered(harness: &Harness<'_, App>) -> Option<Answered> {
    harness.state().state().course.answered().cloned()
}

/// Returns the answer being made, once it is complete.
fn draft(harness: &Harness<'_, App>) -> Option<Answer> {
    let open = harness.state().state().course.open.as_ref()?;
    open.answer(scene(harness))
}

fn revealed(harness: &Harness<'_, App>) -> bool {
    harness.state().state().course.revealed()
}

/// Presses Tab until the widget with this role and name has the focus.
fn tab_to(harness: &mut Harness<'_, App>, role: Role, name: &str) {
    let name = named(name);
    for _ in 0..120 {
        harness.key_press(Key::Tab);
        harness.run_ok();
        let node = harness.query_by_role_and_label(role, name);
        if node.is_some_and(|node| node.is_focused()) {
            return;
        }
    }
    panic!("no way to {name:?} by Tab");
}

fn type_text(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(eframe::egui::Event::Text(text.to_owned()));
    harness.run_ok();
}

#[test]
fn a_step_shows_its_scene_its_text_and_its_controls() {
    let mut harness = window();
    assert_eq!(scene(&harness).material.n, 20.0);
    assert_eq!(
        harness.state().state().window.appearance.view,
        ViewName::Course
    );
    assert!(
        harness
            .query_by_label_contains("half-width is 15.0°")
            .is_some()
    );
    harness.get_by_role_and_label(Role::SpinButton, named("material.n"));
    assert!(!harness.state().state().window.appearance.controls);
    // Changes can be reset.
    hands::enter(&mut harness, "material.n", 55.0);
    assert_eq!(scene(&harness).material.n, 55.0);
    harness
        .get_by_label(english!("course-again"))
        .click_accesskit();
    harness.run_ok();
    harness.run_ok();
    assert_eq!(scene(&harness).material.n, 20.0);
    press(&mut harness, "course-next");
    assert_eq!(step(&harness), 1);
    harness.key_press(Key::PageUp);
    harness.run_ok();
    harness.run_ok();
    assert_eq!(step(&harness), 0);
}

#[test]
fn the_picture_moves_on_to_the_next_step() {
    let lesson = find("exponent").expect("a lesson").lesson();
    let mut harness = hands::window_with("sphere", |app| app.with_lesson(Some(lesson), None));
    go(&mut harness, 1);
    let moves = |style: &mut Style| style.animation_time = 0.1;
    harness.ctx.all_styles_mut(moves);
    let n = |harness: &Harness<'_, App>| scene(harness).material.n;
    let before = n(&harness);
    harness.key_press(Key::PageDown);
    harness.step();
    let mut seen = Vec::new();
    while harness.state().state().course.gliding.is_some() {
        harness.step();
        seen.push(n(&harness));
        // The animation counts neither as unsaved changes nor as a step of undo.
        assert!(!harness.state().state().session.modified());
    }
    ready(&mut harness);
    let after = n(&harness);
    let between = |at: &f64| (before.min(after)..before.max(after)).contains(at) && *at != before;
    assert!(seen.iter().any(between), "{seen:?}");
    let open = harness.state().state().course.open.as_ref();
    let staged = open.and_then(|open| open.staged.clone());
    assert_eq!(scene(&harness), &staged.expect("a scene").scene);
    // The question of this step keeps its scene; undo does not lead to another one.
    hands::undo(&mut harness);
    assert_eq!(n(&harness), after);
    assert_eq!(said(&harness), Some(english!("course-locked")));
}

/// Presses a button of the page of results, on which a sign of waiting may turn.
fn choose(harness: &mut Harness<'_, App>, key: &str) {
    harness
        .get_by_role_and_label(Role::Button, named(key))
        .click_accesskit();
    harness.run_ok();
}

fn said<'h>(harness: &'h Harness<'_, App>) -> Option<&'h str> {
    harness.state().state().session.said()
}

/// A question whose answer is seen in the exact picture, with text behind it.
const FOLDS: &str = r#"+++
lesson = 1
name = "folds"
title = "Folds"
+++

## Where are the folds?

A folded sheet.

```step
scene = "vertex-normals"
set = ["compare.view=single", "object.segments=6"]
controls = ["segments"]
```

```question
kind = "choice"
ask = "How many folds are there?"
set = ["shading.mode=exact", "material.kd=0.3"]
[[option]]
text = "One"
right = false
[[option]]
text = "Five"
right = true
```

Each strip has its own normal.
"#;

#[test]
fn the_answer_waits_behind_the_question_and_then_the_scene_moves() {
    let lesson = Lesson::read(FOLDS, None).expect("a lesson");
    let mut harness = window_with(lesson);
    let told = |harness: &Harness<'_, App>| {
        harness
            .query_by_label_contains("Each strip has its own normal")
            .is_some()
    };
    let before = scene(&harness).clone();
    assert!(!told(&harness));
    // What is locked says so, where it stands.
    let waits = english!("course-after-answer");
    assert!(harness.query_all_by_label(waits).next().is_some());
    for key in [Key::Num5, Key::D, Key::K, Key::V, Key::M] {
        harness.key_press(key);
        harness.step();
        assert_eq!(said(&harness), Some(english!("course-locked")), "{key:?}");
        harness.run_ok();
        assert_eq!(scene(&harness), &before, "{key:?}");
        let overlay = &harness.state().state().window.appearance.overlay;
        assert!(!overlay.vectors && !overlay.normals(), "{key:?}");
    }
    let locked = |harness: &Harness<'_, App>, name: &str| {
        let button = harness.get_by_role_and_label(Role::Button, name);
        assert!(button.accesskit_node().is_disabled(), "{name}");
    };
    locked(&harness, "5 Exact");
    let middle = picture_place(&harness).center();
    hands::right_click(&mut harness, middle);
    for name in [
        "picture-menu-point",
        "picture-menu-line",
        "controls-command-export",
    ] {
        locked(&harness, named(name));
    }
    harness.key_press(Key::Escape);
    harness.run_ok();
    let moves = |style: &mut Style| style.animation_time = 0.1;
    harness.ctx.all_styles_mut(moves);
    harness
        .get_by_role_and_label(Role::RadioButton, "Five")
        .click();
    harness.run_ok();
    harness
        .get_by_role_and_label(Role::Button, english!("course-check"))
        .click();
    let mut seen = Vec::new();
    for _ in 0..120 {
        harness.step();
        seen.push(scene(&harness).material.kd.x);
    }
    // A step of the window is a quarter of a second: half of the way, and then the end.
    let halfway = 0.5 * (before.material.kd.x + 0.3);
    let mut passed = seen.clone();
    passed.dedup();
    passed.retain(|kd| *kd != before.material.kd.x);
    assert_eq!(passed.len(), 2, "{seen:?}");
    assert_eq!(seen[0], before.material.kd.x, "the end is not seen first");
    assert!((passed[0] - halfway).abs() < 1e-9, "{seen:?}");
    assert_eq!(seen.last(), Some(&0.3));
    assert_eq!(scene(&harness).shading.mode, ShadingMode::Exact);
    assert!(told(&harness));
    let own = harness.get_by_role_and_label(Role::RadioButton, "Five");
    assert!(own.accesskit_node().toggled().is_some());
    // Now everything is open.
    harness.key_press(Key::Num1);
    harness.run_ok();
    assert_eq!(scene(&harness).shading.mode, ShadingMode::Flat);
}

#[test]
fn a_lesson_alone_says_what_its_scenes_show() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/lessons/en/diffuse.md");
    let mut harness = window_with(Lesson::open(&path).expect("a lesson"));
    let titled = |harness: &Harness<'_, App>| {
        let document = harness.state().state().session.document();
        harness.query_by_label(&document.title()).is_some()
    };
    assert!(!titled(&harness));
    // The probe is marked in steps that take numbers at it.
    let probe = |harness: &Harness<'_, App>| harness.state().state().course.shows_probe();
    assert!(probe(&harness));
    next(&mut harness);
    assert!(!probe(&harness));
    press(&mut harness, "course-lessons");
    harness.run_ok();
    assert!(titled(&harness));
}

#[test]
fn numbers_are_hidden_until_the_answer_is_shown() {
    let mut harness = window();
    go(&mut harness, 1);
    assert!(harness.state().state().course.hides());
    harness
        .get_by_label(&english!("course-numbers", view = english!("view-curves")))
        .click_accesskit();
    harness.run_ok();
    harness.get_by_label(english!("course-hidden"));
    press(&mut harness, "course-to-question");
    // The answer cannot be looked up before one is given.
    assert!(
        harness
            .query_by_label(english!("course-show-answer"))
            .is_none()
    );
    harness
        .get_by_role_and_label(Role::RadioButton, "Wider")
        .click();
    harness.run_ok();
    press(&mut harness, "course-check");
    let first = answered(&harness).expect("an answer");
    assert_eq!((&first.answer, first.tries), (&Answer::Choice(0), 1));
    assert!(!revealed(&harness) && harness.state().state().course.hides());
    press(&mut harness, "course-show-answer");
    let shown = answered(&harness).expect("an answer");
    assert_eq!((shown.looked_up, shown.tries), (1, 1));
    assert!(revealed(&harness) && !harness.state().state().course.hides());
    assert!(
        harness
            .query_by_label_contains("A higher power of")
            .is_some()
    );
    assert!(harness.query_by_label(english!("course-check")).is_none());
}

#[test]
fn every_question_is_answered_by_mouse() {
    let mut harness = window();
    // A place.
    go(&mut harness, 3);
    let picture = picture_place(&harness);
    let click = |harness: &mut Harness<'_, App>, at: Pos2| {
        harness.hover_at(at);
        harness.run_ok();
        harness.drag_at(at);
        harness.run_ok();
        harness.drop_at(at);
        harness.run_ok();
    };
    click(&mut harness, picture.center() + vec2(-150.0, 100.0));
    press(&mut harness, "course-check");
    assert!(!revealed(&harness));
    click(&mut harness, picture.center() + vec2(60.0, -75.0));
    press(&mut harness, "course-check");
    let given = answered(&harness).expect("an answer");
    assert!(given.grade.right, "{given:?}");
    assert_eq!(given.tries, 2);
    // A curve: from the left to the right at the height of a cosine.
    next(&mut harness);
    draw(&mut harness, |share| {
        (180.0 * share).to_radians().cos().max(0.0)
    });
    press(&mut harness, "course-check");
    let given = answered(&harness).expect("an answer");
    assert!(given.grade.right, "{given:?}");
    next(&mut harness);
    draw(&mut harness, |_| 0.05);
    press(&mut harness, "course-check");
    assert!(!revealed(&harness));
    // A setting. The verdict on one value is not shown for another.
    next(&mut harness);
    press(&mut harness, "course-check");
    assert!(!revealed(&harness));
    assert!(harness.query_by_label(english!("course-wrong")).is_some());
    hands::enter(&mut harness, "material.n", 45.3);
    assert!(harness.query_by_label(english!("course-wrong")).is_none());
    press(&mut harness, "course-check");
    assert!(revealed(&harness));
    // An order, in which the last two are the wrong way round.
    next(&mut harness);
    for _ in 0..3 {
        let Some(Answer::Order(order)) = draft(&harness) else {
            panic!("an order");
        };
        let wrong = (1..3).find(|place| order[place - 1] < order[*place]);
        if let Some(place) = wrong {
            let names = ["$n = 10$", "$n = 30$", "$n = 90$"];
            press(
                &mut harness,
                &english!("course-up", item = names[order[place]]),
            );
        }
    }
    press(&mut harness, "course-check");
    let given = answered(&harness).expect("an answer");
    assert_eq!(given.answer, Answer::Order(vec![2, 1, 0]));
    assert!(given.grade.right);
    // A match.
    next(&mut harness);
    press(&mut harness, "course-check");
    assert!(!revealed(&harness));
    hands::enter(&mut harness, "material.kd", 0.3);
    hands::enter(&mut harness, "material.n", 60.0);
    press(&mut harness, "course-check");
    assert!(revealed(&harness));
    choose(&mut harness, "course-results");
    choose(&mut harness, "course-finish");
    let course = &harness.state().state().course;
    assert!(course.open.is_none() && course.kept.done.contains("kinds"));
    assert_eq!(
        course
            .kept
            .record("kinds")
            .map(|record| record.answers.len()),
        Some(6)
    );
}

/// Draws a curve of heights from 0 to 1 over the fraction of the width.
fn draw(harness: &mut Harness<'_, App>, height: impl Fn(f32) -> f32) {
    let area = harness.get_by_role(Role::Canvas).rect();
    // The axes are at the left and at the bottom; the y axis reaches beyond 1.
    let (left, right) = (area.min.x + 25.0, area.max.x - 11.0);
    let (top, bottom) = (area.min.y + 23.0, area.max.y - 38.0);
    let at = |share: f32| {
        pos2(
            left + share * (right - left),
            bottom - height(share) / 1.05 * (bottom - top),
        )
    };
    harness.drag_at(at(0.0));
    harness.run_ok();
    for index in 1..=20 {
        harness.hover_at(at(index as f32 / 20.0));
        harness.run_ok();
    }
    harness.drop_at(at(1.0));
    harness.run_ok();
}

#[test]
fn the_keyboard_alone_is_enough() {
    let mut harness = window();
    next(&mut harness);
    tab_to(
        &mut harness,
        Role::RadioButton,
        "Narrower: $(R·V)^n$ falls faster, and that is seen as a smaller spot on the ball",
    );
    harness.key_press(Key::Enter);
    harness.run_ok();
    tab_to(&mut harness, Role::Button, "course-check");
    harness.key_press(Key::Enter);
    harness.run_ok();
    assert!(answered(&harness).is_some_and(|answered| answered.grade.right));
    // A presenter's remote works whatever has the focus.
    next(&mut harness);
    tab_to(&mut harness, Role::TextInput, "course-answer");
    type_text(&mut harness, "1/3");
    harness.key_press(Key::Enter);
    harness.run_ok();
    assert!(!revealed(&harness));
    // It is the answer of a wrong model, which is named.
    let named = "That is a straight line, 0.33; it is a cosine.";
    assert!(harness.query_by_label_contains(named).is_some());
    // The next try continues in the field.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    type_text(&mut harness, "1/2");
    harness.key_press(Key::Enter);
    harness.run_ok();
    harness.run_ok();
    assert!(answered(&harness).is_some_and(|answered| answered.grade.right));
    next(&mut harness);
    harness.key_press(Key::F3);
    harness.run_ok();
    for _ in 0..6 {
        harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowRight);
        harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowUp);
        harness.run_ok();
    }
    harness.key_press(Key::Enter);
    harness.run_ok();
    let given = answered(&harness).expect("an answer");
    assert!(given.grade.right, "{given:?}");
    next(&mut harness);
    tab_to(
        &mut harness,
        Role::Canvas,
        &english!("course-curve-area", y = "cos θ", x = "θ, degrees"),
    );
    for _ in 0..20 {
        harness.key_press(Key::ArrowLeft);
        harness.run_ok();
    }
    for column in 0..17 {
        let wanted = (column as f64 * 180.0 / 16.0).to_radians().cos().max(0.0);
        loop {
            // The first key makes the whole curve level.
            let value = match draft(&harness) {
                Some(Answer::Curve(drawn)) => drawn[column * (drawn.len() - 1) / 16],
                _ => None,
            };
            if value.is_some_and(|value| (value - wanted).abs() < 0.03) {
                break;
            }
            let value = value.unwrap_or(0.5);
            let key = if value < wanted {
                Key::ArrowUp
            } else {
                Key::ArrowDown
            };
            harness.key_press(key);
            harness.run_ok();
        }
        harness.key_press(Key::ArrowRight);
        harness.run_ok();
    }
    harness.key_press(Key::Enter);
    harness.run_ok();
    let given = answered(&harness).expect("an answer");
    assert!(given.grade.right, "{given:?}");
}

#[test]
fn answers_are_handed_in_as_a_picture() {
    let mut harness = window();
    go(&mut harness, 2);
    tab_to(&mut harness, Role::TextInput, "course-answer");
    type_text(&mut harness, "0.9");
    press(&mut harness, "course-check");
    assert!(!revealed(&harness));
    press(&mut harness, "controls-group-file");
    press(&mut harness, "controls-command-hand-in");
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("course-answers.png");
    let _ = std::fs::remove_file(&path);
    for (field, text) in [
        ("course-hand-in-name", "Ada"),
        ("file", path.to_str().expect("a path")),
    ] {
        let field = harness.get_by_role_and_label(Role::TextInput, english!(field));
        field.focus();
        harness.run_ok();
        harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        type_text(&mut harness, text);
    }
    press(&mut harness, "course-hand-in.verb");
    let there = path.clone();
    assert!(wait(&mut harness, |_| there.exists()));
    let file = std::io::BufReader::new(std::fs::File::open(&path).expect("a file"));
    let handed_in = read_hand_in(file).expect("answers");
    assert_eq!(
        (&*handed_in.name, &*handed_in.record.lesson),
        ("Ada", "kinds")
    );
    assert_eq!(handed_in.record.seed, 5);
    let answers: Vec<_> = handed_in
        .record
        .answers
        .iter()
        .map(|one| &one.answer)
        .collect();
    assert_eq!(answers, [&Answer::Value(0.9)]);
}

#[test]
fn a_question_out_of_sight_has_a_way_down_to_it() {
    let seen = |harness: &Harness<'_, App>| {
        harness
            .query_by_role_and_label(Role::Button, english!("course-to-question"))
            .is_some()
    };
    let mut high = window();
    go(&mut high, 1);
    assert!(!seen(&high));
    let mut low = window_of(lesson(), [1280.0, 260.0]);
    go(&mut low, 1);
    assert!(seen(&low));
    low.get_by_role_and_label(Role::Button, english!("course-to-question"))
        .click();
    for _ in 0..3 {
        low.run_ok();
    }
    assert!(!seen(&low));
}

/// Returns the addresses that the desktop is asked to open in the next frames.
fn addresses(harness: &mut Harness<'_, App>) -> Vec<String> {
    let mut all = Vec::new();
    for _ in 0..4 {
        harness.step();
        let commands = &harness.output().platform_output.commands;
        all.extend(commands.iter().filter_map(|command| match command {
            OutputCommand::OpenUrl(open) => Some(open.url.clone()),
            _ => None,
        }));
    }
    all
}

#[test]
fn a_lesson_opens_pages_and_letters_and_nothing_else() {
    let closed = [
        ("closed script", "javascript:alert(1)"),
        ("closed Script", "JaVaScRiPt:alert(1)"),
        ("closed data", "data:text/html,x"),
        ("closed file", "file:///etc/passwd"),
        ("closed share", "smb://host/share"),
        ("closed login", "ssh://host"),
        ("closed beside", "other.html"),
    ];
    let links: String = closed
        .iter()
        .map(|(words, address)| format!("[{words}]({address})\n\n"))
        .collect();
    let text = format!(
        "+++\nlesson = 1\nname = \"links\"\ntitle = \"Links\"\n+++\n\n## Links\n\n\
         [page](https://example.org/?a=1) [letter](mailto:a@example.org) [[nested](x)](javascript:y)\n\n{links}\
         ```step\nscene = \"sphere\"\n```\n"
    );
    let mut harness = window_with(Lesson::read(&text, None).expect("a lesson"));
    // A link in the status bar leads to a view.
    let shown = harness.get_all_by_role(Role::Link);
    let shown = shown.filter_map(|node| node.accesskit_node().label());
    let shown: Vec<_> = shown
        .filter(|words| !words.ends_with(&english!("left-out", count = "")))
        .collect();
    assert_eq!(shown, ["page", "letter"]);
    for (words, _) in closed {
        let mut shown = harness.query_all_by_label_contains(words);
        assert!(shown.next().is_some(), "{words}");
    }
    for (words, address) in [
        ("page", "https://example.org/?a=1"),
        ("letter", "mailto:a@example.org"),
    ] {
        harness
            .get_by_role_and_label(Role::Link, words)
            .click_accesskit();
        assert_eq!(addresses(&mut harness), [address]);
    }
    // No other request to open an address gets through, either.
    for (_, address) in closed {
        harness.ctx.open_url(OpenUrl::same_tab(address));
        assert_eq!(addresses(&mut harness), [""; 0], "{address}");
    }
}
