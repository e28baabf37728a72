//! The rasterizer: plan → transform → clip → cover → shade → display.

mod beyond;
mod bins;
mod bounce;
mod bvh;
mod clip;
mod cover;
mod display;
mod exact;
mod frame;
mod interpolate;
mod lens;
mod model;
mod painting;
mod plan;
mod points;
mod rays;
mod reference;
mod renderer;
#[cfg(test)]
mod robustness;
mod section;
mod shade;
mod shadow;
mod sites;
mod solid;
mod span;
mod stage;
mod surroundings;
mod transform;
mod transmission;

pub use display::srgb;
pub use frame::{Frame, Report, Stage, StageRun};
pub use plan::{Facts, Per, Plan, Term};
pub(crate) use reference::Evaluation;
pub use renderer::Renderer;
pub(crate) use section::{Piece, displayed};
pub use transmission::Transmission;
