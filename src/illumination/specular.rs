//! The specular factor S: Phong's `(R·V)^n` and Blinn's `(N·H)^n`, each in two forms, and Cook and Torrance's microfacets.
//!
//! A power of a cosine is stiff: an error δ of the cosine becomes n·δ of the result, and near the lobe's axis the cosine
//! itself is rounded to a few 10⁻⁸ in single precision. With the chord between the two unit vectors,
//! `1 − a·b = |a − b|²/2`, the distance from the axis keeps its digits, and `(a·b)^n = exp(n·ln(1 − |a − b|²/2))`. At
//! small n the plain cosine is the better form, because the lobe is wide and the chord long.

use super::lobe::Lobe;
use super::microfacet::{beckmann, geometric_over_view, ggx, seen, smith_over_view};
use super::{Real, Scalar, ShadingPoint, V3};
use crate::scene::{Distribution, ReflectionModel, Rgb, Scene, ShadingMode};

/// Which form of the specular factor a scene needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpecularForm {
    /// No light is reflected specularly.
    None,
    PhongCosine,
    PhongChord,
    BlinnCosine,
    BlinnChord,
    Beckmann,
    Ggx,
}

impl SpecularForm {
    /// From this n on the chord form is used. Where the chord's logarithm ends, at `1 − a·b` = 0.29, the power is then
    /// below 0.71⁶⁴ = 3·10⁻¹⁰ and counts as 0, and below it the cosine form loses less than 64 · 10⁻⁷.
    pub const CHORD_FROM: f64 = 64.0;

    /// The form that `scene` needs. Normals that are left short of unit length have no chord.
    pub fn of(scene: &Scene) -> Self {
        let (soloing, ks) = (scene.soloing(), scene.material.ks * scene.material.specular_color);
        let lit = scene.lights.iter().any(|light| light.shines(soloing) && ks * light.color != Rgb::ZERO);
        if lit { Self::of_model(scene) } else { Self::None }
    }

    /// The form that `scene` would need whatever its coefficients.
    pub(super) fn of_model(scene: &Scene) -> Self {
        let shading = &scene.shading;
        let unit_normals = shading.renormalise || shading.mode != ShadingMode::Phong;
        let chord = scene.material.n >= Self::CHORD_FROM && unit_normals;
        match scene.reflection.model {
            ReflectionModel::Phong if chord => Self::PhongChord,
            ReflectionModel::Phong => Self::PhongCosine,
            ReflectionModel::Blinn if chord => Self::BlinnChord,
            ReflectionModel::Blinn => Self::BlinnCosine,
            ReflectionModel::CookTorrance => match scene.reflection.distribution {
                Distribution::Beckmann => Self::Beckmann,
                Distribution::Ggx => Self::Ggx,
            },
        }
    }
}

/// Work that is compiled once for each specular form.
pub trait FormTask {
    type Output;

    fn run<F: Specular>(self, form: F) -> Self::Output;
}

impl SpecularForm {
    /// Whether W depends on the angle between L and H instead of that between L and N.
    pub fn at_halfway(self) -> bool {
        matches!(self, Self::BlinnCosine | Self::BlinnChord | Self::Beckmann | Self::Ggx)
    }

    /// Runs `task` with the type that stands for this form.
    pub fn dispatch<T: FormTask>(self, task: T) -> T::Output {
        match self {
            Self::None => task.run(NoSpecular),
            Self::PhongCosine => task.run(PhongCosine),
            Self::PhongChord => task.run(PhongChord),
            Self::BlinnCosine => task.run(BlinnCosine),
            Self::BlinnChord => task.run(BlinnChord),
            Self::Beckmann => task.run(Beckmann),
            Self::Ggx => task.run(Ggx),
        }
    }
}

