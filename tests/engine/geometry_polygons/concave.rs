//! Concave polygons of random outlines: each stays one polygon, whatever triangles cover it.
//!
//! An outline lies on the picture's position grid, off the rows and columns of the pixels' centres, so that the double-precision
//! results here hold for every pixel.

use crate::common::dice::Dice;
use crate::common::tries::tries;
use glam::{DVec2, DVec3};
use shading_lab::analysis::normals::NormalField;
use shading_lab::analysis::probe::probe;
use shading_lab::analysis::scan::{Grid, scan_in_grid};
use shading_lab::geometry::{Mesh, NormalOrigin, read_obj, tessellate};
use shading_lab::render::{Per, Renderer};
use shading_lab::scene::{
    Backfacing, Camera, Choice, Interpolation, Light, LightKind, NormalSource, Object, ObjectKind,
    Projection, Rgb, Scene, ShadingMode, View, Weighting,
};
use std::collections::HashMap;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Side of the picture in pixels, and in world units.
const SIDE: u32 = 96;
/// Error of single precision for values between 0 and 1.
const SINGLE: f64 = 2e-5;

/// Returns a concave outline of `corners` corners, in pixels from the picture's middle, y upwards, counter-clockwise.
fn outline(dice: &mut Dice, corners: u32) -> Vec<DVec2> {
    let angle = |k: u32| TAU * f64::from(k) / f64::from(corners);
    let mut points: Vec<DVec2> = match dice.of(&[0, 1, 2, 3]) {
        0 => {
            let star = (0..corners).map(|k| DVec2::from_angle(angle(k)) * dice.between(8.0, 44.0));
            star.collect()
        }
        1 => {
            // Convex but for some corners.
            let mut pulled_in = |k: u32| k % 4 == 1 && dice.unit() < 0.5 || k == 1;
            let place = |k: u32| {
                let share = if pulled_in(k) { 0.4 } else { 1.0 };
                DVec2::from_angle(angle(k)) * DVec2::new(44.0, 36.0) * share
            };
            (0..corners).map(place).collect()
        }
        2 => comb(dice, corners),
        _ => spiral(corners),
    };
    let first = (dice.unit() * points.len() as f64) as usize;
    points.rotate_left(first);
    // Odd multiples of the grid's step: no centre has such a coordinate.
    let on_grid = |p: DVec2| ((p * 128.0).floor() * 2.0 + 1.0) / 256.0;
    points.into_iter().map(on_grid).collect()
}

/// Returns teeth of random lengths on a bar; surplus corners lie on its straight lower edge.
fn comb(dice: &mut Dice, corners: u32) -> Vec<DVec2> {
    if corners < 8 {
        let arrow = [[-40.0, -40.0], [0.0, -10.0], [40.0, -40.0], [0.0, 40.0]];
        return arrow.map(DVec2::from_array).to_vec();
    }
    let teeth = (corners - 2) / 4;
    let width = 88.0 / f64::from(2 * teeth - 1);
    let mut points = vec![DVec2::new(-44.0, -44.0)];
    let straight = corners - 2 - 4 * teeth;
    points.extend((1..=straight).map(|k| DVec2::new(-44.0 + 5.0 * f64::from(k), -44.0)));
    points.push(DVec2::new(44.0, -44.0));
    for tooth in (0..teeth).rev() {
        let (left, top) = (
            -44.0 + 2.0 * width * f64::from(tooth),
            dice.between(-20.0, 44.0),
        );
        let [right, foot] = [left + width, -30.0];
        points.extend(
            [[right, foot], [right, top], [left, top], [left, foot]].map(DVec2::from_array),
        );
    }
    points
}

/// Returns a band that winds inwards.
fn spiral(corners: u32) -> Vec<DVec2> {
    let along = (corners / 2).max(4);
    let turns = (f64::from(along) / 14.0).clamp(0.4, 4.0);
    let pitch = 40.0 / turns.max(1.0);
    let at = |k: u32, inwards: f64| {
        let share = f64::from(k) / f64::from(along - 1);
        DVec2::from_angle(TAU * turns * share) * (44.0 - pitch * turns * share * 0.95 - inwards)
    };
    let width = (0.45 * pitch).min(2.0 + 44.0 - pitch * turns * 0.95 - 2.5);
    let outer = (0..along).map(|k| at(k, 0.0));
    outer
        .chain((0..along).rev().map(|k| at(k, width)))
        .collect()
}

