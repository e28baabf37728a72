//! Packets of rays and points in SIMD lanes, and the bits of which of them see a light.

use crate::illumination::Reached;
use fearless_simd::{f32x16, mask32x16, prelude::*};
use glam::DVec3;

pub const RAYS: usize = 16;

/// The rays traced together, relative to the model's origin.
#[derive(Clone, Default)]
pub struct Packet {
    pub origin: [[f64; RAYS]; 3],
    pub direction: [[f64; RAYS]; 3],
    pub t_max: [f64; RAYS],
}

impl Packet {
    pub fn set(&mut self, ray: usize, origin: DVec3, direction: DVec3, t_max: f64) {
        for axis in 0..3 {
            self.origin[axis][ray] = origin[axis];
            self.direction[axis][ray] = direction[axis];
        }
        self.t_max[ray] = t_max;
    }

    pub fn ray(&self, ray: usize) -> (DVec3, DVec3, f64) {
        let of =
            |planes: &[[f64; RAYS]; 3]| DVec3::new(planes[0][ray], planes[1][ray], planes[2][ray]);
        (of(&self.origin), of(&self.direction), self.t_max[ray])
    }
}

/// Returns the numbers of the bits that are set, the lowest first.
#[inline(always)]
pub fn rays_of(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let ray = bits.trailing_zeros() as usize;
        let any = bits != 0;
        bits &= bits.wrapping_sub(1);
        any.then_some(ray)
    })
}

/// The points shown by a row of pixels, or a block of vertices or faces.
#[derive(Default)]
pub struct PointRow {
    /// The origins of the rays before their clearance, relative to the middle of the object's ball, world units.
    pub start: [Vec<f64>; 3],
    pub normal: [Vec<f64>; 3],
    /// A bit for each of [`RAYS`] points, set if the point exists.
    pub present: Vec<u32>,
}

impl PointRow {
    /// Makes space for `count` points, none of which exists yet.
    pub fn clear(&mut self, count: usize) {
        let packets = count.div_ceil(RAYS);
        for plane in self.start.iter_mut().chain(&mut self.normal) {
            plane.resize(packets * RAYS, 0.0);
        }
        self.present.clear();
        self.present.resize(packets, 0);
    }

    pub fn set(&mut self, index: usize, start: DVec3, normal: DVec3) {
        for axis in 0..3 {
            self.start[axis][index] = start[axis];
            self.normal[axis][index] = normal[axis];
        }
        self.present[index / RAYS] |= 1 << (index % RAYS);
    }

    /// Returns the point, `clearance` away along its normal.
    pub fn lifted(&self, index: usize, clearance: f64) -> DVec3 {
        DVec3::from_array(
            [0, 1, 2].map(|axis| self.start[axis][index] + self.normal[axis][index] * clearance),
        )
    }
}

/// The points of a block where the equation is evaluated at vertices or faces.
pub const BLOCK: usize = 4096;

/// The visibility of sources from points: blocks (a row of pixels, or [`BLOCK`] points), each with a row of bits for each source.
#[derive(Default)]
pub struct Visibility {
    pub words: Vec<u64>,
    pub block: usize,
    /// The words of one source within a block.
    pub stride: usize,
}

impl Visibility {
    /// Makes space for `blocks` blocks of `points` points, none in shadow.
    pub fn clear(&mut self, blocks: usize, points: usize, sources: usize) {
        self.stride = points.div_ceil(64);
        // One word more, since bits are read two words at a time.
        self.block = sources * self.stride + 1;
        self.words.clear();
        self.words.resize(blocks * self.block, u64::MAX);
    }

    /// Returns the bits from point `first` of a block on.
    pub fn at(&self, block: usize, first: usize) -> Option<Reached<'_>> {
        let words = self
            .words
            .get(block * self.block..(block + 1) * self.block)?;
        (self.block > 0).then_some(Reached {
            words,
            stride: self.stride,
            first,
        })
    }
}

pub type Vectors<S> = [f32x16<S>; 3];

#[inline(always)]
pub fn bits<S: Simd>(mask: mask32x16<S>) -> u32 {
    mask.to_bitmask() as u32
}

#[inline(always)]
pub fn dot<S: Simd>(a: &Vectors<S>, b: &Vectors<S>) -> f32x16<S> {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}
