//! The scan line in slow motion: one polygon, enlarged to pixels that can be counted, shaded as the course does it.
//!
//! A face of a drawn scene comes in; a [`Scan`] comes out: the edge table, for each scan line its active edges with their
//! crossings P and Q, for each pixel between them its value, and all of that once more as steps to walk through. Values are
//! carried linearly along the edges and then along the scan line (Gouraud 1971):
//!
//! ```text
//!            P₁                        P divides P₁P₂ in the ratio α : 1−α
//!           ╱  ╲                         I(P) = (1−α)·I(P₁) + α·I(P₂)
//!    ───── P━━·━━Q ─────  scan line    and the pixel PQ likewise
//!         ╱       ╲                      I = (1−α)·I(P) + α·I(Q)
//!        P₂────────P₃
//! ```
//!
//! Pixel centres lie at +0.5; one on a left or a top edge belongs to the polygon, one on a right or a bottom edge does not.
//! All of it is in double precision and comes out as the renderer's `scanline` interpolation does.

mod convert;
mod drawing;
mod report;

#[cfg(feature = "app")]
pub(crate) use convert::scan_drawn;
pub use convert::{Grid, scan, scan_in_grid};
pub use drawing::{lay_out_scan, scan_room};
pub use report::{Mix, ScanQuestion, ScanStop, Stop};

use crate::figure::lowered;
use crate::render::Renderer;
use crate::scene::{Rgb, Scene, ShadingMode};
use crate::text::text;
use glam::{DVec2, DVec3};
use serde::Serialize;
use std::ops::RangeInclusive;
use thiserror::Error;

/// The face of `scene` that pixel (`x`, `y`) sees, drawing the scene first if it is not the picture last drawn.
pub fn face_at(renderer: &mut Renderer, scene: &Scene, x: u32, y: u32) -> Option<u32> {
    renderer.render(scene);
    renderer.polygon_at(x, y)
}

/// A polygon's conversion to pixels, step by step.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scan {
    /// Index of the face in the mesh.
    pub face: u32,
    /// The shading; `exact`, which has no polygons, is shown as Phong's.
    pub mode: ShadingMode,
    /// What is interpolated.
    pub carried: Carried,
    /// Whether an interpolated normal is made a unit vector before the equation is evaluated.
    pub renormalise: bool,
    /// The interpolation that each pixel's value is compared with.
    pub compared: Rule,
    /// Where the polygon lies on the grid.
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

/// Linear on the triangle in the picture, or linear on it in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rule {
    /// Linear on the triangle in the picture.
    Affine,
    /// Linear on the triangle in space.
    Perspective,
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

/// How a corner is lettered: P₁, P₂, … in the polygon's order.
pub fn corner_name(index: usize) -> String {
    format!("P{}", lowered(index + 1))
}

/// An edge of the table, from its upper end down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ScanEdge {
    /// Indices of the corners: the upper one, the lower one.
    pub corners: [usize; 2],
    /// y of the upper end, pixels of the grid.
    pub y_top: f64,
    /// y of the lower end, pixels of the grid.
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
    /// Where the scan line enters the polygon.
    pub p: Crossing,
    /// Where it leaves it.
    pub q: Crossing,
    /// From left to right; none where P and Q lie between two centres.
    pub pixels: Vec<ScanPixel>,
}

/// Where the scan line crosses an edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Crossing {
    /// Index into the edge table.
    pub edge: usize,
    /// Where the crossing lies, pixels of the grid.
    pub x: f64,
    /// 0 at the edge's upper end, 1 at its lower one.
    pub alpha: f64,
    /// What is interpolated, there: an intensity or a normal.
    pub value: DVec3,
    /// The intensity as stored in a picture, where it is an intensity that is carried.
    pub stored: Option<[u8; 3]>,
}

/// A pixel of a span.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ScanPixel {
    /// Column of the grid.
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
    Line {
        /// Index into the scan's lines.
        line: usize,
    },
    /// P is found.
    P {
        /// Index into the scan's lines.
        line: usize,
        /// Index into the line's spans.
        span: usize,
    },
    /// Q is found.
    Q {
        /// Index into the scan's lines.
        line: usize,
        /// Index into the line's spans.
        span: usize,
    },
    /// A pixel is shaded.
    Pixel {
        /// Index into the scan's lines.
        line: usize,
        /// Index into the line's spans.
        span: usize,
        /// Index into the span's pixels.
        pixel: usize,
    },
}

/// How large a step is. A larger one is also the beginning of smaller ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ScanLevel {
    /// To the next pixel.
    Pixel,
    /// To the next crossing.
    Edge,
    /// To the next scan line.
    Line,
}

impl ScanStep {
    /// How large it is.
    pub const fn level(self) -> ScanLevel {
        match self {
            Self::Line { .. } => ScanLevel::Line,
            Self::P { .. } | Self::Q { .. } => ScanLevel::Edge,
            Self::Pixel { .. } => ScanLevel::Pixel,
        }
    }
}

/// What stands at a step: the line, and of its span what has been found so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanPoint<'a> {
    /// How large the step is.
    pub level: ScanLevel,
    /// The scan line.
    pub line: &'a ScanLine,
    /// The span; none while the line has just begun.
    pub span: Option<&'a ScanSpan>,
    /// P, once it is found.
    pub p: Option<&'a Crossing>,
    /// Q, once it is found.
    pub q: Option<&'a Crossing>,
    /// The pixel, once it is shaded.
    pub pixel: Option<&'a ScanPixel>,
}

