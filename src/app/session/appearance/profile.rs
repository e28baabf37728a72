//! What the profile's view shows. How it is looked at is kept between two sessions; what is compared begins anew with each
//! scene.

use crate::analysis::{Perception, ProfileQuestion, Viewing};
use crate::scene::{Choice, ShadingMode};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// What is compared and how it is looked at.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ProfileAppearance {
    /// Modes that are compared with the picture's own.
    #[serde(skip)]
    pub added: Vec<ShadingMode>,
    /// Whether the picture is shown as it is perceived.
    #[serde(skip)]
    pub perceived: bool,
    /// Whether the plots mark where polygons meet.
    pub edges: bool,
    /// Whether the perceived brightness is plotted beside the intensity.
    pub brightness: bool,
    /// How large a pixel is for the eye.
    pub viewing: Viewing,
    /// The model of the eye.
    pub perception: Perception,
}

impl Default for ProfileAppearance {
    fn default() -> Self {
        Self {
            added: Vec::new(),
            perceived: false,
            edges: true,
            brightness: true,
            viewing: Viewing::default(),
            perception: Perception::default(),
        }
    }
}

impl ProfileAppearance {
    /// The same with what is out of bounds put back to its default.
    pub fn sound(self) -> Self {
        Self {
            viewing: self.viewing.sound(),
            perception: self.perception.sound(),
            ..self
        }
    }

    /// Compares nothing, as when a scene is opened.
    pub fn begin(&mut self) {
        self.added.clear();
        self.perceived = false;
    }

    /// The profile between two places, of the picture's mode and those beside it.
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
