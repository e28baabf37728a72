//! Triangles to pixels: transform, clip, cover, interpolate.

mod bins;
mod clip;
mod cover;
mod coverage;
mod edge_table;
mod fragments;
mod grid;
mod interpolate;
mod scan_line;
mod span;
mod transform;
mod triangles;
mod true_surface;

pub use bins::Bins;
pub use cover::{Band, DepthScratch};
pub use coverage::{Coverage, ROWS};
pub use fragments::{Block, Fragment, fragment, is_seen, join};
pub use grid::{BAND, BandPlace, Place, SUBPIXELS, UNPLACED, doubled_area};
pub use interpolate::{CarriedValues, Rule, SHORTEST_NORMAL, interpolate};
pub use scan_line::{Crossing, Outline, crossing_pair};
pub use triangles::{PlacedTriangles, Triangles};
pub use true_surface::{meet, meet_band};
