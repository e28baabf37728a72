//! Interpolation of intensities from the vertices to the pixels, against the course's formulas, computed independently.
//!
//! The vertices get their intensities from their normals: under light along −z, with kd = 1 and no other term, I is the normal's
//! z.

use crate::common::properties;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use shading_lab::analysis::probe::probe;
use shading_lab::analysis::profile::{ProfileQuestion, profile};
use shading_lab::geometry::read_obj;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Backfacing, Interpolation, Light, LightKind, NormalSource, ObjectKind, PatternKind, Projection,
    Rgb, Scene, ShadingMode, Shared, View, presets,
};

/// An odd side, so that a pixel's centre is the picture's middle.
const SIDE: u32 = 65;
/// Error of values computed in single precision, or derived from normals stored in it.
const SINGLE: f64 = 1e-5;

/// Returns a scene of one polygon whose vertices have these intensities.
fn polygon(corners: &[(DVec3, f64)], interpolation: Interpolation) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [SIDE; 2];
    scene.camera.projection = Projection::Orthographic;
    (scene.camera.eye, scene.camera.height) = (DVec3::Z * 100.0, f64::from(SIDE));
    scene.object.kind = ObjectKind::Polygons;
    scene.object.normals = NormalSource::File;
    scene.object.vertices = corners.iter().map(|(place, _)| *place).collect();
    scene.object.vertex_normals = corners
        .iter()
        .map(|(_, i)| DVec3::new((1.0 - i * i).sqrt(), 0.0, *i))
        .collect();
    scene.object.faces = vec![(0..corners.len() as u32).collect()].into();
    (scene.material.ka, scene.material.kd, scene.material.ks) = (Rgb::ZERO, Rgb::ONE, Rgb::ZERO);
    scene.material.color = Rgb::ONE;
    (scene.shading.mode, scene.shading.interpolation) = (ShadingMode::Gouraud, interpolation);
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        direction: DVec3::NEG_Z,
        ..Light::default()
    }];
    scene
}

/// Returns the probe's intensity at some of the pixels that show the polygon; the picture must agree with it.
fn intensities(scene: &Scene) -> Vec<([u32; 2], f64)> {
    assert_eq!(scene.validate(), Ok(()));
    let mut renderer = Renderer::default();
    let picture = renderer.render(scene).clone();
    let mut found = Vec::new();
    for (x, y) in (0..SIDE)
        .step_by(2)
        .flat_map(|y| (0..SIDE).step_by(3).map(move |x| (x, y)))
    {
        let Some(hit) = probe(&mut renderer, scene, x, y).hit else {
            continue;
        };
        let stored = picture.pixel(x, y).expect("inside")[0];
        // The picture's vertices lie on a grid of 1/256 pixel.
        let off = (hit.sum.x * 255.0 - f64::from(stored)).abs();
        assert!(off < 2.0, "({x}, {y}): {} is stored as {stored}", hit.sum.x);
        found.push(([x, y], hit.sum.x));
    }
    found
}

/// Returns the intensity in the picture's middle.
fn in_the_middle(scene: &Scene) -> f64 {
    probe(&mut Renderer::default(), scene, SIDE / 2, SIDE / 2)
        .hit
        .expect("the polygon")
        .sum
        .x
}

fn centre([x, y]: [u32; 2]) -> DVec2 {
    DVec2::new(f64::from(x), f64::from(y)) + 0.5
}

/// Returns the positions of the corners in the picture, with their intensities.
fn seen(scene: &Scene, corners: &[(DVec3, f64)]) -> Vec<(DVec2, f64)> {
    let view = View::new(&scene.camera, scene.image.size);
    corners
        .iter()
        .map(|(place, i)| (view.project(*place).expect("in front of the eye").0, *i))
        .collect()
}

/// Interpolates linearly over the triangle: each corner's weight is the area of the triangle opposite.
fn barycentric(corners: &[(DVec2, f64)], at: DVec2) -> f64 {
    let [(a, ia), (b, ib), (c, ic)] = [corners[0], corners[1], corners[2]];
    let area = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    (ia * area(at, b, c) + ib * area(a, at, c) + ic * area(a, b, at)) / area(a, b, c)
}

