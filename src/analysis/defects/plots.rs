//! Those defects that are a curve, as plots.

use super::{Defects, Orientation, SharedVertices};
use crate::figure::{Axis, Curve, Dash, Ink, Mark, Plot, PlotKind};

/// The plots of what was measured.
pub fn defect_plots(defects: &Defects) -> Vec<Plot> {
    let orientation = defects.orientation.as_ref().ok().map(orientation);
    let shared = defects.shared_vertices.as_ref().ok().map(shared);
    orientation.into_iter().chain(shared).collect()
}

fn plot(kind: PlotKind, title: &str, x: Axis, y: &str, curves: Vec<Curve>) -> Plot {
    let values = curves.iter().flat_map(|curve| curve.points.iter().map(|[_, y]| *y));
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
    // A curve that is even to rounding is shown as even.
    let padding = (0.08 * (high - low)).max(0.02 * high.abs()).max(1e-6);
    Plot {
        kind,
        title: title.to_owned(),
        note: String::new(),
        x,
        y: Axis::new(y, low - padding, high + padding),
        curves,
        legend: vec![],
        marks: vec![],
        directions: vec![],
        borders: vec![],
        points: vec![],
    }
}

fn orientation(measured: &Orientation) -> Plot {
    let curve = |name, of: fn(&super::orientation::Turned) -> Option<f64>, ink, dash, emphasised| {
        let points = measured.samples.iter().filter_map(|turned| Some([turned.angle, of(turned)?])).collect();
        Curve { dash, emphasised, ..Curve::new(name, points, ink) }
    };
    let curves = vec![
        curve("along the scan line", |turned| turned.scanline, Ink::L, Dash::Solid, true),
        curve("barycentric", |turned| turned.barycentric, Ink::N, Dash::Dashed, false),
    ];
    let x = Axis::degrees("roll", 0.0, 360.0);
    let mut plot = plot(PlotKind::Orientation, "One point while the picture turns", x, "I", curves);
    let values = (0..2).filter_map(|index| plot.curves[index].at(measured.roll).map(|y| (index, y))).collect();
    plot.marks = vec![Mark { x: measured.roll, label: "now".to_owned(), values, probe: true }];
    plot
}

fn shared(measured: &SharedVertices) -> Plot {
    let points = |side: usize| measured.samples.iter().map(|sample| [sample[0], sample[side]]).collect();
    let curves = vec![
        Curve::new("the side with the vertex", points(2), Ink::L),
        Curve { dash: Dash::Dashed, emphasised: false, ..Curve::new("the side without", points(1), Ink::N) },
    ];
    let x = Axis::new("along the edge", 0.0, 1.0);
    let mut plot = plot(PlotKind::SharedEdge, "Both sides of the edge", x, "I", curves);
    let value = |index: usize| plot.curves[index].at(measured.vertex).map(|y| (index, y));
    let values = (0..2).filter_map(value).collect();
    plot.marks = vec![Mark { x: measured.vertex, label: "vertex".to_owned(), values, probe: false }];
    plot
}
