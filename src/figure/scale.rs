//! Where a plot draws its values.

use glam::DVec2;

/// From values to places and back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Scale {
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

impl Scale {
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
    pub fn x_at(&self, place: DVec2) -> Option<f64> {
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
