//! Every view and every dialog at common window sizes, in both languages: no text is cut off or has a letter without a glyph,
//! captions in the picture do not overlap, and the picture keeps its minimum size.

use crate::common::hands;
use eframe::egui::accesskit::Role;
use eframe::egui::epaint::{ClippedShape, Shape, TextShape};
use eframe::egui::{Event, Key, Modifiers, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::{App, Appearance, SavedProgress, ViewName};
use shading_lab::lesson::{Answer, Answered, CURVE_POINTS, Grade, Kind, Lesson, Record};
use shading_lab::scene::presets::DEFAULT;
use shading_lab::text::{Language, in_language, text};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Width and height of the window in points at a scale of 1, and whether it is at projector size.
const SIZES: [([f32; 2], bool); 6] = [
    ([1280.0, 800.0], false),
    ([1024.0, 768.0], false),
    ([1024.0, 768.0], true),
    ([1920.0, 1080.0], false),
    ([390.0, 844.0], false),
    ([844.0, 390.0], false),
];

/// A lock for the language, which belongs to the process: the tests take turns.
static TURN: Mutex<()> = Mutex::new(());

fn turn() -> MutexGuard<'static, ()> {
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Minimum width of the picture in a narrow window, points.
const LEAST: f32 = 176.0;

/// A link whose error has a long word to wrap.
const BROKEN_LINK: &str =
    "https://example.org/shading-lab/?scene=teapot&surroundings.backdrop.horizon=1";

/// The page that links begin with.
const PAGE: &str = "https://example.org/shading-lab/";

/// The height of the menus, points.
const MENUS: f32 = 52.0;

/// The names of the rail's buttons.
const RAIL: [&str; 6] = [
    "view-controls",
    "view-point",
    "view-line",
    "view-picture",
    "view-engine",
    "course",
];

/// Returns the texts of a frame with their clip rectangles.
pub fn texts(shapes: &[ClippedShape]) -> Vec<(Rect, &TextShape)> {
    fn gather<'s>(shape: &'s Shape, clip: Rect, found: &mut Vec<(Rect, &'s TextShape)>) {
        match shape {
            Shape::Text(text) => found.push((clip, text)),
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| gather(shape, clip, found)),
            _ => {}
        }
    }
    let mut found = Vec::new();
    for shape in shapes {
        gather(&shape.shape, shape.clip_rect, &mut found);
    }
    found
}

fn place(text: &TextShape) -> Rect {
    text.galley.rect.translate(text.pos.to_vec2())
}

/// The content of a frame.
#[derive(Clone, Copy, PartialEq)]
enum Shown {
    View,
    /// A view in place of the picture.
    Enlarged,
    /// A dialog with typed text, which may be longer than its field.
    Typed,
}

/// Creates a folder with a window's unsaved work, of a file with a long name.
fn left_behind(name: &str) -> std::path::PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("layout-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    let origin = "/home/teacher/computer-graphics/illumination/a_scene_for_the_third_week.toml";
    let head = format!(
        "# Unsaved work of shading-lab, from {{\"origin\":{{\"File\":\"{origin}\"}}}}\nversion = 1\n"
    );
    fs::write(folder.join("0.toml"), head).expect("kept work");
    folder
}

