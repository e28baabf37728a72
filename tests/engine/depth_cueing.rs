//! Depth cueing against closed forms, the probe's working against the picture, and the stages that re-run when it changes.

use glam::{DVec2, DVec3};
use shading_lab::analysis::probe::probe;
use shading_lab::analysis::profile::{ProfileQuestion, profile};
use shading_lab::render::{Cued, Frame, Renderer, Stage};
use shading_lab::scene::{
    AmbientSource, Choice, CuedBy, DepthCueing, FlatAt, Interpolation, ObjectKind, Projection, Rgb,
    Scene, ShadingMode, View, presets,
};
use shading_lab::text::Message;

/// Returns a square of one polygon that recedes from the eye, of constant I, fading into blue.
fn slanted(by: CuedBy, front: f64, back: f64) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [96, 128];
    scene.image.background = Rgb::new(0.0, 0.3, 0.0);
    scene.object.kind = ObjectKind::Plane;
    (scene.object.segments, scene.object.rings) = (1, 1);
    (scene.camera.eye, scene.camera.target, scene.camera.up) =
        (DVec3::new(0.0, -3.0, 1.0), DVec3::ZERO, DVec3::Z);
    (scene.material.ka, scene.material.color) = (Rgb::ONE, Rgb::new(0.9, 0.8, 0.1));
    scene.lights.clear();
    scene.depth_cueing = DepthCueing {
        by,
        front,
        back,
        color: Rgb::new(0.0, 0.2, 0.8),
        ..DepthCueing::default()
    };
    scene
}

/// Returns the depth of the plane z = 0 at a pixel, if the pixel sees the square.
fn depth_at(scene: &Scene, x: u32, y: u32) -> Option<f64> {
    let view = View::new(&scene.camera, scene.image.size);
    let (origin, direction) = view.ray(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5));
    let point = origin + direction * (-origin.z / direction.z);
    // Well inside: the outline is decided in fixed point.
    (point.truncate().abs().max_element() < 0.98).then(|| (point - view.eye).dot(view.forward))
}

/// Compares every pixel of the square with `expected` of its depth; returns how many there were.
#[track_caller]
fn assert_ramp(scene: &Scene, expected: impl Fn(f64) -> f64) -> u32 {
    let frame = Renderer::default().render(scene).clone();
    let mut seen = 0;
    for (x, y) in places(&frame) {
        let Some(depth) = depth_at(scene, x, y) else {
            continue;
        };
        let s0 = expected(depth);
        let color = scene.material.color * s0 + scene.depth_cueing.color * (1.0 - s0);
        let stored = frame.pixel(x, y).expect("inside");
        for channel in 0..3 {
            let code = 255.0 * color[channel];
            assert!(
                (code - f64::from(stored[channel])).abs() <= 0.6,
                "{x},{y} at {depth}: {code}, stored {stored:?}"
            );
        }
        seen += 1;
    }
    seen
}

fn places(frame: &Frame) -> impl Iterator<Item = (u32, u32)> + use<> {
    let (width, height) = (frame.width, frame.height);
    (0..height).flat_map(move |y| (0..width).map(move |x| (x, y)))
}

/// Returns the depths of the square's near and far edge.
fn edges(scene: &Scene) -> [f64; 2] {
    let view = View::new(&scene.camera, scene.image.size);
    [-1.0, 1.0].map(|y| (DVec3::new(0.0, y, 0.0) - view.eye).dot(view.forward))
}

#[test]
fn by_pixel_it_is_the_formula_at_every_pixel() {
    for &projection in Projection::VALUES {
        for &mode in ShadingMode::VALUES {
            let mut scene = slanted(CuedBy::Pixel, 2.8, 3.5);
            (
                scene.depth_cueing.front_scale,
                scene.depth_cueing.back_scale,
            ) = (0.95, 0.2);
            (scene.shading.mode, scene.camera.projection) = (mode, projection);
            let law = |z: f64| 0.2 + ((3.5 - z) / 0.7).clamp(0.0, 1.0) * 0.75;
            assert!(assert_ramp(&scene, law) > 1000, "{mode:?}");
        }
    }
}

#[test]
fn a_linear_cue_is_the_same_by_vertex_and_by_pixel() {
    for mode in [
        ShadingMode::Interpolated,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Exact,
    ] {
        for by in [CuedBy::Vertex, CuedBy::Pixel] {
            let mut scene = slanted(by, 1.5, 5.0);
            scene.shading.mode = mode;
            assert!(assert_ramp(&scene, |z| (5.0 - z) / 3.5) > 1000);
            // In an orthographic picture every interpolation is linear in the depth.
            scene.camera.projection = Projection::Orthographic;
            for &rule in Interpolation::VALUES {
                scene.shading.interpolation = rule;
                assert!(assert_ramp(&scene, |z| (5.0 - z) / 3.5) > 1000);
            }
        }
    }
}

