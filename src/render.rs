//! The rasterizer. [`Renderer::render`] reads as the pipeline: mesh, plan, place, points, cover, interpolate, rays, shade, display.
//!
//! - `renderer/`: the plan, the steps and their stored outputs, the equation at points and pixels, the display;
//! - `rays/`: shadows, light through the object, one bounce, and the view past the object;
//! - `raster/`: transform, clip, cover, interpolate.
//!
//! Imports run downwards: a folder imports those below it in this list, and lens, model and node.

mod face_materials;
mod lens;
mod model;
mod node;
mod raster;
mod rays;
mod renderer;
mod simd;

pub(crate) use face_materials::{FaceMaterials, any_transmits, for_each_material, transmits};
pub use node::Memory;
pub use rays::Transmission;
pub use renderer::{
    Cued, DrawTime, Frame, FrameReport, Per, Plan, Renderer, Stage, StageRun, Term, TermName,
    TooLarge, check_memory, check_memory_for, check_mesh_memory, coarser_size, srgb,
};
pub(crate) use renderer::{Evaluation, Piece, WeightedPoint, can_be_had, displayed, stored_pixel};
pub use simd::SimdLevel;
