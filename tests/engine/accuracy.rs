//! Pictures of a sphere against rays intersected in closed form, independent of the engine, in double precision.

mod grid;

use crate::common::textbook::{Dice, field_edge, meet, random_scene, steps, textbook};
use glam::DVec3;
use shading_lab::analysis::probe::probe;
use shading_lab::geometry::tessellate;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    FlatAt, NormalSource, ObjectKind, Overflow, Rgb, Scene, ShadingMode, presets,
};

/// Returns the maximum difference in code values over the pixels at least 1.5 pixels inside the outline, without the points that
/// `leave_out` excludes.
fn worst(renderer: &mut Renderer, scene: &Scene, leave_out: impl Fn(DVec3) -> bool) -> f64 {
    let frame = renderer.render(scene);
    let mut worst: f64 = 0.0;
    for y in 0..frame.height {
        for x in 0..frame.width {
            let Some((p, inside)) = meet(scene, x, y) else {
                continue;
            };
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
    for index in 0..60 {
        let n = 1000_f64.powf(f64::from(index) / 59.0);
        let mut scene = random_scene(&mut dice, n);
        scene.shading.mode = ShadingMode::Exact;
        let worst = worst(&mut renderer, &scene, |p| field_edge(&scene, p, 1e-5));
        assert!(
            worst <= 1.0,
            "scene {index}: {worst} code values, {scene:?}"
        );
    }
}

#[test]
fn phong_shading_of_a_fine_sphere_nears_the_closed_form() {
    let mut dice = Dice(0x5eed_1975);
    let mut renderer = Renderer::default();
    for index in 0..60 {
        let mut scene = random_scene(&mut dice, 1000_f64.powf(f64::from(index) / 59.0));
        scene.shading.mode = ShadingMode::Phong;
        scene.object.segments = 512;
        scene.object.rings = 256;
        scene.object.normals = NormalSource::Exact;
        let worst = worst(&mut renderer, &scene, |p| steps(&scene, p, 2e-4));
        // The mesh departs by 4·10⁻⁵ from the sphere; the steepest lobes and cones here multiply that by 300.
        assert!(
            worst <= 4.0,
            "scene {index}: {worst} code values, {scene:?}"
        );
    }
}

/// Checks that the probe agrees with the picture wherever the mode evaluates the equation.
#[test]
fn the_probe_adds_up_to_the_stored_pixel() {
    let mut dice = Dice(0x5eed_1997);
    let mut renderer = Renderer::default();
    let modes = [
        ShadingMode::Flat,
        ShadingMode::Interpolated,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Exact,
    ];
    let kinds = [
        ObjectKind::Sphere,
        ObjectKind::Torus,
        ObjectKind::Cylinder,
        ObjectKind::Cone,
        ObjectKind::Cube,
    ];
    for (index, kind) in kinds.into_iter().cycle().take(25).enumerate() {
        let mut scene = random_scene(&mut dice, 20.0);
        scene.object.kind = kind;
        scene.shading.mode = modes[index % modes.len()];
        let mut seen = 0;
        for _ in 0..200 {
            let (x, y) = ((dice.unit() * 256.0) as u32, (dice.unit() * 192.0) as u32);
            let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
                continue;
            };
            seen += 1;
            let terms: DVec3 = hit
                .lights
                .iter()
                .map(|light| light.diffuse + light.specular)
                .sum();
            assert!(
                (hit.ambient + terms - hit.sum).abs().max_element() < 1e-9,
                "terms do not add up"
            );
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

/// Checks which normal each kind of flat shading uses: the highlight's terms at its points, computed independently, must match.
#[test]
fn flat_shading_takes_the_normals_that_are_documented() {
    let mut scene = Scene::default();
    scene.image.size = [64, 64];
    (scene.object.segments, scene.object.rings) = (9, 6);
    scene.material.ks = Rgb::ZERO;
    let mut renderer = Renderer::default();
    let mesh = tessellate(&scene.object);
    let (own, light) = (
        mesh.with_vertex_normals(scene.object.normals, scene.object.weighting),
        scene.lights[0].position,
    );
    let lambert = |p: DVec3, n: DVec3| n.dot((light - p).normalize()).max(0.0);
    for (mode, flat_at) in [
        (ShadingMode::Flat, FlatAt::Centre),
        (ShadingMode::Flat, FlatAt::VertexMean),
        (ShadingMode::Flat, FlatAt::ProvokingVertex),
    ] {
        (scene.shading.mode, scene.shading.flat_at) = (mode, flat_at);
        let hit = probe(&mut renderer, &scene, 36, 28)
            .hit
            .expect("the sphere");
        let face = hit.face.expect("a polygon") as usize;
        let corners = own.face(face).iter().map(|&v| v as usize);
        let shades: Vec<f64> = corners
            .map(|v| lambert(own.positions[v].as_dvec3(), own.normals[v].as_dvec3()))
            .collect();
        let expected = match flat_at {
            FlatAt::Centre => lambert(mesh.face_centre(face), mesh.face_normal(face)),
            FlatAt::VertexMean => shades.iter().sum::<f64>() / shades.len() as f64,
            FlatAt::ProvokingVertex => shades[0],
        };
        let found = hit.lights[0].diffuse / (scene.material.kd * scene.material.color);
        assert!(
            (found.x - expected).abs() < 1e-6,
            "{flat_at:?}: {found} and {expected}"
        );
    }
}

#[test]
fn a_picture_that_is_scaled_says_by_how_much() {
    let mut scene = presets::find("overflow").expect("a scene").scene();
    scene.image.size = [120, 120];
    scene.display.overflow = Overflow::Scale;
    let mut renderer = Renderer::default();
    let mut brightest: f64 = 0.0;
    for (x, y) in (0..120).flat_map(|y| (0..120).map(move |x| (x, y))) {
        let Some(hit) = probe(&mut renderer, &scene, x, y).hit else {
            continue;
        };
        brightest = brightest.max(hit.sum.max_element());
        for channel in 0..3 {
            let code = hit.sum[channel] / hit.divisor * 255.0;
            assert!(
                (code - f64::from(hit.stored[channel])).abs() <= 0.6,
                "{x},{y}: {code} {:?}",
                hit.stored
            );
        }
    }
    let divisor = renderer.report().divisor;
    assert!(
        divisor > 1.2 && (divisor / brightest - 1.0).abs() < 1e-5,
        "{divisor} for {brightest}"
    );
    scene.display.overflow = Overflow::Clamp;
    renderer.render(&scene);
    assert_eq!(renderer.report().divisor, 1.0);
}
