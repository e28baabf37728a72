//! Newell's teapot: its polygons, and rays at its patches.

use crate::common::properties;
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use shading_lab::geometry::{Mesh, Ray, Surface, tessellate};
use shading_lab::scene::{NormalSource, Object, ObjectKind, Weighting};
use std::collections::{HashMap, HashSet};

fn mesh(segments: u32, rings: u32) -> Mesh {
    tessellate(&Object {
        kind: ObjectKind::Teapot,
        segments,
        rings,
        ..Object::default()
    })
}

fn surface() -> Surface {
    Surface::of(&Object {
        kind: ObjectKind::Teapot,
        ..Object::default()
    })
    .expect("the teapot has a surface")
}

fn points(mesh: &Mesh, f: usize) -> Vec<DVec3> {
    mesh.face(f)
        .iter()
        .map(|corner| mesh.positions[corner.position as usize].as_dvec3())
        .collect()
}

/// Returns term `k` of van der Corput's sequence, which spreads evenly over 0 to 1 and is reproducible.
fn spread(mut k: u32, base: u32) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0);
    while k > 0 {
        digit /= f64::from(base);
        value += digit * f64::from(k % base);
        k /= base;
    }
    value
}

/// Returns a direction spread evenly over the sphere.
fn direction(k: u32) -> DVec3 {
    let (y, turn) = (
        2.0 * spread(k, 2) - 1.0,
        std::f64::consts::TAU * spread(k, 3),
    );
    let radial = (1.0 - y * y).sqrt();
    DVec3::new(radial * turn.sin(), y, radial * turn.cos())
}

#[test]
fn it_has_the_published_size() {
    let mesh = mesh(128, 128);
    let start = mesh.positions[0];
    let (low, high) = mesh
        .positions
        .iter()
        .fold((start, start), |(l, h), p| (l.min(*p), h.max(*p)));
    // Handle to spout, base to knob, and across, in the units of the listing; the spout's lip is at 3.43404.
    let expected = [
        (-3.0 - 0.217, 3.434_04 - 0.217),
        (-1.575, 1.575),
        (-2.0, 2.0),
    ];
    for (axis, (least, most)) in expected.into_iter().enumerate() {
        assert!(
            (f64::from(low[axis]) - least / 3.35).abs() < 1e-5,
            "{axis} {low}"
        );
        assert!(
            (f64::from(high[axis]) - most / 3.35).abs() < 1e-5,
            "{axis} {high}"
        );
    }
    assert!(mesh.positions.iter().all(|p| p.length() < 1.0));
}

#[test]
fn neighbouring_patches_share_their_edges_and_only_the_six_openings_are_open() {
    for (segments, rings) in [(4, 4), (12, 8), (32, 16), (8, 40)] {
        let mesh = mesh(segments, rings);
        let mut edges: HashMap<(u32, u32), i32> = HashMap::new();
        for f in 0..mesh.face_count() {
            let face = mesh.face(f);
            assert!(mesh.face_normal(f) != DVec3::ZERO, "face {f} has no area");
            for (k, corner) in face.iter().enumerate() {
                let (a, b) = (corner.position, face[(k + 1) % face.len()].position);
                assert_ne!(a, b);
                let (count, other) = (edges.entry((a, b)).or_default(), (b, a));
                *count += 1;
                assert_eq!(*count, 1, "edge {a} {b} is used twice in one direction");
                edges.entry(other).or_default();
            }
        }
        // Inside of the rim, outside of the lid: four patches round. Both ends of handle and spout: two patches round.
        let open = edges.values().filter(|count| **count == 0).count();
        assert_eq!(
            open as u32,
            8 * (segments / 4) + 8 * (segments / 4).max(2),
            "{segments} × {rings}"
        );
        assert!(!mesh.closed && !mesh.clone().with_closedness_detected().closed);

        let mut distinct: Vec<[u32; 3]> = mesh
            .positions
            .iter()
            .map(|p| p.to_array().map(f32::to_bits))
            .collect();
        distinct.sort_unstable();
        distinct.dedup();
        // The handle touches the body in one point without being joined to it.
        assert!(mesh.positions.len() - distinct.len() <= 1);
    }
}

