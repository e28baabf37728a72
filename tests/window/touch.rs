//! The picture on a touch screen: one finger turns it, two zoom and shift it, a long press sets the probe; a finger that goes up
//! or down scrolls the panel.

use crate::common::hands::{folded, named, picture_place, press, scene, window};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Event, Modifiers, PointerButton, Pos2, Rect, TouchDeviceId, TouchId, TouchPhase, Vec2, vec2,
};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use glam::DVec3;
use shading_lab::app::App;

/// Puts a finger down, moves or lifts it, reported as by a browser: the first finger is the pointer as well.
fn touch(harness: &mut Harness<'_, App>, finger: u64, phase: TouchPhase, pos: Pos2) {
    let first = finger == 0;
    let button = |pressed| Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let mut events = vec![Event::Touch {
        device_id: TouchDeviceId(0),
        id: TouchId(finger),
        phase,
        pos,
        force: None,
    }];
    match phase {
        TouchPhase::Start if first => events.extend([Event::PointerMoved(pos), button(true)]),
        TouchPhase::Move if first => events.push(Event::PointerMoved(pos)),
        TouchPhase::End if first => events.extend([button(false), Event::PointerGone]),
        _ => {}
    }
    harness.input_mut().events.extend(events);
    // One frame at a time: a finger at rest for more than half a second is a long press.
    harness.step();
}

#[test]
fn one_finger_turns_two_zoom_and_shift() {
    let mut harness = window("sphere");
    let middle = picture_place(&harness).center();
    let at = middle + vec2(-120.0, 90.0);
    let before = scene(&harness).camera.clone();
    touch(&mut harness, 0, TouchPhase::Start, at);
    for step in 1..=5u8 {
        let moved = at + vec2(10.0 * f32::from(step), 0.0);
        touch(&mut harness, 0, TouchPhase::Move, moved);
    }
    touch(&mut harness, 0, TouchPhase::End, at + vec2(50.0, 0.0));
    harness.run_ok();
    let turned = scene(&harness).camera.clone();
    assert!(turned.eye.distance(before.eye) > 0.1, "one finger turns");
    assert!((turned.distance() - before.distance()).abs() < 1e-9);
    assert_eq!(turned.target, before.target);

    touch(&mut harness, 0, TouchPhase::Start, middle - vec2(40.0, 0.0));
    touch(&mut harness, 1, TouchPhase::Start, middle + vec2(40.0, 0.0));
    for step in 1..=8u8 {
        let apart = vec2(40.0 + 5.0 * f32::from(step), 0.0);
        touch(&mut harness, 0, TouchPhase::Move, middle - apart);
        touch(&mut harness, 1, TouchPhase::Move, middle + apart);
    }
    let nearer = scene(&harness).camera.clone();
    let factor = turned.distance() / nearer.distance();
    assert!(
        (factor - 2.0).abs() < 0.1,
        "the picture follows the fingers: {factor}"
    );
    for step in 1..=5u8 {
        let down = vec2(0.0, 10.0 * f32::from(step));
        touch(
            &mut harness,
            0,
            TouchPhase::Move,
            middle + down - vec2(80.0, 0.0),
        );
        touch(
            &mut harness,
            1,
            TouchPhase::Move,
            middle + down + vec2(80.0, 0.0),
        );
    }
    let shifted = scene(&harness).camera.clone();
    assert!(
        shifted.target.y > nearer.target.y + 0.05,
        "what is seen goes down"
    );
    // The remaining finger moves nothing.
    touch(&mut harness, 1, TouchPhase::End, middle + vec2(80.0, 50.0));
    touch(&mut harness, 0, TouchPhase::Move, middle + vec2(0.0, -60.0));
    touch(&mut harness, 0, TouchPhase::End, middle + vec2(0.0, -60.0));
    assert_eq!(scene(&harness).camera, shifted);
}

