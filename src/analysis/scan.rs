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

mod barycentric;
mod convert;
mod corners;
mod data;
mod drawing;
mod grid;
mod report;
mod walk;
mod words;

pub use data::{
    Carried, Crossing, Rule, Scan, ScanCorner, ScanEdge, ScanError, ScanLine, ScanPixel, ScanSpan, ScanStep,
};
pub use drawing::{lay_out_scan, scan_room};
pub use grid::Grid;
pub use report::{ScanQuestion, ScanStop, Stop};
pub use walk::{ScanLevel, ScanPoint};
pub use words::{Mix, corner_name};

use crate::render::Renderer;
use crate::scene::Scene;
use corners::Shaded;

/// Scans face `face` of `scene`, drawing the scene first if it is not the picture last drawn, in a grid of `rows` rows.
///
/// Light that rays bring to pixels is left out: the intensity is the equation's own, at corners with their shadows.
pub fn scan(renderer: &mut Renderer, scene: &Scene, face: u32, rows: u32) -> Result<Scan, ScanError> {
    renderer.render(scene);
    scan_drawn(renderer, scene, face, rows)
}

/// The face of `scene` that pixel (`x`, `y`) sees, drawing the scene first if it is not the picture last drawn.
pub fn face_at(renderer: &mut Renderer, scene: &Scene, x: u32, y: u32) -> Option<u32> {
    renderer.render(scene);
    renderer.polygon_at(x, y)
}

/// The same as [`scan`] for the picture last drawn, which is `scene`'s.
pub(crate) fn scan_drawn(renderer: &Renderer, scene: &Scene, face: u32, rows: u32) -> Result<Scan, ScanError> {
    if !Scan::ROWS.contains(&rows) {
        return Err(ScanError::Rows { rows });
    }
    let shaded = Shaded::new(renderer, scene, face)?;
    let grid = Grid::around(&shaded.places(), rows).ok_or(ScanError::EdgeOn { face })?;
    let scan = convert::convert(&shaded, grid);
    let covered = scan.steps.iter().any(|step| matches!(step, ScanStep::Pixel { .. }));
    if covered { Ok(scan) } else { Err(ScanError::EdgeOn { face }) }
}

/// The same in any grid, which need not be about the face.
pub fn scan_in_grid(renderer: &Renderer, scene: &Scene, face: u32, grid: Grid) -> Result<Scan, ScanError> {
    Ok(convert::convert(&Shaded::new(renderer, scene, face)?, grid))
}
