//! An answer as the window shows it: its words, numbers, tables and plots, how far it is known, and the ways to save it.

use crate::analysis::report::{Part, Section};
use crate::analysis::{Analysis, Answer, Format, Question, Report, ReportContext};
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::document::Document;
use crate::app::session::window::WindowState;
use crate::app::widgets::background::{progress_ui, wake};
use crate::app::widgets::drawing::{height, plot_style, plot_ui};
use crate::app::widgets::letter::lettered;
use crate::app::widgets::table::rows_ui;
use crate::app::widgets::theme::TEXT;
use crate::document::save_answer;
use crate::figure::{Drawing, Paper, PlotStyle, lay_out};
use crate::jobs::{Background, Request};
use crate::scene::{Choice, Scene};
use crate::text::{Language, language, text};
use eframe::egui::accesskit::Role;
use eframe::egui::{Button, Context, RichText, Ui, WidgetInfo};
use glam::DVec2;
use std::collections::BTreeMap;
use std::fmt::Debug;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

pub use crate::app::widgets::table::table_ui;

/// From this width on, points, a plot and its table stand side by side, and sections in columns.
pub const WIDE: f32 = 780.0;
/// The share of the width that plots take beside a table.
const PLOTS: f32 = 0.52;
/// Least width of a column of sections, points, and the most columns.
const COLUMN: f32 = 380.0;
const MOST_COLUMNS: usize = 3;
const GAP: f32 = 20.0;

/// A report, its plots laid out once.
#[derive(Debug, Default)]
pub struct ReportView {
    report: Report,
    language: Language,
    /// The plots as laid out, by section and part, for a style and a width.
    drawings: BTreeMap<Place, (PlotStyle, f32, Drawing)>,
}

/// A part of a report: the numbers of its section and of itself.
type Place = (usize, usize);

/// What is clicked of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Picked {
    /// A row of the tables to choose from, counted through all of them.
    Row(usize),
    /// A point of a plot.
    Point(usize),
}