/// A polygon in a random plane over an outline.
struct Polygon {
    /// Positions in pixels of the picture, y downwards.
    places: Vec<DVec2>,
    corners: Vec<DVec3>,
    /// The unit normal of the plane.
    normal: DVec3,
    /// I at the corners, for shading with the normals in the file.
    intensities: Vec<f64>,
}

impl Polygon {
    /// Returns a polygon of 4 to 300 corners.
    fn random(dice: &mut Dice) -> Self {
        let corners = dice.between(2.0, 300_f64.ln()).exp().clamp(4.0, 300.0) as u32;
        let outline = outline(dice, corners);
        Self::over(dice, outline)
    }

    /// Returns a random polygon, or in one case of ten a frame as models have it, which touches itself along the way to its hole
    /// and back.
    fn random_or_frame(dice: &mut Dice, case: u64) -> Self {
        if case % 10 != 3 {
            return Self::random(dice);
        }
        let [[a, b, c, d], [e, f, g, h]] = [39.5, 17.25].map(|r: f64| {
            [[-r, -r], [r, -r], [r, r], [-r, r]].map(|p| DVec2::from_array(p) + 1.0 / 256.0)
        });
        Self::over(dice, vec![a, b, c, d, a, e, h, g, f, e])
    }

    /// Returns the polygon over an outline, with its front or its back towards the eye.
    fn over(dice: &mut Dice, mut outline: Vec<DVec2>) -> Self {
        let (a, b) = (dice.between(-1.5, 1.5), dice.between(-1.5, 1.5));
        let mut normal = DVec3::new(-a, -b, 1.0).normalize();
        if dice.unit() < 0.5 {
            outline.reverse();
            normal = -normal;
        }
        let half = f64::from(SIDE) / 2.0;
        Self {
            places: outline
                .iter()
                .map(|p| DVec2::new(half + p.x, half - p.y))
                .collect(),
            corners: outline
                .iter()
                .map(|p| p.extend(a * p.x + b * p.y))
                .collect(),
            normal,
            intensities: {
                let random: Vec<f64> = outline.iter().map(|_| dice.between(0.1, 1.0)).collect();
                // A repeated corner has the intensity of its first occurrence.
                let first = |p: &DVec2| outline.iter().position(|q| q == p).unwrap_or(0);
                outline.iter().map(|p| random[first(p)]).collect()
            },
        }
    }

    /// Returns whether a scene may hold the polygon: it has few enough corners, none of them repeated.
    fn fits_a_scene(&self) -> bool {
        let again = |k: usize| self.places[..k].contains(&self.places[k]);
        self.places.len() <= Object::MAX_CORNERS && !(0..self.places.len()).any(again)
    }

    /// Returns a scene with the polygon, as a model if a scene may not hold it, and a renderer for it.
    fn scene(&self) -> (Scene, Renderer) {
        let mut scene = Scene::default();
        (scene.image.size, scene.image.background) = ([SIDE; 2], Rgb::splat(9.0));
        scene.camera.projection = Projection::Orthographic;
        (scene.camera.eye, scene.camera.height) = (DVec3::Z * 1000.0, f64::from(SIDE));
        (scene.material.ka, scene.material.kd) = (Rgb::ZERO, Rgb::ONE);
        (scene.material.ks, scene.material.color) = (Rgb::ZERO, Rgb::ONE);
        let mut renderer = Renderer::default();
        renderer.keep_linear(true);
        // Under light along −z, I is the normal's z.
        let normals = self
            .intensities
            .iter()
            .map(|i| DVec3::new((1.0 - i * i).sqrt(), 0.0, *i));
        if self.fits_a_scene() {
            scene.object.kind = ObjectKind::Polygons;
            scene.object.vertices = self.corners.iter().copied().collect();
            scene.object.vertex_normals = normals.collect();
            scene.object.faces = vec![(0..self.corners.len() as u32).collect()].into();
            assert_eq!(scene.validate(), Ok(()));
        } else {
            let normals: Vec<DVec3> = normals.collect();
            (scene.object.kind, scene.object.path) = (ObjectKind::Obj, Some("one.obj".into()));
            renderer.set_model(Some(Arc::new(model(&[(&self.corners, &normals)]))));
        }
        (scene, renderer)
    }