/// Uses a polygon that reaches beyond both depths: per pixel, s0 has two corners; per vertex, it has none.
#[test]
fn the_corners_of_clamping_are_missed_between_vertices() {
    for mode in [ShadingMode::Gouraud, ShadingMode::Phong] {
        let mut scene = slanted(CuedBy::Vertex, 2.8, 3.5);
        scene.shading.mode = mode;
        let [near, far] = edges(&scene);
        assert!(near < 2.8 && far > 3.5);
        assert!(assert_ramp(&scene, |z| (far - z) / (far - near)) > 1000);
    }
}

#[test]
fn an_affine_ramp_is_linear_in_the_picture() {
    for (mode, rule) in [
        (ShadingMode::Gouraud, Interpolation::Affine),
        (ShadingMode::Phong, Interpolation::Scanline),
        (ShadingMode::Gouraud, Interpolation::Scanline),
    ] {
        let mut scene = slanted(CuedBy::Vertex, 1.5, 5.0);
        (scene.shading.mode, scene.shading.interpolation) = (mode, rule);
        let [near, far] = edges(&scene);
        let s0 = |z: f64| (5.0 - z) / 3.5;
        // On a plane whose far edge is level, rows are linear in 1/z. Affine interpolation is linear on each of two triangles, so
        // only the scan line's ramp has one slope over the square.
        let part = |z: f64| (1.0 / z - 1.0 / far) / (1.0 / near - 1.0 / far);
        let linear = |z: f64| s0(far) + part(z) * (s0(near) - s0(far));
        if rule == Interpolation::Scanline {
            assert!(assert_ramp(&scene, linear) > 1000);
        } else {
            let frame = Renderer::default().render(&scene).clone();
            scene.shading.interpolation = Interpolation::Perspective;
            let correct = Renderer::default().render(&scene).clone();
            let off = places(&frame).map(|(x, y)| {
                let pair = [&frame, &correct]
                    .map(|frame| frame.pixel(x, y).map_or(0, |p| i32::from(p[2])));
                pair[0] - pair[1]
            });
            assert!(
                off.max().is_some_and(|off| off > 10),
                "the far side comes too near"
            );
        }
    }
}

#[test]
fn a_flat_polygon_fades_as_a_whole() {
    for (at, depth) in [
        (FlatAt::Centre, 0.0),
        (FlatAt::ProvokingVertex, 1.0),
        (FlatAt::VertexMean, 0.0),
    ] {
        let mut scene = slanted(CuedBy::Vertex, 1.5, 5.0);
        (scene.shading.mode, scene.shading.flat_at) = (ShadingMode::Flat, at);
        let [near, far] = edges(&scene);
        let depth = 0.5 * (near + far) + 0.5 * depth * (far - near);
        assert!(
            assert_ramp(&scene, |_| (5.0 - depth) / 3.5) > 1000,
            "{at:?}"
        );
    }
}

#[test]
fn the_background_keeps_its_colour() {
    let scene = slanted(CuedBy::Pixel, 0.0, 0.1);
    let frame = Renderer::default().render(&scene).clone();
    assert_eq!(frame.pixel(0, 0), Some([0, 77, 0]));
    assert_eq!(frame.pixel(48, 64), Some([0, 51, 204]));
}

/// Returns scenes that combine depth cueing with everything else that makes up a pixel.
fn crowded() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for kind in [ObjectKind::Torus, ObjectKind::Teapot, ObjectKind::Cube] {
        for &mode in ShadingMode::VALUES {
            for by in [CuedBy::Vertex, CuedBy::Pixel] {
                let mut scene = Scene::default();
                scene.image.size = [64, 64];
                scene.object.kind = kind;
                (scene.object.segments, scene.object.rings) = (10, 7);
                scene.shading.mode = mode;
                scene.camera.eye = DVec3::new(0.6, 1.2, 2.4);
                let color = Rgb::new(0.3, 0.5, 0.2);
                scene.depth_cueing = DepthCueing {
                    by,
                    front: 1.9,
                    back: 3.1,
                    back_scale: 0.1,
                    color,
                    ..DepthCueing::default()
                };
                scenes.push(scene);
            }
        }
    }
    let count = scenes.len();
    for (index, scene) in scenes.iter_mut().enumerate() {
        scene.shading.interpolation = Interpolation::VALUES[index % 3];
        scene.shading.flat_at =
            [FlatAt::Centre, FlatAt::VertexMean, FlatAt::ProvokingVertex][index * 3 / count];
        match index % 4 {
            1 => (scene.transparency.kt, scene.ground.visible) = (0.4, true),
            2 => (scene.ambient.source, scene.shading.shadows) = (AmbientSource::Bounce, true),
            // So near that polygons are clipped.
            3 => scene.camera.eye = DVec3::new(0.2, 0.3, 1.0),
            _ => {}
        }
    }
    scenes
}

