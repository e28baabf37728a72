//! The tab of stiff and extreme cases: what the textbook's way, the engine and a reference make of each, and by how much they
//! differ.

use super::background::wake;
use super::engine::Engine;
use super::report::{export_ui, words_ui};
use super::state::AppState;
use crate::analysis::{
    CASE_PICTURES, CaseResult, HALF_A_CODE_VALUE, Section, StabilityQuestion, stability_cases,
};
use crate::jobs::{Asked, Background};
use crate::scene::{Choice, Scene};
use eframe::egui::{
    Align, Button, ColorImage, Context, Image, Layout, ProgressBar, RichText, TextureHandle,
    TextureOptions, Ui, Vec2, vec2,
};
use std::fmt;

/// The tab's state.
#[derive(Default)]
pub struct StabilityView {
    work: Background<Asked<StabilityQuestion>>,
    /// The case that is shown.
    chosen: usize,
    /// The pictures of the case that is shown.
    shown: Option<[TextureHandle; 3]>,
}

impl fmt::Debug for StabilityView {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StabilityView")
            .field("work", &self.work)
            .field("chosen", &self.chosen)
            .finish()
    }
}

/// Widths of the columns, points, and the height of a row.
const NUMBER: f32 = 62.0;
const ROW: f32 = 21.0;
/// Between the pictures.
const GAP: f32 = 6.0;

/// The tab. The catalogue is drawn once, when the tab is first seen.
pub fn stability_ui(ui: &mut Ui, view: &mut StabilityView, state: &mut AppState, _: &Engine) {
    let ask = || {
        Asked::new(
            StabilityQuestion::default(),
            &Scene::default(),
            None,
            [1, 1],
        )
    };
    view.work.ask(wake(ui.ctx()), |_| true, ask);
    ui.label(
        "Scenes at the limits of floating point. A textbook's renderer fails; this one must not.",
    );
    ui.add_space(4.0);
    let (known, total) = (
        view.work.answer().map_or(0, |found| found.results.len()),
        stability_cases().count(),
    );
    if view.work.progress().is_some() {
        ui.add(
            ProgressBar::new(known as f32 / total as f32).text(format!("{known} of {total} cases")),
        );
        ui.add_space(4.0);
    } else if let Some(Err(why)) = view.work.known() {
        ui.label(RichText::new(why).color(ui.visuals().warn_fg_color));
    }
    let opened = table_ui(ui, view);
    export_ui(ui, state, "stability", || {
        Some((Box::new(view.work.answer()?.clone()), Scene::default()))
    });
    if let Some(mut scene) = opened {
        // The window has its own size, and the picture is looked at in it.
        scene.image.size = state.document.scene.image.size;
        state.document.scene = scene;
    }
}

/// A case with its pictures; returns whether it is asked for as a scene.
fn case_ui(ui: &mut Ui, result: &CaseResult, pictures: &[TextureHandle; 3]) -> bool {
    ui.add_space(4.0);
    ui.label(RichText::new(result.case.title).strong().size(16.0));
    ui.add_space(2.0);
    let side = ((ui.available_width() - 2.0 * GAP) / 3.0).max(40.0);
    let errors = [Some(result.naive_error), Some(result.robust_error), None];
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        for (picture, name) in pictures.iter().zip(CASE_PICTURES) {
            let words = format!("{}: {name}", result.case.title);
            ui.add(
                Image::new(picture)
                    .fit_to_exact_size(vec2(side, side))
                    .alt_text(words),
            );
        }
    });
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        for (name, error) in CASE_PICTURES.into_iter().zip(errors) {
            cell_ui(
                ui,
                vec2(side, 40.0),
                Layout::top_down(Align::Center),
                |ui| {
                    ui.spacing_mut().item_spacing.y = 0.0;
                    ui.label(name);
                    ui.label(match error {
                        Some(error) => error_text(ui, "off by ", error),
                        None => RichText::new("106 bits").weak(),
                    });
                },
            );
        }
    });
    let mut section = Section::default();
    result.describe(&mut section);
    section.parts.iter().for_each(|part| words_ui(ui, part));
    let tip = "The case becomes the scene in the window. Undo leads back";
    let open = Button::new("Open as the scene");
    result.scene.is_some() && ui.add(open).on_hover_text(tip).clicked()
}

