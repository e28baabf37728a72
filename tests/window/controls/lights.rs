//! Lights in the window: added, named, muted, dragged.

use crate::common::dice::Dice;
use crate::common::hands::{
    choose, drag, enter, named, open_view, picture, picture_place, press, scene, undo, wait, window,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use glam::{DVec2, DVec3};
use shading_lab::app::App;
use shading_lab::scene::{Light, LightKind, Scene, View};

/// Random steps among lights and back.
const LIGHT_STEPS: usize = 60;

#[test]
fn lights_are_added_and_removed() {
    let mut harness = window("sphere");
    let before = picture(&harness);
    press(&mut harness, "lights-add");
    assert_eq!(scene(&harness).lights.len(), 2);
    let lit = picture(&harness);
    assert!(lit != before, "another light changes the picture");
    press(&mut harness, &english!("lights-remove", number = 2));
    assert!(picture(&harness) == before);
}

#[test]
fn a_spot_lights_cone_is_typed() {
    let mut harness = window("sphere");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, named("light.0.cone"))
            .is_none(),
        "a point has no cone"
    );
    choose(&mut harness, "light.0.kind", "spot");
    for (name, value) in [
        ("light.0.cone", 6.0),
        ("light.0.softness", 0.8),
        ("light.0.exponent", 90.0),
        ("light.0.direction.x", -2.0),
    ] {
        let before = picture(&harness);
        enter(&mut harness, name, value);
        assert!(
            picture(&harness) != before,
            "{name} = {value} changes nothing"
        );
    }
    assert_eq!(
        (
            scene(&harness).lights[0].kind,
            scene(&harness).lights[0].cone
        ),
        (LightKind::Spot, 6.0)
    );
    enter(&mut harness, "light.0.cone", 500.0);
    assert_eq!(
        scene(&harness).lights[0].cone,
        6.0,
        "a cone is at most a half-space, so this is refused"
    );
    let mut wide = scene(&harness).clone();
    wide.lights[0].cone = 500.0;
    let reason = harness.state().state().session.said();
    let reason = reason.map(str::to_owned);
    let refused = wide.validate().map_err(|error| error.to_string());
    assert_eq!(reason, refused.err(), "as a scene file would be");
    // A number that would take all memory is refused before it is drawn.
    let before = scene(&harness).clone();
    enter(&mut harness, "object.segments", 4e9);
    assert_eq!(*scene(&harness), before);
}

#[test]
fn lights_are_muted_and_soloed() {
    let mut harness = window("three-lights");
    let all = picture(&harness);
    press(&mut harness, &english!("lights-mute.name", number = 1));
    let muted = picture(&harness);
    assert!(scene(&harness).lights[0].mute && muted != all);
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, named("light.0.kind"))
            .is_some(),
        "its controls stay"
    );
    press(&mut harness, &english!("lights-mute.name", number = 1));
    assert!(picture(&harness) == all);
    press(&mut harness, &english!("lights-number", number = 2));
    press(&mut harness, &english!("lights-solo.name", number = 2));
    assert!(scene(&harness).lights[1].solo);
    assert!(picture(&harness) != all && picture(&harness) != muted);
    undo(&mut harness);
    assert!(picture(&harness) == all);
}

#[test]
fn a_light_is_named() {
    let mut harness = window("sphere");
    let before = picture(&harness);
    harness
        .get_by_role_and_label(Role::TextInput, named("light.0.name"))
        .focus();
    harness.run();
    harness
        .get_by_role_and_label(Role::TextInput, named("light.0.name"))
        .type_text("Key\u{7} lamp");
    harness.run();
    assert_eq!(scene(&harness).lights[0].name, "Key lamp");
    let chip = english!("lights-named", number = 1, name = "Key lamp");
    assert!(
        harness
            .query_by_role_and_label(Role::Button, &chip)
            .is_some(),
        "its chip says so"
    );
    harness
        .get_by_role_and_label(Role::TextInput, named("light.0.name"))
        .type_text(&"x".repeat(100));
    harness.run();
    assert_eq!(scene(&harness).lights[0].name.chars().count(), 64);
    assert_eq!(scene(&harness).validate(), Ok(()));
    assert!(picture(&harness) == before, "a name is not seen");
}

