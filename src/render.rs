//! The rasterizer: plan → transform → clip → cover → shade → display.

mod frame;
mod renderer;

pub use frame::{Frame, Report, Stage, StageRun};
pub use renderer::Renderer;
