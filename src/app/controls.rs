//! The panel of controls, in the order of the equation: sections of rows, each the row of a parameter or a control of its own.

mod lights;
mod object;

use super::action::Action;
use super::engine::Engine;
use super::focus::named;
use super::material::{gallery_ui, matching_ui};
use super::plan::grouped;
use super::row::{About, View, parameter_with, row};
use super::state::AppState;
use super::symbol::Symbol;
use crate::scene::parameter::{Parameter, Slider};
use crate::scene::{
    AmbientSource, Choice, CuedBy, DepthCueing, GREATEST_LENGTH, PatternKind, Reflectance,
    ReflectionModel, Rgb, Scene, ShadingMode, camera, material, shading, surroundings,
};
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, CollapsingHeader, RichText, ScrollArea, Ui};

/// What a section shows.
enum Item {
    Rows(&'static [&'static Parameter]),
    /// Rows that are shown while they have an effect.
    Used(&'static [&'static Parameter]),
    /// Rows that are shown while this holds.
    While(fn(&Scene) -> bool, &'static [&'static Parameter]),
    Own(fn(&mut Ui, &mut AppState, &Engine)),
}

use Item::{Own, Rows, Used, While};

/// The parts of the panel that fold: the title, the symbols that a part holds which begins folded (it opens when one of them is
/// clicked in the equation), and what it shows.
static SECTIONS: [(&str, &[Symbol], &[Item]); 8] = [
    (
        "Material",
        &[],
        &[
            Own(|ui, state, _| {
                gallery_ui(
                    ui,
                    &mut state.lit,
                    &mut state.gallery,
                    &mut state.shown.scene.material,
                );
            }),
            Rows(&[&material::KA, &material::KD, &material::KS]),
            While(has_facets, &[&material::ROUGHNESS]),
            While(|scene| !has_facets(scene), &[&material::N]),
            Own(|ui, state, _| matching_ui(ui, &mut state.lit, &mut state.shown.scene)),
            Rows(&[
                &material::COLOR,
                &material::SPECULAR_COLOR,
                &material::PATTERN_KIND,
            ]),
            While(
                |scene| scene.pattern.kind != PatternKind::None,
                &[&material::PATTERN_COLOR, &material::PATTERN_SCALE],
            ),
            Rows(&[&material::MODEL]),
            While(has_facets, &[&material::DISTRIBUTION]),
            Rows(&[&material::REFLECTANCE]),
            While(
                |scene| scene.material.reflectance == Reflectance::Custom,
                &[&material::IOR, &material::EXTINCTION],
            ),
            Rows(&[&material::BACKFACING]),
        ],
    ),
    (
        "Transparency",
        &[Symbol::Kt, Symbol::Transmitted],
        &[Rows(&[
            &material::KT,
            &material::TRANSPARENCY_IOR,
            &material::THROUGH,
        ])],
    ),
    (
        "Lights",
        &[],
        &[
            Rows(&[&material::AMBIENT_COLOR]),
            Own(|ui, state, _| lights::lights_ui(ui, state)),
        ],
    ),
    (
        "Surroundings",
        &[Symbol::Shadows, Symbol::Bounce],
        &[
            Rows(&[&shading::SHADOWS, &material::AMBIENT_SOURCE]),
            Own(fit_ui),
            Rows(&[&surroundings::GROUND_VISIBLE]),
            While(
                |scene| scene.ground.visible,
                &[
                    &surroundings::GROUND_HEIGHT,
                    &surroundings::GROUND_KA,
                    &surroundings::GROUND_KD,
                    &surroundings::GROUND_COLOR,
                ],
            ),
            Rows(&[&surroundings::BACKDROP_PATTERN]),
            Used(&[
                &surroundings::BACKDROP_COLOR,
                &surroundings::BACKDROP_SCALE,
                &surroundings::BACKDROP_DISTANCE,
            ]),
        ],
    ),
    (
        "Shading",
        &[],
        &[
            Own(mode_ui),
            Used(&[
                &shading::FLAT_AT,
                &shading::INTERPOLATION,
                &shading::RENORMALISE,
            ]),
        ],
    ),
    ("Object", &[], &[Own(object::object_ui)]),
    (
        "Camera",
        &[],
        &[
            Rows(&[&camera::VIEWER, &camera::PROJECTION]),
            Used(&[&camera::FOV_Y, &camera::HEIGHT]),
            Rows(&[&camera::FRAMING]),
            Rows(&[&camera::ROLL, &camera::EYE, &camera::TARGET]),
            Own(|ui, state, _| {
                if ui
                    .button("Reset camera")
                    .on_hover_text("As the scene was opened (key 0)")
                    .clicked()
                {
                    state.ask(Action::ResetCamera);
                }
            }),
        ],
    ),
    (
        "Display",
        &[],
        &[
            Rows(&[&camera::OVERFLOW]),
            Own(overflow_ui),
            Rows(&[
                &camera::ENCODING,
                &camera::BACKGROUND,
                &surroundings::CUED_BY,
            ]),
            Own(depths_ui),
            Used(&[
                &surroundings::FRONT_SCALE,
                &surroundings::BACK_SCALE,
                &surroundings::CUE_COLOR,
            ]),
        ],
    ),
];

fn has_facets(scene: &Scene) -> bool {
    scene.reflection.model == ReflectionModel::CookTorrance
}

