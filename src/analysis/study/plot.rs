//! Error over time, both logarithmic: a curve for each method, and the front of Pareto.

use super::{Method, Setting, Study, StudyRow};
use crate::analysis::{Axis, Curve, Dash, Ink, Plot, PlotKind, Point};
use crate::scene::{Interpolation, ShadingMode};

/// The axes reach beyond the points by this part of their extent, and span at least half a decade.
const MARGIN: f64 = 0.08;
const LEAST: f64 = 0.5;

/// The plot of what is known; nothing as long as no setting has an error and a time.
pub fn study_plot(study: &Study) -> Option<Plot> {
    let known: Vec<(&StudyRow, [f64; 2])> =
        study.rows.iter().filter_map(|row| Some((row, study_point(row)?))).collect();
    let first = known.first()?;
    let varies = |of: fn(&Setting) -> u64| known.iter().any(|(row, _)| of(&row.setting) != of(&first.0.setting));
    let several_n = varies(|setting| setting.n.to_bits());
    let mut front: Vec<[f64; 2]> = known.iter().filter(|(row, _)| row.pareto).map(|(_, at)| *at).collect();
    front.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (ink, dash) = (Ink::Reference, Dash::Long);
    let mut curves = vec![Curve { dash, emphasised: false, ..Curve::new("front of Pareto", front, ink) }];
    let mut points = Vec::new();
    for series in known.chunk_by(|a, b| a.0.setting.is_like(&b.0.setting)) {
        let setting = &series[0].0.setting;
        let name = name(setting, several_n);
        let (ink, dash) = look(setting.method);
        let emphasised = setting.interpolation != Some(Interpolation::Affine);
        let line = series.iter().map(|(_, at)| *at).collect();
        curves.push(Curve { dash, emphasised, ..Curve::new(&name, line, ink) });
        points.extend(series.iter().enumerate().map(|(index, (row, at))| {
            let segments = row.setting.segments;
            let text = if index == 0 || row.pareto { format!("{name} {segments}") } else { segments.to_string() };
            Point { at: *at, name: text, ink, hollow: row.scalar, strong: index == 0 || row.pareto }
        }));
    }
    let axis = |name: &str, index: usize| {
        let [low, high] = extent(known.iter().map(|(_, at)| at[index]));
        Axis::decades(name, low, high)
    };
    Some(Plot {
        kind: PlotKind::Study,
        title: "Error against run time".to_owned(),
        note:
            "Root mean square of the error inside (N·V ≥ 0.2) against the exact picture, linear intensity; numbers are \
               segments. Rings: scalar code in one thread, not to be compared with the engine's times."
                .to_owned(),
        x: axis("time of a frame, ms", 0),
        y: axis("RMS error", 1),
        curves,
        legend: vec![],
        marks: vec![],
        directions: vec![],
        borders: vec![],
        points,
    })
}

/// Where a row stands in the plot: the logarithms to the base 10 of its time in milliseconds and of its error.
pub fn study_point(row: &StudyRow) -> Option<[f64; 2]> {
    let point = [row.time_ms.log10(), row.error_rms.log10()];
    point.iter().all(|value| value.is_finite()).then_some(point)
}

fn name(setting: &Setting, several_n: bool) -> String {
    let how = match setting.interpolation {
        Some(Interpolation::Affine) => ", affine",
        Some(Interpolation::Scanline) => ", scan line",
        Some(Interpolation::Perspective) | None => "",
    };
    let n = if several_n { format!(", n = {}", setting.n) } else { String::new() };
    format!("{}{how}{n}", setting.method.title())
}

fn look(method: Method) -> (Ink, Dash) {
    match method {
        Method::Flat => (Ink::Shading(ShadingMode::Flat), Dash::Solid),
        Method::FlatVertexMean => (Ink::Shading(ShadingMode::Flat), Dash::Dashed),
        Method::Interpolated => (Ink::Shading(ShadingMode::Interpolated), Dash::DashDot),
        Method::Gouraud => (Ink::Shading(ShadingMode::Gouraud), Dash::Solid),
        Method::Phong => (Ink::Shading(ShadingMode::Phong), Dash::Solid),
        Method::PhongUnnormalised => (Ink::Shading(ShadingMode::Phong), Dash::Dashed),
        Method::PhongScalar => (Ink::Historic(0), Dash::Solid),
        Method::Taylor => (Ink::Historic(1), Dash::DashDot),
        Method::Angular => (Ink::Historic(2), Dash::Dotted),
    }
}

fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)]);
    let margin = ((high - low) * MARGIN).max(0.5 * (LEAST - (high - low)));
    [low - margin, high + margin]
}
