//! The equation at a point as arrows, arcs and the construction of R: for all lights, and in full for the chosen one.

use super::lights::LETTERED;
use super::{lobe, side};
use crate::analysis::lobe::ReflectionLobe;
use crate::analysis::overlay::{OverlayLayer, OverlayOptions, Sketch, inset};
use crate::analysis::probe::{LightTerms, ProbeHit};
use crate::figure::palette::Vector;
use crate::figure::{Area, Shape, lowered};
use crate::scene::{Backfacing, ReflectionModel, Scene};
use glam::{DVec2, DVec3};

/// Sine of the angle to the line of sight (10°) below which an arrow shows its head from the front or from behind.
const HEAD_ON: f64 = 0.17;
/// Width of the arrows of lights that are not emphasised.
const SUBORDINATE: f64 = 0.55;
/// Number of chords in an arc, and the radii of the arcs of θ, φ and α, in unit vectors.
const CHORDS: u32 = 48;
const RADIUS: [f64; 3] = [0.42, 0.64, 0.53];
/// Side of the square that marks a right angle, in unit vectors.
const SQUARE: f64 = 0.07;
/// Dashes of the lines that complete the parallelogram.
const DASHES: &[f32] = &[4.0, 3.0];

/// The end of an arrow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ArrowHead {
    /// A triangle.
    Plain,
    /// A dot within a circle: the arrow points at the eye.
    Towards,
    /// A cross within a circle: the arrow points away from the eye.
    Away,
}

/// A vector of the equation in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    /// The vector that the arrow stands for.
    pub vector: Vector,
    /// The light that it belongs to; none for N and V.
    pub light: Option<usize>,
    /// Position of the probed point in the picture, pixels.
    pub tail: DVec2,
    /// Position of the vector's end, pixels; it may be outside the picture.
    pub tip: DVec2,
    /// The end of the arrow.
    pub head: ArrowHead,
    /// False for lights that are not chosen.
    pub emphasised: bool,
}

/// The angle that an arc measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Angle {
    /// The angle between N and L.
    Theta,
    /// The angle between N and R, which equals θ.
    Mirror,
    /// The angle between R and V.
    Phi,
    /// The angle between N and H.
    Alpha,
}

/// An arc between two vectors in the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Arc {
    /// The angle that it measures.
    pub angle: Angle,
    /// Points along it, pixels.
    pub points: Vec<DVec2>,
    /// True if the arc is seen edge-on; only its label is then drawn.
    pub edge_on: bool,
}

/// The equation at a point, ready to be drawn in any view.
pub(super) struct Equation<'a> {
    hit: &'a ProbeHit,
    phong: bool,
    half_vector: bool,
    pub(super) focus: Option<Focus<'a>>,
}

/// The chosen light.
pub(super) struct Focus<'a> {
    index: usize,
    pub terms: &'a LightTerms,
    /// N, a unit vector, turned towards the light where surfaces have two sides.
    pub n: DVec3,
    /// True if N·L > 0, without which there is no reflection to draw.
    pub lit: bool,
}

impl<'a> Equation<'a> {
    /// Returns the equation at `hit` for the light that `options` choose.
    pub fn new(hit: &'a ProbeHit, scene: &Scene, options: &OverlayOptions) -> Self {
        let phong = scene.reflection.model == ReflectionModel::Phong;
        let n = hit.normal.normalize_or_zero();
        let two_sided = scene.reflection.backfacing == Backfacing::Flip;
        let lit = |terms: &LightTerms| n.dot(terms.l) > 0.0 || (two_sided && n.dot(terms.l) < 0.0);
        let chosen = options.light.filter(|index| *index < hit.lights.len());
        let index = chosen
            .or_else(|| hit.lights.iter().position(lit))
            .unwrap_or(0);
        let focus = hit.lights.get(index).map(|terms| {
            let n = if two_sided && n.dot(terms.l) < 0.0 {
                -n
            } else {
                n
            };
            Focus {
                index,
                terms,
                n,
                lit: lit(terms),
            }
        });
        Self {
            hit,
            phong,
            half_vector: options.half_vector || !phong,
            focus,
        }
    }

