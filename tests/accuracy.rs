//! Pictures of a sphere against rays that meet it in closed form, written apart from the engine, in double precision.

use glam::DVec3;
use shading_lab::analysis::probe;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Attenuation, Backfacing, Camera, Image, Light, LightKind, NormalSource, ObjectKind, Projection, ReflectionModel,
    Scene, ShadingMode, Viewer,
};

/// Marsaglia's xorshift generator: the same scenes on every machine.
struct Dice(u64);

impl Dice {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
            if v.length() > 0.1 && v.length() < 1.0 {
                return v.normalize();
            }
        }
    }

    fn colour(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }
}

fn random_light(dice: &mut Dice) -> Light {
    let kind = if dice.unit() < 0.5 { LightKind::Point } else { LightKind::Directional };
    let attenuation = match (dice.unit() * 5.0) as u32 {
        0 => Attenuation::Viewer,
        1 => Attenuation::Light,
        2 => Attenuation::InverseSquare,
        3 => Attenuation::Quadratic,
        _ => Attenuation::None,
    };
    Light {
        kind,
        position: dice.direction() * dice.between(1.2, 6.0),
        direction: dice.direction() * dice.between(0.1, 10.0),
        color: dice.colour(),
        attenuation,
        k: dice.between(0.0, 2.0),
        c1: dice.between(0.1, 1.0),
        c2: dice.between(0.0, 0.5),
        c3: dice.between(0.0, 0.5),
        ..Light::default()
    }
}

fn random_scene(dice: &mut Dice, n: f64) -> Scene {
    let camera = Camera {
        eye: dice.direction() * dice.between(2.5, 6.0),
        up: dice.direction(),
        projection: if dice.unit() < 0.7 { Projection::Perspective } else { Projection::Orthographic },
        fov_y: 45.0,
        viewer: if dice.unit() < 0.5 { Viewer::Local } else { Viewer::Infinite },
        ..Camera::default()
    };
    let mut scene = Scene { camera, ..Scene::default() };
    scene.image = Image { size: [256, 192], background: DVec3::ZERO };
    scene.object.kind = ObjectKind::Sphere;
    scene.material.ka = dice.colour() * 0.3;
    scene.material.kd = dice.colour();
    scene.material.ks = dice.colour();
    scene.material.n = n;
    scene.material.color = dice.colour();
    scene.ambient.color = dice.colour();
    scene.reflection.model = if dice.unit() < 0.5 { ReflectionModel::Phong } else { ReflectionModel::Blinn };
    scene.reflection.backfacing = if dice.unit() < 0.7 { Backfacing::Clamp } else { Backfacing::Flip };
    scene.lights = (0..1 + (dice.unit() * 4.0) as usize).map(|_| random_light(dice)).collect();
    scene
}

