//! A hierarchy of boxes over a model's triangles, for the intersection with rays.
//!
//! Boxes are split where the surface area heuristic is smallest over a few bins (I. Wald, *On fast construction of SAH-based
//! bounding volume hierarchies*, 2007). Coordinates are those of the model, relative to its origin.

use crate::render::model::Model;
use crate::render::node::{Memory, capacity};
use glam::Vec3;
use rayon::join;

/// The most triangles in a leaf.
const LEAF: usize = 4;
/// The bins that a box's centres are sorted into.
const BINS: usize = 12;
/// The depth beyond which boxes are split into halves of equal number, which bounds the depth.
const UNEVEN_DEPTH: usize = 40;
/// The largest depth: [`UNEVEN_DEPTH`] and as often as 2³² triangles can be halved.
pub const DEPTH: usize = 80;
/// The number of triangles from which both halves are built in parallel.
const PARALLEL: usize = 4096;

/// A box and its contents: children, or triangles.
#[derive(Clone, Copy, Debug, Default)]
pub struct Node {
    pub low: [f32; 3],
    pub high: [f32; 3],
    /// The right child (the left one follows its parent), or the first triangle.
    pub start: u32,
    /// The number of triangles; 0 for a box with children.
    pub count: u32,
}

impl Node {
    /// Returns a radius that holds the box, relative to the model's origin.
    pub fn radius(&self) -> f32 {
        Vec3::from_array(self.low)
            .abs()
            .max(Vec3::from_array(self.high).abs())
            .length()
    }
}

#[derive(Default)]
pub struct Bvh {
    pub nodes: Vec<Node>,
    /// The corners in the order of the leaves.
    pub corners: Vec<[Vec3; 3]>,
    /// The indices of the triangles in the order of the leaves.
    pub order: Vec<u32>,
    /// The radius of a ball about the model's origin that lies within the solid; 0 if none is known.
    pub inner_radius: f64,
}

#[derive(Clone, Copy)]
struct Bounds {
    low: Vec3,
    high: Vec3,
}

impl Bounds {
    const EMPTY: Self = Self {
        low: Vec3::INFINITY,
        high: Vec3::NEG_INFINITY,
    };

