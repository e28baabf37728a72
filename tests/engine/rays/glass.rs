//! The view through glass and of the walls around it.

use super::{SIDE, eye_ray};
use glam::DVec3;
use shading_lab::analysis::probe::probe;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Ground, NormalSource, ObjectKind, PatternKind, Rgb, Scene, ShadingMode, Through, presets,
};

fn before_wall(eta: f64, through: Through) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [SIDE, SIDE];
    scene.image.background = Rgb::new(0.2, 0.3, 0.4);
    scene.backdrop.pattern = PatternKind::Checker;
    scene.backdrop.color = Rgb::new(0.9, 0.8, 0.7);
    scene.backdrop.scale = 0.3;
    scene.backdrop.distance = 2.0;
    scene.transparency.kt = 1.0;
    scene.transparency.ior = eta;
    scene.transparency.through = through;
    scene.object.normals = NormalSource::Exact;
    (scene.object.segments, scene.object.rings) = (256, 128);
    scene.shading.mode = ShadingMode::Exact;
    scene
}

/// Returns the colour of the wall where a ray meets it.
fn wall(scene: &Scene, origin: DVec3, direction: DVec3) -> Option<Rgb> {
    let p = origin + direction * ((-scene.backdrop.distance - origin.z) / direction.z);
    let cell = |x: f64| (x / scene.backdrop.scale).round() as i64;
    let near_edge = |x: f64| ((x / scene.backdrop.scale - 0.5).rem_euclid(1.0) - 0.5).abs() > 0.47;
    if direction.z >= 0.0 {
        return Some(scene.image.background);
    }
    let odd = (cell(p.x) + cell(p.y)).rem_euclid(2) == 1;
    (!near_edge(p.x) && !near_edge(p.y)).then_some(if odd {
        scene.backdrop.color
    } else {
        scene.image.background
    })
}

fn refract(d: DVec3, n: DVec3, eta: f64) -> Option<DVec3> {
    // By angles: the tangential part shrinks by η.
    let across = (d - n * d.dot(n)) / eta;
    let rest = 1.0 - across.length_squared();
    (rest >= 0.0).then(|| across - n * rest.sqrt())
}

#[test]
fn a_glass_ball_shows_what_two_refractions_lead_to() {
    let mut renderer = Renderer::default();
    for (eta, through) in [
        (1.0, Through::Solid),
        (1.5, Through::Solid),
        (1.33, Through::Solid),
        (1.5, Through::Surface),
        (0.8, Through::Surface),
    ] {
        let scene = before_wall(eta, through);
        let frame = renderer.render(&scene).clone();
        let (mut compared, mut wrong) = (0, 0);
        for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
            let (origin, direction) = eye_ray(&scene, x, y);
            let b = origin.dot(direction);
            let discriminant = b * b - (origin.length_squared() - 1.0);
            if discriminant < 0.02 {
                continue;
            }
            let p = origin + direction * (-b - discriminant.sqrt());
            let Some(inside) = refract(direction, p, eta) else {
                continue;
            };
            let seen = if through == Through::Surface {
                wall(&scene, p, inside)
            } else {
                // The chord ends at q; there the normal points with the ray.
                let q = p - inside * 2.0 * p.dot(inside);
                refract(inside, -q, 1.0 / eta).and_then(|out| wall(&scene, q, out))
            };
            let Some(seen) = seen else { continue };
            let stored = frame.pixel(x, y).expect("inside");
            compared += 1;
            wrong +=
                u32::from((0..3).any(|c| (seen[c] * 255.0 - f64::from(stored[c])).abs() > 1.0));
        }
        assert!(
            compared > 1500 && wrong == 0,
            "η {eta} {through:?}: {wrong} of {compared}"
        );
    }
}

#[test]
fn beyond_the_critical_angle_nothing_passes() {
    let mut scene = presets::find("under-water").expect("a scene").scene();
    scene.image.size = [SIDE, SIDE];
    let mut renderer = Renderer::default();
    let critical = (1.0_f64 / 1.33).asin();
    let (mut through, mut back) = (0, 0);
    for (x, y) in (0..SIDE)
        .step_by(7)
        .flat_map(|y| (0..SIDE).step_by(7).map(move |x| (x, y)))
    {
        let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
            continue;
        };
        let angle = hit.view.dot(hit.normal).acos();
        let transmission = hit.transmission.expect("transparent");
        assert_eq!(
            transmission.t.is_some(),
            angle < critical,
            "{x},{y} at {}°",
            angle.to_degrees()
        );
        match transmission.t {
            Some(t) => {
                let sine = t.cross(hit.normal).length();
                assert!(
                    (sine / angle.sin() - 1.33).abs() < 1e-9,
                    "sin θ₂ = sin θ₁·1.33"
                );
                through += 1;
            }
            None => back += 1,
        }
    }
    assert!(through > 100 && back > 100, "{through} {back}");
}

