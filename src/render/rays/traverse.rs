//! The traversal of the boxes by sixteen rays at once; a single ray is a packet of one.
//!
//! Boxes are tested in single precision, widened by more than the rounding, so that none is missed. A triangle is first
//! rejected in single precision where it lies beside a ray by more than any rounding; the rest is decided in double
//! precision, so that the answers depend neither on the SIMD level nor on the grouping of the rays.

use super::bvh::{Bvh, DEPTH, Node};
use super::packet::{self, Packet, RAYS, Vectors, bits};
use crate::geometry::{Descent, cross, dot, load, nearer_first, splat, sub};
use fearless_simd::{f32x16, f64x8, prelude::*};
use glam::{DVec3, Vec3};

/// Half a packet, the lanes of double precision.
const HALF: usize = RAYS / 2;

/// The widening of edges, as a part of the triangle, so that a ray through a shared edge misses neither side.
const SEAM: f64 = 1e-9;
/// The widening of the boxes, as a part of the largest coordinate: four roundings.
const WIDENING: f64 = 4.0 * f32::EPSILON as f64;
/// A stand-in for a component of the direction that is 0.
const LEVEL: f64 = 1e-30;

impl Bvh {
    /// Finds the rays, among those whose bits are set in `requested`, on which anything lies for 0 < t < t_max.
    #[inline(always)]
    pub fn blocked<S: Simd>(&self, simd: S, packet: &Packet, requested: u32) -> u32 {
        let Some(root) = self.nodes.first() else {
            return 0;
        };
        let rays = Rays::new(simd, packet, f64::from(root.radius()));
        let mut descent = Descent::<DEPTH>::new();
        let mut open = requested;
        let (mut here, mut among) = (0, rays.enter(simd, root).0 & requested);
        loop {
            let node = &self.nodes[here as usize];
            if among == 0 {
                // All rays that reached this box are blocked by now.
            } else if node.count > 0 {
                for corners in
                    &self.corners[node.start as usize..(node.start + node.count) as usize]
                {
                    let near = rays.pass_near(simd, corners) & among & open;
                    if near != 0 {
                        open &= !(meet_exactly(simd, packet, corners, near) & near);
                    }
                }
                if open == 0 {
                    return requested;
                }
            } else {
                let (left, right) = (here + 1, node.start);
                let in_left = rays.enter(simd, &self.nodes[left as usize]).0 & among;
                let in_right = rays.enter(simd, &self.nodes[right as usize]).0 & among;
                let mut children = [(left, in_left), (right, in_right)];
                // First the child that more rays enter: it is likelier to block them all.
                if in_left.count_ones() < in_right.count_ones() {
                    children.reverse();
                }
                if let Some(next) = descent.descend(children) {
                    (here, among) = next;
                    continue;
                }
            }
            let Some(next) = descent.pop() else {
                return requested & !open;
            };
            (here, among) = (next.0, next.1 & open);
        }
    }
}

/// The first triangles on the rays of a packet.
pub struct Nearest {
    t: [f64; RAYS],
    triangle: [u32; RAYS],
    weights: [[f64; RAYS]; 2],
    met: u32,
}

impl Nearest {
    /// Returns the distance at which a ray meets its triangle, the triangle, and the weights of its second and third corner there.
    pub fn hit(&self, ray: usize) -> Option<(f64, u32, [f64; 2])> {
        let weights = [self.weights[0][ray], self.weights[1][ray]];
        (self.met >> ray & 1 == 1).then(|| (self.t[ray], self.triangle[ray], weights))
    }

    #[inline(always)]
    fn take<S: Simd>(&mut self, met: &Met<S>, requested: u32, first: usize, triangle: u32) -> bool {
        let rays = met.rays & requested >> first;
        for lane in (0..HALF).filter(|lane| rays >> lane & 1 == 1) {
            let ray = first + lane;
            self.t[ray] = met.t[lane];
            self.triangle[ray] = triangle;
            self.weights[0][ray] = met.weights[0][lane];
            self.weights[1][ray] = met.weights[1][lane];
        }
        self.met |= rays << first;
        rays != 0
    }
}

