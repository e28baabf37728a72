//! The materials of an object's faces: a model's own, with the scene's changes, or the scene's for all.

use crate::geometry::{Mesh, ModelMaterial, NO_MATERIAL, VertexMesh, built_in};
use crate::scene::{FaceMaterial, MaterialSource, Scene};
use std::borrow::Cow;
use std::collections::HashMap;

/// The materials that the faces of a mesh have.
#[derive(Clone, Debug, Default)]
pub struct FaceMaterials {
    /// The materials in the order of their first faces; `None` for the scene's. Empty where the object has none of its own.
    own: Vec<Option<ModelMaterial>>,
    /// The material of each face, an index into [`Self::materials`]; empty where all have the same.
    pub faces: Vec<u16>,
}

impl FaceMaterials {
    /// Finds the materials of the faces of `mesh`.
    pub fn of(mesh: &VertexMesh) -> Self {
        let mut own = vec![];
        let mut places: HashMap<u16, u16> = HashMap::new();
        let mut place = |number: &u16| {
            *places.entry(*number).or_insert_with(|| {
                own.push(mesh.materials.get(usize::from(*number)).cloned());
                own.len() as u16 - 1
            })
        };
        let mut faces: Vec<u16> = mesh.face_materials.iter().map(&mut place).collect();
        if own.len() <= 1 {
            faces = vec![];
        }
        Self { own, faces }
    }

    /// Returns whether the object has no materials of its own.
    pub fn is_empty(&self) -> bool {
        self.own.is_empty()
    }

    /// Returns the materials in `scene`, at least one.
    pub fn materials(&self, scene: &Scene) -> Vec<FaceMaterial> {
        if self.own.is_empty() {
            return vec![FaceMaterial::of_scene(scene)];
        }
        let material = |own: &Option<ModelMaterial>| match own {
            Some(own) => scene.object.material(&own.name, &own.face_material()),
            None => FaceMaterial::of_scene(scene),
        };
        self.own.iter().map(material).collect()
    }

    /// Returns the index of a face's material.
    pub fn of_face(&self, face: u32) -> usize {
        let material = self.faces.get(face as usize);
        usize::from(material.copied().unwrap_or_default())
    }

    /// Returns the name of a material in the model; `None` for the scene's.
    pub fn name(&self, index: usize) -> Option<&str> {
        let own = self.own.get(index)?.as_ref()?;
        Some(&own.name)
    }
}

/// Calls `each` with the scene once for each of `materials`, which is then the scene's, and collects what it returns.
pub fn for_each_material<T>(
    scene: &Scene,
    materials: &[FaceMaterial],
    mut each: impl FnMut(&Scene) -> T,
) -> Vec<T> {
    let mut own = Cow::Borrowed(scene);
    let with = |material: &FaceMaterial| {
        if FaceMaterial::of_scene(&own) != *material {
            material.clone().replace_in(own.to_mut());
        }
        each(&own)
    };
    materials.iter().map(with).collect()
}

/// Returns whether light passes through any of these materials.
pub fn any_transmits(materials: &[FaceMaterial]) -> bool {
    materials.iter().any(|own| own.kt > 0.0)
}

/// Returns whether light passes through any surface of the object of `scene`, which shows `model` if it is one.
pub fn transmits(scene: &Scene, model: Option<&Mesh>) -> bool {
    let own = scene.material.source == MaterialSource::Model;
    let all = scene.transparency.kt > 0.0;
    let model = if scene.object.kind.is_model() {
        model
    } else {
        built_in(scene.object.kind).map(|mesh| &**mesh)
    };
    let Some(model) = model.filter(|model| own && !model.materials.is_empty()) else {
        return all;
    };
    let changed = |own: &ModelMaterial| scene.object.material(&own.name, &own.face_material()).kt;
    model.materials.iter().any(|own| changed(own) > 0.0)
        || all && model.face_materials.contains(&NO_MATERIAL)
}
