//! Analyses of a picture in numbers: questions, and answers with their reports.
//!
//! Each analysis is a module with a [`Question`] and an [`Answer`]; [`ANALYSES`] lists them. The terminal, CSV, JSON,
//! pictures and the window show any answer by its [`Report`].

mod bench;
mod codec;
mod comparison;
mod conditions;
pub mod curves;
mod defects;
mod lobe;
mod normals;
mod overlay;
mod perception;
mod plan;
mod plan_words;
mod probe;
mod profile;
mod question;
mod report;
mod sampling;
mod scan;
mod stability;
mod study;

pub use crate::figure::{Axis, Curve, Dash, Direction, Ink, Mark, Plot, PlotKind, Point, Tag};
pub use bench::{Bench, BenchQuestion, CHANGES, Growth};
pub use codec::{Codec, from_bytes, to_bytes};
pub use comparison::{
    Brightest, Comparison, ComparisonQuestion, DrawnPane, ErrorFigures, ErrorRegion, LinearPicture,
    PaneArea, PaneFigures, RegionErrors, brightest, caption, comparison_sheet, difference_picture,
    difference_scale, draw_panes, error_figures, error_line, pane_areas, pane_figures,
    panes_on_sheet, region_errors,
};
pub use conditions::{
    Assumption, CONDITIONS, Conditions, ConditionsQuestion, Variation, conditions,
};
pub use curves::{Curves, CurvesQuestion};
pub use defects::{
    DEFECTS, Defect, DefectMark, Defects, DefectsQuestion, MeasuredDefects, Measurement,
    Orientation, PerspectiveDistortion, SharedVertices, Silhouette, VertexNormals, defect_marks,
    defect_plots, defects, defects_with_progress, draw_defects,
};
pub use lobe::{ReflectionLobe, Response};
pub use normals::{
    FoundNormal, LitVertex, Needle, NeedleKind, Needles, NormalField, NormalsQuestion, SeenNormal,
    SeenNormals, VertexFace, VertexNormal, draw_normals,
};
pub use overlay::{Halo, OverlayLayer, OverlayOptions, overlay_letters};
pub use perception::{Perception, ResponseModel, Viewing, blur_line, blur_picture, luminance};
pub use plan::{FramePlan, PlanQuestion};
pub use plan_words::stage_words;
pub use probe::{
    Angle, Arc, Arrow, ArrowHead, ConstructionStep, CueTerms, FilledLine, FilledPart, Here,
    Letters, LightHandle, LightHere, LightTerms, LineValue, Overlay, Probe, ProbeHit,
    ProbeQuestion, Probed, Product, Share, TermColumn, Tone, VectorsShown, WorkedStep, ZeroCause,
    ZeroCauses, channels, clearest_pixel, digits, digits_below, draw_overlay, draw_vectors,
    equation_letters, percent, pixel_beside_highlight, plain_formula, probe, specular_vector,
};
pub use profile::{
    Abscissa, Border, Compared, Discontinuity, PERCEIVED_WIDTH, Profile, ProfileCurves,
    ProfileError, ProfileQuestion, Sample, TakenProfile, Trace, compared_plots, draw_profile,
    lay_out_profile, mode_dash, perceived_picture, profile, profile_plots,
};
pub use question::{ANALYSES, Analysis, Format, Question, Subject, Watch, unwatched};
pub(crate) use report::cells;
pub use report::{
    Answer, Cell, Column, Figure, Part, Report, ReportContext, Section, Table, as_it_is, fixed,
    grouped, word,
};
pub use sampling::{REFERENCE_SAMPLES, SamplingError, sampling_error_with};
#[cfg(feature = "app")]
pub(crate) use scan::scan_drawn;
pub use scan::{
    Carried, Crossing, Grid, Mix, Rule, Scan, ScanCorner, ScanEdge, ScanError, ScanLevel, ScanLine,
    ScanPixel, ScanPoint, ScanQuestion, ScanSpan, ScanStep, ScanStop, Stop, corner_name, face_at,
    lay_out_scan, scan, scan_in_grid, scan_room,
};
pub use stability::{
    Case, CaseResult, Catalogue, Condition, HALF_A_CODE_VALUE, StabilityQuestion, Topic, Verdict,
    case_pictures, stability, stability_cases, stability_sheet,
};
pub use study::{
    Fit, Method, Omission, Series, Setting, Study, StudyQuestion, StudyRow, fit_line,
    median_and_spread, order_of, pareto_front, student, study, study_plot, study_point,
};
