//! The laws of illumination against their closed forms: at ordinary points, at their limits, and in their conserved quantities.

use crate::common::textbook::{
    Dice, amplitude_reflectance, cook_torrance, random_scene, spot_part,
};
use glam::DVec3;
use shading_lab::illumination::{Equation, Index, LightAt, attenuation_at};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Attenuation, Choice, Distribution, Light, LightKind, Material, Reflectance, ReflectionModel,
    Rgb, Scene, ShadingMode, Viewer,
};
use std::f64::consts::PI;

/// Returns a scene with the eye far out on the z axis, for the point at the origin with normal z.
fn bench(model: ReflectionModel, n: f64) -> Scene {
    let mut scene = Scene::default();
    scene.camera.eye = DVec3::new(0.0, 0.0, 1e3);
    scene.reflection.model = model;
    scene.material = Material {
        ka: Rgb::ZERO,
        kd: Rgb::ONE,
        ks: Rgb::ONE,
        n,
        color: Rgb::ONE,
        ..Material::default()
    };
    scene
}

/// Returns a direction `angle` radians from z, in the plane of x and z.
fn tilted(angle: f64) -> DVec3 {
    DVec3::new(angle.sin(), 0.0, angle.cos())
}

/// Returns a directional light whose rays arrive from `l`.
fn from(l: DVec3) -> Light {
    Light {
        kind: LightKind::Directional,
        direction: -l,
        ..Light::default()
    }
}

/// Evaluates the contribution of one light at the origin of a scene, seen along `v`.
fn respond(scene: &Scene, light: Light, v: DVec3) -> LightAt {
    let mut scene = scene.clone();
    scene.camera.eye = v * 1e3;
    scene.camera.up = DVec3::Y;
    scene.camera.viewer = Viewer::Infinite;
    scene.lights = vec![light];
    Equation::<f64>::new(&scene).respond_world(0, DVec3::ZERO, DVec3::Z, None)
}

fn degrees(from: i32, to: i32) -> impl Iterator<Item = f64> {
    (from..=to).map(|d| f64::from(d).to_radians())
}

#[test]
fn lamberts_term_is_the_cosine_and_ends_at_a_right_angle() {
    let scene = bench(ReflectionModel::Phong, 10.0);
    for angle in degrees(-89, 89) {
        let at = respond(&scene, from(tilted(angle)), DVec3::Z);
        assert!((at.diffuse_factor - angle.cos()).abs() < 1e-12);
    }
    for angle in [90.0_f64, 90.001, 120.0, 180.0].map(f64::to_radians) {
        let at = respond(&scene, from(tilted(angle)), DVec3::Z);
        assert!(
            at.diffuse_factor < 1e-15 && at.specular_factor < 1e-15,
            "{angle}"
        );
    }
}

#[test]
fn phongs_lobe_is_the_power_of_the_cosine_about_the_mirror_direction() {
    for n in [0.0, 0.5, 1.0, 5.0, 15.0, 45.0, 63.9, 64.0, 1005.0, 1e6] {
        let scene = bench(ReflectionModel::Phong, n);
        for phi in degrees(-100, 100).filter(|phi| (phi.abs().to_degrees() - 90.0).abs() > 0.5) {
            // Light from 40° on one side; the mirror direction is 40° on the other.
            let v = tilted(phi - 40_f64.to_radians());
            let at = respond(&scene, from(tilted(40_f64.to_radians())), v);
            let expected = phi.cos().max(0.0).powf(n);
            assert!(
                (at.specular_factor - expected).abs() < 1e-9,
                "n {n}, φ {}",
                phi.to_degrees()
            );
        }
    }
}

#[test]
fn a_mirror_shows_the_light_in_its_own_direction_only() {
    for model in [ReflectionModel::Phong, ReflectionModel::Blinn] {
        let scene = bench(model, f64::INFINITY);
        let l = DVec3::new(0.6, 0.0, 0.8);
        let at = |v: DVec3| respond(&scene, from(l), v).specular_factor;
        assert!(
            (at(DVec3::new(-0.6, 0.0, 0.8)) - 1.0).abs() < 1e-12,
            "{model:?}"
        );
        assert_eq!(at(tilted(-0.644_5)), 0.0);
    }
}

