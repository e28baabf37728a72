//! The view of stiff and extreme cases: the results of a naive renderer, of the engine and of a reference for each, and their
//! differences; above them the stability of the scene's own law.

mod law;

use super::report::{Offer, Pending, Picked, WIDE, export_ui, words_ui};
use crate::analysis::report::Section;
use crate::analysis::stability::{
    CaseResult, HALF_A_CODE_VALUE, StabilityQuestion, case_pictures, stability_cases,
};
use crate::app::engine::{Engine, image_of};
use crate::app::session::Session;
use crate::app::session::action::Requests;
use crate::app::session::window::WindowState;
use crate::app::widgets::background::wake;
use crate::jobs::Request;
use crate::scene::Scene;
use crate::text::text;
use eframe::egui::{
    Align, Button, Context, Image, Label, Layout, RichText, ScrollArea, TextureHandle,
    TextureOptions, Ui, Vec2, vec2,
};
use law::{LawView, law_ui};
use std::sync::Arc;

/// State of the view.
#[derive(Default)]
pub struct StabilityView {
    asking: Pending<StabilityQuestion>,
    law: LawView,
    /// Index of the case that is shown.
    chosen: usize,
    /// True if the case was chosen in the previous frame, so that it has to be scrolled into view.
    new: bool,
    /// Pictures of the case that is shown.
    shown: Option<[TextureHandle; 3]>,
}

impl StabilityView {
    fn start(&mut self, ctx: &Context) {
        let (question, scene) = (StabilityQuestion::default(), Scene::default());
        let asked = Request::new(question, &scene, None, [1, 1]);
        self.asking.work.start(asked, wake(ctx));
    }

    fn result(&self) -> Option<Arc<CaseResult>> {
        let results = &self.asking.work.answer()?.results;
        results.get(self.chosen).map(Arc::clone)
    }

    fn choose(&mut self, picked: Option<Picked>) {
        if let Some(Picked::Row(row)) = picked {
            (self.chosen, self.shown, self.new) = (row, None, true);
        }
    }
}

/// Space between the pictures, in points.
const GAP: f32 = 6.0;
/// Share of the width that the list has beside a case.
const LIST: f32 = 0.46;
/// Minimum height of the list beside a case, in points.
const LEAST_HEIGHT: f32 = 320.0;

/// Shows the view. The cases are drawn once, when it is first shown.
pub fn stability_ui(
    ui: &mut Ui,
    view: &mut StabilityView,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    engine: &Engine,
) {
    law_ui(ui, &mut view.law, session, window, requests, engine);
    let work = &view.asking.work;
    if work.known().is_none() && work.progress().is_none() {
        view.start(ui.ctx());
    }
    view.asking.receive();
    ui.label(text!("engine-stability-intro"));
    ui.add_space(4.0);
    let complete = view
        .asking
        .work
        .answer()
        .is_some_and(|found| found.results.len() == stability_cases().count());
    if !complete {
        let offer = Offer {
            about: "",
            start: text!("engine-draw-cases"),
            problem: None,
            stale: false,
        };
        if view.asking.state_ui(ui, &offer) {
            view.start(ui.ctx());
        }
    }
    export_ui(ui, session, window, requests, "stability", || {
        view.asking.latest()
    });
    ui.add_space(6.0);
    let opened = if ui.available_width() >= WIDE {
        beside_ui(ui, view)
    } else {
        below_ui(ui, view)
    };
    if let Some(mut scene) = opened {
        // The window has its own size, in which the picture is shown.
        scene.image.size = session.document().scene.image.size;
        session.put_scene(scene);
    }
}

/// Shows the list at the left and the chosen case at the right, and returns the scene to open, if requested.
fn beside_ui(ui: &mut Ui, view: &mut StabilityView) -> Option<Scene> {
    let height = (ui.clip_rect().bottom() - ui.cursor().top()).max(LEAST_HEIGHT);
    let whole = ui.available_width();
    let size = |share: f32| vec2(share * whole - GAP, height);
    ui.horizontal_top(|ui| {
        ui.allocate_ui_with_layout(size(LIST), Layout::top_down(Align::Min), |ui| {
            ScrollArea::vertical()
                .id_salt("cases")
                .auto_shrink(false)
                .show(ui, |ui| {
                    ui.label(RichText::new(text!("engine-stability-title")).weak());
                    let sections = view.asking.view.sections();
                    let mut picked = None;
                    for section in sections {
                        picked = section_ui(ui, view, section).or(picked);
                    }
                    view.choose(picked);
                });
        });
        ui.add_space(GAP);
        ui.allocate_ui_with_layout(size(1.0 - LIST), Layout::top_down(Align::Min), |ui| {
            ScrollArea::vertical()
                .id_salt("case")
                .auto_shrink(false)
                .show(ui, |ui| case_ui(ui, view))
                .inner
        })
        .inner
    })
    .inner
}

