//! Time that the window's frame adds to the engine's after a slider has moved, without the painting by the graphics card: `cargo
//! test --release --test window slider_time -- --ignored --nocapture`.

use crate::common::hands::{named, picture, scene, unfold_all, window_looking};
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use shading_lab::app::Appearance;
use shading_lab::document::load_scene;
use shading_lab::render::Renderer;
use std::path::Path;
use std::time::Instant;

/// Measured drags of [`FRAMES`] frames each. The first frame does not count: it still shows the numbers of an unchanged picture.
const DRAGS: usize = 40;
const FRAMES: usize = 6;

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
    let fine = ["object.segments=512", "object.rings=257"];
    for (name, settings) in [
        ("teapot", &[][..]),
        ("sphere", &[]),
        ("torus", &[]),
        ("sphere", &fine),
    ] {
        measure(name, settings);
    }
}

fn measure(built_in: &str, settings: &[&str]) {
    let settings: Vec<_> = settings.iter().map(|&setting| setting.to_owned()).collect();
    let mut loaded = load_scene(Path::new(built_in)).expect("a built-in scene");
    loaded.scene = loaded.scene.with_overrides(&settings).expect("settings");
    // No smoother picture is drawn while a slider is held.
    let appearance = Appearance {
        smooth_edges: false,
        ..Appearance::default()
    };
    let mut harness = window_looking(loaded, [1280.0, 800.0], &appearance, |app| app);
    unfold_all(&mut harness);
    let mut renderer = Renderer::default();
    for (name, step) in [("material.ka", 0.001), ("material.n", 0.1)] {
        let (mut changed, mut unchanged, mut engine, mut alone) = (vec![], vec![], vec![], vec![]);
        let mut value = if name == "material.n" {
            scene(&harness).material.n
        } else {
            0.2
        };
        for _ in 0..DRAGS {
            harness.run();
            unchanged.extend((0..FRAMES).map(|_| milliseconds(|| harness.step())));
            let before = picture(&harness);
            for frame in 0..FRAMES {
                value += step;
                harness
                    .get_by_role_and_label(Role::Slider, named(name))
                    .set_value_accesskit(value);
                let time = milliseconds(|| harness.step());
                if frame > 0 {
                    changed.push(time);
                    engine.push(harness.state().report().nanoseconds as f64 / 1e6);
                }
            }
            assert!(picture(&harness) != before, "{name} changes the picture");
            let mut shown = scene(&harness).clone();
            let drawn = harness.state().frame();
            shown.image.size = [drawn.width, drawn.height];
            for _ in 0..FRAMES {
                shown.material.ka += 0.001;
                shown.material.n += 0.1;
                alone.push(milliseconds(|| _ = renderer.render(&shown)));
            }
        }
        let [changed, unchanged, engine, alone] = [changed, unchanged, engine, alone].map(median);
        println!(
            "{built_in} {settings:?}, {name}: the window's frame {changed:.2} ms, unchanged {unchanged:.2} ms, the engine \
             {engine:.2} ms in it and {alone:.2} ms alone: what the change adds is {:.2} times the engine's time",
            (changed - unchanged) / engine
        );
    }
}
