//! What a hand does in the window: sliders, letters that are dragged, a command that is looked for.

use crate::common::hands::{
    built_in, drag, folded, named, open_view, picture_place, press, right_click, window,
    window_looking,
};
use crate::layout::texts;
use eframe::egui::accesskit::Role;
use eframe::egui::{Color32, Key, Modifiers, Pos2, Rect, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::analysis::probe::probe;
use shading_lab::app::{App, Appearance, ViewName};
use shading_lab::figure::palette::contrast;
use shading_lab::render::Renderer;
use shading_lab::scene::presets::DEFAULT;

/// Returns the exponent that the window shows.
fn exponent(harness: &Harness<'_, App>) -> f64 {
    harness.state().state().session.shown.scene.material.n
}

#[test]
fn a_point_of_movement_changes_the_exponent_by_at_most_six_percent_at_every_size() {
    for (size, projector) in [
        ([1280.0, 800.0], false),
        ([1024.0, 768.0], false),
        ([1024.0, 768.0], true),
        ([1920.0, 1080.0], false),
        ([1920.0, 1080.0], true),
        ([900.0, 600.0], false),
        ([720.0, 900.0], false),
        ([844.0, 390.0], false),
        ([390.0, 844.0], false),
    ] {
        let mut stored = Appearance::default();
        if projector {
            stored.projector();
        }
        (stored.controls, stored.views) = (true, false);
        let scale = stored.zoom(size[1]);
        let points = size.map(|side| side / scale);
        let mut harness = window_looking(built_in("sphere"), points, &stored, |app| app);
        let name = named("material.n");
        let slider = harness.get_by_role_and_label(Role::Slider, name);
        slider.scroll_to_me();
        harness.run_ok();
        let slider = harness
            .get_by_role_and_label(Role::Slider, named("material.n"))
            .rect();
        assert!(slider.width() >= 120.0, "{size:?} {projector}: {slider:?}");
        let at = |step: u16| pos2(slider.left() + 8.0 + f32::from(step), slider.center().y);
        harness.drag_at(at(0));
        let mut values = Vec::new();
        let end = (slider.width() - 16.0) as u16;
        for step in 0..=end {
            harness.hover_at(at(step));
            harness.run_ok();
            values.push(exponent(&harness));
        }
        harness.drop_at(at(end));
        let steps = values.windows(2).map(|pair| pair[1] / pair[0]);
        let largest = steps.fold(0.0, f64::max);
        assert!(
            largest <= 1.06,
            "{size:?} {projector}: {largest} of {slider:?}: {values:?}"
        );
        let (first, last) = (values[0], values[usize::from(end)]);
        assert!(
            first < 1.3 && last > 800.0,
            "{size:?}: only from {first} to {last}"
        );
    }
}

#[test]
fn a_letter_of_the_equation_is_dragged_as_one_step_of_undo() {
    let mut harness = window("sphere");
    let letter = format!("Exponent {}", english!("in-equation"));
    let from = harness.get_by_label(&letter).rect().center();
    let before = exponent(&harness);
    harness.drag_at(from);
    harness.run_ok();
    for step in 1..=5_u8 {
        harness.hover_at(from + vec2(10.0 * f32::from(step), 0.0));
        harness.run_ok();
    }
    harness.drop_at(from + vec2(50.0, 0.0));
    harness.run_ok();
    let after = exponent(&harness);
    assert!(after > 1.5 * before, "{before} to {after}");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_ok();
    assert_eq!(exponent(&harness), before, "one step of undo");
}

#[test]
fn a_clicked_letter_has_its_slider_right_below_it_unless_the_controls_are_open() {
    for controls in [false, true] {
        let mut stored = Appearance::default();
        stored.projector();
        (stored.controls, stored.views) = (controls, false);
        let points = [1024.0, 768.0].map(|side| side / stored.zoom(768.0));
        let mut harness = window_looking(built_in("sphere"), points, &stored, |app| app);
        let name = named("material.n");
        let sliders = |harness: &Harness<'_, App>| -> Vec<Rect> {
            let all = harness.query_all_by_role_and_label(Role::Slider, name);
            all.map(|node| node.rect()).collect()
        };
        let picture = picture_place(&harness);
        let letter = format!("Exponent {}", english!("in-equation"));
        let letter = harness.get_by_label(&letter);
        let above = letter.rect();
        letter.click();
        harness.run_ok();
        assert_eq!(picture_place(&harness), picture, "nothing gives way");
        let [slider] = sliders(&harness)[..] else {
            panic!("one slider: {:?}", sliders(&harness));
        };
        if controls {
            continue;
        }
        assert!(
            slider.top() >= above.bottom() && slider.top() < above.bottom() + 60.0,
            "{slider:?} below {above:?}"
        );
        assert!(slider.width() >= 120.0, "{slider:?}");
        let before = exponent(&harness);
        let at = |share: f32| pos2(slider.left() + share * slider.width(), slider.center().y);
        drag(&mut harness, at(0.5), at(0.9));
        assert!(exponent(&harness) > 1.5 * before, "{before}");
        assert_eq!(sliders(&harness).len(), 1, "it stays while it is used");
        harness.key_press(Key::Escape);
        harness.run_ok();
        assert!(sliders(&harness).is_empty(), "Escape closes it");
    }
}

