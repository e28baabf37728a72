//! The illumination equation itself: the sum over the sources.

mod own_law;

pub(crate) use own_law::SourcePart;

use super::formula::{Law, LawPoint, LawScratch};
use super::fresnel::{Fresnel, Index};
use super::pattern::Fields;
use super::source::{BRIGHTEST, Share};
use super::specular::{greatest_factor, halfway, reflect};
use super::{Lobe, Real, Scalar, ShadingPoint, Source, SpecularForm, V3};
use crate::scene::{
    Backfacing, Projection, ReflectionModel, Rgb, Scene, ShadingMode, View, Viewer,
};
use glam::DVec3;
use std::ops::Range;
use std::sync::Arc;

/// The contribution of one source at a shading point, factor by factor.
#[derive(Clone, Copy, Debug)]
pub struct LightResponse<R> {
    /// L, unit.
    pub l: V3<R>,
    /// f, the attenuation by distance.
    pub attenuation: R,
    /// The part of its intensity that a spot light sends this way; 1 for other lights.
    pub spot: R,
    /// N·L, adjusted by the policy for surfaces turned away.
    pub n_dot_l: R,
    /// f·max(N·L, 0), times the spot's part; 0 in shadow.
    pub diffuse: R,
    /// f·S where the light is above the surface, times the spot's part; otherwise 0.
    pub specular: R,
    /// The cosine of the angle of incidence that W depends on.
    pub incidence: R,
}

/// The shadow bits: one for each source and shading point, set where the source reaches the point.
#[derive(Clone, Copy, Debug)]
pub struct Reached<'a> {
    /// One row of bits for each source, `stride` words long, and one word more at the end.
    pub words: &'a [u64],
    /// The words of one source's row.
    pub stride: usize,
    /// The bit of the first lane's shading point.
    pub first: usize,
}

impl Reached<'_> {
    /// Returns the bits of `this` for lanes that start at shading point `first`.
    #[inline(always)]
    pub fn starting_at(this: Option<Self>, first: usize) -> Option<Self> {
        let reached = this?;
        Some(Self { first, ..reached })
    }

    /// Returns words of bits of other points in the order given, each from its own row and its place there, with `stride`
    /// words for each source; empty where the rows have no bits.
    pub(crate) fn gathered<'a>(
        points: impl ExactSizeIterator<Item = (Option<Reached<'a>>, usize)>,
        sources: usize,
    ) -> (Vec<u64>, usize) {
        let stride = points.len().div_ceil(64);
        let mut words = vec![];
        for (place, (reached, point)) in points.enumerate() {
            let Some(reached) = Reached::starting_at(reached, point) else {
                return (vec![], stride);
            };
            words.resize(sources * stride + 1, 0);
            for source in (0..sources).filter(|source| reached.holds(*source)) {
                words[source * stride + place / 64] |= 1 << (place % 64);
            }
        }
        (words, stride)
    }

    /// Returns whether `source` reaches the first shading point.
    pub(crate) fn holds(self, source: usize) -> bool {
        self.bits(source) & 1 == 1
    }

    /// Returns the bits of `source`, the lowest for the first lane's shading point.
    #[inline(always)]
    fn bits(&self, source: usize) -> u64 {
        let (word, shift) = (source * self.stride + self.first / 64, self.first % 64);
        // Shifted twice, because a shift by 64 is none.
        self.words[word] >> shift | self.words[word + 1] << 1 << (63 - shift)
    }
}

/// The coefficients of a scene's equation.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation<T> {
    /// `ka·color·Ia` per channel; `ka·Ia` where a pattern gives the colour.
    pub ambient: [T; 3],
    /// The sources of the lights in the scene's order, black ones included: one for each light, or several for an area light.
    pub sources: Vec<Source<T>>,
    /// The start of each light's sources, and the end of the last.
    starts: Vec<usize>,
    lobe: Lobe<T>,
    fresnel: Option<Fresnel<T>>,
    pattern: Option<Patterned<T>>,
    backfacing: Backfacing,
    /// The height over the tangent plane, in camera distances, and the N·L from which a light counts as above the surface.
    /// Below, rounding would switch the highlight on and off.
    grazing: [T; 2],
    /// V, if it is constant.
    infinite_view: Option<[T; 3]>,
    form: SpecularForm,
    /// The law in place of both terms; [`Source::diffuse`] is then Ip alone.
    law: Option<Arc<Law>>,
    /// The values that the law computes once for each source, source by source.
    known: Vec<Vec<T>>,
    /// True if any light is reflected diffusely.
    diffuses: bool,
    /// The eye, world.
    eye: DVec3,
    /// World units to one camera distance.
    unit: f64,
}

