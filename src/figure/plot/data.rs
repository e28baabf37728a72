//! A plot as plain data: sampled curves with their names, and marks at the scene's own values.

use crate::scene::ShadingMode;
use serde::{Deserialize, Serialize};

/// Kind of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum PlotKind {
    /// The family cosⁿ φ.
    Exponent,
    /// f(d), the attenuation of a light with distance.
    Attenuation,
    /// W(θ), the reflectance by angle of incidence.
    Reflectance,
    /// Light that one point reflects in every direction, as a polar plot.
    Lobe,
    /// The intensity along a line through the picture.
    Profile,
    /// Slope of the intensity along that line.
    ProfileSlope,
    /// Difference between the perceived brightness and the intensity.
    ProfileAdded,
    /// The intensity at a point while the picture is rotated.
    Orientation,
    /// The intensity on both sides of an edge.
    SharedEdge,
    /// Error against run time.
    Study,
    /// A curve that a lesson asks for.
    Question,
}

impl PlotKind {
    /// All kinds that belong to a point, in the order of the equation; the lobe combines all of them.
    pub const ALL: [Self; 4] = [
        Self::Attenuation,
        Self::Exponent,
        Self::Reflectance,
        Self::Lobe,
    ];

    /// Returns whether x is an angle from the vertical, in degrees clockwise, and y the distance from the middle.
    pub fn is_polar(self) -> bool {
        self == Self::Lobe
    }
}

/// Curves over one pair of axes.
///
/// ```
/// use shading_lab::figure::{Axis, Curve, Ink, Paper, Plot, PlotKind, PlotStyle, lay_out};
/// use shading_lab::glam::DVec2;
///
/// let power = |n: f64| (0..=90).map(move |degrees| {
///     let angle = f64::from(degrees);
///     [angle, angle.to_radians().cos().powf(n)]
/// });
/// let curve = Curve::new("n = 20", power(20.0).collect(), Ink::R);
/// let axes = [Axis::degrees("φ", 0.0, 90.0), Axis::new("cosⁿ φ", 0.0, 1.0)];
/// let plot = Plot::new(PlotKind::Exponent, "A highlight", "", axes, vec![curve]);
///
/// let drawing = lay_out(&plot, DVec2::new(480.0, 320.0), &PlotStyle::of([480, 320], 1, Paper::LIGHT));
/// let svg = drawing.to_svg(&plot.title);
/// assert!(svg.starts_with("<svg"));
/// let frame = drawing.to_frame().expect("it is small enough");
/// assert_eq!((frame.width, frame.height), (480, 320));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Plot {
    /// Kind of the plot.
    pub kind: PlotKind,
    /// Title, a few words.
    pub title: String,
    /// The formula, and other necessary explanations.
    pub note: String,
    /// The horizontal axis; of a polar plot, the angle.
    pub x: Axis,
    /// The vertical axis; of a polar plot, the distance from the middle.
    pub y: Axis,
    /// The curves, the later over the earlier.
    pub curves: Vec<Curve>,
    /// Descriptions of the columns of the curves' notes.
    pub legend: Vec<String>,
    /// Marks at the scene's own values.
    pub marks: Vec<Mark>,
    /// The arrows of a polar plot; others have none.
    pub directions: Vec<Direction>,
    /// Values of x at the edges between polygons, ticked without a name.
    pub borders: Vec<f64>,
    /// Single points, named where space allows.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<Point>,
}

impl Plot {
    /// Creates a plot without marks, over the axes of x and y.
    pub fn new(
        kind: PlotKind,
        title: impl Into<String>,
        note: impl Into<String>,
        [x, y]: [Axis; 2],
        curves: Vec<Curve>,
    ) -> Self {
        Self {
            kind,
            title: title.into(),
            note: note.into(),
            x,
            y,
            curves,
            legend: vec![],
            marks: vec![],
            directions: vec![],
            borders: vec![],
            points: vec![],
        }
    }

    /// Returns the curve of that name.
    pub fn curve(&self, name: &str) -> Option<&Curve> {
        self.curves.iter().find(|curve| curve.name == name)
    }
}

/// An axis: its quantity, and the range to show.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Axis {
    /// Name of the quantity, with its unit.
    pub name: String,
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// True for degrees, whose round numbers are multiples of 15.
    pub degrees: bool,
    /// True if values are logarithms to base 10 of the quantity, whose own values the ticks show.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub decades: bool,
}

impl Axis {
    /// Creates an axis of an angle.
    pub fn degrees(name: impl Into<String>, low: f64, high: f64) -> Self {
        Self {
            degrees: true,
            ..Self::new(name, low, high)
        }
    }

    /// Creates an axis of any other quantity.
    pub fn new(name: impl Into<String>, low: f64, high: f64) -> Self {
        Self {
            name: name.into(),
            low,
            high,
            degrees: false,
            decades: false,
        }
    }

