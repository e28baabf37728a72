//! The controls of the object: its shape, its tessellation or its own polygons, and its vertex normals.

use super::row::{
    About, NumberRow, RowOptions, SliderRange, axes, number, parameter, parameter_with, value_row,
    whole,
};
use super::vertices::{MOST_HANDLES, move_vertex};
use crate::analysis::report::grouped;
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::widgets::symbol::Symbol;
use crate::geometry::{divisions_for, triangles};
use crate::scene::object::{FIT, KIND, NORMALS, RINGS, SEGMENTS, WEIGHTING};
use crate::scene::{ChoiceOption, NormalSource, Object, ObjectKind, Scene};
use crate::text;
use eframe::egui::Ui;

/// Maximum number of triangles on the slider, and the maximum that can be typed, which takes more than a gigabyte.
const SLIDER: f64 = 1e6;
const MOST: f64 = 4e6;

/// Shows the rows of the object.
pub fn object_ui(ui: &mut Ui, session: &mut Session, requests: &mut Requests, engine: &Engine) {
    let Session {
        shown,
        initial,
        vertex,
        ..
    } = session;
    let report = engine.report();
    let before = shown.scene.object.kind;
    parameter(ui, initial, &mut shown.scene, &KIND);
    let object = &mut shown.scene.object;
    let kind = object.kind;
    if kind == ObjectKind::Polygons && before != kind {
        object.own_polygons();
    }
    if kind == ObjectKind::Obj && shown.model.is_none() {
        object.kind = before;
        requests.ask(Action::Open);
    }
    // Another shape may need more segments or rings.
    (object.segments, object.rings) = (
        object.segments.max(object.min_segments()),
        object.rings.max(object.min_rings()),
    );
    match kind {
        ObjectKind::Obj => {
            let path = object.path.as_ref().and_then(|path| path.file_name());
            let name = path.map_or(text!("lights-model-none").into(), |name| {
                name.to_string_lossy()
            });
            ui.horizontal(|ui| {
                ui.weak(name);
                if ui.button(text!("lights-model-open")).clicked() {
                    requests.ask(Action::Open);
                }
            });
            parameter(ui, initial, &mut shown.scene, &FIT);
        }
        ObjectKind::Balls => {}
        ObjectKind::Polygons => polygons_ui(ui, vertex, object),
        _ => {
            if kind != ObjectKind::Corrugated {
                let idle = SEGMENTS.idle(&shown.scene, 0);
                triangles_ui(ui, initial, idle, &mut shown.scene.object);
            }
            parameter(ui, initial, &mut shown.scene, &SEGMENTS);
            parameter(ui, initial, &mut shown.scene, &RINGS);
        }
    }
    let [faces, vertices, triangles] =
        [report.faces, report.vertices, report.triangles].map(grouped);
    let tip = text!("lights-mesh.tip", triangles = triangles);
    let counts = text!("lights-mesh", faces = faces, vertices = vertices);
    ui.weak(counts).on_hover_text(tip);
    let scene = &mut shown.scene;
    let options = RowOptions {
        offered: Some(has_normals),
        ..RowOptions::default()
    };
    parameter_with(ui, initial, scene, &NORMALS, &options);
    if scene.object.normal_source() == NormalSource::Averaged {
        parameter(ui, initial, scene, &WEIGHTING);
    }
}

/// Returns whether the object has vertex normals from this source.
fn has_normals(scene: &Scene, source: &ChoiceOption) -> bool {
    let Object {
        kind,
        vertex_normals,
        ..
    } = &scene.object;
    match source.word {
        "exact" => kind.has_surface(),
        "file" => {
            *kind == ObjectKind::Obj
                || (*kind == ObjectKind::Polygons && !vertex_normals.is_empty())
        }
        _ => true,
    }
}

/// Shows one slider for segments and rings together.
fn triangles_ui(ui: &mut Ui, initial: &Scene, idle: Option<&str>, object: &mut Object) {
    let plain = Object {
        segments: initial.object.segments,
        rings: initial.object.rings,
        ..object.clone()
    };
    let [segments, rings] = divisions_for(object.kind, 0);
    let least = triangles(&Object {
        segments,
        rings,
        ..object.clone()
    }) as f64;
    let about = About {
        label: text!("lights-triangles"),
        tip: text!("lights-triangles.tip"),
        symbol: Some(Symbol::Normal),
        idle,
        ..About::default()
    };
    let range = SliderRange {
        limits: least..=MOST,
        decimals: 0,
        ..SliderRange::logarithmic(least..=SLIDER)
    };
    let (now, default) = (triangles(object) as f64, triangles(&plain) as f64);
    let mut wanted = now;
    let row = NumberRow {
        about,
        range,
        default,
    };
    number(ui, &row, &mut wanted);
    if wanted == now {
        return;
    }
    [object.segments, object.rings] = if wanted == default {
        [plain.segments, plain.rings]
    } else {
        // The limits keep the number from being negative.
        divisions_for(object.kind, wanted.round() as u64)
    };
}

/// Shows the size of the scene's own polygons, the ways to edit them, and the chosen vertex in numbers.
fn polygons_ui(ui: &mut Ui, vertex: &mut usize, object: &mut Object) {
    let polygons = object.polygons();
    let (count, faces) = (polygons.vertices.len(), polygons.faces.len());
    ui.label(text!("lights-polygons", vertices = count, faces = faces));
    let how = if count <= MOST_HANDLES {
        text!("lights-polygons-drag")
    } else {
        text!("lights-polygons-many")
    };
    ui.weak(how);
    let Some(at) = polygons.vertices.get(*vertex).copied() else {
        return;
    };
    let mut number = u32::try_from(*vertex).unwrap_or(u32::MAX);
    let last = (count - 1) as f64;
    let range = SliderRange {
        limits: 0.0..=last,
        decimals: 0,
        ..SliderRange::linear(0.0..=last)
    };
    let about = About {
        label: text!("lights-vertex"),
        tip: text!("lights-vertex.tip"),
        ..About::default()
    };
    let row = NumberRow {
        about,
        range,
        default: 0.0,
    };
    whole(ui, &row, &mut number);
    *vertex = number as usize;
    let about = About {
        label: text!("lights-vertex-position"),
        name: text!("lights-vertex-position.name"),
        tip: text!("lights-vertex-position.tip"),
        ..About::default()
    };
    let mut to = at;
    value_row(ui, &about, at, &mut to, |ui, to| {
        axes(ui, about.name, to);
    });
    if to != at {
        move_vertex(object, number, to, f64::MIN_POSITIVE);
    }
}