/// The surface's colour where a pattern varies it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Patterned<T> {
    fields: Fields<T>,
    /// Od between the fields, and on them.
    colors: [[T; 3]; 2],
}

impl<T: Scalar> Patterned<T> {
    #[inline(always)]
    fn color<R: Real<Scalar = T>>(&self, position: V3<R>) -> [R; 3] {
        let on = self.fields.lie_on(position);
        let [between, pattern] = &self.colors;
        let of = V3::constant(position.x, *pattern);
        let other = V3::constant(position.x, *between);
        [
            R::select(on, of.x, other.x),
            R::select(on, of.y, other.y),
            R::select(on, of.z, other.z),
        ]
    }
}

impl<T: Scalar> Equation<T> {
    /// Prepares the equation of `scene`, with lengths in camera distances.
    pub fn new(scene: &Scene) -> Self {
        Self::in_units(scene, scene.camera.distance())
    }

    /// Prepares the equation of `scene`, with lengths in units of `unit` world units.
    pub(crate) fn in_units(scene: &Scene, unit: f64) -> Self {
        let camera = &scene.camera;
        let material = &scene.material;
        let axis = if scene.object.kind.faces_viewer() {
            2
        } else {
            1
        };
        let pattern = Fields::new(
            scene.pattern.kind,
            scene.pattern.scale,
            axis,
            camera.eye,
            unit,
        )
        .map(|fields| {
            let colors = [material.color, scene.pattern.color]
                .map(|color| color.to_array().map(T::from_f64));
            Patterned { fields, colors }
        });
        // A pattern's colour is a separate factor at each point, at most `tint`.
        let (color, tint) = if pattern.is_some() {
            let brightest = material.color.max(scene.pattern.color);
            (Rgb::ONE, brightest.max_element().max(1.0))
        } else {
            (material.color, 1.0)
        };
        let backwards = (camera.eye - camera.target).normalize_or_zero();
        let soloing = scene.soloing();
        let peak = match scene.reflection.model {
            ReflectionModel::Phong | ReflectionModel::Blinn | ReflectionModel::Formula => 1.0,
            ReflectionModel::CookTorrance => greatest_factor(material.roughness),
        };
        let count: usize = scene
            .lights
            .iter()
            .map(|light| light.sample_count() as usize)
            .sum();
        let share = Share::new(count, tint, peak);
        let mut sources = Vec::with_capacity(count);
        let mut starts = vec![0];
        let has_law = scene.reflection.is_own_law();
        let coefficients = if has_law {
            [Rgb::ONE, Rgb::ZERO]
        } else {
            [material.kd * color, material.ks * material.specular_color]
        };
        for light in &scene.lights {
            let on = if light.shines(soloing) { 1.0 } else { 0.0 };
            sources.extend(Source::all_of(
                light,
                camera.eye,
                unit,
                coefficients.map(|of| of * on),
                share,
            ));
            starts.push(sources.len());
        }
        let zero = [T::default(); 3];
        let infinite = camera.viewer == Viewer::Infinite;
        let parallel = sources.iter().all(Source::is_parallel);
        let law = has_law.then(|| Arc::new(own_law::law_of(scene, pattern.is_some(), parallel)));
        let mut equation = Self {
            diffuses: sources.iter().any(|source| source.diffuse != zero),
            ambient: (material.ka * color * scene.ambient.constant())
                .min(Rgb::splat(BRIGHTEST / tint))
                .to_array()
                .map(T::from_f64),
            sources,
            starts,
            lobe: Lobe::of(material),
            fresnel: Index::of(material).map(Fresnel::new),
            pattern,
            backfacing: scene.reflection.backfacing,
            grazing: grazing(scene, unit, T::ROUNDING, T::GRID).map(T::from_f64),
            infinite_view: infinite.then(|| backwards.to_array().map(T::from_f64)),
            form: SpecularForm::of(scene),
            law,
            known: vec![],
            eye: camera.eye,
            unit,
        };
        equation.prepare_law();
        equation
    }

