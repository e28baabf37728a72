//! The curves at the probe, drawn with the window's own painter, with their values under the pointer.
//!
//! The plots are sampled when the scene, the probe or the chosen light changes, and laid out when the panel's width or the theme
//! does. A frame in which nothing has changed only paints them.

use super::report::{ReportView, export_ui};
use crate::analysis::curves::Curves;
use crate::analysis::probe::Probe;
use crate::analysis::{Answer, ReportContext};
use crate::app::engine::Engine;
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::window::WindowState;
use crate::figure::PlotKind;
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::Ui;

/// The plots as last sampled, and the state that they were sampled for.
#[derive(Debug, Default)]
pub struct CurvesView {
    sampled: Option<(u64, usize)>,
    curves: Option<Curves>,
    view: ReportView,
}

/// Shows the plots for the probe, one below the other.
pub fn curves_ui(
    ui: &mut Ui,
    own: &mut CurvesView,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    let scene = &session.shown.scene;
    let light = session.light.min(scene.lights.len().saturating_sub(1));
    if own.sampled != Some((engine.revision, light)) || !own.view.is_current() {
        own.sampled = Some((engine.revision, light));
        own.curves = engine.curves(light);
        let curves = own.curves.clone().unwrap_or_default();
        own.view
            .set(curves.report(&ReportContext { name: "", scene }));
    }
    own.view.ui(ui);
    let kinds = own.curves.iter().flat_map(|curves| &curves.kinds);
    if !kinds.into_iter().any(|kind| *kind == PlotKind::Lobe) {
        missing_ui(ui, engine, light);
    }
    export_ui(ui, session, window, requests, "curves", || {
        Some((Box::new(own.curves.clone()?), engine.drawn()?.clone()))
    });
}

/// Says what the probe shows beside the object.
pub fn beside_words(probe: &Probe, scene: &Scene) -> &'static str {
    if probe.beside_is_floor(scene) {
        text!("point-background.floor")
    } else {
        text!("point-background")
    }
}

/// Explains why there is no lobe.
fn missing_ui(ui: &mut Ui, engine: &Engine, light: usize) {
    let (Some(probe), Some(scene)) = (engine.probed(), engine.drawn()) else {
        return;
    };
    let why = match &probe.hit {
        None => beside_words(probe, scene).to_owned(),
        Some(hit) if hit.lights.is_empty() => text!("point-no-light").to_owned(),
        Some(hit) if hit.normal == glam::DVec3::ZERO => text!("point-no-normal").to_owned(),
        Some(_) => text!("point-light-behind", light = light + 1),
    };
    ui.label(why);
}
