//! Drawings over a picture: what they may show, and the sizes, colours and labels that they share.

mod options;
mod sketch;

pub use options::{Halo, OverlayLayer, OverlayOptions};
pub(super) use sketch::{Sketch, Style};
