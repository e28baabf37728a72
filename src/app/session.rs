//! A session: the open document as its panes show it, and the undo history. A [`Session`] holds what is open, a
//! [`window::WindowState`] how it is viewed; an [`action::Action`] is a request to change them.
//!
//! A pane's scene is derived from the document's. The controls edit the scene of the active pane, [`Session::shown`];
//! [`Session::commit`] sends its changes to the document, except for settings of the pane's own:
//!
//! ```text
//!   document ──┬────────────────────────→ pane 0     a key that a pane sets itself changes there alone,
//!              ├── shading.mode=exact ──→ pane 1     any other changes everywhere
//!              └── object.segments=64 ──→ pane 2
//! ```

pub mod action;
pub mod appearance;
pub mod document;
pub mod history;
pub mod lock;
pub mod notice;
mod panes;
pub mod place;
pub mod recovery;
pub mod window;

use crate::document::undrawn;
use crate::render::check_mesh_memory;
use crate::scene::{Choice as _, Compare, CompareView, Pane, Scene, SceneError, ShadingMode};
use crate::text::text;
use action::Action;
use document::{Document, Origin};
use history::History;
use lock::Lock;
use notice::Notice;
pub use panes::Panes;
use panes::{Change, distribute, mend};

/// The open document as its panes show it, and the documents that undo and redo lead to.
#[derive(Default)]
pub struct Session {
    /// The open document.
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
    /// The active pane's scene as opened: the values that a reset restores.
    pub initial: Scene,
    /// True if another scene has been opened since the controls were last shown.
    just_opened: bool,
    /// True if the document differs from the saved one.
    modified: bool,
    /// True if the document has changed since the history last observed it.
    unobserved: bool,
    /// The number of times that another scene has taken the place of the present one.
    replacements: u64,
    /// Previously open documents, as they were opened or saved: undo can return to them.
    opened_history: Vec<(Document, Scene)>,
    /// Index of the light whose controls are shown.
    pub light: usize,
    /// Index of the vertex whose position is shown, among a scene's own polygons.
    pub vertex: usize,
    /// The lock of the open question, which keeps the scene until it is answered.
    pub lock: Option<Lock>,
    /// A message about the last action, shown for a few seconds or until another document is opened.
    pub notice: Option<Notice>,
    /// A message about a problem with the open document, shown until it is dismissed or another document is opened.
    pub warning: Option<String>,
}

impl Session {
    /// Returns the open document.
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

    /// Returns how often another scene has taken the place of the present one: opened, restored, reset, reached by undo or
    /// redo, or moved to another pane. What is half typed then belongs to a scene that is gone.
    pub fn replacements(&self) -> u64 {
        self.replacements
    }

    /// Starts a new history with the open document, which undo does not take back.
    pub fn begin(&mut self) {
        self.history = History::new(self.document.clone());
    }

