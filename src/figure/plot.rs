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
    lay_out_column(std::slice::from_ref(plot), size, span, style).remove(0)
}

/// Lays out plots that stand below one another, each as [`lay_out_bare`] does. All leave the same space for the
/// numbers at the left.
pub fn lay_out_column(
    plots: &[Plot],
    size: DVec2,
    span: Option<[f64; 2]>,
    style: &PlotStyle,
) -> Vec<Drawing> {
    let whole = Area::from_size(size);
    let begun = plots.iter().map(|plot| {
        let mut drawing = Drawing::new(size, style.paper.ground);
        let bounds = PlotCanvas::new(&mut drawing, plot, style).heading(whole);
        (plot, drawing, bounds)
    });
    let begun: Vec<_> = begun.collect();
    let widths = begun
        .iter()
        .map(|(plot, _, bounds)| cartesian::labels_width(plot, bounds, style.text));
    let widest = widths.fold(0.0, f64::max);
    let draw = |(plot, mut drawing, bounds)| {
        let mut canvas = PlotCanvas::new(&mut drawing, plot, style);
        cartesian::draw(&mut canvas, bounds, widest, span);
        drawing
    };
    begun.into_iter().map(draw).collect()
}

/// Lays out several plots on one sheet of `size`, in order. Those over the same x axis leave the same space for the
/// numbers at the left.
pub fn lay_out_sheet(plots: &[Plot], size: DVec2, style: &PlotStyle) -> Drawing {
    let mut drawing = Drawing::new(size, style.paper.ground);
    let grid = paper::grid(plots.len(), size.x > size.y);
    let cell = size / grid;
    let begun = (0u32..).zip(plots).map(|(index, plot)| {
        let index = f64::from(index);
        let min = cell * DVec2::new(index % grid.x, (index / grid.x).floor());
        let mut canvas = PlotCanvas::new(&mut drawing, plot, style);
        let bounds = canvas.heading(Area {
            min,
            max: min + cell,
        });
        let (legend, bounds) = Legend::new(&canvas, bounds);
        (plot, legend, bounds)
    });
    let begun: Vec<_> = begun.collect();
    for (plot, legend, bounds) in &begun {
        let mut canvas = PlotCanvas::new(&mut drawing, plot, style);
        if plot.kind.is_polar() {
            polar::draw(&mut canvas, *bounds);
        } else {
            let alike = begun.iter().filter(|(other, ..)| other.x == plot.x);
            let widths =
                alike.map(|(other, _, bounds)| cartesian::labels_width(other, bounds, style.text));
            cartesian::draw(&mut canvas, *bounds, widths.fold(0.0, f64::max), None);
        }
        legend.draw(&mut canvas);
    }
    drawing
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::drawing::Scale;

    #[test]
    fn plots_over_the_same_axis_begin_at_the_same_place() {
        let plot = |low, high| {
            let axes = [Axis::new("x", 0.0, 80.0), Axis::new("y", low, high)];
            Plot::new(PlotKind::Profile, "", "", axes, vec![])
        };
        let plots = [plot(0.0, 1.0), plot(-0.0004, 0.0003), plot(0.0, 500.0)];
        let style = PlotStyle {
            paper: Paper::LIGHT,
            text: 12.0,
            titled: false,
        };
        let left = |scale: &Scale, column: f64| match scale {
            Scale::Cartesian { min, .. } => min.x - column,
            Scale::Polar { .. } => panic!("straight axes"),
        };
        let column = lay_out_column(&plots, DVec2::new(400.0, 200.0), None, &style);
        let lefts: Vec<f64> = column.iter().map(|one| left(&one.scales[0], 0.0)).collect();
        assert!(lefts.iter().all(|at| *at == lefts[1]), "{lefts:?}");
        let alone = lay_out_bare(&plots[0], DVec2::new(400.0, 200.0), None, &style);
        assert!(left(&alone.scales[0], 0.0) < lefts[1]);
        let sheet = lay_out_sheet(&plots, DVec2::new(800.0, 600.0), &style);
        let columns = sheet.scales.iter().zip([0.0, 400.0, 0.0]);
        let lefts: Vec<f64> = columns.map(|(scale, column)| left(scale, column)).collect();
        assert!(
            lefts.iter().all(|at| (at - lefts[1]).abs() < 1e-9),
            "{lefts:?}"
        );
    }
}
