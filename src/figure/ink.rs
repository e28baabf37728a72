//! Strokes, areas and letters on a pixmap, each set off from the picture by a halo.
//!
//! All halos are laid down before any colour, so that lines that meet grow together instead of cutting one another.

use super::palette::Rgb8;
use super::text::Lettering;
use glam::DVec2;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, PixmapMut, Stroke, StrokeDash, Transform,
};

/// Letters are stroked by this share of their size, since the font is a light one.
const EMBOLDEN: f64 = 0.055;
/// Corners of the polygon that stands for a circle: at the largest radius in use it is off by less than a tenth pixel.
const CIRCLE_CORNERS: u32 = 96;

/// A line or an area, in pixels.
#[derive(Clone, Debug)]
pub(super) struct Mark {
    pub points: Vec<DVec2>,
    pub closed: bool,
    pub fill: bool,
    /// Width of the line; for an area that of its rounded edge.
    pub width: f64,
    /// In widths; empty is solid.
    pub dashes: &'static [f32],
    pub colour: Rgb8,
    /// From 0 to 1.
    pub opacity: f64,
    /// Whether a halo surrounds it.
    pub halo: bool,
}

impl Mark {
    /// A solid line through `points`.
    pub fn line(points: Vec<DVec2>, width: f64, colour: Rgb8) -> Self {
        Self { points, closed: false, fill: false, width, dashes: &[], colour, opacity: 1.0, halo: true }
    }

    /// An area with rounded corners.
    pub fn area(points: Vec<DVec2>, width: f64, colour: Rgb8) -> Self {
        Self { closed: true, fill: true, ..Self::line(points, width, colour) }
    }

    /// A circle's outline.
    pub fn ring(centre: DVec2, radius: f64, width: f64, colour: Rgb8) -> Self {
        let step = std::f64::consts::TAU / f64::from(CIRCLE_CORNERS);
        let points = (0..CIRCLE_CORNERS).map(|i| centre + radius * DVec2::from_angle(f64::from(i) * step)).collect();
        Self { closed: true, ..Self::line(points, width, colour) }
    }

    /// A filled circle.
    pub fn dot(centre: DVec2, radius: f64, colour: Rgb8) -> Self {
        Self { fill: true, ..Self::ring(centre, radius, 0.0, colour) }
    }

    /// The same with dashes, in line widths.
    pub fn dashed(self, dashes: &'static [f32]) -> Self {
        Self { dashes, ..self }
    }

    /// The same, partly transparent.
    pub fn faded(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }
}

/// A pixmap and the halo's colour and breadth on every side.
pub(super) struct Ink<'a, 'b> {
    pub pixmap: &'a mut PixmapMut<'b>,
    pub halo: Rgb8,
    /// At most; a thin line has less.
    pub breadth: f64,
}

impl Ink<'_, '_> {
    /// Draws the marks, the later ones on top, above the halos of all.
    pub fn marks(&mut self, marks: &[Mark]) {
        for mark in marks.iter().filter(|mark| mark.halo) {
            let breadth = if mark.fill { self.breadth } else { self.breadth.min(0.9 * mark.width) };
            let halo = self.halo;
            self.mark(&Mark { width: mark.width + 2.0 * breadth, dashes: &[], colour: halo, ..mark.clone() });
        }
        for mark in marks {
            self.mark(mark);
        }
    }

