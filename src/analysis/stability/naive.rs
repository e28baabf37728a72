//! The naive renderer: a first renderer that follows the textbook line by line, in single precision: one matrix, a
//! division by w without clipping, edge functions, normals divided by their length, the power of the cosine, and the
//! intensity times 255 cast to a byte. No line of it is wrong on an ordinary scene, where it agrees with the reference
//! to about a code value.

use crate::illumination::{Incidence, LawOperations, LawSite, V3};
use crate::scene::{
    Attenuation, Light, LightKind, NormalSource, ObjectKind, Projection, ReflectionModel, Scene,
    ShadingMode, Viewer,
};
use glam::{Vec2, Vec3, Vec4};

/// Near and far plane of the depths that are kept, camera distances.
const NEAR: f32 = 1e-3;
const FAR: f32 = 1e3;

/// Draws polygons or, in exact mode, the sphere: linear intensities from the top, which may be infinite or NaN.
pub fn draw(scene: &Scene) -> Vec<[f32; 3]> {
    let [width, height] = scene.image.size;
    let background = scene.image.background.as_vec3().to_array();
    let mut pixels = vec![background; width as usize * height as usize];
    let camera = Camera::new(scene);
    let shaded = Shaded::new(scene);
    if scene.object.kind == ObjectKind::Sphere {
        for (index, pixel) in pixels.iter_mut().enumerate() {
            let place = Vec2::new(
                (index as u32 % width) as f32 + 0.5,
                (index as u32 / width) as f32 + 0.5,
            );
            let (origin, direction) = camera.ray(place);
            if let Some(point) = sphere(origin, direction) {
                *pixel = illuminate(&shaded, &camera, point, point);
            }
        }
        return pixels;
    }
    let mut depths = vec![1.0_f32; pixels.len()];
    for triangle in triangles(scene) {
        fill(&shaded, &camera, &triangle, &mut pixels, &mut depths);
    }
    pixels
}

/// A scene, with the law of its own if it has one.
struct Shaded<'a> {
    scene: &'a Scene,
    law: Option<LawOperations>,
}

impl<'a> Shaded<'a> {
    fn new(scene: &'a Scene) -> Self {
        let law = LawOperations::of_model(scene);
        Self { scene, law }
    }
}

struct Camera {
    eye: Vec3,
    forward: Vec3,
    right: Vec3,
    up: Vec3,
    /// World to clip coordinates, row by row.
    matrix: [Vec4; 4],
    size: Vec2,
    /// Pixels per unit of the picture's plane.
    scale: f32,
    perspective: bool,
}

impl Camera {
    fn new(scene: &Scene) -> Self {
        let camera = &scene.camera;
        let [width, height] = scene.image.size;
        let size = Vec2::new(width as f32, height as f32);
        let (eye, target, up) = (
            camera.eye.as_vec3(),
            camera.target.as_vec3(),
            camera.up.as_vec3(),
        );
        let distance = (target - eye).length();
        let (near, far) = (NEAR * distance, FAR * distance);
        let perspective = camera.projection == Projection::Perspective;
        let forward = (target - eye) / distance;
        let right = forward.cross(up) / length(forward.cross(up));
        let up = right.cross(forward);
        let row = |axis: Vec3| axis.extend(-axis.dot(eye));
        let [x, y, z] = [row(right), row(up), row(-forward)];
        let span = camera.span([f64::from(width), f64::from(height)]) as f32;
        let (across, upwards) = (span / size.x, span / size.y);
        let (matrix, scale) = if perspective {
            let cotangent = 1.0 / ((camera.fov_y as f32).to_radians() / 2.0).tan();
            let (a, b) = ((far + near) / (near - far), 2.0 * far * near / (near - far));
            (
                [
                    x * (cotangent * across),
                    y * (cotangent * upwards),
                    z * a + Vec4::W * b,
                    -z,
                ],
                span * cotangent / 2.0,
            )
        } else {
            let half = camera.height as f32 / 2.0;
            let (a, b) = (2.0 / (near - far), (far + near) / (near - far));
            (
                [
                    x * (across / half),
                    y * (upwards / half),
                    z * a + Vec4::W * b,
                    Vec4::W,
                ],
                span / camera.height as f32,
            )
        };
        Self {
            eye,
            forward,
            right,
            up,
            matrix,
            size,
            scale,
            perspective,
        }
    }

