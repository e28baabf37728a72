//! The transition from one scene of a lesson to the next: camera, lights and n change gradually, so that the
//! eye can follow.

use crate::scene::Scene;
use eframe::egui::{Context, Event};
use glam::{DVec3, FloatExt as _};

/// The duration of a transition, in seconds.
const DURATION: f64 = 0.5;

/// A transition in progress.
pub struct Glide {
    from: Scene,
    to: Scene,
    /// The start time in seconds; `None` before the first frame.
    begun: Option<f64>,
}

impl Glide {
    /// Creates the transition between two scenes with the same object, if camera, lights or n differ.
    pub fn between(from: &Scene, to: &Scene) -> Option<Self> {
        let same = from.object == to.object
            && from.lights.len() == to.lights.len()
            && (from.camera.projection, from.camera.up) == (to.camera.projection, to.camera.up);
        let differs = from.camera != to.camera
            || from.lights != to.lights
            || from.material.n != to.material.n;
        (same && differs).then(|| Self {
            from: from.clone(),
            to: to.clone(),
            begun: None,
        })
    }

    /// Returns the current scene, and whether it is the last one. If animations are off or the user does
    /// something, the last scene comes at once.
    pub fn now(&mut self, ctx: &Context) -> (Scene, bool) {
        let now = ctx.input(|input| input.time);
        let share = (now - *self.begun.get_or_insert(now)) / DURATION;
        let still = ctx.global_style().animation_time == 0.0;
        let scene = self.at(share * share * (3.0 - 2.0 * share));
        if share >= 1.0 || still || is_in_use(ctx) || scene.validate().is_err() {
            (self.at(1.0), true)
        } else {
            (scene, false)
        }
    }

    /// Returns the scene at a fraction of the transition. Everything that does not move is as at the end.
    fn at(&self, share: f64) -> Scene {
        let mut scene = self.to.clone();
        if share >= 1.0 {
            return scene;
        }
        let (a, b) = (&self.from.camera, &self.to.camera);
        let camera = &mut scene.camera;
        camera.target = a.target.lerp(b.target, share);
        camera.eye = camera.target + turned(a.eye - a.target, b.eye - b.target, share);
        camera.roll = a.roll.lerp(b.roll, share);
        camera.fov_y = a.fov_y.lerp(b.fov_y, share);
        camera.height = a.height.lerp(b.height, share);
        let lights = self.from.lights.iter().zip(&self.to.lights);
        for (light, (a, b)) in scene.lights.iter_mut().zip(lights) {
            light.position = a.position.lerp(b.position, share);
            light.direction = turned(a.direction, b.direction, share);
        }
        // A highlight shrinks evenly with the logarithm of n.
        let [a, b] = [&self.from, &self.to].map(|scene| scene.material.n.ln());
        let n = a.lerp(b, share).exp();
        scene.material.n = if n.is_finite() { n } else { self.to.material.n };
        scene
    }
}

/// Turns a vector by a fraction of the way towards another.
fn turned(from: DVec3, to: DVec3, share: f64) -> DVec3 {
    if from == DVec3::ZERO || to == DVec3::ZERO {
        return to;
    }
    from.slerp(to, share)
}

/// Returns whether there is any input besides pointer movement and releases.
fn is_in_use(ctx: &Context) -> bool {
    let passes = |event: &Event| {
        matches!(
            event,
            Event::PointerMoved(_)
                | Event::MouseMoved(_)
                | Event::PointerGone
                | Event::WindowFocused(_)
                | Event::PointerButton { pressed: false, .. }
                | Event::Key { pressed: false, .. }
        )
    };
    ctx.input(|input| !input.events.iter().all(passes))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::presets;

    #[test]
    fn it_leads_from_one_scene_to_the_other_and_every_scene_on_the_way_is_sound() {
        let from = presets::find("sphere").expect("a built-in scene").scene();
        let set = [
            "camera.eye=[0,0,-3]",
            "light.0.direction=[1,0,0]",
            "light.0.position=[-3,1,2]",
            "material.n=500",
        ];
        let to = from.with_overrides(&set).expect("settings");
        let glide = Glide::between(&from, &to).expect("a way");
        assert_eq!(glide.at(1.0), to);
        let close = |a: DVec3, b: DVec3| (a - b).length() < 1e-12;
        assert!(close(glide.at(0.0).camera.eye, from.camera.eye));
        for step in 0..=100 {
            let scene = glide.at(f64::from(step) / 100.0);
            assert_eq!(scene.validate(), Ok(()));
            // The eye goes round the object, not through it.
            assert!(scene.camera.eye.distance(scene.camera.target) > 2.0);
            assert!((from.material.n..=500.0 + 1e-9).contains(&scene.material.n));
        }
        assert!(Glide::between(&from, &from).is_none());
        let other = from.with_overrides(&["object.rings=9"]).expect("settings");
        assert!(Glide::between(&from, &other).is_none());
    }
}
