//! The buttons under the picture: by pixel, edge and line, forwards and back; play; and a slider over all steps.

use super::super::action::{Action, Walk};
use super::super::state::AppState;
use super::ScanView;
use crate::analysis::ScanLevel;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, Layout, Response, RichText, Slider, Ui, WidgetInfo, vec2};

/// Height of a button, points.
const HEIGHT: f32 = 28.0;
/// Width of an arrow's button.
const ARROW: f32 = 28.0;
/// Space between the three groups.
const GROUPS: f32 = 8.0;

pub fn transport_ui(ui: &mut Ui, view: &mut ScanView, state: &mut AppState) {
    let Some(last) = view.ready().map(crate::analysis::Scan::last) else { return };
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        walk_ui(ui, state, "|◀", "First step", "To the beginning (Home)", ARROW, Walk::First);
        let (text, name) = if view.is_playing() { ("■ Pause", "Pause") } else { ("▶ Play", "Play") };
        walk_ui(ui, state, text, name, "Plays step by step, or pauses (Space)", 84.0, Walk::Play);
        walk_ui(ui, state, "▶|", "Last step", "To the end (End)", ARROW, Walk::Last);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.label(RichText::new(format!("step {} of {last}", view.step())).weak());
        });
    });
    let mut step = view.step();
    ui.spacing_mut().slider_width = ui.available_width();
    let slider = ui.add(Slider::new(&mut step, 0..=last).show_value(false));
    let (enabled, value) = (ui.is_enabled(), step);
    slider.widget_info(|| WidgetInfo::slider(enabled, value as f64, "Scan step"));
    if slider.changed() {
        view.go_to(step);
    }
    groups_ui(ui, state);
}

/// ◀ pixel ▶  ◀ edge ▶  ◀ line ▶
fn groups_ui(ui: &mut Ui, state: &mut AppState) {
    let middle = ((ui.available_width() - 2.0 * GROUPS) / 3.0 - 2.0 * ARROW).max(0.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        let levels = [
            (ScanLevel::Pixel, "pixel", "Pixel", ", ."),
            (ScanLevel::Edge, "edge", "Edge", "[ ]"),
            (ScanLevel::Line, "line", "Line", "Page up, Page down"),
        ];
        for (index, (level, word, name, keys)) in levels.into_iter().enumerate() {
            if index > 0 {
                ui.add_space(GROUPS);
            }
            let tip = |way: &str| format!("A {word} {way} ({keys})").replace("A e", "An e");
            walk_ui(ui, state, "◀", &format!("{name} back"), &tip("back"), ARROW, Walk::Back(level));
            ui.allocate_ui_with_layout(vec2(middle, HEIGHT), Layout::top_down(Align::Center), |ui| {
                ui.set_min_size(vec2(middle, HEIGHT));
                ui.add_space(0.5 * (HEIGHT - ui.text_style_height(&eframe::egui::TextStyle::Body)));
                ui.label(word);
            });
            walk_ui(ui, state, "▶", &format!("{name} forward"), &tip("forwards"), ARROW, Walk::Forward(level));
        }
    });
}

fn walk_ui(ui: &mut Ui, state: &mut AppState, text: &str, name: &str, tip: &str, width: f32, walk: Walk) {
    let response: Response = ui.add(Button::new(text).min_size(vec2(width, HEIGHT)));
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    if response.on_hover_text(tip).clicked() {
        state.ask(Action::Scan(walk));
    }
}
