//! Shadows, transparency, the floor and one bounce of light: pictures against independently computed rays.

mod glass;

use glam::{DVec2, DVec3};
use shading_lab::analysis::probe::probe;
use shading_lab::render::{Renderer, Stage};
use shading_lab::scene::{
    AmbientSource, AreaShape, Backfacing, Choice, CuedBy, FlatAt, Ground, Interpolation, Light,
    LightKind, NormalSource, ObjectKind, PatternKind, Rgb, Scene, ShadingMode, presets,
};
use std::time::Instant;

const SIDE: u32 = 160;

/// Returns a sphere over a floor, seen from above.
fn over_floor() -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [SIDE, SIDE];
    scene.camera.eye = DVec3::new(0.5, 3.0, 4.0);
    scene.camera.target = DVec3::new(0.0, -0.4, 0.0);
    scene.object.normals = NormalSource::Exact;
    (scene.object.segments, scene.object.rings) = (128, 64);
    scene.material.ka = Rgb::ZERO;
    scene.ground = Ground {
        visible: true,
        height: -1.2,
        ka: 0.0,
        kd: 1.0,
        color: Rgb::ONE,
    };
    scene.shading.shadows = true;
    scene
}

/// Returns the ray through the middle of a pixel.
fn eye_ray(scene: &Scene, x: u32, y: u32) -> (DVec3, DVec3) {
    let camera = &scene.camera;
    let forward = (camera.target - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    let up = right.cross(forward);
    let [width, height] = scene.image.size.map(f64::from);
    let focal = 0.5 * camera.span([width, height]) / (0.5 * camera.fov_y.to_radians()).tan();
    let place = DVec2::new(
        f64::from(x) + 0.5 - 0.5 * width,
        0.5 * height - f64::from(y) - 0.5,
    ) / focal;
    (
        camera.eye,
        (forward + right * place.x + up * place.y).normalize(),
    )
}

/// Returns the distance of a ray from the centre of the unit sphere, or `None` if the sphere is behind it.
fn nearest_approach(origin: DVec3, direction: DVec3) -> Option<f64> {
    let direction = direction.normalize();
    let t = -origin.dot(direction);
    (t > 0.0).then(|| (origin + direction * t).length())
}

#[test]
fn a_spheres_shadow_on_the_floor_is_where_rays_to_the_light_meet_it() {
    let lamp = Light {
        position: DVec3::new(2.0, 3.0, 1.0),
        ..Light::default()
    };
    let sun = Light {
        kind: LightKind::Directional,
        direction: DVec3::new(-1.0, -1.3, 0.4),
        ..Light::default()
    };
    let mut renderer = Renderer::default();
    for (light, mode) in [
        (&lamp, ShadingMode::Phong),
        (&sun, ShadingMode::Phong),
        (&lamp, ShadingMode::Exact),
    ] {
        let mut scene = over_floor();
        scene.lights = vec![light.clone()];
        scene.shading.mode = mode;
        let frame = renderer.render(&scene).clone();
        let (mut dark, mut lit) = (0, 0);
        for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
            let (origin, direction) = eye_ray(&scene, x, y);
            if direction.y >= 0.0 || nearest_approach(origin, direction).is_some_and(|r| r < 1.03) {
                continue;
            }
            let p = origin + direction * ((scene.ground.height - origin.y) / direction.y);
            let l = if light.kind == LightKind::Directional {
                -light.direction
            } else {
                light.position - p
            };
            let approach = nearest_approach(p, l).unwrap_or(9.0);
            if (approach - 1.0).abs() < 5e-3 {
                continue;
            }
            let red = frame.pixel(x, y).expect("inside")[0];
            let expected = if approach < 1.0 {
                0.0
            } else {
                l.normalize().y * 255.0
            };
            assert!(
                (f64::from(red) - expected).abs() <= 1.0,
                "{mode:?} {x},{y}: {red}, expected {expected}"
            );
            if approach < 1.0 { dark += 1 } else { lit += 1 }
        }
        assert!(dark > 300 && lit > 3000, "{dark} {lit}");
    }
}

