//! Where the defects of interpolated shading are in the picture.

use crate::analysis::Defects;
use crate::analysis::overlay::{OverlayOptions, Style};
use crate::figure::{Shape, Text};
use glam::DVec2;
use tiny_skia::PixmapMut;

/// A defect that has a place.
#[derive(Clone, Debug, PartialEq)]
pub struct DefectMark {
    /// A distance between two places, or twice the same place; pixels.
    pub ends: [DVec2; 2],
    pub label: String,
    /// Which way from the second end the label stands, a unit vector.
    pub way: DVec2,
}

/// Shorter distances are not seen, pixels.
const LEAST: f64 = 0.05;
/// Smaller jumps are roundings, a quarter of a code value.
const LEAST_JUMP: f64 = 1e-3;
/// A distance shorter than this is pointed at by an arrow, in letters.
const SHORT: f64 = 0.3;

/// The marks of what was measured: the outline's greatest distance, and the greatest jump at an unshared vertex.
pub fn defect_marks(defects: &Defects) -> Vec<DefectMark> {
    let mut marks = Vec::new();
    if let Ok(silhouette) = defects.silhouette.as_ref()
        && silhouette.greatest > LEAST
    {
        let ends = [silhouette.polygon, silhouette.surface];
        let way = (ends[1] - ends[0]).normalize_or(DVec2::X);
        marks.push(DefectMark { ends, label: format!("{:.1} px", silhouette.greatest), way });
    }
    if let Ok(shared) = defects.shared_vertices.as_ref()
        && shared.greatest > LEAST_JUMP
    {
        let label = format!("jump {:.3}", shared.greatest);
        marks.push(DefectMark { ends: [shared.at; 2], label, way: DVec2::NEG_Y });
    }
    marks
}

impl DefectMark {
    /// The lines of the mark, for letters of `em` pixels: a distance between two ticks, an arrow to a short one, or nothing
    /// about a place, which is ringed.
    pub fn lines(&self, em: f64) -> Vec<[DVec2; 2]> {
        let [a, b] = self.ends;
        if a == b {
            return vec![];
        }
        let tick = 0.45 * em * self.way.perp();
        if a.distance(b) >= SHORT * em {
            return vec![[a, b], [a - tick, a + tick], [b - tick, b + tick]];
        }
        let tip = b + 0.15 * em * self.way;
        let back = |side: f64| tip + 0.35 * em * self.way + 0.5 * side * tick;
        vec![[tip, tip + em * self.way], [tip, back(1.0)], [tip, back(-1.0)]]
    }

    /// Radius of the ring about a place.
    pub fn ring(&self, em: f64) -> Option<f64> {
        (self.ends[0] == self.ends[1]).then_some(0.75 * em)
    }

    /// The middle of the label.
    pub fn label_at(&self, em: f64) -> DVec2 {
        // Words are wider than high.
        self.ends[1] + DVec2::new(1.9 * em, 1.6 * em) * self.way
    }
}

/// Draws the marks of `defects` over the picture in which they were measured.
pub fn draw_defects(pixmap: &mut PixmapMut<'_>, defects: &Defects, options: &OverlayOptions) {
    let style = Style::new(f64::from(pixmap.width().min(pixmap.height())), options);
    let em = style.text;
    for mark in defect_marks(defects) {
        let lines = mark.lines(em).into_iter().map(|line| Shape::line(line.to_vec(), 0.8 * style.line, style.neutral));
        let ring = mark.ring(em).map(|radius| Shape::ring(mark.ends[0], radius, 0.8 * style.line, style.neutral));
        let mut drawing = style.drawing(lines.chain(ring).collect());
        let text = Text::centred(&mark.label, mark.label_at(em), em, style.neutral);
        drawing.texts.push(Text { halo: style.halo, ..text });
        drawing.draw(pixmap);
    }
}
