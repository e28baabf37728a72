//! A profile as plots: intensity with perceived brightness, the slope, and the difference between perceived and
//! actual brightness.

use super::{Border, Profile, ProfileQuestion, Sample, Trace};
use crate::analysis::perception::ResponseModel;
use crate::figure::{Axis, Curve, Dash, Ink, Plot, PlotKind};
use crate::scene::{Choice, ShadingMode};
use crate::text::text;

/// Padding below and above the curves, in their height.
const PADDING: f64 = 0.06;
/// Slope per pixel below which it counts as 0: over a thousand pixels it makes less than a code value.
const CONSTANT: f64 = 1e-6;
/// Minimum distance from the object's outline of values that set the scale of a plot: at the outline the intensity
/// jumps, which would flatten the rest. For slopes in pixels; for the perceived brightness in widths of the surround.
const CLEAR: [f64; 2] = [2.0, 4.0];
/// Share of the slopes that may lie off the plot where there are no polygons: at an outline they have no bound.
const OFF: f64 = 0.02;

/// The quantity on the x axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Abscissa {
    /// The distance along the line, pixels.
    Distance,
    /// x in the picture between two places, pixels, for horizontal lines.
    PictureX([f64; 2]),
}

impl Abscissa {
    /// Returns the axis value at parameter t of the line.
    pub fn at(self, profile: &Profile, t: f64) -> f64 {
        let [from, to] = self.ends(profile);
        from + (to - from) * t
    }

    /// Returns the parameter t of the line at axis value x.
    pub fn share(self, profile: &Profile, x: f64) -> f64 {
        let [from, to] = self.ends(profile);
        (x - from) / (to - from)
    }

    /// Returns whether the axis runs against the line.
    fn reversed(self, profile: &Profile) -> bool {
        let [from, to] = self.ends(profile);
        to < from
    }

    /// Returns the axis values of the line's ends.
    fn ends(self, profile: &Profile) -> [f64; 2] {
        let x = |sample: Option<&Sample>| sample.map_or(0.0, |sample| sample.x);
        match self {
            Self::Distance => [0.0, profile.length],
            Self::PictureX(_) => [x(profile.samples.first()), x(profile.samples.last())],
        }
    }
}

/// A view of one mode among others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compared {
    /// The mode whose curve is emphasised.
    pub own: ShadingMode,
    /// The quantity on the x axis.
    pub abscissa: Abscissa,
    /// True to mark the edges between polygons.
    pub edges: bool,
    /// True to show the mode's perceived brightness beside its intensity.
    pub perceived: bool,
}

/// Returns the plots of a view: intensity, slope, and perceived minus actual, each with the curves of all modes.
pub fn compared_plots(profile: &Profile, request: &ProfileQuestion, view: Compared) -> [Plot; 3] {
    let plotter = ProfilePlotter::new(profile, view.abscissa, view.edges);
    let own = view.own;
    let traces = profile.traces.iter();
    let seen: Vec<&Trace> = traces
        .filter(|trace| view.perceived && trace.mode == own)
        .collect();
    let mut curves = plotter.curves(own, |trace| trace.intensity.clone());
    curves.extend(seen.iter().map(|trace| plotter.perceived(trace)));
    let y = plotter.intensity_axis(&seen);
    let title = text!("line-intensity-title");
    let intensity = plotter.plot(PlotKind::Profile, title, "", y, curves);
    [intensity, plotter.slopes(own), plotter.added(request, own)]
}

/// A profile, to be plotted over a quantity on the x axis.
struct ProfilePlotter<'a> {
    profile: &'a Profile,
    abscissa: Abscissa,
    /// Edges between polygons on the line, without the diagonals within polygons.
    edges: Vec<&'a Border>,
    marked: bool,
}

impl<'a> ProfilePlotter<'a> {
    fn new(profile: &'a Profile, abscissa: Abscissa, marked: bool) -> Self {
        let borders = profile.borders.iter();
        let edges = borders.filter(|border| border.faces[0] != border.faces[1]);
        Self {
            profile,
            abscissa,
            edges: edges.collect(),
            marked,
        }
    }

