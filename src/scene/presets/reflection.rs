//! Scenes about the material.

use super::studio::{COOL, WARM, floor, lamp, seen_from, studio, surface};
use crate::scene::materials::{self, NamedMaterial};
use crate::scene::{
    Backfacing, Camera, Display, Distribution, Image, Light, Material, ObjectKind, Overflow, Pattern, PatternKind,
    Reflectance, Reflection, ReflectionModel, Rgb, Scene, Shading, ShadingMode,
};
use glam::DVec3;

pub(super) fn mirror_like() -> Scene {
    Scene {
        material: surface([0.20, 0.22, 0.26], 0.60, 1.0, 1005.0),
        lights: vec![
            lamp([2.4, 3.0, 3.2], WARM),
            lamp([-2.8, 1.6, 2.6], COOL),
            lamp([-0.6, -2.2, 3.4], Rgb::new(1.0, 0.55, 0.35)),
        ],
        ..studio(ObjectKind::Sphere, 256, 128)
    }
}

pub(super) fn blinn() -> Scene {
    Scene {
        // Z is up here, so that the plane is a floor, lit from beyond.
        camera: Camera { up: DVec3::Z, target: DVec3::new(0.0, -0.2, 0.0), ..seen_from(DVec3::new(0.0, -3.7, 1.7)) },
        material: surface([0.70, 0.26, 0.32], 0.60, 0.75, 90.0),
        reflection: Reflection { model: ReflectionModel::Blinn, ..Reflection::default() },
        lights: vec![lamp([0.2, 2.6, 1.2], WARM)],
        ..studio(ObjectKind::Plane, 96, 96)
    }
}

pub(super) fn matt() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 2.2, 3.0)),
        material: surface([0.86, 0.80, 0.70], 0.9, 0.0, 20.0),
        ..studio(ObjectKind::Torus, 256, 96)
    }
}

pub(super) fn tinted_highlight() -> Scene {
    Scene {
        material: Material {
            specular_color: Rgb::new(1.0, 0.72, 0.25),
            ..surface([0.42, 0.10, 0.22], 0.75, 0.9, 24.0)
        },
        ..studio(ObjectKind::Sphere, 192, 96)
    }
}

/// Lamps all round, since a metal is what it mirrors.
fn ring_of_lamps(strength: f64) -> Vec<Light> {
    vec![
        lamp([2.6, 2.6, 2.8], WARM * strength),
        lamp([-3.0, 1.6, 2.0], COOL * (0.7 * strength)),
        lamp([-0.6, 3.4, -2.6], WARM * strength),
        lamp([3.2, -0.4, -1.2], Rgb::splat(0.8 * strength)),
        lamp([0.3, -2.4, 3.0], WARM * (0.4 * strength)),
    ]
}

pub(super) fn gold() -> Scene {
    Scene {
        camera: Camera { fov_y: 30.0, target: DVec3::new(0.0, -0.05, 0.0), ..seen_from(DVec3::new(0.8, 1.5, 3.6)) },
        material: Material {
            ka: Rgb::splat(0.06),
            reflectance: Reflectance::Gold,
            roughness: 0.32,
            ..surface([0.80, 0.52, 0.16], 0.12, 0.8, 30.0)
        },
        reflection: Reflection {
            model: ReflectionModel::CookTorrance,
            distribution: Distribution::Ggx,
            ..Reflection::default()
        },
        lights: ring_of_lamps(0.5),
        ..studio(ObjectKind::Teapot, 64, 64)
    }
}

pub(super) fn glass_rim() -> Scene {
    let material =
        Material { ka: Rgb::splat(0.02), reflectance: Reflectance::Glass, ..surface([0.2, 0.3, 0.35], 0.1, 4.0, 12.0) };
    Scene {
        material,
        lights: vec![
            lamp([1.6, 1.4, 3.4], WARM),
            lamp([-3.6, 0.6, -1.2], COOL),
            lamp([3.0, 1.6, -2.2], WARM),
            lamp([0.2, -3.4, -1.0], COOL * 0.7),
        ],
        ..studio(ObjectKind::Sphere, 192, 96)
    }
}

pub(super) fn microfacets() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 2.0, 3.2)),
        material: Material {
            ka: Rgb::splat(0.14),
            roughness: 0.38,
            specular_color: Rgb::new(1.0, 0.62, 0.48),
            ..surface([0.72, 0.36, 0.24], 0.25, 0.9, 30.0)
        },
        reflection: Reflection { model: ReflectionModel::CookTorrance, ..Reflection::default() },
        lights: vec![lamp([2.0, 2.8, 2.4], WARM), lamp([-1.2, 1.0, -3.6], WARM * 0.8)],
        ..studio(ObjectKind::Torus, 256, 96)
    }
}

pub(super) fn two_sided() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(1.3, 0.9, -3.6)),
        material: surface([0.56, 0.40, 0.74], 0.75, 0.60, 60.0),
        reflection: Reflection { backfacing: Backfacing::Flip, ..Reflection::default() },
        lights: vec![lamp([0.5, 0.6, -1.1], WARM)],
        ..studio(ObjectKind::Plane, 48, 48)
    }
}

pub(super) fn overflow() -> Scene {
    Scene {
        material: surface([0.95, 0.62, 0.40], 0.95, 0.60, 14.0),
        display: Display { overflow: Overflow::Mark, ..Display::default() },
        lights: vec![lamp([2.4, 3.0, 3.2], WARM), lamp([-2.0, 1.6, 3.2], COOL * 0.8)],
        ..studio(ObjectKind::Sphere, 192, 96)
    }
}

pub(super) fn brass() -> Scene {
    Scene {
        camera: Camera { fov_y: 30.0, target: DVec3::new(0.0, -0.05, 0.0), ..seen_from(DVec3::new(0.8, 1.5, 3.6)) },
        material: materials::find("brass").map(NamedMaterial::material).unwrap_or_default(),
        reflection: Reflection { model: ReflectionModel::Blinn, ..Reflection::default() },
        ..studio(ObjectKind::Teapot, 64, 64)
    }
}

pub(super) fn opengl() -> Scene {
    Scene {
        material: surface([0.25, 0.55, 0.40], 0.70, 0.50, 48.0),
        reflection: Reflection { model: ReflectionModel::Blinn, ..Reflection::default() },
        shading: Shading { mode: ShadingMode::Gouraud, ..Shading::default() },
        ..studio(ObjectKind::Sphere, 32, 16)
    }
}

pub(super) fn checker() -> Scene {
    Scene {
        camera: Camera { fov_y: 30.0, target: DVec3::new(0.0, -0.05, 0.0), ..seen_from(DVec3::new(0.8, 1.5, 3.6)) },
        image: Image { background: Rgb::ZERO, ..Image::default() },
        material: surface([0.16, 0.30, 0.62], 0.80, 0.55, 60.0),
        pattern: Pattern { kind: PatternKind::Checker, scale: 0.22, ..Pattern::default() },
        shading: Shading { shadows: true, ..Shading::default() },
        ground: floor(-0.5),
        ..studio(ObjectKind::Teapot, 64, 64)
    }
}

pub(super) fn rings() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 2.9, 2.6)),
        material: surface([0.70, 0.22, 0.20], 0.80, 0.45, 50.0),
        pattern: Pattern { kind: PatternKind::Rings, scale: 0.12, ..Pattern::default() },
        ..studio(ObjectKind::Sphere, 192, 96)
    }
}
