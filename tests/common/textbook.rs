//! The textbooks' equation, independent of the program, in double precision, for the unit sphere.

use super::dice;

use glam::{DVec2, DVec3};
use shading_lab::illumination::area_samples;
use shading_lab::scene::{
    AreaShape, Attenuation, Backfacing, Camera, Choice, Distribution, Image, Light, LightKind,
    Material, ObjectKind, PatternKind, Projection, Reflectance, ReflectionModel, Scene, Viewer,
};
use std::f64::consts::PI;

pub use dice::Dice;

impl Dice {
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(
                self.between(-1.0, 1.0),
                self.between(-1.0, 1.0),
                self.between(-1.0, 1.0),
            );
            if (0.1..=1.0).contains(&v.length()) {
                return v.normalize();
            }
        }
    }

    pub fn colour(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }
}

pub fn random_light(dice: &mut Dice) -> Light {
    let position = dice.direction() * dice.between(1.6, 6.0);
    Light {
        kind: dice.of(LightKind::VALUES),
        position,
        // Towards the sphere, so that cones meet it.
        direction: (dice.direction() * 0.5 - position.normalize()) * dice.between(0.1, 10.0),
        color: dice.colour(),
        cone: dice.between(8.0, 60.0),
        exponent: dice.between(0.0, 60.0),
        softness: dice.between(0.2, 1.0),
        shape: dice.of(AreaShape::VALUES),
        extent: [dice.between(0.1, 1.0), dice.between(0.1, 1.0)],
        radius: dice.between(0.05, 0.5),
        samples: dice.of(&[1, 2, 5, 16]),
        attenuation: dice.of(Attenuation::VALUES),
        k: dice.between(0.0, 2.0),
        c1: dice.between(0.1, 1.0),
        c2: dice.between(0.0, 0.5),
        c3: dice.between(0.0, 0.5),
        ..Light::default()
    }
}

pub fn random_scene(dice: &mut Dice, n: f64) -> Scene {
    let camera = Camera {
        eye: dice.direction() * dice.between(2.5, 6.0),
        up: dice.direction(),
        projection: if dice.unit() < 0.7 {
            Projection::Perspective
        } else {
            Projection::Orthographic
        },
        fov_y: 45.0,
        viewer: if dice.unit() < 0.5 {
            Viewer::Local
        } else {
            Viewer::Infinite
        },
        ..Camera::default()
    };
    let mut scene = Scene {
        camera,
        ..Scene::default()
    };
    scene.image = Image {
        size: [256, 192],
        background: DVec3::ZERO,
    };
    scene.object.kind = ObjectKind::Sphere;
    scene.material = Material {
        ka: dice.colour() * 0.3,
        kd: dice.colour(),
        ks: dice.colour(),
        n,
        roughness: dice.between(0.1, 1.0),
        color: dice.colour(),
        specular_color: dice.colour(),
        reflectance: dice.of(&[
            Reflectance::Constant,
            Reflectance::Constant,
            Reflectance::Glass,
            Reflectance::Gold,
            Reflectance::Silver,
            Reflectance::Custom,
        ]),
        ior: dice.colour() * 3.0 + 0.05,
        extinction: dice.colour() * 5.0,
        source: shading_lab::scene::MaterialSource::Model,
    };
    scene.pattern.kind = dice.of(&[
        PatternKind::None,
        PatternKind::None,
        PatternKind::Checker,
        PatternKind::Rings,
    ]);
    scene.pattern.color = dice.colour();
    scene.ambient.color = dice.colour();
    scene.reflection.model = dice.of(&[
        ReflectionModel::Phong,
        ReflectionModel::Phong,
        ReflectionModel::Blinn,
        ReflectionModel::CookTorrance,
    ]);
    scene.reflection.distribution = dice.of(Distribution::VALUES);
    scene.reflection.backfacing = if dice.unit() < 0.7 {
        Backfacing::Clamp
    } else {
        Backfacing::Flip
    };
    scene.lights = (0..1 + (dice.unit() * 4.0) as usize)
        .map(|_| random_light(dice))
        .collect();
    scene
}

