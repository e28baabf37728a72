//! The parts of the illumination: elementary functions in lanes, refraction, the width of highlights, patterns.

use fearless_simd::{Level, Simd, dispatch};
use glam::DVec3;
use shading_lab::illumination::{
    Equation, Fields, Lanes, Real, V3, area_samples, blinn_from_phong, critical_angle, half_width,
    mirror, phong_from_blinn, rectangle_axes, refract,
};
use shading_lab::scene::{
    AreaShape, Camera, Choice, Distribution, Light, LightKind, PatternKind, ReflectionModel, Scene,
    Viewer,
};
use std::f64::consts::FRAC_PI_2;

/// Applies `function` to a number at the machine's best SIMD level and at its baseline.
fn at_both(function: Function, x: f32) -> [f32; 2] {
    [Level::new(), Level::baseline()]
        .map(|level| dispatch!(level, simd => apply(simd, function, x)))
}

#[derive(Clone, Copy)]
enum Function {
    InverseSqrt,
    Exp2,
    Log2,
    Log2OneMinus,
}

#[inline(always)]
fn apply<S: Simd>(simd: S, function: Function, x: f32) -> f32 {
    let x = Lanes::splat(simd, x);
    let y = match function {
        Function::InverseSqrt => x.inverse_sqrt(),
        Function::Exp2 => x.exp2(),
        Function::Log2 => x.log2(),
        Function::Log2OneMinus => Lanes::log2_one_minus(x),
    };
    y.0[0]
}

fn relative(got: f32, expected: f64) -> f64 {
    (f64::from(got) - expected).abs() / expected.abs()
}

#[test]
fn inverse_square_roots_are_good_to_three_units() {
    for exponent in -60..60 {
        for step in 0..50 {
            let x = 2_f32.powi(exponent) * (1.0 + step as f32 / 50.0);
            for got in at_both(Function::InverseSqrt, x) {
                assert!(
                    relative(got, 1.0 / f64::from(x).sqrt()) < 3.6e-7,
                    "{x}: {got}"
                );
            }
        }
    }
    assert!(
        at_both(Function::InverseSqrt, 0.0)
            .iter()
            .all(|y| y.is_finite())
    );
}

#[test]
fn powers_and_logarithms_are_good_to_their_documented_errors() {
    for step in -1200..1200 {
        let x = step as f32 / 10.0;
        for got in at_both(Function::Exp2, x) {
            assert!(relative(got, f64::from(x).exp2()) < 3e-7, "2^{x}: {got}");
        }
    }
    for step in 1..20_000 {
        let x = step as f32 / 5000.0;
        for got in at_both(Function::Log2, x) {
            let truth = f64::from(x).log2();
            assert!(
                (f64::from(got) - truth).abs() < 2e-7 * truth.abs().max(1.0),
                "log2 {x}: {got}"
            );
        }
    }
    for step in 1..2900 {
        let t = step as f32 / 10_000.0;
        for scale in [1.0, 1e-3, 1e-6] {
            for got in at_both(Function::Log2OneMinus, t * scale) {
                let truth = (-f64::from(t * scale)).ln_1p() / std::f64::consts::LN_2;
                assert!(relative(got, truth) < 3e-7, "{t}: {got}");
            }
        }
    }
}

#[test]
fn nothing_is_lost_below_the_range_of_exponents() {
    for got in at_both(Function::Exp2, -1e30) {
        assert!((0.0..1e-37).contains(&got));
    }
}

fn towards(angle: f64) -> DVec3 {
    DVec3::new(angle.sin(), 0.0, -angle.cos())
}

#[test]
fn the_sines_are_as_the_indices() {
    for eta in [0.7, 1.0, 1.33, 1.5, 2.4] {
        for degrees in 0..90_i32 {
            let angle = f64::from(degrees).to_radians();
            let through = refract(towards(angle), DVec3::Z, eta);
            let sine = angle.sin() / eta;
            match through {
                Some(t) => {
                    assert!((t.length() - 1.0).abs() < 1e-14);
                    assert!(
                        (t.x - sine).abs() < 1e-14 && t.y == 0.0 && t.z <= 0.0,
                        "η {eta}, {degrees}°: {t}"
                    );
                }
                None => assert!(sine > 1.0, "η {eta}, {degrees}°"),
            }
        }
    }
}

