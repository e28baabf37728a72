//! The built-in shapes: topology, orientation, size, and normals against the closed forms.

use crate::common::properties;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use shading_lab::geometry::{Mesh, divisions_for, tessellate, triangles};
use shading_lab::scene::{Choice, NormalSource, Object, ObjectKind, Scene, Weighting};
use std::collections::HashSet;
use std::f64::consts::PI;

const CLOSED: [ObjectKind; 5] = [
    ObjectKind::Sphere,
    ObjectKind::Torus,
    ObjectKind::Cylinder,
    ObjectKind::Cone,
    ObjectKind::Cube,
];

fn mesh(kind: ObjectKind, segments: u32, rings: u32) -> Mesh {
    tessellate(&Object {
        kind,
        segments,
        rings,
        ..Object::default()
    })
}

fn euler_characteristic(mesh: &Mesh) -> i64 {
    let mut edges = HashSet::new();
    let mut points = HashSet::new();
    for f in 0..mesh.face_count() {
        let face = mesh.face(f);
        for (k, corner) in face.iter().enumerate() {
            let next = face[(k + 1) % face.len()].position;
            points.insert(corner.position);
            edges.insert((corner.position.min(next), corner.position.max(next)));
        }
    }
    assert_eq!(points.len(), mesh.positions.len(), "every point is used");
    points.len() as i64 - edges.len() as i64 + mesh.face_count() as i64
}

/// Returns the distance from the surface, by its implicit equation; its gradient on the surface is the normal.
fn implicit(kind: ObjectKind, p: DVec3) -> f64 {
    let radial = DVec2::new(p.x, p.z).length();
    match kind {
        ObjectKind::Sphere => p.length() - 1.0,
        ObjectKind::Torus => DVec2::new(radial - 0.7, p.y).length() - 0.3,
        ObjectKind::Cylinder => (radial - 0.6).max(p.y.abs() - 0.8),
        ObjectKind::Cone => ((2.0 * radial + p.y - 1.0) / 5f64.sqrt()).max(-0.6 - p.y),
        ObjectKind::Cube => p.abs().max_element() - 1.0 / 3f64.sqrt(),
        ObjectKind::Plane => p.z,
        _ => unreachable!(),
    }
}

#[test]
fn closed_shapes_have_the_right_topology() {
    for kind in CLOSED {
        for (segments, rings) in [(3, 1), (3, 2), (4, 3), (7, 5), (32, 16), (13, 40)] {
            let mesh = mesh(kind, segments, rings);
            let expected = if kind == ObjectKind::Torus { 0 } else { 2 };
            assert_eq!(
                euler_characteristic(&mesh),
                expected,
                "{kind:?} {segments} × {rings}"
            );
            assert!(
                mesh.closed && mesh.clone().with_closedness_detected().closed,
                "{kind:?} {segments} × {rings}"
            );
            assert_eq!(mesh.convex, kind != ObjectKind::Torus);
        }
    }
    let plane = mesh(ObjectKind::Plane, 5, 4);
    assert_eq!(euler_characteristic(&plane), 1);
    assert!(!plane.closed && !plane.convex && !plane.with_closedness_detected().closed);
}

#[test]
fn a_reversed_or_torn_mesh_is_not_closed() {
    let mut reversed = mesh(ObjectKind::Torus, 8, 8);
    for f in 0..reversed.face_count() {
        let range = reversed.starts[f] as usize..reversed.starts[f + 1] as usize;
        reversed.corners[range].reverse();
    }
    assert!(reversed.signed_volume() < 0.0);
    assert!(!reversed.with_closedness_detected().closed);

    let mut torn = mesh(ObjectKind::Sphere, 8, 8);
    torn.starts.pop();
    assert!(!torn.with_closedness_detected().closed);

    // A large sphere outwards and a small one inside out: the total volume is positive, one part is not.
    let mut two = mesh(ObjectKind::Sphere, 8, 8);
    let (points, corners) = (two.positions.len() as u32, two.corners.clone());
    two.positions
        .extend(two.positions.clone().iter().map(|p| *p * 0.5));
    for window in two.starts.clone().windows(2) {
        for corner in corners[window[0] as usize..window[1] as usize].iter().rev() {
            let mut corner = *corner;
            corner.position += points;
            two.corners.push(corner);
        }
        two.starts.push(two.corners.len() as u32);
    }
    assert!(two.signed_volume() > 0.0);
    assert!(!two.with_closedness_detected().closed);
}

