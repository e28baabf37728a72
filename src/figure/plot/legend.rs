//! The legend: one line per curve, beside the plot or below it.

use super::canvas::PlotCanvas;
use crate::figure::area::Area;
use crate::figure::palette::Rgb8;
use crate::figure::text::width_of;
use glam::DVec2;

/// Length of a line's sample, and gaps after it and before the notes, in ems.
const SAMPLE: f64 = 2.9;
const GAPS: [f64; 2] = [0.6, 1.4];
/// Minimum gap before notes, in ems.
const LEAST_GAP: f64 = 0.5;
/// Height of a line, in ems.
const LINE: f64 = 1.4;
/// Maximum share of the width for a legend beside the plot, and minimum ratio of width to height for it.
const BESIDE: [f64; 2] = [0.4, 1.2];

/// Layout of the legend.
pub struct Legend {
    min: DVec2,
    /// Right edges of the columns of notes, from the left edge of the legend.
    columns: Vec<f64>,
    shown: bool,
}

impl Legend {
    /// Reserves space for the legend of a plot in `bounds`; returns the rest.
    pub fn new(canvas: &PlotCanvas<'_>, bounds: Area) -> (Self, Area) {
        let (plot, em) = (canvas.plot, canvas.em);
        let widest = |texts: &mut dyn Iterator<Item = &str>| {
            texts.map(|text| width_of(text, em)).fold(0.0, f64::max)
        };
        let mut width = (SAMPLE + GAPS[0]) * em
            + widest(&mut plot.curves.iter().map(|curve| curve.name.as_str()));
        let heads = plot.legend.iter().enumerate();
        let widths: Vec<f64> = heads
            .map(|(index, head)| {
                let notes = plot
                    .curves
                    .iter()
                    .filter_map(|curve| Some(curve.notes.get(index)?.as_str()));
                widest(&mut notes.chain([head.as_str()]))
            })
            .collect();
        // Where space is short, columns move together.
        let gap = (bounds.max.x - bounds.min.x - width - widths.iter().sum::<f64>())
            / widths.len().max(1) as f64;
        let gap = gap.clamp(LEAST_GAP * em, GAPS[1] * em);
        let mut columns = Vec::new();
        for column in widths {
            width += gap + column;
            columns.push(width);
        }
        // A single curve is named by the axis.
        if plot.curves.len() < 2 && columns.is_empty() {
            return (
                Self {
                    min: bounds.min,
                    columns,
                    shown: false,
                },
                bounds,
            );
        }
        let lines = (plot.curves.len() + usize::from(!plot.legend.is_empty())) as f64;
        let size = DVec2::new(width, LINE * em * lines);
        let whole = bounds.max - bounds.min;
        let beside = size.x <= BESIDE[0] * whole.x && whole.x >= BESIDE[1] * whole.y;
        let mut rest = bounds;
        let min = if beside {
            rest.max.x -= size.x + 1.6 * em;
            DVec2::new(
                bounds.max.x - size.x,
                bounds.min.y + (0.5 * (whole.y - size.y) - em).clamp(0.0, 3.0 * em),
            )
        } else {
            rest.max.y -= size.y + 0.5 * em;
            DVec2::new(bounds.min.x, bounds.max.y - size.y)
        };
        (
            Self {
                min,
                columns,
                shown: true,
            },
            rest,
        )
    }

    /// Draws the legend.
    pub fn draw(&self, canvas: &mut PlotCanvas<'_>) {
        if !self.shown {
            return;
        }
        let (em, paper, plot) = (canvas.em, canvas.paper, canvas.plot);
        let mut at = self.min + DVec2::new(0.0, em);
        if !plot.legend.is_empty() {
            self.cells(canvas, &plot.legend, at, 0.92, paper.weak);
            at.y += LINE * em;
        }
        for curve in &plot.curves {
            canvas.curve(
                curve,
                &[0.0, SAMPLE].map(|x| at + DVec2::new(x, -0.33) * em),
            );
            let name = at + DVec2::new((SAMPLE + GAPS[0]) * em, 0.0);
            canvas
                .text(&curve.name, name, 1.0, paper.letters(curve.ink), 0.0)
                .strong = curve.emphasised;
            self.cells(canvas, &curve.notes, at, 1.0, paper.text);
            at.y += LINE * em;
        }
    }

    fn cells(
        &self,
        canvas: &mut PlotCanvas<'_>,
        texts: &[String],
        at: DVec2,
        size: f64,
        colour: Rgb8,
    ) {
        for (right, text) in self.columns.iter().zip(texts) {
            canvas.text(text, at + DVec2::new(*right, 0.0), size, colour, 1.0);
        }
    }
}