#[test]
fn blinn_and_phong_agree_on_the_axis_of_the_lobe() {
    for n in [0.0, 1.0, 45.0, 1005.0, 1e9] {
        for angle in degrees(0, 89) {
            let [phong, blinn] = [ReflectionModel::Phong, ReflectionModel::Blinn].map(|model| {
                respond(&bench(model, n), from(tilted(angle)), tilted(-angle)).specular_factor
            });
            assert!(
                (phong - 1.0).abs() < 1e-5 && (blinn - 1.0).abs() < 1e-5,
                "n {n}: {phong} {blinn}"
            );
        }
    }
}

#[test]
fn blinns_lobe_is_the_power_of_the_cosine_to_the_half_vector() {
    for n in [1.0, 20.0, 400.0] {
        let scene = bench(ReflectionModel::Blinn, n);
        for view in degrees(-80, 80) {
            let at = respond(&scene, from(tilted(0.5)), tilted(view));
            let expected = (0.5 * (0.5 + view)).cos().powf(n);
            assert!((at.specular_factor - expected).abs() < 1e-10);
        }
    }
}

#[test]
fn attenuation_has_its_forms_and_nothing_divides_by_zero() {
    let light = Light {
        k: 0.5,
        c1: 0.3,
        c2: 0.2,
        c3: 0.1,
        ..Light::default()
    };
    type Form = (Attenuation, fn(f64) -> f64);
    let forms: [Form; 5] = [
        (Attenuation::None, |_| 1.0),
        (Attenuation::Light, |d| 1.0 / (d + 0.5)),
        (Attenuation::Viewer, |d| 1.0 / (d + 0.5)),
        (Attenuation::InverseSquare, |d| 1.0 / (d * d)),
        (Attenuation::Quadratic, |d| {
            (1.0 / (0.3 + 0.2 * d + 0.1 * d * d)).min(1.0)
        }),
    ];
    let mut scene = bench(ReflectionModel::Phong, 10.0);
    for (attenuation, form) in forms {
        for d in [1e-3, 0.1, 1.0, 3.0, 1e3, 1e6] {
            let lamp = Light {
                attenuation,
                position: DVec3::Z * d,
                ..light.clone()
            };
            assert!((attenuation_at(&lamp, attenuation, d) / form(d) - 1.0).abs() < 1e-12);
            scene.lights = vec![lamp];
            let viewer = 1e3;
            let expected = if attenuation == Attenuation::Viewer {
                form(viewer)
            } else {
                form(d)
            };
            let at = Equation::<f64>::new(&scene).respond_world(0, DVec3::ZERO, DVec3::Z, None);
            assert!(
                (at.attenuation / expected - 1.0).abs() < 1e-9,
                "{attenuation:?} at {d}: {}",
                at.attenuation
            );
        }
        // The light on the surface itself, and at distance 0 of the plotted curve.
        scene.lights = vec![Light {
            attenuation,
            position: DVec3::ZERO,
            k: 0.0,
            c1: 0.0,
            ..light.clone()
        }];
        let at = Equation::<f64>::new(&scene).respond_world(0, DVec3::ZERO, DVec3::Z, None);
        assert!(
            at.attenuation.is_finite() && at.diffuse.is_finite() && at.specular.is_finite(),
            "{attenuation:?}"
        );
        let none = Light {
            k: 0.0,
            c1: 0.0,
            ..light.clone()
        };
        assert!(attenuation_at(&none, attenuation, 0.0).is_finite());
    }
    for attenuation in [
        Attenuation::Light,
        Attenuation::InverseSquare,
        Attenuation::Quadratic,
    ] {
        assert!(
            attenuation_at(&light, attenuation, 1e30) < 1e-29,
            "it vanishes far away"
        );
    }
}