#[test]
fn volumes_converge_to_the_analytic_ones_from_below() {
    let analytic = [
        4.0 / 3.0 * PI,
        2.0 * PI * PI * 0.7 * 0.09,
        PI * 0.36 * 1.6,
        PI * 0.64 * 1.6 / 3.0,
        (2.0 / 3f64.sqrt()).powi(3),
    ];
    for (kind, analytic) in CLOSED.into_iter().zip(analytic) {
        let errors = [16, 32, 64].map(|n| 1.0 - mesh(kind, n, n).signed_volume() / analytic);
        assert!(errors.iter().all(|e| *e > -1e-6), "{kind:?} {errors:?}");
        assert!(errors[2] < 0.01, "{kind:?} {errors:?}");
        if kind != ObjectKind::Cube {
            let order = (errors[1] / errors[2]).log2();
            assert!(
                (order - 2.0).abs() < 0.05,
                "{kind:?} converges with order {order}"
            );
        }
    }
}

#[test]
fn the_sphere_has_the_documented_layout() {
    let (segments, rings) = (5, 4);
    let mesh = mesh(ObjectKind::Sphere, segments, rings);
    let at = |i: u32, j: u32| {
        let (theta, phi) = (
            PI * f64::from(j) / f64::from(rings),
            2.0 * PI * f64::from(i) / f64::from(segments),
        );
        DVec3::new(
            theta.sin() * phi.sin(),
            theta.cos(),
            theta.sin() * phi.cos(),
        )
    };
    for j in 0..rings {
        for i in 0..segments {
            let mut expected = vec![at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
            if j == 0 {
                expected.pop();
            } else if j == rings - 1 {
                expected.remove(2);
            }
            let face = mesh.face((j * segments + i) as usize);
            assert_eq!(face.len(), expected.len());
            for (corner, expected) in face.iter().zip(expected) {
                let position = mesh.positions[corner.position as usize].as_dvec3();
                assert!(position.distance(expected) < 1e-7, "{position} {expected}");
            }
        }
    }
}

#[test]
fn points_lie_on_the_surface_and_normals_are_its_gradient() {
    for kind in CLOSED.into_iter().chain([ObjectKind::Plane]) {
        let mesh = mesh(kind, 24, 10);
        for f in 0..mesh.face_count() {
            let centre = mesh.face_centre(f);
            for corner in mesh.face(f) {
                let p = mesh.positions[corner.position as usize].as_dvec3();
                let n = mesh.normals[corner.normal as usize].as_dvec3();
                assert!(implicit(kind, p).abs() < 1e-7, "{kind:?} {p}");
                assert!((n.length() - 1.0).abs() < 1e-6);
                // The gradient slightly inside the face, away from creases.
                let q = p.lerp(centre, 1e-3);
                let step = 1e-6;
                let along =
                    |axis: DVec3| implicit(kind, q + axis * step) - implicit(kind, q - axis * step);
                let gradient =
                    DVec3::new(along(DVec3::X), along(DVec3::Y), along(DVec3::Z)) / (2.0 * step);
                let tolerance = if kind == ObjectKind::Cone && p.y > 0.99 {
                    0.2
                } else {
                    2e-3
                };
                assert!(
                    gradient.normalize().distance(n) < tolerance,
                    "{kind:?} {p} {n} {gradient}"
                );
                assert!(
                    mesh.face_normal(f).dot(n) > 0.9,
                    "{kind:?}: face and normal are on one side"
                );
            }
        }
    }
}

#[test]
fn every_shape_fits_where_it_should() {
    for kind in CLOSED {
        let vertices =
            mesh(kind, 40, 20).with_vertex_normals(NormalSource::Exact, Weighting::Equal);
        assert!(
            (vertices.radius() - 1.0).abs() < 1e-6,
            "{kind:?} {}",
            vertices.radius()
        );
    }
    let plane = mesh(ObjectKind::Plane, 2, 2);
    assert!(
        plane
            .positions
            .iter()
            .all(|p| p.abs().max_element() <= 1.0 && p.z == 0.0)
    );
}

#[test]
fn counts_follow_segments_and_rings() {
    assert_eq!(
        mesh(ObjectKind::Sphere, 32, 16).triangle_count(),
        2 * 32 * 15
    );
    assert_eq!(mesh(ObjectKind::Cube, 4, 1).face_count(), 6);
    assert_eq!(
        mesh(ObjectKind::Cube, 12, 5).face_count(),
        4 * 3 * 5 + 2 * 9
    );
    assert_eq!(mesh(ObjectKind::Cylinder, 6, 1).face_count(), 8);
    assert_eq!(mesh(ObjectKind::Plane, 1, 1).face_count(), 1);
    assert_eq!(mesh(ObjectKind::Plane, 3, 2).face_count(), 6);
    assert_eq!(mesh(ObjectKind::Corrugated, 6, 3).face_count(), 18);
    assert_eq!(mesh(ObjectKind::Obj, 3, 2).face_count(), 0);
}

#[test]
fn a_smooth_shape_has_one_vertex_a_point_and_a_crease_splits_them() {
    for source in [NormalSource::Averaged, NormalSource::Exact] {
        let sphere = mesh(ObjectKind::Sphere, 32, 16).with_vertex_normals(source, Weighting::Equal);
        assert_eq!(sphere.positions.len(), 32 * 15 + 2);
    }
    let cylinder = mesh(ObjectKind::Cylinder, 32, 4);
    let averaged = cylinder.with_vertex_normals(NormalSource::Averaged, Weighting::Equal);
    let exact = cylinder.with_vertex_normals(NormalSource::Exact, Weighting::Equal);
    assert_eq!(averaged.positions.len(), 32 * 5);
    assert_eq!(exact.positions.len(), 32 * 7);
    let cube =
        mesh(ObjectKind::Cube, 4, 1).with_vertex_normals(NormalSource::Facet, Weighting::Equal);
    assert_eq!((cube.positions.len(), cube.corners.len()), (24, 24));
}

proptest! {
    #![proptest_config(properties::config(file!()))]

    #[test]
    fn any_numbers_of_divisions_work(segments in 0u32..40, rings in 0u32..40, kind in 0usize..7) {
        let kind = [CLOSED.as_slice(), &[ObjectKind::Plane, ObjectKind::Corrugated]].concat()[kind];
        let mesh = mesh(kind, segments, rings);
        prop_assert_eq!(mesh.closed, mesh.clone().with_closedness_detected().closed);
        for source in [NormalSource::Averaged, NormalSource::Exact, NormalSource::Facet, NormalSource::File] {
            for &weighting in Weighting::VALUES {
                let vertices = mesh.with_vertex_normals(source, weighting);
                prop_assert_eq!(vertices.positions.len(), vertices.normals.len());
                prop_assert!(vertices.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-6));
                prop_assert!(vertices.corners.iter().all(|&i| (i as usize) < vertices.positions.len()));
            }
        }
    }
}

