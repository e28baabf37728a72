//! The sum over the sources by the scene's own law.

use super::{Equation, Reached};
use crate::illumination::formula::{
    Constancy, GROUPS_TOGETHER, Incidence, Law, LawLines, LawPart, LawPoint, LawScratch, LawSite,
    LawValues,
};
use crate::illumination::source::BRIGHTEST;
use crate::illumination::{LANES, Real, Scalar, ShadingPoint, Source, V3};
use crate::scene::{ObjectKind, Rgb, Scene, Viewer};
use glam::DVec3;
use std::ops::Range;

/// The distance in camera distances that counts as that of parallel rays.
const FARTHEST: f64 = 1e12;

/// The part of one source at a point: the law's factors times coefficients.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SourcePart {
    pub site: LawSite<f64>,
    /// `f·Ip` times the spot's part, per channel.
    pub coefficients: [f64; 3],
    /// The reciprocal of the source's distance in camera distances; 0 for parallel rays.
    pub nearness: f64,
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
                Some(law.known(&Incidence {
                    l: V3::from(DVec3::from(l)),
                    distance,
                    grazing: self.grazing[1].to_f64(),
                }))
            });
            let rounded = |known: Vec<f64>| known.into_iter().map(T::from_f64).collect();
            self.known = known.map(rounded).collect();
        }
    }

    /// Returns the parts of the scene's own law, with the numbers of their operations; none where it has none.
    pub fn law_parts(&self) -> Option<&[LawPart]> {
        self.law.as_deref().map(Law::parts)
    }

    /// Returns a shading point at which the scene's own law is yet to be evaluated; `tint` multiplies Od.
    #[inline(always)]
    pub(crate) fn law_point<R: Real<Scalar = T>>(
        &self,
        site: ShadingPoint<R>,
        tint: Option<[R; 3]>,
    ) -> LawPoint<R> {
        let (sum, color) = self.ambient_at(&site, tint);
        LawPoint {
            undefined: site.inverse_distance.number(0.0),
            site,
            color,
            sum,
        }
    }

    /// Adds the parts of some sources by the scene's own law to the points of `scratch`: at most an equal share of [`BRIGHTEST`]
    /// each, and 0 where the law has no value. The lanes of all groups of points follow one another in `reached`.
    // In one copy for all shaders.
    #[inline(never)]
    pub(crate) fn add_law<R: Real<Scalar = T>>(
        &self,
        sources: Range<usize>,
        reached: Option<Reached<'_>>,
        LawScratch { points, registers }: &mut LawScratch<R>,
    ) {
        let (Some(law), Some(first)) = (&self.law, points.first()) else {
            return;
        };
        let like = first.undefined;
        like.vectorize(
            #[inline(always)]
            || {
                let zero = like.number(0.0);
                let limit = like.number(BRIGHTEST / self.sources.len().max(1) as f64);
                let mut at = law.at(points, registers, like);
                for index in sources {
                    let source = &self.sources[index];
                    let known = self.known.get(index).map_or(&[][..], Vec::as_slice);
                    let lit = |group: usize| {
                        let all = reached?;
                        let of_group = Reached {
                            first: all.first + group * LANES,
                            ..all
                        };
                        Some(of_group.bits(index))
                    };
                    let is_dark =
                        |group: usize| lit(group).is_some_and(|bits| like.holds_none(bits));
                    if (0..points.len()).all(is_dark) {
                        continue;
                    }
                    let mut strengths = [zero; GROUPS_TOGETHER];
                    for (group, (point, own)) in points.iter().zip(&mut strengths).enumerate() {
                        let (incidence, strength, _) = self.incidence(source, &point.site);
                        at.put(group, &incidence, known);
                        *own = strength;
                    }
                    at.run(points.len());
                    for (group, (point, strength)) in points.iter_mut().zip(strengths).enumerate() {
                        let mask = lit(group).map(|bits| like.mask_of_bits(bits));
                        let V3 { x, y, z } = V3::constant(strength, source.diffuse);
                        let factors = at.factors(group).into_iter().zip([x, y, z]);
                        for (sum, (factor, ip)) in point.sum.iter_mut().zip(factors) {
                            let part = factor * ip * strength;
                            // The absolute value of what is not a number is not above −1, either.
                            let is_number = part.abs().greater_than(strength.number(-1.0));
                            let part = R::select(is_number, part.min(limit).max(-limit), zero);
                            *sum = *sum + mask.map_or(part, |mask| R::select(mask, part, zero));
                        }
                        if law.may_be_undefined() {
                            let own = at.undefined(group);
                            let own = mask.map_or(own, |mask| R::select(mask, own, zero));
                            point.undefined = point.undefined.max(own);
                        }
                    }
                }
            },
        );
    }

    /// Returns what the law knows of a source at a point, its distance only if the law depends on it; the attenuation times the spot's part;
    /// and the reciprocal of the distance in camera distances, 0 for parallel rays.
    #[inline(always)]
    fn incidence<R: Real<Scalar = T>>(
        &self,
        source: &Source<T>,
        site: &ShadingPoint<R>,
    ) -> (Incidence<R>, R, R) {
        let like = site.inverse_distance;
        let (l, attenuation, nearness) = source.reach(site.position, site.inverse_distance);
        let mut distance = like.number(0.0);
        if self.law.as_ref().is_some_and(|law| law.names_distance()) {
            let nearest = nearness.max(like.number(1.0 / FARTHEST));
            distance = like.number(1.0) / nearest * T::from_f64(self.unit);
        }
        let grazing = self.grazing_at(nearness);
        let incidence = Incidence {
            l,
            distance,
            grazing,
        };
        (incidence, attenuation * source.spot(l), nearness)
    }
}

impl Equation<f64> {
    /// Returns what the scene's own law reflects of some sources at a point, where Od is `color`.
    pub(super) fn reflected_by_law(
        &self,
        sources: Range<usize>,
        site: &ShadingPoint<f64>,
        color: Rgb,
        reached: Option<Reached<'_>>,
    ) -> Rgb {
        let mut scratch = LawScratch::default();
        scratch.points.push(LawPoint {
            site: *site,
            color: Some(color.to_array()),
            sum: [0.0; 3],
            undefined: 0.0,
        });
        self.add_law(sources, reached, &mut scratch);
        Rgb::from_array(scratch.points[0].sum)
    }

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
            grazing: self.grazing_at(self.unit / distance),
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
            let (incidence, strength, nearness) = self.incidence(source, &site);
            SourcePart {
                site: LawSite {
                    normal: V3::from(n),
                    view: site.view,
                    color: Some(color),
                    incidence,
                },
                coefficients: source.diffuse.map(|ip| ip * strength),
                nearness,
            }
        };
        reaching.map(part).collect()
    }
}