/// Returns the points of the 32 patches, each with those of its faces in their order.
fn patches(mesh: &Mesh) -> Vec<Vec<DVec3>> {
    let per_patch = mesh.face_count() / 32;
    let faces: Vec<usize> = (0..mesh.face_count()).collect();
    let patch = |faces: &[usize]| faces.iter().flat_map(|f| points(mesh, *f)).collect();
    faces.chunks(per_patch).map(patch).collect()
}

#[test]
fn body_and_lid_have_fourfold_symmetry_and_handle_and_spout_are_mirrored() {
    let patches = patches(&mesh(8, 8));
    let axis = DVec3::X * (-0.217 / 3.35);
    for (first, sense) in [
        (0, 1.0),
        (4, 1.0),
        (8, 1.0),
        (20, 1.0),
        (24, 1.0),
        (28, -1.0),
    ] {
        for patch in first..first + 3 {
            for (p, next) in patches[patch].iter().zip(&patches[patch + 1]) {
                let turned = DVec3::new(-sense * p.z, p.y, sense * (p.x - axis.x)) + axis;
                assert!(turned.distance(*next) < 1e-6, "patch {patch}");
            }
        }
    }
    for first in [12, 14, 16, 18] {
        for p in &patches[first] {
            let mirrored = *p * DVec3::new(1.0, 1.0, -1.0);
            let distances = patches[first + 1].iter().map(|q| q.distance(mirrored));
            assert!(distances.fold(1.0, f64::min) < 1e-6, "patch {first}");
        }
    }
}

#[test]
fn all_patches_face_outwards() {
    let (segments, rings) = (32, 32);
    let mesh = mesh(segments, rings);
    let per_patch = mesh.face_count() / 32;
    let axis = DVec3::X * (-0.217 / 3.35);
    let (mut f, mut seen) = (0, 0);
    for patch in 0..32 {
        for _ in 0..per_patch {
            let (n, centre) = (mesh.face_normal(f), mesh.face_centre(f));
            let outward = match patch {
                4..12 => n.dot((centre - axis) * DVec3::new(1.0, 0.0, 1.0)) > 0.0,
                12..18 => n.z.abs() < 0.3 || n.z.signum() == centre.z.signum(),
                24..28 => n.dot(centre + DVec3::Y - axis) > 0.0,
                28..32 => n.y < 0.0,
                _ => true,
            };
            assert!(outward, "patch {patch}: {centre} {n}");
            for (corner, p) in mesh.face(f).iter().zip(points(&mesh, f)) {
                let exact = mesh.normals[corner.normal as usize].as_dvec3();
                assert!((exact.length() - 1.0).abs() < 1e-6);
                assert!(exact.dot(n) > 0.0, "patch {patch}: {p} {n} {exact}");
                seen += 1;
            }
            f += 1;
        }
    }
    assert_eq!(f, mesh.face_count());
    assert!(seen > 8000);
}

#[test]
fn the_poles_of_lid_and_bottom_have_their_limit_normals() {
    let vertices = mesh(32, 16).with_vertex_normals(NormalSource::Exact, Weighting::Equal);
    let axis = -0.217 / 3.35f32;
    for (y, expected) in [(1.575 / 3.35, Vec3::Y), (-1.575 / 3.35, Vec3::NEG_Y)] {
        let pole = Vec3::new(axis, y, 0.0);
        let at: Vec<usize> = (0..vertices.positions.len())
            .filter(|&v| vertices.positions[v].distance(pole) < 1e-6)
            .collect();
        assert_eq!(at.len(), 1, "one vertex at the pole {pole}");
        assert!(vertices.normals[at[0]].distance(expected) < 1e-6);
    }
}

