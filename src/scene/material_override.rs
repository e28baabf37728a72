//! Changes of a model's materials, which belong to the scene: the model's files stay as they are.

use super::format::{Coefficient, list_of};
use super::material::{self, Material, Reflectance};
use super::object::Object;
use super::parameter::{Parameter, at_most, defaults, table};
use super::validation::Checks;
use super::{Rgb, Scene};
use crate::text::text;

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
    pub fn between(name: &str, own: &Material, wanted: &Material) -> Self {
        let coefficient = |a: Rgb, b: Rgb| (a != b).then_some(Coefficient(b));
        let channels = |a: Rgb, b: Rgb| (a != b).then_some(b);
        let number = |a: f64, b: f64| (a != b).then_some(b);
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
        }
    }

    /// Returns a material with this change.
    #[must_use]
    pub fn applied_to(&self, own: &Material) -> Material {
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

impl Object {
    /// The most changes of a model's materials in a scene.
    pub const MAX_MATERIALS: usize = 512;

    /// Returns the model's material `name`, which is `own` in its file, as this scene shows it.
    pub fn material(&self, name: &str, own: &Material) -> Material {
        self.materials
            .iter()
            .find(|change| change.name == name)
            .map_or_else(|| own.clone(), |change| change.applied_to(own))
    }

    /// Changes the model's material `name`, which is `own` in its file, to `wanted`.
    pub fn change_material(&mut self, name: &str, own: &Material, wanted: &Material) {
        let change = MaterialOverride::between(name, own, wanted);
        let nothing = MaterialOverride {
            name: name.to_owned(),
            ..MaterialOverride::default()
        };
        let place = self.materials.iter().position(|one| one.name == name);
        match place {
            Some(place) if change == nothing => {
                self.materials.remove(place);
            }
            Some(place) => self.materials[place] = change,
            None if change == nothing => {}
            None => self.materials.push(change),
        }
    }

    /// Reports the problems of the changes of a model's materials, whether or not a model is shown.
    pub(super) fn check_materials(&self, checks: &mut Checks) {
        if self.materials.len() > Self::MAX_MATERIALS {
            let (found, expected) = (list_of(self.materials.len()), at_most(Self::MAX_MATERIALS));
            return checks.value("object.material", found, expected);
        }
        let mut scene = Scene::default();
        for (index, change) in self.materials.iter().enumerate() {
            let key = format!("object.material.{index}");
            let mut before = self.materials[..index].iter();
            if change.name.is_empty() {
                checks.found(&format!("{key}.name"), text!("problem-material-unnamed"));
            } else if before.any(|other| other.name == change.name) {
                checks.found(&format!("{key}.name"), text!("problem-material-twice"));
            }
            scene.material = change.applied_to(&Material::default());
            for parameter in Material::PARAMETERS {
                let own = parameter.key.replacen("material", &key, 1);
                checks.within(&own, parameter.outside(&scene, 0));
            }
        }
    }
}
