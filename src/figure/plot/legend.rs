//! The legend: a line a curve, beside the plot or below it.

use super::data::Plot;
use super::{PlotStyle, dashes};
use crate::figure::drawing::{Drawing, Shape, Text, width_of};
use crate::figure::labels::Area;
use glam::DVec2;

/// Length of a line's sample, and the gaps after it and before the notes, in ems.
const SAMPLE: f64 = 2.9;
const GAPS: [f64; 2] = [0.6, 1.4];
/// Height of a line, in ems.
const LINE: f64 = 1.4;
/// The share of the width that a legend beside the plot may take, and the least ratio of width to height for it.
const BESIDE: [f64; 2] = [0.4, 1.2];

/// Where the legend is.
pub struct Legend {
    min: DVec2,
    /// The right edges of the columns of notes, from the left edge of the legend.
    columns: Vec<f64>,
    shown: bool,
}

impl Legend {
    /// Finds room for the legend of `plot` in `room`; returns the rest.
    pub fn new(plot: &Plot, room: Area, style: &PlotStyle) -> (Self, Area) {
        let em = style.text;
        let widest = |texts: &mut dyn Iterator<Item = &str>| texts.map(|text| width_of(text, em)).fold(0.0, f64::max);
        let mut width = (SAMPLE + GAPS[0]) * em + widest(&mut plot.curves.iter().map(|curve| curve.name.as_str()));
        let mut columns = Vec::new();
        for (index, head) in plot.legend.iter().enumerate() {
            let notes = plot.curves.iter().filter_map(|curve| Some(curve.notes.get(index)?.as_str()));
            width += GAPS[1] * em + widest(&mut notes.chain([head.as_str()]));
            columns.push(width);
        }
        // One curve alone is what the axis says.
        if plot.curves.len() < 2 && columns.is_empty() {
            return (Self { min: room.min, columns, shown: false }, room);
        }
        let size = DVec2::new(width, LINE * em * lines(plot));
        let whole = room.max - room.min;
        let beside = size.x <= BESIDE[0] * whole.x && whole.x >= BESIDE[1] * whole.y;
        let mut rest = room;
        let min = if beside {
            rest.max.x -= size.x + 1.6 * em;
            DVec2::new(room.max.x - size.x, room.min.y + (0.5 * (whole.y - size.y) - em).clamp(0.0, 3.0 * em))
        } else {
            rest.max.y -= size.y + 0.5 * em;
            DVec2::new(room.min.x, room.max.y - size.y)
        };
        (Self { min, columns, shown: true }, rest)
    }

    /// Draws it.
    pub fn draw(&self, drawing: &mut Drawing, plot: &Plot, style: &PlotStyle) {
        if !self.shown {
            return;
        }
        let (em, paper) = (style.text, &style.paper);
        let names = self.min.x + (SAMPLE + GAPS[0]) * em;
        let mut baseline = self.min.y + em;
        let cells = |texts: &[String], baseline: f64, size: f64, colour| {
            let placed = self.columns.iter().zip(texts);
            let cell = |(right, text): (&f64, &String)| {
                Text::new(text, DVec2::new(self.min.x + right, baseline), size, colour).aligned(1.0)
            };
            placed.map(cell).collect::<Vec<_>>()
        };
        if !plot.legend.is_empty() {
            drawing.texts.extend(cells(&plot.legend, baseline, 0.92 * em, paper.weak));
            baseline += LINE * em;
        }
        for curve in &plot.curves {
            let middle = baseline - 0.33 * em;
            let ends = vec![DVec2::new(self.min.x, middle), DVec2::new(self.min.x + SAMPLE * em, middle)];
            let sample = Shape::line(ends, style.curve(curve.emphasised), paper.line(curve.ink));
            drawing.shapes.push(sample.dashed(dashes(curve.dash)));
            let colour = paper.letters(curve.ink);
            let strong = curve.emphasised;
            let name = Text::new(&curve.name, DVec2::new(names, baseline), em, colour);
            drawing.texts.push(Text { strong, ..name });
            drawing.texts.extend(cells(&curve.notes, baseline, em, paper.text));
            baseline += LINE * em;
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "a plot has few curves")]
fn lines(plot: &Plot) -> f64 {
    (plot.curves.len() + usize::from(!plot.legend.is_empty())) as f64
}
