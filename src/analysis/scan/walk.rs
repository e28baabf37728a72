//! Walking through the steps: by pixel, by edge, by line, forwards and back.

use super::{Crossing, Scan, ScanLine, ScanPixel, ScanSpan, ScanStep};
use glam::DVec2;
use serde::Serialize;

/// How large a step is. A larger one is also the beginning of smaller ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ScanLevel {
    Pixel,
    Edge,
    Line,
}

/// What stands at a step: the line, and of its span what has been found so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanPoint<'a> {
    pub level: ScanLevel,
    pub line: &'a ScanLine,
    pub span: Option<&'a ScanSpan>,
    pub p: Option<&'a Crossing>,
    pub q: Option<&'a Crossing>,
    pub pixel: Option<&'a ScanPixel>,
}

impl ScanStep {
    pub const fn level(self) -> ScanLevel {
        match self {
            Self::Line { .. } => ScanLevel::Line,
            Self::P { .. } | Self::Q { .. } => ScanLevel::Edge,
            Self::Pixel { .. } => ScanLevel::Pixel,
        }
    }

    pub const fn line(self) -> usize {
        match self {
            Self::Line { line } | Self::P { line, .. } | Self::Q { line, .. } | Self::Pixel { line, .. } => line,
        }
    }
}

impl Scan {
    /// The last step.
    pub fn last(&self) -> usize {
        self.steps.len().saturating_sub(1)
    }

    /// The next step that is as large as `level` or larger; the last one after all of these.
    pub fn forward(&self, from: usize, level: ScanLevel) -> usize {
        let after = self.steps.iter().enumerate().skip(from.saturating_add(1));
        after.into_iter().find(|(_, step)| step.level() >= level).map_or(self.last(), |(index, _)| index)
    }

    /// The step of that size before `from`; the first one before all of these.
    pub fn back(&self, from: usize, level: ScanLevel) -> usize {
        let before = &self.steps[..from.min(self.last())];
        before.iter().rposition(|step| step.level() >= level).unwrap_or(0)
    }

    /// What stands at step `step`, or at the last one.
    ///
    /// # Panics
    /// If there are no steps, which [`super::scan`] never returns.
    pub fn at(&self, step: usize) -> ScanPoint<'_> {
        let step = self.steps[step.min(self.last())];
        let line = &self.lines[step.line()];
        let bare = ScanPoint { level: step.level(), line, span: None, p: None, q: None, pixel: None };
        let span = |span: usize| &line.spans[span];
        match step {
            ScanStep::Line { .. } => bare,
            ScanStep::P { span: s, .. } => ScanPoint { span: Some(span(s)), p: Some(&span(s).p), ..bare },
            ScanStep::Q { span: s, .. } => {
                ScanPoint { span: Some(span(s)), p: Some(&span(s).p), q: Some(&span(s).q), ..bare }
            }
            ScanStep::Pixel { span: s, pixel, .. } => {
                let span = span(s);
                ScanPoint {
                    span: Some(span),
                    p: Some(&span.p),
                    q: Some(&span.q),
                    pixel: span.pixels.get(pixel),
                    ..bare
                }
            }
        }
    }

    /// The pixels shaded up to step `step` and with it, each with its row.
    pub fn filled(&self, step: usize) -> impl Iterator<Item = (u32, &ScanPixel)> {
        self.steps.iter().take(step.saturating_add(1)).filter_map(|step| match *step {
            ScanStep::Pixel { line, span, pixel } => {
                let line = &self.lines[line];
                Some((line.y, &line.spans[span].pixels[pixel]))
            }
            _ => None,
        })
    }

    /// The step that shades the pixel nearest to a place of the grid.
    pub fn step_near(&self, place: DVec2) -> usize {
        self.nearest(ScanLevel::Pixel, place)
    }

    /// The step of this scan that is most like step `step` of `other`, of the same polygon in another view.
    pub fn step_like(&self, other: &Self, step: usize) -> usize {
        let share = DVec2::new(f64::from(self.grid.columns), f64::from(self.grid.rows))
            / DVec2::new(f64::from(other.grid.columns), f64::from(other.grid.rows));
        let step = step.min(other.last());
        self.nearest(other.steps[step].level(), other.place_of(step) * share)
    }

    /// The step that begins line `y` of the grid, and the one that ends it.
    pub fn steps_of_line(&self, y: u32) -> Option<[usize; 2]> {
        let within = |step: &ScanStep| self.lines[step.line()].y == y;
        Some([self.steps.iter().position(within)?, self.steps.iter().rposition(within)?])
    }

    fn nearest(&self, level: ScanLevel, place: DVec2) -> usize {
        let steps = (0..self.steps.len()).filter(|step| self.steps[*step].level() == level);
        // Another line is farther than any pixel of this one.
        let far =
            |step: &usize| (self.place_of(*step) - place).abs().dot(DVec2::new(1.0, f64::from(self.grid.columns)));
        steps.min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
    }

    /// Where a step happens, in the grid.
    fn place_of(&self, step: usize) -> DVec2 {
        let point = self.at(step);
        let x = match (point.pixel, point.q, point.p) {
            (Some(pixel), _, _) => f64::from(pixel.x) + 0.5,
            (None, Some(found), _) | (None, None, Some(found)) => found.x,
            _ => 0.0,
        };
        DVec2::new(x, point.line.at())
    }
}
