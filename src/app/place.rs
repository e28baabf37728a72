//! Where the picture is on the screen.

use super::lines;
use eframe::egui::{Pos2, Rect, Ui, vec2};
use glam::DVec2;

/// Where the picture is on the screen, in points and in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub rect: Rect,
    /// In physical pixels.
    pub size: [u32; 2],
    pub pixels_per_point: f32,
}

impl Place {
    /// The whole pixels inside the space that `ui` has left.
    pub fn of(ui: &Ui) -> Self {
        let pixels_per_point = ui.ctx().pixels_per_point();
        let room = ui.available_rect_before_wrap();
        let min = vec2((room.min.x * pixels_per_point).ceil(), (room.min.y * pixels_per_point).ceil());
        let max = vec2((room.max.x * pixels_per_point).floor(), (room.max.y * pixels_per_point).floor());
        let size = (max - min).max(vec2(1.0, 1.0));
        let rect = Rect::from_min_size((min / pixels_per_point).to_pos2(), size / pixels_per_point);
        Self { rect, size: [size.x as u32, size.y as u32], pixels_per_point }
    }

    /// A point of the screen in the picture's pixels.
    pub fn pixel(&self, at: Pos2) -> DVec2 {
        let offset = (at - self.rect.min) * self.pixels_per_point;
        DVec2::new(f64::from(offset.x), f64::from(offset.y))
    }

    /// A point of the picture, in pixels, on the screen.
    pub fn point(&self, pixel: DVec2) -> Pos2 {
        self.rect.min + vec2(pixel.x as f32, pixel.y as f32) / self.pixels_per_point
    }

    /// The same in double precision, for lines that may reach far out of sight.
    pub fn exact_point(&self, pixel: DVec2) -> DVec2 {
        lines::exact(self.rect.min) + pixel / f64::from(self.pixels_per_point)
    }
}