    /// Returns whether the centre of each pixel is inside, row by row.
    fn coverage(&self) -> Vec<bool> {
        let centres =
            (0..SIDE * SIDE).map(|k| DVec2::new(f64::from(k % SIDE), f64::from(k / SIDE)) + 0.5);
        let mut row = (f64::NAN, Vec::new());
        let inside = centres.map(|centre| {
            if row.0 != centre.y {
                row = (centre.y, self.crossings(centre.y));
            }
            row.1.iter().filter(|(x, _)| *x <= centre.x).count() % 2 == 1
        });
        inside.collect()
    }

    /// Returns the crossings of the line at height `y` with the edges, from the left, each with I there: `(1−α)·I₁ + α·I₂`.
    fn crossings(&self, y: f64) -> Vec<(f64, f64)> {
        let count = self.places.len();
        let edges = (0..count).map(|k| (k, (k + 1) % count));
        let mut found: Vec<(f64, f64)> = edges
            .filter(|&(i, j)| (self.places[i].y < y) != (self.places[j].y < y))
            .map(|(i, j)| {
                let alpha = (y - self.places[i].y) / (self.places[j].y - self.places[i].y);
                let between = |a: f64, b: f64| (1.0 - alpha) * a + alpha * b;
                (
                    between(self.places[i].x, self.places[j].x),
                    between(self.intensities[i], self.intensities[j]),
                )
            })
            .collect();
        found.sort_by(|p, q| p.0.total_cmp(&q.0));
        found
    }

    /// Returns I by the scan line: between P and Q, the crossings on either side of the position.
    fn by_scan_line(&self, at: DVec2) -> f64 {
        let crossings = self.crossings(at.y);
        let pairs = crossings.as_chunks::<2>().0;
        let [p, q] = pairs
            .iter()
            .find(|[p, q]| p.0 <= at.x && at.x < q.0)
            .expect("a span");
        p.1 + (at.x - p.0) / (q.0 - p.0) * (q.1 - p.1)
    }
}

/// Returns a model of these polygons, each with its corners and the normals there.
fn model(polygons: &[(&[DVec3], &[DVec3])]) -> Mesh {
    let (mut points, mut faces, mut number) = (String::new(), String::new(), 0);
    for (corners, normals) in polygons {
        faces.push('f');
        for (p, n) in corners.iter().zip(*normals) {
            number += 1;
            points += &format!("v {} {} {}\nvn {} {} {}\n", p.x, p.y, p.z, n.x, n.y, n.z);
            faces += &format!(" {number}//{number}");
        }
        faces.push('\n');
    }
    read_obj((points + &faces).as_bytes(), &mut |_| {}).expect("a model")
}

fn centre_of(k: usize) -> DVec2 {
    let k = k as u32;
    DVec2::new(f64::from(k % SIDE), f64::from(k / SIDE)) + 0.5
}

