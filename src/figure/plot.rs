//! Plots, laid out once as plain geometry and drawn by tiny-skia, as SVG text, or by the window.
//!
//! A [`Plot`] and the room for it come in, a [`Drawing`] comes out: lines, areas and lines of text with their places. No
//! curve is told apart by colour alone: each has dashes of its own, and the legend names it.

mod axes;
mod cartesian;
mod data;
mod legend;
mod paper;
mod polar;

pub use axes::short;
pub use data::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Point, Tag};
pub use paper::{Paper, PlotStyle};

use super::drawing::{Drawing, Text, width_of};
use super::labels::Area;
use axes::ticks;
use glam::DVec2;
use legend::Legend;
use paper::{dashes, grid};

/// Lays `plot` out in a room of `size` (width, height).
pub fn lay_out(plot: &Plot, size: DVec2, style: &PlotStyle) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    fill(&mut drawing, plot, Area { min: DVec2::ZERO, max: size }, style);
    drawing
}

/// Lays several plots out on one sheet of `size`, in their order.
pub fn lay_out_sheet(plots: &[Plot], size: DVec2, style: &PlotStyle) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    let grid = grid(plots.len(), size.x > size.y);
    let cell = size / grid;
    for (index, plot) in (0u32..).zip(plots) {
        let index = f64::from(index);
        let min = cell * DVec2::new(index % grid.x, (index / grid.x).floor());
        fill(&mut drawing, plot, Area { min, max: min + cell }, style);
    }
    drawing
}

fn fill(drawing: &mut Drawing, plot: &Plot, room: Area, style: &PlotStyle) {
    let room = heading(drawing, plot, room, style);
    let (legend, room) = Legend::new(plot, room, style);
    if plot.kind.is_polar() {
        polar::draw(drawing, plot, room, style);
    } else {
        cartesian::draw(drawing, plot, room, style);
    }
    legend.draw(drawing, plot, style);
}

/// Title and note; returns the room below them, with a margin on all sides.
fn heading(drawing: &mut Drawing, plot: &Plot, room: Area, style: &PlotStyle) -> Area {
    let em = style.text;
    let margin = if style.titled { em } else { 0.0 };
    let mut rest = Area { min: room.min + margin, max: room.max - margin };
    let width = rest.max.x - rest.min.x;
    if style.titled {
        rest.min.y += 1.2 * em;
        drawing.texts.push(Text::new(&plot.title, rest.min, 1.25 * em, style.paper.text).bold());
        rest.min.y += 0.35 * em;
    }
    for line in wrapped(&plot.note, width, 0.92 * em) {
        rest.min.y += 1.1 * em;
        drawing.texts.push(Text::new(line, rest.min, 0.92 * em, style.paper.weak));
        rest.min.y += 0.15 * em;
    }
    rest.min.y += 0.5 * em;
    rest
}

/// `text` in lines no wider than `width`, broken at spaces.
fn wrapped(text: &str, width: f64, size: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match (longer.filter(|longer| width_of(longer, size) <= width), lines.last_mut()) {
            (Some(longer), Some(line)) => *line = longer,
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_broken_at_spaces_only_where_it_must_be() {
        assert_eq!(wrapped("one two", 1000.0, 10.0), ["one two"]);
        assert_eq!(wrapped("one two", 1.0, 10.0), ["one", "two"]);
        assert!(wrapped("", 10.0, 10.0).is_empty());
    }
}
