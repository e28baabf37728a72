//! The catalogue of stiff and extreme cases, each a scene that the naive renderer, the engine and the reference all
//! draw. Their titles and explanations are in the catalogue of text, keyed by their names.

use super::precise::{Precise, precise};
use super::reference::Truth;
use super::{Case, Pictures, Topic, case, engine_picture};
use crate::illumination::{critical_angle, refract};
use crate::render::Renderer;
use crate::scene::{
    Attenuation, Interpolation, Light, LightKind, NormalSource, ObjectKind, Projection,
    ReflectionModel, Rgb, Scene, ShadingMode, Shared, Viewer,
};
use Topic::{Cosines, Geometry, Highlight, Lights, Vectors};
use glam::{DVec3, Vec2};

/// Side of the pictures, pixels: odd, so that one pixel's centre is the picture's.
pub const SIDE: u32 = 129;

/// All cases, by topic.
pub const CASES: &[Case] = &[
    case("exponent-0", Highlight).draws(square).with(|scene| {
        scene.material.n = 0.0;
        scene.lights = vec![lamp(0.3, 0.1, 0.1)];
    }),
    case("exponent-1e4", Highlight)
        .condition(1e4, "engine-condition-power")
        .draws(|| lobe(1e4)),
    case("exponent-1e6", Highlight)
        .condition(1e6, "engine-condition-power")
        .draws(|| lobe(1e6)),
    case("exponent-1e9", Highlight)
        .condition(1e9, "engine-condition-power")
        .draws(|| lobe(1e9)),
    case("exponent-1e12", Highlight)
        .condition(1e12, "engine-condition-power")
        .draws(|| lobe(1e12)),
    case("exponent-infinite", Highlight)
        .draws(square)
        .with(|scene| {
            (scene.camera.eye, scene.camera.viewer) =
                (DVec3::new(-1.1, 0.9, 2.3), Viewer::Infinite);
            let direction = DVec3::new(-1.1, 0.9, -2.3);
            scene.lights = vec![Light {
                kind: LightKind::Directional,
                direction,
                ..Light::default()
            }];
            scene.material.n = f64::INFINITY;
        }),
    case("microfacets", Highlight)
        .condition(1e6, "engine-condition-beckmann")
        .draws(|| lobe(1e6))
        .with(|scene| {
            scene.reflection.model = ReflectionModel::CookTorrance;
            scene.material.roughness = 1e-3;
            // The peak is proportional to 1/m².
            scene.lights[0].color = Rgb::splat(5e-6);
        }),
    case("light-in-the-plane", Cosines).draws(|| {
        // In the plane x + y + z = 0, all coordinates exact.
        let at = |s: f64, t: f64| [s + 0.5 * t, 0.5 * t - s, -t];
        let corners = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
        let mut scene = polygons(&corners, &[&[0, 1, 2, 3]]);
        let light = DVec3::from_array(at(0.25, 3.0));
        (scene.camera.eye, scene.camera.up) = (DVec3::from_array(at(0.0, -3.0)) + 0.75, DVec3::ONE);
        (scene.material.n, scene.material.ks) = (6.0, Rgb::splat(0.8));
        scene.lights = vec![Light {
            position: light,
            ..Light::default()
        }];
        scene
    }),
    case("light-inside", Cosines).draws(sphere).with(|scene| {
        (scene.material.n, scene.material.ks) = (5.0, Rgb::splat(0.6));
        scene.lights = vec![lamp(0.88, 0.3, 0.12)];
    }),
    case("opposed-normals", Vectors)
        .draws(|| with_normals(|x, _| DVec3::new(x, 0.0, 0.0)))
        .with(|scene| scene.lights = vec![lamp(2.0, 0.0, 1.0)]),
    case("huge-normals", Vectors).draws(|| with_normals(|x, y| DVec3::new(x, y, 1.2) * 1e25)),
    case("denormal-normals", Vectors).draws(|| with_normals(|x, y| DVec3::new(x, y, 1.2) * 1e-30)),
    case("light-on-the-surface", Lights)
        .draws(square)
        .with(|scene| {
            scene.lights = vec![
                lamp(0.0, 0.0, 0.0),
                Light {
                    color: Rgb::splat(0.5),
                    ..lamp(1.0, 2.0, 3.0)
                },
            ];
        }),
    case("attenuation-0", Lights)
        .condition(2.0, "engine-condition-attenuation")
        .draws(corner)
        .with(|scene| {
            let color = Rgb::splat(0.3);
            scene.lights = vec![Light {
                color,
                attenuation: Attenuation::InverseSquare,
                ..lamp(0.0, 0.0, 0.0)
            }];
        }),
    case("light-at-1e30", Lights)
        .draws(square)
        .with(|scene| scene.lights = vec![lamp(0.5e30, 0.25e30, 1e30)]),
    case("narrow-cone", Lights)
        .condition(6.6e5, "engine-condition-cone")
        .draws(square)
        .with(|scene| {
            scene.camera.eye = DVec3::new(0.0, 0.0, 0.02);
            let (position, direction) = (DVec3::new(0.25, 0.5, 3.0), DVec3::new(-0.25, -0.5, -3.0));
            let (kind, cone, exponent) = (LightKind::Spot, 0.1, 0.0);
            scene.lights = vec![Light {
                kind,
                cone,
                exponent,
                position,
                direction,
                ..Light::default()
            }];
        }),
    case("a-million-lights", Lights)
        .draws(near)
        .with(|scene| scene.lights[0].color = Rgb::splat(1e6)),
    case("overflow", Lights).draws(near).with(|scene| {
        scene.material.color = Rgb::new(1.0, 0.0, 0.0);
        (scene.material.kd, scene.material.ks) = (Rgb::splat(1e6), Rgb::ZERO);
        scene.lights[0].color = Rgb::splat(1e30);
        scene.lights[0].attenuation = Attenuation::InverseSquare;
        scene.lights[0].position = DVec3::new(0.3, 0.2, 0.002);
    }),
    case("eye-on-the-surface", Geometry).draws(|| room(0.0, 6.0)),
    case("behind-the-eye", Geometry).draws(|| room(-0.7, 6.0)),
    case("w-0", Geometry).draws(|| room(-0.7, 2.0)),
    case("slivers", Geometry)
        .condition(1e8, "engine-condition-sliver")
        .draws(|| {
            // In the planes of the adjacent polygons.
            let (width, slope) = (1e-8, 0.25);
            let tip = |x: f64| [x * (0.875 + width), 0.0, -width * slope];
            let corners = [
                [-0.875, -0.75, 0.0],
                [0.0, -0.75, 0.875 * slope],
                [0.875, -0.75, 0.0],
                [0.875, 0.75, 0.0],
                [0.0, 0.75, 0.875 * slope],
                [-0.875, 0.75, 0.0],
                tip(-1.0),
                tip(1.0),
            ];
            polygons(
                &corners,
                &[&[0, 1, 4, 5], &[1, 2, 3, 4], &[0, 5, 6], &[3, 2, 7]],
            )
        }),
    case("scale-1e-15", Geometry).draws(|| scaled(1e-15)),
    case("scale-1e15", Geometry).draws(|| scaled(1e15)),
    case("far-from-the-origin", Geometry)
        .condition(1e7, "engine-condition-difference")
        .draws(pyramid)
        .with(|scene| {
            moved(scene, |v| v + DVec3::new(1.1e7, -0.7e7, 1.3e7));
        }),
    case("telephoto", Geometry)
        .condition(1e10, "engine-condition-discriminant")
        .draws(sphere)
        .with(|scene| {
            scene.camera.eye = DVec3::new(0.3, 0.4, 1.0) * 1e5;
            scene.camera.fov_y = 1.3e-3;
        }),
    case("depth-fighting", Geometry)
        .condition(1e5, "engine-condition-depths")
        .draws(|| {
            let gap = 4e-5;
            let at = |x: f64, y: f64, z: f64| [x, y, 0.3 * x + z];
            let one = |z: f64| {
                [
                    at(-1.0, -1.0, z),
                    at(1.0, -1.0, z),
                    at(1.0, 1.0, z),
                    at(-1.0, 1.0, z),
                ]
            };
            let mut scene = polygons(
                &[one(0.0), one(gap)].concat(),
                &[&[0, 1, 2, 3], &[4, 5, 6, 7]],
            );
            let (behind, before) = (DVec3::new(0.9, 0.0, 0.2), DVec3::new(-0.3, 0.0, 1.0));
            scene.object.vertex_normals = (0..8)
                .map(|v| if v < 4 { behind } else { before })
                .collect();
            scene.object.normals = NormalSource::File;
            scene.lights = vec![lamp(-2.0, 2.0, 3.0)];
            scene
        }),
    case("span-of-length-0", Geometry).pictures(scan_lines),
    case("critical-angle", Geometry)
        .condition(5e5, "engine-condition-refraction")
        .pictures(critical),
];

