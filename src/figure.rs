//! Drawings that explain a picture, laid over it or standing alone, with tiny-skia and without any window.
//!
//! [`Overlay`] lays out the vectors of the illumination equation at a probed point: first as plain geometry in pixels
//! (arrows, arcs, labels), then drawn. Everything here is a pure function of its arguments, so the same scene gives the
//! same pixels everywhere.

mod ink;
mod overlay;
pub mod palette;
mod text;

pub use overlay::{
    Angle, Arc, Area, Arrow, ArrowHead, Halo, Label, LightHandle, Overlay, OverlayLayer, OverlayOptions, draw_overlay,
};
