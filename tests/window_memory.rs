//! The window's memory: the largest scenes, meshes and windows leave nothing behind, nor do letters of other sizes and pictures
//! of a closed dialog.

#[path = "common/fixtures.rs"]
#[allow(dead_code, reason = "each program takes what it needs")]
mod common;

use common::hands::{wait, window};
use eframe::egui::{Event, Key, vec2};
use egui_kittest::Harness;
use peak_alloc::PeakAlloc;
use shading_lab::app::App;
use shading_lab::scene::presets;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::sleep;
use std::time::Duration;

#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

/// Scenes that need the most memory: depth cueing, rays to the floor, through glass and from other surfaces, panes, and a fine
/// mesh.
const LARGE: [&str; 6] = [
    "depth-cueing",
    "shadows",
    "glass-ball",
    "one-bounce",
    "sphere&pane=shading.mode=flat&pane=shading.mode=exact&pane=material.n=4",
    "sphere&set=object.segments=1000&set=object.rings=500",
];
/// A lock by which the tests take turns: each counts every byte.
static TURN: Mutex<()> = Mutex::new(());

fn turn() -> MutexGuard<'static, ()> {
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Bytes in which the window shows the cube at rest, with what stays of the tests before: the teapot's intersection data.
const AT_REST: usize = 25_000_000;
/// Bytes that may remain: fonts first used meanwhile, undo steps.
const LEFT: usize = 4_000_000;

fn open(harness: &mut Harness<'_, App>, scene: &str) {
    harness.event(Event::Paste(format!("?scene={scene}&view=equation")));
    harness.run_ok();
}

/// Waits until the cube is drawn and the window at rest; returns the bytes that it takes.
fn at_rest(harness: &mut Harness<'_, App>) -> usize {
    let smooth = |harness: &Harness<'_, App>| harness.state().samples() > 1;
    assert!(wait(harness, smooth), "the cube's edges get smooth");
    // The background job ends slightly after its picture arrives.
    assert!(wait(harness, |_| HEAP.current_usage() < AT_REST));
    let held = (0..25).map(|_| {
        harness.run_ok();
        sleep(Duration::from_millis(20));
        HEAP.current_usage()
    });
    held.min().unwrap_or_default()
}

#[test]
fn large_scenes_leave_nothing_behind() {
    let _turn = turn();
    let mut harness = window("cube");
    let before = at_rest(&mut harness);
    for size in [vec2(1280.0, 800.0), vec2(2560.0, 1600.0)] {
        for scene in LARGE {
            harness.set_size(size);
            open(&mut harness, scene);
            let held = HEAP.current_usage();
            println!("{scene} {size}: {held}");
            assert!(held > before + LEFT, "{scene} needs much");
        }
    }
    harness.set_size(vec2(1280.0, 800.0));
    open(&mut harness, "cube");
    let over = wait(&mut harness, |_| HEAP.current_usage() < before + LEFT);
    assert!(over, "{} of {before}", HEAP.current_usage());
}

/// Checks projector size, where letters grow with the window: each height has letters of its own.
#[test]
fn letters_of_other_sizes_leave_nothing_behind() {
    let _turn = turn();
    let mut harness = window("cube");
    // As large as graphics cards take them.
    harness.input_mut().max_texture_side = Some(16_384);
    harness.run_ok();
    let atlas = |harness: &Harness<'_, App>| harness.ctx.fonts(|fonts| fonts.font_image_size());
    let before = atlas(&harness);
    harness.key_press(Key::F9);
    harness.run_ok();
    for height in (800..1600).step_by(25) {
        harness.set_size(vec2(1280.0, height as f32) / harness.ctx.zoom_factor());
        harness.run_ok();
    }
    assert!(harness.ctx.zoom_factor() > 1.5, "the letters have grown");
    harness.key_press(Key::F9);
    harness.run_ok();
    harness.set_size(vec2(1280.0, 800.0));
    harness.run_ok();
    assert_eq!(harness.ctx.zoom_factor(), 1.0);
    assert_eq!(atlas(&harness), before);
}

#[test]
fn pictures_of_scenes_leave_nothing_behind() {
    let _turn = turn();
    let mut harness = window("cube");
    // The teapot's intersection data are computed once, and stay.
    open(&mut harness, "teapot&set=shading.mode=exact");
    open(&mut harness, "cube");
    let before = at_rest(&mut harness);
    let textures = |harness: &Harness<'_, App>| harness.ctx.tex_manager().read().num_allocated();
    let all = textures(&harness) + presets::ALL.len();
    // A fine screen: the pictures take four times the memory.
    let screen = |harness: &mut Harness<'_, App>, scale: f32| {
        for viewport in harness.input_mut().viewports.values_mut() {
            viewport.native_pixels_per_point = Some(scale);
        }
    };
    for come in [0, all] {
        screen(&mut harness, 2.0);
        harness.key_press(Key::F2);
        harness.run_ok();
        assert!(wait(&mut harness, |harness| textures(harness) >= come));
        harness.key_press(Key::Escape);
        screen(&mut harness, 1.0);
        // Larger buffers are freed with the next scene.
        open(&mut harness, "sphere");
        open(&mut harness, "cube");
        let over = wait(&mut harness, |_| HEAP.current_usage() < before + LEFT);
        assert!(over, "{} of {before}", HEAP.current_usage());
    }
}
