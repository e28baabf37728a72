//! Scenes about where the equation is evaluated.

use super::studio::{WARM, beside, lamp, rays, seen_from, studio, surface};
use crate::scene::{
    Camera, CuedBy, DepthCueing, FlatAt, Image, NormalSource, Object, ObjectKind, Pattern, PatternKind, Projection,
    Rgb, Scene, Shading, ShadingMode, Viewer,
};
use glam::DVec3;

pub(super) fn highlight() -> Scene {
    let studio = studio(ObjectKind::Plane, 1, 1);
    Scene {
        camera: seen_from(DVec3::new(0.0, 0.35, 3.9)),
        material: surface([0.80, 0.42, 0.30], 0.55, 0.70, 40.0),
        image: Image { size: [1200, 900], ..studio.image },
        shading: Shading { mode: ShadingMode::Flat, ..Shading::default() },
        lights: vec![lamp([0.0, 0.1, 1.3], WARM)],
        compare: beside(&["shading.mode=gouraud", "shading.mode=phong", "shading.mode=exact"]),
        ..studio
    }
}

pub(super) fn flat_facets() -> Scene {
    let studio = studio(ObjectKind::Sphere, 24, 12);
    Scene {
        object: Object { normals: NormalSource::Averaged, ..studio.object },
        material: surface([0.85, 0.83, 0.80], 0.85, 0.0, 20.0),
        shading: Shading { mode: ShadingMode::Flat, flat_at: FlatAt::Centre, ..Shading::default() },
        ..studio
    }
}

pub(super) fn mach_bands() -> Scene {
    let studio = studio(ObjectKind::Cylinder, 16, 1);
    Scene {
        camera: Camera {
            projection: Projection::Orthographic,
            height: 1.9,
            viewer: Viewer::Infinite,
            ..seen_from(DVec3::new(0.0, 0.0, 4.0))
        },
        material: surface([0.86, 0.84, 0.80], 0.9, 0.0, 20.0),
        shading: Shading { mode: ShadingMode::Gouraud, ..Shading::default() },
        lights: vec![rays([-0.35, -0.2, -1.0], WARM)],
        ..studio
    }
}

pub(super) fn depth_cueing() -> Scene {
    let mist = Rgb::new(0.55, 0.60, 0.66);
    let studio = studio(ObjectKind::Plane, 1, 1);
    Scene {
        camera: Camera { target: DVec3::new(0.0, 0.0, -0.12), up: DVec3::Z, ..seen_from(DVec3::new(0.0, -1.9, 0.42)) },
        image: Image { background: mist, ..studio.image },
        material: surface([0.20, 0.42, 0.55], 0.85, 0.0, 20.0),
        pattern: Pattern { kind: PatternKind::Checker, color: Rgb::new(0.92, 0.84, 0.62), scale: 0.25 },
        depth_cueing: DepthCueing { by: CuedBy::Vertex, front: 1.4, back: 2.4, color: mist, ..DepthCueing::default() },
        lights: vec![rays([0.3, 0.5, -1.0], WARM)],
        ..studio
    }
}
