//! The axes of a question about a curve, with the same layout in the window, on a worksheet and on a class's
//! sheet.

use crate::figure::{Axis, Drawing, Paper, Plot, PlotKind, PlotStyle, lay_out_bare};
use crate::text::text;
use glam::DVec2;

/// The size of the axes on a page, in CSS pixels; [`LETTERS`] is the size of their letters.
const SIZE: DVec2 = DVec2::new(598.0, 340.0);
const LETTERS: f64 = 13.0;

/// The axes of a curve that a question asks for.
#[derive(Clone, Debug)]
pub struct CurveAxes {
    plot: Plot,
}

impl CurveAxes {
    /// Creates axes with the given ranges and names of x and y; the names may contain the marks of formulas.
    pub fn new([x, y]: [[f64; 2]; 2], names: [&str; 2]) -> Self {
        let [x_name, y_name] = names.map(|name| name.trim().replace(['$', '`'], ""));
        let axes = [Axis::new(x_name, x[0], x[1]), Axis::new(y_name, y[0], y[1])];
        Self {
            plot: Plot::new(PlotKind::Question, "", "", axes, vec![]),
        }
    }

    /// Describes the axes for screen readers.
    pub fn words(&self) -> String {
        let [x, y] = [&self.plot.x, &self.plot.y].map(|axis| &*axis.name);
        text!("course-curve-area", x = x, y = y)
    }

    /// Lays out the axes within `size`.
    pub fn lay_out(&self, size: DVec2, style: &PlotStyle) -> Drawing {
        lay_out_bare(&self.plot, size, None, style)
    }

    /// Lays out the axes in the size used on pages.
    pub fn on_page(&self) -> Drawing {
        let style = PlotStyle {
            paper: Paper::LIGHT,
            text: LETTERS,
            titled: false,
        };
        self.lay_out(SIZE, &style)
    }
}
