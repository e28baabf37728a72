//! The vectors of one light seen from the side as a drawing of its own, with the steps that construct R and H.

use super::equation::{Angle, Equation, Focus, draw_point, draw_right_angle};
use super::side::{Frame, draw_surface, view};
use crate::analysis::overlay::{Halo, OverlayOptions, Sketch, Style};
use crate::analysis::probe::ConstructionStep;
use crate::analysis::probe::products::Here;
use crate::figure::palette::{Rgb8, Vector, readable};
use crate::figure::{Area, Drawing, PlotStyle, Shape};
use crate::text::fixed;
use glam::{DVec2, DVec3};

/// Margins about the vectors for their letters, in ems: beside, above and below.
const MARGIN: [f64; 3] = [2.4, 1.6, 1.0];
/// Extent of the surface beside and below the point, in unit vectors.
const SURFACE: [f64; 2] = [0.74, 0.15];
/// Size of the letters relative to plots, and width of a step's lines relative to an arrow.
const LETTERS: f64 = 1.15;
const STRONG: f64 = 1.9;
/// Dashes of the line from the end of L to N.
const DASHES: &[f32] = &[4.0, 3.0];
/// Minimum contrast of lines and of letters with their background.
const CONTRAST: [f64; 2] = [3.0, 4.5];

/// Contents of the drawing of the vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VectorsShown {
    /// The vectors and the angles between them.
    #[default]
    Angles,
    /// One step of the construction of R and H.
    Step(ConstructionStep),
    /// The whole construction.
    Construction,
}

impl VectorsShown {
    fn vector(self, vector: Vector) -> bool {
        use ConstructionStep::{Across, Cosine, Halfway, Mirror, Projection};
        match self {
            Self::Angles | Self::Construction => true,
            Self::Step(Cosine | Projection | Across) => matches!(vector, Vector::N | Vector::L),
            Self::Step(Mirror) => matches!(vector, Vector::N | Vector::L | Vector::R),
            Self::Step(Halfway) => matches!(vector, Vector::L | Vector::V | Vector::H),
        }
    }

    fn angles(self) -> &'static [Angle] {
        match self {
            Self::Angles => &[Angle::Mirror, Angle::Theta, Angle::Phi, Angle::Alpha],
            Self::Step(ConstructionStep::Cosine) => &[Angle::Theta],
            Self::Step(ConstructionStep::Mirror) => &[Angle::Mirror, Angle::Theta],
            Self::Step(_) | Self::Construction => &[],
        }
    }

    /// Returns whether the lines of a step are shown.
    fn has(self, step: ConstructionStep) -> bool {
        match self {
            Self::Angles => false,
            Self::Construction => step != ConstructionStep::Cosine,
            Self::Step(own) => own == step,
        }
    }
}

/// Draws N, L, R, V, H and T of a light at the probed point, seen from the side, in a drawing of that `width`; none
/// where there is no such light or no direction. Letters lie inside the drawing and do not overlap.
pub fn draw_vectors(
    here: Here<'_>,
    light: usize,
    shown: VectorsShown,
    width: f64,
    style: &PlotStyle,
) -> Option<Drawing> {
    let options = OverlayOptions {
        light: Some(light),
        half_vector: true,
        ..OverlayOptions::default()
    };
    let equation = Equation::new(here.hit, here.scene, &options);
    let (focus, v) = (equation.focus.as_ref()?, here.hit.view.try_normalize()?);
    if focus.n == DVec3::ZERO || !focus.terms.l.is_finite() {
        return None;
    }
    let paper = style.paper;
    let letters = Style {
        neutral: paper.text,
        halo_colour: paper.ground,
        ..Style::of_text(LETTERS * style.text, Halo::Light)
    };
    let vectors = [focus.n, focus.terms.l, v];
    // H lies in the plane of L and V, which seldom is that of N.
    let halfway = shown == VectorsShown::Step(ConstructionStep::Halfway);
    let up = focus.terms.h.try_normalize().filter(|_| halfway);
    let up = up.unwrap_or(focus.n);
    let seen_from = |origin, unit| view(Frame { origin, unit }, up, [focus.terms.l, v]);
    // As large as the width allows, but not taller than wide.
    let through = here.hit.transmission.and_then(|through| through.t);
    let all = vectors
        .into_iter()
        .chain([focus.terms.r, focus.terms.h])
        .chain(through);
    let flat = seen_from(DVec2::ZERO, 1.0);
    let [mut aside, mut below] = SURFACE;
    for vector in all.filter(|vector| vector.is_finite()) {
        aside = aside.max(vector.dot(flat.right).abs());
        below = below.max(-vector.dot(flat.up));
    }
    let margin = MARGIN.map(|margin| margin * letters.text);
    let unit = ((0.5 * width - margin[0]) / aside)
        .min((width - margin[1] - margin[2]) / (1.0 + below))
        .max(letters.text);
    let size = DVec2::new(width, margin[1] + (1.0 + below) * unit + margin[2]);
    let pane = Area::from_size(size);
    let view = seen_from(DVec2::new(0.5 * width, margin[1] + unit), unit);
    let mut sketch = Sketch::new(view, letters, pane, DVec3::ZERO, 1.0)?;
    if !halfway {
        draw_surface(&mut sketch, focus.n);
    }
    let surfaces = sketch.shapes.len();
    draw_lines(&mut sketch, focus, shown);
    equation.draw_vectors(&mut sketch, false, |vector| shown.vector(vector));
    draw_point(&mut sketch);
    equation.draw_angles(&mut sketch, focus, shown.angles());
    draw_steps(&mut sketch, focus, here.hit.normal.length(), v, shown);
    let labels = sketch.labels(&[]);
    let mut drawing = Drawing::new(size, paper.ground);
    let texts = labels.iter().map(|label| label.to_text(letters.halo));
    drawing.texts = texts.collect();
    drawing.shapes = sketch.shapes;
    let fit = |colour: &mut Rgb8, contrast| *colour = readable(*colour, paper.ground, contrast);
    for shape in drawing.shapes.iter_mut().skip(surfaces) {
        fit(&mut shape.colour, CONTRAST[0]);
    }
    for text in &mut drawing.texts {
        fit(&mut text.colour, CONTRAST[1]);
    }
    Some(drawing)
}

