//! The five defects of interpolated shading: the figures against geometry.

use glam::{DVec2, DVec3};
use shading_lab::analysis::defects::{Defects, defect_marks, defect_plots, defects};
use shading_lab::analysis::probe::probe;
use shading_lab::analysis::unwatched;
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Camera, Interpolation, NormalSource, Object, ObjectKind, Projection, Scene, Shading,
    ShadingMode, Viewer, presets,
};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

fn measured(scene: &Scene) -> Defects {
    let pixel = scene.image.size.map(|side| side / 2);
    defects(&mut Renderer::default(), scene, pixel, &unwatched)
}

fn preset(name: &str, size: [u32; 2]) -> Scene {
    let mut scene = presets::find(name)
        .map(|preset| preset.scene())
        .expect("built in");
    scene.image.size = size;
    scene
}

/// Returns a cylinder seen along its axis: a circle of radius 0.6 beside a regular polygon.
fn disc(segments: u32, size: [u32; 2]) -> Scene {
    let mut scene = Scene {
        camera: Camera {
            eye: DVec3::new(0.0, 5.0, 0.0),
            up: DVec3::NEG_Z,
            projection: Projection::Orthographic,
            height: 1.5,
            viewer: Viewer::Infinite,
            ..Camera::default()
        },
        object: Object {
            kind: ObjectKind::Cylinder,
            segments,
            rings: 1,
            ..Object::default()
        },
        shading: Shading {
            mode: ShadingMode::Gouraud,
            ..Shading::default()
        },
        ..Scene::default()
    };
    scene.image.size = size;
    scene
}

#[test]
fn the_silhouette_of_a_circle_of_segments_is_off_by_its_sagitta() {
    for segments in [3, 4, 5, 6, 8, 11, 16, 24, 32, 64, 100] {
        for size in [[300, 300], [640, 480]] {
            let scene = disc(segments, size);
            let radius = 0.6 * f64::from(size[1]) / 1.5;
            let expected = radius * (1.0 - (std::f64::consts::PI / f64::from(segments)).cos());
            let silhouette = measured(&scene).silhouette.expect("a circle");
            let off = (silhouette.greatest - expected).abs();
            assert!(
                off < 0.02 + 0.5 / 256.0,
                "{segments} at {size:?}: {} for {expected}",
                silhouette.greatest
            );
        }
    }
}

/// Compares a circle of radius 1, a sphere seen from above, with its inscribed polygon.
#[test]
fn the_silhouette_of_few_segments_is_their_sagitta_at_any_size() {
    for (size, height) in [
        (768, 2.2),
        (768, 2.4),
        (768, 1.3),
        (512, 2.05),
        (300, 3.7),
        (200, 9.0),
    ] {
        for segments in [3, 4, 5, 7, 12] {
            let mut scene = disc(segments, [size, size]);
            scene.camera.height = height;
            scene.object = Object {
                kind: ObjectKind::Sphere,
                segments,
                rings: 16,
                ..Object::default()
            };
            let radius = f64::from(size) / height;
            let sagitta = radius * (1.0 - (std::f64::consts::PI / f64::from(segments)).cos());
            // The middles of the sides are in the picture.
            if radius - sagitta < 0.5 * f64::from(size) - 2.0 {
                let found = measured(&scene).silhouette.expect("a circle").greatest;
                assert!(
                    (found - sagitta).abs() < 0.03,
                    "{segments} at {size}, {height}: {found} for {sagitta}"
                );
            }
        }
    }
}

#[test]
fn measuring_tells_how_far_it_is_and_can_be_stopped() {
    let scene = preset("shared-vertices", [100, 100]);
    let told = Mutex::new(Vec::new());
    let note = |share: f32| {
        told.lock().expect("a list").push(share);
        true
    };
    let watched = defects(&mut Renderer::default(), &scene, [50, 50], &note);
    let told = told.into_inner().expect("a list");
    assert_eq!(watched, measured(&scene));
    assert!(
        told.is_sorted() && told.len() > 4 && told.last() == Some(&1.0),
        "{told:?}"
    );
    let after_first = |share: f32| share < 0.3;
    let stopped = defects(&mut Renderer::default(), &scene, [50, 50], &after_first);
    assert_eq!(stopped.silhouette, watched.silhouette);
    assert_eq!(
        stopped.vertex_normals.map(|_| ()),
        Err("picture-missing-stopped")
    );
}

