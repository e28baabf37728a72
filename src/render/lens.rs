//! The camera as the kernels need it: lengths in camera distances, positions relative to the eye.

use crate::scene::{Camera, Projection, View};
use glam::{DVec2, DVec3};

/// What is nearer to the eye than this many camera distances is clipped away.
pub const NEAR: f64 = 1e-3;

/// What is farther from the eye than this many camera distances is lit as if it were no farther: squares must not overflow.
pub const FARTHEST: f64 = 1e12;

/// The object reaches no farther from the eye than this many camera distances: where eye and target are so near to each other
/// that it would, a camera distance is longer than from one to the other. Lights beside it are then still told from lights at
/// infinity, and what is nearer than [`NEAR`] is less than single precision resolves of the object.
pub const DEEPEST: f64 = 1e8;

/// The centre of a pixel.
pub fn pixel_centre(x: usize, y: usize) -> DVec2 {
    DVec2::new(x as f64 + 0.5, y as f64 + 0.5)
}

/// Projection of one picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    pub eye: DVec3,
    /// World units to one camera distance.
    pub unit: f64,
    /// Unit vectors, world.
    pub right: DVec3,
    pub up: DVec3,
    pub forward: DVec3,
    pub perspective: bool,
    /// Pixels to one camera distance, at depth 1 where the projection is a perspective one.
    pub focal: f64,
    /// Where the viewing direction meets the picture, pixels.
    pub middle: DVec2,
}

impl Lens {
    /// The lens for `size` pixels whose samples lie `offset` pixels from the centres; a camera distance is `unit` world units.
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

    /// Right, up and forward components of a world point, camera distances.
    pub fn view_from_world(&self, world: DVec3) -> DVec3 {
        let p = (world - self.eye) / self.unit;
        DVec3::new(p.dot(self.right), p.dot(self.up), p.dot(self.forward))
    }

    /// Where a point given by its view components appears, pixels.
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

    /// The depth key at a distance along the viewing direction: linear in the picture over a flat polygon, greater if nearer.
    pub fn key_from_depth(&self, depth: f64) -> f64 {
        if self.perspective {
            1.0 / depth
        } else {
            -depth
        }
    }

    /// The depth of a key.
    pub fn depth_from_key(&self, key: f64) -> f64 {
        if self.perspective { 1.0 / key } else { -key }
    }

    /// The ray through a place in the picture, relative to the eye: point + depth·direction lies at that depth.
    pub fn ray(&self, place: DVec2) -> (DVec3, DVec3) {
        let across = self.right * ((place.x - self.middle.x) / self.focal)
            - self.up * ((place.y - self.middle.y) / self.focal);
        if self.perspective {
            (DVec3::ZERO, self.forward + across)
        } else {
            (across, self.forward)
        }
    }

    /// The ray from the eye through the centre of a pixel: a point and a unit direction, world.
    pub fn eye_ray(&self, x: usize, y: usize) -> (DVec3, DVec3) {
        let (point, direction) = self.ray(pixel_centre(x, y));
        (self.world(point), direction.normalize())
    }

    /// The key of the farthest depth.
    pub fn least_key(&self) -> f64 {
        self.key_from_depth(FARTHEST)
    }

    /// World coordinates of a point relative to the eye in camera distances.
    pub fn world(&self, position: DVec3) -> DVec3 {
        self.eye + position * self.unit
    }
}
