//! Drawings as plain geometry: lines, areas and texts with their positions, for any device.

use super::area::{Area, clipped};
use super::palette::Rgb8;
use super::text::{Lettering, width_of};
use glam::DVec2;
use std::borrow::Cow;
use std::sync::LazyLock;

/// Corners of the polygon drawn as a circle: off by less than a tenth of a pixel at the largest radius.
const CIRCLE_CORNERS: u32 = 96;

/// A line or an area.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Corners, units of the drawing.
    pub points: Vec<DVec2>,
    /// True if the last point is joined to the first.
    pub closed: bool,
    /// True if the area within is filled. All of it must be visible from its first point.
    pub fill: bool,
    /// Width of the line; of an area, that of its rounded edge.
    pub width: f64,
    /// Lengths of alternating dashes and gaps, in widths; empty is solid.
    pub dashes: &'static [f32],
    /// Colour as stored: red, green and blue.
    pub colour: Rgb8,
    /// Opacity from 0 to 1.
    pub opacity: f64,
    /// True if it has the drawing's halo.
    pub halo: bool,
}

impl Shape {
    /// Creates a solid line.
    pub fn line(points: Vec<DVec2>, width: f64, colour: Rgb8) -> Self {
        Self {
            points,
            closed: false,
            fill: false,
            width,
            dashes: &[],
            colour,
            opacity: 1.0,
            halo: true,
        }
    }

    /// Creates a closed line.
    pub fn outline(points: Vec<DVec2>, width: f64, colour: Rgb8) -> Self {
        Self {
            closed: true,
            ..Self::line(points, width, colour)
        }
    }

    /// Creates a filled area.
    pub fn area(points: Vec<DVec2>, colour: Rgb8) -> Self {
        Self {
            fill: true,
            ..Self::outline(points, 0.0, colour)
        }
    }

    /// Creates a circle's outline.
    pub fn ring(centre: DVec2, radius: f64, width: f64, colour: Rgb8) -> Self {
        static CORNERS: LazyLock<Vec<DVec2>> = LazyLock::new(|| {
            let step = std::f64::consts::TAU / f64::from(CIRCLE_CORNERS);
            (0..CIRCLE_CORNERS)
                .map(|i| DVec2::from_angle(f64::from(i) * step))
                .collect()
        });
        Self::outline(
            CORNERS
                .iter()
                .map(|corner| centre + radius * *corner)
                .collect(),
            width,
            colour,
        )
    }

    /// Creates a filled circle.
    pub fn disc(centre: DVec2, radius: f64, colour: Rgb8) -> Self {
        Self {
            fill: true,
            ..Self::ring(centre, radius, 0.0, colour)
        }
    }

    /// Creates the triangle at the end of an arrow.
    pub fn arrow_head(tip: DVec2, along: DVec2, length: f64, colour: Rgb8) -> Self {
        let (base, side) = (tip - along * length, along.perp() * 0.4 * length);
        Self::area(vec![tip, base + side, base - side], colour)
    }

    /// Creates the shaft and the head of an arrow in the direction `along`.
    pub fn arrow(
        [tail, tip]: [DVec2; 2],
        along: DVec2,
        width: f64,
        head: f64,
        colour: Rgb8,
    ) -> [Self; 2] {
        let shaft = vec![tail, tip - along * 0.85 * head];
        [
            Self::line(shaft, width, colour),
            Self::arrow_head(tip, along, head, colour),
        ]
    }

    /// Sets dashes, in line widths.
    pub fn dashed(self, dashes: &'static [f32]) -> Self {
        Self { dashes, ..self }
    }

