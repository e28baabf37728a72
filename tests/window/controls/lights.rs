//! Lights in the window: added, named, muted, dragged.

use crate::common::dice::Dice;
use crate::common::hands::{
    choose, drag, enter, open_view, picture, press, scene, undo, wait, window,
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
    harness
        .get_by_role_and_label(Role::Button, "Add light")
        .click_accesskit();
    harness.run();
    assert_eq!(scene(&harness).lights.len(), 2);
    let lit = picture(&harness);
    assert!(lit != before, "another light changes the picture");
    harness
        .get_by_role_and_label(Role::Button, "Remove light 2")
        .click_accesskit();
    harness.run();
    assert!(picture(&harness) == before);
}

#[test]
fn a_spot_lights_cone_is_typed() {
    let mut harness = window("sphere");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, "Light 1 cone")
            .is_none(),
        "a point has no cone"
    );
    choose(&mut harness, "Light 1 kind", "spotlight");
    for (name, value) in [
        ("Light 1 cone", 6.0),
        ("Light 1 softness", 0.8),
        ("Light 1 exponent", 90.0),
        ("Light 1 direction x", -2.0),
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
    enter(&mut harness, "Light 1 cone", 500.0);
    assert_eq!(
        scene(&harness).lights[0].cone,
        6.0,
        "a cone is at most a half-space, so this is refused"
    );
    let reason = harness.state().state().session.notice.as_deref();
    assert_eq!(
        reason,
        Some("`light.0.cone` is 500, expected 0.1 to 90 degrees"),
        "as a scene file would be"
    );
    // What would take all memory is refused before it is drawn.
    let before = scene(&harness).clone();
    enter(&mut harness, "Segments", 4e9);
    assert_eq!(*scene(&harness), before);
}

#[test]
fn lights_are_muted_and_soloed() {
    let mut harness = window("three-lights");
    let all = picture(&harness);
    press(&mut harness, "Mute light 1");
    let muted = picture(&harness);
    assert!(scene(&harness).lights[0].mute && muted != all);
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, "Light 1 kind")
            .is_some(),
        "its controls stay"
    );
    press(&mut harness, "Mute light 1");
    assert!(picture(&harness) == all);
    press(&mut harness, "Light 2");
    press(&mut harness, "Solo light 2");
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
        .get_by_role_and_label(Role::TextInput, "Light 1 name")
        .focus();
    harness.run();
    harness
        .get_by_role_and_label(Role::TextInput, "Light 1 name")
        .type_text("Key\u{7} lamp");
    harness.run();
    assert_eq!(scene(&harness).lights[0].name, "Key lamp");
    assert!(
        harness
            .query_by_role_and_label(Role::Button, "Light 1, Key lamp")
            .is_some(),
        "its chip says so"
    );
    harness
        .get_by_role_and_label(Role::TextInput, "Light 1 name")
        .type_text(&"x".repeat(100));
    harness.run();
    assert_eq!(scene(&harness).lights[0].name.chars().count(), 64);
    assert_eq!(scene(&harness).validate(), Ok(()));
    assert!(picture(&harness) == before, "a name is not seen");
}

#[test]
fn an_area_lights_points_and_their_error_are_shown() {
    let mut harness = window("sphere");
    choose(&mut harness, "Light 1 kind", "area");
    let shown = |text: &'static str| {
        move |harness: &Harness<'_, App>| harness.query_by_label_contains(text).is_some()
    };
    assert!(
        wait(&mut harness, shown("N = 16: error ")),
        "the error of the default"
    );
    let before = picture(&harness);
    enter(&mut harness, "Light 1 samples", 1.0);
    assert!(picture(&harness) != before);
    assert!(
        wait(&mut harness, shown("N = 1: error ")),
        "the error of one point"
    );
    choose(&mut harness, "Light 1 shape", "sphere");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, "Light 1 extent width")
            .is_none(),
        "a sphere has no width"
    );
    enter(&mut harness, "Light 1 radius", 1.5);
    assert_eq!(scene(&harness).lights[0].radius, 1.5);
    press(&mut harness, "Mute light 1");
    assert!(
        wait(&mut harness, shown("does not reach the picture")),
        "a muted light has no error"
    );
}

#[test]
fn a_spot_lights_arrow_is_dragged() {
    let mut harness = window("sphere");
    choose(&mut harness, "Light 1 kind", "spotlight");
    let before = scene(&harness).clone();
    // The light has been aimed at the camera's target, so that its arrow ends in the picture's middle.
    let middle = harness
        .get_by_role_and_label(Role::Image, "Picture, Phong shading")
        .rect()
        .center();
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
    // Beside the handles the camera turns.
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
                if count < 8 { "Add light" } else { "Duplicate" },
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
        press(&mut harness, "Duplicate");
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

/// Buttons whose names begin so, by their numbers.
fn numbered(harness: &Harness<'_, App>, name: &str) -> Vec<usize> {
    let numbers = harness.query_all_by_role(Role::Button).filter_map(|node| {
        node.accesskit_node()
            .label()?
            .strip_prefix(name)?
            .parse()
            .ok()
    });
    numbers.collect()
}

/// What the window says of its lights, beside those that the scene has.
fn check_lights(harness: &Harness<'_, App>, done: &[&str]) {
    let count = scene(harness).lights.len();
    let all: Vec<usize> = (1..=count).collect();
    assert_eq!(numbered(harness, "Light "), all, "{done:?}");
    assert_eq!(numbered(harness, "Remove light "), all, "{done:?}");
    let chosen = harness.state().state().session.light + 1;
    assert!(
        chosen <= count.max(1),
        "light {chosen} of {count}: {done:?}"
    );
    let none = harness.query_by_label_contains("There is no light");
    assert_eq!(none.is_some(), count == 0, "{done:?}");
    let duplicate = harness.get_by_role_and_label(Role::Button, "Duplicate");
    let disabled = duplicate.accesskit_node().is_disabled();
    assert_eq!(disabled, count == 0, "{done:?}");
    // The rows are those of the chosen one, and of no other; so are the vectors.
    let kinds = (1..=count.max(4)).filter(|number| {
        let kind = format!("Light {number} kind");
        harness
            .query_by_role_and_label(Role::ComboBox, &kind)
            .is_some()
    });
    let expected = if count == 0 { vec![] } else { vec![chosen] };
    assert_eq!(kinds.collect::<Vec<_>>(), expected, "{done:?}");
    let vectors = format!("Vectors, light {chosen}");
    let shown = harness.query_by_label(&vectors).is_some();
    assert_eq!(shown, count > 1, "{done:?}");
}

#[test]
fn the_chosen_light_is_one_that_there_is_after_every_step_back() {
    let mut harness = window("sphere");
    open_view(&mut harness, "Equation");
    press(&mut harness, "Add light");
    press(&mut harness, "Add light");
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
            "add" => press(&mut harness, "Add light"),
            "double" if count > 0 => press(&mut harness, "Duplicate"),
            "choose" | "remove" if count > 0 => {
                let number = dice.between(1.0, count as f64 + 1.0) as usize;
                let word = if step == "remove" {
                    "Remove light"
                } else {
                    "Light"
                };
                press(&mut harness, &format!("{word} {number}"));
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
