//! The lights' handles in the window, and the camera's way back.

use crate::common::hands::{
    built_in, choose, drag, picture_place, press, scene, seen, undo, window, window_of,
};
use eframe::egui::vec2;
use glam::DVec3;
use shading_lab::geometry::tessellate;
use shading_lab::scene::{Camera, Projection, View};

#[test]
fn a_dragged_light_keeps_its_distance_and_is_one_step_of_undo() {
    let mut harness = window("sphere");
    press(&mut harness, "lights-add");
    let before = scene(&harness).clone();
    let light = before.lights.len() - 1;
    let from = before.lights[light].position;
    assert!(before.lights[light].color.max_element() < 0.7, "moderate");
    let start = seen(&harness, from).expect("before the eye");
    harness.drag_at(start);
    harness.run();
    for step in 1..5 {
        harness.hover_at(start + vec2(-9.0, 6.0) * step as f32);
        harness.run();
    }
    let end = start + vec2(-36.0, 24.0);
    harness.drop_at(end);
    harness.run();
    let at = scene(&harness).lights[light].position;
    assert!(at.distance(from) > 0.05, "{at}");
    assert!((at.length() - from.length()).abs() < 0.01, "{from} to {at}");
    let place = seen(&harness, at).expect("before the eye");
    assert!(place.distance(end) < 3.0, "under the pointer");
    assert_eq!(scene(&harness).camera, before.camera);
    undo(&mut harness);
    assert_eq!(scene(&harness).lights, before.lights);
}

#[test]
fn the_camera_comes_back_and_shows_another_shape_whole() {
    let mut harness = window("teapot");
    let opened = scene(&harness).camera.clone();
    let middle = picture_place(&harness).center();
    drag(
        &mut harness,
        middle + vec2(90.0, 90.0),
        middle + vec2(140.0, 120.0),
    );
    assert_ne!(scene(&harness).camera, opened);
    press(&mut harness, "controls-reset-camera");
    assert_eq!(scene(&harness).camera, opened);
    choose(&mut harness, "object.kind", "plane");
    press(&mut harness, "controls-reset-camera");
    let fitted = scene(&harness).camera.clone();
    assert!(fitted.distance() > opened.distance() + 0.1, "{fitted:?}");
    let frame = harness.state().frame();
    let size = [frame.width, frame.height];
    let view = View::new(&fitted, size);
    let least = Camera::MARGIN * f64::from(size[0].min(size[1])) - 1.0;
    for p in &tessellate(&scene(&harness).object).positions {
        let (at, _) = view.project(p.as_dvec3()).expect("before the eye");
        let room = at
            .min_element()
            .min(f64::from(size[0]) - at.x)
            .min(f64::from(size[1]) - at.y);
        assert!(room > least, "{p} at {at}");
    }
}

/// Checks a handle while the object's middle appears farther out than `f32` reaches: the light's number is placed on the side
/// away from that middle.
#[test]
fn lights_have_handles_where_the_object_is_seen_extremely_far_out() {
    let mut loaded = built_in("sphere");
    let scene = &mut loaded.scene;
    scene.camera.target = DVec3::new(1e10, 0.0, 0.0);
    scene.camera.eye = DVec3::new(1e10, 0.0, 1e4);
    scene.camera.projection = Projection::Orthographic;
    scene.camera.height = 1e-30;
    scene.lights[0].position = scene.camera.target;
    scene.validate().expect("a sound scene");
    window_of(loaded).run();
}