#[test]
fn a_spot_shines_along_its_axis_and_not_beyond_its_cone() {
    for (cone, exponent, softness) in [
        (20.0, 0.0, 0.0),
        (20.0, 8.0, 0.5),
        (0.1, 0.0, 0.0),
        (90.0, 1.0, 1.0),
    ] {
        let light = Light {
            kind: LightKind::Spot,
            position: DVec3::Z,
            direction: -DVec3::Z * 7.0,
            cone,
            exponent,
            softness,
            ..Light::default()
        };
        let mut scene = bench(ReflectionModel::Phong, 10.0);
        scene.lights = vec![light.clone()];
        let equation = Equation::<f64>::new(&scene);
        for step in 0..=200_i32 {
            let angle = (f64::from(step) * 0.01 * cone).to_radians();
            // A point in that direction from the light.
            let ray = DVec3::new(angle.sin(), 0.0, -angle.cos());
            let at = equation.respond_world(0, light.position + ray * 0.7, DVec3::Z, None);
            let expected = spot_part(&light, ray);
            // A hard edge falls off within a millionth of the cone.
            let at_edge = (99..=101).contains(&step) && softness == 0.0;
            assert!(
                at_edge || (at.spot - expected).abs() < 1e-6,
                "cone {cone}, step {step}: {} {expected}",
                at.spot
            );
        }
        let on_axis = equation.respond_world(0, DVec3::ZERO, DVec3::Z, None).spot;
        assert!((on_axis - 1.0).abs() < 1e-12);
    }
}

#[test]
fn fresnel_is_the_closed_form_of_the_cited_indices() {
    for index in [Index::GLASS, Index::SILVER, Index::GOLD] {
        for angle in [0.0_f64, 10.0, 45.0, 56.0, 80.0, 89.9] {
            let cosine = angle.to_radians().cos();
            let w = index.reflectance(cosine);
            for c in 0..3 {
                let expected = amplitude_reflectance(index.eta[c], index.k[c], cosine);
                assert!(
                    (w[c] / expected - 1.0).abs() < 1e-9,
                    "{angle}°: {} {expected}",
                    w[c]
                );
            }
        }
        let normal = ((index.eta - 1.0).powf(2.0) + index.k * index.k)
            / ((index.eta + 1.0).powf(2.0) + index.k * index.k);
        assert!((index.reflectance(1.0) - normal).abs().max_element() < 1e-12);
        assert!(
            (index.reflectance(0.0) - Rgb::ONE).abs().max_element() < 1e-12,
            "grazing light is all reflected"
        );
    }
    // Computed by hand: 4.2 % for glass, and gold's red above its blue.
    assert!((Index::GLASS.reflectance(1.0).y - 0.042_4).abs() < 2e-4);
    let gold = Index::GOLD.reflectance(1.0);
    assert!(
        (gold - Rgb::new(0.963, 0.787, 0.408)).abs().max_element() < 2e-3,
        "{gold}"
    );
}

#[test]
fn fresnel_at_its_limits() {
    let equal = Index {
        eta: Rgb::ONE,
        k: Rgb::ZERO,
    };
    for step in 0..=90 {
        let cosine = f64::from(step).to_radians().cos();
        assert!(
            equal.reflectance(cosine).max_element() < 1e-12,
            "equal indices reflect nothing"
        );
    }
    // From glass into air: all light is reflected beyond the critical angle, 41.8°.
    let out = Index {
        eta: Rgb::splat(1.0 / 1.5),
        k: Rgb::ZERO,
    };
    let critical = (1.0_f64 / 1.5).asin();
    for beyond in [1e-6, 0.1, 0.5] {
        assert!(
            (out.reflectance((critical + beyond).cos()) - Rgb::ONE)
                .abs()
                .max_element()
                < 1e-12
        );
    }
    assert!(out.reflectance((critical - 0.01).cos()).max_element() < 0.7);
    // Brewster's angle: only the perpendicular part is left, ρ = sin⁴(θ₁ − θ₂)… = ((η² − 1)/(η² + 1))²/2.
    let (eta, index) = (
        1.5_f64,
        Index {
            eta: Rgb::splat(1.5),
            k: Rgb::ZERO,
        },
    );
    let expected = 0.5 * ((eta * eta - 1.0) / (eta * eta + 1.0)).powi(2);
    assert!((index.reflectance(eta.atan().cos()).x - expected).abs() < 1e-12);
}

