//! The camera's mathematics: from the world to the picture and back.

use crate::common::properties;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use shading_lab::scene::{Camera, Projection, View};

const SIZE: [u32; 2] = [640, 480];

fn vector(range: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
}

fn camera() -> impl Strategy<Value = Camera> {
    let place = (vector(10.0), vector(10.0), vector(1.0), -1e3..1e3f64);
    (place, any::<bool>(), 1.0..170.0, 0.01..100.0).prop_map(
        |((eye, target, up, roll), perspective, fov_y, height)| {
            let projection = if perspective {
                Projection::Perspective
            } else {
                Projection::Orthographic
            };
            Camera {
                eye,
                target,
                up,
                roll,
                projection,
                fov_y,
                height,
                ..Camera::default()
            }
        },
    )
}

#[test]
fn the_target_is_in_the_middle_and_the_field_of_view_spans_the_height() {
    let view = View::new(&Camera::default(), SIZE);
    assert_eq!(
        view.project(DVec3::ZERO),
        Some((DVec2::new(320.0, 240.0), 4.0))
    );
    let top = DVec3::new(0.0, 4.0 * 20f64.to_radians().tan(), 0.0);
    let (pixel, _) = view.project(top).expect("in front of the eye");
    assert!((pixel - DVec2::new(320.0, 0.0)).length() < 1e-9, "{pixel}");
    let (right, _) = view.project(DVec3::X).expect("in front of the eye");
    assert!(
        right.x > 320.0 && (right.y - 240.0).abs() < 1e-12,
        "+x is to the right of an eye on +z"
    );
}

#[test]
fn an_orthographic_picture_spans_its_height_at_every_depth() {
    let view = View::new(
        &Camera {
            projection: Projection::Orthographic,
            ..Camera::default()
        },
        SIZE,
    );
    for z in [-5.0, 0.0, 3.0] {
        let (pixel, depth) = view
            .project(DVec3::new(0.0, 1.25, z))
            .expect("in front of the eye");
        assert!(pixel.y.abs() < 1e-12 && (depth - (4.0 - z)).abs() < 1e-12);
    }
}

#[test]
fn a_roll_turns_what_is_seen_counter_clockwise() {
    let at = |roll: f64, world: DVec3| {
        let view = View::new(
            &Camera {
                roll,
                ..Camera::default()
            },
            SIZE,
        );
        let (pixel, _) = view.project(world).expect("in front of the eye");
        // Relative to the middle, y upwards.
        (pixel - view.centre) * DVec2::new(1.0, -1.0)
    };
    let across = at(0.0, DVec3::X).x;
    for quarters in -9..9i32 {
        let turned = at(f64::from(quarters) * 90.0, DVec3::X);
        let expected = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y]
            [quarters.rem_euclid(4) as usize]
            * across;
        assert!(
            (turned - expected).length() < 1e-12,
            "{quarters} quarters: {turned}"
        );
    }
    let turned = at(30.0, DVec3::X);
    assert!(
        (turned.to_angle().to_degrees() - 30.0).abs() < 1e-9,
        "{turned}"
    );
    let back = View::without_roll(turned, 30.0);
    assert!((back - DVec2::new(across, 0.0)).length() < 1e-9);
    for roll in [f64::NAN, f64::INFINITY, -1e300] {
        assert!(
            View::new(
                &Camera {
                    roll,
                    ..Camera::default()
                },
                SIZE
            )
            .right
            .is_finite()
        );
    }
}

#[test]
fn what_is_behind_the_eye_does_not_appear() {
    let view = View::new(&Camera::default(), SIZE);
    assert_eq!(view.project(DVec3::new(0.0, 0.0, 4.0)), None);
    assert_eq!(view.project(DVec3::new(0.0, 0.0, 5.0)), None);
    assert_eq!(view.project(DVec3::NAN), None);
}

#[test]
fn a_degenerate_camera_still_has_a_frame() {
    let upon = DVec3::splat(2.0);
    for (eye, target, up) in [
        (upon, upon, DVec3::Y),
        (DVec3::Y * 4.0, DVec3::ZERO, DVec3::Y),
        (DVec3::Z, DVec3::ZERO, DVec3::ZERO),
        (DVec3::Z * 1e-300, DVec3::ZERO, DVec3::Y * 1e-300),
        (DVec3::Z * 1e308, DVec3::Z * -1e308, DVec3::X * 1e308),
    ] {
        let view = View::new(
            &Camera {
                eye,
                target,
                up,
                ..Camera::default()
            },
            SIZE,
        );
        assert!(
            (view.right.cross(view.up) + view.forward).length() < 1e-9,
            "{eye} {target} {up}: {view:?}"
        );
    }
}

proptest! {
    #![proptest_config(properties::config(file!()))]

    #[test]
    fn unprojecting_what_was_projected_returns_the_point(camera in camera(), point in vector(10.0)) {
        let view = View::new(&camera, SIZE);
        // Near the eye's plane the pixel lies far outside, and its digits no longer hold the point's.
        if let Some((pixel, depth)) = view.project(point).filter(|(_, depth)| *depth > 0.01) {
            prop_assert!((view.unproject(pixel, depth) - point).length() < 1e-8);
            let (origin, along) = view.ray(pixel);
            prop_assert!((along.length() - 1.0).abs() < 1e-12);
            prop_assert!((point - origin).cross(along).length() < 1e-8);
            let beside = point + view.right * view.world_per_pixel(depth);
            let (next, _) = view.project(beside).expect("as deep as the point");
            // Each projection rounds the depth, and the difference may be a thousandth of it.
            let rounding = 1e-14 / depth * (pixel - view.centre).length();
            prop_assert!((next - pixel - DVec2::X).length() < 1e-9 + 10.0 * rounding);
        }
    }

    #[test]
    fn the_frame_is_orthonormal(camera in camera()) {
        let view = View::new(&camera, SIZE);
        prop_assert!((view.right.cross(view.up) + view.forward).length() < 1e-9);
        let upright = View::new(&Camera { roll: 0.0, ..camera.clone() }, SIZE);
        prop_assert!(upright.up.dot(camera.up) >= 0.0, "up in the world is up in the picture");
    }
}
