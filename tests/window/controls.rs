//! The window's controls: each is found by role and name, changes the picture, and can be undone.

mod law;
mod lights;
mod materials;
mod model;

use crate::common::hands::{
    built_in, choose, drag, enter, named, open_view, picture, picture_place, press, scene, undo,
    window, window_looking,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Shape, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use glam::DVec3;
use shading_lab::analysis::normals::NormalField;
use shading_lab::app::{App, Appearance, ProfileAppearance, ViewName};
use shading_lab::geometry::tessellate;
use shading_lab::scene::{Choice, CompareView, Pane, Rgb, ShadingMode, View, presets};
use std::sync::Arc;

/// Makes a change, checks that the picture changes, and undoes it.
fn changes_the_picture(
    scene: &str,
    prepare: &[Key],
    what: &str,
    change: impl Fn(&mut Harness<'_, App>),
) {
    let mut harness = window(scene);
    for key in prepare {
        harness.key_press(*key);
        harness.run();
    }
    let before = picture(&harness);
    change(&mut harness);
    assert!(
        picture(&harness) != before,
        "{what} changes nothing in {scene}"
    );
    undo(&mut harness);
    assert!(
        picture(&harness) == before,
        "undo of {what} does not bring the picture back"
    );
}

/// Makes a choice, checks that the picture changes, and undoes it.
fn choice_changes_the_picture(scene: &str, prepare: &[Key], list: &str, entry: &str) {
    let choice = format!("{list}: {entry}");
    changes_the_picture(scene, prepare, &choice, |harness| {
        choose(harness, list, entry);
    });
}

/// Sets a slider by the key of its parameter, checks that the picture changes, and undoes it.
fn slider_changes_the_picture(scene: &str, name: &str, value: f64) {
    changes_the_picture(scene, &[], name, |harness| {
        harness
            .get_by_role_and_label(Role::Slider, named(name))
            .set_value_accesskit(value);
        harness.run();
    });
}

#[test]
fn every_slider_of_the_material_changes_the_picture() {
    for (name, value) in [
        ("material.ka", 0.6),
        ("material.kd", 0.2),
        ("material.ks", 0.0),
        ("material.n", 3.0),
    ] {
        slider_changes_the_picture("sphere", name, value);
    }
}

#[test]
fn tessellation_changes_the_picture() {
    slider_changes_the_picture("flat-facets", "object.segments", 7.0);
    slider_changes_the_picture("flat-facets", "object.rings", 5.0);
}

#[test]
fn keys_choose_the_shading_mode() {
    let modes = [
        (Key::Num1, ShadingMode::Flat, true),
        (Key::Num2, ShadingMode::Interpolated, true),
        (Key::Num3, ShadingMode::Gouraud, true),
        (Key::Num5, ShadingMode::Exact, true),
        (Key::Num6, ShadingMode::Phong, false),
        (Key::Num4, ShadingMode::Phong, true),
    ];
    let mut harness = window("torus");
    let mut seen = vec![picture(&harness)];
    for (key, mode, renormalise) in modes {
        harness.key_press(key);
        harness.run();
        assert_eq!(
            (
                scene(&harness).shading.mode,
                scene(&harness).shading.renormalise
            ),
            (mode, renormalise)
        );
        seen.push(picture(&harness));
    }
    seen.sort();
    seen.dedup();
    assert_eq!(
        seen.len(),
        6,
        "six ways of shading are six pictures, and the last is the first again"
    );
}

#[test]
fn a_number_can_be_infinite() {
    let mut harness = window("sphere");
    let before = picture(&harness);
    let infinite = english!("controls-infinite", name = named("material.n"));
    press(&mut harness, &infinite);
    assert_eq!(scene(&harness).material.n, f64::INFINITY);
    assert!(picture(&harness) != before);
}

#[test]
fn a_control_without_effect_is_disabled() {
    let mut harness = window("sphere");
    harness
        .get_by_role_and_label(Role::Slider, named("material.ks"))
        .set_value_accesskit(0.0);
    harness.run();
    let n = harness.get_by_role_and_label(Role::Slider, named("material.n"));
    assert!(
        n.accesskit_node().is_disabled(),
        "n has no effect without Ks"
    );
}

#[test]
fn keys_turn_the_camera_and_move_the_probe() {
    let mut harness = window("sphere");
    let before = scene(&harness).camera.eye;
    harness.key_press(Key::D);
    harness.run();
    assert!(scene(&harness).camera.eye.distance(before) > 0.1);
    assert!(
        (scene(&harness).camera.eye.length() - before.length()).abs() < 1e-9,
        "turning keeps the distance"
    );
    let probe = harness.state().state().window.probe;
    harness.key_press(Key::ArrowLeft);
    harness.run();
    assert!(harness.state().state().window.probe != probe);
}

#[test]
fn a_file_that_cannot_be_opened_says_so_and_changes_nothing() {
    let folder = std::env::temp_dir().join(format!("shading-lab-window-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    let path = folder.join("broken.toml");
    std::fs::write(&path, "version = 1\n[material]\nn = -3\n").expect("a file for the test");
    let mut harness = window("sphere");
    let before = scene(&harness).clone();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::O);
    harness.run();
    harness
        .get_by_role_and_label(Role::TextInput, english!("file"))
        .type_text(&path.display().to_string());
    harness.run();
    harness
        .get_by_role_and_label(Role::Button, english!("open"))
        .click_accesskit();
    let mut shown = false;
    for _ in 0..200 {
        harness.run_ok();
        shown = harness.query_by_label_contains("broken.toml:3").is_some();
        if shown {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    std::fs::remove_dir_all(&folder).expect("the test's own folder");
    assert!(shown, "the dialog names the file and the line");
    assert!(*scene(&harness) == before, "the scene is left alone");
}

#[test]
fn controls_appear_where_they_have_an_effect() {
    let mut harness = window("cone");
    assert!(
        harness
            .query_by_role_and_label(Role::ComboBox, named("object.weighting"))
            .is_none(),
        "exact normals have no weights"
    );
    choose(&mut harness, "object.normals", "averaged");
    let equal = picture(&harness);
    choose(&mut harness, "object.weighting", "angle");
    assert!(picture(&harness) != equal);

    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, named("camera.height"))
            .is_none()
    );
    choose(&mut harness, "camera.projection", "orthographic");
    assert!(
        harness
            .query_by_role_and_label(Role::SpinButton, named("camera.fov_y"))
            .is_none()
    );
    let near = picture(&harness);
    enter(&mut harness, "camera.height", 5.0);
    assert!(picture(&harness) != near);
}

#[test]
fn every_choice_changes_the_picture() {
    let choices: [(&str, &[Key], &str, &str); 15] = [
        ("sphere", &[], "reflection.model", "blinn"),
        ("sphere", &[], "reflection.backfacing", "flip"),
        ("sphere", &[], "light.0.kind", "directional"),
        ("sphere", &[], "light.0.attenuation", "inverse-square"),
        ("sphere", &[], "object.kind", "torus"),
        ("cylinder", &[], "object.normals", "facet"),
        ("cone", &[], "object.normals", "averaged"),
        ("sphere", &[], "camera.projection", "orthographic"),
        ("sphere", &[], "camera.viewer", "infinite"),
        ("sphere", &[], "display.overflow", "mark"),
        ("sphere", &[], "display.overflow", "scale"),
        ("sphere", &[], "display.encoding", "srgb"),
        (
            "attenuation",
            &[Key::Num1],
            "shading.flat_at",
            "provoking-vertex",
        ),
        ("highlight", &[Key::Num3], "shading.interpolation", "affine"),
        ("torus", &[Key::Num3], "shading.interpolation", "scanline"),
    ];
    for (scene, prepare, list, entry) in choices {
        println!("{scene}: {list}: {entry}");
        choice_changes_the_picture(scene, prepare, list, entry);
    }
}

#[test]
fn typed_numbers_change_the_picture() {
    let fields = [
        ("material.color.red", 0.1),
        ("ambient.color.red", 0.0),
        ("light.0.position.x", -3.0),
        ("light.0.color.green", 0.2),
        ("camera.fov_y", 70.0),
        ("camera.eye.x", 3.0),
        ("camera.target.y", 0.4),
        ("image.background.blue", 0.9),
    ];
    for (name, value) in fields {
        changes_the_picture("sphere", &[], name, |harness| enter(harness, name, value));
    }
}

#[test]
fn the_pixels_above_one_are_counted() {
    let mut harness = window("flat-facets");
    enter(&mut harness, "light.0.color.red", 0.5);
    let above = |count: i32| english!("controls-overflowing", count = count, number = "");
    assert!(harness.query_by_label(&above(0)).is_some());
    enter(&mut harness, "light.0.color.red", 3.0);
    assert!(harness.query_by_label_contains(&above(2)).is_some());
}

#[test]
fn panes_are_compared_by_key_and_a_change_reaches_all_but_what_they_have_of_their_own() {
    let mut harness = window("torus");
    open_view(&mut harness, "view-compare");
    harness.key_press(Key::K);
    harness.run();
    assert_eq!(scene(&harness).compare.view, CompareView::Panes);
    assert_eq!(
        scene(&harness).compare.panes,
        [Pane::of(&["shading.mode=exact"])]
    );
    assert!(
        harness
            .query_by_role_and_label(
                Role::Button,
                &format!("2 {}", english!("choice-shading-exact"))
            )
            .is_some()
    );
    let phong = picture(&harness);
    harness.key_press(Key::N);
    harness.run();
    assert_eq!(harness.state().state().session.panes.active, 1);
    assert!(
        picture(&harness) != phong,
        "the active pane is the exact one"
    );
    // The mode belongs to this pane; Kd is shared.
    harness.key_press(Key::Num3);
    harness.run();
    assert_eq!(
        scene(&harness).compare.panes,
        [Pane::of(&["shading.mode=gouraud"])]
    );
    assert_eq!(scene(&harness).shading.mode, ShadingMode::Phong);
    harness
        .get_by_role_and_label(Role::Slider, named("material.kd"))
        .set_value_accesskit(0.25);
    harness.run();
    assert_eq!(scene(&harness).material.kd, Rgb::splat(0.25));
    let mode = named("shading.mode");
    let gouraud = english!("choice-shading-gouraud");
    press(&mut harness, &format!("{mode}: {gouraud}  ×"));
    assert_eq!(scene(&harness).compare.panes, [Pane::default()]);
    press(&mut harness, &english!("picture-pane-menu", number = 2));
    press(&mut harness, "picture-remove-pane");
    assert_eq!(scene(&harness).compare.view, CompareView::Single);
    undo(&mut harness);
    assert_eq!(scene(&harness).compare.panes, [Pane::default()]);
}

#[test]
fn the_line_of_a_wipe_is_dragged_in_one_step() {
    let mut harness = window("flat-facets");
    harness.key_press(Key::K);
    harness.key_press(Key::K);
    harness.run();
    assert_eq!(scene(&harness).compare.view, CompareView::Wipe);
    let picture = picture_place(&harness);
    let from = picture.center_top() + vec2(0.0, 30.0);
    drag(
        &mut harness,
        from,
        from + vec2(-0.25 * picture.width(), 60.0),
    );
    let wipe = scene(&harness).compare.wipe;
    assert!((wipe - 0.25).abs() < 0.01, "{wipe}");
    undo(&mut harness);
    assert_eq!(scene(&harness).compare.wipe, 0.5);
}

#[test]
fn the_probe_jumps_to_the_greatest_difference() {
    let mut harness = window("flat-facets");
    open_view(&mut harness, "view-compare");
    for _ in 0..3 {
        harness.key_press(Key::K);
        harness.run();
    }
    assert_eq!(scene(&harness).compare.view, CompareView::Difference);
    let before = harness.state().state().window.probe;
    let place = english!("picture-greatest", name = "|", x = "|", y = "");
    let (_, place) = place.split_once('|').expect("a name");
    let (place, _) = place.split_once('|').expect("a place");
    let shown = |label: String| label.contains(place);
    harness
        .get_by(|node| node.label().is_some_and(shown))
        .click_accesskit();
    harness.run();
    assert_ne!(harness.state().state().window.probe, before);
}

#[test]
fn depth_cueing_unfolds_and_keeps_its_depths_in_order() {
    let mut harness = window("sphere");
    let plain = picture(&harness);
    let front = |harness: &Harness<'_, App>| {
        harness
            .query_by_role_and_label(Role::SpinButton, named("depth_cueing.front"))
            .is_some()
    };
    assert!(!front(&harness), "it is off");
    choose(&mut harness, "depth_cueing.by", "pixel");
    assert!(front(&harness) && picture(&harness) != plain);
    let symbol = format!("Depth {}", english!("in-equation"));
    assert!(harness.query_all_by_label(&symbol).count() > 0);
    enter(&mut harness, "depth_cueing.front", 6.0);
    let cueing = scene(&harness).depth_cueing;
    assert!(
        cueing.front == 6.0 && cueing.back > 6.0,
        "the back is pushed: {cueing:?}"
    );
    enter(&mut harness, "depth_cueing.back", 4.5);
    let cueing = scene(&harness).depth_cueing;
    assert!(
        cueing.back == 4.5 && cueing.front < 4.5,
        "the front is pushed: {cueing:?}"
    );
    enter(&mut harness, "depth_cueing.back_scale", 0.25);
    enter(&mut harness, "depth_cueing.color.blue", 0.5);
    assert_eq!(scene(&harness).validate(), Ok(()));
    // The probe shows the attenuated value.
    let cueing = english!("point-depth-cueing");
    let cueing = english!("point-line-at-probe", name = cueing, value = "");
    assert!(harness.query_by_label_contains(&cueing).is_some());
    // A list whose entry was chosen without a pointer stays open.
    press(&mut harness, "choice-depth-cueing-vertex");
    press_key_for_every_mode(&mut harness);
    press(&mut harness, "choice-depth-cueing-off");
    assert!(!front(&harness) && picture(&harness) == plain);
}

fn press_key_for_every_mode(harness: &mut Harness<'_, App>) {
    for key in [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5] {
        harness.key_press(key);
        harness.run();
    }
    harness.key_press(Key::Num4);
    harness.run();
}

#[test]
fn pointing_at_a_vertex_lights_up_its_faces() {
    let mut harness = window("vertex-normals");
    // The tab that the scene opens has pictures of its own.
    open_view(&mut harness, "view-equation");
    // The key leads from panes through wipe and difference to one picture.
    for _ in 0..3 {
        harness.key_press(Key::K);
        harness.run();
    }
    assert_eq!(scene(&harness).compare.view, CompareView::Single);
    let lit = |harness: &Harness<'_, App>| harness.state().state().window.pointed.lit;
    let (rect, before) = (picture_place(&harness), picture(&harness));
    let centre = rect.center();
    let at = |harness: &Harness<'_, App>, point: DVec3| {
        let size = [rect.width() as u32, rect.height() as u32];
        let (pixel, _) = View::new(&scene(harness).camera, size)
            .project(point)
            .expect("before the eye");
        rect.min + vec2(pixel.x as f32, pixel.y as f32)
    };
    // The ridge in the middle of the sheet's upper border.
    let field = |harness: &Harness<'_, App>| {
        let object = &scene(harness).object;
        NormalField::of_mesh(
            Arc::new(tessellate(object)),
            object.normals,
            object.weighting,
        )
    };
    let sheet = field(&harness);
    let upper = (0..sheet.vertex_count() as u32)
        .filter_map(|v| sheet.vertex(v))
        .filter(|v| v.position.y > 0.6);
    let middle = upper
        .min_by(|a, b| a.position.x.abs().total_cmp(&b.position.x.abs()))
        .expect("a vertex");
    let place = at(&harness, middle.position);
    harness.hover_at(place);
    harness.run();
    assert_eq!(lit(&harness), None, "nothing while normals are hidden");
    harness.key_press(Key::M);
    harness.run();
    let appearance = &harness.state().state().window.appearance.overlay;
    assert!(appearance.face_normals && appearance.vertex_normals);
    harness.hover_at(place + vec2(5.0, 3.0));
    harness.run();
    assert_eq!(lit(&harness), Some(middle.vertex));
    harness.hover_at(centre + vec2(0.0, 0.12 * rect.height()));
    harness.run();
    assert_eq!(lit(&harness), None, "no vertex is near");
    // A click keeps the selection while the weighting changes, and even when other vertices are made.
    harness.hover_at(place);
    harness.run();
    harness.drag_at(place);
    harness.drop_at(place);
    harness.run();
    harness.hover_at(centre + vec2(0.0, 0.12 * rect.height()));
    harness.run();
    assert_eq!(lit(&harness), Some(middle.vertex), "kept");
    choose(&mut harness, "object.weighting", "area");
    assert_eq!(lit(&harness), Some(middle.vertex));
    choose(&mut harness, "object.normals", "exact");
    let other = lit(&harness)
        .and_then(|vertex| field(&harness).vertex(vertex))
        .expect("still lit");
    assert_eq!(other.position, middle.position);
    harness.key_press(Key::M);
    harness.run();
    assert_eq!(lit(&harness), None, "hidden with the normals");
    undo(&mut harness);
    undo(&mut harness);
    assert!(
        picture(&harness) == before,
        "needles are no part of the picture"
    );
}