#[test]
fn a_setting_is_found_by_a_mistyped_name_and_its_section_opens() {
    let mut harness = window("sphere");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::K);
    harness.run_ok();
    let field = english!("find");
    harness
        .get_by_role_and_label(Role::SearchInput, field)
        .type_text("depth cuing");
    harness.run_ok();
    harness.key_press(Key::ArrowDown);
    harness.run_ok();
    harness.key_press(Key::ArrowDown);
    harness.run_ok();
    harness.key_press(Key::Enter);
    harness.run_ok();
    assert!(
        harness
            .query_by_role_and_label(Role::SearchInput, field)
            .is_none()
    );
    let row = harness.query_by_role_and_label(Role::ComboBox, named("depth_cueing.by"));
    assert!(row.is_some());
}

#[test]
fn everything_is_reset_with_the_probe_where_the_opened_scene_has_it() {
    let mut harness = window("sphere");
    let find = |harness: &mut Harness<'_, App>, sought: &str| {
        harness.key_press_modifiers(Modifiers::COMMAND, Key::K);
        harness.run_ok();
        harness
            .get_by_role_and_label(Role::SearchInput, english!("find"))
            .type_text(sought);
        harness.run_ok();
        harness.key_press(Key::Enter);
        harness.run_ok();
        let state = harness.state().state();
        state.window.probe.0
    };
    let opened = find(&mut harness, "shadows on a floor");
    let title = harness.state().state().session.document().origin.name();
    harness.key_press(Key::ArrowRight);
    harness.run_ok();
    let reset = find(&mut harness, "reset everything");
    assert!(opened.distance(reset) < 0.02, "{title}: {opened} {reset}");
}

#[test]
fn the_gallery_opens_the_scene_whose_name_has_the_word() {
    let mut harness = window("sphere");
    harness.key_press(Key::F2);
    harness.run_ok();
    harness
        .get_by_role_and_label(Role::SearchInput, english!("scenes-search"))
        .type_text("glass");
    harness.run_ok();
    harness.key_press(Key::Enter);
    harness.run_ok();
    let name = harness.state().state().session.document().origin.name();
    assert_eq!(name, "glass-rim");
}

/// Returns the rectangle of a button by the key of its name.
fn button(harness: &Harness<'_, App>, key: &str) -> Rect {
    let button = harness.get_by_role_and_label(Role::Button, named(key));
    button.rect()
}

/// Clicks with the pointer.
fn click(harness: &mut Harness<'_, App>, at: Pos2) {
    harness.hover_at(at);
    harness.run_ok();
    harness.drag_at(at);
    harness.step();
    harness.drop_at(at);
    harness.run_ok();
}

#[test]
fn a_menu_that_pointing_has_opened_stays_open_when_it_is_clicked() {
    let mut harness = window("sphere");
    let is_open = |harness: &Harness<'_, App>, item: &str| {
        harness
            .query_all_by_role(Role::Button)
            .filter_map(|node| node.accesskit_node().label())
            .any(|label| label.starts_with(named(item)))
    };
    let [edit, view] =
        ["edit", "view"].map(|menu| button(&harness, &format!("controls-group-{menu}")).center());
    click(&mut harness, edit);
    assert!(is_open(&harness, "controls-command-reset-all"));
    harness.hover_at(view);
    harness.run_ok();
    assert!(is_open(&harness, "controls-theme"), "by pointing");
    click(&mut harness, view);
    assert!(is_open(&harness, "controls-theme"), "by a click");
    click(&mut harness, view);
    assert!(!is_open(&harness, "controls-theme"));
    click(&mut harness, view);
    assert!(is_open(&harness, "controls-theme"));
}

