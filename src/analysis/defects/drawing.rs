//! Drawings of the defects: marks over the picture for those that have a place, plots for those that are a curve.

use super::{DeepEdge, Defects, Orientation, SharedVertices};
use crate::analysis::overlay::{OverlayOptions, Style};
use crate::figure::{Axis, Curve, Dash, Ink, Mark, Plot, PlotKind, Shape, Text, inked_size};
use crate::text;
use glam::DVec2;
use std::iter;
use tiny_skia::PixmapMut;

/// Smallest visible distance, pixels.
const LEAST: f64 = 0.05;
/// Smallest jump beyond rounding, a quarter of a code value.
const LEAST_JUMP: f64 = 1e-3;
/// Distance, in letters, below which an arrow points at it.
const SHORT: f64 = 0.3;
/// Length of the tick at a tenth of an edge, and the distance of the words' middle from the edge, in letters.
const TENTH: f64 = 0.5;
const WORDS: f64 = 4.0;

/// The mark of a defect that has a place in the picture, for letters of some size; pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct DefectMark {
    /// The built-in scene that shows the defect.
    pub scene: &'static str,
    /// Lines to draw, each through its points; pixels.
    pub lines: Vec<Vec<DVec2>>,
    /// Text beside the lines.
    pub label: String,
    /// The middle of the label.
    pub label_at: DVec2,
}

/// Returns the marks in a picture of `size` pixels, for letters of `em` pixels: the outline's largest distance, the tenths of
/// an edge that runs away from the eye, the largest jump at an unshared vertex.
pub fn defect_marks(defects: &Defects, size: [u32; 2], em: f64) -> Vec<DefectMark> {
    // Words are wider than tall.
    let beside = |end: DVec2, way: DVec2| end + DVec2::new(1.9 * em, 1.6 * em) * way;
    let outline = defects
        .silhouette
        .as_ref()
        .ok()
        .filter(|found| found.greatest > LEAST)
        .map(|found| {
            let way = (found.surface - found.polygon).normalize_or(DVec2::X);
            let lines = distance([found.polygon, found.surface], way, em);
            DefectMark {
                scene: "silhouette",
                lines,
                label: format!("{:.1} px", found.greatest),
                label_at: beside(found.surface, way),
            }
        });
    let jump = defects
        .shared_vertices
        .as_ref()
        .ok()
        .filter(|found| found.greatest > LEAST_JUMP)
        .map(|found| {
            let mut ring = Shape::ring(found.at, 0.75 * em, 0.0, [0; 3]).points;
            ring.extend(ring.first().copied());
            let size = format!("{:.3}", found.greatest);
            let label = text!("picture-mark-jump", size = size);
            DefectMark {
                scene: "shared-vertices",
                lines: vec![ring],
                label,
                label_at: beside(found.at, DVec2::NEG_Y),
            }
        });
    let edge = defects
        .perspective
        .as_ref()
        .ok()
        .and_then(|found| found.edge);
    let tenths = edge.iter().flat_map(|edge| tenths(edge, em));
    let mut marks: Vec<DefectMark> = outline.into_iter().chain(tenths).chain(jump).collect();
    let size = DVec2::from_array(size.map(f64::from));
    for mark in &mut marks {
        let half = 0.5 * inked_size(&mark.label, em);
        mark.label_at = mark.label_at.clamp(half, (size - half).max(half));
    }
    marks
}

/// Marks the tenths of an edge, on its left those in the picture, on its right those in space.
fn tenths(edge: &DeepEdge, em: f64) -> [DefectMark; 2] {
    let [near, far] = edge.ends;
    let across = (far - near).normalize_or_zero().perp();
    let left = if across.x > 0.0 { -across } else { across };
    let side = |way: DVec2, words: &str, at: &dyn Fn(f64) -> DVec2| {
        let tick = |tenth: u32| {
            let [place, length] = [at(f64::from(tenth) / 10.0), DVec2::splat(TENTH * em)];
            let longer = if tenth == 5 { 2.0 } else { 1.0 };
            vec![place, place + longer * length * way]
        };
        DefectMark {
            scene: "perspective-distortion",
            lines: iter::once(vec![near, far])
                .chain((1..10).map(tick))
                .collect(),
            label: words.to_owned(),
            label_at: near.midpoint(at(0.5)) + WORDS * em * way,
        }
    };
    let in_picture = |s: f64| near.lerp(far, s);
    let in_space = |t: f64| edge.in_space(t);
    [
        side(left, text!("picture-mark-in-picture"), &in_picture),
        side(-left, text!("picture-mark-in-space"), &in_space),
    ]
}