    /// Sets the opacity.
    pub fn faded(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    /// Removes the halo.
    pub fn plain(self) -> Self {
        Self {
            halo: false,
            ..self
        }
    }
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The text. It may have subscript digits and ⁿ, which fonts may lack.
    pub text: String,
    /// A point of the baseline.
    pub at: DVec2,
    /// Share of the text's width to the left of that point: 0, 0.5 or 1.
    pub align: f64,
    /// Size in units per em.
    pub size: f64,
    /// Colour as stored: red, green and blue.
    pub colour: Rgb8,
    /// True if its strokes are thickened.
    pub strong: bool,
    /// Width of its halo, 0 for none.
    pub halo: f64,
}

impl Text {
    /// Creates text that begins at `at`.
    pub fn new(text: impl Into<String>, at: DVec2, size: f64, colour: Rgb8) -> Self {
        Self {
            text: text.into(),
            at,
            align: 0.0,
            size,
            colour,
            strong: false,
            halo: 0.0,
        }
    }

    /// Creates text with the middle of its ink at `centre`.
    pub fn centred(text: &str, centre: DVec2, size: f64, colour: Rgb8) -> Self {
        let lettering = Lettering::new(text, size);
        Self::new(
            text,
            centre - (lettering.min + lettering.max) * 0.5,
            size,
            colour,
        )
    }

    /// Returns its width.
    pub fn width(&self) -> f64 {
        width_of(&self.text, self.size)
    }

    /// Aligns the text with its middle (0.5) or its end (1) at its point.
    pub fn aligned(self, align: f64) -> Self {
        Self { align, ..self }
    }

    /// Sets the width of the halo.
    pub(crate) fn haloed(self, halo: f64) -> Self {
        Self { halo, ..self }
    }

    /// Makes the text bold.
    pub fn bold(self) -> Self {
        Self {
            strong: true,
            ..self
        }
    }
}

/// The mapping from a plot's values to the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Scale {
    Cartesian {
        min: DVec2,
        max: DVec2,
        x: [f64; 2],
        y: [f64; 2],
    },
    /// Polar axes: x is an angle in degrees clockwise from above; `scale` is the length of 1.
    Polar {
        centre: DVec2,
        radius: f64,
        scale: f64,
    },
}

impl Scale {
    /// Returns the position of a value.
    pub fn place(&self, [x, y]: [f64; 2]) -> DVec2 {
        match self {
            Self::Cartesian {
                min,
                max,
                x: [x0, x1],
                y: [y0, y1],
            } => DVec2::new(
                min.x + (x - x0) / (x1 - x0) * (max.x - min.x),
                max.y - (y - y0) / (y1 - y0) * (max.y - min.y),
            ),
            Self::Polar { centre, scale, .. } => {
                let (sine, cosine) = x.to_radians().sin_cos();
                *centre + DVec2::new(sine, -cosine) * (y * scale)
            }
        }
    }
}

/// Lines, areas and texts, on a background of their own or over a picture.
///
/// ```
/// use shading_lab::figure::{Drawing, Shape, Text};
/// use shading_lab::glam::DVec2;
///
/// let mut drawing = Drawing::new(DVec2::new(60.0, 40.0), [255; 3]);
/// drawing.shapes.push(Shape::disc(DVec2::new(20.0, 20.0), 12.0, [200, 40, 40]));
/// drawing.texts.push(Text::new("N", DVec2::new(40.0, 24.0), 12.0, [0; 3]));
/// assert!(drawing.to_svg("a disc").contains("N"));
/// let frame = drawing.to_frame().expect("it is small enough");
/// assert_eq!(frame.pixel(20, 20), Some([200, 40, 40]));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Width and height, in the units of its shapes.
    pub size: DVec2,
    /// Background colour; none over a picture.
    pub ground: Option<Rgb8>,
    /// The colour of all halos.
    pub halo: Rgb8,
    /// Maximum width of the halos of shapes: thin lines have narrower ones.
    pub breadth: f64,
    /// The shapes, the later over the earlier, and the texts over all.
    pub shapes: Vec<Shape>,
    /// The texts.
    pub texts: Vec<Text>,
    /// One scale for each plot that fit.
    pub(crate) scales: Vec<Scale>,
}

