//! Light through the object: a ray refracted at the surface, or through the whole solid.

use super::bvh::{Packet, RAYS};
use super::sites::Sight;
use super::solid::Solid;
use super::surroundings::Surroundings;
use crate::illumination::{mirror, refract};
use crate::scene::{Rgb, Through};
use fearless_simd::Simd;
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

    /// Follows as many rays at once as a packet has: each pixel's ray travels along its direction and meets the surface at
    /// the sight beside it. Calls `each` with what they see at last.
    #[inline(always)]
    pub fn transmit_all<S: Simd>(
        &self,
        simd: S,
        rays: &[(Sight, DVec3)],
        scratch: &mut Vec<u64>,
        mut each: impl FnMut(usize, Rgb),
    ) {
        let mut paths = [Path { point: DVec3::ZERO, direction: DVec3::X, refractions: 0, total_reflections: 0 }; RAYS];
        for (path, (sight, incident)) in paths.iter_mut().zip(rays) {
            (path.point, path.direction) = (sight.point, *incident);
            self.pass(path, sight.normal);
        }
        let mut packet = Packet::default();
        let (middle, _) = self.solid.ball();
        let mut inside = if self.through == Through::Solid { u32::MAX >> (32 - rays.len().clamp(1, RAYS)) } else { 0 };
        let convex = self.solid.is_convex();
        let mut lost = 0_u32;
        while inside != 0 {
            for (ray, path) in paths.iter().enumerate() {
                let start = path.point + path.direction * self.solid.clearance() - middle;
                packet.set(ray, self.solid.past_inner_ball(start, path.direction), path.direction, f64::INFINITY);
            }
            let mut on = 0;
            self.solid.nearest_of(simd, &packet, inside, |ray, hit| {
                let (Some(hit), path) = (hit, &mut paths[ray]) else { return };
                path.point = hit.point;
                self.pass(path, hit.normal);
                // Nothing meets a convex solid that has left it.
                let gone = convex && path.direction.dot(hit.facing) > 0.0;
                let spent = path.refractions + path.total_reflections >= MOST_EVENTS;
                lost |= u32::from(spent) << ray;
                on |= u32::from(!spent && !gone) << ray;
            });
            inside = on;
        }
        for (ray, path) in paths.iter().enumerate().take(rays.len()) {
            let nothing = lost >> ray & 1 == 1;
            each(ray, if nothing { Rgb::ZERO } else { self.surroundings.along(path.point, path.direction, scratch) });
        }
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

#[derive(Clone, Copy)]
struct Path {
    point: DVec3,
    direction: DVec3,
    refractions: u32,
    total_reflections: u32,
}