#[test]
fn equal_indices_change_nothing_and_the_normal_is_never_bent() {
    for degrees in 0..90_i32 {
        let i = towards(f64::from(degrees).to_radians());
        assert!((refract(i, DVec3::Z, 1.0).expect("no total reflection") - i).length() < 1e-14);
    }
    assert_eq!(refract(-DVec3::Z, DVec3::Z, 0.5), Some(-DVec3::Z));
}

#[test]
fn at_the_critical_angle_the_ray_grazes() {
    let eta = 1.0 / 1.5;
    let critical = critical_angle(eta).expect("η < 1");
    assert!((critical.to_degrees() - 41.810_314_895_778_6).abs() < 1e-12);
    let grazing = refract(towards(critical - 1e-9), DVec3::Z, eta).expect("just before");
    assert!(grazing.z.abs() < 1e-4 && grazing.x > 1.0 - 1e-8);
    assert_eq!(refract(towards(critical + 1e-9), DVec3::Z, eta), None);
    assert_eq!(critical_angle(1.0), None);
}

#[test]
fn there_and_back_again() {
    for degrees in 0..90_i32 {
        let i = towards(f64::from(degrees).to_radians());
        let inside = refract(i, DVec3::Z, 1.5).expect("into glass");
        let outside = refract(inside, DVec3::Z, 1.0 / 1.5).expect("out of it");
        assert!((outside - i).length() < 1e-7, "{degrees}");
    }
}

#[test]
fn a_mirrored_ray_keeps_its_angle() {
    for degrees in 0..=90_i32 {
        let i = towards(f64::from(degrees).to_radians());
        let m = mirror(i, DVec3::Z);
        assert!((m - DVec3::new(i.x, i.y, -i.z)).length() < 1e-15);
    }
}

#[test]
fn at_the_half_width_the_lobe_is_half_as_high() {
    for n in [0.1, 0.5, 1.0, 5.0, 15.0, 45.0, 1005.0, 1e6, 1e12] {
        let cosine = -2.0 * (0.5 * half_width(n)).sin().powi(2);
        assert!(((n * cosine.ln_1p()).exp() - 0.5).abs() < 1e-9, "n = {n}");
    }
    // The course's exponents, computed independently: arccos 2^(−1/n).
    for (n, degrees) in [
        (5.0, 29.477_318),
        (15.0, 17.284_424),
        (45.0, 10.030_639),
        (1005.0, 2.127_734),
    ] {
        assert!(
            (half_width(n).to_degrees() - degrees).abs() < 1e-6,
            "n = {n}: {}",
            half_width(n).to_degrees()
        );
    }
    assert_eq!(half_width(f64::INFINITY), 0.0);
    assert!((half_width(0.0) - FRAC_PI_2).abs() < 1e-15);
}

#[test]
fn the_two_models_match_each_way() {
    for n in [0.7, 1.0, 10.0, 1005.0, 1e8] {
        let there = blinn_from_phong(n);
        assert!((phong_from_blinn(there) / n - 1.0).abs() < 1e-9, "n = {n}");
        assert!((0.5 * half_width(n) - half_width(there)).abs() < 1e-12 * (1.0 + half_width(n)));
    }
    assert!((blinn_from_phong(1e4) / 4e4 - 1.0).abs() < 1e-3);
    assert_eq!(blinn_from_phong(f64::INFINITY), f64::INFINITY);
    assert_eq!(phong_from_blinn(0.5), 0.0);
}

fn on_pattern(kind: PatternKind, point: [f64; 3]) -> bool {
    let fields = Fields::<f64>::new(kind, 0.5, 1, DVec3::ZERO, 1.0).expect("a pattern");
    fields.lie_on(V3::from(DVec3::from_array(point)))
}