#[test]
fn the_longest_menu_ends_above_the_bottom_of_the_window() {
    let mut harness = window("sphere");
    let view = button(&harness, "controls-group-view").center();
    click(&mut harness, view);
    let language = button(&harness, "language");
    assert!(language.bottom() <= 800.0 - 8.0, "{language:?}");
}

#[test]
fn a_name_beside_three_values_is_not_cut() {
    let harness = window("one-bounce");
    let shapes = &harness.output().shapes;
    let name = english!("point-bounce");
    let names = texts(shapes);
    let mut names = names
        .iter()
        .filter(|(_, text)| text.galley.job.text == name);
    assert!(names.any(|(_, text)| !text.galley.elided), "{name}");
}

#[test]
fn the_chosen_command_is_readable() {
    let mut harness = window("sphere");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::K);
    harness.run_ok();
    harness
        .get_by_role_and_label(Role::SearchInput, english!("find"))
        .type_text("exponent");
    harness.run_ok();
    let fill = harness.ctx.global_style().visuals.selection.bg_fill;
    let kind = english!("find-setting");
    let shapes = &harness.output().shapes;
    let (_, first) = texts(shapes)
        .into_iter()
        .find(|(_, text)| text.galley.job.text == kind)
        .expect("the kind of the chosen command");
    let own = first.galley.job.sections[0].format.color;
    let colour = if own == Color32::PLACEHOLDER {
        first.fallback_color
    } else {
        own
    };
    let rgb = |colour: Color32| [colour.r(), colour.g(), colour.b()];
    assert!(contrast(rgb(colour), rgb(fill)) >= 4.5, "{colour:?}");
}

/// Returns the smallest distance of the object from the edges of the picture, in pixels.
fn object_margin(harness: &Harness<'_, App>) -> f64 {
    let frame = harness.state().frame();
    let (width, height) = (frame.width as usize, frame.height as usize);
    let background = frame.pixels[0];
    let is_object = |x: usize, y: usize| frame.pixels[y * width + x] != background;
    let (mut low, mut high) = ([width, height], [0, 0]);
    for y in 0..height {
        for x in (0..width).filter(|x| is_object(*x, y)) {
            low = [low[0].min(x), low[1].min(y)];
            high = [high[0].max(x), high[1].max(y)];
        }
    }
    let margins = [low[0], low[1], width - 1 - high[0], height - 1 - high[1]];
    margins.into_iter().min().unwrap_or(0) as f64
}

#[test]
fn at_projector_size_the_object_stays_wholly_visible_beside_any_panel() {
    let mut stored = Appearance::default();
    stored.projector();
    let scale = stored.zoom(768.0);
    let points = [1024.0 / scale, 768.0 / scale];
    for scene in [DEFAULT, "teapot"] {
        let mut harness = window_looking(built_in(scene), points, &stored, |app| app);
        let check = |harness: &Harness<'_, App>, what: &str| {
            let margin = object_margin(harness);
            assert!(margin >= 2.0, "{scene}, {what}: {margin} pixels of margin");
            let picture = picture_place(harness);
            let least = picture.width().min(picture.height());
            assert!(least >= 150.0, "{scene}, {what}: {picture:?}");
            // Nothing else that can be clicked lies over the picture.
            for node in harness.query_all_by_role(Role::Slider) {
                assert!(
                    !picture.shrink(1.0).intersects(node.rect()),
                    "{scene}, {what}"
                );
            }
        };
        check(&harness, "alone");
        press(&mut harness, "view-controls");
        check(&harness, "controls");
        for _ in 0..10 {
            harness.key_press(Key::C);
            harness.run_ok();
            let view = harness.state().state().window.appearance.view;
            check(&harness, &format!("{view:?}"));
        }
    }
}