    fn ray(&self, place: Vec2) -> (Vec3, Vec3) {
        let across = (place - self.size / 2.0) / self.scale;
        let across = self.right * across.x - self.up * across.y;
        if self.perspective {
            (self.eye, self.forward + across)
        } else {
            (self.eye + across, self.forward)
        }
    }
}

fn length(v: Vec3) -> f32 {
    v.dot(v).sqrt()
}

fn unit(v: Vec3) -> Vec3 {
    v / length(v)
}

/// A corner of a polygon, world.
#[derive(Clone, Copy)]
struct NaiveVertex {
    position: Vec3,
    normal: Vec3,
}

fn triangles(scene: &Scene) -> Vec<[NaiveVertex; 3]> {
    let polygons = scene.object.polygons();
    let at = |v: u32| polygons.vertices[v as usize].as_vec3();
    let own = |face: &[u32]| unit((at(face[1]) - at(face[0])).cross(at(face[2]) - at(face[0])));
    let normal = |face: &[u32], v: u32| {
        if scene.shading.mode == ShadingMode::Flat || scene.object.normals == NormalSource::Facet {
            own(face)
        } else if scene.object.normals == NormalSource::File && !polygons.normals.is_empty() {
            unit(polygons.normals[v as usize].as_vec3())
        } else {
            unit(
                polygons
                    .faces
                    .iter()
                    .filter(|face| face.contains(&v))
                    .map(|face| own(face))
                    .sum(),
            )
        }
    };
    let corner = |face: &[u32], v: u32| NaiveVertex {
        position: at(v),
        normal: normal(face, v),
    };
    let fan = |face: &[u32]| -> Vec<[NaiveVertex; 3]> {
        let corners: Vec<NaiveVertex> = face.iter().map(|&v| corner(face, v)).collect();
        corners[1..]
            .windows(2)
            .map(|pair| [corners[0], pair[0], pair[1]])
            .collect()
    };
    polygons.faces.iter().flat_map(|face| fan(face)).collect()
}

fn fill(
    shaded: &Shaded<'_>,
    camera: &Camera,
    corners: &[NaiveVertex; 3],
    pixels: &mut [[f32; 3]],
    depths: &mut [f32],
) {
    let clip: [Vec4; 3] = corners.map(|corner| {
        let p = corner.position.extend(1.0);
        Vec4::from_array(camera.matrix.map(|row| row.dot(p)))
    });
    let device = clip.map(|p| p.truncate() / p.w);
    let at = device.map(|p| {
        Vec2::new(
            (p.x + 1.0) / 2.0 * camera.size.x,
            (1.0 - p.y) / 2.0 * camera.size.y,
        )
    });
    let area = (at[1] - at[0]).perp_dot(at[2] - at[0]);
    let bounds = |axis: usize| {
        let values = at.map(|p| p[axis]);
        let (min, max) = (
            values[0].min(values[1]).min(values[2]),
            values[0].max(values[1]).max(values[2]),
        );
        let last = camera.size[axis] as i64;
        (
            (min.floor() as i64).clamp(0, last),
            (max.ceil() as i64).clamp(0, last),
        )
    };
    let ((x0, x1), (y0, y1)) = (bounds(0), bounds(1));
    for (y, x) in (y0..y1).flat_map(|y| (x0..x1).map(move |x| (y, x))) {
        let place = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
        let weight = |k: usize| (at[(k + 1) % 3] - place).perp_dot(at[(k + 2) % 3] - place) / area;
        let weights = [weight(0), weight(1), weight(2)];
        // A weight that is NaN is not below 0.
        if weights.iter().any(|w| *w < 0.0) {
            continue;
        }
        let index = y as usize * camera.size.x as usize + x as usize;
        let depth = weights
            .iter()
            .zip(device)
            .map(|(w, p)| w * p.z)
            .sum::<f32>();
        if depth > depths[index] {
            continue;
        }
        depths[index] = depth;
        let over_w = [0, 1, 2].map(|k| weights[k] / clip[k].w);
        let sum: f32 = over_w.iter().sum();
        let mix = |of: fn(&NaiveVertex) -> Vec3| {
            over_w
                .iter()
                .zip(corners)
                .map(|(w, c)| of(c) * *w)
                .sum::<Vec3>()
                / sum
        };
        let position = mix(|corner| corner.position);
        pixels[index] = illuminate(shaded, camera, position, mix(|corner| corner.normal));
    }
}

