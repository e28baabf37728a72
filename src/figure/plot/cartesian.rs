//! Curves over two straight axes.

mod points;

use super::data::{Axis, Curve, Mark, Plot};
use super::{PlotStyle, dashes, ticks};
use crate::figure::clip::clipped;
use crate::figure::drawing::{Drawing, Shape, Text, width_of};
use crate::figure::labels::Area;
use crate::figure::scale::Scale;
use glam::DVec2;
use points::points;

/// The axis of y reaches beyond its greatest value by this factor, so that a curve's top is seen.
const HEADROOM: f64 = 1.05;
/// Height of a row of labels above the plot, in ems.
const ROW: f64 = 1.35;
/// Least room for the curves, in ems.
const LEAST: f64 = 3.0;
/// Least width of a plot whose curves carry names, in ems.
const TAGGED: f64 = 20.0;
/// Samples nearer to the last one drawn than this are left out.
const THINNER: f64 = 0.4;
/// Least distance between borders that are drawn, in ems.
const BORDER_GAP: f64 = 0.2;
/// Least mean distance between borders that have lines of their own.
const LINE_GAP: f64 = 0.8;
/// Of those lines, in widths.
const BORDER_DASHES: &[f32] = &[2.0, 4.0];
/// Of the lines that mark values of x, in widths.
const MARK_DASHES: &[f32] = &[3.0, 3.0];

/// Draws axes, marks and curves in `room`.
pub fn draw(drawing: &mut Drawing, plot: &Plot, room: Area, style: &PlotStyle) {
    let em = style.text;
    let y = Axis { high: plot.y.low + (plot.y.high - plot.y.low) * HEADROOM, ..plot.y.clone() };
    let y_ticks = ticks(&y, (room.max.y - room.min.y) / (2.6 * em));
    let widest = y_ticks.iter().map(|(_, text)| width_of(text, em)).fold(0.0, f64::max);
    let mut area =
        Area { min: room.min + DVec2::new(widest + 0.6 * em, 0.0), max: room.max - DVec2::new(0.9 * em, 3.0 * em) };
    let rows = label_rows(plot, &area, room.min.x, em);
    let above = rows.iter().copied().max().unwrap_or(0);
    #[expect(clippy::cast_precision_loss, reason = "a plot has few marks")]
    let above = 1.0 + above as f64;
    area.min.y += ROW * em * above;
    if (area.max - area.min).min_element() < LEAST * em {
        return;
    }
    let scale = Scale::Cartesian { min: area.min, max: area.max, x: [plot.x.low, plot.x.high], y: [y.low, y.high] };
    axes(drawing, plot, &scale, &area, &y_ticks, style);
    let name = Text::new(&plot.y.name, DVec2::new(room.min.x, area.min.y - 0.45 * em), em, style.paper.text);
    drawing.texts.push(name);
    for (mark, row) in plot.marks.iter().zip(&rows) {
        let (from, _) = label_span(mark, plot, &area, em);
        let at = DVec2::new(from, area.min.y - (0.45 + ROW * *row as f64) * em);
        mark_line(drawing, mark, at, scale.place([mark.x, y.low]), style);
    }
    borders(drawing, plot, &scale, &area, style);
    // The scene's own curve over the others.
    for emphasised in [false, true] {
        for curve in plot.curves.iter().filter(|curve| curve.emphasised == emphasised) {
            draw_curve(drawing, curve, &scale, &area, style);
        }
    }
    for mark in &plot.marks {
        dots(drawing, plot, mark, &scale, &area, style);
    }
    points(drawing, plot, &scale, &area, style);
    drawing.scales.push(scale);
}

/// The row above the plot, 0 the lowest, in which each mark's label stands clear of the others and of y's name.
fn label_rows(plot: &Plot, area: &Area, left: f64, em: f64) -> Vec<usize> {
    let mut taken: Vec<(usize, f64, f64)> = vec![(0, left, left + width_of(&plot.y.name, em) + em)];
    let mut rows = Vec::new();
    for mark in &plot.marks {
        let (from, to) = label_span(mark, plot, area, em);
        let free = |row: &usize| !taken.iter().any(|(r, a, b)| r == row && *a < to + 0.6 * em && from < *b + 0.6 * em);
        let row = (0..).find(free).unwrap_or(0);
        taken.push((row, from, to));
        rows.push(row);
    }
    rows
}

/// Where a mark's label begins and ends: about its line, inside the plot.
fn label_span(mark: &Mark, plot: &Plot, area: &Area, em: f64) -> (f64, f64) {
    let share = (mark.x - plot.x.low) / (plot.x.high - plot.x.low);
    let width = width_of(&mark.label, em);
    let middle = area.min.x + share * (area.max.x - area.min.x);
    let from = (middle - 0.5 * width).min(area.max.x + 0.9 * em - width).max(area.min.x);
    (from, from + width)
}

