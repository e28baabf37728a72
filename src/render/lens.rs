//! The camera in the kernels' units: lengths in camera distances, positions relative to the eye.

use crate::scene::{Camera, Projection, View};
use glam::{DVec2, DVec3};

/// The near plane's distance from the eye, in camera distances; anything nearer is clipped away.
pub const NEAR: f64 = 1e-3;

/// The distance from the eye, in camera distances, beyond which points are lit as if at this distance: squares must not overflow.
pub const FARTHEST: f64 = 1e12;

/// The farthest that the object reaches from the eye, in camera distances. Where eye and target are so near to each other
/// that it would reach farther, a camera distance is longer than their distance. Lights beside the object then still differ
/// from lights at infinity, and anything nearer than [`NEAR`] is less than single precision resolves of the object.
pub const DEEPEST: f64 = 1e8;

pub fn pixel_centre(x: usize, y: usize) -> DVec2 {
    DVec2::new(x as f64 + 0.5, y as f64 + 0.5)
}

/// The projection of one picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    pub eye: DVec3,
    /// World units to one camera distance.
    pub unit: f64,
    /// The unit vectors of the picture, world.
    pub right: DVec3,
    pub up: DVec3,
    pub forward: DVec3,
    pub perspective: bool,
    /// Pixels to one camera distance, at depth 1 in a perspective projection.
    pub focal: f64,
    /// The point where the viewing direction meets the picture, pixels.
    pub middle: DVec2,
}

impl Lens {
    /// Creates the lens for `size` pixels whose samples lie `offset` pixels from the centres; a camera distance is `unit`
    /// world units.
    pub fn new(camera: &Camera, size: [u32; 2], offset: DVec2, unit: f64) -> Self {
        let View {
            eye,
            right,
            up,
            forward,
            centre,
            scale,
            projection,
        } = View::new(camera, size);
        let perspective = projection == Projection::Perspective;
        let focal = if perspective { scale } else { scale * unit };
        Self {
            eye,
            unit,
            right,
            up,
            forward,
            perspective,
            focal,
            middle: centre - offset,
        }
    }

    /// Returns the right, up and forward components of a world point, camera distances.
    pub fn view_from_world(&self, world: DVec3) -> DVec3 {
        let p = (world - self.eye) / self.unit;
        DVec3::new(p.dot(self.right), p.dot(self.up), p.dot(self.forward))
    }

    /// Projects a point given by its view components to the picture, pixels.
    pub fn picture_from_view(&self, view: DVec3) -> DVec2 {
        let scale = if self.perspective {
            self.focal / view.z
        } else {
            self.focal
        };
        DVec2::new(
            self.middle.x + view.x * scale,
            self.middle.y - view.y * scale,
        )
    }

    /// Returns the depth key at a distance along the viewing direction: linear in the picture over a flat polygon, larger
    /// if nearer.
    pub fn key_from_depth(&self, depth: f64) -> f64 {
        if self.perspective {
            1.0 / depth
        } else {
            -depth
        }
    }

    pub fn depth_from_key(&self, key: f64) -> f64 {
        if self.perspective { 1.0 / key } else { -key }
    }

    /// Returns the ray through a point in the picture, relative to the eye: point + depth·direction lies at that depth.
    pub fn ray(&self, place: DVec2) -> (DVec3, DVec3) {
        let across = self.right * ((place.x - self.middle.x) / self.focal)
            - self.up * ((place.y - self.middle.y) / self.focal);
        if self.perspective {
            (DVec3::ZERO, self.forward + across)
        } else {
            (across, self.forward)
        }
    }

    /// Returns the ray from the eye through the centre of a pixel: a point and a unit direction, world.
    pub fn eye_ray(&self, x: usize, y: usize) -> (DVec3, DVec3) {
        let (point, direction) = self.ray(pixel_centre(x, y));
        (self.world(point), direction.normalize())
    }

    pub fn least_key(&self) -> f64 {
        self.key_from_depth(FARTHEST)
    }

    /// Converts a point relative to the eye in camera distances to world coordinates.
    pub fn world(&self, position: DVec3) -> DVec3 {
        self.eye + position * self.unit
    }
}
