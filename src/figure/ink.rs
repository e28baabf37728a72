//! Strokes, areas and letters on a pixmap, each set off from the picture by a halo.
//!
//! All halos are laid down before any colour, so that lines that meet grow together instead of cutting one another.

use super::Area;
use super::clip::{Run, can_be_filled, clipped};
use super::palette::Rgb8;
use super::text::Lettering;
use glam::DVec2;
use std::sync::LazyLock;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, PixmapMut, Stroke, StrokeDash, Transform,
};

/// Letters are stroked by this share of their size, since the font is a light one.
const EMBOLDEN: f64 = 0.055;
/// Corners of the polygon that stands for a circle: at the largest radius in use it is off by less than a tenth pixel.
const CIRCLE_CORNERS: u32 = 96;

/// A line or an area, in pixels.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mark {
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
        static CORNERS: LazyLock<Vec<DVec2>> = LazyLock::new(|| {
            let step = std::f64::consts::TAU / f64::from(CIRCLE_CORNERS);
            (0..CIRCLE_CORNERS).map(|i| DVec2::from_angle(f64::from(i) * step)).collect()
        });
        let points = CORNERS.iter().map(|corner| centre + radius * *corner).collect();
        Self { closed: true, ..Self::line(points, width, colour) }
    }

    /// A filled circle.
    pub fn dot(centre: DVec2, radius: f64, colour: Rgb8) -> Self {
        Self { fill: true, ..Self::ring(centre, radius, 0.0, colour) }
    }

    /// The triangle at the end of an arrow.
    pub fn arrow_head(tip: DVec2, along: DVec2, length: f64, colour: Rgb8) -> Self {
        let (base, side) = (tip - along * length, along.perp() * 0.4 * length);
        Self::area(vec![tip, base + side, base - side], 0.0, colour)
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
pub(crate) struct Ink<'a, 'b> {
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
        self.letters(lettering.centred(centre), size, colour);
    }

    /// Draws text of `size` pixels an em whose baseline begins at `origin`.
    pub fn line_of_text(&mut self, lettering: &Lettering, size: f64, origin: DVec2, colour: Rgb8) {
        self.letters(lettering.placed(origin), size, colour);
    }

    fn letters(&mut self, outline: Option<Path>, size: f64, colour: Rgb8) {
        let Some(path) = outline else { return };
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
        for run in clipped(mark.points.iter().copied(), &self.window(mark.width)) {
            self.run(&run, mark, &paint);
        }
    }

    fn run(&mut self, run: &Run, mark: &Mark, paint: &Paint<'_>) {
        let Some(path) = polyline(&run.points, false) else { return };
        let lengths: Vec<f32> = mark.dashes.iter().map(|dash| dash * mark.width as f32).collect();
        let period = f64::from(lengths.iter().sum::<f32>());
        let offset = if period > 0.0 { run.start.rem_euclid(period) } else { 0.0 };
        let dash = StrokeDash::new(lengths, offset as f32);
        self.pixmap.stroke_path(&path, paint, &stroke(mark.width, dash), Transform::identity(), None);
    }

    /// The path of a closed mark, if any of it can be seen.
    fn outline(&self, mark: &Mark) -> Option<Path> {
        if can_be_filled(&mark.points, &self.window(mark.width)) { polyline(&mark.points, true) } else { None }
    }

    /// The picture with room for a line of `width` whose middle runs outside.
    fn window(&self, width: f64) -> Area {
        let margin = DVec2::splat(2.0 * width + 2.0);
        let size = DVec2::new(f64::from(self.pixmap.width()), f64::from(self.pixmap.height()));
        Area { min: -margin, max: size + margin }
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

#[cfg(test)]
mod tests {
    use super::*;
    use tiny_skia::Pixmap;

    const RED: Rgb8 = [255, 0, 0];

    fn drawn(width: u32, height: u32, marks: &[Mark]) -> Pixmap {
        let mut pixmap = Pixmap::new(width, height).expect("not empty");
        Ink { pixmap: &mut pixmap.as_mut(), halo: [0, 0, 255], breadth: 2.0 }.marks(marks);
        pixmap
    }

    /// `#` the mark's colour, `+` the halo's, `.` neither; what covers less than half a pixel counts as nothing.
    fn ascii(pixmap: &Pixmap) -> Vec<String> {
        let symbol = |p: &tiny_skia::PremultipliedColorU8| match (p.red() > 127, p.blue() > 127) {
            (true, _) => '#',
            (false, true) => '+',
            (false, false) => '.',
        };
        pixmap.pixels().chunks(pixmap.width() as usize).map(|row| row.iter().map(symbol).collect()).collect()
    }

    #[test]
    fn a_dashed_line_lies_in_one_halo() {
        let line = vec![DVec2::new(4.0, 5.0), DVec2::new(20.0, 5.0)];
        let pixmap = drawn(24, 10, &[Mark::line(line, 2.0, RED).dashed(&[2.0, 1.0])]);
        let expected = [
            "........................",
            "........................",
            "...++++++++++++++++++...",
            "..++++++++++++++++++++..",
            ".+++####++####++####+++.",
            ".+++####++####++####+++.",
            "..++++++++++++++++++++..",
            "...++++++++++++++++++...",
            "........................",
            "........................",
        ];
        assert_eq!(ascii(&pixmap), expected);
    }

    #[test]
    fn a_line_from_far_outside_keeps_its_dashes_in_step() {
        let marks = |x: f64| {
            let line = vec![DVec2::new(x - 90_001.0, 5.0), DVec2::new(x + 40.0, 5.0)];
            [Mark::line(line, 2.0, RED).dashed(&[4.5, 1.5])]
        };
        // A shift by whole periods of twelve pixels cannot be seen.
        assert_eq!(
            ascii(&drawn(64, 10, &marks(20.0))),
            ascii(&drawn(
                64,
                10,
                &[Mark { points: vec![DVec2::new(20.0 - 61.0, 5.0), DVec2::new(60.0, 5.0)], ..marks(0.0)[0].clone() },]
            ))
        );
    }

    #[test]
    fn a_line_that_leaves_and_returns_is_drawn_in_both_parts() {
        let points = [(5.0, 5.0), (5.0, -500.0), (35.0, -500.0), (35.0, 5.0)];
        let line = points.map(|(x, y)| DVec2::new(x, y)).to_vec();
        let pixmap = drawn(40, 10, &[Mark::line(line, 2.0, RED)]);
        let row = ascii(&pixmap).swap_remove(2);
        assert_eq!(row.matches("##").count(), 2, "{row}");
    }

    #[test]
    fn what_is_outside_leaves_no_trace() {
        let far = DVec2::new(1e6, -1e6);
        let marks = [
            Mark::ring(far, 10.0, 2.0, RED),
            Mark::line(vec![far, far * 2.0], 2.0, RED),
            Mark::area(vec![far, far * 2.0, far + 1.0], 2.0, RED),
        ];
        assert!(drawn(20, 20, &marks).data().iter().all(|byte| *byte == 0));
    }
}
