//! The floor as pixels see it, a row at a time: where the eye's rays meet it in double precision, its shadows by packets of
//! rays, and the equation in lanes.

use super::packet::{PointRow, RAYS};
use super::world::{LightScratch, World};
use crate::illumination::{Lanes, NoSpecular, Reached, V3};
use crate::render::lens::{FARTHEST, Lens};
use fearless_simd::{f64x8, prelude::*};
use glam::{DVec2, Vec3};

/// Pixels whose rays are met with the floor at a time.
const EIGHT: usize = 8;

/// What a thread keeps from one row to the next.
#[derive(Default)]
pub struct FloorScratch {
    light: LightScratch,
    /// Relative to the eye, camera distances.
    position: [Vec<f32>; 3],
}

impl FloorScratch {
    /// The point that a pixel of the row sees of the floor, relative to the eye, camera distances.
    pub fn seen(&self, x: usize) -> Option<Vec3> {
        let [px, py, pz] = &self.position;
        (self.light.row.present[x / RAYS] >> (x % RAYS) & 1 == 1).then(|| Vec3::new(px[x], py[x], pz[x]))
    }
}

impl World<'_> {
    /// Puts the floor's intensity into the unset (NaN) pixels of row `y` that see the floor.
    #[inline(always)]
    pub fn light_row<S: Simd>(&self, simd: S, y: usize, line: &mut [Vec3], scratch: &mut FloorScratch) {
        if self.find_row(simd, y, line.len(), |x| line[x].x.is_nan(), scratch) {
            let FloorScratch { light: LightScratch { row, words, waiting }, position } = scratch;
            let reached = self.floor.reached(line.len().div_ceil(64), row, words, waiting);
            self.light_found(simd, row, position, reached, line);
        }
    }

    /// Finds the points of the floor that the `wanted` pixels of row `y` see; tells whether there are any.
    #[inline(always)]
    pub fn find_row<S: Simd>(
        &self,
        simd: S,
        y: usize,
        width: usize,
        wanted: impl Fn(usize) -> bool,
        scratch: &mut FloorScratch,
    ) -> bool {
        let Some(ground) = self.ground else { return false };
        let FloorScratch { light: LightScratch { row, .. }, position } = scratch;
        row.clear(width);
        position.iter_mut().for_each(|plane| plane.resize(width.next_multiple_of(RAYS), 0.0));
        let mut any = false;
        for x in (0..width).step_by(EIGHT) {
            let mut eight = 0;
            for lane in 0..EIGHT.min(width - x) {
                eight |= u32::from(wanted(x + lane)) << lane;
            }
            if eight != 0 {
                any |= self.meet_eight(simd, ground, [x, y], eight, row, position);
            }
        }
        any
    }

    /// Finds the points of the floor that eight pixels from column `x` on see; tells whether any does.
    #[inline(always)]
    fn meet_eight<S: Simd>(
        &self,
        simd: S,
        height: f64,
        [x, y]: [usize; 2],
        wanted: u32,
        row: &mut PointRow,
        position: &mut [Vec<f32>; 3],
    ) -> bool {
        let lens = self.hits.lens;
        let Lens { eye, unit, right, focal, middle, perspective, .. } = *lens;
        let (point, direction) = lens.ray(DVec2::new(middle.x, y as f64 + 0.5));
        let columns: [f64; EIGHT] = [0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5];
        let across = (f64x8::from_slice(simd, &columns) + (x as f64 - middle.x)) / focal;
        let splat = |v: f64| f64x8::splat(simd, v);
        let drop = (height - eye.y) / unit;
        let (from, along) = if perspective { (splat(0.0), across) } else { (across, splat(0.0)) };
        let from_y = from * right.y + point.y;
        let along_y = along * right.y + direction.y;
        let t = (splat(drop) - from_y) / along_y;
        let px = t * (along * right.x + direction.x) + (from * right.x + point.x);
        let pz = t * (along * right.z + direction.z) + (from * right.z + point.z);
        let near = splat(FARTHEST);
        let seen = along_y.simd_lt(splat(0.0))
            & from_y.simd_gt(splat(drop))
            & px.abs().simd_lt(near)
            & pz.abs().simd_lt(near)
            & t.simd_le(splat(self.wall_depth));
        let seen = seen.to_bitmask() as u32 & wanted;
        if seen == 0 || drop.abs() >= FARTHEST {
            return false;
        }
        row.present[x / RAYS] |= seen << (x % RAYS);
        let (ball, _) = self.hits.solid.ball();
        let base = eye - ball;
        (px * unit + base.x).store_slice(&mut row.start[0][x..x + EIGHT]);
        (pz * unit + base.z).store_slice(&mut row.start[2][x..x + EIGHT]);
        row.start[1][x..x + EIGHT].fill(height - ball.y);
        row.normal[0][x..x + EIGHT].fill(0.0);
        row.normal[1][x..x + EIGHT].fill(1.0);
        row.normal[2][x..x + EIGHT].fill(0.0);
        position[1][x..x + EIGHT].fill(drop as f32);
        for lane in 0..EIGHT {
            position[0][x + lane] = px[lane] as f32;
            position[2][x + lane] = pz[lane] as f32;
        }
        true
    }

    /// I at the points found.
    #[inline(always)]
    fn light_found<S: Simd>(
        &self,
        simd: S,
        row: &PointRow,
        [px, py, pz]: &[Vec<f32>; 3],
        reached: Option<Reached<'_>>,
        line: &mut [Vec3],
    ) {
        let lanes = Lanes::<S>::LEN;
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        for (x, pixels) in (0..).step_by(lanes).zip(line.chunks_mut(lanes)) {
            let present = row.present[x / RAYS] >> (x % RAYS) & (u32::MAX >> (32 - lanes));
            if present == 0 {
                continue;
            }
            let position =
                V3::new(Lanes::load(simd, &px[x..]), Lanes::load(simd, &py[x..]), Lanes::load(simd, &pz[x..]));
            let point = self.floor_lanes.site(position, V3::new(zero, one, zero));
            let reached = reached.map(
                #[inline(always)]
                |reached| reached.starting_at(x),
            );
            let [r, g, b] = self.floor_lanes.illuminate::<Lanes<S>, NoSpecular>(&point, reached);
            for (lane, pixel) in pixels.iter_mut().enumerate().filter(|(lane, _)| present >> lane & 1 == 1) {
                *pixel = Vec3::new(r.0[lane], g.0[lane], b.0[lane]);
            }
        }
    }
}
