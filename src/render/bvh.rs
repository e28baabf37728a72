//! Triangles in, a hierarchy of boxes out, in which rays find them.
//!
//! Boxes are split where the surface area heuristic is least over a few bins (I. Wald, *On fast construction of SAH-based
//! bounding volume hierarchies*, 2007). Coordinates are those of the model, relative to its origin; rays are traced in
//! double precision against the same single-precision corners that are drawn.

mod packet;

pub(super) use packet::{Nearest, Packet, RAYS};

use super::memory::{Holds, Memory, room};
use super::model::Model;
use glam::{DVec3, Vec3, Vec3A};
use rayon::join;

/// Triangles in a leaf at most.
const LEAF: usize = 4;
/// Bins that a box's centres are sorted into.
const BINS: usize = 12;
/// Deeper than this, boxes are split into halves of equal number, which bounds the depth.
const UNEVEN_DEPTH: usize = 40;
/// Boxes that wait on the way down: one a level, [`UNEVEN_DEPTH`] and as many as 2³² triangles can be halved.
const STACK: usize = 80;
/// From this many triangles on, both halves are built at once.
const PARALLEL: usize = 4096;

/// A box, and what is in it: children, or triangles.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    low: [f32; 3],
    high: [f32; 3],
    /// The right child (the left one follows its parent), or the first triangle.
    start: u32,
    /// Triangles; 0 for a box with children.
    count: u32,
}

impl Node {
    /// A radius that holds the box, relative to the model's origin.
    fn reach(&self) -> f32 {
        Vec3::from_array(self.low).abs().max(Vec3::from_array(self.high).abs()).length()
    }
}

/// A hierarchy over a model's triangles.
#[derive(Default)]
pub(super) struct Bvh {
    nodes: Vec<Node>,
    /// Corners in the order of the leaves.
    corners: Vec<[Vec3; 3]>,
    /// Indices of the triangles in the same order.
    order: Vec<u32>,
    /// Radius of a ball about the model's origin that lies within the solid; 0 if none is known.
    inner_radius: f64,
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Meeting {
    pub t: f64,
    pub triangle: u32,
    /// Weights of the triangle's second and third corner.
    pub weights: [f64; 2],
}

#[derive(Clone, Copy)]
struct Bounds {
    low: Vec3,
    high: Vec3,
}

impl Bounds {
    const EMPTY: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
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

impl Holds for Bvh {
    fn memory(&self) -> Memory {
        Memory::of_triangles(room(&self.nodes) + room(&self.corners) + room(&self.order))
    }
}

impl Bvh {
    pub fn new(model: &Model) -> Self {
        let corner = |v: u32| model.place(v);
        let corners_of = |triangle: &[u32; 3]| triangle.map(corner);
        let mut items: Vec<Item> = (0_u32..)
            .zip(&model.triangles)
            .map(|(triangle, vertices)| {
                let [a, b, c] = corners_of(vertices).map(Bounds::point);
                let bounds = a.with(b).with(c);
                Item { bounds, centre: (bounds.low + bounds.high) * 0.5, triangle }
            })
            .collect();
        if items.is_empty() {
            return Self::default();
        }
        let mut nodes = vec![Node::default(); 2 * items.len()];
        build(&mut items, &mut nodes, 0, 0, 0);
        let order: Vec<u32> = items.iter().map(|item| item.triangle).collect();
        let corners: Vec<_> = order.iter().map(|&triangle| corners_of(&model.triangles[triangle as usize])).collect();
        let inner_radius = if model.closed && model.convex { inner_radius(&corners) } else { 0.0 };
        Self { nodes, corners, order, inner_radius }
    }

    /// Radius of a ball about the model's origin that lies within the solid; 0 if none is known.
    pub fn inner_radius(&self) -> f64 {
        self.inner_radius
    }

    /// The height of the lowest corner.
    pub fn lowest(&self) -> f64 {
        self.nodes.first().map_or(0.0, |root| f64::from(root.low[1]))
    }

    /// Whether anything lies on the ray `origin + t·direction` for 0 < t < `t_max`.
    pub fn blocks(&self, origin: DVec3, direction: DVec3, t_max: f64) -> bool {
        self.search(origin, direction, t_max, |_| true).is_some()
    }

