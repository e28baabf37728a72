//! Where a change of the scene goes: to the document, or to the active pane alone.

use super::panes::{Change, Panes};
use super::state::AppState;
use crate::scene::parameter::Parameter;
use crate::scene::{Compare, Scene, SceneError};

impl AppState {
    /// Takes over what has changed in the active pane's scene or in the document, so that every pane shows it. What a scene
    /// file would refuse is taken back, and the notice says why in the same words.
    pub fn commit(&mut self) {
        let changes = self.panes.changes(&self.shown.scene);
        if !changes.is_empty() || self.document.scene != self.panes.document {
            if let Err(error) = self.take_over(&changes) {
                self.notice = error.problems().first().map(ToString::to_string);
                self.document.scene = self.panes.document.clone();
            }
            self.derive();
        }
    }

    fn take_over(&mut self, changes: &[Change]) -> Result<(), SceneError> {
        let Self { document, shown, panes, .. } = self;
        shown.scene.validate()?;
        distribute(&mut document.scene, panes, &shown.scene, changes);
        mend(&mut document.scene);
        document.scene.validate()
    }

    /// Derives the panes' scenes from the document's.
    pub fn derive(&mut self) {
        let Self { document, shown, panes, .. } = self;
        let scene = &document.scene;
        panes.document.clone_from(scene);
        panes.others = (1..scene.pane_count()).map(|pane| scene.pane(pane).unwrap_or_else(|_| scene.clone())).collect();
        if !scene.shown_panes().contains(&panes.active) {
            panes.active = 0;
            self.lit.opened.clone_from(&self.opened);
        }
        if !panes.changes(&shown.scene).is_empty() {
            shown.scene = Scene { compare: Compare::default(), ..panes.scene(panes.active).clone() };
        }
        if document.model_differs(shown) || document.origin != shown.origin {
            (shown.model, shown.origin) = (document.model.clone(), document.origin.clone());
        }
    }

    /// Makes another pane the active one.
    pub fn activate(&mut self, pane: usize) {
        self.commit();
        self.panes.active = pane;
        self.derive();
        self.lit.opened = self.opened.pane(self.panes.active).unwrap_or_else(|_| self.opened.clone());
    }
}

/// Tables and keys in which panes do not differ.
fn is_shared(parameter: &Parameter) -> bool {
    ["version", "about", "camera", "image"].contains(&parameter.section()) || parameter.key == "object.path"
}

/// Sends each change of the active pane to the document, or to the pane; a change of the first pane alone is kept from the
/// others.
fn distribute(document: &mut Scene, panes: &Panes, after: &Scene, changes: &[Change]) {
    let before = panes.scene(panes.active);
    // Lights are added and removed for all.
    let renewed = before.lights.len() != after.lights.len();
    if renewed {
        document.lights.clone_from(&after.lights);
    }
    for &(parameter, index) in changes.iter().filter(|(parameter, _)| !(renewed && parameter.of_light())) {
        let key = parameter.key(index);
        let alone = panes.own && !is_shared(parameter);
        let compared = &mut document.compare.panes;
        match panes.active.checked_sub(1).and_then(|pane| compared.get_mut(pane)) {
            Some(pane) if alone || pane.value(&key).is_some() => {
                pane.put(&key, &parameter.setting(after, index));
                continue;
            }
            None if alone => {
                let kept = parameter.setting(before, index);
                compared.iter_mut().filter(|pane| pane.value(&key).is_none()).for_each(|pane| pane.put(&key, &kept));
            }
            _ => {}
        }
        parameter.copy(after, document, index);
    }
}

