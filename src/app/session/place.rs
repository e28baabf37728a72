//! Positions in the picture: on the screen, and relative to the picture so that they stay at the same place of the
//! scene when the window is resized.

use crate::app::widgets::lines;
use crate::scene::{View, pixel_to_place};
use eframe::egui::{Pos2, Rect, Ui, vec2};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

/// The position of the picture on the screen, in points and in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    pub rect: Rect,
    /// Size in physical pixels.
    pub size: [u32; 2],
    pub pixels_per_point: f32,
}

impl Place {
    /// Returns the area of whole pixels inside the space that `ui` has left.
    pub fn of(ui: &Ui) -> Self {
        let pixels_per_point = ui.ctx().pixels_per_point();
        let room = ui.available_rect_before_wrap();
        let min = (room.min.to_vec2() * pixels_per_point).ceil();
        let max = (room.max.to_vec2() * pixels_per_point).floor();
        let size = (max - min).max(vec2(1.0, 1.0));
        let rect = Rect::from_min_size((min / pixels_per_point).to_pos2(), size / pixels_per_point);
        Self {
            rect,
            size: [size.x as u32, size.y as u32],
            pixels_per_point,
        }
    }

    /// Converts a point of the screen to the picture's pixels.
    pub fn pixel(&self, at: Pos2) -> DVec2 {
        let offset = (at - self.rect.min) * self.pixels_per_point;
        DVec2::new(f64::from(offset.x), f64::from(offset.y))
    }

    /// Converts a point of the picture, in pixels, to the screen.
    pub fn point(&self, pixel: DVec2) -> Pos2 {
        self.rect.min + vec2(pixel.x as f32, pixel.y as f32) / self.pixels_per_point
    }

    /// Converts a point of the screen to the picture's pixels, as [`Place::pixel`] does, in double precision.
    pub fn exact_pixel(&self, at: DVec2) -> DVec2 {
        (at - lines::exact(self.rect.min)) * f64::from(self.pixels_per_point)
    }

    /// Converts a point of the picture to the screen, as [`Place::point`] does, in double precision, for lines that may
    /// reach far out of sight.
    pub fn exact_point(&self, pixel: DVec2) -> DVec2 {
        lines::exact(self.rect.min) + pixel / f64::from(self.pixels_per_point)
    }

    /// Returns where a point of the world is on the screen; `None` if the viewer cannot see that way, see [`View::project`].
    pub fn seen(&self, view: &View, world: DVec3) -> Option<Pos2> {
        Some(self.point(view.project(world)?.0))
    }

    /// Returns where a point of the world is on the screen, as [`Place::seen`] does, in double precision.
    pub fn exact_seen(&self, view: &View, world: DVec3) -> Option<DVec2> {
        Some(self.exact_point(view.project(world)?.0))
    }
}

/// Returns the shorter side of a picture, at least 1 pixel.
fn shorter(size: [u32; 2]) -> f64 {
    f64::from(size[0].min(size[1]).max(1))
}

/// Returns the sides of a picture, each at least 1 pixel.
fn at_least_one(size: [u32; 2]) -> DVec2 {
    DVec2::from_array(size.map(|side| f64::from(side.max(1))))
}

/// Converts a point of a picture of `size` pixels, clamped to the picture, to an offset from its middle in units of its
/// shorter side.
pub fn from_pixel(pixel: DVec2, size: [u32; 2]) -> DVec2 {
    let size = at_least_one(size);
    pixel_to_place(pixel.clamp(DVec2::ZERO, size), size)
}

/// The position of the probe, relative to the picture's middle in units of its shorter side, so that the probe stays at
/// the same place of the scene when the window is resized.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProbePoint(pub DVec2);

impl Default for ProbePoint {
    fn default() -> Self {
        Self(DVec2::new(0.11, -0.13))
    }
}

impl ProbePoint {
    /// Returns the probe's pixel in a picture of `size` pixels, clamped to the picture.
    pub fn pixel(self, size: [u32; 2]) -> [u32; 2] {
        let ([width, height], unit) = (size.map(f64::from), shorter(size));
        let inside = |value: f64, side: u32| {
            value.floor().clamp(0.0, f64::from(side.saturating_sub(1))) as u32
        };
        [
            inside(self.0.x * unit + width * 0.5, size[0]),
            inside(self.0.y * unit + height * 0.5, size[1]),
        ]
    }

    /// Returns the centre of the probe's pixel in a picture of `size` pixels.
    pub fn centre(self, size: [u32; 2]) -> DVec2 {
        let [x, y] = self.pixel(size).map(f64::from);
        DVec2::new(x + 0.5, y + 0.5)
    }

    /// Returns the probe at the centre of `pixel`, its `x` and `y`, in a picture of `size` pixels.
    pub fn at(pixel: [u32; 2], size: [u32; 2]) -> Self {
        let centre = DVec2::from_array(pixel.map(|value| f64::from(value) + 0.5));
        Self(pixel_to_place(centre, at_least_one(size)))
    }

    /// Returns the probe moved by whole pixels, but not past the picture's edge.
    pub fn moved(self, by: [i32; 2], size: [u32; 2]) -> Self {
        let [x, y] = self.pixel(size);
        let step = |value: u32, by: i32, side: u32| {
            value.saturating_add_signed(by).min(side.saturating_sub(1))
        };
        Self::at([step(x, by[0], size[0]), step(y, by[1], size[1])], size)
    }
}

/// The line of the profile: both ends relative to the picture's middle in units of its shorter side, like the probe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProfileLine(pub [DVec2; 2]);

impl Default for ProfileLine {
    fn default() -> Self {
        Self([DVec2::new(-0.4, 0.06), DVec2::new(0.4, 0.06)])
    }
}

impl ProfileLine {
    /// Returns both ends in a picture of `size` pixels, clamped to the picture.
    pub fn pixels(self, size: [u32; 2]) -> [DVec2; 2] {
        let unit = shorter(size);
        let size = DVec2::from_array(size.map(f64::from));
        self.0
            .map(|end| (end * unit + 0.5 * size).clamp(DVec2::ZERO, size))
    }

    /// Moves an end to a point of a picture of `size` pixels.
    pub fn put(&mut self, end: usize, pixel: DVec2, size: [u32; 2]) {
        if let Some(end) = self.0.get_mut(end) {
            *end = from_pixel(pixel, size);
        }
    }
}

/// Rounds `v` to the decimal place below `step`, so that no digits are shown that the user did not intend.
pub fn tidy(v: DVec3, step: f64) -> DVec3 {
    let unit = 10f64.powf(step.max(1e-12).log10().floor());
    // Multiplying by a negative power of ten leaves trailing digits; dividing by the positive one does not.
    if unit < 1.0 {
        (v * (1.0 / unit).round()).round() / (1.0 / unit).round()
    } else {
        (v / unit).round() * unit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_probe_returns_to_its_pixel_and_stays_in_the_picture() {
        for size in [[1, 1], [640, 480], [33, 1001]] {
            for pixel in [
                [0, 0],
                [size[0] - 1, size[1] - 1],
                [size[0] / 2, size[1] / 3],
            ] {
                assert_eq!(ProbePoint::at(pixel, size).pixel(size), pixel);
            }
        }
        let size = [10, 10];
        assert_eq!(
            ProbePoint::at([0, 9], size)
                .moved([-1, 1], size)
                .pixel(size),
            [0, 9]
        );
        assert_eq!(
            ProbePoint::at([0, 9], size)
                .moved([3, -2], size)
                .pixel(size),
            [3, 7]
        );
        assert_eq!(ProbePoint::default().pixel([0, 0]), [0, 0]);
    }
}