    /// Returns the axis for the range of all intensities, and of the perceived brightness of those of `seen`.
    fn intensity_axis(&self, seen: &[&Trace]) -> Axis {
        let traces = self.profile.traces.iter();
        let actual = traces.flat_map(|trace| &trace.intensity);
        let perceived = seen.iter().flat_map(|trace| &trace.perceived);
        let all = actual.chain(perceived).copied().collect();
        axis(text!("line-axis-intensity"), bounds(all, 0.0))
    }

    fn slopes(&self, own: ShadingMode) -> Plot {
        let constant = |trace: &Trace| trace.slope.iter().all(|slope| slope.abs() < CONSTANT);
        if self.profile.traces.iter().all(constant) {
            return self.jumps(own);
        }
        let sign = self.sign();
        let curves = self.curves(own, |trace| trace.slope.iter().map(|s| s * sign).collect());
        let values = self.away_from_outline(CLEAR[0], &curves);
        let off = if self.edges.is_empty() { OFF } else { 0.0 };
        let y = axis(text!("line-axis-slope"), bounds(values, off));
        let (title, note) = (text!("line-slope-title"), text!("line-slope-note"));
        self.plot(PlotKind::ProfileSlope, title, note, y, curves)
    }

    /// Returns the factor by which slopes along the line become slopes along the axis.
    fn sign(&self) -> f64 {
        if self.abscissa.reversed(self.profile) {
            -1.0
        } else {
            1.0
        }
    }

    /// Plots the jumps of intensity between polygons, where slopes are 0 within them.
    fn jumps(&self, own: ShadingMode) -> Plot {
        let curve = |trace: &Trace| {
            let steps = self.profile.borders.iter().zip(&trace.corners);
            let spikes = steps.filter_map(|(border, corner)| {
                let x = self.x(border.t);
                Some([[x, 0.0], [x, self.sign() * corner.as_ref()?.step], [x, 0.0]])
            });
            let [first, last] = [0.0, 1.0].map(|t| [self.x(t), 0.0]);
            let points = std::iter::once(first)
                .chain(spikes.flatten())
                .chain([last])
                .collect();
            Curve {
                points: self.ordered(points),
                ..self.curve_of(trace, Vec::new(), own)
            }
        };
        let curves: Vec<Curve> = self.profile.traces.iter().map(curve).collect();
        let values = curves
            .iter()
            .flat_map(|curve| curve.points.iter().map(|[_, y]| *y));
        let y = axis(text!("line-axis-jump"), bounds(values.collect(), 0.0));
        let (title, note) = (text!("line-jumps-title"), text!("line-jumps-note"));
        self.plot(PlotKind::ProfileSlope, title, note, y, curves)
    }

    fn added(&self, request: &ProfileQuestion, own: ShadingMode) -> Plot {
        let curves = self.curves(own, |trace| {
            let pairs = trace.perceived.iter().zip(&trace.intensity);
            pairs.map(|(seen, actual)| seen - actual).collect()
        });
        let [centre, surround] = self.profile.widths;
        let values = self.away_from_outline(CLEAR[1] * surround, &curves);
        let [low, high] = bounds(values, 0.0);
        let y = axis(text!("line-axis-added"), [low.min(0.0), high.max(0.0)]);
        let outside = |curve: &Curve| {
            let margin = PADDING * (high - low);
            let mut values = curve.points.iter().map(|[_, value]| *value);
            values.any(|value| !(low - margin..=high + margin).contains(&value))
        };
        let model = match request.perception.model {
            ResponseModel::LateralInhibition => text!("line-lateral-inhibition"),
            ResponseModel::ResponseNormalisation => text!("line-response-normalisation"),
        };
        let mut note = text!(
            "line-added-note",
            model = model,
            centre = format!("{centre:.1}"),
            surround = format!("{surround:.1}"),
            weight = request.perception.weight.to_string()
        );
        if curves.iter().any(outside) {
            note = format!("{note} {}", text!("line-added-outline"));
        }
        let title = text!("line-added-title");
        self.plot(PlotKind::ProfileAdded, title, &note, y, curves)
    }

