//! The catalogue: stiff and extreme cases, each a scene that the naive way, the engine and the reference all draw.

mod cosines;
mod geometry;
mod lights;
mod pictures;

use super::{Case, Subject};
use crate::scene::{Light, ObjectKind, Rgb, Scene, ShadingMode, Shared};
use glam::DVec3;

/// Sides of the pictures, pixels: odd, so that one pixel's centre is the picture's.
pub const SIDE: u32 = 129;

/// All cases, by topic.
pub fn catalogue() -> impl Iterator<Item = &'static Case> {
    [cosines::CASES, lights::CASES, geometry::CASES, pictures::CASES].into_iter().flatten()
}

/// A scene of one light and polygons that the eye sees from (0, 0, 4).
fn polygons(vertices: &[[f64; 3]], faces: &[&[u32]]) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [SIDE; 2];
    scene.image.background = Rgb::splat(0.12);
    scene.object.kind = ObjectKind::Polygons;
    scene.object.vertices = vertices.iter().copied().map(DVec3::from_array).collect();
    scene.object.faces = faces.iter().map(|face| face.iter().copied().collect::<Shared<u32>>()).collect();
    scene.shading.mode = ShadingMode::Phong;
    matter(&mut scene);
    scene
}

/// The unit sphere itself.
fn sphere() -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [SIDE; 2];
    scene.image.background = Rgb::splat(0.12);
    scene.shading.mode = ShadingMode::Exact;
    matter(&mut scene);
    scene
}

/// What all objects are made of: nothing is brighter than the display's white.
fn matter(scene: &mut Scene) {
    let material = &mut scene.material;
    (material.ka, material.kd, material.ks) = (Rgb::splat(0.1), Rgb::splat(0.5), Rgb::splat(0.4));
    (material.color, material.n) = (Rgb::new(0.95, 0.6, 0.25), 32.0);
}

/// The square −1 ≤ x, y ≤ 1 in the plane z = 0, facing the eye.
fn square() -> Scene {
    polygons(&[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]], &[&[0, 1, 2, 3]])
}

/// A point light.
fn lamp(x: f64, y: f64, z: f64) -> Light {
    Light { position: DVec3::new(x, y, z), ..Light::default() }
}

const fn scene(make: fn() -> Scene) -> Subject {
    Subject::Scene(make)
}