impl Bvh {
    /// Finds the first triangle on each of the rays whose bits are set in `requested`, for 0 < t < t_max.
    #[inline(always)]
    pub fn nearest<S: Simd>(&self, simd: S, packet: &Packet, requested: u32) -> Nearest {
        let mut nearest = Nearest {
            t: packet.t_max,
            triangle: [0; RAYS],
            weights: [[0.0; RAYS]; 2],
            met: 0,
        };
        let Some(root) = self.nodes.first() else {
            return nearest;
        };
        let mut rays = Rays::new(simd, packet, f64::from(root.radius()));
        let mut descent = Descent::<DEPTH>::new();
        let (mut here, mut among) = (0, rays.enter(simd, root).0 & requested);
        loop {
            let node = &self.nodes[here as usize];
            if node.count > 0 && among != 0 {
                let range = node.start as usize..(node.start + node.count) as usize;
                let mut nearer = false;
                for (corners, &triangle) in
                    self.corners[range.clone()].iter().zip(&self.order[range])
                {
                    let near = rays.pass_near(simd, corners) & among;
                    for first in [0, HALF] {
                        if near >> first & 0xff != 0 {
                            let met = meet_half(simd, packet, &nearest.t, corners, first);
                            nearer |= nearest.take(&met, near, first, triangle);
                        }
                    }
                }
                if nearer {
                    rays.end_at(simd, &nearest.t);
                }
            } else if among != 0 {
                let (left, right) = (here + 1, node.start);
                let (in_left, at_left) = rays.enter(simd, &self.nodes[left as usize]);
                let (in_right, at_right) = rays.enter(simd, &self.nodes[right as usize]);
                let children = [(left, in_left & among), (right, in_right & among)];
                let children = nearer_first(among, children, &[at_left, at_right]);
                if let Some(next) = descent.descend(children) {
                    (here, among) = next;
                    continue;
                }
            }
            let Some(next) = descent.pop() else {
                return nearest;
            };
            (here, among) = next;
            among &= rays.enter(simd, &self.nodes[here as usize]).0;
        }
    }
}

/// The distance, in radii of the model, beyond which a ray is started near the model.
const FAR: f64 = 64.0;

/// Returns the starts, near the model, of rays that come from far away: twice its radius before their point nearest to its origin.
#[inline(always)]
fn starts(packet: &Packet, radius: f64) -> [f64; RAYS] {
    let mut start = [0.0; RAYS];
    for (ray, start) in start.iter_mut().enumerate() {
        let (origin, direction, _) = packet.ray(ray);
        let speed = direction.length();
        if speed > 0.0 && origin.length_squared() > (FAR * radius).powi(2) {
            *start = (-origin.dot(direction) / speed - 2.0 * radius).max(0.0) / speed;
        }
    }
    start
}

/// A packet in single precision.
struct Rays<S: Simd> {
    /// The origin moved by the widening of the boxes, for their low sides and for their high ones.
    from_low: Vectors<S>,
    from_high: Vectors<S>,
    inverse: Vectors<S>,
    limit: f32x16<S>,
    origin: Vectors<S>,
    direction: Vectors<S>,
    /// The error bound of a triple product of direction, an edge and the vector from a corner, over the edge's length.
    error: f32x16<S>,
    /// The error bound of the product that gives the distance, over the square of the edge's length.
    depth_error: f32x16<S>,
    /// The start of each ray here: those from far away start near the model, since single precision is relative to the origin.
    start: [f64; RAYS],
}

impl<S: Simd> Rays<S> {
    /// The roundings of a triple product in single precision, generously.
    const ROUNDINGS: f64 = 24.0 * f32::EPSILON as f64;

    /// The size below which products may have lost digits to underflow.
    const LEAST: f32 = 1e-30;

