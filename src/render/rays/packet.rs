//! Sixteen rays that are asked about together.

use glam::DVec3;

/// Rays of a packet.
pub const RAYS: usize = 16;
/// Rays that are asked about together, relative to the model's origin.
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
        let of = |planes: &[[f64; RAYS]; 3]| DVec3::new(planes[0][ray], planes[1][ray], planes[2][ray]);
        (of(&self.origin), of(&self.direction), self.t_max[ray])
    }
}

/// The rays whose bits are set.
pub fn rays_of(bits: u32) -> impl Iterator<Item = usize> {
    (0..RAYS).filter(move |ray| bits >> ray & 1 == 1)
}
