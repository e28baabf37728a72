//! Where the equation is evaluated.

use super::V3;

/// A point where the equation is evaluated. Lengths are camera distances, positions relative to the eye.
#[derive(Clone, Copy, Debug)]
pub struct ShadingPoint<R> {
    /// N, unit unless the shading mode forgets to make it so.
    pub normal: V3<R>,
    pub position: V3<R>,
    /// V, unit.
    pub view: V3<R>,
    /// 1/distance from the eye.
    pub inverse_distance: R,
}
