//! Which light reaches which site: rays from the sites to the sources, a bit each.

use super::solid::Solid;
use crate::illumination::{Equation, Reached};
use crate::scene::{Backfacing, Light, Scene};
use glam::DVec3;

/// What casts shadows, and for which sources.
#[derive(Clone, Copy)]
pub(super) struct Shadows<'a> {
    pub solid: Solid<'a>,
    /// With the sources that the picture is shaded with, in their order.
    pub equation: &'a Equation<f64>,
    /// The height of the floor, if it is there.
    pub ground: Option<f64>,
    pub flip: bool,
    lights: &'a [Light],
}

impl<'a> Shadows<'a> {
    pub fn new(scene: &'a Scene, solid: Solid<'a>, equation: &'a Equation<f64>) -> Self {
        let ground = scene.ground.visible.then_some(scene.ground.height);
        let flip = scene.reflection.backfacing == Backfacing::Flip;
        Self { solid, equation, ground, flip, lights: &scene.lights }
    }

    /// Whether `source` reaches a site at `start`, world, with normal `n`. A source behind the surface reaches it as far as
    /// shadows go: the equation itself leaves it out.
    pub fn reaches(&self, source: usize, start: DVec3, n: DVec3) -> bool {
        let (direction, t_max) = self.equation.way_to(source, start);
        let facing = n.dot(direction);
        if facing <= 0.0 && !self.flip {
            return true;
        }
        let start = start + n * self.solid.clearance().copysign(facing);
        // A convex solid lies behind the tangent plane of each of its points.
        let alone = self.solid.is_convex() && facing > 0.0;
        !self.is_underground(start, direction, t_max) && (alone || !self.solid.blocks(start, direction, t_max))
    }

    fn is_underground(&self, start: DVec3, direction: DVec3, t_max: f64) -> bool {
        self.ground.is_some_and(|height| {
            let t = (height - start.y) / direction.y;
            t > 0.0 && t < t_max
        })
    }

    /// Whether nothing can stand between a point and a light of the scene: the object's ball does not come as near to the
    /// way between them as the light's ball is wide.
    pub fn is_clear_of(&self, light: usize, point: DVec3) -> bool {
        let Some(light) = self.lights.get(light).filter(|light| light.kind.has_position()) else { return false };
        let (centre, radius) = self.solid.ball();
        let way = light.position - point;
        let t = ((centre - point).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        // False where any of it is not a number.
        self.ground.is_none_or(|height| light.position.y - light.reach() > height)
            && (point + way * t - centre).length() > (radius + light.reach()) * (1.0 + 1e-9)
    }

    /// Whether nothing stands between `start` and `start + t_max·direction`.
    pub fn is_open(&self, start: DVec3, direction: DVec3, t_max: f64) -> bool {
        !self.is_underground(start, direction, t_max) && !self.solid.blocks(start, direction, t_max)
    }

    /// Sets the bits of the sources that reach a site; `words` has one row of `stride` words a source.
    pub fn mark(&self, start: DVec3, n: DVec3, bit: usize, stride: usize, words: &mut [u64]) {
        for source in 0..self.equation.sources.len() {
            if self.reaches(source, start, n) {
                words[source * stride + bit / 64] |= 1 << (bit % 64);
            }
        }
    }
}

/// The bits of a whole picture or of all points: blocks of sites, each with a row of bits a source.
#[derive(Default)]
pub(super) struct Reach {
    pub words: Vec<u64>,
    /// Words of one block.
    pub block: usize,
    /// Words of one source within a block.
    pub stride: usize,
}

impl Reach {
    /// Room for `blocks` blocks of `sites` sites, all in shadow.
    pub fn clear(&mut self, blocks: usize, sites: usize, sources: usize) {
        self.stride = sites.div_ceil(64);
        // One word more, since bits are read two words at a time.
        self.block = sources * self.stride + 1;
        self.words.clear();
        self.words.resize(blocks * self.block, 0);
    }

    /// The bits from site `first` of a block on.
    pub fn at(&self, block: usize, first: usize) -> Option<Reached<'_>> {
        let words = self.words.get(block * self.block..(block + 1) * self.block)?;
        (self.block > 0).then_some(Reached { words, stride: self.stride, first })
    }
}
