//! The question for the scan of one polygon, and its report in words and numbers with the formulas filled in.

use super::{
    Carried, Crossing, Rule, Scan, ScanLine, ScanPixel, ScanSpan, corner_name, face_at,
    lay_out_scan, scan,
};
use crate::analysis::probe::clearest_pixel;
use crate::analysis::report::{
    Answer, Cell, Column, Figure, Part, Report, ReportContext, Table, as_it_is, cells,
};
use crate::analysis::{Question, Subject, Watch};
use crate::figure::{Paper, PlotStyle};
use crate::scene::Choice;
use crate::text::{fixed, text};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// Width and height of a figure in ems: its column of formulas must fit.
const EMS: DVec2 = DVec2::new(48.0, 37.0);
/// Number of edges beyond which a polygon's table holds only the active ones.
const MOST_EDGES: usize = 64;

/// The question for one polygon, step by step.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ScanQuestion {
    /// Index of the polygon in the mesh; without one, the polygon at the pixel.
    pub face: Option<u32>,
    /// The pixel; without one, the clearest pixel.
    pub pixel: Option<[u32; 2]>,
    /// Rows of enlarged pixels.
    pub rows: u32,
    /// The stop at which the scan is shown.
    pub stop: Stop,
}

/// The stop at which a scan is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Stop {
    /// The requested pixel, or one in the middle.
    #[default]
    Pixel,
    /// The step of this number, from 0.
    Step(usize),
    /// The end of a row of the grid.
    Line(u32),
    /// The end of the conversion.
    Last,
}

/// A scan, and the step that is shown.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanStop {
    /// The step, from 0.
    pub step: usize,
    /// The whole conversion.
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
                let [x, y] = self
                    .pixel
                    .unwrap_or_else(|| clearest_pixel(&mut renderer, scene).pixel);
                let seen = face_at(&mut renderer, scene, x, y);
                let expected = || text!("line-scan-error-background", x = x, y = y);
                let place = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                (seen.ok_or_else(expected)?, Some(place))
            }
        };
        let scan =
            scan(&mut renderer, scene, face, self.rows).map_err(|error| error.to_string())?;
        let last = scan.last();
        let step = match self.stop {
            Stop::Last => last,
            Stop::Step(step) if step <= last => step,
            Stop::Step(step) => {
                return Err(text!("line-scan-error-step", step = step, last = last));
            }
            Stop::Line(y) => {
                let [first, end] = [scan.lines.first(), scan.lines.last()]
                    .map(|line| line.map_or(0, |line| line.y));
                let expected = || text!("line-scan-error-line", y = y, first = first, last = end);
                scan.steps_of_line(y)
                    .map(|[_, end]| end)
                    .ok_or_else(expected)?
            }
            Stop::Pixel => {
                let place = place.map(|place| scan.grid.from_picture(place));
                scan.step_near(place.unwrap_or(0.5 * scan.grid.size()))
            }
        };
        Ok(ScanStop { step, scan })
    }
}

impl Answer for ScanStop {
    fn report(&self, _: &ReportContext<'_>) -> Report {
        let scan = &self.scan;
        let line = scan.at(self.step).line;
        let mut report = Report::new(text!(
            "line-scan-report-title",
            face = scan.face,
            corners = scan.corners.len(),
            mode = scan.mode.label(),
            what = scan.carried.words()
        ));
        report
            .section(text!("line-scan-edge-table-active"))
            .push(Part::Table(scan.edge_table(self.step)));
        report.section(text!(
            "line-scan-report-line",
            y = line.y,
            at = line.centre_y().to_string()
        ));
        let [first, last] = scan.steps_of_line(line.y).unwrap_or_default();
        for mix in (first..=last).filter_map(|step| scan.found(step).pop()) {
            let place = if mix.pixel.is_none() {
                format!(", x = {}", fixed(mix.x, 3))
            } else {
                String::new()
            };
            let section = report.section(mix.name.clone() + &place);
            for text in mix.lines(scan) {
                section.line(format!("  {}", text.replace('\t', ": ")));
            }
        }
        report
    }