/// Returns the appearance of a window that starts with a stored one.
fn look_from(stored: &Appearance) -> Appearance {
    let harness = window_looking(built_in(presets::DEFAULT), [900.0, 600.0], stored, |app| {
        app
    });
    let mut appearance = harness.state().state().window.appearance.clone();
    // Not stored: the profile has followed the picture's mode.
    appearance.profile.own = None;
    appearance
}

#[test]
fn what_was_stored_is_put_right_field_by_field() {
    let usual = Appearance {
        view: ViewName::Profile,
        stages: false,
        ..Appearance::default()
    };
    for scale in [0.0, -3.0, 0.01, 3.0, 1e30, f32::INFINITY, f32::NAN] {
        assert_eq!(
            look_from(&Appearance {
                scale,
                ..usual.clone()
            }),
            usual,
            "{scale}"
        );
    }
    for wrong in [0.0, -1.0, 1e300, f64::INFINITY, f64::NAN] {
        let mut stored = Appearance {
            scale: 1.25,
            ..usual.clone()
        };
        let profile = &mut stored.profile;
        profile.added = vec![ShadingMode::Phong];
        (profile.viewing.distance, profile.viewing.density) = (wrong, wrong);
        let perception = &mut profile.perception;
        (
            perception.centre,
            perception.surround,
            perception.saturation,
        ) = (wrong, wrong, wrong);
        perception.weight = if wrong == 0.0 { f64::NAN } else { wrong };
        assert_eq!(
            look_from(&stored),
            Appearance {
                scale: 1.25,
                ..usual.clone()
            },
            "{wrong}"
        );
    }
    let sound = Appearance {
        scale: 2.5,
        profile: ProfileAppearance {
            edges: false,
            brightness: false,
            ..ProfileAppearance::default()
        },
        ..usual
    };
    assert_eq!(look_from(&sound), sound, "what is within bounds stays");
    let mut compared = sound.clone();
    (compared.profile.perceived, compared.profile.added) = (true, vec![ShadingMode::Exact]);
    assert_eq!(
        look_from(&compared),
        sound,
        "a comparison ends with its session"
    );
}

