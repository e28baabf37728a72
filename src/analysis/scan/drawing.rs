//! Drawing of the scan line in slow motion: enlarged pixels, the polygon's outline, P and Q. The part α of an edge or
//! of a span, from its first end to the point found on it, is thick and yellow; the rest, 1−α, in the colour of text.

use super::{Crossing, Scan, ScanLevel, ScanPoint, corner_name};
use crate::figure::palette::{ALPHA, Rgb8, readable};
use crate::figure::{Area, Drawing, Paper, PlotStyle, Shape, Text};
use crate::scene::{Choice, ShadingMode};
use crate::text::text;
use glam::DVec2;

/// Margins about the outermost corners, in ems: for α at the sides, for names above and below.
const LETTERED: DVec2 = DVec2::new(2.5, 1.9);
/// Number of corners beyond which only a polygon's active edges are lettered.
const MOST_LETTERS: usize = 12;
/// Width of the column beside a wide figure, in ems, and height of the formulas below a narrow one.
const COLUMN: DVec2 = DVec2::new(19.5, 33.0);
/// Dashes of the scan line, in widths.
const LINE_DASHES: &[f32] = &[4.0, 3.0];
/// Minimum length of a lettered part of an edge, in ems.
const LETTERED_PART: f64 = 1.5;
/// Size of pixels, in ems, above which every share fits.
const ROOMY: f64 = 1.2;

/// Returns the size of the picture of `scan` in a width, no taller than `tallest`.
pub fn scan_room(scan: &Scan, width: f64, tallest: f64, style: &PlotStyle) -> DVec2 {
    let grid = scan.grid.size();
    let cell = (width - 2.0 * pad(width / grid.x, style.text).x) / grid.x;
    let height = cell * grid.y + 2.0 * pad(cell, style.text).y;
    DVec2::new(width, height.min(tallest))
}

/// Returns the margins beside and above a grid of such pixels, whose free rows and columns hold letters too.
fn pad(cell: f64, em: f64) -> DVec2 {
    (LETTERED * em - cell).max(DVec2::splat(0.3 * em))
}

/// Draws `scan` at step `step` in an area of `size`; with a title there is also a column with the formulas filled in.
pub fn lay_out_scan(scan: &Scan, step: usize, size: DVec2, style: &PlotStyle) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    let mut bounds = Area::from_size(size);
    if style.titled {
        bounds = draw_column(&mut drawing, scan, step, bounds, style);
    }
    let (grid, extent) = (scan.grid.size(), bounds.max - bounds.min);
    let natural = (extent / grid).min_element();
    let cell = (extent - 2.0 * pad(natural, style.text)) / grid;
    let cell = cell.min_element().max(0.0);
    let origin = (bounds.min + bounds.max - grid * cell) * 0.5;
    let (point, paper, em) = (scan.at(step), style.paper, style.text);
    let alpha = readable(ALPHA, paper.ground, 3.0);
    let mut canvas = ScanCanvas {
        scan,
        point,
        origin,
        cell,
        bounds,
        em,
        paper,
        alpha,
        drawing,
        taken: Vec::new(),
    };
    for (y, pixel) in scan.filled(step) {
        let square = canvas.square([pixel.x, y]).corners();
        canvas.push(Shape::area(square, pixel.stored));
    }
    canvas.grid_lines();
    let corners = scan.corners.iter().chain(scan.corners.first());
    let outline = corners.map(|corner| canvas.at(corner.place)).collect();
    canvas.cased(outline, 0.12, paper.weak);
    canvas.scan_line();
    canvas.active_edges();
    canvas.span();
    canvas.letters();
    canvas.drawing
}