/// Returns whether a position is inside a triangle. The picture's grid may show a pixel just outside it: there the scan line
/// keeps the outline's value, and a linear function extrapolates.
fn inside(corners: &[(DVec2, f64)], at: DVec2) -> bool {
    let turn = |k: usize| (corners[(k + 1) % 3].0 - corners[k].0).perp_dot(at - corners[k].0);
    (0..3).all(|k| turn(k) > 0.0) || (0..3).all(|k| turn(k) < 0.0)
}

/// Evaluates the course's formula: P and Q where the scan line cuts the outline, α along either edge, then along the span.
fn bilinear(corners: &[(DVec2, f64)], at: DVec2) -> f64 {
    let mut cuts = Vec::new();
    for (k, &(from, i1)) in corners.iter().enumerate() {
        let (to, i2) = corners[(k + 1) % corners.len()];
        if from.y.min(to.y) <= at.y && at.y < from.y.max(to.y) {
            let alpha = (at.y - from.y) / (to.y - from.y);
            cuts.push((
                from.x + alpha * (to.x - from.x),
                (1.0 - alpha) * i1 + alpha * i2,
            ));
        }
    }
    assert_eq!(cuts.len(), 2, "a convex outline is cut twice at {at}");
    let [p, q] = [cuts[0], cuts[1]];
    // The picture's grid may show a pixel just outside the outline: it has the outline's value.
    let t = ((at.x - p.0) / (q.0 - p.0)).clamp(0.0, 1.0);
    (1.0 - t) * p.1 + t * q.1
}

fn intensity() -> impl Strategy<Value = f64> {
    0.0..=1.0f64
}

fn corner() -> impl Strategy<Value = (DVec3, f64)> {
    (
        (-30.0..30.0f64, -30.0..30.0f64, -20.0..20.0f64),
        intensity(),
    )
        .prop_map(|((x, y, z), i)| (DVec3::new(x, y, z), i))
}

/// Generates a convex quadrilateral, with one corner in each quarter of a circle.
fn quadrilateral() -> impl Strategy<Value = Vec<(DVec3, f64)>> {
    prop::collection::vec((0.1..0.9f64, intensity()), 4).prop_map(|corners| {
        let on_circle = |(k, (part, i)): (usize, &(f64, f64))| {
            let way = DVec2::from_angle((k as f64 + part) * std::f64::consts::FRAC_PI_2) * 30.0;
            (way.extend(0.0), *i)
        };
        corners.iter().enumerate().map(on_circle).collect()
    })
}

proptest! {
    // Uses the same polygons in every run: next to a corner that a row nearly grazes, the vertices' grid moves a pixel by more
    // than the tolerance of the comparison.
    #![proptest_config(ProptestConfig { cases: 24, rng_seed: RngSeed::Fixed(1971), ..properties::config(file!()) })]

    /// Checks that the scan line on a triangle is barycentric: both are the one linear function that has the corners' values.
    #[test]
    fn on_a_triangle_the_scan_line_is_barycentric(corners in prop::collection::vec(corner(), 3), perspective in any::<bool>()) {
        let scene = |interpolation| {
            let mut scene = polygon(&corners, interpolation);
            if perspective {
                scene.camera.projection = Projection::Perspective;
            }
            scene
        };
        let places = seen(&scene(Interpolation::Affine), &corners);
        prop_assume!((places[1].0 - places[0].0).perp_dot(places[2].0 - places[0].0).abs() > 50.0);
        let lines = intensities(&scene(Interpolation::Scanline));
        let affine = intensities(&scene(Interpolation::Affine));
        prop_assert_eq!(lines.len(), affine.len());
        for ((at, line), (_, affine)) in lines.into_iter().zip(affine).filter(|((at, _), _)| inside(&places, centre(*at))) {
            prop_assert!((line - affine).abs() < SINGLE, "{at:?}: {line} {affine}");
            let expected = barycentric(&places, centre(at));
            prop_assert!((line - expected).abs() < 1e-4, "{at:?}: {line}, expected {expected}");
        }
    }

    #[test]
    fn on_a_convex_quadrilateral_the_scan_line_is_bilinear_at_every_angle(corners in quadrilateral(), turn in 0.0..15.0f64) {
        let mut scene = polygon(&corners, Interpolation::Scanline);
        for step in 0..24 {
            scene.camera.roll = turn + 15.0 * f64::from(step);
            let places = seen(&scene, &corners);
            for (at, found) in intensities(&scene) {
                let at = centre(at);
                // On the outline the picture's grid decides which pixels are inside.
                let inside = places.iter().map(|p| p.0.y).fold(f64::INFINITY, f64::min) < at.y
                    && at.y < places.iter().map(|p| p.0.y).fold(f64::NEG_INFINITY, f64::max);
                if inside {
                    let expected = bilinear(&places, at);
                    prop_assert!((found - expected).abs() < 1e-4, "{at}: {found}, expected {expected}");
                }
            }
        }
    }
}

