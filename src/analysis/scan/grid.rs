//! The grid of enlarged pixels: part of the picture, magnified about one polygon.

use glam::DVec2;
use serde::Serialize;

/// Rows and columns left free on each side of the polygon.
const MARGIN: f64 = 1.0;
/// Widths of polygons in their heights that are shown as they are. Others are stretched to the nearest of them, along with
/// their pixels, which changes neither α nor any value.
const SHAPES: [f64; 2] = [0.5, 1.6];
/// Polygons whose area is less than this part of the square of their extent are lines but for roundings.
const EDGE_ON: f64 = 1e-10;

/// Enlarged pixels: (0, 0) is the top left one, the centre of (x, y) is (x + 0.5, y + 0.5).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Grid {
    pub columns: u32,
    pub rows: u32,
    /// Pixels of the grid to one of the picture, across and down; the same unless the polygon is very long.
    pub scale: DVec2,
    /// The place of the picture that is the grid's corner, pixels.
    pub origin: DVec2,
}

impl Grid {
    /// A grid of `rows` rows in whose middle a polygon is as large as fits; nothing for one that is seen edge-on.
    pub(super) fn around(places: &[DVec2], rows: u32) -> Option<Self> {
        let (min, max) = places.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(a, b), p| (a.min(*p), b.max(*p)));
        let extent = max - min;
        let flat = area(places).abs() <= EDGE_ON * extent.length_squared();
        if flat || !extent.is_finite() {
            return None;
        }
        let height = f64::from(rows) - 2.0 * MARGIN;
        let width = height * (extent.x / extent.y).clamp(SHAPES[0], SHAPES[1]);
        let scale = DVec2::new(width, height) / extent;
        let size = DVec2::new((width + 2.0 * MARGIN).ceil(), f64::from(rows));
        let origin = (min + max) * 0.5 - size * 0.5 / scale;
        scale.is_finite().then_some(Self { columns: size.x as u32, rows, scale, origin })
    }

    /// A place of the grid in the picture, pixels.
    pub fn to_picture(&self, place: DVec2) -> DVec2 {
        place / self.scale + self.origin
    }

    /// A place of the picture in the grid.
    pub fn from_picture(&self, pixel: DVec2) -> DVec2 {
        (pixel - self.origin) * self.scale
    }
}

/// The area of a polygon, positive where its corners run clockwise on the screen.
pub(super) fn area(places: &[DVec2]) -> f64 {
    let Some(&first) = places.first() else { return 0.0 };
    places.windows(2).map(|pair| (pair[0] - first).perp_dot(pair[1] - first)).sum::<f64>() * 0.5
}
