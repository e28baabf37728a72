//! The view of the five defects of interpolated shading: their definitions, their size in this scene, a scene to try each in, and
//! their places in the picture.

use super::report::{Pending, export_ui};
use crate::analysis::conditions::{CONDITIONS, ConditionsQuestion};
use crate::analysis::defects::{DEFECTS, Defect, DefectMark, DefectsQuestion, defect_marks};
use crate::analysis::normals::NormalsQuestion;
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::appearance::ViewName;
use crate::app::session::document::Origin;
use crate::app::session::place::Place;
use crate::app::session::window::WindowState;
use crate::app::widgets::background::progress_ui;
use crate::app::widgets::letter::letter;
use crate::app::widgets::mark::mark_ui;
use crate::app::widgets::{focus, lines};
use crate::scene::{
    Light, LightKind, NormalSource, Object, ObjectKind, Projection, Scene, ShadingMode, Viewer,
};
use crate::text;
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align2, CollapsingHeader, Color32, FontId, Id, Label, Painter, RichText, Ui, UiBuilder,
};
use glam::DVec3;

/// Approximate width of a card of the view, in points.
const CARD: f32 = 380.0;

/// State of the view: its measurements, and the part of them that is shown in the picture.
#[derive(Default)]
pub struct DefectsView {
    measured: Pending<DefectsQuestion>,
    normal: Pending<NormalsQuestion>,
    conditions: Pending<ConditionsQuestion>,
    /// Defect that is marked, chosen while this scene was open.
    marked: Option<(Origin, &'static str)>,
    /// State that the buttons of the conditions have changed, to go back to.
    before: Before,
}

/// Lights and object before they were changed to meet a condition.
#[derive(Default)]
struct Before {
    lights: Vec<Light>,
    object: Option<Object>,
}

/// Shows the view of defects.
pub fn defects_ui(
    ui: &mut Ui,
    view: &mut DefectsView,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let size = engine.size;
    if size.contains(&0) {
        return;
    }
    let pixel = Some(window.probe.pixel(size));
    let question = DefectsQuestion { pixel };
    view.measured.ask(ui.ctx(), &session.shown, size, &question);
    ui.label(text!("picture-defects-about"));
    let work = &view.measured.work;
    ui.vertical(|ui| {
        if !progress_ui(ui, work, text!("picture-defects-stop")) && work.stopped() {
            ui.label(RichText::new(text!("picture-defects-stopped")).weak());
        }
    });
    export_ui(ui, session, window, requests, "defects", || {
        view.measured.latest()
    });
    ui.add_space(4.0);
    // The defect that the scene is about comes first.
    let mut order: Vec<(usize, &Defect)> = DEFECTS.iter().enumerate().collect();
    order.sort_by_key(|(_, defect)| !is_open(session, defect));
    let columns = ((ui.available_width() / CARD) as usize).clamp(1, 3);
    ui.columns(columns, |columns| {
        let count = columns.len();
        for (place, (index, defect)) in order.into_iter().enumerate() {
            columns[place % count]
                .vertical(|ui| card_ui(ui, view, session, requests, index, defect));
        }
    });
    ui.separator();
    let flat = session.shown.scene.shading.mode == ShadingMode::Flat;
    let title = text!("picture-conditions");
    CollapsingHeader::new(title)
        .default_open(flat)
        .show(ui, |ui| {
            conditions_ui(ui, view, session, window, requests, size);
        });
    ui.collapsing(text!("picture-vertex-normal"), |ui| {
        normal_ui(ui, &mut view.normal, session, window, requests, size);
    });
}

/// Shows a card about a defect: what it is, how large, and where to see it.
fn card_ui(
    ui: &mut Ui,
    view: &mut DefectsView,
    session: &Session,
    requests: &mut Requests,
    index: usize,
    defect: &'static Defect,
) {
    ui.separator();
    // Grouped, so that the widgets below keep their identity when the answer arrives.
    ui.vertical(|ui| {
        if view.measured.view.is_empty() {
            ui.label(RichText::new(defect.title()).strong());
            ui.label("…");
        }
        view.measured.view.section_ui(ui, index);
    });
    if MARKED.contains(&defect.scene) {
        let mut on = is_marked(Some(view), session, defect);
        if ui
            .checkbox(&mut on, text!("picture-mark"))
            .on_hover_text(text!("picture-mark.tip"))
            .changed()
        {
            let chosen = if on { defect.scene } else { "" };
            view.marked = Some((session.document().origin.clone(), chosen));
        }
    }
    if is_open(session, defect) {
        ui.label(text!("picture-try", what = defect.try_this()));
    } else {
        let name = text!("picture-example-of", name = defect.title());
        let button = ui.button(text!("picture-example"));
        let button = focus::named(button, Role::Button, &name);
        if button.on_hover_text(defect.try_this()).clicked() {
            requests.ask(Action::OpenBuiltIn(defect.scene.to_owned()));
        }
    }
    ui.add_space(6.0);
}

/// Scenes of the defects that have a place in the picture.
const MARKED: [&str; 4] = [
    "silhouette",
    "perspective-distortion",
    "orientation",
    "shared-vertices",
];

/// Returns whether a defect is marked in the picture: the chosen one, or else the one that the scene is about.
fn is_marked(view: Option<&DefectsView>, session: &Session, defect: &Defect) -> bool {
    let chosen = view.and_then(|view| view.marked.as_ref());
    match chosen.filter(|(origin, _)| *origin == session.document().origin) {
        Some((_, scene)) => *scene == defect.scene,
        None => is_open(session, defect),
    }
}

/// Returns the built-in scene of the defect that is marked in the picture.
pub fn marked(session: &Session, window: &WindowState) -> Option<&'static str> {
    let view = window.own.get::<DefectsView>();
    let mut defects = DEFECTS.iter().filter(|_| window.shows(ViewName::Defects));
    let marked = defects.find(|defect| is_marked(view, session, defect));
    marked.map(|defect| defect.scene)
}