    /// Returns whether an axis can reach from `low` to `high`: finite numbers, the smaller one first, so far apart
    /// that double precision has numbers between them, all with their full digits.
    pub fn can_span(low: f64, high: f64) -> bool {
        /// Minimum span relative to the larger end: ticks and points between the ends keep six digits and more.
        const THINNEST: f64 = 1e-9;
        /// Minimum span whose parts are not subnormal numbers.
        const SHORTEST: f64 = f64::MIN_POSITIVE / f64::EPSILON;
        let span = high - low;
        let min_span = (THINNEST * low.abs().max(high.abs())).max(SHORTEST);
        // A round number above it must be finite too.
        (10.0 * span).is_finite() && span >= min_span
    }

    /// Creates an axis of the logarithms to base 10 of a quantity.
    pub fn decades(name: impl Into<String>, low: f64, high: f64) -> Self {
        Self {
            decades: true,
            ..Self::new(name, low, high)
        }
    }
}

/// A sampled curve.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Curve {
    /// Name in the legend.
    pub name: String,
    /// Name in files, if different.
    #[serde(skip)]
    pub key: String,
    /// Additional columns in the legend.
    pub notes: Vec<String>,
    /// Values of x and y; x never decreases, unless the curve is never interpolated.
    pub points: Vec<[f64; 2]>,
    /// Meaning of its colour.
    pub ink: Ink,
    /// Dash pattern of its line.
    pub dash: Dash,
    /// True for the scene's own curve, with which the others are compared.
    pub emphasised: bool,
    /// Name on the curve itself.
    pub tag: Option<Tag>,
}

impl Curve {
    /// Creates a curve of the scene's own.
    pub fn new(name: impl Into<String>, points: Vec<[f64; 2]>, ink: Ink) -> Self {
        let name = name.into();
        Self {
            key: name.clone(),
            name,
            notes: vec![],
            points,
            ink,
            dash: Dash::Solid,
            emphasised: true,
            tag: None,
        }
    }

    /// Returns y at `x`, linear between the samples; none outside them.
    pub fn at(&self, x: f64) -> Option<f64> {
        let after = self.points.partition_point(|[at, _]| *at < x);
        let [x1, y1] = *self.points.get(after)?;
        if x1 == x {
            return Some(y1);
        }
        let [x0, y0] = *self.points.get(after.checked_sub(1)?)?;
        Some(y0 + (y1 - y0) * (x - x0) / (x1 - x0))
    }
}

/// A name beside a curve, its right edge at `at`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Tag {
    /// The name.
    pub text: String,
    /// Position as x and y.
    pub at: [f64; 2],
}

/// A point with a name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// Position as x and y.
    pub at: [f64; 2],
    /// Name of the point.
    pub name: String,
    /// Meaning of its colour.
    pub ink: Ink,
    /// True for a ring, false for a disc.
    pub hollow: bool,
    /// True if it is named before the others.
    pub strong: bool,
    /// Description in the window, a few lines.
    #[serde(skip)]
    pub about: Vec<String>,
}

/// A marked value of x, as a line across the plot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mark {
    /// Value of x.
    pub x: f64,
    /// Label of the mark.
    pub label: String,
    /// Values there: a curve's index and y.
    pub values: Vec<(usize, f64)>,
    /// True if the value is the probe's.
    pub probe: bool,
}

/// An arrow from the middle of a polar plot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Direction {
    /// Letter of the vector: N, L, R, V or H.
    pub letter: &'static str,
    /// Angle in degrees clockwise from the vertical.
    pub angle: f64,
    /// Length: 1 in the plot's plane, less where the vector leaves it.
    pub length: f64,
    /// Meaning of its colour.
    pub ink: Ink,
}

/// Meaning of a curve's colour; the paper determines the colour itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Ink {
    /// The colour of N. Each vector's colour is also that of the term that it determines.
    N,
    /// The colour of L.
    L,
    /// The colour of R.
    R,
    /// The colour of V.
    V,
    /// The colour of H.
    H,
    /// The colour of a channel: red, green or blue.
    Channel(u8),
    /// The colour of a shading mode.
    Shading(ShadingMode),
    /// The colour of perceived brightness that is not there.
    Perceived,
    /// The colour of curves without a meaning in the scene.
    Reference,
    /// The colour of a historic shading method, by its number from 0 to 2.
    Historic(u8),
}

/// Dash pattern of a line, which distinguishes curves without colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Dash {
    /// A solid line.
    Solid,
    /// Long dashes.
    Long,
    /// Medium dashes.
    Dashed,
    /// Alternating dashes and dots.
    DashDot,
    /// Dots.
    Dotted,
}