#[test]
fn a_long_press_sets_the_probe() {
    let mut harness = window("sphere");
    let at = picture_place(&harness).center() + vec2(30.0, 20.0);
    let before = (
        harness.state().state().window.probe,
        scene(&harness).clone(),
    );
    touch(&mut harness, 0, TouchPhase::Start, at);
    // A frame of a window without a screen takes a quarter of a second.
    (0..8).for_each(|_| harness.step());
    touch(&mut harness, 0, TouchPhase::End, at);
    assert_ne!(harness.state().state().window.probe, before.0);
    assert_eq!(*scene(&harness), before.1, "the camera stays");
}

#[test]
fn a_field_stays_in_sight_when_the_keyboard_takes_half_of_the_screen() {
    let n = named("material.n");
    for ([width, height], keyboard) in [
        ([390.0, 844.0], 400.0),
        ([844.0, 390.0], 200.0),
        ([360.0, 640.0], 330.0),
    ] {
        let mut harness = folded("sphere");
        harness.set_size(vec2(width, height));
        harness.run();
        if harness
            .query_by_role_and_label(Role::SpinButton, n)
            .is_none()
        {
            press(&mut harness, "view-controls");
        }
        // While text is typed into the control, it is a text field.
        let place = |harness: &Harness<'_, App>| {
            harness
                .query_by(|node| node.is_focused())
                .map(|node| node.rect())
        };
        harness
            .get_by_role_and_label(Role::SpinButton, n)
            .scroll_to_me();
        harness.run();
        harness.get_by_role_and_label(Role::SpinButton, n).click();
        harness.run();
        assert!(
            place(&harness).is_some(),
            "{width} × {height}: n is typed in"
        );
        harness.set_size(vec2(width, height - keyboard));
        // A browser hides its keyboard after a single frame without a text field.
        harness.step();
        let seen = Rect::from_min_max(
            picture_place(&harness).min,
            Pos2::new(width, height - keyboard),
        );
        assert!(
            harness.output().platform_output.ime.is_some(),
            "{width} × {height}: n is out of sight"
        );
        harness.run();
        assert!(harness.output().platform_output.ime.is_some());
        assert!(seen.contains_rect(place(&harness).unwrap()));
    }
}

/// Moves a finger from the middle of the slider of Kd by `way`. Returns the new Kd, and how far the slider has moved.
fn thumb(way: Vec2) -> (DVec3, f32) {
    let mut harness = folded("sphere");
    harness.set_size(vec2(390.0, 844.0));
    harness.run();
    let kd = named("material.kd");
    if harness.query_by_role_and_label(Role::Slider, kd).is_none() {
        press(&mut harness, "view-controls");
    }
    let place = |harness: &Harness<'_, App>| {
        let slider = harness.get_by_role_and_label(Role::Slider, kd);
        slider.rect()
    };
    // The first touch tells the window that there are fingers, and the rows make room for them.
    touch(&mut harness, 0, TouchPhase::Start, Pos2::new(195.0, 5.0));
    touch(&mut harness, 0, TouchPhase::End, Pos2::new(195.0, 5.0));
    harness.run();
    let before = place(&harness);
    let at = before.center();
    touch(&mut harness, 0, TouchPhase::Start, at);
    for step in 1..=8u8 {
        let moved = at + way * (f32::from(step) / 8.0);
        touch(&mut harness, 0, TouchPhase::Move, moved);
    }
    let moved = place(&harness).min.y - before.min.y;
    touch(&mut harness, 0, TouchPhase::End, at + way);
    (scene(&harness).material.kd, moved)
}

#[test]
fn a_finger_that_goes_up_over_a_slider_scrolls_and_one_that_goes_sideways_drags_it() {
    let before = scene(&window("sphere")).material.kd;
    let (kd, moved) = thumb(vec2(3.0, -90.0));
    assert_eq!(kd, before, "scrolling changes nothing");
    assert!(moved < -50.0, "the panel follows the finger: {moved}");
    let (kd, moved) = thumb(vec2(90.0, 3.0));
    assert_ne!(kd, before, "the slider follows the finger");
    assert!(moved.abs() < 1.0, "the panel stays: {moved}");
}
