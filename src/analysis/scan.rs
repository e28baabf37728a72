//! The scan line in slow motion: one polygon, enlarged to countable pixels, shaded as in the course.
//!
//! Input is a face of a drawn scene, output a [`Scan`]: the edge table, for each scan line its active edges with
//! their crossings P and Q, for each pixel between them its value, and all of that once more as steps to walk
//! through. Values are interpolated linearly along the edges and then along the scan line (Gouraud 1971):
//!
//! ```text
//!            P₁                        P divides P₁P₂ in the ratio α : 1−α
//!           ╱  ╲                         I(P) = (1−α)·I(P₁) + α·I(P₂)
//!    ───── P━━·━━Q ─────  scan line    and the pixel PQ likewise
//!         ╱       ╲                      I = (1−α)·I(P) + α·I(Q)
//!        P₂────────P₃
//! ```
//!
//! Pixel centres lie at +0.5; one on a left or a top edge belongs to the polygon, one on a right or a bottom edge
//! does not. All of it is in double precision and agrees with the renderer's `scanline` interpolation.

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

/// Returns the face of `scene` that pixel (`x`, `y`) sees, drawing the scene first if need be.
pub fn face_at(renderer: &mut Renderer, scene: &Scene, x: u32, y: u32) -> Option<u32> {
    renderer.render(scene);
    renderer.polygon_at(x, y)
}

/// A polygon's conversion to pixels, step by step.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scan {
    /// Index of the face in the mesh.
    pub face: u32,
    /// The shading mode; `exact`, which has no polygons, is shown as Phong's.
    pub mode: ShadingMode,
    /// The interpolated quantity.
    pub carried: Carried,
    /// True if an interpolated normal is normalised before the equation is evaluated.
    pub renormalise: bool,
    /// The interpolation with which each pixel's value is compared.
    pub compared: Rule,
    /// The grid of enlarged pixels.
    pub grid: Grid,
    /// Corners in the polygon's order, which is counter-clockwise from outside.
    pub corners: Vec<ScanCorner>,
    /// The edge table: edges that cross scan lines, by their upper ends.
    pub edges: Vec<ScanEdge>,
    /// Scan lines from the top.
    pub lines: Vec<ScanLine>,
    /// Steps in their order; never empty.
    pub steps: Vec<ScanStep>,
}

/// The quantity that is interpolated from the corners.
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

/// The rule of interpolation: linear on the triangle in the picture, or in space.
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
    /// Position, pixels of the grid.
    pub place: DVec2,
    /// Distance from the eye along the viewing direction, world units.
    pub depth: f64,
    /// The intensity, red, green and blue; or the unit normal, world.
    pub value: DVec3,
}

/// Returns the letter of a corner: P₁, P₂, … in the polygon's order.
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
    /// x of the upper end.
    pub x_top: f64,
    /// Increment of x from one scan line to the next.
    pub dx_dy: f64,
}

/// A scan line through the polygon.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanLine {
    /// Row of the grid.
    pub y: u32,
    /// Indices of the edges that it crosses, from left to right.
    pub active: Vec<usize>,
    /// Pairs of crossings: outside to inside, inside to outside. A concave polygon may have several.
    pub spans: Vec<ScanSpan>,
}

impl ScanLine {
    /// Returns y of its pixels' centres.
    pub fn centre_y(&self) -> f64 {
        f64::from(self.y) + 0.5
    }
}

/// The part of a scan line between two crossings.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanSpan {
    /// Crossing at which the scan line enters the polygon.
    pub p: Crossing,
    /// Crossing at which it leaves the polygon.
    pub q: Crossing,
    /// Pixels from left to right; none where P and Q lie between two centres.
    pub pixels: Vec<ScanPixel>,
}

/// A crossing of the scan line and an edge.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Crossing {
    /// Index into the edge table.
    pub edge: usize,
    /// x of the crossing, pixels of the grid.
    pub x: f64,
    /// Parameter along the edge, 0 at its upper end, 1 at its lower one.
    pub alpha: f64,
    /// The interpolated value there: an intensity or a normal.
    pub value: DVec3,
    /// The intensity as stored in a picture, if intensities are interpolated.
    pub stored: Option<[u8; 3]>,
}

/// A pixel of a span.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ScanPixel {
    /// Column of the grid.
    pub x: u32,
    /// Parameter along the span, 0 at P, 1 at Q.
    pub alpha: f64,
    /// The interpolated intensity or normal; the normal before normalisation.
    pub value: DVec3,
    /// The pixel's linear intensity.
    pub intensity: Rgb,
    /// The intensity as stored in a picture.
    pub stored: [u8; 3],
    /// The pixel's intensity by barycentric interpolation.
    pub barycentric: Rgb,
}

/// One step of the conversion, by indices into lines, their spans, and the pixels of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "does", rename_all = "kebab-case")]
#[expect(
    missing_docs,
    reason = "indices into the scan's lines, a line's spans and a span's pixels"
)]
pub enum ScanStep {
    /// A new scan line, its active edges sorted.
    Line { line: usize },
    /// P is found.
    P { line: usize, span: usize },
    /// Q is found.
    Q { line: usize, span: usize },
    /// A pixel is shaded.
    Pixel {
        line: usize,
        span: usize,
        pixel: usize,
    },
}

