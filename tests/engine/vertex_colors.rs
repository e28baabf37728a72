//! Colours of vertices: they tint Od in every mode, as another computation has it.

use crate::common::dice::Dice;
use crate::model_materials::{VARIANTS, linear, model, scene};
use glam::{DVec2, DVec3, Vec3};
use shading_lab::analysis::probe::probe;
use shading_lab::geometry::Mesh;
use shading_lab::illumination::Equation;
use shading_lab::render::Renderer;
use shading_lab::scene::{Choice, MaterialSource, ObjectKind, Rgb, Scene, ShadingMode, View};
use std::sync::Arc;

/// Returns a mesh whose points have colours that differ much.
fn colored(kind: ObjectKind, materials: bool) -> Mesh {
    let mut mesh = Mesh::clone(&model(kind, 8, |face| (face % 6) as u16));
    if !materials {
        (mesh.materials, mesh.face_materials) = (vec![], vec![]);
    }
    let color = |k: usize| {
        Vec3::new((k % 5) as f32, (k % 3) as f32, (k % 7) as f32) / Vec3::new(4.0, 2.0, 6.0)
    };
    mesh.colors = (0..mesh.positions.len()).map(color).collect();
    mesh.corner_colors = mesh.corners.iter().map(|corner| corner.position).collect();
    mesh
}

fn drawn(mesh: &Mesh, scene: &Scene) -> Vec<[f32; 4]> {
    let mut renderer = Renderer::default().with_model(Some(Arc::new(mesh.clone())));
    let (picture, _) = linear(&mut renderer, scene);
    picture
        .into_iter()
        .map(|pixel| pixel.map(f32::from_bits))
        .collect()
}

#[test]
fn one_colour_for_all_is_a_colour_of_the_material() {
    let tint = Vec3::new(0.5, 0.25, 1.0);
    for (index, variant) in VARIANTS.iter().enumerate() {
        let mut mesh = colored(ObjectKind::Torus, index % 2 == 0);
        mesh.colors.fill(tint);
        let mut tinted = mesh.clone();
        (mesh.colors, mesh.corner_colors) = (vec![], vec![]);
        for own in &mut mesh.materials {
            own.ka = own.ka.map(|ka| ka * tint.as_dvec3());
            own.kd = own.kd.map(|kd| kd * tint.as_dvec3());
        }
        for mode in ShadingMode::VALUES {
            let mut shown = scene(variant);
            shown.shading.mode = *mode;
            let mut alone = shown.clone();
            alone.material.color *= tint.as_dvec3();
            alone.pattern.color *= tint.as_dvec3();
            if !mesh.materials.is_empty() && shown.pattern.kind.word() != "none" {
                // The pattern's colour takes the place of Od, and Kd has the tint already.
                alone.pattern.color = shown.pattern.color;
            }
            let pairs = drawn(&tinted, &shown).into_iter().zip(drawn(&mesh, &alone));
            for (pixel, (a, b)) in pairs.enumerate() {
                let same = (0..4).all(|c| (a[c] - b[c]).abs() <= 2e-5 * (1.0 + b[c].abs()));
                assert!(same, "{mode:?} {variant:?} {pixel}: {a:?} {b:?}");
            }
        }
        // The scene's material for all is without the colours, too.
        let mut all = scene(variant);
        all.material.source = MaterialSource::Scene;
        (mesh.materials, mesh.face_materials) = (vec![], vec![]);
        let plain = drawn(&mesh, &all);
        assert!(drawn(&tinted, &all) == plain, "{variant:?}");
        tinted.colors.fill(Vec3::ONE);
        assert_eq!(tinted.corner_color(0), Vec3::ONE);
    }
}

/// A face, three of its corners, and their weights.
type Hit = (usize, [usize; 3], [f64; 3]);

/// Returns the nearest triangle of a ray (Möller and Trumbore 1997).
fn nearest(mesh: &Mesh, from: DVec3, along: DVec3) -> Option<Hit> {
    let mut best: Option<(f64, Hit)> = None;
    for face in 0..mesh.face_count() {
        let first = mesh.starts[face] as usize;
        let count = mesh.face(face).len();
        for k in 1..count - 1 {
            let corners = [first, first + k, first + k + 1];
            let [a, b, c] = corners
                .map(|corner| mesh.positions[mesh.corners[corner].position as usize].as_dvec3());
            let (e1, e2, o) = (b - a, c - a, from - a);
            let (p, q) = (along.cross(e2), o.cross(e1));
            let whole = e1.dot(p);
            let [u, v, t] = [o.dot(p), along.dot(q), e2.dot(q)].map(|part| part / whole);
            let met = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0;
            if met && best.is_none_or(|(nearest, _)| t < nearest) {
                best = Some((t, (face, corners, [1.0 - u - v, u, v])));
            }
        }
    }
    best.map(|(_, hit)| hit)
}

