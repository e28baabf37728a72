//! Drawings as plain geometry, and their output as pixels, SVG text and window painting, without any window.
//!
//! [`lay_out`] turns a [`Plot`] into a [`Drawing`]: lines, areas and text with their positions. The analyses decide
//! what a drawing shows; this module knows none of them. Everything here is a pure function of its arguments.

mod area;
mod drawing;
mod formula;
mod labels;
pub mod palette;
mod pixels;
mod plot;
mod qr;
mod svg;
mod text;
mod typed;

pub use area::{Area, Run, can_be_filled, clipped};
pub use drawing::{Drawing, Shape, Text};
pub use formula::{Base, Formula, Item, is_italic};
pub use labels::{Label, Placer, Wish};
pub use plot::{
    Axis, Curve, Dash, Direction, Ink, Mark, Paper, Plot, PlotKind, PlotStyle, Point, Tag, dashes,
    lay_out, lay_out_bare, lay_out_column, lay_out_sheet, magnitude, round_up, scientific, short,
    ticks,
};
pub use qr::QrCode;
pub(crate) use text::inked_size;
pub use text::{Set, lowered, raised, with_raised_n};
pub use typed::typed;
