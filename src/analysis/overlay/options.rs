//! What an overlay shows and how.

use serde::{Deserialize, Serialize};

/// What an overlay may show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum OverlayLayer {
    /// N, L, R, V and, for Blinn's model, H at the probe's point.
    Vectors,
    /// The arcs of θ and φ with their values.
    Angles,
    /// How R comes from L by projection on N.
    Construction,
    /// A sun for each light, parallel rays for each directional one.
    Lights,
    /// What the point reflects of the light to every side, as a surface about it.
    Lobe,
    /// The vectors once more in a corner, seen from the side: V points at the eye, so in the picture itself it is a point.
    SideView,
    /// The intensity along a line. It belongs to no point and is drawn by [`draw_profile`](crate::analysis::draw_profile).
    Profile,
    /// Where the defects of interpolated shading are. They belong to no point and are drawn by
    /// [`draw_defects`](crate::analysis::draw_defects).
    Defects,
    /// A needle at the centre of each polygon that is seen. Like the next it belongs to no point and is drawn by
    /// [`Needles`](crate::analysis::Needles).
    FaceNormals,
    /// A needle at each vertex that is seen.
    VertexNormals,
}

impl OverlayLayer {
    /// Every layer.
    pub const ALL: [Self; 10] = [
        Self::Vectors,
        Self::Angles,
        Self::Construction,
        Self::Lights,
        Self::Lobe,
        Self::SideView,
        Self::Profile,
        Self::Defects,
        Self::FaceNormals,
        Self::VertexNormals,
    ];

    /// Whether it explains the probe's point.
    pub fn of_point(self) -> bool {
        !matches!(self, Self::Lights | Self::Profile | Self::Defects | Self::FaceNormals | Self::VertexNormals)
    }

    /// Whether it is drawn by an [`Overlay`](crate::analysis::Overlay).
    pub fn of_overlay(self) -> bool {
        self.of_point() || self == Self::Lights
    }

    /// Whether it is drawn by [`Needles`](crate::analysis::Needles).
    pub fn of_needles(self) -> bool {
        matches!(self, Self::FaceNormals | Self::VertexNormals)
    }
}

/// What surrounds strokes and letters to set them off from the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Halo {
    /// White.
    Light,
    /// Nearly black.
    Dark,
}

/// How an overlay is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct OverlayOptions {
    pub layers: Vec<OverlayLayer>,
    /// The light whose L is emphasised and whose R, H, θ, φ and construction are shown, by its index in the scene. With
    /// nothing chosen it is the first that the point faces, or else the first.
    pub light: Option<usize>,
    /// Length of a unit vector in world units; nothing makes it about a fifth of the picture's shorter side at the
    /// point's depth.
    pub length: Option<f64>,
    /// Shows H for every model; without it for Blinn's alone.
    pub half_vector: bool,
    pub halo: Halo,
    /// Multiplies lettering and line widths, from 0.05 to 20; 1 suits a picture that fills the screen.
    pub scale: f64,
}

impl Default for OverlayOptions {
    fn default() -> Self {
        Self {
            layers: vec![OverlayLayer::Vectors, OverlayLayer::Angles],
            light: None,
            length: None,
            half_vector: false,
            halo: Halo::Light,
            scale: 1.0,
        }
    }
}