/// Why a polygon cannot be scanned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum ScanError {
    /// The mesh has no such face.
    #[error("{}", no_face(*.face, *.count))]
    NoFace {
        /// The face asked for.
        face: u32,
        /// How many there are.
        count: usize,
    },
    /// The object has no polygons.
    #[error("{}", text!("line-scan-error-empty"))]
    Empty,
    /// A grid has [`Scan::ROWS`] rows.
    #[error("{}", wrong_rows(*.rows))]
    Rows {
        /// The rows asked for.
        rows: u32,
    },
    /// A corner lies behind the eye.
    #[error("{}", of_face("line-scan-error-behind", *.face))]
    BehindTheEye {
        /// The face asked for.
        face: u32,
    },
    /// The polygon is seen from its edge, or covers no pixel's centre.
    #[error("{}", of_face("line-scan-error-edge-on", *.face))]
    EdgeOn {
        /// The face asked for.
        face: u32,
    },
}

fn no_face(face: u32, count: usize) -> String {
    let last = count.saturating_sub(1);
    text!("line-scan-error-no-face", face = face, last = last)
}

fn wrong_rows(rows: u32) -> String {
    let (low, high) = (*Scan::ROWS.start(), *Scan::ROWS.end());
    text!("line-scan-error-rows", rows = rows, low = low, high = high)
}

fn of_face(key: &str, face: u32) -> String {
    text!(key, face = face)
}

impl Scan {
    /// How many rows of pixels a polygon may be enlarged to.
    pub const ROWS: RangeInclusive<u32> = 8..=64;
    /// Rows that leave each pixel large enough to be seen from the back of a room.
    pub const USUAL_ROWS: u32 = 16;

    /// The last step.
    pub fn last(&self) -> usize {
        self.steps.len().saturating_sub(1)
    }

    /// The next step that is as large as `level` or larger; the last one after all of these.
    pub fn forward(&self, from: usize, level: ScanLevel) -> usize {
        let mut after = from.saturating_add(1)..self.steps.len();
        after
            .find(|step| self.steps[*step].level() >= level)
            .unwrap_or(self.last())
    }

    /// The step of that size before `from`; the first one before all of these.
    pub fn back(&self, from: usize, level: ScanLevel) -> usize {
        let before = &self.steps[..from.min(self.last())];
        before
            .iter()
            .rposition(|step| step.level() >= level)
            .unwrap_or(0)
    }

    /// What stands at step `step`, or at the last one.
    ///
    /// # Panics
    /// If there are no steps, which [`scan`] never returns.
    pub fn at(&self, step: usize) -> ScanPoint<'_> {
        let step = self.steps[step.min(self.last())];
        let (line, span, q, pixel) = match step {
            ScanStep::Line { line } => (line, None, false, None),
            ScanStep::P { line, span } => (line, Some(span), false, None),
            ScanStep::Q { line, span } => (line, Some(span), true, None),
            ScanStep::Pixel { line, span, pixel } => (line, Some(span), true, Some(pixel)),
        };
        let line = &self.lines[line];
        let span = span.map(|span| &line.spans[span]);
        ScanPoint {
            level: step.level(),
            line,
            span,
            p: span.map(|span| &span.p),
            q: span.filter(|_| q).map(|span| &span.q),
            pixel: span.zip(pixel).map(|(span, pixel)| &span.pixels[pixel]),
        }
    }

    /// The pixels shaded up to step `step` and with it, each with its row.
    pub fn filled(&self, step: usize) -> impl Iterator<Item = (u32, &ScanPixel)> {
        (0..self.steps.len().min(step.saturating_add(1))).filter_map(|step| {
            let point = self.at(step);
            Some((point.line.y, point.pixel?))
        })
    }

    /// The step that shades the pixel nearest to a place of the grid.
    pub fn step_near(&self, place: DVec2) -> usize {
        self.nearest(ScanLevel::Pixel, place)
    }

    /// The step of this scan that is most like step `step` of `other`, of the same polygon in another view.
    pub fn step_like(&self, other: &Self, step: usize) -> usize {
        self.nearest(
            other.at(step).level,
            other.place_of(step) * self.grid.size() / other.grid.size(),
        )
    }

    /// The step that begins line `y` of the grid, and the one that ends it.
    pub fn steps_of_line(&self, y: u32) -> Option<[usize; 2]> {
        let within = |step: &usize| self.at(*step).line.y == y;
        let mut steps = (0..self.steps.len()).filter(within);
        let first = steps.next()?;
        Some([first, steps.next_back().unwrap_or(first)])
    }

    fn nearest(&self, level: ScanLevel, place: DVec2) -> usize {
        let steps = (0..self.steps.len()).filter(|step| self.steps[*step].level() == level);
        // Another line is farther than any pixel of this one.
        let far = |step: &usize| {
            (self.place_of(*step) - place)
                .abs()
                .dot(DVec2::new(1.0, f64::from(self.grid.columns)))
        };
        steps.min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
    }

    /// Where a step happens, in the grid.
    fn place_of(&self, step: usize) -> DVec2 {
        let point = self.at(step);
        let crossing = point.q.or(point.p).map_or(0.0, |crossing| crossing.x);
        DVec2::new(
            point
                .pixel
                .map_or(crossing, |pixel| f64::from(pixel.x) + 0.5),
            point.line.at(),
        )
    }
}