    /// Returns the values at least `pixels` from where the line enters or leaves the object; if there are none, all.
    fn away_from_outline(&self, pixels: f64, curves: &[Curve]) -> Vec<f64> {
        let edges = self.edges.iter().filter(|edge| edge.faces.contains(&None));
        let outline: Vec<f64> = edges.map(|edge| self.x(edge.t)).collect();
        let clear = |x: f64| outline.iter().all(|edge| (x - edge).abs() >= pixels);
        let points = || curves.iter().flat_map(|curve| &curve.points);
        let away: Vec<f64> = points()
            .filter(|[x, _]| clear(*x))
            .map(|[_, y]| *y)
            .collect();
        if away.is_empty() {
            points().map(|[_, y]| *y).collect()
        } else {
            away
        }
    }

    /// Returns the axis value at parameter t of the line.
    fn x(&self, t: f64) -> f64 {
        self.abscissa.at(self.profile, t)
    }

    fn plot(&self, kind: PlotKind, title: &str, note: &str, y: Axis, curves: Vec<Curve>) -> Plot {
        let x = match self.abscissa {
            Abscissa::Distance => Axis::new(text!("line-axis-distance"), 0.0, self.profile.length),
            Abscissa::PictureX([low, high]) => Axis::new(text!("line-axis-x"), low, high),
        };
        let marked = self.edges.iter().filter(|_| self.marked);
        let mut borders: Vec<f64> = marked.map(|edge| self.x(edge.t)).collect();
        borders.sort_by(f64::total_cmp);
        Plot {
            borders,
            ..Plot::new(kind, title, note, [x, y], curves)
        }
    }

    fn curves(&self, own: ShadingMode, values: impl Fn(&Trace) -> Vec<f64>) -> Vec<Curve> {
        self.profile
            .traces
            .iter()
            .map(|trace| self.curve_of(trace, values(trace), own))
            .collect()
    }

    fn curve_of(&self, trace: &Trace, values: Vec<f64>, own: ShadingMode) -> Curve {
        let emphasised = own == trace.mode;
        let dash = mode_dash(trace.mode, emphasised);
        Curve {
            emphasised,
            ..self.curve(trace, &values, dash)
        }
    }

    fn curve(&self, trace: &Trace, values: &[f64], dash: Dash) -> Curve {
        let samples = self.profile.samples.iter().zip(values);
        let points = samples.map(|(sample, value)| [self.x(sample.t), *value]);
        let (points, ink) = (self.ordered(points.collect()), Ink::Shading(trace.mode));
        Curve {
            dash,
            ..Curve::new(trace.mode.label(), points, ink)
        }
    }

    fn perceived(&self, trace: &Trace) -> Curve {
        Curve {
            name: text!("line-perceived").to_owned(),
            ink: Ink::Perceived,
            emphasised: false,
            ..self.curve(trace, &trace.perceived, Dash::Dashed)
        }
    }

    fn ordered(&self, mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        if self.abscissa.reversed(self.profile) {
            points.reverse();
        }
        points
    }
}

/// Returns the dash pattern of a mode's curve, which identifies it without colour; the emphasised one is solid.
pub fn mode_dash(mode: ShadingMode, stands_out: bool) -> Dash {
    match mode {
        _ if stands_out => Dash::Solid,
        ShadingMode::Flat => Dash::Dotted,
        ShadingMode::Interpolated => Dash::DashDot,
        ShadingMode::Gouraud => Dash::Solid,
        ShadingMode::Phong => Dash::Long,
        ShadingMode::Exact => Dash::Dashed,
    }
}

fn axis(name: &str, [low, high]: [f64; 2]) -> Axis {
    Axis::new(name, low - PADDING * (high - low), high)
}

/// Returns the minimum and maximum without the share `off` at either end. Equal ones are padded on both sides.
fn bounds(mut values: Vec<f64>, off: f64) -> [f64; 2] {
    values.retain(|value| value.is_finite());
    values.sort_by(f64::total_cmp);
    let Some(last) = values.len().checked_sub(1) else {
        return [0.0, 1.0];
    };
    let skip = (last as f64 * off) as usize;
    let [low, high] = [values[skip], values[last - skip]];
    if high - low > 1e-6 * high.abs().max(low.abs()) {
        [low, high]
    } else {
        let margin = (0.5 * high.abs()).max(0.05);
        [low - margin, high + margin]
    }
}
