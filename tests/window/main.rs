//! The window, without a screen where possible.

#[path = "../common/fixtures.rs"]
#[allow(dead_code, reason = "each program takes what it needs")]
#[macro_use]
mod common;

mod claims;
#[cfg(feature = "class")]
mod class;
mod conditions_panel;
mod controls;
mod course;
mod desktop;
mod embed;
mod film;
mod handling;
mod keyboard;
mod layout;
mod light_handles;
mod links;
mod monkey;
mod panels;
mod point;
mod saving;
mod scanline;
mod slices;
mod slider_time;
mod smooth_edges;
mod study_panel;
mod textures;
mod touch;
