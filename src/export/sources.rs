//! Common parts of both languages: the lights that shine, and the features that neither expresses.

use super::limit::{Limit, holding, limit};
use crate::geometry::VertexMesh;
use crate::illumination::{SpecularForm, area_samples, attenuation_at, direction};
use crate::render::{FaceMaterials, any_transmits, for_each_material};
use crate::scene::{
    AmbientSource, Attenuation, FaceMaterial, FlatAt, Interpolation, Light, LightKind, PatternKind,
    Projection, Scene, Viewer,
};
use glam::DVec3;

/// Distance, in camera distances, beyond which a light is parallel, as in the equation.
const PARALLEL_BEYOND: f64 = 1e9;

/// The materials of what is drawn.
pub(super) struct Materials {
    /// The materials, one or more, in the order of their first polygons.
    pub all: Vec<FaceMaterial>,
    /// The name of each, for comments; empty for the scene's.
    names: Vec<String>,
    /// True if colours of vertices tint Od.
    tinted: bool,
}

impl Materials {
    /// Returns those of `mesh`, or the scene's.
    pub fn of(scene: &Scene, mesh: Option<&VertexMesh>) -> (Self, FaceMaterials) {
        let face_materials = mesh.map_or_else(FaceMaterials::default, FaceMaterials::of);
        let all = face_materials.materials(scene);
        let name = |index| plain(face_materials.name(index).unwrap_or_default());
        let names = (0..all.len()).map(name).collect();
        let tinted = mesh.is_some_and(|mesh| !mesh.corner_colors.is_empty());
        let materials = Self { all, names, tinted };
        (materials, face_materials)
    }

    /// Returns a material's name for a comment.
    pub fn name(&self, index: usize) -> &str {
        let name = &self.names[index];
        if name.is_empty() { "the scene's" } else { name }
    }

    /// Returns their numbers and names in a line.
    pub fn list(&self) -> String {
        let numbered = |index| format!("{index} {}", self.name(index));
        let all: Vec<String> = (0..self.all.len()).map(numbered).collect();
        all.join(", ")
    }

    /// Calls `each` with the scene once for each of them, and collects what it returns.
    pub fn each<T>(&self, scene: &Scene, each: impl FnMut(&Scene) -> T) -> Vec<T> {
        for_each_material(scene, &self.all, each)
    }
}

/// Returns a name as plain ASCII that ends no comment.
fn plain(name: &str) -> String {
    let sound = |c: char| c.is_ascii_alphanumeric() || " -_.,'".contains(c);
    let name = name.chars().map(|c| if sound(c) { c } else { '_' });
    name.collect::<String>().trim().to_owned()
}

/// Length up to which, and down to its inverse, squares and products of a few of them stay within single precision.
const GREATEST_LENGTH: f64 = 1e9;

/// A light that shines.
pub(super) struct Emitter<'a> {
    /// Index in the scene's list.
    pub index: usize,
    pub light: &'a Light,
    pub place: EmitterPosition,
    /// f if it is constant: for a light without a distance, or with one that does not vary.
    pub constant: Option<f64>,
}

/// The position of a light.
pub(super) enum EmitterPosition {
    /// L, a unit vector, constant.
    Towards(DVec3),
    At(DVec3),
    /// The points that represent an area, each with an equal share of the intensity.
    Among(Vec<DVec3>),
}

