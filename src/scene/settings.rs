//! The picture's size and background, and the choices of reflection, shading and display.

use super::Rgb;
use serde::{Deserialize, Serialize};

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Image {
    /// Width and height in pixels, 1 to [`Image::MAX_SIDE`] each.
    pub size: [u32; 2],
    /// Linear colour where no surface is seen.
    pub background: Rgb,
}

impl Image {
    /// The longest side of a picture, in pixels: what the rasterizer's fixed-point coordinates carry.
    pub const MAX_SIDE: u32 = 16_384;
}

impl Default for Image {
    fn default() -> Self {
        Self { size: [768, 768], background: Rgb::ZERO }
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Reflection {
    pub model: ReflectionModel,
    /// How the microfacets' slopes are spread, Cook–Torrance only.
    pub distribution: Distribution,
    pub backfacing: Backfacing,
}

impl Default for Reflection {
    fn default() -> Self {
        Self { model: ReflectionModel::Phong, distribution: Distribution::Beckmann, backfacing: Backfacing::Clamp }
    }
}

/// The specular term.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ReflectionModel {
    /// `(R·V)^n` (Phong 1975).
    Phong,
    /// `(N·H)^n` (Blinn 1977).
    Blinn,
    /// `π·D·G/(4·(N·V))` of microfacets (Cook and Torrance 1982).
    CookTorrance,
}

/// How the slopes of microfacets are spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Distribution {
    /// Normally distributed slopes (Beckmann and Spizzichino 1963), with the V-cavities of Torrance and Sparrow 1967.
    Beckmann,
    /// The longer tail of Walter et al. 2007, with their shadowing.
    Ggx,
}

/// What happens where N·L < 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Backfacing {
    /// The light contributes nothing.
    Clamp,
    /// The normal is turned towards the light: two-sided surfaces.
    Flip,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Shading {
    pub mode: ShadingMode,
    pub flat_at: FlatAt,
    pub interpolation: Interpolation,
    /// Whether interpolated normals are made unit vectors again, Phong shading only.
    pub renormalise: bool,
    /// Whether what stands between a point and a light keeps the light away.
    pub shadows: bool,
}

impl Default for Shading {
    fn default() -> Self {
        Self {
            mode: ShadingMode::Phong,
            flat_at: FlatAt::Centre,
            interpolation: Interpolation::Perspective,
            renormalise: true,
            shadows: false,
        }
    }
}

/// Where the illumination equation is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ShadingMode {
    /// Once a polygon.
    Flat,
    /// At each polygon's vertices with the polygon's own normal, the intensity interpolated.
    Interpolated,
    /// At the vertices with the vertex normals, the intensity interpolated (Gouraud 1971).
    Gouraud,
    /// At every pixel with the interpolated normal (Phong 1975).
    Phong,
    /// At every pixel with the true surface's point and normal.
    Exact,
}

/// Where a flat polygon takes its one shade from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FlatAt {
    /// The mean of its corners, with the polygon's own normal.
    Centre,
    /// The mean of the shades at its vertices, with the vertex normals.
    VertexMean,
    /// The shade at its first vertex, with the vertex normal.
    ProvokingVertex,
}

/// How values between vertices are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Interpolation {
    /// Linear on the polygon in space.
    Perspective,
    /// Linear on the triangle in the picture.
    Affine,
    /// Linear along the polygon's edges, then along the scan line, in the picture.
    Scanline,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Display {
    pub overflow: Overflow,
    pub encoding: Encoding,
}

impl Default for Display {
    fn default() -> Self {
        Self { overflow: Overflow::Clamp, encoding: Encoding::Raw }
    }
}

/// What happens where I > 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Overflow {
    /// It is shown as 1.
    Clamp,
    /// The whole picture is divided by its greatest value.
    Scale,
    /// It is shown as a hatching.
    Mark,
}

/// From linear intensity to the stored value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Encoding {
    /// value × 255, rounded, as the textbooks do.
    Raw,
    /// The transfer function of IEC 61966-2-1.
    Srgb,
}