#[test]
fn microfacets_are_the_closed_form_and_reciprocal() {
    let mut dice = Dice(0x1982);
    for &distribution in Distribution::VALUES {
        for m in [0.05, 0.2, 0.5, 1.0] {
            let mut scene = bench(ReflectionModel::CookTorrance, 1.0);
            scene.reflection.distribution = distribution;
            scene.material.roughness = m;
            for _ in 0..500 {
                let mut upper = || {
                    DVec3 {
                        z: 0.05 + dice.unit(),
                        ..dice.direction()
                    }
                    .normalize()
                };
                let (l, v) = (upper(), upper());
                let at = respond(&scene, from(l), v).specular_factor;
                let expected = cook_torrance(distribution, m, DVec3::Z, l, v);
                assert!(
                    (at - expected).abs() < 1e-9 * (1.0 + expected),
                    "{distribution:?} {m}: {at} {expected}"
                );
                // Helmholtz: f(l, v) = f(v, l), where π·f·(N·L) is the reflected part.
                let back = respond(&scene, from(v), l).specular_factor;
                assert!(
                    (at / l.z - back / v.z).abs() < 1e-9 * (1.0 + at / l.z),
                    "{distribution:?} {m}"
                );
            }
        }
    }
}

/// Checks that a normal shorter than unit length enters unchanged: cos α is N·H, as in Blinn's model.
#[test]
fn microfacets_take_a_short_normal_as_it_is() {
    let mut dice = Dice(0x2007);
    for &distribution in Distribution::VALUES {
        for m in [0.2, 0.5, 1.0] {
            let mut scene = bench(ReflectionModel::CookTorrance, 1.0);
            (scene.shading.mode, scene.shading.renormalise) = (ShadingMode::Phong, false);
            scene.reflection.distribution = distribution;
            scene.material.roughness = m;
            scene.camera.viewer = Viewer::Infinite;
            scene.camera.eye = DVec3::new(0.3, 0.0, 1e3);
            let v = (scene.camera.eye - scene.camera.target).normalize();
            for _ in 0..500 {
                let mut upper = || {
                    DVec3 {
                        z: 0.05 + dice.unit(),
                        ..dice.direction()
                    }
                    .normalize()
                };
                let (l, n) = (upper(), upper());
                let n = n * (1.0 - 0.2 * dice.unit());
                if n.dot(l) < 1e-6 {
                    continue;
                }
                scene.lights = vec![from(l)];
                let at = Equation::<f64>::new(&scene)
                    .respond_world(0, DVec3::ZERO, n, None)
                    .specular_factor;
                let expected = cook_torrance(distribution, m, n, l, v);
                assert!(
                    (at - expected).abs() < 1e-9 * (1.0 + expected),
                    "{distribution:?} {m}, |N| = {}: {at} {expected}",
                    n.length()
                );
            }
        }
    }
}

#[test]
fn phongs_factor_is_the_same_both_ways() {
    let mut dice = Dice(0x1975);
    let scene = bench(ReflectionModel::Phong, 12.0);
    for _ in 0..500 {
        let mut upper = || {
            DVec3 {
                z: 0.05 + dice.unit(),
                ..dice.direction()
            }
            .normalize()
        };
        let (l, v) = (upper(), upper());
        let [there, back] =
            [(l, v), (v, l)].map(|(l, v)| respond(&scene, from(l), v).specular_factor);
        assert!((there - back).abs() < 1e-12);
    }
}

/// Checks that every microfacet counts once: ∫ D·cos α dω = 1. D is measured by the light that returns to where it came from.
#[test]
fn the_distributions_are_normalised() {
    for &distribution in Distribution::VALUES {
        for m in [0.1, 0.3, 0.6] {
            let mut scene = bench(ReflectionModel::CookTorrance, 1.0);
            scene.reflection.distribution = distribution;
            scene.material.roughness = m;
            let steps = 4000;
            let mut sum = 0.0;
            for step in 0..steps {
                let alpha = (f64::from(step) + 0.5) / f64::from(steps) * PI / 2.0;
                let direction = tilted(alpha);
                let s = respond(&scene, from(direction), direction).specular_factor;
                let c = alpha.cos();
                let g = match distribution {
                    Distribution::Beckmann => (2.0 * c * c).min(1.0),
                    Distribution::Ggx => {
                        (2.0 / (1.0 + (1.0 + m * m * alpha.tan().powi(2)).sqrt())).powi(2)
                    }
                };
                let d = 4.0 * c * s / (PI * g);
                sum += d * c * 2.0 * PI * alpha.sin() * (PI / 2.0 / f64::from(steps));
            }
            assert!((sum - 1.0).abs() < 2e-3, "{distribution:?} {m}: {sum}");
        }
    }
}