/// Returns a square about the picture's middle, counter-clockwise from its lower left.
fn square(values: [f64; 4]) -> Vec<(DVec3, f64)> {
    let corners = [[-20.0, -20.0], [20.0, -20.0], [20.0, 20.0], [-20.0, 20.0]];
    corners
        .into_iter()
        .zip(values)
        .map(|([x, y], i)| (DVec3::new(x, y, 0.0), i))
        .collect()
}

#[test]
fn a_turned_square_changes_its_shade_and_a_triangle_does_not() {
    let values = [0.9, 0.2, 0.7, 0.1];
    let corners = square(values);
    let mut scene = polygon(&corners, Interpolation::Scanline);
    let mut at = |roll: f64| {
        scene.camera.roll = roll;
        in_the_middle(&scene)
    };
    let mean = values.iter().sum::<f64>() / 4.0;
    for quarters in 0..4u8 {
        let found = at(90.0 * f64::from(quarters));
        assert!((found - mean).abs() < SINGLE, "{found}");
    }
    // On its corner, the line through the middle runs from corner to corner: the upper right one is then at the top.
    for (roll, expected) in [
        (45.0, (values[1] + values[3]) / 2.0),
        (135.0, (values[0] + values[2]) / 2.0),
    ] {
        let found = at(roll);
        assert!(
            (found - expected).abs() < 1e-3 && (found - mean).abs() > 0.2,
            "{roll}: {found}, expected {expected}"
        );
    }
    for (rule, corners) in [
        (Interpolation::Scanline, &corners[..3]),
        (Interpolation::Affine, &corners),
        (Interpolation::Perspective, &corners),
    ] {
        // The middle of the picture lies on the square's diagonal, hence inside a triangle once the square is moved slightly.
        let moved: Vec<_> = corners
            .iter()
            .map(|(place, i)| (place + DVec3::new(-5.0, 3.0, 0.0), *i))
            .collect();
        let mut scene = polygon(&moved, rule);
        let upright = in_the_middle(&scene);
        for step in 1..24 {
            scene.camera.roll = 15.0 * f64::from(step);
            let turned = in_the_middle(&scene);
            assert!(
                (turned - upright).abs() < 1e-4,
                "{rule:?}, {} corners, {}: {turned} {upright}",
                corners.len(),
                scene.camera.roll
            );
        }
    }
}

/// Checks that a point off the middle keeps its value at a quarter turn and has another in between.
#[test]
fn a_point_fixed_to_the_square_is_followed() {
    let mut scene = polygon(&square([0.9, 0.2, 0.7, 0.1]), Interpolation::Scanline);
    let mut at = |roll: f64, x: u32, y: u32| {
        scene.camera.roll = roll;
        let hit = probe(&mut Renderer::default(), &scene, 32 + x, 32 - y)
            .hit
            .expect("the square");
        (hit.position, hit.sum.x)
    };
    let ((p0, i0), (p45, i45), (p90, i90)) = (at(0.0, 17, 0), at(45.0, 12, 12), at(90.0, 0, 17));
    assert!(p0.distance(p45) < 0.05 && p0.distance(p90) < 1e-3);
    assert!((i0 - i90).abs() < 1e-4, "{i0} {i90}");
    assert!((i0 - i45).abs() > 0.03, "{i0} {i45}");
}

