//! The materials of a model: their list, and the change of the chosen one.
//!
//! A model's material is changed by `[[object.material]]` of the scene, never in its file. While its rows are shown it takes
//! the place of the scene's material, so that they need not know whose it is.

use super::row::{RowOptions, parameter_with};
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::window::WindowState;
use crate::app::widgets::focus::switch_named;
use crate::app::widgets::sign::{disc, signed};
use crate::app::widgets::swatch::display_colour;
use crate::geometry::{Mesh, built_in};
use crate::scene::material::SOURCE;
use crate::scene::{MaterialSource, Rgb};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{ScrollArea, Ui, vec2};
use std::sync::Arc;

/// Side of a material's colour, in points.
const COLOUR: f32 = 12.0;
/// Height of the list, in lines, above which it scrolls.
const MOST_LINES: f32 = 8.5;

/// The material whose rows are shown.
#[derive(Default)]
pub struct ChosenMaterial {
    /// Its number in the model; the scene's own where there is none.
    number: Option<usize>,
    /// The model.
    of: Option<*const Mesh>,
    /// The pixel that was probed last.
    probed: Option<[u32; 2]>,
}

/// Returns the mesh whose faces may have materials of their own.
fn mesh(session: &Session) -> Option<&Arc<Mesh>> {
    let kind = session.shown.scene.object.kind;
    built_in(kind).or(session.shown.model.as_ref().filter(|_| kind.is_model()))
}

/// Returns the model's materials, if faces have them.
fn model(session: &Session) -> Option<&Arc<Mesh>> {
    let own = session.shown.scene.material.source == MaterialSource::Model;
    let model = mesh(session).filter(|_| own)?;
    (!model.materials.is_empty()).then_some(model)
}

/// Returns whether the panel has a list of materials.
pub fn has_several(session: &Session) -> bool {
    model(session).is_some()
}

/// Shows a line for each of the model's materials. Probing a face chooses its material.
pub fn list_ui(ui: &mut Ui, session: &mut Session, window: &mut WindowState, engine: &Engine) {
    let has = |model: &Arc<Mesh>| !(model.materials.is_empty() && model.corner_colors.is_empty());
    if !mesh(session).is_some_and(has) {
        return;
    }
    let (initial, scene) = (&session.initial, &mut session.shown.scene);
    parameter_with(ui, initial, scene, &SOURCE, &RowOptions::default());
    let Some(model) = model(session) else {
        return;
    };
    let mut chosen: ChosenMaterial = window.own.take();
    let object = &session.shown.scene.object;
    let of = Some(Arc::as_ptr(model));
    if chosen.of != of {
        chosen = ChosenMaterial {
            number: Some(0),
            of,
            probed: None,
        };
    }
    let drawn = engine
        .drawn()
        .filter(|drawn| drawn.object.path == object.path);
    let probed = drawn.and(engine.probed()).map(|probe| probe.pixel);
    if probed != chosen.probed
        && let Some(face) = engine.probed_face()
    {
        let number = usize::from(model.face_material(face as usize));
        chosen.number = (number < model.materials.len()).then_some(number);
    }
    chosen.probed = probed;
    let line = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let area = ScrollArea::vertical().max_height(MOST_LINES * line);
    area.id_salt("model").show(ui, |ui| {
        for (number, own) in model.materials.iter().enumerate() {
            let shown = object.material(&own.name, &own.face_material());
            let colour = shown.material.kd;
            if line_ui(ui, &own.name, colour, chosen.number == Some(number)) {
                chosen.number = Some(number);
            }
        }
        let scene = &session.shown.scene.material;
        let colour = scene.kd * scene.color;
        let none = text!("controls-model-none");
        if line_ui(ui, none, colour, chosen.number.is_none()) {
            chosen.number = None;
        }
    });
    window.own.put(chosen);
}

/// Shows a material's colour and name, and returns whether it was clicked.
fn line_ui(ui: &mut Ui, name: &str, colour: Rgb, chosen: bool) -> bool {
    let button = signed(chosen, disc(COLOUR, display_colour(colour)), name);
    let response = ui.add(button.min_size(vec2(ui.available_width(), 0.0)));
    switch_named(response, Role::Button, chosen, name).clicked()
}

/// Returns the number of the model's material whose rows are shown; none for the scene's own.
pub fn chosen(session: &Session, window: &WindowState) -> Option<usize> {
    let chosen: &ChosenMaterial = window.own.get()?;
    let count = model(session)?.materials.len();
    chosen.number.filter(|number| *number < count)
}

/// Runs `edit` with the model's material `number` in place of the scene's, and takes over its changes.
pub fn with_chosen(
    session: &mut Session,
    number: Option<usize>,
    edit: &mut dyn FnMut(&mut Session),
) {
    let own = number.zip(model(session));
    let own = own.map(|(number, model)| &model.materials[number]);
    let Some((name, own)) = own.map(|own| (own.name.clone(), own.face_material())) else {
        return edit(session);
    };
    let before = session.shown.scene.object.material(&name, &own);
    let opened = session.initial.object.material(&name, &own);
    let scene = before.clone().replace_in(&mut session.shown.scene);
    let initial = opened.replace_in(&mut session.initial);
    edit(session);
    let wanted = scene.replace_in(&mut session.shown.scene);
    initial.replace_in(&mut session.initial);
    if wanted != before {
        let object = &mut session.shown.scene.object;
        object.change_material(&name, &own, &wanted);
    }
}
