//! What the profile's tab compares, which is kept between two sessions.

use crate::analysis::{Perception, ProfileQuestion, Viewing};
use crate::scene::{Choice, ShadingMode};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// What is compared and how it is looked at.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ProfileLook {
    pub modes: Vec<ShadingMode>,
    pub viewing: Viewing,
    pub perception: Perception,
    /// Whether the picture is shown as it is perceived.
    pub perceived: bool,
}

impl Default for ProfileLook {
    fn default() -> Self {
        let modes = vec![ShadingMode::Gouraud, ShadingMode::Phong];
        Self {
            modes,
            viewing: Viewing::default(),
            perception: Perception::default(),
            perceived: false,
        }
    }
}

impl ProfileLook {
    /// The same with what is out of bounds put back to its default, each mode at most once.
    pub fn sound(self) -> Self {
        let Self {
            modes,
            viewing,
            perception,
            perceived,
        } = self;
        let modes = ShadingMode::VALUES
            .iter()
            .copied()
            .filter(|mode| modes.contains(mode))
            .collect();
        Self {
            modes,
            viewing: viewing.sound(),
            perception: perception.sound(),
            perceived,
        }
    }

    /// The profile between two places.
    pub fn request(&self, [from, to]: [DVec2; 2]) -> ProfileQuestion {
        let Self {
            modes,
            viewing,
            perception,
            perceived: _,
        } = self.clone();
        ProfileQuestion {
            from,
            to,
            modes,
            viewing,
            perception,
        }
    }
}
