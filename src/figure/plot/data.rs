//! A plot as plain data: sampled curves, what they are called, and where the scene itself stands on them.

use crate::scene::ShadingMode;
use serde::{Deserialize, Serialize};

/// The curves of local illumination.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum PlotKind {
    /// The family cosⁿ φ.
    Exponent,
    /// f(d), the attenuation of a light by distance.
    Attenuation,
    /// W(θ), what a surface reflects by angle of incidence.
    Reflectance,
    /// What one point reflects to every side, as a polar plot.
    Lobe,
    /// The intensity along a line through the picture.
    Profile,
    /// Its slope.
    ProfileSlope,
    /// What the eye adds to it.
    ProfileAdded,
    /// The intensity at a point while the picture turns.
    Orientation,
    /// The intensity on both sides of an edge.
    SharedEdge,
    /// Error against run time.
    Study,
    /// A curve that a lesson asks for.
    Question,
}

impl PlotKind {
    /// Every kind that belongs to a point, in the order of the equation: the lobe last, because it is all of them together.
    pub const ALL: [Self; 4] = [
        Self::Attenuation,
        Self::Exponent,
        Self::Reflectance,
        Self::Lobe,
    ];

    /// Whether x is an angle from the vertical, in degrees clockwise, and y the distance from the middle.
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
    /// Which plot it is.
    pub kind: PlotKind,
    /// What is plotted, in a few words.
    pub title: String,
    /// The formula, and what else the reader must know.
    pub note: String,
    /// The horizontal axis; of a polar plot, the angle.
    pub x: Axis,
    /// The vertical axis; of a polar plot, the distance from the middle.
    pub y: Axis,
    /// The curves, the later over the earlier.
    pub curves: Vec<Curve>,
    /// What each of the curves' notes says.
    pub legend: Vec<String>,
    /// Where the scene itself stands.
    pub marks: Vec<Mark>,
    /// The arrows of a polar plot; others have none.
    pub directions: Vec<Direction>,
    /// Values of x where polygons meet, ticked without a name.
    pub borders: Vec<f64>,
    /// Single points, named where there is room.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<Point>,
}

impl Plot {
    /// A plot without marks, over the axes of x and y.
    pub fn new(
        kind: PlotKind,
        title: impl Into<String>,
        note: impl Into<String>,
        [x, y]: [Axis; 2],
        curves: Vec<Curve>,
    ) -> Self {
        let (title, note) = (title.into(), note.into());
        let (legend, marks, directions, borders, points) = (vec![], vec![], vec![], vec![], vec![]);
        Self {
            kind,
            title,
            note,
            x,
            y,
            curves,
            legend,
            marks,
            directions,
            borders,
            points,
        }
    }

    /// The curve of that name.
    pub fn curve(&self, name: &str) -> Option<&Curve> {
        self.curves.iter().find(|curve| curve.name == name)
    }
}

/// One axis: what it measures, and the part of it that is worth showing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Axis {
    /// What it measures, with its unit.
    pub name: String,
    /// Its lower end.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
    /// Whether it measures degrees, whose round numbers are multiples of 15.
    pub degrees: bool,
    /// Whether values are logarithms to the base 10 of what it measures, which is what its ticks say.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub decades: bool,
}

impl Axis {
    /// An axis of an angle.
    pub fn degrees(name: impl Into<String>, low: f64, high: f64) -> Self {
        Self {
            name: name.into(),
            low,
            high,
            degrees: true,
            decades: false,
        }
    }

    /// An axis of any other quantity.
    pub fn new(name: impl Into<String>, low: f64, high: f64) -> Self {
        Self {
            name: name.into(),
            low,
            high,
            degrees: false,
            decades: false,
        }
    }

    /// Whether an axis can reach from `low` to `high`: finite numbers, the smaller one first, so far apart that double precision has
    /// numbers between them, all with their full digits.
    pub fn can_span(low: f64, high: f64) -> bool {
        /// Of the larger end: ticks and points between the ends keep six digits and more.
        const THINNEST: f64 = 1e-9;
        /// Parts of a shorter span would be subnormal numbers.
        const SHORTEST: f64 = f64::MIN_POSITIVE / f64::EPSILON;
        let span = high - low;
        let least = (THINNEST * low.abs().max(high.abs())).max(SHORTEST);
        // A round number above it is a number too.
        (10.0 * span).is_finite() && span >= least
    }

    /// An axis of the logarithms to the base 10 of a quantity.
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
    /// What the legend calls it.
    pub name: String,
    /// What it is called in files, where that is not its name.
    #[serde(skip)]
    pub key: String,
    /// What the legend says besides the name, in columns.
    pub notes: Vec<String>,
    /// x and y; x never decreases, unless the curve is read nowhere.
    pub points: Vec<[f64; 2]>,
    /// What its colour means.
    pub ink: Ink,
    /// How its line is broken.
    pub dash: Dash,
    /// The curve that the scene itself has, against which the others are measured.
    pub emphasised: bool,
    /// A name on the curve itself.
    pub tag: Option<Tag>,
}

impl Curve {
    /// A curve of the scene's own.
    pub fn new(name: impl Into<String>, points: Vec<[f64; 2]>, ink: Ink) -> Self {
        let (name, notes, dash) = (name.into(), Vec::new(), Dash::Solid);
        Self {
            key: name.clone(),
            name,
            notes,
            points,
            ink,
            dash,
            emphasised: true,
            tag: None,
        }
    }

    /// y at `x`, linear between the samples; nothing outside them.
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
    /// What it says.
    pub text: String,
    /// x and y.
    pub at: [f64; 2],
}

/// A point with a name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// x and y.
    pub at: [f64; 2],
    /// What it is called.
    pub name: String,
    /// What its colour means.
    pub ink: Ink,
    /// A ring and not a disc.
    pub hollow: bool,
    /// Named before the others.
    pub strong: bool,
    /// What the window says of it, a few lines.
    #[serde(skip)]
    pub about: Vec<String>,
}

/// A value of x, a line across the plot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mark {
    /// Where the line is.
    pub x: f64,
    /// What it is called.
    pub label: String,
    /// The values there: a curve's index and y.
    pub values: Vec<(usize, f64)>,
    /// Whether it is the probe's.
    pub probe: bool,
}

/// An arrow from the middle of a polar plot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Direction {
    /// N, L, R, V or H.
    pub letter: &'static str,
    /// Degrees clockwise from the vertical.
    pub angle: f64,
    /// 1 in the plot's plane, less where the vector leaves it.
    pub length: f64,
    /// What its colour means.
    pub ink: Ink,
}

/// What a curve's colour means; which colour that is depends on the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Ink {
    /// The colours of the vectors, and of the terms that they make.
    N,
    /// The colour of L.
    L,
    /// The colour of R.
    R,
    /// The colour of V.
    V,
    /// The colour of H.
    H,
    /// Red, green or blue.
    Channel(u8),
    /// A way of shading.
    Shading(ShadingMode),
    /// What is seen and not there.
    Perceived,
    /// Of no meaning in the scene.
    Reference,
    /// A historic way of shading, by its number from 0 to 2.
    Historic(u8),
}

/// How a line is broken, so that curves are told apart without colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Dash {
    /// Not at all.
    Solid,
    /// In long dashes.
    Long,
    /// In dashes.
    Dashed,
    /// In dashes and dots by turns.
    DashDot,
    /// In dots.
    Dotted,
}
