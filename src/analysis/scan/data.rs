//! A polygon's conversion to pixels as data.

use super::grid::Grid;
use crate::scene::{Rgb, ShadingMode};
use glam::{DVec2, DVec3};
use serde::Serialize;
use std::ops::RangeInclusive;
use thiserror::Error;

/// A polygon's conversion to pixels, step by step.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scan {
    /// Index of the face in the mesh.
    pub face: u32,
    /// The shading; `exact`, which has no polygons, is shown as Phong's.
    pub mode: ShadingMode,
    pub carried: Carried,
    /// Whether an interpolated normal is made a unit vector before the equation is evaluated.
    pub renormalise: bool,
    /// The interpolation that each pixel's value is compared with.
    pub compared: Rule,
    pub grid: Grid,
    /// In the polygon's order, which is counter-clockwise from outside.
    pub corners: Vec<ScanCorner>,
    /// The edge table: edges that cross scan lines, by their upper ends.
    pub edges: Vec<ScanEdge>,
    /// From the top.
    pub lines: Vec<ScanLine>,
    /// What is done in which order; never empty.
    pub steps: Vec<ScanStep>,
}

impl Scan {
    /// How many rows of pixels a polygon may be enlarged to.
    pub const ROWS: RangeInclusive<u32> = 8..=64;
    /// Rows that leave each pixel large enough to be seen from the back of a room.
    pub const USUAL_ROWS: u32 = 16;
}

/// What is interpolated from the corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Carried {
    /// One intensity for the whole polygon.
    Constant,
    /// The intensity at the corners.
    Intensity,
    /// The normal at the corners; the equation is evaluated at each pixel.
    Normal,
}

/// A corner of the polygon.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ScanCorner {
    /// Where it appears, pixels of the grid.
    pub place: DVec2,
    /// Distance from the eye along the viewing direction, world units.
    pub depth: f64,
    /// The intensity, red, green and blue; or the unit normal, world.
    pub value: DVec3,
}

/// An edge of the table, from its upper end down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ScanEdge {
    /// Indices of the corners: the upper one, the lower one.
    pub corners: [usize; 2],
    pub y_top: f64,
    pub y_bottom: f64,
    /// x at the upper end.
    pub x_top: f64,
    /// What x grows by from one scan line to the next.
    pub dx_dy: f64,
}

/// A scan line through the polygon.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanLine {
    /// Row of the grid.
    pub y: u32,
    /// Indices of the edges that it crosses, from left to right.
    pub active: Vec<usize>,
    /// Crossings in pairs: outside to inside, inside to outside. A concave polygon may have several.
    pub spans: Vec<ScanSpan>,
}

impl ScanLine {
    /// Where its pixels' centres lie.
    pub fn at(&self) -> f64 {
        f64::from(self.y) + 0.5
    }
}

/// What lies between two crossings.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanSpan {
    pub p: Crossing,
    pub q: Crossing,
    /// From left to right; none where P and Q lie between two centres.
    pub pixels: Vec<ScanPixel>,
}

/// Where the scan line crosses an edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Crossing {
    /// Index into the edge table.
    pub edge: usize,
    pub x: f64,
    /// 0 at the edge's upper end, 1 at its lower one.
    pub alpha: f64,
    pub value: DVec3,
    /// The intensity as stored in a picture, where it is an intensity that is carried.
    pub stored: Option<[u8; 3]>,
}

/// A pixel of a span.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ScanPixel {
    pub x: u32,
    /// 0 at P, 1 at Q.
    pub alpha: f64,
    /// The interpolated intensity or normal; the normal before it is made a unit vector.
    pub value: DVec3,
    /// The linear intensity that the pixel gets.
    pub intensity: Rgb,
    /// As stored in a picture.
    pub stored: [u8; 3],
    /// The intensity that barycentric interpolation gives it.
    pub barycentric: Rgb,
}

/// One step of the conversion, by indices into lines, their spans, and the pixels of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "does", rename_all = "kebab-case")]
pub enum ScanStep {
    /// A new scan line, its active edges sorted.
    Line { line: usize },
    /// P is found.
    P { line: usize, span: usize },
    /// Q is found.
    Q { line: usize, span: usize },
    /// A pixel is shaded.
    Pixel { line: usize, span: usize, pixel: usize },
}

/// Why a polygon cannot be scanned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ScanError {
    #[error("no face {face} in the object, expected 0 to {last}", last = .count.saturating_sub(1))]
    NoFace { face: u32, count: usize },
    #[error("the object has no polygons")]
    Empty,
    #[error("{rows} rows, expected {low} to {high}", low = Scan::ROWS.start(), high = Scan::ROWS.end())]
    Rows { rows: u32 },
    #[error(
        "face {face} reaches behind the eye and is cut before it is drawn, expected one that is wholly in front of it"
    )]
    BehindTheEye { face: u32 },
    #[error("face {face} is seen edge-on: no pixel's centre lies inside, expected one that is turned to the viewer")]
    EdgeOn { face: u32 },
}

/// Linear on the triangle in the picture, or linear on it in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rule {
    Affine,
    Perspective,
}