#[test]
fn the_welcome_makes_way_for_what_is_opened_at_every_size() {
    for points in [
        [1280.0, 800.0],
        [1024.0, 768.0],
        [550.0, 412.0],
        [390.0, 844.0],
    ] {
        let stored = Appearance::default();
        let mut harness = window_looking(built_in(DEFAULT), points, &stored, App::with_welcome);
        harness.run_steps(3);
        assert!(harness.state().state().window.welcome, "{points:?}");
        press(&mut harness, "view-line");
        let window = &harness.state().state().window;
        assert!(window.shows(ViewName::Profile), "{points:?}");
        assert!(!window.welcome && window.appearance.welcomed, "{points:?}");
    }
}

#[test]
fn a_built_in_scene_is_opened_with_the_probe_on_its_object() {
    // Between the three balls is the background.
    for name in ["balls", "sphere", "shadows"] {
        let stored = Appearance::default();
        let mut harness =
            window_looking(built_in(name), [1280.0, 800.0], &stored, App::with_welcome);
        harness.run_steps(3);
        let state = harness.state().state();
        let [x, y] = (state.window.probe).pixel(state.session.shown.scene.image.size);
        let found = probe(&mut Renderer::default(), &state.session.shown.scene, x, y);
        assert!(found.hit.is_some(), "{name} {x},{y}");
    }
}

#[test]
fn a_right_click_offers_what_can_be_done_there() {
    let mut harness = window("sphere");
    let at = picture_place(&harness).center();
    let before = harness.state().state().session.document().scene.clone();
    right_click(&mut harness, at);
    press(&mut harness, "picture-menu-line");
    let state = harness.state().state();
    assert_eq!(state.window.appearance.view, ViewName::Profile);
    assert_eq!(state.session.document().scene, before, "nothing is turned");
    let [from, to] = state.window.line.0;
    assert!(from.y == to.y && to.x - from.x > 0.5, "{from} to {to}");
    // While the menu is open, a click on the right beside it opens it there.
    let middle = picture_place(&harness).center();
    for beside in [vec2(30.0, -30.0), vec2(-30.0, -50.0)] {
        right_click(&mut harness, middle + beside);
    }
    press(&mut harness, "picture-menu-light");
    let lights = &harness.state().state().session.document().scene.lights;
    assert_eq!(lights.len(), before.lights.len() + 1);
    assert_eq!(harness.state().state().session.light, before.lights.len());
}

#[test]
fn a_removed_light_comes_back_from_the_notice() {
    let mut harness = window("three-lights");
    let before = harness.state().state().session.document().scene.clone();
    harness
        .get_by_label(&english!("lights-remove", number = 2))
        .click_accesskit();
    harness.run_ok();
    assert_eq!(
        harness
            .state()
            .state()
            .session
            .document()
            .scene
            .lights
            .len(),
        2
    );
    press(&mut harness, "controls-command-undo");
    assert_eq!(harness.state().state().session.document().scene, before);
    assert_eq!(harness.state().state().session.said(), None);
    // After another change, undo would take back something else.
    harness
        .get_by_label(&english!("lights-remove", number = 2))
        .click_accesskit();
    harness.run_ok();
    harness.key_press(Key::Num1);
    harness.run_ok();
    assert_eq!(harness.state().state().session.said(), None);
}

#[test]
fn a_view_stands_where_its_group_does_and_sections_stay_as_they_were_folded() {
    let mut harness = folded("sphere");
    press(&mut harness, "view-engine");
    press(&mut harness, "view-below");
    let place = |harness: &Harness<'_, App>| picture_place(harness).width();
    let width = place(&harness);
    for view in ["view-study", "view-stability", "view-plan"] {
        open_view(&mut harness, view);
        assert_eq!(place(&harness), width, "{view}");
    }
    let is_open = |harness: &Harness<'_, App>, title: &str| {
        let header = harness.get_by_role_and_label(Role::DisclosureTriangle, named(title));
        header.accesskit_node().data().is_expanded() == Some(true)
    };
    let camera = "controls-camera";
    assert!(!is_open(&harness, camera));
    harness
        .get_by_role_and_label(Role::DisclosureTriangle, named(camera))
        .click_accesskit();
    harness.run_ok();
    press(&mut harness, "scenes-next");
    assert!(is_open(&harness, camera), "it was opened by hand");
}