/// Checks an edge from depth z1 to z2, seen across: its half-way point in the picture is nearer to the near end on the polygon.
#[test]
fn half_way_in_the_picture_weighs_by_the_other_ends_depth() {
    for (z1, z2) in [(1.0, 9.0), (2.0, 3.0), (1.0, 100.0)] {
        let (i1, i2) = (0.1, 0.9);
        let corner =
            |side: f64, z: f64, slope: f64, i: f64| (DVec3::new(side * z, slope * z, -z), i);
        let (near, far) = (
            |side| corner(side, z1, -0.2, i1),
            |side| corner(side, z2, 0.2, i2),
        );
        let corners = [near(-0.3), near(0.3), far(0.1), far(-0.1)];
        for (rule, expected) in [
            (Interpolation::Perspective, (z2 * i1 + z1 * i2) / (z1 + z2)),
            (Interpolation::Affine, (i1 + i2) / 2.0),
            (Interpolation::Scanline, (i1 + i2) / 2.0),
        ] {
            let mut scene = polygon(&corners, rule);
            scene.camera.projection = Projection::Perspective;
            (scene.camera.eye, scene.camera.target) = (DVec3::ZERO, DVec3::NEG_Z);
            let found = in_the_middle(&scene);
            assert!(
                (found - expected).abs() < SINGLE,
                "{rule:?} from {z1} to {z2}: {found}, expected {expected}"
            );
            let stored = f64::from(
                Renderer::default()
                    .render(&scene)
                    .pixel(SIDE / 2, SIDE / 2)
                    .expect("inside")[0],
            );
            assert!(
                (stored - 255.0 * expected).abs() < 2.0,
                "{rule:?}: {stored}"
            );
        }
    }
}

/// Returns the probe's maximum difference from the stored pixels, in code values, and the maximum stored value.
fn off_the_picture(scene: &Scene) -> (f64, u8) {
    assert_eq!(scene.validate(), Ok(()));
    let mut renderer = Renderer::default();
    let (mut worst, mut brightest) = (0.0_f64, 0);
    let [width, height] = scene.image.size;
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let Some(hit) = probe(&mut renderer, scene, x, y).hit else {
            continue;
        };
        for k in 0..3 {
            worst =
                worst.max((hit.sum[k].clamp(0.0, 1.0) * 255.0 - f64::from(hit.stored[k])).abs());
            brightest = brightest.max(hit.stored[k]);
        }
    }
    (worst, brightest)
}

/// Returns a face that is far from plane and appears folded over itself.
fn warped() -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [96, 96];
    scene.object.kind = ObjectKind::Polygons;
    let corners = [
        [-1.0, -1.0, -1.0],
        [1.0, -1.0, -1.0],
        [1.0, -1.0, 1.0],
        [-1.0, 1.0, 2.0],
    ];
    scene.object.vertices = corners.map(DVec3::from_array).into_iter().collect();
    scene.object.faces = vec![(0..4).collect()].into();
    scene.reflection.backfacing = Backfacing::Flip;
    scene
}

#[test]
fn on_a_warped_face_picture_and_probe_are_the_same() {
    for mode in [ShadingMode::Gouraud, ShadingMode::Phong] {
        for interpolation in [
            Interpolation::Scanline,
            Interpolation::Affine,
            Interpolation::Perspective,
        ] {
            let mut scene = warped();
            (scene.shading.mode, scene.shading.interpolation) = (mode, interpolation);
            let (off, _) = off_the_picture(&scene);
            assert!(off <= 1.0, "{mode:?} {interpolation:?}: {off}");
        }
    }
}

#[test]
fn clipped_polygons_are_probed_as_they_are_drawn() {
    let preset = presets::find("perspective-distortion").expect("a built-in scene");
    let mut near = preset.scene();
    (near.camera.eye, near.image.size) = (DVec3::new(0.0, -0.2, 0.5), [64; 2]);
    let mut narrow = Scene::default();
    (narrow.camera.fov_y, narrow.image.size) = (0.01, [64; 2]);
    narrow.camera.target = DVec3::new(0.3, 0.2, 0.0);
    for mut scene in [near, narrow] {
        for interpolation in [
            Interpolation::Scanline,
            Interpolation::Affine,
            Interpolation::Perspective,
        ] {
            for mode in [ShadingMode::Gouraud, ShadingMode::Phong] {
                (scene.shading.interpolation, scene.shading.mode) = (interpolation, mode);
                let (off, brightest) = off_the_picture(&scene);
                assert!(
                    off <= 1.0 && brightest > 30,
                    "{interpolation:?} {mode:?}: {off}, {brightest}"
                );
            }
        }
    }
}