    /// Returns the lobe of the chosen light, if requested.
    pub fn lobe(&self, sketch: &Sketch, scene: &Scene, layers: &[OverlayLayer]) -> Vec<Shape> {
        let lobe = self.lobe_of(scene, layers);
        lobe.map_or_else(Vec::new, |lobe| lobe::draw(sketch, &lobe, scene))
    }

    fn lobe_of(&self, scene: &Scene, layers: &[OverlayLayer]) -> Option<ReflectionLobe> {
        let focus = self.focus.as_ref()?;
        let shown = layers.contains(&OverlayLayer::Lobe);
        ReflectionLobe::at(scene, self.hit, focus.index).filter(|_| shown)
    }

    /// Draws the side view in a corner of `picture`, if it is requested or needed, and fits: vectors and angles of one
    /// light, and the lobe in cross-section.
    pub fn side_view(
        &self,
        picture: Area,
        scene: &Scene,
        sketch: &Sketch,
        options: &OverlayOptions,
    ) -> Option<Sketch> {
        let (focus, v) = (self.focus.as_ref()?, self.hit.view.try_normalize()?);
        let Focus { terms, n, lit, .. } = focus;
        let sound = *n != DVec3::ZERO && terms.l.is_finite();
        let needed = options.side_view_where_needed
            && options.layers.contains(&OverlayLayer::Vectors)
            && *lit
            && side::is_needed(sketch, [*n, terms.l, terms.r]);
        let asked = options.layers.contains(&OverlayLayer::SideView);
        if !sound || !(needed || asked) {
            return None;
        }
        let enlarged = options.side_view_enlarged;
        let pane = |free| inset::pane(picture, sketch.origin, &sketch.style, enlarged, free);
        let free = options.free_corners.filter(|_| !enlarged);
        let pane = pane(free).or_else(|| asked.then(|| pane(None)).flatten())?;
        let mut side = side::sketch(pane, [*n, terms.l, v], options)?;
        if let Some(lobe) = self.lobe_of(scene, &options.layers) {
            let section = lobe::draw_section(&side, &lobe, scene);
            side.shapes.extend(section);
        }
        let constructed = options.layers.contains(&OverlayLayer::Construction);
        let mut layers = vec![OverlayLayer::Vectors];
        layers.extend(options.side_view_angles.then_some(OverlayLayer::Angles));
        layers.extend(constructed.then_some(OverlayLayer::Construction));
        self.draw(&mut side, false, &layers);
        Some(side)
    }

    /// Draws layers, those first whose letters get the best places. `every_light` adds L of the other lights.
    pub fn draw(
        &self,
        sketch: &mut Sketch,
        every_light: bool,
        layers: &[OverlayLayer],
    ) -> (Vec<Arrow>, Vec<Arc>) {
        let shown = |layer| self.focus.as_ref().filter(|_| layers.contains(&layer));
        let constructed = shown(OverlayLayer::Construction).filter(|focus| focus.lit);
        if let Some(focus) = constructed {
            draw_construction(sketch, focus.n, focus.terms.l);
        }
        let arrows = if layers.contains(&OverlayLayer::Vectors) {
            self.draw_vectors(sketch, every_light, |_| true)
        } else {
            vec![]
        };
        draw_point(sketch);
        let arcs = shown(OverlayLayer::Angles)
            .map(|focus| {
                let lobe = if self.phong { Angle::Phi } else { Angle::Alpha };
                self.draw_angles(sketch, focus, &[Angle::Mirror, Angle::Theta, lobe])
            })
            .unwrap_or_default();
        if let Some(Focus { n, terms, .. }) = constructed {
            let foot = *n * n.dot(terms.l);
            if let (Some(at_l), Some(at_foot)) = (sketch.end(terms.l), sketch.end(foot)) {
                let em = sketch.style.text;
                let (anchor, colour) = (sketch.inside(at_foot, em), Vector::N.colour());
                let aside = (at_foot - at_l).normalize_or_zero();
                sketch.letter("N(N·L)".into(), 0.8, colour, anchor, aside, 0.3 * em);
            }
        }
        (arrows, arcs)
    }

