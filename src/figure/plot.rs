//! Plots, laid out once as plain geometry and drawn by tiny-skia, as SVG text, or by the window. No curve is
//! distinguished by colour alone: each has its own dashes, and the legend names it.

mod axes;
mod canvas;
mod cartesian;
mod data;
mod legend;
mod paper;
mod polar;

pub use axes::{magnitude, round_up, scientific, short, ticks};
pub use data::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Point, Tag};
pub use paper::{Paper, PlotStyle, dashes};

use super::area::Area;
use super::drawing::Drawing;
use canvas::PlotCanvas;
use glam::DVec2;
use legend::Legend;

/// Lays out `plot` in an area of `size` (width, height).
pub fn lay_out(plot: &Plot, size: DVec2, style: &PlotStyle) -> Drawing {
    lay_out_sheet(std::slice::from_ref(plot), size, style)
}

/// Lays out `plot` without a legend, for a view that names the curves elsewhere. With a `span`, the x axis begins and
/// ends exactly at these positions in the area, whatever is beside it.
pub fn lay_out_bare(
    plot: &Plot,
    size: DVec2,
    span: Option<[f64; 2]>,
    style: &PlotStyle,
) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    let mut canvas = PlotCanvas::new(&mut drawing, plot, style);
    let bounds = canvas.heading(Area {
        min: DVec2::ZERO,
        max: size,
    });
    cartesian::draw(&mut canvas, bounds, span);
    drawing
}

/// Lays out several plots on one sheet of `size`, in order.
pub fn lay_out_sheet(plots: &[Plot], size: DVec2, style: &PlotStyle) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    let grid = paper::grid(plots.len(), size.x > size.y);
    let cell = size / grid;
    for (index, plot) in (0u32..).zip(plots) {
        let index = f64::from(index);
        let min = cell * DVec2::new(index % grid.x, (index / grid.x).floor());
        let mut canvas = PlotCanvas::new(&mut drawing, plot, style);
        let bounds = canvas.heading(Area {
            min,
            max: min + cell,
        });
        let (legend, bounds) = Legend::new(&canvas, bounds);
        if plot.kind.is_polar() {
            polar::draw(&mut canvas, bounds);
        } else {
            cartesian::draw(&mut canvas, bounds, None);
        }
        legend.draw(&mut canvas);
    }
    drawing
}