/// Checks points at a distance of 10¹⁵, where rounding is as large as the object, so that rays between them and the light start
/// at the light.
#[test]
fn points_extremely_far_away_lie_in_the_shadow_and_cost_no_more_than_near_ones() {
    const SIDE: u32 = 48;
    let lamp = DVec3::new(0.0, 3.0, 0.0);
    let seen_from = |away: f64| {
        let mut scene = over_floor();
        scene.image.size = [SIDE; 2];
        (scene.object.segments, scene.object.rings) = (256, 128);
        scene.lights = vec![Light {
            position: lamp,
            ..Light::default()
        }];
        (scene.camera.eye, scene.camera.target) = (DVec3::new(0.0, away, 0.3 * away), DVec3::ZERO);
        scene.ground.height = -away;
        let mut renderer = Renderer::default();
        let began = Instant::now();
        (renderer.render(&scene).clone(), began.elapsed(), scene)
    };
    let (_, near, _) = seen_from(20.0);
    let (frame, far, scene) = seen_from(1e15);
    let (mut dark, mut lit) = (0, 0);
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let (origin, direction) = eye_ray(&scene, x, y);
        let p = origin + direction * ((scene.ground.height - origin.y) / direction.y);
        // Starts at the light: seen from the point, rounding would leave nothing of the object's size.
        let approach = nearest_approach(lamp, p - lamp).unwrap_or(9.0);
        if (approach - 1.0).abs() < 5e-3 {
            continue;
        }
        let red = frame.pixel(x, y).expect("inside")[0];
        let expected = if approach < 1.0 {
            0.0
        } else {
            (lamp - p).normalize().y * 255.0
        };
        assert!(
            (f64::from(red) - expected).abs() <= 1.0,
            "{x},{y}: {red}, expected {expected}"
        );
        if approach < 1.0 { dark += 1 } else { lit += 1 }
    }
    assert!(dark > 200 && lit > 500, "{dark} {lit}");
    assert!(far < 4 * near, "{far:?} from far away, {near:?} from near");
}

/// Checks that facets that stand for a smooth surface cast no shadow on each other, however grazing the light.
#[test]
fn a_convex_solid_is_free_of_its_own_shadow_in_every_mode() {
    let mut renderer = Renderer::default();
    let modes = [
        ShadingMode::Flat,
        ShadingMode::Interpolated,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Exact,
    ];
    for kind in [
        ObjectKind::Sphere,
        ObjectKind::Cylinder,
        ObjectKind::Cone,
        ObjectKind::Cube,
    ] {
        for mode in modes {
            let mut scene = over_floor();
            scene.object.kind = kind;
            (scene.object.segments, scene.object.rings) = (24, 12);
            // A cube's averaged normals describe no solid.
            let averaged = kind != ObjectKind::Cube;
            scene.object.normals = if averaged {
                NormalSource::Averaged
            } else {
                NormalSource::Exact
            };
            scene.shading.mode = mode;
            scene.ground.height = -3.0;
            scene.lights = vec![Light {
                position: DVec3::new(3.0, 1.0, -1.0),
                ..Light::default()
            }];
            let shadowed = renderer.render(&scene).clone();
            scene.shading.shadows = false;
            let plain = renderer.render(&scene).clone();
            let mut differing = 0;
            for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
                let on_object = probe(&mut renderer, &scene, x, y).hit.is_some();
                differing += u32::from(on_object && shadowed.pixel(x, y) != plain.pixel(x, y));
            }
            assert!(differing <= 12, "{kind:?} {mode:?}: {differing} pixels");
        }
    }
}

