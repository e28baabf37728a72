//! Diffuse surfaces that pixels do not see directly: the floor, and the object where light from it is gathered.

use super::packet::RAYS;
use super::point_row::PointRow;
use super::shadow::{ShadowCaster, Waiting};
use crate::illumination::{Equation, Reached};
use crate::scene::{Light, Material, Pattern, Reflectance, Rgb, Scene, Transparency};
use fearless_simd::{Level, dispatch};
use glam::DVec3;

/// The scene with a plain diffuse material. Sources that cannot light the object are kept.
pub fn diffuse_scene(scene: &Scene, ka: Rgb, kd: Rgb, color: Rgb) -> Scene {
    let material =
        Material { ka, kd, ks: Rgb::ZERO, color, reflectance: Reflectance::Constant, ..scene.material.clone() };
    Scene { material, pattern: Pattern::default(), transparency: Transparency::default(), ..scene.clone() }
}

/// Whether any light is on.
pub fn any_light(scene: &Scene) -> bool {
    let soloing = scene.soloing();
    scene.lights.iter().any(|light: &Light| light.shines(soloing) && light.color != Rgb::ZERO)
}

/// A surface with its equation, in the shadow of the object if that casts any.
pub struct DiffuseSurface<'a> {
    pub equation: Equation<f64>,
    pub caster: Option<ShadowCaster<'a>>,
}

/// What a thread keeps from one packet of points to the next.
#[derive(Default)]
pub struct LightScratch {
    row: PointRow,
    words: Vec<u64>,
    waiting: Waiting,
}

impl DiffuseSurface<'_> {
    /// Calls `each` with the index of every point, world, and I there.
    pub fn light(
        &self,
        level: Level,
        points: &[(DVec3, DVec3)],
        scratch: &mut LightScratch,
        mut each: impl FnMut(usize, Rgb),
    ) {
        let LightScratch { row, words, waiting } = scratch;
        for (first, points) in (0..).step_by(RAYS).zip(points.chunks(RAYS)) {
            if let Some(caster) = &self.caster {
                row.clear(points.len());
                for (index, (point, normal)) in points.iter().enumerate() {
                    row.set(index, caster.relative(*point), *normal);
                }
                words.clear();
                words.resize(caster.words(1), u64::MAX);
                dispatch!(level, simd => caster.mark_row(simd, row, 1, words, waiting));
            }
            for (index, (point, normal)) in points.iter().enumerate() {
                let reached = self.caster.as_ref().map(|_| Reached { words, stride: 1, first: index });
                each(first + index, self.equation.illuminate_world(*point, *normal, reached));
            }
        }
    }
}
