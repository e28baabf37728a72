//! Ia, and the lights: which there are, and the one chosen.

use crate::app::action::Action;
use crate::app::palette::vector_text;
use crate::app::row::{About, NumberRow, Rail, choice, colour, number, swatch, vector};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::figure::palette::Vector;
use crate::scene::{Ambient, Attenuation, Light, LightKind, Projection, Rgb, Viewer};
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, RichText, Sense, Ui, WidgetInfo, vec2};

pub fn lights_ui(ui: &mut Ui, state: &mut AppState) {
    let scene = &mut state.document.scene;
    let about = About {
        letter: "Ia",
        label: "ambient",
        name: "Ia ambient light",
        tip: "Ia, the light that comes from everywhere alike: red, green and blue, linear, 1 is white.",
        symbol: Some(Symbol::Ia),
        idle: (scene.material.ka == Rgb::ZERO).then_some("Ka is 0: the surface returns no ambient light"),
        ..About::default()
    };
    colour(ui, &mut state.lit, &about, Ambient::default().color, &mut scene.ambient.color);
    chips_ui(ui, state);
    let index = state.light;
    let AppState { document, lit, .. } = state;
    let at_infinity = document.scene.camera.viewer == Viewer::Infinite
        || document.scene.camera.projection == Projection::Orthographic;
    match document.scene.lights.get_mut(index) {
        Some(light) => light_ui(ui, lit, index, light, at_infinity),
        None => {
            ui.label(RichText::new("No light but the ambient. “+” adds one.").weak());
        }
    }
}

/// One chip a light, and what adds, doubles and removes them.
fn chips_ui(ui: &mut Ui, state: &mut AppState) {
    let lit = state.lit.now == Some(Symbol::Lights);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (index, colour) in state.document.scene.lights.iter().map(|light| light.color).enumerate() {
            if chip(ui, index, colour, state.light == index, lit) {
                state.light = index;
            }
        }
        let index = state.light;
        if tool(ui, "+", "Add a light", true) {
            state.ask(Action::AddLight);
        }
        let any = index < state.document.scene.lights.len();
        if tool(ui, "▫▫", "Duplicate this light", any) {
            state.ask(Action::DuplicateLight(index));
        }
        if tool(ui, "−", "Remove this light", any) {
            state.ask(Action::RemoveLight(index));
        }
    });
}

fn chip(ui: &mut Ui, index: usize, colour: Rgb, selected: bool, lit: bool) -> bool {
    let name = format!("Light {}", index + 1);
    let text = format!("     L{}", index + 1);
    let mut button = Button::selectable(selected, text);
    if lit {
        button = button.fill(ui.visuals().widgets.hovered.bg_fill);
    }
    let response = ui.add(button);
    let centre = response.rect.left_center() + vec2(15.0, 0.0);
    ui.painter().circle(centre, 6.0, swatch(colour), ui.visuals().window_stroke);
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, selected, &name));
    response.on_hover_text(format!("Show the controls of light {}", index + 1)).clicked()
}

fn tool(ui: &mut Ui, sign: &str, name: &str, enabled: bool) -> bool {
    let response = ui.add_enabled(enabled, Button::new(sign).min_size(vec2(28.0, 0.0)).sense(Sense::click()));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    response.on_hover_text(name).clicked()
}

