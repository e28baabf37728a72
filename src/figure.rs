//! Drawings as plain geometry, and the pixels, SVG text and window painting made of them, without any window.
//!
//! [`lay_out`] turns a [`Plot`] into a [`Drawing`]: lines, areas and text with their places. What a drawing shows is decided
//! by the analyses; this module knows none of them. Everything here is a pure function of its arguments.

mod clip;
mod drawing;
pub(crate) mod labels;
pub mod palette;
mod pixels;
mod plot;
mod scale;
mod svg;
mod text;

#[cfg(feature = "app")]
pub(crate) use clip::{can_be_filled, clipped};
pub use drawing::{Drawing, Shape, Text};
pub use labels::{Area, Label};
pub use plot::{
    Axis, Curve, Dash, Direction, Ink, Mark, Paper, Plot, PlotKind, PlotStyle, Point, Tag, lay_out, lay_out_sheet,
    short,
};
pub use text::Set;
pub(crate) use text::inked_size;
