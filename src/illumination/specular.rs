//! The specular factor S: Phong's `(R·V)^n` and Blinn's `(N·H)^n`, each in two forms, and Cook and Torrance's microfacets;
//! and the width of a highlight.
//!
//! A power of a cosine is stiff: an error δ of the cosine becomes n·δ of the result, and near the lobe's axis the cosine
//! itself is rounded to a few 10⁻⁸ in single precision. With the chord between the two unit vectors,
//! `1 − a·b = |a − b|²/2`, the distance from the axis keeps its digits, and `(a·b)^n = exp(n·ln(1 − |a − b|²/2))`.
//! At small n the plain cosine is the better form, because the lobe is wide and the chord long.

use super::{Real, Scalar, V3};
use crate::scene::{Distribution, Material, ReflectionModel, Rgb, Scene, ShadingMode};
use std::f64::consts::{FRAC_PI_2, LN_2, LOG2_E};

/// A point where the equation is evaluated. Lengths are camera distances, positions relative to the eye.
#[derive(Clone, Copy, Debug)]
pub struct ShadingPoint<R> {
    /// N, unit unless the shading mode leaves it unnormalised.
    pub normal: V3<R>,
    /// The position relative to the eye, in camera distances.
    pub position: V3<R>,
    /// V, unit.
    pub view: V3<R>,
    /// 1/distance from the eye.
    pub inverse_distance: R,
}

/// The form of the specular factor that a scene needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SpecularForm {
    /// No specular reflection of any light.
    None,
    /// `(R·V)^n` from the cosine, for n below [`Self::CHORD_FROM`] or normals that are not unit.
    PhongCosine,
    /// `(R·V)^n` from the chord between R and V, which keeps its digits where n is large.
    PhongChord,
    /// `(N·H)^n` from the cosine.
    BlinnCosine,
    /// `(N·H)^n` from the chord between N and H.
    BlinnChord,
    /// Cook and Torrance's model with Beckmann's distribution, cos α = N·H from the chord between N and H.
    Beckmann,
    /// Beckmann's distribution with cos α taken directly, for normals that are not unit.
    BeckmannCosine,
    /// Cook and Torrance's model with the distribution of Walter et al., from the chord.
    Ggx,
    /// The distribution of Walter et al. from the cosine, for normals that are not unit.
    GgxCosine,
    /// The law that the scene has as a formula, in place of both terms.
    Formula,
}

impl SpecularForm {
    /// The n from which the chord form is used. Where the chord's logarithm ends, at `1 − a·b` = 0.29, the power is then
    /// below 0.71⁶⁴ = 3·10⁻¹⁰ and counts as 0; for smaller n the cosine form loses less than 64 · 10⁻⁷.
    pub const CHORD_FROM: f64 = 64.0;

    /// Returns the form that `scene` needs. Normals that are left short of unit length have no chord.
    pub fn of(scene: &Scene) -> Self {
        let soloing = scene.soloing();
        let ks = scene.material.ks * scene.material.specular_color;
        let lit = scene
            .lights
            .iter()
            .any(|light| light.shines(soloing) && ks * light.color != Rgb::ZERO);
        if lit || scene.reflection.is_own_law() {
            Self::of_model(scene)
        } else {
            Self::None
        }
    }

    /// Returns whether light is mirrored at H, so that W depends on the angle between L and H instead of that between L and N.
    #[inline(always)]
    pub fn at_halfway(self) -> bool {
        matches!(self, Self::BlinnCosine | Self::BlinnChord) || self.has_microfacets()
    }

    /// Returns whether the model is Cook and Torrance's.
    pub(crate) fn has_microfacets(self) -> bool {
        matches!(
            self,
            Self::Beckmann | Self::BeckmannCosine | Self::Ggx | Self::GgxCosine
        )
    }

