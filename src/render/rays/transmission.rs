//! The view past the object, and through it: rays refracted at the surface, or through the whole solid.

use super::packet::{Packet, RAYS};
use super::solid::PrimaryHit;
use super::world::{Beyond, FloorScratch, LightScratch, World, in_range};
use crate::illumination::{mirror, refract};
use crate::render::raster::{Coverage, ROWS};
use crate::scene::{Rgb, Through};
use fearless_simd::dispatch;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use serde::Serialize;
use std::ops::Range;

/// The most surfaces that a ray passes or is mirrored at; beyond that its light is negligible.
const MOST_EVENTS: u32 = 16;

/// The path of a transmitted ray.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Transmission {
    /// T, the direction of the ray behind the surface, unit, world; `None` where it is totally reflected there.
    pub t: Option<DVec3>,
    /// The number of refractions.
    pub refractions: u32,
    /// The number of total reflections.
    pub total_reflections: u32,
    /// Itrans: the colour that it finally reaches.
    pub seen: Rgb,
}

#[derive(Clone, Copy)]
struct Path {
    point: DVec3,
    direction: DVec3,
    told: Transmission,
}

impl World<'_> {
    /// Follows at most a packet of rays, each given by its number, its hit and its unit direction; calls `each` with their paths.
    pub fn transmit(
        &self,
        rays: &[(usize, PrimaryHit, DVec3)],
        scratch: &mut LightScratch,
        mut each: impl FnMut(usize, Transmission),
    ) {
        let solid = &self.hits.solid;
        let none = Transmission {
            t: None,
            refractions: 0,
            total_reflections: 0,
            seen: Rgb::ZERO,
        };
        let mut paths = [Path {
            point: DVec3::ZERO,
            direction: DVec3::X,
            told: none,
        }; RAYS];
        for (path, (_, hit, incident)) in paths.iter_mut().zip(rays) {
            (path.point, path.direction) = (hit.point, *incident);
            path.told.t = self.pass(path, hit.normal);
        }
        let mut packet = Packet::default();
        let (middle, _) = solid.ball();
        let whole = self.scene.transparency.through == Through::Solid;
        let mut inside = if whole {
            u32::MAX >> (32 - rays.len().clamp(1, RAYS))
        } else {
            0
        };
        let convex = solid.is_convex();
        let mut lost = 0_u32;
        while inside != 0 {
            for (ray, path) in paths.iter().enumerate() {
                let start = path.point + path.direction * solid.clearance() - middle;
                packet.set(
                    ray,
                    solid.past_inner_ball(start, path.direction),
                    path.direction,
                    f64::INFINITY,
                );
            }
            let mut on = 0;
            solid.nearest(&packet, inside, |ray, hit| {
                let (Some(hit), path) = (hit, &mut paths[ray]) else {
                    return;
                };
                path.point = hit.point;
                self.pass(path, hit.normal);
                // A ray that has left a convex solid does not meet it again.
                let gone = convex && path.direction.dot(hit.facing) > 0.0;
                let spent = path.told.refractions + path.told.total_reflections >= MOST_EVENTS;
                lost |= u32::from(spent) << ray;
                on |= u32::from(!spent && !gone) << ray;
            });
            inside = on;
        }
        let mut on_floor = [(0, (DVec3::ZERO, DVec3::Y, 0)); RAYS];
        let mut count = 0;
        for (ray, path) in paths
            .iter_mut()
            .enumerate()
            .take(rays.len())
            .filter(|(ray, _)| lost >> ray & 1 == 0)
        {
            match self.meet(path.point, path.direction) {
                Beyond::Elsewhere(color) => path.told.seen = color,
                Beyond::Floor(point) => {
                    on_floor[count] = (ray, (point, DVec3::Y, 0));
                    count += 1;
                }
            }
        }
        let points = on_floor.map(|(_, point)| point);
        self.floor.light(&points[..count], scratch, |index, color| {
            paths[on_floor[index].0].told.seen = color;
        });
        rays.iter()
            .zip(&paths)
            .for_each(|((number, ..), path)| each(*number, path.told));
    }

    /// Refracts the path at a surface whose outward normal is `n`, or mirrors it where it cannot leave.
    fn pass(&self, path: &mut Path, n: DVec3) -> Option<DVec3> {
        let (eta, enters) = (self.scene.transparency.ior, path.direction.dot(n) <= 0.0);
        // A single surface has the same medium before it whichever way it faces.
        let (n, eta) = match (enters, self.scene.transparency.through) {
            (true, _) => (n, eta),
            (false, Through::Solid) => (-n, 1.0 / eta),
            (false, Through::Surface) => (-n, eta),
        };
        let refracted = refract(path.direction, n, eta);
        match refracted {
            Some(_) => path.told.refractions += 1,
            None => path.told.total_reflections += 1,
        }
        path.direction = refracted.unwrap_or_else(|| mirror(path.direction, n));
        refracted
    }

    /// Computes what each pixel of some columns shows past the object, and behind its surface where light passes through that.
    pub fn see_background(
        &self,
        coverage: Coverage<'_>,
        columns: &Range<usize>,
        seen: &mut Vec<Vec3>,
    ) {
        let (hits, passes) = (&self.hits, self.scene.transparency.kt > 0.0);
        let width = coverage.size[0] as usize;
        seen.resize(width * coverage.size[1] as usize, Vec3::ZERO);
        // Only the pixels of these columns are unset.
        for line in seen.chunks_mut(width.max(1)) {
            line[columns.clone()].fill(Vec3::NAN);
        }
        let parts = seen.par_chunks_mut(ROWS * width).zip(coverage.parts());
        parts.for_each_init(
            <(LightScratch, FloorScratch)>::default,
            |(scratch, floor_scratch), (part, (band, fragments))| {
                let first_row = band.place.first_row as usize;
                hits.walk_covered(band, fragments, |row, covered| {
                    let (start, end) = (covered.start.max(columns.start), covered.end.min(columns.end));
                    if start < end {
                        part[row * width + start..row * width + end].fill(Vec3::ZERO);
                    }
                });
                if passes {
                    let mut follow = |rays: &mut Vec<_>| {
                        self.transmit(rays, scratch, |pixel, path| part[pixel] = in_range(path.seen));
                        rays.clear();
                    };
                    let mut waiting = Vec::with_capacity(RAYS);
                    hits.walk(band, fragments, |x, row, hit| {
                        if !columns.contains(&x) {
                            return;
                        }
                        waiting.push((row * width + x, hit, hits.lens.eye_ray(x, first_row + row).1));
                        if waiting.len() == RAYS {
                            follow(&mut waiting);
                        }
                    });
                    if !waiting.is_empty() {
                        follow(&mut waiting);
                    }
                }
                for (y, line) in (first_row..).zip(part.chunks_mut(width)) {
                    dispatch!(hits.solid.level, simd => self.light_row(simd, y, line, floor_scratch));
                    self.fill_row(y, line);
                    for (x, pixel) in line.iter_mut().enumerate().filter(|(_, pixel)| pixel.is_nan()) {
                        let (origin, direction) = hits.lens.eye_ray(x, y);
                        match self.meet(origin, direction) {
                            Beyond::Elsewhere(color) => *pixel = in_range(color),
                            Beyond::Floor(point) => {
                                self.floor.light(&[(point, DVec3::Y, 0)], scratch, |_, color| *pixel = in_range(color));
                            }
                        }
                    }
                }
            },
        );
    }
}
