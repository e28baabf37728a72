//! The true surfaces: rays against a search along the implicit equation, and properties that any hit must have.

use crate::common::properties;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use shading_lab::geometry::{Ray, Surface};
use shading_lab::scene::{Object, ObjectKind};

const SOLIDS: [ObjectKind; 5] = [
    ObjectKind::Sphere,
    ObjectKind::Torus,
    ObjectKind::Cylinder,
    ObjectKind::Cone,
    ObjectKind::Cube,
];

fn surface(kind: ObjectKind) -> Surface {
    Surface::of(&Object {
        kind,
        ..Object::default()
    })
    .expect("a built-in shape has a surface")
}

/// Returns the value of the implicit equation: negative inside, positive outside.
fn implicit(kind: ObjectKind, p: DVec3) -> f64 {
    let radial = DVec2::new(p.x, p.z).length();
    match kind {
        ObjectKind::Sphere => p.length() - 1.0,
        ObjectKind::Torus => DVec2::new(radial - 0.7, p.y).length() - 0.3,
        ObjectKind::Cylinder => (radial - 0.6).max(p.y.abs() - 0.8),
        ObjectKind::Cone => ((2.0 * radial + p.y - 1.0) / 5f64.sqrt()).max(-0.6 - p.y),
        ObjectKind::Cube => p.abs().max_element() - 1.0 / 3f64.sqrt(),
        _ => unreachable!(),
    }
}

/// Returns the first change of sign along the ray, found in steps of 1/2000 and then by bisection, and the number of changes in
/// all.
fn by_search(kind: ObjectKind, ray: &Ray, t_max: f64) -> (Option<f64>, usize) {
    let at = |t: f64| implicit(kind, ray.origin + t * ray.direction);
    let steps = (t_max * 2000.0) as usize;
    let (mut first, mut changes) = (None, 0);
    for k in 0..steps {
        let (mut low, mut high) = (k as f64 / 2000.0, (k + 1) as f64 / 2000.0);
        if (at(low) < 0.0) == (at(high) < 0.0) {
            continue;
        }
        changes += 1;
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if (at(middle) < 0.0) == (at(low) < 0.0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        first = first.or(Some(low));
    }
    (first, changes)
}

fn all_hits(surface: Surface, ray: &Ray) -> Vec<f64> {
    let mut hits = Vec::new();
    let mut t = 0.0;
    while let Some(hit) = surface.intersect(ray, t) {
        assert!(hit.t > t, "{} after {t}", hit.t);
        hits.push(hit.t);
        // Past the rounding of the last hit.
        t = hit.t + 1e-9;
        assert!(hits.len() < 20);
    }
    hits
}

fn vector(range: f64) -> impl Strategy<Value = DVec3> {
    (-range..range, -range..range, -range..range).prop_map(DVec3::from)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..properties::config(file!()) })]

    #[test]
    fn hits_are_where_a_search_along_the_ray_finds_them(kind in 0usize..5, eye in vector(2.0), aim in vector(0.9)) {
        let kind = SOLIDS[kind];
        prop_assume!(eye.distance(aim) > 0.1);
        let ray = Ray { origin: eye, direction: (aim - eye).normalize() };
        let (searched, changes) = by_search(kind, &ray, 6.0);
        let hits = all_hits(surface(kind), &ray);
        // A search in steps can jump over a sliver; the surface can miss nothing that the search finds.
        prop_assert!(hits.len() >= changes && hits.len() <= 4, "{hits:?} {searched:?}");
        if let Some(searched) = searched.filter(|_| hits.len() == changes) {
            prop_assert!((hits[0] - searched).abs() < 1e-9, "{} {searched}", hits[0]);
        }
    }

    #[test]
    fn a_hit_is_on_the_surface_with_the_outward_unit_normal(
        kind in 0usize..5, eye in vector(30.0), aim in vector(0.9), scale in -8i32..8
    ) {
        let kind = SOLIDS[kind];
        prop_assume!(eye.distance(aim) > 0.1);
        let ray = Ray { origin: eye, direction: (aim - eye).normalize() * 10f64.powi(scale) };
        if let Some(hit) = surface(kind).intersect(&ray, 0.0) {
            let p = ray.origin + hit.t * ray.direction;
            prop_assert!(implicit(kind, p).abs() < 1e-12 * (1.0 + eye.length()), "{}", implicit(kind, p));
            prop_assert!((hit.normal.length() - 1.0).abs() < 1e-14);
            prop_assert!(implicit(kind, p + 1e-4 * hit.normal) > 0.0);
            prop_assert!(implicit(kind, p - 1e-4 * hit.normal) < 0.0);
            let from_outside = implicit(kind, eye) > 1e-6;
            prop_assert!(!from_outside || hit.normal.dot(ray.direction) <= 1e-9 * ray.direction.length());
        }
    }

    #[test]
    fn nothing_makes_a_hit_that_is_not_finite(
        kind in 0usize..7,
        numbers in proptest::collection::vec(
            prop_oneof![
                Just(0.0), Just(-0.0), Just(f64::NAN), Just(f64::INFINITY), Just(1e300), Just(1e-300), Just(0.6),
                Just(-0.8), Just(1.0), -2.0..2.0
            ], 7)
    ) {
        let kind = [SOLIDS.as_slice(), &[ObjectKind::Plane, ObjectKind::Corrugated]].concat()[kind];
        let ray = Ray {
            origin: DVec3::new(numbers[0], numbers[1], numbers[2]),
            direction: DVec3::new(numbers[3], numbers[4], numbers[5]),
        };
        if let Some(hit) = surface(kind).intersect(&ray, numbers[6]) {
            prop_assert!(hit.t.is_finite() && (hit.normal.length() - 1.0).abs() < 1e-9);
            prop_assert!(hit.t > numbers[6] || (hit.t - numbers[6]).abs() <= 1e-9 * hit.t.abs());
        }
    }
}

