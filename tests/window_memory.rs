//! What the window holds: the largest scenes, meshes and windows leave nothing behind.

#[path = "common/window.rs"]
mod hands;

use eframe::egui::{Event, vec2};
use egui_kittest::Harness;
use hands::{wait, window};
use peak_alloc::PeakAlloc;
use shading_lab::app::App;

#[global_allocator]
static HEAP: PeakAlloc = PeakAlloc;

/// Scenes that need the most: fading, rays to the floor, through glass and from other surfaces, panes, and a fine mesh.
const LARGE: [&str; 6] = [
    "depth-cueing",
    "shadows",
    "glass-ball",
    "one-bounce",
    "sphere&pane=shading.mode=flat&pane=shading.mode=exact&pane=material.n=4",
    "sphere&set=object.segments=1000&set=object.rings=500",
];
/// What may be left of them: fonts that were first used there, steps of undo.
const LEFT: usize = 4_000_000;

fn open(harness: &mut Harness<'_, App>, scene: &str) {
    harness.event(Event::Paste(format!("?scene={scene}&view=equation")));
    harness.run_ok();
}

#[test]
fn large_scenes_leave_nothing_behind() {
    let mut harness = window("cube");
    let smooth = |harness: &Harness<'_, App>| harness.state().samples() > 1;
    assert!(wait(&mut harness, smooth), "the cube's edges get smooth");
    // The work beside the window is over a little later than its picture comes.
    assert!(wait(&mut harness, |_| HEAP.current_usage() < 20_000_000));
    let before = HEAP.current_usage();
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
