//! One bounce: light that the object and the floor have scattered once, gathered from all sides.
//!
//! What arrives at a point is the mean of what is seen in directions spread as the cosine to its normal, which is what a
//! diffuse surface weighs them by. It is gathered on a grid of pixels and carried to the others by weights that fall with
//! the distance in the picture and vanish on another surface (after W. J. Ward et al., *A ray tracing solution for diffuse
//! interreflection*, 1988: indirect light changes slowly but at creases).

use super::bounce_grid::{Grid, Receiver};
use super::diffuse::{DiffuseSurface, LightScratch};
use super::packet::{Packet, RAYS};
use super::solid::Solid;
use super::surroundings::{Beyond, Surroundings};
use crate::scene::Rgb;
use fearless_simd::{Level, dispatch};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Directions from a point: rows times columns.
const DIRECTIONS: [usize; 2] = [8, 8];
/// Every ray of a packet.
const ALL: u32 = u32::MAX >> (32 - RAYS);
/// Points of the grid along the picture's longer side: light from other surfaces changes over the object, not over pixels.
const POINTS: usize = 72;

/// What light is gathered from.
#[derive(Clone, Copy)]
pub struct Gathering<'a> {
    pub solid: Solid<'a>,
    pub surroundings: &'a Surroundings,
    /// The object's diffuse reflection without its ambient light, and the floor's.
    pub object: &'a DiffuseSurface<'a>,
    pub floor: &'a DiffuseSurface<'a>,
}

/// What a thread keeps from one receiver to the next.
#[derive(Default)]
struct Scratch {
    on_object: Vec<(DVec3, DVec3)>,
    on_floor: Vec<(DVec3, DVec3)>,
    light: LightScratch,
}

impl Gathering<'_> {
    /// The mean intensity that arrives from other surfaces at every pixel of a picture `width` wide; `world` gives a
    /// receiver's point.
    pub fn gather(
        &self,
        level: Level,
        receivers: &[Receiver],
        width: usize,
        world: impl Fn(Vec3) -> DVec3 + Sync,
        gathered: &mut Vec<Vec3>,
    ) {
        gathered.resize(receivers.len(), Vec3::ZERO);
        if receivers.is_empty() || width == 0 {
            return;
        }
        let height = receivers.len() / width;
        let step = (width.max(height) / POINTS).max(1);
        let columns = width.div_ceil(step);
        let at = |receiver: &Receiver, salt: usize, scratch: &mut Scratch| {
            let point = world(receiver.place);
            self.at(level, receiver, point, salt, scratch).min(Rgb::splat(1e36)).as_vec3()
        };
        let pick = |column: usize, row: usize| {
            let (x, y) = ((column * step + step / 2).min(width - 1), (row * step + step / 2).min(height - 1));
            receivers[y * width + x]
        };
        let points: Vec<(Receiver, Vec3)> = (0..height.div_ceil(step) * columns)
            .into_par_iter()
            .map_init(Scratch::default, |scratch, cell| {
                let receiver = pick(cell % columns, cell / columns);
                let light = if receiver.is_there() { at(&receiver, cell, scratch) } else { Vec3::ZERO };
                (receiver, light)
            })
            .collect();
        let grid = Grid { points, columns, step };
        let lines = gathered.par_chunks_mut(width).zip(receivers.par_chunks(width)).enumerate();
        lines.for_each_init(Scratch::default, |scratch, (y, (line, receivers))| {
            dispatch!(level, simd => grid.carry_row(simd, y, receivers, line));
            for (x, (light, receiver)) in line.iter_mut().zip(receivers).enumerate() {
                if !receiver.is_there() {
                    *light = Vec3::ZERO;
                } else if light.is_nan() {
                    *light = at(receiver, y * width + x, scratch);
                }
            }
        });
    }

    /// The mean intensity from other surfaces at a receiver's point, world. `salt` turns the directions, so that their
    /// number does not show as steps.
    fn at(&self, level: Level, receiver: &Receiver, point: DVec3, salt: usize, scratch: &mut Scratch) -> Rgb {
        let n = receiver.normal.as_dvec3();
        let start = point + n * self.solid.clearance();
        let (middle, _) = self.solid.ball();
        let directions = directions(n, salt);
        let Scratch { on_object, on_floor, light } = scratch;
        on_object.clear();
        on_floor.clear();
        let mut see_past = |direction: DVec3| match self.surroundings.meet(start, direction) {
            Beyond::Floor(point) => on_floor.push((point, DVec3::Y)),
            Beyond::Elsewhere(_) => {}
        };
        // A convex solid lies behind the tangent plane of each of its points.
        if receiver.on_object && self.solid.is_convex() {
            directions.into_iter().for_each(see_past);
        } else {
            let mut packet = Packet::default();
            for directions in directions.chunks_exact(RAYS) {
                for (ray, direction) in directions.iter().enumerate() {
                    packet.set(ray, start - middle, *direction, f64::INFINITY);
                }
                self.solid.nearest(level, &packet, ALL, |ray, hit| match hit {
                    Some(hit) => on_object.push((hit.point, hit.normal)),
                    None => see_past(directions[ray]),
                });
            }
        }
        let mut sum = Rgb::ZERO;
        self.object.light(level, on_object, light, |_, intensity| sum += intensity);
        self.floor.light(level, on_floor, light, |_, intensity| sum += intensity);
        sum / directions.len() as f64
    }
}

/// Directions about `n`, spread as the cosine to it and turned by `salt`.
fn directions(n: DVec3, salt: usize) -> [DVec3; DIRECTIONS[0] * DIRECTIONS[1]] {
    let (tangent, bitangent) = n.any_orthonormal_pair();
    let [rows, columns] = DIRECTIONS;
    let turn = [0.754_877_666, 0.569_840_291].map(|golden: f64| (salt as f64 * golden).fract());
    std::array::from_fn(|k| {
        let height = ((k / columns) as f64 + turn[0]) / rows as f64;
        let angle = TAU * ((k % columns) as f64 + turn[1]) / columns as f64;
        // Even over the disc under the half-sphere: spread as the cosine over the half-sphere.
        let (radius, (sine, cosine)) = (height.sqrt(), angle.sin_cos());
        tangent * (radius * cosine) + bitangent * (radius * sine) + n * (1.0 - height).sqrt()
    })
}