    /// Prepares a packet; `radius` is that of a ball about the model's origin that holds every corner.
    #[inline(always)]
    fn new(simd: S, packet: &Packet, radius: f64) -> Self {
        let start = starts(packet, radius);
        let [mut widening, mut distance, mut speed, mut lost] = [[0.0_f64; RAYS]; 4];
        let mut moved = packet.origin;
        for (origins, directions) in moved.iter_mut().zip(&packet.direction) {
            for ray in 0..RAYS {
                let (origin, direction) = (origins[ray], directions[ray]);
                let near = origin + start[ray] * direction;
                origins[ray] = near;
                // Two roundings of at most the origin's distance, where the ray was moved at all.
                lost[ray] += if start[ray] > 0.0 {
                    4.0 * f64::EPSILON * origin.abs()
                } else {
                    0.0
                };
                widening[ray] = widening[ray].max(WIDENING * near.abs());
                distance[ray] += near.abs();
                speed[ray] += direction.abs();
            }
        }
        for ray in 0..RAYS {
            widening[ray] += lost[ray];
            distance[ray] += lost[ray] / Self::ROUNDINGS;
        }
        let [mut low, mut high, mut inverse, mut near, mut way] = [[[0.0_f32; RAYS]; 3]; 5];
        for axis in 0..3 {
            for ray in 0..RAYS {
                let (origin, direction) = (moved[axis][ray], packet.direction[axis][ray]);
                let slope = if direction.abs() < LEVEL {
                    LEVEL.copysign(direction)
                } else {
                    direction
                };
                low[axis][ray] = (origin + widening[ray]) as f32;
                high[axis][ray] = (origin - widening[ray]) as f32;
                inverse[axis][ray] = (1.0 / slope) as f32;
                near[axis][ray] = origin as f32;
                way[axis][ray] = direction as f32;
            }
        }
        let mut errors = [[0.0_f32; RAYS]; 2];
        for ray in 0..RAYS {
            let error = Self::ROUNDINGS * (distance[ray] + radius);
            errors[0][ray] = (error * speed[ray]) as f32;
            errors[1][ray] = error as f32;
        }
        let mut rays = Self {
            from_low: load(simd, &low, 0),
            from_high: load(simd, &high, 0),
            inverse: load(simd, &inverse, 0),
            origin: load(simd, &near, 0),
            direction: load(simd, &way, 0),
            limit: f32x16::splat(simd, 0.0),
            error: f32x16::from_slice(simd, &errors[0]),
            depth_error: f32x16::from_slice(simd, &errors[1]),
            start,
        };
        rays.end_at(simd, &packet.t_max);
        rays
    }

    /// Ends the rays at `t`, with a margin for rounding.
    #[inline(always)]
    fn end_at(&mut self, simd: S, t: &[f64; RAYS]) {
        let mut limit = [0.0_f32; RAYS];
        for ray in 0..RAYS {
            limit[ray] = ((t[ray] - self.start[ray]) * (1.0 + 2e-6)
                + 4.0 * f64::EPSILON * self.start[ray]) as f32;
        }
        self.limit = f32x16::from_slice(simd, &limit);
    }

    /// Finds the rays that enter a box before their limit, and the points where they do.
    #[inline(always)]
    fn enter(&self, simd: S, node: &Node) -> (u32, f32x16<S>) {
        let mut near = f32x16::splat(simd, 0.0);
        let mut far = f32x16::splat(simd, f32::INFINITY);
        for axis in 0..3 {
            let low =
                (f32x16::splat(simd, node.low[axis]) - self.from_low[axis]) * self.inverse[axis];
            let high =
                (f32x16::splat(simd, node.high[axis]) - self.from_high[axis]) * self.inverse[axis];
            near = near.max(low.min(high));
            far = far.min(low.max(high));
        }
        (
            bits(near.simd_le(far * (1.0 + 1e-6)) & near.simd_le(self.limit)),
            near,
        )
    }

    /// Finds the rays that may meet a triangle: all that do, and few others.
    #[inline(always)]
    fn pass_near(&self, simd: S, &[a, b, c]: &[Vec3; 3]) -> u32 {
        let (e1, e2) = (b - a, c - a);
        let longest = e1.length().max(e2.length());
        let from = sub(self.origin, splat(simd, a));
        let [e1, e2]: [Vectors<S>; 2] = [splat(simd, e1), splat(simd, e2)];
        let (p, q) = (cross(self.direction, e2), cross(from, e1));
        let determinant = packet::dot(&e1, &p);
        let one = f32x16::splat(simd, 1.0).copysign(determinant);
        let size = determinant.abs();
        let (w1, w2) = (
            packet::dot(&from, &p) * one,
            packet::dot(&self.direction, &q) * one,
        );
        let t = packet::dot(&e2, &q) * one;
        let error = self.error * longest;
        let depth_error = self.depth_error * (longest * longest);
        let beside =
            w1.simd_lt(-error) | w2.simd_lt(-error) | (w1 + w2).simd_gt(size + error * 3.0);
        let behind = t.simd_lt(-depth_error);
        // Without the sign of the determinant nothing is known.
        !bits((beside | behind) & size.simd_gt(error + Self::LEAST))
    }
}

