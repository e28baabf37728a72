//! The ways of shading that are compared.

use crate::scene::{FlatAt, Scene, ShadingMode};
use serde::{Deserialize, Serialize};

/// A way of shading: one of the engine's modes, or one of the historic ones, in scalar code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// One intensity a face, at its centre.
    Flat,
    /// One intensity a face, the mean of those at its vertices.
    FlatVertexMean,
    /// Intensities at vertices with the face's own normal.
    Interpolated,
    Gouraud,
    Phong,
    /// Phong shading that forgets to make its normals unit vectors.
    PhongUnnormalised,
    /// Phong shading once more, in the scalar code of the two below.
    PhongScalar,
    /// Bishop and Weimer 1986.
    Taylor,
    /// Kuijk and Blake 1989.
    Angular,
}

/// What a pixel costs inside a span, under one white light at infinity and a viewer there: the operations of the method's
/// text here, without coverage and depth.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct PixelCost {
    pub additions: u32,
    pub multiplications: u32,
    /// Divisions and roots.
    pub divisions: u32,
    /// Powers, which the papers look up in a table.
    pub powers: u32,
}

impl Method {
    pub const ALL: [Self; 9] = [
        Self::Flat,
        Self::FlatVertexMean,
        Self::Interpolated,
        Self::Gouraud,
        Self::Phong,
        Self::PhongUnnormalised,
        Self::PhongScalar,
        Self::Taylor,
        Self::Angular,
    ];

    /// Its name on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::FlatVertexMean => "flat-vertex-mean",
            Self::Interpolated => "interpolated",
            Self::Gouraud => "gouraud",
            Self::Phong => "phong",
            Self::PhongUnnormalised => "phong-unnormalised",
            Self::PhongScalar => "phong-scalar",
            Self::Taylor => "taylor",
            Self::Angular => "angular",
        }
    }

    /// The method of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }

    /// Its name for a reader.
    pub fn title(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::FlatVertexMean => "flat, vertex mean",
            Self::Interpolated => "interpolated",
            Self::Gouraud => "Gouraud",
            Self::Phong => "Phong",
            Self::PhongUnnormalised => "Phong, not unit",
            Self::PhongScalar => "Phong, scalar",
            Self::Taylor => "Taylor, scalar",
            Self::Angular => "angular, scalar",
        }
    }

    /// Whether it is drawn by scalar code in one thread, and not by the engine.
    pub fn is_scalar(self) -> bool {
        matches!(self, Self::PhongScalar | Self::Taylor | Self::Angular)
    }

    /// Whether how values are carried makes a difference.
    pub fn carries(self) -> bool {
        !matches!(self, Self::Flat | Self::FlatVertexMean)
    }

    /// Puts the method into a scene; scalar ones leave it as it is.
    pub(super) fn apply(self, scene: &mut Scene) {
        let shading = &mut scene.shading;
        shading.mode = match self {
            Self::Flat | Self::FlatVertexMean => ShadingMode::Flat,
            Self::Interpolated => ShadingMode::Interpolated,
            Self::Gouraud => ShadingMode::Gouraud,
            Self::Phong | Self::PhongUnnormalised => ShadingMode::Phong,
            Self::PhongScalar | Self::Taylor | Self::Angular => return,
        };
        match self {
            Self::Flat => shading.flat_at = FlatAt::Centre,
            Self::FlatVertexMean => shading.flat_at = FlatAt::VertexMean,
            _ => {}
        }
        shading.renormalise = self != Self::PhongUnnormalised;
    }

    /// What a pixel costs.
    ///
    /// Phong's normal takes 3 additions to carry, 6 multiplications, 2 additions, a root and a division to make unit; N·L and
    /// N·V 3 multiplications and 2 additions each; R·V = 2(N·L)(N·V) − L·V 2 and 1; the sum with kd and ks 2 and 2. Taylor's two
    /// cosines take 2 additions each by forward differences, kd and ks being part of them and of the table; their sum is
    /// the fifth. The normal of angular interpolation takes 3 multiplications and 3 additions and is unit by construction.
    pub fn pixel_cost(self) -> PixelCost {
        let cost =
            |additions, multiplications, divisions, powers| PixelCost { additions, multiplications, divisions, powers };
        match self {
            Self::Flat | Self::FlatVertexMean => cost(0, 0, 0, 0),
            Self::Interpolated | Self::Gouraud => cost(1, 0, 0, 0),
            Self::Phong | Self::PhongScalar => cost(12, 16, 2, 1),
            Self::PhongUnnormalised => cost(10, 10, 0, 1),
            Self::Taylor => cost(5, 0, 0, 1),
            Self::Angular => cost(10, 13, 0, 1),
        }
    }
}
