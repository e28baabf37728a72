//! The equation itself.

use super::{Exponent, FormTask, Real, Scalar, Source, Specular, SpecularForm, V3, specular};
use crate::scene::{Backfacing, Rgb, Scene, Viewer};
use glam::DVec3;

/// A point where the equation is evaluated. Lengths are camera distances, positions relative to the eye.
#[derive(Clone, Copy, Debug)]
pub struct Site<R> {
    /// N, unit unless the shading mode forgets to make it so.
    pub normal: V3<R>,
    pub position: V3<R>,
    /// V, unit.
    pub view: V3<R>,
    /// 1/distance from the eye.
    pub inverse_distance: R,
}

/// What one light does at a site.
#[derive(Clone, Copy, Debug)]
pub struct LightResponse<R> {
    /// L, unit.
    pub l: V3<R>,
    /// f.
    pub attenuation: R,
    /// N·L, after the policy for surfaces turned away.
    pub n_dot_l: R,
    /// f·max(N·L, 0).
    pub diffuse: R,
    /// f·S where N·L > 0, otherwise 0.
    pub specular: R,
}

/// The coefficients of a scene's equation.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation<T> {
    /// `ka·color·Ia` per channel.
    pub ambient: [T; 3],
    /// One per light of the scene, in its order, black ones included.
    pub sources: Vec<Source<T>>,
    exponent: Exponent<T>,
    backfacing: Backfacing,
    /// V where it is constant.
    infinite_view: Option<[T; 3]>,
    form: SpecularForm,
    /// The eye, world.
    eye: DVec3,
    /// World units to one camera distance.
    unit: f64,
}

impl<T: Scalar> Equation<T> {
    /// Prepares the equation of `scene`.
    pub fn new(scene: &Scene) -> Self {
        let camera = &scene.camera;
        let unit = camera.distance();
        let material = &scene.material;
        let kd_color = material.kd * material.color;
        let backwards = (camera.eye - camera.target).normalize_or_zero();
        Self {
            ambient: (material.ka * material.color * scene.ambient.color).to_array().map(T::from_f64),
            sources: scene
                .lights
                .iter()
                .map(|light| Source::new(light, camera.eye, unit, kd_color, material.ks))
                .collect(),
            exponent: Exponent::new(material.n),
            backfacing: scene.reflection.backfacing,
            infinite_view: (camera.viewer == Viewer::Infinite).then(|| backwards.to_array().map(T::from_f64)),
            form: SpecularForm::of(scene),
            eye: camera.eye,
            unit,
        }
    }

    /// The text of the specular factor that the scene needs.
    pub fn form(&self) -> SpecularForm {
        self.form
    }

    /// Leaves out the lights that cannot add anything.
    pub fn retain_lights(&mut self, keep: impl Fn(usize) -> bool) {
        let mut index = 0;
        self.sources.retain(|_| {
            index += 1;
            keep(index - 1)
        });
    }

    /// World coordinates to the equation's: relative to the eye, in camera distances.
    pub fn from_world(&self, world: DVec3) -> DVec3 {
        (world - self.eye) / self.unit
    }

    /// The site of a point relative to the eye.
    #[inline(always)]
    pub fn site<R: Real<Scalar = T>>(&self, position: V3<R>, normal: V3<R>) -> Site<R> {
        let inverse_distance = position.dot(position).inverse_sqrt();
        let view = match self.infinite_view {
            Some(view) => V3::constant(position.x, view),
            None => -position.scale(inverse_distance),
        };
        Site { normal, position, view, inverse_distance }
    }

    /// What `source` does at `site`: direction, attenuation, Lambert's cosine and the specular factor.
    #[inline(always)]
    pub fn respond<R: Real<Scalar = T>, F: Specular>(&self, source: &Source<T>, site: &Site<R>) -> LightResponse<R> {
        let (l, attenuation) = source.reach(site.position, site.inverse_distance);
        let zero = l.x.constant(T::default());
        let mut turned = *site;
        let mut n_dot_l = site.normal.dot(l);
        if self.backfacing == Backfacing::Flip {
            let away = zero.greater_than(n_dot_l);
            let sign = R::select(away, zero.constant(T::from_f64(-1.0)), zero.constant(T::from_f64(1.0)));
            turned.normal = site.normal.scale(sign);
            n_dot_l = n_dot_l.abs();
        }
        let lit = n_dot_l.greater_than(zero);
        let specular = if F::PRESENT && R::any(lit) {
            let factor = F::factor(&turned, l, n_dot_l, &self.exponent);
            R::select(lit, factor * attenuation, zero)
        } else {
            zero
        };
        LightResponse { l, attenuation, n_dot_l, diffuse: n_dot_l.max(zero) * attenuation, specular }
    }

    /// I at `site`, per channel.
    #[inline(always)]
    pub fn illuminate<R: Real<Scalar = T>, F: Specular>(&self, site: &Site<R>) -> [R; 3] {
        let like = site.inverse_distance;
        let [r, g, b] = self.ambient;
        let mut sum = [like.constant(r), like.constant(g), like.constant(b)];
        for source in &self.sources {
            let response = self.respond::<R, F>(source, site);
            for (channel, total) in sum.iter_mut().enumerate() {
                *total = response.diffuse.mul_add(like.constant(source.diffuse[channel]), *total);
                if F::PRESENT {
                    *total = response.specular.mul_add(like.constant(source.specular[channel]), *total);
                }
            }
        }
        sum
    }
}

impl Equation<f64> {
    /// V at a point of the world.
    pub fn view_at(&self, point: DVec3) -> DVec3 {
        self.site(V3::from(self.from_world(point)), V3::from(DVec3::ZERO)).view.into()
    }

    /// I at a point of the world with normal `n`, per channel: the reference.
    pub fn illuminate_world(&self, point: DVec3, n: DVec3) -> Rgb {
        let site = self.site(V3::from(self.from_world(point)), V3::from(n));
        Rgb::from_array(self.form.dispatch(Illuminate { equation: self, site: &site }))
    }

    /// What the light of index `light` does at a point of the world with normal `n`, with V, R and H there.
    ///
    /// # Panics
    /// If there is no such light.
    pub fn respond_world(&self, light: usize, point: DVec3, n: DVec3) -> (LightResponse<f64>, [DVec3; 3]) {
        let site = self.site(V3::from(self.from_world(point)), V3::from(n));
        let source = &self.sources[light];
        let response = self.form.dispatch(Respond { equation: self, source, site: &site });
        let r = specular::reflect(site.normal, response.l, site.normal.dot(response.l));
        let h = specular::halfway(response.l, site.view);
        (response, [site.view.into(), r.into(), h.into()])
    }
}

struct Illuminate<'a> {
    equation: &'a Equation<f64>,
    site: &'a Site<f64>,
}

impl FormTask for Illuminate<'_> {
    type Output = [f64; 3];

    fn run<F: Specular>(self, _: F) -> [f64; 3] {
        self.equation.illuminate::<f64, F>(self.site)
    }
}

struct Respond<'a> {
    equation: &'a Equation<f64>,
    source: &'a Source<f64>,
    site: &'a Site<f64>,
}

impl FormTask for Respond<'_> {
    type Output = LightResponse<f64>;

    fn run<F: Specular>(self, _: F) -> LightResponse<f64> {
        self.equation.respond::<f64, F>(self.source, self.site)
    }
}
