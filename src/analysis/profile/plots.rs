//! A profile as plots: a panel a mode, then the slopes and what the eye adds, all modes together.

use super::{Profile, ProfileQuestion, Trace};
use crate::analysis::perception::ResponseModel;
use crate::figure::{Axis, Curve, Dash, Ink, Plot, PlotKind};
use crate::scene::{Choice, ShadingMode};

/// Of the values of a curve this share may lie off its plot: at an outline slopes grow beyond all bounds.
const OFF: f64 = 0.02;
/// The same for what the eye adds, which is greatest at the outline.
const OFF_ADDED: f64 = 0.08;
/// Room below and above the curves, in their height.
const PADDING: f64 = 0.06;

/// The plots of a profile: for each mode its intensity beside what is perceived, on the same scale for all; then the slopes,
/// and the difference between perceived and real intensity.
pub fn profile_plots(profile: &Profile, request: &ProfileQuestion) -> Vec<Plot> {
    let all = profile
        .traces
        .iter()
        .flat_map(|trace| trace.intensity.iter().chain(&trace.perceived));
    let y = axis("I", bounds(all.copied(), 0.0));
    let panels = profile.traces.iter().map(|trace| {
        let seen = Curve::new(
            "intensity",
            points(profile, &trace.intensity),
            Ink::Shading(trace.mode),
        );
        let perceived = Curve::new(
            "perceived",
            points(profile, &trace.perceived),
            Ink::Perceived,
        );
        let perceived = Curve {
            dash: Dash::Dashed,
            emphasised: false,
            ..perceived
        };
        let title = format!("{}: what is there and what is seen", trace.mode.label());
        plot(
            profile,
            PlotKind::Profile,
            &title,
            y.clone(),
            vec![seen, perceived],
        )
    });
    panels
        .chain([slopes(profile), added(profile, request)])
        .collect()
}

fn slopes(profile: &Profile) -> Plot {
    let curves = profile
        .traces
        .iter()
        .map(|trace| curve(profile, trace, &trace.slope))
        .collect();
    let all = profile
        .traces
        .iter()
        .flat_map(|trace| trace.slope.iter().copied());
    let y = axis("dI/ds, per pixel", bounds(all, OFF));
    plot(
        profile,
        PlotKind::ProfileSlope,
        "The slope, which jumps where bands are seen",
        y,
        curves,
    )
}

fn added(profile: &Profile, request: &ProfileQuestion) -> Plot {
    let difference = |trace: &Trace| -> Vec<f64> {
        trace
            .perceived
            .iter()
            .zip(&trace.intensity)
            .map(|(seen, there)| seen - there)
            .collect()
    };
    let curves: Vec<Curve> = profile
        .traces
        .iter()
        .map(|trace| curve(profile, trace, &difference(trace)))
        .collect();
    // Steps would hide the rest: where there is anything else, that sets the scale.
    let smooth = |curve: &Curve| {
        !matches!(
            curve.ink,
            Ink::Shading(ShadingMode::Flat | ShadingMode::Interpolated)
        )
    };
    let none_smooth = !curves.iter().any(smooth);
    let scale = curves.iter().filter(|curve| none_smooth || smooth(curve));
    let [low, high] = bounds(
        scale.flat_map(|curve| curve.points.iter().map(|[_, y]| *y)),
        OFF_ADDED,
    );
    let y = axis("R − I", [low.min(0.0), high.max(0.0)]);
    let [centre, surround] = profile.widths;
    let model = match request.perception.model {
        ResponseModel::LateralInhibition => "lateral inhibition",
        ResponseModel::ResponseNormalisation => "response normalisation",
    };
    let mut plot = plot(
        profile,
        PlotKind::ProfileAdded,
        "The bands: what the eye adds",
        y,
        curves,
    );
    plot.note = format!(
        "{model}, σc = {centre:.1} and σs = {surround:.1} pixels, w = {}",
        request.perception.weight
    );
    plot
}

fn plot(profile: &Profile, kind: PlotKind, title: &str, y: Axis, curves: Vec<Curve>) -> Plot {
    let x = Axis::new("s, pixels along the line", 0.0, profile.length);
    // Not the diagonals within polygons.
    let edges = profile
        .borders
        .iter()
        .filter(|border| border.faces[0] != border.faces[1]);
    let borders = edges.map(|border| border.t * profile.length).collect();
    Plot {
        borders,
        ..Plot::new(kind, title, "", [x, y], curves)
    }
}

fn curve(profile: &Profile, trace: &Trace, values: &[f64]) -> Curve {
    let dash = match trace.mode {
        ShadingMode::Flat => Dash::Dotted,
        ShadingMode::Interpolated => Dash::DashDot,
        ShadingMode::Gouraud => Dash::Solid,
        ShadingMode::Phong => Dash::Long,
        ShadingMode::Exact => Dash::Dashed,
    };
    Curve {
        dash,
        ..Curve::new(
            trace.mode.label(),
            points(profile, values),
            Ink::Shading(trace.mode),
        )
    }
}

fn points(profile: &Profile, values: &[f64]) -> Vec<[f64; 2]> {
    profile
        .samples
        .iter()
        .zip(values)
        .map(|(sample, value)| [sample.t * profile.length, *value])
        .collect()
}

fn axis(name: &str, [low, high]: [f64; 2]) -> Axis {
    Axis::new(name, low - PADDING * (high - low), high)
}

/// Least and greatest value but for the share `off` at either end; apart from each other in any case.
fn bounds(values: impl Iterator<Item = f64>, off: f64) -> [f64; 2] {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    let Some(last) = values.len().checked_sub(1) else {
        return [0.0, 1.0];
    };
    #[expect(clippy::cast_precision_loss, reason = "far fewer samples than 2⁵³")]
    let skip = (last as f64 * off) as usize;
    let [low, high] = [values[skip], values[last - skip]];
    let least = (1e-9f64).max(1e-6 * high.abs());
    if high - low > least {
        [low, high]
    } else {
        [low - least, high + least]
    }
}
