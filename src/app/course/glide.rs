//! The transition from one scene of a lesson to the next: numbers change gradually, so that the eye can follow.

use crate::scene::Scene;
use crate::scene::parameter::{Access, Kind, Parameter};
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
    /// Creates the transition between two scenes with the same object, if they differ in numbers.
    pub fn between(from: &Scene, to: &Scene) -> Option<Self> {
        let same = from.object == to.object
            && from.lights.len() == to.lights.len()
            && (from.camera.projection, from.camera.up) == (to.camera.projection, to.camera.up);
        let moves = |(parameter, _): (&Parameter, usize)| {
            !matches!(
                parameter.kind,
                Kind::Choice(_)
                    | Kind::Switch(_)
                    | Kind::Text(..)
                    | Kind::Lines(..)
                    | Kind::Other(..)
            )
        };
        (same && from.differences(to).any(moves)).then(|| Self {
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

    /// Returns the scene at the start, if it is valid.
    pub fn start(&self) -> Option<Scene> {
        Some(self.at(0.0)).filter(|scene| scene.validate().is_ok())
    }

    /// Returns the scene at a fraction of the transition. Everything that does not move is as at the end.
    fn at(&self, share: f64) -> Scene {
        let mut scene = self.to.clone();
        if share >= 1.0 {
            return scene;
        }
        for (parameter, index) in self.from.differences(&self.to) {
            self.blend(&mut scene, parameter, index, share);
        }
        // The eye goes round the target, not through it.
        let (a, b) = (&self.from.camera, &self.to.camera);
        scene.camera.eye = scene.camera.target + turned(a.eye - a.target, b.eye - b.target, share);
        scene
    }

    /// Sets a number of a scene to that at a fraction of the transition.
    fn blend(&self, scene: &mut Scene, parameter: &Parameter, index: usize, share: f64) {
        match parameter.kind {
            Kind::Number(at, _, slider) => self.mix(scene, at, index, |a: f64, b: f64| {
                // A highlight shrinks evenly with the logarithm of n.
                let value = if slider.logarithmic && a > 0.0 && b > 0.0 {
                    a.ln().lerp(b.ln(), share).exp()
                } else {
                    a.lerp(b, share)
                };
                if value.is_finite() { value } else { b }
            }),
            Kind::Coefficient(at, ..) | Kind::Channels(at, ..) | Kind::Colour(at, _) => {
                self.mix(scene, at, index, |a, b| a.lerp(b, share));
            }
            Kind::Point(at) => self.mix(scene, at, index, |a, b| a.lerp(b, share)),
            Kind::Direction(at, _) => {
                self.mix(scene, at, index, |a, b| turned(a, b, share));
            }
            _ => {}
        }
    }

    /// Sets a value of a scene to a mixture of those at both ends.
    fn mix<T: Copy>(
        &self,
        scene: &mut Scene,
        at: &Access<T>,
        index: usize,
        mixed: impl Fn(T, T) -> T,
    ) {
        let ends = [&self.from, &self.to].map(|scene| (at.get)(scene, index));
        if let ([Some(a), Some(b)], Some(value)) = (ends, (at.get_mut)(scene, index)) {
            *value = mixed(*a, *b);
        }
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
            "material.kd=0.1",
        ];
        let to = from.with_overrides(&set).expect("settings");
        let glide = Glide::between(&from, &to).expect("a way");
        assert_eq!(glide.at(1.0), to);
        let halfway = glide.at(0.5).material.kd.x;
        assert!(0.1 < halfway && halfway < from.material.kd.x);
        let close = |a: DVec3, b: DVec3| (a - b).length() < 1e-12;
        assert!(close(glide.at(0.0).camera.eye, from.camera.eye));
        for step in 0..=100 {
            let scene = glide.at(f64::from(step) / 100.0);
            assert_eq!(scene.validate(), Ok(()));
            // The eye goes round the object, not through it.
            assert!(scene.camera.eye.distance(scene.camera.target) > 2.0);
            assert!((from.material.n..=500.0 + 1e-9).contains(&scene.material.n));
            assert!((0.1 - 1e-9..=from.material.kd.x).contains(&scene.material.kd.x));
        }
        assert!(Glide::between(&from, &from).is_none());
        let other = from.with_overrides(&["object.rings=9"]).expect("settings");
        assert!(Glide::between(&from, &other).is_none());
    }
}
