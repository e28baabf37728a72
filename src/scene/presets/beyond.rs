//! Scenes about what the equation at a point leaves out.

use super::studio::{COOL, WARM, floor, lamp, seen_from, studio, surface};
use crate::scene::{
    Ambient, AmbientSource, Backdrop, Camera, Image, Material, ObjectKind, PatternKind, Rgb, Scene, Shading, Through,
    Transparency,
};
use glam::DVec3;

fn with_shadows() -> Shading {
    Shading { shadows: true, ..Shading::default() }
}

fn over_black() -> Image {
    Image { background: Rgb::ZERO, ..Image::default() }
}

pub(super) fn shadows() -> Scene {
    Scene {
        camera: Camera { target: DVec3::new(0.0, -0.4, 0.0), ..seen_from(DVec3::new(0.0, 2.6, 3.4)) },
        image: over_black(),
        material: surface([0.88, 0.56, 0.18], 0.78, 0.45, 50.0),
        shading: with_shadows(),
        ground: floor(-0.75),
        lights: vec![lamp([2.2, 2.4, 1.4], WARM * 0.9), lamp([-2.6, 3.0, 0.4], COOL * 0.4)],
        ..studio(ObjectKind::Torus, 192, 64)
    }
}

/// A wall of light and dark fields.
fn wall(distance: f64, scale: f64) -> Backdrop {
    Backdrop { pattern: PatternKind::Checker, distance, scale, ..Backdrop::default() }
}

fn clear(kt: f64, ior: f64, through: Through) -> Transparency {
    Transparency { kt, ior, through }
}

fn glass() -> Material {
    Material { ka: Rgb::splat(0.05), ..surface([0.45, 0.70, 0.80], 0.25, 0.9, 200.0) }
}

pub(super) fn glass_ball() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 0.6, 4.0)),
        image: Image { background: Rgb::new(0.16, 0.24, 0.34), ..Image::default() },
        material: glass(),
        transparency: clear(0.85, 1.5, Through::Solid),
        backdrop: wall(9.0, 1.1),
        ..studio(ObjectKind::Sphere, 128, 64)
    }
}

pub(super) fn one_surface() -> Scene {
    Scene { transparency: clear(0.85, 1.5, Through::Surface), backdrop: wall(1.2, 0.17), ..glass_ball() }
}

pub(super) fn under_water() -> Scene {
    Scene {
        // Close under the surface, looking straight out: the critical angle is a circle about the line of sight.
        camera: Camera { fov_y: 100.0, ..seen_from(DVec3::new(0.0, 0.0, 0.72)) },
        image: Image { background: Rgb::new(0.03, 0.16, 0.24), ..Image::default() },
        material: Material { ka: Rgb::splat(0.05), ..surface([0.3, 0.6, 0.7], 0.3, 0.5, 60.0) },
        transparency: clear(0.9, 1.0 / 1.33, Through::Surface),
        backdrop: Backdrop { color: Rgb::new(0.88, 0.92, 0.90), ..wall(1.5, 0.45) },
        lights: vec![lamp([0.5, 0.55, 0.7], WARM)],
        ..studio(ObjectKind::Plane, 8, 8)
    }
}

pub(super) fn one_bounce() -> Scene {
    Scene {
        camera: Camera { target: DVec3::new(0.0, -0.25, 0.0), ..seen_from(DVec3::new(0.0, 1.7, 4.0)) },
        image: over_black(),
        material: Material { ka: Rgb::splat(0.75), ..surface([0.86, 0.20, 0.14], 0.75, 0.0, 20.0) },
        shading: with_shadows(),
        ground: crate::scene::Ground { ka: 0.85, kd: 0.85, color: Rgb::splat(0.9), ..floor(-1.0) },
        // The constant that fits best in a picture of the usual size.
        ambient: Ambient { color: Rgb::new(0.065, 0.005, 0.002), source: AmbientSource::Split },
        lights: vec![lamp([0.4, 3.2, 2.2], WARM)],
        ..studio(ObjectKind::Sphere, 128, 64)
    }
}