/// Shows the list, with the chosen case below its topic, and returns the scene to open, if requested.
fn below_ui(ui: &mut Ui, view: &mut StabilityView) -> Option<Scene> {
    ui.label(RichText::new(text!("engine-stability-title")).weak());
    let (mut opened, mut picked) = (None, None);
    for section in view.asking.view.sections() {
        picked = section_ui(ui, view, section).or(picked);
        let rows = |section| view.asking.view.rows_before(section);
        if (rows(section)..rows(section + 1)).contains(&view.chosen) {
            opened = case_ui(ui, view);
            ui.add_space(8.0);
        }
    }
    view.choose(picked);
    opened
}

/// Shows the cases of a topic, and returns the clicked one.
fn section_ui(ui: &mut Ui, view: &mut StabilityView, section: usize) -> Option<Picked> {
    let chosen = Some(view.chosen);
    let picked = view
        .asking
        .view
        .sections_ui(ui, section..section + 1, chosen);
    ui.add_space(8.0);
    picked
}

/// Shows the chosen case with its pictures, and returns it as a scene if that is requested.
fn case_ui(ui: &mut Ui, view: &mut StabilityView) -> Option<Scene> {
    let result = view.result()?;
    let pictures = view
        .shown
        .get_or_insert_with(|| textures(ui.ctx(), &result))
        .clone();
    let title = Label::new(RichText::new(result.case.title()).strong().size(16.0)).wrap();
    let title = ui.add(title);
    if std::mem::take(&mut view.new) && !ui.clip_rect().contains_rect(title.rect) {
        title.scroll_to_me(Some(Align::Center));
    }
    ui.add_space(2.0);
    pictures_ui(ui, &result, &pictures);
    let mut section = Section::default();
    result.describe(&mut section);
    section.parts.iter().for_each(|part| words_ui(ui, part));
    let open = Button::new(text!("engine-open-case"));
    let asked = result.scene.is_some()
        && ui
            .add(open)
            .on_hover_text(text!("engine-open-case.tip"))
            .clicked();
    result.scene.clone().filter(|_| asked)
}

/// Shows the three pictures, each with its name and its error below.
fn pictures_ui(ui: &mut Ui, result: &CaseResult, pictures: &[TextureHandle; 3]) {
    let side = ((ui.available_width() - 2.0 * GAP) / 3.0).clamp(40.0, 258.0);
    let errors = [Some(result.naive_error), Some(result.robust_error), None];
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        for ((picture, name), error) in pictures.iter().zip(case_pictures()).zip(errors) {
            let words = text!("engine-picture", case = result.case.title(), name = name);
            cell_ui(ui, side, |ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                ui.add(
                    Image::new(picture)
                        .fit_to_exact_size(Vec2::splat(side))
                        .alt_text(words),
                );
                ui.add(Label::new(name).wrap());
                ui.label(match error {
                    Some(error) => error_text(ui, error),
                    None => RichText::new(text!("engine-bits")).weak(),
                });
            });
        }
    });
    ui.add_space(4.0);
}

/// Shows a cell of fixed width, whatever its content.
fn cell_ui(ui: &mut Ui, width: f32, content: impl FnOnce(&mut Ui)) {
    ui.allocate_ui_with_layout(vec2(width, 0.0), Layout::top_down(Align::Center), |ui| {
        ui.set_width(width);
        content(ui);
    });
}

/// Formats an error in code values, in the colour of a warning if it is visible.
fn error_text(ui: &Ui, error: f64) -> RichText {
    let decimals = if error >= 10.0 { 0 } else { 2 };
    let error_in_digits = format!("{error:.decimals$}");
    let text = RichText::new(text!("engine-off-by", error = error_in_digits));
    if error > HALF_A_CODE_VALUE {
        text.color(ui.visuals().warn_fg_color)
    } else {
        text.weak()
    }
}

fn textures(ctx: &Context, result: &CaseResult) -> [TextureHandle; 3] {
    [0, 1, 2].map(|index| {
        let image = image_of(&result.pictures[index]);
        ctx.load_texture(format!("stability {index}"), image, TextureOptions::NEAREST)
    })
}
