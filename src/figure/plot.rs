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
mod sheet;

pub use axes::{magnitude, round_up, scientific, short, ticks};
pub use data::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Point, Tag};
pub use paper::{Paper, PlotStyle, dashes};

use super::area::Area;
use super::drawing::Drawing;
use glam::DVec2;
use legend::Legend;
use sheet::Sheet;

/// Lays `plot` out in a room of `size` (width, height).
pub fn lay_out(plot: &Plot, size: DVec2, style: &PlotStyle) -> Drawing {
    lay_out_sheet(std::slice::from_ref(plot), size, style)
}

/// Lays `plot` out without a legend, for a view that names the curves elsewhere. With a `span`, the axis of x begins and ends
/// exactly at these places of the room, whatever stands beside it.
pub fn lay_out_bare(
    plot: &Plot,
    size: DVec2,
    span: Option<[f64; 2]>,
    style: &PlotStyle,
) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    let mut sheet = Sheet::new(&mut drawing, plot, style);
    let room = sheet.heading(Area {
        min: DVec2::ZERO,
        max: size,
    });
    cartesian::draw(&mut sheet, room, span);
    drawing
}

/// Lays several plots out on one sheet of `size`, in their order.
pub fn lay_out_sheet(plots: &[Plot], size: DVec2, style: &PlotStyle) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    let grid = paper::grid(plots.len(), size.x > size.y);
    let cell = size / grid;
    for (index, plot) in (0u32..).zip(plots) {
        let index = f64::from(index);
        let min = cell * DVec2::new(index % grid.x, (index / grid.x).floor());
        let mut sheet = Sheet::new(&mut drawing, plot, style);
        let room = sheet.heading(Area {
            min,
            max: min + cell,
        });
        let (legend, room) = Legend::new(&sheet, room);
        if plot.kind.is_polar() {
            polar::draw(&mut sheet, room);
        } else {
            cartesian::draw(&mut sheet, room, None);
        }
        legend.draw(&mut sheet);
    }
    drawing
}
