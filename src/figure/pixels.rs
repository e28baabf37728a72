//! A drawing as pixels, by tiny-skia.

use super::clip::{Run, can_be_filled, clipped};
use super::drawing::{Drawing, Shape, Text};
use super::labels::Area;
use super::palette::Rgb8;
use super::text::Lettering;
use crate::render::Frame;
use glam::DVec2;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, PixmapMut, Stroke, StrokeDash, Transform,
};

/// Letters are stroked by this share of their size, since the font is a light one.
const EMBOLDEN: f64 = 0.055;

impl Drawing {
    /// The drawing as a picture, a unit a pixel; nothing where it has no pixel or too many.
    pub fn to_frame(&self) -> Option<Frame> {
        let (width, height) = (self.size.x as u32, self.size.y as u32);
        let mut pixmap = Pixmap::new(width, height)?;
        self.draw(&mut pixmap.as_mut());
        // The ground is opaque, so that nothing is premultiplied.
        Some(Frame { width, height, pixels: pixmap.data().as_chunks::<4>().0.to_vec() })
    }

    /// Draws on a pixmap, a unit a pixel.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>) {
        if let Some([r, g, b]) = self.ground {
            pixmap.fill(Color::from_rgba8(r, g, b, 255));
        }
        for shape in self.painted() {
            draw_shape(pixmap, &shape);
        }
        for text in &self.texts {
            draw_text(pixmap, text, self.halo);
        }
    }

    /// Draws over a finished picture.
    pub fn draw_over(&self, frame: &mut Frame) {
        let (width, height) = (frame.width, frame.height);
        if let Some(mut pixmap) = PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height) {
            self.draw(&mut pixmap);
        }
    }
}

fn draw_text(pixmap: &mut PixmapMut<'_>, text: &Text, halo: Rgb8) {
    let lettering = Lettering::new(&text.text, text.size);
    let Some(path) = lettering.placed(text.at - DVec2::new(text.align * lettering.width, 0.0)) else { return };
    let bold = EMBOLDEN * text.size;
    for (colour, width) in [(halo, bold + 2.0 * text.halo), (text.colour, bold)] {
        let paint = paint(colour, 1.0);
        pixmap.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), None);
        pixmap.stroke_path(&path, &paint, &stroke(width, None), Transform::identity(), None);
    }
}

fn draw_shape(pixmap: &mut PixmapMut<'_>, shape: &Shape) {
    let paint = paint(shape.colour, shape.opacity);
    let window = window(pixmap, shape.width);
    if !shape.closed {
        for run in clipped(shape.points.iter().copied(), &window) {
            draw_run(pixmap, &run, shape, &paint);
        }
        return;
    }
    if !can_be_filled(&shape.points, &window) {
        return;
    }
    let Some(path) = polyline(&shape.points, true) else { return };
    if shape.fill {
        pixmap.fill_path(&path, &paint, FillRule::Winding, Transform::identity(), None);
    }
    if shape.width > 0.0 {
        pixmap.stroke_path(&path, &paint, &stroke(shape.width, None), Transform::identity(), None);
    }
}

fn draw_run(pixmap: &mut PixmapMut<'_>, run: &Run, shape: &Shape, paint: &Paint<'_>) {
    let Some(path) = polyline(&run.points, false) else { return };
    let lengths: Vec<f32> = shape.dashes.iter().map(|dash| dash * shape.width as f32).collect();
    let period = f64::from(lengths.iter().sum::<f32>());
    let offset = if period > 0.0 { run.start.rem_euclid(period) } else { 0.0 };
    let dash = StrokeDash::new(lengths, offset as f32);
    pixmap.stroke_path(&path, paint, &stroke(shape.width, dash), Transform::identity(), None);
}

/// The picture with room for a line of `width` whose middle runs outside.
fn window(pixmap: &PixmapMut<'_>, width: f64) -> Area {
    let margin = DVec2::splat(2.0 * width + 2.0);
    let size = DVec2::new(f64::from(pixmap.width()), f64::from(pixmap.height()));
    Area { min: -margin, max: size + margin }
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

    fn drawn(width: u32, height: u32, marks: &[Shape]) -> Pixmap {
        let mut pixmap = Pixmap::new(width, height).expect("not empty");
        let drawing = Drawing { shapes: marks.to_vec(), ..Drawing::over_picture([0, 0, 255], 2.0) };
        drawing.draw(&mut pixmap.as_mut());
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
        let pixmap = drawn(24, 10, &[Shape::line(line, 2.0, RED).dashed(&[2.0, 1.0])]);
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
            [Shape::line(line, 2.0, RED).dashed(&[4.5, 1.5])]
        };
        // A shift by whole periods of twelve pixels cannot be seen.
        assert_eq!(
            ascii(&drawn(64, 10, &marks(20.0))),
            ascii(&drawn(
                64,
                10,
                &[Shape { points: vec![DVec2::new(20.0 - 61.0, 5.0), DVec2::new(60.0, 5.0)], ..marks(0.0)[0].clone() },]
            ))
        );
    }

    #[test]
    fn a_line_that_leaves_and_returns_is_drawn_in_both_parts() {
        let points = [(5.0, 5.0), (5.0, -500.0), (35.0, -500.0), (35.0, 5.0)];
        let line = points.map(|(x, y)| DVec2::new(x, y)).to_vec();
        let pixmap = drawn(40, 10, &[Shape::line(line, 2.0, RED)]);
        let row = ascii(&pixmap).swap_remove(2);
        assert_eq!(row.matches("##").count(), 2, "{row}");
    }

    #[test]
    fn what_is_outside_leaves_no_trace() {
        let far = DVec2::new(1e6, -1e6);
        let marks = [
            Shape::ring(far, 10.0, 2.0, RED),
            Shape::line(vec![far, far * 2.0], 2.0, RED),
            Shape { width: 2.0, ..Shape::area(vec![far, far * 2.0, far + 1.0], RED) },
        ];
        assert!(drawn(20, 20, &marks).data().iter().all(|byte| *byte == 0));
    }
}