/// Returns a scene of one light and polygons that the eye sees from (0, 0, 4).
fn polygons(vertices: &[[f64; 3]], faces: &[&[u32]]) -> Scene {
    let mut scene = sphere();
    scene.object.kind = ObjectKind::Polygons;
    scene.object.vertices = vertices.iter().copied().map(DVec3::from_array).collect();
    scene.object.faces = faces
        .iter()
        .map(|face| face.iter().copied().collect::<Shared<u32>>())
        .collect();
    scene.shading.mode = ShadingMode::Phong;
    scene
}

/// Returns the unit sphere itself, of a material that makes nothing brighter than the display's white.
fn sphere() -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [SIDE; 2];
    scene.image.background = Rgb::splat(0.12);
    scene.shading.mode = ShadingMode::Exact;
    let material = &mut scene.material;
    (material.ka, material.kd, material.ks) = (Rgb::splat(0.1), Rgb::splat(0.5), Rgb::splat(0.4));
    (material.color, material.n) = (Rgb::new(0.95, 0.6, 0.25), 32.0);
    scene
}

/// Returns the square −1 ≤ x, y ≤ 1 in the plane z = 0, facing the eye.
fn square() -> Scene {
    polygons(
        &[
            [-1.0, -1.0, 0.0],
            [1.0, -1.0, 0.0],
            [1.0, 1.0, 0.0],
            [-1.0, 1.0, 0.0],
        ],
        &[&[0, 1, 2, 3]],
    )
}