    /// Draws the vectors that are `shown` from the probed point, with their letters.
    pub fn draw_vectors(
        &self,
        sketch: &mut Sketch,
        every_light: bool,
        shown: impl Fn(Vector) -> bool,
    ) -> Vec<Arrow> {
        let hit = self.hit;
        let mut list = vec![(Vector::N, None, hit.normal)];
        if let Some(Focus {
            index, terms, lit, ..
        }) = &self.focus
        {
            let light = Some(*index);
            list.push((Vector::L, light, terms.l));
            list.extend(lit.then_some((Vector::R, light, terms.r)));
            let halfway = (Vector::H, light, terms.h);
            list.extend(self.half_vector.then_some(halfway));
        }
        list.push((Vector::V, None, hit.view));
        let through = hit.transmission.and_then(|through| through.t);
        list.extend(through.map(|t| (Vector::T, None, t)));
        list.retain(|(vector, ..)| shown(*vector));
        let emphasised = list.len();
        if every_light {
            let looked_at = self.focus.as_ref().map(|focus| focus.index);
            let others = hit
                .lights
                .iter()
                .enumerate()
                .filter(|(index, _)| Some(*index) != looked_at);
            list.extend(others.map(|(index, terms)| (Vector::L, Some(index), terms.l)));
        }
        let (mut circles, mut arrows) = (vec![(sketch.origin, sketch.style.ring)], Vec::new());
        for (place, (vector, light, direction)) in list.into_iter().enumerate() {
            if !direction.is_finite() || direction == DVec3::ZERO {
                continue;
            }
            let Some(tip) = sketch.end(direction) else {
                continue;
            };
            let slant = sketch.slant(direction);
            let head = match (slant.abs() < HEAD_ON, slant.is_sign_positive()) {
                (false, _) => ArrowHead::Plain,
                (true, true) => ArrowHead::Towards,
                (true, false) => ArrowHead::Away,
            };
            let emphasised = place < emphasised;
            let arrow = Arrow {
                vector,
                light,
                tail: sketch.origin,
                tip,
                head,
                emphasised,
            };
            let beside = draw_arrow(sketch, &arrow, &mut circles);
            if emphasised || hit.lights.len() <= LETTERED {
                let name = format!("{}{}", vector.letter(), self.subscript(light));
                let size = if emphasised { 1.15 } else { 0.9 };
                let (em, colour) = (sketch.style.text, sketch.style.colour(vector));
                let anchor = sketch.inside(tip, 0.5 * em);
                let along = (tip - sketch.origin).normalize_or_zero();
                sketch.letter(name, size, colour, anchor, along, beside + 0.15 * em);
            }
            arrows.push(arrow);
        }
        arrows
    }

    /// Draws arcs of angles and requests their labels.
    pub fn draw_angles(&self, sketch: &mut Sketch, focus: &Focus<'_>, shown: &[Angle]) -> Vec<Arc> {
        let Focus { terms, n, .. } = focus;
        let subscript = self.subscript(Some(focus.index));
        let mut arcs = Vec::new();
        for angle in shown {
            let (pair, letter, value) = match angle {
                Angle::Theta => ((*n, terms.l), "θ", terms.theta),
                Angle::Mirror => ((*n, terms.r), "", terms.theta),
                Angle::Phi => ((terms.r, self.hit.view), "φ", terms.phi),
                Angle::Alpha => ((*n, terms.h), "α", terms.alpha),
            };
            if *angle != Angle::Theta && !focus.lit {
                continue;
            }
            let Some(arc) = draw_arc(sketch, *angle, pair) else {
                continue;
            };
            if !letter.is_empty() {
                let (middle, style) = (arc.points[arc.points.len() / 2], sketch.style);
                let out = (middle - sketch.origin).normalize_or_zero();
                let anchor = sketch.inside(middle, 0.5 * style.text);
                let text = format!("{letter}{subscript} {:.1}°", value.to_degrees());
                sketch.letter(text, 0.9, style.neutral, anchor, out, 0.3 * style.text);
            }
            arcs.push(arc);
        }
        arcs
    }

