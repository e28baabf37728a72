//! The renderer: plan, steps, account.

mod account;
mod bands;
mod compose;
mod cue;
mod display;
mod draft;
mod frame;
mod keys;
mod mesh_source;
mod pipeline;
mod plan;
mod points;
mod polygon;
mod queries;
mod ray_nodes;
mod reference;
mod samples;
mod section;
mod shade;

pub use account::Term;
pub use display::srgb;
pub(crate) use display::stored_pixel;
pub use draft::{coarseness, coarser_size};
pub use frame::{Frame, Report, Stage, StageRun};
pub use pipeline::Renderer;
pub use plan::{Cued, Facts, Per, Plan};
pub(crate) use polygon::Polygon;
pub(crate) use reference::{Evaluation, WeightedPoint};
pub use samples::{TooLarge, check_memory};
pub(crate) use section::{Piece, displayed};
