//! The camera moved by hand: round its target, parallel to the picture, nearer and farther.

use crate::app::session::document::Document;
use crate::geometry::tessellate;
use crate::scene::{Camera, Object, ObjectKind, Projection, Scene, View};
use glam::{DQuat, DVec3};

/// The minimum angle between the viewing direction and `up`, in degrees, so that the picture never turns
/// over.
const POLE: f64 = 0.5;
/// The distances of the eye from its target, in world units.
const DISTANCES: std::ops::RangeInclusive<f64> = 1e-3..=1e6;

/// Turns the eye about the target by `right` degrees to the right and `up` degrees upwards.
pub fn orbit(camera: &mut Camera, right: f64, up: f64) {
    let offset = camera.eye - camera.target;
    let pole = camera.up.normalize_or(DVec3::Y);
    // The picture may be rolled about its centre; the eye still moves round the upright axis.
    let level = Camera {
        roll: 0.0,
        ..camera.clone()
    };
    let sideways = View::new(&level, [1, 1]).right;
    let height = 90.0 - offset.angle_between(pole).to_degrees();
    let up = (height + up).clamp(-90.0 + POLE, 90.0 - POLE) - height;
    let turn = DQuat::from_axis_angle(pole, right.to_radians())
        * DQuat::from_axis_angle(sideways, -up.to_radians());
    let turned = camera.target + turn * offset;
    if turned.is_finite() {
        camera.eye = turned;
    }
}

/// Moves eye and target together by `right` and `up`, as fractions of the picture's span at the target's
/// distance.
pub fn pan(camera: &mut Camera, right: f64, up: f64) {
    let view = View::new(camera, [1, 1]);
    let seen = view.world_per_pixel(camera.eye.distance(camera.target));
    let shift = (view.right * right + view.up * up) * seen;
    if shift.is_finite() {
        camera.eye += shift;
        camera.target += shift;
    }
}

/// Multiplies the eye's distance from the target, or the height spanned by an orthographic picture.
pub fn zoom(camera: &mut Camera, factor: f64) {
    match camera.projection {
        Projection::Orthographic => camera.height = (camera.height * factor).clamp(1e-6, 1e6),
        Projection::Perspective => {
            let offset = camera.eye - camera.target;
            let distance = offset.length();
            let wanted = (distance * factor).clamp(*DISTANCES.start(), *DISTANCES.end());
            let eye = camera.target + offset * (wanted / distance);
            if eye.is_finite() {
                camera.eye = eye;
            }
        }
    }
}

/// The maximum divisions of a shape when its extent is computed.
const COARSE: u32 = 32;

/// Resets the camera of `document` to that of the opened scene, except for the current projection and viewer.
/// If the object or the projection has changed since then, fits the whole object into a picture of `size`
/// pixels.
pub fn reset(document: &mut Document, opened: &Scene, size: [u32; 2]) {
    let Camera {
        projection, viewer, ..
    } = document.scene.camera;
    let camera = Camera {
        projection,
        viewer,
        ..opened.camera.clone()
    };
    let extent = |object: &Object| (object.kind, object.vertices.clone(), object.path.clone());
    let same = extent(&document.scene.object) == extent(&opened.object)
        && projection == opened.camera.projection;
    document.scene.camera = if same {
        camera
    } else {
        let (centre, radius) = ball(document);
        camera.fitted(centre, radius, size)
    };
}

/// Returns the centre and the radius of a ball about the object.
pub fn ball(document: &Document) -> (DVec3, f64) {
    let object = &document.scene.object;
    match &document.model {
        Some(mesh) if object.kind == ObjectKind::Obj => mesh.ball(),
        _ => tessellate(&Object {
            segments: object.segments.min(COARSE),
            rings: object.rings.min(COARSE),
            ..object.clone()
        })
        .ball(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_orbit_goes_right_and_up_keeps_the_distance_and_never_passes_the_pole() {
        let mut camera = Camera::default();
        orbit(&mut camera, 10.0, 0.0);
        assert!(camera.eye.x > 0.0);
        orbit(&mut camera, 0.0, 10.0);
        assert!(camera.eye.y > 0.0);
        camera.eye = DVec3::new(3.0, 1.0, 2.0);
        let distance = camera.eye.length();
        for _ in 0..100 {
            orbit(&mut camera, 17.0, 11.0);
            assert!((camera.eye.length() - distance).abs() < 1e-9);
        }
        let from_pole = camera.eye.angle_between(DVec3::Y).to_degrees();
        assert!((from_pole - POLE).abs() < 1e-6, "{from_pole}");
    }

    #[test]
    fn an_orbit_keeps_the_roll_and_the_way_it_goes() {
        let (mut plain, mut rolled) = (
            Camera::default(),
            Camera {
                roll: 70.0,
                ..Camera::default()
            },
        );
        orbit(&mut plain, 10.0, 20.0);
        orbit(&mut rolled, 10.0, 20.0);
        assert_eq!(
            rolled,
            Camera {
                roll: 70.0,
                ..plain
            }
        );
    }

    #[test]
    fn panning_by_a_height_shifts_the_picture_by_its_height() {
        let mut camera = Camera::default();
        let origin = |camera: &Camera| {
            View::new(camera, [100, 100])
                .project(DVec3::ZERO)
                .expect("in sight")
                .0
        };
        let before = origin(&camera);
        pan(&mut camera, 0.0, 1.0);
        assert!(
            (origin(&camera).y - before.y - 100.0).abs() < 1e-9,
            "{before}"
        );
    }

    #[test]
    fn zooming_is_bounded_and_an_eye_upon_its_target_stays_a_number() {
        let mut camera = Camera::default();
        (0..1000).for_each(|_| zoom(&mut camera, 0.5));
        assert!((camera.eye.length() - DISTANCES.start()).abs() < 1e-9);
        camera.projection = Projection::Orthographic;
        (0..1000).for_each(|_| zoom(&mut camera, 2.0));
        assert!(camera.height <= 1e6);
        let mut camera = Camera {
            eye: DVec3::ZERO,
            ..Camera::default()
        };
        orbit(&mut camera, 10.0, 10.0);
        pan(&mut camera, 1.0, 1.0);
        zoom(&mut camera, 2.0);
        assert!(camera.eye.is_finite() && camera.target.is_finite());
    }
}
