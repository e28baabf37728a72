//! The teapot's patches, cut into small ones, in a tree of bounding boxes.
//!
//! A box holds the control points of its patches and with them the patches themselves, so the tree loses nothing of the
//! outline.

use super::RAYS_TOGETHER;
use super::leaf::{Leaf, QUAD, Quad};
use super::patch_ray::meet;
use super::solids::{Meeting, UnitRay};
use crate::geometry::bezier::Patch;
use crate::geometry::descent::{Descent, nearer_first};
use crate::geometry::teapot::TEAPOT;
use crate::geometry::vector::load;
use fearless_simd::{f64x8, prelude::*};
use glam::{DVec2, DVec3};
use std::array;
use std::sync::LazyLock;

/// The number of times each patch is quartered: 32 · 4⁴ leaves, small enough that nearly all are met by one Newton iteration.
const QUARTERINGS: u32 = 4;

/// The margin of the boxes in world units: more than the rounding of a ray's meeting with them.
const SLACK: f64 = 1e-9;

/// The smallest component of a direction, so that its reciprocal is finite.
const LEAST_COMPONENT: f64 = 1e-100;

struct Tree {
    nodes: Vec<Node>,
    leaves: Vec<Leaf>,
}

struct Node {
    low: DVec3,
    high: DVec3,
    /// The index of the first of its two children, which are adjacent, or of its leaf.
    index: u32,
    is_leaf: bool,
}

static TREE: LazyLock<Tree> = LazyLock::new(Tree::of_teapot);

/// Returns the nearest meetings of the rays whose bits are set in `requested`.
#[inline(always)]
pub fn teapot<S: Simd>(
    simd: S,
    rays: &[UnitRay; RAYS_TOGETHER],
    requested: u32,
) -> [Option<Meeting>; RAYS_TOGETHER] {
    let tree = &*TREE;
    let found = tree.nearest(simd, rays, requested);
    let meeting = |ray: usize| {
        let LeafHit { leaf, uv, .. } = found[ray];
        let patch = &tree.leaves.get(leaf?)?.patch;
        let s = (patch.at(uv.x, uv.y) - rays[ray].origin).dot(rays[ray].direction);
        Some(Meeting {
            s,
            normal: patch.normal(uv.x, uv.y),
        })
    };
    array::from_fn(meeting)
}

fn box_of(patch: &Patch<DVec3>) -> (DVec3, DVec3) {
    let first = patch.points[0];
    patch
        .points
        .iter()
        .fold((first, first), |(low, high), &p| (low.min(p), high.max(p)))
}

#[derive(Clone, Copy)]
struct LeafHit {
    s: f64,
    leaf: Option<usize>,
    uv: DVec2,
}

/// Rays prepared for the test against boxes.
struct Rays<S: Simd> {
    origin: [f64x8<S>; 3],
    reciprocal: [f64x8<S>; 3],
    s_min: f64x8<S>,
}

impl<S: Simd> Rays<S> {
    #[inline(always)]
    fn new(simd: S, rays: &[UnitRay; RAYS_TOGETHER]) -> Self {
        let (mut origin, mut reciprocal, mut s_min) = (
            [[0.0; RAYS_TOGETHER]; 3],
            [[0.0; RAYS_TOGETHER]; 3],
            [0.0; RAYS_TOGETHER],
        );
        for (k, ray) in rays.iter().enumerate() {
            for axis in 0..3 {
                let d = ray.direction[axis];
                let component = if d.abs() < LEAST_COMPONENT {
                    LEAST_COMPONENT.copysign(d)
                } else {
                    d
                };
                origin[axis][k] = ray.origin[axis];
                reciprocal[axis][k] = 1.0 / component;
            }
            s_min[k] = ray.s_min;
        }
        Self {
            origin: load(simd, &origin, 0),
            reciprocal: load(simd, &reciprocal, 0),
            s_min: f64x8::from_slice(simd, &s_min),
        }
    }

    /// Finds the rays that enter a box before `s_max`, and the points where they do.
    #[inline(always)]
    fn enter(&self, simd: S, node: &Node, s_max: f64x8<S>) -> (u32, f64x8<S>) {
        let (mut enter, mut leave) = (self.s_min, s_max);
        for axis in 0..3 {
            let low =
                (f64x8::splat(simd, node.low[axis]) - self.origin[axis]) * self.reciprocal[axis];
            let high =
                (f64x8::splat(simd, node.high[axis]) - self.origin[axis]) * self.reciprocal[axis];
            enter = enter.max(low.min(high));
            leave = leave.min(low.max(high));
        }
        (enter.simd_le(leave).to_bitmask() as u32, enter)
    }
}