#[test]
fn an_area_lights_points_and_their_error_are_shown() {
    let mut harness = window("sphere");
    choose(&mut harness, "light.0.kind", "area");
    let shown = |text: String| {
        move |harness: &Harness<'_, App>| harness.query_by_label_contains(&text).is_some()
    };
    assert!(
        wait(&mut harness, shown("N = 16: ".to_owned())),
        "the error of the default"
    );
    let before = picture(&harness);
    enter(&mut harness, "light.0.samples", 1.0);
    assert!(picture(&harness) != before);
    assert!(
        wait(&mut harness, shown("N = 1: ".to_owned())),
        "the error of one point"
    );
    choose(&mut harness, "light.0.shape", "sphere");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, named("light.0.extent.width"))
            .is_none(),
        "a sphere has no width"
    );
    enter(&mut harness, "light.0.radius", 1.5);
    assert_eq!(scene(&harness).lights[0].radius, 1.5);
    press(&mut harness, &english!("lights-mute.name", number = 1));
    assert!(
        wait(
            &mut harness,
            shown(english!("lights-sampling-none").to_owned())
        ),
        "a muted light has no error"
    );
}

#[test]
fn a_spot_lights_arrow_is_dragged() {
    let mut harness = window("sphere");
    choose(&mut harness, "light.0.kind", "spot");
    let before = scene(&harness).clone();
    // The light has been aimed at the camera's target, so that its arrow ends in the picture's middle.
    let middle = picture_place(&harness).center();
    drag(&mut harness, middle, middle + vec2(60.0, 20.0));
    let turned = scene(&harness).clone();
    assert!(
        turned.lights[0]
            .direction
            .angle_between(before.lights[0].direction)
            > 0.02,
        "the arrow was turned"
    );
    assert_eq!(
        (turned.camera, turned.lights[0].position),
        (before.camera.clone(), before.lights[0].position)
    );
    undo(&mut harness);
    assert_eq!(*scene(&harness), before, "a drag is one step");
    // A drag beside the handles turns the camera.
    drag(
        &mut harness,
        middle - vec2(0.0, 150.0),
        middle - vec2(50.0, 150.0),
    );
    assert_eq!(scene(&harness).lights, before.lights);
    assert!(scene(&harness).camera != before.camera);
}

#[test]
fn a_new_light_goes_where_it_is_seen_and_no_other_is() {
    for name in ["sphere", "spotlight"] {
        let mut harness = window(name);
        for count in scene(&harness).lights.len() + 1..14 {
            press(
                &mut harness,
                if count < 8 {
                    "lights-add"
                } else {
                    "lights-duplicate"
                },
            );
            let Scene { lights, camera, .. } = scene(&harness);
            assert_eq!(lights.len(), count);
            let size = [
                harness.state().frame().width,
                harness.state().frame().height,
            ];
            let at = |light: &Light| {
                View::new(camera, size)
                    .project(light.position)
                    .map(|(pixel, _)| pixel)
            };
            let added = at(&lights[count - 1]).expect("before the eye");
            let inside = added.cmpgt(DVec2::ZERO).all()
                && added.cmplt(DVec2::from_array(size.map(f64::from))).all();
            assert!(
                inside,
                "light {count} is out of sight at {added} of {size:?}"
            );
            let nearest = lights[..count - 1]
                .iter()
                .filter_map(at)
                .map(|at| at.distance(added))
                .fold(f64::MAX, f64::min);
            assert!(
                nearest > 16.0,
                "light {count} is {nearest} pixels from another"
            );
        }
    }
}