/// Returns the nearest point of the unit sphere about the origin, by the quadratic formula of school.
fn sphere(origin: Vec3, direction: Vec3) -> Option<Vec3> {
    let (a, b, c) = (
        direction.dot(direction),
        2.0 * origin.dot(direction),
        origin.dot(origin) - 1.0,
    );
    let root = (b * b - 4.0 * a * c).sqrt();
    let t = (-b - root) / (2.0 * a);
    (t > 0.0).then(|| origin + direction * t)
}

/// Evaluates the equation at a point, N of any length.
fn illuminate(shaded: &Shaded<'_>, camera: &Camera, point: Vec3, normal: Vec3) -> [f32; 3] {
    let Shaded { scene, law } = shaded;
    let material = &scene.material;
    let n = unit(normal);
    let v = if scene.camera.viewer == Viewer::Infinite {
        -camera.forward
    } else {
        unit(camera.eye - point)
    };
    let mut sum = (material.ka * material.color * scene.ambient.color).as_vec3();
    let (diffuse, specular) = (
        (material.kd * material.color).as_vec3(),
        material.ks.as_vec3(),
    );
    for light in &scene.lights {
        let to_light = light.position.as_vec3() - point;
        let l = if light.kind == LightKind::Directional {
            -unit(light.direction.as_vec3())
        } else {
            unit(to_light)
        };
        let d = length(to_light);
        let f = attenuation(light, d) * spot(light, l);
        if let Some(law) = law {
            sum += light.color.as_vec3() * f * typed(law, n, v, (l, d));
            continue;
        }
        let reflected = factor(scene, n, l, v);
        sum += light.color.as_vec3() * f * (diffuse * positive(n.dot(l)) + specular * reflected);
    }
    sum.to_array()
}

/// Returns `max(x, 0)` by a comparison, which keeps NaN.
fn positive(x: f32) -> f32 {
    if x < 0.0 { 0.0 } else { x }
}

fn attenuation(light: &Light, d: f32) -> f32 {
    let of = |v: f64| v as f32;
    match light.attenuation {
        Attenuation::None | Attenuation::Viewer => 1.0,
        Attenuation::Light => 1.0 / (d + of(light.k)),
        Attenuation::InverseSquare => 1.0 / (d * d),
        Attenuation::Quadratic => {
            (1.0 / (of(light.c1) + of(light.c2) * d + of(light.c3) * d * d)).min(1.0)
        }
    }
}

fn spot(light: &Light, l: Vec3) -> f32 {
    if light.kind != LightKind::Spot {
        return 1.0;
    }
    let cosine = -l.dot(unit(light.direction.as_vec3()));
    if cosine < (light.cone as f32).to_radians().cos() {
        0.0
    } else {
        cosine.powf(light.exponent as f32)
    }
}

/// Returns the factors of the scene's own law, as typed.
fn typed(law: &LawOperations, n: Vec3, v: Vec3, (l, distance): (Vec3, f32)) -> Vec3 {
    let vector = |v: Vec3| V3::new(v.x, v.y, v.z);
    let site = LawSite {
        normal: vector(n),
        view: vector(v),
        color: None,
        incidence: Incidence {
            l: vector(l),
            distance,
            grazing: 0.0,
        },
    };
    Vec3::from_array(law.factors_at(&site))
}

/// Returns S, whether or not the surface faces the light.
fn factor(scene: &Scene, n: Vec3, l: Vec3, v: Vec3) -> f32 {
    let exponent = scene.material.n as f32;
    let power = |c: f32| if c > 0.0 { c.powf(exponent) } else { 0.0 };
    match scene.reflection.model {
        ReflectionModel::Phong => power((2.0 * n.dot(l) * n - l).dot(v)),
        ReflectionModel::Blinn => power(n.dot(unit(l + v))),
        ReflectionModel::CookTorrance => {
            let h = unit(l + v);
            let (m, angle) = (scene.material.roughness as f32, n.dot(h).acos());
            let spread = (-(angle.tan() / m).powi(2)).exp() / (m * m * angle.cos().powi(4));
            let of = |cosine: f32| 2.0 * n.dot(h) * cosine / v.dot(h);
            let masking = 1.0_f32.min(of(n.dot(v))).min(of(n.dot(l)));
            spread * masking / (4.0 * n.dot(v))
        }
        // Its own law stands for both terms.
        ReflectionModel::Formula => 0.0,
    }
}
