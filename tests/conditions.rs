//! The three conditions under which flat shading is exact: what they measure, and that they are enough.

use shading_lab::analysis::{CONDITIONS, Conditions, conditions};
use shading_lab::render::Renderer;
use shading_lab::scene::{
    Light, LightKind, NormalSource, ObjectKind, Projection, Rgb, Scene, ShadingMode, Viewer,
};

/// An object under a directional light, seen from infinity.
fn scene(kind: ObjectKind) -> Scene {
    let mut scene = Scene::default();
    scene.image.size = [120, 100];
    scene.object.kind = kind;
    scene.camera.eye = glam::DVec3::new(1.3, 1.7, 3.1);
    scene.camera.viewer = Viewer::Infinite;
    // A highlight wide enough to be seen on a cube.
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
    let cube = found(&scene(ObjectKind::Cube));
    assert_eq!(hold(&cube), [true; 3], "{cube:?}");
    assert!(
        cube.error.pixels > 1000 && cube.error.greatest < 1e-5,
        "{cube:?}"
    );
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
    // Of a sphere next to the equator, which lies between two rings: the normal of the polygon above it is tilted by t.
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
    // In parallel projection V is constant; a light that is off does not count.
    plane.camera.projection = Projection::Orthographic;
    plane.lights[0].mute = true;
    assert_eq!(hold(&found(&plane)), [true; 3]);
}

#[test]
fn polygons_without_a_surface_stand_for_what_their_normals_say() {
    let mut scene = shading_lab::scene::presets::find("shared-vertices")
        .expect("built in")
        .scene();
    scene.image.size = [80, 60];
    scene.object.normals = NormalSource::Facet;
    assert!(hold(&found(&scene))[2]);
}
