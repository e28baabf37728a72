//! The lights: which there are, and the one chosen.

use crate::app::action::Action;
use crate::app::focus::{named, switch_named};
use crate::app::row::{About, View, parameter_with, swatch, value_row};
use crate::app::sampling::Finding;
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::scene::light::{
    ATTENUATION, C1, C2, C3, COLOR, CONE, DIRECTION, EXPONENT, EXTENT, K, KIND, NAME, POSITION,
    RADIUS, SAMPLES, SHAPE, SOFTNESS, viewer_far,
};
use crate::scene::{Attenuation, Light, LightKind, Scene};
use eframe::egui::accesskit::Role;
use eframe::egui::{Atom, Button, IdSalt, RichText, Sense, Stroke, Ui, vec2};
use glam::DVec3;

/// The longest name that a chip shows, in characters.
const LONGEST: usize = 12;

/// A chip for each light, and the rows of the chosen one; what its kind and its shape do not use is not shown.
pub fn lights_ui(ui: &mut Ui, state: &mut AppState) {
    chips_ui(ui, state);
    let (
        index,
        AppState {
            shown,
            lit,
            sampling,
            ..
        },
    ) = (state.light, state);
    let (scene, view) = (
        &mut shown.scene,
        View {
            index,
            ..View::default()
        },
    );
    if index >= scene.lights.len() {
        ui.label(RichText::new("No light but the ambient. “+” adds one.").weak());
        return;
    }
    parameter_with(ui, lit, scene, &NAME, &view);
    switches_ui(ui, lit, scene, index);
    kind_ui(ui, lit, scene, index);
    for row in [
        &POSITION, &DIRECTION, &CONE, &EXPONENT, &SOFTNESS, &SHAPE, &EXTENT, &RADIUS, &SAMPLES,
    ] {
        if (row.idle)(scene, index).is_none() {
            parameter_with(ui, lit, scene, row, &view);
        }
    }
    let Light { kind, samples, .. } = scene.lights[index];
    if kind == LightKind::Area {
        let text = error_text(sampling.ask(ui.ctx(), shown, index), samples);
        let tip = "The difference to 4096 points, of white, over a small picture without shadows: the root mean square and the greatest of its channels.";
        ui.label(RichText::new(text).weak()).on_hover_text(tip);
    }
    let scene = &mut shown.scene;
    parameter_with(ui, lit, scene, &COLOR, &view);
    parameter_with(ui, lit, scene, &ATTENUATION, &view);
    let constants: &[_] = match scene.lights[index].attenuation {
        Attenuation::Viewer | Attenuation::Light => &[&K],
        Attenuation::Quadratic => &[&C1, &C2, &C3],
        Attenuation::None | Attenuation::InverseSquare => &[],
    };
    for row in constants {
        parameter_with(ui, lit, scene, row, &view);
    }
    if viewer_far(scene, index) {
        ui.label(RichText::new("f uses the distance to the eye, though V is constant").weak());
    }
}

/// One chip a light, and what adds, doubles and removes them.
fn chips_ui(ui: &mut Ui, state: &mut AppState) {
    let lit = state.lit.now == Some(Symbol::Lights);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let soloing = state.shown.scene.soloing();
        for (index, light) in state.shown.scene.lights.iter().enumerate() {
            if chip(
                ui,
                index,
                light,
                light.shines(soloing),
                state.light == index,
                lit,
            ) {
                state.light = index;
            }
        }
        let index = state.light;
        if tool(ui, "+", "Add a light", true) {
            state.ask(Action::AddLight(Light::default()));
        }
        let chosen = state.shown.scene.lights.get(index).cloned();
        let duplicated = tool(ui, "▫▫", "Duplicate this light", chosen.is_some());
        if tool(ui, "−", "Remove this light", chosen.is_some()) {
            state.shown.scene.lights.remove(index);
            state.light = index.min(state.shown.scene.lights.len().saturating_sub(1));
        } else if let Some(light) = chosen.filter(|_| duplicated) {
            state.ask(Action::AddLight(light));
        }
    });
}

