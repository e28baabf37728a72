//! The defects of interpolated shading, one scene each.

use super::studio::{BACKGROUND, COOL, WARM, beside, lamp, rays, seen_from, studio, surface};
use crate::scene::{
    Camera, Image, Interpolation, NormalSource, Object, ObjectKind, Projection, Scene, Shading, ShadingMode, Shared,
    Viewer,
};
use glam::DVec3;

/// Room for two panes beside each other.
fn wide() -> Image {
    Image { size: [1440, 720], background: BACKGROUND }
}

/// Gouraud shading, with its values interpolated by a rule.
fn gouraud(interpolation: Interpolation) -> Shading {
    Shading { mode: ShadingMode::Gouraud, interpolation, ..Shading::default() }
}

/// Polygons over vertices, with averaged normals.
fn polygons<const N: usize>(vertices: [[f64; 3]; N], faces: &[[u32; 4]]) -> Object {
    Object {
        kind: ObjectKind::Polygons,
        vertices: vertices.into_iter().map(DVec3::from_array).collect(),
        faces: faces.iter().map(|face| Shared::from(face.to_vec())).collect(),
        normals: NormalSource::Averaged,
        ..Object::default()
    }
}

pub(super) fn silhouette() -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 0.9, 3.9)),
        material: surface([0.93, 0.62, 0.30], 0.9, 0.0, 20.0),
        shading: gouraud(Interpolation::Perspective),
        image: wide(),
        lights: vec![lamp([1.2, 2.2, 4.0], WARM), lamp([-3.5, -0.5, 2.0], COOL * 0.35)],
        compare: beside(&["shading.mode=exact"]),
        ..studio(ObjectKind::Sphere, 9, 6)
    }
}

/// A floor of long strips, bright and dark in turn at their sides: its vertices have the normals of a wavy floor.
pub(super) fn perspective_distortion() -> Scene {
    const STRIPS: u32 = 6;
    const SIDES: [f64; 2] = [1.0, -11.0];
    let side = |k: u32| f64::from(k) - 0.5 * f64::from(STRIPS);
    let vertices = (0..=STRIPS).flat_map(|k| SIDES.map(|z| DVec3::new(side(k), -1.0, z))).collect();
    let lean = |k: u32| if k.is_multiple_of(2) { DVec3::new(-1.6, 1.0, 0.0) } else { DVec3::new(0.35, 1.0, 0.0) };
    Scene {
        camera: Camera { target: DVec3::new(0.0, -1.0, -1.6), fov_y: 46.0, ..seen_from(DVec3::new(0.0, 0.6, 3.2)) },
        image: wide(),
        compare: beside(&["shading.interpolation=perspective"]),
        object: Object {
            kind: ObjectKind::Polygons,
            vertices,
            faces: (0..STRIPS).map(|k| Shared::from([0, 2, 3, 1].map(|c| 2 * k + c).to_vec())).collect(),
            vertex_normals: (0..=STRIPS).flat_map(|k| [lean(k); 2]).collect(),
            normals: NormalSource::File,
            ..Object::default()
        },
        material: surface([0.42, 0.72, 0.68], 0.88, 0.0, 20.0),
        shading: gouraud(Interpolation::Affine),
        lights: vec![rays([-0.6, -1.0, 0.0], WARM)],
        ..Scene::default()
    }
}

pub(super) fn orientation() -> Scene {
    Scene {
        camera: Camera {
            projection: Projection::Orthographic,
            height: 3.1,
            roll: 30.0,
            viewer: Viewer::Infinite,
            ..seen_from(DVec3::new(0.0, 0.0, 4.0))
        },
        object: polygons([[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]], &[[0, 1, 2, 3]]),
        material: surface([0.62, 0.70, 1.0], 0.85, 0.0, 20.0),
        shading: gouraud(Interpolation::Scanline),
        image: wide(),
        compare: beside(&["shading.mode=phong"]),
        // Each near a corner, and dark at its neighbours.
        lights: vec![lamp([-0.8, -0.8, 0.35], WARM), lamp([0.8, 0.8, 0.35], WARM)],
        ..studio(ObjectKind::Polygons, 1, 1)
    }
}

/// A wall of three: the left one has nothing where the two on the right meet.
pub(super) fn shared_vertices() -> Scene {
    let vertices = [
        [-1.0, -1.0, 0.0],
        [0.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
        [0.0, 0.0, 0.0],
    ];
    Scene {
        camera: seen_from(DVec3::new(1.0, 0.9, 4.3)),
        object: polygons(vertices, &[[0, 1, 5, 6], [1, 2, 3, 7], [7, 3, 4, 5]]),
        material: surface([0.90, 0.55, 0.42], 0.95, 0.0, 20.0),
        shading: gouraud(Interpolation::Perspective),
        image: wide(),
        lights: vec![lamp([0.0, 0.0, 0.45], WARM)],
        compare: beside(&["shading.mode=phong"]),
        ..studio(ObjectKind::Polygons, 1, 1)
    }
}

pub(super) fn vertex_normals() -> Scene {
    let studio = studio(ObjectKind::Corrugated, 10, 1);
    Scene {
        camera: seen_from(DVec3::new(0.0, 1.3, 2.9)),
        object: Object { normals: NormalSource::Averaged, ..studio.object },
        material: surface([0.62, 0.74, 0.48], 0.9, 0.0, 20.0),
        shading: gouraud(Interpolation::Perspective),
        image: wide(),
        lights: vec![rays([-0.9, -0.35, -0.9], WARM)],
        compare: beside(&["object.rings=4", "shading.mode=exact"]),
        ..studio
    }
}