/// Returns the point and normal of the unit sphere at the centre of a pixel, and the pixel's distance from the outline, in
/// pixels.
pub fn meet(scene: &Scene, x: u32, y: u32) -> Option<(DVec3, f64)> {
    let camera = &scene.camera;
    let [width, height] = scene.image.size.map(f64::from);
    let forward = (camera.target - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    let up = right.cross(forward);
    let (px, py) = (
        f64::from(x) + 0.5 - width / 2.0,
        height / 2.0 - f64::from(y) - 0.5,
    );
    let distance = camera.eye.length();
    let (origin, direction, radius) = if camera.projection == Projection::Perspective {
        let focal = camera.span([width, height]) / 2.0 / (camera.fov_y.to_radians() / 2.0).tan();
        (
            camera.eye,
            (forward * focal + right * px + up * py).normalize(),
            focal / (distance * distance - 1.0).sqrt(),
        )
    } else {
        let pixels = camera.span([width, height]) / camera.height;
        (
            camera.eye + (right * px + up * py) / pixels,
            forward,
            pixels,
        )
    };
    let b = origin.dot(direction);
    let discriminant = b * b - (origin.length_squared() - 1.0);
    if discriminant < 0.0 {
        return None;
    }
    Some((
        origin + direction * (-b - discriminant.sqrt()),
        radius - px.hypot(py),
    ))
}

/// Evaluates the equation of the unit sphere at `p`.
pub fn textbook(scene: &Scene, p: DVec3) -> DVec3 {
    textbook_at(scene, p, p)
}

/// Evaluates the equation at `p` of a surface with normal `n`.
pub fn textbook_at(scene: &Scene, p: DVec3, n: DVec3) -> DVec3 {
    let m = &scene.material;
    let od = surface_colour(scene, p);
    let mut sum = m.ka * od * scene.ambient.color;
    for light in &scene.lights {
        if light.kind == LightKind::Area {
            let points = area_samples(light);
            for position in &points {
                let sample = Light {
                    kind: LightKind::Point,
                    position: *position,
                    color: light.color / points.len() as f64,
                    ..light.clone()
                };
                sum += from_light(scene, &sample, [p, n], od);
            }
        } else {
            sum += from_light(scene, light, [p, n], od);
        }
    }
    sum
}

fn surface_colour(scene: &Scene, p: DVec3) -> DVec3 {
    let cell = |x: f64| (x / scene.pattern.scale).round() as i64;
    let odd = match scene.pattern.kind {
        PatternKind::None => false,
        PatternKind::Checker => (cell(p.x) + cell(p.y) + cell(p.z)).rem_euclid(2) == 1,
        PatternKind::Stripes => cell(p.y).rem_euclid(2) == 1,
        PatternKind::Rings => cell(p.x.hypot(p.z)).rem_euclid(2) == 1,
    };
    if odd {
        scene.pattern.color
    } else {
        scene.material.color
    }
}

fn from_light(scene: &Scene, light: &Light, [p, n]: [DVec3; 2], od: DVec3) -> DVec3 {
    let (m, camera) = (&scene.material, &scene.camera);
    let to_eye = camera.eye - p;
    let v = if camera.viewer == Viewer::Local {
        to_eye.normalize()
    } else {
        (camera.eye - camera.target).normalize()
    };
    let directional = light.kind == LightKind::Directional;
    let d = (light.position - p).length();
    let l = if directional {
        -light.direction.normalize()
    } else {
        (light.position - p) / d
    };
    let f = match light.attenuation {
        Attenuation::Viewer => 1.0 / (to_eye.length() + light.k),
        _ if directional => 1.0,
        Attenuation::None => 1.0,
        Attenuation::Light => 1.0 / (d + light.k),
        Attenuation::InverseSquare => 1.0 / (d * d),
        Attenuation::Quadratic => (1.0 / (light.c1 + light.c2 * d + light.c3 * d * d)).min(1.0),
    };
    let spot = if light.kind == LightKind::Spot {
        spot_part(light, -l)
    } else {
        1.0
    };
    let flipped = scene.reflection.backfacing == Backfacing::Flip && n.dot(l) < 0.0;
    let n = if flipped { -n } else { n };
    let n_dot_l = n.dot(l);
    if n_dot_l <= 0.0 {
        return DVec3::ZERO;
    }
    let (s, cosine) = specular(scene, n, l, v);
    f * spot
        * light.color
        * (m.kd * od * n_dot_l + m.ks * m.specular_color * fresnel(m, cosine) * s)
}

/// Returns the fraction of a spot light's intensity in the direction `ray`.
pub fn spot_part(light: &Light, ray: DVec3) -> f64 {
    let axis = light.direction.normalize();
    let cosine = ray.dot(axis);
    let (outer, inner) = (
        light.cone.to_radians().cos(),
        (light.cone * (1.0 - light.softness)).to_radians().cos(),
    );
    if cosine <= outer {
        return 0.0;
    }
    let t = if inner > outer {
        ((cosine - outer) / (inner - outer)).min(1.0)
    } else {
        1.0
    };
    cosine.max(0.0).powf(light.exponent) * t * t * (3.0 - 2.0 * t)
}

/// Returns S, and the cosine of the angle of incidence that W depends on.
fn specular(scene: &Scene, n: DVec3, l: DVec3, v: DVec3) -> (f64, f64) {
    let m = &scene.material;
    let h = (l + v).normalize();
    match scene.reflection.model {
        ReflectionModel::Phong => ((2.0 * n.dot(l) * n - l).dot(v).max(0.0).powf(m.n), n.dot(l)),
        ReflectionModel::Blinn => (n.dot(h).max(0.0).powf(m.n), l.dot(h)),
        // Whoever compares by this says what the law is.
        ReflectionModel::Formula => (0.0, n.dot(l)),
        ReflectionModel::CookTorrance => (
            cook_torrance(scene.reflection.distribution, m.roughness, n, l, v),
            l.dot(h),
        ),
    }
}

/// Returns `π·D·G/(4·(N·V))`.
pub fn cook_torrance(distribution: Distribution, m: f64, n: DVec3, l: DVec3, v: DVec3) -> f64 {
    let h = (l + v).normalize();
    let alpha = n.dot(h).clamp(-1.0, 1.0).acos();
    let (nl, nv, nh, vh) = (n.dot(l), n.dot(v).max(1e-4), n.dot(h), v.dot(h));
    if nh <= 0.0 {
        return 0.0;
    }
    let (d, g) = match distribution {
        Distribution::Beckmann => {
            let d = (-(alpha.tan() / m).powi(2)).exp() / (PI * m * m * alpha.cos().powi(4));
            (d, (2.0 * nh * nv / vh).min(2.0 * nh * nl / vh).min(1.0))
        }
        Distribution::Ggx => {
            let d = m * m / (PI * alpha.cos().powi(4) * (m * m + alpha.tan().powi(2)).powi(2));
            let g1 = |c: f64| 2.0 / (1.0 + (1.0 + m * m * (1.0 / (c * c) - 1.0)).sqrt());
            (d, g1(nl.max(1e-4)) * g1(nv))
        }
    };
    let fading = (1.0 + 4.0 * n.dot(v)).clamp(0.0, 1.0);
    PI * d * g * fading / (4.0 * nv)
}

/// Returns W per channel, from the complex amplitudes of Fresnel's formulas.
pub fn fresnel(m: &Material, cosine: f64) -> DVec3 {
    let (eta, k) = match m.reflectance {
        Reflectance::Constant => return DVec3::ONE,
        Reflectance::Glass => (DVec3::new(1.514_32, 1.518_72, 1.526_68), DVec3::ZERO),
        Reflectance::Silver => (
            DVec3::new(0.05, 0.06, 0.04),
            DVec3::new(4.483, 3.586, 2.657),
        ),
        Reflectance::Gold => (
            DVec3::new(0.14, 0.43, 1.38),
            DVec3::new(3.697, 2.455, 1.914),
        ),
        Reflectance::Custom => (m.ior, m.extinction),
    };
    DVec3::from_array([0, 1, 2].map(|c| amplitude_reflectance(eta[c], k[c], cosine)))
}

/// Returns the reflectance of unpolarised light at a surface of index η + ik.
pub fn amplitude_reflectance(eta: f64, k: f64, cosine: f64) -> f64 {
    type Complex = DVec2;
    let times = |a: Complex, b: Complex| Complex::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
    let over = |a: Complex, b: Complex| times(a, Complex::new(b.x, -b.y)) / b.length_squared();
    let root = |a: Complex| {
        let x = (0.5 * (a.length() + a.x)).max(0.0).sqrt();
        Complex::new(x, (0.5 * (a.length() - a.x)).max(0.0).sqrt().copysign(a.y))
    };
    let index = Complex::new(eta, k);
    let sine_squared = Complex::new(1.0 - cosine * cosine, 0.0);
    // n·cos θ₂ = √(n² − sin² θ₁).
    let inside = root(times(index, index) - sine_squared);
    let c = Complex::new(cosine, 0.0);
    let perpendicular = over(c - inside, c + inside);
    let square = times(index, index);
    let parallel = over(times(square, c) - inside, times(square, c) + inside);
    0.5 * (perpendicular.length_squared() + parallel.length_squared())
}

/// Returns whether the equation has a step near `p`, where a slightly different normal or rounding changes the value: the
/// terminator, at which a highlight that reaches beyond it ends abruptly, or the edge between two fields of a pattern.
pub fn steps(scene: &Scene, p: DVec3, near: f64) -> bool {
    let terminator = scene.lights.iter().any(|light| {
        let towards = |place: DVec3| p.dot((place - p).normalize()).abs() < near;
        match light.kind {
            LightKind::Directional => p.dot(light.direction.normalize()).abs() < near,
            LightKind::Area => area_samples(light).into_iter().any(towards),
            LightKind::Point | LightKind::Spot => towards(light.position),
        }
    });
    terminator || field_edge(scene, p, near)
}

/// Returns whether `p` is within `near` world units of an edge of the pattern.
pub fn field_edge(scene: &Scene, p: DVec3, near: f64) -> bool {
    let edge = |x: f64| {
        ((x / scene.pattern.scale - 0.5).rem_euclid(1.0) - 0.5).abs()
            > 0.5 - near / scene.pattern.scale
    };
    match scene.pattern.kind {
        PatternKind::None => false,
        PatternKind::Checker => edge(p.x) || edge(p.y) || edge(p.z),
        PatternKind::Stripes => edge(p.y),
        PatternKind::Rings => edge(p.x.hypot(p.z)),
    }
}
