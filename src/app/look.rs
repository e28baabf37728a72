//! How the window looks: what is written to disk between two sessions.

use super::profile::look::ProfileLook;
use super::theme::{SCALES, ThemeChoice};
use serde::{Deserialize, Serialize};

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
    pub fn sound(self) -> Self {
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
