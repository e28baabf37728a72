//! What the built-in scenes share: a camera, lamps, a background.

use crate::scene::{
    Camera, Compare, CompareView, Ground, Image, Light, LightKind, Material, NormalSource, Object, ObjectKind, Pane,
    Rgb, Scene,
};
use glam::DVec3;

/// Night blue, dark enough for a highlight and bright enough for an unlit outline.
pub(super) const BACKGROUND: Rgb = Rgb::new(0.07, 0.08, 0.10);
pub(super) const WARM: Rgb = Rgb::new(1.0, 0.95, 0.86);
pub(super) const COOL: Rgb = Rgb::new(0.62, 0.74, 1.0);

pub(super) fn seen_from(eye: DVec3) -> Camera {
    Camera { eye, fov_y: 36.0, ..Camera::default() }
}

pub(super) fn lamp(position: [f64; 3], color: Rgb) -> Light {
    Light { position: DVec3::from_array(position), color, ..Light::default() }
}

/// A distant light whose rays travel along `direction`.
pub(super) fn rays(direction: [f64; 3], color: Rgb) -> Light {
    Light { kind: LightKind::Directional, direction: DVec3::from_array(direction), color, ..Light::default() }
}

pub(super) fn surface(color: [f64; 3], kd: f64, ks: f64, n: f64) -> Material {
    let grey = Rgb::splat;
    Material { ka: grey(0.12), kd: grey(kd), ks: grey(ks), n, color: Rgb::from_array(color), ..Material::default() }
}

/// The studio: a camera slightly above, a warm lamp to the upper right.
pub(super) fn studio(kind: ObjectKind, segments: u32, rings: u32) -> Scene {
    Scene {
        camera: seen_from(DVec3::new(0.0, 1.1, 3.9)),
        image: Image { background: BACKGROUND, ..Image::default() },
        object: Object { kind, segments, rings, normals: NormalSource::Exact, ..Object::default() },
        lights: vec![lamp([2.4, 3.0, 3.2], WARM)],
        ..Scene::default()
    }
}

/// A bright floor that touches the object's lowest point at `height`.
pub(super) fn floor(height: f64) -> Ground {
    Ground { visible: true, height, ka: 0.12, kd: 0.8, color: Rgb::new(0.78, 0.77, 0.75) }
}

/// Panes beside the scene, each with one setting of its own.
pub(super) fn beside(settings: &[&str]) -> Compare {
    let panes = settings.iter().map(|setting| Pane::of(&[setting])).collect();
    Compare { view: CompareView::Panes, panes, ..Compare::default() }
}
