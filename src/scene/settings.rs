//! The picture's size and background, and the choices of reflection, shading and display.

use super::Rgb;
use super::choice::choices;

#[derive(Clone, Debug, PartialEq)]
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

#[derive(Clone, Debug, PartialEq)]
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

choices! {
    /// The specular term.
    pub enum ReflectionModel {
        /// `(R·V)^n` (Phong 1975).
        Phong = "phong", "Phong  (R·V)^n", "R is L reflected about N";
        /// `(N·H)^n` (Blinn 1977).
        Blinn = "blinn", "Blinn  (N·H)^n", "H is half-way between L and V";
        /// `π·D·G/(4·(N·V))` of microfacets (Cook and Torrance 1982).
        CookTorrance = "cook-torrance", "Cook–Torrance  D·G", "Microfacets: D is the fraction that mirrors the light, G the fraction of those that is lit and seen";
    }
}

choices! {
    /// How the slopes of microfacets are spread.
    pub enum Distribution {
        /// Normally distributed slopes (Beckmann and Spizzichino 1963), with the V-cavities of Torrance and Sparrow 1967.
        Beckmann = "beckmann", "Beckmann", "Normally distributed slopes, with V-shaped cavities";
        /// The longer tail of Walter et al. 2007, with their shadowing.
        Ggx = "ggx", "GGX", "A longer tail about the highlight (Walter et al. 2007), with Smith's G";
    }
}

choices! {
    /// What happens where N·L < 0.
    pub enum Backfacing {
        Clamp = "clamp", "clamp to 0", "The light contributes nothing";
        Flip = "flip", "flip N", "The normal is turned towards the light: a two-sided surface";
    }
}

#[derive(Clone, Debug, PartialEq)]
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

choices! {
    /// Where the illumination equation is evaluated.
    pub enum ShadingMode {
        Flat = "flat", "Flat", "The equation once per polygon";
        Interpolated = "interpolated", "Interpolated", "The equation at each polygon's vertices with the polygon's own normal; the intensity is interpolated";
        Gouraud = "gouraud", "Gouraud", "The equation at the vertices with the vertex normals; the intensity is interpolated (Gouraud 1971)";
        Phong = "phong", "Phong", "The equation at every pixel with the interpolated normal (Phong 1975)";
        Exact = "exact", "Exact", "The equation at every pixel of the true surface, with its own normal and outline";
    }
}

choices! {
    /// Where a flat polygon takes its one shade from.
    pub enum FlatAt {
        Centre = "centre", "the centre", "The mean of the vertices, with the polygon's own normal";
        VertexMean = "vertex-mean", "vertices, averaged", "The mean of the intensities at the vertices, with the vertex normals";
        ProvokingVertex = "provoking-vertex", "the first vertex", "The intensity at the first vertex, as OpenGL may do";
    }
}

choices! {
    /// How values between vertices are found.
    pub enum Interpolation {
        Perspective = "perspective", "perspective-correct", "Linear on the polygon in space";
        Affine = "affine", "affine", "Linear on the triangle in the picture";
        Scanline = "scanline", "scan line", "Linear along the edges, then along the scan line, in the picture";
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Display {
    pub overflow: Overflow,
    pub encoding: Encoding,
}

impl Default for Display {
    fn default() -> Self {
        Self { overflow: Overflow::Clamp, encoding: Encoding::Raw }
    }
}

choices! {
    /// What happens where I > 1.
    pub enum Overflow {
        Clamp = "clamp", "clamp", "Shown as 1";
        Scale = "scale", "scale the picture", "The whole picture is divided by its greatest value";
        Mark = "mark", "mark", "Hatched where a channel is above 1";
    }
}

choices! {
    /// From linear intensity to the stored value.
    pub enum Encoding {
        Raw = "raw", "value × 255", "As in the textbooks: value × 255, rounded";
        Srgb = "srgb", "sRGB", "The transfer function of IEC 61966-2-1: light on the screen is proportional to I";
    }
}