/// The size of a step. A larger one also begins smaller ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ScanLevel {
    /// A step to the next pixel.
    Pixel,
    /// A step to the next crossing.
    Edge,
    /// A step to the next scan line.
    Line,
}

impl ScanStep {
    /// Returns the size of the step.
    pub const fn level(self) -> ScanLevel {
        match self {
            Self::Line { .. } => ScanLevel::Line,
            Self::P { .. } | Self::Q { .. } => ScanLevel::Edge,
            Self::Pixel { .. } => ScanLevel::Pixel,
        }
    }
}

/// The state at a step: the line, and the part of its span found so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanPoint<'a> {
    /// Size of the step.
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

/// The reason why a polygon cannot be scanned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
#[expect(
    missing_docs,
    reason = "the fields are the requested face and rows, and the number of faces"
)]
pub enum ScanError {
    /// The mesh has no such face.
    #[error("{}", text!("line-scan-error-no-face", face = .face, last = .count.saturating_sub(1)))]
    NoFace { face: u32, count: usize },
    /// The object has no polygons.
    #[error("{}", text!("line-scan-error-empty"))]
    Empty,
    /// The number of rows is not one of [`Scan::ROWS`].
    #[error("{}", text!("line-scan-error-rows", rows = .rows, low = *Scan::ROWS.start(), high = *Scan::ROWS.end()))]
    Rows { rows: u32 },
    /// A corner lies behind the eye.
    #[error("{}", text!("line-scan-error-behind", face = .face))]
    BehindTheEye { face: u32 },
    /// The polygon is seen edge-on, or covers no pixel's centre.
    #[error("{}", text!("line-scan-error-edge-on", face = .face))]
    EdgeOn { face: u32 },
}

impl Scan {
    /// The number of pixel rows to which a polygon may be enlarged.
    pub const ROWS: RangeInclusive<u32> = 8..=64;
    /// Number of rows that leaves each pixel large enough to be seen from the back of a room.
    pub const USUAL_ROWS: u32 = 16;

    /// Returns the last step.
    pub fn last(&self) -> usize {
        self.steps.len().saturating_sub(1)
    }

    /// Returns the next step that is as large as `level` or larger; the last one after all of these.
    pub fn forward(&self, from: usize, level: ScanLevel) -> usize {
        let mut after = from.saturating_add(1)..self.steps.len();
        after
            .find(|step| self.steps[*step].level() >= level)
            .unwrap_or(self.last())
    }

    /// Returns the step of that size before `from`; the first one before all of these.
    pub fn back(&self, from: usize, level: ScanLevel) -> usize {
        self.steps[..from.min(self.last())]
            .iter()
            .rposition(|step| step.level() >= level)
            .unwrap_or(0)
    }

    /// Returns the state at step `step`, or at the last one; [`scan`] never returns none at all.
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

    /// Returns the pixels shaded up to and including step `step`, each with its row.
    pub fn filled(&self, step: usize) -> impl Iterator<Item = (u32, &ScanPixel)> {
        (0..self.steps.len().min(step.saturating_add(1))).filter_map(|step| {
            let point = self.at(step);
            Some((point.line.y, point.pixel?))
        })
    }

    /// Returns the step that shades the pixel nearest to a place of the grid.
    pub fn step_near(&self, place: DVec2) -> usize {
        self.nearest(ScanLevel::Pixel, place)
    }

    /// Returns the step of this scan that is most like step `step` of `other`, of the same polygon in another view.
    pub fn step_like(&self, other: &Self, step: usize) -> usize {
        let place = other.place_of(step) * self.grid.size() / other.grid.size();
        self.nearest(other.at(step).level, place)
    }

    /// Returns the step that begins line `y` of the grid, and the one that ends it.
    pub fn steps_of_line(&self, y: u32) -> Option<[usize; 2]> {
        let mut steps = (0..self.steps.len()).filter(|step| self.at(*step).line.y == y);
        let first = steps.next()?;
        Some([first, steps.next_back().unwrap_or(first)])
    }

    /// Returns the step of that size nearest to a place of the grid.
    fn nearest(&self, level: ScanLevel, place: DVec2) -> usize {
        let steps = (0..self.steps.len()).filter(|step| self.steps[*step].level() == level);
        // Another line is farther than any pixel of this one.
        let weights = DVec2::new(1.0, f64::from(self.grid.columns));
        let far = |step: &usize| (self.place_of(*step) - place).abs().dot(weights);
        steps.min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
    }

    /// Returns the place of the grid that a step has reached.
    fn place_of(&self, step: usize) -> DVec2 {
        let point = self.at(step);
        let crossing = point.q.or(point.p).map_or(0.0, |crossing| crossing.x);
        let pixel = point.pixel.map(|pixel| f64::from(pixel.x) + 0.5);
        DVec2::new(pixel.unwrap_or(crossing), point.line.centre_y())
    }
}