#[test]
fn polygons_cast_the_shadow_of_the_surface_they_stand_for() {
    let mut renderer = Renderer::default();
    let mut scene = over_floor();
    scene.object.kind = ObjectKind::Torus;
    (scene.object.segments, scene.object.rings) = (192, 96);
    scene.lights = vec![Light {
        position: DVec3::new(2.0, 1.2, 0.5),
        ..Light::default()
    }];
    let polygons = renderer.render(&scene).clone();
    scene.shading.mode = ShadingMode::Exact;
    let exact = renderer.render(&scene).clone();
    let far = polygons
        .pixels
        .iter()
        .zip(&exact.pixels)
        .filter(|(a, b)| (0..3).any(|c| a[c].abs_diff(b[c]) > 6))
        .count();
    assert!(far < 120, "{far} pixels differ");
    scene.shading.shadows = false;
    let none = renderer.render(&scene).clone();
    let shaded = exact
        .pixels
        .iter()
        .zip(&none.pixels)
        .filter(|(a, b)| a != b)
        .count();
    assert!(shaded > 2000, "{shaded} pixels are in shadow");
}

#[test]
fn an_area_light_has_a_penumbra_as_deep_as_the_part_that_is_hidden() {
    let mut scene = over_floor();
    scene.lights = vec![Light {
        kind: LightKind::Area,
        shape: AreaShape::Sphere,
        radius: 0.4,
        samples: 256,
        position: DVec3::new(0.0, 4.0, 0.0),
        ..Light::default()
    }];
    let mut renderer = Renderer::default();
    let frame = renderer.render(&scene).clone();
    let mut levels = std::collections::BTreeSet::new();
    for x in 0..SIDE {
        levels.insert(frame.pixel(x, SIDE - 12).expect("inside")[0]);
    }
    assert!(
        levels.len() > 12,
        "shades between light and dark: {levels:?}"
    );
}

#[test]
fn shadows_are_kept_while_the_material_changes_and_traced_again_when_a_light_moves() {
    let mut renderer = Renderer::default();
    let mut scene = over_floor();
    for mode in [ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong] {
        scene.shading.mode = mode;
        renderer.render(&scene);
        let ran = |renderer: &Renderer| {
            renderer
                .report()
                .stages
                .iter()
                .any(|run| run.stage == Stage::Rays && run.ran)
        };
        assert!(ran(&renderer), "{mode:?}");
        scene.material.n += 1.0;
        scene.material.ks *= 0.9;
        renderer.render(&scene);
        assert!(!ran(&renderer), "{mode:?}");
        scene.lights[0].position.x += 0.1;
        renderer.render(&scene);
        assert!(ran(&renderer), "{mode:?}");
    }
}

/// Checks that a ray inside a ball meets its surface at the angle at which it was refracted, and leaves. Under water it is
/// reflected beyond the critical angle, and only there.
#[test]
fn what_the_scenes_say_of_total_reflection_is_seen_in_them() {
    for (name, critical) in [
        ("glass-ball", None),
        ("under-water", Some((1.0_f64 / 1.33).asin().to_degrees())),
    ] {
        let preset = presets::find(name).expect("a scene");
        let mut scene = preset.scene();
        scene.image.size = [64, 64];
        let (mut renderer, mut total, mut passing) = (Renderer::default(), 0, 0);
        for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
            let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
                continue;
            };
            let through = hit.transmission.expect("glass");
            let angle = hit
                .normal
                .dot((scene.camera.eye - hit.position).normalize())
                .acos()
                .to_degrees();
            assert_eq!(
                through.total_reflections > 0,
                critical.is_some_and(|critical| angle > critical),
                "{name} {x},{y}"
            );
            if through.total_reflections > 0 {
                total += 1;
            } else {
                passing += 1;
            }
        }
        assert!(
            passing > 1000 && (total > 500) == critical.is_some(),
            "{name}: {total} and {passing}"
        );
        assert_eq!(
            critical.is_some(),
            preset.sentence().contains("all light is reflected"),
            "{name}"
        );
        assert!(!preset.sentence().contains("totally"), "{name}");
    }
}

