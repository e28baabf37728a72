//! Drawings as plain geometry, and the pixels, SVG text and window painting made of them, without any window.
//!
//! [`lay_out`] turns a [`Plot`] into a [`Drawing`]: lines, areas and text with their places. What a drawing shows is decided
//! by the analyses; this module knows none of them. Everything here is a pure function of its arguments.

mod clip;
pub(crate) mod ink;
pub(crate) mod labels;
pub mod palette;
pub(crate) mod plot;
pub(crate) mod text;

#[cfg(feature = "app")]
pub(crate) use clip::{can_be_filled, clipped};
pub use labels::{Area, Label};
pub use plot::{
    Axis, Curve, Dash, Direction, Drawing, Ink, Mark, Paper, Plot, PlotKind, PlotStyle, Point, Shape, Tag, Text,
    lay_out, lay_out_sheet, short,
};
pub use text::Set;
