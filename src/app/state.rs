//! Everything that the window remembers: what is open, what is shown of it, and what was asked for.
//!
//! A pane's scene is derived from the document's. The controls edit the active pane's, [`AppState::shown`]; what has changed
//! in it goes to the document, except for what the pane has of its own:
//!
//! ```text
//!   document ──┬────────────────────────→ pane 0     a key that a pane sets itself changes there alone,
//!              ├── shading.mode=exact ──→ pane 1     any other changes everywhere
//!              └── object.segments=64 ──→ pane 2
//! ```

use super::action::Action;
use super::appearance::{Appearance, ViewName};
use super::course::{Course, Glide};
use super::dialog::Dialog;
use super::document::{CoursePart, Document, History, Origin};
use super::material::Gallery;
use super::place::{ProbePoint, ProfileLine};
use super::sampling::Sampling;
use super::symbol::Lit;
use crate::document::undrawn;
use crate::figure::Area;
use crate::render::check_mesh_memory;
use crate::scene::parameter::Parameter;
use crate::scene::{Compare, Scene, SceneError};
use eframe::egui::Vec2;
use glam::{DVec2, DVec3};
use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::path::PathBuf;

/// The state of the window. What is written to disk between two sessions is its look alone.
#[derive(Default)]
pub struct AppState {
    /// How the window looks.
    pub appearance: Appearance,
    /// The scene that is open.
    pub document: Document,
    /// The document as the active pane shows it; the controls edit its scene, see [`AppState::commit`].
    pub shown: Document,
    /// What undo and redo go through.
    pub history: History,
    /// The panes of a comparison, and which of them is active.
    pub panes: Panes,
    /// The document as last opened or saved.
    pub saved: Document,
    /// The scene as opened, or as saved in a new file: what resetting returns to.
    pub opened: Scene,
    /// Whether another scene has been opened since the controls were last shown.
    pub just_opened: bool,
    /// The pixel that is probed.
    pub probe: ProbePoint,
    /// Whether the probe is to be put beside the highlight, once the picture is drawn.
    pub seek_highlight: bool,
    /// What was opened before, as it was opened or saved: undo reaches back to it.
    pub begun: Vec<(Document, Scene)>,
    /// Where the profile is taken.
    pub line: ProfileLine,
    /// Index of the light whose controls are shown.
    pub light: usize,
    /// The vertex whose faces are lit up, while normals are shown.
    pub pointed: PointedVertex,
    /// Number of the vertex whose place is shown, of a scene's own polygons.
    pub vertex: usize,
    /// The error of the chosen area light.
    pub sampling: Sampling,
    /// Pictures of the named materials.
    pub gallery: Gallery,
    /// What is being dragged in the picture.
    pub drag: Option<Drag>,
    /// What handles and captions cover in the active pane, in its pixels: the letters of vectors keep off it.
    pub covered: Vec<Area>,
    /// The faces at the pointed vertex, drawn brighter.
    pub lit: Lit,
    /// Shows the open view alone.
    pub enlarged: bool,
    /// The controls that the window shows as a figure in another page, by the words of the link.
    pub embedded: Option<Vec<String>>,
    /// Whether the first start's card is shown.
    pub welcome: bool,
    /// Shows the picture alone.
    pub picture_alone: bool,
    /// Size of the picture with all its panes, pixels.
    pub room: [u32; 2],
    /// The dialog that is open.
    pub dialog: Option<Dialog>,
    /// The path that the desktop's own dialog gave, which has asked whether to replace the file.
    pub agreed: Option<PathBuf>,
    /// Whether the desktop turned out to have no dialog for files.
    pub no_dialog: bool,
    /// Whether the window is about to close, and what was asked about that.
    pub leaving: Leaving,
    /// The lessons, and what was answered.
    pub course: Course,
    /// The way to the scene of a lesson's step.
    pub gliding: Option<Glide>,
    /// What views and dialogs remember for themselves.
    pub own: ViewStates,
    /// What was last done, said for a few seconds; another document that is opened takes it away.
    pub notice: Option<String>,
    /// What is wrong with what is open, said until it is dismissed or another document is opened.
    pub warning: Option<String>,
    /// What was asked for in this frame, by button, menu or key.
    pub asked: Vec<Action>,
}