/// Returns a point light.
fn lamp(x: f64, y: f64, z: f64) -> Light {
    Light {
        position: DVec3::new(x, y, z),
        ..Light::default()
    }
}

/// Returns a plane seen where the lobe is, which is about half as high as the picture whatever `n`.
fn lobe(n: f64) -> Scene {
    let mut scene = square();
    scene.material.n = n;
    // The light is mirrored at the origin.
    scene.camera.eye = DVec3::new(-1.0, 0.0, 1.0);
    scene.camera.fov_y = (340.0 / n.sqrt()).clamp(1e-3, 30.0);
    scene.lights = vec![lamp(1.0, 0.0, 1.0)];
    scene
}

/// Returns the square with a vertex normal at each corner, given as a function of x and y.
fn with_normals(normal: fn(f64, f64) -> DVec3) -> Scene {
    let mut scene = square();
    let vertices = scene.object.vertices.iter();
    scene.object.vertex_normals = vertices.map(|v| normal(v.x, v.y)).collect();
    scene.object.normals = NormalSource::File;
    scene
}

/// Returns the square with a light near it.
fn near() -> Scene {
    let mut scene = square();
    scene.lights = vec![lamp(0.4, 0.3, 0.7)];
    scene
}

/// Returns a floor and a wall at right angles, seen so that the picture's centre shows the origin, on the floor.
fn corner() -> Scene {
    let floor = [
        [-1.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 0.0, -0.5],
        [-1.0, 0.0, -0.5],
    ];
    let wall = [
        [-1.0, 0.0, -0.5],
        [1.0, 0.0, -0.5],
        [1.0, 1.25, -0.5],
        [-1.0, 1.25, -0.5],
    ];
    let mut scene = polygons(&[floor, wall].concat(), &[&[0, 1, 2, 3], &[4, 5, 6, 7]]);
    scene.camera.eye = DVec3::new(0.0, 2.0, 3.5);
    scene
}

