//! Smooth edges: a picture gets them when nothing changes, and loses them with the first change.

use crate::common::hands::{picture, wait, window};
use eframe::egui::{Key, vec2};
use egui_kittest::Harness;
use shading_lab::app::App;

fn samples(harness: &Harness<'_, App>) -> u32 {
    harness.state().samples()
}

#[test]
fn a_picture_that_rests_is_refined_until_something_changes() {
    let mut harness = window("cube");
    // A single small picture, so that sixteen samples are drawn quickly.
    harness.key_press(Key::F11);
    harness.run();
    harness.set_size(vec2(200.0, 150.0));
    harness.run();
    let refined = |harness: &Harness<'_, App>| samples(harness) == 16;
    assert!(wait(&mut harness, refined));
    // Measurements keep one sample per pixel, at its centre.
    let measured = picture(&harness);
    harness.key_press(Key::Num1);
    harness.run_steps(1);
    harness.run_steps(1);
    assert_eq!(samples(&harness), 1, "a change goes back at once");
    assert!(picture(&harness) != measured);
    assert!(wait(&mut harness, refined));
    // Needles show pixels.
    harness.key_press(Key::M);
    harness.run();
    assert_eq!(samples(&harness), 1);
    for _ in 0..20 {
        harness.run_steps(1);
    }
    assert_eq!(samples(&harness), 1);
    harness.key_press(Key::M);
    assert!(wait(&mut harness, refined));
}