#[test]
fn lights_add_up_in_any_order_and_in_proportion() {
    let mut dice = Dice(0x5eed);
    let mut renderer = Renderer::default();
    for _ in 0..10 {
        let mut scene = random_scene(&mut dice, 12.0);
        scene.image.size = [64, 48];
        scene.lights.truncate(2);
        if scene.lights.len() < 2 {
            continue;
        }
        let mut swapped = scene.clone();
        swapped.lights.swap(0, 1);
        let points: Vec<DVec3> = (0..50).map(|_| dice.direction()).collect();
        let [one, other] = [&scene, &swapped].map(Equation::<f64>::new);
        let mut half = scene.clone();
        half.ambient.color *= 0.5;
        half.lights.iter_mut().for_each(|light| light.color *= 0.5);
        let halved = Equation::<f64>::new(&half);
        for p in points {
            let whole = one.illuminate_world(p, p, None);
            assert!(
                (whole - other.illuminate_world(p, p, None))
                    .abs()
                    .max_element()
                    < 1e-12
            );
            assert_eq!(halved.illuminate_world(p, p, None) * 2.0, whole);
        }
        let first = renderer.render(&scene).pixels.clone();
        let second = renderer.render(&swapped).pixels.clone();
        let most = first
            .iter()
            .flatten()
            .zip(second.iter().flatten())
            .map(|(a, b)| a.abs_diff(*b))
            .max();
        assert!(most <= Some(1), "a rounding at most");
    }
}

#[test]
fn a_colour_of_the_highlight_tints_it_and_nothing_else() {
    let plain = bench(ReflectionModel::Phong, 20.0);
    let mut tinted = plain.clone();
    tinted.material.specular_color = Rgb::new(1.0, 0.5, 0.25);
    let [a, b] = [plain, tinted].map(|scene| respond(&scene, from(tilted(0.3)), tilted(-0.2)));
    assert_eq!(b.diffuse, a.diffuse);
    assert_eq!(b.specular, a.specular * Rgb::new(1.0, 0.5, 0.25));
}

#[test]
fn w_multiplies_the_highlight_at_the_models_own_angle() {
    for model in [
        ReflectionModel::Phong,
        ReflectionModel::Blinn,
        ReflectionModel::CookTorrance,
    ] {
        let plain = bench(model, 20.0);
        let mut gold = plain.clone();
        gold.material.reflectance = Reflectance::Gold;
        let (l, v) = (tilted(1.1), tilted(-0.7));
        let [a, b] = [plain, gold].map(|scene| respond(&scene, from(l), v));
        let cosine = if model == ReflectionModel::Phong {
            l.z
        } else {
            l.dot((l + v).normalize())
        };
        assert!((b.incidence - cosine.acos()).abs() < 1e-7);
        let expected = a.specular * Index::GOLD.reflectance(cosine);
        assert!(
            (b.specular - expected).abs().max_element() < 1e-12,
            "{model:?}"
        );
    }
}

#[test]
fn silent_lights_add_nothing() {
    let mut scene = bench(ReflectionModel::Phong, 20.0);
    scene.lights = vec![from(tilted(0.3)), from(tilted(-0.3)), from(DVec3::Z)];
    let parts: Vec<Rgb> = (0..3)
        .map(|keep| {
            let mut one = scene.clone();
            one.lights = vec![scene.lights[keep].clone()];
            Equation::<f64>::new(&one).illuminate_world(DVec3::ZERO, DVec3::Z, None)
        })
        .collect();
    let whole =
        |scene: &Scene| Equation::<f64>::new(scene).illuminate_world(DVec3::ZERO, DVec3::Z, None);
    scene.lights[1].mute = true;
    assert!((whole(&scene) - parts[0] - parts[2]).abs().max_element() < 1e-12);
    scene.lights[2].solo = true;
    assert!((whole(&scene) - parts[2]).abs().max_element() < 1e-12);
    scene.lights[1].solo = true;
    assert!(
        (whole(&scene) - parts[2]).abs().max_element() < 1e-12,
        "muted, though soloed"
    );
}