/// Returns a wall at z = −3 before an eye at (0, 0, 2), and a floor at height `floor` from z = −3 to `to`.
fn room(floor: f64, to: f64) -> Scene {
    let wall = [
        [-1.5, -0.7, -3.0],
        [1.5, -0.7, -3.0],
        [1.5, 1.2, -3.0],
        [-1.5, 1.2, -3.0],
    ];
    let floor = [
        [-1.5, floor, to],
        [1.5, floor, to],
        [1.5, floor, -3.0],
        [-1.5, floor, -3.0],
    ];
    let mut scene = polygons(&[wall, floor].concat(), &[&[0, 1, 2, 3], &[4, 5, 6, 7]]);
    (scene.camera.eye, scene.camera.target) = (DVec3::new(0.0, 0.0, 2.0), DVec3::NEG_Z);
    scene.lights = vec![lamp(0.8, 1.0, 0.5)];
    scene
}

/// Returns a pyramid over a square, its apex towards the eye.
fn pyramid() -> Scene {
    let corners = [
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
        [0.1, 0.2, 0.9],
    ];
    let mut scene = polygons(&corners, &[&[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]]);
    scene.object.normals = NormalSource::Facet;
    scene
}

fn moved(scene: &mut Scene, to: impl Fn(DVec3) -> DVec3) {
    scene.object.vertices = scene.object.vertices.iter().map(|v| to(*v)).collect();
    (scene.camera.eye, scene.camera.target) = (to(scene.camera.eye), to(scene.camera.target));
    for light in &mut scene.lights {
        light.position = to(light.position);
    }
}

fn scaled(factor: f64) -> Scene {
    let mut scene = pyramid();
    moved(&mut scene, |v| v * factor);
    scene
}

/// Corners of the polygon in pixels, all at centres of pixels, with their intensities.
const CORNERS: [([f64; 2], f64); 6] = [
    ([64.5, 10.5], 0.1),
    ([20.5, 60.5], 0.9),
    ([40.5, 110.5], 0.3),
    ([90.5, 110.5], 0.7),
    ([112.5, 82.5], 0.2),
    ([92.5, 40.5], 1.0),
];

/// Returns the polygon as a scene whose pixels are world units and whose intensities are the normals' z.
fn polygon() -> Scene {
    let half = f64::from(SIDE) / 2.0;
    let corners = CORNERS.map(|([x, y], _)| [x - half, half - y, 0.0]);
    let mut scene = polygons(&corners, &[&[0, 1, 2, 3, 4, 5]]);
    (scene.camera.projection, scene.camera.height) = (Projection::Orthographic, f64::from(SIDE));
    scene.object.vertex_normals = CORNERS
        .iter()
        .map(|(_, i)| DVec3::new((1.0 - i * i).sqrt(), 0.0, *i))
        .collect();
    scene.object.normals = NormalSource::File;
    (scene.material.ka, scene.material.kd, scene.material.ks) = (Rgb::ZERO, Rgb::ONE, Rgb::ZERO);
    scene.material.color = Rgb::ONE;
    (scene.shading.mode, scene.shading.interpolation) =
        (ShadingMode::Gouraud, Interpolation::Scanline);
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        direction: DVec3::NEG_Z,
        ..Light::default()
    }];
    scene
}

fn scan_lines(renderer: &mut Renderer) -> Pictures {
    let scene = polygon();
    let background = scene.image.background.to_array();
    let (truth, naive) = (true_spans(background), naive_spans(background));
    Pictures {
        engine: engine_picture(renderer, &scene),
        naive,
        truth,
        scene: Some(scene),
    }
}