/// Takes back what panes set that the document no longer allows, such as a key of a light that is gone.
fn mend(document: &mut Scene) {
    for place in 0..document.compare.panes.len() {
        if document.pane(place + 1).is_ok() {
            continue;
        }
        let settings = std::mem::take(&mut document.compare.panes[place].set);
        for setting in settings {
            document.compare.panes[place].set.push(setting);
            if document.pane(place + 1).is_err() {
                document.compare.panes[place].set.pop();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{CompareView, Light, Pane, ShadingMode};

    /// A scene beside which a pane shows it exactly.
    fn state() -> AppState {
        let mut state = AppState::default();
        let compare = &mut state.document.scene.compare;
        compare.view = CompareView::Panes;
        compare.panes = vec![Pane::of(&["shading.mode=exact"]), Pane::of(&["object.segments=64"])];
        state.commit();
        state
    }

    fn edit(state: &mut AppState, pane: usize, change: impl FnOnce(&mut Scene)) {
        state.activate(pane);
        change(&mut state.shown.scene);
        state.commit();
        assert_eq!(state.document.scene.validate(), Ok(()));
    }

    fn scenes(state: &AppState) -> Vec<&Scene> {
        (0..3).map(|pane| state.panes.scene(pane)).collect()
    }

    fn modes(state: &AppState) -> Vec<ShadingMode> {
        scenes(state).iter().map(|scene| scene.shading.mode).collect()
    }

    #[test]
    fn a_change_goes_to_all_panes_but_those_that_have_their_own() {
        let mut state = state();
        edit(&mut state, 0, |scene| scene.shading.mode = ShadingMode::Gouraud);
        assert_eq!(modes(&state), [ShadingMode::Gouraud, ShadingMode::Exact, ShadingMode::Gouraud]);
        edit(&mut state, 1, |scene| scene.shading.mode = ShadingMode::Flat);
        assert_eq!(modes(&state), [ShadingMode::Gouraud, ShadingMode::Flat, ShadingMode::Gouraud]);
        edit(&mut state, 1, |scene| scene.material.n = 7.5);
        assert!(scenes(&state).iter().all(|scene| scene.material.n == 7.5));
        edit(&mut state, 2, |scene| scene.camera.fov_y = 20.0);
        assert!(scenes(&state).iter().all(|scene| scene.camera.fov_y == 20.0));
    }

    #[test]
    fn a_change_of_one_pane_alone_stays_there() {
        let mut state = state();
        state.panes.own = true;
        let before = state.document.scene.material.kd;
        edit(&mut state, 1, |scene| scene.material.n = f64::INFINITY);
        edit(&mut state, 0, |scene| scene.material.kd *= 0.5);
        let scenes = scenes(&state);
        assert_eq!(scenes[1].material.n, f64::INFINITY);
        assert_ne!(scenes[0].material.n, f64::INFINITY);
        assert_eq!(scenes[0].material.kd, before * 0.5);
        assert!(scenes[1..].iter().all(|scene| scene.material.kd == before));
    }

    #[test]
    fn lights_are_added_and_removed_for_all() {
        let mut state = state();
        state.document.scene.compare.panes[0].put("light.0.mute", "true");
        edit(&mut state, 1, |scene| scene.lights.push(Light::default()));
        assert!(scenes(&state).iter().all(|scene| scene.lights.len() == 2));
        edit(&mut state, 2, |scene| scene.lights.clear());
        assert!(scenes(&state).iter().all(|scene| scene.lights.is_empty()));
        assert_eq!(state.document.scene.compare.panes[0].set, ["shading.mode=exact"]);
    }

    #[test]
    fn what_a_file_refuses_is_taken_back_with_the_same_sentence() {
        let mut state = state();
        for pane in 0..3 {
            edit(&mut state, pane, |scene| scene.material.n = -1.0);
            assert_eq!(state.notice.take().as_deref(), Some("`material.n` is -1, expected 0 to inf"));
            assert_eq!(state.shown.scene.material.n, 32.0);
        }
        state.document.scene.compare.gain = 1000.0;
        state.commit();
        assert_eq!(state.notice.as_deref(), Some("`compare.gain` is 1000, expected 1 to 64"));
        assert_eq!(state.document.scene.compare.gain, 8.0);
    }

    #[test]
    fn looking_changes_nothing() {
        let mut state = state();
        let before = state.document.scene.clone();
        for pane in 0..3 {
            edit(&mut state, pane, |_| {});
        }
        assert_eq!(state.document.scene, before);
        state.activate(7);
        assert_eq!(state.panes.active, 0);
    }
}