/// The controls of what the equation's symbols stand for.
pub fn controls_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for (title, folded_with, items) in &SECTIONS {
            // A symbol that was clicked may live in a folded section.
            let sought = |symbol: &Symbol| folded_with.is_empty() || folded_with.contains(symbol);
            let open = state.lit.seek.filter(sought).map(|_| true);
            let header = CollapsingHeader::new(RichText::new(*title).strong()).id_salt(title);
            header
                .default_open(folded_with.is_empty())
                .open(open)
                .show_unindented(ui, |ui| {
                    ui.add_space(1.0);
                    items
                        .iter()
                        .for_each(|item| item_ui(ui, state, engine, item));
                    ui.add_space(6.0);
                });
        }
        ui.add_space(12.0);
    });
}

fn item_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine, item: &Item) {
    let AppState {
        shown, lit, look, ..
    } = state;
    let scene = &mut shown.scene;
    let rows = match item {
        Rows(rows) | Used(rows) => *rows,
        While(holds, rows) if holds(scene) => *rows,
        While(..) => &[],
        Own(control) => return control(ui, state, engine),
    };
    let view = View {
        channels: look.channels,
        ..View::default()
    };
    for row in rows {
        if !matches!(item, Used(_)) || (row.idle)(scene, 0).is_none() {
            parameter_with(ui, lit, scene, row, &view);
        }
    }
}

/// What the shading mode does.
fn mode_ui(ui: &mut Ui, state: &mut AppState, _: &Engine) {
    let Scene {
        shading, object, ..
    } = &state.shown.scene;
    let what = if shading.mode == ShadingMode::Exact && !object.kind.has_surface() {
        "There is no surface beyond these polygons: here Phong shading, evaluated in double precision"
    } else {
        shading.mode.help()
    };
    ui.label(RichText::new(what).weak());
}

/// How many pixels the overflow policy is about.
fn overflow_ui(ui: &mut Ui, _: &mut AppState, engine: &Engine) {
    let text = match engine.report().overflowing {
        0 => "No pixel is above 1".to_owned(),
        1 => "1 pixel is above 1".to_owned(),
        many => format!("{} pixels are above 1", grouped(many)),
    };
    ui.label(RichText::new(text).weak());
}

/// The constant that stands best for the bounce that is drawn, and a way to take it.
fn fit_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let ambient = &mut state.shown.scene.ambient;
    if ambient.source == AmbientSource::Constant {
        return;
    }
    let fit = engine.report().ambient_fit;
    let about = About {
        letter: "Ia",
        label: "fits best",
        name: "Best ambient light",
        tip: "The constant Ia whose ambient term differs least from the light that other surfaces really throw here: least squares over the picture. Red, green, blue.",
        symbol: Some(Symbol::Ia),
        idle: fit
            .is_none()
            .then_some("Ka is 0 where light is scattered: no constant makes a difference"),
        ..About::default()
    };
    row(ui, &mut state.lit, &about, false, |ui| {
        let Some(fit) = fit.map(Rgb::from_array) else {
            return;
        };
        let [r, g, b] = fit.to_array().map(|channel| format!("{channel:.3}"));
        let taken = (ambient.color - fit).abs().max_element() < 5e-4;
        let button = named(
            ui.add_enabled(!taken, Button::new("take")),
            Role::Button,
            "Take the best ambient light",
        );
        if button.on_hover_text("Makes it the constant Ia").clicked() {
            ambient.color = (fit * 1e3).round() / 1e3;
        }
        ui.label(RichText::new(format!("{r} {g} {b}")).monospace());
    });
}

/// Where fading begins and ends. The sliders reach as far behind the camera's target as that is from the eye.
fn depths_ui(ui: &mut Ui, state: &mut AppState, _: &Engine) {
    let AppState { shown, lit, .. } = state;
    let scene = &mut shown.scene;
    if scene.depth_cueing.by == CuedBy::Off {
        return;
    }
    if scene.depth_cueing.by == CuedBy::Vertex && scene.shading.mode == ShadingMode::Exact {
        ui.label(RichText::new("Exact shading has no vertices: each pixel's depth").weak());
    }
    let (before, reach) = (scene.depth_cueing.front, 2.0 * scene.camera.distance());
    for row in [&surroundings::FRONT, &surroundings::BACK] {
        let view = View {
            slider: Some(Slider::linear(0.0, reach)),
            ..View::default()
        };
        parameter_with(ui, lit, scene, row, &view);
    }
    let front_moved = scene.depth_cueing.front.to_bits() != before.to_bits();
    part(&mut scene.depth_cueing, front_moved, reach);
}

/// Keeps the front before the back: the one that moved pushes the other.
fn part(cueing: &mut DepthCueing, front_moved: bool, reach: f64) {
    let gap = (0.005 * reach).max(1e-9 * cueing.front.max(cueing.back));
    if cueing.front < cueing.back {
        return;
    }
    if front_moved {
        cueing.front = cueing.front.min(GREATEST_LENGTH - gap);
        cueing.back = cueing.front + gap;
    } else {
        cueing.back = cueing.back.max(gap);
        cueing.front = (cueing.back - gap).max(0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_stays_before_the_back() {
        for (front, back) in [
            (7.0, 5.0),
            (0.0, 0.0),
            (1e30, 3.0),
            (3.0, 0.0),
            (1e-30, 1e-30),
        ] {
            for front_moved in [true, false] {
                for reach in [8.0, 1e-20, 1e20] {
                    let mut scene = Scene::default();
                    (scene.depth_cueing.front, scene.depth_cueing.back) = (front, back);
                    part(&mut scene.depth_cueing, front_moved, reach);
                    assert_eq!(
                        scene.validate(),
                        Ok(()),
                        "{front} {back} {front_moved} {reach}"
                    );
                }
            }
        }
    }
}
