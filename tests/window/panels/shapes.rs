//! Polygons, tessellation and the camera, from their controls and in the picture.

use crate::common::hands::{choose, drag, enter, named, picture_place, press, scene, undo, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use glam::{DVec3, Vec3Swizzles};
use shading_lab::app::App;
use shading_lab::geometry::tessellate;
use shading_lab::scene::{ObjectKind, View};

/// Returns the position on the screen of a point of the scene.
fn on_screen(harness: &Harness<'_, App>, world: DVec3) -> Pos2 {
    let rect = picture_place(harness);
    let size = [
        harness.state().frame().width,
        harness.state().frame().height,
    ];
    let (pixel, _) = View::new(&scene(harness).camera, size)
        .project(world)
        .expect("in sight");
    // In the first of several panes, which begins where the picture does; a pixel is a point.
    rect.min + vec2(pixel.x as f32, pixel.y as f32)
}

#[test]
fn a_vertex_is_dragged_in_the_picture() {
    let mut harness = window("orientation");
    let before = scene(&harness).clone();
    let corner = before.object.vertices[2];
    let at = on_screen(&harness, corner);
    drag(&mut harness, at, at + vec2(-30.0, 25.0));
    let moved = scene(&harness).clone();
    let landed = on_screen(&harness, moved.object.vertices[2]);
    assert!(
        landed.distance(at + vec2(-30.0, 25.0)) < 3.0,
        "{landed} from {at}"
    );
    assert_eq!(
        (&moved.camera, &moved.lights),
        (&before.camera, &before.lights)
    );
    assert!(
        (moved.object.vertices[2].z - corner.z).abs() < 1e-9,
        "parallel to the picture"
    );
    undo(&mut harness);
    assert_eq!(*scene(&harness), before, "a drag is one step");
    // Beyond the opposite corner the square would cross itself.
    let opposite = on_screen(&harness, before.object.vertices[0]);
    drag(
        &mut harness,
        at,
        at + (opposite - at) * 1.05 + vec2(12.0, 0.0),
    );
    let stopped = scene(&harness);
    assert_eq!(stopped.validate(), Ok(()));
    assert!(
        stopped.object.vertices[2].distance(corner) > 0.5,
        "{}",
        stopped.object.vertices[2]
    );
    undo(&mut harness);
    // With Shift the vertex leaves the picture's plane.
    harness.event(Event::PointerMoved(at));
    harness.event_modifiers(
        Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed: true,
            modifiers: Modifiers::SHIFT,
        },
        Modifiers::SHIFT,
    );
    // A single frame: in further ones the drag would go on without Shift.
    harness.step();
    harness.event_modifiers(Event::PointerMoved(at + vec2(0.0, -40.0)), Modifiers::SHIFT);
    harness.run();
    harness.event_modifiers(
        Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed: false,
            modifiers: Modifiers::SHIFT,
        },
        Modifiers::SHIFT,
    );
    harness.run();
    let vertex = scene(&harness).object.vertices[2];
    assert!(
        vertex.z > 0.05 && (vertex - corner).truncate().length() < 1e-2,
        "{vertex}"
    );
}

#[test]
fn polygons_are_counted_and_their_vertices_typed() {
    let mut harness = window("sphere");
    choose(&mut harness, "object.kind", "polygons");
    assert_eq!(
        scene(&harness).object.vertices.len(),
        4,
        "a quadrilateral to begin with"
    );
    assert_eq!(scene(&harness).validate(), Ok(()));
    assert!(
        harness
            .query_by_label(&english!("lights-polygons", vertices = 4, faces = 1))
            .is_some()
    );
    assert!(
        harness
            .query_by_role_and_label(Role::Slider, named("object.segments"))
            .is_none()
    );
    enter(&mut harness, "lights-vertex", 2.0);
    enter(&mut harness, "lights-vertex-position.name.x", 1.25);
    assert_eq!(scene(&harness).object.vertices[2].x, 1.25);
    undo(&mut harness);
    assert_eq!(scene(&harness).object.vertices[2].x, 0.85);
    let mut harness = window("sphere");
    choose(&mut harness, "object.kind", "corrugated");
    assert_eq!(scene(&harness).object.kind, ObjectKind::Corrugated);
    enter(&mut harness, "object.segments", 2.0);
    assert_eq!(
        (scene(&harness).object.segments, scene(&harness).validate()),
        (2, Ok(()))
    );
    // Too few segments for a sphere are raised to enough.
    let mut harness = window("vertex-normals");
    enter(&mut harness, "object.segments", 2.0);
    choose(&mut harness, "object.kind", "sphere");
    assert_eq!(
        (scene(&harness).object.segments, scene(&harness).validate()),
        (3, Ok(()))
    );
}

