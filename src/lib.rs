pub mod analysis;
pub mod geometry;
pub mod render;
pub mod scene;
