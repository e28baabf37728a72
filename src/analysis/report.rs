//! The result of an analysis in the one form that the terminal, CSV, JSON, pictures and the window show.
//!
//! A report for people is in the current language: it is made from messages of the catalogue when it is shown.
//! Programs read the keys of columns and the words of choices, which are in the code; any text in CSV and JSON is
//! English.

mod csv;

use crate::figure::{Drawing, Paper, Plot, PlotStyle, lay_out_sheet};
use crate::render::Frame;
use crate::scene::Scene;
use crate::text::{Language, in_language, text};
use glam::DVec2;
use serde_json::Value;
use std::borrow::Cow;
use std::fmt::Debug;

/// The name and the scene that a report mentions beside the answer.
#[derive(Clone, Copy, Debug)]
pub struct ReportContext<'a> {
    /// Name of the scene.
    pub name: &'a str,
    /// The scene.
    pub scene: &'a Scene,
}

impl ReportContext<'_> {
    /// Returns the name, if there is one, and the picture's size.
    pub fn heading(&self) -> String {
        let [width, height] = self.scene.image.size;
        if self.name.is_empty() {
            return format!("{width}×{height}");
        }
        format!("{}: {width}×{height}", self.name)
    }
}

/// The result of an analysis.
pub trait Answer: Debug + Send + Sync {
    /// Returns text, numbers, tables and plots, in the current language.
    fn report(&self, about: &ReportContext<'_>) -> Report;

    /// Returns the object of [`Self::object`] with its words in the current language.
    fn value(&self, about: &ReportContext<'_>) -> Value;

    /// Returns the rows for a file, where they are more than the report shows.
    fn table(&self) -> Option<Table> {
        None
    }

    /// Returns the default size in pixels of a figure with `plots` plots.
    fn figure_size(&self, plots: usize) -> [u32; 2] {
        [[1280, 800], [1920, 760], [1920, 1280]][plots.clamp(1, 3) - 1]
    }

    /// Returns the figure; by default the plots of the report on one sheet. Returns none if there is nothing to draw.
    fn figure(
        &self,
        about: &ReportContext<'_>,
        size: Option<[u32; 2]>,
        paper: Paper,
    ) -> Option<Figure> {
        let plots: Vec<Plot> = self.report(about).plots().cloned().collect();
        let size = size.unwrap_or_else(|| self.figure_size(plots.len()));
        let extent = DVec2::from_array(size.map(f64::from));
        let titles: Vec<&str> = plots.iter().map(|plot| plot.title.as_str()).collect();
        let title = titles.join("; ");
        let drawing = || lay_out_sheet(&plots, extent, &PlotStyle::of(size, plots.len(), paper));
        (!plots.is_empty()).then(|| Figure::Drawing {
            drawing: drawing(),
            title,
        })
    }

    /// Returns the rows as CSV: the answer's own table, or that of the report which has keys, or the samples of all
    /// curves.
    fn csv(&self, about: &ReportContext<'_>) -> String {
        in_language(Language::English, || {
            self.table()
                .unwrap_or_else(|| self.report(about).rows())
                .to_csv()
        })
    }

    /// Returns the object that programs read, whatever the language.
    fn object(&self, about: &ReportContext<'_>) -> Value {
        in_language(Language::English, || self.value(about))
    }

    /// Returns that object as text, as `--json` prints it. JSON has no infinity; it becomes null.
    fn json(&self, about: &ReportContext<'_>) -> String {
        format!("{:#}\n", self.object(about))
    }

    /// Returns the report for a terminal. One without a title is its table.
    fn text(&self, about: &ReportContext<'_>) -> String {
        let report = self.report(about);
        if report.title.is_empty() {
            self.csv(about)
        } else {
            report.text()
        }
    }
}

/// A figure to write to a file.
#[derive(Clone, Debug)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the variants tell what their fields are")]
pub enum Figure {
    /// Lines and texts, with a title for file formats that have a place for it.
    Drawing { drawing: Drawing, title: String },
    /// A picture, with the scene that it shows if it is one.
    Picture {
        frame: Frame,
        scene: Option<Box<Scene>>,
    },
}

/// The complete report of an analysis, in reading order.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Title of the report.
    pub title: String,
    /// The sections in reading order.
    pub sections: Vec<Section>,
    /// Reason why the command fails although there is an answer.
    pub failure: Option<String>,
}

/// A part of a report under its own heading, which may be empty.
#[derive(Clone, Debug, Default)]
pub struct Section {
    /// Heading of the section; may be empty.
    pub title: String,
    /// The parts in reading order.
    pub parts: Vec<Part>,
}

/// A piece of a report.
#[derive(Clone, Debug)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the variants tell what their fields are")]
pub enum Part {
    /// One or more sentences.
    Text(String),
    /// An explanation or a remark.
    Note(String),
    /// A number with its unit, as text, and its name.
    Quantity { value: String, name: String },
    /// A table with headed columns.
    Table(Table),
    /// Curves.
    Plot(Box<Plot>),
}

impl Report {
    /// Creates a report without sections.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            ..Self::default()
        }
    }

    /// Begins a section.
    pub fn section(&mut self, title: impl Into<String>) -> &mut Section {
        self.sections.push_mut(Section {
            title: title.into(),
            parts: Vec::new(),
        })
    }

    fn parts(&self) -> impl Iterator<Item = &Part> {
        self.sections.iter().flat_map(|section| &section.parts)
    }

    /// Returns all plots in reading order.
    pub fn plots(&self) -> impl Iterator<Item = &Plot> {
        self.parts().filter_map(|part| match part {
            Part::Plot(plot) => Some(&**plot),
            _ => None,
        })
    }

    /// Returns the first table with keys, or else the samples of all curves.
    fn rows(&self) -> Table {
        let mut tables = self.parts().filter_map(|part| match part {
            Part::Table(table) => Some(table),
            _ => None,
        });
        let own = tables.find(|table| table.columns.iter().any(|column| column.key.is_some()));
        own.map_or_else(|| samples(self.plots()), Table::clone)
    }

    fn text(&self) -> String {
        let sections: Vec<String> = self
            .sections
            .iter()
            .map(Section::text)
            .filter(|text| !text.is_empty())
            .collect();
        format!("{}\n\n{}", self.title, sections.join("\n"))
            .trim_end()
            .to_owned()
            + "\n"
    }
}