    /// Returns S at a shading point for the unit direction `l` to the light and `n_dot_l` = N·L.
    ///
    /// The form is chosen here, once for all lanes, so that the kernels are compiled only once.
    #[inline(always)]
    pub fn factor<R: Real>(
        self,
        site: &ShadingPoint<R>,
        l: V3<R>,
        n_dot_l: R,
        lobe: &Lobe<R::Scalar>,
    ) -> R {
        let (n, v) = (site.normal, site.view);
        match self {
            Self::None | Self::Formula => n_dot_l.number(0.0),
            // R·V without R: 2(N·L)(N·V) − L·V.
            Self::PhongCosine => {
                power_of_cosine((n_dot_l + n_dot_l).mul_add(n.dot(v), -l.dot(v)), lobe)
            }
            Self::BlinnCosine => power_of_cosine(n.dot(halfway(l, v)), lobe),
            form => form.long_factor(site, l, n_dot_l, lobe),
        }
    }

    /// Returns S of the forms with longer texts.
    // In a page, where all code has the same instructions, one copy for all shaders is smaller.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    fn long_factor<R: Real>(
        self,
        site: &ShadingPoint<R>,
        l: V3<R>,
        n_dot_l: R,
        lobe: &Lobe<R::Scalar>,
    ) -> R {
        let (n, v) = (site.normal, site.view);
        match self {
            Self::PhongChord => power_of_chord(reflect(n, l, n_dot_l), v, lobe),
            Self::BlinnChord => power_of_chord(n, halfway(l, v), lobe),
            Self::Ggx | Self::GgxCosine => {
                let f = Facet::new(site, l, self == Self::Ggx);
                f.factor(ggx(f.gap, lobe), smith_over_view(n_dot_l, f.n_dot_v, lobe))
            }
            _ => {
                let f = Facet::new(site, l, self == Self::Beckmann);
                f.factor(
                    beckmann(f.gap, lobe),
                    geometric_over_view(f.n_dot_h, n_dot_l, f.n_dot_v, f.v_dot_h),
                )
            }
        }
    }

    /// Returns the cosine of the angle of incidence.
    #[inline(always)]
    pub(super) fn incidence<R: Real>(self, site: &ShadingPoint<R>, l: V3<R>, n_dot_l: R) -> R {
        if self.at_halfway() {
            // |L + V|/2 is the cosine of half the angle between them.
            let sum = l + site.view;
            sum.dot(sum).sqrt() * R::Scalar::from_f64(0.5)
        } else {
            n_dot_l
        }
    }

    /// Returns the form that `scene` would need whatever its coefficients.
    pub(super) fn of_model(scene: &Scene) -> Self {
        let shading = &scene.shading;
        let unit_normals = shading.renormalise || shading.mode != ShadingMode::Phong;
        let chord = scene.material.n >= Self::CHORD_FROM && unit_normals;
        match (scene.reflection.model, scene.reflection.distribution) {
            (ReflectionModel::Formula, _) => Self::Formula,
            (ReflectionModel::Phong, _) if chord => Self::PhongChord,
            (ReflectionModel::Phong, _) => Self::PhongCosine,
            (ReflectionModel::Blinn, _) if chord => Self::BlinnChord,
            (ReflectionModel::Blinn, _) => Self::BlinnCosine,
            (ReflectionModel::CookTorrance, Distribution::Beckmann) if unit_normals => {
                Self::Beckmann
            }
            (ReflectionModel::CookTorrance, Distribution::Beckmann) => Self::BeckmannCosine,
            (ReflectionModel::CookTorrance, Distribution::Ggx) if unit_normals => Self::Ggx,
            (ReflectionModel::CookTorrance, Distribution::Ggx) => Self::GgxCosine,
        }
    }
}

/// Returns `R = 2N(N·L) − L`, L mirrored at N.
#[inline(always)]
pub(crate) fn reflect<R: Real>(n: V3<R>, l: V3<R>, n_dot_l: R) -> V3<R> {
    n.scale_add(n_dot_l + n_dot_l, -l)
}

/// Returns `H = (L + V)/|L + V|`, halfway between the light and the viewer.
#[inline(always)]
pub(super) fn halfway<R: Real>(l: V3<R>, v: V3<R>) -> V3<R> {
    (l + v).normalised()
}

/// Returns `max(c, 0)^n` from the cosine, which rounding may take past 1.
#[inline(always)]
fn power_of_cosine<R: Real>(c: R, lobe: &Lobe<R::Scalar>) -> R {
    let (zero, one) = (c.number(0.0), c.number(1.0));
    if !R::any(c.greater_than(c.constant(lobe.faint))) {
        return zero;
    }
    let tiny = c.number(f64::from(f32::MIN_POSITIVE));
    let power = (c.max(tiny).min(one).log2() * lobe.n).exp2();
    R::select(c.greater_than(zero), power, c.constant(lobe.at_zero))
}