struct Met<S: Simd> {
    rays: u32,
    t: f64x8<S>,
    weights: [f64x8<S>; 2],
}

/// Finds the rays in `near` that meet a triangle before their limit.
#[inline(always)]
fn meet_exactly<S: Simd>(simd: S, packet: &Packet, corners: &[Vec3; 3], near: u32) -> u32 {
    let low = if near & 0xff == 0 {
        0
    } else {
        meet_half(simd, packet, &packet.t_max, corners, 0).rays
    };
    let high = if near >> HALF == 0 {
        0
    } else {
        meet_half(simd, packet, &packet.t_max, corners, HALF).rays
    };
    low | high << HALF
}

/// Intersects eight rays with a triangle (T. Möller and B. Trumbore, *Fast, minimum storage ray/triangle intersection*, 1997).
#[inline(always)]
fn meet_half<S: Simd>(
    simd: S,
    packet: &Packet,
    limit: &[f64; RAYS],
    corners: &[Vec3; 3],
    first: usize,
) -> Met<S> {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let [e1, e2, corner]: [[f64x8<S>; 3]; 3] =
        [splat(simd, b - a), splat(simd, c - a), splat(simd, a)];
    let direction = load(simd, &packet.direction, first);
    let origin = load(simd, &packet.origin, first);
    let from = sub(origin, corner);
    let p = cross(direction, e2);
    let determinant = dot(e1, p);
    let inverse = f64x8::splat(simd, 1.0) / determinant;
    let w1 = dot(from, p) * inverse;
    let q = cross(from, e1);
    let w2 = dot(direction, q) * inverse;
    let t = dot(e2, q) * inverse;
    let (min, max) = (f64x8::splat(simd, -SEAM), f64x8::splat(simd, 1.0 + SEAM));
    let zero = f64x8::splat(simd, 0.0);
    let limit = f64x8::from_slice(simd, &limit[first..first + HALF]);
    let within = w1.simd_ge(min) & w1.simd_le(max) & w2.simd_ge(min) & (w1 + w2).simd_le(max);
    let met = within & t.simd_gt(zero) & t.simd_lt(limit) & determinant.simd_ne(zero);
    Met {
        rays: met.to_bitmask() as u32,
        t,
        weights: [w1, w2],
    }
}