impl Section {
    /// Adds a sentence.
    pub fn line(&mut self, text: impl Into<String>) -> &mut Self {
        self.push(Part::Text(text.into()))
    }

    /// Adds a remark.
    pub fn note(&mut self, text: impl Into<String>) -> &mut Self {
        self.push(Part::Note(text.into()))
    }

    /// Adds a number with its unit, and its name.
    pub fn quantity(&mut self, value: impl Into<String>, name: impl Into<String>) -> &mut Self {
        self.push(Part::Quantity {
            value: value.into(),
            name: name.into(),
        })
    }

    /// Adds a part.
    pub fn push(&mut self, part: Part) -> &mut Self {
        self.parts.push(part);
        self
    }

    fn text(&self) -> String {
        let mut text = if self.title.is_empty() {
            String::new()
        } else {
            format!("{}\n", self.title)
        };
        for part in &self.parts {
            match part {
                Part::Text(line) | Part::Note(line) => text += &format!("{line}\n"),
                Part::Quantity { value, name } => {
                    text += &format!(
                        "  {}{value}  {name}\n",
                        " ".repeat(10_usize.saturating_sub(columns_of(value)))
                    );
                }
                Part::Table(table) => text += &table.text(),
                Part::Plot(plot) => text += &plot_text(plot),
            }
        }
        text
    }
}

fn plot_text(plot: &Plot) -> String {
    let mut text = format!("{}\n  {}\n", plot.title, plot.note);
    if !plot.legend.is_empty() {
        let heads = plot
            .legend
            .iter()
            .map(|head| Column::shown(head.clone(), as_it_is));
        let mut table = Table::new(std::iter::once(Column::shown("", as_it_is)).chain(heads));
        for curve in &plot.curves {
            let cells = std::iter::once(&curve.name).chain(&curve.notes);
            table
                .rows
                .push(cells.map(|cell| cell.as_str().into()).collect());
        }
        text += &table.text();
    }
    text.extend(plot.marks.iter().map(|mark| format!("  {}\n", mark.label)));
    let from = text!("report-from-normal");
    text.extend(plot.directions.iter().map(|arrow| {
        let angle = format!("{}°", text::fixed(arrow.angle, 1));
        format!("  {:20}{angle:>12} {from}\n", arrow.letter)
    }));
    text
}

fn samples<'a>(plots: impl Iterator<Item = &'a Plot>) -> Table {
    let mut table = Table::new(["plot", "curve", "x", "y"].map(Column::key));
    for plot in plots {
        let kind = word(&plot.kind);
        for curve in &plot.curves {
            table.rows.extend(
                curve
                    .points
                    .iter()
                    .map(|[x, y]| cells![kind.as_str(), curve.key.as_str(), *x, *y]),
            );
        }
    }
    table
}

