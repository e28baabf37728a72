//! The way from triangles to pixels: transform, clip, cover, interpolate.

mod clip;
mod cover;
mod fragments;
mod grid;
mod interpolate;
mod scan_line;
mod transform;
mod triangles;

pub use cover::{Band, Coverage, DepthScratch, ROWS, Run, meet, meet_band};
pub use fragments::{Block, Fragment, fragment, is_seen, join, put};
pub use grid::{BAND, BandExtent, GridPosition, SUBPIXELS, UNPLACED, doubled_area};
pub use interpolate::{SHORTEST_NORMAL, carry, interpolate};
pub use scan_line::{Crossing, Outline, crossing_pair};
pub use triangles::{PlacedTriangles, Triangles};
