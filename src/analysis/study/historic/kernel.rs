//! What the methods share: triangles on the screen, spans of pixels, and the equation at what a pixel sees.

use crate::illumination::{Equation, Real, V3};
use crate::scene::{Interpolation, Projection, Reflection, Rgb, Scene, View};
use glam::{DVec2, DVec3};
use std::ops::{Add, Mul, Sub};

/// A corner of a triangle in the picture.
#[derive(Clone, Copy, Debug)]
pub struct ScreenVertex {
    /// Position in the picture, pixels.
    pub at: DVec2,
    /// Depth key, linear in the picture over a flat polygon: 1/depth, or −depth without perspective; nearer is larger.
    pub key: f64,
    /// Unit normal.
    pub normal: DVec3,
}

/// A crossing of a scan line and an edge.
#[derive(Clone, Copy, Debug)]
pub struct Crossing {
    /// x of the crossing, pixels.
    pub x: f64,
    /// The edge's ends, by their numbers in the triangle.
    pub from: usize,
    pub to: usize,
    /// Parameter along the edge, which is divided there in the ratio α : 1−α.
    pub alpha: f64,
}

/// The part of a scan line inside a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Span {
    /// Centre of the first pixel.
    pub first: DVec2,
    pub ends: [Crossing; 2],
}

/// Returns the crossings at which the line at `y` enters and leaves a triangle; an edge lacks its lower end.
pub fn crossings(corners: [DVec2; 3], y: f64) -> Option<[Crossing; 2]> {
    let mut crossed = (0..3).filter_map(|from| {
        let to = (from + 1) % 3;
        let (a, b) = (corners[from], corners[to]);
        let alpha = (y - a.y) / (b.y - a.y);
        ((a.y <= y) != (b.y <= y)).then_some(Crossing {
            x: a.x + alpha * (b.x - a.x),
            from,
            to,
            alpha,
        })
    });
    let (p, q) = (crossed.next()?, crossed.next()?);
    Some(if p.x <= q.x { [p, q] } else { [q, p] })
}

/// A function that is linear in the picture: its value at a corner and its slopes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Linear<T> {
    pub origin: DVec2,
    pub value: T,
    pub x: T,
    pub y: T,
}

/// Returns the function that has the given values at the corners.
pub fn linear<T>(corners: &[ScreenVertex; 3], value: impl Fn(&ScreenVertex) -> T) -> Linear<T>
where
    T: Copy + Sub<Output = T> + Mul<f64, Output = T>,
{
    let [a, b, c] = corners;
    let (u, v) = (b.at - a.at, c.at - a.at);
    let inverse = 1.0 / u.perp_dot(v);
    let origin = value(a);
    let (du, dv) = (value(b) - origin, value(c) - origin);
    Linear {
        origin: a.at,
        value: origin,
        x: du * (v.y * inverse) - dv * (u.y * inverse),
        y: dv * (u.x * inverse) - du * (v.x * inverse),
    }
}

impl<T: Copy + Add<Output = T> + Mul<f64, Output = T>> Linear<T> {
    pub fn at(&self, place: DVec2) -> T {
        let from = place - self.origin;
        self.value + self.x * from.x + self.y * from.y
    }
}

/// Returns normals as a linear function of the picture; divided by the depth they are linear in space.
pub fn carried(triangle: &[ScreenVertex; 3], perspective: bool) -> Linear<DVec3> {
    linear(triangle, |corner| {
        corner.normal * if perspective { corner.key } else { 1.0 }
    })
}

/// Returns whether values between vertices are linear in space and not in the picture.
pub fn carried_in_perspective(scene: &Scene) -> bool {
    scene.camera.projection == Projection::Perspective
        && scene.shading.interpolation == Interpolation::Perspective
}

/// The equation of a scene at the points that pixels see.
pub struct Shade {
    pub view: View,
    pub equation: Equation<f64>,
    pub perspective: bool,
    /// True if values between vertices are linear in space and not in the picture.
    pub carried_in_perspective: bool,
    pub reflection: Reflection,
    pub n: f64,
    /// World units per unit of the equation.
    pub unit: f64,
}

impl Shade {
    pub fn new(scene: &Scene) -> Self {
        Self {
            view: View::new(&scene.camera, scene.image.size),
            equation: Equation::new(scene),
            perspective: scene.camera.projection == Projection::Perspective,
            carried_in_perspective: carried_in_perspective(scene),
            reflection: scene.reflection.clone(),
            n: scene.material.n,
            unit: scene.camera.distance(),
        }
    }

    /// Returns the point seen at an offset from the picture's middle, pixels, with a key: in the equation's frame.
    pub fn position<R: Real<Scalar = f64>>(&self, [x, y]: [R; 2], key: R) -> V3<R> {
        let View {
            right,
            up,
            forward,
            scale,
            ..
        } = self.view;
        let axis = |axis: DVec3| V3::constant(x, axis.to_array());
        let one = x.constant(1.0);
        let depth = if self.perspective { one / key } else { -key };
        let across = axis(right).scale(x * (1.0 / scale)) - axis(up).scale(y * (1.0 / scale));
        let at = if self.perspective {
            (axis(forward) + across).scale(depth)
        } else {
            across + axis(forward).scale(depth)
        };
        at.scale(one * (1.0 / self.unit))
    }

    /// Returns I with normal `n` at a pixel.
    // Compiled once, so that the times of two methods differ only by their own work.
    #[inline(never)]
    pub fn illuminate(&self, place: DVec2, key: f64, n: DVec3) -> Rgb {
        let offset = place - self.view.centre;
        let p: DVec3 = self.position([offset.x, offset.y], key).into();
        self.equation
            .illuminate_world(self.view.eye + p * self.unit, n, None)
    }
}

/// A method of finding intensities along spans.
pub trait Kernel<'a> {
    /// True if the equation is evaluated at each pixel instead of once per triangle.
    const PER_PIXEL: bool = true;

    fn shade(&self) -> &'a Shade;
    fn begin_triangle(&mut self, triangle: &[ScreenVertex; 3]);
    fn begin_span(&mut self, span: &Span);
    /// Returns the intensity at a pixel of the span whose key is `key`.
    fn pixel(&self, place: DVec2, key: f64) -> Rgb;
    /// Advances to the pixel on the right.
    fn step(&mut self);
}
