//! The three conditions under which flat shading is exact: their measured values, and that together they suffice.

mod agree;

use shading_lab::analysis::comparison::{LinearPicture, error_figures};
use shading_lab::analysis::conditions::{Assumption, CONDITIONS, Conditions, conditions};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Attenuation, Camera, Choice, CuedBy, FlatAt, Light, LightKind, NormalSource, ObjectKind,
    PatternKind, Projection, Rgb, Scene, ShadingMode, Viewer, presets,
};

/// Returns an object under a directional light, seen from infinity.
fn scene(kind: ObjectKind) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [120, 100];
    scene.object.kind = kind;
    scene.camera.eye = glam::DVec3::new(1.3, 1.7, 3.1);
    scene.camera.viewer = Viewer::Infinite;
    // A highlight wide enough to show on a cube.
    (scene.material.ks, scene.material.n) = (Rgb::splat(0.4), 2.0);
    scene.shading.mode = ShadingMode::Flat;
    scene.lights = vec![Light {
        kind: LightKind::Directional,
        ..Light::default()
    }];
    scene
}

fn found(scene: &Scene) -> Conditions {
    conditions(&mut Renderer::default(), scene)
}

fn hold(found: &Conditions) -> [bool; 3] {
    CONDITIONS.map(|(_, holds)| holds(found))
}

#[test]
fn where_all_three_hold_the_flat_picture_is_the_exact_one() {
    // In the last two sizes a pixel's centre lies so near an edge that the picture's grid assigns it to the other polygon.
    for size in [[120, 100], [150, 150], [160, 160]] {
        let mut scene = scene(ObjectKind::Cube);
        scene.image.size = size;
        let cube = found(&scene);
        assert_eq!(hold(&cube), [true; 3], "{cube:?}");
        assert!(
            cube.error.pixels > 1000 && cube.error.greatest < 1e-5,
            "{cube:?}"
        );
    }
}

#[test]
fn each_condition_fails_alone_and_then_the_pictures_differ() {
    type Change = fn(&mut Scene);
    let changes: [(Change, [bool; 3]); 3] = [
        (
            |scene| scene.lights[0].kind = LightKind::Point,
            [false, true, true],
        ),
        (
            |scene| scene.camera.viewer = Viewer::Local,
            [true, false, true],
        ),
        (
            |scene| scene.object.kind = ObjectKind::Sphere,
            [true, true, false],
        ),
    ];
    for (change, expected) in changes {
        let mut scene = scene(ObjectKind::Cube);
        change(&mut scene);
        let found = found(&scene);
        assert_eq!(hold(&found), expected, "{found:?}");
        assert!(found.error.greatest > 1e-3, "{expected:?}: {found:?}");
    }
}

#[test]
fn polygons_lean_from_a_round_surface_by_half_a_segment() {
    let mut cylinder = scene(ObjectKind::Cylinder);
    for segments in [6, 12, 40] {
        cylinder.object.segments = segments;
        let expected = 180.0 / f64::from(segments);
        let angle = found(&cylinder).surface;
        assert!((angle - expected).abs() < 0.01, "{segments}: {angle}");
    }
    // A sphere next to its equator, which lies between two rings: the normal of the polygon above it is tilted by t.
    let mut sphere = scene(ObjectKind::Sphere);
    (sphere.object.segments, sphere.object.rings) = (16, 8);
    let [half, ring] = [180.0_f64 / 16.0, 180.0 / 8.0].map(f64::to_radians);
    let tilt = (half.cos() * (0.5 * ring).tan()).atan();
    let expected = (half.cos() * tilt.cos()).acos().to_degrees();
    let angle = found(&sphere).surface;
    assert!((angle - expected).abs() < 0.01, "{angle} {expected}");
}

#[test]
fn the_direction_to_a_point_turns_as_seen_from_a_polygon() {
    let mut plane = scene(ObjectKind::Plane);
    (plane.object.segments, plane.object.rings) = (1, 1);
    plane.lights = vec![Light {
        position: glam::DVec3::new(0.0, 0.0, 1.0),
        ..Light::default()
    }];
    plane.camera.viewer = Viewer::Local;
    plane.camera.eye = glam::DVec3::new(0.0, 0.0, 2.0);
    let seen = found(&plane);
    // Between opposite corners, which are √2 from the middle; N·L is 1 there and 1/√3 at the corners.
    let expected = 2.0 * 2.0_f64.sqrt().atan().to_degrees();
    assert!((seen.light.degrees - expected).abs() < 1e-6, "{seen:?}");
    assert!(
        (seen.light.cosine - (1.0 - 3.0_f64.sqrt().recip())).abs() < 1e-9,
        "{seen:?}"
    );
    let far = 2.0 * (2.0_f64.sqrt() / 2.0).atan().to_degrees();
    assert!((seen.viewer.degrees - far).abs() < 1e-6, "{seen:?}");
    // A local viewer's V points to the eye even in parallel projection; a light that is off does not count.
    plane.camera.projection = Projection::Orthographic;
    plane.lights[0].mute = true;
    let parallel = found(&plane);
    assert_eq!(hold(&parallel), [true, false, true]);
    assert_eq!(parallel.viewer, seen.viewer);
    plane.camera.viewer = Viewer::Infinite;
    assert_eq!(hold(&found(&plane)), [true; 3]);
}