#[test]
fn fields_are_centred_at_the_origin_and_alternate() {
    for kind in [
        PatternKind::Checker,
        PatternKind::Stripes,
        PatternKind::Rings,
    ] {
        assert!(!on_pattern(kind, [0.2, 0.2, 0.1]), "{kind:?}");
    }
    assert!(
        on_pattern(PatternKind::Checker, [0.3, 0.0, 0.0])
            && on_pattern(PatternKind::Checker, [0.0, -0.3, 0.0])
    );
    assert!(!on_pattern(PatternKind::Checker, [0.3, -0.3, 0.0]));
    assert!(
        on_pattern(PatternKind::Stripes, [9.0, 0.3, 9.0])
            && !on_pattern(PatternKind::Stripes, [0.0, 0.8, 0.0])
    );
    assert!(
        on_pattern(PatternKind::Rings, [0.3, 5.0, 0.0])
            && !on_pattern(PatternKind::Rings, [0.8, 0.0, 0.0])
    );
}

#[test]
fn no_pattern_has_no_fields() {
    assert_eq!(
        Fields::<f64>::new(PatternKind::None, 1.0, 1, DVec3::ZERO, 1.0),
        None
    );
}

#[test]
fn any_number_of_samples_covers_a_rectangle_evenly() {
    for count in [1, 2, 3, 5, 7, 16, 17, 100, 1023, 1024, 4096] {
        let light = Light {
            position: DVec3::ZERO,
            samples: count,
            ..Light::default()
        };
        let samples = area_samples(&light);
        assert_eq!(samples.len(), count as usize);
        let mean = samples.iter().sum::<DVec3>() / f64::from(count);
        assert!(mean.length() < 1e-12, "{count}: {mean}");
    }
}

/// Checks that the only sample is the middle, so that an area light of one sample equals a point light, whatever its shape.
#[test]
fn one_sample_is_the_middle() {
    for &shape in AreaShape::VALUES {
        let light = Light {
            position: DVec3::new(1.0, 2.0, 3.0),
            radius: 0.7,
            shape,
            samples: 1,
            ..Light::default()
        };
        assert_eq!(area_samples(&light), [light.position], "{shape:?}");
        let two = area_samples(&Light {
            samples: 2,
            ..light.clone()
        });
        assert!(
            ((two[0] + two[1]) / 2.0 - light.position).length() < 1e-12,
            "{shape:?}: {two:?}"
        );
    }
}

#[test]
fn samples_lie_on_the_light() {
    let light = Light {
        position: DVec3::new(1.0, 2.0, 3.0),
        radius: 0.7,
        ..Light::default()
    };
    let sphere = Light {
        shape: AreaShape::Sphere,
        samples: 50,
        ..light.clone()
    };
    assert!(
        area_samples(&sphere)
            .iter()
            .all(|p| ((*p - sphere.position).length() - 0.7).abs() < 1e-12)
    );
    let facing = light.direction.normalize();
    let [across, up] = rectangle_axes(&light);
    assert!(
        across.dot(facing).abs() < 1e-12
            && up.dot(facing).abs() < 1e-12
            && across.dot(up).abs() < 1e-12
    );
    assert!(across.y.abs() < 1e-12);
    assert!(
        area_samples(&light)
            .iter()
            .all(|p| (*p - light.position).dot(facing).abs() < 1e-12)
    );
}

/// Returns S of a surface with normal `n`, seen along −z, under light from half-way between +x and +z.
fn specular(distribution: Distribution, n: DVec3) -> f64 {
    let mut scene = Scene {
        camera: Camera {
            viewer: Viewer::Infinite,
            ..Camera::default()
        },
        lights: vec![Light {
            kind: LightKind::Directional,
            direction: DVec3::new(-1.0, 0.0, -1.0),
            ..Light::default()
        }],
        ..Scene::default()
    };
    scene.material.roughness = 1.0;
    (scene.reflection.model, scene.reflection.distribution) =
        (ReflectionModel::CookTorrance, distribution);
    Equation::<f64>::new(&scene)
        .respond_world(0, DVec3::ZERO, n, None)
        .specular_factor
}

#[test]
fn the_lobe_is_continued_past_the_outline_and_fades() {
    for &distribution in Distribution::VALUES {
        let at = |n_dot_v: f64| {
            let n = DVec3::new((1.0 - n_dot_v * n_dot_v).sqrt(), 0.0, n_dot_v);
            specular(distribution, n)
        };
        assert!(
            at(-0.01) > 0.5 * at(0.0) && at(-0.1) > 0.0,
            "{distribution:?}: nothing breaks off"
        );
        assert_eq!((at(-0.25), at(-0.5)), (0.0, 0.0));
    }
}
