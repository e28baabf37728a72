//! Two ways to make Phong shading faster, as they were published, and Phong shading beside them in the same kind of text.
//!
//! - [`Taylor`]: Bishop and Weimer, "Fast Phong Shading", SIGGRAPH 1986. N·L and the highlight's cosine are functions of the
//!   picture's x and y over a triangle; their Taylor expansions of the second order about its centre are evaluated by forward
//!   differences, two additions a pixel each. The error is of the third order in the triangle's size, and where two triangles
//!   meet their expansions do not.
//! - [`Angular`]: Kuijk and Blake, "Faster Phong shading via angular interpolation", Computer Graphics Forum 8 (1989). Normals
//!   turn by equal angles along the edges and then along the span: N(i+1) = 2·cos Δ·N(i) − N(i−1), unit without a root.
//!   Equal angles are equal steps in the picture, so that this is affine by construction.
//!
//! All is scalar code in double precision and in one thread, unlike the engine's kernels. Times are to be compared among the
//! three of them, or as counts of operations ([`super::Method::pixel_cost`]), not with the engine's.

mod angular;
mod jet;
mod kernel;
mod phong;
mod raster;
mod taylor;

use super::Method;
use crate::geometry::VertexMesh;
use crate::scene::{
    AmbientSource, CuedBy, Interpolation, PatternKind, Projection, Reflectance, ReflectionModel, Scene,
};
use angular::Angular;
use kernel::{Shade, carried_in_perspective};
use phong::Phong;
use raster::Raster;
use taylor::Taylor;

/// A picture drawn by one of the methods.
#[derive(Debug, Default)]
pub struct Historic {
    /// As [`crate::render::Renderer::linear`] has it.
    pub linear: Vec<[f32; 4]>,
    /// As it would be shown, so that the time is that of a whole frame.
    stored: Vec<[u8; 3]>,
    keys: Vec<f64>,
    /// Evaluations of the equation or, Taylor's, of expansions.
    pub evaluations: u64,
}

impl Historic {
    /// Draws `mesh` in `scene` by `method`, which is scalar.
    pub fn draw(&mut self, method: Method, scene: &Scene, mesh: &VertexMesh) {
        let [width, height] = scene.image.size.map(|side| side as usize);
        let [r, g, b] = scene.image.background.as_vec3().to_array();
        self.linear.clear();
        self.linear.resize(width * height, [r, g, b, 0.0]);
        self.keys.clear();
        self.keys.resize(width * height, f64::NEG_INFINITY);
        let shade = Shade::new(scene);
        let mut raster = Raster::new(scene, mesh, &shade, &mut self.linear, &mut self.keys);
        self.evaluations = match method {
            Method::Taylor => raster.run(&mut Taylor::new(scene, &shade)),
            Method::Angular => raster.run(&mut Angular::new(&shade)),
            _ => raster.run(&mut Phong::new(&shade, carried_in_perspective(scene))),
        };
        self.stored.clear();
        #[expect(clippy::cast_sign_loss, reason = "clamped")]
        let code = |value: f32| (255.0 * value.clamp(0.0, 1.0) + 0.5) as u8;
        self.stored.extend(self.linear.iter().map(|[r, g, b, _]| [code(*r), code(*g), code(*b)]));
    }
}

/// Why the scalar code cannot draw a scene by `method`.
pub fn cannot_draw(method: Method, scene: &Scene) -> Option<&'static str> {
    let rays = scene.shading.shadows
        || scene.ground.visible
        || scene.backdrop.pattern != PatternKind::None
        || scene.transparency.kt > 0.0
        || scene.ambient.source != AmbientSource::Constant;
    if rays {
        return Some("the scalar code follows no rays");
    }
    if scene.depth_cueing.by != CuedBy::Off {
        return Some("the scalar code knows no depth cueing");
    }
    if method == Method::Angular && scene.shading.interpolation == Interpolation::Perspective {
        return (scene.camera.projection == Projection::Perspective)
            .then_some("equal angles are equal steps in the picture");
    }
    if method != Method::Taylor {
        return None;
    }
    if scene.reflection.model == ReflectionModel::CookTorrance || scene.material.reflectance != Reflectance::Constant {
        return Some("the highlight has no single cosine to expand");
    }
    (scene.pattern.kind != PatternKind::None).then_some("a pattern has no expansion")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_scalar_text_cannot_draw_is_said() {
        let plain = Scene { lights: vec![], ..Scene::default() };
        assert_eq!(cannot_draw(Method::Taylor, &plain), None);
        assert!(cannot_draw(Method::Angular, &plain).is_some(), "in perspective");
        let changes: [fn(&mut Scene); 5] = [
            |scene| scene.shading.shadows = true,
            |scene| scene.backdrop.pattern = PatternKind::Checker,
            |scene| scene.transparency.kt = 0.5,
            |scene| scene.reflection.model = ReflectionModel::CookTorrance,
            |scene| scene.pattern.kind = PatternKind::Stripes,
        ];
        for (index, change) in changes.into_iter().enumerate() {
            let mut scene = plain.clone();
            change(&mut scene);
            assert!(cannot_draw(Method::Taylor, &scene).is_some(), "{index}");
            assert_eq!(cannot_draw(Method::PhongScalar, &scene).is_some(), index < 3, "{index}");
        }
    }
}
