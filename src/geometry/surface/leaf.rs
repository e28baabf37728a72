//! A small part of a Bézier patch, and four rays that Newton's iteration brings to it side by side.
//!
//! The derivatives of a leaf lie within radii r about those in its middle, since three times the differences of the control
//! points hold them. Seen along a unit direction d, the Jacobian in the middle is J = (Sᵤ × Sᵥ)·d, and that between any two
//! points of the leaf, a mean of its derivatives, differs from it by at most rᵤ|Sᵥ| + rᵥ|Sᵤ| + rᵤrᵥ. Where |J| is larger,
//! the ray meets the leaf once at most (the mean value theorem); and the first step towards a meeting differs from the
//! whole way w by at most (rᵤ + rᵥ)·max(|Sᵤ|, |Sᵥ|)/|J| of |w|, so that a longer one leads past the leaf. Where the ray
//! grazes, the leaf is seen as a streak: in the picture plane, across the normal N it reaches no farther than h + |N·d|·R,
//! with h its height over the tangent plane in the middle and R its radius.

use super::patch_ray::EDGE;
use super::solids::UnitRay;
use crate::geometry::bezier::{Jet, Patch, bernstein, bernstein_slopes};
use crate::geometry::vector::{cross, dot, load, splat, sub};
use fearless_simd::{f64x4, prelude::*};
use glam::DVec3;

/// The rounding error of distances in leaves and from rays, for a surface of a size about 1.
const ROUNDING: f64 = 1e-12;

pub const QUAD: usize = 4;

pub struct Leaf {
    pub patch: Patch<DVec3>,
    middle: Jet<DVec3>,
    /// Sᵤ × Sᵥ in the middle.
    normal: DVec3,
    /// The bound on the Jacobian's difference from that in the middle.
    fold: f64,
    /// The bound on the error of the first step as a fraction of the way, times the Jacobian in the middle.
    stray: f64,
    /// The largest distance from the tangent plane in the middle, times the normal's length, and from the middle itself.
    height: f64,
    radius: f64,
}

impl Leaf {
    pub fn new(patch: Patch<DVec3>) -> Self {
        let (p, middle) = (&patch.points, patch.jet(0.5, 0.5));
        let radius = |middle: DVec3, difference: &dyn Fn(usize) -> Option<DVec3>| {
            let distances = (0..16)
                .filter_map(difference)
                .map(|d| (3.0 * d - middle).length());
            distances.fold(0.0, f64::max)
        };
        let in_u = radius(middle.along_u, &|k| Some(*p.get(k + 4)? - p[k]));
        let in_v = radius(middle.along_v, &|k| (k % 4 < 3).then(|| p[k + 1] - p[k]));
        let [u, v] = [middle.along_u, middle.along_v].map(DVec3::length);
        let normal = middle.along_u.cross(middle.along_v);
        let max_of = |distance: &dyn Fn(DVec3) -> f64| {
            let distances = p.iter().map(|p| distance(*p - middle.point));
            distances.fold(0.0, f64::max) * (1.0 + EDGE) + ROUNDING
        };
        Self {
            normal,
            height: max_of(&|p| p.dot(normal).abs()),
            radius: max_of(&|p| p.length()),
            fold: (in_u * v + in_v * u + in_u * in_v) * (1.0 + EDGE),
            stray: (in_u + in_v) * u.max(v),
            middle,
            patch,
        }
    }
}

pub struct Quad {
    /// The rays that meet the leaf, a bit each.
    pub roots: u32,
    /// The rays of which nothing is known, a bit each.
    pub undecided: u32,
    /// The meetings: the length along each ray, and (u, v).
    pub s: [f64; QUAD],
    pub uv: [[f64; QUAD]; 2],
}

type Four<S> = [f64x4<S>; 3];

