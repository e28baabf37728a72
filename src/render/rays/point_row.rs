//! Points side by side, as lanes take them.

use super::packet::RAYS;
use glam::DVec3;

/// The points that a row of pixels sees, or a block of vertices or faces.
#[derive(Default)]
pub struct PointRow {
    /// Where rays start but for their clearance, relative to the middle of the object's ball, world units.
    pub start: [Vec<f64>; 3],
    /// Unit.
    pub normal: [Vec<f64>; 3],
    /// A bit for each of [`RAYS`] points: whether it is there.
    pub present: Vec<u32>,
}

impl PointRow {
    /// Room for `count` points, none of them there.
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

    /// The point, `clearance` away along its normal.
    pub fn lifted(&self, index: usize, clearance: f64) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|axis| self.start[axis][index] + self.normal[axis][index] * clearance))
    }
}