/// Returns whether the ring that turns the picture is shown.
pub fn shows_ring(session: &Session, window: &WindowState) -> bool {
    marked(session, window) == Some("orientation")
}

/// Shows the three conditions under which flat shading is exact, each with its figures and a button that meets or breaks it.
fn conditions_ui(
    ui: &mut Ui,
    view: &mut DefectsView,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    size: [u32; 2],
) {
    let DefectsView {
        conditions, before, ..
    } = view;
    conditions.ask(ui.ctx(), &session.shown, size, &ConditionsQuestion);
    ui.label(text!("picture-conditions.about"));
    ui.add_space(4.0);
    let Some(found) = conditions.work.answer().cloned() else {
        ui.label("…");
        return;
    };
    for (index, (_, holds)) in CONDITIONS.iter().enumerate() {
        let holds = holds(&found);
        condition_ui(ui, holds, found.title(index), &found.figures(index));
        let [meet, spoil] = match index {
            0 => [
                "picture-condition-light.meet",
                "picture-condition-light.break",
            ],
            1 => [
                "picture-condition-viewer.meet",
                "picture-condition-viewer.break",
            ],
            _ if found.has_surface => [
                "picture-condition-surface.meet",
                "picture-condition-surface.break",
            ],
            _ => [
                "picture-condition-polygons.meet",
                "picture-condition-polygons.break",
            ],
        };
        // The button keeps its identity when content above it comes and goes, so that no click is lost.
        let own = UiBuilder::new().scope_id(Id::unique(("condition", index)));
        let button = ui.scope_builder(own, |ui| ui.button(text!(if holds { spoil } else { meet })));
        if button.inner.clicked() {
            let scene = &mut session.shown.scene;
            match index {
                0 => before.turn_lights(scene, holds),
                1 => turn_viewer(scene, holds),
                _ => before.turn_object(scene, holds),
            }
        }
        ui.add_space(6.0);
    }
    let holds = found.further.is_empty();
    let words = found.further_words();
    condition_ui(ui, holds, text!("picture-further"), &words);
    ui.add_space(6.0);
    // The section of the pictures comes after those with the text above.
    conditions.view.section_ui(ui, CONDITIONS.len() + 1);
    export_ui(ui, session, window, requests, "conditions", || {
        conditions.latest()
    });
    ui.add_space(6.0);
}

/// Shows a condition: whether it holds, and what was found.
fn condition_ui(ui: &mut Ui, holds: bool, title: &str, found: &str) {
    ui.horizontal(|ui| {
        verdict_ui(ui, holds);
        ui.add(Label::new(RichText::new(title).strong()).wrap());
    });
    ui.label(found);
}