/// Draws the title and the column of results so far; returns the area left for the picture.
fn draw_column(
    drawing: &mut Drawing,
    scan: &Scan,
    step: usize,
    bounds: Area,
    style: &PlotStyle,
) -> Area {
    let (em, paper) = (style.text, &style.paper);
    let mut rest = bounds.inset(em);
    let mode = match scan.mode {
        ShadingMode::Exact => ShadingMode::Phong,
        mode => mode,
    };
    let title = text!(
        "line-scan-figure-title",
        mode = mode.label(),
        face = scan.face
    );
    rest.min.y += 1.2 * em;
    let title = Text::new(title, rest.min, 1.25 * em, paper.text).bold();
    rest.min.y += 1.45 * em;
    let caption = Text::new(scan.caption(step), rest.min, em, paper.weak);
    drawing.texts.extend([title, caption]);
    rest.min.y += 0.7 * em;
    let (mut at, extent) = (rest.min, rest.max - rest.min);
    if extent.x > extent.y {
        at.x = rest.max.x - COLUMN.x * em;
        rest.max.x = at.x - em;
    } else {
        at.y = rest.max.y - COLUMN.y * em;
        rest.max.y = at.y - em;
    }
    at.y += 0.4 * em;
    let mut block = |swatch: Option<Rgb8>, heading: &str, lines: Vec<String>| {
        at.y += 1.1 * em;
        let mut heading = Text::new(heading, at, 1.05 * em, paper.text).bold();
        if let Some(colour) = swatch {
            let min = at + DVec2::new(0.0, -0.95) * em;
            let max = at + DVec2::new(1.5, 0.25) * em;
            let square = Area { min, max }.corners();
            let around = [&square[..], &[min]].concat();
            drawing.shapes.extend([
                Shape::area(square, colour),
                Shape::line(around, 0.06 * em, paper.weak),
            ]);
            heading.at.x += 2.0 * em;
        }
        drawing.texts.push(heading);
        for line in lines {
            at.y += 1.28 * em;
            // Text after a tabulator begins at the same place in every line.
            for (text, indent) in line.split('\t').zip([0.0, em]) {
                let place = at + DVec2::new(indent, 0.0);
                let text = Text::new(text, place, 0.88 * em, paper.text);
                drawing.texts.push(text);
            }
        }
        at.y += 0.75 * em;
    };
    let point = scan.at(step);
    if point.level == ScanLevel::Line {
        let lines = scan
            .edges
            .iter()
            .enumerate()
            .take(MOST_LETTERS)
            .map(|(index, edge)| {
                let mark = if point.line.active.contains(&index) {
                    text!("line-scan-active")
                } else {
                    ""
                };
                let slope = format!("{:.2}", edge.dx_dy).replace('-', "−");
                let row = text!(
                    "line-scan-edge-row",
                    edge = scan.edge_name(index),
                    top = format!("{:.2}", edge.y_top),
                    bottom = format!("{:.2}", edge.y_bottom),
                    slope = slope
                );
                format!("{row}  {mark}")
            });
        block(None, text!("line-scan-edge-table"), lines.collect());
    }
    for mix in scan.found(step) {
        block(mix.stored, &mix.name, mix.lines(scan));
    }
    rest
}

/// The picture being drawn: the position of the grid, and the areas of the labels.
struct ScanCanvas<'a> {
    scan: &'a Scan,
    point: ScanPoint<'a>,
    /// The top left corner of the grid.
    origin: DVec2,
    /// The side of a pixel.
    cell: f64,
    bounds: Area,
    em: f64,
    paper: Paper,
    /// Colour of the share α.
    alpha: Rgb8,
    drawing: Drawing,
    taken: Vec<Area>,
}

