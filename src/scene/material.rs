//! The reflecting material: the coefficients of the illumination equation.

use super::Rgb;
use super::choice::choices;

#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Ambient coefficient; in a file one number or three.
    pub ka: Rgb,
    /// Diffuse coefficient.
    pub kd: Rgb,
    /// Specular coefficient.
    pub ks: Rgb,
    /// The specular exponent, from 0 to infinity (a mirror).
    pub n: f64,
    /// The root mean square slope of the microfacets (Beckmann), or their width α (GGX); Cook–Torrance only.
    pub roughness: f64,
    /// Od, the surface's own colour, which multiplies `ka` and `kd`.
    pub color: Rgb,
    /// Os, the colour of the highlight, which multiplies `ks`; white leaves it the light's own.
    pub specular_color: Rgb,
    /// W(θ), how the specular coefficient depends on the angle of incidence.
    pub reflectance: Reflectance,
    /// Index of refraction per channel, `reflectance = "custom"` only.
    pub ior: Rgb,
    /// Extinction coefficient, the imaginary part of the index, per channel, `reflectance = "custom"` only.
    pub extinction: Rgb,
}

choices! {
    /// W(θ): the part of the light that is reflected at the angle of incidence θ.
    pub enum Reflectance {
        /// 1, whatever the angle: Phong's own model.
        Constant = "constant", "constant", "1 at every angle, as in Phong's model";
        /// Fresnel's formulas for crown glass.
        Glass = "glass", "glass", "Crown glass N-BK7, by Fresnel's formulas";
        /// For silver.
        Silver = "silver", "silver", "By the index of Johnson and Christy 1972";
        /// For gold.
        Gold = "gold", "gold", "By the index of Johnson and Christy 1972";
        /// For a material's own complex index of refraction.
        Custom = "custom", "custom η and k", "A complex index of refraction of your own";
    }
}

impl Default for Material {
    fn default() -> Self {
        Self {
            ka: Rgb::splat(0.1),
            kd: Rgb::splat(0.7),
            ks: Rgb::splat(0.4),
            n: 32.0,
            roughness: 0.25,
            color: Rgb::new(0.9, 0.3, 0.2),
            specular_color: Rgb::ONE,
            reflectance: Reflectance::Constant,
            ior: Rgb::splat(1.5),
            extinction: Rgb::ZERO,
        }
    }
}