impl Quad {
    /// Runs Newton's iteration from the middle of a leaf for the rays whose bits are set in `requested`. Rays that have
    /// converged stay as they are, so that none depends on the others.
    #[inline(always)]
    pub fn solve<S: Simd>(simd: S, leaf: &Leaf, rays: &[UnitRay], requested: u32) -> Self {
        const STEPS: usize = 10;
        /// The step after which the next would be of the order of its square, which is rounding.
        const CONVERGED: f64 = 1e-8;
        /// The distance from the middle beyond which the bounds on the derivatives say nothing.
        const STRAYED: f64 = 1.0;
        let (mut origin, mut direction) = ([[0.0; QUAD]; 3], [[0.0; QUAD]; 3]);
        for (lane, ray) in rays.iter().enumerate() {
            for axis in 0..3 {
                origin[axis][lane] = ray.origin[axis];
                direction[axis][lane] = ray.direction[axis];
            }
        }
        let (origin, direction) = (load(simd, &origin, 0), load(simd, &direction, 0));
        let Jet {
            point,
            along_u,
            along_v,
        } = leaf.middle;
        let [along_u, along_v]: [Four<S>; 2] = [splat(simd, along_u), splat(simd, along_v)];
        let from = sub(splat(simd, point), origin);
        let normal = splat(simd, leaf.normal);
        let jacobian = dot(normal, direction);
        let step_u = dot(from, cross(along_v, direction));
        let step_v = dot(from, cross(direction, along_u));
        let size = jacobian.abs();
        let single = size.simd_gt(f64x4::splat(simd, leaf.fold));
        let reach = (size + leaf.stray) * (0.5 + 2.0 * EDGE);
        let across = (dot(from, normal) - jacobian * dot(from, direction)).abs();
        let streak = across.simd_le(size * leaf.radius + leaf.height);
        let near = step_u.abs().simd_le(reach) & step_v.abs().simd_le(reach);
        let mut quad = Self {
            roots: 0,
            undecided: requested & !(single.to_bitmask() as u32) & streak.to_bitmask() as u32,
            s: [0.0; QUAD],
            uv: [[0.0; QUAD]; 2],
        };
        let wanted = requested & (single & near).to_bitmask() as u32;
        if wanted == 0 {
            return quad;
        }
        let (zero, half) = (f64x4::splat(simd, 0.0), f64x4::splat(simd, 0.5));
        let (mut u, mut v, mut s) = (half - step_u / jacobian, half - step_v / jacobian, zero);
        let mut open = single & near;
        let mut converged = 0;
        for _ in 0..STEPS {
            let [point, along_u, along_v] = jet(simd, &leaf.patch, u, v);
            let from = sub(point, origin);
            let (over_v, over_u) = (cross(along_v, direction), cross(direction, along_u));
            let jacobian = dot(along_u, over_v);
            let step_u = open.select(dot(from, over_v) / jacobian, zero);
            let step_v = open.select(dot(from, over_u) / jacobian, zero);
            u -= step_u;
            v -= step_v;
            let here = dot(from, direction)
                - (step_u * dot(along_u, direction) + step_v * dot(along_v, direction));
            s = open.select(here, s);
            let distance = (u - 0.5).abs().max((v - 0.5).abs());
            // Also false where the step is not a number.
            let stays = distance.simd_le(f64x4::splat(simd, STRAYED));
            let long = step_u
                .abs()
                .max(step_v.abs())
                .simd_ge(f64x4::splat(simd, CONVERGED));
            converged |= (open & stays & !long).to_bitmask() as u32;
            open = open & stays & long;
            if open.to_bitmask() as u32 & wanted == 0 {
                break;
            }
        }
        let distance = (u - 0.5).abs().max((v - 0.5).abs());
        let within = distance
            .simd_le(f64x4::splat(simd, 0.5 + EDGE))
            .to_bitmask() as u32;
        quad.roots = wanted & converged & within;
        quad.undecided |= wanted & !converged;
        s.store_slice(&mut quad.s);
        let one = f64x4::splat(simd, 1.0);
        u.max(zero).min(one).store_slice(&mut quad.uv[0]);
        v.max(zero).min(one).store_slice(&mut quad.uv[1]);
        quad
    }
}

/// Returns the point at (u, v), ∂S/∂u and ∂S/∂v.
#[inline(always)]
fn jet<S: Simd>(simd: S, patch: &Patch<DVec3>, u: f64x4<S>, v: f64x4<S>) -> [Four<S>; 3] {
    let (zero, one) = (f64x4::splat(simd, 0.0), f64x4::splat(simd, 1.0));
    let (bu, bv) = (bernstein(u, one - u), bernstein(v, one - v));
    let (su, sv) = (bernstein_slopes(u, one - u), bernstein_slopes(v, one - v));
    let [mut point, mut along_u, mut along_v] = [[zero; 3]; 3];
    for i in 0..4 {
        let row = &patch.points[4 * i..4 * i + 4];
        for axis in 0..3 {
            let [a, b, c, d] = [row[0][axis], row[1][axis], row[2][axis], row[3][axis]];
            let place = bv[0] * a + bv[1] * b + bv[2] * c + bv[3] * d;
            let slope = sv[0] * a + sv[1] * b + sv[2] * c + sv[3] * d;
            point[axis] += bu[i] * place;
            along_u[axis] += su[i] * place;
            along_v[axis] += bu[i] * slope;
        }
    }
    [point, along_u, along_v]
}
