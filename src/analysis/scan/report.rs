//! The scan of one polygon: how it is asked, and what it says in words and numbers.

use super::words::{number, triple};
use super::{Carried, Mix, Scan, ScanSpan, face_at, lay_out_scan, scan};
use crate::analysis::report::{About, Answer, Column, Figure, Part, Report, Section, Table, cells, fixed};
use crate::analysis::{Question, Subject, Watch, clearest_pixel};
use crate::figure::{Paper, PlotStyle};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// Ems to the height of a figure: its column of formulas must fit.
const LINES: f64 = 37.0;
/// Ems to its width.
const LETTERS: f64 = 48.0;

/// One polygon, step by step.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ScanQuestion {
    /// By its index in the mesh; otherwise the polygon at the pixel.
    pub face: Option<u32>,
    /// Otherwise the clearest one.
    pub pixel: Option<[u32; 2]>,
    /// Rows of enlarged pixels.
    pub rows: u32,
    pub stop: Stop,
}

/// Where the scan is looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Stop {
    /// At the pixel asked for, or one in the middle.
    #[default]
    Pixel,
    Step(usize),
    /// At the end of a row of the grid.
    Line(u32),
    Last,
}

/// A scan, and the step that is looked at.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanStop {
    pub step: usize,
    #[serde(flatten)]
    pub scan: Scan,
}

impl Question for ScanQuestion {
    type Answer = ScanStop;

    fn answer(&self, subject: &Subject, _: &dyn Watch<ScanStop>) -> Result<ScanStop, String> {
        let (mut renderer, scene) = (subject.renderer(), &subject.scene);
        let (face, place) = match self.face {
            Some(face) => (face, None),
            None => {
                let [x, y] = self.pixel.unwrap_or_else(|| clearest_pixel(&mut renderer, scene).pixel);
                let seen = face_at(&mut renderer, scene, x, y);
                let expected = || format!("pixel {x},{y} shows the background, expected one that shows the object");
                (seen.ok_or_else(expected)?, Some(DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5)))
            }
        };
        let scan = scan(&mut renderer, scene, face, self.rows).map_err(|error| error.to_string())?;
        Ok(ScanStop { step: self.step(&scan, place)?, scan })
    }
}

impl ScanQuestion {
    fn step(&self, scan: &Scan, place: Option<DVec2>) -> Result<usize, String> {
        let last = scan.last();
        match self.stop {
            Stop::Last => Ok(last),
            Stop::Step(step) if step <= last => Ok(step),
            Stop::Step(step) => Err(format!("--step {step}: no such step, expected 0 to {last} or last")),
            Stop::Line(y) => {
                let [first, end] = [scan.lines.first(), scan.lines.last()].map(|line| line.map_or(0, |line| line.y));
                let expected =
                    || format!("--line {y}: not a scan line of the polygon, expected {first} to {end} or last");
                scan.steps_of_line(y).map(|[_, end]| end).ok_or_else(expected)
            }
            Stop::Pixel => {
                let middle = DVec2::new(f64::from(scan.grid.columns), f64::from(scan.grid.rows)) * 0.5;
                Ok(scan.step_near(place.map_or(middle, |place| scan.grid.from_picture(place))))
            }
        }
    }
}

impl Answer for ScanStop {
    /// The edge table, and the scan line of the step with all its pixels.
    fn report(&self, _: &About<'_>) -> Report {
        let scan = &self.scan;
        let line = scan.at(self.step).line;
        let mode = format!("{:?}", scan.mode).to_lowercase();
        let title = format!("face {}, {} corners, {mode} shading, {}", scan.face, scan.corners.len(), scan.what());
        let mut report = Report::new(title);
        report.section("Edge table").push(Part::Table(scan.edge_table(self.step)));
        report.section(format!("scan line {}, centres at y = {}", line.y, line.at()));
        for span in &line.spans {
            for (of, crossing) in [("P", &span.p), ("Q", &span.q)] {
                let mix = scan.crossing_mix(line, crossing, of);
                let title = format!("{of} on {}, x = {}", scan.edge_name(crossing.edge), number(crossing.x, 3));
                write_mix(report.section(title), scan, &mix);
            }
            for pixel in &span.pixels {
                let section = report.section(format!("pixel ({}, {})", pixel.x, line.y));
                write_mix(section, scan, &scan.pixel_mix(span, pixel));
                scan.pixel_words(pixel).into_iter().for_each(|words| _ = section.line(format!("  {words}")));
            }
        }
        report
    }

