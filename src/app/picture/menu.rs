//! The menu of a right click in the picture: what can be done there.

use super::{handles, put_probe};
use crate::analysis::Format;
use crate::analysis::probe::Probed;
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::appearance::ViewName;
use crate::app::session::place::Place;
use crate::app::session::window::{Grip, WindowState};
use crate::app::views::report::export;
use crate::app::widgets::symbol::{self, Sought, Symbol};
use crate::scene::{Choice as _, Light, Scene, View};
use crate::text::text;
use eframe::egui::{Popup, PopupCloseBehavior, Pos2, Response, Ui};
use glam::DVec2;

/// The place of the last right click, and the handle there.
#[derive(Clone, Copy, Debug)]
struct Clicked {
    grip: Grip,
    at: Pos2,
    place: Place,
}

/// Opens the menu at `at`, where `grip` is.
pub fn open(window: &mut WindowState, grip: Grip, at: Pos2, place: Place) {
    window.own.put(Some(Clicked { grip, at, place }));
}

/// Shows the menu while it is open. Items that could show the answer to an open question are disabled.
pub fn menu_ui(
    response: &Response,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let Some(clicked) = window.own.get::<Option<Clicked>>().copied().flatten() else {
        return;
    };
    let chosen = session.light;
    let locked = session.lock.is_some();
    // A click closes the menu, but for one on the right, which opens it at another place.
    let close = if response.secondary_clicked() {
        PopupCloseBehavior::IgnoreClicks
    } else {
        PopupCloseBehavior::CloseOnClick
    };
    let popup = Popup::context_menu(response).close_behavior(close);
    popup.show(|ui| {
        if locked {
            ui.weak(text!("course-after-answer"));
        }
        ui.add_enabled_ui(!locked, |ui| match clicked.grip {
            Grip::Light(index) => light_ui(ui, session, requests, index),
            Grip::SideView => side_view_ui(ui, session, window, requests, engine),
            Grip::Aim { .. } | Grip::Rim(_) => light_ui(ui, session, requests, chosen),
            _ => place_ui(ui, session, window, requests, clicked),
        });
        ui.separator();
        for (name, action) in [
            (text!("controls-command-reset-camera"), Action::ResetCamera),
            (text!("controls-command-copy"), Action::CopyPicture),
            (text!("controls-command-export"), Action::Export),
        ] {
            let free = !(locked && action.waits());
            if ui.add_enabled_ui(free, |ui| item(ui, name)).inner {
                requests.ask(action);
            }
        }
    });
}

/// Shows an item, and returns whether it was chosen, by whatever means: the menu then closes.
fn item(ui: &mut Ui, name: &str) -> bool {
    let chosen = ui.button(name).clicked();
    if chosen {
        ui.close();
    }
    chosen
}

/// Shows what can be done at a place of the picture.
fn place_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    Clicked { at, place, .. }: Clicked,
) {
    let mut probed = |name: &str, view: ViewName| {
        if item(ui, name) {
            put_probe(window, place, at);
            requests.ask(Action::View(view));
        }
    };
    probed(text!("picture-menu-point"), ViewName::Equation);
    probed(text!("picture-menu-scan"), ViewName::ScanLine);
    if item(ui, text!("picture-menu-line")) {
        let y = place.pixel(at).y;
        for (end, x) in [0.08, 0.92].into_iter().enumerate() {
            let pixel = DVec2::new(x * f64::from(place.size[0]), y);
            window.line.put(end, pixel, place.size);
        }
        requests.ask(Action::View(ViewName::Profile));
    }
    let full = session.shown.scene.lights.len() >= Scene::MAX_LIGHTS;
    ui.add_enabled_ui(!full, |ui| {
        if item(ui, text!("picture-menu-light")) {
            let scene = &mut session.shown.scene;
            let view = View::new(&scene.camera, place.size);
            let light = handles::put_light(Light::default(), scene, &view, place.pixel(at));
            scene.lights.push(light);
            session.light = scene.lights.len() - 1;
            symbol::seek(ui.ctx(), Sought::Symbol(Symbol::Light));
        }
    });
}

/// Shows what can be done with the side view of the vectors.
fn side_view_ui(
    ui: &mut Ui,
    session: &Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let overlay = &mut window.appearance.overlay;
    ui.checkbox(
        &mut overlay.side_view_enlarged,
        text!("picture-menu-enlarged"),
    );
    let always = text!("controls-command-side-view");
    ui.checkbox(&mut overlay.side_view, always);
    let needed = text!("controls-command-side-view-where-needed");
    ui.checkbox(&mut overlay.side_view_where_needed, needed);
    for format in [Format::Png, Format::Svg] {
        if item(ui, &format!("{}…", format.label()))
            && let (Some(probe), Some(scene)) = (engine.probed(), engine.drawn())
        {
            let answer = Box::new(Probed::of(probe.clone(), session.light));
            let scene = scene.clone();
            export(session, window, requests, "probe", format, answer, scene);
        }
    }
}

/// Shows what can be done with a light.
fn light_ui(ui: &mut Ui, session: &mut Session, requests: &mut Requests, index: usize) {
    let Some(light) = session.shown.scene.lights.get_mut(index) else {
        return;
    };
    ui.weak(text!("lights-number", number = index + 1));
    if item(ui, text!("picture-menu-settings")) {
        session.light = index;
        symbol::seek(ui.ctx(), Sought::Symbol(Symbol::Light));
    }
    ui.checkbox(&mut light.mute, text!("lights-mute"));
    ui.checkbox(&mut light.solo, text!("lights-solo"));
    if item(ui, text!("lights-duplicate")) {
        requests.ask(Action::AddLight(light.clone()));
    }
    if item(ui, &text!("lights-remove", number = index + 1)) {
        session.remove_light(index);
    }
}