#[test]
fn a_flat_polygon_has_one_shade_from_one_evaluation_and_covers_its_inside() {
    let mut dice = Dice(0x000c_0147);
    for case in 0..tries(60) {
        let polygon = Polygon::random_or_frame(&mut dice, case);
        let (mut scene, mut renderer) = polygon.scene();
        let centre = polygon.corners.iter().sum::<DVec3>() / polygon.corners.len() as f64;
        let across = polygon.normal.any_orthonormal_vector();
        let light = centre + 150.0 * polygon.normal + dice.between(-90.0, 90.0) * across;
        scene.lights = vec![Light {
            position: light,
            ..Light::default()
        }];
        scene.shading.mode = ShadingMode::Flat;
        renderer.render(&scene);
        let expected = (light - centre).normalize().dot(polygon.normal);
        let shades = renderer.linear();
        let inside = polygon.coverage();
        for (k, (shade, inside)) in shades.iter().zip(&inside).enumerate() {
            assert_eq!(shade[3] > 0.0, *inside, "case {case}: {}", centre_of(k));
        }
        let first = inside
            .iter()
            .position(|inside| *inside)
            .expect("a pixel of the polygon");
        let one = shades.iter().zip(inside).filter(|(_, inside)| *inside);
        assert!(
            one.clone().all(|(shade, _)| *shade == shades[first]),
            "case {case}"
        );
        assert!(
            (f64::from(shades[first][0]) - expected).abs() < SINGLE,
            "case {case}"
        );
        let terms = renderer.terms().into_iter();
        let lit: Vec<_> = terms
            .filter(|term| term.name.light().is_some() && term.omitted.is_none())
            .collect();
        assert!(!lit.is_empty());
        assert!(
            lit.iter()
                .all(|term| (term.per, term.evaluations) == (Per::Face, 1)),
            "{lit:?}"
        );
    }
}

#[test]
fn the_scan_line_runs_over_the_whole_polygon() {
    let mut dice = Dice(0x000c_0971);
    for case in 0..tries(40) {
        let polygon = Polygon::random_or_frame(&mut dice, case);
        let (mut scene, mut renderer) = polygon.scene();
        scene.lights = vec![Light {
            kind: LightKind::Directional,
            direction: DVec3::NEG_Z,
            ..Light::default()
        }];
        scene.object.normals = NormalSource::File;
        (scene.shading.mode, scene.shading.interpolation) =
            (ShadingMode::Gouraud, Interpolation::Scanline);
        renderer.render(&scene);
        let mut seen = 0;
        for (k, inside) in polygon.coverage().into_iter().enumerate() {
            if inside {
                let (value, at) = (f64::from(renderer.linear()[k][0]), centre_of(k));
                let expected = polygon.by_scan_line(at);
                assert!(
                    (value - expected).abs() < SINGLE,
                    "case {case}, {at}: {value}, not {expected}"
                );
                seen += 1;
                if seen % 97 == 0 {
                    let hit = probe(&mut renderer, &scene, at.x as u32, at.y as u32)
                        .hit
                        .expect("the polygon");
                    assert!(
                        (hit.sum.x - expected).abs() < SINGLE && hit.face == Some(0),
                        "case {case}, {at}"
                    );
                }
            }
        }
        assert!(seen > 50, "case {case}: {seen} pixels");
        let grid = Grid {
            columns: SIDE,
            rows: SIDE,
            scale: DVec2::ONE,
            origin: DVec2::ZERO,
        };
        let scan = scan_in_grid(&renderer, &scene, 0, grid).expect("a polygon in sight");
        assert_eq!(scan.corners.len(), polygon.corners.len());
        for line in &scan.lines {
            let own: Vec<f64> = line
                .spans
                .iter()
                .flat_map(|span| [span.p.value.x, span.q.value.x])
                .collect();
            let expected = polygon.crossings(line.centre_y());
            assert_eq!(own.len(), expected.len(), "case {case}, line {}", line.y);
            assert!(
                own.iter()
                    .zip(&expected)
                    .all(|(own, (_, i))| (own - i).abs() < SINGLE)
            );
        }
    }
}

/// Counts the sides of triangles, each in its own direction.
fn sides(mesh: &Mesh) -> HashMap<(u32, u32), i32> {
    let mut sides = HashMap::new();
    for f in 0..mesh.face_count() {
        for triangle in mesh.face_triangles(f) {
            let [a, b, c] = triangle.map(|corner| corner.position);
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *sides.entry((from, to)).or_default() += 1;
            }
        }
    }
    sides
}

