//! Phong shading: normals carried linearly, made unit vectors at each pixel (Phong 1975).

use super::kernel::{Corner, Kernel, Linear, Shade, Span, linear};
use crate::scene::Rgb;
use glam::{DVec2, DVec3};

pub struct Phong<'a> {
    shade: &'a Shade,
    /// Normals are divided by the depth before they are carried: their direction is then linear in space.
    perspective: bool,
    carried: Linear<DVec3>,
    normal: DVec3,
}

impl<'a> Phong<'a> {
    pub fn new(shade: &'a Shade, perspective: bool) -> Self {
        Self { shade, perspective, carried: Linear::default(), normal: DVec3::ZERO }
    }
}

impl Kernel for Phong<'_> {
    fn begin_triangle(&mut self, triangle: &[Corner; 3]) {
        self.carried = carried(triangle, self.perspective);
    }

    fn begin_span(&mut self, span: &Span) {
        self.normal = self.carried.at(span.first);
    }

    fn pixel(&self, place: DVec2, key: f64) -> Rgb {
        self.shade.illuminate(place, key, self.normal.normalize_or_zero())
    }

    fn step(&mut self) {
        self.normal += self.carried.x;
    }

    fn evaluations_per_triangle(&self) -> u64 {
        0
    }

    fn evaluations_per_pixel(&self) -> u64 {
        1
    }
}

/// Normals as a linear function of the picture; only their directions count.
pub fn carried(triangle: &[Corner; 3], perspective: bool) -> Linear<DVec3> {
    let weight = |corner: &Corner| if perspective { corner.key } else { 1.0 };
    linear(triangle.map(|corner| corner.at), triangle.map(|corner| corner.normal * weight(&corner)))
}