#[test]
fn what_a_screen_reader_sends_is_kept_within_bounds() {
    let mut harness = window("sphere");
    for role in [Role::Slider, Role::SpinButton] {
        for name in ["material.kd", "material.n", "object.segments"] {
            harness
                .get_by_role_and_label(role, named(name))
                .set_value_accesskit(f64::NAN);
            harness.run();
            assert_eq!(scene(&harness).validate(), Ok(()), "{name}");
            let mut shapes = harness.output().shapes.iter().map(|clipped| &clipped.shape);
            // An empty text has no bounds.
            let drawn = |shape: &&Shape| !matches!(shape, Shape::Text(_));
            let broken =
                shapes.find(|shape| drawn(shape) && shape.visual_bounding_rect().any_nan());
            assert!(broken.is_none(), "{name} draws {broken:?}");
        }
    }
    harness
        .get_by_role_and_label(Role::SpinButton, named("camera.roll"))
        .set_value_accesskit(f64::NEG_INFINITY);
    open_view(&mut harness, "view-defects");
    assert_eq!(scene(&harness).validate(), Ok(()));
}

#[test]
fn all_modes_stand_side_by_side_and_captions_are_dragged_to_other_places() {
    let mut harness = window("cylinder");
    let before = scene(&harness).compare.clone();
    open_view(&mut harness, "view-compare");
    press(&mut harness, "picture-all-modes");
    let modes = |harness: &Harness<'_, App>| {
        let scene = scene(harness);
        (0..scene.pane_count())
            .map(|pane| scene.pane(pane).expect("a sound pane").shading.mode)
            .collect::<Vec<_>>()
    };
    assert_eq!(modes(&harness), ShadingMode::VALUES);
    assert_eq!(scene(&harness).reference_pane(), 4);
    let caption = |harness: &Harness<'_, App>, number: usize, mode: &str| {
        let caption = english!("picture-caption", number = number, name = named(mode));
        harness
            .get_by_role_and_label(Role::Button, &caption)
            .rect()
            .center()
    };
    let (exact, flat) = (
        caption(&harness, 5, "choice-shading-exact"),
        caption(&harness, 1, "choice-shading-flat"),
    );
    drag(&mut harness, exact, flat);
    use ShadingMode::{Exact, Flat, Gouraud, Interpolated, Phong};
    let moved = [Exact, Flat, Interpolated, Gouraud, Phong];
    assert_eq!(modes(&harness), moved);
    assert_eq!(
        scene(&harness).reference_pane(),
        0,
        "the exact pane is still the reference"
    );
    assert_eq!(scene(&harness).validate(), Ok(()));
    harness
        .get_by_role_and_label(
            Role::RadioButton,
            &english!("picture-reference-pane", number = 5),
        )
        .click_accesskit();
    harness.run();
    assert_eq!(scene(&harness).reference_pane(), 4);
    for _ in 0..2 {
        undo(&mut harness);
    }
    assert_eq!(modes(&harness), ShadingMode::VALUES);
    undo(&mut harness);
    assert_eq!(scene(&harness).compare, before);
}