#[test]
fn colours_are_interpolated_as_another_computation_has_it_in_every_mode() {
    for (kind, materials) in [(ObjectKind::Sphere, false), (ObjectKind::Cube, true)] {
        let mesh = colored(kind, materials);
        for mode in ShadingMode::VALUES {
            let mut shown = scene(&["object.normals=file", "image.size=[60,50]"]);
            shown.shading.mode = *mode;
            let picture = drawn(&mesh, &shown);
            let view = View::new(&shown.camera, shown.image.size);
            let value = |point: DVec3, normal: DVec3, color: Rgb, face: usize| {
                let mut own = shown.clone();
                if let Some(material) = mesh.materials.get(usize::from(mesh.face_material(face))) {
                    material.face_material().replace_in(&mut own);
                }
                own.material.color *= color;
                Equation::<f64>::new(&own).illuminate_world(point, normal, None)
            };
            let at =
                |corner: usize| mesh.positions[mesh.corners[corner].position as usize].as_dvec3();
            let normal =
                |corner: usize| mesh.normals[mesh.corners[corner].normal as usize].as_dvec3();
            let color = |corner: usize| mesh.corner_color(corner).as_dvec3();
            let (mut compared, mut far) = (0, 0);
            for (pixel, found) in picture
                .iter()
                .enumerate()
                .filter(|(_, found)| found[3] > 0.0)
            {
                let place = DVec2::new((pixel % 60) as f64 + 0.5, (pixel / 60) as f64 + 0.5);
                let (origin, along) = view.ray(place);
                let Some((face, corners, weights)) = nearest(&mesh, origin, along) else {
                    continue;
                };
                let mean = |of: &dyn Fn(usize) -> DVec3| -> DVec3 {
                    corners
                        .iter()
                        .zip(weights)
                        .map(|(&corner, weight)| of(corner) * weight)
                        .sum()
                };
                let expected = match mode {
                    ShadingMode::Flat => {
                        let count = mesh.face(face).len();
                        let first = mesh.starts[face] as usize;
                        let tint: Rgb =
                            (first..first + count).map(color).sum::<Rgb>() / count as f64;
                        value(mesh.face_centre(face), mesh.face_normal(face), tint, face)
                    }
                    ShadingMode::Interpolated => mean(&|corner| {
                        value(at(corner), mesh.face_normal(face), color(corner), face)
                    }),
                    ShadingMode::Gouraud => {
                        mean(&|corner| value(at(corner), normal(corner), color(corner), face))
                    }
                    ShadingMode::Phong | ShadingMode::Exact => {
                        value(mean(&at), mean(&normal).normalize(), mean(&color), face)
                    }
                };
                compared += 1;
                let differs = (0..3).any(|c| (f64::from(found[c]) - expected[c]).abs() > 4e-3);
                // Corners are rounded to 1/256 pixel, so that a pixel beside an edge may show the neighbour.
                far += usize::from(differs);
            }
            assert!(
                compared > 400 && far * 100 <= compared,
                "{kind:?} {mode:?}: {far} of {compared}"
            );
        }
    }
}

#[test]
fn the_probe_sees_what_the_picture_shows_with_the_colours() {
    let mut dice = Dice(8);
    let mut asked = 0;
    while asked < 1000 {
        let kind = dice.of(&[ObjectKind::Sphere, ObjectKind::Torus, ObjectKind::Cube]);
        let mesh = colored(kind, dice.of(&[false, true]));
        let mut shown = scene(dice.of(&VARIANTS));
        shown.shading.mode = dice.of(ShadingMode::VALUES);
        let mut renderer = Renderer::default().with_model(Some(Arc::new(mesh)));
        let (picture, _) = linear(&mut renderer, &shown);
        let [width, height] = shown.image.size;
        for _ in 0..40 {
            let [x, y] = [width, height].map(|side| dice.between(0.0, side.into()) as u32);
            let Some(hit) = probe(&mut renderer, &shown, x, y).hit else {
                continue;
            };
            asked += 1;
            let tint = hit.tint.expect("vertices have colours");
            assert!(
                tint.min_element() >= -1e-9 && tint.max_element() <= 1.0 + 1e-9,
                "{tint}"
            );
            let terms: Rgb = hit
                .lights
                .iter()
                .map(|light| light.diffuse + light.specular)
                .sum();
            let far = (hit.ambient + terms - hit.reflected).abs().max_element();
            assert!(far < 1e-9, "the terms add up: {far}");
            // Where the equation is evaluated once, Od of the scene that the point shows is the tinted one.
            if matches!(shown.shading.mode, ShadingMode::Phong | ShadingMode::Exact) {
                let own = hit.scene_of(&shown);
                let expected = own.material.ka * hit.color * shown.ambient.color;
                assert!(hit.bounced || (hit.ambient - expected).abs().max_element() < 1e-9);
            }
            let found =
                picture[(y * width + x) as usize].map(|bits| f64::from(f32::from_bits(bits)));
            for (a, b) in hit.sum.to_array().into_iter().zip(found) {
                assert!(
                    (a - b).abs() < 2e-3 * (1.0 + b.abs()),
                    "{kind:?} {:?} {x}, {y}: {a}, {b}",
                    shown.shading.mode
                );
            }
        }
    }
}
