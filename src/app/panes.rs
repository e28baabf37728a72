//! Panes in the window: whose scene the controls show, and where a change goes.
//!
//! While panels run, the document's scene is the active pane's. What has changed in it goes to the scene that all panes
//! share, except for what the pane has of its own:
//!
//! ```text
//!   shared scene ──┬────────────────────────→ pane 0     a key that a pane sets itself changes there alone,
//!                  ├── shading.mode=exact ──→ pane 1     any other changes everywhere
//!                  └── object.segments=64 ──→ pane 2
//! ```

mod captions;
mod keys;
mod place;

pub use captions::paint;
pub use place::{PanePlace, on_wipe, pane_at, places};

use super::state::AppState;
use crate::scene::{Compare, Pane, Scene, SceneError};
use keys::{changes, replaced};

/// Tables and keys in which panes do not differ.
const SHARED: [&str; 4] = ["version", "camera.", "image.", "object.path"];

/// Which pane is being worked on.
#[derive(Debug, Default)]
pub struct Panes {
    /// The pane whose scene the controls show, from 0.
    pub active: usize,
    /// Whether changes concern that pane alone.
    pub own: bool,
    entered: Option<Entered>,
    /// The panes' scenes as last worked out, and what from.
    known: Option<(Scene, Vec<Scene>)>,
}

/// What the document's scene stands in for.
#[derive(Debug)]
struct Entered {
    shared: Scene,
    /// The active pane's scene when it took the document's place.
    before: Scene,
}

impl AppState {
    /// The scene that all panes share: what is saved.
    pub fn shared_scene(&self) -> &Scene {
        self.panes.entered.as_ref().map_or(&self.document.scene, |entered| &entered.shared)
    }

    /// Puts the active pane's scene in the document's place.
    pub fn enter_pane(&mut self) {
        if self.panes.entered.is_some() {
            return;
        }
        if !self.document.scene.shown_panes().contains(&self.panes.active) {
            self.panes.active = 0;
        }
        let compare = self.document.scene.compare.clone();
        let mut scene = self.pane_scene(self.panes.active);
        scene.compare = compare;
        let shared = std::mem::replace(&mut self.document.scene, scene.clone());
        self.panes.entered = Some(Entered { shared, before: scene });
    }

    /// Gives the document its own scene back, with what has changed. What a scene file would refuse is not taken over, and the
    /// notice says why in the same words.
    pub fn leave_pane(&mut self) {
        let Some(Entered { shared, before }) = self.panes.entered.take() else { return };
        let after = std::mem::replace(&mut self.document.scene, shared);
        if after == before {
            return;
        }
        match self.taken_over(&before, after) {
            Ok(scene) => self.document.scene = scene,
            Err(error) => self.notice = error.problems().first().map(ToString::to_string),
        }
    }

    /// The document's scene with what has changed in the active pane's.
    fn taken_over(&self, before: &Scene, after: Scene) -> Result<Scene, SceneError> {
        let shared = &self.document.scene;
        if shared.compare.panes.is_empty() {
            return after.validate().map(|()| after);
        }
        Scene { compare: Compare::default(), ..after.clone() }.validate()?;
        let mut changed = Scene { compare: after.compare.clone(), ..shared.clone() };
        distribute(&mut changed, before, &after, self.panes.active, self.panes.own);
        mend(&mut changed);
        changed.validate().map(|()| changed)
    }

    /// Sends what has changed to where it belongs, so that every pane shows it.
    pub fn commit_pane(&mut self) {
        if self.panes.entered.as_ref().is_some_and(|entered| entered.before != self.document.scene) {
            self.leave_pane();
            self.enter_pane();
        }
    }

    /// Makes another pane the active one.
    pub fn activate(&mut self, pane: usize) {
        if pane != self.panes.active {
            let entered = self.panes.entered.is_some();
            self.leave_pane();
            self.panes.active = pane;
            if entered {
                self.enter_pane();
            }
        }
    }

    /// The panes that are shown: their numbers and scenes. What they compare is left to the shared scene.
    pub fn shown_scenes(&mut self) -> Vec<(usize, Scene)> {
        let shown = self.shared_scene().shown_panes();
        shown.into_iter().map(|pane| (pane, self.pane_scene(pane))).collect()
    }

    fn pane_scene(&mut self, pane: usize) -> Scene {
        let shared = self.panes.entered.as_ref().map_or(&self.document.scene, |entered| &entered.shared);
        if self.panes.known.as_ref().is_none_or(|(known, _)| known != shared) {
            let alone = || Scene { compare: Compare::default(), ..shared.clone() };
            let scenes = (0..shared.pane_count()).map(|pane| shared.pane(pane).unwrap_or_else(|_| alone())).collect();
            self.panes.known = Some((shared.clone(), scenes));
        }
        let scenes = self.panes.known.as_ref().map(|(_, scenes)| scenes);
        scenes.and_then(|scenes| scenes.get(pane).or(scenes.last())).cloned().unwrap_or_default()
    }
}

