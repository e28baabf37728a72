//! The true surfaces behind the polygons, met by rays in double precision.
//!
//! In: a ray. Out: the nearest point where it meets the surface itself, outline included, with the true normal. Every
//! surface lies within [`Surface::BOUND`] of the world's origin, so a ray is first normalised and moved to its point
//! nearest the origin: the equations then work with numbers about 1 however far away the eye is.

mod leaf;
mod patch_ray;
mod patches;
mod polynomial;
mod solids;

use self::solids::{Meeting, UnitRay};
use super::sizes::{CONE, CUBE_HALF_EDGE, CYLINDER};
use crate::scene::{Object, ObjectKind};
use fearless_simd::{Level, dispatch};
use glam::DVec3;
use std::slice;

/// The most rays intersected at a time.
pub const RAYS_TOGETHER: usize = 8;

/// Half a line: the points `origin + t · direction` for t > 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ray {
    /// The starting point, in world units.
    pub origin: DVec3,
    /// The direction, of any length but zero; `t` counts in multiples of it.
    pub direction: DVec3,
}

/// A point where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceHit {
    /// The ray's parameter: the point is `ray.origin + t · ray.direction`.
    pub t: f64,
    /// The unit normal, out of the shape from whichever side the ray comes. The plane's and the corrugated sheet's are
    /// those of the sides that face +z.
    pub normal: DVec3,
}

/// The true surface of a built-in shape. It is cheap to copy and to share between threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Surface {
    kind: ObjectKind,
    /// The slopes of the corrugated sheet.
    slopes: u32,
}

impl Surface {
    /// The radius of a sphere about the origin that holds every surface: √2 for the corners of the plane, a little more for
    /// rounding.
    pub const BOUND: f64 = 1.415;

    /// Returns the surface of `object`; `None` for a model or a scene's own polygons, which have no surface beyond them.
    pub fn of(object: &Object) -> Option<Self> {
        let slopes = object.segments.clamp(2, Object::MAX_DIVISIONS);
        object.kind.has_surface().then_some(Self {
            kind: object.kind,
            slopes,
        })
    }

    /// Returns the radius of a ball about the world's origin that the surface encloses; 0 if none is known.
    pub fn inner_radius(&self) -> f64 {
        match self.kind {
            ObjectKind::Sphere => 1.0,
            ObjectKind::Cylinder => CYLINDER.bottom.min(CYLINDER.high),
            ObjectKind::Cube => CUBE_HALF_EDGE,
            _ => 0.0,
        }
    }

    /// Returns the nearest point with t > `t_min` where `ray` meets the surface, if there is one.
    ///
    /// Closed forms are exact to rounding, about 10⁻¹⁵; the torus and the teapot are iterated to the same accuracy. A direction
    /// that is zero or not finite meets nothing.
    pub fn intersect(&self, ray: &Ray, t_min: f64) -> Option<SurfaceHit> {
        self.intersect_all(Level::new(), slice::from_ref(ray), t_min)[0]
    }

    /// Returns the nearest points, as [`Self::intersect`] does, for at most [`RAYS_TOGETHER`] rays; neither the level nor the
    /// other rays change an answer.
    pub fn intersect_all(
        &self,
        level: Level,
        rays: &[Ray],
        t_min: f64,
    ) -> [Option<SurfaceHit>; RAYS_TOGETHER] {
        let mut near = [UnitRay::default(); RAYS_TOGETHER];
        // The conversion from the length along the unit ray to t.
        let mut scale = [(0.0, 1.0); RAYS_TOGETHER];
        let mut requested = 0;
        for (k, ray) in rays.iter().enumerate().take(RAYS_TOGETHER) {
            let length = ray.direction.length();
            let direction = ray.direction / length;
            let shift = -ray.origin.dot(direction);
            let origin = ray.origin + shift * direction;
            // Also false, as it should be, where any of it is not a number.
            if origin.length_squared() <= Self::BOUND * Self::BOUND {
                near[k] = UnitRay {
                    origin,
                    direction,
                    s_min: t_min * length - shift,
                };
                scale[k] = (shift, length);
                requested |= 1 << k;
            }
        }
        let mut meetings = [None; RAYS_TOGETHER];
        if self.kind == ObjectKind::Teapot {
            if requested != 0 {
                meetings = dispatch!(level, simd => patches::teapot(simd, &near, requested));
            }
        } else {
            for k in (0..RAYS_TOGETHER).filter(|k| requested >> k & 1 == 1) {
                meetings[k] = self.meet(&near[k]);
            }
        }
        let mut hits = [None; RAYS_TOGETHER];
        for (k, (meeting, (shift, length))) in meetings.into_iter().zip(scale).enumerate() {
            hits[k] = meeting.map(|meeting: Meeting| SurfaceHit {
                t: (meeting.s + shift) / length,
                normal: meeting.normal.normalize_or(DVec3::Y),
            });
        }
        hits
    }

    /// Returns the point where one ray meets a surface that is not made of patches.
    fn meet(&self, ray: &UnitRay) -> Option<Meeting> {
        match self.kind {
            ObjectKind::Sphere => solids::sphere(ray),
            ObjectKind::Torus => solids::torus(ray),
            ObjectKind::Cylinder => solids::frustum(&CYLINDER, ray),
            ObjectKind::Cone => solids::frustum(&CONE, ray),
            ObjectKind::Cube => solids::cube(ray),
            ObjectKind::Plane => solids::plane(ray),
            ObjectKind::Corrugated => solids::corrugated(ray, self.slopes),
            ObjectKind::Teapot | ObjectKind::Balls | ObjectKind::Obj | ObjectKind::Polygons => None,
        }
    }
}
