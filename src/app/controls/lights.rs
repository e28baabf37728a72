//! Ia, and the lights: which there are, and the one chosen.

mod area;
mod chosen;

use crate::app::action::Action;
use crate::app::row::{parameter, swatch};
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::scene::Light;
use crate::scene::material::AMBIENT_COLOR;
use eframe::egui::accesskit::Role;
use eframe::egui::{Atom, Button, IdSalt, RichText, Sense, Stroke, Ui, WidgetInfo, vec2};

/// The longest name that a chip shows, in characters.
const LONGEST: usize = 12;

pub fn lights_ui(ui: &mut Ui, state: &mut AppState) {
    parameter(ui, &mut state.lit, &mut state.shown.scene, &AMBIENT_COLOR);
    chips_ui(ui, state);
    if state.light < state.shown.scene.lights.len() {
        chosen::light_ui(ui, state);
    } else {
        ui.label(RichText::new("No light but the ambient. “+” adds one.").weak());
    }
}

/// One chip a light, and what adds, doubles and removes them.
fn chips_ui(ui: &mut Ui, state: &mut AppState) {
    let lit = state.lit.now == Some(Symbol::Lights);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let soloing = state.shown.scene.soloing();
        for (index, light) in state.shown.scene.lights.iter().enumerate() {
            if chip(ui, index, light, light.shines(soloing), state.light == index, lit) {
                state.light = index;
            }
        }
        let index = state.light;
        if tool(ui, "+", "Add a light", true) {
            state.ask(Action::AddLight);
        }
        let any = index < state.shown.scene.lights.len();
        if tool(ui, "▫▫", "Duplicate this light", any) {
            state.ask(Action::DuplicateLight(index));
        }
        if tool(ui, "−", "Remove this light", any) {
            state.ask(Action::RemoveLight(index));
        }
    });
}

/// A light that is silent is struck through and hollow.
fn chip(ui: &mut Ui, index: usize, light: &Light, shines: bool, selected: bool, lit: bool) -> bool {
    let text = RichText::new(if shown(light) { light.name.clone() } else { format!("L{}", index + 1) });
    let text = if shines { text } else { text.strikethrough() };
    // The colour's place is kept free without letters, which would be struck through as well.
    let mut button = Button::selectable(selected, (Atom::custom(IdSalt::new("colour"), vec2(12.0, 12.0)), text));
    // The chosen one keeps its colour, on which its letters are read.
    if lit && !selected {
        button = button.fill(ui.visuals().widgets.hovered.bg_fill);
    }
    let response = ui.add(button);
    let centre = response.rect.left_center() + vec2(15.0, 0.0);
    if shines {
        ui.painter().circle(centre, 6.0, swatch(light.color), ui.visuals().window_stroke);
    } else {
        ui.painter().circle_stroke(centre, 5.0, Stroke::new(1.5, ui.visuals().weak_text_color()));
    }
    let number = format!("Light {}", index + 1);
    let name = if light.name.is_empty() { number.clone() } else { format!("{number}, {}", light.name) };
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, selected, &name));
    let silent = if shines { "" } else { "; it is silent: muted, or another light is soloed" };
    response.on_hover_text(format!("Show the controls of {}{silent}", name.to_lowercase())).clicked()
}

/// Whether a chip shows the light's name.
fn shown(light: &Light) -> bool {
    !light.name.trim().is_empty() && light.name.chars().count() <= LONGEST
}

fn tool(ui: &mut Ui, sign: &str, name: &str, enabled: bool) -> bool {
    let response = ui.add_enabled(enabled, Button::new(sign).min_size(vec2(28.0, 0.0)).sense(Sense::click()));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    response.on_hover_text(name).clicked()
}
