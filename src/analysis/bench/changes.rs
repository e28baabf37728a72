//! The small changes whose frames are timed.

use crate::scene::{LightKind, Object, ObjectKind, Rgb, Scene};
use glam::DQuat;

/// The scene's frame of a number, from 1; none where the scene has nothing of the kind to change.
pub type Change = fn(&Scene, u32) -> Option<Scene>;

/// Each makes the scene's frame of a number; consecutive numbers up to 8 give different scenes.
pub const CHANGES: [(&str, Change); 5] =
    [("light", move_light), ("n", turn_n), ("ka", turn_ka), ("camera", orbit), ("tessellation", divide)];

fn move_light(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    let by = 0.01 * f64::from(step) * scene.camera.distance();
    let light = scene.lights.first_mut()?;
    match light.kind {
        LightKind::Directional => light.direction.x += 0.01 * f64::from(step) * light.direction.length(),
        _ => light.position.x += by.max(light.position.length() * 1e-3 * f64::from(step)),
    }
    Some(scene)
}

fn turn_n(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    let n = &mut scene.material.n;
    *n = if n.is_finite() { *n * 0.9 + 0.1 * f64::from(step) } else { 1000.0 + f64::from(step) };
    Some(scene)
}

fn turn_ka(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    scene.material.ka = scene.material.ka * 0.9 + Rgb::splat(0.005 * f64::from(step));
    Some(scene)
}

fn orbit(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    let camera = &mut scene.camera;
    let turn = DQuat::from_axis_angle(camera.up.normalize(), 0.01 * f64::from(step));
    camera.eye = camera.target + turn * (camera.eye - camera.target);
    Some(scene)
}

fn divide(scene: &Scene, step: u32) -> Option<Scene> {
    let mut scene = scene.clone();
    let object = &mut scene.object;
    if object.kind == ObjectKind::Obj {
        return None;
    }
    // The teapot and the cube are cut anew at every fourth segment only.
    let finer = object.segments + 4 * step;
    object.segments = if finer <= Object::MAX_DIVISIONS { finer } else { object.segments - 4 * step };
    Some(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn every_change_changes_one_thing_and_leaves_the_scene_sound() {
        let mut far = Scene::default();
        far.lights[0].position = glam::DVec3::splat(1e20);
        let mut mirror = Scene::default();
        mirror.material.n = f64::INFINITY;
        let lit = presets::ALL.iter().map(|preset| preset.scene()).filter(|scene| !scene.lights.is_empty());
        for scene in lit.chain([far, mirror]) {
            for (name, change) in CHANGES {
                for step in 1..8 {
                    let (a, b) = (change(&scene, step).expect("a light"), change(&scene, step + 1).expect("a light"));
                    assert_ne!(a, b, "{name}");
                    assert_eq!(a.validate(), Ok(()), "{name}");
                    let parts = [
                        a.lights != b.lights,
                        a.material.n != b.material.n,
                        a.material.ka != b.material.ka,
                        a.camera != b.camera,
                        a.object != b.object,
                    ];
                    assert_eq!(parts.iter().filter(|&&differs| differs).count(), 1, "{name}");
                }
            }
        }
        assert_eq!(move_light(&Scene { lights: vec![], ..Scene::default() }, 1), None);
    }
}