/// Returns the faults in the frame drawn last.
fn faults(harness: &Harness<'_, App>, shown: Shown) -> Vec<String> {
    let screen = harness.ctx.content_rect();
    let mut faults = Vec::new();
    let pictures = harness.query_all_by_role(Role::Image);
    let picture = pictures
        .map(|node| node.rect())
        .max_by(|a, b| a.area().total_cmp(&b.area()));
    let mut captions: Vec<(Rect, String)> = Vec::new();
    for (clip, text) in texts(&harness.output().shapes) {
        let (rect, words) = (place(text), text.galley.text().to_owned());
        if words.trim().is_empty() || text.angle != 0.0 {
            continue;
        }
        // Items outside a scroll area must be on the screen.
        let fixed = clip.contains_rect(screen);
        if fixed && (rect.min.y < screen.min.y - 1.0 || rect.max.y > screen.max.y + 1.0) {
            faults.push(format!("“{words}” is outside the window: {rect:?}"));
        }
        if !clip.intersects(rect) {
            continue;
        }
        let seen = clip.intersect(screen);
        let cut = rect.min.x < seen.min.x - 1.0 || rect.max.x > seen.max.x + 1.0;
        if cut && shown != Shown::Typed {
            faults.push(format!("“{words}” is cut off: {rect:?} in {seen:?}"));
        }
        // The name of the scene may be shortened in favour of the menus.
        let gives_way = rect.center().y < MENUS;
        if text.galley.elided && shown != Shown::Typed && !gives_way {
            faults.push(format!("“{words}” is shortened"));
        }
        for section in &text.galley.job.sections {
            let range = section.byte_range.start.0..section.byte_range.end.0;
            let part = &text.galley.job.text[range];
            let missing: String = part
                .chars()
                .filter(|letter| !letter.is_control() && !letter.is_whitespace())
                .filter(|letter| {
                    let font = &section.format.font_id;
                    !harness
                        .ctx
                        .fonts_mut(|fonts| fonts.has_glyph(font, *letter))
                })
                .collect();
            if !missing.is_empty() {
                faults.push(format!("no font has {missing:?} of “{words}”"));
            }
        }
        let inside = picture.is_some_and(|picture| picture.expand(2.0).contains_rect(clip));
        if inside && shown == Shown::View && !captions.contains(&(rect, words.clone())) {
            captions.push((rect, words));
        }
    }
    for (index, (a, one)) in captions.iter().enumerate() {
        for (b, other) in &captions[index + 1..] {
            let both = a.intersect(*b);
            if one != other && both.width() > 2.0 && both.height() > 3.0 {
                faults.push(format!("“{one}” and “{other}” overlap in the picture"));
            }
        }
    }
    for name in RAIL.map(|key| text!(key)) {
        for button in harness.query_all_by_role_and_label(Role::Button, name) {
            if !screen.expand(1.0).contains_rect(button.rect()) {
                faults.push(format!(
                    "“{name}” on the rail is outside the window: {:?}",
                    button.rect()
                ));
            }
        }
    }
    let width = picture.map_or(0.0, |picture| picture.width());
    let narrow = screen.width() < 900.0;
    let least = if narrow {
        LEAST
    } else {
        0.47 * screen.width() - 1.0
    };
    if width < least && shown != Shown::Enlarged {
        faults.push(format!("the picture is {width} wide, expected {least}"));
    }
    faults
}

