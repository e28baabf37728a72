//! What both languages ask of a scene: the lights that shine, and what neither expresses.

use super::limit::{Limit, holding, limit};
use crate::illumination::{SpecularForm, area_samples, attenuation_at, direction};
use crate::scene::{
    AmbientSource, Attenuation, FlatAt, Interpolation, Light, LightKind, PatternKind, Projection,
    Scene, Viewer,
};
use glam::DVec3;

/// A light farther away than this many camera distances is parallel, as it is in the equation.
const PARALLEL_BEYOND: f64 = 1e9;

/// Between this and its inverse, squares of lengths and products of a few of them stay within single precision.
const GREATEST_LENGTH: f64 = 1e9;

/// A light that shines.
pub(super) struct Emitter<'a> {
    /// Its place in the scene's list.
    pub index: usize,
    pub light: &'a Light,
    pub place: Place,
    /// f where it is the same everywhere: what has no distance, or one that does not vary.
    pub constant: Option<f64>,
}

/// Where light comes from.
pub(super) enum Place {
    /// L, unit, everywhere the same.
    Towards(DVec3),
    At(DVec3),
    /// The points that stand for an area, each with an equal share of the intensity.
    Among(Vec<DVec3>),
}

/// The lights of `scene` that shine, in its order: muted ones left out, distant ones made parallel.
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
            LightKind::Directional => Place::Towards(-direction(light.direction)),
            _ if far => Place::Towards(direction(offset)),
            LightKind::Area => Place::Among(area_samples(light)),
            LightKind::Point | LightKind::Spot => Place::At(light.position),
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
    /// `Light 0, a point light`, with the name that its author gave it where that can stand in a comment.
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

    /// D, the unit vector along the axis of a spot light's cone.
    pub fn axis(&self) -> DVec3 {
        direction(self.light.direction)
    }
}

/// What neither the calls nor the shaders do: mostly what needs more than one surface at a time.
pub(super) fn surroundings(scene: &Scene) -> Vec<Limit> {
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
            scene.transparency.kt > 0.0,
            limit!("export-limit-transparency"),
        ),
        (scene.ground.visible, limit!("export-limit-ground")),
        (backdrop, limit!("export-limit-backdrop")),
        (
            scene.ambient.source != AmbientSource::Constant,
            limit!("export-limit-bounce"),
        ),
        (!measured, limit!("export-limit-lengths")),
    ])
}

/// What flat shading is not.
pub(super) fn flat(scene: &Scene) -> Option<Limit> {
    // Where L and V do not vary, a polygon with one normal has one shade.
    let parallel = emitters(scene)
        .iter()
        .all(|emitter| matches!(emitter.place, Place::Towards(_)));
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

/// What interpolation is not; `affine` says whether the target can interpolate in the picture.
pub(super) fn interpolation(scene: &Scene, affine: bool) -> Option<Limit> {
    match scene.shading.interpolation {
        Interpolation::Affine if !affine && scene.camera.projection == Projection::Perspective => {
            Some(limit!("export-limit-affine"))
        }
        Interpolation::Scanline => Some(limit!("export-limit-scanline")),
        _ => None,
    }
}