#[test]
fn triangles_use_each_corner_and_share_the_edges_of_the_polygon() {
    let mut dice = Dice(0x000c_0a4c);
    for case in 0..tries(200) {
        let polygon = Polygon::random(&mut dice);
        let normals = vec![DVec3::Z; polygon.corners.len()];
        let mesh = model(&[(&polygon.corners, &normals)]);
        let corners = polygon.corners.len() as u32;
        assert_eq!(
            (mesh.face_count(), mesh.face(0).len()),
            (1, corners as usize)
        );
        let order: Vec<u32> = mesh.face(0).iter().map(|corner| corner.position).collect();
        assert_eq!(order, (0..corners).collect::<Vec<_>>(), "the file's order");
        assert_eq!(mesh.triangle_count(), corners as usize - 2);
        let sides = sides(&mesh);
        for (&(from, to), &times) in &sides {
            let outer = to == (from + 1) % corners;
            let back = sides.get(&(to, from)).copied().unwrap_or(0);
            assert_eq!(
                (times, back),
                (1, i32::from(!outer)),
                "case {case}: side {from} to {to}"
            );
        }
        assert!(
            (0..corners).all(|k| sides.contains_key(&(k, (k + 1) % corners))),
            "case {case}"
        );
    }
}

#[test]
fn what_would_take_long_to_cut_stays_a_fan() {
    let star = |corners: u32| {
        let corner = |k: u32| {
            let angle = TAU * f64::from(k) / f64::from(corners);
            (DVec2::from_angle(angle) * [1.0, 0.4][k as usize % 2]).extend(0.0)
        };
        let corners: Vec<DVec3> = (0..corners).map(corner).collect();
        model(&[(&corners, &vec![DVec3::Z; corners.len()])])
    };
    assert!(!star(2000).cut.is_empty());
    let large = star(70_000);
    assert_eq!((large.face_count(), large.cut.len()), (1, 0));
}

#[test]
fn what_is_convex_stays_a_fan() {
    for kind in [ObjectKind::Cylinder, ObjectKind::Torus, ObjectKind::Teapot] {
        assert_eq!(
            tessellate(&Object {
                kind,
                ..Object::default()
            })
            .cut,
            []
        );
    }
    let straight = "v 0 0 0\nv 0.1 0.1 0\nv 0.3 0.3 0\nv 0 1 0\nf 1 2 3 4\n";
    let mesh = read_obj(straight.as_bytes(), &mut |_| {}).expect("a model");
    assert_eq!(
        mesh.cut,
        [],
        "a corner on a straight edge, but for rounding"
    );
}

/// A U, counter-clockwise seen from +z; none of its corners sees all of it.
const U: [[f64; 2]; 8] = [
    [-0.8, 0.7],
    [-0.8, -0.7],
    [0.8, -0.7],
    [0.8, 0.7],
    [0.3, 0.7],
    [0.3, -0.2],
    [-0.3, -0.2],
    [-0.3, 0.7],
];

#[test]
fn a_u_is_one_shade_at_the_mean_of_its_corners() {
    let object = Object {
        kind: ObjectKind::Polygons,
        vertices: U.iter().map(|[x, y]| DVec3::new(*x, *y, 0.0)).collect(),
        faces: vec![(0..8).collect()].into(),
        ..Object::default()
    };
    let mut scene = Scene {
        object,
        ..Scene::default()
    };
    scene.shading.mode = ShadingMode::Flat;
    scene.lights[0].position = DVec3::new(0.3, 0.3, 0.6);
    let mut renderer = Renderer::default();
    let frame = renderer.render(&scene).clone();
    let hidden = frame.pixel(0, 0);
    let mut shades: Vec<[u8; 3]> = (0..frame.height)
        .flat_map(|y| (0..frame.width).map(move |x| (x, y)))
        .filter_map(|(x, y)| frame.pixel(x, y))
        .filter(|shade| Some(*shade) != hidden)
        .collect();
    assert!(shades.len() > 16_000, "{}", shades.len());
    shades.dedup();
    assert_eq!(shades, [[163, 55, 37]]);
}

/// Returns the U extruded from z = 0 to `height`: face 0 is its front, face 1 its back, face 2 + k the side from corner k.
fn prism(height: f64) -> Object {
    let at = |z: f64| U.iter().map(move |[x, y]| DVec3::new(*x, *y, z));
    let side = |k: u32| vec![k + 8, (k + 1) % 8 + 8, (k + 1) % 8, k];
    let faces = [(0..8).collect(), (8..16).rev().collect()].into_iter();
    Object {
        kind: ObjectKind::Polygons,
        vertices: at(height).chain(at(0.0)).collect(),
        faces: faces
            .chain((0..8).map(side))
            .map(|face: Vec<u32>| face.into())
            .collect(),
        ..Object::default()
    }
}