    /// Returns the form of the specular factor that the scene needs.
    pub fn form(&self) -> SpecularForm {
        self.form
    }

    /// Drops the lights that cannot add anything: they keep no sources, and the specular form becomes `None` if no light needs it.
    pub fn retain_lights(&mut self, keep: impl Fn(usize) -> bool) {
        let mut kept = Vec::with_capacity(self.sources.len());
        let mut starts = vec![0];
        for light in 0..self.starts.len() - 1 {
            if keep(light) {
                kept.extend_from_slice(&self.sources[self.sources_of(light)]);
            }
            starts.push(kept.len());
        }
        (self.sources, self.starts) = (kept, starts);
        self.prepare_law();
        let zero = [T::default(); 3];
        self.diffuses = self.sources.iter().any(|source| source.diffuse != zero);
        if self.law.is_none() && self.sources.iter().all(|source| source.specular == zero) {
            self.form = SpecularForm::None;
        }
    }

    /// Returns the equation without its ambient term.
    #[must_use]
    pub(crate) fn without_ambient(self) -> Self {
        Self {
            ambient: [T::default(); 3],
            ..self
        }
    }

    /// Evaluates terms even where the scene's numbers make them 0, and f even where it is 1.
    pub fn leave_nothing_out(&mut self, scene: &Scene) {
        self.form = SpecularForm::of_model(scene);
        self.diffuses = true;
        self.sources
            .iter_mut()
            .for_each(Source::evaluate_attenuation);
    }

    /// Returns the number of lights in the scene, those without sources included.
    pub fn light_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Returns the indices of one light's sources.
    ///
    /// # Panics
    /// If there is no such light.
    pub fn sources_of(&self, light: usize) -> Range<usize> {
        self.starts[light]..self.starts[light + 1]
    }

    /// Converts world coordinates to the equation's: relative to the eye, in camera distances.
    pub fn from_world(&self, world: DVec3) -> DVec3 {
        (world - self.eye) / self.unit
    }

    /// Returns the shading point at a position relative to the eye.
    #[inline(always)]
    pub fn site<R: Real<Scalar = T>>(&self, position: V3<R>, normal: V3<R>) -> ShadingPoint<R> {
        let inverse_distance = position.dot(position).inverse_sqrt();
        let view = match self.infinite_view {
            Some(view) => V3::constant(position.x, view),
            None => -position.scale(inverse_distance),
        };
        ShadingPoint {
            normal,
            position,
            view,
            inverse_distance,
        }
    }

    /// Evaluates one source at a shading point: its direction, attenuation, Lambert's cosine and the specular factor.
    #[inline(always)]
    pub fn respond<R: Real<Scalar = T>>(
        &self,
        form: SpecularForm,
        source: &Source<T>,
        site: &ShadingPoint<R>,
    ) -> LightResponse<R> {
        let (l, attenuation, nearness) = source.reach(site.position, site.inverse_distance);
        let spot = source.spot(l);
        let strength = attenuation * spot;
        let zero = l.x.number(0.0);
        let mut turned = *site;
        let mut n_dot_l = site.normal.dot(l);
        if self.backfacing == Backfacing::Flip {
            let away = zero.greater_than(n_dot_l);
            let sign = R::select(away, zero.number(-1.0), zero.number(1.0));
            turned.normal = site.normal.scale(sign);
            n_dot_l = n_dot_l.abs();
        }
        let lit = n_dot_l.greater_than(self.grazing_at(nearness));
        let specular = if form != SpecularForm::None && R::any(lit) {
            let factor = form.factor(&turned, l, n_dot_l, &self.lobe);
            R::select(lit, factor * strength, zero)
        } else {
            zero
        };
        let diffuse = R::select(lit, n_dot_l * strength, zero);
        LightResponse {
            l,
            attenuation,
            spot,
            n_dot_l,
            diffuse,
            specular,
            incidence: form.incidence(site, l, n_dot_l),
        }
    }

    /// Returns the N·L from which a source counts at a point, where its distance is that from which [`Source::reach`] has `nearness`.
    #[inline(always)]
    pub(crate) fn grazing_at<R: Real<Scalar = T>>(&self, nearness: R) -> R {
        let [height, cosine] = self.grazing.map(|min| nearness.constant(min));
        nearness.mul_add(height, cosine)
    }

