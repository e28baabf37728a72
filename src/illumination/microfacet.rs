//! The factors of Cook and Torrance's model (ACM Transactions on Graphics 1 (1), 1982): how many microfacets mirror the
//! light, and how many of them are seen.

use super::lobe::Lobe;
use super::{Real, Scalar};

/// Cosines are lifted to this before anything is divided by them. The quotients stay finite and go to their limits.
const SMALLEST_COSINE: f64 = 1e-4;

/// Upper bound of `π·D·G/(4(N·V))` at roughness m for both distributions: π·D is below 1.5/m², and G/(N·V) below 1 over the
/// smallest cosine for cavities, below 4 times that for Smith's G over α.
pub(super) fn greatest_factor(roughness: f64) -> f64 {
    1.0 / (SMALLEST_COSINE * roughness * roughness)
}

/// `π·D` of Beckmann's distribution, `exp(−tan²α/m²)/(m²·cos⁴α)`, for `gap` = 1 − cos α.
///
/// m is the root mean square slope. sin²α = gap·(2 − gap) keeps its digits near α = 0, where the lobe is stiff.
#[inline(always)]
pub(super) fn beckmann<R: Real>(gap: R, lobe: &Lobe<R::Scalar>) -> R {
    let (cos2, sin2) = squares(gap);
    // Lifted so that neither the quotient nor the fourth power leaves the range of single precision.
    let cos2 = cos2.max(gap.constant(R::Scalar::from_f64(1e-8)));
    let tan2 = sin2 / cos2;
    let power = (tan2 * lobe.inverse_roughness_squared * R::Scalar::from_f64(-std::f64::consts::LOG2_E)).exp2();
    power * lobe.inverse_roughness_squared / (cos2 * cos2)
}

/// `π·D` of the distribution of Walter et al. (EGSR 2007), `α²/((α² − 1)·cos² + 1)²`, for `gap` = 1 − cos.
#[inline(always)]
pub(super) fn ggx<R: Real>(gap: R, lobe: &Lobe<R::Scalar>) -> R {
    let (cos2, sin2) = squares(gap);
    // (α² − 1)·cos² + 1 = α²·cos² + sin².
    let sum = (cos2 * lobe.roughness_squared) + sin2;
    let quotient = sum.constant(lobe.roughness_squared) / sum;
    quotient * quotient * lobe.inverse_roughness_squared
}

/// cos² and sin² of the angle whose 1 − cos is `gap`.
#[inline(always)]
fn squares<R: Real>(gap: R) -> (R, R) {
    let one = gap.constant(R::Scalar::from_f64(1.0));
    let cosine = one - gap;
    (cosine * cosine, gap * (one + cosine))
}

/// `G/(N·V)` of the V-shaped cavities of Torrance and Sparrow (J. Opt. Soc. Am. 57, 1967):
/// G = min(1, 2(N·H)(N·V)/(V·H), 2(N·H)(N·L)/(V·H)).
#[inline(always)]
pub(super) fn geometric_over_view<R: Real>(n_dot_h: R, n_dot_l: R, n_dot_v: R, v_dot_h: R) -> R {
    let least = n_dot_v.constant(R::Scalar::from_f64(SMALLEST_COSINE));
    let one = n_dot_v.constant(R::Scalar::from_f64(1.0));
    let inverse_view = one / n_dot_v.max(least);
    let cavity = (n_dot_h + n_dot_h) / v_dot_h.max(least);
    inverse_view.min(cavity).min(cavity * n_dot_l * inverse_view)
}

/// `min(1, max(0, 1 + 4·N·V))`: 1 where the surface faces the viewer. At the outline of a coarse mesh the interpolated
/// normal turns some degrees away from the viewer; there the limit of `G/(N·V)` at N·V = 0 fades out until N·V = −¼. This is
/// our choice: the published models end at N·V = 0, which would cut the rim off.
#[inline(always)]
pub(super) fn seen<R: Real>(n_dot_v: R) -> R {
    let (zero, one) = (n_dot_v.constant(R::Scalar::default()), n_dot_v.constant(R::Scalar::from_f64(1.0)));
    (n_dot_v * R::Scalar::from_f64(4.0) + one).max(zero).min(one)
}

/// `G/(N·V)` by Smith's method for the distribution of Walter et al.: G = G₁(N·L)·G₁(N·V) with
/// G₁(x) = 2x/(x + √(α² + (1 − α²)x²)).
#[inline(always)]
pub(super) fn smith_over_view<R: Real>(n_dot_l: R, n_dot_v: R, lobe: &Lobe<R::Scalar>) -> R {
    let least = n_dot_v.constant(R::Scalar::from_f64(SMALLEST_COSINE));
    let (l, v) = (n_dot_l.max(least), n_dot_v.max(least));
    let four = l * R::Scalar::from_f64(4.0);
    four / (smith_divisor(l, lobe) * smith_divisor(v, lobe))
}

/// `x + √(α² + (1 − α²)x²)`.
#[inline(always)]
fn smith_divisor<R: Real>(x: R, lobe: &Lobe<R::Scalar>) -> R {
    let one = x.constant(R::Scalar::from_f64(1.0));
    let squared = x.constant(lobe.roughness_squared);
    x + (one - squared).mul_add(x * x, squared).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lobe_fades_past_the_outline() {
        let faded = [1.0, 1e-3, 0.0, -0.125, -0.25, -0.9].map(seen::<f64>);
        assert_eq!(faded, [1.0, 1.0, 1.0, 0.5, 0.0, 0.0]);
    }
}