    /// Returns the light's number as a subscript, where there are several lights.
    fn subscript(&self, light: Option<usize>) -> String {
        light
            .filter(|_| self.hit.lights.len() > 1)
            .map_or_else(String::new, |index| lowered(index + 1))
    }
}

/// Draws an arrow and returns the additional distance of its letter from its tip: one seen along its shaft ends in a
/// circle, and circles about one place nest.
fn draw_arrow(sketch: &mut Sketch, arrow: &Arrow, circles: &mut Vec<(DVec2, f64)>) -> f64 {
    let style = sketch.style;
    let (colour, dashes) = (style.colour(arrow.vector), arrow.vector.dashes());
    let way = arrow.tip - arrow.tail;
    let (along, length) = (way.normalize_or_zero(), way.length());
    if arrow.head == ArrowHead::Plain {
        let thin = if arrow.emphasised { 1.0 } else { SUBORDINATE };
        let head = (style.head * thin.sqrt()).min(0.6 * length);
        let start = arrow.tail + along * style.ring.min(0.4 * length);
        let [shaft, point] =
            Shape::arrow([start, arrow.tip], along, style.line * thin, head, colour);
        sketch.shapes.extend([shaft.dashed(dashes), point]);
        return 0.0;
    }
    let mut radius = style.ring + 1.6 * style.line;
    let near = |(centre, taken): &(DVec2, f64), radius: f64| {
        (*centre - arrow.tip).length() < 3.0 * style.line
            && (taken - radius).abs() < 1.3 * style.line
    };
    while circles.iter().any(|circle| near(circle, radius)) {
        radius += 1.5 * style.line;
    }
    circles.push((arrow.tip, radius));
    if length > radius + style.ring {
        let shaft = vec![arrow.tail + along * style.ring, arrow.tip - along * radius];
        sketch
            .shapes
            .push(Shape::line(shaft, style.line, colour).dashed(dashes));
    }
    sketch.draw_end_on(arrow.tip, radius, arrow.head == ArrowHead::Towards, colour);
    radius
}

/// Draws a circle's arc about the probed point in the plane of two vectors; none if one has no direction.
fn draw_arc(sketch: &mut Sketch, angle: Angle, (from, to): (DVec3, DVec3)) -> Option<Arc> {
    let (radius, width) = match angle {
        Angle::Theta => (RADIUS[0], 0.6),
        Angle::Mirror => (RADIUS[0], 0.33),
        Angle::Phi => (RADIUS[1], 0.6),
        Angle::Alpha => (RADIUS[2], 0.6),
    };
    let directions = turn(from, to)?.into_iter();
    let points = sketch.ends(directions.map(|direction| direction * radius))?;
    // All points on one line through the origin: edge-on, the arc would only thicken the arrow beneath it.
    let ways = || points.iter().map(|point| *point - sketch.origin);
    let far = ways().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let along = far.unwrap_or(DVec2::ZERO).normalize_or_zero();
    let edge_on = ways().all(|way| along.perp_dot(way).abs() < 1.2 * sketch.style.line);
    if !edge_on {
        let style = sketch.style;
        let mark = Shape::line(points.clone(), width * style.line, style.neutral);
        // The arcs share a colour; dashes tell them apart.
        sketch.shapes.push(match angle {
            Angle::Phi => mark.dashed(&[3.0, 2.0]),
            Angle::Alpha => mark.dashed(&[1.25, 1.5]),
            Angle::Theta | Angle::Mirror => mark,
        });
    }
    Some(Arc {
        angle,
        points,
        edge_on,
    })
}

