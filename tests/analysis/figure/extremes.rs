//! Overlays of extreme pictures, numbers and light counts.

use super::{everything, probe_at, three_lights};
use glam::DVec3;
use shading_lab::analysis::probe::{Overlay, draw_overlay};
use shading_lab::scene::{Light, LightKind, Scene};
use tiny_skia::Pixmap;

#[test]
fn slender_and_tiny_and_vast_pictures_are_drawn() {
    let scene = Scene {
        lights: three_lights(),
        ..Scene::default()
    };
    for size in [
        [1, 1],
        [2, 3],
        [1, 400],
        [400, 1],
        [16_384, 40],
        [40, 16_384],
        [40, 40],
    ] {
        let probe = probe_at(&scene, size, [size[0] / 2, size[1] / 2]);
        let mut pixmap = Pixmap::new(size[0], size[1]).expect("not empty");
        draw_overlay(&mut pixmap.as_mut(), &scene, &probe, &everything());
        assert!(
            pixmap.pixels().iter().any(|pixel| pixel.alpha() > 0),
            "{size:?}"
        );
    }
    let size = [16_384, 16_384];
    let overlay = Overlay::new(
        size,
        &scene,
        &probe_at(&scene, size, [7000, 7000]),
        &everything(),
    );
    assert!(overlay.labels.len() > 10);
}

#[test]
fn numbers_beyond_reason_neither_panic_nor_reach_the_layout() {
    let sound = probe_at(&Scene::default(), [100, 100], [50, 50]);
    let values = [
        0.0,
        -1.0,
        1e-300,
        1e-15,
        1e15,
        1e300,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    for value in values {
        let vector = DVec3::new(value, -value, 0.5 * value);
        for place in 0..8 {
            let (mut scene, mut probe, mut options) =
                (Scene::default(), sound.clone(), everything());
            let hit = probe.hit.as_mut().expect("on the sphere");
            let light = &mut hit.lights[0];
            match place {
                0 => hit.position = vector,
                1 => hit.normal = vector,
                2 => hit.view = vector,
                3 => (light.l, light.r, light.h) = (vector, vector, vector),
                4 => (light.theta, light.phi, light.alpha) = (value, value, value),
                5 => (options.length, options.scale) = (Some(value), value),
                6 => scene.lights[0].position = vector,
                _ => {
                    scene.lights[0].kind = LightKind::Directional;
                    (scene.lights[0].direction, scene.lights[0].color) = (vector, vector);
                }
            }
            let overlay = Overlay::new([100, 100], &scene, &probe, &options);
            let finite = overlay.arrows.iter().all(|arrow| arrow.tip.is_finite())
                && overlay
                    .arcs
                    .iter()
                    .flat_map(|arc| &arc.points)
                    .all(|point| point.is_finite())
                && overlay.lights.iter().all(|light| light.pixel.is_finite());
            assert!(finite, "{value} at {place}: {overlay:?}");
            let mut pixmap = Pixmap::new(100, 100).expect("not empty");
            overlay.draw(&mut pixmap.as_mut());
        }
    }
}

#[test]
fn many_lights_are_laid_out_in_bounded_work() {
    let scene = Scene {
        lights: vec![Light::default(); 500],
        ..Scene::default()
    };
    let probe = probe_at(&scene, [300, 300], [120, 120]);
    let overlay = Overlay::new([300, 300], &scene, &probe, &everything());
    assert_eq!((overlay.lights.len(), overlay.arrows.len()), (500, 3 + 500));
    assert!(
        overlay.labels.len() < 30,
        "the crowd is not lettered: {}",
        overlay.labels.len()
    );
}
