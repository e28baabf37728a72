//! Light gathered on a grid of pixels, carried to all pixels, a row at a time in lanes.

use crate::illumination::{Lanes, Real, V3};
use fearless_simd::prelude::*;
use glam::Vec3;

/// Weights below this tell nothing; the pixel gathers for itself.
const LEAST_WEIGHT: f32 = 0.02;
/// A grid point's weight falls to nothing so many cells away.
const WIDTH: f32 = 2.5;
/// Cells on either side within that.
const NEIGHBOURS: usize = 2;

/// A point to gather at.
#[derive(Clone, Copy, Debug, Default)]
pub struct Receiver {
    /// Relative to the eye, camera distances.
    pub place: Vec3,
    /// Unit; zero where there is nothing.
    pub normal: Vec3,
    pub on_object: bool,
}

impl Receiver {
    pub fn is_there(&self) -> bool {
        self.normal != Vec3::ZERO
    }
}

/// Points of the picture at which light was gathered: the middles of square cells.
pub struct Grid {
    pub points: Vec<(Receiver, Vec3)>,
    pub columns: usize,
    /// Pixels along a cell.
    pub step: usize,
}

/// Pixels in lanes.
struct Pixels<S: Simd> {
    x: Lanes<S>,
    place: V3<Lanes<S>>,
    normal: V3<Lanes<S>>,
    /// 1 over the distance of two planes that are taken for one.
    inverse_gap: Lanes<S>,
}

impl Grid {
    /// The weighted mean of the grid's points about each pixel of row `y`; not a number where none of them lies on the same
    /// surface.
    #[inline(always)]
    pub fn carry_row<S: Simd>(&self, simd: S, y: usize, receivers: &[Receiver], light: &mut [Vec3]) {
        let lanes = Lanes::<S>::LEN;
        let rows = self.around(y, y, self.points.len() / self.columns);
        for (x, (receivers, light)) in (0..).step_by(lanes).zip(receivers.chunks(lanes).zip(light.chunks_mut(lanes))) {
            if !receivers.iter().any(Receiver::is_there) {
                continue;
            }
            let pixels = Pixels::load(simd, x, receivers);
            let zero = Lanes::splat(simd, 0.0);
            let (mut sum, mut weights) = (V3::new(zero, zero, zero), zero);
            for row in rows.clone() {
                let share = self.tent(row, y);
                for column in self.around(x, x + receivers.len() - 1, self.columns) {
                    let (other, arriving) = &self.points[row * self.columns + column];
                    if share > 0.0 && other.is_there() {
                        let across = pixels.tent(self.middle(column), self.step as f32) * share;
                        let weight = across * pixels.likeness(other);
                        sum = V3::constant(zero, arriving.to_array()).scale_add(weight, sum);
                        weights = weights + weight;
                    }
                }
            }
            let known = weights.greater_than(Lanes::splat(simd, LEAST_WEIGHT));
            let inverse = Lanes::select(known, Lanes::splat(simd, 1.0) / weights, Lanes::splat(simd, f32::NAN));
            let mean = sum.scale(inverse);
            for (lane, light) in light.iter_mut().enumerate() {
                *light = Vec3::new(mean.x.0[lane], mean.y.0[lane], mean.z.0[lane]);
            }
        }
    }

    /// The cells that have a weight at any of the pixels `first` to `last` of a row or column.
    fn around(&self, first: usize, last: usize, count: usize) -> std::ops::Range<usize> {
        (first / self.step).saturating_sub(NEIGHBOURS)..(last / self.step + NEIGHBOURS + 1).min(count)
    }

    fn middle(&self, cell: usize) -> f32 {
        (cell * self.step + self.step / 2) as f32
    }

    /// Falls from 1 at the cell's middle to 0.
    fn tent(&self, cell: usize, pixel: usize) -> f32 {
        (1.0 - (self.middle(cell) - pixel as f32).abs() / (WIDTH * self.step as f32)).max(0.0)
    }
}

impl<S: Simd> Pixels<S> {
    #[inline(always)]
    fn load(simd: S, x: usize, receivers: &[Receiver]) -> Self {
        let mut planes = [[0.0_f32; 16]; 6];
        for (lane, receiver) in receivers.iter().enumerate() {
            for axis in 0..3 {
                planes[axis][lane] = receiver.place[axis];
                planes[3 + axis][lane] = receiver.normal[axis];
            }
        }
        let [px, py, pz, nx, ny, nz] = &planes;
        let place = V3::new(Lanes::load(simd, px), Lanes::load(simd, py), Lanes::load(simd, pz));
        let normal = V3::new(Lanes::load(simd, nx), Lanes::load(simd, ny), Lanes::load(simd, nz));
        let one = Lanes::splat(simd, 1.0);
        let gap = place.dot(place).sqrt().mul_add(Lanes::splat(simd, 0.01), Lanes::splat(simd, 1e-6));
        Self { x: Lanes::count_up(simd) + Lanes::splat(simd, x as f32), place, normal, inverse_gap: one / gap }
    }

    /// Falls from 1 at a cell's middle to 0.
    #[inline(always)]
    fn tent(&self, middle: f32, step: f32) -> Lanes<S> {
        let one = self.x.constant(1.0);
        let distance = (self.x - self.x.constant(middle)).abs();
        distance.mul_add(self.x.constant(-1.0 / (WIDTH * step)), one).max(self.x.constant(0.0))
    }

    /// 1 for points in one plane, towards 0 where the normals or the planes part.
    #[inline(always)]
    fn likeness(&self, other: &Receiver) -> Lanes<S> {
        let (zero, one) = (self.x.constant(0.0), self.x.constant(1.0));
        let cosine = self.normal.dot(V3::constant(zero, other.normal.to_array())).max(zero);
        let square = cosine * cosine;
        let fourth = square * square;
        let eighth = fourth * fourth;
        let apart = (self.place - V3::constant(zero, other.place.to_array())).dot(self.normal) * self.inverse_gap;
        let square = apart * apart;
        eighth * eighth / square.mul_add(square, one)
    }
}