/// Finds the nearest meeting with a patch beyond the ray's start and before `s_max`, by halving where the patch may fold.
fn meet_folded(ray: &UnitRay, patch: &Patch<DVec3>, s_max: f64) -> Option<(f64, DVec2)> {
    let (a, b) = ray.direction.any_orthonormal_pair();
    let flat = patch.map(|p| {
        let p = p - ray.origin;
        DVec2::new(p.dot(a), p.dot(b))
    });
    let mut nearest = (s_max, None);
    meet(&flat, |u, v| {
        let s = (patch.at(u, v) - ray.origin).dot(ray.direction);
        if s > ray.s_min && s < nearest.0 {
            nearest = (s, Some(DVec2::new(u, v)));
        }
    });
    let (s, uv) = nearest;
    uv.map(|uv| (s, uv))
}

impl Tree {
    fn of_teapot() -> Self {
        let mut leaves: Vec<Patch<DVec3>> = (0..TEAPOT.patches.len())
            .map(|patch| TEAPOT.patch(patch))
            .collect();
        for _ in 0..QUARTERINGS {
            leaves = leaves.iter().flat_map(Patch::quarters).collect();
        }
        let mut order: Vec<u32> = (0..leaves.len() as u32).collect();
        let mut tree = Self {
            nodes: Vec::with_capacity(2 * leaves.len()),
            leaves: leaves.into_iter().map(Leaf::new).collect(),
        };
        tree.nodes.push(Node {
            low: DVec3::ZERO,
            high: DVec3::ZERO,
            index: 0,
            is_leaf: true,
        });
        tree.build(0, &mut order);
        tree
    }

    /// Makes node `at` hold the leaves listed, halving them along the axis on which their middles spread most.
    fn build(&mut self, at: usize, order: &mut [u32]) {
        let boxes = order
            .iter()
            .map(|&leaf| box_of(&self.leaves[leaf as usize].patch));
        let nothing = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (low, high) = boxes
            .clone()
            .fold(nothing, |all, one| (all.0.min(one.0), all.1.max(one.1)));
        let middles = boxes
            .map(|(low, high)| low + high)
            .fold(nothing, |all, m| (all.0.min(m), all.1.max(m)));
        self.nodes[at].low = low - SLACK;
        self.nodes[at].high = high + SLACK;
        if let [leaf] = *order {
            self.nodes[at].index = leaf;
            return;
        }
        let axis = (middles.1 - middles.0).max_position();
        let middle = |leaf: &u32| {
            let (low, high) = box_of(&self.leaves[*leaf as usize].patch);
            low[axis] + high[axis]
        };
        let half = order.len() / 2;
        order.select_nth_unstable_by(half, |a, b| middle(a).total_cmp(&middle(b)));
        let children = self.nodes.len();
        for _ in 0..2 {
            self.nodes.push(Node {
                low,
                high,
                index: 0,
                is_leaf: true,
            });
        }
        (self.nodes[at].index, self.nodes[at].is_leaf) = (children as u32, false);
        let (left, right) = order.split_at_mut(half);
        self.build(children, left);
        self.build(children + 1, right);
    }

    /// Visits the boxes that the rays enter, nearer ones first, except those behind the nearest meetings so far.
    #[inline(always)]
    fn nearest<S: Simd>(
        &self,
        simd: S,
        rays: &[UnitRay; RAYS_TOGETHER],
        requested: u32,
    ) -> [LeafHit; RAYS_TOGETHER] {
        /// The largest depth: the tree is halved at every level, so its depth is the logarithm of the number of leaves.
        const DEPTH: usize = 40;
        let lanes = Rays::new(simd, rays);
        let nothing = LeafHit {
            s: f64::INFINITY,
            leaf: None,
            uv: DVec2::ZERO,
        };
        let mut found = [nothing; RAYS_TOGETHER];
        let mut s_max = f64x8::splat(simd, f64::INFINITY);
        let mut descent = Descent::<DEPTH>::new();
        let (mut here, mut among) = (0, requested & lanes.enter(simd, &self.nodes[0], s_max).0);
        loop {
            let node = &self.nodes[here as usize];
            if among != 0 && node.is_leaf {
                if self.meet_leaf(simd, rays, node.index as usize, among, &mut found) {
                    s_max = f64x8::from_slice(
                        simd,
                        &found.map(
                            #[inline(always)]
                            |place| place.s,
                        ),
                    );
                }
            } else if among != 0 {
                let (left, right) = (node.index, node.index + 1);
                let (in_left, at_left) = lanes.enter(simd, &self.nodes[left as usize], s_max);
                let (in_right, at_right) = lanes.enter(simd, &self.nodes[right as usize], s_max);
                let children = [(left, in_left & among), (right, in_right & among)];
                let children = nearer_first(among, children, &[at_left, at_right]);
                if let Some(next) = descent.descend(children) {
                    (here, among) = next;
                    continue;
                }
            }
            let Some(next) = descent.pop() else {
                return found;
            };
            (here, among) = next;
            among &= lanes.enter(simd, &self.nodes[here as usize], s_max).0;
        }
    }

