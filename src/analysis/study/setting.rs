//! What is measured: methods, tessellations, interpolations and n, and which of their combinations there are.

use super::Method;
use super::historic::cannot_draw;
use crate::scene::{Interpolation, ObjectKind, Projection, Scene};
use serde::{Deserialize, Serialize};

/// What a study compares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StudyQuestion {
    pub methods: Vec<Method>,
    /// Polygons round the axis; those along it go with them as the scene has it. Of a shape that is not divided by number
    /// only its own polygons are measured.
    pub segments: Vec<u32>,
    pub interpolations: Vec<Interpolation>,
    /// Exponents; none is the scene's own.
    pub n: Vec<f64>,
    /// Frames timed for each setting, at least 1.
    pub repeats: u32,
}

impl Default for StudyQuestion {
    fn default() -> Self {
        Self {
            methods: Method::ALL.to_vec(),
            segments: vec![8, 16, 32, 64, 128, 256],
            interpolations: vec![Interpolation::Perspective, Interpolation::Affine],
            n: Vec::new(),
            repeats: 9,
        }
    }
}

/// One way to draw the scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Setting {
    pub method: Method,
    pub segments: u32,
    pub rings: u32,
    /// None where it makes no difference.
    pub interpolation: Option<Interpolation>,
    pub n: f64,
}

impl Setting {
    /// Puts the setting into a scene.
    pub(super) fn apply(&self, scene: &mut Scene) {
        (scene.object.segments, scene.object.rings) = (self.segments, self.rings);
        scene.material.n = self.n;
        scene.shading.interpolation = self.interpolation.unwrap_or(scene.shading.interpolation);
        self.method.apply(scene);
    }

    /// Puts the setting into a scene and returns true, unless it is one of the scalar methods, which no scene has.
    pub fn load(&self, scene: &mut Scene) -> bool {
        if !self.method.is_scalar() {
            self.apply(scene);
        }
        !self.method.is_scalar()
    }

    /// Whether it belongs to the same row of tessellations.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        (self.method, self.interpolation) == (other.method, other.interpolation)
            && self.n.to_bits() == other.n.to_bits()
    }
}

/// What is not measured, and why.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Omission {
    pub method: Method,
    pub interpolation: Option<Interpolation>,
    pub reason: &'static str,
}

/// The settings of `request` in `scene`, those of one method together, from coarse to fine; and what is left out.
pub fn settings(request: &StudyQuestion, scene: &Scene) -> (Vec<Setting>, Vec<Omission>) {
    let (mut settings, mut omissions) = (Vec::new(), Vec::new());
    let divisions = divisions(request, scene);
    let exponents = if request.n.is_empty() { vec![scene.material.n] } else { unique(&request.n) };
    for n in exponents {
        for method in unique(&request.methods) {
            for interpolation in interpolations(method, request, scene) {
                let mut drawn = scene.clone();
                drawn.shading.interpolation = interpolation.unwrap_or(scene.shading.interpolation);
                if let Some(reason) = method.is_scalar().then(|| cannot_draw(method, &drawn)).flatten() {
                    let omission = Omission { method, interpolation, reason };
                    if !omissions.contains(&omission) {
                        omissions.push(omission);
                    }
                    continue;
                }
                let setting = |&[segments, rings]: &[u32; 2]| Setting { method, segments, rings, interpolation, n };
                settings.extend(divisions.iter().map(setting));
            }
        }
    }
    (settings, omissions)
}

/// The interpolations that make a difference: without perspective, or where nothing is carried, one stands for all.
fn interpolations(method: Method, request: &StudyQuestion, scene: &Scene) -> Vec<Option<Interpolation>> {
    if !method.carries() {
        return vec![None];
    }
    let flat = scene.camera.projection == Projection::Orthographic;
    let same = |interpolation: Interpolation| match interpolation {
        Interpolation::Affine if flat => Interpolation::Perspective,
        // The scalar code carries over triangles, not along the scan lines of polygons.
        Interpolation::Scanline if method.is_scalar() => Interpolation::Affine,
        other => other,
    };
    let wanted: Vec<_> = request.interpolations.iter().copied().map(same).collect();
    unique(&wanted).into_iter().map(Some).collect()
}

/// Segments and rings, from coarse to fine.
fn divisions(request: &StudyQuestion, scene: &Scene) -> Vec<[u32; 2]> {
    let object = &scene.object;
    let own = [object.segments, object.rings];
    if matches!(object.kind, ObjectKind::Obj | ObjectKind::Polygons) || request.segments.is_empty() {
        return vec![own];
    }
    let per_segment = f64::from(own[1]) / f64::from(own[0].max(1));
    let valid = |[segments, rings]: &[u32; 2]| {
        let mut tried = scene.clone();
        (tried.object.segments, tried.object.rings) = (*segments, *rings);
        tried.validate().is_ok()
    };
    let mut all: Vec<[u32; 2]> = request
        .segments
        .iter()
        .map(|&segments| [segments, ((f64::from(segments) * per_segment).round() as u32).max(LEAST_RINGS.min(own[1]))])
        .filter(valid)
        .collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// What every shape can do with.
const LEAST_RINGS: u32 = 3;

/// Each value once, in their order.
fn unique<T: PartialEq + Copy>(values: &[T]) -> Vec<T> {
    let mut kept = Vec::new();
    for value in values {
        if !kept.contains(value) {
            kept.push(*value);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_makes_no_difference_is_measured_once() {
        let mut scene = Scene::default();
        let request = StudyQuestion { segments: vec![32, 8, 8], ..StudyQuestion::default() };
        let (all, omitted) = settings(&request, &scene);
        let count = |method| all.iter().filter(|setting| setting.method == method).count();
        assert_eq!([Method::Flat, Method::Gouraud, Method::Taylor, Method::Angular].map(count), [2, 4, 4, 2]);
        assert_eq!(omitted.len(), 1, "{omitted:?}");
        assert_eq!((all[0].segments, all[0].rings, all[1].segments), (8, 4, 32));
        scene.camera.projection = Projection::Orthographic;
        let (all, omitted) = settings(&request, &scene);
        assert_eq!((all.len(), omitted.len()), (2 * Method::ALL.len(), 0));
    }

    #[test]
    fn a_setting_is_loaded_into_the_scene_unless_it_is_historic() {
        let mut scene = Scene::default();
        let interpolation = Some(Interpolation::Affine);
        let setting = Setting { method: Method::PhongUnnormalised, segments: 12, rings: 7, interpolation, n: 9.0 };
        assert!(setting.load(&mut scene));
        assert_eq!((scene.object.segments, scene.object.rings, scene.material.n), (12, 7, 9.0));
        assert!(!scene.shading.renormalise && scene.shading.interpolation == Interpolation::Affine);
        let before = scene.clone();
        assert!(!Setting { method: Method::Taylor, n: 3.0, ..setting }.load(&mut scene));
        assert_eq!(scene, before);
    }
}