impl AppState {
    /// Whether a view is in sight.
    pub fn shows(&self, view: ViewName) -> bool {
        self.appearance.views && !self.picture_alone && self.appearance.view == view
    }

    /// Opens a view, and the panel.
    pub fn show_view(&mut self, view: ViewName) {
        (self.appearance.views, self.appearance.view) = (true, view);
    }

    /// Asks for an action, done at the end of the frame.
    pub fn ask(&mut self, action: Action) {
        self.asked.push(action);
    }

    /// Shows another document, in the view that its scene names; the present one is a step of undo away. Returns whether it is shown,
    /// see [`Self::replace`].
    pub fn open(&mut self, document: Document) -> bool {
        if !self.replace(document) {
            return false;
        }
        let view = self.document.scene.about.view.as_str();
        if let Ok(view) = serde_json::from_value(view.into()) {
            self.show_view(view);
        }
        if let CoursePart::HandIn(_) = self.document.part {
            self.show_view(ViewName::Course);
        }
        if let Origin::File(path) = &self.document.origin {
            self.appearance.remember(path);
        }
        true
    }

    /// Puts another document in the place of this one. Where the memory to draw it cannot be had, a notice says so and this one stays;
    /// returns whether it went.
    pub fn replace(&mut self, document: Document) -> bool {
        if let Err(error) = check_mesh_memory(&document.scene, document.model.as_deref()) {
            self.notice = Some(error.to_string());
            return false;
        }
        self.document = document;
        (self.notice, self.warning) = (None, None);
        self.gliding = None;
        self.saved = self.document.clone();
        self.opened = self.document.scene.clone();
        self.just_opened = true;
        self.appearance.profile.begin();
        self.begin();
        (self.light, self.vertex) = (0, 0);
        self.panes.active = 0;
        self.derive();
        self.lit.opened.clone_from(&self.opened);
        true
    }

    /// Remembers how the document was opened or saved, for when undo comes back to it.
    pub fn begin(&mut self) {
        let (origin, history) = (&self.saved.origin, &self.history);
        self.begun
            .retain(|(saved, _)| saved.origin != *origin && history.reaches(&saved.origin));
        self.begun.push((self.saved.clone(), self.opened.clone()));
    }

    /// After undo or redo: what was opened or saved may have been another document.
    pub fn return_to_origin(&mut self) {
        let origin = &self.document.origin;
        let begun = self.begun.iter().find(|(saved, _)| saved.origin == *origin);
        if let Some((saved, opened)) = begun.filter(|_| *origin != self.saved.origin).cloned() {
            (self.saved, self.opened) = (saved, opened);
            self.notice = None;
            (self.light, self.vertex) = (0, 0);
            self.derive();
            self.take_opened();
        } else {
            self.derive();
        }
    }

    /// Whether the document has changed since it was opened or saved.
    pub fn modified(&self) -> bool {
        self.document != self.saved
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

    /// Derives from the document all that follows from it: the panes' scenes, what is chosen in them, what is wrong with the
    /// model, and whether a lesson is in view. Whatever changes the document ends here, undo and redo too.
    pub fn derive(&mut self) {
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
            self.lit.opened.clone_from(&self.opened);
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
        self.follow_document();
    }

    /// Keeps the chosen light and the chosen vertex among those that there are.
    pub fn keep_chosen(&mut self) {
        let Scene { lights, object, .. } = &self.shown.scene;
        let vertices = object.polygons().vertices.len();
        self.light = self.light.min(lights.len().saturating_sub(1));
        self.vertex = self.vertex.min(vertices.saturating_sub(1));
    }

    /// What is said at present: what was last done goes before what is wrong.
    pub fn said(&self) -> Option<&str> {
        self.notice.as_deref().or(self.warning.as_deref())
    }

    /// Makes another pane the active one.
    pub fn activate(&mut self, pane: usize) {
        self.commit();
        self.panes.active = pane;
        self.derive();
        self.take_opened();
    }

    /// What resetting returns to in the active pane.
    pub fn take_opened(&mut self) {
        let opened = self.opened.pane(self.panes.active);
        self.lit.opened = opened.unwrap_or_else(|_| self.opened.clone());
    }
}

/// Tables and keys in which panes do not differ here.
fn is_shared(parameter: &Parameter) -> bool {
    Compare::shares(parameter.key) || parameter.section() == "about"
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

/// Whether the window is to close.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Leaving {
    #[default]
    No,
    OnceSaved,
    /// Whatever is unsaved.
    Now,
}

/// The vertex that the pointer is on, or was clicked on, in the active pane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PointedVertex {
    /// The vertex that is lit up, by its number among those with normals.
    pub lit: Option<u32>,
    /// The point of the mesh that was clicked on: its vertex stays lit when the pointer is elsewhere, whichever normals are
    /// chosen.
    pub kept: Option<u32>,
}

