//! The arrows.

use super::{Arrow, ArrowHead};
use crate::analysis::overlay::Sketch;
use crate::figure::Shape;
use crate::figure::palette::Vector;
use glam::{DVec2, DVec3};

/// Within this sine of the line of sight (ten degrees) an arrow has no length to speak of and shows its head from the
/// front or from behind.
const HEAD_ON: f64 = 0.17;
/// Width of the arrows of lights that are not emphasised.
const SUBORDINATE: f64 = 0.55;

/// A vector to be drawn.
pub(super) struct Given {
    pub vector: Vector,
    pub light: Option<usize>,
    pub direction: DVec3,
    /// The letter with its number; empty for none.
    pub name: String,
    pub emphasised: bool,
}

/// Draws arrows from the probe's point, the point's ring and their letters.
pub(super) fn draw(sketch: &mut Sketch, given: Vec<Given>) -> Vec<Arrow> {
    let ring = sketch.style.ring;
    let mut circles = vec![(sketch.origin, ring)];
    let mut arrows = Vec::new();
    for Given { vector, light, direction, name, emphasised } in given {
        if !direction.is_finite() || direction == DVec3::ZERO {
            continue;
        }
        let Some(tip) = sketch.end(direction) else { continue };
        let slant = sketch.slant(direction);
        let head = match (slant.abs() < HEAD_ON, slant.is_sign_positive()) {
            (false, _) => ArrowHead::Plain,
            (true, true) => ArrowHead::Towards,
            (true, false) => ArrowHead::Away,
        };
        let arrow = Arrow { vector, light, tail: sketch.origin, tip, head, emphasised };
        match head {
            ArrowHead::Plain => plain(sketch, &arrow, name),
            ArrowHead::Towards | ArrowHead::Away => head_on(sketch, &arrow, name, &mut circles),
        }
        arrows.push(arrow);
    }
    let point = Shape::ring(sketch.origin, ring, 0.5 * sketch.style.line, sketch.style.neutral);
    sketch.shapes.push(point);
    arrows
}

fn plain(sketch: &mut Sketch, arrow: &Arrow, name: String) {
    let style = sketch.style;
    let way = arrow.tip - arrow.tail;
    let along = way.normalize_or_zero();
    let thin = if arrow.emphasised { 1.0 } else { SUBORDINATE };
    let width = style.line * thin;
    let head = (style.head * thin.sqrt()).min(0.6 * way.length());
    let colour = arrow.vector.colour();
    let start = arrow.tail + along * style.ring.min(0.4 * way.length());
    let [shaft, point] = Shape::arrow([start, arrow.tip], along, width, head, colour);
    sketch.shapes.extend([shaft.dashed(arrow.vector.dashes()), point]);
    let anchor = sketch.inside(arrow.tip, 0.5 * style.text);
    let size = if arrow.emphasised { 1.15 } else { 0.9 };
    sketch.letter(name, size, colour, anchor, along, 0.15 * style.text);
}

/// An arrow seen along its shaft: its point as a dot, or its fletching as a cross. Circles about one place nest.
fn head_on(sketch: &mut Sketch, arrow: &Arrow, name: String, circles: &mut Vec<(DVec2, f64)>) {
    let style = sketch.style;
    let colour = arrow.vector.colour();
    let mut radius = style.ring + 1.6 * style.line;
    while circles.iter().any(|(centre, taken)| {
        (*centre - arrow.tip).length() < 3.0 * style.line && (taken - radius).abs() < 1.3 * style.line
    }) {
        radius += 1.5 * style.line;
    }
    circles.push((arrow.tip, radius));
    let way = arrow.tip - arrow.tail;
    let along = way.normalize_or_zero();
    if way.length() > radius + style.ring {
        let shaft = vec![arrow.tail + along * style.ring, arrow.tip - along * radius];
        sketch.shapes.push(Shape::line(shaft, style.line, colour).dashed(arrow.vector.dashes()));
    }
    sketch.draw_end_on(arrow.tip, radius, arrow.head == ArrowHead::Towards, colour);
    let size = if arrow.emphasised { 1.15 } else { 0.9 };
    let anchor = sketch.inside(arrow.tip, 0.5 * style.text);
    sketch.letter(name, size, colour, anchor, along, radius + 0.15 * style.text);
}