fn light_ui(ui: &mut Ui, lit: &mut Lit, index: usize, light: &mut Light, viewer_at_infinity: bool) {
    let (name, default) = (format!("Light {}", index + 1), Light::default());
    let orange = Some(vector_text(ui.visuals(), Vector::L));
    let about =
        About { label: "Kind", name: &format!("{name} kind"), symbol: Some(Symbol::Lights), ..About::default() };
    let kinds = [
        (LightKind::Point, "point", "Shines from a place to all sides"),
        (LightKind::Directional, "directional", "Parallel rays, as of the sun"),
    ];
    choice(ui, lit, &about, default.kind, &kinds, &mut light.kind);
    let (letter, symbol) = ("L", Some(Symbol::Light));
    match light.kind {
        LightKind::Point | LightKind::Spot | LightKind::Area => {
            let tip = "Where the light stands: x to the right, y up, z towards the first viewer; world units. Its handle in the picture can be dragged.";
            let name = format!("{name} position");
            let about = About { letter, tint: orange, label: "position", name: &name, tip, symbol, idle: None };
            vector(ui, lit, &about, default.position, &mut light.position);
        }
        LightKind::Directional => {
            let tip = "The way the light travels: x, y, z, of any length; L is its opposite. Its handle in the picture can be dragged.";
            let name = format!("{name} direction");
            let about = About { letter, tint: orange, label: "direction", name: &name, tip, symbol, idle: None };
            vector(ui, lit, &about, default.direction, &mut light.direction);
            if light.direction == glam::DVec3::ZERO {
                light.direction = glam::DVec3::NEG_Y;
            }
        }
    }
    let tip = "Ip, the light's intensity: red, green and blue, linear; 1 is white, more is allowed.";
    let colour_name = format!("{name} Ip");
    let about =
        About { letter: "Ip", label: "colour", name: &colour_name, tip, symbol: Some(Symbol::Ip), ..About::default() };
    colour(ui, lit, &about, default.color, &mut light.color);
    attenuation_ui(ui, lit, &name, light, viewer_at_infinity);
}

fn attenuation_ui(ui: &mut Ui, lit: &mut Lit, name: &str, light: &mut Light, viewer_at_infinity: bool) {
    let default = Light::default();
    let tip = "f, how the light weakens. d is the distance to the light; a directional light has none.";
    let symbol = Some(Symbol::Attenuation);
    let row_name = format!("{name} attenuation");
    let idle = match (light.kind, light.attenuation) {
        (LightKind::Directional, Attenuation::Light | Attenuation::InverseSquare | Attenuation::Quadratic) => {
            Some("A directional light is infinitely far away; its distance weakens nothing")
        }
        _ => None,
    };
    let about = About { letter: "f", label: "weakens", name: &row_name, tip, symbol, idle: None, tint: None };
    let choices = [
        (Attenuation::None, "not at all", "f = 1"),
        (Attenuation::Viewer, "1/(r+k), r to the viewer", "The older textbooks' way"),
        (Attenuation::Light, "1/(r+k), r to the light", ""),
        (Attenuation::InverseSquare, "1/d²", "As light in empty space does"),
        (Attenuation::Quadratic, "1/(c1+c2·d+c3·d²)", "At most 1"),
    ];
    choice(ui, lit, &about, default.attenuation, &choices, &mut light.attenuation);
    let viewer_far = light.attenuation == Attenuation::Viewer && viewer_at_infinity;
    let idle = idle.or(viewer_far.then_some("f keeps to the distance of the eye, though V is taken as constant"));
    let constants: &mut [(&str, &str, &mut f64, f64)] = match light.attenuation {
        Attenuation::None | Attenuation::InverseSquare => &mut [],
        Attenuation::Viewer | Attenuation::Light => {
            &mut [("k", "the constant that keeps 1/(r + k) finite; world units", &mut light.k, default.k)]
        }
        Attenuation::Quadratic => &mut [
            ("c1", "the constant part; no unit", &mut light.c1, default.c1),
            ("c2", "the linear part; per world unit", &mut light.c2, default.c2),
            ("c3", "the quadratic part; per world unit squared", &mut light.c3, default.c3),
        ],
    };
    for (letter, tip, value, default) in constants {
        let row_name = format!("{name} {letter}");
        let idle = idle.filter(|_| !viewer_far);
        let about = About { letter, label: "constant", name: &row_name, tip, symbol, idle, tint: None };
        number(ui, lit, &NumberRow { about, rail: Rail::linear(0.0..=2.0), default: *default }, value);
    }
}