#[test]
fn what_passes_and_what_is_reflected_are_mixed_by_kt() {
    let mut renderer = Renderer::default();
    for kt in [0.0, 0.3, 1.0] {
        let mut scene = before_wall(1.5, Through::Solid);
        scene.transparency.kt = kt;
        let hit = probe(&mut renderer, &scene, 80, 80).hit.expect("the ball");
        let seen = hit.transmission.map_or(Rgb::ZERO, |through| through.seen);
        assert!(
            (hit.sum - (hit.reflected * (1.0 - kt) + seen * kt))
                .abs()
                .max_element()
                < 1e-12
        );
        for c in 0..3 {
            assert!(
                (hit.sum[c].min(1.0) * 255.0 - f64::from(hit.stored[c])).abs() <= 1.0,
                "kt {kt}"
            );
        }
    }
}

/// Returns the colour of the first of ground, wall and nothing that a ray meets; `None` if the difference is too small to decide.
fn nearest(scene: &Scene, origin: DVec3, direction: DVec3) -> Option<Rgb> {
    let forward = (scene.camera.target - scene.camera.eye).normalize();
    let right = forward.cross(scene.camera.up).normalize();
    let up = right.cross(forward);
    let centre = scene.camera.target + forward * scene.backdrop.distance;
    let to_wall = (centre - origin).dot(forward) / direction.dot(forward);
    let to_floor = (scene.ground.height - origin.y) / direction.y;
    let floor = direction.y < 0.0 && to_floor > 0.0;
    if direction.dot(forward).abs() < 1e-4
        || direction.y.abs() < 1e-4
        || (to_wall / to_floor - 1.0).abs() < 1e-3
    {
        return None;
    }
    if to_wall < 0.0 || (floor && to_floor < to_wall) {
        return Some(if floor {
            scene.ground.color
        } else {
            scene.image.background
        });
    }
    let place = (origin + direction * to_wall - centre) / scene.backdrop.scale;
    let (x, y) = (place.dot(right), place.dot(up));
    let near_edge = |x: f64| ((x - 0.5).rem_euclid(1.0) - 0.5).abs() > 0.48;
    let odd = (x.round() + y.round()).rem_euclid(2.0) == 1.0;
    let color = if odd {
        scene.backdrop.color
    } else {
        scene.image.background
    };
    (!near_edge(x) && !near_edge(y)).then_some(color)
}

/// Checks a pane in the plane z = 0: every third picture looks through it or at it.
#[test]
fn of_the_ground_and_the_wall_a_ray_sees_the_nearer() {
    let mut renderer = Renderer::default();
    let mut seed = 7_u64;
    let mut number = |from: f64, to: f64| {
        seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (seed >> 11) as f64 / (1_u64 << 53) as f64
    };
    let (mut direct, mut through, mut mirrored) = ([0; 3], [0; 3], [0; 3]);
    for case in 0..150 {
        let mut scene = before_wall(number(0.6, 1.8), Through::Surface);
        scene.image.size = [40, 30];
        scene.object.kind = ObjectKind::Plane;
        (scene.object.segments, scene.object.rings) = (1, 1);
        scene.camera.eye = DVec3::new(number(-1.5, 1.5), number(-0.5, 2.0), number(1.0, 5.0));
        scene.camera.target = DVec3::new(number(-1.0, 1.0), number(-1.0, 1.0), number(-0.5, 0.5));
        if case % 3 == 0 {
            scene.object.kind = ObjectKind::Sphere;
            // Out of the picture.
            scene.camera.eye.z += 3.0;
            scene.camera.target.x += 40.0;
        }
        scene.backdrop.distance = number(0.5, 8.0);
        scene.backdrop.scale = number(0.2, 0.8);
        scene.ground = Ground {
            visible: true,
            height: number(-2.0, -0.2),
            ka: 1.0,
            kd: 0.0,
            color: Rgb::new(0.1, 0.6, 0.3),
        };
        scene.lights.clear();
        let frame = renderer.render(&scene).clone();
        for (x, y) in (0..30).flat_map(|y| (0..40).map(move |x| (x, y))) {
            let (origin, direction) = eye_ray(&scene, x, y);
            let t = -origin.z / direction.z;
            let p = origin + direction * t;
            let pane = scene.object.kind == ObjectKind::Plane && t > 0.0;
            let rim = p.x.abs().max(p.y.abs());
            if pane && (rim - 1.0).abs() < 0.02 {
                continue;
            }
            let (seen, count) = if pane && rim < 1.0 {
                let n = DVec3::Z * -direction.z.signum();
                match refract(direction, n, scene.transparency.ior) {
                    Some(on) => (nearest(&scene, p, on), &mut through),
                    None => (
                        nearest(&scene, p, direction - n * (2.0 * n.dot(direction))),
                        &mut mirrored,
                    ),
                }
            } else {
                (nearest(&scene, origin, direction), &mut direct)
            };
            let Some(seen) = seen else { continue };
            let which = if seen == scene.ground.color {
                0
            } else {
                1 + usize::from(seen == scene.backdrop.color)
            };
            count[which] += 1;
            let stored = frame.pixel(x, y).expect("inside");
            let off = (0..3)
                .map(|c| (seen[c] * 255.0 - f64::from(stored[c])).abs())
                .fold(0.0, f64::max);
            assert!(off <= 1.0, "case {case} at {x},{y}: {stored:?} for {seen}");
        }
    }
    assert!(
        [direct, through]
            .as_flattened()
            .iter()
            .all(|count| *count > 5000),
        "{direct:?} {through:?}"
    );
    assert!(mirrored.iter().sum::<i32>() > 500, "{mirrored:?}");
}
