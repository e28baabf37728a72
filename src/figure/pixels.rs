//! A drawing as pixels, by tiny-skia.

use super::area::{Area, can_be_filled, clipped};
use super::drawing::{Drawing, Shape, Text};
use super::palette::Rgb8;
use super::text::Lettering;
use crate::render::Frame;
use glam::DVec2;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, PixmapMut, Stroke,
    StrokeDash, Transform,
};

/// Stroke width of letters as a share of their size, since the font is a light one.
const EMBOLDEN: f64 = 0.055;

impl Drawing {
    /// Returns the drawing as a picture, one pixel per unit; none if it has no pixels or too many.
    pub fn to_frame(&self) -> Option<Frame> {
        let (width, height) = (self.size.x as u32, self.size.y as u32);
        let mut pixmap = Pixmap::new(width, height)?;
        self.draw(&mut pixmap.as_mut());
        // The background is opaque, so that nothing is premultiplied.
        Some(Frame {
            width,
            height,
            pixels: pixmap.data().as_chunks::<4>().0.to_vec(),
        })
    }

    /// Draws on a pixmap, one pixel per unit.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>) {
        if let Some([r, g, b]) = self.ground {
            pixmap.fill(Color::from_rgba8(r, g, b, 255));
        }
        self.painted().for_each(|shape| draw_shape(pixmap, &shape));
        self.texts
            .iter()
            .for_each(|text| draw_text(pixmap, text, self.halo));
    }

    /// Draws over a finished picture.
    pub fn draw_over(&self, frame: &mut Frame) {
        let (width, height) = (frame.width, frame.height);
        if let Some(mut pixmap) =
            PixmapMut::from_bytes(frame.pixels.as_flattened_mut(), width, height)
        {
            self.draw(&mut pixmap);
        }
    }
}

fn draw_text(pixmap: &mut PixmapMut<'_>, text: &Text, halo: Rgb8) {
    let lettering = Lettering::new(&text.text, text.size);
    let Some(path) = lettering.placed(text.at - DVec2::new(text.align * lettering.width, 0.0))
    else {
        return;
    };
    let bold = EMBOLDEN * text.size;
    for (colour, width) in [(halo, bold + 2.0 * text.halo), (text.colour, bold)] {
        let paint = paint(colour, 1.0);
        fill(pixmap, &path, &paint);
        stroke(pixmap, &path, &paint, width, None);
    }
}

fn draw_shape(pixmap: &mut PixmapMut<'_>, shape: &Shape) {
    let paint = paint(shape.colour, shape.opacity);
    // The picture with a margin for a line whose middle is outside.
    let margin = 2.0 * shape.width + 2.0;
    let size = DVec2::new(f64::from(pixmap.width()), f64::from(pixmap.height()));
    let window = Area::from_size(size).inset(-margin);
    if shape.closed {
        let points = Some(&shape.points).filter(|points| can_be_filled(points, &window));
        let Some(path) = points.and_then(|points| polyline(points, true)) else {
            return;
        };
        if shape.fill {
            fill(pixmap, &path, &paint);
        }
        if shape.width > 0.0 {
            stroke(pixmap, &path, &paint, shape.width, None);
        }
        return;
    }
    let lengths: Vec<f32> = shape
        .dashes
        .iter()
        .map(|dash| dash * shape.width as f32)
        .collect();
    let period = f64::from(lengths.iter().sum::<f32>());
    for run in clipped(shape.points.iter().copied(), &window) {
        let Some(path) = polyline(&run.points, false) else {
            continue;
        };
        let offset = if period > 0.0 {
            run.start.rem_euclid(period)
        } else {
            0.0
        };
        stroke(
            pixmap,
            &path,
            &paint,
            shape.width,
            StrokeDash::new(lengths.clone(), offset as f32),
        );
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

fn fill(pixmap: &mut PixmapMut<'_>, path: &Path, paint: &Paint<'_>) {
    pixmap.fill_path(path, paint, FillRule::Winding, Transform::identity(), None);
}

fn stroke(
    pixmap: &mut PixmapMut<'_>,
    path: &Path,
    paint: &Paint<'_>,
    width: f64,
    dash: Option<StrokeDash>,
) {
    let line_cap = if dash.is_some() {
        LineCap::Butt
    } else {
        LineCap::Round
    };
    let stroke = Stroke {
        width: width as f32,
        dash,
        line_cap,
        line_join: LineJoin::Round,
        ..Stroke::default()
    };
    pixmap.stroke_path(path, paint, &stroke, Transform::identity(), None);
}
