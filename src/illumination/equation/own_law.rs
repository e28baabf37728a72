//! The sum over the sources by the scene's own law.

use super::{Equation, Reached};
use crate::illumination::formula::{
    Constancy, Incidence, Law, LawAt, LawLines, LawPart, LawScratch, LawSite, LawValues, TOGETHER,
};
use crate::illumination::source::BRIGHTEST;
use crate::illumination::{Real, Scalar, ShadingPoint, Source, V3};
use crate::scene::{ObjectKind, Rgb, Scene, Viewer};
use glam::DVec3;

/// The distance in camera distances that counts as that of parallel rays.
const FARTHEST: f64 = 1e12;

/// The part of one source at a point: the law's factors times coefficients.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SourcePart {
    pub site: LawSite<f64>,
    /// `f·Ip` times the spot's part, per channel.
    pub coefficients: [f64; 3],
}

/// Prepares the law of `scene`; one that cannot be read reflects nothing. `parallel` says whether the rays of each light are.
pub(super) fn law_of(scene: &Scene, has_pattern: bool, parallel: bool) -> Law {
    let color = if has_pattern {
        Rgb::ONE
    } else {
        scene.material.color
    };
    let camera = &scene.camera;
    let backwards = (camera.eye - camera.target).normalize_or_zero();
    let constancy = Constancy {
        // The vertices of a model may have colours, which tint Od.
        color: !has_pattern && scene.object.kind != ObjectKind::Obj,
        view: (camera.viewer == Viewer::Infinite).then(|| backwards.to_array()),
        lights: parallel,
    };
    Law::of(scene, color, constancy).unwrap_or_default()
}

impl<T: Scalar> Equation<T> {
    /// Computes what the law needs once for each source.
    pub(super) fn prepare_law(&mut self) {
        if let Some(law) = &self.law {
            let known = self.sources.iter().filter_map(|source| {
                let l = source.parallel()?.map(T::to_f64);
                let distance = FARTHEST * self.unit;
                let l = V3::from(DVec3::from(l));
                Some(law.known(&Incidence { l, distance }))
            });
            self.known = known.flatten().map(T::from_f64).collect();
        }
    }

    /// Returns the parts of the scene's own law, with the numbers of their operations; none where it has none.
    pub fn law_parts(&self) -> Option<&[LawPart]> {
        self.law.as_deref().map(Law::parts)
    }

    /// Returns what the law has computed for the source of that index.
    #[inline(always)]
    fn known_of(&self, source: usize) -> &[T] {
        let count = self.known.len() / self.sources.len().max(1);
        &self.known[source * count..][..count]
    }

    /// Adds the parts of all sources by the scene's own law to `sum`; the second value is 1 where the law is undefined for a source
    /// that reaches the point, otherwise 0.
    // In one copy for all shaders.
    #[inline(never)]
    pub(super) fn add_law<R: Real<Scalar = T>>(
        &self,
        law: &Law,
        site: &ShadingPoint<R>,
        reached: Option<Reached<'_>>,
        color: Option<&[R; 3]>,
        mut sum: [R; 3],
        scratch: &mut LawScratch<R>,
    ) -> ([R; 3], R) {
        let like = site.inverse_distance;
        like.vectorize(
            #[inline(always)]
            || {
                let zero = like.number(0.0);
                let (mut undefined, last) = (zero, self.sources.len());
                let mut point = law.at(site.normal, site.view, color, (scratch, last));
                // The lights that are evaluated together.
                let mut group = [(0, zero); TOGETHER];
                let mut count = 0;
                for index in 0..last {
                    if !reached.is_some_and(|reached| like.holds_none(reached.bits(index))) {
                        let (incidence, strength) = self.incidence(&self.sources[index], site);
                        point.put(count, &incidence, self.known_of(index));
                        group[count] = (index, strength);
                        count += 1;
                    }
                    if count < point.places() && index + 1 < last {
                        continue;
                    }
                    point.run(count);
                    for (place, (index, strength)) in group[..count].iter().enumerate() {
                        let mut parts = self.parts_by_law(point.factors(place), *index, *strength);
                        let lit = reached.map(|reached| like.mask_of_bits(reached.bits(*index)));
                        if let Some(lit) = lit {
                            for part in &mut parts {
                                *part = R::select(lit, *part, zero);
                            }
                        }
                        for (sum, part) in sum.iter_mut().zip(parts) {
                            *sum = *sum + part;
                        }
                        if law.may_be_undefined() {
                            let own = point.undefined(place);
                            let own = lit.map_or(own, |lit| R::select(lit, own, zero));
                            undefined = undefined.max(own);
                        }
                    }
                    count = 0;
                }
                (sum, undefined)
            },
        )
    }

