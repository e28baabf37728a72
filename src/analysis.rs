//! What a picture means in numbers.

mod comparison;
pub mod curves;
mod defects;
mod lobe;
mod normals;
mod overlay;
mod perception;
mod probe;
mod profile;
mod sampling;
mod scan;
mod stability;
mod study;

pub use crate::figure::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Point, Tag};
pub use comparison::{
    Brightest, DrawnPane, ErrorFigures, LinearPicture, PaneArea, PaneFigures, RegionErrors, brightest, caption,
    comparison_sheet, difference_picture, difference_scale, draw_panes, error_figures, pane_areas, pane_figures,
    panes_on_sheet, region_errors,
};
pub use defects::{
    DefectMark, Defects, Finding, Orientation, PerspectiveDistortion, SharedVertices, Silhouette, VertexNormals,
    defect_marks, defect_plots, defects, defects_with_progress, draw_defects,
};
pub use lobe::{ReflectionLobe, Response};
pub use normals::{
    LitVertex, Needle, NeedleKind, Needles, NormalField, SeenNormal, SeenNormals, VertexFace, VertexNormal,
    draw_normals,
};
pub use overlay::{Halo, OverlayLayer, OverlayOptions};
pub use perception::{Perception, ResponseModel, Viewing, blur_line, blur_picture};
pub use probe::{
    Angle, Arc, Arrow, ArrowHead, CueTerms, LightHandle, LightTerms, Overlay, Probe, ProbeHit, ZeroCause, ZeroCauses,
    draw_overlay, probe,
};
pub use profile::{
    Border, CURVE, Corner, PERCEIVED_WIDTH, Profile, ProfileCurves, ProfileError, ProfileRequest, Sample, Trace,
    draw_profile, lay_out_profile, luminance, perceived_picture, profile, profile_plots,
};
pub use sampling::{REFERENCE_SAMPLES, SamplingError, sampling_error, sampling_error_with};
#[cfg(feature = "app")]
pub(crate) use scan::scan_drawn;
pub use scan::{
    Carried, Crossing, Grid, Mix, Rule, Scan, ScanCorner, ScanEdge, ScanError, ScanLevel, ScanLine, ScanPixel,
    ScanPoint, ScanSpan, ScanStep, corner_name, face_at, lay_out_scan, scan, scan_room,
};
pub use stability::{
    CASE_PICTURES, Case, CaseResult, Condition, HALF_A_CODE_VALUE, Topic, Verdict, stability, stability_cases,
    stability_sheet,
};
pub use study::{
    Fit, Method, Omission, PixelCost, Progress, Series, Setting, Study, StudyRequest, StudyRow, fit_line, order_of,
    pareto_front, student, study, study_plot, study_point,
};