/// Returns `(a·b)^n` of two unit vectors from the chord between them.
#[inline(always)]
fn power_of_chord<R: Real>(a: V3<R>, b: V3<R>, lobe: &Lobe<R::Scalar>) -> R {
    let chord = a - b;
    let t = chord.dot(chord) * R::Scalar::from_f64(0.5);
    let (limit, zero, one) = (t.number(0.29), t.number(0.0), t.number(1.0));
    if !R::any((one - t).greater_than(t.constant(lobe.faint)) & limit.greater_than(t)) {
        return zero;
    }
    let power = (R::log2_one_minus(t.min(limit)) * lobe.n).exp2();
    R::select(limit.greater_than(t), power, zero)
}

/// The parameter that narrows the highlight, prepared: the exponent n, or the microfacets' roughness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobe<T> {
    /// n, finite: a mirror's is so large that the lobe vanishes off its axis.
    n: T,
    /// `0^n`: 1 for n = 0, otherwise 0.
    at_zero: T,
    /// The cosine up to which no power is needed, because it would add nothing visible.
    faint: T,
    roughness_squared: T,
    inverse_roughness_squared: T,
}

/// A finite n for ∞: any angle that single precision can tell from 0 gives 0; rounding errors of double precision give 1.
const MIRROR: f64 = 1e24;

/// A number below all cosines.
const NEVER_FAINT: f64 = -2.0;

/// An addition to an intensity that changes no stored value: it is below half a unit in the last place, in single
/// precision, of any intensity that is not stored as 0.
const UNSEEN: f64 = 1.0 / (1_u64 << 38) as f64;

/// The powers of two in a step of a highlight's brightness.
const STEP: f64 = 4.0;

impl<T: Scalar> Lobe<T> {
    /// Returns the lobe of `material`, whose n may be infinite.
    pub fn of(material: &Material) -> Self {
        Self::new(material.n, material.roughness)
    }

    fn new(n: f64, roughness: f64) -> Self {
        Self {
            n: T::from_f64(n.min(MIRROR)),
            at_zero: T::from_f64(if n == 0.0 { 1.0 } else { 0.0 }),
            faint: T::from_f64(NEVER_FAINT),
            roughness_squared: T::from_f64(roughness * roughness),
            inverse_roughness_squared: T::from_f64(1.0 / (roughness * roughness)),
        }
    }
}

impl Lobe<f32> {
    /// Skips powers that add nothing visible where a highlight of all sources together adds at most `most`.
    pub(super) fn leave_out_faint(&mut self, most: f64) {
        let n = f64::from(self.n);
        if n > 0.0 && most > 0.0 {
            // In steps, so that the factors rarely change with the coefficients.
            let steps = (most.log2() / STEP).ceil().max(1.0);
            self.faint = f32::from_f64(((UNSEEN.log2() - STEP * steps) / n).exp2());
        }
    }
}

/// The microfacets that mirror the light to the viewer: those whose normal is H (Cook and Torrance, ACM Transactions on Graphics
/// 1 (1), 1982).
///
/// S is `D·G·π/(4·(N·V))`; F is W(θ), per channel, and multiplied outside. With a light's intensity so counted that Lambert's
/// term is `kd·(N·L)`, a BRDF f contributes `π·f·(N·L)`, and Cook and Torrance's is `D·F·G/(4·(N·L)·(N·V))`.
struct Facet<R> {
    n_dot_h: R,
    n_dot_v: R,
    v_dot_h: R,
    /// `1 − N·H`, not below 0 nor above 1.
    gap: R,
}

impl<R: Real> Facet<R> {
    /// Returns the facets at a shading point; `by_chord` says that N is unit, so that 1 − N·H is half the square of its chord to H.
    #[inline(always)]
    fn new(site: &ShadingPoint<R>, l: V3<R>, by_chord: bool) -> Self {
        let h = halfway(l, site.view);
        let n_dot_h = site.normal.dot(h);
        let (zero, one) = (l.x.number(0.0), l.x.number(1.0));
        let gap = if by_chord {
            let chord = site.normal - h;
            chord.dot(chord) * R::Scalar::from_f64(0.5)
        } else {
            // Rounding may take N·H past 1.
            (one - n_dot_h).max(zero)
        };
        Self {
            n_dot_h,
            n_dot_v: site.normal.dot(site.view),
            v_dot_h: site.view.dot(h),
            gap: gap.min(one),
        }
    }

