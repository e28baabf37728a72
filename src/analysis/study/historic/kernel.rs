//! What the methods share: the projected triangle, the point that a pixel sees, and the equation there.

use crate::illumination::{Equation, Real, V3};
use crate::scene::{Interpolation, Projection, Rgb, Scene, View};
use glam::{DVec2, DVec3};

/// A vertex in the picture.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// Pixels.
    pub at: DVec2,
    /// Linear in the picture over a flat polygon, the greater the nearer: 1/depth, or −depth without perspective.
    pub key: f64,
    /// Unit.
    pub normal: DVec3,
}

/// Where a scan line crosses an edge.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// Pixels.
    pub x: f64,
    /// The edge's ends, by their numbers in the triangle.
    pub from: usize,
    pub to: usize,
    /// The edge is divided in the ratio α : 1−α there.
    pub alpha: f64,
}

/// The part of a scan line inside a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    /// The centre of the first pixel.
    pub first: DVec2,
    pub ends: [Crossing; 2],
}

/// A way to find intensities along spans.
pub trait Kernel {
    fn begin_triangle(&mut self, triangle: &[Corner; 3]);
    fn begin_span(&mut self, span: &Span);
    /// The intensity at a pixel of the span whose key is `key`.
    fn pixel(&self, place: DVec2, key: f64) -> Rgb;
    /// Goes on to the pixel on the right.
    fn step(&mut self);
    /// Evaluations of the equation, or what stands for them, before the first pixel of a triangle.
    fn evaluations_per_triangle(&self) -> u64;
    /// Likewise at each pixel.
    fn evaluations_per_pixel(&self) -> u64;
}

/// A function that is linear in the picture: its value at a corner and its slopes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Linear<T> {
    pub origin: DVec2,
    pub value: T,
    pub x: T,
    pub y: T,
}

/// The slopes of a function with values `values` at `corners`.
pub fn linear<T>(corners: [DVec2; 3], values: [T; 3]) -> Linear<T>
where
    T: Copy + std::ops::Sub<Output = T> + std::ops::Mul<f64, Output = T>,
{
    let [a, b, c] = corners;
    let (u, v) = (b - a, c - a);
    let inverse = 1.0 / u.perp_dot(v);
    let (du, dv) = (values[1] - values[0], values[2] - values[0]);
    Linear {
        origin: a,
        value: values[0],
        x: du * (v.y * inverse) - dv * (u.y * inverse),
        y: dv * (u.x * inverse) - du * (v.x * inverse),
    }
}

impl<T: Copy + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>> Linear<T> {
    pub fn at(&self, place: DVec2) -> T {
        let from = place - self.origin;
        self.value + self.x * from.x + self.y * from.y
    }
}

/// The equation of a scene where pixels see it.
pub struct Shade {
    pub view: View,
    pub equation: Equation<f64>,
    perspective: bool,
    /// World units to one of the equation's.
    unit: f64,
}

impl Shade {
    pub fn new(scene: &Scene) -> Self {
        Self {
            view: View::new(&scene.camera, scene.image.size),
            equation: Equation::new(scene),
            perspective: scene.camera.projection == Projection::Perspective,
            unit: scene.camera.distance(),
        }
    }

    pub fn key_from_depth(&self, depth: f64) -> f64 {
        if self.perspective { 1.0 / depth } else { -depth }
    }

    /// The point seen at a place of the picture, given as offsets from its middle in pixels and a key: in the equation's
    /// frame, in any number type.
    pub fn position<R: Real<Scalar = f64>>(&self, [x, y]: [R; 2], key: R) -> V3<R> {
        let View { right, up, forward, scale, .. } = self.view;
        let axis = |axis: DVec3| V3::constant(x, axis.to_array());
        let one = x.constant(1.0);
        let depth = if self.perspective { one / key } else { -key };
        let across = axis(right).scale(x * (1.0 / scale)) - axis(up).scale(y * (1.0 / scale));
        let at =
            if self.perspective { (axis(forward) + across).scale(depth) } else { across + axis(forward).scale(depth) };
        at.scale(one * (1.0 / self.unit))
    }

    /// I with normal `n` at a pixel.
    // Compiled once, so that the times of two ways differ by what they do themselves.
    #[inline(never)]
    pub fn illuminate(&self, place: DVec2, key: f64, n: DVec3) -> Rgb {
        let offset = place - self.view.centre;
        let p: DVec3 = self.position([offset.x, offset.y], key).into();
        self.equation.illuminate_world(self.view.eye + p * self.unit, n, None)
    }
}

/// Whether values between vertices are linear in space and not in the picture.
pub fn carried_in_perspective(scene: &Scene) -> bool {
    scene.camera.projection == Projection::Perspective && scene.shading.interpolation == Interpolation::Perspective
}