    /// Returns I at a shading point, per channel. Sources that are not among `reached` are in shadow; without `reached`
    /// there are no shadows.
    #[inline(always)]
    pub fn illuminate<R: Real<Scalar = T>>(
        &self,
        site: &ShadingPoint<R>,
        reached: Option<Reached<'_>>,
    ) -> [R; 3] {
        self.illuminate_site(site, reached, None, &mut LawScratch::default())
            .0
    }

    /// Returns the ambient term at a shading point, and what varies of Od there: the pattern's colour times `tint`.
    #[inline(always)]
    fn ambient_at<R: Real<Scalar = T>>(
        &self,
        site: &ShadingPoint<R>,
        tint: Option<[R; 3]>,
    ) -> ([R; 3], Option<[R; 3]>) {
        let V3 { x: r, y: g, z: b } = V3::constant(site.inverse_distance, self.ambient);
        let color = self
            .pattern
            .as_ref()
            .map(|pattern| pattern.color(site.position));
        let color = match (color, tint) {
            (Some([r, g, b]), Some(tint)) => Some([r * tint[0], g * tint[1], b * tint[2]]),
            (color, tint) => color.or(tint),
        };
        match color {
            Some(color) => ([r * color[0], g * color[1], b * color[2]], Some(color)),
            None => ([r, g, b], None),
        }
    }

    /// Returns I as [`Self::illuminate`] does; `tint` multiplies Od. The second value is 1 where the scene's own law is undefined,
    /// otherwise 0; `scratch` is that of this equation's points before, or new.
    #[inline(always)]
    pub(crate) fn illuminate_site<R: Real<Scalar = T>>(
        &self,
        site: &ShadingPoint<R>,
        reached: Option<Reached<'_>>,
        tint: Option<[R; 3]>,
        scratch: &mut LawScratch<R>,
    ) -> ([R; 3], R) {
        if self.law.is_none() {
            let color = self.illuminate_by(self.form, site, reached, tint);
            return (color, site.inverse_distance.number(0.0));
        }
        let point = self.law_point(*site, tint);
        scratch.points.clear();
        scratch.points.push(point);
        self.add_law(0..self.sources.len(), reached, scratch);
        let LawPoint { sum, undefined, .. } = scratch.points[0];
        (sum, undefined)
    }

    /// Returns I by a given form of the specular factor, not the scene's own law: where it is a constant, the other forms are not
    /// compiled in. `tint` multiplies Od.
    #[inline(always)]
    pub(crate) fn illuminate_by<R: Real<Scalar = T>>(
        &self,
        form: SpecularForm,
        site: &ShadingPoint<R>,
        reached: Option<Reached<'_>>,
        tint: Option<[R; 3]>,
    ) -> [R; 3] {
        let like = site.inverse_distance;
        let (mut sum, color) = self.ambient_at(site, tint);
        for (index, source) in self.sources.iter().enumerate() {
            if reached.is_some_and(|reached| like.holds_none(reached.bits(index))) {
                continue;
            }
            let mut response = self.respond(form, source, site);
            if let Some(reached) = reached {
                let (lit, zero) = (like.mask_of_bits(reached.bits(index)), like.number(0.0));
                response.diffuse = R::select(lit, response.diffuse, zero);
                response.specular = R::select(lit, response.specular, zero);
            }
            if self.diffuses {
                let mut diffuse = V3::constant(like, source.diffuse);
                if let Some([r, g, b]) = color {
                    diffuse = V3::new(diffuse.x * r, diffuse.y * g, diffuse.z * b);
                }
                add(&mut sum, response.diffuse, diffuse);
            }
            if form != SpecularForm::None {
                let mut specular = V3::constant(like, source.specular);
                if let Some(fresnel) = &self.fresnel {
                    let [r, g, b] = fresnel.reflectance(response.incidence);
                    specular = V3::new(specular.x * r, specular.y * g, specular.z * b);
                }
                add(&mut sum, response.specular, specular);
            }
        }
        sum
    }
}

/// Adds `factor` times a colour.
#[inline(always)]
fn add<R: Real>(sum: &mut [R; 3], factor: R, color: V3<R>) {
    sum[0] = factor.mul_add(color.x, sum[0]);
    sum[1] = factor.mul_add(color.y, sum[1]);
    sum[2] = factor.mul_add(color.z, sum[2]);
}

