//! An answer as the window shows it: its words, numbers, tables and plots, and the ways to save it.

use super::action::Action;
use super::background::wake;
use super::document::Document;
use super::drawing::{height, plot_style, plot_ui};
use super::letter::lettered;
use super::state::AppState;
use super::theme::TEXT;
use crate::analysis::{About, Analysis, Answer, Format, Part, Plot, Question, Report, Table};
use crate::document::save_answer;
use crate::figure::{Drawing, Paper, PlotStyle, lay_out};
use crate::jobs::{Asked, Background};
use crate::scene::{Choice, Scene};
use crate::text::{Language, language};
use eframe::egui::accesskit::Role;
use eframe::egui::{
    Align, Button, Context, Grid, Label, Layout, RichText, ScrollArea, TextStyle, Ui, WidgetInfo,
};
use glam::DVec2;
use std::fmt::Debug;
use std::hash::Hash;
use std::path::Path;

/// A report, its plots laid out once.
#[derive(Debug, Default)]
pub struct ReportView {
    report: Report,
    language: Language,
    drawings: Vec<Drawing>,
    /// The style and the width of what is laid out.
    laid_out: Option<(PlotStyle, f32)>,
}

impl ReportView {
    pub fn set(&mut self, report: Report) {
        (self.report, self.laid_out, self.language) = (report, None, language());
    }

    /// Whether the report is in the language of the window; if not, it is to be made again.
    pub fn is_current(&self) -> bool {
        self.language == language()
    }

    pub fn title(&self) -> &str {
        &self.report.title
    }

    pub fn is_empty(&self) -> bool {
        self.report.sections.is_empty()
    }

    /// The whole report.
    pub fn ui(&mut self, ui: &mut Ui) {
        for index in 0..self.report.sections.len() {
            self.section_ui(ui, index);
        }
    }

    /// The whole report, the rows of its first table to choose from; returns the one that is clicked.
    pub fn picked_ui(&mut self, ui: &mut Ui) -> Option<usize> {
        let picked = self.rows_ui(ui, 0, true);
        (1..self.report.sections.len()).for_each(|index| self.section_ui(ui, index));
        picked
    }

    /// One of its sections.
    pub fn section_ui(&mut self, ui: &mut Ui, index: usize) {
        self.rows_ui(ui, index, false);
    }

    fn rows_ui(&mut self, ui: &mut Ui, index: usize, pick: bool) -> Option<usize> {
        let (style, mut picked) = (self.lay_out(ui), None);
        let section = self.report.sections.get(index)?;
        if !section.title.is_empty() {
            ui.label(RichText::new(&section.title).strong());
        }
        for (number, part) in section.parts.iter().enumerate() {
            match part {
                Part::Table(table) => {
                    picked = table_ui(ui, (index, number), table, pick).or(picked);
                }
                Part::Plot(plot) => {
                    let drawing = self
                        .report
                        .plots()
                        .position(|other| std::ptr::eq(other, &**plot));
                    if let Some(drawing) = drawing.and_then(|place| self.drawings.get(place)) {
                        let title = lettered(&plot.title, ui.visuals().strong_text_color());
                        let words = || WidgetInfo::labeled(Role::Label, true, &plot.title);
                        ui.label(title).widget_info(words);
                        plot_ui(ui, plot, drawing, &style);
                        ui.add_space(12.0);
                    }
                }
                words => words_ui(ui, words),
            }
        }
        picked
    }

    /// Lays the plots out anew where the report, the theme or the width has changed.
    fn lay_out(&mut self, ui: &Ui) -> PlotStyle {
        let style = plot_style(ui);
        let width = ui.available_width();
        if self.laid_out != Some((style, width)) {
            self.laid_out = Some((style, width));
            let room =
                |plot: &Plot| DVec2::new(width.into(), height(plot, width.into(), style.text));
            self.drawings = self
                .report
                .plots()
                .map(|plot| lay_out(plot, room(plot), &style))
                .collect();
        }
        style
    }
}

/// A question about the document, answered in the background, and the report of its latest answer.
pub struct Asking<Q: Question> {
    pub work: Background<Asked<Q>>,
    pub view: ReportView,
}

impl<Q: Question> Default for Asking<Q> {
    fn default() -> Self {
        Self {
            work: Background::default(),
            view: ReportView::default(),
        }
    }
}

impl<Q: Question> Asking<Q> {
    /// Asks it about the document in a picture of `size`; until the answer comes, the last one stays.
    pub fn ask(&mut self, ctx: &Context, document: &Document, size: [u32; 2], question: &Q) {
        let Document { scene, model, .. } = document;
        let same = |asked: &Asked<Q>| asked.is(question, scene, model.as_ref(), size);
        let new = self.work.ask(wake(ctx), same, || {
            Asked::new(question.clone(), scene, model.as_ref(), size)
        });
        let again = new || !self.view.is_current();
        if let Some(answer) = self.work.answer().filter(|_| again) {
            self.view.set(answer.report(&About { name: "", scene }));
        }
    }

    /// Asks it once; [`Self::receive`] takes the answer.
    pub fn start(&mut self, ctx: &Context, document: &Document, size: [u32; 2], question: Q) {
        self.work.start(
            Asked::new(question, &document.scene, document.model.as_ref(), size),
            wake(ctx),
        );
    }