/// Intersects one ray with a triangle for 0 < t < `limit`, as [`meet_half`] does eight.
pub fn meet(corners: &[Vec3; 3], origin: DVec3, direction: DVec3, limit: f64) -> Option<f64> {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let (e1, e2) = ((b - a).to_array(), (c - a).to_array());
    let (from, direction) = ((origin - a).to_array(), direction.to_array());
    let p = cross(direction, e2);
    let determinant = dot(e1, p);
    let inverse = 1.0 / determinant;
    let w1 = dot(from, p) * inverse;
    let q = cross(from, e1);
    let w2 = dot(direction, q) * inverse;
    let t = dot(e2, q) * inverse;
    let side = -SEAM..=1.0 + SEAM;
    let within = side.contains(&w1) && w2 >= -SEAM && w1 + w2 <= 1.0 + SEAM;
    (within && t > 0.0 && t < limit && determinant != 0.0).then_some(t)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::geometry::tessellate;
    use crate::render::model::Model;
    use crate::scene::{NormalSource, Object, ObjectKind, Weighting};
    use fearless_simd::{Level, dispatch};

    pub fn model(kind: ObjectKind) -> Model {
        let mesh = tessellate(&Object {
            kind,
            segments: 40,
            rings: 23,
            ..Object::default()
        });
        Model::new(mesh.with_vertex_normals(NormalSource::Exact, Weighting::Equal))
    }

    fn rays() -> Vec<(DVec3, DVec3)> {
        let part = |k: u32, factor: f64| (f64::from(k) * factor).fract() * 2.0 - 1.0;
        let ray = |k| {
            let origin =
                DVec3::new(part(k, 0.618_034), part(k, 0.754_877), part(k, 0.569_84)) * 1.5;
            (
                origin,
                DVec3::new(part(k, 0.438_579), part(k, 0.324_718), part(k, 0.220_744)),
            )
        };
        (1..2000).map(ray).collect()
    }

    #[test]
    fn packets_find_what_a_search_through_all_triangles_finds() {
        let kinds = [
            ObjectKind::Torus,
            ObjectKind::Teapot,
            ObjectKind::Plane,
            ObjectKind::Sphere,
        ];
        for (kind, away) in kinds
            .into_iter()
            .flat_map(|kind| [0.0, 1e8].map(|away| (kind, away)))
        {
            let model = model(kind);
            let bvh = Bvh::new(&model);
            let corners: Vec<[Vec3; 3]> = model
                .triangles
                .iter()
                .map(|t| t.map(|v| model.place(v)))
                .collect();
            let mut found = 0;
            for rays in rays().chunks_exact(RAYS) {
                let mut packet = Packet::default();
                for (k, (origin, direction)) in rays.iter().enumerate() {
                    packet.set(
                        k,
                        *origin - *direction * away,
                        *direction,
                        away + 0.1 + 0.2 * k as f64,
                    );
                }
                let first = |k: usize| {
                    let (origin, direction, t_max) = packet.ray(k);
                    let nearer = |limit, corners: &[Vec3; 3]| {
                        meet(corners, origin, direction, limit).unwrap_or(limit)
                    };
                    Some(corners.iter().fold(t_max, nearer)).filter(|t| *t < t_max)
                };
                let expected: [Option<f64>; RAYS] = std::array::from_fn(first);
                let met = (0..RAYS).fold(0, |bits, k| bits | u32::from(expected[k].is_some()) << k);
                found += met.count_ones();
                for level in [Level::new(), Level::baseline()] {
                    for requested in [0xffff, 0xff0f, 0x00f0, 0x0008, 0] {
                        let blocked =
                            dispatch!(level, simd => bvh.blocked(simd, &packet, requested));
                        assert_eq!(blocked, met & requested, "{kind:?}");
                        let nearest =
                            dispatch!(level, simd => bvh.nearest(simd, &packet, requested));
                        for k in (0..RAYS).filter(|k| requested >> k & 1 == 1) {
                            let alone = nearest.hit(k).map(|(t, ..)| t);
                            assert!(
                                alone
                                    .zip(expected[k])
                                    .is_none_or(|(a, b)| (a - b).abs() <= 1e-12 * b),
                                "{kind:?}"
                            );
                            assert_eq!(alone.is_some(), expected[k].is_some(), "{kind:?}");
                        }
                    }
                }
            }
            assert!(found > 100, "{kind:?}: {found}");
        }
    }

    #[test]
    fn rays_from_far_away_enter_no_box_that_they_pass() {
        let node = Node {
            low: [-1.0; 3],
            high: [1.0; 3],
            start: 0,
            count: 1,
        };
        let mut packet = Packet::default();
        for ray in 0..RAYS {
            let towards = DVec3::new(0.0, 0.92 + 0.05 * ray as f64, 0.0);
            let origin = DVec3::new(-1e9, 3e8, 7e8);
            packet.set(ray, origin, towards - origin, f64::INFINITY);
        }
        let radius = f64::from(node.radius());
        let entered =
            dispatch!(Level::new(), simd => Rays::new(simd, &packet, radius).enter(simd, &node).0);
        assert_eq!(entered, 0x00ff, "those past y = 1.3 miss the corner");
    }

    #[test]
    fn the_inner_ball_touches_the_planes_and_a_model_of_one_place_is_searched() {
        let radius = Bvh::new(&model(ObjectKind::Sphere)).inner_radius;
        assert!(radius > 0.98 && radius < 1.0, "{radius}");
        assert_eq!(Bvh::new(&model(ObjectKind::Torus)).inner_radius, 0.0);
        let position = [vec![0.0; 16], vec![0.0; 16], vec![0.0; 16]];
        let place = Model {
            position,
            triangles: vec![[0, 1, 2]; 1000],
            ..Model::default()
        };
        let mut packet = Packet::default();
        packet.set(0, DVec3::Z, -DVec3::Z, f64::INFINITY);
        for bvh in [Bvh::new(&place), Bvh::new(&Model::default())] {
            assert_eq!(
                dispatch!(Level::new(), simd => bvh.nearest(simd, &packet, 1)).hit(0),
                None
            );
        }
    }
}