/// Returns whether a step before that of H is shown, for which L is projected onto N.
fn projects(focus: &Focus<'_>, shown: VectorsShown) -> bool {
    match shown {
        VectorsShown::Angles | VectorsShown::Step(ConstructionStep::Halfway) => false,
        VectorsShown::Step(ConstructionStep::Cosine) => true,
        VectorsShown::Step(_) | VectorsShown::Construction => focus.lit,
    }
}

/// Draws the lines under the arrows: from the end of L to N's line, and from L to V.
fn draw_lines(sketch: &mut Sketch, focus: &Focus<'_>, shown: VectorsShown) {
    let (n, l) = (focus.n, focus.terms.l);
    if projects(focus, shown) {
        let foot = n * n.dot(l);
        thin(sketch, [l, foot]);
        thin(sketch, [DVec3::ZERO, foot]);
        draw_right_angle(sketch, n, l, foot);
    }
}

/// Draws the additions of the steps shown, with their letters.
fn draw_steps(sketch: &mut Sketch, focus: &Focus<'_>, length: f64, v: DVec3, shown: VectorsShown) {
    use ConstructionStep::{Across, Cosine, Halfway, Mirror, Projection};
    let (l, r) = (focus.terms.l, focus.terms.r);
    // N as given, which may be shorter than 1.
    let n = focus.n * length;
    let foot = n * n.dot(l);
    let (colour, neutral) = (Vector::N.colour(), sketch.style.neutral);
    if projects(focus, shown) {
        if shown.has(Cosine) {
            let line = sketch.ends([DVec3::ZERO, foot]);
            let width = STRONG * sketch.style.line;
            let line = line.map(|ends| Shape::line(ends, width, colour));
            sketch.shapes.extend(line);
            let text = format!("N·L = {}", fixed(n.dot(l), 3));
            letter(sketch, text, colour, 0.5 * foot, -l);
        }
        let steps = [Projection, Across, Mirror];
        if steps.into_iter().any(|step| shown.has(step)) {
            arrow(sketch, [DVec3::ZERO, foot], STRONG, colour);
            letter(sketch, "N(N·L)".into(), colour, 0.5 * foot, r - foot);
        }
        if shown.has(Across) || shown.has(Mirror) {
            arrow(sketch, [l, foot], 1.0, neutral);
            letter(sketch, "S".into(), neutral, 0.5 * (l + foot), n);
        }
        if shown.has(Mirror) {
            arrow(sketch, [foot, r], 1.0, neutral);
            letter(sketch, "S".into(), neutral, 0.5 * (foot + r), n);
        }
    }
    if shown.has(Halfway) && (l + v).length() > 1e-9 {
        let middle = 0.5 * (l + v);
        thin(sketch, [l, v]);
        if let Some(at) = sketch.end(middle) {
            let dot = Shape::disc(at, 1.3 * sketch.style.line, Vector::H.colour());
            sketch.shapes.push(dot);
        }
        letter(sketch, "(L + V)/2".into(), neutral, middle, -middle);
    }
}

/// Draws a thin dashed line.
fn thin(sketch: &mut Sketch, ends: [DVec3; 2]) {
    let (width, colour) = (0.5 * sketch.style.line, sketch.style.neutral);
    let line = sketch
        .ends(ends)
        .map(|points| Shape::line(points, width, colour).dashed(DASHES));
    sketch.shapes.extend(line);
}

/// Draws an arrow, its width relative to that of the vectors.
fn arrow(sketch: &mut Sketch, ends: [DVec3; 2], width: f64, colour: Rgb8) {
    let [Some(from), Some(to)] = ends.map(|end| sketch.end(end)) else {
        return;
    };
    let Some(along) = (to - from).try_normalize() else {
        return;
    };
    let style = sketch.style;
    let head = (style.head * width.sqrt()).min(0.6 * (to - from).length());
    let arrow = Shape::arrow([from, to], along, width * style.line, head, colour);
    sketch.shapes.extend(arrow);
}

/// Requests a label beside the end of `at`, towards `aside`.
fn letter(sketch: &mut Sketch, text: String, colour: Rgb8, at: DVec3, aside: DVec3) {
    let Some(anchor) = sketch.end(at) else { return };
    let end = sketch.end(at + aside).unwrap_or(anchor);
    let towards = (end - anchor).normalize_or_zero();
    let clearance = 0.35 * sketch.style.text;
    sketch.letter(text, 0.9, colour, anchor, towards, clearance);
}