fn axes(drawing: &mut Drawing, plot: &Plot, scale: &Scale, area: &Area, y_ticks: &[(f64, String)], style: &PlotStyle) {
    let (em, paper) = (style.text, &style.paper);
    let line = |a, b, colour| Shape::line(vec![a, b], style.axis(), colour);
    for (value, text) in y_ticks {
        let at = scale.place([plot.x.low, *value]);
        drawing.shapes.push(line(at, DVec2::new(area.max.x, at.y), paper.grid));
        let label = Text::new(text, at + DVec2::new(-0.45 * em, 0.34 * em), em, paper.weak);
        drawing.texts.push(label.aligned(1.0));
    }
    for (value, text) in ticks(&plot.x, (area.max.x - area.min.x) / (3.4 * em)) {
        let at = scale.place([value, plot.y.low]);
        drawing.shapes.push(line(at, DVec2::new(at.x, area.min.y), paper.grid));
        let label = Text::new(text, at + DVec2::new(0.0, 1.3 * em), em, paper.weak);
        drawing.texts.push(label.aligned(0.5));
    }
    let corner = DVec2::new(area.min.x, area.max.y);
    drawing.shapes.push(line(corner, area.max, paper.weak));
    drawing.shapes.push(line(corner, area.min, paper.weak));
    let middle = DVec2::new(0.5 * (area.min.x + area.max.x), area.max.y + 2.65 * em);
    drawing.texts.push(Text::new(&plot.x.name, middle, em, paper.text).aligned(0.5));
}

/// Where polygons meet: a faint line through the plot and a tick on the axis, unless they are too close to be told apart.
fn borders(drawing: &mut Drawing, plot: &Plot, scale: &Scale, area: &Area, style: &PlotStyle) {
    let places = plot.borders.iter().map(|x| scale.place([*x, plot.y.low]).x);
    #[expect(clippy::cast_precision_loss, reason = "far fewer borders than 2⁵³")]
    let roomy = area.max.x - area.min.x >= LINE_GAP * style.text * plot.borders.len() as f64;
    let mut last = f64::NEG_INFINITY;
    for x in places.filter(|x| (area.min.x..=area.max.x).contains(x)) {
        if x - last < BORDER_GAP * style.text {
            continue;
        }
        last = x;
        let line =
            |top: f64, colour| Shape::line(vec![DVec2::new(x, area.max.y), DVec2::new(x, top)], style.axis(), colour);
        if roomy {
            drawing.shapes.push(line(area.min.y, style.paper.weak).dashed(BORDER_DASHES));
        }
        drawing.shapes.push(line(area.max.y - 0.5 * style.text, style.paper.weak));
    }
}

/// The line of a mark from the axis up to its label at `label`.
fn mark_line(drawing: &mut Drawing, mark: &Mark, label: DVec2, foot: DVec2, style: &PlotStyle) {
    let colour = if mark.probe { style.paper.text } else { style.paper.weak };
    let ends = vec![foot, DVec2::new(foot.x, label.y + 0.25 * style.text)];
    drawing.shapes.push(Shape::line(ends, style.axis(), colour).dashed(MARK_DASHES));
    let text = Text::new(&mark.label, label, style.text, colour);
    drawing.texts.push(Text { strong: mark.probe, ..text.with_halo() });
}

fn draw_curve(drawing: &mut Drawing, curve: &Curve, scale: &Scale, area: &Area, style: &PlotStyle) {
    let colour = style.paper.line(curve.ink);
    for run in clipped(curve.points.iter().map(|point| scale.place(*point)), area) {
        let line = Shape::line(thinned(&run.points), style.curve(curve.emphasised), colour);
        drawing.shapes.push(line.dashed(dashes(curve.dash)));
    }
    let roomy = area.max.x - area.min.x >= TAGGED * style.text;
    if let Some(tag) = curve.tag.as_ref().filter(|_| roomy) {
        let at = scale.place(tag.at) + DVec2::new(-0.3, 0.3) * style.text;
        let text = Text::new(&tag.text, at, 0.92 * style.text, style.paper.letters(curve.ink));
        drawing.texts.push(text.with_halo().aligned(1.0));
    }
}

fn dots(drawing: &mut Drawing, plot: &Plot, mark: &Mark, scale: &Scale, area: &Area, style: &PlotStyle) {
    for (index, value) in &mark.values {
        let at = scale.place([mark.x, *value]);
        let inside = Area { min: area.min - 1.0, max: area.max + 1.0 }.holds(&Area { min: at, max: at });
        let Some(curve) = plot.curves.get(*index).filter(|_| inside) else { continue };
        drawing.shapes.push(Shape::disc(at, 0.36 * style.text, style.paper.ground));
        drawing.shapes.push(Shape::disc(at, 0.27 * style.text, style.paper.line(curve.ink)));
    }
}

/// A line without the points that nobody could see.
pub(super) fn thinned(points: &[DVec2]) -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for (index, point) in points.iter().enumerate() {
        let ends = index == 0 || index + 1 == points.len();
        if ends || kept.last().is_none_or(|last| last.distance(*point) >= THINNER) {
            kept.push(*point);
        }
    }
    kept
}