fn true_spans(background: [f64; 3]) -> Vec<Truth> {
    let beside = Truth {
        color: background,
        clear: true,
    };
    let mut pixels = vec![beside; (SIDE * SIDE) as usize];
    for y in 0..SIDE {
        let line = f64::from(y) + 0.5;
        let mut crossings: Vec<[Precise; 2]> = Vec::new();
        for (index, ([xa, ya], ia)) in CORNERS.iter().enumerate() {
            let ([xb, yb], ib) = CORNERS[(index + 1) % CORNERS.len()];
            if (*ya <= line) != (yb <= line) {
                let alpha = precise(line - ya) / precise(yb - ya);
                crossings.push([
                    alpha * (xb - xa) + precise(*xa),
                    alpha * (ib - ia) + precise(*ia),
                ]);
            }
        }
        let [Some(p), Some(q)] = [crossings.first(), crossings.get(1)] else {
            continue;
        };
        let (p, q) = if p[0] <= q[0] { (p, q) } else { (q, p) };
        // After the division, crossings at a pixel's centre have a wrong last bit.
        let ends = [p[0], q[0]].map(f64::from);
        for x in 0..SIDE {
            let centre = f64::from(x) + 0.5;
            if ends[0] <= centre && centre < ends[1] {
                let at = precise(centre);
                let value = p[1] + (at - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
                pixels[(y * SIDE + x) as usize] = Truth {
                    color: [value.into(); 3],
                    clear: true,
                };
            }
        }
    }
    pixels
}

fn naive_spans(background: [f64; 3]) -> Vec<[f64; 3]> {
    let mut pixels = vec![background; (SIDE * SIDE) as usize];
    let corners = CORNERS.map(|([x, y], i)| (Vec2::new(x as f32, y as f32), i as f32));
    for y in 0..SIDE {
        let line = y as f32 + 0.5;
        let mut crossings: Vec<Vec2> = Vec::new();
        for (index, (a, ia)) in corners.iter().enumerate() {
            let (b, ib) = corners[(index + 1) % corners.len()];
            if a.y.min(b.y) <= line && line <= a.y.max(b.y) {
                let alpha = (line - a.y) / (b.y - a.y);
                let x = if alpha.is_nan() {
                    a.x
                } else {
                    a.x + alpha * (b.x - a.x)
                };
                crossings.push(Vec2::new(x, ia + alpha * (ib - ia)));
            }
        }
        crossings.sort_by(|p, q| p.x.total_cmp(&q.x));
        let [Some(p), Some(q)] = [crossings.first(), crossings.last()] else {
            continue;
        };
        for x in 0..SIDE {
            let at = x as f32 + 0.5;
            if p.x <= at && at <= q.x {
                let value = p.y + (at - p.x) / (q.x - p.x) * (q.y - p.y);
                pixels[(y * SIDE + x) as usize] = [value.into(); 3];
            }
        }
    }
    pixels
}

/// Radians on either side of the critical angle, across the picture; η increases upwards.
const ANGLES: f64 = 2e-6;
/// Factor that makes cos θ₂ visible.
const GAIN: f64 = 300.0;

fn critical(_: &mut Renderer) -> Pictures {
    let mut pictures = Pictures {
        naive: vec![],
        engine: vec![],
        truth: vec![],
        scene: None,
    };
    let middle = f64::from(SIDE / 2);
    for (y, x) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (y, x))) {
        let eta = 0.95 - 0.5 * f64::from(y) / f64::from(SIDE);
        let beyond = (f64::from(x) - middle) / middle * ANGLES;
        let angle = critical_angle(eta).unwrap_or_default() + beyond;
        pictures.truth.push(Truth {
            color: [true_cosine(angle, eta) * GAIN; 3],
            clear: true,
        });
        let incident = DVec3::new(angle.sin(), 0.0, -angle.cos());
        let cosine = refract(incident, DVec3::Z, eta).map_or(0.0, |t| -t.z);
        pictures.engine.push([cosine * GAIN; 3]);
        let cosine = naive_cosine(angle as f32, eta as f32);
        pictures.naive.push([f64::from(cosine) * GAIN; 3]);
    }
    pictures
}

/// Returns cos θ₂ by Snell's law, 0 where nothing is transmitted.
fn true_cosine(angle: f64, eta: f64) -> f64 {
    let sine = precise(angle).sin_cos().0 / precise(eta);
    let rest = precise(1.0) - sine * sine;
    if rest > precise(0.0) {
        rest.sqrt().into()
    } else {
        0.0
    }
}

fn naive_cosine(angle: f32, eta: f32) -> f32 {
    let cosine = angle.cos();
    (1.0 - (1.0 - cosine * cosine) / (eta * eta)).sqrt()
}
