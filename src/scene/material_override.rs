//! Changes of a model's materials, which belong to the scene: the model's files stay as they are.

use super::Rgb;
use super::face_material::FaceMaterial;
use super::format::Coefficient;
use super::material::{self, Material, Reflectance};
use super::parameter::{Parameter, defaults, table};

table! {
    /// A change of one of a model's materials. What it does not set is as the model has it.
    pub struct MaterialOverride = [object.material.N] in [object.materials] {
        /// Name of the model's material; at most 128 characters.
        NAME name: String = String::new(), Text(MaterialOverride::MAX_NAME);
        /// Its own Ka.
        KA ka: Option<Coefficient> = None, Other("kind-coefficient", || range(&material::KA));
        /// Its own Kd.
        KD kd: Option<Coefficient> = None, Other("kind-coefficient", || range(&material::KD));
        /// Its own Ks.
        KS ks: Option<Coefficient> = None, Other("kind-coefficient", || range(&material::KS));
        /// Its own n.
        N n: Option<f64> = None, Other("kind-number", || range(&material::N));
        /// Its own Od.
        COLOR color: Option<Rgb> = None, Other("kind-colour", || range(&material::COLOR));
        /// Its own Os.
        SPECULAR_COLOR specular_color: Option<Rgb> = None, Other("kind-colour", || range(&material::SPECULAR_COLOR));
        /// Its own m.
        ROUGHNESS roughness: Option<f64> = None, Other("kind-number", || range(&material::ROUGHNESS));
        /// Its own source of W(θ).
        REFLECTANCE reflectance: Option<Reflectance> = None, Other("kind-choice", String::new);
        /// Its own index of refraction.
        IOR ior: Option<Rgb> = None, Other("kind-channels", || range(&material::IOR));
        /// Its own extinction coefficient.
        EXTINCTION extinction: Option<Rgb> = None, Other("kind-channels", || range(&material::EXTINCTION));
        /// Its own Kt.
        KT kt: Option<f64> = None, Other("kind-number", || range(&material::KT));
        /// Its own η of transmitted light.
        RELATIVE_IOR relative_ior: Option<f64> = None, Other("kind-number", || range(&material::TRANSPARENCY_IOR));
    }
}

fn range(parameter: &Parameter) -> String {
    let limits = parameter.limits(defaults());
    limits.map_or_else(String::new, |limits| limits.to_string())
}

impl MaterialOverride {
    /// The most characters of a material's name.
    pub const MAX_NAME: usize = 128;

    /// Returns the change of the material `name` that makes `wanted` of `own`.
    pub fn between(name: &str, own: &FaceMaterial, wanted: &FaceMaterial) -> Self {
        let coefficient = |a: Rgb, b: Rgb| (a != b).then_some(Coefficient(b));
        let channels = |a: Rgb, b: Rgb| (a != b).then_some(b);
        let number = |a: f64, b: f64| (a != b).then_some(b);
        let (kt, relative_ior) = (
            number(own.kt, wanted.kt),
            number(own.relative_ior, wanted.relative_ior),
        );
        let (own, wanted) = (&own.material, &wanted.material);
        Self {
            name: name.to_owned(),
            ka: coefficient(own.ka, wanted.ka),
            kd: coefficient(own.kd, wanted.kd),
            ks: coefficient(own.ks, wanted.ks),
            n: number(own.n, wanted.n),
            color: channels(own.color, wanted.color),
            specular_color: channels(own.specular_color, wanted.specular_color),
            roughness: number(own.roughness, wanted.roughness),
            reflectance: (own.reflectance != wanted.reflectance).then_some(wanted.reflectance),
            ior: channels(own.ior, wanted.ior),
            extinction: channels(own.extinction, wanted.extinction),
            kt,
            relative_ior,
        }
    }

    /// Returns a material with this change.
    #[must_use]
    pub fn applied_to(&self, own: &FaceMaterial) -> FaceMaterial {
        FaceMaterial {
            material: self.coefficients(&own.material),
            kt: self.kt.unwrap_or(own.kt),
            relative_ior: self.relative_ior.unwrap_or(own.relative_ior),
        }
    }

    fn coefficients(&self, own: &Material) -> Material {
        let coefficient = |change: Option<Coefficient>, own| change.map_or(own, |value| value.0);
        Material {
            ka: coefficient(self.ka, own.ka),
            kd: coefficient(self.kd, own.kd),
            ks: coefficient(self.ks, own.ks),
            n: self.n.unwrap_or(own.n),
            color: self.color.unwrap_or(own.color),
            specular_color: self.specular_color.unwrap_or(own.specular_color),
            roughness: self.roughness.unwrap_or(own.roughness),
            reflectance: self.reflectance.unwrap_or(own.reflectance),
            ior: self.ior.unwrap_or(own.ior),
            extinction: self.extinction.unwrap_or(own.extinction),
            source: own.source,
        }
    }
}
