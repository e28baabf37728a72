//! Drawings that explain a picture, laid over it or standing alone, with tiny-skia and without any window.
//!
//! [`Overlay`] lays out the vectors of the illumination equation at a probed point: first as plain geometry in pixels
//! (arrows, arcs, labels), then drawn. [`lay_out`] does the same for the plots of [`crate::analysis::curves`], which are drawn
//! as pictures, as SVG text and in the window. Everything here is a pure function of its arguments, so the same scene gives the
//! same pixels everywhere.

mod clip;
mod comparison;
mod difference;
mod ink;
mod overlay;
pub mod palette;
mod plot;
mod scan;
mod stability;
mod text;

#[cfg(feature = "app")]
pub(crate) use clip::{can_be_filled, clipped};
pub use comparison::{
    DrawnPane, PaneArea, caption, comparison_sheet, draw_panes, pane_areas, pane_figures, panes_on_sheet,
};
pub use difference::{difference_picture, draw_difference_scale};
pub use overlay::{
    Angle, Arc, Area, Arrow, ArrowHead, CURVE, DefectMark, Halo, Label, LightHandle, LitVertex, Needle, NeedleKind,
    Needles, Overlay, OverlayLayer, OverlayOptions, ProfileCurves, defect_marks, draw_defects, draw_normals,
    draw_overlay, draw_profile, lay_out_profile,
};
pub use plot::{Drawing, Paper, PlotStyle, Shape, Text, lay_out, lay_out_sheet};
pub use scan::{lay_out_scan, scan_room};
pub use stability::stability_sheet;
pub use text::Set;
