//! A scene's lights as what shines: muted ones left out, distant ones made parallel, names made harmless.

use crate::illumination::{area_samples, attenuation_at, direction};
use crate::scene::{Attenuation, Light, LightKind, Scene};
use glam::DVec3;

/// A light farther away than this many camera distances is parallel, as it is in the equation.
const PARALLEL_BEYOND: f64 = 1e9;

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

/// The lights of `scene` that shine, in its order.
pub(super) fn emitters(scene: &Scene) -> Vec<Emitter<'_>> {
    let soloing = scene.soloing();
    let shining = scene.lights.iter().enumerate().filter(|(_, light)| light.shines(soloing));
    shining.map(|(index, light)| Emitter::new(scene, index, light)).collect()
}

impl<'a> Emitter<'a> {
    fn new(scene: &Scene, index: usize, light: &'a Light) -> Self {
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
        Self { index, light, place, constant }
    }

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
        let name = if harmless { format!(" \"{name}\"") } else { String::new() };
        format!("Light {}{name}, {kind}", self.index)
    }

    /// D, the unit vector along the axis of a spot light's cone.
    pub fn axis(&self) -> DVec3 {
        direction(self.light.direction)
    }
}
