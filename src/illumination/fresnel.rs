//! W(θ), the reflectance of a smooth surface at the angle of incidence θ by Fresnel's formulas; and T, the direction of
//! transmitted light.
//!
//! For a complex index of refraction η + ik, per channel and for unpolarised light (M. Born and E. Wolf, *Principles of
//! Optics*, 13.2; in this form P. Lapierre and S. Lagarde, *Fresnel term approximations for metals*, 2008). With
//! c = cos θ, s² = 1 − c²:
//!
//! ```text
//! a² + b² = √((η² − k² − s²)² + 4η²k²)        a = √((a² + b² + η² − k² − s²)/2)
//! ρ⊥ = (a² + b² − 2ac + c²)/(a² + b² + 2ac + c²)
//! ρ∥ = ρ⊥ · (c²(a² + b²) − 2ac·s² + s⁴)/(c²(a² + b²) + 2ac·s² + s⁴)        W = (ρ⊥ + ρ∥)/2
//! ```
//!
//! W(0°) = ((η − 1)² + k²)/((η + 1)² + k²), W(90°) = 1 except for η = 1, k = 0, where nothing is reflected.

use super::{Real, Scalar};
use crate::scene::{Material, Reflectance, Rgb};
use glam::DVec3;

/// A complex index of refraction for red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Index {
    /// η, the real part.
    pub eta: Rgb,
    /// k, the extinction coefficient.
    pub k: Rgb,
}

impl Index {
    /// Crown glass N-BK7 at 656.3, 546.1 and 435.8 nm: the SCHOTT data sheet's `n_C`, `n_e`, `n_g`.
    pub const GLASS: Self = Self {
        eta: Rgb::new(1.514_32, 1.518_72, 1.526_68),
        k: Rgb::ZERO,
    };

    /// Silver at 1.88, 2.26 and 2.75 eV (659, 549 and 451 nm): P. B. Johnson and R. W. Christy, *Optical constants of the
    /// noble metals*, Phys. Rev. B 6 (1972), table I.
    pub const SILVER: Self = Self {
        eta: Rgb::new(0.05, 0.06, 0.04),
        k: Rgb::new(4.483, 3.586, 2.657),
    };

    /// Gold, from the same table at the same energies.
    pub const GOLD: Self = Self {
        eta: Rgb::new(0.14, 0.43, 1.38),
        k: Rgb::new(3.697, 2.455, 1.914),
    };

    /// Returns the index that `material` reflects by; `None` where W is constant.
    pub fn of(material: &Material) -> Option<Self> {
        match material.reflectance {
            Reflectance::Constant => None,
            Reflectance::Glass => Some(Self::GLASS),
            Reflectance::Silver => Some(Self::SILVER),
            Reflectance::Gold => Some(Self::GOLD),
            Reflectance::Custom => Some(Self {
                eta: material.ior,
                k: material.extinction,
            }),
        }
    }

    /// Returns W per channel at the angle of incidence whose cosine is `cosine`.
    pub fn reflectance(&self, cosine: f64) -> Rgb {
        Rgb::from_array(Fresnel::<f64>::new(*self).reflectance(cosine))
    }
}

/// An index of refraction, prepared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fresnel<T> {
    /// η² − k² − 1, so that η near 1 keeps its digits.
    excess: [T; 3],
    /// 4η²k².
    product: [T; 3],
}

impl<T: Scalar> Fresnel<T> {
    pub fn new(Index { eta, k }: Index) -> Self {
        let excess = (eta - 1.0) * (eta + 1.0) - k * k;
        let product = 4.0 * eta * eta * k * k;
        Self {
            excess: excess.to_array().map(T::from_f64),
            product: product.to_array().map(T::from_f64),
        }
    }

    /// Returns W per channel.
    #[inline(always)]
    pub fn reflectance<R: Real<Scalar = T>>(&self, cosine: R) -> [R; 3] {
        let cosine = cosine.max(cosine.number(0.0)).min(cosine.number(1.0));
        [
            self.channel(cosine, 0),
            self.channel(cosine, 1),
            self.channel(cosine, 2),
        ]
    }

    #[inline(always)]
    fn channel<R: Real<Scalar = T>>(&self, c: R, channel: usize) -> R {
        let half = T::from_f64(0.5);
        let (zero, c2) = (c.number(0.0), c * c);
        let s2 = c.number(1.0) - c2;
        // η² − k² − s² = (η² − k² − 1) + c².
        let inner = c2 + c.constant(self.excess[channel]);
        let modulus = inner
            .mul_add(inner, c.constant(self.product[channel]))
            .sqrt();
        let a = ((modulus + inner) * half).max(zero).sqrt();
        let twice = (a + a) * c;
        let perpendicular = (modulus + c2 - twice).max(zero) * (modulus + c2 + twice).reciprocal();
        let level = c2.mul_add(modulus, s2 * s2);
        let tilt = twice * s2;
        let ratio = (level - tilt).max(zero) * (level + tilt).reciprocal();
        perpendicular.mul_add(ratio, perpendicular) * half
    }
}

/// Returns the direction T of a ray that travels along `incident` and passes a surface with normal `n`, by Snell's law
/// `sin θ₁ = η·sin θ₂`; `None` where it is totally reflected.
///
/// `incident` and `n` are unit vectors, `incident·n` ≤ 0: the ray comes from the side that `n` points to. `eta` is the
/// index of refraction beyond the surface relative to that before it. T is a unit vector (A. S. Glassner, *An Introduction
/// to Ray Tracing*, 1989, 4.3):
/// `T = I/η + (c/η − √(1 − (1 − c²)/η²))·n`, c = −I·n. At η = 1 the ray goes straight on. There is no T where
/// `sin θ₁ > η`, beyond the critical angle arcsin η, for η < 1.
pub fn refract(incident: DVec3, n: DVec3, eta: f64) -> Option<DVec3> {
    let cosine = -incident.dot(n);
    // From the cross product, since 1 − cos² would lose its digits near the normal.
    let sine_squared = incident.cross(n).length_squared() / (eta * eta);
    let rest = 1.0 - sine_squared;
    (rest >= 0.0).then(|| ((incident + n * cosine) / eta - n * rest.sqrt()).normalize_or(incident))
}

/// Returns the direction of a ray that travels along `incident` and is mirrored at a surface with normal `n`, both unit vectors.
pub fn mirror(incident: DVec3, n: DVec3) -> DVec3 {
    incident - 2.0 * incident.dot(n) * n
}

/// Returns the angle of incidence beyond which nothing is transmitted, radians; `None` for η ≥ 1.
pub fn critical_angle(eta: f64) -> Option<f64> {
    (eta < 1.0).then(|| eta.asin())
}
