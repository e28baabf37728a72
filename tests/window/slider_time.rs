//! Times of the window's frame while something is dragged, without the painting by the graphics card: `cargo test --release --test
//! window slider_time -- --ignored --nocapture --test-threads 1`.

use crate::common::hands::{
    built_in, named, picture, picture_place, scene, unfold_all, window_looking,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::{App, Appearance};
use shading_lab::document::{Loaded, load_scene};
use shading_lab::render::Renderer;
use shading_lab::scene::presets;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

/// Measured drags of [`FRAMES`] frames each. The first frame does not count: it still shows the numbers of an unchanged picture.
const DRAGS: usize = 40;
const FRAMES: usize = 6;

fn milliseconds(work: impl FnOnce()) -> f64 {
    let began = Instant::now();
    work();
    began.elapsed().as_secs_f64() * 1e3
}

/// Returns the value that a part of all values do not exceed.
fn percentile(mut values: Vec<f64>, part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * part).round() as usize]
}

/// Opens a window of 1280×800 points in which no smoother picture is drawn while the pointer rests.
fn open(loaded: Loaded) -> Harness<'static, App> {
    let appearance = Appearance {
        smooth_edges: false,
        ..Appearance::default()
    };
    let mut harness = window_looking(loaded, [1280.0, 800.0], &appearance, |app| app);
    unfold_all(&mut harness);
    harness
}

/// Changes something in each of 60 frames while the pointer is held at `from`; returns the times of the first frame and of
/// 95 % of all.
fn held(
    harness: &mut Harness<'_, App>,
    from: Pos2,
    mut change: impl FnMut(&Harness<'_, App>, f32),
) -> [f64; 2] {
    // What is asked for at rest is answered first.
    harness.run_ok();
    thread::sleep(Duration::from_millis(200));
    harness.run_ok();
    harness.drag_at(from);
    harness.step();
    let times: Vec<f64> = (1..=60_u8)
        .map(|frame| {
            change(harness, frame.into());
            milliseconds(|| harness.step())
        })
        .collect();
    harness.drop_at(from);
    harness.run_ok();
    [times[0], percentile(times, 0.95)]
}

#[test]
#[ignore = "measures times"]
fn every_scene_answers_while_something_is_dragged() {
    for preset in presets::ALL {
        let mut harness = open(built_in(preset.name));
        let middle = picture_place(&harness).center();
        let camera = held(&mut harness, middle, |harness, frame| {
            harness.hover_at(middle + vec2(3.0, 1.0) * frame);
        });
        let before = scene(&harness).lights.clone();
        let light = (!before.is_empty()).then(|| {
            held(&mut harness, middle, |harness, frame| {
                harness
                    .get_by_role_and_label(Role::SpinButton, named("light.0.color.red"))
                    .set_value_accesskit(0.5 + f64::from(frame) / 200.0);
            })
        });
        assert_eq!(light.is_some(), scene(&harness).lights != before);
        println!("{:24} camera {camera:.1?} light {light:.1?}", preset.name);
    }
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
    let mut harness = open(loaded);
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
        let [changed, unchanged, engine, alone] =
            [changed, unchanged, engine, alone].map(|times| percentile(times, 0.5));
        println!(
            "{built_in} {settings:?}, {name}: the window's frame {changed:.2} ms, unchanged {unchanged:.2} ms, the engine \
             {engine:.2} ms in it and {alone:.2} ms alone: what the change adds is {:.2} times the engine's time",
            (changed - unchanged) / engine
        );
    }
}
