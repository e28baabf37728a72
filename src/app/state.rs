//! Everything that the window remembers: what is open, what is shown of it, and what was asked for.

use super::action::Action;
use super::code;
use super::compare;
use super::defects::Measured;
use super::dialog::Dialog;
use super::document::Document;
use super::gallery::Gallery;
use super::handles::line::ProfileLine;
use super::history::History;
use super::panes::Panes;
use super::profile::{ProfileLook, Profiles};
use super::sampling::Sampling;
use super::scan::ScanView;
use super::stability::StabilityView;
use super::study::StudyView;
use super::symbol::Lit;
use super::theme::{SCALES, ThemeChoice};
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
    #[serde(skip)]
    pub history: History,
    /// Which pane is worked on.
    #[serde(skip)]
    pub panes: Panes,
    /// The defects as last measured.
    #[serde(skip)]
    pub measured: Measured,
    /// What is typed in the tab of comparisons.
    #[serde(skip)]
    pub compared: compare::Typed,
    /// The document as last opened or saved.
    #[serde(skip)]
    pub saved: Document,
    #[serde(skip)]
    pub probe: ProbePoint,
    /// Where the profile is taken.
    #[serde(skip)]
    pub line: ProfileLine,
    #[serde(skip)]
    pub profiles: Profiles,
    /// Index of the light whose controls are shown.
    #[serde(skip)]
    pub light: usize,
    /// The vertex whose faces are lit up, while normals are shown.
    #[serde(skip)]
    pub pointed: PointedVertex,
    /// Number of the vertex whose place is shown, of a scene's own polygons.
    #[serde(skip)]
    pub vertex: usize,
    /// The polygon that is scanned in slow motion, and how far.
    #[serde(skip)]
    pub scan: ScanView,
    /// Error against run time.
    #[serde(skip)]
    pub study: StudyView,
    /// Stiff and extreme cases.
    #[serde(skip)]
    pub stability: StabilityView,
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
    /// The scene as code, while its dialog is open.
    #[serde(skip)]
    pub code: code::Writer,
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
        self.light = 0;
        self.panes.active = 0;
        self.vertex = 0;
    }

    /// Whether the document has changed since it was opened or saved.
    pub fn modified(&self) -> bool {
        let Document { scene, origin, .. } = &self.saved;
        *self.shared_scene() != *scene || self.document.origin != *origin || self.document.model_differs(&self.saved)
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

/// How the window looks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Look {
    pub theme: ThemeChoice,
    /// Size of the interface; 1 is 14-point text.
    pub scale: f32,
    /// Whether the panel of controls is open.
    pub controls: bool,
    /// Whether the panel of numbers is open.
    pub numbers: bool,
    /// Whether the bar of stages is open.
    pub stages: bool,
    /// Whether coefficients have a number for each channel.
    pub channels: bool,
    /// What the panel of numbers shows.
    pub tab: NumbersTab,
    pub overlay: OverlayLook,
    pub profile: ProfileLook,
}

impl Look {
    /// The same with what is out of bounds put back to its default.
    fn sound(self) -> Self {
        let sizes = SCALES[0]..=SCALES[SCALES.len() - 1];
        let scale = if sizes.contains(&self.scale) { self.scale } else { Self::default().scale };
        Self { scale, profile: self.profile.sound(), ..self }
    }
}

impl Default for Look {
    fn default() -> Self {
        Self {
            theme: ThemeChoice::System,
            scale: 1.0,
            controls: true,
            numbers: true,
            stages: true,
            channels: false,
            tab: NumbersTab::Equation,
            overlay: OverlayLook::default(),
            profile: ProfileLook::default(),
        }
    }
}

/// What the panel of numbers shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NumbersTab {
    /// The equation filled in, the vectors and the angles.
    #[default]
    Equation,
    /// The plots.
    Curves,
    /// The intensity along a line.
    Profile,
    /// Panes, and how far they are from each other.
    Compare,
    /// The five defects of interpolated shading.
    Defects,
    /// The scan line in slow motion.
    ScanLine,
    /// The plan of the frame.
    Plan,
    /// Error against run time.
    Study,
    /// Stiff and extreme cases.
    Stability,
}

/// What is drawn over the picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct OverlayLook {
    pub vectors: bool,
    pub angles: bool,
    pub construction: bool,
    pub side_view: bool,
    /// What the point reflects to every side.
    pub lobe: bool,
    pub half_vector: bool,
    /// The handles of lights and of vertices.
    pub handles: bool,
    /// A needle on each polygon.
    pub face_normals: bool,
    /// A needle at each vertex.
    pub vertex_normals: bool,
}

impl OverlayLook {
    /// Whether any needles are shown.
    pub fn normals(&self) -> bool {
        self.face_normals || self.vertex_normals
    }
}

impl Default for OverlayLook {
    fn default() -> Self {
        Self {
            vectors: true,
            angles: true,
            construction: false,
            side_view: false,
            lobe: false,
            half_vector: false,
            handles: true,
            face_normals: false,
            vertex_normals: false,
        }
    }
}

/// Where the probe stands: from the picture's middle, in units of the picture's height, so that it keeps to the same
/// place of the scene when the window changes its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbePoint(pub DVec2);

impl Default for ProbePoint {
    fn default() -> Self {
        Self(DVec2::new(0.11, -0.13))
    }
}

impl ProbePoint {
    /// The pixel it stands on in a picture of `size` pixels, kept inside.
    pub fn pixel(self, size: [u32; 2]) -> [u32; 2] {
        let [width, height] = size.map(f64::from);
        let inside = |value: f64, side: u32| value.floor().clamp(0.0, f64::from(side.saturating_sub(1))) as u32;
        [inside(self.0.x * height + width * 0.5, size[0]), inside(self.0.y * height + height * 0.5, size[1])]
    }

    /// The probe at the centre of pixel `x`, `y` of a picture of `size` pixels.
    pub fn at(pixel: [u32; 2], size: [u32; 2]) -> Self {
        let [width, height] = size.map(|side| f64::from(side.max(1)));
        let [x, y] = pixel.map(|value| f64::from(value) + 0.5);
        Self(DVec2::new((x - width * 0.5) / height, (y - height * 0.5) / height))
    }

    /// The probe moved by whole pixels, not past the picture's edge.
    pub fn moved(self, by: [i32; 2], size: [u32; 2]) -> Self {
        let [x, y] = self.pixel(size);
        let step = |value: u32, by: i32, side: u32| value.saturating_add_signed(by).min(side.saturating_sub(1));
        Self::at([step(x, by[0], size[0]), step(y, by[1], size[1])], size)
    }
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
    fn the_probe_returns_to_its_pixel() {
        for size in [[1, 1], [640, 480], [33, 1001]] {
            for pixel in [[0, 0], [size[0] - 1, size[1] - 1], [size[0] / 2, size[1] / 3]] {
                assert_eq!(ProbePoint::at(pixel, size).pixel(size), pixel);
            }
        }
    }

    #[test]
    fn the_probe_stays_in_the_picture() {
        let size = [10, 10];
        assert_eq!(ProbePoint::at([0, 9], size).moved([-1, 1], size).pixel(size), [0, 9]);
        assert_eq!(ProbePoint::at([0, 9], size).moved([3, -2], size).pixel(size), [3, 7]);
        assert_eq!(ProbePoint::default().pixel([0, 0]), [0, 0]);
    }

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
