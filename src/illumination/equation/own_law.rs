//! The sum over the sources by the scene's own law.

use super::{Equation, Reached};
use crate::illumination::formula::{
    Constancy, Incidence, Law, LawAt, LawLines, LawPart, LawSite, LawValues,
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

    /// Adds the parts of all sources by the scene's own law to `sum`.
    // In one copy for all shaders.
    #[inline(never)]
    pub(super) fn add_law<R: Real<Scalar = T>>(
        &self,
        law: &Law,
        site: &ShadingPoint<R>,
        reached: Option<Reached<'_>>,
        color: Option<[R; 3]>,
        mut sum: [R; 3],
    ) -> [R; 3] {
        let like = site.inverse_distance;
        like.vectorize(
            #[inline(always)]
            || {
                let zero = like.number(0.0);
                let mut point = law.at(site.normal, site.view, color);
                for index in 0..self.sources.len() {
                    if reached.is_some_and(|reached| like.holds_none(reached.bits(index))) {
                        continue;
                    }
                    let parts = self.part_by_law(&mut point, index, site);
                    for (sum, part) in sum.iter_mut().zip(parts) {
                        let lit = reached.map(|reached| like.mask_of_bits(reached.bits(index)));
                        *sum = *sum + lit.map_or(part, |lit| R::select(lit, part, zero));
                    }
                }
                sum
            },
        )
    }

    /// Returns what one source adds by the scene's own law, per channel: at most an equal share of [`BRIGHTEST`], and 0 where the
    /// law has no value.
    #[inline(always)]
    pub(super) fn part_by_law<R: Real<Scalar = T>>(
        &self,
        point: &mut LawAt<'_, R>,
        index: usize,
        site: &ShadingPoint<R>,
    ) -> [R; 3] {
        let (like, source) = (site.inverse_distance, &self.sources[index]);
        let zero = like.number(0.0);
        let limit = like.number(BRIGHTEST / self.sources.len().max(1) as f64);
        let (incidence, strength) = self.incidence(source, site);
        let factors = point.factors(&incidence, self.known_of(index));
        let V3 { x, y, z } = V3::constant(like, source.diffuse);
        let [r, g, b] = factors;
        [r * x, g * y, b * z].map(
            #[inline(always)]
            |factor| {
                let part = factor * strength;
                // What is not a number is neither above nor below 0.
                let above = R::select(part.greater_than(zero), part.min(limit), zero);
                R::select(zero.greater_than(part), part.max(-limit), above)
            },
        )
    }

    /// Returns what a law knows of a source at a point, and the attenuation times the spot's part.
    #[inline(always)]
    fn incidence<R: Real<Scalar = T>>(
        &self,
        source: &Source<T>,
        site: &ShadingPoint<R>,
    ) -> (Incidence<R>, R) {
        let like = site.inverse_distance;
        let (l, attenuation, nearness) = source.reach(site.position, site.inverse_distance);
        let nearest = nearness.max(like.number(1.0 / FARTHEST));
        let distance = like.number(1.0) / nearest * T::from_f64(self.unit);
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