#[test]
fn the_probe_adds_up_to_the_stored_pixel() {
    let mut renderer = Renderer::default();
    for scene in crowded() {
        let what = format!(
            "{:?} {:?} {:?}",
            scene.object.kind, scene.shading, scene.depth_cueing.by
        );
        // A clipped polygon is interpolated piecewise, and a bent one has no single depth along its scan lines.
        let approximate = scene.shading.interpolation == Interpolation::Scanline;
        let (mut seen, mut off) = (0, 0);
        for (x, y) in (0..64)
            .step_by(3)
            .flat_map(|y| (0..64).step_by(3).map(move |x| (x, y)))
        {
            let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
                continue;
            };
            let cue = hit.cue.expect("the depth is cued");
            assert!((cue.kept + cue.veil - hit.sum).abs().max_element() < 1e-12);
            assert!(
                (-1e-9..=1.0 + 1e-9).contains(&cue.scale) || scene.camera.eye.z < 1.5,
                "{what}: {}",
                cue.scale
            );
            if scene.depth_cueing.by == CuedBy::Pixel {
                let own = scene.depth_cueing.scale_at(hit.depth);
                assert!(
                    (own - cue.scale).abs() < 1e-12
                        && (hit.intensity * own - cue.kept).abs().max_element() < 1e-9
                );
            }
            let code = hit.sum.clamp(Rgb::ZERO, Rgb::ONE) * 255.0;
            let stored = DVec3::from_array(hit.stored.map(f64::from));
            off += u32::from((code - stored).abs().max_element() > 1.0);
            seen += 1;
        }
        assert!(seen > 30, "{what}: {seen} pixels");
        assert!(
            off == 0 || (approximate && off * 20 < seen),
            "{what}: {off} of {seen} pixels differ"
        );
    }
}

#[test]
fn what_cannot_change_anything_is_left_out() {
    let cued = |change: fn(&mut Scene)| {
        let mut scene = slanted(CuedBy::Pixel, 2.8, 3.5);
        change(&mut scene);
        let mut renderer = Renderer::default();
        renderer.render(&scene);
        let plan = renderer.plan().expect("a picture was drawn").clone();
        let terms = renderer.terms();
        let term = terms
            .into_iter()
            .find(|term| term.name.part() == english!("render-term-depth-cueing"))
            .expect("a step of its own");
        assert_eq!(plan.cued == Cued::Nowhere, term.omitted.is_some());
        assert!(!plan.whole_picture || plan.cued != Cued::Nowhere);
        term.omitted
    };
    assert_eq!(cued(|_| ()), None);
    assert_eq!(
        cued(|scene| scene.depth_cueing.by = CuedBy::Off),
        Some(Message("render-why-switched-off"))
    );
    assert!(
        cued(|scene| scene.depth_cueing.back_scale = 1.0)
            == Some(Message("render-why-cue-without-effect"))
    );
    assert!(
        cued(|scene| (scene.depth_cueing.front, scene.depth_cueing.back) = (5.0, 6.0)).is_some()
    );
    assert_eq!(
        cued(|scene| scene.depth_cueing = DepthCueing {
            front_scale: 0.5,
            front: 5.0,
            back: 6.0,
            ..scene.depth_cueing
        }),
        None
    );
}

/// Checks that the steps skipped in front of the front depth would not have changed a pixel.
#[test]
fn before_the_front_the_picture_is_as_without() {
    for preset in presets::ALL
        .iter()
        .filter(|preset| preset.topic == "shapes")
    {
        let mut scene = preset.scene();
        scene.image.size = [40, 40];
        let plain = Renderer::default().render(&scene).clone();
        scene.depth_cueing = DepthCueing {
            by: CuedBy::Pixel,
            front: 50.0,
            back: 51.0,
            ..DepthCueing::default()
        };
        assert!(
            Renderer::default().render(&scene).pixels == plain.pixels,
            "{}",
            preset.name
        );
    }
}

