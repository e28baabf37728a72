//! The materials of a scene's model with the scene's changes, and the conditions that these must meet.

use super::Scene;
use super::face_material::FaceMaterial;
use super::format::list_of;
use super::material::{KT, Material, TRANSPARENCY_IOR};
use super::material_override::MaterialOverride;
use super::object::Object;
use super::parameter::at_most;
use super::validation::Checks;
use crate::text::text;

impl Object {
    /// The most changes of a model's materials in a scene.
    pub const MAX_MATERIALS: usize = 512;

    /// Returns the model's material `name`, which is `own` in its file, as this scene shows it.
    pub fn material(&self, name: &str, own: &FaceMaterial) -> FaceMaterial {
        self.materials
            .iter()
            .find(|change| change.name == name)
            .map_or_else(|| own.clone(), |change| change.applied_to(own))
    }

    /// Changes the model's material `name`, which is `own` in its file, to `wanted`.
    pub fn change_material(&mut self, name: &str, own: &FaceMaterial, wanted: &FaceMaterial) {
        let change = MaterialOverride::between(name, own, wanted);
        let nothing = MaterialOverride {
            name: name.to_owned(),
            ..MaterialOverride::default()
        };
        match self.materials.iter().position(|one| one.name == name) {
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
        let usual = FaceMaterial::of_scene(&scene);
        for (index, change) in self.materials.iter().enumerate() {
            let key = format!("object.material.{index}");
            let mut before = self.materials[..index].iter();
            if change.name.is_empty() {
                checks.found(&format!("{key}.name"), text!("problem-material-unnamed"));
            } else if before.any(|other| other.name == change.name) {
                checks.found(&format!("{key}.name"), text!("problem-material-twice"));
            }
            change.applied_to(&usual).replace_in(&mut scene);
            for parameter in Material::PARAMETERS {
                let own = parameter.key.replacen("material", &key, 1);
                checks.within(&own, parameter.outside(&scene, 0));
            }
            checks.within(&format!("{key}.kt"), KT.outside(&scene, 0));
            checks.within(
                &format!("{key}.relative_ior"),
                TRANSPARENCY_IOR.outside(&scene, 0),
            );
        }
    }
}
