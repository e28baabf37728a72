//! Drawings that explain a picture, laid over it or standing alone, with tiny-skia and without any window.
//!
//! [`Overlay`] lays out the vectors of the illumination equation at a probed point: first as plain geometry in pixels
//! (arrows, arcs, labels), then drawn. [`lay_out`] does the same for the plots of [`crate::analysis::curves`], which are drawn
//! as pictures, as SVG text and in the window. Everything here is a pure function of its arguments, so the same scene gives the
//! same pixels everywhere.

mod ink;
mod overlay;
pub mod palette;
mod plot;
mod text;

pub use overlay::{
    Angle, Arc, Area, Arrow, ArrowHead, Halo, Label, LightHandle, Overlay, OverlayLayer, OverlayOptions, draw_overlay,
    draw_profile,
};
pub use plot::{Drawing, Paper, PlotStyle, Shape, Text, lay_out, lay_out_sheet};
pub use text::Set;
