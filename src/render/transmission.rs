//! Light through the object: a ray refracted at the surface, or through the whole solid.

use super::solid::Solid;
use super::surroundings::Surroundings;
use crate::illumination::{mirror, refract};
use crate::scene::{Rgb, Through};
use glam::DVec3;

/// Surfaces that a ray passes or is mirrored at before what it carries counts for nothing.
const MOST_EVENTS: u32 = 16;

/// What a transmitted ray did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transmission {
    /// T, where the ray goes on behind the surface, unit, world; none where it is totally reflected there.
    pub t: Option<DVec3>,
    /// Times that it was refracted.
    pub refractions: u32,
    /// Times that it was totally reflected.
    pub total_reflections: u32,
    /// Itrans: what it sees at last.
    pub seen: Rgb,
}

/// What light passes through.
pub(super) struct Glass<'a> {
    pub solid: Solid<'a>,
    pub surroundings: &'a Surroundings<'a>,
    pub eta: f64,
    pub through: Through,
}

impl Glass<'_> {
    /// Follows a ray that travels along `incident`, unit, and meets the surface at `point` with normal `n`.
    pub fn transmit(&self, point: DVec3, n: DVec3, incident: DVec3, scratch: &mut Vec<u64>) -> Transmission {
        let mut path = Path { point, direction: incident, refractions: 0, total_reflections: 0 };
        let t = self.pass(&mut path, n);
        let mut lost = false;
        while self.through == Through::Solid && !lost {
            let start = path.point + path.direction * self.solid.clearance();
            let Some(hit) = self.solid.nearest(start, path.direction) else { break };
            path.point = hit.point;
            self.pass(&mut path, hit.normal);
            lost = path.refractions + path.total_reflections >= MOST_EVENTS;
        }
        let seen = if lost { Rgb::ZERO } else { self.surroundings.along(path.point, path.direction, scratch) };
        let Path { refractions, total_reflections, .. } = path;
        Transmission { t, refractions, total_reflections, seen }
    }

    /// Refracts the path at a surface whose outward normal is `n`, or mirrors it where it cannot leave.
    fn pass(&self, path: &mut Path, n: DVec3) -> Option<DVec3> {
        let enters = path.direction.dot(n) <= 0.0;
        // A single surface has the same medium before it whichever way it is turned.
        let (n, eta) = match (enters, self.through) {
            (true, _) => (n, self.eta),
            (false, Through::Solid) => (-n, 1.0 / self.eta),
            (false, Through::Surface) => (-n, self.eta),
        };
        let refracted = refract(path.direction, n, eta);
        match refracted {
            Some(_) => path.refractions += 1,
            None => path.total_reflections += 1,
        }
        path.direction = refracted.unwrap_or_else(|| mirror(path.direction, n));
        refracted
    }
}

struct Path {
    point: DVec3,
    direction: DVec3,
    refractions: u32,
    total_reflections: u32,
}