#[test]
fn a_torus_ray_meets_four_sheets() {
    let ray = Ray {
        origin: DVec3::new(-3.0, 0.1, 0.05),
        direction: DVec3::X,
    };
    assert_eq!(all_hits(surface(ObjectKind::Torus), &ray).len(), 4);
    let through_the_hole = Ray {
        origin: DVec3::new(0.1, 3.0, 0.1),
        direction: DVec3::NEG_Y,
    };
    assert!(
        surface(ObjectKind::Torus)
            .intersect(&through_the_hole, 0.0)
            .is_none()
    );
}

#[test]
fn rays_through_special_points_hit() {
    let down_the_axis = Ray {
        origin: DVec3::Y * 5.0,
        direction: DVec3::NEG_Y,
    };
    let hit = surface(ObjectKind::Cone)
        .intersect(&down_the_axis, 0.0)
        .expect("the apex");
    assert!((hit.t - 4.0).abs() < 1e-7 && hit.normal.y > 0.4);
    let hit = surface(ObjectKind::Cone)
        .intersect(&down_the_axis, 4.5)
        .expect("the base, from inside");
    assert!((hit.t - 5.6).abs() < 1e-12 && hit.normal == DVec3::NEG_Y);
    let hit = surface(ObjectKind::Cylinder)
        .intersect(&down_the_axis, 0.0)
        .expect("the cap");
    assert!((hit.t - 4.2).abs() < 1e-12 && hit.normal == DVec3::Y);
    let at_an_edge = Ray {
        origin: DVec3::splat(4.0),
        direction: DVec3::splat(-1.0),
    };
    assert!(
        surface(ObjectKind::Cube)
            .intersect(&at_an_edge, 0.0)
            .is_some()
    );
    let along_a_face = Ray {
        origin: DVec3::new(5.0, 0.1, 0.2),
        direction: DVec3::NEG_X,
    };
    assert!(
        surface(ObjectKind::Cube)
            .intersect(&along_a_face, 0.0)
            .is_some()
    );
    // Parallel to the side of the cone, inside and outside of it.
    let slope = DVec3::new(1.0, -2.0, 0.0);
    let inside = Ray {
        origin: DVec3::new(-0.1, 0.5, 0.0),
        direction: slope,
    };
    let hit = surface(ObjectKind::Cone)
        .intersect(&inside, 0.0)
        .expect("the base");
    assert!((inside.origin + hit.t * slope).y + 0.6 < 1e-12);
}

#[test]
fn the_plane_is_seen_from_both_sides_with_one_normal() {
    for z in [2.0, -2.0] {
        let ray = Ray {
            origin: DVec3::new(0.5, 0.5, z),
            direction: DVec3::new(0.0, 0.0, -z),
        };
        let hit = surface(ObjectKind::Plane)
            .intersect(&ray, 0.0)
            .expect("the plane");
        assert_eq!((hit.t, hit.normal), (1.0, DVec3::Z));
    }
    let beside = Ray {
        origin: DVec3::new(1.5, 0.0, 1.0),
        direction: DVec3::NEG_Z,
    };
    assert!(surface(ObjectKind::Plane).intersect(&beside, 0.0).is_none());
}

#[test]
fn a_far_eye_loses_only_the_digits_of_its_own_distance() {
    let eye = DVec3::new(1e6, 2e6, 3e6);
    for kind in SOLIDS {
        let ray = Ray {
            origin: eye,
            direction: (DVec3::new(0.5, 0.1, 0.3) - eye).normalize(),
        };
        let hit = surface(kind)
            .intersect(&ray, 0.0)
            .expect("the ray is aimed inside the shape");
        assert!(
            implicit(kind, ray.origin + hit.t * ray.direction).abs() < 1e-8,
            "{kind:?}"
        );
    }
}

#[test]
fn a_model_has_no_surface() {
    for kind in [ObjectKind::Obj, ObjectKind::Polygons] {
        assert!(
            Surface::of(&Object {
                kind,
                ..Object::default()
            })
            .is_none()
        );
    }
}