    /// Returns S from `π·D` and `G/(N·V)`; no facet faces inwards.
    #[inline(always)]
    fn factor(&self, distribution: R, geometry: R) -> R {
        let zero = geometry.number(0.0);
        let factor = distribution * seen(self.n_dot_v) * geometry * R::Scalar::from_f64(0.25);
        R::select(self.n_dot_h.greater_than(zero), factor, zero)
    }
}

/// The smallest divisor among cosines. With it the quotients stay finite and approach their limits.
const SMALLEST_COSINE: f64 = 1e-4;

/// Returns an upper bound of `π·D·G/(4(N·V))` at roughness m for both distributions: π·D is below 1.5/m², and G/(N·V) below
/// 1 over the smallest cosine for cavities, below 4 times that for Smith's G over α.
pub(super) fn greatest_factor(roughness: f64) -> f64 {
    1.0 / (SMALLEST_COSINE * roughness * roughness)
}

/// Returns `π·D` of Beckmann's distribution, `exp(−tan²α/m²)/(m²·cos⁴α)`, for `gap` = 1 − cos α.
///
/// m is the root mean square slope. sin²α = gap·(2 − gap) keeps its digits near α = 0, where the lobe is stiff.
#[inline(always)]
fn beckmann<R: Real>(gap: R, lobe: &Lobe<R::Scalar>) -> R {
    let (cos2, sin2) = squares(gap);
    // Raised so that neither the quotient nor the fourth power leaves the range of single precision.
    let cos2 = cos2.max(gap.number(1e-8));
    let tan2 = sin2 / cos2;
    let power = (tan2 * lobe.inverse_roughness_squared * R::Scalar::from_f64(-LOG2_E)).exp2();
    power * lobe.inverse_roughness_squared / (cos2 * cos2)
}

/// Returns `π·D` of the distribution of Walter et al. (EGSR 2007), `α²/((α² − 1)·cos² + 1)²`, for `gap` = 1 − cos.
#[inline(always)]
fn ggx<R: Real>(gap: R, lobe: &Lobe<R::Scalar>) -> R {
    let (cos2, sin2) = squares(gap);
    // (α² − 1)·cos² + 1 = α²·cos² + sin².
    let sum = (cos2 * lobe.roughness_squared) + sin2;
    let quotient = sum.constant(lobe.roughness_squared) / sum;
    quotient * quotient * lobe.inverse_roughness_squared
}

/// Returns cos² and sin² of the angle whose 1 − cos is `gap`.
#[inline(always)]
fn squares<R: Real>(gap: R) -> (R, R) {
    let one = gap.number(1.0);
    let cosine = one - gap;
    (cosine * cosine, gap * (one + cosine))
}

/// Returns `G/(N·V)` of the V-shaped cavities of Torrance and Sparrow (J. Opt. Soc. Am. 57, 1967): G = min(1,
/// 2(N·H)(N·V)/(V·H), 2(N·H)(N·L)/(V·H)).
#[inline(always)]
fn geometric_over_view<R: Real>(n_dot_h: R, n_dot_l: R, n_dot_v: R, v_dot_h: R) -> R {
    let min_cosine = n_dot_v.number(SMALLEST_COSINE);
    let inverse_view = n_dot_v.number(1.0) / n_dot_v.max(min_cosine);
    let cavity = (n_dot_h + n_dot_h) / v_dot_h.max(min_cosine);
    inverse_view
        .min(cavity)
        .min(cavity * n_dot_l * inverse_view)
}

/// Returns `min(1, max(0, 1 + 4·N·V))`: 1 where the surface faces the viewer.
///
/// At the outline of a coarse mesh the interpolated normal turns some degrees away from the viewer; there the limit of
/// `G/(N·V)` at N·V = 0 fades out until N·V = −¼. This is our choice: the published models end at N·V = 0, which would cut
/// the rim off.
#[inline(always)]
fn seen<R: Real>(n_dot_v: R) -> R {
    let (zero, one) = (n_dot_v.number(0.0), n_dot_v.number(1.0));
    (n_dot_v * R::Scalar::from_f64(4.0) + one)
        .max(zero)
        .min(one)
}

