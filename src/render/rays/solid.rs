//! What rays meet: the polygons, or the true surface where that is drawn.

use super::bvh::Bvh;
use super::packet::{Packet, rays_of};
use super::traverse::Meeting;
use crate::geometry::{Ray, Surface};
use crate::render::model::Model;
use fearless_simd::{Level, Simd, dispatch};
use glam::DVec3;

/// Rays start this part of the object's radius away from the surface, so that they do not meet the point they leave.
/// Polygons meet their own corners exactly, up to the rounding of double precision.
const CLEAR_OF_POLYGONS: f64 = 1e-6;
/// The teapot's patches are iterated to about 10⁻⁹.
const CLEAR_OF_SURFACE: f64 = 1e-5;

/// The object as rays see it.
#[derive(Clone, Copy)]
pub struct Solid<'a> {
    pub level: Level,
    pub model: &'a Model,
    pub bvh: &'a Bvh,
    /// The true surface, if that is drawn.
    pub surface: Option<&'a Surface>,
    /// Whether the normal is interpolated over a polygon.
    pub smooth: bool,
}

/// Where a ray meets the object.
#[derive(Clone, Copy, Debug)]
pub struct SolidHit {
    /// World.
    pub point: DVec3,
    /// Unit, outwards.
    pub normal: DVec3,
    /// Outwards from the polygon itself, of any length; the true surface's normal.
    pub facing: DVec3,
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

    /// The height of the lowest point, or less.
    pub fn lowest(&self) -> f64 {
        match self.surface {
            Some(_) => -Surface::BOUND,
            None => self.model.origin.y + self.bvh.lowest(),
        }
    }

    /// Radius of a ball about the middle of [`Solid::ball`] that lies within the object, so that a ray from outside into it
    /// meets the object; 0 if none is known. A little less than touches, so that it lies before the surface on every ray.
    pub fn inner_radius(&self) -> f64 {
        match self.surface {
            Some(surface) => surface.inner_radius() * (1.0 - CLEAR_OF_SURFACE),
            None => self.bvh.inner_radius,
        }
    }

    /// On which of the rays whose bits are set in `asked` the object lies; the rays are relative to the ball's middle.
    #[inline(always)]
    pub fn blocked<S: Simd>(&self, simd: S, packet: &Packet, asked: u32) -> u32 {
        let Some(surface) = self.surface else { return self.bvh.blocked(simd, packet, asked) };
        let blocks = |ray: &usize| {
            let (origin, direction, t_max) = packet.ray(*ray);
            surface.intersect(&Ray { origin, direction }, 0.0).is_some_and(|hit| hit.t < t_max)
        };
        rays_of(asked).filter(blocks).fold(0, |blocked, ray| blocked | 1 << ray)
    }

    /// The first point of the object on each of the rays whose bits are set in `asked`; the rays are relative to the ball's
    /// middle. Calls `each` with the ray and what it meets.
    pub fn nearest(&self, packet: &Packet, asked: u32, mut each: impl FnMut(usize, Option<SolidHit>)) {
        let (middle, _) = self.ball();
        if let Some(surface) = self.surface {
            for ray in rays_of(asked) {
                let (start, direction, _) = packet.ray(ray);
                let origin = middle + start;
                let hit = surface.intersect(&Ray { origin, direction }, 0.0);
                let point = |t: f64| origin + direction * t;
                each(ray, hit.map(|hit| SolidHit { point: point(hit.t), normal: hit.normal, facing: hit.normal }));
            }
            return;
        }
        let nearest = dispatch!(self.level, simd => self.bvh.nearest(simd, packet, asked));
        for ray in rays_of(asked) {
            let (origin, direction, _) = packet.ray(ray);
            each(ray, nearest.of(ray).map(|meeting| self.hit(middle + origin, direction, meeting)));
        }
    }

    fn hit(&self, origin: DVec3, direction: DVec3, Meeting { t, triangle, weights }: Meeting) -> SolidHit {
        let [a, b, c] = self.model.triangles[triangle as usize].map(|v| self.model.place(v).as_dvec3());
        let facing = (b - a).cross(c - a);
        SolidHit { point: origin + direction * t, normal: self.normal(triangle, weights), facing }
    }

    /// Where a ray from `start`, relative to the ball's middle, leaves the inner ball of a convex object; `start` itself if
    /// it does not pass that. From inside the object nothing is met before.
    pub fn past_inner_ball(&self, start: DVec3, direction: DVec3) -> DVec3 {
        let radius = self.inner_radius();
        if !self.is_convex() || radius <= 0.0 {
            return start;
        }
        let unit = direction.normalize();
        let middle = -start.dot(unit);
        let half_chord = radius * radius - (start + unit * middle).length_squared();
        if middle > 0.0 && half_chord > 0.0 { start + unit * (middle + half_chord.sqrt()) } else { start }
    }

    /// The unit normal of a triangle where its second and third corner have these weights.
    fn normal(&self, triangle: u32, [w1, w2]: [f64; 2]) -> DVec3 {
        let face = || self.model.face_normal(self.model.faces[triangle as usize]);
        if !self.smooth {
            return face();
        }
        let [a, b, c] = self.model.triangles[triangle as usize].map(|v| self.model.normal(v));
        (a * (1.0 - w1 - w2) + b * w1 + c * w2).try_normalize().unwrap_or_else(face)
    }
}