    fn table(&self) -> Option<Table> {
        let columns = "y,x,p_x,q_x,alpha_p,alpha_q,alpha,value_r,value_g,value_b,barycentric_r,barycentric_g,barycentric_b";
        let mut table = Table::new(columns.split(',').map(Column::key));
        for line in &self.scan.lines {
            for ScanSpan { p, q, pixels } in &line.spans {
                table.rows.extend(pixels.iter().map(|pixel| {
                    let mut row = cells![line.y, pixel.x, p.x, q.x, p.alpha, q.alpha, pixel.alpha];
                    let colors = [pixel.intensity, pixel.barycentric];
                    row.extend(
                        colors
                            .into_iter()
                            .flat_map(|color| color.to_array().map(Cell::from)),
                    );
                    row
                }));
            }
        }
        Some(table)
    }

    fn value(&self, _: &ReportContext<'_>) -> Value {
        json!(self)
    }

    fn figure(
        &self,
        _: &ReportContext<'_>,
        size: Option<[u32; 2]>,
        paper: Paper,
    ) -> Option<Figure> {
        let size = DVec2::from_array(size.unwrap_or([1600, 1100]).map(f64::from));
        let text = (size / EMS).min_element().max(7.0);
        let style = PlotStyle {
            paper,
            text,
            titled: true,
        };
        let drawing = lay_out_scan(&self.scan, self.step, size, &style);
        let title = text!(
            "line-scan-alternative",
            caption = self.scan.caption(self.step)
        );
        Some(Figure::Drawing { drawing, title })
    }
}

/// The computation of P, Q or a pixel: one linear interpolation, with its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Mix<'a> {
    /// Name, such as `P on P₁P₂` or `Pixel (3, 4)`.
    pub name: String,
    /// The point in the formula: `P`, `Q`, or nothing for the pixel.
    pub of: &'static str,
    /// Names of the two points between which it lies, α = 0 first.
    pub ends: [String; 2],
    /// Coordinates of the first point, of the result, and of the second point: y on an edge, x on the scan line.
    pub places: [f64; 3],
    /// x of the result, pixels of the grid.
    pub x: f64,
    /// The share of the distance from the first point to the second, 0 to 1.
    pub alpha: f64,
    /// The interpolated values at the two points.
    pub values: [DVec3; 2],
    /// The result.
    pub value: DVec3,
    /// The result as stored in a picture, if it is an intensity.
    pub stored: Option<[u8; 3]>,
    /// The pixel that it is for; none for P and Q.
    pub pixel: Option<&'a ScanPixel>,
}