/// Marks a distance between two ticks, or a short one with an arrow; `way` is the unit vector along it.
fn distance([a, b]: [DVec2; 2], way: DVec2, em: f64) -> Vec<Vec<DVec2>> {
    let tick = 0.45 * em * way.perp();
    if a.distance(b) >= SHORT * em {
        return vec![
            vec![a, b],
            vec![a - tick, a + tick],
            vec![b - tick, b + tick],
        ];
    }
    let tip = b + 0.15 * em * way;
    let back = |side: f64| tip + 0.35 * em * way + 0.5 * side * tick;
    vec![
        vec![tip, tip + em * way],
        vec![tip, back(1.0)],
        vec![tip, back(-1.0)],
    ]
}

/// Draws the marks of `defects` over the picture in which they were measured; those of one built-in scene's defect, or all.
pub fn draw_defects(
    pixmap: &mut PixmapMut<'_>,
    defects: &Defects,
    scene: Option<&str>,
    options: &OverlayOptions,
) {
    let style = Style::new(f64::from(pixmap.width().min(pixmap.height())), options);
    let drawn = |mark: &DefectMark| scene.is_none_or(|scene| mark.scene == scene);
    let size = [pixmap.width(), pixmap.height()];
    for mark in defect_marks(defects, size, style.text)
        .into_iter()
        .filter(drawn)
    {
        let lines = mark
            .lines
            .into_iter()
            .map(|line| Shape::line(line, 0.8 * style.line, style.neutral));
        let mut drawing = style.drawing(lines.collect());
        let text = Text::centred(&mark.label, mark.label_at, style.text, style.neutral);
        drawing.texts.push(text.haloed(style.halo));
        drawing.draw(pixmap);
    }
}

/// Returns the plots of the measurements.
pub fn defect_plots(defects: &Defects) -> Vec<Plot> {
    let orientation = defects.orientation.as_ref().ok().map(orientation);
    orientation
        .into_iter()
        .chain(defects.shared_vertices.as_ref().ok().map(shared))
        .collect()
}

/// Plots two curves, the first one emphasised, with a mark at which both are read.
fn plot(kind: PlotKind, title: &str, x: Axis, curves: [Curve; 2], mark: Mark) -> Plot {
    let [first, second] = curves;
    let curves = vec![
        first,
        Curve {
            dash: Dash::Dashed,
            emphasised: false,
            ..second
        },
    ];
    let values = curves
        .iter()
        .flat_map(|curve| curve.points.iter().map(|[_, y]| *y));
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
        (l.min(v), h.max(v))
    });
    let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
    // A curve that is constant up to rounding is shown as constant.
    let padding = (0.08 * (high - low)).max(0.02 * high.abs()).max(1e-6);
    let values = curves
        .iter()
        .enumerate()
        .filter_map(|(index, curve)| Some((index, curve.at(mark.x)?)));
    let marks = vec![Mark {
        values: values.collect(),
        ..mark
    }];
    let y = Axis::new("I", low - padding, high + padding);
    Plot {
        marks,
        ..Plot::new(kind, title, "", [x, y], curves)
    }
}

fn orientation(measured: &Orientation) -> Plot {
    let turned = || measured.samples.iter();
    let scanline = turned()
        .filter_map(|turned| Some([turned.angle, turned.scanline?]))
        .collect();
    let barycentric = turned()
        .filter_map(|turned| Some([turned.angle, turned.barycentric?]))
        .collect();
    let curves = [
        Curve::new(text!("picture-curve-scanline"), scanline, Ink::L),
        Curve::new(text!("picture-curve-barycentric"), barycentric, Ink::N),
    ];
    let mark = Mark {
        x: measured.roll,
        label: text!("picture-curve-now").to_owned(),
        values: vec![],
        probe: true,
    };
    let x = Axis::degrees(text!("picture-axis-roll"), 0.0, 360.0);
    plot(
        PlotKind::Orientation,
        text!("picture-plot-orientation"),
        x,
        curves,
        mark,
    )
}

fn shared(measured: &SharedVertices) -> Plot {
    let points = |side: usize| {
        measured
            .samples
            .iter()
            .map(|sample| [sample[0], sample[side]])
            .collect()
    };
    let curves = [
        Curve::new(text!("picture-curve-with"), points(2), Ink::L),
        Curve::new(text!("picture-curve-without"), points(1), Ink::N),
    ];
    let mark = Mark {
        x: measured.vertex,
        label: text!("picture-curve-vertex").to_owned(),
        values: vec![],
        probe: false,
    };
    plot(
        PlotKind::SharedEdge,
        text!("picture-plot-shared"),
        Axis::new(text!("picture-axis-edge"), 0.0, 1.0),
        curves,
        mark,
    )
}