#[test]
fn averaged_normals_of_a_prism_count_its_caps_once_each() {
    let (height, u) = (0.5, U.map(DVec2::from_array));
    let object = prism(height);
    let mesh = tessellate(&object);
    assert!(mesh.closed && (mesh.signed_volume() - 0.5 * (1.6 * 1.4 - 0.6 * 0.9)).abs() < 1e-6);
    for &weighting in Weighting::VALUES {
        let field = NormalField::of_mesh(Arc::new(mesh.clone()), NormalSource::Averaged, weighting);
        for k in 0..8_usize {
            let [before, after] = [u[k] - u[(k + 7) % 8], u[(k + 1) % 8] - u[k]];
            let reflex = before.perp_dot(after) < 0.0;
            let outwards = |edge: DVec2| DVec3::new(edge.y, -edge.x, 0.0).normalize();
            let [cap, left, right] = match weighting {
                Weighting::Equal => [1.0; 3],
                Weighting::Area => [
                    1.6 * 1.4 - 0.6 * 0.9,
                    before.length() * height,
                    after.length() * height,
                ],
                Weighting::Angle => [if reflex { 270.0 } else { 90.0 }, 90.0, 90.0],
            };
            let expected = cap * DVec3::Z + left * outwards(before) + right * outwards(after);
            let vertex = field.vertex(k as u32).expect("a vertex");
            assert_eq!(vertex.origin, NormalOrigin::Averaged);
            let faces: Vec<u32> = vertex.faces.iter().map(|face| face.face).collect();
            let mut sides = [2 + (k as u32 + 7) % 8, 2 + k as u32];
            sides.sort_unstable();
            assert_eq!(faces, [0, sides[0], sides[1]]);
            let off = vertex.normal.angle_between(expected).to_degrees();
            assert!(off < 1e-4, "{weighting:?}, corner {k}: {off} degrees");
            assert!((vertex.faces[0].weight - cap).abs() < 1e-5);
        }
    }
}

#[test]
fn a_model_of_concave_polygons_has_the_files_numbers() {
    let normals = [DVec3::Z; 8];
    // Smaller copies side by side, five in a row, each starting one corner later.
    let shapes: Vec<Vec<DVec3>> = (0..10)
        .map(|f| {
            let middle = DVec2::new(f64::from(f % 5) * 0.4 - 0.8, f64::from(f / 5) * 0.5 - 0.25);
            let mut shape = U
                .map(|p| (0.2 * DVec2::from_array(p) + middle).extend(0.0))
                .to_vec();
            shape.rotate_left(f as usize % 8);
            shape
        })
        .collect();
    let all: Vec<(&[DVec3], &[DVec3])> = shapes.iter().map(|s| (&s[..], &normals[..])).collect();
    let mesh = Arc::new(model(&all));
    assert_eq!((mesh.face_count(), mesh.triangle_count()), (10, 60));
    let mut scene = Scene::default();
    scene.image.size = [300, 200];
    (scene.object.kind, scene.object.path) = (ObjectKind::Obj, Some("ten.obj".into()));
    let mut renderer = Renderer::default().with_model(Some(Arc::clone(&mesh)));
    renderer.render(&scene);
    assert_eq!(renderer.report().faces, 10);
    let field = NormalField::new(&renderer, &scene.object);
    let view = View::new(&scene.camera, scene.image.size);
    for (f, shape) in (0..).zip(&shapes) {
        // In the right arm, and in the bar.
        let corner = |k: usize| shape[(k + 8 - f as usize % 8) % 8];
        for inside in [(corner(2) + corner(4)) / 2.0, (corner(1) + corner(5)) / 2.0] {
            let (pixel, _) = view.project(inside).expect("before the eye");
            let hit = probe(&mut renderer, &scene, pixel.x as u32, pixel.y as u32).hit;
            assert_eq!(hit.expect("a polygon").face, Some(f));
        }
        assert_eq!(field.outline(f).len(), 8);
        for (own, given) in field.outline(f).iter().zip(shape) {
            assert!(own.distance(*given) < 1e-6);
        }
        let vertex = field.vertex(8 * f + 3).expect("a vertex");
        assert_eq!(
            vertex
                .faces
                .iter()
                .map(|face| face.face)
                .collect::<Vec<_>>(),
            [f]
        );
    }
}