/// Checks that Ia makes no difference where light from other surfaces takes its place; the wall hides the ground there too.
#[test]
fn a_bounce_does_not_depend_on_the_constant_that_it_takes_the_place_of() {
    let mut renderer = Renderer::default();
    for mode in [ShadingMode::Gouraud, ShadingMode::Phong, ShadingMode::Exact] {
        let mut scene = presets::find("one-bounce").expect("a scene").scene();
        scene.image.size = [90, 80];
        scene.shading.mode = mode;
        scene.ambient.source = AmbientSource::Bounce;
        let own = renderer.render(&scene).clone();
        assert!(own.pixels.iter().filter(|pixel| pixel[0] > 20).count() > 2000);
        for ia in [0.0, 1.0, 1e7, 1e12, 1e30] {
            scene.ambient.color = Rgb::splat(ia);
            let same = renderer.render(&scene).pixels == own.pixels;
            assert!(same, "{mode:?}, Ia {ia}");
            let hit = probe(&mut renderer, &scene, 45, 30).hit.expect("the ball");
            assert!(
                (0..3)
                    .all(|c| (hit.sum[c].min(1.0) * 255.0 - f64::from(hit.stored[c])).abs() <= 1.0),
                "{mode:?} {ia}"
            );
        }
        // The bounce stays the same even beside the brightest constant.
        scene.ambient.source = AmbientSource::Split;
        assert_eq!(scene.validate(), Ok(()));
        let halves = renderer.render(&scene).clone();
        for (index, (pixel, own)) in halves.pixels.iter().zip(&own.pixels).enumerate() {
            assert!(index % 90 < 45 || pixel == own, "{mode:?} {index}");
        }
    }
}

/// Returns every shading mode with a pattern, a floor, glass and depth cueing, in a picture whose middle is not a whole SIMD
/// vector of pixels.
fn patterned_scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    let kinds = [
        PatternKind::Checker,
        PatternKind::Stripes,
        PatternKind::Rings,
    ];
    for (index, (mode, flat_at)) in [
        (ShadingMode::Flat, FlatAt::Centre),
        (ShadingMode::Flat, FlatAt::VertexMean),
        (ShadingMode::Flat, FlatAt::ProvokingVertex),
        (ShadingMode::Interpolated, FlatAt::Centre),
        (ShadingMode::Gouraud, FlatAt::Centre),
        (ShadingMode::Phong, FlatAt::Centre),
        (ShadingMode::Exact, FlatAt::Centre),
    ]
    .into_iter()
    .enumerate()
    {
        for (more, cued) in [CuedBy::Off, CuedBy::Vertex, CuedBy::Pixel]
            .into_iter()
            .enumerate()
        {
            let mut scene = Scene::default();
            scene.image.size = [75, 50];
            (scene.object.segments, scene.object.rings) = (24, 12);
            (scene.shading.mode, scene.shading.flat_at) = (mode, flat_at);
            scene.shading.interpolation = Interpolation::VALUES[(index + more) % 3];
            scene.pattern.kind = kinds[(index + 2 * more) % 3];
            scene.material.ka = Rgb::splat(0.5);
            scene.depth_cueing.by = cued;
            scene.depth_cueing.color = Rgb::new(0.1, 0.2, 0.3);
            scene.ground.visible = more > 0;
            scene.transparency.kt = if more > 1 { 0.4 } else { 0.0 };
            scene.material.n = if more == 1 { 2e7 } else { 20.0 };
            scene.ambient.source = AmbientSource::Split;
            scenes.push(scene);
        }
    }
    scenes
}

#[test]
fn split_is_half_the_constant_picture_and_half_the_bounce() {
    let mut renderer = Renderer::default();
    renderer.keep_linear(true);
    for scene in patterned_scenes() {
        let [split, constant, bounce] = [
            AmbientSource::Split,
            AmbientSource::Constant,
            AmbientSource::Bounce,
        ]
        .map(|source| {
            let mut scene = scene.clone();
            scene.ambient.source = source;
            renderer.render(&scene);
            renderer.linear().to_vec()
        });
        let about = format!("{:?}, {:?}", scene.shading, scene.depth_cueing.by);
        for (index, pixel) in split.iter().enumerate() {
            let half = if index % 75 < 38 { &constant } else { &bounce };
            assert_eq!(
                *pixel,
                half[index],
                "{about}: {}, {}",
                index % 75,
                index / 75
            );
        }
        for (x, y) in [(30, 20), (37, 25), (38, 25), (41, 18), (50, 30)] {
            let shown = split[y as usize * 75 + x as usize];
            let hit = probe(&mut renderer, &scene, x, y).hit.expect("the ball");
            assert_eq!(hit.bounced, x >= 38);
            let [r, g, b, _] = shown.map(f64::from);
            let off = (hit.sum - Rgb::new(r, g, b)).abs().max_element();
            assert!(off < 2e-3, "{about} at {x},{y}: {off}");
        }
    }
}