impl Mix<'_> {
    /// Describes the point and the meaning of α there.
    pub fn definition(&self) -> String {
        let [from, to] = &self.ends;
        match self.of {
            "P" => text!("line-scan-p", from = from.as_str(), to = to.as_str()),
            "Q" => text!("line-scan-q", from = from.as_str(), to = to.as_str()),
            _ => text!("line-scan-pixel-alpha").to_owned(),
        }
    }

    /// Formats the formula of α, `α = (y − y₁) / (y₂ − y₁)`: y on an edge, x on the scan line.
    pub fn alpha_formula(&self) -> String {
        if self.of.is_empty() {
            return "α = (x − x(P)) / (x(Q) − x(P))".to_owned();
        }
        let [from, to] = &self.ends;
        format!("α = (y − y({from})) / (y({to}) − y({from}))")
    }

    /// Formats α with its numbers, `α = (7.50 − 2.00) / (14.00 − 2.00) = 0.458`.
    pub fn alpha_text(&self) -> String {
        let [from, here, to] = self.places.map(|place| fixed(place, 2));
        format!(
            "α = ({here} − {from}) / ({to} − {from}) = {}",
            fixed(self.alpha, 3)
        )
    }

    /// Formats the interpolation, `I(P) = (1−α)·I(P₁) + α·I(P₂)`.
    pub fn formula(&self, letter: &str) -> String {
        let [a, b] = &self.ends;
        let of = if self.of.is_empty() {
            String::new()
        } else {
            format!("({})", self.of)
        };
        format!("{letter}{of} = (1−α)·{letter}({a}) + α·{letter}({b})")
    }

    /// Formats the interpolation with the numbers of one component.
    pub fn row(&self, component: usize) -> String {
        let bracketed = |value: f64| {
            let text = fixed(value, 4);
            if text.starts_with('−') {
                format!("({text})")
            } else {
                text
            }
        };
        let [a, b] = self.values.map(|value| bracketed(value[component]));
        let [rest, alpha] = [1.0 - self.alpha, self.alpha].map(|share| fixed(share, 3));
        format!(
            "{rest}·{a} + {alpha}·{b} = {}",
            fixed(self.value[component], 4)
        )
    }

    /// Returns all of its lines; a component's name ends at a tabulator.
    pub fn lines(&self, scan: &Scan) -> Vec<String> {
        let mut lines = vec![self.alpha_text()];
        if scan.carried == Carried::Constant {
            lines.push(format!("I = {}", triple(self.value)));
        } else {
            lines.push(self.formula(scan.carried.letter()));
            let components = scan.carried.components().into_iter().enumerate();
            lines.extend(components.map(|(index, name)| format!("{name}\t{}", self.row(index))));
        }
        let Some(pixel) = self.pixel else {
            return lines;
        };
        lines.extend(scan.intensity_words(pixel));
        lines.push(format!("{}:", scan.compared.name()));
        lines.push(format!("I = {}", triple(pixel.barycentric)));
        lines.push(text!(
            "line-scan-difference",
            values = triple(pixel.intensity - pixel.barycentric)
        ));
        let [r, g, b] = pixel.stored;
        lines.push(text!("line-scan-stored", r = r, g = g, b = b));
        lines
    }
}

impl Carried {
    /// Describes the interpolated quantity.
    pub fn words(self) -> &'static str {
        match self {
            Self::Constant => text!("line-scan-constant"),
            Self::Intensity => text!("line-scan-intensities"),
            Self::Normal => text!("line-scan-normals"),
        }
    }

    /// Returns the letter of the interpolated quantity.
    pub const fn letter(self) -> &'static str {
        if matches!(self, Self::Normal) {
            "N"
        } else {
            "I"
        }
    }

    /// Returns the names of its three components.
    pub const fn components(self) -> [&'static str; 3] {
        if matches!(self, Self::Normal) {
            ["x", "y", "z"]
        } else {
            ["r", "g", "b"]
        }
    }
}

impl Rule {
    /// Returns its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Affine => text!("line-scan-affine"),
            Self::Perspective => text!("line-scan-perspective"),
        }
    }
}

impl Scan {
    /// Returns the name of an edge by its corners, the upper one first.
    pub fn edge_name(&self, edge: usize) -> String {
        self.edges[edge].corners.map(corner_name).concat()
    }

    /// Returns the names of the edges that a line crosses.
    pub fn active_edges(&self, line: &ScanLine) -> String {
        let names = line.active.iter().map(|edge| self.edge_name(*edge));
        names.collect::<Vec<_>>().join(", ")
    }

