//! R by projection: L drops onto N at N(N·L), and as far again on the other side lies R = 2N(N·L) − L.

use crate::analysis::overlay::Sketch;
use crate::figure::Shape;
use crate::figure::palette;
use glam::DVec3;

/// Side of the right angle's square, in unit vectors.
const SQUARE: f64 = 0.07;
/// Of the lines that complete the parallelogram.
const DASHES: &[f32] = &[4.0, 3.0];

/// Draws the projection of `l` on `n` and the parallelogram of L and R. Both are unit, and
/// `n`·`l` is positive.
pub(super) fn draw(sketch: &mut Sketch, n: DVec3, l: DVec3) {
    let foot = n * n.dot(l);
    let [at_l, at_r, at_foot, at_top] = [l, 2.0 * foot - l, foot, 2.0 * foot].map(|vector| sketch.end(vector));
    let (Some(at_l), Some(at_r), Some(at_foot), Some(at_top)) = (at_l, at_r, at_foot, at_top) else { return };
    let style = sketch.style;
    let width = 0.45 * style.line;
    let thin = |points| Shape::line(points, width, style.neutral);
    sketch.shapes.push(thin(vec![at_l, at_r]));
    sketch.shapes.push(thin(vec![at_l, at_top, at_r]).dashed(DASHES));
    sketch.shapes.push(thin(vec![sketch.origin, at_top]).dashed(DASHES));
    if let Some(across) = (l - foot).try_normalize().filter(|_| (l - foot).length() > 2.0 * SQUARE) {
        let corners = [foot + across * SQUARE, foot + (across - n) * SQUARE, foot - n * SQUARE];
        if let Some(corners) = corners.into_iter().map(|corner| sketch.end(corner)).collect() {
            sketch.shapes.push(thin(corners));
        }
    }
    sketch.shapes.push(Shape::disc(at_foot, 0.9 * style.line, palette::N));
}

/// Letters the foot.
pub(super) fn letter(sketch: &mut Sketch, n: DVec3, l: DVec3) {
    let foot = n * n.dot(l);
    let (Some(at_l), Some(at_foot)) = (sketch.end(l), sketch.end(foot)) else { return };
    let style = sketch.style;
    let aside = (at_foot - at_l).normalize_or_zero();
    sketch.letter("N(N·L)".into(), 0.8, palette::N, sketch.inside(at_foot, style.text), aside, 0.3 * style.text);
}