/// Checks many edges with many vertices on them: each vertex is found, and an evenly spaced selection is measured.
#[test]
fn many_unshared_vertices_are_measured_in_bounded_time() {
    // Triangles that each have their own copy of the same long edge, and triangles with a corner on it.
    let count = 100;
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    for k in 0..count {
        let share = f64::from(k) / f64::from(count);
        let y = 1.9 * share - 0.95;
        let own = [
            DVec3::new(0.0, -1.0, 0.0),
            DVec3::new(0.5 + 0.4 * share, 0.0, 0.1 * share),
            DVec3::new(0.0, 1.0, 0.0),
        ];
        let beside = [
            DVec3::new(0.0, y, 0.0),
            DVec3::new(-0.9, y + 0.004, 0.0),
            DVec3::new(-0.9, y - 0.004, 0.0),
        ];
        for corners in [own, beside] {
            let first = vertices.len() as u32;
            vertices.extend(corners);
            faces.push(vec![first, first + 1, first + 2].into());
        }
    }
    let mut scene = preset("shared-vertices", [64, 64]);
    scene.object = Object {
        kind: ObjectKind::Polygons,
        vertices: vertices.into(),
        faces: faces.into(),
        ..Object::default()
    };
    assert_eq!(scene.validate(), Ok(()));
    let steps = AtomicUsize::new(0);
    let count_steps = |_: f32| {
        steps.fetch_add(1, Ordering::Relaxed);
        true
    };
    let found = defects(&mut Renderer::default(), &scene, [40, 32], &count_steps);
    let steps = steps.into_inner();
    let shared = found.shared_vertices.expect("edges with unshared vertices");
    assert!(
        shared.measured < 5000 && 2 * shared.measured <= shared.edges,
        "{} of {}",
        shared.measured,
        shared.edges
    );
    assert!(
        steps < 2 * shared.measured,
        "{steps} steps for {} edges",
        shared.measured
    );
}

#[test]
fn the_silhouette_nears_the_outline_as_the_square_of_the_segments() {
    let at = |segments: u32| {
        let mut scene = preset("silhouette", [500, 500]);
        (scene.object.segments, scene.object.rings) = (segments, segments / 2);
        measured(&scene).silhouette.expect("a sphere").greatest
    };
    let ratio = at(16) / at(32);
    assert!((3.2..4.8).contains(&ratio), "{ratio}");
}

#[test]
fn where_there_is_nothing_to_measure_it_says_why() {
    let mut scene = preset("orientation", [200, 200]);
    let found = measured(&scene);
    assert_eq!(found.silhouette, Err("picture-missing-surface"));
    assert_eq!(
        found.perspective.map(|_| ()),
        Err("picture-missing-parallel")
    );
    scene.shading.mode = ShadingMode::Flat;
    assert_eq!(measured(&scene).orientation, Err("picture-missing-flat"));
    scene.camera.target = scene.camera.eye * 2.0;
    scene.shading.mode = ShadingMode::Gouraud;
    let away = measured(&scene);
    assert_eq!(away.orientation, Err("picture-missing-background"));
    assert_eq!(
        away.vertex_normals.map(|_| ()),
        Err("picture-missing-object")
    );
    let smooth = measured(&preset("sphere", [100, 100]));
    assert_eq!(smooth.shared_vertices, Err("picture-missing-unshared"));
}

#[test]
fn perspective_distortion_vanishes_with_the_polygons_size_and_in_a_parallel_projection() {
    let coarse = measured(&preset("perspective-distortion", [300, 300]))
        .perspective
        .expect("perspective");
    assert_eq!(coarse.interpolation, Interpolation::Affine);
    assert!(coarse.error.greatest > 0.1, "{coarse:?}");
    let mut plane = preset("plane", [300, 300]);
    plane.shading = Shading {
        mode: ShadingMode::Gouraud,
        interpolation: Interpolation::Affine,
        ..plane.shading
    };
    plane.camera.eye = DVec3::new(2.0, 1.0, 1.2);
    let at = |divisions: u32| {
        let mut scene = plane.clone();
        (scene.object.segments, scene.object.rings) = (divisions, divisions);
        measured(&scene).perspective.expect("perspective").error.rms
    };
    assert!(at(32) < 0.25 * at(4), "{} {}", at(4), at(32));
}

#[test]
fn the_tenths_of_the_deepest_edge_are_equal_in_space() {
    let scene = preset("perspective-distortion", [300, 300]);
    let found = measured(&scene).perspective.expect("perspective");
    let edge = found.edge.expect("an edge");
    let mut renderer = Renderer::default();
    renderer.render(&scene);
    let mut z_at = |place: DVec2| {
        // Beside an edge that is drawn, the floor is seen on either side of it.
        let [x, y] = (place - DVec2::new(0.0, 0.5)).as_uvec2().to_array();
        let hit = probe(&mut renderer, &scene, x, y).hit.expect("the floor");
        hit.position.z
    };
    let [near, far] = [0.02, 0.98].map(|t| z_at(edge.in_space(t)));
    assert!(near > 0.0 && far < -9.0, "{near} {far}");
    for tenth in 1..10 {
        let t = f64::from(tenth) / 10.0;
        let expected = 1.0 - 12.0 * t;
        let z = z_at(edge.in_space(t));
        assert!((z - expected).abs() < 0.25, "{t}: {z}");
        // What is equal in the picture is not equal in space.
        let other = z_at(edge.ends[0].lerp(edge.ends[1], t));
        assert!(other - expected > 0.5, "{t}: {other}");
    }
    // The words of both sides are in the picture, however narrow it is.
    let narrow = preset("perspective-distortion", [240, 240]);
    let found = Defects {
        silhouette: Err("picture-missing-surface"),
        ..measured(&narrow)
    };
    let em = 13.0;
    let at = |width: u32| -> Vec<DVec2> {
        let marks = defect_marks(&found, [width, 240], em);
        marks.into_iter().map(|mark| mark.label_at).collect()
    };
    let (inside, free) = (at(240), at(2400));
    assert_eq!(inside.len(), 2);
    assert!(
        inside.iter().all(|at| at.x > em && at.x < 240.0 - em),
        "{inside:?}"
    );
    assert_ne!(inside, free, "one of them was moved into the picture");
    let mut parallel = scene.clone();
    parallel.camera.projection = Projection::Orthographic;
    assert!(measured(&parallel).perspective.is_err());
    let shallow = measured(&preset("shared-vertices", [300, 300]));
    assert_eq!(shallow.perspective.expect("perspective").edge, None);
    // Nor has a single level polygon an edge that runs away.
    let mut level = preset("plane", [200, 200]);
    level.shading.mode = ShadingMode::Gouraud;
    level.camera.eye = DVec3::new(0.0, 0.0, 4.0);
    let found = measured(&level).perspective.expect("perspective");
    assert_eq!(found.edge, None);
}