/// Checks a plane whose vertices lie on the borders of the fields.
#[test]
fn vertices_on_the_borders_of_fields_are_in_one_field_for_picture_and_probe() {
    let mut scene = presets::find("plane").expect("a built-in scene").scene();
    scene.image.size = [96; 2];
    for kind in [
        PatternKind::Checker,
        PatternKind::Stripes,
        PatternKind::Rings,
    ] {
        for scale in [0.25, 0.125, 0.1] {
            (scene.pattern.kind, scene.pattern.scale) = (kind, scale);
            for mode in [
                ShadingMode::Flat,
                ShadingMode::Interpolated,
                ShadingMode::Gouraud,
                ShadingMode::Phong,
            ] {
                scene.shading.mode = mode;
                let (off, _) = off_the_picture(&scene);
                assert!(off <= 1.0, "{kind:?} {scale} {mode:?}: {off}");
            }
        }
    }
}

/// Draws a bowl's rim of very many corners: the cost of a row does not grow with the polygon, and that of a sample of the profile
/// hardly does. The bound is some hundred times what is needed.
#[test]
fn a_polygon_of_twenty_thousand_corners_is_drawn_and_read_along_a_line() {
    let corners = 20_000_u32;
    let angle = |k: u32| f64::from(k) / f64::from(corners) * std::f64::consts::TAU;
    let vertex = |k: u32| {
        format!(
            "v {} {} {}\n",
            angle(k).cos(),
            angle(k).sin(),
            0.1 * (5.0 * angle(k)).sin()
        )
    };
    let mut text: String = (0..corners).map(vertex).collect();
    text.push('f');
    (1..=corners).for_each(|k| text.push_str(&format!(" {k}")));
    let model = read_obj(std::io::Cursor::new(text), &mut |_| {}).expect("a model");
    assert_eq!(model.face_count(), 1, "a convex polygon stays one");
    let mut scene = Scene::default();
    scene.image.size = [128; 2];
    (scene.object.kind, scene.object.path) = (ObjectKind::Obj, Some("rim.obj".into()));
    (scene.shading.mode, scene.shading.interpolation) =
        (ShadingMode::Gouraud, Interpolation::Scanline);
    let mut renderer = Renderer::default().with_model(Some(std::sync::Arc::new(model)));
    let began = std::time::Instant::now();
    renderer.render(&scene);
    assert!(renderer.report().covered > 2000);
    let modes = vec![ShadingMode::Gouraud];
    let line = ProfileQuestion {
        modes,
        ..ProfileQuestion::new(DVec2::new(60.0, 60.0), DVec2::new(80.0, 70.0))
    };
    let profile = profile(&mut renderer, &scene, &line).expect("a line in the picture");
    assert!(
        profile
            .traces
            .iter()
            .all(|trace| trace.intensity.iter().all(|value| value.is_finite()))
    );
    assert!(began.elapsed().as_secs() < 100, "{:?}", began.elapsed());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, rng_seed: RngSeed::Fixed(1971), ..properties::config(file!()) })]

    /// Checks any quadrilateral or larger polygon: warped, concave, self-intersecting in the picture, clipped, foreshortened.
    #[test]
    fn no_value_leaves_the_range_of_the_corners(
        corners in prop::collection::vec(((-1.5..1.5f64, -1.5..1.5f64, -1.5..4.5f64), intensity()), 4..9),
        perspective in any::<bool>(),
        flat in any::<bool>(),
    ) {
        let corners: Vec<_> = corners.into_iter().map(|((x, y, z), i)| (DVec3::new(x, y, if flat { z * 0.02 } else { z }), i)).collect();
        let mut scene = polygon(&corners, Interpolation::Scanline);
        (scene.camera.eye, scene.camera.height) = (DVec3::new(0.3, 0.2, 4.0), 3.0);
        if perspective {
            scene.camera.projection = Projection::Perspective;
        }
        prop_assume!(scene.validate().is_ok());
        let (low, high) = corners.iter().fold((1.0f64, 0.0f64), |(low, high), c| (low.min(c.1), high.max(c.1)));
        let mut renderer = Renderer::default();
        renderer.keep_linear(true);
        renderer.render(&scene);
        for [r, g, b, _] in renderer.linear().iter().filter(|pixel| pixel[3] > 0.0) {
            let inside = |v: f32| (low - SINGLE..=high + SINGLE).contains(&f64::from(v));
            prop_assert!(inside(*r) && inside(*g) && inside(*b), "{r}, expected {low} to {high}");
        }
    }
}

