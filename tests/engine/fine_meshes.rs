//! Polygons as small as pixels: reused intermediate results give the same picture as a new renderer.

use crate::common::simd::levels;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Encoding, FlatAt, Interpolation, ObjectKind, Overflow, Projection, Rgb, Scene, ShadingMode,
};

/// Returns a scene with triangles smaller than pixels.
fn fine(kind: ObjectKind) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [97, 70];
    (scene.object.kind, scene.object.segments, scene.object.rings) = (kind, 128, 64);
    scene
}

type Change = (&'static str, fn(&mut Scene));

const VIEWS: [Change; 6] = [
    ("as it is", |_| {}),
    ("orthographic", |s| {
        s.camera.projection = Projection::Orthographic;
    }),
    ("near by, cut by the near plane", |s| {
        s.camera.eye = s.camera.target + 0.5 * (s.camera.eye - s.camera.target).normalize();
    }),
    ("scaled", |s| {
        (s.display.overflow, s.lights[0].color) = (Overflow::Scale, Rgb::splat(2.0));
    }),
    ("sRGB", |s| s.display.encoding = Encoding::Srgb),
    ("fading", |s| {
        s.depth_cueing.by = shading_lab::scene::CuedBy::Vertex;
        (s.depth_cueing.front_scale, s.depth_cueing.back_scale) = (1.0, 0.2);
    }),
];

const SHADINGS: [Change; 8] = [
    ("flat", |s| {
        (s.shading.mode, s.shading.flat_at) = (ShadingMode::Flat, FlatAt::Centre);
    }),
    ("flat, first vertex", |s| {
        (s.shading.mode, s.shading.flat_at) = (ShadingMode::Flat, FlatAt::ProvokingVertex);
    }),
    ("flat, mean", |s| {
        (s.shading.mode, s.shading.flat_at) = (ShadingMode::Flat, FlatAt::VertexMean);
    }),
    ("interpolated", |s| {
        s.shading.mode = ShadingMode::Interpolated;
    }),
    ("Gouraud", |s| s.shading.mode = ShadingMode::Gouraud),
    ("Gouraud, affine", |s| {
        (s.shading.mode, s.shading.interpolation) = (ShadingMode::Gouraud, Interpolation::Affine);
    }),
    ("Gouraud, scan line", |s| {
        (s.shading.mode, s.shading.interpolation) = (ShadingMode::Gouraud, Interpolation::Scanline);
    }),
    ("Phong", |s| s.shading.mode = ShadingMode::Phong),
];

const MOVES: [Change; 6] = [
    ("light", |s| s.lights[0].position.x -= 1.5),
    ("n", |s| s.material.n = 7.0),
    ("Ka", |s| s.material.ka = Rgb::splat(0.3)),
    ("background", |s| {
        s.image.background = Rgb::new(0.2, 0.1, 0.4);
    }),
    ("light, up", |s| s.lights[0].position.y += 2.0),
    ("camera", |s| s.camera.eye.x += 0.3),
];

#[test]
fn what_is_kept_is_what_would_be_drawn() {
    for level in levels() {
        for kind in [ObjectKind::Sphere, ObjectKind::Torus] {
            for (view, appearance) in VIEWS {
                // One renderer for all shading modes, so that each finds another's cached results.
                let mut renderer = Renderer::default().with_level(level);
                for (shading, shade) in SHADINGS {
                    let mut scene = fine(kind);
                    appearance(&mut scene);
                    shade(&mut scene);
                    assert_eq!(scene.validate(), Ok(()), "{view}, {shading}");
                    renderer.render(&scene);
                    for (name, change) in MOVES {
                        change(&mut scene);
                        let kept = &renderer.render(&scene).pixels;
                        let anew = Renderer::default()
                            .with_level(level)
                            .render(&scene)
                            .pixels
                            .clone();
                        let off = kept.iter().zip(&anew).filter(|(a, b)| a != b).count();
                        assert_eq!(
                            off, 0,
                            "{level:?}, {kind:?}, {view}, {shading}: pixels after a change of {name}"
                        );
                    }
                }
            }
        }
    }
}
