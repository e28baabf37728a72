//! One scene of each shape.

use super::studio::{COOL, WARM, lamp, seen_from, studio, surface};
use crate::scene::{Camera, ObjectKind, Scene};
use glam::DVec3;

pub(super) fn sphere() -> Scene {
    Scene { material: surface([0.91, 0.33, 0.20], 0.75, 0.45, 40.0), ..studio(ObjectKind::Sphere, 192, 96) }
}

pub(super) fn torus() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 2.2, 3.0)),
        material: surface([0.16, 0.62, 0.60], 0.75, 0.55, 60.0),
        ..studio(ObjectKind::Torus, 256, 96)
    }
}

pub(super) fn cylinder() -> Scene {
    Scene {
        material: surface([0.93, 0.67, 0.22], 0.75, 0.45, 50.0),
        // Low enough to be mirrored to the eye by an upright wall, with a window above for the cap.
        lights: vec![lamp([2.2, -0.2, 3.0], WARM), lamp([-1.6, 3.4, 1.4], COOL * 0.5)],
        ..studio(ObjectKind::Cylinder, 192, 48)
    }
}

pub(super) fn cone() -> Scene {
    Scene { material: surface([0.52, 0.40, 0.85], 0.78, 0.45, 40.0), ..studio(ObjectKind::Cone, 192, 64) }
}

pub(super) fn cube() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(2.0, 1.7, 3.0)),
        material: surface([0.38, 0.64, 0.96], 0.88, 0.30, 30.0),
        lights: vec![lamp([1.6, 3.8, 2.6], WARM)],
        ..studio(ObjectKind::Cube, 24, 24)
    }
}

pub(super) fn plane() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.6, 0.9, 3.8)),
        material: surface([0.36, 0.66, 0.42], 0.70, 0.50, 60.0),
        lights: vec![lamp([0.4, 0.7, 0.9], WARM)],
        ..studio(ObjectKind::Plane, 48, 48)
    }
}

pub(super) fn teapot() -> Scene {
    Scene {
        camera: Camera { fov_y: 30.0, target: DVec3::new(0.0, -0.05, 0.0), ..seen_from(DVec3::new(0.8, 1.5, 3.6)) },
        material: surface([0.28, 0.58, 0.86], 0.78, 0.80, 85.0),
        lights: vec![lamp([1.6, 2.2, 3.4], WARM), lamp([-3.4, 1.4, 1.2], COOL * 0.45)],
        ..studio(ObjectKind::Teapot, 64, 64)
    }
}
