//! Which vectors and angles the equation has at a point: those of all lights, and of the one that is looked at in full.

use super::parts::{Arc, Arrow, LETTERED};
use super::{angles, construction, lobe, side, vectors};
use crate::analysis::overlay::Sketch;
use crate::analysis::overlay::{OverlayLayer, OverlayOptions};
use crate::analysis::{LightTerms, ProbeHit, ReflectionLobe};
use crate::figure::palette::Vector;
use crate::figure::{Area, Shape, lowered};
use crate::scene::{Backfacing, ReflectionModel, Scene};
use glam::DVec3;

/// The equation at a point, ready to be drawn in any view.
pub(super) struct Equation<'a> {
    hit: &'a ProbeHit,
    model: ReflectionModel,
    half_vector: bool,
    focus: Option<Focus<'a>>,
}

/// The light that is looked at.
struct Focus<'a> {
    index: usize,
    terms: &'a LightTerms,
    /// N, unit, turned towards the light where surfaces have two sides.
    n: DVec3,
    /// Whether N·L > 0, without which there is no reflection to draw.
    lit: bool,
}

impl<'a> Equation<'a> {
    /// The equation at `hit`, looking at the light that `options` choose.
    pub fn at(hit: &'a ProbeHit, scene: &Scene, options: &OverlayOptions) -> Self {
        let model = scene.reflection.model;
        let half_vector = options.half_vector || model != ReflectionModel::Phong;
        let n = hit.normal.normalize_or_zero();
        let two_sided = scene.reflection.backfacing == Backfacing::Flip;
        let lit = |terms: &LightTerms| n.dot(terms.l) > 0.0 || (two_sided && n.dot(terms.l) < 0.0);
        let chosen = options.light.filter(|index| *index < hit.lights.len());
        let index = chosen.or_else(|| hit.lights.iter().position(lit)).unwrap_or(0);
        let focus = hit.lights.get(index).map(|terms| {
            let n = if two_sided && n.dot(terms.l) < 0.0 { -n } else { n };
            Focus { index, terms, n, lit: lit(terms) }
        });
        Self { hit, model, half_vector, focus }
    }

    /// The lobe of the light that is looked at, if it is asked for.
    pub fn lobe(&self, sketch: &Sketch, scene: &Scene, layers: &[OverlayLayer]) -> Vec<Shape> {
        let focus = self.focus.as_ref().filter(|_| layers.contains(&OverlayLayer::Lobe));
        let lobe = focus.and_then(|focus| ReflectionLobe::at(scene, self.hit, focus.index));
        lobe.map_or_else(Vec::new, |lobe| lobe::draw(sketch, &lobe, scene))
    }

    /// Draws the layers asked for at the point in the picture.
    pub fn draw(&self, sketch: &mut Sketch, layers: &[OverlayLayer]) -> (Vec<Arrow>, Vec<Arc>) {
        self.draw_layers(sketch, true, |layer| layers.contains(&layer))
    }

    /// The side view in a corner of `picture`, if it is asked for and has room: vectors and angles of one light.
    pub fn side_view(&self, picture: Area, sketch: &Sketch, options: &OverlayOptions) -> Option<Sketch> {
        let (focus, v) = (self.focus.as_ref()?, self.hit.view.try_normalize()?);
        let sound = focus.n != DVec3::ZERO && focus.terms.l.is_finite();
        if !options.layers.contains(&OverlayLayer::SideView) || !sound {
            return None;
        }
        let pane = side::pane(picture, sketch.origin, &sketch.style)?;
        let phi_between = if focus.lit { self.phi_between(focus.n, focus.terms) } else { (v, v) };
        let directions = side::Directions { n: focus.n, l: focus.terms.l, v, phi_between };
        let mut side = side::sketch(pane, &directions, options)?;
        let construction = options.layers.contains(&OverlayLayer::Construction);
        self.draw_layers(&mut side, false, |layer| layer != OverlayLayer::Construction || construction);
        Some(side)
    }

    /// Draws in the order in which the letters want places: what is lettered first gets the best.
    fn draw_layers(
        &self,
        sketch: &mut Sketch,
        every_light: bool,
        shows: impl Fn(OverlayLayer) -> bool,
    ) -> (Vec<Arrow>, Vec<Arc>) {
        let constructed = self.focus.as_ref().filter(|focus| focus.lit && shows(OverlayLayer::Construction));
        if let Some(focus) = constructed {
            construction::draw(sketch, focus.n, focus.terms.l);
        }
        let vectors = if shows(OverlayLayer::Vectors) { self.vectors(every_light) } else { vec![] };
        let arrows = vectors::draw(sketch, vectors);
        let arcs = if shows(OverlayLayer::Angles) { self.draw_angles(sketch) } else { vec![] };
        if let Some(focus) = constructed {
            construction::letter(sketch, focus.n, focus.terms.l);
        }
        (arrows, arcs)
    }

    /// The vectors in the order in which they are drawn and lettered; `every_light` adds L of the other lights.
    fn vectors(&self, every_light: bool) -> Vec<vectors::Given> {
        let given = |vector: Vector, light, direction, emphasised| {
            let named = emphasised || self.hit.lights.len() <= LETTERED;
            let name = if named { format!("{}{}", vector.letter(), self.subscript(light)) } else { String::new() };
            vectors::Given { vector, light, direction, name, emphasised }
        };
        let mut list = vec![given(Vector::N, None, self.hit.normal, true)];
        if let Some(Focus { index, terms, lit, .. }) = &self.focus {
            list.push(given(Vector::L, Some(*index), terms.l, true));
            if *lit {
                list.push(given(Vector::R, Some(*index), terms.r, true));
            }
            if self.half_vector {
                list.push(given(Vector::H, Some(*index), terms.h, true));
            }
        }
        list.push(given(Vector::V, None, self.hit.view, true));
        if let Some(t) = self.hit.transmission.and_then(|through| through.t) {
            list.push(given(Vector::T, None, t, true));
        }
        if every_light {
            let looked_at = self.focus.as_ref().map(|focus| focus.index);
            let others = self.hit.lights.iter().enumerate().filter(|(index, _)| Some(*index) != looked_at);
            list.extend(others.map(|(index, terms)| given(Vector::L, Some(index), terms.l, false)));
        }
        list
    }

    fn draw_angles(&self, sketch: &mut Sketch) -> Vec<Arc> {
        let Some(Focus { index, terms, n, lit }) = &self.focus else { return vec![] };
        let given = angles::Given {
            n: *n,
            l: terms.l,
            r: lit.then_some(terms.r),
            phi_between: lit.then(|| self.phi_between(*n, terms)),
            theta: terms.theta,
            phi: terms.phi,
            subscript: self.subscript(Some(*index)),
        };
        angles::draw(sketch, &given)
    }

    /// The vectors whose angle is φ.
    fn phi_between(&self, n: DVec3, terms: &LightTerms) -> (DVec3, DVec3) {
        if self.model == ReflectionModel::Phong { (terms.r, self.hit.view) } else { (n, terms.h) }
    }

    /// The light's number below the line, where there are several lights.
    fn subscript(&self, light: Option<usize>) -> String {
        light.filter(|_| self.hit.lights.len() > 1).map_or_else(String::new, |index| lowered(index + 1))
    }
}
