//! Polygons as fine as pixels: what pixels keep while intensities change, and which points are evaluated at all.

#[path = "common/levels.rs"]
mod simd;

use glam::DVec3;
use shading_lab::render::{Renderer, Stage};
use shading_lab::scene::{
    Encoding, FlatAt, Interpolation, LightKind, ObjectKind, Overflow, Projection, Rgb, Scene, ShadingMode, Viewer,
};
use simd::levels;

/// Triangles smaller than pixels.
fn fine(kind: ObjectKind) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [97, 70];
    (scene.object.kind, scene.object.segments, scene.object.rings) = (kind, 128, 64);
    scene
}

type Change = (&'static str, fn(&mut Scene));

const VIEWS: [Change; 6] = [
    ("as it is", |_| {}),
    ("orthographic", |s| s.camera.projection = Projection::Orthographic),
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
    ("flat", |s| (s.shading.mode, s.shading.flat_at) = (ShadingMode::Flat, FlatAt::Centre)),
    ("flat, first vertex", |s| (s.shading.mode, s.shading.flat_at) = (ShadingMode::Flat, FlatAt::ProvokingVertex)),
    ("flat, mean", |s| (s.shading.mode, s.shading.flat_at) = (ShadingMode::Flat, FlatAt::VertexMean)),
    ("interpolated", |s| s.shading.mode = ShadingMode::Interpolated),
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
    ("background", |s| s.image.background = Rgb::new(0.2, 0.1, 0.4)),
    ("light, up", |s| s.lights[0].position.y += 2.0),
    ("camera", |s| s.camera.eye.x += 0.3),
];

#[test]
fn what_pixels_keep_is_what_would_be_drawn() {
    for level in levels() {
        for kind in [ObjectKind::Sphere, ObjectKind::Torus] {
            for (view, look) in VIEWS {
                // One renderer for all shadings, so that each finds what another has kept.
                let mut renderer = Renderer::default().with_level(level);
                for (shading, shade) in SHADINGS {
                    let mut scene = fine(kind);
                    look(&mut scene);
                    shade(&mut scene);
                    assert_eq!(scene.validate(), Ok(()), "{view}, {shading}");
                    renderer.render(&scene);
                    for (name, change) in MOVES {
                        change(&mut scene);
                        let kept = &renderer.render(&scene).pixels;
                        let anew = Renderer::default().with_level(level).render(&scene).pixels.clone();
                        let off = kept.iter().zip(&anew).filter(|(a, b)| a != b).count();
                        assert_eq!(off, 0, "{level:?}, {kind:?}, {view}, {shading}: pixels after a change of {name}");
                    }
                }
            }
        }
    }
}

#[test]
fn pixels_keep_something_from_the_second_change_on_and_let_it_go() {
    for (name, shade) in SHADINGS.iter().filter(|(name, _)| ["flat", "Gouraud", "interpolated"].contains(name)) {
        let mut scene = fine(ObjectKind::Sphere);
        shade(&mut scene);
        let mut renderer = Renderer::default();
        renderer.render(&scene);
        let before = renderer.memory().pixels;
        let mut after = [0; 2];
        for (after, x) in after.iter_mut().zip([1.0, 2.0]) {
            scene.lights[0].position.x = x;
            renderer.render(&scene);
            *after = renderer.memory().pixels;
        }
        assert!(before < after[0] && after[0] == after[1], "{name}: {before}, {after:?}");
        (scene.object.segments, scene.object.rings) = (12, 6);
        for x in [1.0, 2.0] {
            scene.lights[0].position.x = x;
            renderer.render(&scene);
        }
        assert!(renderer.memory().pixels <= before, "{name}: large polygons");
    }
}

fn shades(renderer: &Renderer) -> bool {
    renderer.report().stages.iter().any(|run| run.stage == Stage::VertexShading && run.ran)
}

/// Where neither light nor viewer is near, intensities do not depend on the camera: they are evaluated for what comes into
/// sight, and once.
#[test]
fn points_are_evaluated_where_they_come_into_sight() {
    for mode in [ShadingMode::Gouraud, ShadingMode::Flat, ShadingMode::Interpolated] {
        let mut scene = fine(ObjectKind::Sphere);
        // Larger than pixels, most of them: those that miss every pixel's centre are left out.
        scene.image.size = [970, 700];
        (scene.shading.mode, scene.camera.viewer) = (mode, Viewer::Infinite);
        scene.material.ks = Rgb::ZERO;
        (scene.lights[0].kind, scene.lights[0].direction) = (LightKind::Directional, DVec3::NEG_Z);
        let mut renderer = Renderer::default();
        renderer.render(&scene);
        let report = renderer.report();
        let all = if mode == ShadingMode::Flat { report.faces } else { report.vertices };
        let share = report.points as f64 / all as f64;
        // A ball's nearer cap, and what is added where rows of points are cut into blocks.
        assert!((0.3..0.65).contains(&share), "{mode:?}: {share}");
        let evaluations = report.stages.iter().map(|run| run.evaluations).sum::<u64>();
        assert_eq!(evaluations, report.points, "{mode:?}");
        let terms = renderer.terms();
        let left_out = terms.iter().find(|term| term.name.ends_with("out of sight")).expect("a term");
        assert_eq!(left_out.omitted, Some("no polygon in the picture needs them"), "{mode:?}");

        let same = |renderer: &mut Renderer, scene: &Scene| {
            renderer.render(scene).pixels == Renderer::default().render(scene).pixels
        };
        scene.image.size[0] = 400;
        assert!(same(&mut renderer, &scene), "{mode:?}, cropped");
        assert!(!shades(&renderer), "{mode:?}: all of it has been seen before");
        scene.camera.eye.x = -scene.camera.eye.x - 3.0;
        assert!(same(&mut renderer, &scene), "{mode:?}, from the other side");
        assert!(shades(&renderer), "{mode:?}: the other side has not been seen");
    }
}