#[test]
fn a_surface_of_two_sides_scatters_light_from_behind_it() {
    let mut scene = presets::find("one-bounce").expect("a scene").scene();
    (scene.image.size, scene.object.kind) = ([100, 75], ObjectKind::Plane);
    scene.ambient.source = AmbientSource::Bounce;
    // The floor before the plane lies in its shadow.
    scene.lights[0].position = DVec3::new(0.3, 0.6, -1.5);
    // One renderer: the bounce that it keeps is of no use to the other surface.
    let mut renderer = Renderer::default();
    let [clamped, flipped] = [Backfacing::Clamp, Backfacing::Flip].map(|backfacing| {
        scene.reflection.backfacing = backfacing;
        let [r, g, _, _] = renderer.render(&scene).pixels[70 * 100 + 50];
        [r, g].map(u32::from)
    });
    assert_eq!(clamped, [0, 0]);
    let [r, g] = flipped;
    assert!(r > 5 && r > 3 * g, "{r} {g}");
}

#[test]
fn without_lamps_nothing_bounces() {
    let mut renderer = Renderer::default();
    for mut scene in patterned_scenes() {
        scene.lights.clear();
        scene.transparency.kt = 0.0;
        scene.depth_cueing.by = CuedBy::Off;
        let frame = renderer.render(&scene).clone();
        for (index, pixel) in frame.pixels.iter().enumerate() {
            let black = *pixel == [0, 0, 0, 255];
            assert!(black || index % 75 < 38, "{:?}: {pixel:?}", scene.shading);
        }
        let seen = frame.pixels.iter().filter(|pixel| pixel[0] > 20).count();
        assert!(seen > 300, "{seen} pixels have the constant");
        let hit = probe(&mut renderer, &scene, 43, 27).hit.expect("the ball");
        assert_eq!((hit.ambient, hit.sum), (Rgb::ZERO, Rgb::ZERO));
        let between = (0..3).all(|c| {
            let ends = [scene.material.color[c], scene.pattern.color[c]];
            (ends[0].min(ends[1]) - 1e-9..=ends[0].max(ends[1]) + 1e-9).contains(&hit.color[c])
        });
        assert!(between, "Od {}", hit.color);
    }
}

/// Checks that only the direction from the eye to its target counts, however near they are, in every mode, for picture and probe.
#[test]
fn an_eye_next_to_its_target_sees_what_one_a_little_farther_sees() {
    let modes = [
        ShadingMode::Flat,
        ShadingMode::Interpolated,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Exact,
    ];
    let mut renderer = Renderer::default();
    for mode in modes {
        let mut scene = Scene::default();
        scene.image.size = [48, 48];
        scene.object.kind = ObjectKind::Torus;
        scene.shading.mode = mode;
        scene.camera.eye = DVec3::new(0.0, 0.0, 1e-6);
        let expected = renderer.render(&scene).clone();
        assert!(
            expected.pixels.iter().any(|pixel| pixel[0] > 150),
            "{mode:?}"
        );
        for distance in [1e-9, 1e-12, 1e-14, 1e-18, 1e-22, 1e-29] {
            scene.camera.eye.z = distance;
            assert_eq!(scene.validate(), Ok(()));
            let found = renderer.render(&scene).clone();
            let pairs = found.pixels.iter().zip(&expected.pixels);
            let off = pairs
                .filter(|(a, b)| (0..3).any(|c| a[c].abs_diff(b[c]) > 2))
                .count();
            assert!(off <= 24, "{mode:?} at {distance:e}: {off} pixels");
            let hit = probe(&mut renderer, &scene, 10, 20).hit.expect("the torus");
            assert!(
                (0..3).all(|c| (hit.sum[c] * 255.0 - f64::from(hit.stored[c])).abs() <= 1.0),
                "{mode:?} {distance:e}"
            );
        }
    }
}