    fn table(&self) -> Option<Table> {
        Some(pixel_table(&self.scan))
    }

    fn json(&self, _: &About<'_>) -> Value {
        json!(self)
    }

    fn figure(&self, _: &About<'_>, size: Option<[u32; 2]>, paper: Paper) -> Option<Figure> {
        let size = DVec2::from_array(size.unwrap_or([1600, 1100]).map(f64::from));
        let text = (size.x / LETTERS).min(size.y / LINES).max(7.0);
        let drawing = lay_out_scan(&self.scan, self.step, size, &PlotStyle { paper, text, titled: true });
        let title = format!("The scan line in slow motion: {}", self.scan.caption(self.step));
        Some(Figure::Drawing { drawing, title })
    }
}

/// Of polygons with more edges the table holds the active ones alone.
const MOST_EDGES: usize = 64;

impl Scan {
    /// What has been found up to a step on its scan line: P, Q and the pixel, with what barycentric interpolation gives it.
    pub fn found_table(&self, step: usize) -> Table {
        let point = self.at(step);
        let [a, b, c] = self.carried.components();
        let show = |value: f64| number(value, 4);
        let mut table = Table::new(["", "α", a, b, c].map(|head| Column::shown(head, show)));
        let mut row = |name: &str, alpha: Option<f64>, value: DVec3| {
            table.rows.push(cells![name, alpha, value.x, value.y, value.z]);
        };
        for (letter, crossing) in [("P", point.p), ("Q", point.q)] {
            if let Some(crossing) = crossing {
                let name = format!("{letter} on {}", self.edge_name(crossing.edge));
                row(&name, Some(crossing.alpha), crossing.value);
            }
        }
        if let Some(pixel) = point.pixel {
            row("pixel", Some(pixel.alpha), pixel.value);
            if self.carried == Carried::Normal {
                row("I (r, g, b)", None, pixel.intensity);
            }
            row("barycentric", None, pixel.barycentric);
            row("difference", None, pixel.intensity - pixel.barycentric);
        }
        table
    }

    /// The edges, those that are active at a step marked.
    pub fn edge_table(&self, step: usize) -> Table {
        let active = &self.at(step).line.active;
        let columns = ["edge", "y_top", "y_bottom", "x_top", "dx/dy", ""];
        let mut table = Table::new(columns.map(|head| Column::shown(head, fixed::<3>)));
        let many = self.edges.len() > MOST_EDGES;
        for (index, edge) in self.edges.iter().enumerate().filter(|(index, _)| !many || active.contains(index)) {
            let mark = if active.contains(&index) { "active" } else { "" };
            table.rows.push(cells![self.edge_name(index), edge.y_top, edge.y_bottom, edge.x_top, edge.dx_dy, mark]);
        }
        table
    }
}

/// The pixels, a row each.
fn pixel_table(scan: &Scan) -> Table {
    let columns = "y,x,p_x,q_x,alpha_p,alpha_q,alpha,value_r,value_g,value_b,barycentric_r,barycentric_g,barycentric_b";
    let mut table = Table::new(columns.split(',').map(Column::key));
    for line in &scan.lines {
        for ScanSpan { p, q, pixels } in &line.spans {
            table.rows.extend(pixels.iter().map(|pixel| {
                let [[r, g, b], [br, bg, bb]] = [pixel.intensity, pixel.barycentric].map(|color| color.to_array());
                cells![line.y, pixel.x, p.x, q.x, p.alpha, q.alpha, pixel.alpha, r, g, b, br, bg, bb]
            }));
        }
    }
    table
}

fn write_mix(section: &mut Section, scan: &Scan, mix: &Mix) {
    section.line(format!("  {}", mix.alpha_text()));
    if scan.carried == Carried::Constant {
        section.line(format!("  I = {}, the polygon's own", triple(mix.value, 4)));
        return;
    }
    section.line(format!("  {}", mix.formula(scan.carried.letter())));
    for (index, component) in scan.carried.components().into_iter().enumerate() {
        section.line(format!("  {component}: {}", mix.row(index)));
    }
}
