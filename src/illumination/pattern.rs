//! Patterns of two colours laid out over space.

use super::{Real, Scalar, V3};
use crate::scene::PatternKind;
use glam::DVec3;

/// A pattern in a frame of its own: coordinates are `scale · position + offset`, fields are 1 wide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fields<T> {
    kind: PatternKind,
    /// The axis that rings lie about.
    axis: usize,
    scale: T,
    offset: [T; 3],
    /// Half the width of a field, and [`BORDER`].
    half: T,
}

/// The shift of borders, as a part of the eye's distances from origin and target: more than single precision rounds
/// positions by. So a point on a nominal border, as vertices often are, is in the same field in every precision.
const BORDER: f64 = 1.0 / (1 << 21) as f64;

impl<T: Scalar> Fields<T> {
    /// Returns the fields of `kind`, `width` world units wide, rings about axis `axis` (0 to 2), for positions that are
    /// `unit` world units long and start from `origin`; `None` where there is no pattern.
    pub fn new(
        kind: PatternKind,
        width: f64,
        axis: usize,
        origin: DVec3,
        unit: f64,
    ) -> Option<Self> {
        let offset = (origin / width).to_array().map(T::from_f64);
        let border = (BORDER * (unit + origin.abs().max_element()) / width).min(0.25);
        let (scale, half) = (T::from_f64(unit / width), T::from_f64(0.5 + border));
        (kind != PatternKind::None).then_some(Self {
            kind,
            axis,
            scale,
            offset,
            half,
        })
    }

    /// Returns whether the pattern covers a point, so that its own colour is seen there.
    #[inline(always)]
    pub fn lie_on<R: Real<Scalar = T>>(&self, position: V3<R>) -> R::Mask {
        let like = position.x;
        let half = like.constant(self.half);
        let p = position.scale_add(like.constant(self.scale), V3::constant(like, self.offset));
        let count = match self.kind {
            PatternKind::None | PatternKind::Checker => {
                (p.x + half).floor() + (p.y + half).floor() + (p.z + half).floor()
            }
            PatternKind::Stripes => (p.y + half).floor(),
            PatternKind::Rings => {
                let [a, b] = match self.axis {
                    0 => [p.y, p.z],
                    1 => [p.x, p.z],
                    _ => [p.x, p.y],
                };
                (a.mul_add(a, b * b).sqrt() + half).floor()
            }
        };
        // Odd fields: count − 2⌊count/2⌋ is 1.
        let pairs = (count * T::from_f64(0.5)).floor();
        (count - pairs - pairs).greater_than(like.number(0.5))
    }
}