    /// Returns what one source adds by the scene's own law at a point, per channel.
    #[inline(always)]
    pub(super) fn part_by_law<R: Real<Scalar = T>>(
        &self,
        point: &mut LawAt<'_, R>,
        index: usize,
        site: &ShadingPoint<R>,
    ) -> [R; 3] {
        let (incidence, strength) = self.incidence(&self.sources[index], site);
        point.put(0, &incidence, self.known_of(index));
        point.run(1);
        self.parts_by_law(point.factors(0), index, strength)
    }

    /// Returns what one source adds where the law has these factors, per channel: at most an equal share of [`BRIGHTEST`], and 0 where
    /// the law has no value.
    #[inline(always)]
    fn parts_by_law<R: Real<Scalar = T>>(
        &self,
        mut factors: [R; 3],
        index: usize,
        strength: R,
    ) -> [R; 3] {
        let zero = strength.number(0.0);
        let limit = strength.number(BRIGHTEST / self.sources.len().max(1) as f64);
        let V3 { x, y, z } = V3::constant(strength, self.sources[index].diffuse);
        // A loop: what `map` of an array takes is not always compiled into it, and then not for the lanes' instructions.
        for (factor, ip) in factors.iter_mut().zip([x, y, z]) {
            let part = *factor * ip * strength;
            // What is not a number is neither above nor below 0.
            let above = R::select(part.greater_than(zero), part.min(limit), zero);
            *factor = R::select(zero.greater_than(part), part.max(-limit), above);
        }
        factors
    }

    /// Returns what the law knows of a source at a point, its distance only if the law depends on it; and the attenuation times the spot's part.
    #[inline(always)]
    fn incidence<R: Real<Scalar = T>>(
        &self,
        source: &Source<T>,
        site: &ShadingPoint<R>,
    ) -> (Incidence<R>, R) {
        let like = site.inverse_distance;
        let (l, attenuation, nearness) = source.reach(site.position, site.inverse_distance);
        let mut distance = like.number(0.0);
        if self.law.as_ref().is_some_and(|law| law.names_distance()) {
            let nearest = nearness.max(like.number(1.0 / FARTHEST));
            distance = like.number(1.0) / nearest * T::from_f64(self.unit);
        }
        (Incidence { l, distance }, attenuation * source.spot(l))
    }
}

impl Equation<f64> {
    /// Evaluates the lines of the scene's own law for a light at a point of the world with normal `n` and the surface's colour Od
    /// there, towards the middle of an area light; none where the scene has no law of its own.
    ///
    /// # Panics
    /// If there is no such light.
    pub fn law_values(
        &self,
        scene: &Scene,
        light: usize,
        (point, n): (DVec3, DVec3),
        od: Rgb,
    ) -> Option<LawValues> {
        let lines = self.law.as_ref().and_then(|_| LawLines::of(scene).ok())?;
        let at = self.respond_world(light, point, n, None);
        let source = &scene.lights[light];
        let distance = if source.kind.has_position() {
            (source.position - point).length()
        } else {
            f64::INFINITY
        };
        let incidence = Incidence {
            l: V3::from(at.l),
            distance: distance.min(FARTHEST * self.unit),
        };
        Some(lines.at([n, at.v], od, &incidence))
    }

    /// Returns the parts of the sources that reach a point of the world with normal `n`; `tint` multiplies Od.
    pub(crate) fn source_parts(
        &self,
        (point, n): (DVec3, DVec3),
        tint: Rgb,
        reached: Option<Reached<'_>>,
    ) -> Vec<SourcePart> {
        let site = self.site_at(point, n);
        let color = (self.pattern_color(point) * tint).to_array();
        let reaching = self.sources.iter().enumerate().filter(|(index, source)| {
            reached.is_none_or(|reached| reached.holds(*index)) && source.diffuse != [0.0; 3]
        });
        let part = |(_, source)| {
            let (incidence, strength) = self.incidence(source, &site);
            SourcePart {
                site: LawSite {
                    normal: V3::from(n),
                    view: site.view,
                    color: Some(color),
                    incidence,
                },
                coefficients: source.diffuse.map(|ip| ip * strength),
            }
        };
        reaching.map(part).collect()
    }
}
