//! What narrows a highlight: the exponent n, or the roughness of microfacets.

use super::Scalar;
use crate::scene::Material;

/// What narrows the highlight, prepared: the exponent n, or the microfacets' roughness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lobe<T> {
    /// n, finite: a mirror's is so large that all but the axis itself vanishes.
    pub(super) n: T,
    /// `0^n`: 1 for n = 0, otherwise 0.
    pub(super) at_zero: T,
    /// Cosines up to this one need no power: what it would add is not seen.
    pub(super) faint: T,
    /// The square of the roughness.
    pub(super) roughness_squared: T,
    /// 1 over the square of the roughness.
    pub(super) inverse_roughness_squared: T,
}

/// Stands for n = ∞: any angle that single precision can tell from 0 gives 0; rounding errors of double precision give 1.
const MIRROR: f64 = 1e24;

impl<T: Scalar> Lobe<T> {
    /// The lobe of `material`, whose n may be infinite.
    pub fn of(material: &Material) -> Self {
        Self::new(material.n, material.roughness)
    }

    pub(super) fn new(n: f64, roughness: f64) -> Self {
        Self {
            n: T::from_f64(n.min(MIRROR)),
            at_zero: T::from_f64(if n == 0.0 { 1.0 } else { 0.0 }),
            faint: T::from_f64(NEVER_FAINT),
            roughness_squared: T::from_f64(roughness * roughness),
            inverse_roughness_squared: T::from_f64(1.0 / (roughness * roughness)),
        }
    }
}

/// Below all cosines.
const NEVER_FAINT: f64 = -2.0;

/// Adding this to an intensity changes no stored value: it is below half a unit in the last place, in single precision, of
/// any intensity that is not stored as 0.
const UNSEEN: f64 = 1.0 / (1_u64 << 38) as f64;

/// Powers of two per step of a highlight's brightness.
const STEP: f64 = 4.0;

impl Lobe<f32> {
    /// Leaves out powers that add nothing to be seen where a highlight of all sources together adds `most`.
    pub(super) fn leave_out_faint(&mut self, most: f64) {
        let n = f64::from(self.n);
        if n > 0.0 && most > 0.0 {
            // In steps, so that the factors rarely change with the coefficients.
            let steps = (most.log2() / STEP).ceil().max(1.0);
            self.faint = f32::from_f64(((UNSEEN.log2() - STEP * steps) / n).exp2());
        }
    }
}
