//! The arrows.

use super::{Arrow, ArrowHead};
use crate::analysis::overlay::Sketch;
use crate::figure::ink::Mark;
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
    /// The letter with its number.
    /// Empty for none.
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
    let point = Mark::ring(sketch.origin, ring, 0.5 * sketch.style.line, sketch.style.neutral);
    sketch.marks.push(point);
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
    let shaft = vec![start, arrow.tip - along * 0.85 * head];
    sketch.marks.push(Mark::line(shaft, width, colour).dashed(arrow.vector.dashes()));
    sketch.marks.push(Mark::arrow_head(arrow.tip, along, head, colour));
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
        sketch.marks.push(Mark::line(shaft, style.line, colour).dashed(arrow.vector.dashes()));
    }
    sketch.marks.push(Mark::ring(arrow.tip, radius, 0.8 * style.line, colour));
    if arrow.head == ArrowHead::Towards {
        sketch.marks.push(Mark::dot(arrow.tip, 1.1 * style.line, colour));
    } else {
        let arm = DVec2::splat(radius * std::f64::consts::FRAC_1_SQRT_2);
        for arm in [arm, arm.perp()] {
            sketch.marks.push(Mark::line(vec![arrow.tip - arm, arrow.tip + arm], 0.6 * style.line, colour));
        }
    }
    let size = if arrow.emphasised { 1.15 } else { 0.9 };
    let anchor = sketch.inside(arrow.tip, 0.5 * style.text);
    sketch.letter(name, size, colour, anchor, along, radius + 0.15 * style.text);
}