impl Equation<f32> {
    /// Skips powers of a cosine that add nothing visible.
    pub fn leave_out_faint(&mut self) {
        let most = self.sources.iter().map(Source::greatest_specular).sum();
        self.lobe.leave_out_faint(most);
    }
}

/// Returns the height over the tangent plane, in camera distances, and the N·L from which a light counts. Positions and
/// directions are rounded to `rounding`, vertices to `grid` pixels. Two-sided surfaces have no step there; a true surface
/// has no vertices.
fn grazing(scene: &Scene, unit: f64, rounding: f64, grid: f64) -> [f64; 2] {
    if scene.reflection.backfacing == Backfacing::Flip {
        return [0.0; 2];
    }
    let scale = View::new(&scene.camera, scene.image.size).scale;
    let pixels = match scene.camera.projection {
        Projection::Perspective => scale,
        Projection::Orthographic => scale * unit,
    };
    [
        rounding
            + if scene.shading.mode == ShadingMode::Exact {
                0.0
            } else {
                grid / pixels
            },
        rounding,
    ]
}

/// The contribution of one light at a point; an area light's samples are combined.
#[derive(Clone, Copy, Debug, Default)]
pub struct LightAt {
    /// L, unit; towards the middle of an area light.
    pub l: DVec3,
    /// V at the point, unit.
    pub v: DVec3,
    /// R, L mirrored at N: `2N(N·L) − L`.
    pub r: DVec3,
    /// H, halfway between L and V; zero where these are opposite.
    pub h: DVec3,
    /// f; the mean over an area light's samples.
    pub attenuation: f64,
    /// The part that a spot light sends this way; 1 for other lights.
    pub spot: f64,
    /// W per channel; the mean over an area light's samples.
    pub reflectance: Rgb,
    /// The angle of incidence that W depends on, radians; towards the middle of an area light.
    pub incidence: f64,
    /// The fraction of the samples that are not in shadow.
    pub reached: f64,
    /// f·max(N·L, 0), 0 in shadow; the mean over an area light's samples.
    pub diffuse_factor: f64,
    /// f·S, 0 in shadow; the mean over an area light's samples.
    pub specular_factor: f64,
    /// The light's addition to the diffuse term, per channel.
    pub diffuse: Rgb,
    /// The light's addition to the specular term, per channel.
    pub specular: Rgb,
}

impl Equation<f64> {
    /// Returns the vector from a point of the world towards a source, and the source's distance in multiples of its length:
    /// almost infinite for parallel rays.
    ///
    /// # Panics
    /// If there is no such source.
    pub fn way_to(&self, source: usize, point: DVec3) -> (DVec3, f64) {
        let (way, times) = self.sources[source].way(V3::from(self.from_world(point)));
        (DVec3::from(way) * self.unit, times)
    }

    /// Returns the shading point at a point of the world with normal `n`.
    fn site_at(&self, point: DVec3, n: DVec3) -> ShadingPoint<f64> {
        self.site(V3::from(self.from_world(point)), V3::from(n))
    }

    /// Returns V at a point of the world.
    pub fn view_at(&self, point: DVec3) -> DVec3 {
        self.site_at(point, DVec3::ZERO).view.into()
    }

    /// Returns whether a pattern varies Od.
    pub fn has_pattern(&self) -> bool {
        self.pattern.is_some()
    }

    /// Returns Od at a point of the world where a pattern varies it; white where it is part of the coefficients.
    pub fn pattern_color(&self, point: DVec3) -> Rgb {
        self.pattern.map_or(Rgb::ONE, |pattern| {
            Rgb::from_array(pattern.color(V3::from(self.from_world(point))))
        })
    }

    /// Returns W per channel at the angle of incidence whose cosine is `cosine`.
    pub fn reflectance(&self, cosine: f64) -> Rgb {
        self.fresnel.map_or(Rgb::ONE, |fresnel| {
            Rgb::from_array(fresnel.reflectance(cosine))
        })
    }

