//! Everything that the window remembers: what is open, what is shown of it, and what was asked for.

use super::action::Action;
use super::dialog::Dialog;
use super::document::Document;
use super::gallery::Gallery;
use super::history::History;
use super::look::{Look, NumbersTab};
use super::own::Own;
use super::panes::Panes;
use super::points::{ProbePoint, ProfileLine};
use super::sampling::Sampling;
use super::symbol::Lit;
use crate::scene::Scene;
use glam::DVec2;
use serde::de::IntoDeserializer;
use serde::de::value::{Error, StrDeserializer};
use serde::{Deserialize, Serialize};

/// The state of the window. What is written to disk between two sessions is how the window looks, not what is open.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(default)]
pub struct AppState {
    pub look: Look,
    #[serde(skip)]
    pub document: Document,
    /// The document as the active pane shows it; the controls edit its scene, see [`AppState::commit`].
    #[serde(skip)]
    pub shown: Document,
    #[serde(skip)]
    pub history: History,
    /// Which pane is worked on.
    #[serde(skip)]
    pub panes: Panes,
    /// The document as last opened or saved.
    #[serde(skip)]
    pub saved: Document,
    /// The scene as opened, or as saved in a new file: what resetting returns to.
    #[serde(skip)]
    pub opened: Scene,
    #[serde(skip)]
    pub probe: ProbePoint,
    /// Where the profile is taken.
    #[serde(skip)]
    pub line: ProfileLine,
    /// Index of the light whose controls are shown.
    #[serde(skip)]
    pub light: usize,
    /// The vertex whose faces are lit up, while normals are shown.
    #[serde(skip)]
    pub pointed: PointedVertex,
    /// Number of the vertex whose place is shown, of a scene's own polygons.
    #[serde(skip)]
    pub vertex: usize,
    /// The error of the chosen area light.
    #[serde(skip)]
    pub sampling: Sampling,
    /// Pictures of the named materials.
    #[serde(skip)]
    pub gallery: Gallery,
    #[serde(skip)]
    pub drag: Drag,
    #[serde(skip)]
    pub lit: Lit,
    /// Shows the picture alone.
    #[serde(skip)]
    pub picture_alone: bool,
    #[serde(skip)]
    pub dialog: Option<Dialog>,
    #[serde(skip)]
    pub leaving: Leaving,
    /// What tabs and dialogs remember for themselves.
    #[serde(skip)]
    pub own: Own,
    /// A line in the bottom bar about what was last done.
    #[serde(skip)]
    pub notice: Option<String>,
    /// What was asked for in this frame, by button, menu or key.
    #[serde(skip)]
    pub asked: Vec<Action>,
}

impl AppState {
    /// What was stored, as far as it is within bounds: anybody may have written it.
    pub fn sound(self) -> Self {
        Self { look: self.look.sound(), ..self }
    }

    /// Whether a tab of the panel of numbers is in sight.
    pub fn shows(&self, tab: NumbersTab) -> bool {
        self.look.numbers && !self.picture_alone && self.look.tab == tab
    }

    /// Opens a tab of the panel of numbers, and the panel.
    pub fn show_tab(&mut self, tab: NumbersTab) {
        (self.look.numbers, self.look.tab) = (true, tab);
    }

    /// Asks for an action, done at the end of the frame.
    pub fn ask(&mut self, action: Action) {
        self.asked.push(action);
    }

    /// Shows another document, in the tab that its scene names; the present one is a step of undo away.
    pub fn open(&mut self, document: Document) {
        let view: StrDeserializer<'_, Error> = document.scene.about.view.as_str().into_deserializer();
        if let Ok(tab) = NumbersTab::deserialize(view) {
            (self.look.tab, self.look.numbers) = (tab, true);
        }
        self.document = document;
        self.saved = self.document.clone();
        self.opened = self.document.scene.clone();
        self.light = 0;
        self.panes.active = 0;
        self.vertex = 0;
        self.derive();
        self.lit.opened.clone_from(&self.opened);
    }

    /// Whether the document has changed since it was opened or saved.
    pub fn modified(&self) -> bool {
        let Document { scene, origin, .. } = &self.saved;
        self.document.scene != *scene || self.document.origin != *origin || self.document.model_differs(&self.saved)
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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Drag {
    #[default]
    Nothing,
    /// The camera about its target.
    Orbit,
    /// The camera along the picture's plane.
    Pan,
    Probe,
    /// The line of a wipe.
    Wipe,
    /// The knob by which the picture is turned.
    Roll,
    /// An end of the profile's line; `grab` leads from the pointer to it in pixels.
    LineEnd {
        end: usize,
        grab: DVec2,
    },
    /// A light, by its index; `grab` leads from the pointer to the light in pixels.
    Light {
        index: usize,
        grab: DVec2,
    },
    /// A light towards the viewer and away.
    LightDepth {
        index: usize,
    },
    /// A vertex of the scene's own polygons, by its number; `grab` as before.
    Vertex {
        vertex: u32,
        grab: DVec2,
    },
    /// A vertex towards the viewer and away.
    VertexDepth {
        vertex: u32,
    },
    /// The head of a light's axis, on the viewer's side of the light or beyond; `grab` as before.
    Aim {
        index: usize,
        grab: DVec2,
        front: bool,
    },
    /// The edge of a spot light's cone.
    Rim {
        index: usize,
        grab: DVec2,
    },
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::document::Origin;
    use crate::scene::presets;

    #[test]
    fn opening_a_built_in_scene_opens_its_tab() {
        for preset in presets::ALL.iter().filter(|preset| preset.name != presets::DEFAULT) {
            let mut state = AppState::default();
            let (scene, origin) = (preset.scene(), Origin::BuiltIn(preset.name.to_owned()));
            state.open(Document { scene, model: None, origin });
            let opened = serde_json::to_value(state.look.tab).expect("a word");
            assert_eq!(opened, preset.about().view, "{}", preset.name);
        }
    }

    #[test]
    fn the_look_survives_being_written_and_what_is_open_is_not_written() {
        let mut state = AppState::default();
        state.look.scale = 1.25;
        state.document.scene.material.n = 77.0;
        let text = serde_json::to_string(&state).expect("plain data");
        assert!(!text.contains("77"), "{text}");
        let back: AppState = serde_json::from_str(&text).expect("what was written");
        assert_eq!(back.look, state.look);
    }
}
