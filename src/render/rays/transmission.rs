//! The view past the object, and through it: rays refracted at the surface, or through the whole solid.
//!
//! A ray that has passed a surface passes the next ones of the same material, whose own light is not added. At a surface of
//! another material it sees that surface, by its equation, with the weight 1 − Kt and goes on with Kt.

use super::packet::{Packet, RAYS};
use super::solid::{PrimaryHit, SolidHit};
use super::world::{Beyond, FloorScratch, LightScratch, LitPoint, World, in_range};
use crate::illumination::{mirror, refract};
use crate::render::face_materials::any_transmits;
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
    /// The index of the material that it has passed last.
    material: usize,
    /// The part of its light that is still to come, and the light of surfaces of other materials.
    left: f64,
    gathered: Rgb,
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
            material: 0,
            left: 1.0,
            gathered: Rgb::ZERO,
            told: none,
        }; RAYS];
        for (path, (_, hit, incident)) in paths.iter_mut().zip(rays) {
            (path.point, path.direction, path.material) = (hit.point, *incident, hit.material);
            path.told.t = self.pass(path, hit.normal, hit.material);
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
        let (mut lost, mut ended) = (0_u32, 0_u32);
        let mut others = Vec::new();
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
                if hit.material != path.material {
                    others.push((ray, path.left, seen_from(path.direction, &hit)));
                    path.left *= self.materials[hit.material].kt;
                    if path.left == 0.0 {
                        ended |= 1 << ray;
                        return;
                    }
                    path.material = hit.material;
                }
                self.pass(path, hit.normal, hit.material);
                // A ray that has left a convex solid does not meet it again.
                let gone = convex && path.direction.dot(hit.facing) > 0.0;
                let spent = path.told.refractions + path.told.total_reflections >= MOST_EVENTS;
                lost |= u32::from(spent) << ray;
                on |= u32::from(!spent && !gone) << ray;
            });
            inside = on;
            self.see_others(&mut others, &mut paths, scratch);
        }
        let mut on_floor = [(0, LitPoint::FLOOR); RAYS];
        let mut count = 0;
        for (ray, path) in paths
            .iter_mut()
            .enumerate()
            .take(rays.len())
            .filter(|(ray, _)| (lost | ended) >> ray & 1 == 0)
        {
            match self.meet(path.point, path.direction) {
                Beyond::Elsewhere(color) => path.told.seen = color,
                Beyond::Floor(point) => {
                    on_floor[count] = (ray, LitPoint::of_floor(point));
                    count += 1;
                }
            }
        }
        let points = on_floor.map(|(_, point)| point);
        self.floor.light(&points[..count], scratch, |index, color| {
            paths[on_floor[index].0].told.seen = color;
        });
        for ((number, ..), path) in rays.iter().zip(&mut paths) {
            path.told.seen = path.gathered + path.told.seen * path.left;
            each(*number, path.told);
        }
    }

    /// Adds the light of surfaces of other materials, each a ray's number, the part of its light still to come before, and
    /// the point: of that part, 1 − Kt is the surface's own, by its equation.
    fn see_others(
        &self,
        others: &mut Vec<(usize, f64, LitPoint)>,
        paths: &mut [Path; RAYS],
        scratch: &mut LightScratch,
    ) {
        if let Some(object) = self.object.as_ref().filter(|_| !others.is_empty()) {
            let points: Vec<LitPoint> = others.iter().map(|(.., point)| *point).collect();
            object.light(&points, scratch, |index, color| {
                let (ray, left, point) = &others[index];
                let own = left * (1.0 - self.materials[point.material].kt);
                paths[*ray].gathered += color * own;
            });
        }
        others.clear();
    }

    /// Refracts the path at a surface of `material` whose outward normal is `n`, or mirrors it where it cannot leave.
    fn pass(&self, path: &mut Path, n: DVec3, material: usize) -> Option<DVec3> {
        let eta = self.materials[material].relative_ior;
        let enters = path.direction.dot(n) <= 0.0;
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
        let (hits, passes) = (&self.hits, any_transmits(self.materials));
        let width = coverage.size[0] as usize;
        seen.resize(width * coverage.size[1] as usize, Vec3::ZERO);
        let parts = seen.par_chunks_mut(ROWS * width).zip(coverage.parts());
        parts.for_each_init(
            <(LightScratch, FloorScratch)>::default,
            |(scratch, floor_scratch), (part, (band, fragments))| {
                // Only the pixels of these columns are unset.
                for line in part.chunks_mut(width) {
                    line[columns.clone()].fill(Vec3::NAN);
                }
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
                        if !columns.contains(&x) || self.materials[hit.material].kt == 0.0 {
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
                                self.floor.light(&[LitPoint::of_floor(point)], scratch, |_, color| *pixel = in_range(color));
                            }
                        }
                    }
                }
            },
        );
    }
}

/// Returns a point of the object as a ray in this direction sees it: from the side that it comes from.
fn seen_from(direction: DVec3, hit: &SolidHit) -> LitPoint {
    let from_inside = direction.dot(hit.facing) > 0.0;
    LitPoint {
        point: hit.point,
        normal: if from_inside { -hit.normal } else { hit.normal },
        material: hit.material,
        tint: hit.tint,
        view: Some(-direction.normalize()),
    }
}