const SQUARE: u32 = 64;

/// Returns the linear picture of a polygon whose corners, in pixels, have these intensities.
fn linear_polygon(corners: &[(DVec2, f64)], interpolation: Interpolation) -> Vec<[f32; 4]> {
    let mut scene = Scene::default();
    (scene.image.size, scene.image.background) = ([SQUARE; 2], Rgb::splat(9.0));
    (scene.camera.projection, scene.camera.height) = (Projection::Orthographic, f64::from(SQUARE));
    let half = f64::from(SQUARE / 2);
    scene.object.kind = ObjectKind::Polygons;
    scene.object.vertices = corners
        .iter()
        .map(|(at, _)| DVec3::new(at.x - half, half - at.y, 0.0))
        .collect();
    // Under light along −z, I is the normal's z.
    scene.object.vertex_normals = corners
        .iter()
        .map(|(_, i)| DVec3::new((1.0 - i * i).sqrt(), 0.0, *i))
        .collect();
    scene.object.faces = vec![(0..corners.len() as u32).collect::<Shared<u32>>()].into();
    scene.object.normals = NormalSource::File;
    (scene.material.ka, scene.material.kd, scene.material.ks) = (Rgb::ZERO, Rgb::ONE, Rgb::ZERO);
    scene.material.color = Rgb::ONE;
    (scene.shading.mode, scene.shading.interpolation) = (ShadingMode::Gouraud, interpolation);
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        direction: DVec3::NEG_Z,
        ..Light::default()
    }];
    assert_eq!(scene.validate(), Ok(()));
    let mut renderer = Renderer::default();
    renderer.keep_linear(true);
    renderer.render(&scene);
    renderer.linear().to_vec()
}

/// Generates a position on the picture's grid, off the rows of the pixels' centres.
fn place() -> impl Strategy<Value = DVec2> {
    [0..16_000u32, 0..16_000u32]
        .prop_map(|xy| DVec2::from_array(xy.map(|k| (f64::from(k) + 64.0).floor() / 256.0)))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..properties::config(file!()) })]

    #[test]
    fn on_a_triangle_the_scan_line_is_affine(corners in prop::collection::vec((place(), 0.0..=1.0f64), 3)) {
        let area = (corners[1].0 - corners[0].0).perp_dot(corners[2].0 - corners[0].0);
        prop_assume!(area.abs() > 20.0);
        let (line, affine) = (linear_polygon(&corners, Interpolation::Scanline), linear_polygon(&corners, Interpolation::Affine));
        for (line, affine) in line.iter().zip(&affine) {
            prop_assert!((line[0] - affine[0]).abs() < 1e-5, "{line:?} {affine:?}");
        }
    }

    #[test]
    fn on_a_quadrilateral_it_is_bilinear(parts in prop::collection::vec((0u32..3000, 0.0..=1.0f64), 4)) {
        // A corner on each side of the picture, counter-clockwise, a quarter of a pixel off the centres' rows.
        let along = |k: usize| f64::from(parts[k].0) / 256.0 + 20.25;
        let at = [
            DVec2::new(1.25, along(0)), DVec2::new(along(1), 62.25), DVec2::new(62.25, along(2)), DVec2::new(along(3), 1.25),
        ];
        prop_assume!([0, 2].iter().all(|&k| (at[k].y.fract() - 0.5).abs() > 0.01));
        let corners: Vec<_> = at.into_iter().zip(parts).map(|(at, (_, i))| (at, i)).collect();
        let picture = linear_polygon(&corners, Interpolation::Scanline);
        for (k, pixel) in (0u32..).zip(&picture).filter(|(_, pixel)| pixel[0] < 2.0) {
            let centre = DVec2::new(f64::from(k % SQUARE), f64::from(k / SQUARE)) + 0.5;
            let expected = bilinear(&corners, centre);
            prop_assert!((f64::from(pixel[0]) - expected).abs() < 1e-5, "{centre}: {pixel:?}, expected {expected}");
        }
    }
}
