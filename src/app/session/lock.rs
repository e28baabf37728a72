//! The lock of a question: it keeps the scene until the question is answered.

use crate::scene::Scene;
use crate::scene::parameter::Parameter;

/// A lock that keeps the scene as it is, except for the controls that answer the question. With such controls the
/// view of the scene may change too: it is no part of the answer then.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lock {
    /// The keys that answer the question.
    controls: Vec<String>,
}

impl Lock {
    /// Creates the lock of a question that is answered by controls with these keys.
    pub fn new(controls: &[String]) -> Self {
        Self {
            controls: controls.to_vec(),
        }
    }

    /// Returns whether a parameter may change.
    pub fn frees(&self, parameter: &Parameter, index: usize) -> bool {
        let view = parameter.section() == "camera" && !self.controls.is_empty();
        view || self.controls.contains(&parameter.key(index))
    }

    /// Returns whether a scene may become another one.
    pub fn allows(&self, before: &Scene, after: &Scene) -> bool {
        let mut changes = before.differences(after);
        changes.all(|(parameter, index)| self.frees(parameter, index))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_answers_the_question_may_change() {
        let scene = Scene::default();
        let with = |settings: &[&str]| scene.with_overrides(settings).expect("settings");
        let prediction = Lock::default();
        let settings = Lock::new(&["light.0.k".to_owned()]);
        for (lock, change, allowed) in [
            (&prediction, "shading.mode=flat", false),
            (&prediction, "camera.eye=[0,0,9]", false),
            (&prediction, "light.0.k=2", false),
            (&settings, "light.0.k=2", true),
            (&settings, "camera.eye=[0,0,9]", true),
            (&settings, "light.0.mute=true", false),
            (&settings, "material.ks=0", false),
        ] {
            let after = with(&[change]);
            assert_eq!(lock.allows(&scene, &after), allowed, "{change}");
        }
        let mut more = scene.clone();
        more.lights.push(more.lights[0].clone());
        assert!(!settings.allows(&scene, &more) && settings.allows(&scene, &scene));
    }
}
