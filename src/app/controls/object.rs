//! The object, how finely it is made of polygons, and its vertex normals.

mod polygons;

use super::triangles::{counts_ui, triangles_ui};
use crate::app::action::Action;
use crate::app::engine::Engine;
use crate::app::row::{About, NumberRow, Rail, choice, toggle, whole};
use crate::app::state::AppState;
use crate::app::symbol::{Lit, Symbol};
use crate::scene::{FlatAt, NormalSource, Object, ObjectKind, Scene, ShadingMode, Weighting};
use eframe::egui::{Button, RichText, Ui};

/// The most segments and rings that a slider reaches; more can be typed.
const SLIDER_DIVISIONS: f64 = 512.0;

const SHAPES: [(ObjectKind, &str, &str); 10] = [
    (ObjectKind::Sphere, "sphere", ""),
    (ObjectKind::Torus, "torus", ""),
    (ObjectKind::Cylinder, "cylinder", ""),
    (ObjectKind::Cone, "cone", ""),
    (ObjectKind::Cube, "cube", ""),
    (ObjectKind::Plane, "plane", ""),
    (ObjectKind::Teapot, "teapot", "Martin Newell's, of 32 patches"),
    (ObjectKind::Corrugated, "corrugated sheet", "Folded to and fro: undivided slopes average to one normal"),
    (ObjectKind::Polygons, "polygons", "The scene's own: vertices to drag in the picture"),
    (ObjectKind::Obj, "model from a file", "A Wavefront OBJ file"),
];

pub fn object_ui(ui: &mut Ui, state: &mut AppState, engine: &Engine) {
    let default = Object::default();
    let AppState { document, lit, .. } = state;
    let mut kind = document.scene.object.kind;
    let about = About { label: "Shape", name: "Object kind", tip: "What is drawn.", ..About::default() };
    choice(ui, lit, &about, default.kind, &SHAPES, &mut kind);
    if kind == ObjectKind::Polygons && document.scene.object.kind != kind {
        document.scene.object.own_polygons();
    }
    if kind != ObjectKind::Obj || document.model.is_some() {
        document.scene.object.kind = kind;
    }
    match kind {
        ObjectKind::Obj => model_ui(ui, state),
        ObjectKind::Polygons => polygons::polygons_ui(ui, state),
        _ => divisions_ui(ui, lit, &mut document.scene),
    }
    if kind == ObjectKind::Obj && state.document.model.is_none() {
        state.ask(Action::Open);
    }
    counts_ui(ui, engine.report());
    normals_ui(ui, &mut state.lit, &mut state.document.scene);
}

/// The model's file.
fn model_ui(ui: &mut Ui, state: &mut AppState) {
    let AppState { document, lit, .. } = state;
    let path = document.scene.object.path.as_ref();
    let name = path.and_then(|path| path.file_name()).map(|name| name.to_string_lossy().into_owned());
    ui.horizontal(|ui| {
        ui.label(RichText::new(name.as_deref().unwrap_or("no model yet")).weak());
        if ui.add(Button::new("Open model…")).clicked() {
            state.asked.push(Action::Open);
        }
    });
    let about = About {
        label: "Fit",
        name: "Fit model",
        tip: "Centres the model and scales it into the unit sphere; otherwise it stays as the file has it.",
        ..About::default()
    };
    toggle(ui, lit, &about, true, &mut document.scene.object.fit);
}

fn divisions_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let idle = (scene.shading.mode == ShadingMode::Exact)
        .then_some("Exact shading draws the true surface, which has no polygons");
    let object = &mut scene.object;
    let (segments, rings) = (object.min_segments(), object.min_rings());
    let sheet = object.kind == ObjectKind::Corrugated;
    if !sheet {
        triangles_ui(ui, lit, idle, object);
    }
    let rail = |least: u32| Rail {
        limits: f64::from(least)..=f64::from(Object::MAX_DIVISIONS),
        decimals: 0,
        ..Rail::logarithmic(f64::from(least)..=SLIDER_DIVISIONS)
    };
    let about = About {
        label: "Segments",
        tip: if sheet {
            "Slopes from left to right. The slider reaches 512; up to 4096 can be typed."
        } else {
            "Polygons round the axis. The slider reaches 512; up to 4096 can be typed."
        },
        symbol: Some(Symbol::Normal),
        idle,
        ..About::default()
    };
    let default = Object::default();
    whole(
        ui,
        lit,
        &NumberRow { about: about.clone(), rail: rail(segments), default: f64::from(default.segments) },
        &mut object.segments,
    );
    let about = About {
        label: "Rings",
        tip: if sheet {
            "Strips of each slope. The slider reaches 512; up to 4096 can be typed."
        } else {
            "Polygons along the axis. The slider reaches 512; up to 4096 can be typed."
        },
        ..about
    };
    whole(ui, lit, &NumberRow { about, rail: rail(rings), default: f64::from(default.rings) }, &mut object.rings);
    (object.segments, object.rings) = (object.segments.max(segments), object.rings.max(rings));
}

fn normals_ui(ui: &mut Ui, lit: &mut Lit, scene: &mut Scene) {
    let default = Object::default();
    let unused = match (scene.shading.mode, scene.shading.flat_at) {
        (ShadingMode::Exact, _) if scene.object.kind.has_surface() => {
            Some("Exact shading takes the true surface's normal at every pixel")
        }
        (ShadingMode::Interpolated, _) | (ShadingMode::Flat, FlatAt::Centre) => {
            Some("This shading takes the polygon's own normal; vertex normals are not used")
        }
        _ => None,
    };
    let object = &scene.object;
    let given =
        object.kind == ObjectKind::Obj || (object.kind == ObjectKind::Polygons && !object.vertex_normals.is_empty());
    let has_surface = object.kind.has_surface();
    let about = About {
        label: "Normals",
        name: "Vertex normals",
        tip: "Where the normals at the vertices come from.",
        symbol: Some(Symbol::Normal),
        idle: unused,
        ..About::default()
    };
    let all = [
        (NormalSource::Averaged, "averaged", "The mean of the polygons that meet at the vertex"),
        (NormalSource::Exact, "true surface's", "Those of the surface that the polygons stand for"),
        (NormalSource::File, "the file's", "As the model or the scene file gives them; averaged where it gives none"),
        (NormalSource::Facet, "each polygon's own", "No smoothing"),
    ];
    let present = scene.object.normals;
    let possible: Vec<_> = all
        .into_iter()
        .filter(|(source, ..)| match source {
            NormalSource::File => given || present == NormalSource::File,
            NormalSource::Exact => has_surface || present == NormalSource::Exact,
            _ => true,
        })
        .collect();
    choice(ui, lit, &about, default.normals, &possible, &mut scene.object.normals);
    if scene.object.normals == NormalSource::Averaged {
        let about =
            About { label: "Weighted", name: "Weighting", tip: "What each polygon counts for in the mean.", ..about };
        let choices = [
            (Weighting::Equal, "equally", "One each (Gouraud 1971)"),
            (Weighting::Area, "by area", "The larger the polygon, the more"),
            (Weighting::Angle, "by angle", "By the polygon's angle at the vertex (Thürmer and Wüthrich 1998)"),
        ];
        choice(ui, lit, &about, default.weighting, &choices, &mut scene.object.weighting);
    }
}