/// Shows a tick or a cross.
fn verdict_ui(ui: &mut Ui, holds: bool) {
    let words = if holds {
        text!("picture-holds")
    } else {
        text!("picture-fails")
    };
    let response = mark_ui(ui, 16.0, holds);
    focus::named(response, Role::Label, words).on_hover_text(words);
}

impl Before {
    /// Moves the lights to infinity, or back to where they were.
    fn turn_lights(&mut self, scene: &mut Scene, far: bool) {
        if !far {
            self.lights = scene.lights.clone();
            for light in scene
                .lights
                .iter_mut()
                .filter(|light| light.kind.has_position())
            {
                light.kind = LightKind::Directional;
                // Shapes are centred on the origin.
                if light.position != DVec3::ZERO {
                    light.direction = -light.position;
                }
            }
        } else if self.lights.len() == scene.lights.len() {
            scene.lights = std::mem::take(&mut self.lights);
        } else {
            for light in &mut scene.lights {
                light.kind = LightKind::Point;
            }
        }
    }

    /// Replaces the object by a cube, whose polygons are its surface, or restores it.
    ///
    /// An object that is only polygons gets other normals instead.
    fn turn_object(&mut self, scene: &mut Scene, flat: bool) {
        let object = &mut scene.object;
        let surface = object.kind.has_surface();
        if !flat {
            self.object = Some(object.clone());
            if surface {
                object.kind = ObjectKind::Cube;
            } else {
                object.normals = NormalSource::Facet;
            }
            return;
        }
        match self.object.take() {
            Some(before) if surface => object.kind = before.kind,
            Some(before) => object.normals = before.normals,
            None if surface => object.kind = ObjectKind::Sphere,
            None => object.normals = NormalSource::Averaged,
        }
    }
}

/// Moves the equation's viewer to infinity, or to the eye.
fn turn_viewer(scene: &mut Scene, far: bool) {
    let camera = &mut scene.camera;
    camera.viewer = if far {
        // In parallel projection V is constant anyway.
        camera.projection = Projection::Perspective;
        Viewer::Local
    } else {
        Viewer::Infinite
    };
}

/// Shows the normal of the highlighted vertex, or of the one next to the probe, with its faces and their weights.
fn normal_ui(
    ui: &mut Ui,
    normal: &mut Pending<NormalsQuestion>,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    size: [u32; 2],
) {
    let question = NormalsQuestion {
        vertex: window.pointed.lit,
        pixel: Some(window.probe.pixel(size)),
    };
    normal.ask(ui.ctx(), &session.shown, size, &question);
    match normal.work.known() {
        None => _ = ui.label("…"),
        Some(Err(why)) => _ = ui.label(why),
        Some(Ok(_)) => normal.view.ui(ui),
    }
    export_ui(ui, session, window, requests, "normals", || normal.latest());
}

/// Returns whether the built-in scene about a defect is open.
fn is_open(session: &Session, defect: &Defect) -> bool {
    matches!(&session.document().origin, Origin::BuiltIn(name) if name == defect.scene)
}

/// Draws the marks of the last measurement in the active picture.
pub fn paint(
    painter: &Painter,
    session: &Session,
    window: &WindowState,
    place: Place,
    font: &FontId,
) {
    let measured = window
        .own
        .get::<DefectsView>()
        .filter(|_| window.shows(ViewName::Defects));
    let Some(found) = measured.and_then(|view| view.measured.work.answer()) else {
        return;
    };
    let em = f64::from(font.size * place.pixels_per_point);
    let scene = marked(session, window);
    let drawn = |mark: &DefectMark| scene == Some(mark.scene);
    for mark in defect_marks(&found.defects, place.size, em)
        .into_iter()
        .filter(drawn)
    {
        for stroke in lines::cased([4.0, 1.8], [160, 255]) {
            for line in &mark.lines {
                let points = line.iter().map(|point| place.exact_point(*point));
                lines::line(painter, points, stroke, &[]);
            }
        }
        letter(
            painter,
            place.point(mark.label_at),
            Align2::CENTER_CENTER,
            &mark.label,
            font,
            Color32::WHITE,
        );
    }
}
