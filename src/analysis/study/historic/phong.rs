//! Phong shading: normals interpolated linearly and normalised at each pixel (Phong 1975).

use super::kernel::{Kernel, Linear, ScreenVertex, Shade, Span, carried};
use crate::scene::Rgb;
use glam::{DVec2, DVec3};

/// Phong shading: normals interpolated linearly and normalised at each pixel (Phong 1975).
pub struct Phong<'a> {
    shade: &'a Shade,
    perspective: bool,
    carried: Linear<DVec3>,
    normal: DVec3,
}

impl<'a> Phong<'a> {
    pub fn new(shade: &'a Shade) -> Self {
        Self {
            shade,
            perspective: shade.carried_in_perspective,
            carried: Linear::default(),
            normal: DVec3::ZERO,
        }
    }
}

impl<'a> Kernel<'a> for Phong<'a> {
    fn shade(&self) -> &'a Shade {
        self.shade
    }

    fn begin_triangle(&mut self, triangle: &[ScreenVertex; 3]) {
        self.carried = carried(triangle, self.perspective);
    }

    fn begin_span(&mut self, span: &Span) {
        self.normal = self.carried.at(span.first);
    }

    fn pixel(&self, place: DVec2, key: f64) -> Rgb {
        self.shade
            .illuminate(place, key, self.normal.normalize_or_zero())
    }

    fn step(&mut self) {
        self.normal += self.carried.x;
    }
}
