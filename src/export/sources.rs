//! What both languages ask of a scene: the lights that shine, and what neither expresses.

use super::text::holding;
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

pub(super) const SCALE: &str = "The division by the picture's greatest intensity, which nothing knows before all is drawn: I is clamped.";

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
        format!("Light {}{name}, {kind}", self.index)
    }

    /// D, the unit vector along the axis of a spot light's cone.
    pub fn axis(&self) -> DVec3 {
        direction(self.light.direction)
    }
}

/// What neither the calls nor the shaders do: mostly what needs more than one surface at a time.
pub(super) fn surroundings(scene: &Scene) -> Vec<String> {
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
            "Shadows: every light reaches every point.",
        ),
        (
            scene.transparency.kt > 0.0,
            "Transparency (Kt): the surface is drawn opaque.",
        ),
        (
            scene.ground.visible,
            "The ground: only the object is drawn.",
        ),
        (
            backdrop,
            "The backdrop: only the background's colour is behind the object.",
        ),
        (
            scene.ambient.source != AmbientSource::Constant,
            "Light that other surfaces have scattered: Ia is constant.",
        ),
        (
            !measured,
            "Lengths of this size: OpenGL squares them in single precision. Scale the scene.",
        ),
    ])
}

/// What flat shading is not.
pub(super) fn flat(scene: &Scene) -> Option<&'static str> {
    // Where L and V do not vary, a polygon with one normal has one shade.
    let parallel = emitters(scene)
        .iter()
        .all(|emitter| matches!(emitter.place, Place::Towards(_)));
    let constant = parallel
        && (scene.camera.viewer == Viewer::Infinite
            || SpecularForm::of(scene) == SpecularForm::None);
    match scene.shading.flat_at {
        FlatAt::ProvokingVertex => None,
        FlatAt::Centre if constant => Some(
            "Flat shading with the polygon's own N: GL_FLAT takes the shade of one vertex, with that vertex's N. Vertex \
             normals of the facets (object.normals = \"facet\") make them agree.",
        ),
        FlatAt::Centre => Some(
            "Flat shading at the polygon's centre: GL_FLAT takes the shade of one vertex, here the polygon's first.",
        ),
        FlatAt::VertexMean => Some(
            "Flat shading by the mean of the vertices' shades: GL_FLAT takes the shade of one, here the polygon's first.",
        ),
    }
}

/// What interpolation is not; `affine` says whether the target can interpolate in the picture.
pub(super) fn interpolation(scene: &Scene, affine: bool) -> Option<&'static str> {
    match scene.shading.interpolation {
        Interpolation::Affine if !affine && scene.camera.projection == Projection::Perspective => {
            Some("Affine interpolation: OpenGL's is perspective-correct.")
        }
        Interpolation::Scanline => Some(
            "Interpolation along scan lines: polygons are drawn as triangles, interpolated as such.",
        ),
        _ => None,
    }
}