    /// Replaces the document with another one; undo returns to the present one. If there is not enough memory to draw
    /// the new one, shows a notice and keeps the present one. Returns whether the document was replaced.
    pub fn replace(&mut self, document: Document) -> bool {
        if let Err(error) = check_mesh_memory(&document.scene, document.model.as_deref()) {
            self.notice = Some(error.to_string().into());
            return false;
        }
        self.document = document;
        self.replacements += 1;
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

    /// Marks the document as saved, and remembers it for when undo returns to it.
    fn mark_saved(&mut self) {
        self.saved = self.document.clone();
        (self.modified, self.unobserved) = (false, true);
        let (origin, history) = (&self.saved.origin, &self.history);
        self.opened_history
            .retain(|(saved, _)| saved.origin != *origin && history.reaches(&saved.origin));
        self.opened_history
            .push((self.saved.clone(), self.opened.clone()));
    }

    /// Undoes the last step.
    pub fn undo(&mut self) {
        self.travel(History::undo, History::redo);
    }

    /// Redoes the last step that was undone.
    pub fn redo(&mut self) {
        self.travel(History::redo, History::undo);
    }

    /// Moves through the history, unless the lock keeps the scene. A document outside the lesson is not kept back.
    fn travel(&mut self, there: Travel, back: Travel) {
        self.notice = None;
        self.replacements += 1;
        let locked = self.lock.as_ref();
        let locked = locked.map(|lock| (lock, self.document.clone()));
        there(&mut self.history, &mut self.document);
        let after = &self.document;
        let held = locked.is_some_and(|(lock, before)| {
            before.part == after.part && !lock.allows(&before.scene, &after.scene)
        });
        if held {
            back(&mut self.history, &mut self.document);
            self.say_locked();
        }
        self.return_to_origin();
    }

    /// Says that the lock keeps the scene.
    pub fn say_locked(&mut self) {
        self.notice = Some(text!("course-locked").into());
    }

    /// Restores the saved state after undo or redo, which may have led to a document that was opened or saved as
    /// another one.
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

    /// Records in the history the document at the end of a frame, see [`History::observe`].
    pub fn observe(&mut self, held: bool, time: f64) {
        if held || std::mem::take(&mut self.unobserved) {
            let recorded = self.history.observe(&self.document, held, time);
            let undoes = |notice: &mut Notice| matches!(notice.offer, Some(Action::Undo));
            if let Some(notice) = self.notice.take_if(|notice| recorded && undoes(notice))
                && !notice.recorded
            {
                self.notice = Some(Notice { recorded, ..notice });
            }
        }
    }

    /// Returns whether the document has changed since it was opened or saved.
    pub fn modified(&self) -> bool {
        self.modified
    }

    /// Applies the changes of the active pane's scene or of the document, so that every pane shows them. Changes that a
    /// scene file would reject are reverted, with the file's error message as the notice.
    pub fn commit(&mut self) {
        let changes = self.panes.changes(&self.shown.scene);
        if !changes.is_empty() || self.document.scene != self.panes.document {
            if let Err(words) = self.take_over(&changes) {
                self.notice = Some(words.into());
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
            lock,
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
        let held = |lock: &Lock| !lock.allows(&panes.document, &document.scene);
        if lock.as_ref().is_some_and(held) {
            return Err(text!("course-locked").to_owned());
        }
        check_mesh_memory(&document.scene, document.model.as_deref())
            .map_err(|error| error.to_string())
    }

    /// Derives from the document everything that depends on it: the panes' scenes, the selection in them, and the
    /// warning about the model. Every change of the document ends here, undo and redo included.
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
            let mut said = undrawn(&document.scene.object, document.model.as_deref());
            let more = said.len().saturating_sub(1);
            self.warning = said.drain(..).next().map(|first| match more {
                0 => first,
                _ => text!("document-and-more", first = first, count = more),
            });
        }
        (shown.model, shown.origin) = (document.model.clone(), document.origin.clone());
        self.keep_chosen();
    }

    /// Removes a light from the active pane's scene; a notice offers to undo it.
    pub fn remove_light(&mut self, index: usize) {
        let lights = &mut self.shown.scene.lights;
        if index < lights.len() {
            lights.remove(index);
            self.light -= usize::from(self.light > index);
            self.keep_chosen();
            let text = text!("lights-removed", number = index + 1);
            self.notice = Some(Notice::undoable(text));
        }
    }

    /// Clamps the selected light and the selected vertex to those that exist.
    fn keep_chosen(&mut self) {
        let Scene { lights, object, .. } = &self.shown.scene;
        let vertices = object.polygons().vertices.len();
        self.light = self.light.min(lights.len().saturating_sub(1));
        self.vertex = self.vertex.min(vertices.saturating_sub(1));
    }

    /// Edits the document's scene; `change` also gets the active pane's scene as opened. Changes that a scene file
    /// would reject are reverted, see [`Session::commit`].
    pub fn edit(&mut self, change: impl FnOnce(&mut Scene, &Scene)) {
        change(&mut self.document.scene, &self.initial);
        self.commit();
    }

    /// Replaces the document's scene, as one edit.
    pub fn put_scene(&mut self, scene: Scene) {
        self.replacements += 1;
        self.edit(|present, _| *present = scene);
    }

    /// Marks the document as saved as `origin`. After a save in a new file, resets restore the saved scene.
    pub fn save_as(&mut self, origin: Origin) {
        if self.document.origin != origin {
            self.opened = self.document.scene.clone();
            self.activate(self.panes.active);
        }
        self.document.origin = origin;
        self.mark_saved();
    }

    /// Replaces the document's scene, as a change that does not need to be saved. The lock does not keep it: the course
    /// shows its own scenes so.
    pub fn show_scene(&mut self, scene: Scene) {
        let lock = self.lock.take();
        self.put_scene(scene);
        self.lock = lock;
        self.saved.scene.clone_from(&self.document.scene);
        self.modified = self.document != self.saved;
    }

    /// Replaces the open document with a later state of it.
    pub fn restore(&mut self, document: Document) {
        self.document = document;
        self.replacements += 1;
        self.derive();
    }

    /// Returns the message to show: the notice, or else the warning.
    pub fn said(&self) -> Option<&str> {
        let notice = self.notice.as_ref().map(|notice| &*notice.text);
        notice.or(self.warning.as_deref())
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

    /// Shows the panes in another view. If there are none, adds one with the exact picture, or with Phong shading
    /// beside an exact one.
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

    /// Shows how the active pane differs from the same scene with Phong's model.
    pub fn compare_with_phong(&mut self) {
        let active = self.panes.active;
        if active > 0 {
            self.rearrange(0, |scene| scene.move_pane(active, 0));
        }
        self.edit(|scene, _| scene.compare_with_phong());
    }

    /// Adds, removes or moves panes; pane `active` is the active one afterwards.
    pub fn rearrange(
        &mut self,
        active: usize,
        change: impl Fn(&mut Scene) -> Result<(), SceneError>,
    ) {
        if self.lock.is_some() {
            return self.say_locked();
        }
        self.commit();
        match change(&mut self.document.scene) {
            Ok(()) => {
                self.replacements += 1;
                self.panes.active = active;
                // The values that a reset restores move with their pane.
                let count = self.document.scene.pane_count();
                let mut opened = self.opened.clone();
                if change(&mut opened).is_ok() && opened.pane_count() == count {
                    self.opened = opened;
                }
                self.derive();
                self.take_initial();
            }
            Err(error) => {
                let problem = error.problems().first();
                self.notice = problem.map(|problem| problem.to_string().into());
            }
        }
    }

    /// Returns the comparison view after the present one.
    pub fn next_comparison(&self) -> CompareView {
        let present = self.document.scene.compare.view;
        let views = CompareView::VALUES;
        let place = views.iter().position(|view| *view == present);
        views[place.map_or(0, |place| (place + 1) % views.len())]
    }
}

/// A step through the history: undo or redo.
type Travel = fn(&mut History, &mut Document);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Light, ReflectionModel};

