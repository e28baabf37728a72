//! Light through the object: a ray refracted at the surface, or through the whole solid.

use super::diffuse::{DiffuseSurface, LightScratch};
use super::packet::{Packet, RAYS};
use super::primary_hit::PrimaryHit;
use super::solid::Solid;
use super::surroundings::{Beyond, Surroundings};
use crate::illumination::{mirror, refract};
use crate::scene::{Rgb, Scene, Through, Transparency};
use fearless_simd::Level;
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
pub struct Glass<'a> {
    solid: Solid<'a>,
    surroundings: &'a Surroundings,
    floor: &'a DiffuseSurface<'a>,
    eta: f64,
    through: Through,
}

impl<'a> Glass<'a> {
    pub fn new(scene: &Scene, solid: Solid<'a>, surroundings: &'a Surroundings, floor: &'a DiffuseSurface<'a>) -> Self {
        let Transparency { ior: eta, through, .. } = scene.transparency;
        Self { solid, surroundings, floor, eta, through }
    }

    /// Follows as many rays at once as a packet has: each travels along its direction, unit, and meets the surface at the hit
    /// beside it. Calls `each` with what they do.
    pub fn transmit(
        &self,
        level: Level,
        rays: &[(PrimaryHit, DVec3)],
        scratch: &mut LightScratch,
        mut each: impl FnMut(usize, Transmission),
    ) {
        let none = Transmission { t: None, refractions: 0, total_reflections: 0, seen: Rgb::ZERO };
        let mut paths = [Path { point: DVec3::ZERO, direction: DVec3::X, told: none }; RAYS];
        for (path, (hit, incident)) in paths.iter_mut().zip(rays) {
            (path.point, path.direction) = (hit.point, *incident);
            path.told.t = self.pass(path, hit.normal);
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
            self.solid.nearest(level, &packet, inside, |ray, hit| {
                let (Some(hit), path) = (hit, &mut paths[ray]) else { return };
                path.point = hit.point;
                self.pass(path, hit.normal);
                // Nothing meets a convex solid that has left it.
                let gone = convex && path.direction.dot(hit.facing) > 0.0;
                let spent = path.told.refractions + path.told.total_reflections >= MOST_EVENTS;
                lost |= u32::from(spent) << ray;
                on |= u32::from(!spent && !gone) << ray;
            });
            inside = on;
        }
        let mut on_floor = [(0, (DVec3::ZERO, DVec3::Y)); RAYS];
        let mut count = 0;
        for (ray, path) in paths.iter_mut().enumerate().take(rays.len()).filter(|(ray, _)| lost >> ray & 1 == 0) {
            match self.surroundings.meet(path.point, path.direction) {
                Beyond::Elsewhere(color) => path.told.seen = color,
                Beyond::Floor(point) => {
                    on_floor[count] = (ray, (point, DVec3::Y));
                    count += 1;
                }
            }
        }
        let points = on_floor.map(|(_, point)| point);
        self.floor.light(level, &points[..count], scratch, |index, color| paths[on_floor[index].0].told.seen = color);
        paths.iter().take(rays.len()).enumerate().for_each(|(ray, path)| each(ray, path.told));
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
            Some(_) => path.told.refractions += 1,
            None => path.told.total_reflections += 1,
        }
        path.direction = refracted.unwrap_or_else(|| mirror(path.direction, n));
        refracted
    }
}

#[derive(Clone, Copy)]
struct Path {
    point: DVec3,
    direction: DVec3,
    told: Transmission,
}