#[test]
fn every_view_and_dialog_fits_at_every_size_in_both_languages() {
    let _turn = turn();
    let mut found = BTreeSet::new();
    for language in Language::ALL {
        for (size, projector) in SIZES {
            let mut appearance = Appearance {
                language: Some(language),
                view: ViewName::Stability,
                ..Appearance::default()
            };
            if projector {
                appearance.projector();
            }
            let scale = appearance.zoom(size[1]);
            let points = size.map(|side| side / scale);
            let mut harness = hands::window_looking(
                hands::built_in("three-lights"),
                points,
                &appearance,
                |app| app,
            );
            let mut check = |harness: &Harness<'_, App>, what: &str, shown: Shown| {
                for fault in faults(harness, shown) {
                    let [width, height] = size;
                    let how = if projector { " to a room" } else { "" };
                    found.insert(format!(
                        "{} {width}×{height}{how}, {what}: {fault}",
                        language.tag()
                    ));
                }
            };
            let first = hands::window_looking(
                hands::built_in(DEFAULT),
                points,
                &appearance,
                App::with_welcome,
            );
            check(&first, "first start", Shown::View);
            let folder = left_behind(&format!("{}-{size:?}", language.tag()));
            let after_crash =
                hands::window_looking(hands::built_in(DEFAULT), points, &appearance, |app| {
                    app.with_recovery(&folder)
                });
            assert!(after_crash.state().state().dialog.is_some());
            check(&after_crash, "kept work", Shown::View);
            check(&harness, "start", Shown::View);
            for _ in 0..10 {
                harness.key_press(Key::C);
                harness.run_ok();
                let tab = harness.state().state().window.appearance.view;
                check(&harness, &format!("{tab:?}"), Shown::View);
                let press = |harness: &mut Harness<'_, App>, key: &str| {
                    let name = in_language(language, || text!(key));
                    harness.get_by_label(name).click_accesskit();
                    harness.run_ok();
                };
                press(&mut harness, "view-enlarge");
                check(&harness, &format!("{tab:?}, enlarged"), Shown::Enlarged);
                press(&mut harness, "view-shrink");
            }
            harness.key_press(Key::Num3);
            harness.run_ok();
            for what in ["panes", "wipe", "difference", "one"] {
                harness.key_press(Key::K);
                harness.run_ok();
                check(&harness, what, Shown::View);
            }
            for (modifiers, key, what) in [
                (Modifiers::NONE, Key::F1, "keys"),
                (Modifiers::NONE, Key::F2, "scenes"),
                (Modifiers::COMMAND, Key::O, "open"),
                (Modifiers::COMMAND, Key::E, "export"),
                (Modifiers::COMMAND, Key::U, "code"),
                (Modifiers::COMMAND, Key::Q, "unsaved"),
            ] {
                harness.key_press_modifiers(modifiers, key);
                harness.run_ok();
                let typed = matches!(what, "open" | "export" | "code");
                let shown = if typed { Shown::Typed } else { Shown::View };
                check(&harness, what, shown);
                harness.key_press(Key::Escape);
                harness.run_ok();
            }
            // Closes the menu again, or the next would not open.
            let mut dialog = |what: &str, open: &dyn Fn(&mut Harness<'_, App>)| {
                open(&mut harness);
                harness.run_ok();
                assert!(
                    harness.state().state().dialog.is_some(),
                    "{what} {language:?} {size:?} {projector}"
                );
                check(&harness, what, Shown::View);
                harness.key_press(Key::Escape);
                harness.run_ok();
                assert!(harness.state().state().dialog.is_none(), "{what}");
            };
            dialog("message", &|harness| {
                harness.event(Event::Paste(BROKEN_LINK.to_owned()));
            });
            dialog("page", &|harness| harness.key_press(Key::Q));
            dialog("about", &|harness| {
                for key in ["menu", "controls-group-help", "controls-command-about"] {
                    let name = in_language(language, || text!(key));
                    // Only in a narrow window are the menus combined into one.
                    if let Some(button) = harness.query_by_role_and_label(Role::Button, name) {
                        button.click_accesskit();
                        harness.run_ok();
                    }
                }
            });
            // Its dialog shows the whole link.
            let with_page = |app: App| app.with_page(Some(PAGE.to_owned()));
            let mut linked =
                hands::window_looking(hands::built_in(DEFAULT), points, &appearance, with_page);
            linked.key_press(Key::Q);
            linked.run_ok();
            assert!(linked.state().state().dialog.is_some());
            check(&linked, "link", Shown::Enlarged);
        }
    }
    let found: Vec<_> = found.into_iter().collect();
    assert!(
        found.is_empty(),
        "{} faults:\n{}",
        found.len(),
        found.join("\n")
    );
}

/// Opens every section of the panel of controls.
fn unfold_all(harness: &mut Harness<'_, App>, language: Language) {
    for key in hands::TITLES {
        let title = in_language(language, || text!(key));
        let section = harness.query_by_role_and_label(Role::DisclosureTriangle, title);
        if let Some(section) =
            section.filter(|section| section.accesskit_node().data().is_expanded() != Some(true))
        {
            section.click_accesskit();
            harness.run_ok();
        }
    }
}

