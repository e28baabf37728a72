//! The settings of the profile's view. Those for viewing are stored between two sessions; those for comparing are reset
//! with each scene.

use crate::analysis::perception::{Perception, Viewing};
use crate::analysis::profile::ProfileQuestion;
use crate::scene::{Choice, ShadingMode};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The compared modes, and how the profile is viewed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ProfileAppearance {
    /// Modes compared with the picture's own.
    #[serde(skip)]
    pub added: Vec<ShadingMode>,
    /// The picture's own mode when the profile was last shown.
    #[serde(skip)]
    pub own: Option<ShadingMode>,
    /// True if the picture is shown as it is perceived.
    #[serde(skip)]
    pub perceived: bool,
    /// True if the plots mark where polygons meet.
    pub edges: bool,
    /// True if the perceived brightness is plotted beside the intensity.
    pub brightness: bool,
    /// The viewing conditions, which determine how large a pixel is for the eye.
    pub viewing: Viewing,
    /// The model of the eye.
    pub perception: Perception,
}

impl Default for ProfileAppearance {
    fn default() -> Self {
        Self {
            added: Vec::new(),
            own: None,
            perceived: false,
            edges: true,
            brightness: true,
            viewing: Viewing::default(),
            perception: Perception::default(),
        }
    }
}

impl ProfileAppearance {
    /// Resets values that are out of bounds to their defaults.
    pub fn sound(self) -> Self {
        Self {
            viewing: self.viewing.sound(),
            perception: self.perception.sound(),
            ..self
        }
    }

    /// Clears the comparison, as when a scene is opened.
    pub fn begin(&mut self) {
        self.added.clear();
        self.own = None;
        self.perceived = false;
    }

    /// Takes note of the picture's own mode. While others are compared with it, the one before stays among them.
    pub fn follow(&mut self, own: ShadingMode) {
        let before = self.own.replace(own).filter(|before| *before != own);
        if let Some(before) = before
            && !self.added.is_empty()
            && !self.added.contains(&before)
        {
            self.added.push(before);
        }
    }

    /// Returns the question for a profile between two points, in the picture's mode and the added ones.
    pub fn request(&self, [from, to]: [DVec2; 2], own: ShadingMode) -> ProfileQuestion {
        let shown = |mode: &ShadingMode| *mode == own || self.added.contains(mode);
        ProfileQuestion {
            from,
            to,
            modes: ShadingMode::VALUES.iter().copied().filter(shown).collect(),
            viewing: self.viewing,
            perception: self.perception,
        }
    }
}
