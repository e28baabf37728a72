//! The camera, and where V points.

use crate::app::action::Action;
use crate::app::palette::vector_text;
use crate::app::row::{About, NumberRow, Rail, choice, number, vector};
use crate::app::state::AppState;
use crate::app::symbol::Symbol;
use crate::figure::palette::Vector;
use crate::scene::{Camera, Projection, Rgb, Viewer};
use eframe::egui::{Button, Ui};

pub fn camera_ui(ui: &mut Ui, state: &mut AppState) {
    viewer_ui(ui, state);
    let default = Camera::default();
    let AppState { document, lit, .. } = state;
    let camera = &mut document.scene.camera;
    let tip = "Perspective, as an eye sees; orthographic, without foreshortening.";
    let about = About { label: "Projection", tip, ..About::default() };
    let choices = [(Projection::Perspective, "perspective", ""), (Projection::Orthographic, "orthographic", "")];
    choice(ui, lit, &about, default.projection, &choices, &mut camera.projection);
    match camera.projection {
        Projection::Perspective => {
            let tip = "The angle that the picture spans from bottom to top; degrees.";
            let about = About { label: "Field of view", tip, ..About::default() };
            let rail = Rail { limits: 0.1..=179.0, decimals: 1, suffix: "°", ..Rail::linear(5.0..=120.0) };
            number(ui, lit, &NumberRow { about, rail, default: default.fov_y }, &mut camera.fov_y);
        }
        Projection::Orthographic => {
            let about = About {
                label: "Height",
                tip: "What the picture spans from bottom to top; world units.",
                ..About::default()
            };
            let rail = Rail { limits: 1e-6..=1e6, ..Rail::logarithmic(0.1..=20.0) };
            number(ui, lit, &NumberRow { about, rail, default: default.height }, &mut camera.height);
        }
    }
    let tip = "Turns what is seen about the picture's middle, counter-clockwise; degrees.";
    let about = About { label: "Roll", tip, ..About::default() };
    let rail = Rail { limits: -1e6..=1e6, decimals: 1, suffix: "°", ..Rail::linear(-180.0..=180.0) };
    number(ui, lit, &NumberRow { about, rail, default: default.roll }, &mut camera.roll);
    let about = About { label: "Eye", tip: "Where the picture is seen from; world units.", ..About::default() };
    vector(ui, lit, &about, default.eye, &mut camera.eye);
    let about = About {
        label: "Target",
        tip: "The point looked at, in the picture's middle; world units.",
        ..About::default()
    };
    vector(ui, lit, &about, default.target, &mut camera.target);
    if ui.add(Button::new("Put the camera back")).on_hover_text("As the scene was opened (key 0)").clicked() {
        state.ask(Action::ResetCamera);
    }
}

fn viewer_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let scene = &mut document.scene;
    let idle = (scene.material.ks == Rgb::ZERO)
        .then_some("Ks is 0: only the specular term asks where the viewer is")
        .or(scene.lights.is_empty().then_some("There is no light"));
    let about = About {
        letter: "V",
        tint: Some(vector_text(ui.visuals(), Vector::V)),
        label: "viewer",
        name: "Viewer",
        tip: "Where V points: to the eye from each point, or the same way everywhere, as if the viewer were infinitely far.",
        symbol: Some(Symbol::Viewer),
        idle,
    };
    let choices = [
        (Viewer::Local, "at the eye", "V points to the eye, from each point"),
        (Viewer::Infinite, "at infinity", "V is constant, from target to eye"),
    ];
    choice(ui, lit, &about, Camera::default().viewer, &choices, &mut scene.camera.viewer);
}
