//! An area light's sample points against a large number of them: the error falls as their number grows.

use glam::DVec3;
use shading_lab::analysis::sampling::{self, SamplingError};
use shading_lab::render::Renderer;
use shading_lab::scene::{AreaShape, Choice, Light, LightKind, Scene, presets};

fn sampling_error(scene: &Scene, light: usize) -> Option<SamplingError> {
    sampling::sampling_error(&mut Renderer::default(), scene, light)
}

const COUNTS: [u32; 5] = [1, 4, 16, 64, 256];

fn scene(shape: AreaShape, samples: u32) -> Scene {
    let mut scene = presets::find("sphere").expect("a built-in scene").scene();
    let light = Light {
        kind: LightKind::Area,
        shape,
        samples,
        extent: [1.5, 1.0],
        radius: 0.6,
        ..Light::default()
    };
    scene.lights = vec![Light {
        position: DVec3::new(2.0, 2.5, 3.0),
        direction: DVec3::new(-2.0, -2.5, -3.0),
        ..light
    }];
    scene
}

fn errors(shape: AreaShape) -> Vec<SamplingError> {
    let error = |&samples: &u32| {
        sampling_error(&scene(shape, samples), 0).expect("an area light on a sphere")
    };
    COUNTS.iter().map(error).collect()
}

/// Returns the slope of log `values` over log N, by least squares.
fn slope(values: &[f64]) -> f64 {
    let x: Vec<f64> = COUNTS.iter().map(|&count| f64::from(count).ln()).collect();
    let y: Vec<f64> = values.iter().map(|value| value.ln()).collect();
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (mx, my) = (mean(&x), mean(&y));
    let covariance: f64 = x.iter().zip(&y).map(|(x, y)| (x - mx) * (y - my)).sum();
    covariance / x.iter().map(|x| (x - mx).powi(2)).sum::<f64>()
}

#[test]
fn the_error_falls_as_the_points_grow_in_number() {
    for &shape in AreaShape::VALUES {
        let errors = errors(shape);
        for (count, error) in COUNTS.iter().zip(&errors) {
            println!(
                "{shape:?}, N = {count}: rms {:.3e}, greatest {:.3e}",
                error.rms, error.greatest
            );
            assert!(error.rms <= error.greatest);
        }
        for pair in errors.windows(2) {
            assert!(pair[1].rms < pair[0].rms, "{shape:?}: {pair:?}");
        }
        let slope = slope(&errors.iter().map(|error| error.rms).collect::<Vec<_>>());
        println!("{shape:?}: the error falls as N^{slope:.2}");
        assert!(
            slope < -0.7,
            "{shape:?}: the error falls as N^{slope:.2} only"
        );
    }
}

#[test]
fn only_an_area_light_that_is_seen_has_an_error() {
    let sound = scene(AreaShape::Rectangle, 4);
    assert!(sampling_error(&sound, 0).is_some());
    assert_eq!(sampling_error(&sound, 1), None, "there is no second light");
    let change = |change: &dyn Fn(&mut Scene)| {
        let mut scene = sound.clone();
        change(&mut scene);
        sampling_error(&scene, 0)
    };
    assert_eq!(
        change(&|scene| scene.lights[0].kind = LightKind::Spot),
        None
    );
    assert_eq!(change(&|scene| scene.lights[0].mute = true), None);
    assert_eq!(
        change(&|scene| scene.camera.target.z = 10.0),
        None,
        "the object is behind the viewer"
    );
}

#[test]
fn a_light_of_no_size_needs_one_point() {
    let mut scene = scene(AreaShape::Sphere, 1);
    scene.lights[0].radius = 0.0;
    let error = sampling_error(&scene, 0).expect("an area light on a sphere");
    assert!(error.greatest < 1e-12, "{error:?}");
}