impl ScanCanvas<'_> {
    fn at(&self, place: DVec2) -> DVec2 {
        self.origin + place * self.cell
    }

    fn on_line(&self, x: f64) -> DVec2 {
        self.at(DVec2::new(x, self.point.line.centre_y()))
    }

    fn push(&mut self, shape: Shape) {
        self.drawing.shapes.push(shape);
    }

    fn square(&self, [x, y]: [u32; 2]) -> Area {
        let min = self.at(DVec2::new(f64::from(x), f64::from(y)));
        Area {
            min,
            max: min + self.cell,
        }
    }

    /// Returns the ends of an edge, the upper one first.
    fn ends(&self, edge: usize) -> [DVec2; 2] {
        self.scan.edges[edge]
            .corners
            .map(|corner| self.at(self.scan.corners[corner].place))
    }

    /// Draws a line, its width in ems.
    fn line(&mut self, points: Vec<DVec2>, width: f64, colour: Rgb8) {
        self.push(Shape::line(points, width * self.em, colour));
    }

    /// Draws a line set off from the lines that it crosses.
    fn cased(&mut self, points: Vec<DVec2>, width: f64, colour: Rgb8) {
        self.line(points.clone(), width + 0.16, self.paper.ground);
        self.line(points, width, colour);
    }

    /// Draws a dot set off from its background, its radii in ems.
    fn dot(&mut self, at: DVec2, [outer, inner]: [f64; 2], colour: Rgb8) {
        for (radius, colour) in [(outer, self.paper.ground), (inner, colour)] {
            self.push(Shape::disc(at, radius * self.em, colour));
        }
    }

    /// Draws text, its size in ems, on a patch at the first of `places` where it overlaps no other label; if there is
    /// none it is omitted, or at the first place if it `must` appear.
    fn label(&mut self, text: String, colour: Rgb8, size: f64, places: &[DVec2], must: bool) {
        let size = size * self.em;
        let text = Text::new(text, DVec2::ZERO, size, colour).bold();
        let half = DVec2::new(0.5 * text.width() + 0.15 * self.em, 0.6 * size);
        let (low, high) = (self.bounds.min + half, self.bounds.max - half);
        let about = |place: &DVec2| Area::about(place.max(low).min(high.max(low)), 2.0 * half);
        let free = |area: &Area| !self.taken.iter().any(|other| area.overlaps(other));
        let area = places
            .iter()
            .map(about)
            .find(free)
            .or_else(|| places.first().map(about).filter(|_| must));
        let Some(area) = area else { return };
        self.push(Shape::area(area.corners(), self.paper.ground).faded(0.78));
        let at = area.centre() + DVec2::new(0.0, 0.35 * size);
        self.drawing.texts.push(Text { at, ..text }.aligned(0.5));
        self.taken.push(area);
    }

    fn grid_lines(&mut self) {
        let grid = self.scan.grid;
        let width = (0.06 * self.em).min(0.12 * self.cell);
        let end = grid.size();
        let columns =
            (0..=grid.columns).map(|x| [DVec2::new(x.into(), 0.0), DVec2::new(x.into(), end.y)]);
        let rows =
            (0..=grid.rows).map(|y| [DVec2::new(0.0, y.into()), DVec2::new(end.x, y.into())]);
        for ends in columns.chain(rows) {
            let ends = ends.map(|place| self.at(place)).to_vec();
            self.push(Shape::line(ends, width, self.paper.grid));
        }
    }

    /// Draws the line through the centres of its pixels, with a dot at each centre.
    fn scan_line(&mut self) {
        let columns = self.scan.grid.columns;
        let ends = [0.0, f64::from(columns)].map(|x| self.on_line(x)).to_vec();
        let width = if self.point.level == ScanLevel::Line {
            0.16
        } else {
            0.1
        };
        self.line(ends.clone(), width + 0.12, self.paper.ground);
        let line = Shape::line(ends, width * self.em, self.paper.text);
        self.push(line.dashed(LINE_DASHES));
        if self.cell >= 0.8 * self.em {
            for x in 0..columns {
                let centre = self.on_line(f64::from(x) + 0.5);
                self.dot(centre, [0.17, 0.1], self.paper.text);
            }
        }
    }

    /// Draws the edges that the line crosses, those of the current span divided in the ratio α : 1−α.
    fn active_edges(&mut self) {
        let point = self.point;
        for &edge in &point.line.active {
            let [from, to] = self.ends(edge);
            self.cased(vec![from, to], 0.24, self.paper.text);
            let found = [point.p, point.q]
                .into_iter()
                .flatten()
                .find(|crossing| crossing.edge == edge);
            if let Some(crossing) = found {
                self.line(vec![from, self.on_line(crossing.x)], 0.3, self.alpha);
            }
        }
    }

    /// Draws the line from P to the current pixel and on to Q, and the pixel.
    fn span(&mut self) {
        let ScanPoint {
            p: Some(p),
            q: Some(q),
            pixel,
            line,
            ..
        } = self.point
        else {
            return;
        };
        let from = self.on_line(p.x);
        self.cased(vec![from, self.on_line(q.x)], 0.2, self.paper.text);
        let Some(pixel) = pixel else { return };
        let here = self.on_line(f64::from(pixel.x) + 0.5);
        self.line(vec![from, here], 0.26, self.alpha);
        let mut square = self.square([pixel.x, line.y]).corners();
        square.extend(square.first().copied());
        self.cased(square, 0.2, self.paper.text);
        self.dot(here, [0.3, 0.2], self.alpha);
    }

    /// Letters P and Q, the corners, and α beside the parts that it divides, in the order in which they are placed.
    fn letters(&mut self) {
        let point = self.point;
        if let Some(pixel) = point.pixel {
            self.taken.push(self.square([pixel.x, point.line.y]));
        }
        let found = [("P", -1.0, point.p), ("Q", 1.0, point.q)];
        let found = || {
            found
                .into_iter()
                .filter_map(|(letter, side, crossing)| Some((letter, side, crossing?)))
        };
        for (letter, side, crossing) in found() {
            let at = self.on_line(crossing.x);
            self.dot(at, [0.42, 0.3], self.alpha);
            // Clear of the edge's upper part, which is the important one.
            let leans = side * (self.scan.edges[crossing.edge].x_top - crossing.x) > 0.0;
            let rise = if leans { 0.85 } else { -0.85 };
            let beside =
                [rise, -rise, 0.0].map(|rise| at + DVec2::new(side * 1.15, rise) * self.em);
            self.label(letter.to_owned(), self.paper.text, 1.3, &beside, true);
        }
        self.corner_letters();
        for (_, side, crossing) in found() {
            self.edge_shares(crossing, side);
        }
        if let (Some(p), Some(q), Some(pixel)) = (point.p, point.q, point.pixel) {
            let [from, here, to] = [p.x, f64::from(pixel.x) + 0.5, q.x].map(|x| self.on_line(x));
            let away = DVec2::new(0.0, 0.5 * self.cell + 0.8 * self.em);
            self.share([from, here], away, pixel.alpha, true);
            self.share([here, to], away, 1.0 - pixel.alpha, false);
        }
    }

    fn corner_letters(&mut self) {
        let (scan, line) = (self.scan, self.point.line);
        let active = |corner: usize| {
            line.active
                .iter()
                .any(|&edge| scan.edges[edge].corners.contains(&corner))
        };
        let few = scan.corners.len() <= MOST_LETTERS;
        let sum: DVec2 = scan.corners.iter().map(|corner| corner.place).sum();
        let middle = self.at(sum / scan.corners.len().max(1) as f64);
        let corners = scan.corners.iter().enumerate();
        for (index, corner) in corners.filter(|(index, _)| few || active(*index)) {
            let at = self.at(corner.place);
            let outwards = (at - middle).normalize_or_zero();
            let colour = if active(index) {
                self.paper.text
            } else {
                self.paper.weak
            };
            self.push(Shape::disc(at, 0.22 * self.em, colour));
            let places = [-0.0f64, 0.7, -0.7, 1.4, -1.4].map(|turn| {
                at + DVec2::from_angle(turn).rotate(outwards) * DVec2::new(1.25, 1.05) * self.em
            });
            self.label(corner_name(index), colour, 1.05, &places, few);
        }
    }

    /// Letters α and 1−α beside the two parts of an edge.
    fn edge_shares(&mut self, crossing: &Crossing, side: f64) {
        let [top, bottom] = self.ends(crossing.edge);
        let at = self.on_line(crossing.x);
        let along = (bottom - top).normalize_or_zero();
        // Outwards, as far as the label's own extent requires.
        let outwards = DVec2::new(side * along.y, -side * along.x);
        let aside = outwards * (1.75 * outwards.x.abs() + 0.95 * outwards.y.abs()) * self.em;
        self.share([top, at], aside, crossing.alpha, true);
        // Once pixels are shaded, small pictures have space for α only.
        if self.point.pixel.is_none() || self.cell > ROOMY * self.em {
            self.share([at, bottom], aside, 1.0 - crossing.alpha, false);
        }
    }

    /// Draws the number of a part, beside its middle or on the other side, if the part is long enough.
    fn share(&mut self, [from, to]: [DVec2; 2], aside: DVec2, value: f64, alpha: bool) {
        if from.distance(to) < LETTERED_PART * self.em {
            return;
        }
        let (letter, colour) = if alpha {
            ("α ", readable(ALPHA, self.paper.ground, 4.5))
        } else {
            ("", self.paper.text)
        };
        let middle = (from + to) * 0.5;
        let text = format!("{letter}{value:.2}");
        let places = [middle + aside, middle - aside];
        self.label(text, colour, 0.95, &places, false);
    }
}