/// The specular factor of one light, a type for each form so that loops carry no choice.
pub trait Specular: Copy + Send + Sync + 'static {
    const PRESENT: bool = true;

    /// Whether light is mirrored at H, so that W depends on the angle between L and H instead of that between L and N.
    const AT_HALFWAY: bool = false;

    /// S at `shading point` for the unit direction `l` to the light and `n_dot_l` = N·L.
    fn factor<R: Real>(site: &ShadingPoint<R>, l: V3<R>, n_dot_l: R, lobe: &Lobe<R::Scalar>) -> R;

    /// The cosine of the angle of incidence.
    #[inline(always)]
    fn incidence<R: Real>(site: &ShadingPoint<R>, l: V3<R>, n_dot_l: R) -> R {
        if Self::AT_HALFWAY {
            // |L + V|/2 is the cosine of half the angle between them.
            let sum = l + site.view;
            sum.dot(sum).sqrt() * R::Scalar::from_f64(0.5)
        } else {
            n_dot_l
        }
    }
}

/// ks = 0.
#[derive(Clone, Copy, Debug)]
pub struct NoSpecular;
#[derive(Clone, Copy, Debug)]
pub struct PhongCosine;
#[derive(Clone, Copy, Debug)]
pub struct PhongChord;
#[derive(Clone, Copy, Debug)]
pub struct BlinnCosine;
#[derive(Clone, Copy, Debug)]
pub struct BlinnChord;
/// Cook and Torrance's model with Beckmann's distribution.
#[derive(Clone, Copy, Debug)]
pub struct Beckmann;
/// The same with the distribution of Walter et al.
#[derive(Clone, Copy, Debug)]
pub struct Ggx;

impl Specular for NoSpecular {
    const PRESENT: bool = false;

    #[inline(always)]
    fn factor<R: Real>(_: &ShadingPoint<R>, _: V3<R>, n_dot_l: R, _: &Lobe<R::Scalar>) -> R {
        n_dot_l.constant(R::Scalar::default())
    }
}

/// `R = 2N(N·L) − L`, L mirrored at N.
#[inline(always)]
pub(super) fn reflect<R: Real>(n: V3<R>, l: V3<R>, n_dot_l: R) -> V3<R> {
    n.scale_add(n_dot_l + n_dot_l, -l)
}

/// `H = (L + V)/|L + V|`, half-way between the light and the viewer.
#[inline(always)]
pub(super) fn halfway<R: Real>(l: V3<R>, v: V3<R>) -> V3<R> {
    (l + v).normalised()
}

/// `max(c, 0)^n`, from the cosine, which rounding may take past 1.
#[inline(always)]
fn power_of_cosine<R: Real>(c: R, lobe: &Lobe<R::Scalar>) -> R {
    let zero = c.constant(R::Scalar::default());
    if !R::any(c.greater_than(c.constant(lobe.faint))) {
        return zero;
    }
    let tiny = c.constant(R::Scalar::from_f64(f64::from(f32::MIN_POSITIVE)));
    let one = c.constant(R::Scalar::from_f64(1.0));
    let power = (c.max(tiny).min(one).log2() * lobe.n).exp2();
    R::select(c.greater_than(zero), power, c.constant(lobe.at_zero))
}

/// `(a·b)^n` of two unit vectors, from the chord between them.
#[inline(always)]
fn power_of_chord<R: Real>(a: V3<R>, b: V3<R>, lobe: &Lobe<R::Scalar>) -> R {
    let chord = a - b;
    let t = chord.dot(chord) * R::Scalar::from_f64(0.5);
    let limit = t.constant(R::Scalar::from_f64(0.29));
    let (zero, one) = (t.constant(R::Scalar::default()), t.constant(R::Scalar::from_f64(1.0)));
    if !R::any((one - t).greater_than(t.constant(lobe.faint)) & limit.greater_than(t)) {
        return zero;
    }
    let power = (R::log2_one_minus(t.min(limit)) * lobe.n).exp2();
    R::select(limit.greater_than(t), power, zero)
}

impl Specular for PhongCosine {
    #[inline(always)]
    fn factor<R: Real>(site: &ShadingPoint<R>, l: V3<R>, n_dot_l: R, lobe: &Lobe<R::Scalar>) -> R {
        // R·V without R: 2(N·L)(N·V) − L·V.
        let n_dot_v = site.normal.dot(site.view);
        power_of_cosine((n_dot_l + n_dot_l).mul_add(n_dot_v, -l.dot(site.view)), lobe)
    }
}