/// Returns `G/(N·V)` by Smith's method for the distribution of Walter et al.: G = G₁(N·L)·G₁(N·V) with
/// G₁(x) = 2x/(x + √(α² + (1 − α²)x²)).
#[inline(always)]
fn smith_over_view<R: Real>(n_dot_l: R, n_dot_v: R, lobe: &Lobe<R::Scalar>) -> R {
    let min_cosine = n_dot_v.number(SMALLEST_COSINE);
    let (l, v) = (n_dot_l.max(min_cosine), n_dot_v.max(min_cosine));
    let four = l * R::Scalar::from_f64(4.0);
    four / (smith_divisor(l, lobe) * smith_divisor(v, lobe))
}

/// Returns `x + √(α² + (1 − α²)x²)`.
#[inline(always)]
fn smith_divisor<R: Real>(x: R, lobe: &Lobe<R::Scalar>) -> R {
    let squared = x.constant(lobe.roughness_squared);
    x + (x.number(1.0) - squared).mul_add(x * x, squared).sqrt()
}

/// Returns the angle φ at which cosⁿφ has fallen to one half, radians: half the lobe's width at half its height.
///
/// From cos φ = 2^(−1/n); 0 for a mirror, a right angle for n = 0, where the lobe does not fall off.
pub fn half_width(n: f64) -> f64 {
    let exponent = LN_2 / n;
    // 1 − cos φ = 1 − e^(−x) and φ = 2·asin(√((1 − cos φ)/2)): no digits are lost for large n.
    2.0 * (0.5 * -(-exponent).exp_m1()).sqrt().asin()
}

/// Returns the n of `(N·H)^n` whose highlight is as wide as that of `(R·V)^n` with `n`, about 4n: in the plane of incidence
/// H turns by half the angle of R, so the half-width is halved.
pub fn blinn_from_phong(n: f64) -> f64 {
    of_half_width(0.5 * half_width(n), 4.0 * n)
}

/// Returns the inverse of [`blinn_from_phong`] where there is one: a half-width over 45° has no n for Phong's model and gives 0.
pub fn phong_from_blinn(n: f64) -> f64 {
    of_half_width(2.0 * half_width(n), 0.25 * n)
}

/// Returns Beckmann's m whose highlight is as narrow as that of `(N·H)^n`: m = √(2/(n + 2)) (Walter et al. 2007, appendix).
pub fn roughness_from_exponent(n: f64) -> f64 {
    (2.0 / (n + 2.0)).sqrt()
}

/// Returns n = −ln 2/ln cos φ, or `narrow` where the angle is too small for its cosine to be told from 1.
fn of_half_width(angle: f64, narrow: f64) -> f64 {
    if angle >= FRAC_PI_2 {
        return 0.0;
    }
    let half_sine = (0.5 * angle).sin();
    let n = -LN_2 / (-2.0 * half_sine * half_sine).ln_1p();
    if n.is_finite() { n } else { narrow }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_the_exponent_and_the_fading_past_the_outline() {
        let at = |cosine: f64, n: f64| power_of_cosine(cosine, &Lobe::new(n, 1.0));
        assert_eq!((at(0.0, 0.0), at(0.5, 0.0), at(-0.5, 0.0)), (1.0, 1.0, 1.0));
        assert_eq!((at(0.0, 2.0), at(-1.0, 0.3)), (0.0, 0.0));
        let (axis, near) = (V3::new(0.0, 0.0, 1.0), V3::new(1e-6, 0.0, 1.0));
        let mirror = Lobe::new(f64::INFINITY, 1.0);
        assert_eq!(
            (
                power_of_chord(axis, axis, &mirror),
                power_of_chord(axis, near, &mirror)
            ),
            (1.0, 0.0)
        );
        let faded = [1.0, 1e-3, 0.0, -0.125, -0.25, -0.9].map(seen::<f64>);
        assert_eq!(faded, [1.0, 1.0, 1.0, 0.5, 0.0, 0.0]);
    }
}