#[test]
fn a_turned_square_comes_back_at_right_angles_and_barycentric_weights_do_not_care() {
    let mut scene = preset("orientation", [256, 256]);
    scene.camera.roll = 0.0;
    let orientation = defects(&mut Renderer::default(), &scene, [150, 110], &unwatched)
        .orientation
        .expect("a square");
    let at = |angle: f64| {
        orientation
            .samples
            .iter()
            .find(|turned| turned.angle == angle)
            .and_then(|t| t.scanline)
    };
    let [zero, quarter, eighth] = [0.0, 90.0, 45.0].map(|angle| at(angle).expect("seen"));
    assert!((zero - quarter).abs() < 2e-3, "{zero} {quarter}");
    assert!((zero - eighth).abs() > 0.02, "{zero} {eighth}");
    assert!(
        orientation.spread[0] > 0.1 && orientation.spread[1] < 2e-3,
        "{:?}",
        orientation.spread
    );
    assert_eq!(orientation.samples.len(), 121);
}

#[test]
fn the_jump_at_an_unshared_vertex_is_that_of_the_two_interpolations() {
    let scene = preset("shared-vertices", [400, 400]);
    let shared = measured(&scene)
        .shared_vertices
        .expect("a vertex on an edge");
    assert_eq!(shared.edges, 1);
    // The edge recedes from the eye, so that its middle does not appear half-way.
    assert!(
        (0.4..0.6).contains(&shared.vertex) && (shared.vertex - 0.5).abs() > 0.01,
        "{}",
        shared.vertex
    );
    // Without the vertex the edge is linear between its ends; with it the edge peaks there, so the jump is largest at
    // the vertex.
    let at = |s: f64| {
        shared
            .samples
            .iter()
            .find(|sample| (sample[0] - s).abs() < 1e-9)
            .expect("a sample")
    };
    let [_, without, with] = *at(shared.vertex);
    assert!(
        (with - without - shared.greatest).abs() < 1e-3,
        "{with} {without} {}",
        shared.greatest
    );
    let ends = [at(0.005), at(0.995)];
    assert!(
        ends.iter()
            .all(|[_, without, with]| (with - without).abs() < 0.05 * shared.greatest),
        "{ends:?}"
    );
    // The side without it runs straight but for perspective: the mean of the ends, within a few per cent.
    let mean = 0.5 * (ends[0][1] + ends[1][1]);
    assert!((without - mean).abs() < 0.03, "{without} {mean}");
}

#[test]
fn averaged_normals_of_a_corrugated_sheet_are_all_alike_until_it_is_cut_finer() {
    let scene = preset("vertex-normals", [300, 200]);
    let coarse = measured(&scene).vertex_normals.expect("Gouraud shading");
    // Slopes of the sheet: 10 over a width of 1.5, rising 0.2 each.
    let slope = (0.2_f64 / 0.15).atan().to_degrees();
    assert!(
        (coarse.greatest_angle - slope).abs() < 1e-3,
        "{} {slope}",
        coarse.greatest_angle
    );
    assert!(
        coarse.contrast < 1e-3 && coarse.true_contrast > 0.1,
        "{coarse:?}"
    );
    let mut finer = scene.clone();
    finer.object.rings = 8;
    let finer = measured(&finer).vertex_normals.expect("Gouraud shading");
    assert!(finer.contrast > 0.6 * finer.true_contrast, "{finer:?}");
    let mut facet = scene;
    facet.object.normals = NormalSource::Facet;
    assert!(
        measured(&facet)
            .vertex_normals
            .expect("Gouraud shading")
            .greatest_angle
            < 1e-3
    );
}

#[test]
fn curves_are_plotted_where_there_are_some() {
    let kinds = |name| defect_plots(&measured(&preset(name, [200, 200]))).len();
    assert_eq!(kinds("shared-vertices"), 2);
    assert_eq!(kinds("orientation"), 1);
    assert_eq!(kinds("flat-facets"), 0);
}
