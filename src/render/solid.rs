//! What rays meet: the polygons, or the true surface where that is drawn.

use super::bvh::{Bvh, Meeting};
use super::model::Model;
use crate::geometry::{Ray, Surface};
use glam::DVec3;

/// Rays start this part of the object's radius away from the surface, so that they do not meet the point they leave.
/// Polygons meet their own corners exactly, up to the rounding of double precision.
const CLEAR_OF_POLYGONS: f64 = 1e-6;
/// The teapot's patches are iterated to about 10⁻⁹.
const CLEAR_OF_SURFACE: f64 = 1e-5;

/// Room for the rounding of a squared distance.
const ROUNDING: f64 = 1e-9;

/// The object as rays see it.
#[derive(Clone, Copy)]
pub(super) struct Solid<'a> {
    pub model: &'a Model,
    pub bvh: &'a Bvh,
    /// The true surface, if that is drawn.
    pub surface: Option<&'a Surface>,
    /// Whether the normal is interpolated over a polygon.
    pub smooth: bool,
}

/// Where a ray meets the object.
#[derive(Clone, Copy, Debug)]
pub(super) struct SolidHit {
    /// World.
    pub point: DVec3,
    /// Unit, outwards.
    pub normal: DVec3,
}

impl Solid<'_> {
    /// How far from the surface a ray starts, world units.
    pub fn clearance(&self) -> f64 {
        let part = if self.surface.is_some() { CLEAR_OF_SURFACE } else { CLEAR_OF_POLYGONS };
        part * self.model.radius
    }

    /// Whether no line leaves the object and enters it again.
    pub fn is_convex(&self) -> bool {
        self.model.closed && self.model.convex
    }

    /// A ball that holds the object: centre and radius, world.
    pub fn ball(&self) -> (DVec3, f64) {
        match self.surface {
            Some(_) => (DVec3::ZERO, Surface::BOUND),
            None => (self.model.origin, self.model.radius),
        }
    }

    /// Whether the object lies on the ray `origin + t·direction`, world, for 0 < t < `t_max`.
    pub fn blocks(&self, origin: DVec3, direction: DVec3, t_max: f64) -> bool {
        // Most rays pass the object at a distance.
        let (centre, radius) = self.ball();
        let towards = centre - origin;
        let t = (towards.dot(direction) / direction.length_squared()).clamp(0.0, t_max);
        if (towards - direction * t).length_squared() > radius * radius * (1.0 + ROUNDING) {
            return false;
        }
        match self.surface {
            Some(surface) => surface.intersect(&Ray { origin, direction }, 0.0).is_some_and(|hit| hit.t < t_max),
            None => self.bvh.blocks(origin - self.model.origin, direction, t_max),
        }
    }

    /// The first point of the object on the ray.
    pub fn nearest(&self, origin: DVec3, direction: DVec3) -> Option<SolidHit> {
        if let Some(surface) = self.surface {
            let hit = surface.intersect(&Ray { origin, direction }, 0.0)?;
            return Some(SolidHit { point: origin + direction * hit.t, normal: hit.normal });
        }
        let Meeting { t, triangle, weights } = self.bvh.nearest(origin - self.model.origin, direction)?;
        Some(SolidHit { point: origin + direction * t, normal: self.normal(triangle, weights) })
    }

    /// The unit normal of a triangle where its second and third corner have these weights.
    pub fn normal(&self, triangle: u32, [w1, w2]: [f64; 2]) -> DVec3 {
        let face = || self.model.face_normal(self.model.faces[triangle as usize]);
        if !self.smooth {
            return face();
        }
        let [a, b, c] = self.model.triangles[triangle as usize].map(|v| self.model.normal(v));
        (a * (1.0 - w1 - w2) + b * w1 + c * w2).try_normalize().unwrap_or_else(face)
    }
}
