//! The renderer: its plan, its steps and their account.

mod account;
mod bands;
mod cue;
mod display;
mod estimate;
mod frame;
mod parts;
mod pipeline;
mod plan;
mod points;
mod queries;
mod ray_nodes;
mod reference;
mod samples;
mod section;
mod shade;
mod target;

pub use account::{Term, TermName};
pub use display::srgb;
pub(crate) use display::stored_pixel;
pub(crate) use estimate::can_be_had;
pub use estimate::{TooLarge, check_memory, check_memory_for, check_mesh_memory};
pub use frame::{DrawTime, Frame, FrameReport, Stage, StageRun, coarser_size};
pub use pipeline::Renderer;
pub use plan::{Cued, Per, Plan};
pub(crate) use reference::{Evaluation, WeightedPoint};
pub(crate) use section::{Piece, displayed};
