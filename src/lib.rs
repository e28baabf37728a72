pub mod analysis;
pub mod document;
pub mod figure;
pub mod geometry;
pub mod illumination;
pub mod picture;
pub mod render;
pub mod scene;
