//! What a hand does in the window: sliders, letters that are dragged, a command that is looked for.

use crate::common::hands::{built_in, named, window, window_looking};
use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use shading_lab::app::{App, Appearance};

/// Returns the exponent that the window shows.
fn exponent(harness: &Harness<'_, App>) -> f64 {
    harness.state().state().session.shown.scene.material.n
}

#[test]
fn a_point_of_movement_changes_the_exponent_by_at_most_six_percent_at_every_size() {
    for size in [
        [1280.0, 800.0],
        [1024.0, 768.0],
        [1920.0, 1080.0],
        [900.0, 600.0],
    ] {
        let stored = Appearance::default();
        let mut harness = window_looking(built_in("sphere"), size, &stored, |app| app);
        harness.run_ok();
        let slider = harness
            .get_by_role_and_label(Role::Slider, named("material.n"))
            .rect();
        assert!(slider.width() >= 120.0, "{size:?}: {slider:?}");
        let at = |step: u8| pos2(slider.left() + 8.0 + f32::from(step), slider.center().y);
        harness.drag_at(at(0));
        let mut values = Vec::new();
        for step in 0..=110 {
            harness.hover_at(at(step));
            harness.run_ok();
            values.push(exponent(&harness));
        }
        harness.drop_at(at(110));
        let steps = values.windows(2).map(|pair| pair[1] / pair[0]);
        let largest = steps.fold(0.0, f64::max);
        assert!(largest <= 1.06, "{size:?}: {largest}");
        let (first, last) = (values[0], values[110]);
        assert!(last > 50.0 * first, "{size:?}: only from {first} to {last}");
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