    /// The first triangle on the ray.
    pub fn nearest(&self, origin: DVec3, direction: DVec3) -> Option<Meeting> {
        self.search(origin, direction, f64::INFINITY, |_| false)
    }

    /// Looks for the nearest meeting, until `enough` is satisfied with one.
    fn search(
        &self,
        origin: DVec3,
        direction: DVec3,
        t_max: f64,
        enough: impl Fn(&Meeting) -> bool,
    ) -> Option<Meeting> {
        let root = self.nodes.first()?;
        let slabs = Slabs::new(origin, direction);
        let mut found: Option<Meeting> = None;
        let mut limit = t_max;
        let mut stack = [0_u32; STACK];
        let mut waiting = 0;
        let mut here = 0_u32;
        slabs.enter(root, limit)?;
        loop {
            let node = &self.nodes[here as usize];
            if node.count > 0 {
                let range = node.start as usize..(node.start + node.count) as usize;
                for (corners, &triangle) in self.corners[range.clone()].iter().zip(&self.order[range]) {
                    let Some((t, weights)) = meet(corners, origin, direction, limit) else { continue };
                    limit = t;
                    let meeting = Meeting { t, triangle, weights };
                    if enough(&meeting) {
                        return Some(meeting);
                    }
                    found = Some(meeting);
                }
            } else {
                let (left, right) = (here + 1, node.start);
                let enter = |child: u32| slabs.enter(&self.nodes[child as usize], limit);
                match (enter(left), enter(right)) {
                    (Some(a), Some(b)) => {
                        let (near, far) = if a <= b { (left, right) } else { (right, left) };
                        stack[waiting] = far;
                        waiting += 1;
                        here = near;
                        continue;
                    }
                    (Some(_), None) => {
                        here = left;
                        continue;
                    }
                    (None, Some(_)) => {
                        here = right;
                        continue;
                    }
                    (None, None) => {}
                }
            }
            if waiting == 0 {
                return found;
            }
            waiting -= 1;
            here = stack[waiting];
        }
    }
}

/// A ray as boxes see it, in single precision: the boxes are widened by more than the rounding, so that none that is met
/// is missed.
#[derive(Clone, Copy)]
struct Slabs {
    /// The origin moved by the widening, for the low sides and for the high ones.
    from_low: Vec3A,
    from_high: Vec3A,
    inverse: Vec3A,
}

impl Slabs {
    /// What the boxes are widened by, as a part of the greatest coordinate: four roundings.
    const WIDENING: f64 = 4.0 * f32::EPSILON as f64;
    /// Stands for a component of the direction that is 0.
    const LEVEL: f64 = 1e-30;

    fn new(origin: DVec3, direction: DVec3) -> Self {
        let slope = |x: f64| if x.abs() < Self::LEVEL { Self::LEVEL.copysign(x) } else { x };
        let direction = DVec3::new(slope(direction.x), slope(direction.y), slope(direction.z));
        let widening = DVec3::splat(Self::WIDENING * origin.abs().max_element());
        let near = |v: DVec3| v.as_vec3().into();
        Self { from_low: near(origin + widening), from_high: near(origin - widening), inverse: near(direction.recip()) }
    }

