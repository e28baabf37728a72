//! A plot laid out: lines, areas and text with their places, for any device.

use super::Paper;
use crate::figure::ink::{Ink, Mark};
use crate::figure::palette::Rgb8;
use crate::figure::text::Lettering;
use crate::render::Frame as Picture;
use glam::DVec2;
use tiny_skia::{Color, Pixmap, PixmapMut};

/// Letters are set off from what they cross by so much, in their size.
pub(super) const HALO: f64 = 0.14;

/// A line or an area.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    pub points: Vec<DVec2>,
    /// Whether the area within is filled; its edge is then not drawn. Every point of an area is seen from its first one.
    pub fill: bool,
    /// Width of the line.
    pub width: f64,
    /// Lengths of dashes and gaps in turn, in widths; empty is solid.
    pub dashes: &'static [f32],
    pub colour: Rgb8,
    /// From 0 to 1.
    pub opacity: f64,
}

impl Shape {
    /// A solid line.
    pub(crate) fn line(points: Vec<DVec2>, width: f64, colour: Rgb8) -> Self {
        Self { points, fill: false, width, dashes: &[], colour, opacity: 1.0 }
    }

    /// A filled area.
    pub(crate) fn area(points: Vec<DVec2>, colour: Rgb8) -> Self {
        Self { fill: true, ..Self::line(points, 0.0, colour) }
    }

    /// A disc.
    pub(crate) fn disc(centre: DVec2, radius: f64, colour: Rgb8) -> Self {
        Self::area(Mark::dot(centre, radius, colour).points, colour)
    }

    pub(crate) fn dashed(self, dashes: &'static [f32]) -> Self {
        Self { dashes, ..self }
    }
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// It may have subscript digits and ⁿ, which fonts may lack.
    pub text: String,
    /// A point of the baseline.
    pub at: DVec2,
    /// Which part of the text's width lies left of that point: 0, 0.5 or 1.
    pub align: f64,
    /// Units an em.
    pub size: f64,
    pub colour: Rgb8,
    pub strong: bool,
    /// Whether it may stand on lines and is to be set off from them.
    pub halo: bool,
}

impl Text {
    /// Text that begins at `at`.
    pub fn new(text: impl Into<String>, at: DVec2, size: f64, colour: Rgb8) -> Self {
        Self { text: text.into(), at, align: 0.0, size, colour, strong: false, halo: false }
    }

    /// Its width.
    pub fn width(&self) -> f64 {
        width_of(&self.text, self.size)
    }

    /// The same with its middle (0.5) or its end (1) there.
    pub(crate) fn aligned(self, align: f64) -> Self {
        Self { align, ..self }
    }
}

/// The width of a line of text.
pub(crate) fn width_of(text: &str, size: f64) -> f64 {
    Lettering::new(text, size).width
}

/// From values to places and back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Frame {
    Cartesian {
        min: DVec2,
        max: DVec2,
        x: [f64; 2],
        y: [f64; 2],
    },
    /// x is an angle in degrees clockwise from above; `scale` is the length of 1.
    Polar {
        centre: DVec2,
        radius: f64,
        scale: f64,
    },
}

impl Frame {
    /// Where a value is drawn.
    pub fn place(&self, [x, y]: [f64; 2]) -> DVec2 {
        match self {
            Self::Cartesian { min, max, x: [x0, x1], y: [y0, y1] } => DVec2::new(
                min.x + (x - x0) / (x1 - x0) * (max.x - min.x),
                max.y - (y - y0) / (y1 - y0) * (max.y - min.y),
            ),
            Self::Polar { centre, scale, .. } => {
                let (sine, cosine) = x.to_radians().sin_cos();
                *centre + DVec2::new(sine, -cosine) * (y * scale)
            }
        }
    }

    /// The x of a place inside the plot.
    fn x_at(&self, place: DVec2) -> Option<f64> {
        match self {
            Self::Cartesian { min, max, x: [x0, x1], .. } => {
                let inside = place.cmpge(*min).all() && place.cmple(*max).all();
                inside.then(|| x0 + (place.x - min.x) / (max.x - min.x) * (x1 - x0))
            }
            Self::Polar { centre, radius, .. } => {
                let way = place - *centre;
                (way.length() <= *radius && way.y <= 0.0).then(|| way.x.atan2(-way.y).to_degrees())
            }
        }
    }
}

/// A drawing of one plot or several.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    pub size: DVec2,
    pub ground: Rgb8,
    /// The later over the earlier, and the texts over all.
    pub shapes: Vec<Shape>,
    pub texts: Vec<Text>,
    /// One a plot that had room.
    pub(super) frames: Vec<Frame>,
}

impl Drawing {
    pub(crate) fn new(size: DVec2, paper: &Paper) -> Self {
        Self { size, ground: paper.ground, shapes: vec![], texts: vec![], frames: vec![] }
    }

    /// x at a place inside the first plot.
    pub fn x_at(&self, place: DVec2) -> Option<f64> {
        self.frames.first()?.x_at(place)
    }

    /// The place of a value of the first plot, and the line that marks its x there: from the axis to the far side.
    pub fn place(&self, value: [f64; 2]) -> Option<(DVec2, [DVec2; 2])> {
        let frame = self.frames.first()?;
        let line = match frame {
            Frame::Cartesian { y: [low, high], .. } => [*low, *high],
            Frame::Polar { radius, scale, .. } => [0.0, radius / scale],
        };
        Some((frame.place(value), line.map(|y| frame.place([value[0], y]))))
    }

    /// The drawing as a picture, a unit a pixel; nothing where it has no pixel or too many.
    pub fn to_frame(&self) -> Option<Picture> {
        let (width, height) = (self.size.x as u32, self.size.y as u32);
        let mut pixmap = Pixmap::new(width, height)?;
        self.draw(&mut pixmap.as_mut());
        // The ground is opaque, so that nothing is premultiplied.
        Some(Picture { width, height, pixels: pixmap.data().as_chunks::<4>().0.to_vec() })
    }

    /// Draws on a pixmap, a unit a pixel.
    pub fn draw(&self, pixmap: &mut PixmapMut<'_>) {
        let [r, g, b] = self.ground;
        pixmap.fill(Color::from_rgba8(r, g, b, 255));
        let mut ink = Ink { pixmap, halo: self.ground, breadth: 0.0 };
        let marks: Vec<Mark> = self.shapes.iter().map(mark).collect();
        ink.marks(&marks);
        for text in &self.texts {
            let lettering = Lettering::new(&text.text, text.size);
            let origin = text.at - DVec2::new(text.align * lettering.width, 0.0);
            ink.breadth = if text.halo { HALO * text.size } else { 0.0 };
            ink.line_of_text(&lettering, text.size, origin, text.colour);
        }
    }
}

fn mark(shape: &Shape) -> Mark {
    Mark {
        points: shape.points.clone(),
        closed: shape.fill,
        fill: shape.fill,
        width: shape.width,
        dashes: shape.dashes,
        colour: shape.colour,
        opacity: shape.opacity,
        halo: false,
    }
}