#[test]
fn smooth_seams_have_one_vertex_and_averaged_normals_near_the_exact_ones() {
    let mesh = mesh(64, 64);
    let exact = mesh.with_vertex_normals(NormalSource::Exact, Weighting::Equal);
    let averaged = mesh.with_vertex_normals(NormalSource::Averaged, Weighting::Angle);
    assert_eq!(averaged.positions.len(), mesh.positions.len());
    // Rim and body, lid and knob, body and bottom meet in creases: few points, round the pot, have two normals.
    assert!(
        exact.positions.len() - mesh.positions.len() < 8 * 64,
        "{}",
        exact.positions.len() - mesh.positions.len()
    );
    let mut far = 0;
    for (c, corner) in mesh.corners.iter().enumerate() {
        let average = averaged.normals[corner.position as usize];
        far += usize::from(average.distance(exact.normals[exact.corners[c] as usize]) > 0.1);
    }
    assert!(
        far * 20 < mesh.corners.len(),
        "{far} of {}",
        mesh.corners.len()
    );
}

/// Returns the points on edges with a face on one side only.
fn border(mesh: &Mesh) -> HashSet<u32> {
    let mut edges = HashSet::new();
    for f in 0..mesh.face_count() {
        let face = mesh.face(f);
        edges.extend(
            (0..face.len()).map(|k| (face[k].position, face[(k + 1) % face.len()].position)),
        );
    }
    edges
        .iter()
        .filter(|(a, b)| !edges.contains(&(*b, *a)))
        .flat_map(|(a, b)| [*a, *b])
        .collect()
}

#[test]
fn a_ray_at_any_point_of_the_pot_meets_it_there() {
    let (mesh, surface) = (mesh(40, 40), surface());
    let border = border(&mesh);
    let (mut tried, mut k) = (0, 0);
    for corner in &mesh.corners {
        k += 1;
        // There rounding may take the point off the surface.
        if border.contains(&corner.position) {
            continue;
        }
        let p = mesh.positions[corner.position as usize].as_dvec3();
        let n = mesh.normals[corner.normal as usize].as_dvec3();
        let d = direction(k);
        if n.dot(d).abs() < 0.1 {
            continue;
        }
        tried += 1;
        let ray = Ray {
            origin: p - 3.0 * d,
            direction: d,
        };
        let first = surface
            .intersect(&ray, 0.0)
            .unwrap_or_else(|| panic!("{p} from {d} is missed"));
        assert!(first.t < 3.0 + 1e-5);
        // Points are rounded to single precision; along the ray that is 10⁻⁷ over the cosine.
        let hit = surface
            .intersect(&ray, 3.0 - 1e-5)
            .unwrap_or_else(|| panic!("{p} from {d} is missed, n {n}"));
        assert!((hit.t - 3.0).abs() < 1e-5, "{p} from {d}: {}", hit.t);
    }
    assert!(tried > 10_000);
}

/// Returns t and the normal at the first triangle that a ray meets.
fn by_triangles(mesh: &Mesh, ray: &Ray) -> Option<(f64, DVec3)> {
    let mut nearest: Option<(f64, DVec3)> = None;
    for f in 0..mesh.face_count() {
        let p = points(mesh, f);
        for k in 1..p.len() - 1 {
            let (e1, e2) = (p[k] - p[0], p[k + 1] - p[0]);
            let normal = e1.cross(e2);
            let t = (p[0] - ray.origin).dot(normal) / ray.direction.dot(normal);
            let q = ray.origin + t * ray.direction - p[0];
            let (a, b) = (q.cross(e2).dot(normal), e1.cross(q).dot(normal));
            let inside = a >= 0.0 && b >= 0.0 && a + b <= normal.length_squared();
            if inside && t > 0.0 && nearest.is_none_or(|(other, _)| t < other) {
                nearest = Some((t, normal.normalize()));
            }
        }
    }
    nearest
}