    /// Where the ray enters a box, if it does so before `limit`.
    #[inline(always)]
    fn enter(&self, node: &Node, limit: f64) -> Option<f32> {
        let low = (Vec3A::from_array(node.low) - self.from_low) * self.inverse;
        let high = (Vec3A::from_array(node.high) - self.from_high) * self.inverse;
        let near = low.min(high).max_element().max(0.0);
        let far = low.max(high).min_element();
        // A part in 10⁶ for the rounding of the products.
        let met = near <= far * (1.0 + 1e-6) && f64::from(near) <= limit * (1.0 + 1e-6);
        met.then_some(near)
    }
}

/// The distance of the origin from the nearest of a convex solid's planes, a little less for rounding.
fn inner_radius(corners: &[[Vec3; 3]]) -> f64 {
    let distance = |triangle: &[Vec3; 3]| {
        let [a, b, c] = triangle.map(|corner| corner.as_dvec3());
        (b - a).cross(c - a).try_normalize().map(|normal| normal.dot(a))
    };
    corners.iter().filter_map(distance).fold(f64::INFINITY, f64::min).max(0.0) * (1.0 - 1e-5)
}

/// Edges are this much wider, as a part of the triangle, so that a ray through a shared edge misses neither.
const SEAM: f64 = 1e-9;

/// Where a ray meets a triangle with 0 < t < `limit`, and the weights of the second and third corner (T. Möller and
/// B. Trumbore, *Fast, minimum storage ray/triangle intersection*, 1997).
fn meet(corners: &[Vec3; 3], origin: DVec3, direction: DVec3, limit: f64) -> Option<(f64, [f64; 2])> {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let (e1, e2, from) = (b - a, c - a, origin - a);
    let p = direction.cross(e2);
    let determinant = e1.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let inverse = 1.0 / determinant;
    let w1 = from.dot(p) * inverse;
    if !(-SEAM..=1.0 + SEAM).contains(&w1) {
        return None;
    }
    let q = from.cross(e1);
    let w2 = direction.dot(q) * inverse;
    if w2 < -SEAM || w1 + w2 > 1.0 + SEAM {
        return None;
    }
    let t = e2.dot(q) * inverse;
    (t > 0.0 && t < limit).then_some((t, [w1, w2]))
}

/// Builds the box of `items` at `nodes[0]`, which stands at index `index` of all nodes; `first` is the index of the first
/// item among all.
fn build(items: &mut [Item], nodes: &mut [Node], index: u32, first: u32, depth: usize) {
    let bounds = items.iter().fold(Bounds::EMPTY, |sum, item| sum.with(item.bounds));
    let node = Node { low: bounds.low.to_array(), high: bounds.high.to_array(), start: first, count: 0 };
    if items.len() <= LEAF {
        nodes[0] = Node { count: items.len() as u32, ..node };
        return;
    }
    let middle = split(items, depth);
    let (left, right) = items.split_at_mut(middle);
    // A box of m triangles takes at most 2m − 1 places, so the right child's place is known before the left is built.
    let (own, rest) = nodes.split_at_mut(1);
    let (left_nodes, right_nodes) = rest.split_at_mut(2 * middle - 1);
    let right_index = index + 2 * middle as u32;
    own[0] = Node { start: right_index, ..node };
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
    let centres = items.iter().fold(Bounds::EMPTY, |sum, item| sum.with(Bounds::point(item.centre)));
    let size = centres.high - centres.low;
    let axis = size.max_position();
    let half = items.len() / 2;
    if size[axis] > 0.0 && depth < UNEVEN_DEPTH {
        let scale = BINS as f32 / size[axis];
        let bin = |item: &Item| (((item.centre[axis] - centres.low[axis]) * scale) as usize).min(BINS - 1);
        let edge = cheapest(items, bin);
        let middle = partition(items, |item| bin(item) < edge);
        if middle > 0 && middle < items.len() {
            return middle;
        }
    }
    items.select_nth_unstable_by(half, |a, b| a.centre[axis].total_cmp(&b.centre[axis]));
    half
}

/// The first bin of the second part, such that area times number, summed over both parts, is least.
fn cheapest(items: &[Item], bin: impl Fn(&Item) -> usize) -> usize {
    let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
    for item in items {
        let (bounds, count) = &mut bins[bin(item)];
        *bounds = bounds.with(item.bounds);
        *count += 1;
    }
    let cost = |part: &[(Bounds, usize)]| {
        let (bounds, count) = part.iter().fold((Bounds::EMPTY, 0), |(b, n), (c, m)| (b.with(*c), n + m));
        if count == 0 { 0.0 } else { bounds.half_area() * count as f32 }
    };
    let whole = |edge: &usize| cost(&bins[..*edge]) + cost(&bins[*edge..]);
    (1..BINS).min_by(|a, b| whole(a).total_cmp(&whole(b))).unwrap_or(1)
}

/// Moves the items that are `first` before the others; returns how many they are.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::tessellate;
    use crate::scene::{NormalSource, Object, ObjectKind, Weighting};
    use fearless_simd::{Level, dispatch};

    fn model(kind: ObjectKind) -> Model {
        let mesh = tessellate(&Object { kind, segments: 40, rings: 23, ..Object::default() });
        Model::new(mesh.with_vertex_normals(NormalSource::Exact, Weighting::Equal))
    }

