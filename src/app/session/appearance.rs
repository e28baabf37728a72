//! How the window looks: what is written to disk between two sessions.

pub mod profile;

use crate::app::session::appearance::profile::ProfileAppearance;
use crate::app::system;
use crate::app::widgets::theme::{PROJECTOR_LINES, SCALES, TEXT, ThemeChoice};
use crate::link::{PAGE, page};
use crate::text::Language;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// How the window looks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Appearance {
    /// Dark, light, or as the system has it.
    pub theme: ThemeChoice,
    /// Size of the interface; 1 is 14-point text.
    pub scale: f32,
    /// Whether the interface is large enough for a room: it grows with the window, see [`Appearance::zoom`].
    pub projector: bool,
    /// Whether the panel of controls is open.
    pub controls: bool,
    /// Whether the panel of views is open.
    pub views: bool,
    /// Whether the bar of stages is open.
    pub stages: bool,
    /// Whether the equation stands over the picture.
    pub equation: bool,
    /// The language of the text; the system's where none is chosen.
    pub language: Option<Language>,
    /// Whether the first start's card has been answered.
    pub welcomed: bool,
    /// Whether coefficients have a number for each channel.
    pub channels: bool,
    /// The view that is open.
    pub view: ViewName,
    /// What is drawn over the picture.
    pub overlay: Overlays,
    /// Whether a picture that rests is drawn with several samples a pixel.
    pub smooth_edges: bool,
    /// How profiles are looked at.
    pub profile: ProfileAppearance,
    /// Files opened or saved, the latest first.
    pub recent: Vec<PathBuf>,
    /// The address of the page that links begin with; may be empty.
    pub page: String,
}

/// How many files are remembered.
const RECENT: usize = 10;

impl Appearance {
    /// The same with what is out of bounds put back to its default.
    pub fn sound(self) -> Self {
        let sizes = SCALES[0]..=SCALES[SCALES.len() - 1];
        let scale = if sizes.contains(&self.scale) {
            self.scale
        } else {
            Self::default().scale
        };
        Self {
            scale,
            profile: self.profile.sound(),
            page: page(&self.page).unwrap_or_else(|_| PAGE.to_owned()),
            ..self
        }
    }

    /// Puts a file first among those that were opened or saved; a page cannot open them again.
    pub fn remember(&mut self, path: &Path) {
        if system::PAGE {
            return;
        }
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        self.recent.retain(|known| *known != path);
        self.recent.insert(0, path);
        self.recent.truncate(RECENT);
    }

    /// Shows the normals of polygons and of vertices, or hides both.
    pub fn switch_normals(&mut self) {
        let on = !self.overlay.normals();
        (self.overlay.face_normals, self.overlay.vertex_normals) = (on, on);
    }

    /// The next larger size of the interface.
    pub fn larger(&mut self) {
        self.scale = SCALES
            .into_iter()
            .find(|scale| *scale > self.scale + 0.01)
            .unwrap_or(self.scale);
    }

    /// The next smaller size.
    pub fn smaller(&mut self) {
        self.scale = SCALES
            .into_iter()
            .rfind(|scale| *scale < self.scale - 0.01)
            .unwrap_or(self.scale);
    }

    /// The ordinary size of the interface.
    pub fn ordinary_size(&mut self) {
        (self.scale, self.projector) = (1.0, false);
    }

    /// The size of text for a room, and back. The panels fold, so that the picture is seen; the course stays, which the room
    /// is there for.
    pub fn projector(&mut self) {
        (self.scale, self.projector) = (1.0, !self.projector);
        self.controls = !self.projector && self.view != ViewName::Course;
        self.views = !self.projector || self.view == ViewName::Course && self.views;
    }

    /// The scale of the interface in a window so many points of the screen high.
    pub fn zoom(&self, height: f32) -> f32 {
        if self.projector {
            self.scale.max(1.0) * (height / (PROJECTOR_LINES * TEXT)).max(1.0)
        } else {
            self.scale
        }
    }
}

impl Default for Appearance {
    fn default() -> Self {
        Self {
            theme: ThemeChoice::System,
            scale: 1.0,
            projector: false,
            controls: true,
            views: true,
            stages: true,
            equation: true,
            language: None,
            welcomed: false,
            channels: false,
            view: ViewName::Equation,
            overlay: Overlays {
                vectors: true,
                angles: true,
                handles: true,
                ..Overlays::default()
            },
            smooth_edges: true,
            profile: ProfileAppearance::default(),
            recent: Vec::new(),
            page: PAGE.to_owned(),
        }
    }
}

/// The view that is open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ViewName {
    /// The equation filled in at the probe's pixel.
    #[default]
    Equation,
    /// Curves of the terms.
    Curves,
    /// Intensity along a line.
    Profile,
    /// Panes and their figures.
    Compare,
    /// The defects of interpolated shading.
    Defects,
    /// A polygon's conversion to pixels.
    ScanLine,
    /// What a frame evaluates, and what it leaves out.
    Plan,
    /// Error against run time.
    Study,
    /// Cases that break a naive renderer.
    Stability,
    /// Lessons.
    Course,
}

impl ViewName {
    /// The view that links and lessons call so.
    pub fn named(name: &str) -> Option<Self> {
        serde_json::from_value(name.into()).ok()
    }
}

/// What is drawn over the picture.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Overlays {
    /// N, L, R or H, and V at the probe's point.
    pub vectors: bool,
    /// The angles between them.
    pub angles: bool,
    /// How R is constructed.
    pub construction: bool,
    /// The plane of N and L, seen from its side.
    pub side_view: bool,
    /// What the point reflects to every side.
    pub lobe: bool,
    /// H, for models too that do not need it.
    pub half_vector: bool,
    /// The handles of lights and of vertices.
    pub handles: bool,
    /// A needle on each polygon.
    pub face_normals: bool,
    /// A needle at each vertex.
    pub vertex_normals: bool,
}

impl Overlays {
    /// Whether any needles are shown.
    pub fn normals(&self) -> bool {
        self.face_normals || self.vertex_normals
    }
}
