//! The editor of a scene's own law: what is typed is drawn at once, and an error keeps the picture.

use crate::common::hands::{
    choose, folded, named, open_view, picture, press, scene, settle, undo, unfold, window,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, Rect, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use shading_lab::app::App;
use shading_lab::scene::{CompareView, ObjectKind, Pane, Reflection, ReflectionModel};

const LAMBERT: &str = "kd * od * max(N·L, 0)";
const WRONG: &str = "kd * od * max(N·K, 0)";
/// What is wrong with [`WRONG`], and where.
const PLACE: &str = "line 1, column 1";

fn with_law() -> Harness<'static, App> {
    let mut harness = window("sphere");
    choose(&mut harness, "reflection.model", "formula");
    harness
}

fn typed(harness: &Harness<'_, App>) -> String {
    let field = harness.get_by_role_and_label(Role::MultilineTextInput, field());
    field.value().unwrap_or_default()
}

fn field() -> &'static str {
    named("reflection.formula")
}

fn take_field(harness: &mut Harness<'_, App>) {
    harness
        .get_by_role_and_label(Role::MultilineTextInput, field())
        .focus();
    settle(harness);
}

fn type_text(harness: &mut Harness<'_, App>, text: &str) {
    harness.event(Event::Text(text.to_owned()));
    settle(harness);
}

/// Types another formula in place of the present one.
fn retype(harness: &mut Harness<'_, App>, text: &str) {
    take_field(harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    type_text(harness, text);
}

fn leave_field(harness: &mut Harness<'_, App>) {
    harness.key_press(Key::Escape);
    settle(harness);
}

fn formula<'h>(harness: &'h Harness<'_, App>) -> &'h str {
    &scene(harness).reflection.formula
}

fn shows(harness: &Harness<'_, App>, words: &str) -> bool {
    harness.query_by_label_contains(words).is_some()
}

fn put(harness: &mut Harness<'_, App>, key: &str) {
    press(harness, &english!("course-formula-put", key = key));
}

/// Opens the scene of a link, in place of the present one.
fn open(harness: &mut Harness<'_, App>, settings: &str) {
    let link = format!("https://example.org/shading-lab/?scene=torus&{settings}");
    harness.event(Event::Paste(link));
    settle(harness);
    assert_eq!(scene(harness).object.kind, ObjectKind::Torus);
}

#[test]
fn the_model_begins_with_phongs_law_as_a_text() {
    let mut harness = window("sphere");
    let before = picture(&harness);
    let editor =
        |harness: &Harness<'_, App>| harness.query_by_role(Role::MultilineTextInput).is_some();
    assert!(!editor(&harness) && shows(&harness, named("parameter-reflection-formula.label")));
    choose(&mut harness, "reflection.model", "formula");
    assert_eq!(typed(&harness), Reflection::PHONG);
    let own = picture(&harness);
    let apart = |(a, b): (&[u8; 4], &[u8; 4])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 1);
    assert!(!before.iter().zip(&own).any(apart), "Phong's picture");
}

