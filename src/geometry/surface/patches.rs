//! The teapot's patches, cut into small ones, in a tree of boxes.
//!
//! A box holds the control points of its patches and with them the patches themselves, so the tree loses nothing of the
//! outline.

use super::patch_ray::meet;
use super::solids::{Meeting, UnitRay};
use crate::geometry::bezier::Patch;
use crate::geometry::teapot::TEAPOT;
use glam::{DVec2, DVec3};
use std::sync::LazyLock;

/// Each patch is quartered so often: 32 · 4⁴ leaves, small enough that nearly all are met by one Newton iteration.
const QUARTERINGS: u32 = 4;

/// Boxes are wider by this, in world units, than what they hold: more than the rounding of a ray's meeting with them.
const SLACK: f64 = 1e-9;

/// A direction's component is at least this, so that its reciprocal is finite.
const LEAST_COMPONENT: f64 = 1e-100;

struct Tree {
    nodes: Vec<Node>,
    leaves: Vec<Patch<DVec3>>,
}

struct Node {
    low: DVec3,
    high: DVec3,
    /// The first of its two children, which lie side by side, or its leaf.
    index: u32,
    is_leaf: bool,
}

static TREE: LazyLock<Tree> = LazyLock::new(Tree::of_teapot);

pub fn teapot(ray: &UnitRay) -> Option<Meeting> {
    TREE.nearest(ray)
}

fn box_of(patch: &Patch<DVec3>) -> (DVec3, DVec3) {
    let first = patch.points[0];
    patch
        .points
        .iter()
        .fold((first, first), |(low, high), &p| (low.min(p), high.max(p)))
}

/// A ray prepared for boxes and patches.
struct Caster {
    origin: DVec3,
    direction: DVec3,
    reciprocal: DVec3,
    /// With the direction an orthonormal basis.
    across: [DVec3; 2],
    s_min: f64,
}

impl Caster {
    fn of(ray: &UnitRay) -> Self {
        let (a, b) = ray.direction.any_orthonormal_pair();
        let component = |d: f64| {
            if d.abs() < LEAST_COMPONENT {
                LEAST_COMPONENT.copysign(d)
            } else {
                d
            }
        };
        let d = ray.direction;
        let reciprocal = DVec3::new(component(d.x), component(d.y), component(d.z)).recip();
        Self {
            origin: ray.origin,
            direction: d,
            reciprocal,
            across: [a, b],
            s_min: ray.s_min,
        }
    }

    /// Where the ray enters a box, if it does so before `s_max`.
    fn enters(&self, node: &Node, s_max: f64) -> Option<f64> {
        let low = (node.low - self.origin) * self.reciprocal;
        let high = (node.high - self.origin) * self.reciprocal;
        let enter = low.min(high).max_element().max(self.s_min);
        let leave = low.max(high).min_element().min(s_max);
        (enter <= leave).then_some(enter)
    }

    /// The nearest meeting with a patch before `s_max`.
    fn meets(&self, leaf: &Patch<DVec3>, s_max: f64) -> Option<Meeting> {
        let flat = leaf.map(|p| {
            let p = p - self.origin;
            DVec2::new(p.dot(self.across[0]), p.dot(self.across[1]))
        });
        let mut nearest = (s_max, None);
        meet(&flat, |u, v| {
            let s = (leaf.at(u, v) - self.origin).dot(self.direction);
            if s > self.s_min && s < nearest.0 {
                nearest = (s, Some((u, v)));
            }
        });
        let (s, uv) = nearest;
        uv.map(|(u, v)| Meeting {
            s,
            normal: leaf.normal(u, v),
        })
    }
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
            leaves,
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

    /// Makes node `at` hold the leaves listed, halving them where their middles spread most.
    fn build(&mut self, at: usize, order: &mut [u32]) {
        let boxes = order
            .iter()
            .map(|&leaf| box_of(&self.leaves[leaf as usize]));
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
            let (low, high) = box_of(&self.leaves[*leaf as usize]);
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

    /// Walks the boxes that the ray enters, nearer ones first, and leaves out those behind the nearest meeting so far.
    fn nearest(&self, ray: &UnitRay) -> Option<Meeting> {
        /// The tree is halved at every level, so its depth is the logarithm of its leaves.
        const DEPTH: usize = 40;
        let caster = Caster::of(ray);
        let mut nearest: Option<Meeting> = None;
        let mut waiting = [(0, 0.0); DEPTH];
        let mut count = 0;
        let mut next = caster
            .enters(&self.nodes[0], f64::INFINITY)
            .map(|enter| (0, enter));
        while let Some((node, enter)) = next {
            let s_max = nearest.map_or(f64::INFINITY, |meeting| meeting.s);
            let node = &self.nodes[node as usize];
            next = None;
            if enter > s_max {
            } else if node.is_leaf {
                nearest = caster
                    .meets(&self.leaves[node.index as usize], s_max)
                    .or(nearest);
            } else {
                let entered = |child: u32| {
                    caster
                        .enters(&self.nodes[child as usize], s_max)
                        .map(|s| (child, s))
                };
                next = match (entered(node.index), entered(node.index + 1)) {
                    (Some(a), Some(b)) => {
                        let (near, far) = if a.1 <= b.1 { (a, b) } else { (b, a) };
                        waiting[count] = far;
                        count += 1;
                        Some(near)
                    }
                    (a, b) => a.or(b),
                };
            }
            if next.is_none() && count > 0 {
                count -= 1;
                next = Some(waiting[count]);
            }
        }
        nearest
    }
}