/// Point and normal of the unit sphere in the middle of a pixel, and how far from its outline the pixel lies, in pixels.
fn meet(scene: &Scene, x: u32, y: u32) -> Option<(DVec3, f64)> {
    let camera = &scene.camera;
    let [width, height] = scene.image.size.map(f64::from);
    let forward = (camera.target - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    let up = right.cross(forward);
    let (px, py) = (f64::from(x) + 0.5 - width / 2.0, height / 2.0 - f64::from(y) - 0.5);
    let distance = camera.eye.length();
    let (origin, direction, radius) = if camera.projection == Projection::Perspective {
        let focal = height / 2.0 / (camera.fov_y.to_radians() / 2.0).tan();
        (camera.eye, (forward * focal + right * px + up * py).normalize(), focal / (distance * distance - 1.0).sqrt())
    } else {
        let pixels = height / camera.height;
        (camera.eye + (right * px + up * py) / pixels, forward, pixels)
    };
    let b = origin.dot(direction);
    let discriminant = b * b - (origin.length_squared() - 1.0);
    if discriminant < 0.0 {
        return None;
    }
    Some((origin + direction * (-b - discriminant.sqrt()), radius - px.hypot(py)))
}

/// The equation of the unit sphere at `p`, as the textbooks write it.
fn textbook(scene: &Scene, p: DVec3) -> DVec3 {
    let (m, camera) = (&scene.material, &scene.camera);
    let to_eye = camera.eye - p;
    let v = if camera.viewer == Viewer::Local { to_eye.normalize() } else { (camera.eye - camera.target).normalize() };
    let mut sum = m.ka * m.color * scene.ambient.color;
    for light in &scene.lights {
        let directional = light.kind == LightKind::Directional;
        let d = (light.position - p).length();
        let l = if directional { -light.direction.normalize() } else { (light.position - p) / d };
        let f = match light.attenuation {
            Attenuation::Viewer => 1.0 / (to_eye.length() + light.k),
            _ if directional => 1.0,
            Attenuation::None => 1.0,
            Attenuation::Light => 1.0 / (d + light.k),
            Attenuation::InverseSquare => 1.0 / (d * d),
            Attenuation::Quadratic => (1.0 / (light.c1 + light.c2 * d + light.c3 * d * d)).min(1.0),
        };
        let flipped = scene.reflection.backfacing == Backfacing::Flip && p.dot(l) < 0.0;
        let n = if flipped { -p } else { p };
        let n_dot_l = n.dot(l);
        if n_dot_l <= 0.0 {
            continue;
        }
        let cosine = match scene.reflection.model {
            ReflectionModel::Phong => (2.0 * n_dot_l * n - l).dot(v),
            ReflectionModel::Blinn | ReflectionModel::CookTorrance => n.dot((l + v).normalize()),
        };
        sum += f * light.color * (m.kd * m.color * n_dot_l + m.ks * cosine.max(0.0).powf(m.n));
    }
    sum
}

/// Whether the equation has a step near `p`: a highlight that reaches beyond the terminator ends there at once, because a
/// light with N·L ≤ 0 contributes nothing, and any other normal moves the step.
fn steps(scene: &Scene, p: DVec3) -> bool {
    scene.lights.iter().any(|light| {
        let to_light = if light.kind == LightKind::Directional { -light.direction } else { light.position - p };
        p.dot(to_light.normalize()).abs() < 2e-4
    })
}

/// The greatest difference in code values over the pixels at least 1.5 pixels inside the outline, but for those that
/// `leave_out` names.
fn worst(renderer: &mut Renderer, scene: &Scene, leave_out: impl Fn(DVec3) -> bool) -> f64 {
    let frame = renderer.render(scene);
    let mut worst: f64 = 0.0;
    for y in 0..frame.height {
        for x in 0..frame.width {
            let Some((p, inside)) = meet(scene, x, y) else { continue };
            if inside < 1.5 || leave_out(p) {
                continue;
            }
            let stored = frame.pixel(x, y).expect("a pixel of the picture");
            let expected = textbook(scene, p);
            for channel in 0..3 {
                let code = expected[channel].clamp(0.0, 1.0) * 255.0;
                worst = worst.max((code - f64::from(stored[channel])).abs());
            }
        }
    }
    worst
}

#[test]
fn exact_shading_is_the_closed_form() {
    let mut dice = Dice(0x5eed_1971);
    let mut renderer = Renderer::default();
    for index in 0..20 {
        let n = 1000_f64.powf(f64::from(index) / 19.0);
        let mut scene = random_scene(&mut dice, n);
        scene.shading.mode = ShadingMode::Exact;
        let worst = worst(&mut renderer, &scene, |_| false);
        assert!(worst <= 1.0, "scene {index}: {worst} code values, {scene:?}");
    }
}

#[test]
fn phong_shading_of_a_fine_sphere_nears_the_closed_form() {
    let mut dice = Dice(0x5eed_1975);
    let mut renderer = Renderer::default();
    for index in 0..20 {
        let mut scene = random_scene(&mut dice, 1000_f64.powf(f64::from(index) / 19.0));
        scene.shading.mode = ShadingMode::Phong;
        scene.object.segments = 512;
        scene.object.rings = 256;
        scene.object.normals = NormalSource::Exact;
        let worst = worst(&mut renderer, &scene, |p| steps(&scene, p));
        assert!(worst <= 2.0, "scene {index}: {worst} code values, {scene:?}");
    }
}

/// The probe says what the picture shows, wherever the mode evaluates the equation.
#[test]
fn the_probe_adds_up_to_the_stored_pixel() {
    let mut dice = Dice(0x5eed_1997);
    let mut renderer = Renderer::default();
    let modes =
        [ShadingMode::Flat, ShadingMode::Interpolated, ShadingMode::Gouraud, ShadingMode::Phong, ShadingMode::Exact];
    let kinds = [ObjectKind::Sphere, ObjectKind::Torus, ObjectKind::Cylinder, ObjectKind::Cone, ObjectKind::Cube];
    for (index, kind) in kinds.into_iter().cycle().take(25).enumerate() {
        let mut scene = random_scene(&mut dice, 20.0);
        scene.object.kind = kind;
        scene.shading.mode = modes[index % modes.len()];
        let mut seen = 0;
        for _ in 0..200 {
            let (x, y) = ((dice.unit() * 256.0) as u32, (dice.unit() * 192.0) as u32);
            let Some(hit) = probe(&mut renderer, &scene, x, y).hit else { continue };
            seen += 1;
            let terms: DVec3 = hit.lights.iter().map(|light| light.diffuse + light.specular).sum();
            assert!((hit.ambient + terms - hit.sum).abs().max_element() < 1e-9, "terms do not add up");
            for channel in 0..3 {
                let code = hit.sum[channel].clamp(0.0, 1.0) * 255.0;
                let off = (code - f64::from(hit.stored[channel])).abs();
                assert!(
                    off <= 1.0,
                    "{kind:?} {:?} pixel {x},{y}: {code} stored as {}",
                    scene.shading.mode,
                    hit.stored[channel]
                );
            }
        }
        assert!(seen >= 5, "the object is in the picture");
    }
}
