//! Which light reaches which site: rays from the sites to the sources, a bit each.

mod cast;
mod proof;
mod site_row;

pub(super) use cast::{Cast, Waiting};
pub(super) use site_row::SiteRow;

use super::solid::Solid;
use crate::illumination::{Equation, Reached, area_hull};
use crate::scene::{AreaShape, Backfacing, Light, LightKind, Scene};
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
        let mut start = start + n * self.solid.clearance().copysign(facing);
        start.y = start.y.max(self.least_height());
        // A convex solid lies behind the tangent plane of each of its points.
        let alone = self.solid.is_convex() && facing > 0.0;
        !self.is_underground(start, direction, t_max) && (alone || !self.solid.blocks(start, direction, t_max))
    }

    /// The height that the object's own sites have at least: on an object that stands on the floor or above it none lies beneath,
    /// though normals that lean out of its faces lift some there.
    fn least_height(&self) -> f64 {
        let ground = self.ground.filter(|ground| self.solid.lowest() >= ground - self.solid.clearance());
        ground.unwrap_or(f64::NEG_INFINITY)
    }

    fn is_underground(&self, start: DVec3, direction: DVec3, t_max: f64) -> bool {
        self.ground.is_some_and(|height| {
            let t = (height - start.y) / direction.y;
            t > 0.0 && t < t_max
        })
    }

    /// What is known of the samples of a light, by its index in the scene, without following a ray to each.
    pub fn all_of(&self, light: usize, start: DVec3) -> Extent {
        let Some(light) = self.lights.get(light).filter(|light| light.kind.has_position()) else {
            return Extent::Unknown;
        };
        if self.ground.is_some_and(|height| light.position.y - light.reach() <= height) {
            return Extent::Unknown;
        }
        let (centre, radius) = self.solid.ball();
        let way = light.position - start;
        let t = ((centre - start).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        let distance = (start + way * t - centre).length();
        if distance > (radius + light.reach()) * (1.0 + ROUNDING) {
            return Extent::Clear;
        }
        if light.kind != LightKind::Area {
            return Extent::Unknown;
        }
        let corners = area_hull(light);
        if light.shape == AreaShape::Rectangle && is_beside(start, &corners, centre - start, radius) {
            return Extent::Clear;
        }
        if !self.solid.is_convex() {
            return Extent::Unknown;
        }
        // What a convex solid hides of a convex light is convex: with all its corners hidden nothing is seen, and on a line
        // the hidden points lie side by side.
        if corners.iter().all(|corner| self.solid.blocks(start, *corner - start, 1.0)) {
            return Extent::Hidden;
        }
        if light.shape == AreaShape::Rectangle { Extent::Rows(light.samples) } else { Extent::Unknown }
    }

    /// Whether nothing stands between `start` and `start + t_max·direction`.
    pub fn is_open(&self, start: DVec3, direction: DVec3, t_max: f64) -> bool {
        !self.is_underground(start, direction, t_max) && !self.solid.blocks(start, direction, t_max)
    }
}

/// How much of a light is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Extent {
    /// All of it.
    Clear,
    /// Nothing.
    Hidden,
    /// Rays have to find out; those of a row of so many samples that are hidden follow each other.
    Rows(u32),
    /// Rays have to find out.
    Unknown,
}

/// Rounding errors that a proof leaves room for.
const ROUNDING: f64 = 1e-9;

/// Whether a ball, from `start` at `towards`, lies beside the pyramid whose apex is `start` and whose base has these
/// corners: beyond one of the planes through the apex and an edge.
fn is_beside(start: DVec3, corners: &[DVec3], towards: DVec3, radius: f64) -> bool {
    let base = corners.iter().sum::<DVec3>() / corners.len() as f64 - start;
    (0..corners.len()).any(|k| {
        let (a, b) = (corners[k] - start, corners[(k + 1) % corners.len()] - start);
        let across = a.cross(b);
        // Outwards: away from the base's middle.
        let outwards = if across.dot(base) > 0.0 { -across } else { across };
        outwards.dot(towards) > radius * outwards.length() * (1.0 + ROUNDING) && outwards.length_squared() > 0.0
    })
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
    /// Room for `blocks` blocks of `sites` sites, none in shadow.
    pub fn clear(&mut self, blocks: usize, sites: usize, sources: usize) {
        self.stride = sites.div_ceil(64);
        // One word more, since bits are read two words at a time.
        self.block = sources * self.stride + 1;
        self.words.clear();
        self.words.resize(blocks * self.block, u64::MAX);
    }

    /// The bits from site `first` of a block on.
    pub fn at(&self, block: usize, first: usize) -> Option<Reached<'_>> {
        let words = self.words.get(block * self.block..(block + 1) * self.block)?;
        (self.block > 0).then_some(Reached { words, stride: self.stride, first })
    }
}