    /// Returns I at a point of the world with normal `n`, per channel: the reference. Without `reached` all sources reach it.
    pub fn illuminate_world(&self, point: DVec3, n: DVec3, reached: Option<Reached<'_>>) -> Rgb {
        let site = self.site_at(point, n);
        Rgb::from_array(self.illuminate(&site, reached))
    }

    /// Returns I at a point of the world as [`Self::illuminate_world`] does, with `tint` times Od, seen from the direction `v`,
    /// unit; without it as in the picture.
    pub fn illuminate_tinted(
        &self,
        (point, n): (DVec3, DVec3),
        tint: Rgb,
        v: Option<DVec3>,
        reached: Option<Reached<'_>>,
    ) -> Rgb {
        let mut site = self.site_at(point, n);
        if let Some(v) = v {
            site.view = V3::from(v);
        }
        let tint = Some(tint.to_array());
        let scratch = &mut LawScratch::default();
        let (color, _) = self.illuminate_site(&site, reached, tint, scratch);
        Rgb::from_array(color)
    }

    /// Evaluates one source as [`Self::respond`] does, with the scene's specular form.
    pub fn respond_to(&self, source: &Source<f64>, site: &ShadingPoint<f64>) -> LightResponse<f64> {
        self.respond(self.form, source, site)
    }

    /// Returns whether the scene's own law is undefined at a point of the world with normal `n`; `tint` multiplies Od.
    pub(crate) fn is_undefined(
        &self,
        (point, n): (DVec3, DVec3),
        tint: Rgb,
        reached: Option<Reached<'_>>,
    ) -> bool {
        let may = self.law.as_ref().is_some_and(|law| law.may_be_undefined());
        if !may {
            return false;
        }
        let site = self.site_at(point, n);
        let tint = Some(tint.to_array());
        let scratch = &mut LawScratch::default();
        let (_, undefined) = self.illuminate_site(&site, reached, tint, scratch);
        undefined > 0.0
    }

    /// Returns the contribution of the light of index `light` at a point of the world with normal `n`.
    ///
    /// # Panics
    /// If there is no such light.
    pub fn respond_world(
        &self,
        light: usize,
        point: DVec3,
        n: DVec3,
        reached: Option<Reached<'_>>,
    ) -> LightAt {
        self.respond_tinted(light, (point, n), Rgb::ONE, reached)
    }

    /// Returns the contribution of a light as [`Self::respond_world`] does, with `tint` times Od.
    ///
    /// # Panics
    /// If there is no such light.
    pub fn respond_tinted(
        &self,
        light: usize,
        (point, n): (DVec3, DVec3),
        tint: Rgb,
        reached: Option<Reached<'_>>,
    ) -> LightAt {
        let site = self.site_at(point, n);
        let color = self.pattern_color(point) * tint;
        let range = self.sources_of(light);
        let share = 1.0 / range.len().max(1) as f64;
        let mut sum = LightAt {
            v: site.view.into(),
            ..LightAt::default()
        };
        if self.law.is_some() {
            sum.diffuse = self.reflected_by_law(range.clone(), &site, color, reached);
        }
        for index in range {
            let source = &self.sources[index];
            let response = self.respond_to(source, &site);
            let lit = if reached.is_none_or(|reached| reached.holds(index)) {
                1.0
            } else {
                0.0
            };
            let reflectance = self.reflectance(response.incidence);
            sum.l += DVec3::from(response.l);
            sum.attenuation += share * response.attenuation;
            sum.spot += share * response.spot;
            sum.reflectance += share * reflectance;
            sum.reached += share * lit;
            sum.diffuse_factor += share * lit * response.diffuse;
            sum.specular_factor += share * lit * response.specular;
            if self.law.is_some() {
                continue;
            }
            sum.diffuse += Rgb::from_array(source.diffuse) * color * (lit * response.diffuse);
            sum.specular +=
                Rgb::from_array(source.specular) * reflectance * (lit * response.specular);
        }
        sum.l = sum.l.normalize_or(n);
        let l = V3::from(sum.l);
        sum.r = reflect(site.normal, l, site.normal.dot(l)).into();
        sum.h = halfway(l, site.view).into();
        let n_dot_l = n.dot(sum.l);
        let cosine = if self.form.at_halfway() {
            sum.l.dot(sum.h)
        } else {
            n_dot_l.abs()
        };
        sum.incidence = cosine.clamp(-1.0, 1.0).acos();
        sum
    }
}