impl Drawing {
    /// Creates an empty sheet.
    pub fn new(size: DVec2, ground: Rgb8) -> Self {
        Self {
            size,
            ground: Some(ground),
            ..Self::over_picture(ground, 0.0)
        }
    }

    /// Creates an empty drawing over a picture, with halos of a colour and a width.
    pub fn over_picture(halo: Rgb8, breadth: f64) -> Self {
        Self {
            size: DVec2::ZERO,
            ground: None,
            halo,
            breadth,
            shapes: vec![],
            texts: vec![],
            scales: vec![],
        }
    }

    /// Returns the shapes as they are painted: all halos first, so that lines that meet join and do not cut one
    /// another.
    pub fn painted(&self) -> impl Iterator<Item = Cow<'_, Shape>> {
        let haloed = self
            .shapes
            .iter()
            .filter(|shape| shape.halo && self.breadth > 0.0);
        let halos = haloed.map(|shape| {
            let breadth = if shape.fill {
                self.breadth
            } else {
                self.breadth.min(0.9 * shape.width)
            };
            let width = shape.width + 2.0 * breadth;
            Cow::Owned(Shape {
                width,
                dashes: &[],
                colour: self.halo,
                ..shape.clone()
            })
        });
        halos.chain(self.shapes.iter().map(Cow::Borrowed))
    }

    /// Draws a curve over the first plot within its axes; points that are not finite interrupt it, and a single point is a
    /// dot.
    pub fn draw_curve(
        &mut self,
        points: impl IntoIterator<Item = [f64; 2]>,
        width: f64,
        colour: Rgb8,
        opacity: f64,
    ) {
        let Some(scale @ Scale::Cartesian { min, max, .. }) = self.scales.first().copied() else {
            return;
        };
        let area = Area { min, max };
        let places: Vec<DVec2> = points.into_iter().map(|point| scale.place(point)).collect();
        for part in places.split(|place| !place.is_finite()) {
            if let [only] = *part
                && area.nearest(only) == only
            {
                self.shapes
                    .push(Shape::disc(only, width, colour).faded(opacity));
            }
            for run in clipped(part.iter().copied(), &area) {
                self.shapes
                    .push(Shape::line(run.points, width, colour).faded(opacity));
            }
        }
    }

    /// Returns x at a position inside the first plot.
    pub fn x_at(&self, place: DVec2) -> Option<f64> {
        match self.scales.first()? {
            Scale::Cartesian { min, max, .. } => {
                let inside = place.cmpge(*min).all() && place.cmple(*max).all();
                self.value_near(place).filter(|_| inside).map(|[x, _]| x)
            }
            Scale::Polar { centre, radius, .. } => {
                let way = place - *centre;
                (way.length() <= *radius && way.y <= 0.0).then(|| way.x.atan2(-way.y).to_degrees())
            }
        }
    }

    /// Returns x and y at the point of the first plot that is nearest to `place`; none for a polar plot.
    pub fn value_near(&self, place: DVec2) -> Option<[f64; 2]> {
        let Scale::Cartesian {
            min,
            max,
            x: [x0, x1],
            y: [y0, y1],
        } = self.scales.first()?
        else {
            return None;
        };
        let share = (place.clamp(*min, *max) - *min) / (*max - *min);
        Some([x0 + share.x * (x1 - x0), y1 - share.y * (y1 - y0)])
    }

    /// Returns the position of a value of the first plot, and the line across the plot that marks its x.
    pub fn place(&self, value: [f64; 2]) -> Option<(DVec2, [DVec2; 2])> {
        let scale = self.scales.first()?;
        let line = match scale {
            Scale::Cartesian { y: [low, high], .. } => [*low, *high],
            Scale::Polar { radius, scale, .. } => [0.0, radius / scale],
        };
        Some((scale.place(value), line.map(|y| scale.place([value[0], y]))))
    }
}