#[test]
fn an_error_keeps_the_picture_and_is_told_with_its_place() {
    let mut harness = with_law();
    retype(&mut harness, LAMBERT);
    let matt = picture(&harness);
    retype(&mut harness, WRONG);
    assert!(picture(&harness) == matt && formula(&harness) == LAMBERT);
    assert_eq!(typed(&harness), WRONG);
    let kept = english!("controls-law-kept");
    assert!(shows(&harness, PLACE) && shows(&harness, "did you mean") && shows(&harness, kept));
    // Letter by letter the text becomes right again.
    harness.key_press(Key::End);
    for _ in "K, 0)".chars() {
        harness.key_press(Key::Backspace);
    }
    settle(&mut harness);
    assert!(picture(&harness) == matt && formula(&harness) == LAMBERT);
    type_text(&mut harness, "H, 0)");
    assert_eq!(formula(&harness), LAMBERT.replace("N·L", "N·H"));
    assert!(picture(&harness) != matt && !shows(&harness, kept));
    // Nothing typed is no formula either.
    let half = picture(&harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.key_press(Key::Delete);
    settle(&mut harness);
    assert!(typed(&harness).is_empty() && shows(&harness, kept));
    assert!(picture(&harness) == half);
}

#[test]
fn enter_begins_a_line_and_pasted_lines_are_kept() {
    let mut harness = with_law();
    retype(&mut harness, "spot = max(R·V, 0)");
    assert_eq!(formula(&harness), Reflection::PHONG, "no value yet");
    harness.key_press(Key::Enter);
    settle(&mut harness);
    type_text(&mut harness, "ks * spot^4");
    assert_eq!(formula(&harness), "spot = max(R·V, 0)\nks * spot^4");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    harness.event(Event::Paste("a = N·L\r\nkd * a".to_owned()));
    settle(&mut harness);
    assert_eq!(formula(&harness), "a = N·L\nkd * a");
}

#[test]
fn undo_brings_text_and_picture_back() {
    let mut harness = with_law();
    let phong = picture(&harness);
    retype(&mut harness, LAMBERT);
    let matt = picture(&harness);
    assert!(matt != phong);
    // In the field, and back.
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(typed(&harness), Reflection::PHONG);
    assert!(picture(&harness) == phong);
    retype(&mut harness, LAMBERT);
    retype(&mut harness, WRONG);
    leave_field(&mut harness);
    undo(&mut harness);
    assert_eq!(typed(&harness), formula(&harness), "the draft is gone");
    while formula(&harness) != Reflection::PHONG {
        undo(&mut harness);
    }
    assert_eq!(typed(&harness), Reflection::PHONG);
    assert!(picture(&harness) == phong);
    // What was typed before does not come back by way of the field.
    take_field(&mut harness);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    settle(&mut harness);
    assert_eq!(
        [&*typed(&harness), formula(&harness)],
        [Reflection::PHONG; 2]
    );
}

#[test]
fn another_scene_replaces_the_draft_even_one_of_the_same_law() {
    for (settings, expected) in [
        ("set=reflection.model=formula", Reflection::PHONG),
        (
            "set=reflection.model=formula&set=reflection.formula=kd*od*N%C2%B7L",
            "kd*od*N·L",
        ),
    ] {
        let mut harness = with_law();
        take_field(&mut harness);
        type_text(&mut harness, " + (");
        assert_ne!(typed(&harness), Reflection::PHONG);
        leave_field(&mut harness);
        open(&mut harness, settings);
        assert_eq!([&*typed(&harness), formula(&harness)], [expected; 2]);
        take_field(&mut harness);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        settle(&mut harness);
        assert_eq!([&*typed(&harness), formula(&harness)], [expected; 2]);
        harness.key_press_modifiers(Modifiers::COMMAND, Key::End);
        type_text(&mut harness, "*2");
        assert_eq!(formula(&harness), format!("{expected}*2"));
    }
}

#[test]
fn a_draft_ends_with_its_model_and_by_reset() {
    let mut harness = with_law();
    retype(&mut harness, WRONG);
    leave_field(&mut harness);
    choose(&mut harness, "reflection.model", "blinn");
    // Closes the list.
    leave_field(&mut harness);
    choose(&mut harness, "reflection.model", "formula");
    assert_eq!(typed(&harness), Reflection::PHONG);
    let reset = english!("controls-reset", name = field());
    let offered = |harness: &Harness<'_, App>| {
        harness
            .query_by_role_and_label(Role::Button, &reset)
            .is_some()
    };
    assert!(!offered(&harness));
    // A draft can be reset although the scene's formula is as opened.
    retype(&mut harness, WRONG);
    assert!(offered(&harness));
    press(&mut harness, &reset);
    assert_eq!(typed(&harness), Reflection::PHONG);
    retype(&mut harness, LAMBERT);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::R);
    settle(&mut harness);
    assert_eq!(
        [&*typed(&harness), formula(&harness)],
        [Reflection::PHONG; 2]
    );
}

#[test]
fn each_pane_has_its_own_draft() {
    let mut harness = with_law();
    open_view(&mut harness, "view-compare");
    harness.key_press(Key::K);
    settle(&mut harness);
    harness
        .get_by_role_and_label(Role::CheckBox, english!("picture-own-changes"))
        .click_accesskit();
    settle(&mut harness);
    let next_pane = |harness: &mut Harness<'_, App>| {
        harness.key_press(Key::N);
        settle(harness);
    };
    retype(&mut harness, WRONG);
    leave_field(&mut harness);
    // The second pane has the same formula, but not the draft of the first.
    next_pane(&mut harness);
    assert_eq!(typed(&harness), Reflection::PHONG);
    retype(&mut harness, LAMBERT);
    leave_field(&mut harness);
    let panes = &scene(&harness).compare.panes;
    assert_eq!(
        panes[0].value("reflection.formula"),
        Some(&*format!("\"{LAMBERT}\""))
    );
    assert_eq!(formula(&harness), Reflection::PHONG);
    assert!(scene(&harness).pane_name(1).contains(LAMBERT));
    next_pane(&mut harness);
    assert_eq!(typed(&harness), Reflection::PHONG);
    next_pane(&mut harness);
    assert_eq!(typed(&harness), LAMBERT);
}

#[test]
fn names_are_put_where_the_cursor_is_and_the_field_keeps_the_focus() {
    let mut harness = with_law();
    retype(&mut harness, "kd * ");
    put(&mut harness, "N·L");
    assert_eq!(formula(&harness), "kd * N·L");
    type_text(&mut harness, " * ");
    put(&mut harness, "od");
    assert_eq!(formula(&harness), "kd * N·L * od");
    harness.key_press(Key::Home);
    settle(&mut harness);
    put(&mut harness, "ks");
    type_text(&mut harness, "*");
    assert_eq!(formula(&harness), "ks*kd * N·L * od");
    let sign = english!("course-formula-put", key = "^");
    assert!(
        harness.query_by_label(&sign).is_none(),
        "a keyboard has signs"
    );
}

