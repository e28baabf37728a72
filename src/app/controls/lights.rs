//! The list of lights, and the controls of the chosen one.

use super::row::{RowOptions, parameter_with};
use super::sampling::{Finding, Sampling};
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::window::WindowState;
use crate::app::widgets::focus::{named, switch_named};
use crate::app::widgets::sign::{light_sign, signed};
use crate::app::widgets::swatch::display_colour;
use crate::app::widgets::symbol::{self, Symbol};
use crate::scene::light::{
    ATTENUATION, C1, C2, C3, COLOR, CONE, DIRECTION, EXPONENT, EXTENT, K, KIND, NAME, POSITION,
    RADIUS, SAMPLES, SHAPE, SOFTNESS, viewer_far,
};
use crate::scene::{Attenuation, Light, LightKind, Rgb, Scene};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{Align, Button, Layout, RichText, Ui, vec2};
use glam::DVec3;

/// Side of a light's icon, in points.
const SIGN: f32 = 16.0;

/// Shows a line for each light, and the rows of the chosen one.
///
/// Rows that the light's kind and shape do not use are hidden.
pub fn lights_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
) {
    list_ui(ui, session, requests);
    let Session {
        shown,
        initial,
        light,
        ..
    } = session;
    let (index, scene) = (*light, &mut shown.scene);
    let view = RowOptions {
        index,
        ..RowOptions::default()
    };
    if index >= scene.lights.len() {
        ui.weak(text!("lights-none"));
        return;
    }
    parameter_with(ui, initial, scene, &NAME, &view);
    kind_ui(ui, initial, scene, &view);
    for row in [
        &POSITION, &DIRECTION, &CONE, &EXPONENT, &SOFTNESS, &SHAPE, &EXTENT, &RADIUS, &SAMPLES,
    ] {
        if row.idle(scene, index).is_none() {
            parameter_with(ui, initial, scene, row, &view);
        }
    }
    let Light { kind, samples, .. } = scene.lights[index];
    if kind == LightKind::Area {
        let mut sampling: Sampling = window.own.take();
        let text = error_text(sampling.ask(ui.ctx(), shown, index), samples);
        window.own.put(sampling);
        ui.weak(text).on_hover_text(text!("lights-sampling.tip"));
    }
    let scene = &mut shown.scene;
    parameter_with(ui, initial, scene, &COLOR, &view);
    parameter_with(ui, initial, scene, &ATTENUATION, &view);
    let constants: &[_] = match scene.lights[index].attenuation {
        Attenuation::Viewer | Attenuation::Light => &[&K],
        Attenuation::Quadratic => &[&C1, &C2, &C3],
        Attenuation::None | Attenuation::InverseSquare => &[],
    };
    for row in constants {
        parameter_with(ui, initial, scene, row, &view);
    }
    if viewer_far(scene, index) {
        ui.weak(text!("lights-viewer-far"));
    }
}

/// Shows a line for each light, and the buttons that add and duplicate lights.
fn list_ui(ui: &mut Ui, session: &mut Session, requests: &mut Requests) {
    let lit = symbol::is_lit(ui.ctx(), Symbol::Lights);
    let soloing = session.shown.scene.soloing();
    let mut removed = None;
    for (index, light) in session.shown.scene.lights.iter_mut().enumerate() {
        let shines = light.shines(soloing);
        let action = line_ui(ui, index, light, shines, session.light == index, lit);
        match action {
            Some(LineAction::Choose) => session.light = index,
            Some(LineAction::Remove) => removed = Some(index),
            None => {}
        }
    }
    if let Some(index) = removed {
        session.remove_light(index);
    }
    ui.horizontal(|ui| {
        if ui.button(text!("lights-add")).clicked() {
            requests.ask(Action::AddLight(moderate(&session.shown.scene)));
        }
        let chosen = session.shown.scene.lights.get(session.light).cloned();
        let button = Button::new(text!("lights-duplicate"));
        let duplicated = ui.add_enabled(chosen.is_some(), button).clicked();
        if let Some(light) = chosen.filter(|_| duplicated) {
            requests.ask(Action::AddLight(light));
        }
    });
}

/// Returns a new light. The more lights are on, the weaker it is, so that their sum does not overflow.
fn moderate(scene: &Scene) -> Light {
    let soloing = scene.soloing();
    let on = scene.lights.iter().filter(|light| light.shines(soloing));
    let share = 0.8 / (1.0 + on.count() as f64).sqrt();
    Light {
        color: Rgb::splat((share * 20.0).round() / 20.0),
        // While other lights are shown solo, the new one is solo too.
        solo: soloing,
        ..Light::default()
    }
}

