//! Scenes about light.

use super::studio::{COOL, WARM, floor, lamp, rays, seen_from, studio, surface};
use crate::scene::{
    Ambient, AreaShape, Attenuation, Camera, Image, Light, LightKind, Material, ObjectKind, Rgb, Scene, Shading, Viewer,
};
use glam::DVec3;

pub(super) fn three_lights() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 2.0, 3.2)),
        material: surface([0.82, 0.80, 0.78], 0.70, 0.50, 50.0),
        lights: vec![
            lamp([2.6, 2.6, 2.8], WARM * 0.75),
            lamp([-3.2, 1.2, 2.2], COOL * 0.35),
            lamp([-0.8, 2.4, -3.4], Rgb::new(1.0, 0.72, 0.50) * 0.8),
        ],
        ..studio(ObjectKind::Torus, 256, 96)
    }
}

pub(super) fn colored_lights() -> Scene {
    Scene {
        material: surface([0.95, 0.95, 0.95], 0.75, 0.35, 40.0),
        ambient: Ambient { color: Rgb::splat(0.5), ..Ambient::default() },
        lights: vec![
            lamp([0.0, 3.4, 2.6], Rgb::new(1.0, 0.12, 0.10)),
            lamp([-3.0, -1.4, 2.8], Rgb::new(0.10, 0.95, 0.20)),
            lamp([3.0, -1.4, 2.8], Rgb::new(0.15, 0.25, 1.0)),
        ],
        ..studio(ObjectKind::Sphere, 192, 96)
    }
}

pub(super) fn attenuation() -> Scene {
    let lamp = lamp([0.0, 0.15, 0.55], WARM * 0.45);
    Scene {
        camera: seen_from(DVec3::new(1.5, 1.2, 3.2)),
        material: surface([0.75, 0.62, 0.45], 0.85, 0.25, 20.0),
        lights: vec![Light { attenuation: Attenuation::InverseSquare, ..lamp }],
        ..studio(ObjectKind::Plane, 96, 96)
    }
}

pub(super) fn infinite() -> Scene {
    let studio = studio(ObjectKind::Sphere, 192, 96);
    Scene {
        camera: Camera { viewer: Viewer::Infinite, ..studio.camera },
        material: surface([0.35, 0.65, 0.80], 0.75, 0.50, 40.0),
        lights: vec![rays([-2.4, -3.0, -3.2], WARM)],
        ..studio
    }
}

pub(super) fn ambient_only() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 2.2, 3.0)),
        material: Material { ka: Rgb::splat(0.55), ..surface([0.91, 0.62, 0.25], 0.75, 0.55, 60.0) },
        ambient: Ambient { color: Rgb::new(1.0, 0.95, 0.86), ..Ambient::default() },
        lights: vec![],
        ..studio(ObjectKind::Torus, 256, 96)
    }
}

pub(super) fn sun() -> Scene {
    Scene {
        camera: looking_down(DVec3::new(2.2, 2.3, 3.4)),
        image: on_floor(),
        material: surface([0.36, 0.62, 0.86], 0.78, 0.25, 30.0),
        shading: Shading { shadows: true, ..Shading::default() },
        ground: floor(-0.577_350_269_189_625_8),
        lights: vec![Light { name: "Sun".into(), ..rays([-2.2, -1.8, -0.7], WARM) }],
        ..studio(ObjectKind::Cube, 8, 8)
    }
}

pub(super) fn spotlight() -> Scene {
    let spot = Light {
        name: "Spot".into(),
        kind: LightKind::Spot,
        direction: DVec3::new(-1.1, -2.75, -1.5),
        cone: 17.0,
        exponent: 12.0,
        softness: 0.25,
        ..lamp([1.1, 2.6, 1.5], WARM)
    };
    Scene {
        camera: looking_down(DVec3::new(0.5, 2.1, 3.7)),
        image: on_floor(),
        material: surface([0.72, 0.33, 0.28], 0.80, 0.55, 50.0),
        shading: Shading { shadows: true, ..Shading::default() },
        ground: floor(TEAPOT_FOOT),
        lights: vec![spot, lamp([-3.0, 2.5, 1.0], COOL * 0.12)],
        ..studio(ObjectKind::Teapot, 64, 64)
    }
}

pub(super) fn soft_shadow() -> Scene {
    let window = Light {
        name: "Window".into(),
        kind: LightKind::Area,
        shape: AreaShape::Rectangle,
        direction: DVec3::new(-1.9, -2.6, -1.1),
        extent: [1.6, 1.2],
        samples: 64,
        ..lamp([1.9, 2.4, 1.1], WARM)
    };
    Scene {
        camera: looking_down(DVec3::new(-0.4, 2.3, 3.6)),
        image: on_floor(),
        material: surface([0.32, 0.60, 0.52], 0.75, 0.45, 60.0),
        shading: Shading { shadows: true, ..Shading::default() },
        ground: floor(-1.0),
        lights: vec![window],
        ..studio(ObjectKind::Sphere, 96, 48)
    }
}

pub(super) fn quadratic() -> Scene {
    let lamp =
        Light { attenuation: Attenuation::Quadratic, c1: 0.8, c2: 0.3, c3: 0.7, ..lamp([-0.75, 0.2, 0.4], WARM * 1.9) };
    Scene {
        camera: Camera { up: DVec3::Z, ..seen_from(DVec3::new(0.0, -2.9, 1.6)) },
        material: surface([0.62, 0.68, 0.80], 0.85, 0.25, 20.0),
        lights: vec![lamp],
        ..studio(ObjectKind::Plane, 96, 96)
    }
}

pub(super) fn to_the_viewer() -> Scene {
    let lamp = Light { attenuation: Attenuation::Viewer, k: 0.0, ..rays([-0.4, -1.0, -0.5], WARM * 2.6) };
    Scene {
        // A long floor that leads away from the eye: z is up.
        camera: Camera { up: DVec3::Z, target: DVec3::new(0.0, -0.1, 0.0), ..seen_from(DVec3::new(0.0, -2.2, 0.75)) },
        material: surface([0.80, 0.66, 0.46], 0.85, 0.0, 20.0),
        lights: vec![Light { direction: DVec3::new(0.3, 0.5, -1.0), ..lamp }],
        ..studio(ObjectKind::Plane, 96, 96)
    }
}

/// The lowest point of the teapot.
const TEAPOT_FOOT: f64 = -0.5;

/// A camera above the floor, high enough that its horizon is not seen.
fn looking_down(eye: DVec3) -> Camera {
    Camera { target: DVec3::new(0.0, -0.25, 0.0), ..seen_from(eye) }
}

/// Black where the floor ends, as where no light falls on it.
fn on_floor() -> Image {
    Image { background: Rgb::ZERO, ..Image::default() }
}