#[test]
fn what_scrolls_is_not_cut_off_at_the_side() {
    let _turn = turn();
    let mut found = BTreeSet::new();
    for language in Language::ALL {
        // High enough that nothing has to scroll.
        for (scene, size) in [
            ("silhouette", [1280.0, 2400.0]),
            ("glass-ball", [390.0, 3200.0]),
            (DEFAULT, [620.0, 2400.0]),
        ] {
            let appearance = Appearance {
                language: Some(language),
                view: ViewName::Stability,
                ..Appearance::default()
            };
            let mut harness =
                hands::window_looking(hands::built_in(scene), size, &appearance, |app| app);
            let mut check = |harness: &Harness<'_, App>, what: &str| {
                for fault in faults(harness, Shown::View) {
                    found.insert(format!("{} {scene} {what}: {fault}", language.tag()));
                }
            };
            unfold_all(&mut harness, language);
            check(&harness, "controls");
            for _ in 0..10 {
                harness.key_press(Key::C);
                harness.run_ok();
                let view = harness.state().state().window.appearance.view;
                check(&harness, &format!("{view:?}"));
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

/// Returns a lesson with each kind of question.
fn lesson() -> Lesson {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/lessons/kinds.md");
    Lesson::open(&path).expect("a lesson")
}

/// Returns wrong answers to all of its questions, each of which was looked up.
fn looked_up(lesson: &Lesson) -> SavedProgress {
    let mut record = Record::new(&lesson.name, 1);
    for (step, question) in lesson.steps.iter().enumerate() {
        let answer = match question.question.as_ref().map(|question| &question.kind) {
            None => continue,
            Some(Kind::Choice(_)) => Answer::Choice(0),
            Some(Kind::Value(_)) => Answer::Value(0.25),
            Some(Kind::Point(_)) => Answer::Point([-0.3, 0.1]),
            Some(Kind::Curve(_)) => Answer::Curve(vec![Some(0.4); CURVE_POINTS]),
            Some(Kind::Settings(_)) => Answer::Settings(3.0),
            Some(Kind::Formula(_)) => Answer::Formula("1".to_owned()),
            Some(Kind::Order(_)) => Answer::Order(vec![0, 1, 2]),
            Some(Kind::Match(_)) => Answer::Match(vec![0.9, 5.0]),
        };
        record.put(Answered {
            step,
            prediction: answer.clone(),
            answer,
            grade: Grade::default(),
            looked_up: 1,
            tries: 2,
            seconds: 10.0,
        });
    }
    SavedProgress {
        records: vec![record],
        ..SavedProgress::default()
    }
}

#[test]
fn every_step_of_a_lesson_fits_at_every_size_in_both_languages() {
    let _turn = turn();
    let mut found = BTreeSet::new();
    for language in Language::ALL {
        for (size, projector) in SIZES {
            let mut appearance = Appearance {
                language: Some(language),
                smooth_edges: false,
                ..Appearance::default()
            };
            if projector {
                appearance.projector();
            }
            let scale = appearance.zoom(size[1]);
            let points = size.map(|side| side / scale);
            let answers = looked_up(&lesson());
            for kept in [SavedProgress::default(), answers] {
                let shown = !kept.records.is_empty();
                let loaded = hands::built_in(DEFAULT);
                let with_lesson = |app: App| app.with_lesson(Some(lesson()), None);
                let mut harness =
                    hands::window_storing(loaded, points, &appearance, &kept, with_lesson);
                for step in 0..lesson().steps.len() {
                    let known = hands::wait(&mut harness, |harness| {
                        let open = harness.state().state().course.open.as_ref();
                        let known = open.and_then(|open| open.known());
                        known.is_some_and(|known| {
                            let known = known.as_ref().expect("texts");
                            known.key.is_some()
                        })
                    });
                    assert!(known, "step {step}");
                    harness.run_ok();
                    harness.run_ok();
                    for fault in faults(&harness, Shown::View) {
                        let [width, height] = size;
                        found.insert(format!(
                            "{} {width}×{height} {projector}, step {step}, {shown}: {fault}",
                            language.tag()
                        ));
                    }
                    harness.key_press(Key::PageDown);
                    harness.run_ok();
                }
                for fault in faults(&harness, Shown::View) {
                    found.insert(format!("{} {size:?}, lessons: {fault}", language.tag()));
                }
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}