/// Returns unit vectors from `from` to `to` along the great circle; none if either has no direction.
fn turn(from: DVec3, to: DVec3) -> Option<Vec<DVec3>> {
    let (from, to) = (from.try_normalize()?, to.try_normalize()?);
    let whole = from.angle_between(to);
    let across = (to - from * from.dot(to))
        .try_normalize()
        .unwrap_or_else(|| from.any_orthonormal_vector());
    let at = |i: u32| {
        let (sine, cosine) = (whole * f64::from(i) / f64::from(CHORDS)).sin_cos();
        from * cosine + across * sine
    };
    Some((0..=CHORDS).map(at).collect())
}

/// Draws R = 2N(N·L) − L by projection of L onto N, as far again on the other side; unit vectors with `n`·`l` > 0.
fn draw_construction(sketch: &mut Sketch, n: DVec3, l: DVec3) {
    let foot = n * n.dot(l);
    let Some([at_l, at_r, at_foot, at_top]) = sketch
        .ends([l, 2.0 * foot - l, foot, 2.0 * foot])
        .and_then(|ends| <[DVec2; 4]>::try_from(ends).ok())
    else {
        return;
    };
    let style = sketch.style;
    let thin = |points| Shape::line(points, 0.45 * style.line, style.neutral);
    sketch.shapes.extend([
        thin(vec![at_l, at_r]),
        thin(vec![at_l, at_top, at_r]).dashed(DASHES),
        thin(vec![sketch.origin, at_top]).dashed(DASHES),
    ]);
    draw_right_angle(sketch, n, l, foot);
    sketch
        .shapes
        .push(Shape::disc(at_foot, 0.9 * style.line, Vector::N.colour()));
}

/// Draws the square at `foot`, where the line from the end of `l` meets N's line.
pub(super) fn draw_right_angle(sketch: &mut Sketch, n: DVec3, l: DVec3, foot: DVec3) {
    let way = l - foot;
    let Some(across) = way.try_normalize().filter(|_| way.length() > 2.0 * SQUARE) else {
        return;
    };
    let corners = sketch.ends([
        foot + across * SQUARE,
        foot + (across - n) * SQUARE,
        foot - n * SQUARE,
    ]);
    let (width, colour) = (0.45 * sketch.style.line, sketch.style.neutral);
    sketch
        .shapes
        .extend(corners.map(|corners| Shape::line(corners, width, colour)));
}

/// Draws the ring of the probed point.
pub(super) fn draw_point(sketch: &mut Sketch) {
    let style = sketch.style;
    let ring = Shape::ring(sketch.origin, style.ring, 0.5 * style.line, style.neutral);
    sketch.shapes.push(ring);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_runs_from_one_vector_to_the_other_at_unit_distance_and_even_pace() {
        let (from, to) = (DVec3::Y, DVec3::new(1.0, -1.0, 0.5).normalize());
        let turned = turn(from, to).expect("both have a direction");
        assert!(
            (turned[0] - from).length() < 1e-12 && (turned[CHORDS as usize] - to).length() < 1e-12
        );
        let step = turned[0].angle_between(turned[1]);
        for pair in turned.windows(2) {
            assert!(
                (pair[0].length() - 1.0).abs() < 1e-12
                    && (pair[0].angle_between(pair[1]) - step).abs() < 1e-7
            );
        }
        let opposite = turn(DVec3::X, DVec3::NEG_X).expect("both have a direction");
        assert!(
            opposite.iter().all(|v| v.is_finite()) && opposite[CHORDS as usize / 2].x.abs() < 1e-12
        );
        assert!(turn(DVec3::ZERO, DVec3::X).is_none() && turn(DVec3::NAN, DVec3::X).is_none());
    }
}