/// Returns the word that represents a choice in files.
pub fn word(choice: &impl serde::Serialize) -> String {
    serde_json::to_value(choice)
        .ok()
        .and_then(|word| word.as_str().map(str::to_owned))
        .unwrap_or_default()
}

/// A table; a column may be for people, for files, or for both.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// The columns, from the left.
    pub columns: Vec<Column>,
    /// The rows; each has a cell for every column.
    pub rows: Vec<Vec<Cell>>,
    /// True if its rows can be chosen in the window.
    pub to_choose: bool,
}

/// A column.
#[derive(Clone, Debug)]
pub struct Column {
    /// Name in files; none if it is not written to files.
    pub key: Option<Cow<'static, str>>,
    /// Heading for people; none if it is not shown to them.
    pub head: Option<Cow<'static, str>>,
    /// Number format for people; files have all digits.
    pub show: fn(f64) -> String,
    /// True if the column can be omitted where space is short.
    pub extra: bool,
}

/// A column with the function that returns its cell for each row.
pub type Filled<T> = (Column, fn(&T) -> Cell);

/// The content of a cell.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Cell {
    /// No value is known or defined.
    Empty,
    /// A word or a sentence.
    Text(String),
    /// A number; files have it with all its digits.
    Number(f64),
    /// A whole number.
    Count(u64),
}

/// Makes a row of cells.
macro_rules! cells {
    ($($cell:expr),* $(,)?) => { vec![$($crate::analysis::report::Cell::from($cell)),*] };
}
pub(crate) use cells;

/// Makes a table with a row for each of some values: for each column, the cell of a value.
macro_rules! table_of {
    ($value:ident in $values:expr; $($column:expr => $cell:expr;)*) => {
        $crate::analysis::report::Table::from_rows($values, [$(($column, |$value| $cell.into())),*])
    };
}
pub(crate) use table_of;

/// Formats a number with as many digits as it has.
pub fn as_it_is(value: f64) -> String {
    value.to_string()
}

/// Formats a number with a fixed number of decimals.
pub fn fixed<const DECIMALS: usize>(value: f64) -> String {
    format!("{value:.DECIMALS$}")
}

/// Formats a number with digits in groups of three.
pub fn grouped(value: u64) -> String {
    let digits = value.to_string();
    let groups = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(String::from_utf8_lossy);
    groups.collect::<Vec<_>>().join("\u{2009}")
}

impl Column {
    /// Creates a column for files.
    pub fn key(key: impl Into<Cow<'static, str>>) -> Self {
        Self {
            key: Some(key.into()),
            head: None,
            show: as_it_is,
            extra: false,
        }
    }

    /// Creates a column for people.
    pub fn shown(head: impl Into<Cow<'static, str>>, show: fn(f64) -> String) -> Self {
        Self {
            key: None,
            head: Some(head.into()),
            show,
            extra: false,
        }
    }

    /// Creates a column for both files and people.
    pub fn both(
        key: &'static str,
        head: impl Into<Cow<'static, str>>,
        show: fn(f64) -> String,
    ) -> Self {
        Self {
            key: Some(key.into()),
            ..Self::shown(head, show)
        }
    }

    /// Makes the column one that is omitted where space is short.
    pub fn extra(self) -> Self {
        Self {
            extra: true,
            ..self
        }
    }
}

impl Table {
    /// Creates a table without rows.
    pub fn new(columns: impl IntoIterator<Item = Column>) -> Self {
        Self {
            columns: columns.into_iter().collect(),
            ..Self::default()
        }
    }

    /// Creates a table with a row for each of `rows`; every column provides its cell.
    pub fn from_rows<T, const N: usize>(rows: &[T], columns: [Filled<T>; N]) -> Self {
        let rows = rows
            .iter()
            .map(|row| columns.iter().map(|(_, cell)| cell(row)).collect())
            .collect();
        Self {
            columns: columns.into_iter().map(|(column, _)| column).collect(),
            rows,
            to_choose: false,
        }
    }

    /// Makes the table's rows ones that can be chosen.
    pub fn to_choose(self) -> Self {
        Self {
            to_choose: true,
            ..self
        }
    }

