//! The arcs of θ and φ: circles' arcs about the probed point, each in the plane of its two vectors.

use super::{Angle, Arc};
use crate::analysis::overlay::Sketch;
use crate::figure::Shape;
use glam::{DVec2, DVec3};

/// Chords in an arc.
const CHORDS: u32 = 48;
/// Radius of θ's arcs and of φ's, in unit vectors.
const RADIUS: [f64; 2] = [0.42, 0.64];

/// The directions of one light's angles, all unit: θ between `n` and `l`, equal to that between `n` and `r`; φ between
/// the pair of the specular term.
pub(super) struct Given {
    pub n: DVec3,
    pub l: DVec3,
    /// Nothing where the light does not reach the surface.
    pub r: Option<DVec3>,
    pub phi_between: Option<(DVec3, DVec3)>,
    /// Radians.
    pub theta: f64,
    pub phi: f64,
    /// The light's number as a subscript, if it has one.
    pub subscript: String,
}

/// Draws the arcs and asks for their labels.
pub(super) fn draw(sketch: &mut Sketch, given: &Given) -> Vec<Arc> {
    let mut arcs = Vec::new();
    let thick = 0.6 * sketch.style.line;
    if let Some(r) = given.r {
        arcs.extend(arc(sketch, Angle::Mirror, (given.n, r), 0.55 * thick));
    }
    if let Some(theta) = arc(sketch, Angle::Theta, (given.n, given.l), thick) {
        label(sketch, &theta, format!("θ{} {}", given.subscript, degrees(given.theta)));
        arcs.push(theta);
    }
    if let Some(phi) = given.phi_between.and_then(|pair| arc(sketch, Angle::Phi, pair, thick)) {
        label(sketch, &phi, format!("φ{} {}", given.subscript, degrees(given.phi)));
        arcs.push(phi);
    }
    arcs
}

/// An angle in radians as it is lettered.
pub(super) fn degrees(radians: f64) -> String {
    format!("{:.1}°", radians.to_degrees())
}

fn arc(sketch: &mut Sketch, angle: Angle, (from, to): (DVec3, DVec3), width: f64) -> Option<Arc> {
    let radius = if angle == Angle::Phi { RADIUS[1] } else { RADIUS[0] };
    let points: Vec<DVec2> =
        turn(from, to)?.into_iter().map(|direction| sketch.end(direction * radius)).collect::<Option<_>>()?;
    let edge_on = flat(sketch.origin, &points, 1.2 * sketch.style.line);
    if !edge_on {
        let mark = Shape::line(points.clone(), width, sketch.style.neutral);
        // The two arcs share a colour; dashes tell φ's from θ's.
        sketch.shapes.push(if angle == Angle::Phi { mark.dashed(&[3.0, 2.0]) } else { mark });
    }
    Some(Arc { angle, points, edge_on })
}

/// Unit vectors from `from` to `to` along the great circle; nothing if either has no direction.
fn turn(from: DVec3, to: DVec3) -> Option<Vec<DVec3>> {
    let (from, to) = (from.try_normalize()?, to.try_normalize()?);
    let whole = from.angle_between(to);
    let across = (to - from * from.dot(to)).try_normalize().unwrap_or_else(|| from.any_orthonormal_vector());
    let at = |i: u32| {
        let (sine, cosine) = (whole * f64::from(i) / f64::from(CHORDS)).sin_cos();
        from * cosine + across * sine
    };
    Some((0..=CHORDS).map(at).collect())
}

/// Whether all points lie on one line through `origin`: then the arc is seen from its edge and would only thicken the
/// arrow beneath it.
fn flat(origin: DVec2, points: &[DVec2], tolerance: f64) -> bool {
    let far =
        points.iter().map(|point| *point - origin).max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let along = far.unwrap_or(DVec2::ZERO).normalize_or_zero();
    points.iter().all(|point| along.perp_dot(*point - origin).abs() < tolerance)
}

fn label(sketch: &mut Sketch, arc: &Arc, text: String) {
    let Some(middle) = arc.points.get(arc.points.len() / 2).copied() else { return };
    let style = sketch.style;
    let out = (middle - sketch.origin).normalize_or_zero();
    let anchor = sketch.inside(middle, 0.5 * style.text);
    sketch.letter(text, 0.9, style.neutral, anchor, out, 0.3 * style.text);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_runs_from_one_vector_to_the_other_at_unit_distance_and_even_pace() {
        let (from, to) = (DVec3::Y, DVec3::new(1.0, -1.0, 0.5).normalize());
        let turned = turn(from, to).expect("both have a direction");
        assert!((turned[0] - from).length() < 1e-12 && (turned[CHORDS as usize] - to).length() < 1e-12);
        let step = turned[0].angle_between(turned[1]);
        for pair in turned.windows(2) {
            assert!((pair[0].length() - 1.0).abs() < 1e-12 && (pair[0].angle_between(pair[1]) - step).abs() < 1e-7);
        }
    }

    #[test]
    fn opposite_vectors_have_an_arc_and_none_have_no_arc() {
        let turned = turn(DVec3::X, DVec3::NEG_X).expect("both have a direction");
        assert!(turned.iter().all(|v| v.is_finite()) && turned[CHORDS as usize / 2].x.abs() < 1e-12);
        assert!(turn(DVec3::ZERO, DVec3::X).is_none() && turn(DVec3::NAN, DVec3::X).is_none());
    }

    #[test]
    fn an_arc_in_line_with_its_centre_is_flat_and_a_short_one_beside_it_is_not() {
        let at = |(x, y): (f64, f64)| DVec2::new(x, y);
        assert!(flat(DVec2::ZERO, &[(0.0, 0.0), (10.0, 10.0), (-5.0, -5.0)].map(at), 1.0));
        assert!(!flat(DVec2::ZERO, &[(10.0, 0.0), (9.8, 2.0), (9.2, 4.0)].map(at), 1.0));
    }
}