/// Returns the lights of `scene` that shine, in order: muted ones are omitted, distant ones made parallel.
pub(super) fn emitters(scene: &Scene) -> Vec<Emitter<'_>> {
    let soloing = scene.soloing();
    let mut emitters = Vec::new();
    for (index, light) in scene
        .lights
        .iter()
        .enumerate()
        .filter(|(_, light)| light.shines(soloing))
    {
        let offset = light.position - scene.camera.eye;
        let distance = offset.length();
        let far = distance > PARALLEL_BEYOND * scene.camera.distance();
        let place = match light.kind {
            LightKind::Directional => EmitterPosition::Towards(-direction(light.direction)),
            _ if far => EmitterPosition::Towards(direction(offset)),
            LightKind::Area => EmitterPosition::Among(area_samples(light)),
            LightKind::Point | LightKind::Spot => EmitterPosition::At(light.position),
        };
        let constant = match light.attenuation {
            Attenuation::None => Some(1.0),
            Attenuation::Viewer => None,
            _ if !light.kind.has_position() => Some(1.0),
            attenuation => far.then(|| attenuation_at(light, attenuation, distance)),
        };
        emitters.push(Emitter {
            index,
            light,
            place,
            constant,
        });
    }
    emitters
}

impl Emitter<'_> {
    /// Returns `Light 0, a point light`, with the name that its author gave it if that can appear in a comment.
    pub fn title(&self) -> String {
        let kind = match self.light.kind {
            LightKind::Point => "a point light",
            LightKind::Directional => "a directional light",
            LightKind::Spot => "a spot light",
            LightKind::Area => "an area light",
        };
        let plain = |c: char| c.is_ascii_alphanumeric() || " -_.,'".contains(c);
        let name = self.light.name.trim();
        let harmless = !name.is_empty() && name.len() <= 60 && name.chars().all(plain);
        let name = if harmless {
            format!(" \"{name}\"")
        } else {
            String::new()
        };
        format!("Light {}{name}, {kind}", self.index + 1)
    }

    /// Returns D, the unit vector along the axis of a spot light's cone.
    pub fn axis(&self) -> DVec3 {
        direction(self.light.direction)
    }
}

/// Returns the features that neither the calls nor the shaders express: mostly those that need more than one surface
/// at a time.
pub(super) fn surroundings(scene: &Scene, materials: &Materials) -> Vec<Limit> {
    let unit = scene.camera.distance();
    let measured = (1.0 / GREATEST_LENGTH..GREATEST_LENGTH).contains(&unit);
    let shining = scene
        .lights
        .iter()
        .any(|light| light.shines(scene.soloing()));
    let backdrop = scene.backdrop.pattern != PatternKind::None;
    holding([
        (
            scene.shading.shadows && shining,
            limit!("export-limit-shadows"),
        ),
        (
            any_transmits(&materials.all),
            limit!("export-limit-transparency"),
        ),
        (materials.tinted, limit!("export-limit-vertex-colours")),
        (scene.ground.visible, limit!("export-limit-ground")),
        (backdrop, limit!("export-limit-backdrop")),
        (
            scene.ambient.source != AmbientSource::Constant,
            limit!("export-limit-bounce"),
        ),
        (!measured, limit!("export-limit-lengths")),
    ])
}

/// Returns the difference of the target's flat shading from the scene's, if any.
pub(super) fn flat(scene: &Scene) -> Option<Limit> {
    // If L and V do not vary, a polygon with one normal has one shade.
    let parallel = emitters(scene)
        .iter()
        .all(|emitter| matches!(emitter.place, EmitterPosition::Towards(_)));
    let constant = parallel
        && (scene.camera.viewer == Viewer::Infinite
            || SpecularForm::of(scene) == SpecularForm::None);
    match scene.shading.flat_at {
        FlatAt::ProvokingVertex => None,
        FlatAt::Centre if constant => Some(limit!("export-limit-flat-own-normal")),
        FlatAt::Centre => Some(limit!("export-limit-flat-centre")),
        FlatAt::VertexMean => Some(limit!("export-limit-flat-mean")),
    }
}

/// Returns the difference of the target's interpolation from the scene's, if any; `affine` says whether the target
/// can interpolate in the picture.
pub(super) fn interpolation(scene: &Scene, affine: bool) -> Option<Limit> {
    match scene.shading.interpolation {
        Interpolation::Affine if !affine && scene.camera.projection == Projection::Perspective => {
            Some(limit!("export-limit-affine"))
        }
        Interpolation::Scanline => Some(limit!("export-limit-scanline")),
        _ => None,
    }
}