impl Specular for PhongChord {
    #[inline(always)]
    fn factor<R: Real>(site: &ShadingPoint<R>, l: V3<R>, n_dot_l: R, lobe: &Lobe<R::Scalar>) -> R {
        power_of_chord(reflect(site.normal, l, n_dot_l), site.view, lobe)
    }
}

impl Specular for BlinnCosine {
    const AT_HALFWAY: bool = true;

    #[inline(always)]
    fn factor<R: Real>(site: &ShadingPoint<R>, l: V3<R>, _: R, lobe: &Lobe<R::Scalar>) -> R {
        power_of_cosine(site.normal.dot(halfway(l, site.view)), lobe)
    }
}

impl Specular for BlinnChord {
    const AT_HALFWAY: bool = true;

    #[inline(always)]
    fn factor<R: Real>(site: &ShadingPoint<R>, l: V3<R>, _: R, lobe: &Lobe<R::Scalar>) -> R {
        power_of_chord(site.normal, halfway(l, site.view), lobe)
    }
}

/// `D·G·π/(4·(N·V))`; F is W(θ), per channel, and multiplied outside.
///
/// With a light's intensity so counted that Lambert's term is `kd·(N·L)`, a BRDF f contributes `π·f·(N·L)`, and Cook and
/// Torrance's is `D·F·G/(4·(N·L)·(N·V))`.
impl Specular for Beckmann {
    const AT_HALFWAY: bool = true;

    #[inline(always)]
    fn factor<R: Real>(site: &ShadingPoint<R>, l: V3<R>, n_dot_l: R, lobe: &Lobe<R::Scalar>) -> R {
        let f = Facet::new(site, l);
        f.factor(beckmann(f.gap, lobe), geometric_over_view(f.n_dot_h, n_dot_l, f.n_dot_v, f.v_dot_h))
    }
}

impl Specular for Ggx {
    const AT_HALFWAY: bool = true;

    #[inline(always)]
    fn factor<R: Real>(site: &ShadingPoint<R>, l: V3<R>, n_dot_l: R, lobe: &Lobe<R::Scalar>) -> R {
        let f = Facet::new(site, l);
        f.factor(ggx(f.gap, lobe), smith_over_view(n_dot_l, f.n_dot_v, lobe))
    }
}

/// The microfacets that mirror the light to the viewer: those whose normal is H.
struct Facet<R> {
    n_dot_h: R,
    n_dot_v: R,
    v_dot_h: R,
    /// `1 − N·H`, from the chord.
    gap: R,
}

impl<R: Real> Facet<R> {
    #[inline(always)]
    fn new(site: &ShadingPoint<R>, l: V3<R>) -> Self {
        let h = halfway(l, site.view);
        let chord = site.normal - h;
        let one = l.x.constant(R::Scalar::from_f64(1.0));
        let gap = (chord.dot(chord) * R::Scalar::from_f64(0.5)).min(one);
        Self { n_dot_h: site.normal.dot(h), n_dot_v: site.normal.dot(site.view), v_dot_h: site.view.dot(h), gap }
    }

    /// S from `π·D` and `G/(N·V)`; no facet faces inwards.
    #[inline(always)]
    fn factor(&self, distribution: R, geometry: R) -> R {
        let zero = geometry.constant(R::Scalar::default());
        let factor = distribution * seen(self.n_dot_v) * geometry * R::Scalar::from_f64(0.25);
        R::select(self.n_dot_h.greater_than(zero), factor, zero)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_exponent() {
        let at = |cosine: f64, n: f64| power_of_cosine(cosine, &Lobe::new(n, 1.0));
        assert_eq!((at(0.0, 0.0), at(0.5, 0.0), at(-0.5, 0.0)), (1.0, 1.0, 1.0));
        assert_eq!((at(0.0, 2.0), at(-1.0, 0.3)), (0.0, 0.0));
        let axis = V3::new(0.0, 0.0, 1.0);
        let near = V3::new(1e-6, 0.0, 1.0);
        let mirror = Lobe::new(f64::INFINITY, 1.0);
        assert_eq!(power_of_chord(axis, axis, &mirror), 1.0);
        assert_eq!(power_of_chord(axis, near, &mirror), 0.0);
    }
}