    /// Draws text of `size` pixels an em in the middle of `centre`.
    pub fn text(&mut self, lettering: &Lettering, size: f64, centre: DVec2, colour: Rgb8) {
        let Some(path) = lettering.centred(centre) else { return };
        let bold = EMBOLDEN * size;
        for (colour, width) in [(self.halo, bold + 2.0 * self.breadth), (colour, bold)] {
            let paint = paint(colour, 1.0);
            self.pixmap.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), None);
            self.pixmap.stroke_path(&path, &paint, &stroke(width, None), Transform::identity(), None);
        }
    }

    fn mark(&mut self, mark: &Mark) {
        let paint = paint(mark.colour, mark.opacity);
        if mark.closed {
            let Some(path) = self.outline(mark) else { return };
            if mark.fill {
                self.pixmap.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), None);
            }
            if mark.width > 0.0 {
                self.pixmap.stroke_path(&path, &paint, &stroke(mark.width, None), Transform::identity(), None);
            }
            return;
        }
        let mut travelled = 0.0;
        let mut run = Vec::new();
        let mut run_start = 0.0;
        for ends in mark.points.windows(2) {
            let &[a, b] = ends else { continue };
            if let Some((from, to)) = self.visible(a, b, mark.width) {
                if run.last() != Some(&from) {
                    self.run(&run, run_start, mark, &paint);
                    run = vec![from];
                    run_start = travelled + (from - a).length();
                }
                run.push(to);
            }
            travelled += (b - a).length();
        }
        self.run(&run, run_start, mark, &paint);
    }

    /// Strokes a connected visible part of a line that begins `start` pixels along it.
    fn run(&mut self, points: &[DVec2], start: f64, mark: &Mark, paint: &Paint<'_>) {
        let Some(path) = polyline(points, false) else { return };
        let lengths: Vec<f32> = mark.dashes.iter().map(|dash| dash * mark.width as f32).collect();
        let period = f64::from(lengths.iter().sum::<f32>());
        let offset = if period > 0.0 { start.rem_euclid(period) } else { 0.0 };
        let dash = StrokeDash::new(lengths, offset as f32);
        self.pixmap.stroke_path(&path, paint, &stroke(mark.width, dash), Transform::identity(), None);
    }

    /// The path of a closed mark, if any of it can be seen.
    fn outline(&self, mark: &Mark) -> Option<Path> {
        let (low, high) = self.window(mark.width);
        let min = mark.points.iter().copied().reduce(DVec2::min)?;
        let max = mark.points.iter().copied().reduce(DVec2::max)?;
        let seen = min.cmple(high).all() && max.cmpge(low).all();
        // An area that dwarfs the picture is one that perspective blew up beyond meaning.
        let sane = (max - min).cmple((high - low) * 4.0).all();
        if seen && sane { polyline(&mark.points, true) } else { None }
    }

    /// The part of the segment from `a` to `b` that a line of `width` may show (Liang and Barsky 1984).
    fn visible(&self, a: DVec2, b: DVec2, width: f64) -> Option<(DVec2, DVec2)> {
        let (low, high) = self.window(width);
        let along = b - a;
        let (mut enter, mut leave) = (0.0f64, 1.0f64);
        for axis in 0..2 {
            if along[axis] == 0.0 {
                if a[axis] < low[axis] || a[axis] > high[axis] {
                    return None;
                }
                continue;
            }
            let (t, u) = ((low[axis] - a[axis]) / along[axis], (high[axis] - a[axis]) / along[axis]);
            enter = enter.max(t.min(u));
            leave = leave.min(t.max(u));
        }
        let at = |t: f64| {
            if t <= 0.0 {
                a
            } else if t >= 1.0 {
                b
            } else {
                a + along * t
            }
        };
        (enter <= leave && along.is_finite()).then(|| (at(enter), at(leave)))
    }

    /// The picture with room for a line of `width` whose middle runs outside.
    fn window(&self, width: f64) -> (DVec2, DVec2) {
        let margin = DVec2::splat(2.0 * width + 2.0);
        (-margin, DVec2::new(f64::from(self.pixmap.width()), f64::from(self.pixmap.height())) + margin)
    }
}

fn polyline(points: &[DVec2], closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    let (first, rest) = points.split_first()?;
    builder.move_to(first.x as f32, first.y as f32);
    for point in rest {
        builder.line_to(point.x as f32, point.y as f32);
    }
    if closed {
        builder.close();
    }
    builder.finish()
}

fn paint(colour: Rgb8, opacity: f64) -> Paint<'static> {
    let [r, g, b] = colour;
    let mut paint = Paint::default();
    let mut colour = Color::from_rgba8(r, g, b, 255);
    colour.apply_opacity(opacity.clamp(0.0, 1.0) as f32);
    paint.set_color(colour);
    paint
}

fn stroke(width: f64, dash: Option<StrokeDash>) -> Stroke {
    let line_cap = if dash.is_some() { LineCap::Butt } else { LineCap::Round };
    Stroke { width: width as f32, dash, line_cap, line_join: LineJoin::Round, ..Stroke::default() }
}
