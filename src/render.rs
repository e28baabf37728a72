//! The rasterizer: plan → transform → clip → cover → shade → display.

mod bins;
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
mod reference;
mod renderer;
#[cfg(test)]
mod robustness;
mod shade;
mod span;
mod stage;
mod transform;

pub use frame::{Frame, Report, Stage, StageRun};
pub use plan::{Facts, Per, Plan, Term};
pub(crate) use reference::Evaluation;
pub use renderer::Renderer;
