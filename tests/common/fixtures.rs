//! What several tests share.

pub mod any_scene;
pub mod dice;
pub mod fuzz;
#[cfg(feature = "app")]
pub mod hands;
pub mod lessons;
#[cfg(feature = "app")]
pub mod monkey;
#[cfg(feature = "cli")]
pub mod program;
pub mod properties;
pub mod reasons;
pub mod simd;
pub mod textbook;