/// An action requested in a light's line.
enum LineAction {
    Choose,
    Remove,
}

/// Shows a light's icon, its name, and its switches at the right, and returns the requested action.
fn line_ui(
    ui: &mut Ui,
    index: usize,
    light: &mut Light,
    shines: bool,
    chosen: bool,
    lit: bool,
) -> Option<LineAction> {
    let mut action = None;
    let height = ui.spacing().interact_size.y.max(24.0);
    ui.allocate_ui_with_layout(
        vec2(ui.available_width(), height),
        Layout::right_to_left(Align::Center),
        |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let number = index + 1;
            let remove = ui.add(Button::new("×").min_size(vec2(24.0, 0.0)));
            let name = text!("lights-remove", number = number);
            let remove = named(remove, Role::Button, &name);
            if remove.on_hover_text(name).clicked() {
                action = Some(LineAction::Remove);
            }
            let [solo, mute] = [
                text!("lights-solo.name", number = number),
                text!("lights-mute.name", number = number),
            ];
            let tips = [text!("lights-solo.tip"), text!("lights-mute.tip")];
            switch(ui, [text!("lights-solo"), &solo, tips[0]], &mut light.solo);
            switch(ui, [text!("lights-mute"), &mute, tips[1]], &mut light.mute);
            if name_ui(ui, index, light, shines, chosen, lit) {
                action = Some(LineAction::Choose);
            }
        },
    );
    action
}

/// Shows a Mute or Solo button.
fn switch(ui: &mut Ui, [label, name, tip]: [&str; 3], on: &mut bool) {
    let button = Button::selectable(*on, label).frame_when_inactive(true);
    let response = switch_named(ui.add(button), Role::Button, *on, name);
    *on ^= response.on_hover_text(tip).clicked();
}

/// Shows the light's icon and name over the rest of the line, and returns whether it was clicked.
///
/// The name is struck through while the light is off.
fn name_ui(
    ui: &mut Ui,
    index: usize,
    light: &Light,
    shines: bool,
    chosen: bool,
    lit: bool,
) -> bool {
    let number = text!("lights-number", number = index + 1);
    let own = light.name.trim();
    let label = RichText::new(if own.is_empty() { &number } else { own });
    let label = if shines { label } else { label.strikethrough() };
    let colour = shines.then(|| display_colour(light.color));
    let sign = light_sign(SIGN, light.kind, colour);
    let mut button = signed(chosen, sign, label).min_size(vec2(ui.available_width(), 0.0));
    // The chosen line keeps the selection colour, on which its text is legible.
    if lit && !chosen {
        button = button.fill(ui.visuals().widgets.hovered.bg_fill);
    }
    let response = ui
        .with_layout(Layout::left_to_right(Align::Center), |ui| ui.add(button))
        .inner;
    let name = if own.is_empty() {
        number
    } else {
        text!("lights-named", number = index + 1, name = own)
    };
    let response = switch_named(response, Role::Button, chosen, &name);
    let tip = if shines {
        name
    } else {
        text!("lights-off", name = name)
    };
    response.on_hover_text(tip).clicked()
}

/// Shows the row of the light's kind. A light that has never been aimed is aimed at the camera's target.
fn kind_ui(ui: &mut Ui, initial: &Scene, scene: &mut Scene, view: &RowOptions) {
    let target = scene.camera.target;
    let before = scene
        .lights
        .get(view.index)
        .is_some_and(Light::has_direction);
    parameter_with(ui, initial, scene, &KIND, view);
    let Some(light) = scene.lights.get_mut(view.index) else {
        return;
    };
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

/// Formats the error of the points that approximate an area light.
fn error_text(finding: Finding, samples: u32) -> String {
    match finding {
        Finding::Waiting => "…".to_owned(),
        Finding::Nothing => text!("lights-sampling-none").to_owned(),
        Finding::Error(error) => {
            let (rms, greatest) = (percent(error.rms), percent(error.greatest));
            text!(
                "lights-sampling",
                samples = samples,
                rms = rms,
                greatest = greatest
            )
        }
    }
}

/// Formats a fraction of white as a percentage with two significant digits.
fn percent(part: f64) -> String {
    let percent = part * 100.0;
    if percent < 0.001 {
        return "< 0.001 %".to_owned();
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
            (0.0, "< 0.001 %"),
            (0.000_041, "0.0041 %"),
            (0.004_1, "0.41 %"),
            (0.012, "1.2 %"),
            (0.29, "29 %"),
        ] {
            assert_eq!(percent(part), text);
        }
    }
}