/// Sends what differs between two states of pane `active` to the shared scene, to the pane, or (a change of the first pane
/// alone) keeps it from the other panes.
fn distribute(shared: &mut Scene, before: &Scene, after: &Scene, active: usize, own: bool) {
    if before.lights.len() != after.lights.len() {
        shared.lights.clone_from(&after.lights);
    }
    let mut common = Vec::new();
    for change in changes(before, after) {
        let everywhere = SHARED.iter().any(|shared| change.key.starts_with(shared));
        let panes = &mut shared.compare.panes;
        match active.checked_sub(1).and_then(|index| panes.get_mut(index)) {
            Some(pane) if !everywhere && (own || pane.value(&change.key).is_some()) => {
                pane.put(&change.key, &change.after_text());
                continue;
            }
            Some(_) => {}
            None if own && !everywhere => {
                for pane in panes.iter_mut().filter(|pane| pane.value(&change.key).is_none()) {
                    pane.put(&change.key, &change.before_text());
                }
            }
            None => {}
        }
        common.push(change);
    }
    if let Some(changed) = replaced(shared, &common) {
        *shared = changed;
    }
}

/// Takes back what panes set that the shared scene no longer allows, such as a key of a light that is gone.
fn mend(shared: &mut Scene) {
    let alone = Scene { compare: Compare::default(), ..shared.clone() };
    for pane in &mut shared.compare.panes {
        if alone.with_overrides(&pane.set).is_err() {
            let mut sound = Pane { name: pane.name.clone(), set: vec![] };
            for setting in &pane.set {
                sound.set.push(setting.clone());
                if alone.with_overrides(&sound.set).is_err() {
                    sound.set.pop();
                }
            }
            *pane = sound;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{CompareView, Light, ShadingMode};

    /// A scene beside which a pane shows it exactly.
    fn state() -> AppState {
        let mut state = AppState::default();
        let compare = &mut state.document.scene.compare;
        compare.view = CompareView::Panes;
        compare.panes = vec![Pane::of(&["shading.mode=exact"]), Pane::of(&["object.segments=64"])];
        state
    }

    fn edit(state: &mut AppState, pane: usize, change: impl FnOnce(&mut Scene)) {
        state.activate(pane);
        state.enter_pane();
        change(&mut state.document.scene);
        state.leave_pane();
        assert_eq!(state.document.scene.validate(), Ok(()));
    }

    fn modes(state: &mut AppState) -> Vec<ShadingMode> {
        state.shown_scenes().iter().map(|(_, scene)| scene.shading.mode).collect()
    }

    #[test]
    fn a_change_goes_to_all_panes_but_those_that_have_their_own() {
        let mut state = state();
        edit(&mut state, 0, |scene| scene.shading.mode = ShadingMode::Gouraud);
        assert_eq!(modes(&mut state), [ShadingMode::Gouraud, ShadingMode::Exact, ShadingMode::Gouraud]);
        edit(&mut state, 1, |scene| scene.shading.mode = ShadingMode::Flat);
        assert_eq!(modes(&mut state), [ShadingMode::Gouraud, ShadingMode::Flat, ShadingMode::Gouraud]);
        edit(&mut state, 1, |scene| scene.material.n = 7.5);
        assert!(state.shown_scenes().iter().all(|(_, scene)| scene.material.n == 7.5));
        edit(&mut state, 2, |scene| scene.camera.fov_y = 20.0);
        assert!(state.shown_scenes().iter().all(|(_, scene)| scene.camera.fov_y == 20.0));
    }

    #[test]
    fn a_change_of_one_pane_alone_stays_there() {
        let mut state = state();
        state.panes.own = true;
        let before = state.document.scene.material.kd;
        edit(&mut state, 1, |scene| scene.material.n = f64::INFINITY);
        edit(&mut state, 0, |scene| scene.material.kd *= 0.5);
        let scenes = state.shown_scenes();
        assert_eq!(scenes[1].1.material.n, f64::INFINITY);
        assert_ne!(scenes[0].1.material.n, f64::INFINITY);
        assert_eq!(scenes[0].1.material.kd, before * 0.5);
        assert!(scenes[1..].iter().all(|(_, scene)| scene.material.kd == before));
    }

    #[test]
    fn lights_are_added_and_removed_for_all() {
        let mut state = state();
        state.document.scene.compare.panes[0].put("light.0.mute", "true");
        edit(&mut state, 1, |scene| scene.lights.push(Light::default()));
        assert!(state.shown_scenes().iter().all(|(_, scene)| scene.lights.len() == 2));
        edit(&mut state, 2, |scene| scene.lights.clear());
        assert!(state.shown_scenes().iter().all(|(_, scene)| scene.lights.is_empty()));
        assert_eq!(state.document.scene.compare.panes[0].set, ["shading.mode=exact"]);
    }

    #[test]
    fn looking_changes_nothing() {
        let mut state = state();
        let before = state.document.scene.clone();
        for pane in 0..3 {
            edit(&mut state, pane, |_| {});
        }
        assert_eq!(state.document.scene, before);
        state.panes.active = 7;
        state.enter_pane();
        assert_eq!(state.panes.active, 0);
    }
}
