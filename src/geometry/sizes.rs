//! The sizes of the built-in shapes, and the positions of points that meshes and true surfaces share.

use glam::{DVec2, DVec3};

pub const TORUS_RING: f64 = 0.7;
pub const TORUS_TUBE: f64 = 0.3;
pub const CYLINDER: Frustum = Frustum {
    bottom: 0.6,
    top: 0.6,
    low: -0.8,
    high: 0.8,
};
pub const CONE: Frustum = Frustum {
    bottom: 0.8,
    top: 0.0,
    low: -0.6,
    high: 1.0,
};
/// 1/√3: the corners of the cube lie on the unit sphere.
pub const CUBE_HALF_EDGE: f64 = 0.577_350_269_189_625_8;

/// Half the extent of the corrugated sheet across (x) and along its ridges (y): its corners lie in the unit sphere.
pub const CORRUGATED_HALF_WIDTH: f64 = 0.75;
pub const CORRUGATED_HALF_HEIGHT: f64 = 0.65;
/// The distance of the ridges before the sheet's middle, and of the troughs behind it.
pub const CORRUGATED_RIDGE: f64 = 0.1;

/// A cylinder or a cone about the y axis, with caps; pointed where `top` is 0.
pub struct Frustum {
    /// Radius at `low`.
    pub bottom: f64,
    /// Radius at `high`.
    pub top: f64,
    pub low: f64,
    pub high: f64,
}

impl Frustum {
    /// Returns the growth of the radius for each unit downwards.
    pub fn slope(&self) -> f64 {
        (self.bottom - self.top) / (self.high - self.low)
    }
}

/// Returns x and z of slope `slope` of the corrugated sheet after the part `t` of it.
pub fn corrugated_point(slopes: u32, slope: u32, t: f64) -> DVec2 {
    let z = |k: u32| {
        if k.is_multiple_of(2) {
            -CORRUGATED_RIDGE
        } else {
            CORRUGATED_RIDGE
        }
    };
    let x = (2.0 * (f64::from(slope) + t) / f64::from(slopes) - 1.0) * CORRUGATED_HALF_WIDTH;
    DVec2::new(x, z(slope) * (1.0 - t) + z(slope + 1) * t)
}

/// Returns the normal of a slope of the corrugated sheet, towards +z.
pub fn corrugated_normal(slopes: u32, slope: u32) -> DVec3 {
    let run = 2.0 * CORRUGATED_HALF_WIDTH / f64::from(slopes);
    let rise = if slope.is_multiple_of(2) {
        2.0 * CORRUGATED_RIDGE
    } else {
        -2.0 * CORRUGATED_RIDGE
    };
    DVec3::new(-rise, 0.0, run).normalize()
}
