//! Curves over two straight axes.

use super::axes::ticks;
use super::canvas::PlotCanvas;
use super::data::{Axis, Mark, Plot, Point};
use crate::figure::area::{Area, clipped};
use crate::figure::drawing::Scale;
use crate::figure::text::width_of;
use crate::text::text;
use glam::DVec2;

/// Factor by which the y axis reaches beyond its largest value, so that a curve's top is visible.
const HEADROOM: f64 = 1.05;
/// Height of a row of labels above the plot, in ems.
const ROW: f64 = 1.35;
/// Minimum size of the area for the curves, in ems.
const LEAST: f64 = 3.0;
/// Minimum width of a plot with names on its curves, in ems.
const TAGGED: f64 = 20.0;
/// Minimum mean distance between borders with ticks, in ems.
const BORDER_GAP: f64 = 0.25;
/// Minimum mean distance between borders with lines of their own, in ems.
const LINE_GAP: f64 = 0.8;
const BORDER_DASHES: &[f32] = &[2.0, 4.0];
const MARK_DASHES: &[f32] = &[3.0, 3.0];
/// Radius of a point and of the hole in a ring, and the gap to its name, in ems.
const RADIUS: [f64; 2] = [0.3, 0.15];
const GAP: f64 = 0.2;
/// Size of the names of points, relative to other letters.
const LETTERS: f64 = 0.85;

/// Returns the y axis with its headroom, and its ticks in `bounds`.
fn y_axis(plot: &Plot, bounds: &Area, em: f64) -> (Axis, Vec<(f64, String)>) {
    let y = Axis {
        high: plot.y.low + (plot.y.high - plot.y.low) * HEADROOM,
        ..plot.y.clone()
    };
    let y_ticks = ticks(&y, (bounds.max.y - bounds.min.y) / (2.6 * em));
    (y, y_ticks)
}

/// Returns the width of the widest number beside the y axis of a plot in `bounds`.
pub fn labels_width(plot: &Plot, bounds: &Area, em: f64) -> f64 {
    let (_, y_ticks) = y_axis(plot, bounds, em);
    let widths = y_ticks.iter().map(|(_, text)| width_of(text, em));
    widths.fold(0.0, f64::max)
}

