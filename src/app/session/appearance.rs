//! The appearance of the window, stored on disk between two sessions.

pub mod profile;

use crate::app::session::appearance::profile::ProfileAppearance;
use crate::app::system;
use crate::app::widgets::theme::{PROJECTOR_LINES, SCALES, TEXT, ThemeChoice};
use crate::link::{PAGE, page};
use crate::text::Language;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// The appearance of the window.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Appearance {
    /// Dark, light, or following the system.
    pub theme: ThemeChoice,
    /// Scale of the interface; 1 is 14-point text.
    pub scale: f32,
    /// True if the interface is large enough for a room: it grows with the window, see [`Appearance::zoom`].
    pub projector: bool,
    /// True if the panel of controls is open.
    pub controls: bool,
    /// True if the panel of views is open.
    pub views: bool,
    /// True if the bar of stages is open.
    pub stages: bool,
    /// True if the equation is shown over the picture.
    pub equation: bool,
    /// The language of the text; that of the system if `None`.
    pub language: Option<Language>,
    /// True if the welcome card of the first start has been answered.
    pub welcomed: bool,
    /// True if coefficients have a number for each channel.
    pub channels: bool,
    /// The open view.
    pub view: ViewName,
    /// The overlays drawn over the picture.
    pub overlay: Overlays,
    /// True if the picture is drawn with several samples per pixel when nothing changes.
    pub smooth_edges: bool,
    /// The settings of the profile's view.
    pub profile: ProfileAppearance,
    /// Files opened or saved, the latest first.
    pub recent: Vec<PathBuf>,
    /// The address of the page that links begin with; may be empty.
    pub page: String,
}

/// Maximum number of files in the list of recent ones.
const RECENT: usize = 10;

impl Appearance {
    /// Resets values that are out of bounds to their defaults.
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

    /// Returns the appearance of the first start, in the same language and theme, with the same files and page.
    pub fn reset(&self) -> Self {
        Self {
            theme: self.theme,
            language: self.language,
            welcomed: self.welcomed,
            recent: self.recent.clone(),
            page: self.page.clone(),
            ..Self::default()
        }
    }

    /// Moves a file to the front of the recent ones. Does nothing on a page, which cannot open files again.
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

    /// Increases the scale of the interface to the next step.
    pub fn larger(&mut self) {
        self.scale = SCALES
            .into_iter()
            .find(|scale| *scale > self.scale + 0.01)
            .unwrap_or(self.scale);
    }

    /// Decreases the scale of the interface to the next step.
    pub fn smaller(&mut self) {
        self.scale = SCALES
            .into_iter()
            .rfind(|scale| *scale < self.scale - 0.01)
            .unwrap_or(self.scale);
    }

    /// Resets the interface to its ordinary size.
    pub fn ordinary_size(&mut self) {
        (self.scale, self.projector) = (1.0, false);
    }

    /// Toggles the size of text for a room. The panels fold, so that the picture is visible; the course stays, since
    /// the room is there for it.
    pub fn projector(&mut self) {
        (self.scale, self.projector) = (1.0, !self.projector);
        let of_course = matches!(self.view, ViewName::Course | ViewName::Class);
        self.controls = !self.projector && !of_course;
        self.views = !self.projector || of_course && self.views;
    }

    /// Returns the scale of the interface in a window of this height, in points before scaling.
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

/// A view of the window.
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
    /// The terms that a frame evaluates, and those that it skips.
    Plan,
    /// Error against run time.
    Study,
    /// Cases that break a naive renderer.
    Stability,
    /// Lessons.
    Course,
    /// The live class.
    Class,
}

impl ViewName {
    /// Returns the view that has this name in links and lessons.
    pub fn named(name: &str) -> Option<Self> {
        serde_json::from_value(name.into()).ok()
    }
}

/// The overlays drawn over the picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Overlays {
    /// N, L, R or H, and V at the probe's point.
    pub vectors: bool,
    /// The angles between the vectors.
    pub angles: bool,
    /// The construction of R.
    pub construction: bool,
    /// The plane of N and L, seen from its side.
    pub side_view: bool,
    /// True if that side view appears by itself where vectors point at the viewer.
    pub side_view_where_needed: bool,
    /// True if the side view is enlarged.
    #[serde(skip)]
    pub side_view_enlarged: bool,
    /// The light that the point reflects in every direction.
    pub lobe: bool,
    /// H, even for models that do not need it.
    pub half_vector: bool,
    /// The handles of lights and of vertices.
    pub handles: bool,
    /// A needle on each polygon.
    pub face_normals: bool,
    /// A needle at each vertex.
    pub vertex_normals: bool,
    /// The faces of the vertex nearest to the probe, highlighted.
    pub vertex: bool,
}

impl Default for Overlays {
    fn default() -> Self {
        Self {
            vectors: false,
            angles: false,
            construction: false,
            side_view: false,
            side_view_where_needed: true,
            side_view_enlarged: false,
            lobe: false,
            half_vector: false,
            handles: false,
            face_normals: false,
            vertex_normals: false,
            vertex: false,
        }
    }
}

impl Overlays {
    /// Returns whether normals of polygons or of vertices are shown.
    pub fn normals(&self) -> bool {
        self.face_normals || self.vertex_normals || self.vertex
    }
}