#[test]
fn a_change_of_the_cue_covers_nothing_anew_and_what_is_kept_is_what_would_be_drawn() {
    let changes: [fn(&mut Scene); 10] = [
        |s| s.depth_cueing.front = 2.3,
        |s| s.depth_cueing.back = 2.9,
        |s| s.depth_cueing.front_scale = 0.9,
        |s| s.depth_cueing.color.x = 0.9,
        |s| {
            s.depth_cueing.by = if s.depth_cueing.by == CuedBy::Pixel {
                CuedBy::Vertex
            } else {
                CuedBy::Pixel
            }
        },
        |s| s.material.kd *= 0.5,
        |s| s.camera.eye.x += 0.3,
        |s| s.object.segments += 3,
        |s| s.depth_cueing.by = CuedBy::Off,
        |s| s.depth_cueing.by = CuedBy::Vertex,
    ];
    for mut scene in crowded() {
        scene.image.size = [40, 36];
        let mut renderer = Renderer::default();
        renderer.render(&scene);
        renderer.render(&scene);
        let ran = |renderer: &Renderer| -> Vec<Stage> {
            renderer
                .report()
                .stages
                .iter()
                .filter(|run| run.ran)
                .map(|run| run.stage)
                .collect()
        };
        assert_eq!(ran(&renderer), [], "{:?}", scene.shading);
        for (index, change) in changes.iter().enumerate() {
            change(&mut scene);
            let kept = renderer.render(&scene).clone();
            if index < 4 {
                let ran = ran(&renderer);
                assert!(
                    !ran.contains(&Stage::Coverage) && !ran.contains(&Stage::Rays),
                    "{index}: {ran:?}"
                );
            }
            let fresh = Renderer::default().render(&scene).clone();
            assert!(
                kept.pixels == fresh.pixels,
                "change {index}, {:?} {:?}",
                scene.shading,
                scene.depth_cueing
            );
        }
    }
}

#[test]
fn the_profile_has_the_corner_where_the_picture_has_it() {
    for (by, corners) in [(CuedBy::Pixel, true), (CuedBy::Vertex, false)] {
        let scene = slanted(by, 2.8, 3.5);
        let mut renderer = Renderer::default();
        let ends = [DVec2::new(48.5, 53.0), DVec2::new(48.5, 76.0)];
        let request = ProfileQuestion {
            modes: vec![ShadingMode::Phong],
            ..ProfileQuestion::new(ends[0], ends[1])
        };
        let profile = profile(&mut renderer, &scene, &request).expect("a profile");
        let slope = &profile.traces[0].slope;
        let steepest = slope
            .windows(2)
            .map(|pair| (pair[1] - pair[0]).abs())
            .fold(0.0, f64::max);
        let usual = slope.iter().map(|slope| slope.abs()).fold(0.0, f64::max);
        assert_eq!(
            steepest > 0.3 * usual,
            corners,
            "{by:?}: {steepest} beside {usual}"
        );
        for (sample, value) in profile.samples.iter().zip(&profile.traces[0].intensity) {
            if (sample.y.fract() - 0.5).abs() < 1e-9 {
                let sum = probe(&mut renderer, &scene, 48, sample.y as u32)
                    .hit
                    .expect("the square")
                    .sum;
                assert!((sum.dot(Rgb::new(0.2126, 0.7152, 0.0722)) - value).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn samples_fade_as_pixels_do() {
    let scene = slanted(CuedBy::Pixel, 1.5, 5.0);
    let mut renderer = Renderer::default();
    let one = renderer.render(&scene).clone();
    let many = renderer.render_supersampled(&scene, 8, &mut |_| true);
    for (x, y) in places(&one).filter(|&(x, y)| depth_at(&scene, x, y).is_some()) {
        let pair = [&one, &many].map(|frame| frame.pixel(x, y).expect("inside"));
        assert!(
            (0..3).all(|c| pair[0][c].abs_diff(pair[1][c]) <= 1),
            "{x},{y}: {pair:?}"
        );
    }
}

#[test]
fn s0_is_linear_between_its_two_depths_and_constant_beside_them() {
    let cueing = DepthCueing {
        front_scale: 0.9,
        back_scale: 0.1,
        ..DepthCueing::default()
    };
    for (depth, scale) in [
        (-1e30, 0.9),
        (3.0, 0.9),
        (3.5, 0.7),
        (4.0, 0.5),
        (5.0, 0.1),
        (1e30, 0.1),
    ] {
        assert!((cueing.scale_at(depth) - scale).abs() < 1e-15, "{depth}");
    }
    let step = DepthCueing {
        back: 3.0 + f64::EPSILON * 2.0,
        ..DepthCueing::default()
    };
    assert_eq!([step.scale_at(3.0), step.scale_at(step.back)], [1.0, 0.0]);
}
