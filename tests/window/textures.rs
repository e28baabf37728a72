//! The picture that the window uploads to the graphics card: the renderer's, whatever has changed since the last one.

use crate::common::hands::{named, picture, undo, window_on};
use eframe::egui::accesskit::Role;
use eframe::egui::{Color32, ColorImage, ImageData, Key, TextureId, TexturesDelta, Vec2, vec2};
use egui_kittest::kittest::Queryable;
use egui_kittest::{Harness, TestRenderer};
use shading_lab::app::App;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;

/// A graphics card that remembers textures: by copying them, or by keeping the images that it was given.
#[derive(Clone, Default)]
struct Card {
    textures: Rc<RefCell<HashMap<TextureId, Arc<ColorImage>>>>,
    keeps: bool,
}

impl TestRenderer for Card {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        for (id, deltas) in &delta.set {
            for delta in deltas.iter().filter(|delta| delta.pos.is_none()) {
                let ImageData::Color(image) = &delta.image;
                let image = if self.keeps {
                    Arc::clone(image)
                } else {
                    Arc::new(ColorImage::clone(image))
                };
                self.textures.borrow_mut().insert(*id, image);
            }
        }
        delta.clear();
    }
}

/// Runs frames until one has drawn a picture, and compares that with the one on the card.
#[track_caller]
fn assert_shown(harness: &mut Harness<'_, App>, card: &Card, what: &str) {
    let before = picture(harness);
    for _ in 0..3 {
        harness.step();
        let frame = harness.state().frame();
        if frame.pixels == before {
            continue;
        }
        let size = [frame.width as usize, frame.height as usize];
        let colors = frame
            .pixels
            .iter()
            .map(|&[r, g, b, a]| Color32::from_rgba_premultiplied(r, g, b, a));
        let expected = ColorImage::new(size, colors.collect());
        let shown = card
            .textures
            .borrow()
            .values()
            .any(|image| **image == expected);
        assert!(shown, "{what}: another picture is shown");
        return;
    }
    panic!("{what} changes no picture");
}

type Change = (&'static str, fn(&mut Harness<'_, App>));

fn slide(harness: &mut Harness<'_, App>, name: &str, value: f64) {
    harness
        .get_by_role_and_label(Role::Slider, named(name))
        .set_value_accesskit(value);
}

#[test]
fn the_window_shows_what_was_drawn() {
    const LARGE: Vec2 = vec2(1400.0, 900.0);
    let changes: [Change; 14] = [
        ("n", |h| slide(h, "material.n", 12.0)),
        ("Ka", |h| slide(h, "material.ka", 0.3)),
        ("Ka again", |h| slide(h, "material.ka", 0.4)),
        ("flat shading", |h| h.key_press(Key::Num1)),
        ("Kd", |h| slide(h, "material.kd", 0.5)),
        ("exact shading", |h| h.key_press(Key::Num5)),
        ("Ks", |h| slide(h, "material.ks", 0.65)),
        ("Gouraud shading", |h| h.key_press(Key::Num3)),
        ("n in Gouraud shading", |h| {
            slide(h, "material.n", 30.0);
        }),
        ("a larger window", |h| {
            h.set_size(LARGE);
        }),
        ("n in it", |h| slide(h, "material.n", 80.0)),
        ("the camera", |h| h.key_press(Key::Plus)),
        ("n once more", |h| slide(h, "material.n", 9.0)),
        ("n and again", |h| slide(h, "material.n", 8.0)),
    ];
    for (scene, keeps) in [
        ("sphere", false),
        ("sphere", true),
        ("teapot", false),
        ("shadows", true),
    ] {
        let card = Card {
            keeps,
            ..Card::default()
        };
        let mut harness = window_on(scene, card.clone());
        for (name, change) in changes {
            change(&mut harness);
            assert_shown(&mut harness, &card, &format!("{scene}, {name}"));
        }
        harness.run();
        let before = picture(&harness);
        undo(&mut harness);
        assert!(picture(&harness) != before, "{scene}: undone");
    }
}