/// What the pointer drags in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    pub grip: Grip,
    /// From the pointer to the middle of what it holds, pixels.
    pub grab: DVec2,
    /// A light changes its distance, a vertex moves towards the viewer and away; the camera moves along the picture's plane.
    pub deep: bool,
    /// Where the light was that it holds.
    pub start: LightStart,
}

/// Where a light was when a drag of it began.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightStart {
    /// From the object's middle towards the light, world.
    pub offset: DVec3,
    /// Its handle, in the picture's pixels.
    pub pixel: DVec2,
    /// Whether the handle was where the light is, not at the picture's edge.
    pub in_picture: bool,
}

/// What the pointer can take hold of in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grip {
    /// An end of the profile's line.
    LineEnd(usize),
    /// The knob by which the picture is turned.
    Roll,
    /// A light, by its index.
    Light(usize),
    /// The head of the chosen light's axis, on the viewer's side of the light or beyond.
    Aim {
        front: bool,
    },
    /// The edge of the chosen spot light's cone; the unit vector points away from its axis.
    Rim(Vec2),
    /// A vertex of the scene's own polygons, by its number.
    Vertex(u32),
    Probe,
    /// The place that is marked as the answer to a question.
    Mark,
    /// The line of a wipe.
    Wipe,
    /// The camera about its target.
    Camera,
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

/// What each view and dialog remembers, kept by its type, so that the window's state need not know them.
#[derive(Debug, Default)]
pub struct ViewStates(HashMap<TypeId, Box<dyn Any>>);

