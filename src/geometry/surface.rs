//! The true surfaces behind the polygons, met by rays in double precision.
//!
//! In: a ray. Out: the nearest point where it meets the surface itself, outline included, with the true normal. Every
//! surface lies within [`Surface::BOUND`] of the world's origin, so a ray is first brought to unit direction and to its point
//! nearest the origin: the equations then see numbers about 1 however far away the eye is.

mod patch_ray;
mod patches;
mod polynomial;
mod solids;

use self::solids::UnitRay;
use super::sizes::{CONE, CUBE_HALF_EDGE, CYLINDER};
use crate::scene::{Object, ObjectKind};
use glam::DVec3;

/// Half a line: the points `origin + t · direction` for t > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where the ray starts, world units.
    pub origin: DVec3,
    /// Of any length but zero; `t` counts in multiples of it.
    pub direction: DVec3,
}

/// A point where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceHit {
    /// The point is `ray.origin + t · ray.direction`.
    pub t: f64,
    /// Unit vector that points out of the shape, from whichever side the ray comes. The plane's
    /// and the corrugated sheet's are those of the sides that face +z.
    pub normal: DVec3,
}

/// The true surface of a built-in shape. Copied freely and shared between threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Surface {
    kind: ObjectKind,
    /// Of the corrugated sheet.
    slopes: u32,
}

impl Surface {
    /// Radius of a sphere about the origin that holds every surface: √2 for the corners of the plane, a little more for
    /// rounding.
    pub const BOUND: f64 = 1.415;

    /// The surface of `object`; none for a model or a scene's own polygons, which have no surface beyond them.
    pub fn of(object: &Object) -> Option<Self> {
        let slopes = object.segments.clamp(2, Object::MAX_DIVISIONS);
        object.kind.has_surface().then_some(Self {
            kind: object.kind,
            slopes,
        })
    }

    /// Radius of a ball about the world's origin that the surface encloses; 0 if none is known.
    pub fn inner_radius(&self) -> f64 {
        match self.kind {
            ObjectKind::Sphere => 1.0,
            ObjectKind::Cylinder => CYLINDER.bottom.min(CYLINDER.high),
            ObjectKind::Cube => CUBE_HALF_EDGE,
            _ => 0.0,
        }
    }

    /// The nearest point with t > `t_min` where `ray` meets the surface, if there is one.
    ///
    /// Closed forms are exact to rounding, about 10⁻¹⁵; the torus and the teapot are iterated until they are. A direction
    /// that is zero or not finite meets nothing.
    pub fn intersect(&self, ray: &Ray, t_min: f64) -> Option<SurfaceHit> {
        let length = ray.direction.length();
        let direction = ray.direction / length;
        let shift = -ray.origin.dot(direction);
        let origin = ray.origin + shift * direction;
        // Also false, and rightly, where any of it is not a number.
        let comes_near = origin.length_squared() <= Self::BOUND * Self::BOUND;
        if !comes_near {
            return None;
        }
        let ray = UnitRay {
            origin,
            direction,
            s_min: t_min * length - shift,
        };
        let meeting = match self.kind {
            ObjectKind::Sphere => solids::sphere(&ray),
            ObjectKind::Torus => solids::torus(&ray),
            ObjectKind::Cylinder => solids::frustum(&CYLINDER, &ray),
            ObjectKind::Cone => solids::frustum(&CONE, &ray),
            ObjectKind::Cube => solids::cube(&ray),
            ObjectKind::Plane => solids::plane(&ray),
            ObjectKind::Teapot => patches::teapot(&ray),
            ObjectKind::Corrugated => solids::corrugated(&ray, self.slopes),
            ObjectKind::Obj | ObjectKind::Polygons => None,
        }?;
        Some(SurfaceHit {
            t: (meeting.s + shift) / length,
            normal: meeting.normal.normalize_or(DVec3::Y),
        })
    }
}