#[test]
fn hits_agree_with_a_fine_mesh() {
    let (mesh, surface) = (mesh(96, 96), surface());
    let (mut both, mut one) = (0, 0);
    for k in 1..400 {
        let origin = 2.5 * direction(k);
        let target = DVec3::new(
            1.9 * spread(k, 5) - 0.95,
            0.9 * spread(k, 7) - 0.45,
            1.1 * spread(k, 11) - 0.55,
        );
        let ray = Ray {
            origin,
            direction: target - origin,
        };
        match (surface.intersect(&ray, 0.0), by_triangles(&mesh, &ray)) {
            (Some(hit), Some((t, normal))) => {
                let cosine = hit.normal.dot(ray.direction.normalize()).abs();
                let error = (hit.t - t).abs() * ray.direction.length() * cosine;
                if error < 1e-3 {
                    both += 1;
                    assert!(
                        cosine < 0.1 || hit.normal.dot(normal) > 0.98,
                        "{k}: {normal} {}",
                        hit.normal
                    );
                } else {
                    one += 1;
                }
            }
            (None, None) => {}
            _ => one += 1,
        }
    }
    // Only a ray near an outline can tell the mesh from the surface.
    assert!(both > 200 && one <= 2, "{both} agree, {one} do not");
}

#[test]
fn normals_are_those_of_the_points_hit() {
    let surface = surface();
    let mut checked = 0;
    for k in 1..2000 {
        let d = -direction(k);
        let (across, up) = d.any_orthonormal_pair();
        let origin = -2.0 * d + across * (spread(k, 5) - 0.5) + up * (spread(k, 7) - 0.5);
        let h = 1e-5;
        let at = |offset: DVec3| {
            let ray = Ray {
                origin: origin + offset,
                direction: d,
            };
            surface
                .intersect(&ray, 0.0)
                .map(|hit| (ray.origin + hit.t * d, hit.normal))
        };
        let hits = [DVec3::ZERO, h * across, -h * across, h * up, -h * up].map(at);
        let [
            Some((_, normal)),
            Some((r, _)),
            Some((l, _)),
            Some((u, _)),
            Some((b, _)),
        ] = hits
        else {
            continue;
        };
        if normal.dot(d).abs() < 0.3 {
            continue;
        }
        let difference = (r - l).cross(u - b).normalize();
        // A crease or an outline between the five rays falsifies the difference quotient, not the normal.
        let bent = r.distance(l).max(u.distance(b)) > 20.0 * h;
        if !bent {
            checked += 1;
            assert!(
                difference.dot(normal).abs() > 1.0 - 1e-5,
                "{k}: {normal} {difference}"
            );
        }
    }
    assert!(checked > 400, "{checked}");
}

#[test]
fn from_inside_the_normals_still_point_outwards() {
    let inside = DVec3::new(-0.05, -0.2, 0.0);
    let surface = surface();
    for k in 1..500 {
        let ray = Ray {
            origin: inside,
            direction: direction(k),
        };
        if ray.direction.y < 0.3 {
            let hit = surface
                .intersect(&ray, 0.0)
                .expect("below the rim the pot surrounds its inside");
            assert!(hit.normal.dot(ray.direction) > 0.0);
        }
    }
}

proptest! {
    #![proptest_config(properties::config(file!()))]

    #[test]
    fn hits_are_finite_and_beyond_t_min(
        numbers in proptest::collection::vec(
            prop_oneof![4 => -1.5..1.5, 1 => Just(0.0), 1 => Just(1.575 / 3.35), 1 => Just(f64::NAN), 1 => Just(1e9)], 7)
    ) {
        let ray = Ray {
            origin: DVec3::new(numbers[0], numbers[1], numbers[2]),
            direction: DVec3::new(numbers[3], numbers[4], numbers[5]),
        };
        if let Some(hit) = surface().intersect(&ray, numbers[6]) {
            prop_assert!(hit.t.is_finite() && (hit.normal.length() - 1.0).abs() < 1e-12);
            prop_assert!(hit.t > numbers[6] || (hit.t - numbers[6]).abs() <= 1e-9 * hit.t.abs());
        }
    }
}