/// Intersects the ray through a pixel with the polygon's plane; returns the point in the plane's own coordinates, and its depth.
fn met(view: &View, pixel: DVec2, [origin, right, up]: [DVec3; 3]) -> (DVec2, f64) {
    let (from, along) = view.ray(pixel);
    let normal = right.cross(up);
    let t = (origin - from).dot(normal) / along.dot(normal);
    let offset = from + along * t - origin;
    (
        DVec2::new(offset.dot(right), offset.dot(up)),
        t * along.dot(view.forward),
    )
}

#[test]
fn a_clipped_concave_polygon_covers_what_is_left_of_it() {
    let mut dice = Dice(0x000c_0c11);
    let (mut compared, mut clipped) = (0, 0);
    for case in 0..tries(40) {
        let corners = dice.between(4.0, 120.0) as u32;
        let outline = outline(&mut dice, corners);
        let rotation = glam::DQuat::from_euler(
            glam::EulerRot::ZYX,
            dice.between(0.0, TAU),
            dice.between(-1.2, 1.2),
            dice.between(-1.2, 1.2),
        );
        let frame = [DVec3::ZERO, rotation * DVec3::X, rotation * DVec3::Y];
        let (mut scene, mut renderer) = (Scene::default(), Renderer::default());
        scene.image.size = [64, 48];
        scene.camera = Camera {
            eye: DVec3::new(
                dice.between(-20.0, 20.0),
                dice.between(-20.0, 20.0),
                dice.between(4.0, 30.0),
            ),
            target: DVec3::new(
                dice.between(-20.0, 20.0),
                dice.between(-20.0, 20.0),
                dice.between(-9.0, 0.0),
            ),
            ..Camera::default()
        };
        scene.object.kind = ObjectKind::Polygons;
        scene.object.vertices = outline
            .iter()
            .map(|p| frame[1] * p.x + frame[2] * p.y)
            .collect();
        scene.object.faces = vec![(0..outline.len() as u32).collect()].into();
        scene.shading.mode = ShadingMode::Flat;
        scene.reflection.backfacing = Backfacing::Flip;
        assert_eq!(scene.validate(), Ok(()));
        renderer.keep_linear(true);
        renderer.render(&scene);
        clipped += u32::from(renderer.report().clipped > 0);
        let view = View::new(&scene.camera, scene.image.size);
        let inside = |place: DVec2| {
            let edges = outline.iter().zip(outline.iter().cycle().skip(1));
            let crosses = edges.filter(|(a, b)| {
                (a.y < place.y) != (b.y < place.y)
                    && place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x)
            });
            crosses.count() % 2 == 1
        };
        for (k, shade) in (0..).zip(renderer.linear()) {
            let pixel = DVec2::new(f64::from(k % 64), f64::from(k / 64)) + 0.5;
            // The grid decides next to an edge, and where a tooth is not much wider than the grid's steps.
            let (centre, depth) = met(&view, pixel, frame);
            let near = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
            let around = near.map(|by| met(&view, pixel + DVec2::from_array(by) / 32.0, frame));
            let as_centre = |(place, depth): &(DVec2, f64)| {
                let close = *depth > 0.05 && place.distance(centre) < 0.1;
                close && inside(*place) == inside(centre)
            };
            if depth > 0.05 && around.iter().all(as_centre) {
                compared += 1;
                assert_eq!(shade[3] > 0.0, inside(centre), "case {case}, {pixel}");
            }
        }
    }
    assert!(
        compared > 20_000 && clipped > 5,
        "{compared} pixels, {clipped} clipped"
    );
}