/// Draws axes, marks and curves in `bounds`, with space for numbers of the width `widest` beside the y axis; the x axis
/// over `span`, if given.
pub fn draw(canvas: &mut PlotCanvas<'_>, bounds: Area, widest: f64, span: Option<[f64; 2]>) {
    let (em, plot) = (canvas.em, canvas.plot);
    let (y, y_ticks) = y_axis(plot, &bounds, em);
    let mut area = Area {
        min: bounds.min + DVec2::new(widest + 0.6 * em, 0.0),
        max: bounds.max - DVec2::new(0.9 * em, 3.0 * em),
    };
    // If there is no space beside the axis, its numbers are inside.
    let inside = span.is_some_and(|[from, _]| from < area.min.x);
    let mut left = bounds.min.x;
    if let Some([from, to]) = span {
        (area.min.x, area.max.x) = (from, to);
        left = left.max(from - widest - 0.6 * em);
    }
    let rows = label_rows(plot, &area, left, em);
    area.min.y += ROW * em * (1.0 + rows.iter().copied().fold(0.0, f64::max));
    if (area.max - area.min).min_element() < LEAST * em {
        return;
    }
    let scale = Scale::Cartesian {
        min: area.min,
        max: area.max,
        x: [plot.x.low, plot.x.high],
        y: [y.low, y.high],
    };
    axes(canvas, &scale, &area, &y_ticks, inside);
    canvas.text(
        &plot.y.name,
        DVec2::new(left, area.min.y - 0.45 * em),
        1.0,
        canvas.paper.text,
        0.0,
    );
    let marks = plot.marks.iter().zip(&rows).map(|(mark, row)| {
        let (from, to) = label_span(mark, plot, &area, em);
        let label = DVec2::new(from, area.min.y - (0.45 + ROW * row) * em);
        (
            mark,
            label,
            to,
            if mark.probe {
                canvas.paper.text
            } else {
                canvas.paper.weak
            },
        )
    });
    let marks: Vec<_> = marks.collect();
    for (mark, label, _, colour) in &marks {
        let foot = scale.place([mark.x, y.low]);
        // A mark's line ends at the labels of others that it would cross.
        let crossed = marks
            .iter()
            .filter(|(_, at, to, _)| at.y > label.y && at.x < foot.x && foot.x < *to);
        let mut crossed: Vec<f64> = crossed.map(|(_, at, ..)| at.y).collect();
        crossed.sort_by(|a, b| b.total_cmp(a));
        let mut start = foot.y;
        let mut line = |from: f64, to: f64| {
            let ends = [from, to].map(|y| DVec2::new(foot.x, y));
            canvas.axis(ends[0], ends[1], *colour).dashes = MARK_DASHES;
        };
        for baseline in crossed {
            line(start, baseline + 0.25 * em);
            start = baseline - 0.9 * em;
        }
        line(start, label.y + 0.25 * em);
    }
    for (mark, label, _, colour) in marks {
        canvas
            .over_lines(&mark.label, label, 1.0, colour, 0.0)
            .strong = mark.probe;
    }
    borders(canvas, &scale, &area);
    // The scene's own curve is drawn over the others.
    for emphasised in [false, true] {
        for curve in plot
            .curves
            .iter()
            .filter(|curve| curve.emphasised == emphasised)
        {
            for run in clipped(curve.points.iter().map(|point| scale.place(*point)), &area) {
                canvas.curve(curve, &run.points);
            }
            let roomy = area.max.x - area.min.x >= TAGGED * em;
            if let Some(tag) = curve.tag.as_ref().filter(|_| roomy) {
                let at = scale.place(tag.at) + DVec2::new(-0.3, 0.3) * em;
                canvas.over_lines(&tag.text, at, 0.92, canvas.paper.letters(curve.ink), 1.0);
            }
        }
    }
    let around = area.inset(-1.0);
    for (mark, (index, value)) in plot
        .marks
        .iter()
        .flat_map(|mark| mark.values.iter().map(move |value| (mark, value)))
    {
        let at = scale.place([mark.x, *value]);
        let Some(curve) = plot.curves.get(*index).filter(|_| around.contains(at)) else {
            continue;
        };
        canvas.disc(at, 0.36, canvas.paper.ground);
        canvas.disc(at, 0.27, canvas.paper.line(curve.ink));
    }
    points(canvas, &scale, &area);
    canvas.drawing.scales.push(scale);
}

/// Returns each mark's row, 0 the lowest, such that its label overlaps neither others nor the y axis' name.
fn label_rows(plot: &Plot, area: &Area, left: f64, em: f64) -> Vec<f64> {
    let mut taken: Vec<(u32, f64, f64)> = vec![(0, left, left + width_of(&plot.y.name, em) + em)];
    for mark in &plot.marks {
        let (from, to) = label_span(mark, plot, area, em);
        let free = |row: &u32| {
            !taken
                .iter()
                .any(|(r, a, b)| r == row && *a < to + 0.6 * em && from < *b + 0.6 * em)
        };
        taken.push(((0..).find(free).unwrap_or(0), from, to));
    }
    taken
        .into_iter()
        .skip(1)
        .map(|(row, ..)| row.into())
        .collect()
}

/// Returns the extent of a mark's label: about its line, inside the plot.
fn label_span(mark: &Mark, plot: &Plot, area: &Area, em: f64) -> (f64, f64) {
    let share = (mark.x - plot.x.low) / (plot.x.high - plot.x.low);
    let width = width_of(&mark.label, em);
    let middle = area.min.x + share * (area.max.x - area.min.x);
    let from = (middle - 0.5 * width)
        .min(area.max.x + 0.9 * em - width)
        .max(area.min.x);
    (from, from + width)
}

