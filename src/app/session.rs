//! A session: the document that is open, as its panes show it, with what undo and redo lead to. What is open and how it is looked
//! at is a [`Session`] and a [`WindowState`]; what is asked of them is an [`action::Action`].
//!
//! A pane's scene is derived from the document's. The controls edit the active pane's, [`Session::shown`]; [`Session::commit`] sends
//! what has changed in it to the document, except for what the pane has of its own:
//!
//! ```text
//!   document ──┬────────────────────────→ pane 0     a key that a pane sets itself changes there alone,
//!              ├── shading.mode=exact ──→ pane 1     any other changes everywhere
//!              └── object.segments=64 ──→ pane 2
//! ```

pub mod action;
pub mod appearance;
pub mod document;
pub mod place;
pub mod recovery;
pub mod window;

use crate::document::undrawn;
use crate::render::check_mesh_memory;
use crate::scene::parameter::Parameter;
use crate::scene::{Choice as _, Compare, CompareView, Pane, Scene, SceneError, ShadingMode};
use document::{Document, History, Origin};

/// The document that is open, as its panes show it, and the documents that undo and redo lead to.
#[derive(Default)]
pub struct Session {
    /// The scene that is open.
    document: Document,
    /// The document as the active pane shows it; the controls edit its scene, see [`Session::commit`].
    pub shown: Document,
    /// The documents that undo and redo lead to.
    history: History,
    /// The panes of a comparison, and which of them is active.
    pub panes: Panes,
    /// The document as last opened or saved.
    saved: Document,
    /// The scene as opened, or as saved in a new file.
    opened: Scene,
    /// The active pane's scene as opened: the values that resetting returns to.
    pub initial: Scene,
    /// Whether another scene has been opened since the controls were last shown.
    just_opened: bool,
    /// Whether the document differs from what was saved; and whether it has changed since the history last saw it.
    modified: bool,
    unobserved: bool,
    /// Documents that were open before, as they were opened or saved: undo reaches back to them.
    opened_history: Vec<(Document, Scene)>,
    /// Index of the light whose controls are shown.
    pub light: usize,
    /// Number of the vertex whose place is shown, of a scene's own polygons.
    pub vertex: usize,
    /// What was last done, said for a few seconds; another document that is opened takes it away.
    pub notice: Option<String>,
    /// What is wrong with what is open, said until it is dismissed or another document is opened.
    pub warning: Option<String>,
}

impl Session {
    /// Returns the document that is open.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// Returns the document as last opened or saved.
    pub fn saved(&self) -> &Document {
        &self.saved
    }

    /// Returns the scene as opened, or as saved in a new file.
    pub fn opened(&self) -> &Scene {
        &self.opened
    }

    /// Returns the documents that undo and redo lead to.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// Returns, once, whether another scene has been opened.
    pub fn take_just_opened(&mut self) -> bool {
        std::mem::take(&mut self.just_opened)
    }

    /// Begins anew with `document`, which undo does not take back.
    pub fn begin(&mut self) {
        self.history = History::new(self.document.clone());
    }

    /// Puts another document in the place of this one; the present one is a step of undo away. Where the memory to draw it cannot be
    /// had, a notice says so and this one stays; returns whether it went.
    pub fn replace(&mut self, document: Document) -> bool {
        if let Err(error) = check_mesh_memory(&document.scene, document.model.as_deref()) {
            self.notice = Some(error.to_string());
            return false;
        }
        self.document = document;
        (self.notice, self.warning) = (None, None);
        self.just_opened = true;
        self.panes.active = 0;
        (self.light, self.vertex) = (0, 0);
        self.opened = self.document.scene.clone();
        self.mark_saved();
        self.derive();
        self.initial.clone_from(&self.opened);
        true
    }

    /// Takes the document as it is for saved, and remembers it for when undo comes back to it.
    fn mark_saved(&mut self) {
        self.saved = self.document.clone();
        (self.modified, self.unobserved) = (false, true);
        let (origin, history) = (&self.saved.origin, &self.history);
        self.opened_history
            .retain(|(saved, _)| saved.origin != *origin && history.reaches(&saved.origin));
        self.opened_history
            .push((self.saved.clone(), self.opened.clone()));
    }

    /// Takes the last step back.
    pub fn undo(&mut self) {
        self.history.undo(&mut self.document);
        self.return_to_origin();
    }

    /// Takes the last step that was undone again.
    pub fn redo(&mut self) {
        self.history.redo(&mut self.document);
        self.return_to_origin();
    }