#[test]
fn letters_and_signs_are_beside_the_field_of_a_phone() {
    let mut harness = folded("sphere");
    harness.set_size(vec2(390.0, 844.0));
    settle(&mut harness);
    let model = named("reflection.model");
    if harness
        .query_by_role_and_label(Role::ComboBox, model)
        .is_none()
    {
        press(&mut harness, "view-controls");
    }
    unfold(&mut harness, "controls-material");
    choose(&mut harness, "reflection.model", "formula");
    harness
        .get_by_role_and_label(Role::MultilineTextInput, field())
        .scroll_to_me();
    settle(&mut harness);
    take_field(&mut harness);
    let rail = harness.get_by_role_and_label(Role::Button, named("view-controls"));
    let seen = Rect::from_min_max(pos2(0.0, 300.0), pos2(390.0, rail.rect().min.y));
    let input = harness.get_by_role_and_label(Role::MultilineTextInput, field());
    assert!(seen.contains_rect(input.rect()), "{:?}", input.rect());
    for key in ["N", "L", "·", "^", "(", ")"] {
        let name = english!("course-formula-put", key = key);
        let rect = harness.get_by_role_and_label(Role::Button, &name).rect();
        assert!(seen.contains_rect(rect), "{key}: {rect} in {seen}");
        assert!(rect.min.y - input.rect().max.y < 60.0, "{key}: {rect}");
    }
    retype(&mut harness, "kd * ");
    put(&mut harness, "N");
    put(&mut harness, "·");
    put(&mut harness, "L");
    assert_eq!(formula(&harness), "kd * N·L");
}

#[test]
fn what_the_formula_does_not_use_has_no_effect() {
    let mut harness = with_law();
    let is_idle = |harness: &Harness<'_, App>, role, key: &str| {
        let row = harness.get_by_role_and_label(role, named(key));
        row.accesskit_node().is_disabled()
    };
    let sliders = |harness: &Harness<'_, App>| {
        ["material.kd", "material.ks", "material.n"].map(|key| is_idle(harness, Role::Slider, key))
    };
    assert_eq!(sliders(&harness), [false; 3]);
    for key in ["material.reflectance", "reflection.backfacing"] {
        assert!(is_idle(&harness, Role::ComboBox, key), "{key}");
    }
    retype(&mut harness, LAMBERT);
    assert_eq!(sliders(&harness), [false, true, true]);
    // The numbers of other models have rows where the formula has them.
    let has = |harness: &Harness<'_, App>, role, key: &str| {
        harness.query_by_role_and_label(role, named(key)).is_some()
    };
    let ior = "material.ior.red";
    assert!(!has(&harness, Role::Slider, "material.roughness"));
    assert!(!has(&harness, Role::SpinButton, ior));
    retype(&mut harness, "kd * m / eta");
    assert!(!is_idle(&harness, Role::Slider, "material.roughness"));
    assert!(!is_idle(&harness, Role::SpinButton, ior));
    // The model can be chosen although there is no highlight.
    leave_field(&mut harness);
    choose(&mut harness, "reflection.model", "phong");
    harness
        .get_by_role_and_label(Role::Slider, named("material.ks"))
        .set_value_accesskit(0.0);
    settle(&mut harness);
    assert!(!is_idle(&harness, Role::ComboBox, "reflection.model"));
}

#[test]
fn a_law_stands_beside_phongs_with_their_difference() {
    let mut harness = with_law();
    retype(&mut harness, LAMBERT);
    leave_field(&mut harness);
    press(&mut harness, "controls-law-beside");
    let compare = &scene(&harness).compare;
    assert_eq!(compare.view, CompareView::Difference);
    assert_eq!(compare.panes, [Pane::of(&["reflection.model=phong"])]);
    let names = [0, 1].map(|pane| scene(&harness).pane_name(pane));
    let labels = ["formula", "phong"].map(|model| {
        let model = format!("choice-reflection-model-{model}");
        named(&model).to_owned()
    });
    assert_eq!(names, labels);
    let panes = &harness.state().state().session.panes;
    assert_eq!(panes.scene(0).reflection.formula, LAMBERT);
    assert_eq!(panes.scene(1).reflection.model, ReflectionModel::Phong);
    // A second time nothing is added.
    press(&mut harness, "controls-law-beside");
    assert_eq!(scene(&harness).compare.panes.len(), 1);
    undo(&mut harness);
    assert!(scene(&harness).compare.panes.is_empty());
    assert_eq!(scene(&harness).reflection.model, ReflectionModel::Formula);
}

#[test]
fn the_formula_is_found_by_its_name() {
    let mut harness = folded("teapot");
    harness.key_press_modifiers(Modifiers::COMMAND, Key::K);
    harness.run_ok();
    harness
        .get_by_role_and_label(Role::SearchInput, english!("find"))
        .type_text("own formula");
    harness.run_ok();
    harness.key_press(Key::Enter);
    settle(&mut harness);
    let label = named("parameter-reflection-formula.label");
    let row = harness.get_by_label(label);
    assert!(harness.ctx.content_rect().contains_rect(row.rect()));
    row.hover();
    settle(&mut harness);
    assert!(shows(&harness, english!("idle-no-formula")));
}
