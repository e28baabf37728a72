pub mod analysis;
pub mod figure;
pub mod geometry;
pub mod illumination;
pub mod render;
pub mod scene;