    /// Takes what a question that was asked once has found.
    pub fn receive(&mut self) {
        if (self.work.take() || !self.view.is_current())
            && let (Some(answer), Some(asked)) = (self.work.answer(), self.work.answered())
        {
            self.view.set(answer.report(&About {
                name: "",
                scene: &asked.subject().scene,
            }));
        }
    }

    /// The latest answer with the scene that it is about.
    pub fn latest(&self) -> Option<(Box<dyn Answer>, Scene)> {
        Some((
            Box::new(self.work.answer()?.clone()),
            self.work.answered()?.subject().scene,
        ))
    }
}

/// A part of a report that is neither a table nor a plot.
pub fn words_ui(ui: &mut Ui, part: &Part) {
    match part {
        Part::Text(text) => _ = ui.label(text),
        Part::Note(text) => _ = ui.label(RichText::new(text).weak()),
        Part::Quantity { value, name } => {
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing.x = 8.0;
                ui.label(RichText::new(value).monospace().size(1.35 * TEXT).strong());
                ui.label(name);
            });
        }
        Part::Table(_) | Part::Plot(_) => {}
    }
}

/// A table, which is scrolled where it is wider than the panel. Where a row is to be picked, its first cell is a button.
pub fn table_ui(
    ui: &mut Ui,
    id: impl Hash + Copy + Debug,
    table: &Table,
    pick: bool,
) -> Option<usize> {
    let (heads, rows, numbers) = table.for_people();
    let mut picked = None;
    let table = |ui: &mut Ui| {
        if heads.iter().any(|head| !head.is_empty()) {
            for (head, number) in heads.iter().zip(&numbers) {
                let head = Label::new(RichText::new(*head).weak()).extend();
                if *number {
                    ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.add(head));
                } else {
                    ui.add(head);
                }
            }
            ui.end_row();
        }
        for (index, row) in rows.into_iter().enumerate() {
            for (column, (cell, number)) in row.into_iter().zip(&numbers).enumerate() {
                if *number {
                    let text = RichText::new(cell).monospace();
                    ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(text));
                } else if pick && column == 0 {
                    if ui
                        .add(Button::new(cell).frame(false))
                        .on_hover_text("Shows it in the picture")
                        .clicked()
                    {
                        picked = Some(index);
                    }
                } else {
                    let colour = ui.visuals().text_color();
                    ui.label(lettered(&cell, colour));
                }
            }
            ui.end_row();
        }
    };
    ScrollArea::horizontal()
        .id_salt(("scroll", id))
        .show(ui, |ui| {
            ui.spacing_mut().interact_size.y = ui.text_style_height(&TextStyle::Body);
            Grid::new(("table", id))
                .num_columns(heads.len())
                .spacing([6.0, 3.0])
                .show(ui, table)
        });
    picked
}

/// An answer that is about to be saved.
#[derive(Debug)]
pub struct Export {
    answer: Box<dyn Answer>,
    scene: Scene,
    name: String,
}

impl Export {
    fn about(&self) -> About<'_> {
        About {
            name: &self.name,
            scene: &self.scene,
        }
    }
}

/// Buttons that save the answer of `analysis` in every format that it has, and copy it; `answer` gives it with its scene.
pub fn export_ui(
    ui: &mut Ui,
    state: &mut AppState,
    analysis: &'static str,
    answer: impl FnOnce() -> Option<(Box<dyn Answer>, Scene)>,
) {
    let Some(analysis) = Analysis::find(analysis) else {
        return;
    };
    let (mut format, mut copy) = (None, false);
    ui.horizontal_wrapped(|ui| {
        for one in Format::VALUES
            .iter()
            .copied()
            .filter(|one| analysis.formats.contains(one))
        {
            let ending = one.label();
            if ui
                .button(format!("{ending}…"))
                .on_hover_text(format!("Save as {ending}"))
                .clicked()
            {
                format = Some(one);
            }
        }
        copy = ui
            .button("Copy text")
            .on_hover_text("Copies the words and numbers")
            .clicked();
    });
    if format.is_none() && !copy {
        return;
    }
    let Some((answer, scene)) = answer() else {
        return;
    };
    let export = Export {
        answer,
        scene,
        name: state.document.origin.name(),
    };
    if copy {
        ui.ctx().copy_text(export.answer.text(&export.about()));
        state.notice = Some(format!("copied: {}", analysis.name));
    } else if let Some(format) = format {
        state.own.put(export);
        state.ask(Action::SaveAnswer(analysis.name, format));
    }
}

/// Writes the answer that is about to be saved, as the path's ending says.
pub fn save(state: &mut AppState, path: &Path) -> Result<(), String> {
    let export = state
        .own
        .get::<Export>()
        .ok_or("there is nothing to save")?;
    let format =
        Format::from_path(path).ok_or("expected a name that ends in .png, .svg, .csv or .json")?;
    save_answer(
        path,
        format,
        &*export.answer,
        &export.about(),
        (None, Paper::LIGHT),
    )
    .map_err(|e| e.to_string())?;
    state.notice = Some(format!("saved {}", path.display()));
    Ok(())
}
