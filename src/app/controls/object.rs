//! The object, how finely it is made of polygons, and its vertex normals.

mod polygons;

use super::triangles::{counts_ui, triangles_ui};
use crate::app::action::Action;
use crate::app::engine::Engine;
use crate::app::row::{View, parameter, parameter_with};
use crate::app::state::AppState;
use crate::app::symbol::Lit;
use crate::scene::object::{FIT, KIND, NORMALS, RINGS, SEGMENTS, WEIGHTING, polygons_unused};
use crate::scene::{ChoiceOption, NormalSource, ObjectKind, Scene};
use eframe::egui::{Button, RichText, Ui};

pub fn object_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let AppState { shown, lit, .. } = state;
    let before = shown.scene.object.kind;
    parameter(ui, lit, &mut shown.scene, &KIND);
    let object = &mut shown.scene.object;
    let kind = object.kind;
    if kind == ObjectKind::Polygons && before != kind {
        object.own_polygons();
    }
    if kind == ObjectKind::Obj && shown.model.is_none() {
        object.kind = before;
    }
    // Another shape may need more of them.
    (object.segments, object.rings) =
        (object.segments.max(object.min_segments()), object.rings.max(object.min_rings()));
    match kind {
        ObjectKind::Obj => model_ui(ui, state),
        ObjectKind::Polygons => polygons::polygons_ui(ui, state),
        _ => divisions_ui(ui, lit, &mut shown.scene),
    }
    if kind == ObjectKind::Obj && state.shown.model.is_none() {
        state.ask(Action::Open);
    }
    counts_ui(ui, engine.report());
    normals_ui(ui, &mut state.lit, &mut state.shown.scene);
}

/// The model's file.
fn model_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { shown, lit, .. } = state;
    let path = shown.scene.object.path.as_ref();
    let name = path.and_then(|path| path.file_name()).map(|name| name.to_string_lossy().into_owned());
    ui.horizontal(|ui| {
        ui.label(RichText::new(name.as_deref().unwrap_or("no model yet")).weak());
        if ui.add(Button::new("Open model…")).clicked() {
            state.asked.push(Action::Open);
        }
    });
    parameter(ui, lit, &mut shown.scene, &FIT);
}

fn divisions_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    if scene.object.kind != ObjectKind::Corrugated {
        let idle = polygons_unused(scene, 0);
        triangles_ui(ui, lit, idle, &mut scene.object);
    }
    parameter(ui, lit, scene, &SEGMENTS);
    parameter(ui, lit, scene, &RINGS);
}

fn normals_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let offered = |scene: &Scene, option: &ChoiceOption| {
        let object = &scene.object;
        match option.word {
            "exact" => object.kind.has_surface(),
            "file" => {
                object.kind == ObjectKind::Obj
                    || (object.kind == ObjectKind::Polygons && !object.vertex_normals.is_empty())
            }
            _ => true,
        }
    };
    parameter_with(ui, lit, scene, 0, &NORMALS, &View { offered, ..View::default() });
    if scene.object.normals == NormalSource::Averaged {
        parameter(ui, lit, scene, &WEIGHTING);
    }
}