impl ReportView {
    pub fn set(&mut self, report: Report) {
        (self.report, self.language) = (report, language());
        self.drawings.clear();
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

    /// The sections' numbers.
    pub fn sections(&self) -> Range<usize> {
        0..self.report.sections.len()
    }

    /// The rows to choose from in the sections before this one.
    pub fn rows_before(&self, section: usize) -> usize {
        self.choices((section, 0))
    }

    /// The whole report.
    pub fn ui(&mut self, ui: &mut Ui) {
        self.picked_ui(ui, None);
    }

    /// The whole report, whose row `chosen` is; returns what is clicked.
    pub fn picked_ui(&mut self, ui: &mut Ui, chosen: Option<usize>) -> Option<Picked> {
        self.sections_ui(ui, self.sections(), chosen)
    }

    /// One of its sections.
    pub fn section_ui(&mut self, ui: &mut Ui, index: usize) {
        self.sections_ui(ui, index..index + 1, None);
    }

    /// Some of its sections: below each other, or where there is room the plots beside the tables, or sections in columns.
    pub fn sections_ui(
        &mut self,
        ui: &mut Ui,
        sections: Range<usize>,
        chosen: Option<usize>,
    ) -> Option<Picked> {
        let places: Vec<Place> = sections
            .clone()
            .filter_map(|index| Some((index, self.report.sections.get(index)?)))
            .flat_map(|(index, section)| (0..section.parts.len()).map(move |part| (index, part)))
            .collect();
        let is_plot = |place: &Place| matches!(self.part(*place), Some(Part::Plot(_)));
        let has_table = places
            .iter()
            .any(|place| matches!(self.part(*place), Some(Part::Table(_))));
        let (plots, rest): (Vec<Place>, Vec<Place>) = places.iter().partition(|at| is_plot(at));
        let width = ui.available_width();
        if width < WIDE || (plots.is_empty() && sections.len() < 2) {
            return self.parts_ui(ui, &places, chosen);
        }
        if plots.is_empty() {
            let count = ((width / COLUMN) as usize).clamp(1, MOST_COLUMNS);
            return self.columns_ui(ui, &self.balanced(sections, count), chosen);
        }
        if has_table {
            return self.beside_ui(ui, [&plots, &rest], chosen);
        }
        self.parts_ui(ui, &places, chosen)
    }

    fn part(&self, (section, part): Place) -> Option<&Part> {
        self.report.sections.get(section)?.parts.get(part)
    }

    /// The rows to choose from before a part.
    fn choices(&self, until: Place) -> usize {
        let parts = self
            .report
            .sections
            .iter()
            .enumerate()
            .flat_map(|(index, section)| {
                let parts = section.parts.iter().enumerate();
                parts.map(move |(number, part)| ((index, number), part))
            });
        let rows = |part: &Part| match part {
            Part::Table(table) if table.to_choose => table.rows.len(),
            _ => 0,
        };
        parts
            .take_while(|(place, _)| *place < until)
            .map(|(_, part)| rows(part))
            .sum()
    }

    /// Plots at the left, all else at the right.
    fn beside_ui(
        &mut self,
        ui: &mut Ui,
        [plots, rest]: [&[Place]; 2],
        chosen: Option<usize>,
    ) -> Option<Picked> {
        let left = PLOTS * (ui.available_width() - GAP);
        let top = |ui: &mut Ui, width: f32, view: &mut Self, places: &[Place]| {
            ui.vertical(|ui| {
                ui.set_width(width);
                view.parts_ui(ui, places, chosen)
            })
            .inner
        };
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = GAP;
            let picked = top(ui, left, self, plots);
            let right = ui.available_width();
            top(ui, right, self, rest).or(picked)
        })
        .inner
    }

    /// The parts of the sections in so many columns of about one height.
    fn balanced(&self, sections: Range<usize>, count: usize) -> Vec<Vec<Place>> {
        let lines = |section: &Section| {
            let of = |part: &Part| match part {
                Part::Table(table) => table.rows.len() + 1,
                Part::Text(text) | Part::Note(text) => 1 + text.chars().count() / 50,
                _ => 1,
            };
            2 + section.parts.iter().map(of).sum::<usize>()
        };
        let heights: Vec<usize> = self.report.sections[sections.clone()]
            .iter()
            .map(lines)
            .collect();
        let whole: usize = heights.iter().sum();
        let (mut columns, mut above) = (vec![Vec::new(); count], 0);
        for (index, height) in sections.zip(heights) {
            // The column in which the section's middle would be.
            let column = ((above + height / 2) * count / whole.max(1)).min(count - 1);
            above += height;
            let parts = self.report.sections[index].parts.len().max(1);
            columns[column].extend((0..parts).map(|part| (index, part)));
        }
        columns
    }

    fn columns_ui(
        &mut self,
        ui: &mut Ui,
        columns: &[Vec<Place>],
        chosen: Option<usize>,
    ) -> Option<Picked> {
        ui.scope(|ui| {
            ui.spacing_mut().item_spacing.x = GAP;
            ui.columns(columns.len(), |uis| {
                let mut picked = None;
                for (ui, places) in uis.iter_mut().zip(columns) {
                    picked = self.parts_ui(ui, places, chosen).or(picked);
                }
                picked
            })
        })
        .inner
    }

    /// Parts below each other, each section's title above its first.
    fn parts_ui(&mut self, ui: &mut Ui, places: &[Place], chosen: Option<usize>) -> Option<Picked> {
        let (mut picked, mut last) = (None, None);
        for &place in places {
            let (index, number) = place;
            let Some(section) = self.report.sections.get(index) else {
                continue;
            };
            if last != Some(index) && !section.title.is_empty() {
                if last.is_some() {
                    ui.add_space(8.0);
                }
                ui.label(RichText::new(&section.title).strong());
            }
            last = Some(index);
            match section.parts.get(number) {
                Some(Part::Table(table)) => {
                    let before = self.choices(place);
                    let chosen = chosen.and_then(|row| row.checked_sub(before));
                    // Several reports may stand in one view.
                    let id = (self.report.title.as_str(), place);
                    let row = rows_ui(ui, id, table, (table.to_choose, chosen));
                    picked = row.map(|row| Picked::Row(before + row)).or(picked);
                }
                Some(Part::Plot(_)) => picked = self.drawn_ui(ui, place).or(picked),
                Some(words) => words_ui(ui, words),
                None => {}
            }
        }
        picked
    }

    /// A plot, laid out anew where the report, the theme or the width has changed.
    fn drawn_ui(&mut self, ui: &mut Ui, place: Place) -> Option<Picked> {
        let Self {
            report, drawings, ..
        } = self;
        let Part::Plot(plot) = report.sections.get(place.0)?.parts.get(place.1)? else {
            return None;
        };
        let (style, width) = (plot_style(ui), ui.available_width());
        let kept = drawings
            .remove(&place)
            .filter(|(laid, wide, _)| *laid == style && *wide == width);
        let (.., drawing) = drawings.entry(place).or_insert(kept.unwrap_or_else(|| {
            let room = DVec2::new(width.into(), height(plot, width.into(), style.text));
            (style, width, lay_out(plot, room, &style))
        }));
        let title = lettered(&plot.title, ui.visuals().strong_text_color());
        let words = || WidgetInfo::labeled(Role::Label, true, &plot.title);
        ui.label(title).widget_info(words);
        let point = plot_ui(ui, plot, drawing, &style);
        ui.add_space(12.0);
        point.map(Picked::Point)
    }
}

/// What is said of an answer that is not there, and how it is asked for.
#[derive(Clone, Copy, Debug)]
pub struct Offer<'a> {
    /// What it would tell and how long that takes.
    pub about: &'a str,
    /// What the button says that asks for it first.
    pub start: &'a str,
    /// Why it cannot be asked for.
    pub problem: Option<&'a str>,
    /// Whether the answer that is there is about something else by now.
    pub stale: bool,
}

