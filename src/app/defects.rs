//! The tab of the five defects of interpolated shading: what each is, how large it is in this scene, and a scene to try it in.

mod marks;
mod words;

pub use marks::paint;

use super::action::Action;
use super::curves::{LETTERS, height, paper, plot_ui};
use super::document::{Document, same_model};
use super::engine::Engine;
use super::errand::Errand;
use super::look::NumbersTab;
use super::state::AppState;
use super::theme::TEXT;
use crate::analysis::{Defects, Plot, PlotKind, defect_plots, defects_with_progress};
use crate::figure::{Drawing, PlotStyle, lay_out};
use crate::geometry::Mesh;
use crate::render::Renderer;
use crate::scene::Scene;
use eframe::egui::{Button, Context, ProgressBar, RichText, Ui};
use glam::DVec2;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use words::{EACH, Entry};

/// What was last measured, and what is being measured.
#[derive(Debug, Default)]
pub struct Measured {
    known: Option<(Question, Option<Defects>)>,
    work: Option<Errand<Question, Option<Defects>>>,
    shared: Arc<Shared>,
    plots: Vec<Plot>,
    drawings: Vec<Drawing>,
    style: Option<(PlotStyle, f32)>,
}

/// Between the window and the work.
#[derive(Debug, Default)]
struct Shared {
    cancel: AtomicBool,
    /// How far the work is, in percent.
    percent: AtomicU32,
}

#[derive(Clone, Debug)]
struct Question {
    scene: Scene,
    model: Option<Arc<Mesh>>,
    size: [u32; 2],
    pixel: [u32; 2],
}

impl Question {
    fn is(&self, document: &Document, size: [u32; 2], pixel: [u32; 2]) -> bool {
        same_model(self.model.as_ref(), document.model.as_ref())
            && (self.size, self.pixel) == (size, pixel)
            && self.scene == document.scene
    }

    fn answer(&self, ctx: &Context, shared: &Shared) -> Option<Defects> {
        let mut scene = self.scene.clone();
        scene.image.size = self.size;
        let mut renderer = Renderer::default();
        renderer.set_model(self.model.clone());
        let watch = |share: f32| {
            shared.percent.store((100.0 * share) as u32, Ordering::Relaxed);
            ctx.request_repaint();
            !shared.cancel.load(Ordering::Relaxed)
        };
        let measured = defects_with_progress(&mut renderer, &scene, self.pixel, &watch);
        (!shared.cancel.load(Ordering::Relaxed)).then_some(measured)
    }
}

impl Measured {
    /// Sees to it that the scene is measured, beside the window; until then the last figures are shown.
    fn ask(&mut self, ctx: &Context, document: &Document, size: [u32; 2], pixel: [u32; 2]) {
        if let Some((question, answer)) = Errand::take(&mut self.work) {
            let answer = answer.flatten();
            self.plots = answer.as_ref().map(defect_plots).unwrap_or_default();
            self.style = None;
            self.known = Some((question, answer));
        }
        let known = self.known.as_ref().is_some_and(|(known, _)| known.is(document, size, pixel));
        if !known && self.work.is_none() {
            let question = Question { scene: document.scene.clone(), model: document.model.clone(), size, pixel };
            let (shared, repaint) = (Arc::new(Shared::default()), ctx.clone());
            self.shared = Arc::clone(&shared);
            self.work = Some(Errand::new(ctx, question.clone(), move || question.answer(&repaint, &shared)));
        }
    }

    /// How far the measuring is, from 0 to 1, while it runs.
    #[expect(clippy::cast_precision_loss, reason = "a share for the eye")]
    fn progress(&self) -> Option<f32> {
        self.work.as_ref().map(|_| self.shared.percent.load(Ordering::Relaxed) as f32 / 100.0)
    }

    /// Ends the work; the scene is not measured before it changes.
    fn stop(&self) {
        self.shared.cancel.store(true, Ordering::Relaxed);
    }

