//! Cases that no whole scene shows: the scan line itself, and Snell's law at the critical angle.

use super::super::precise::{Precise, precise};
use super::super::reference::Truth;
use super::super::{Case, Condition, Pictures, Subject, Topic, engine_picture};
use super::{SIDE, polygons};
use crate::illumination::{critical_angle, refract};
use crate::render::Renderer;
use crate::scene::{Interpolation, Light, LightKind, NormalSource, Projection, Rgb, Scene, ShadingMode};
use glam::{DVec3, Vec2};

pub const CASES: &[Case] = &[
    Case {
        name: "span-of-length-0",
        title: "A scan line through a corner, and along an edge",
        topic: Topic::Geometry,
        wrong: "At a corner P and Q coincide, and the place between them is 0/0; along a level edge α is. Those pixels are no \
                numbers.",
        robust: "An edge holds its upper end and not its lower one, a span its left end and not its right one: one of length 0 \
                 covers no pixel.",
        condition: None,
        subject: Subject::Pictures(scan_lines),
    },
    Case {
        name: "critical-angle",
        title: "The critical angle, 4·10⁻⁶ radians of it",
        topic: Topic::Geometry,
        wrong: "1 − sin²θ₂ from a cosine has two or three digits left; past the angle its root is no number.",
        robust: "sin² from the cross product, in double precision; where the rest is below 0 nothing is transmitted.",
        condition: Some(Condition { value: 5e5, of: "of cos θ₂ in θ₁: 1/(2δ)" }),
        subject: Subject::Pictures(critical),
    },
];

/// Corners of the polygon in pixels, all at centres of pixels, with their intensities.
const CORNERS: [([f64; 2], f64); 6] = [
    ([64.5, 10.5], 0.1),
    ([20.5, 60.5], 0.9),
    ([40.5, 110.5], 0.3),
    ([90.5, 110.5], 0.7),
    ([112.5, 82.5], 0.2),
    ([92.5, 40.5], 1.0),
];

/// The polygon as a scene whose pixels are world units and whose intensities are the normals' z.
fn polygon() -> Scene {
    let half = f64::from(SIDE) / 2.0;
    let corners = CORNERS.map(|([x, y], _)| [x - half, half - y, 0.0]);
    let mut scene = polygons(&corners, &[&[0, 1, 2, 3, 4, 5]]);
    (scene.camera.projection, scene.camera.height) = (Projection::Orthographic, f64::from(SIDE));
    scene.object.vertex_normals = CORNERS.iter().map(|(_, i)| DVec3::new((1.0 - i * i).sqrt(), 0.0, *i)).collect();
    scene.object.normals = NormalSource::File;
    (scene.material.ka, scene.material.kd, scene.material.ks) = (Rgb::ZERO, Rgb::ONE, Rgb::ZERO);
    scene.material.color = Rgb::ONE;
    (scene.shading.mode, scene.shading.interpolation) = (ShadingMode::Gouraud, Interpolation::Scanline);
    scene.lights = vec![Light { kind: LightKind::Directional, direction: DVec3::NEG_Z, ..Light::default() }];
    scene
}

fn scan_lines(renderer: &mut Renderer) -> Pictures {
    let scene = polygon();
    let background = scene.image.background.to_array();
    let truth = true_spans(background);
    let naive = naive_spans(background);
    Pictures { engine: engine_picture(renderer, &scene), naive, truth, scene: Some(scene) }
}

fn grey(value: f64) -> [f64; 3] {
    [value; 3]
}

fn true_spans(background: [f64; 3]) -> Vec<Truth> {
    let mut pixels = vec![Truth { color: background, clear: true }; (SIDE * SIDE) as usize];
    for y in 0..SIDE {
        let line = f64::from(y) + 0.5;
        let mut crossings: Vec<[Precise; 2]> = Vec::new();
        for (index, ([xa, ya], ia)) in CORNERS.iter().enumerate() {
            let ([xb, yb], ib) = CORNERS[(index + 1) % CORNERS.len()];
            if (*ya <= line) != (yb <= line) {
                let alpha = precise(line - ya) / precise(yb - ya);
                crossings.push([alpha * (xb - xa) + precise(*xa), alpha * (ib - ia) + precise(*ia)]);
            }
        }
        let [Some(p), Some(q)] = [crossings.first(), crossings.get(1)] else { continue };
        let (p, q) = if p[0] <= q[0] { (p, q) } else { (q, p) };
        // Crossings at a pixel's centre come out of the division with a last bit that no longer says so.
        let ends = [p[0], q[0]].map(f64::from);
        for x in 0..SIDE {
            let centre = f64::from(x) + 0.5;
            if ends[0] <= centre && centre < ends[1] {
                let at = precise(centre);
                let value = p[1] + (at - p[0]) / (q[0] - p[0]) * (q[1] - p[1]);
                pixels[(y * SIDE + x) as usize] = Truth { color: grey(value.into()), clear: true };
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
                let x = if alpha.is_nan() { a.x } else { a.x + alpha * (b.x - a.x) };
                crossings.push(Vec2::new(x, ia + alpha * (ib - ia)));
            }
        }
        crossings.sort_by(|p, q| p.x.total_cmp(&q.x));
        let [Some(p), Some(q)] = [crossings.first(), crossings.last()] else { continue };
        for x in 0..SIDE {
            let at = x as f32 + 0.5;
            if p.x <= at && at <= q.x {
                let value = p.y + (at - p.x) / (q.x - p.x) * (q.y - p.y);
                pixels[(y * SIDE + x) as usize] = grey(value.into());
            }
        }
    }
    pixels
}

/// Radians on either side of the critical angle, across the picture; η grows upwards.
const ANGLES: f64 = 2e-6;
/// What cos θ₂ is multiplied by, to be seen.
const GAIN: f64 = 300.0;

fn critical(_: &mut Renderer) -> Pictures {
    let mut pictures = Pictures { naive: vec![], engine: vec![], truth: vec![], scene: None };
    let middle = f64::from(SIDE / 2);
    for (y, x) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (y, x))) {
        let eta = 0.95 - 0.5 * f64::from(y) / f64::from(SIDE);
        let beyond = (f64::from(x) - middle) / middle * ANGLES;
        let angle = critical_angle(eta).unwrap_or_default() + beyond;
        pictures.truth.push(Truth { color: grey(true_cosine(angle, eta) * GAIN), clear: true });
        let incident = DVec3::new(angle.sin(), 0.0, -angle.cos());
        let cosine = refract(incident, DVec3::Z, eta).map_or(0.0, |t| -t.z);
        pictures.engine.push(grey(cosine * GAIN));
        pictures.naive.push(grey(f64::from(naive_cosine(angle as f32, eta as f32)) * GAIN));
    }
    pictures
}

/// cos θ₂ by Snell's law, 0 where nothing is transmitted.
fn true_cosine(angle: f64, eta: f64) -> f64 {
    let sine = precise(angle).sin_cos().0 / precise(eta);
    let rest = precise(1.0) - sine * sine;
    if rest > precise(0.0) { rest.sqrt().into() } else { 0.0 }
}

fn naive_cosine(angle: f32, eta: f32) -> f32 {
    let cosine = angle.cos();
    (1.0 - (1.0 - cosine * cosine) / (eta * eta)).sqrt()
}