    /// Intersects rays with a leaf; returns whether any met it nearer than before.
    #[inline(always)]
    fn meet_leaf<S: Simd>(
        &self,
        simd: S,
        rays: &[UnitRay; RAYS_TOGETHER],
        index: usize,
        among: u32,
        found: &mut [LeafHit; RAYS_TOGETHER],
    ) -> bool {
        let leaf = &self.leaves[index];
        let mut nearer = false;
        for first in [0, QUAD] {
            let requested = (among >> first) & ((1 << QUAD) - 1);
            if requested == 0 {
                continue;
            }
            let quad = Quad::solve(simd, leaf, &rays[first..first + QUAD], requested);
            for lane in 0..QUAD {
                let (ray, place) = (&rays[first + lane], &mut found[first + lane]);
                let met = if quad.roots >> lane & 1 == 1 {
                    let s = quad.s[lane];
                    (s > ray.s_min && s < place.s)
                        .then(|| (s, DVec2::new(quad.uv[0][lane], quad.uv[1][lane])))
                } else if quad.undecided >> lane & 1 == 1 {
                    meet_folded(ray, &leaf.patch, place.s)
                } else {
                    None
                };
                if let Some((s, uv)) = met {
                    let leaf = Some(index);
                    *place = LeafHit { s, leaf, uv };
                    nearer = true;
                }
            }
        }
        nearer
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fearless_simd::{Level, dispatch};

    /// Returns the `k`th test ray towards the teapot.
    fn ray(k: usize) -> UnitRay {
        let part = |factor: f64| (k as f64 * factor).fract() * 2.0 - 1.0;
        let direction = DVec3::new(part(0.618_034), part(0.754_877), part(0.569_84)).normalize();
        let through = DVec3::new(part(0.438_579), 0.5 * part(0.324_718), part(0.220_744)) * 0.8;
        UnitRay {
            origin: through - direction * through.dot(direction),
            direction,
            s_min: -3.0,
        }
    }

    #[test]
    fn rays_side_by_side_meet_what_each_meets_alone_leaf_by_leaf() {
        let mut met = 0;
        for first in (0..1600).step_by(RAYS_TOGETHER) {
            let rays: [UnitRay; RAYS_TOGETHER] = array::from_fn(|k| ray(first + k));
            for level in [Level::new(), Level::baseline()] {
                let together = dispatch!(level, simd => teapot(simd, &rays, 0xff));
                for (ray, meeting) in rays.iter().zip(together) {
                    let alone = [*ray; RAYS_TOGETHER];
                    let alone = dispatch!(level, simd => teapot(simd, &alone, 1))[0];
                    let bits = |meeting: Option<Meeting>| meeting.map(|m| (m.s, m.normal));
                    assert_eq!(bits(alone), bits(meeting));
                }
            }
            if first % 64 != 0 {
                continue;
            }
            let together = dispatch!(Level::new(), simd => teapot(simd, &rays, 0xff));
            for (ray, meeting) in rays.iter().zip(together) {
                let nearest = TREE.leaves.iter().fold(f64::INFINITY, |nearest, leaf| {
                    meet_folded(ray, &leaf.patch, nearest).map_or(nearest, |(s, _)| s)
                });
                let found = meeting.map_or(f64::INFINITY, |meeting| meeting.s);
                assert!(
                    found == nearest || (found - nearest).abs() < 1e-9,
                    "{found} {nearest}"
                );
                met += usize::from(nearest.is_finite());
            }
        }
        assert!(met > 50, "{met}");
    }
}