    /// After undo or redo: what was opened or saved may have been another document.
    fn return_to_origin(&mut self) {
        let origin = &self.document.origin;
        let mut known = self.opened_history.iter();
        let known = known.find(|(saved, _)| saved.origin == *origin);
        if let Some((saved, opened)) = known.filter(|_| *origin != self.saved.origin).cloned() {
            (self.saved, self.opened) = (saved, opened);
            self.notice = None;
            (self.light, self.vertex) = (0, 0);
            self.derive();
            self.take_initial();
        } else {
            self.derive();
        }
    }

    /// Records in the history what has become of the document by the end of a frame, see [`History::observe`].
    pub fn observe(&mut self, held: bool, time: f64) {
        if held || std::mem::take(&mut self.unobserved) {
            self.history.observe(&self.document, held, time);
        }
    }

    /// Returns whether the document has changed since it was opened or saved.
    pub fn modified(&self) -> bool {
        self.modified
    }

    /// Takes over what has changed in the active pane's scene or in the document, so that every pane shows it. What a scene
    /// file would refuse is taken back, and the notice says why in the same words.
    pub fn commit(&mut self) {
        let changes = self.panes.changes(&self.shown.scene);
        if !changes.is_empty() || self.document.scene != self.panes.document {
            if let Err(words) = self.take_over(&changes) {
                self.notice = Some(words);
                self.document.scene = self.panes.document.clone();
            }
            self.derive();
        }
    }

    fn take_over(&mut self, changes: &[Change]) -> Result<(), String> {
        let Self {
            document,
            shown,
            panes,
            ..
        } = self;
        let words = |error: SceneError| {
            let first = error.problems().first();
            first.map(ToString::to_string).unwrap_or_default()
        };
        shown.scene.validate().map_err(words)?;
        distribute(&mut document.scene, panes, &shown.scene, changes);
        mend(&mut document.scene);
        document.scene.validate().map_err(words)?;
        check_mesh_memory(&document.scene, document.model.as_deref())
            .map_err(|error| error.to_string())
    }

    /// Derives from the document all that follows from it: the panes' scenes, what is chosen in them and what is wrong with the
    /// model. Whatever changes the document ends here, undo and redo too.
    fn derive(&mut self) {
        self.modified = self.document != self.saved;
        self.unobserved = true;
        let Self {
            document,
            shown,
            panes,
            ..
        } = self;
        let scene = &document.scene;
        panes.document.clone_from(scene);
        panes.others = (1..scene.pane_count())
            .map(|pane| scene.pane(pane).unwrap_or_else(|_| scene.clone()))
            .collect();
        if !scene.shown_panes().contains(&panes.active) {
            panes.active = 0;
            self.initial.clone_from(&self.opened);
        }
        if !panes.changes(&shown.scene).is_empty() {
            shown.scene = Scene {
                compare: Compare::default(),
                ..panes.scene(panes.active).clone()
            };
        }
        if document.model_differs(shown) {
            self.warning = undrawn(&document.scene.object, document.model.as_deref());
        }
        (shown.model, shown.origin) = (document.model.clone(), document.origin.clone());
        self.keep_chosen();
    }

    /// Keeps the chosen light and the chosen vertex among those that there are.
    pub fn keep_chosen(&mut self) {
        let Scene { lights, object, .. } = &self.shown.scene;
        let vertices = object.polygons().vertices.len();
        self.light = self.light.min(lights.len().saturating_sub(1));
        self.vertex = self.vertex.min(vertices.saturating_sub(1));
    }

    /// Edits the document's scene, beside the active pane's as opened; what a scene file would refuse is taken back, see
    /// [`Session::commit`].
    pub fn edit(&mut self, change: impl FnOnce(&mut Scene, &Scene)) {
        change(&mut self.document.scene, &self.initial);
        self.commit();
    }

    /// Puts another scene in the place of the document's, as one edit of it.
    pub fn put_scene(&mut self, scene: Scene) {
        self.edit(|present, _| *present = scene);
    }

    /// Takes the document as it is for saved as `origin`. In a new file it is as opened.
    pub fn save_as(&mut self, origin: Origin) {
        if self.document.origin != origin {
            self.opened = self.document.scene.clone();
            self.activate(self.panes.active);
        }
        self.document.origin = origin;
        self.mark_saved();
    }