    fn rays() -> impl Iterator<Item = (DVec3, DVec3)> {
        let part = |k: u32, factor: f64| (f64::from(k) * factor).fract() * 2.0 - 1.0;
        (1..2000).map(move |k| {
            let origin = DVec3::new(part(k, 0.618_034), part(k, 0.754_877), part(k, 0.569_84)) * 1.5;
            let direction = DVec3::new(part(k, 0.438_579), part(k, 0.324_718), part(k, 0.220_744));
            (origin, direction)
        })
    }

    #[test]
    fn rays_meet_what_a_search_through_all_triangles_finds() {
        for kind in [ObjectKind::Torus, ObjectKind::Teapot, ObjectKind::Plane] {
            let model = model(kind);
            let bvh = Bvh::new(&model);
            let mut met = 0;
            for (origin, direction) in rays() {
                let mut best = None;
                let mut limit = f64::INFINITY;
                for vertices in &model.triangles {
                    if let Some((t, _)) = meet(&vertices.map(|v| model.place(v)), origin, direction, limit) {
                        limit = t;
                        best = Some(t);
                    }
                }
                assert_eq!(bvh.nearest(origin, direction).map(|meeting| meeting.t), best, "{kind:?}");
                assert_eq!(bvh.blocks(origin, direction, f64::INFINITY), best.is_some());
                if let Some(t) = best {
                    assert!(!bvh.blocks(origin, direction, t * 0.999));
                    met += 1;
                }
            }
            assert!(met > 100, "{kind:?}: {met}");
        }
    }

    #[test]
    fn a_packet_finds_what_its_rays_find_alone() {
        let kinds = [ObjectKind::Torus, ObjectKind::Teapot, ObjectKind::Plane, ObjectKind::Sphere];
        for (kind, away) in kinds.into_iter().flat_map(|kind| [0.0, 1e3, 1e7, 1e9].map(|away| (kind, away))) {
            let bvh = Bvh::new(&model(kind));
            let all: Vec<_> = rays().collect();
            for rays in all.chunks_exact(RAYS) {
                let mut packet = Packet::default();
                for (k, (origin, direction)) in rays.iter().enumerate() {
                    packet.set(k, *origin - *direction * away, *direction, away + 0.1 + 0.2 * k as f64);
                }
                let alone = |k: usize| {
                    let (origin, direction, t_max) = packet.ray(k);
                    u32::from(bvh.blocks(origin, direction, t_max)) << k
                };
                let expected = (0..RAYS).map(alone).sum::<u32>();
                for level in [Level::new(), Level::baseline()] {
                    for asked in [0xffff, 0x00f0, 0] {
                        let blocked = dispatch!(level, simd => bvh.blocked(simd, &packet, asked));
                        assert_eq!(blocked, expected & asked, "{kind:?}");
                    }
                    let nearest = dispatch!(level, simd => bvh.nearest_of(simd, &packet, 0xff0f));
                    for k in (0..RAYS).filter(|k| 0xff0f >> k & 1 == 1) {
                        let (origin, direction, t_max) = packet.ray(k);
                        let alone = bvh.nearest(origin, direction).map(|meeting| meeting.t).filter(|t| *t < t_max);
                        assert_eq!(nearest.of(k).map(|meeting| meeting.t), alone, "{kind:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_inner_ball_of_a_polygonal_sphere_touches_its_planes() {
        let radius = Bvh::new(&model(ObjectKind::Sphere)).inner_radius();
        assert!(radius > 0.98 && radius < 1.0, "{radius}");
        assert_eq!(Bvh::new(&model(ObjectKind::Torus)).inner_radius(), 0.0);
    }

    #[test]
    fn a_model_of_one_place_is_built_and_searched() {
        let model = Model { position: [vec![0.0; 16], vec![0.0; 16], vec![0.0; 16]], ..Model::default() };
        let model = Model { triangles: vec![[0, 1, 2]; 1000], ..model };
        assert_eq!(Bvh::new(&model).nearest(DVec3::Z, -DVec3::Z), None);
        assert_eq!(Bvh::new(&Model::default()).nearest(DVec3::Z, -DVec3::Z), None);
    }
}
