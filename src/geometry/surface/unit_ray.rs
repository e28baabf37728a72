//! Rays and meetings as the shapes see them.

use glam::DVec3;

/// A ray as the shapes see it: unit direction, origin nearest to the world's origin, `s` the length along it.
#[derive(Clone, Copy, Debug)]
pub struct UnitRay {
    pub origin: DVec3,
    pub direction: DVec3,
    /// Only points beyond this are wanted.
    pub s_min: f64,
}

/// A meeting with a shape: where along the [`UnitRay`], and the normal, not yet of unit length.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    pub s: f64,
    pub normal: DVec3,
}

impl UnitRay {
    pub fn at(&self, s: f64) -> DVec3 {
        self.origin + s * self.direction
    }
}