    /// Puts another scene in the place of the document's, as a change that needs not be saved.
    pub fn show_scene(&mut self, scene: Scene) {
        self.put_scene(scene);
        self.saved.scene.clone_from(&self.document.scene);
        self.modified = self.document != self.saved;
    }

    /// Takes `document` for the one that is open as it has become.
    pub fn restore(&mut self, document: Document) {
        self.document = document;
        self.derive();
    }

    /// The message to show: what was last done goes before what is wrong.
    pub fn said(&self) -> Option<&str> {
        self.notice.as_deref().or(self.warning.as_deref())
    }

    /// Makes another pane the active one.
    pub fn activate(&mut self, pane: usize) {
        self.commit();
        self.panes.active = pane;
        self.derive();
        self.take_initial();
    }

    fn take_initial(&mut self) {
        let initial = self.opened.pane(self.panes.active);
        self.initial = initial.unwrap_or_else(|_| self.opened.clone());
    }

    /// Shows the panes in another way; where there are none, beside the exact picture.
    pub fn compare(&mut self, view: CompareView) {
        let exact = self.shown.scene.shading.mode == ShadingMode::Exact;
        let compare = &mut self.document.scene.compare;
        if view != CompareView::Single && compare.panes.is_empty() {
            let other = if exact {
                "shading.mode=phong"
            } else {
                "shading.mode=exact"
            };
            compare.panes.push(Pane::of(&[other]));
            compare.reference = 0;
        }
        compare.view = view;
    }

    /// Changes which panes there are; pane `active` is the active one afterwards.
    pub fn rearrange(
        &mut self,
        active: usize,
        change: impl Fn(&mut Scene) -> Result<(), SceneError>,
    ) {
        self.commit();
        match change(&mut self.document.scene) {
            Ok(()) => {
                self.panes.active = active;
                // What resetting returns to goes with its pane.
                let count = self.document.scene.pane_count();
                let mut opened = self.opened.clone();
                if change(&mut opened).is_ok() && opened.pane_count() == count {
                    self.opened = opened;
                }
                self.derive();
                self.take_initial();
            }
            Err(error) => self.notice = error.problems().first().map(ToString::to_string),
        }
    }

    /// The way to compare after the present one.
    pub fn next_comparison(&self) -> CompareView {
        let present = self.document.scene.compare.view;
        let views = CompareView::VALUES;
        let place = views.iter().position(|view| *view == present);
        views[place.map_or(0, |place| (place + 1) % views.len())]
    }
}