/// A light that is silent is struck through and hollow.
fn chip(ui: &mut Ui, index: usize, light: &Light, shines: bool, selected: bool, lit: bool) -> bool {
    let is_shown = !light.name.trim().is_empty() && light.name.chars().count() <= LONGEST;
    let text = RichText::new(if is_shown {
        light.name.clone()
    } else {
        format!("L{}", index + 1)
    });
    let text = if shines { text } else { text.strikethrough() };
    // The colour's place is kept free without letters, which would be struck through as well.
    let mut button = Button::selectable(
        selected,
        (Atom::custom(IdSalt::new("colour"), vec2(12.0, 12.0)), text),
    );
    // The chosen one keeps its colour, on which its letters are read.
    if lit && !selected {
        button = button.fill(ui.visuals().widgets.hovered.bg_fill);
    }
    let response = ui.add(button);
    let centre = response.rect.left_center() + vec2(15.0, 0.0);
    if shines {
        ui.painter()
            .circle(centre, 6.0, swatch(light.color), ui.visuals().window_stroke);
    } else {
        ui.painter().circle_stroke(
            centre,
            5.0,
            Stroke::new(1.5, ui.visuals().weak_text_color()),
        );
    }
    let number = format!("Light {}", index + 1);
    let name = if light.name.is_empty() {
        number.clone()
    } else {
        format!("{number}, {}", light.name)
    };
    let response = switch_named(response, Role::Button, selected, &name);
    let silent = if shines {
        ""
    } else {
        "; it is silent: muted, or another light is soloed"
    };
    response
        .on_hover_text(format!(
            "Show the controls of {}{silent}",
            name.to_lowercase()
        ))
        .clicked()
}

fn tool(ui: &mut Ui, sign: &str, name: &str, enabled: bool) -> bool {
    let response = ui.add_enabled(
        enabled,
        Button::new(sign)
            .min_size(vec2(28.0, 0.0))
            .sense(Sense::click()),
    );
    named(response, Role::Button, name)
        .on_hover_text(name)
        .clicked()
}

/// Mute and solo in one row.
fn switches_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, index: usize) {
    let Some(light) = scene.lights.get_mut(index) else {
        return;
    };
    let name = format!("Light {}", index + 1);
    let tip = "A muted light is off. While any light is soloed, only soloed lights are on.";
    let about = About {
        label: "Switch",
        name: &name,
        tip,
        symbol: Some(Symbol::Lights),
        ..About::default()
    };
    let opened = lit
        .opened
        .lights
        .get(index)
        .map_or([false, false], |light| [light.mute, light.solo]);
    let mut switches = [light.mute, light.solo];
    value_row(ui, lit, &about, opened, &mut switches, |ui, switches| {
        for (label, on) in ["mute", "solo"].into_iter().zip(switches) {
            let button = Button::selectable(*on, label)
                .frame_when_inactive(true)
                .min_size(vec2(58.0, 0.0));
            let response = switch_named(
                ui.add(button),
                Role::Button,
                *on,
                &format!("{name} {label}"),
            );
            *on ^= response.on_hover_text(tip).clicked();
        }
    });
    [light.mute, light.solo] = switches;
}

fn kind_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene, index: usize) {
    let target = scene.camera.target;
    let before = scene.lights.get(index).is_some_and(Light::has_direction);
    parameter_with(
        ui,
        lit,
        scene,
        &KIND,
        &View {
            index,
            ..View::default()
        },
    );
    let Some(light) = scene.lights.get_mut(index) else {
        return;
    };
    // A light that has never been aimed is aimed at what the camera looks at.
    let default = Light::default();
    let unaimed = light.direction == default.direction && light.position != default.position;
    let aim = target - light.position;
    if !before
        && light.has_direction()
        && light.kind.has_position()
        && unaimed
        && aim != DVec3::ZERO
    {
        light.direction = aim;
    }
}

/// The error of the points that stand for an area light.
fn error_text(finding: Finding, samples: u32) -> String {
    match finding {
        Finding::Waiting => "…".to_owned(),
        Finding::Nothing => "no error: this light does not reach the picture".to_owned(),
        Finding::Error(error) => {
            let (rms, greatest) = (percent(error.rms), percent(error.greatest));
            format!("N = {samples}: error {rms} (rms), {greatest} greatest")
        }
    }
}

/// A part of white with two digits that mean something.
fn percent(part: f64) -> String {
    let percent = part * 100.0;
    if percent < 0.001 {
        return "under 0.001 %".to_owned();
    }
    let decimals = (1.0 - percent.log10().floor()).clamp(0.0, 4.0) as usize;
    format!("{percent:.decimals$} %")
}

#[cfg(test)]
mod tests {
    use super::percent;

    #[test]
    fn an_error_has_two_digits() {
        for (part, text) in [
            (0.0, "under 0.001 %"),
            (0.000_041, "0.0041 %"),
            (0.004_1, "0.41 %"),
            (0.012, "1.2 %"),
            (0.29, "29 %"),
        ] {
            assert_eq!(percent(part), text);
        }
    }
}
