//! Kuijk and Blake, "Faster Phong shading via angular interpolation", Computer Graphics Forum 8 (1989).
//!
//! Normals turn by equal angles along the edges and then along the span: N(i+1) = 2·cos Δ·N(i) − N(i−1), of unit length
//! without a root. Equal angles are equal steps in the picture, so that this is affine by construction.

use super::kernel::{Crossing, Kernel, ScreenVertex, Shade, Span};
use crate::geometry::angle;
use crate::scene::Rgb;
use glam::{DVec2, DVec3};

/// Sine below which two normals count as one: the arc between them is its chord to 10⁻¹².
const SAME: f64 = 1e-6;

/// Angular interpolation: normals turn by equal angles, along the edges and along the span.
pub struct Angular<'a> {
    shade: &'a Shade,
    normals: [DVec3; 3],
    /// The normals at this pixel and at the one on the left.
    normal: DVec3,
    before: DVec3,
    /// `2·cos Δ`, where Δ is the angle from pixel to pixel.
    twice_cosine: f64,
}

impl<'a> Angular<'a> {
    pub fn new(shade: &'a Shade) -> Self {
        Self {
            shade,
            normals: [DVec3::Z; 3],
            normal: DVec3::Z,
            before: DVec3::Z,
            twice_cosine: 2.0,
        }
    }
}

impl<'a> Kernel<'a> for Angular<'a> {
    fn shade(&self) -> &'a Shade {
        self.shade
    }

    fn begin_triangle(&mut self, triangle: &[ScreenVertex; 3]) {
        self.normals = triangle.map(|corner| corner.normal.normalize_or(DVec3::Z));
    }

    fn begin_span(&mut self, span: &Span) {
        let end = |crossing: &Crossing| {
            turned(
                self.normals[crossing.from],
                self.normals[crossing.to],
                crossing.alpha,
            )
        };
        let (left, right) = (end(&span.ends[0]), end(&span.ends[1]));
        let width = span.ends[1].x - span.ends[0].x;
        let t = (span.first.x - span.ends[0].x) / width;
        self.normal = turned(left, right, t);
        self.before = turned(left, right, t - 1.0 / width);
        self.twice_cosine = 2.0 * (angle(left, right) / width).cos();
    }

    fn pixel(&self, place: DVec2, key: f64) -> Rgb {
        self.shade.illuminate(place, key, self.normal)
    }

    fn step(&mut self) {
        let next = self.normal * self.twice_cosine - self.before;
        self.before = std::mem::replace(&mut self.normal, next);
    }
}

/// Returns the unit vector on the great circle from `a` to `b`, at `t` times their angle (Shoemake 1985).
fn turned(a: DVec3, b: DVec3, t: f64) -> DVec3 {
    let angle = angle(a, b);
    let sine = angle.sin();
    if sine < SAME {
        return a.lerp(b, t).normalize_or(a);
    }
    (a * ((1.0 - t) * angle).sin() + b * (t * angle).sin()) / sine
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    /// Compares a span across a cylinder: its true normals turn in one plane by equal angles.
    #[test]
    fn on_a_great_circle_angular_normals_are_exact() {
        let shade = Shade::new(&Scene::default());
        let normal = |angle: f64| DVec3::new(angle.sin(), 0.0, angle.cos());
        let corner = |x: f64, y: f64, turn: f64| ScreenVertex {
            at: DVec2::new(x, y),
            key: 0.25,
            normal: normal(turn),
        };
        let mut kernel = Angular::new(&shade);
        kernel.begin_triangle(&[
            corner(0.0, 0.0, -0.9),
            corner(40.0, 0.0, 1.1),
            corner(0.0, 40.0, -0.9),
        ]);
        let left = Crossing {
            x: 0.0,
            from: 2,
            to: 0,
            alpha: 1.0,
        };
        let right = Crossing {
            x: 40.0,
            from: 0,
            to: 1,
            alpha: 1.0,
        };
        kernel.begin_span(&Span {
            first: DVec2::new(0.5, 0.0),
            ends: [left, right],
        });
        for pixel in 0..40 {
            let expected = normal(-0.9 + 2.0 * (f64::from(pixel) + 0.5) / 40.0);
            assert!(
                kernel.normal.distance(expected) < 1e-12,
                "pixel {pixel}: {} is not {expected}",
                kernel.normal
            );
            kernel.step();
        }
        assert!(
            turned(DVec3::Y, DVec3::Y, 0.3).distance(DVec3::Y) < 1e-15,
            "equal normals stay as they are"
        );
    }
}
