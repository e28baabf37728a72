//! What the window's frame adds to the engine's when a slider has moved, without the painting by the graphics card:
//! `cargo test --release --test slider_time -- --ignored --nocapture`.

#[path = "common/window.rs"]
mod hands;

use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use hands::{picture, scene, window};
use shading_lab::render::Renderer;
use std::time::Instant;

/// Frames of each kind that count, taken in turn.
const FRAMES: usize = 101;

fn milliseconds(work: impl FnOnce()) -> f64 {
    let began = Instant::now();
    work();
    began.elapsed().as_secs_f64() * 1e3
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[test]
#[ignore = "measures times"]
fn a_slider_costs_little_more_than_its_picture() {
    for name in ["Ka", "n"] {
        let mut harness = window("sphere");
        let values = if name == "n" { [20.0, 21.0] } else { [0.2, 0.3] };
        let mut renderer = Renderer::default();
        let (mut changed, mut unchanged, mut alone) = (vec![], vec![], vec![]);
        for frame in 0..FRAMES {
            harness.run();
            unchanged.push(milliseconds(|| harness.step()));
            let before = picture(&harness);
            harness.get_by_role_and_label(Role::Slider, name).set_value_accesskit(values[frame % 2]);
            // The value is taken in one frame, which also draws its picture or leaves that to the next.
            let mut time = milliseconds(|| harness.step());
            if picture(&harness) == before {
                time += milliseconds(|| harness.step());
            }
            assert!(picture(&harness) != before, "{name} changes the picture");
            changed.push(time);
            let mut shown = scene(&harness).clone();
            let drawn = harness.state().frame();
            shown.image.size = [drawn.width, drawn.height];
            alone.push(milliseconds(|| _ = renderer.render(&shown)));
        }
        let [changed, unchanged, alone] = [changed, unchanged, alone].map(median);
        println!(
            "{name}: the window's frame {changed:.2} ms, unchanged {unchanged:.2} ms, the engine alone {alone:.2} ms: \
             what the change adds is {:.2} times the engine",
            (changed - unchanged) / alone
        );
    }
}