    /// Whether what was last asked for was stopped.
    fn stopped(&self) -> bool {
        self.work.is_none() && self.known.as_ref().is_some_and(|(_, answer)| answer.is_none())
    }

    /// The figures last measured.
    pub fn defects(&self) -> Option<&Defects> {
        self.known.as_ref()?.1.as_ref()
    }

    fn lay_out(&mut self, style: PlotStyle, width: f32) {
        if self.style != Some((style, width)) {
            self.style = Some((style, width));
            let room = |plot: &Plot| DVec2::new(width.into(), height(plot, width.into(), style.text));
            self.drawings = self.plots.iter().map(|plot| lay_out(plot, room(plot), &style)).collect();
        }
    }

    fn plot(&self, kind: PlotKind) -> Option<(&Plot, &Drawing)> {
        self.plots.iter().zip(&self.drawings).find(|(plot, _)| plot.kind == kind)
    }
}

/// Whether the tab is in sight.
pub fn shown(state: &AppState) -> bool {
    state.shows(NumbersTab::Defects)
}

/// The tab.
pub fn defects_ui(ui: &mut Ui, measured: &mut Measured, state: &mut AppState, engine: &Engine) {
    let size = engine.size();
    if size.contains(&0) {
        return;
    }
    let pixel = state.probe.pixel(size);
    measured.ask(ui.ctx(), &state.shown, size, pixel);
    let style = PlotStyle { paper: paper(ui), text: LETTERS * f64::from(TEXT), titled: false };
    measured.lay_out(style, ui.available_width());
    ui.label("Five things that interpolation gets wrong, measured in the active picture.");
    progress_ui(ui, measured);
    ui.add_space(4.0);
    // What the scene is about comes first.
    let about = EACH.iter().filter(|entry| is_open(state, entry));
    let order: Vec<&Entry> = about.chain(EACH.iter().filter(|entry| !is_open(state, entry))).collect();
    for entry in order {
        entry_ui(ui, measured, state, entry, &style);
    }
}

/// How far the measuring is, and a way to stop it.
fn progress_ui(ui: &mut Ui, measured: &Measured) {
    if let Some(share) = measured.progress() {
        ui.horizontal(|ui| {
            if ui.add(Button::new("Stop")).on_hover_text("Nothing is measured until the scene changes").clicked() {
                measured.stop();
            }
            ui.add(ProgressBar::new(share).show_percentage().desired_width(ui.available_width()));
        });
    } else if measured.stopped() {
        ui.label(RichText::new("Stopped. Measured again when the scene changes.").weak());
    }
}

/// Whether the built-in scene about a defect is open.
fn is_open(state: &AppState, entry: &Entry) -> bool {
    matches!(&state.document.origin, super::Origin::BuiltIn(name) if name == entry.scene)
}

fn entry_ui(ui: &mut Ui, measured: &Measured, state: &mut AppState, entry: &Entry, style: &PlotStyle) {
    ui.separator();
    ui.label(RichText::new(entry.title).strong());
    match measured.defects().map(entry.figures) {
        None => {
            ui.label("…");
        }
        Some(Ok(figures)) => {
            for figure in figures {
                ui.horizontal_wrapped(|ui| {
                    ui.spacing_mut().item_spacing.x = 8.0;
                    ui.label(RichText::new(figure.value).monospace().size(1.35 * TEXT).strong());
                    ui.label(figure.of);
                });
            }
        }
        Some(Err(why)) => {
            ui.label(RichText::new(format!("Not here: {why}.")).weak());
        }
    }
    if let Some((plot, drawing)) = entry.plot.and_then(|kind| measured.plot(kind)) {
        plot_ui(ui, plot, drawing, style);
    }
    ui.label(RichText::new(entry.says).weak());
    let open = is_open(state, entry);
    if !open && ui.button(format!("Show “{}”", entry.title)).on_hover_text(entry.try_this).clicked() {
        state.ask(Action::OpenBuiltIn(entry.scene.to_owned()));
    }
    if open {
        ui.label(format!("Try: {}", entry.try_this));
    }
    ui.add_space(6.0);
}
