//! Tools for drawing the parts of a plot.

use super::data::{Curve, Plot};
use super::paper::{Paper, PlotStyle, dashes};
use crate::figure::area::Area;
use crate::figure::drawing::{Drawing, Shape, Text};
use crate::figure::palette::Rgb8;
use crate::figure::text::width_of;
use glam::DVec2;

/// Width of the halo of a text that may be over lines, in its size.
const TEXT_HALO: f64 = 0.14;
/// Minimum distance of a sample from the last one drawn; nearer ones are omitted.
const THINNER: f64 = 0.4;

/// A plot being drawn. Sizes and widths are in ems.
pub struct PlotCanvas<'a> {
    pub drawing: &'a mut Drawing,
    pub plot: &'a Plot,
    pub style: &'a PlotStyle,
    pub em: f64,
    pub paper: Paper,
}

impl<'a> PlotCanvas<'a> {
    pub fn new(drawing: &'a mut Drawing, plot: &'a Plot, style: &'a PlotStyle) -> Self {
        Self {
            drawing,
            plot,
            style,
            em: style.text,
            paper: style.paper,
        }
    }

    pub fn line(&mut self, points: Vec<DVec2>, width: f64, colour: Rgb8) -> &mut Shape {
        self.push(Shape::line(points, width * self.em, colour))
    }

    /// Draws a thin line of the plot's frame.
    pub fn axis(&mut self, from: DVec2, to: DVec2, colour: Rgb8) -> &mut Shape {
        self.line(vec![from, to], 0.08, colour)
    }

    /// Draws a curve, or the sample of one, without the points too close to be seen.
    pub fn curve(&mut self, curve: &Curve, points: &[DVec2]) {
        let mut kept: Vec<DVec2> = Vec::new();
        for (index, point) in points.iter().enumerate() {
            let end = index == 0 || index + 1 == points.len();
            if end
                || kept
                    .last()
                    .is_none_or(|last| last.distance(*point) >= THINNER)
            {
                kept.push(*point);
            }
        }
        let width = if curve.emphasised { 0.19 } else { 0.125 };
        self.line(kept, width, self.paper.line(curve.ink)).dashes = dashes(curve.dash);
    }

    pub fn disc(&mut self, at: DVec2, radius: f64, colour: Rgb8) {
        self.push(Shape::disc(at, radius * self.em, colour));
    }

    pub fn push(&mut self, shape: Shape) -> &mut Shape {
        self.drawing.shapes.push_mut(shape)
    }

    /// Draws text whose share `align` lies to the left of `at`.
    pub fn text(
        &mut self,
        text: impl Into<String>,
        at: DVec2,
        size: f64,
        colour: Rgb8,
        align: f64,
    ) -> &mut Text {
        self.drawing
            .texts
            .push_mut(Text::new(text, at, size * self.em, colour).aligned(align))
    }

    /// Draws text with a halo, since it may be over lines.
    pub fn over_lines(
        &mut self,
        text: &str,
        at: DVec2,
        size: f64,
        colour: Rgb8,
        align: f64,
    ) -> &mut Text {
        let text = self.text(text, at, size, colour, align);
        text.halo = TEXT_HALO * text.size;
        text
    }

    /// Draws title and note; returns the area below them, with a margin on all sides.
    pub fn heading(&mut self, bounds: Area) -> Area {
        let (em, paper, plot) = (self.em, self.paper, self.plot);
        let margin = if self.style.titled { em } else { 0.0 };
        let mut rest = bounds.inset(margin);
        if self.style.titled {
            rest.min.y += 1.2 * em;
            self.text(&plot.title, rest.min, 1.25, paper.text, 0.0)
                .strong = true;
            rest.min.y += 0.35 * em;
        }
        for line in wrapped(&plot.note, rest.max.x - rest.min.x, 0.92 * em) {
            rest.min.y += 1.1 * em;
            self.text(line, rest.min, 0.92, paper.weak, 0.0);
            rest.min.y += 0.15 * em;
        }
        rest.min.y += 0.5 * em;
        rest
    }
}

/// Wraps `text` to lines of a width, at spaces and between Chinese characters, not before punctuation.
fn wrapped(text: &str, width: f64, size: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for piece in pieces(text) {
        let longer = lines.last().map(|line| format!("{line}{piece}"));
        match (
            longer.filter(|longer| width_of(longer.trim_end(), size) <= width),
            lines.last_mut(),
        ) {
            (Some(longer), Some(line)) => *line = longer,
            _ => lines.push(piece.to_owned()),
        }
    }
    lines
        .iter()
        .map(|line| line.trim_end().to_owned())
        .collect()
}

/// Returns the pieces of a text that stay in one line: words with the space after them, and Chinese characters.
fn pieces(text: &str) -> Vec<&str> {
    let chinese = |c: char| ('\u{2E80}'..='\u{9FFF}').contains(&c);
    let ends = |c: char| "，。；：、）」』？！".contains(c);
    let opens = |c: char| "（「『".contains(c);
    let mut cuts = vec![0];
    let characters: Vec<(usize, char)> = text.char_indices().collect();
    for pair in characters.windows(2) {
        let ((_, before), (at, after)) = (pair[0], pair[1]);
        let between = (chinese(before) || ends(before) || chinese(after)) && after != ' ';
        if before == ' ' || (between && !ends(after) && !opens(before)) {
            cuts.push(at);
        }
    }
    cuts.push(text.len());
    cuts.windows(2)
        .map(|cut| &text[cut[0]..cut[1]])
        .filter(|piece| !piece.is_empty())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_broken_at_spaces_and_between_chinese_characters() {
        assert_eq!(pieces("a word, 2 more"), ["a ", "word, ", "2 ", "more"]);
        assert_eq!(
            pieces("越好。RMS 是（均方根）"),
            ["越", "好。", "RMS ", "是", "（均", "方", "根）"]
        );
        let lines = wrapped("one two three four", 5.0 * 14.0, 14.0);
        assert!(
            lines.len() > 1 && lines.join(" ") == "one two three four",
            "{lines:?}"
        );
    }
}