/// Checks that the ground is solid, whichever side of the object is lit: a light below it does not light it, with shadows or
/// without.
#[test]
fn a_light_below_the_floor_does_not_light_it() {
    let mut scene = over_floor();
    let pixels = [[8, 150], [80, 155], [150, 120], [30, 152]];
    let mut renderer = Renderer::default();
    for &backfacing in Backfacing::VALUES {
        for shadows in [true, false] {
            (scene.reflection.backfacing, scene.shading.shadows) = (backfacing, shadows);
            for y in [-3.0, 3.0] {
                scene.lights = vec![Light {
                    position: DVec3::new(0.4, y, 0.3),
                    ..Light::default()
                }];
                let frame = renderer.render(&scene);
                let lit = pixels.map(|[x, y]| frame.pixel(x, y).expect("inside")[0] > 20);
                let what = format!("{backfacing:?}, shadows {shadows}, light at {y}");
                assert_eq!(lit, [y > 0.0; 4], "{what}");
            }
        }
    }
}

/// Checks the view factor of an infinite plane: far above an evenly lit floor, a surface whose normal is tilted by β from straight
/// down receives the fraction (1 + cos β)/2 of its light from the floor.
#[test]
fn the_bounce_off_an_infinite_floor_is_its_view_factor() {
    let mut scene = Scene::default();
    scene.image.size = [97, 97];
    scene.camera.eye = DVec3::new(0.0, 0.0, 4.0);
    scene.material.ka = Rgb::ONE;
    scene.material.kd = Rgb::splat(0.8);
    scene.material.ks = Rgb::ZERO;
    scene.material.color = Rgb::ONE;
    scene.object.normals = NormalSource::Exact;
    scene.ground = Ground {
        visible: true,
        height: -60.0,
        ka: 0.0,
        kd: 0.5,
        color: Rgb::ONE,
    };
    scene.ambient.source = AmbientSource::Bounce;
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        direction: DVec3::NEG_Y,
        ..Light::default()
    }];
    let mut renderer = Renderer::default();
    let (mut most, mut sum, mut count): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for y in 20..90 {
        let Some(hit) = probe(&mut renderer, &scene, 48, y).hit else {
            continue;
        };
        let expected = 0.8 * 0.5 * 0.5 * (1.0 - hit.normal.y);
        let error = hit.ambient.x - expected;
        most = most.max(error.abs());
        sum += error;
        count += 1.0;
    }
    // 64 directions per point and a few points per pixel: an error of a hundredth of the fraction each, and none in the mean.
    assert!(
        most < 0.025 && (sum / count).abs() < 0.004,
        "the greatest error is {most}, the mean {}",
        sum / count
    );
}

#[test]
fn the_best_ambient_is_that_whose_picture_is_as_bright() {
    let mut scene = presets::find("one-bounce").expect("a scene").scene();
    scene.image.size = [120, 120];
    scene.ambient.source = AmbientSource::Bounce;
    let mut renderer = Renderer::default();
    let bounced = renderer.render(&scene).clone();
    let fit = renderer.report().ambient_fit.expect("gathered");
    scene.ambient.source = AmbientSource::Constant;
    let mut squared = |factor: f64| -> f64 {
        scene.ambient.color = Rgb::from_array(fit) * factor;
        let constant = renderer.render(&scene);
        let pairs = constant.pixels.iter().zip(&bounced.pixels);
        pairs
            .map(|(a, b)| {
                (0..3)
                    .map(|c| f64::from(a[c].abs_diff(b[c])).powi(2))
                    .sum::<f64>()
            })
            .sum()
    };
    let [less, best, more] = [0.8, 1.0, 1.25].map(&mut squared);
    assert!(best < less && best < more, "{less} {best} {more}");
}