/// Draws a plane as a whole in parallel projection; only the local viewer makes its highlight vary.
#[test]
fn a_local_viewer_fails_in_parallel_projection() {
    let mut plane = scene(ObjectKind::Plane);
    (plane.object.segments, plane.object.rings) = (1, 1);
    plane.camera = Camera {
        projection: Projection::Orthographic,
        ..Default::default()
    };
    plane.lights[0].direction = glam::DVec3::NEG_Z;
    let far = found(&Scene {
        camera: Camera {
            viewer: Viewer::Infinite,
            ..plane.camera.clone()
        },
        ..plane.clone()
    });
    assert_eq!((hold(&far), far.error.greatest < 1e-5), ([true; 3], true));
    let near = found(&plane);
    assert!(near.error.greatest > 0.01, "{near:?}");
    assert_eq!(hold(&near), [true, false, true], "{near:?}");
}

#[test]
fn what_the_three_conditions_assume_is_named() {
    type Change = fn(&mut Scene);
    let changes: [(Change, &[Assumption]); 7] = [
        (
            |scene| scene.pattern.kind = PatternKind::Stripes,
            &[Assumption::Pattern],
        ),
        (
            |scene| scene.lights[0].attenuation = Attenuation::Viewer,
            &[Assumption::ViewerDistance],
        ),
        (
            |scene| {
                scene.lights[0].kind = LightKind::Spot;
                scene.lights[0].attenuation = Attenuation::Light;
            },
            &[Assumption::LightDistance, Assumption::Spot],
        ),
        (
            |scene| {
                (scene.shading.shadows, scene.object.kind) = (true, ObjectKind::Polygons);
                scene.object.normals = NormalSource::Facet;
                let corner = |x, y, z| glam::DVec3::new(x, y, z);
                scene.object.vertices = vec![
                    corner(-1.0, 0.0, -1.0),
                    corner(-1.0, 0.0, 1.0),
                    corner(1.0, 0.0, 1.0),
                    corner(1.0, 0.0, -1.0),
                    corner(-0.3, 0.6, -0.3),
                    corner(-0.3, 0.6, 0.3),
                    corner(0.3, 0.6, 0.3),
                ]
                .into();
                scene.object.faces = vec![vec![0, 1, 2, 3].into(), vec![4, 5, 6].into()].into();
            },
            &[Assumption::Shadows],
        ),
        (
            |scene| {
                scene.depth_cueing.by = CuedBy::Vertex;
                scene.depth_cueing.color = Rgb::ONE;
            },
            &[Assumption::DepthCueing],
        ),
        (
            // The scene's own mode makes no difference.
            |scene| {
                scene.shading.flat_at = FlatAt::ProvokingVertex;
                scene.shading.mode = ShadingMode::Interpolated;
            },
            &[Assumption::VertexNormals],
        ),
        (
            |scene| {
                scene.shading.flat_at = FlatAt::VertexMean;
                scene.object.normals = NormalSource::Facet;
                scene.depth_cueing.by = CuedBy::Pixel;
            },
            &[],
        ),
    ];
    for (change, expected) in changes {
        let mut scene = scene(ObjectKind::Cube);
        change(&mut scene);
        let found = found(&scene);
        assert_eq!(found.further, expected, "{found:?}");
        let wrong = found.error.greatest > 1e-3;
        assert_eq!(wrong, !expected.is_empty(), "{expected:?}: {found:?}");
    }
}

/// Checks that flat minus exact equals the comparison of the two pictures, wherever flat shading evaluates the equation.
#[test]
fn the_pictures_are_those_of_the_scene() {
    let mut scene = presets::find("flat-facets").expect("built in").scene();
    scene.image.size = [90, 90];
    let mut before = Vec::new();
    for flat_at in FlatAt::VALUES {
        scene.shading.flat_at = *flat_at;
        let found = found(&scene);
        let [flat, exact] = [ShadingMode::Flat, ShadingMode::Exact].map(|mode| {
            let mut renderer = Renderer::default();
            renderer.keep_linear(true);
            scene.shading.mode = mode;
            renderer.render(&scene);
            renderer.linear().to_vec()
        });
        let [flat_picture, exact_picture] = [&flat, &exact].map(|pixels| LinearPicture {
            width: 90,
            pixels,
            clamps: true,
        });
        assert_eq!(found.everywhere, error_figures(flat_picture, exact_picture));
        let both = flat.iter().zip(&exact);
        let inside = both.clone().filter(|(a, b)| a[3] > 0.0 && b[3] > 0.0);
        let alone = both.filter(|(a, b)| (a[3] > 0.0) != (b[3] > 0.0)).count();
        assert_eq!(found.error.pixels, inside.clone().count() as u64);
        assert_eq!(found.outline_pixels(), alone as u64);
        assert!(alone > 10);
        let off = |(a, b): (&[f32; 4], &[f32; 4])| {
            (0..3).fold(0.0, |most: f64, c| {
                most.max((f64::from(a[c].min(1.0)) - f64::from(b[c].min(1.0))).abs())
            })
        };
        let greatest = inside.map(off).fold(0.0, f64::max);
        assert!((found.error.greatest - greatest).abs() < 1e-12);
        before.push(found.error.greatest);
    }
    assert!(
        before[0] != before[1] && before[1] != before[2],
        "{before:?}"
    );
}

#[test]
fn polygons_without_a_surface_stand_for_what_their_normals_say() {
    let mut scene = presets::find("shared-vertices").expect("built in").scene();
    scene.image.size = [80, 60];
    let about = |scene: &Scene| {
        let found = found(scene);
        (hold(&found)[2], found.title(2), found.figures(2))
    };
    let (_, title, figures) = about(&scene);
    assert!(
        !(title.to_owned() + &figures).contains("surface"),
        "{title}: {figures}"
    );
    scene.object.normals = NormalSource::Facet;
    assert!(about(&scene).0);
    scene.object.kind = ObjectKind::Cube;
    assert!(about(&scene).2.contains("surface"));
}