#[test]
fn the_camera_is_rolled_and_put_back() {
    let mut harness = window("cube");
    let before = scene(&harness).clone();
    harness
        .get_by_role_and_label(Role::Slider, named("camera.roll"))
        .set_value_accesskit(90.0);
    harness.run();
    assert_eq!(scene(&harness).camera.roll, 90.0);
    // The grabbed point follows the pointer: to the right in the picture is upwards in the world.
    let middle = picture_place(&harness).center();
    drag(
        &mut harness,
        middle + vec2(150.0, 150.0),
        middle + vec2(200.0, 150.0),
    );
    let turned = &scene(&harness).camera;
    assert_eq!(turned.roll, 90.0, "turning keeps the roll");
    assert!(
        turned.eye.y > before.camera.eye.y + 0.1
            && turned.eye.xz().angle_to(before.camera.eye.xz()).abs() < 0.05,
        "{turned:?}"
    );
    press(&mut harness, "controls-reset-camera");
    assert_eq!(scene(&harness).camera, before.camera);
}

#[test]
fn one_number_cuts_every_shape_into_as_many_triangles() {
    let mut harness = window("sphere");
    let drawn =
        |harness: &Harness<'_, App>| tessellate(&scene(harness).object).triangle_count() as f64;
    for wanted in [6.0, 100.0, 7000.0, 150_000.0] {
        enter(&mut harness, "lights-triangles", wanted);
        let found = drawn(&harness);
        assert!(
            (found - wanted).abs() <= 2.0 * wanted.sqrt(),
            "{found} for {wanted}"
        );
        let field = harness.get_by_role_and_label(Role::SpinButton, english!("lights-triangles"));
        assert_eq!(
            field.accesskit_node().numeric_value(),
            Some(found),
            "the field says what there is"
        );
    }
    let object = scene(&harness).object.clone();
    assert!(
        object.segments.abs_diff(2 * object.rings) <= 2,
        "polygons are about square: {object:?}"
    );
    assert!(
        harness
            .query_by_label_contains("polygons, ")
            .is_some_and(|node| {
                node.accesskit_node()
                    .value()
                    .or(node.accesskit_node().label())
                    .is_some_and(|text| text.contains("vertices"))
            })
    );
    // A slider's end, and numbers beyond the sensible range.
    harness
        .get_by_role_and_label(Role::Slider, english!("lights-triangles"))
        .set_value_accesskit(12.0);
    harness.run();
    assert_eq!(drawn(&harness), 12.0);
    enter(&mut harness, "lights-triangles", -5.0);
    assert_eq!(
        (
            scene(&harness).object.segments,
            scene(&harness).object.rings
        ),
        (3, 2)
    );
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run();
    assert!(drawn(&harness) > 6.0, "undone");
}

#[test]
fn the_teapot_is_cut_by_one_number_too() {
    let mut harness = window("teapot");
    for wanted in [128.0, 3000.0, 60_000.0] {
        enter(&mut harness, "lights-triangles", wanted);
        let found = tessellate(&scene(&harness).object).triangle_count() as f64;
        assert!(
            (found - wanted).abs() <= 16.0 * wanted.sqrt(),
            "{found} for {wanted}"
        );
    }
    let reset = english!("controls-reset", name = named("lights-triangles"));
    press(&mut harness, &reset);
    assert_eq!(
        (
            scene(&harness).object.segments,
            scene(&harness).object.rings
        ),
        (64, 64),
        "as opened"
    );
}
