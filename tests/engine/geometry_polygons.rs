//! Polygons given in the scene, and the corrugated sheet.

mod concave;

use crate::common::properties;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use shading_lab::geometry::{Mesh, Ray, Surface, tessellate};
use shading_lab::render::{Renderer, Stage};
use shading_lab::scene::{Choice, NormalSource, Object, ObjectKind, Scene, ShadingMode, Weighting};

fn polygons(vertices: &[[f64; 3]], faces: &[&[u32]]) -> Object {
    Object {
        kind: ObjectKind::Polygons,
        vertices: vertices.iter().copied().map(DVec3::from_array).collect(),
        faces: faces.iter().map(|face| face.to_vec().into()).collect(),
        ..Object::default()
    }
}

fn faces(mesh: &Mesh) -> Vec<Vec<u32>> {
    (0..mesh.face_count())
        .map(|f| mesh.face(f).iter().map(|corner| corner.position).collect())
        .collect()
}

/// A wall of two quads, the right one's left edge divided by vertex 6.
const T_JUNCTION: [[f64; 3]; 8] = [
    [-1.0, -1.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 1.0, 0.0],
    [-1.0, 1.0, 0.0],
    [1.0, -1.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
];

#[test]
fn vertices_are_shared_by_their_number_only() {
    let object = polygons(&T_JUNCTION, &[&[0, 1, 2, 3], &[1, 4, 7, 6], &[6, 7, 5, 2]]);
    let mesh = tessellate(&object);
    assert_eq!(
        faces(&mesh),
        [vec![0, 1, 2, 3], vec![1, 4, 7, 6], vec![6, 7, 5, 2]]
    );
    assert_eq!(mesh.positions.len(), 8);
    assert!(!mesh.closed);
    // A straight corner counts as a corner: the same wall without a gap.
    let joined = polygons(
        &T_JUNCTION,
        &[&[0, 1, 6, 2, 3], &[1, 4, 7, 6], &[6, 7, 5, 2]],
    );
    let mut scene = Scene {
        object: joined,
        ..Scene::default()
    };
    assert_eq!(scene.validate(), Ok(()));
    // Two vertices at the same position stay two, and each averages its own polygons.
    let mut tilted = T_JUNCTION.to_vec();
    tilted.extend([
        [0.0, -1.0, 0.0],
        [0.0, 1.0, 0.0],
        [1.0, -1.0, 1.0],
        [1.0, 1.0, 1.0],
    ]);
    let apart = tessellate(&polygons(&tilted, &[&[0, 1, 2, 3], &[8, 10, 11, 9]]));
    let normals = apart
        .with_vertex_normals(NormalSource::Averaged, Weighting::Equal)
        .normals;
    assert_eq!(normals[1].as_dvec3(), DVec3::Z);
    assert!(
        normals[8]
            .as_dvec3()
            .distance(DVec3::new(-1.0, 0.0, 1.0).normalize())
            < 1e-6
    );
    let shared = tessellate(&polygons(&tilted, &[&[0, 1, 2, 3], &[1, 10, 11, 2]]));
    let normals = shared
        .with_vertex_normals(NormalSource::Averaged, Weighting::Equal)
        .normals;
    assert!(normals[1].x < -0.3 && normals[1] == normals[2]);
    scene.object = Object {
        kind: ObjectKind::Polygons,
        ..Object::default()
    };
    assert_eq!(
        scene.validate(),
        Ok(()),
        "a quadrilateral stands for polygons that are not given"
    );
    assert_eq!(tessellate(&scene.object).face(0).len(), 4);
}

#[test]
fn every_source_of_normals_works() {
    let mut object = polygons(&T_JUNCTION, &[&[0, 1, 2, 3]]);
    object.vertex_normals = (0..8).map(|v| DVec3::new(f64::from(v), 0.0, 2.0)).collect();
    let normals = |source| {
        tessellate(&object)
            .with_vertex_normals(source, Weighting::Equal)
            .normals
    };
    for source in [NormalSource::File, NormalSource::Exact] {
        for (v, normal) in normals(source).iter().take(4).enumerate() {
            assert!(
                normal
                    .as_dvec3()
                    .distance(object.vertex_normals[v].normalize())
                    < 1e-6
            );
        }
    }
    for source in [NormalSource::Averaged, NormalSource::Facet] {
        assert!(
            normals(source)
                .iter()
                .take(4)
                .all(|normal| normal.as_dvec3() == DVec3::Z)
        );
    }
    object.vertex_normals = Vec::new().into();
    let plain = tessellate(&object)
        .with_vertex_normals(NormalSource::File, Weighting::Equal)
        .normals;
    assert!(
        plain
            .iter()
            .take(4)
            .all(|normal| normal.as_dvec3() == DVec3::Z),
        "averaged where none is given"
    );
}

#[test]
fn a_concave_polygon_is_covered_once_and_a_closed_one_is_noticed() {
    let arrow = [
        [-1.0, -1.0, 0.0],
        [0.0, -0.2, 0.0],
        [1.0, -1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    let object = polygons(&arrow, &[&[0, 1, 2, 3]]);
    assert_eq!(
        Scene {
            object: object.clone(),
            ..Scene::default()
        }
        .validate(),
        Ok(())
    );
    let mesh = tessellate(&object);
    assert_eq!((mesh.face_count(), mesh.triangle_count()), (1, 2));
    let area: f64 = (0..mesh.face_count()).map(|f| doubled_area(&mesh, f)).sum();
    assert!((area - 2.4).abs() < 1e-6, "they cover it once: {area}");
    let tetrahedron = [
        [1.0, 1.0, 1.0],
        [-1.0, -1.0, 1.0],
        [-1.0, 1.0, -1.0],
        [1.0, -1.0, -1.0],
    ];
    let mesh = tessellate(&polygons(
        &tetrahedron,
        &[&[0, 2, 1], &[0, 1, 3], &[0, 3, 2], &[1, 2, 3]],
    ));
    assert!(mesh.closed && mesh.signed_volume() > 0.0);
}

/// Returns twice the area of the triangles of a face.
fn doubled_area(mesh: &Mesh, f: usize) -> f64 {
    mesh.face_triangles(f)
        .map(|triangle| {
            let [a, b, c] =
                triangle.map(|corner| mesh.positions[corner.position as usize].as_dvec3());
            (b - a).cross(c - a).length()
        })
        .sum()
}

#[test]
fn what_lies_far_away_keeps_its_shape() {
    let far = T_JUNCTION.map(|[x, y, z]| [x + 1e9, y, z - 1e9]);
    let mesh = tessellate(&polygons(&far, &[&[0, 1, 2, 3]]));
    let (a, b) = (mesh.positions[0].as_dvec3(), mesh.positions[1].as_dvec3());
    assert_eq!(b - a, DVec3::X);
    assert_eq!(mesh.origin + a, DVec3::from_array(far[0]));
}

#[test]
fn a_moved_vertex_is_drawn_and_an_equal_list_is_not_drawn_anew() {
    let mut scene = Scene {
        object: polygons(&T_JUNCTION, &[&[0, 1, 2, 3]]),
        ..Scene::default()
    };
    scene.image.size = [64, 64];
    scene.shading.mode = ShadingMode::Gouraud;
    let mut renderer = Renderer::default();
    let before = renderer.render(&scene).clone();
    let geometry = |renderer: &Renderer| {
        renderer
            .report()
            .stages
            .iter()
            .any(|run| run.stage == Stage::Geometry && run.ran)
    };
    let copy = Scene {
        object: polygons(&T_JUNCTION, &[&[0, 1, 2, 3]]),
        ..scene.clone()
    };
    renderer.render(&copy);
    assert!(!geometry(&renderer));
    scene.object.vertices_mut()[2].x = 0.8;
    assert_eq!(
        copy.object.vertices[2].x, 0.0,
        "a copy keeps its own vertices"
    );
    let after = renderer.render(&scene).clone();
    assert!(geometry(&renderer) && after.pixels != before.pixels);
    assert!(after.pixels == Renderer::default().render(&scene).pixels);
    scene.object.vertex_normals = scene
        .object
        .vertices
        .iter()
        .map(|_| DVec3::new(1.0, 0.0, 1.0))
        .collect();
    scene.object.normals = NormalSource::File;
    assert!(renderer.render(&scene).pixels != after.pixels);
}

#[test]
fn exact_shading_of_polygons_is_phong_shading() {
    let object = polygons(&T_JUNCTION, &[&[0, 1, 2, 3], &[1, 4, 7, 6], &[6, 7, 5, 2]]);
    assert!(Surface::of(&object).is_none());
    let mut scene = Scene {
        object,
        ..Scene::default()
    };
    scene.image.size = [80, 80];
    let phong = Renderer::default().render(&scene).clone();
    scene.shading.mode = ShadingMode::Exact;
    let exact = Renderer::default().render(&scene).clone();
    let worst = phong
        .pixels
        .as_flattened()
        .iter()
        .zip(exact.pixels.as_flattened())
        .map(|(a, b)| a.abs_diff(*b))
        .max();
    assert!(worst <= Some(1), "{worst:?}");
}

fn sheet(slopes: u32, strips: u32) -> Object {
    Object {
        kind: ObjectKind::Corrugated,
        segments: slopes,
        rings: strips,
        ..Object::default()
    }
}

#[test]
fn undivided_slopes_average_to_one_normal_and_divided_ones_do_not() {
    for &weighting in Weighting::VALUES {
        for slopes in [2, 3, 8] {
            let vertices = tessellate(&sheet(slopes, 1))
                .with_vertex_normals(NormalSource::Averaged, weighting);
            assert_eq!(vertices.normals.len(), 2 * (slopes as usize + 1));
            assert!(
                vertices
                    .normals
                    .iter()
                    .all(|normal| normal.as_dvec3().distance(DVec3::Z) < 1e-6)
            );
        }
    }
    let vertices =
        tessellate(&sheet(8, 2)).with_vertex_normals(NormalSource::Averaged, Weighting::Equal);
    let leaning = vertices
        .normals
        .iter()
        .filter(|normal| normal.x.abs() > 0.5)
        .count();
    assert_eq!(leaning, 16, "the middle of each slope has its own normal");
    // At a ridge each slope keeps its own normal.
    let exact = tessellate(&sheet(8, 1)).with_vertex_normals(NormalSource::Exact, Weighting::Equal);
    assert_eq!(exact.positions.len(), 2 * 2 * 8);
    for f in 0..8 {
        let own = exact.face_normal(f);
        assert!(
            exact
                .face(f)
                .iter()
                .all(|&v| exact.normals[v as usize].as_dvec3().distance(own) < 1e-6)
        );
    }
    assert!(
        tessellate(&sheet(9, 3))
            .positions
            .iter()
            .all(|p| p.length() <= 1.0)
    );
}

/// Returns the height of a point above the sheet of `slopes` slopes, along z, and whether the point is over or under the sheet at
/// all.
fn above(slopes: f64, p: DVec3) -> (f64, bool) {
    let along = (p.x + 0.75) / 1.5 * slopes;
    // A triangle wave that begins in a trough.
    let z = 0.1 * (1.0 - 4.0 * ((along / 2.0).rem_euclid(1.0) - 0.5).abs()).clamp(-1.0, 1.0);
    (p.z - z, p.x.abs() <= 0.75 && p.y.abs() <= 0.65)
}

fn point(range: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..properties::config(file!()) })]

    #[test]
    fn a_ray_meets_the_sheet_where_a_search_does(slopes in 2u32..20, from in point(2.0), to in point(0.8)) {
        let surface = Surface::of(&sheet(slopes, 1)).expect("planes");
        let ray = Ray { origin: from, direction: to - from };
        let at = |t: f64| above(f64::from(slopes), from + (to - from) * t);
        let steps = 20_000;
        let change = (0..steps).map(|k| [f64::from(k), f64::from(k + 1)].map(|k| 3.0 * k / f64::from(steps))).find(|&[a, b]| {
            let ((below, inside), (above, still)) = (at(a), at(b));
            inside && still && (below > 0.0) != (above > 0.0)
        });
        let hit = surface.intersect(&ray, 0.0).filter(|hit| hit.t < 3.0);
        if let (Some([low, high]), Some(hit)) = (change, hit) {
            // A search in steps may miss two intersections at a ridge.
            prop_assert!(hit.t <= high + 1e-9);
            if hit.t < low {
                let (_, inside) = at(hit.t);
                prop_assert!(inside);
            }
        } else {
            prop_assert!(change.is_none(), "missed at {change:?}");
        }
        if let Some(hit) = hit {
            let place = from + (to - from) * hit.t;
            let (height, _) = above(f64::from(slopes), place);
            prop_assert!(height.abs() < 1e-9, "{height} off the sheet");
            prop_assert!(DVec2::new(place.x.abs() - 0.75, place.y.abs() - 0.65).max_element() < 1e-9);
            prop_assert!((hit.normal.length() - 1.0).abs() < 1e-9 && hit.normal.z > 0.0 && hit.normal.y == 0.0);
        }
    }

    #[test]
    fn no_ray_from_the_front_slips_through_a_ridge(slopes in 2u32..30, k in 0u32..30, y in -0.6..0.6f64, tilt in -0.9..0.9f64) {
        let surface = Surface::of(&sheet(slopes, 1)).expect("planes");
        let ridge = DVec3::new(1.5 * f64::from(k % (slopes + 1)) / f64::from(slopes) - 0.75, y, if k % (slopes + 1) % 2 == 0 { -0.1 } else { 0.1 });
        prop_assume!(ridge.x.abs() < 0.7);
        // Steeper than the slopes, so that it does not merely touch them.
        let direction = DVec3::new(tilt * 1.5 / f64::from(slopes) / 0.2, 0.1, -1.0);
        let ray = Ray { origin: ridge - direction * 3.0, direction };
        let reached = surface.intersect(&ray, 0.0).is_some_and(|hit| hit.t < 3.0 + 1e-9);
        prop_assert!(reached);
    }
}
