//! The framing of each scene in pictures of any shape.

use crate::common::properties;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use shading_lab::geometry::tessellate;
use shading_lab::render::Renderer;
use shading_lab::scene::{Camera, Framing, Object, Projection, ShadingMode, View, presets};

/// A square, a wide and a narrow picture.
const SHAPES: [[u32; 2]; 3] = [[600, 600], [1600, 1000], [540, 960]];

/// Scenes whose object is cut off by the picture's edge, as their descriptions say.
const CLOSE: [&str; 2] = ["perspective-distortion", "under-water"];

/// Returns the minimum margin around a scene's object, as a fraction of the shorter side; negative if the object is cut off.
fn room(camera: &Camera, points: &[DVec3], size: [u32; 2]) -> f64 {
    let view = View::new(camera, size);
    let [width, height] = size.map(f64::from);
    let least = points.iter().map(|point| {
        view.project(*point).map_or(f64::NEG_INFINITY, |(at, _)| {
            at.min_element().min(width - at.x).min(height - at.y)
        })
    });
    least.fold(f64::INFINITY, f64::min) / width.min(height)
}

#[test]
fn every_built_in_scene_shows_its_whole_object_in_any_shape() {
    let mut cut = Vec::new();
    for preset in presets::ALL {
        let scene = preset.scene();
        assert_eq!(scene.camera.framing, Framing::Whole, "{}", preset.name);
        // Finer than the scene has it, so that no part of the true surface is missed.
        let fine = Object {
            segments: scene.object.segments.max(64),
            rings: scene.object.rings.max(64),
            ..scene.object.clone()
        };
        let mut points: Vec<DVec3> = Vec::new();
        for object in [&scene.object, &fine] {
            let mesh = tessellate(object);
            points.extend(mesh.positions.iter().map(|p| mesh.origin + p.as_dvec3()));
        }
        let least = SHAPES
            .map(|size| room(&scene.camera, &points, size))
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        let close = CLOSE.contains(&preset.name);
        if (least < 0.03) != close {
            cut.push(format!("{}: {least:.3}", preset.name));
        }
    }
    assert!(cut.is_empty(), "{cut:#?}");
}

fn vector(range: f64) -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-range..range).prop_map(DVec3::from_array)
}

fn camera() -> impl Strategy<Value = Camera> {
    let place = (vector(10.0), vector(10.0), -180.0..180.0f64);
    let lens = (any::<bool>(), any::<bool>(), 1.0..150.0f64, 0.01..100.0f64);
    (place, lens).prop_map(
        |((eye, target, roll), (perspective, whole, fov_y, height))| Camera {
            eye,
            target,
            roll,
            projection: if perspective {
                Projection::Perspective
            } else {
                Projection::Orthographic
            },
            framing: if whole {
                Framing::Whole
            } else {
                Framing::Height
            },
            fov_y,
            height,
            ..Camera::default()
        },
    )
}

/// Returns evenly spread points on a ball's surface.
fn surface(centre: DVec3, radius: f64) -> impl Iterator<Item = DVec3> {
    (0..400).map(move |k| {
        let z = 1.0 - (2.0 * f64::from(k) + 1.0) / 400.0;
        let turn = DVec2::from_angle(f64::from(k) * 2.399_963_229_728_653);
        centre + (turn * (1.0 - z * z).sqrt()).extend(z) * radius
    })
}

proptest! {
    #![proptest_config(properties::config(file!()))]

    #[test]
    fn a_fitted_camera_shows_the_whole_ball(
        camera in camera(),
        centre in vector(5.0),
        radius in 0.01..20.0f64,
        shape in 0usize..3,
    ) {
        let size = SHAPES[shape];
        let points: Vec<DVec3> = surface(centre, radius).collect();
        let fitted = camera.fitted(centre, radius, size);
        let least = room(&fitted, &points, size);
        prop_assert!(least > Camera::MARGIN - 1e-6, "{least}: {fitted:?}");
        let [before, after] = [&camera, &fitted].map(|camera| View::new(camera, size).forward);
        prop_assert!((before - after).length() < 1e-9, "it looks the same way");
        let again = fitted.fitted(centre, radius * (1.0 - 1e-9), size);
        prop_assert_eq!(&again, &fitted, "what is shown whole stays as it is");
    }

    #[test]
    fn the_framing_by_the_shorter_side_shows_what_a_square_picture_shows(
        camera in camera(),
        width in 1u32..2000,
        height in 1u32..2000,
        point in vector(10.0),
    ) {
        let side = width.min(height);
        let whole = Camera { framing: Framing::Whole, ..camera };
        let seen = |size| {
            let view = View::new(&whole, size);
            view.project(point).map(|(at, _)| at - view.centre)
        };
        let ([a, b], far) = ([seen([side; 2]), seen([width, height])], 1e9);
        prop_assert_eq!(a.is_some(), b.is_some());
        if let (Some(a), Some(b)) = (a, b) {
            prop_assert!((a - b).length() <= 1e-9 * a.length().max(1.0) || a.length() > far);
        }
    }
}

#[test]
fn the_shading_modes_of_the_start_scene_differ_at_a_glance() {
    let modes = [ShadingMode::Flat, ShadingMode::Gouraud, ShadingMode::Phong];
    for size in SHAPES {
        let pictures = modes.map(|mode| {
            let mut scene = presets::default_scene();
            scene.shading.mode = mode;
            scene.image.size = size;
            let mut renderer = Renderer::default();
            renderer.render(&scene).pixels.to_vec()
        });
        for (a, b) in [(0, 1), (1, 2), (0, 2)] {
            let pairs = pictures[a].iter().zip(&pictures[b]);
            let squares: f64 = pairs
                .flat_map(|(p, q)| [0, 1, 2].map(|i| f64::from(p[i]) - f64::from(q[i])))
                .map(|difference| (difference / 255.0).powi(2))
                .sum();
            let rms = (squares / (3 * pictures[a].len()) as f64).sqrt();
            assert!(
                rms >= 0.03,
                "{:?} and {:?} at {size:?}: {rms}",
                modes[a],
                modes[b]
            );
        }
    }
}