/// Returns the shapes with a true surface.
fn shapes() -> impl Iterator<Item = ObjectKind> {
    ObjectKind::VALUES
        .iter()
        .copied()
        .filter(|kind| kind.has_surface())
}

#[test]
fn triangles_are_counted_as_they_are_made() {
    for kind in shapes() {
        for segments in [1, 3, 4, 7, 8, 12, 33] {
            for rings in [1, 2, 3, 5, 8, 13] {
                let object = Object {
                    kind,
                    segments,
                    rings,
                    ..Object::default()
                };
                let made = tessellate(&object).triangle_count() as u64;
                assert_eq!(triangles(&object), made, "{kind:?} {segments} × {rings}");
            }
        }
    }
}

#[test]
fn any_number_of_triangles_comes_near() {
    for kind in shapes() {
        let smallest = divisions_for(kind, 0);
        let least = triangles(&Object {
            kind,
            segments: smallest[0],
            rings: smallest[1],
            ..Object::default()
        });
        let mut before = 0;
        for step in 0..400 {
            let wanted = (1.05_f64.powi(step) as u64).max(least);
            if wanted > 20_000_000 {
                break;
            }
            let [segments, rings] = divisions_for(kind, wanted);
            let object = Object {
                kind,
                segments,
                rings,
                ..Object::default()
            };
            let found = triangles(&object);
            // Half a row, or four of them where only every fourth division counts.
            let row = if matches!(kind, ObjectKind::Cube | ObjectKind::Teapot) {
                16.0
            } else {
                2.0
            };
            let slack = row * (wanted as f64).sqrt() + 64.0;
            assert!(
                found.abs_diff(wanted) as f64 <= slack,
                "{kind:?}: {found} for {wanted}"
            );
            assert!(found >= before, "{kind:?}: {found} after {before}");
            before = found;
            let scene = Scene {
                object,
                ..Scene::default()
            };
            assert_eq!(scene.validate(), Ok(()));
        }
    }
    assert_eq!(divisions_for(ObjectKind::Sphere, 0), [3, 2]);
    assert_eq!(
        divisions_for(ObjectKind::Sphere, u64::MAX),
        [Object::MAX_DIVISIONS; 2]
    );
}