    /// Returns a session with three panes: one shows the scene exactly, one with 64 segments.
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
        // Activating a pane changes nothing.
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
    fn the_active_panes_law_is_compared_with_phongs() {
        let mut session = session();
        session.panes.own = true;
        edit(&mut session, 2, |scene| {
            scene.reflection.model = ReflectionModel::Formula;
            scene.reflection.formula = "a = N·L\nkd * a".to_owned();
        });
        session.compare_with_phong();
        // Once more adds nothing.
        session.compare_with_phong();
        let scene = &session.document.scene;
        assert_eq!(scene.validate(), Ok(()));
        assert_eq!((scene.pane_count(), session.panes.active), (4, 0));
        assert_eq!(scene.compare.view, CompareView::Difference);
        let shown = scene.shown_panes().into_iter();
        let models = shown.map(|pane| session.panes.scene(pane).reflection.model);
        let models: Vec<_> = models.collect();
        assert_eq!(models, [ReflectionModel::Formula, ReflectionModel::Phong]);
        // A formula is named by its value.
        session.document.scene.compare.panes =
            vec![Pane::of(&["reflection.formula=\"a = 2\\na\""])];
        let names = [0, 1].map(|pane| session.document.scene.pane_name(pane));
        assert_eq!(names, ["kd * a", "a"]);
    }

    #[test]
    fn a_draft_can_tell_that_its_scene_is_gone() {
        let mut session = session();
        let mut count = session.replacements();
        let mut grows = |session: &Session| {
            let before = std::mem::replace(&mut count, session.replacements());
            session.replacements() > before
        };
        edit(&mut session, 0, |scene| scene.material.n = 7.0);
        assert!(!grows(&session), "edits are the draft's own");
        session.save_as(Origin::File("a.toml".into()));
        assert!(!grows(&session), "saving changes nothing");
        session.undo();
        assert!(grows(&session));
        session.redo();
        assert!(grows(&session));
        session.put_scene(Scene::default());
        assert!(grows(&session));
        session.restore(Document::default());
        assert!(grows(&session));
        assert!(session.replace(Document::default()) && grows(&session));
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
                session.said(),
                Some("`material.n` is -1, expected 0 to inf")
            );
            assert_eq!(session.shown.scene.material.n, 32.0);
        }
        session.document.scene.compare.gain = 1000.0;
        session.commit();
        assert_eq!(
            session.said(),
            Some("`compare.gain` is 1000, expected 1 to 64")
        );
        assert_eq!(session.document.scene.compare.gain, 8.0);
    }
}