/// The cases by topic, the chosen one with all that is known of it below its row; returns the scene that is asked for.
fn table_ui(ui: &mut Ui, view: &mut StabilityView) -> Option<Scene> {
    ui.label(RichText::new("Greatest errors in code values, of 255").weak());
    let (mut chosen, mut opened) = (view.chosen, None);
    let mut shown = view.shown.take();
    let results = view.work.answer().map_or(&[][..], |found| &found.results);
    let mut index = 0;
    for results in results.chunk_by(|a, b| a.case.topic == b.case.topic) {
        let heads = if index == 0 {
            ["textbook", "engine"]
        } else {
            [""; 2]
        };
        let title = RichText::new(results[0].case.topic.label()).strong();
        row_ui(ui, heads.map(|head| RichText::new(head).weak()), |ui| {
            _ = ui.label(title);
        });
        for result in results {
            let (case, open) = (result.case, index == view.chosen);
            let errors = [result.naive_error, result.robust_error]
                .map(|error| error_text(ui, "", error).monospace());
            row_ui(ui, errors, |ui| {
                let row = ui
                    .add(Button::selectable(open, case.title).truncate())
                    .on_hover_text(case.title);
                if row.clicked() {
                    chosen = index;
                }
                if open && shown.is_none() && index > 0 {
                    row.scroll_to_me(Some(Align::Min));
                }
            });
            if open {
                let pictures = shown.get_or_insert_with(|| textures(ui.ctx(), result));
                if case_ui(ui, result, pictures) {
                    opened.clone_from(&result.scene);
                }
                ui.add_space(8.0);
            }
            index += 1;
        }
    }
    view.shown = shown.filter(|_| chosen == view.chosen);
    view.chosen = chosen;
    opened
}

/// A row: what it is about, then its numbers.
fn row_ui(ui: &mut Ui, numbers: [RichText; 2], name: impl FnOnce(&mut Ui)) {
    let width = (ui.available_width() - 2.0 * (NUMBER + 4.0)).max(120.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing = vec2(4.0, 1.0);
        cell_ui(
            ui,
            vec2(width, ROW),
            Layout::left_to_right(Align::Center),
            name,
        );
        for number in numbers {
            cell_ui(
                ui,
                vec2(NUMBER, ROW),
                Layout::right_to_left(Align::Center),
                |ui| _ = ui.label(number),
            );
        }
    });
}

/// A cell of a width of its own, whatever is in it.
fn cell_ui(ui: &mut Ui, size: Vec2, layout: Layout, content: impl FnOnce(&mut Ui)) {
    ui.allocate_ui_with_layout(size, layout, |ui| {
        ui.set_min_width(size.x);
        content(ui);
    });
}

/// An error in code values, in the colour of a warning where it is seen.
fn error_text(ui: &Ui, before: &str, error: f64) -> RichText {
    let decimals = if error >= 10.0 { 0 } else { 2 };
    let text = RichText::new(format!("{before}{error:.decimals$}"));
    if error > HALF_A_CODE_VALUE {
        text.color(ui.visuals().warn_fg_color)
    } else {
        text
    }
}

fn textures(ctx: &Context, result: &CaseResult) -> [TextureHandle; 3] {
    [0, 1, 2].map(|index| {
        let frame = &result.pictures[index];
        let size = [frame.width as usize, frame.height as usize];
        let image = ColorImage::from_rgba_premultiplied(size, frame.pixels.as_flattened());
        ctx.load_texture(format!("stability {index}"), image, TextureOptions::NEAREST)
    })
}