fn axes(
    canvas: &mut PlotCanvas<'_>,
    scale: &Scale,
    area: &Area,
    y_ticks: &[(f64, String)],
    inside: bool,
) {
    let (em, paper, plot) = (canvas.em, canvas.paper, canvas.plot);
    for (value, text) in y_ticks {
        let at = scale.place([plot.x.low, *value]);
        canvas.axis(at, DVec2::new(area.max.x, at.y), paper.grid);
        let beside = at + DVec2::new(if inside { 0.3 } else { -0.45 }, 0.34) * em;
        if inside {
            canvas.over_lines(text, beside, 1.0, paper.weak, 0.0);
        } else {
            canvas.text(text, beside, 1.0, paper.weak, 1.0);
        }
    }
    for (value, text) in ticks(&plot.x, (area.max.x - area.min.x) / (3.4 * em)) {
        let at = scale.place([value, plot.y.low]);
        canvas.axis(at, DVec2::new(at.x, area.min.y), paper.grid);
        let half = 0.5 * width_of(&text, em);
        let below = DVec2::new(
            at.x.max(half).min(canvas.drawing.size.x - half),
            at.y + 1.3 * em,
        );
        canvas.text(text, below, 1.0, paper.weak, 0.5);
    }
    let corner = DVec2::new(area.min.x, area.max.y);
    canvas.axis(corner, area.max, paper.weak);
    canvas.axis(corner, area.min, paper.weak);
    let middle = DVec2::new(0.5 * (area.min.x + area.max.x), area.max.y + 2.65 * em);
    canvas.text(&plot.x.name, middle, 1.0, paper.text, 0.5);
}

/// Draws the edges between polygons: faint lines with ticks, or ticks alone, or a word where they crowd.
fn borders(canvas: &mut PlotCanvas<'_>, scale: &Scale, area: &Area) {
    let (em, weak, plot) = (canvas.em, canvas.paper.weak, canvas.plot);
    let places = plot.borders.iter().map(|x| scale.place([*x, plot.y.low]).x);
    let places: Vec<f64> = places
        .filter(|x| (area.min.x..=area.max.x).contains(x))
        .collect();
    let gap = (area.max.x - area.min.x) / (places.len() as f64 * em);
    if gap < BORDER_GAP {
        let words = text!("line-edges-crowded", count = places.len());
        canvas.over_lines(
            &words,
            area.max - DVec2::new(0.3, 0.5) * em,
            0.92,
            weak,
            1.0,
        );
        return;
    }
    for x in places {
        let foot = DVec2::new(x, area.max.y);
        if gap >= LINE_GAP {
            canvas.axis(foot, DVec2::new(x, area.min.y), weak).dashes = BORDER_DASHES;
        }
        canvas.axis(foot, foot - DVec2::new(0.0, 0.5 * em), weak);
    }
}

/// Draws single points, then the names for which there is a free place, those of the strong ones first.
fn points(canvas: &mut PlotCanvas<'_>, scale: &Scale, area: &Area) {
    let (em, paper) = (canvas.em, canvas.paper);
    let places = canvas
        .plot
        .points
        .iter()
        .map(|point| (point, scale.place(point.at)));
    let visible: Vec<(&Point, DVec2)> = places
        .filter(|(_, at)| at.is_finite() && area.contains(*at))
        .collect();
    for (point, at) in &visible {
        canvas.disc(*at, RADIUS[0] + 0.07, paper.ground);
        canvas.disc(*at, RADIUS[0], paper.line(point.ink));
        if point.hollow {
            canvas.disc(*at, RADIUS[1], paper.ground);
        }
    }
    let mut taken: Vec<Area> = visible
        .iter()
        .map(|(_, at)| Area::about(*at, DVec2::splat(2.0 * RADIUS[0] * em)))
        .collect();
    for strong in [true, false] {
        for (index, (point, at)) in visible
            .iter()
            .enumerate()
            .filter(|(_, (point, _))| point.strong == strong)
        {
            let size = LETTERS * em;
            let half = DVec2::new(0.5 * width_of(&point.name, size), 0.5 * size);
            let away = half + (RADIUS[0] + GAP) * em;
            let free = |place: &Area| {
                let clear = |(other, box_): (usize, &Area)| other == index || !place.overlaps(box_);
                area.holds(place) && taken.iter().enumerate().all(clear)
            };
            let sides = [
                [1.0, 0.0],
                [0.0, -1.0],
                [-1.0, 0.0],
                [0.0, 1.0],
                [0.8, -0.8],
                [0.8, 0.8],
                [-0.8, -0.8],
            ];
            let mut places = sides
                .map(|side| Area::about(*at + away * DVec2::from_array(side), 2.0 * half))
                .into_iter();
            let Some(place) = places.find(free) else {
                continue;
            };
            let baseline = place.centre() + DVec2::new(0.0, 0.34 * size);
            taken.push(place);
            canvas
                .over_lines(
                    &point.name,
                    baseline,
                    LETTERS,
                    paper.letters(point.ink),
                    0.5,
                )
                .strong = strong;
        }
    }
}
