//! What an analysis found, in the one form that the terminal, CSV, JSON, pictures and the window show.

mod table;

pub(crate) use table::cells;
pub use table::{Cell, Column, Table, as_it_is, fixed};

use super::Plot;
use crate::figure::{Drawing, Paper, PlotStyle, lay_out_sheet};
use crate::render::Frame;
use crate::scene::Scene;
use glam::DVec2;
use serde_json::Value;

/// What was analysed.
#[derive(Clone, Copy, Debug)]
pub struct About<'a> {
    /// What the scene is called.
    pub name: &'a str,
    pub scene: &'a Scene,
}

impl About<'_> {
    /// The name and the picture's size.
    pub fn heading(&self) -> String {
        let [width, height] = self.scene.image.size;
        format!("{}: {width}×{height}", self.name)
    }
}

/// What an analysis found.
pub trait Answer: Send + Sync {
    /// Words, numbers, tables and plots.
    fn report(&self, about: &About<'_>) -> Report;

    /// The object that `--json` prints.
    fn json(&self, about: &About<'_>) -> Value;

    /// The rows for a file, where they are more than the report shows.
    fn table(&self) -> Option<Table> {
        None
    }

    /// Pixels of a figure of so many plots, unless another size is asked for.
    fn figure_size(&self, plots: usize) -> [u32; 2] {
        [[1280, 800], [1920, 760], [1920, 1280]][plots.clamp(1, 3) - 1]
    }

    /// The figure; by default the plots of the report on one sheet. Nothing where there is nothing to draw.
    fn figure(&self, about: &About<'_>, size: Option<[u32; 2]>, paper: Paper) -> Option<Figure> {
        let report = self.report(about);
        let plots: Vec<Plot> = report.plots().cloned().collect();
        let size = size.unwrap_or_else(|| self.figure_size(plots.len()));
        let room = DVec2::from_array(size.map(f64::from));
        let titles: Vec<&str> = plots.iter().map(|plot| plot.title.as_str()).collect();
        let drawing = || lay_out_sheet(&plots, room, &PlotStyle::of(size, plots.len(), paper));
        (!plots.is_empty()).then(|| Figure::Drawing { drawing: drawing(), title: titles.join("; ") })
    }
}

/// A figure to be written.
#[derive(Clone, Debug)]
pub enum Figure {
    Drawing {
        drawing: Drawing,
        title: String,
    },
    /// Pixels alone, and the scene that they show, where it is one.
    Picture {
        frame: Frame,
        scene: Option<Box<Scene>>,
    },
}

/// Everything that is said about an analysis, in reading order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    pub title: String,
    pub sections: Vec<Section>,
    /// Why a command that asked fails, although there is an answer.
    pub failure: Option<String>,
}

/// A part of a report under a heading of its own, which may be empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    pub title: String,
    pub parts: Vec<Part>,
}

/// A piece of a report.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    Text(String),
    /// An explanation or a remark.
    Note(String),
    /// A number with its unit, and what it is.
    Quantity {
        value: String,
        name: String,
    },
    Table(Table),
    Plot(Box<Plot>),
}

impl Report {
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), ..Self::default() }
    }

    /// Begins a section.
    pub fn section(&mut self, title: impl Into<String>) -> &mut Section {
        self.sections.push(Section { title: title.into(), parts: Vec::new() });
        let last = self.sections.len() - 1;
        &mut self.sections[last]
    }

    fn parts(&self) -> impl Iterator<Item = &Part> {
        self.sections.iter().flat_map(|section| &section.parts)
    }

    pub fn plots(&self) -> impl Iterator<Item = &Plot> {
        self.parts().filter_map(|part| if let Part::Plot(plot) = part { Some(&**plot) } else { None })
    }
}

impl dyn Answer + '_ {
    /// The rows as CSV: the answer's own table, or that of the report which has keys, or the samples of all curves.
    pub fn csv(&self, about: &About<'_>) -> String {
        if let Some(table) = self.table() {
            return table.to_csv();
        }
        let report = self.report(about);
        let tables = report.parts().filter_map(|part| if let Part::Table(table) = part { Some(table) } else { None });
        tables
            .into_iter()
            .find(|table| table.has_keys())
            .map_or_else(|| samples(report.plots()).to_csv(), Table::to_csv)
    }

    /// The report for a terminal. One without a title is its table.
    pub fn text(&self, about: &About<'_>) -> String {
        let report = self.report(about);
        if report.title.is_empty() {
            return self.csv(about);
        }
        let sections: Vec<String> = report.sections.iter().map(Section::text).filter(|text| !text.is_empty()).collect();
        format!("{}\n\n{}", report.title, sections.join("\n")).trim_end().to_owned() + "\n"
    }
}

impl Section {
    pub fn line(&mut self, text: impl Into<String>) -> &mut Self {
        self.push(Part::Text(text.into()))
    }

    pub fn note(&mut self, text: impl Into<String>) -> &mut Self {
        self.push(Part::Note(text.into()))
    }

    pub fn quantity(&mut self, value: impl Into<String>, name: impl Into<String>) -> &mut Self {
        self.push(Part::Quantity { value: value.into(), name: name.into() })
    }

    pub fn push(&mut self, part: Part) -> &mut Self {
        self.parts.push(part);
        self
    }

    fn text(&self) -> String {
        let mut text = if self.title.is_empty() { String::new() } else { format!("{}\n", self.title) };
        for part in &self.parts {
            match part {
                Part::Text(line) | Part::Note(line) => text += &format!("{line}\n"),
                Part::Quantity { value, name } => text += &format!("  {value:>10}  {name}\n"),
                Part::Table(table) => text += &table.text(),
                Part::Plot(plot) => text += &plot_text(plot),
            }
        }
        text
    }
}

/// What a plot says, in words and numbers.
fn plot_text(plot: &Plot) -> String {
    let mut text = format!("{}\n  {}\n", plot.title, plot.note);
    if !plot.legend.is_empty() {
        let heads = plot.legend.iter().map(|head| Column::shown(head.clone(), as_it_is));
        let mut table = Table::new(std::iter::once(Column::shown("", as_it_is)).chain(heads));
        for curve in &plot.curves {
            table
                .rows
                .push(std::iter::once(&curve.name).chain(&curve.notes).map(|cell| cell.as_str().into()).collect());
        }
        text += &table.text();
    }
    text.extend(plot.marks.iter().map(|mark| format!("  {}\n", mark.label)));
    text.extend(plot.directions.iter().map(|arrow| format!("  {:20}{:11.1}° from N\n", arrow.letter, arrow.angle)));
    text
}

/// A row for each sample of each curve.
fn samples<'a>(plots: impl Iterator<Item = &'a Plot>) -> Table {
    let mut table = Table::new(["plot", "curve", "x", "y"].map(Column::key));
    for plot in plots {
        let kind = word(&plot.kind);
        for curve in &plot.curves {
            let name = curve.name.replace(", now", "");
            table.rows.extend(curve.points.iter().map(|[x, y]| cells![kind.as_str(), name.as_str(), *x, *y]));
        }
    }
    table
}

/// The word that stands for a choice in files.
pub fn word(choice: &impl serde::Serialize) -> String {
    serde_json::to_value(choice).ok().and_then(|word| word.as_str().map(str::to_owned)).unwrap_or_default()
}
