//! Sites side by side, as lanes take them.

use crate::render::bvh::RAYS;
use glam::DVec3;

/// The sites of a row of pixels or of a block of points.
#[derive(Default)]
pub(in crate::render) struct SiteRow {
    /// Where rays start but for their clearance, relative to the middle of the object's ball, world units.
    pub start: [Vec<f64>; 3],
    /// Unit.
    pub normal: [Vec<f64>; 3],
    /// Which of [`RAYS`] sites each are there.
    pub present: Vec<u32>,
}

impl SiteRow {
    /// Room for `sites` sites, none of them there.
    pub fn clear(&mut self, sites: usize) {
        let packets = sites.div_ceil(RAYS);
        for plane in self.start.iter_mut().chain(&mut self.normal) {
            plane.resize(packets * RAYS, 0.0);
        }
        self.present.clear();
        self.present.resize(packets, 0);
    }

    pub fn set(&mut self, site: usize, start: DVec3, normal: DVec3) {
        for axis in 0..3 {
            self.start[axis][site] = start[axis];
            self.normal[axis][site] = normal[axis];
        }
        self.present[site / RAYS] |= 1 << (site % RAYS);
    }

    pub fn start_of(&self, site: usize) -> DVec3 {
        DVec3::new(self.start[0][site], self.start[1][site], self.start[2][site])
    }

    pub fn normal_of(&self, site: usize) -> DVec3 {
        DVec3::new(self.normal[0][site], self.normal[1][site], self.normal[2][site])
    }
}
