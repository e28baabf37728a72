//! The light whose controls are shown.

use super::{area, attenuation, spot};
use crate::app::palette::vector_text;
use crate::app::row::{About, choice, colour, flags, text, vector};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::figure::palette::Vector;
use crate::scene::{Light, LightKind, Projection, Viewer};
use eframe::egui::Ui;
use glam::DVec3;

pub fn light_ui(ui: &mut Ui, state: &mut AppState) {
    let (index, AppState { document, lit, sampling, .. }) = (state.light, state);
    let camera = &document.scene.camera;
    let at_infinity = camera.viewer == Viewer::Infinite || camera.projection == Projection::Orthographic;
    let target = camera.target;
    let name = format!("Light {}", index + 1);
    let Some(light) = document.scene.lights.get_mut(index) else { return };
    name_ui(ui, lit, &name, light);
    shines_ui(ui, lit, &name, light);
    kind_ui(ui, lit, &name, light, target);
    place_ui(ui, lit, &name, light);
    match light.kind {
        LightKind::Spot => spot::spot_ui(ui, lit, &name, light),
        LightKind::Area => {
            area::area_ui(ui, lit, &name, light);
            area::error_ui(ui, sampling, document, index);
        }
        LightKind::Point | LightKind::Directional => {}
    }
    let Some(light) = document.scene.lights.get_mut(index) else { return };
    let tip = "Ip, the light's intensity: red, green and blue, linear; 1 is white, more is allowed. An area light's is that of all its points together.";
    let colour_name = format!("{name} Ip");
    let about =
        About { letter: "Ip", label: "colour", name: &colour_name, tip, symbol: Some(Symbol::Ip), ..About::default() };
    colour(ui, lit, &about, Light::default().color, &mut light.color);
    attenuation::attenuation_ui(ui, lit, &name, light, at_infinity);
}

fn name_ui(ui: &mut Ui, lit: &mut Lit, name: &str, light: &mut Light) {
    let tip = "What you call the light; at most 64 characters. Short names are shown above.";
    let row_name = format!("{name} name");
    let about = About { label: "Name", name: &row_name, tip, symbol: Some(Symbol::Lights), ..About::default() };
    text(ui, lit, &about, Light::MAX_NAME, "no name", &mut light.name);
}

fn shines_ui(ui: &mut Ui, lit: &mut Lit, name: &str, light: &mut Light) {
    let tip = "Muted, the light is off. While any light is soloed, only soloed ones shine.";
    let about = About { label: "Silence", name, tip, symbol: Some(Symbol::Lights), ..About::default() };
    flags(ui, lit, &about, &mut [("mute", &mut light.mute), ("solo", &mut light.solo)]);
}

fn kind_ui(ui: &mut Ui, lit: &mut Lit, name: &str, light: &mut Light, target: DVec3) {
    let (default, before) = (Light::default(), light.has_direction());
    let tip = "What sends the light out. What a kind does not read keeps its value.";
    let row_name = format!("{name} kind");
    let about = About { label: "Kind", name: &row_name, tip, symbol: Some(Symbol::Lights), ..About::default() };
    let kinds = [
        (LightKind::Point, "point", "Shines from a place to all sides"),
        (LightKind::Directional, "directional", "Parallel rays, as of the sun"),
        (LightKind::Spot, "spot", "Shines from a place into a cone"),
        (LightKind::Area, "area", "A rectangle or a sphere, replaced by points spread evenly over it"),
    ];
    choice(ui, lit, &about, default.kind, &kinds, &mut light.kind);
    // A light that has never been aimed is aimed at what the camera looks at.
    let unaimed = light.direction == default.direction && light.position != default.position;
    let aim = target - light.position;
    if !before && light.has_direction() && light.kind.has_position() && unaimed && aim.length() > 0.0 {
        light.direction = aim;
    }
}

fn place_ui(ui: &mut Ui, lit: &mut Lit, name: &str, light: &mut Light) {
    let default = Light::default();
    let tint = Some(vector_text(ui.visuals(), Vector::L));
    let (letter, symbol) = ("L", Some(Symbol::Light));
    if light.kind.has_position() {
        let tip = "Where the light stands: x to the right, y up, z towards the first viewer; world units. Its handle in the picture can be dragged.";
        let name = format!("{name} position");
        let about = About { letter, tint, label: "position", name: &name, tip, symbol, idle: None };
        vector(ui, lit, &about, default.position, &mut light.position);
    }
    if light.has_direction() {
        let (letter, tip) = match light.kind {
            LightKind::Spot => {
                ("D", "The axis of the cone: x, y, z, of any length. The arrow's head in the picture can be dragged.")
            }
            LightKind::Area => (
                "",
                "The side that the rectangle faces: x, y, z, of any length. It turns the rectangle, whose width stays level; its points shine to all sides.",
            ),
            _ => (
                "L",
                "The way the light travels: x, y, z, of any length; L is its opposite. Its handle in the picture can be dragged.",
            ),
        };
        let name = format!("{name} direction");
        let about = About { letter, tint, label: "direction", name: &name, tip, symbol, idle: None };
        vector(ui, lit, &about, default.direction, &mut light.direction);
        if light.direction == DVec3::ZERO {
            light.direction = DVec3::NEG_Y;
        }
    }
}
