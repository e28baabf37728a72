//! Pictures that are shaded for a while at a time, so that whoever asked for them can answer meanwhile, and give them up.

use shading_lab::render::{Frame, Renderer, Stage};
use shading_lab::scene::{
    CuedBy, Overflow, Reflection, ReflectionModel, Scene, ShadingMode, presets,
};
use std::sync::atomic::{AtomicU64, Ordering};

/// Nanoseconds by a clock that goes on by one whenever it is read.
fn clock() -> u64 {
    static NOW: AtomicU64 = AtomicU64::new(0);
    NOW.fetch_add(1, Ordering::Relaxed)
}

/// Draws until the picture is finished, for `time` at a time; returns it, how many calls it took, and the overflowing pixels.
fn slices(renderer: &mut Renderer, scene: &Scene, time: u64) -> (Frame, u32, u64) {
    for calls in 1..1000 {
        if renderer.render_for(scene, time) {
            let frame = renderer.render(scene).clone();
            assert!(
                renderer.report().stages.iter().all(|run| !run.ran),
                "finished, and drawn again"
            );
            return (frame, calls, renderer.report().overflowing);
        }
    }
    panic!("no end");
}

fn scenes() -> Vec<Scene> {
    let mut scenes: Vec<Scene> = [
        "sphere",
        "teapot",
        "shadows",
        "glass-ball",
        "overflow",
        "depth-cueing",
        "one-bounce",
    ]
    .map(|name| presets::find(name).expect("a scene").scene())
    .into();
    let own = &mut scenes[1].reflection;
    own.model = ReflectionModel::Formula;
    own.formula = format!("{} + 1/max(N·L - 0.9, 0)", Reflection::PHONG);
    let mut marked = scenes[4].clone();
    marked.display.overflow = Overflow::Mark;
    let mut scaled = scenes[4].clone();
    scaled.display.overflow = Overflow::Scale;
    let mut gouraud = scenes[5].clone();
    gouraud.shading.mode = ShadingMode::Gouraud;
    gouraud.depth_cueing.by = CuedBy::Pixel;
    // Many vertices and faces, and pixels enough for one slice: what is shaded in parts are the points.
    let [faded, flat, stiff] = [
        (ShadingMode::Gouraud, CuedBy::Vertex, 5.0),
        (ShadingMode::Flat, CuedBy::Off, 5.0),
        (ShadingMode::Gouraud, CuedBy::Off, 1e8),
    ]
    .map(|(mode, by, n)| {
        let mut fine = gouraud.clone();
        (fine.object.segments, fine.object.rings) = (300, 150);
        (fine.shading.mode, fine.depth_cueing.by, fine.material.n) = (mode, by, n);
        fine
    });
    scenes.extend([marked, scaled, gouraud, faded, flat, stiff]);
    for scene in &mut scenes {
        scene.image.size = [90, 200];
    }
    scenes
}

#[test]
fn a_picture_in_slices_is_the_one_drawn_at_once() {
    let mut kept = Renderer::with_clock(clock);
    for (index, scene) in scenes().iter().enumerate() {
        let mut whole = Renderer::default();
        let expected = whole.render(scene).clone();
        let (frame, calls, overflowing) = slices(&mut kept, scene, 6);
        assert!(calls > 1, "scene {index} in {calls} calls");
        assert!(frame.pixels == expected.pixels, "scene {index}");
        assert_eq!(overflowing, whole.report().overflowing, "scene {index}");
        // Given up in the middle for another scene, and another size.
        let mut other = scene.clone();
        other.material.kd *= 0.5;
        other.image.size = [90 + 20 * (index as u32 % 2), 200];
        kept.render_for(&other, 6);
        let (frame, ..) = slices(&mut kept, scene, 6);
        assert!(frame.pixels == expected.pixels, "scene {index} once more");
    }
}

#[test]
fn a_slice_shades_some_rows_and_leaves_the_others_as_they_were() {
    let mut scene = presets::find("sphere").expect("a scene").scene();
    scene.image.size = [90, 200];
    let mut renderer = Renderer::with_clock(clock);
    let before = renderer.render(&scene).clone();
    scene.image.background *= 0.5;
    scene.material.kd *= 0.5;
    assert!(!renderer.render_for(&scene, 1));
    let part = renderer.report().clone();
    let shaded = |frame: &Frame| {
        let rows = frame.pixels.chunks(90).zip(before.pixels.chunks(90));
        rows.filter(|(row, before)| row != before).count()
    };
    let first = shaded(renderer.frame());
    assert!(first > 0 && first < 200, "{first} of 200 rows");
    // A call without a limit finishes the picture.
    assert_eq!(shaded(renderer.render(&scene)), 200);
    let covered = part
        .stages
        .iter()
        .any(|run| run.stage == Stage::Coverage && run.ran);
    assert!(!covered, "only shading depends on what was changed");
    scene.material.kd *= 0.5;
    let calls = (1..).find(|_| renderer.render_for(&scene, 1));
    assert!(calls.is_some_and(|calls| calls > 2));
    assert!(renderer.render_for(&scene, 1), "it is finished");
    // Without a clock there is no limit.
    assert!(Renderer::default().render_for(&scene, 0));
}

#[test]
fn many_vertices_are_shaded_in_parts_before_any_pixel() {
    let mut scene = presets::find("sphere").expect("a scene").scene();
    scene.image.size = [90, 20];
    scene.shading.mode = ShadingMode::Gouraud;
    (scene.object.segments, scene.object.rings) = (300, 150);
    let expected = Renderer::default().render(&scene).clone();
    let mut renderer = Renderer::with_clock(clock);
    let mut calls = 0;
    loop {
        let finished = renderer.render_for(&scene, 1);
        let ran = |stage: Stage| {
            let mut stages = renderer.report().stages.iter();
            stages.any(|run| run.stage == stage && run.ran)
        };
        calls += 1;
        assert_eq!(ran(Stage::Coverage), calls == 1);
        assert_eq!(renderer.is_finished(), finished);
        if !ran(Stage::VertexShading) || finished {
            break;
        }
        let Frame {
            width,
            height,
            pixels,
        } = renderer.frame();
        assert_eq!(
            ([*width, *height], pixels.len()),
            (scene.image.size, 90 * 20)
        );
        if !ran(Stage::Interpolation) {
            assert!(pixels.iter().all(|pixel| *pixel == [0; 4]), "call {calls}");
        }
    }
    assert!(calls > 3, "{calls} calls");
    assert_eq!(slices(&mut renderer, &scene, 1).0.pixels, expected.pixels);
    // Given up between vertices for another light, and taken up again.
    let mut other = scene.clone();
    other.lights[0].color *= 0.5;
    assert!(!renderer.render_for(&other, 1));
    assert_eq!(slices(&mut renderer, &scene, 1).0.pixels, expected.pixels);
    let expected = Renderer::default().render(&other).clone();
    assert!(!renderer.render_for(&other, 1));
    assert_eq!(slices(&mut renderer, &other, 1).0.pixels, expected.pixels);
}
