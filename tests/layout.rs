//! Every view and every dialog at the sizes that people have, in both languages: no text is cut off or has a letter that no font
//! has, captions in the picture keep apart, and the picture keeps its room.

#[path = "common/window.rs"]
mod hands;

use eframe::egui::accesskit::Role;
use eframe::egui::epaint::{ClippedShape, Shape, TextShape};
use eframe::egui::{Key, Modifiers, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::{App, Look, ViewName};
use shading_lab::document::load;
use shading_lab::text::Language;
use std::collections::{BTreeSet, HashMap};
use std::path::Path;

/// Width and height of the window, points at a scale of 1; whether it is shown to a room.
const SIZES: [([f32; 2], bool); 6] = [
    ([1280.0, 800.0], false),
    ([1024.0, 768.0], false),
    ([1024.0, 768.0], true),
    ([1920.0, 1080.0], false),
    ([390.0, 844.0], false),
    ([844.0, 390.0], false),
];

/// The least that the picture has of a narrow window, points.
const LEAST: f32 = 300.0;

#[derive(Default)]
struct Kept(HashMap<String, String>);

impl eframe::Storage for Kept {
    fn get_string(&self, key: &str) -> Option<String> {
        self.0.get(key).cloned()
    }

    fn set_string(&mut self, key: &str, value: String) {
        self.0.insert(key.to_owned(), value);
    }

    fn remove_string(&mut self, key: &str) {
        self.0.remove(key);
    }

    fn flush(&mut self) {}
}

#[derive(serde::Serialize)]
struct Stored {
    look: Look,
}

fn opened(scene: &str, size: [f32; 2], look: Look) -> Harness<'static, App> {
    let mut storage = Kept::default();
    eframe::set_value(&mut storage, "look", &Stored { look });
    let storage: &'static Kept = Box::leak(Box::new(storage));
    let loaded = load(Path::new(scene)).expect("a built-in scene");
    let mut harness = Harness::builder()
        .with_size(size)
        .with_max_steps(60)
        .renderer(hands::Nowhere)
        .build_eframe(move |cc| {
            cc.storage = Some(storage);
            App::new(cc, loaded)
        });
    harness.run_ok();
    harness
}

/// The texts of a frame with what of them may be seen.
fn texts(shapes: &[ClippedShape]) -> Vec<(Rect, &TextShape)> {
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

/// What is wrong in the frame that was drawn last.
fn faults(harness: &Harness<'_, App>, typed: bool) -> Vec<String> {
    let screen = harness.ctx.content_rect();
    let mut faults = Vec::new();
    let pictures = harness.query_all_by_role(Role::Image);
    let picture = pictures
        .map(|node| node.rect())
        .max_by(|a, b| a.area().total_cmp(&b.area()));
    let mut captions: Vec<(Rect, String)> = Vec::new();
    for (clip, text) in texts(&harness.output().shapes) {
        let (rect, words) = (place(text), text.galley.text().to_owned());
        if words.trim().is_empty() || text.angle != 0.0 || !clip.intersects(rect) {
            continue;
        }
        let seen = clip.intersect(screen);
        let cut = rect.min.x < seen.min.x - 1.0 || rect.max.x > seen.max.x + 1.0;
        // What is typed may be longer than its field.
        if cut && !typed {
            faults.push(format!("“{words}” is cut off: {rect:?} in {seen:?}"));
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
        if inside && !typed && !captions.contains(&(rect, words.clone())) {
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
    let width = picture.map_or(0.0, |picture| picture.width());
    let narrow = screen.width() < 900.0;
    let least = if narrow {
        LEAST
    } else {
        0.5 * screen.width() - 1.0
    };
    if width < least {
        faults.push(format!("the picture is {width} wide, expected {least}"));
    }
    faults
}

#[test]
fn every_view_and_dialog_fits_at_every_size_in_both_languages() {
    let mut found = BTreeSet::new();
    for language in Language::ALL {
        for (size, projector) in SIZES {
            let mut look = Look {
                language: Some(language),
                view: ViewName::Stability,
                ..Look::default()
            };
            if projector {
                look.projector();
            }
            let scale = look.zoom(size[1]);
            let points = size.map(|side| side / scale);
            let mut harness = opened("three-lights", points, look);
            let mut check = |harness: &Harness<'_, App>, what: &str, typed: bool| {
                for fault in faults(harness, typed) {
                    let [width, height] = size;
                    let how = if projector { " to a room" } else { "" };
                    found.insert(format!(
                        "{} {width}×{height}{how}, {what}: {fault}",
                        language.tag()
                    ));
                }
            };
            check(&harness, "start", false);
            for _ in 0..9 {
                harness.key_press(Key::C);
                harness.run_ok();
                let tab = harness.state().state().look.view;
                check(&harness, &format!("{tab:?}"), false);
            }
            for (modifiers, key, what) in [
                (Modifiers::NONE, Key::F1, "keys"),
                (Modifiers::NONE, Key::F2, "scenes"),
                (Modifiers::COMMAND, Key::O, "open"),
                (Modifiers::COMMAND, Key::E, "export"),
                (Modifiers::COMMAND, Key::U, "code"),
            ] {
                harness.key_press_modifiers(modifiers, key);
                harness.run_ok();
                check(&harness, what, matches!(what, "open" | "export" | "code"));
                harness.key_press(Key::Escape);
                harness.run_ok();
            }
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
