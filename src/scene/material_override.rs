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
        fn changed<T: PartialEq>(from: T, to: T) -> Option<T> {
            (from != to).then_some(to)
        }
        let (a, b) = (&own.material, &wanted.material);
        Self {
            name: name.to_owned(),
            ka: changed(a.ka, b.ka).map(Coefficient),
            kd: changed(a.kd, b.kd).map(Coefficient),
            ks: changed(a.ks, b.ks).map(Coefficient),
            n: changed(a.n, b.n),
            color: changed(a.color, b.color),
            specular_color: changed(a.specular_color, b.specular_color),
            roughness: changed(a.roughness, b.roughness),
            reflectance: changed(a.reflectance, b.reflectance),
            ior: changed(a.ior, b.ior),
            extinction: changed(a.extinction, b.extinction),
            kt: changed(own.kt, wanted.kt),
            relative_ior: changed(own.relative_ior, wanted.relative_ior),
        }
    }

    /// Returns a material with this change.
    #[must_use]
    pub fn applied_to(&self, own: &FaceMaterial) -> FaceMaterial {
        let coefficient = |change: Option<Coefficient>, own| change.map_or(own, |value| value.0);
        let before = &own.material;
        let material = Material {
            ka: coefficient(self.ka, before.ka),
            kd: coefficient(self.kd, before.kd),
            ks: coefficient(self.ks, before.ks),
            n: self.n.unwrap_or(before.n),
            color: self.color.unwrap_or(before.color),
            specular_color: self.specular_color.unwrap_or(before.specular_color),
            roughness: self.roughness.unwrap_or(before.roughness),
            reflectance: self.reflectance.unwrap_or(before.reflectance),
            ior: self.ior.unwrap_or(before.ior),
            extinction: self.extinction.unwrap_or(before.extinction),
            source: before.source,
        };
        FaceMaterial {
            material,
            kt: self.kt.unwrap_or(own.kt),
            relative_ior: self.relative_ior.unwrap_or(own.relative_ior),
        }
    }
}
