//! What a picture means in numbers.

mod comparison;
pub mod curves;
mod defects;
mod lobe;
mod normals;
mod perception;
mod plot;
mod probe;
mod profile;
mod sampling;
mod scan;
mod stability;
mod study;

pub use comparison::{
    Brightest, ErrorFigures, LinearPicture, PaneFigures, RegionErrors, brightest, error_figures, region_errors,
};
pub use defects::{
    Defects, Finding, Orientation, PerspectiveDistortion, SharedVertices, Silhouette, VertexNormals, defect_plots,
    defects, defects_with_progress,
};
pub use lobe::{ReflectionLobe, Response};
pub use normals::{NormalField, SeenNormal, SeenNormals, VertexFace, VertexNormal};
pub use perception::{Perception, ResponseModel, Viewing, blur_line, blur_picture};
pub use plot::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Point, Tag};
pub use probe::{CueTerms, LightTerms, Probe, ProbeHit, ZeroCause, ZeroCauses, probe};
pub use profile::{
    Border, Corner, PERCEIVED_WIDTH, Profile, ProfileError, ProfileRequest, Sample, Trace, luminance,
    perceived_picture, profile, profile_plots,
};
pub use sampling::{REFERENCE_SAMPLES, SamplingError, sampling_error, sampling_error_with};
#[cfg(feature = "app")]
pub(crate) use scan::scan_drawn;
pub use scan::{
    Carried, Crossing, Grid, Mix, Rule, Scan, ScanCorner, ScanEdge, ScanError, ScanLevel, ScanLine, ScanPixel,
    ScanPoint, ScanSpan, ScanStep, corner_name, face_at, scan,
};
pub use stability::{
    CASE_PICTURES, Case, CaseResult, Condition, HALF_A_CODE_VALUE, Topic, Verdict, stability, stability_cases,
};
pub use study::{
    Fit, Method, Omission, PixelCost, Progress, Series, Setting, Study, StudyRequest, StudyRow, fit_line, order_of,
    pareto_front, student, study, study_plot, study_point,
};
