//! The sizes of the built-in shapes.

pub const TORUS_RING: f64 = 0.7;
pub const TORUS_TUBE: f64 = 0.3;
pub const CYLINDER_RADIUS: f64 = 0.6;
pub const CYLINDER_HALF_HEIGHT: f64 = 0.8;
pub const CONE_RADIUS: f64 = 0.8;
pub const CONE_BASE: f64 = -0.6;
pub const CONE_APEX: f64 = 1.0;
/// 1/√3: the corners of the cube lie on the unit sphere.
pub const CUBE_HALF_EDGE: f64 = 0.577_350_269_189_625_8;

/// Half the extent of the corrugated sheet across (x) and along its ridges (y): its corners lie in the unit sphere.
pub const CORRUGATED_HALF_WIDTH: f64 = 0.75;
pub const CORRUGATED_HALF_HEIGHT: f64 = 0.65;
/// How far the ridges stand before the sheet's middle, and the troughs behind it.
pub const CORRUGATED_RIDGE: f64 = 0.1;
