//! An answer as the window shows it: its text, numbers, tables and plots, the state of its computation, and the ways to save it.

use crate::analysis::report::{Part, Section};
use crate::analysis::{Analysis, Answer, Format, Question, Report, ReportContext};
use crate::app::session::Session;
use crate::app::session::action::{Action, Requests};
use crate::app::session::document::Document;
use crate::app::session::notice::Notice;
use crate::app::session::window::WindowState;
use crate::app::widgets::background::{ask, progress_ui, wake};
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

/// Width, in points, from which a plot and its table are side by side, and sections in columns.
pub const WIDE: f32 = 780.0;
/// Share of the width that plots take beside a table.
const PLOTS: f32 = 0.52;
/// Minimum width of a column of sections, in points, and the maximum number of columns.
const COLUMN: f32 = 380.0;
const MOST_COLUMNS: usize = 3;
const GAP: f32 = 20.0;

/// A report whose plots are laid out once.
#[derive(Debug, Default)]
pub struct ReportView {
    report: Report,
    language: Language,
    /// Plots as laid out, by section and part, for a style and a width.
    drawings: BTreeMap<PartIndex, (PlotStyle, f32, Drawing)>,
}

/// A part of a report: the indices of its section and of itself.
type PartIndex = (usize, usize);

/// A clicked item of a report.
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

    /// Returns whether the report is in the language of the window. Otherwise it has to be made again.
    pub fn is_current(&self) -> bool {
        self.language == language()
    }

    pub fn title(&self) -> &str {
        &self.report.title
    }

    pub fn is_empty(&self) -> bool {
        self.report.sections.is_empty()
    }

    /// Returns the sections' indices.
    pub fn sections(&self) -> Range<usize> {
        0..self.report.sections.len()
    }

    /// Returns the number of rows to choose from in the sections before this one.
    pub fn rows_before(&self, section: usize) -> usize {
        self.choices((section, 0))
    }

    /// Shows the whole report.
    pub fn ui(&mut self, ui: &mut Ui) {
        self.picked_ui(ui, None);
    }

    /// Shows the whole report with the row `chosen` highlighted, and returns the clicked item.
    pub fn picked_ui(&mut self, ui: &mut Ui, chosen: Option<usize>) -> Option<Picked> {
        self.sections_ui(ui, self.sections(), chosen)
    }

    /// Shows one section of the report.
    pub fn section_ui(&mut self, ui: &mut Ui, index: usize) {
        self.sections_ui(ui, index..index + 1, None);
    }

    /// Shows some sections of the report, and returns the clicked item.
    ///
    /// The parts are below each other or, if the width allows, plots beside tables or sections in columns.
    pub fn sections_ui(
        &mut self,
        ui: &mut Ui,
        sections: Range<usize>,
        chosen: Option<usize>,
    ) -> Option<Picked> {
        let places: Vec<PartIndex> = sections
            .clone()
            .filter_map(|index| Some((index, self.report.sections.get(index)?)))
            .flat_map(|(index, section)| (0..section.parts.len()).map(move |part| (index, part)))
            .collect();
        let is_plot = |place: &PartIndex| matches!(self.part(*place), Some(Part::Plot(_)));
        let has_table = places
            .iter()
            .any(|place| matches!(self.part(*place), Some(Part::Table(_))));
        let (plots, rest): (Vec<PartIndex>, Vec<PartIndex>) =
            places.iter().partition(|at| is_plot(at));
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

    fn part(&self, (section, part): PartIndex) -> Option<&Part> {
        self.report.sections.get(section)?.parts.get(part)
    }

    /// Returns the number of rows to choose from before a part.
    fn choices(&self, until: PartIndex) -> usize {
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

    /// Shows plots at the left and everything else at the right.
    fn beside_ui(
        &mut self,
        ui: &mut Ui,
        [plots, rest]: [&[PartIndex]; 2],
        chosen: Option<usize>,
    ) -> Option<Picked> {
        let left = PLOTS * (ui.available_width() - GAP);
        let top = |ui: &mut Ui, width: f32, view: &mut Self, places: &[PartIndex]| {
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

    /// Divides the parts of the sections into `count` columns of about equal height.
    fn balanced(&self, sections: Range<usize>, count: usize) -> Vec<Vec<PartIndex>> {
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
            // The column that would hold the middle of the section.
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
        columns: &[Vec<PartIndex>],
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

    /// Shows parts below each other, each section's title above its first part.
    fn parts_ui(
        &mut self,
        ui: &mut Ui,
        places: &[PartIndex],
        chosen: Option<usize>,
    ) -> Option<Picked> {
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
                    // One view may contain several reports.
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

    /// Shows a plot, laid out again if the report, the theme or the width has changed.
    fn drawn_ui(&mut self, ui: &mut Ui, place: PartIndex) -> Option<Picked> {
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

/// Description of an answer that is not there, and of the way to request it.
#[derive(Clone, Copy, Debug)]
pub struct Offer<'a> {
    /// Content of the answer, and the time that it takes.
    pub about: &'a str,
    /// Label of the button that first requests the answer.
    pub start: &'a str,
    /// Reason why the answer cannot be requested.
    pub problem: Option<&'a str>,
    /// True if the present answer is about something else by now.
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
    /// Asks the question about the document in a picture of `size`. Until the answer arrives, the last one stays.
    pub fn ask(&mut self, ctx: &Context, document: &Document, size: [u32; 2], question: &Q) {
        let Document { scene, model, .. } = document;
        let same = |asked: &Request<Q>| asked.is(question, scene, model.as_ref(), size);
        let work = || Request::new(question.clone(), scene, model.as_ref(), size);
        let new = ask(&mut self.work, ctx, same, work);
        let again = new || !self.view.is_current();
        if let Some(answer) = self.work.answer().filter(|_| again) {
            self.view
                .set(answer.report(&ReportContext { name: "", scene }));
        }
    }

    /// Asks the question once; [`Self::receive`] takes the answer.
    pub fn start(&mut self, ctx: &Context, document: &Document, size: [u32; 2], question: Q) {
        self.work.start(
            Request::new(question, &document.scene, document.model.as_ref(), size),
            wake(ctx),
        );
    }

    /// Takes the answer to a question asked once by [`Self::start`].
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

    /// Returns whether the answer is about another model, or a scene that is not the `same` as the document's.
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

    /// Shows the state of the answer in a sentence with the next step, and returns whether to request the answer.
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

    /// Returns the latest answer with the scene that it is about.
    pub fn latest(&self) -> Option<(Box<dyn Answer>, Scene)> {
        Some((
            Box::new(self.work.answer()?.clone()),
            self.work.answered()?.subject().scene,
        ))
    }
}

/// Shows a part of a report that is neither a table nor a plot.
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

/// Shows buttons that save the answer of `analysis` in each of its formats, and copy it.
///
/// `answer` returns the answer with its scene. Returns whether a button was clicked.
pub fn export_ui(
    ui: &mut Ui,
    session: &mut Session,
    window: &mut WindowState,
    requests: &mut Requests,
    analysis: &'static str,
    answer: impl FnOnce() -> Option<(Box<dyn Answer>, Scene)>,
) -> bool {
    let Some(analysis) = Analysis::find(analysis) else {
        return false;
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
        return false;
    }
    let Some((answer, scene)) = answer() else {
        return true;
    };
    if let Some(format) = format {
        export(
            session,
            window,
            requests,
            analysis.name,
            format,
            answer,
            scene,
        );
    } else {
        let name = session.document().origin.name();
        let export = Export {
            answer,
            scene,
            name,
        };
        ui.ctx().copy_text(export.answer.text(&export.about()));
        session.notice = Some(text!("report-copied", name = analysis.name).into());
    }
    true
}

/// Asks where to save the answer of `analysis` to a question about `scene`.
pub fn export(
    session: &Session,
    window: &mut WindowState,
    requests: &mut Requests,
    analysis: &'static str,
    format: Format,
    answer: Box<dyn Answer>,
    scene: Scene,
) {
    let name = session.document().origin.name();
    window.own.put(Export {
        answer,
        scene,
        name,
    });
    requests.ask(Action::SaveAnswer(analysis, format));
}

/// Writes the answer that is about to be saved, in the format that the path's extension names.
pub fn save(session: &mut Session, window: &WindowState, path: &Path) -> Result<(), String> {
    let export = window
        .own
        .get::<Export>()
        .ok_or_else(|| text!("report-nothing-to-save").to_owned())?;
    let format =
        Format::from_path(path).ok_or_else(|| text!("report-unknown-ending").to_owned())?;
    let (answer, about) = (&*export.answer, export.about());
    let saved = save_answer(path, format, answer, &about, (None, Paper::LIGHT));
    saved.map_err(|error| error.to_string())?;
    let text = text!("report-saved", path = path.display().to_string());
    session.notice = Some(Notice::written(text, path));
    Ok(())
}