    /// Returns the results up to a step on its scan line: P, Q and the pixel.
    pub fn found(&self, step: usize) -> Vec<Mix<'_>> {
        let point = self.at(step);
        let crossings = [("P", point.p), ("Q", point.q)].into_iter();
        let mut found: Vec<Mix<'_>> = crossings
            .filter_map(|(of, crossing)| Some(self.crossing_mix(point.line, crossing?, of)))
            .collect();
        if let (Some(ScanSpan { p, q, .. }), Some(pixel)) = (point.span, point.pixel) {
            let x = f64::from(pixel.x) + 0.5;
            found.push(Mix {
                name: text!("line-scan-pixel", x = pixel.x, y = point.line.y),
                of: "",
                ends: ["P".to_owned(), "Q".to_owned()],
                places: [p.x, x, q.x],
                x,
                alpha: pixel.alpha,
                values: [p.value, q.value],
                value: pixel.value,
                stored: Some(pixel.stored),
                pixel: Some(pixel),
            });
        }
        found
    }

    fn crossing_mix(&self, line: &ScanLine, crossing: &Crossing, of: &'static str) -> Mix<'_> {
        let edge = &self.edges[crossing.edge];
        Mix {
            name: text!(
                "line-scan-on-edge",
                letter = of,
                edge = self.edge_name(crossing.edge)
            ),
            of,
            ends: edge.corners.map(corner_name),
            places: [edge.y_top, line.centre_y(), edge.y_bottom],
            x: crossing.x,
            alpha: crossing.alpha,
            values: edge.corners.map(|corner| self.corners[corner].value),
            value: crossing.value,
            stored: crossing.stored,
            pixel: None,
        }
    }

    /// Describes a step in a phrase.
    pub fn caption(&self, step: usize) -> String {
        let line = self.at(step).line;
        match self.found(step).pop() {
            Some(mix) if mix.pixel.is_some() => mix.name,
            Some(mix) => text!("line-scan-at", y = line.y, what = mix.name),
            None => text!(
                "line-scan-crosses",
                y = line.y,
                edges = self.active_edges(line)
            ),
        }
    }

    /// Returns the lines that explain how a pixel gets its intensity from an interpolated normal, if there is one.
    pub fn intensity_words(&self, pixel: &ScanPixel) -> Vec<String> {
        if self.carried != Carried::Normal {
            return Vec::new();
        }
        let length = fixed(pixel.value.length(), 4);
        let words = if self.renormalise {
            text!("line-scan-renormalised", length = length)
        } else {
            text!("line-scan-not-renormalised", length = length)
        };
        vec![words, format!("I = {}", triple(pixel.intensity))]
    }

    /// Returns the table of results up to a step, with the pixel's value by barycentric interpolation.
    pub fn found_table(&self, step: usize) -> Table {
        let [a, b, c] = self.carried.components();
        let value = |head| Column::shown(head, |value| fixed(value, 3));
        let alpha = Column::shown("α", |value| fixed(value, 2));
        let name = Column::shown("", as_it_is);
        let mut table = Table::new([name, alpha, value(a), value(b), value(c)]);
        let mut row = |name: &str, alpha: Option<f64>, value: DVec3| {
            table
                .rows
                .push(cells![name, alpha, value.x, value.y, value.z]);
        };
        for mix in self.found(step) {
            let name = mix.pixel.map_or(mix.of, |_| text!("line-scan-row-pixel"));
            row(name, Some(mix.alpha), mix.value);
            let Some(pixel) = mix.pixel else { continue };
            if self.carried == Carried::Normal {
                row("I (r, g, b)", None, pixel.intensity);
            }
            row(text!("line-scan-row-barycentric"), None, pixel.barycentric);
            let difference = pixel.intensity - pixel.barycentric;
            row(text!("line-scan-row-difference"), None, difference);
        }
        table
    }

    /// Returns the table of edges, those that are active at a step marked.
    pub fn edge_table(&self, step: usize) -> Table {
        let active = &self.at(step).line.active;
        let columns = [
            "",
            text!("line-scan-edge"),
            text!("line-scan-y-from"),
            text!("line-scan-y-to"),
            text!("line-scan-x-from"),
            "dx/dy",
        ];
        let mut table = Table::new(columns.map(|head| Column::shown(head, |v| fixed(v, 2))));
        let many = self.edges.len() > MOST_EDGES;
        let edges = self.edges.iter().enumerate();
        for (index, edge) in edges.filter(|(index, _)| !many || active.contains(index)) {
            let mark = if active.contains(&index) { "●" } else { "" };
            table.rows.push(cells![
                mark,
                self.edge_name(index),
                edge.y_top,
                edge.y_bottom,
                edge.x_top,
                edge.dx_dy
            ]);
        }
        table
    }
}

fn triple(value: DVec3) -> String {
    value.to_array().map(|part| fixed(part, 4)).join(", ")
}