    /// Returns the headings for people, the rows, and which columns are numbers, without the last `left_out` optional
    /// ones.
    pub fn for_people(&self, left_out: usize) -> (Vec<&str>, Vec<Vec<String>>, Vec<bool>) {
        let mut extras = self.columns.iter().filter(|column| column.extra).count();
        let mut kept = |column: &Column| {
            let place = extras;
            extras -= usize::from(column.extra);
            !column.extra || place > left_out
        };
        let all = self.columns.iter().enumerate();
        let shown: Vec<_> = all
            .filter(|(_, column)| kept(column) && column.head.is_some())
            .collect();
        let heads = shown
            .iter()
            .filter_map(|(_, column)| column.head.as_deref())
            .collect();
        let cell = |row: &[Cell], (index, column): &(usize, &Column)| match row.get(*index) {
            Some(Cell::Text(text)) => text.clone(),
            Some(Cell::Number(value)) => (column.show)(*value),
            Some(Cell::Count(count)) => count.to_string(),
            Some(Cell::Empty) | None => "–".to_owned(),
        };
        let rows = self
            .rows
            .iter()
            .map(|row| shown.iter().map(|column| cell(row, column)).collect())
            .collect();
        let text = |index: usize| {
            self.rows
                .iter()
                .any(|row| matches!(row.get(index), Some(Cell::Text(_))))
        };
        (
            heads,
            rows,
            shown.iter().map(|(index, _)| !text(*index)).collect(),
        )
    }

    /// Formats the table for a terminal; empty where no column is for people.
    pub fn text(&self) -> String {
        let (heads, rows, numbers) = self.for_people(0);
        let heads: Vec<String> = heads.into_iter().map(str::to_owned).collect();
        let lines = || {
            std::iter::once(&heads)
                .filter(|heads| heads.iter().any(|head| !head.is_empty()))
                .chain(&rows)
        };
        let width = |column: usize| {
            lines()
                .map(|line| columns_of(&line[column]))
                .max()
                .unwrap_or(0)
        };
        let widths: Vec<usize> = (0..heads.len()).map(width).collect();
        let mut text = String::new();
        for line in lines().filter(|line| !line.is_empty()) {
            let mut row = String::new();
            for ((cell, width), number) in line.iter().zip(&widths).zip(&numbers) {
                let blank = " ".repeat(width - columns_of(cell));
                row += &if *number {
                    format!("  {blank}{cell}")
                } else {
                    format!("  {cell}{blank}")
                };
            }
            text += row.trim_end();
            text.push('\n');
        }
        text
    }

    /// Formats the columns with keys, with all digits, as CSV (RFC 4180).
    pub fn to_csv(&self) -> String {
        let kept = || {
            let columns = self.columns.iter().enumerate();
            columns.filter_map(|(index, column)| Some((column.key.as_deref()?, index)))
        };
        let field = |cell: Option<&Cell>| match cell {
            Some(Cell::Text(text)) => csv::field(text),
            Some(Cell::Number(value)) => value.to_string(),
            Some(Cell::Count(count)) => count.to_string(),
            Some(Cell::Empty) | None => String::new(),
        };
        let line = |fields: Vec<String>| fields.join(",") + "\n";
        let head = line(kept().map(|(key, _)| csv::field(key)).collect());
        let row = |row: &Vec<Cell>| line(kept().map(|(_, index)| field(row.get(index))).collect());
        let rows = self.rows.iter().map(row);
        head + &rows.collect::<String>()
    }
}

/// Returns the number of terminal columns that a text takes: Chinese characters and their punctuation take two each.
fn columns_of(text: &str) -> usize {
    let wide = |c: char| matches!(c, '\u{2E80}'..='\u{A4CF}' | '\u{AC00}'..='\u{D7A3}' | '\u{F900}'..='\u{FAFF}' | '\u{FE30}'..='\u{FE4F}' | '\u{FF01}'..='\u{FF60}');
    text.chars().map(|c| 1 + usize::from(wide(c))).sum()
}

/// Implements the conversion of values that a cell holds unchanged.
macro_rules! into_cell {
    ($($type:ty: $value:ident => $cell:expr,)*) => {
        $(impl From<$type> for Cell {
            fn from($value: $type) -> Self {
                $cell
            }
        })*
    };
}

into_cell! {
    f64: value => Self::Number(value),
    u32: count => Self::Count(count.into()),
    u64: count => Self::Count(count),
    usize: count => Self::Count(count as u64),
    &str: text => Self::Text(text.to_owned()),
    String: text => Self::Text(text),
}

impl<T: Into<Self>> From<Option<T>> for Cell {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Empty, Into::into)
    }
}
