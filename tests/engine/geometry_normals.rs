//! Vertex normals: weightings by hand, and averages without a direction.

use crate::common::{mesh, properties};
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use shading_lab::geometry::{Corner, Mesh, NO_NORMAL, VertexMesh};
use shading_lab::scene::{Choice, NormalSource, Weighting};

fn averaged(mesh: &Mesh, weighting: Weighting) -> VertexMesh {
    mesh.with_vertex_normals(NormalSource::Averaged, weighting)
}

/// Returns three faces of a box that meet at point 0: z = 0 as two triangles, x = 0 a unit square, y = 0 twice as large.
fn box_corner() -> Mesh {
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, -1.0],
        [0.0, 1.0, -1.0],
        [0.0, 0.0, -2.0],
        [1.0, 0.0, -2.0],
    ];
    mesh(
        &positions,
        &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 5, 4], &[0, 6, 7, 1]],
    )
}

#[test]
fn weightings_by_hand() {
    // Normals +z twice (areas ½, angles 45°), −x (area 1, 90°), −y (area 2, 90°).
    let expected = [
        (Weighting::Equal, DVec3::new(-1.0, -1.0, 2.0)),
        (Weighting::Area, DVec3::new(-1.0, -2.0, 1.0)),
        (Weighting::Angle, DVec3::new(-1.0, -1.0, 1.0)),
    ];
    for (weighting, sum) in expected {
        let found = averaged(&box_corner(), weighting).normals[0].as_dvec3();
        assert!(
            found.distance(sum.normalize()) < 1e-6,
            "{weighting:?}: {found}"
        );
    }
}

#[test]
fn a_reflex_corner_weighs_by_its_inside() {
    // An L in the plane z = 0 with 270° at point 0, and a wall x = 0 with 90° there.
    let positions = [
        [0.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 1.0, 1.0],
    ];
    let mesh = mesh(&positions, &[&[0, 1, 2, 3, 4, 5], &[0, 1, 7, 6]]);
    let found = averaged(&mesh, Weighting::Angle).normals[0].as_dvec3();
    assert!(
        found.distance(DVec3::new(1.0, 0.0, 3.0).normalize()) < 1e-6,
        "{found}"
    );
}

#[test]
fn opposed_and_empty_faces_still_give_a_direction() {
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [5.0, 5.0, 5.0],
    ];
    for &weighting in Weighting::VALUES {
        let opposed = averaged(
            &mesh(&positions, &[&[1, 1, 2], &[0, 2, 1], &[0, 1, 2]]),
            weighting,
        );
        assert_eq!(
            opposed.normals[0],
            Vec3::NEG_Z,
            "the first face with an area"
        );
        assert_eq!(opposed.normals[3], Vec3::Z, "no face at all");
        let empty = averaged(&mesh(&positions, &[&[0, 1, 1]]), weighting);
        assert_eq!(empty.normals, vec![Vec3::Z; 4]);
    }
    let facets =
        mesh(&positions, &[&[0, 1, 1]]).with_vertex_normals(NormalSource::Facet, Weighting::Equal);
    assert_eq!(facets.normals, vec![Vec3::Z; 3]);
}

#[test]
fn many_normals_at_one_point_are_told_apart_quickly() {
    // A fan of 20 000 triangles with a normal each: searching them pair by pair would take minutes.
    let count = 20_000u32;
    let mut fan = Mesh {
        starts: vec![0],
        positions: vec![Vec3::ZERO],
        ..Mesh::default()
    };
    for k in 0..count {
        let (sin, cos) = (k as f32 / count as f32 * 6.0).sin_cos();
        fan.positions.push(Vec3::new(cos, sin, 0.0));
        fan.normals.push(Vec3::new(cos, sin, 1.0).normalize());
        let next = (k + 1) % count;
        fan.corners
            .extend([0, k + 1, next + 1].map(|position| Corner {
                position,
                normal: k,
            }));
        fan.starts.push(fan.corners.len() as u32);
    }
    let vertices = fan.with_vertex_normals(NormalSource::Exact, Weighting::Equal);
    let at_the_hub = vertices
        .positions
        .iter()
        .filter(|p| **p == Vec3::ZERO)
        .count();
    assert!(at_the_hub > 19_900);
    for f in 0..vertices.face_count() {
        assert!(
            vertices
                .face(f)
                .iter()
                .all(|&v| vertices.normals[v as usize] == fan.normals[f])
        );
    }
}

#[test]
fn face_normal_and_centre() {
    let mesh = Mesh {
        origin: DVec3::new(1e9, 0.0, 0.0),
        ..box_corner()
    };
    assert_eq!(mesh.face_normal(2), DVec3::NEG_X);
    assert_eq!(mesh.face_centre(3), DVec3::new(1e9 + 0.5, 0.0, -1.0));
    let vertices = averaged(&mesh, Weighting::Equal);
    assert_eq!(
        (vertices.face_normal(2), vertices.face_centre(3)),
        (mesh.face_normal(2), mesh.face_centre(3))
    );
    assert_eq!((mesh.triangle_count(), vertices.triangle_count()), (6, 6));
    assert_eq!(<Mesh>::default().face_count(), 0);
}

proptest! {
    #![proptest_config(properties::config(file!()))]

    #[test]
    fn normals_are_unit_whatever_the_faces(
        points in proptest::collection::vec((-3i8..3, -3i8..3, -3i8..3), 1..9),
        scale in -37i32..37,
        faces in proptest::collection::vec(proptest::collection::vec((0usize..9, any::<bool>()), 1..7), 0..12)
    ) {
        let size = 10f32.powi(scale);
        let mut mesh = Mesh { starts: vec![0], normals: vec![Vec3::X], ..Mesh::default() };
        mesh.positions = points.iter().map(|p| Vec3::new(p.0.into(), p.1.into(), p.2.into()) * size).collect();
        for face in &faces {
            mesh.corners.extend(face.iter().map(|&(p, given)| Corner {
                position: (p % points.len()) as u32,
                normal: if given { 0 } else { NO_NORMAL },
            }));
            mesh.starts.push(mesh.corners.len() as u32);
        }
        for source in [NormalSource::Averaged, NormalSource::File, NormalSource::Facet] {
            for &weighting in Weighting::VALUES {
                let vertices = mesh.with_vertex_normals(source, weighting);
                prop_assert!(vertices.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-6));
                let farthest = vertices.positions.iter().map(|p| p.as_dvec3().length()).fold(0.0, f64::max);
                prop_assert!(farthest <= vertices.radius());
            }
        }
        prop_assert!(mesh.clone().fitted().positions.iter().all(|p| p.length() < 1.0 + 1e-6));
        let _ = mesh.with_closedness_detected();
    }
}