#[test]
fn a_light_from_afar_is_doubled_to_another_direction() {
    let mut harness = window("sun");
    for _ in 0..12 {
        press(&mut harness, "lights-duplicate");
    }
    let directions: Vec<DVec3> = scene(&harness)
        .lights
        .iter()
        .map(|light| light.direction.normalize())
        .collect();
    let close = |i: usize, j: usize| directions[i].dot(directions[j]) > 0.9999;
    assert!(
        (0..directions.len()).all(|i| (0..i).all(|j| !close(i, j))),
        "{directions:?}"
    );
}

/// Returns the numbers of the buttons whose names begin with this message.
fn numbered(harness: &Harness<'_, App>, key: &str) -> Vec<usize> {
    let name = &english!(key, number = "");
    let numbers = harness.query_all_by_role(Role::Button).filter_map(|node| {
        node.accesskit_node()
            .label()?
            .strip_prefix(name)?
            .parse()
            .ok()
    });
    numbers.collect()
}

/// Checks the window's lists of lights against the scene's lights.
fn check_lights(harness: &Harness<'_, App>, done: &[&str]) {
    let count = scene(harness).lights.len();
    let all: Vec<usize> = (1..=count).collect();
    assert_eq!(numbered(harness, "lights-number"), all, "{done:?}");
    assert_eq!(numbered(harness, "lights-remove"), all, "{done:?}");
    let chosen = harness.state().state().session.light + 1;
    assert!(
        chosen <= count.max(1),
        "light {chosen} of {count}: {done:?}"
    );
    let none = harness.query_by_label_contains(english!("idle-no-light"));
    assert_eq!(none.is_some(), count == 0, "{done:?}");
    let duplicate = harness.get_by_role_and_label(Role::Button, english!("lights-duplicate"));
    let disabled = duplicate.accesskit_node().is_disabled();
    assert_eq!(disabled, count == 0, "{done:?}");
    // Rows and vectors are shown for the chosen light only.
    let kinds = (1..=count.max(4)).filter(|number| {
        let kind = named(&format!("light.{}.kind", number - 1));
        harness
            .query_by_role_and_label(Role::ComboBox, kind)
            .is_some()
    });
    let expected = if count == 0 { vec![] } else { vec![chosen] };
    assert_eq!(kinds.collect::<Vec<_>>(), expected, "{done:?}");
    let vectors = english!("point-vectors-of", light = chosen);
    let shown = harness.query_by_label(&vectors).is_some();
    assert_eq!(shown, count > 1, "{done:?}");
}

#[test]
fn the_chosen_light_is_one_that_there_is_after_every_step_back() {
    let mut harness = window("sphere");
    open_view(&mut harness, "view-equation");
    press(&mut harness, "lights-add");
    press(&mut harness, "lights-add");
    check_lights(&harness, &["added", "added"]);
    undo(&mut harness);
    undo(&mut harness);
    check_lights(&harness, &[]);
    let mut dice = Dice(11);
    let mut done: Vec<&str> = vec![];
    let before = scene(&harness).lights.clone();
    for _ in 0..LIGHT_STEPS {
        let count = scene(&harness).lights.len();
        let step = dice.of(&["add", "double", "choose", "remove", "undo", "undo", "redo"]);
        match step {
            "add" => press(&mut harness, "lights-add"),
            "double" if count > 0 => press(&mut harness, "lights-duplicate"),
            "choose" | "remove" if count > 0 => {
                let number = dice.between(1.0, count as f64 + 1.0) as usize;
                let key = if step == "remove" {
                    "lights-remove"
                } else {
                    "lights-number"
                };
                press(&mut harness, &english!(key, number = number));
            }
            "undo" => undo(&mut harness),
            "redo" => {
                harness.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z);
                harness.run();
            }
            _ => continue,
        }
        done.push(step);
        check_lights(&harness, &done);
    }
    while harness
        .state()
        .state()
        .session
        .history()
        .undoable()
        .is_some()
    {
        undo(&mut harness);
    }
    check_lights(&harness, &[]);
    assert_eq!(scene(&harness).lights, before);
}