    fn union(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    fn point(p: Vec3) -> Self {
        Self { low: p, high: p }
    }

    fn half_area(self) -> f32 {
        let size = (self.high - self.low).max(Vec3::ZERO);
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

/// A triangle while the hierarchy is built.
#[derive(Clone, Copy)]
struct Item {
    bounds: Bounds,
    centre: Vec3,
    triangle: u32,
}

impl Bvh {
    pub fn new(model: &Model) -> Self {
        let corner = |v: u32| model.place(v);
        let corners_of = |triangle: &[u32; 3]| triangle.map(corner);
        let mut items: Vec<Item> = (0_u32..)
            .zip(&model.triangles)
            .map(|(triangle, vertices)| {
                let [a, b, c] = corners_of(vertices).map(Bounds::point);
                let bounds = a.union(b).union(c);
                Item {
                    bounds,
                    centre: (bounds.low + bounds.high) * 0.5,
                    triangle,
                }
            })
            .collect();
        if items.is_empty() {
            return Self::default();
        }
        let mut nodes = vec![Node::default(); 2 * items.len()];
        build(&mut items, &mut nodes, 0, 0, 0);
        let order: Vec<u32> = items.iter().map(|item| item.triangle).collect();
        let corners: Vec<_> = order
            .iter()
            .map(|&triangle| corners_of(&model.triangles[triangle as usize]))
            .collect();
        let inner_radius = if model.closed && model.convex {
            inner_radius(&corners)
        } else {
            0.0
        };
        Self {
            nodes,
            corners,
            order,
            inner_radius,
        }
    }

    pub fn count(&self, memory: &mut Memory) {
        memory.triangles += capacity(&self.nodes) + capacity(&self.corners) + capacity(&self.order);
    }

    pub fn lowest(&self) -> f64 {
        self.nodes
            .first()
            .map_or(0.0, |root| f64::from(root.low[1]))
    }
}

/// Returns the distance of the origin from the nearest of a convex solid's planes, a little less for rounding.
fn inner_radius(corners: &[[Vec3; 3]]) -> f64 {
    let distance = |triangle: &[Vec3; 3]| {
        let [a, b, c] = triangle.map(|corner| corner.as_dvec3());
        (b - a)
            .cross(c - a)
            .try_normalize()
            .map(|normal| normal.dot(a))
    };
    corners
        .iter()
        .filter_map(distance)
        .fold(f64::INFINITY, f64::min)
        .max(0.0)
        * (1.0 - 1e-5)
}

/// Builds the box of `items` at `nodes[0]`, node `index` of all; `first` is the index of the first item among all.
fn build(items: &mut [Item], nodes: &mut [Node], index: u32, first: u32, depth: usize) {
    let bounds = items
        .iter()
        .fold(Bounds::EMPTY, |sum, item| sum.union(item.bounds));
    let node = Node {
        low: bounds.low.to_array(),
        high: bounds.high.to_array(),
        start: first,
        count: 0,
    };
    if items.len() <= LEAF {
        nodes[0] = Node {
            count: items.len() as u32,
            ..node
        };
        return;
    }
    let middle = split(items, depth);
    let (left, right) = items.split_at_mut(middle);
    // A box of m triangles takes at most 2m − 1 nodes, so the right child's index is known before the left is built.
    let (own, rest) = nodes.split_at_mut(1);
    let (left_nodes, right_nodes) = rest.split_at_mut(2 * middle - 1);
    let right_index = index + 2 * middle as u32;
    own[0] = Node {
        start: right_index,
        ..node
    };
    let right_first = first + middle as u32;
    let parallel = left.len().min(right.len()) > PARALLEL;
    let mut build_left = || build(left, left_nodes, index + 1, first, depth + 1);
    let mut build_right = || build(right, right_nodes, right_index, right_first, depth + 1);
    if parallel {
        join(build_left, build_right);
    } else {
        build_left();
        build_right();
    }
}

/// Divides `items` into two parts, neither of them empty, and returns the first part's length.
fn split(items: &mut [Item], depth: usize) -> usize {
    let centres = items.iter().fold(Bounds::EMPTY, |sum, item| {
        sum.union(Bounds::point(item.centre))
    });
    let size = centres.high - centres.low;
    let axis = size.max_position();
    let half = items.len() / 2;
    if size[axis] > 0.0 && depth < UNEVEN_DEPTH {
        let scale = BINS as f32 / size[axis];
        let bin = |item: &Item| {
            (((item.centre[axis] - centres.low[axis]) * scale) as usize).min(BINS - 1)
        };
        let edge = cheapest(items, bin);
        let middle = partition(items, |item| bin(item) < edge);
        if middle > 0 && middle < items.len() {
            return middle;
        }
    }
    items.select_nth_unstable_by(half, |a, b| a.centre[axis].total_cmp(&b.centre[axis]));
    half
}

/// Returns the first bin of the second part, such that area times number, summed over both parts, is smallest.
fn cheapest(items: &[Item], bin: impl Fn(&Item) -> usize) -> usize {
    let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
    for item in items {
        let (bounds, count) = &mut bins[bin(item)];
        *bounds = bounds.union(item.bounds);
        *count += 1;
    }
    let cost = |part: &[(Bounds, usize)]| {
        let (bounds, count) = part
            .iter()
            .fold((Bounds::EMPTY, 0), |(b, n), (c, m)| (b.union(*c), n + m));
        if count == 0 {
            0.0
        } else {
            bounds.half_area() * count as f32
        }
    };
    let whole = |edge: &usize| cost(&bins[..*edge]) + cost(&bins[*edge..]);
    (1..BINS)
        .min_by(|a, b| whole(a).total_cmp(&whole(b)))
        .unwrap_or(1)
}

/// Moves the items that are `first` before the others; returns their number.
fn partition(items: &mut [Item], first: impl Fn(&Item) -> bool) -> usize {
    let mut middle = 0;
    for index in 0..items.len() {
        if first(&items[index]) {
            items.swap(index, middle);
            middle += 1;
        }
    }
    middle
}
