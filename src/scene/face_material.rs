//! The part of a scene that a model's material replaces.

use super::Scene;
use super::material::Material;

/// A face's own material: the coefficients of its equation, and how light passes through it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceMaterial {
    /// The coefficients.
    pub material: Material,
    /// Kt, the part of the light from behind that passes: [`Transparency::kt`](super::Transparency::kt).
    pub kt: f64,
    /// η of the inside: [`Transparency::ior`](super::Transparency::ior).
    pub relative_ior: f64,
}

impl FaceMaterial {
    /// Returns that of the scene.
    pub fn of_scene(scene: &Scene) -> Self {
        Self {
            material: scene.material.clone(),
            kt: scene.transparency.kt,
            relative_ior: scene.transparency.ior,
        }
    }

    /// Makes it that of a scene, and returns the one that the scene had.
    pub fn replace_in(self, scene: &mut Scene) -> Self {
        let before = Self::of_scene(scene);
        scene.material = self.material;
        (scene.transparency.kt, scene.transparency.ior) = (self.kt, self.relative_ior);
        before
    }
}