/// Tables and keys in which panes do not differ.
fn is_shared(parameter: &Parameter) -> bool {
    ["version", "about", "camera", "image"].contains(&parameter.section())
        || parameter.key == "object.path"
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
    for &(parameter, index) in changes
        .iter()
        .filter(|(parameter, _)| !(renewed && parameter.of_light()))
    {
        let key = parameter.key(index);
        let alone = panes.own && !is_shared(parameter);
        let compared = &mut document.compare.panes;
        match panes
            .active
            .checked_sub(1)
            .and_then(|pane| compared.get_mut(pane))
        {
            Some(pane) if alone || pane.value(&key).is_some() => {
                pane.put(&key, &parameter.setting(after, index));
                continue;
            }
            None if alone => {
                let kept = parameter.setting(before, index);
                compared
                    .iter_mut()
                    .filter(|pane| pane.value(&key).is_none())
                    .for_each(|pane| pane.put(&key, &kept));
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

/// Which pane is being worked on, and what the panes show.
#[derive(Debug, Default)]
pub struct Panes {
    /// The pane whose scene the controls show, from 0.
    pub active: usize,
    /// Whether changes concern that pane alone.
    pub own: bool,
    /// The document's scene that the others are derived from; the first pane shows it.
    document: Scene,
    /// The scenes of the panes beside the first.
    others: Vec<Scene>,
}

/// A parameter and the number of the light that it belongs to.
type Change = (&'static Parameter, usize);

impl Panes {
    /// The scene that a pane shows.
    pub fn scene(&self, pane: usize) -> &Scene {
        pane.checked_sub(1)
            .and_then(|index| self.others.get(index))
            .unwrap_or(&self.document)
    }

    /// What differs in a scene from what the active pane shows.
    fn changes(&self, scene: &Scene) -> Vec<Change> {
        let before = self.scene(self.active);
        before
            .differences(scene)
            .filter(|(parameter, _)| parameter.section() != "compare")
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Light;

    /// A scene beside which a pane shows it exactly.
    fn session() -> Session {
        let mut session = Session::default();
        let compare = &mut session.document.scene.compare;
        compare.view = CompareView::Panes;
        compare.panes = vec![
            Pane::of(&["shading.mode=exact"]),
            Pane::of(&["object.segments=64"]),
        ];
        session.commit();
        session
    }

    fn edit(session: &mut Session, pane: usize, change: impl FnOnce(&mut Scene)) {
        session.activate(pane);
        change(&mut session.shown.scene);
        session.commit();
        assert_eq!(session.document.scene.validate(), Ok(()));
    }

    fn scenes(session: &Session) -> Vec<&Scene> {
        (0..3).map(|pane| session.panes.scene(pane)).collect()
    }

    fn modes(session: &Session) -> Vec<ShadingMode> {
        scenes(session)
            .iter()
            .map(|scene| scene.shading.mode)
            .collect()
    }

    #[test]
    fn a_change_goes_to_all_panes_but_those_that_have_their_own() {
        let mut session = session();
        edit(&mut session, 0, |scene| {
            scene.shading.mode = ShadingMode::Gouraud;
        });
        assert_eq!(
            modes(&session),
            [
                ShadingMode::Gouraud,
                ShadingMode::Exact,
                ShadingMode::Gouraud
            ]
        );
        edit(&mut session, 1, |scene| {
            scene.shading.mode = ShadingMode::Flat;
        });
        assert_eq!(
            modes(&session),
            [
                ShadingMode::Gouraud,
                ShadingMode::Flat,
                ShadingMode::Gouraud
            ]
        );
        edit(&mut session, 1, |scene| scene.material.n = 7.5);
        assert!(scenes(&session).iter().all(|scene| scene.material.n == 7.5));
        edit(&mut session, 2, |scene| scene.camera.fov_y = 20.0);
        assert!(
            scenes(&session)
                .iter()
                .all(|scene| scene.camera.fov_y == 20.0)
        );
    }

    #[test]
    fn a_change_of_one_pane_alone_stays_there() {
        let mut session = session();
        session.panes.own = true;
        // Looking changes nothing.
        let before = session.document.scene.clone();
        (0..3).for_each(|pane| edit(&mut session, pane, |_| {}));
        assert_eq!(session.document.scene, before);
        session.activate(7);
        assert_eq!(session.panes.active, 0);
        let before = before.material.kd;
        edit(&mut session, 1, |scene| scene.material.n = f64::INFINITY);
        edit(&mut session, 0, |scene| scene.material.kd *= 0.5);
        let scenes = scenes(&session);
        assert_eq!(scenes[1].material.n, f64::INFINITY);
        assert_ne!(scenes[0].material.n, f64::INFINITY);
        assert_eq!(scenes[0].material.kd, before * 0.5);
        assert!(scenes[1..].iter().all(|scene| scene.material.kd == before));
    }

    #[test]
    fn what_resetting_returns_to_moves_with_its_pane() {
        let mut session = session();
        session.opened = session.document.scene.clone();
        for (from, to) in [(1, 0), (0, 2), (2, 1)] {
            session.rearrange(to, |scene| scene.move_pane(from, to));
            assert_eq!(session.initial, session.shown.scene, "{from} to {to}");
        }
    }

    #[test]
    fn lights_are_added_and_removed_for_all() {
        let mut session = session();
        session.document.scene.compare.panes[0].put("light.0.mute", "true");
        edit(&mut session, 1, |scene| scene.lights.push(Light::default()));
        assert!(scenes(&session).iter().all(|scene| scene.lights.len() == 2));
        edit(&mut session, 2, |scene| scene.lights.clear());
        assert!(scenes(&session).iter().all(|scene| scene.lights.is_empty()));
        assert_eq!(
            session.document.scene.compare.panes[0].set,
            ["shading.mode=exact"]
        );
    }

    #[test]
    fn what_a_file_refuses_is_taken_back_with_the_same_sentence() {
        let mut session = session();
        for pane in 0..3 {
            edit(&mut session, pane, |scene| scene.material.n = -1.0);
            assert_eq!(
                session.notice.take().as_deref(),
                Some("`material.n` is -1, expected 0 to inf")
            );
            assert_eq!(session.shown.scene.material.n, 32.0);
        }
        session.document.scene.compare.gain = 1000.0;
        session.commit();
        assert_eq!(
            session.notice.as_deref(),
            Some("`compare.gain` is 1000, expected 1 to 64")
        );
        assert_eq!(session.document.scene.compare.gain, 8.0);
    }
}