/// A question about the document, answered in the background, and the report of its latest answer.
pub struct Pending<Q: Question> {
    pub work: Background<Request<Q>>,
    pub view: ReportView,
}

impl<Q: Question> Default for Pending<Q> {
    fn default() -> Self {
        Self {
            work: Background::default(),
            view: ReportView::default(),
        }
    }
}

impl<Q: Question> Pending<Q> {
    /// Asks it about the document in a picture of `size`; until the answer comes, the last one stays.
    pub fn ask(&mut self, ctx: &Context, document: &Document, size: [u32; 2], question: &Q) {
        let Document { scene, model, .. } = document;
        let same = |asked: &Request<Q>| asked.is(question, scene, model.as_ref(), size);
        let new = self.work.ask(wake(ctx), same, || {
            Request::new(question.clone(), scene, model.as_ref(), size)
        });
        let again = new || !self.view.is_current();
        if let Some(answer) = self.work.answer().filter(|_| again) {
            self.view
                .set(answer.report(&ReportContext { name: "", scene }));
        }
    }

    /// Asks it once; [`Self::receive`] takes the answer.
    pub fn start(&mut self, ctx: &Context, document: &Document, size: [u32; 2], question: Q) {
        self.work.start(
            Request::new(question, &document.scene, document.model.as_ref(), size),
            wake(ctx),
        );
    }

    /// Takes what a question that was asked once has found.
    pub fn receive(&mut self) {
        if (self.work.take() || !self.view.is_current())
            && let (Some(answer), Some(asked)) = (self.work.answer(), self.work.answered())
        {
            self.view.set(answer.report(&ReportContext {
                name: "",
                scene: &asked.subject().scene,
            }));
        }
    }

    /// Whether the answer is about another model, or a scene that is not the `same` as the document's.
    pub fn is_stale(
        &self,
        Document { scene, model, .. }: &Document,
        same: impl Fn(&Scene, &Scene) -> bool,
    ) -> bool {
        self.work.answered().is_some_and(|asked| {
            asked.model.as_ref().map(Arc::as_ptr) != model.as_ref().map(Arc::as_ptr)
                || !same(&asked.scene, scene)
        })
    }

    /// How far the answer is known, in a sentence with the next step; returns whether it is to be asked for.
    pub fn state_ui(&self, ui: &mut Ui, offer: &Offer<'_>) -> bool {
        if progress_ui(ui, &self.work, text!("report-stop-tip")) {
            return false;
        }
        let visuals = ui.visuals();
        let (weak, warning) = (visuals.weak_text_color(), visuals.warn_fg_color);
        let again = text!("report-again");
        let (step, words, colour) = match (self.work.known(), offer.problem) {
            (None, None) => (offer.start, offer.about, weak),
            (None, Some(problem)) => (offer.start, problem, warning),
            (_, Some(problem)) => (again, problem, warning),
            (Some(Err(why)), _) => (text!("report-try-again"), why.as_str(), warning),
            (Some(Ok(_)), _) if self.work.stopped() => (again, text!("report-stopped"), warning),
            (Some(Ok(_)), _) if offer.stale => (again, text!("report-stale"), warning),
            (Some(Ok(_)), _) => (again, "", weak),
        };
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 8.0;
            let button = ui.add_enabled(offer.problem.is_none(), Button::new(step));
            ui.label(RichText::new(words).color(colour));
            button.clicked()
        })
        .inner
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

/// An answer that is about to be saved.
#[derive(Debug)]
pub struct Export {
    answer: Box<dyn Answer>,
    scene: Scene,
    name: String,
}

impl Export {
    fn about(&self) -> ReportContext<'_> {
        ReportContext {
            name: &self.name,
            scene: &self.scene,
        }
    }
}

/// Buttons that save the answer of `analysis` in every format that it has, and copy it; `answer` gives it with its scene.
pub fn export_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
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
                .on_hover_text(text!("report-save-tip", format = ending))
                .clicked()
            {
                format = Some(one);
            }
        }
        copy = ui
            .button(text!("report-copy"))
            .on_hover_text(text!("report-copy.tip"))
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
        name: session.document().origin.name(),
    };
    if copy {
        ui.ctx().copy_text(export.answer.text(&export.about()));
        session.notice = Some(text!("report-copied", name = analysis.name));
    } else if let Some(format) = format {
        window.own.put(export);
        requests.ask(Action::SaveAnswer(analysis.name, format));
    }
}

/// Writes the answer that is about to be saved, as the path's ending says.
pub fn save(session: &mut Session, window: &WindowState, path: &Path) -> Result<(), String> {
    let export = window
        .own
        .get::<Export>()
        .ok_or_else(|| text!("report-nothing-to-save").to_owned())?;
    let format =
        Format::from_path(path).ok_or_else(|| text!("report-unknown-ending").to_owned())?;
    save_answer(
        path,
        format,
        &*export.answer,
        &export.about(),
        (None, Paper::LIGHT),
    )
    .map_err(|e| e.to_string())?;
    session.notice = Some(text!("report-saved", path = path.display().to_string()));
    Ok(())
}
