//! Lessons that are wrong in any way, gone through in the window: each is refused or shown, and any answer may be given to it.

use crate::common::dice::Dice;
use crate::common::fuzz::{Format, is_small, text};
use crate::common::hands::{built_in, window_looking};
use crate::common::lessons::EVERY_KIND;
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key};
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT;
use shading_lab::app::{App, Appearance};
use shading_lab::lesson::Lesson;
use std::thread::sleep;
use std::time::Duration;

#[test]
fn lessons_through_to_the_window() {
    let format = Format {
        name: "lessons through to the window",
        sound: vec![
            include_bytes!("../../data/lessons/kinds.md").to_vec(),
            EVERY_KIND.into(),
        ],
        words: &[
            "x = [0, 5e-324]\n",
            "y = [-1e300, 1e300]\n",
            "tolerance = 1e-300\n",
            "from = -1e308\n",
            "answer = \"x*1e308\"\n",
            "answer = 1e-320\n",
            "unit = \"𝕏\"\n",
            "probe = [1e9, -1e9]\n",
            "line = [0, 0, 0, 0]\n",
            "$\\frac{$",
            "{{ probe.sum[0] | 9 }}",
        ],
        read: |bytes| {
            let Ok(lesson) = Lesson::read(&text(bytes), None) else {
                return false;
            };
            if is_small(&lesson) {
                go_through(lesson, &mut Dice(bytes.len() as u64));
            }
            true
        },
        png: false,
    };
    format.fuzz();
}

/// Goes through every step, and answers its question in some way.
fn go_through(lesson: Lesson, dice: &mut Dice) {
    let appearance = Appearance {
        smooth_edges: false,
        ..Appearance::default()
    };
    let steps = lesson.steps.len();
    let mut harness = window_looking(built_in("sphere"), [1280.0, 800.0], &appearance, |app| {
        app.with_lesson(Some(lesson), Some(5))
    });
    for _ in 0..steps {
        settle(&mut harness);
        for _ in 0..3 {
            answer(&mut harness, dice);
        }
        harness.key_press(Key::Enter);
        harness.run_ok();
        harness.key_press(Key::PageDown);
        harness.run_ok();
    }
}

/// Waits a little for what is worked out beside the window; a step that is wrong is never ready.
fn settle(harness: &mut Harness<'_, App>) {
    for _ in 0..50 {
        harness.run_ok();
        let open = harness.state().state().course.open.as_ref();
        let known = open.and_then(|open| open.known());
        if known.is_some_and(|known| {
            known
                .as_ref()
                .is_ok_and(|known| known.solution.is_some() || known.ask.is_empty())
        }) {
            return;
        }
        sleep(Duration::from_millis(2));
    }
}

/// Clicks, drags or types into something that an answer can be given by.
fn answer(harness: &mut Harness<'_, App>, dice: &mut Dice) {
    const ROLES: [Role; 6] = [
        Role::RadioButton,
        Role::CheckBox,
        Role::SpinButton,
        Role::TextInput,
        Role::Image,
        Role::Slider,
    ];
    let usable = harness.root().children_recursive().filter_map(|node| {
        let it = node.accesskit_node();
        (ROLES.contains(&it.role()) && !it.is_disabled() && it.bounding_box().is_some())
            .then(|| node.rect())
    });
    let places: Vec<_> = usable.collect();
    if places.is_empty() {
        return;
    }
    let rect = dice.of(&places);
    let mut at =
        || rect.min + rect.size() * eframe::egui::vec2(dice.unit() as f32, dice.unit() as f32);
    let [from, to] = [at(), at()];
    harness.drag_at(from);
    harness.run_ok();
    if dice.unit() < 0.5 {
        harness.hover_at(to);
        harness.run_ok();
        harness.drop_at(to);
    } else {
        harness.drop_at(from);
    }
    harness.run_ok();
    let typed = dice.of(&["0", "1e300", "-1e300", "nan", "1e-320", "0.5", ""]);
    harness.event(Event::Text(typed.to_owned()));
    harness.run_ok();
}