impl ViewStates {
    /// The value, if there is one yet.
    pub fn get<T: 'static>(&self) -> Option<&T> {
        self.0.get(&TypeId::of::<T>())?.downcast_ref()
    }

    /// Takes the value out, to be put back; its default if there is none yet.
    pub fn take<T: Default + 'static>(&mut self) -> T {
        let value = self
            .0
            .remove(&TypeId::of::<T>())
            .and_then(|value| value.downcast().ok());
        value.map(|value| *value).unwrap_or_default()
    }

    /// Puts a value in its place.
    pub fn put<T: 'static>(&mut self, value: T) {
        self.0.insert(TypeId::of::<T>(), Box::new(value));
    }

    /// Changes the value.
    pub fn change<T: Default + 'static>(&mut self, change: impl FnOnce(&mut T)) {
        let mut value = self.take();
        change(&mut value);
        self.put(value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{CompareView, Light, Pane, ShadingMode, presets};

    #[test]
    fn opening_a_built_in_scene_opens_its_view() {
        for preset in presets::ALL
            .iter()
            .filter(|preset| preset.name != presets::DEFAULT)
        {
            let mut state = AppState::default();
            state.open(Document::built_in(preset.name).expect("a built-in scene"));
            let opened = serde_json::to_value(state.appearance.view).expect("a word");
            assert_eq!(opened, preset.view(), "{}", preset.name);
        }
    }

    /// A scene beside which a pane shows it exactly.
    fn state() -> AppState {
        let mut state = AppState::default();
        let compare = &mut state.document.scene.compare;
        compare.view = CompareView::Panes;
        compare.panes = vec![
            Pane::of(&["shading.mode=exact"]),
            Pane::of(&["object.segments=64"]),
        ];
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
        scenes(state)
            .iter()
            .map(|scene| scene.shading.mode)
            .collect()
    }

    #[test]
    fn a_change_goes_to_all_panes_but_those_that_have_their_own() {
        let mut state = state();
        edit(&mut state, 0, |scene| {
            scene.shading.mode = ShadingMode::Gouraud;
        });
        assert_eq!(
            modes(&state),
            [
                ShadingMode::Gouraud,
                ShadingMode::Exact,
                ShadingMode::Gouraud
            ]
        );
        edit(&mut state, 1, |scene| {
            scene.shading.mode = ShadingMode::Flat;
        });
        assert_eq!(
            modes(&state),
            [
                ShadingMode::Gouraud,
                ShadingMode::Flat,
                ShadingMode::Gouraud
            ]
        );
        edit(&mut state, 1, |scene| scene.material.n = 7.5);
        assert!(scenes(&state).iter().all(|scene| scene.material.n == 7.5));
        edit(&mut state, 2, |scene| scene.camera.fov_y = 20.0);
        assert!(
            scenes(&state)
                .iter()
                .all(|scene| scene.camera.fov_y == 20.0)
        );
    }

    #[test]
    fn a_change_of_one_pane_alone_stays_there() {
        let mut state = state();
        state.panes.own = true;
        // Looking changes nothing.
        let before = state.document.scene.clone();
        (0..3).for_each(|pane| edit(&mut state, pane, |_| {}));
        assert_eq!(state.document.scene, before);
        state.activate(7);
        assert_eq!(state.panes.active, 0);
        let before = before.material.kd;
        edit(&mut state, 1, |scene| scene.material.n = f64::INFINITY);
        edit(&mut state, 0, |scene| scene.material.kd *= 0.5);
        let scenes = scenes(&state);
        assert_eq!(scenes[1].material.n, f64::INFINITY);
        assert_ne!(scenes[0].material.n, f64::INFINITY);
        assert_eq!(scenes[0].material.kd, before * 0.5);
        assert!(scenes[1..].iter().all(|scene| scene.material.kd == before));
    }

    #[test]
    fn what_resetting_returns_to_moves_with_its_pane() {
        let mut state = state();
        state.opened = state.document.scene.clone();
        for (from, to) in [(1, 0), (0, 2), (2, 1)] {
            state.rearrange(to, |scene| scene.move_pane(from, to));
            assert_eq!(state.lit.opened, state.shown.scene, "{from} to {to}");
        }
    }

    #[test]
    fn lights_are_added_and_removed_for_all() {
        let mut state = state();
        state.document.scene.compare.panes[0].put("light.0.mute", "true");
        edit(&mut state, 1, |scene| scene.lights.push(Light::default()));
        assert!(scenes(&state).iter().all(|scene| scene.lights.len() == 2));
        edit(&mut state, 2, |scene| scene.lights.clear());
        assert!(scenes(&state).iter().all(|scene| scene.lights.is_empty()));
        assert_eq!(
            state.document.scene.compare.panes[0].set,
            ["shading.mode=exact"]
        );
    }

    #[test]
    fn what_a_file_refuses_is_taken_back_with_the_same_sentence() {
        let mut state = state();
        for pane in 0..3 {
            edit(&mut state, pane, |scene| scene.material.n = -1.0);
            assert_eq!(
                state.notice.take().as_deref(),
                Some("`material.n` is -1, expected 0 to inf")
            );
            assert_eq!(state.shown.scene.material.n, 32.0);
        }
        state.document.scene.compare.gain = 1000.0;
        state.commit();
        assert_eq!(
            state.notice.as_deref(),
            Some("`compare.gain` is 1000, expected 1 to 64")
        );
        assert_eq!(state.document.scene.compare.gain, 8.0);
    }
}
