//! Quick tests in single precision that decide for most of sixteen rays whether they certainly miss or certainly hit the object.
//!
//! A ray that passes the ball about the object is open; one that meets the ball within it is blocked, since anything that
//! starts outside and ends outside must cross the surface. Margins are wider than the rounding; outside the range of sizes
//! that they were derived for, the answer is "unknown".

use super::light_buffer::{LightBuffer, Seen};
use super::packet::{PointRow, RAYS, Vectors, bits, dot};
use crate::geometry::{cross, load, splat, sub};
use crate::illumination::area_hull;
use crate::scene::{AreaShape, Light};
use fearless_simd::{f32x16, mask32x16, prelude::*};
use glam::{DVec3, Vec3};

/// The roundings of a point on a ray, generously, as a part of the distances.
const ROUNDINGS: f32 = 16.0 * f32::EPSILON;
/// A factor by which something lies outside by more than any rounding.
pub const WIDER: f64 = 1.0 + 1e-5;
/// The range of the object's radii, and of squares of lengths, whose products stay far from the ends of single precision.
const RADII: [f32; 2] = [1e-6, 1e9];
const SQUARES: [f32; 2] = [1e-24, 1e24];

/// A source, prepared for the tests of rays.
#[derive(Clone, Copy)]
pub struct Target {
    /// The position relative to the middle of the ball, or for parallel rays the direction to the source.
    pub place: DVec3,
    pub parallel: bool,
    /// The height above the floor, or for parallel rays the upward component: positive above.
    pub rise: f32,
    /// True if the source lies outside the object's ball.
    pub outside: bool,
}

impl Target {
    /// Prepares a source; `up` is positive for a source above the floor.
    pub fn new(place: DVec3, parallel: bool, up: f64, radius: f64) -> Self {
        let rise = f32::from(i8::from(up > 0.0) - i8::from(up < 0.0));
        Self {
            place,
            parallel,
            rise,
            outside: parallel || place.length() > radius * WIDER,
        }
    }
}

/// An area light, prepared for tests of all its samples at once.
pub struct AreaLight {
    centre: Vec3,
    /// The largest distance of a sample from the centre.
    reach: f32,
    /// The corners of a polyhedron that holds the light.
    corners: Vec<Target>,
    /// True if the corners are a rectangle's, in their order.
    flat: bool,
}

impl AreaLight {
    pub fn new(light: &Light, middle: DVec3, radius: f64) -> Self {
        let corner = |corner: DVec3| Target::new(corner - middle, false, 0.0, radius);
        Self {
            centre: (light.position - middle).as_vec3(),
            reach: light.reach() as f32,
            corners: area_hull(light).into_iter().map(corner).collect(),
            flat: light.shape == AreaShape::Rectangle,
        }
    }
}

/// The radii of the ball about the object and of the one within it, which is 0 if none is known.
#[derive(Clone, Copy)]
pub struct Balls {
    pub outer: f32,
    pub inner: f32,
}

pub struct Points<S: Simd> {
    /// The origins of their rays, relative to the middle of the balls.
    from: Vectors<S>,
    normal: Vectors<S>,
    /// The distance from the middle of the balls.
    distance: f32x16<S>,
    /// The bound on how far rounding moves a point of a ray.
    error: f32x16<S>,
    /// The height above the floor; infinite without one.
    above: f32x16<S>,
}

impl<S: Simd> Points<S> {
    /// Loads a packet of a row's points, whose rays start `clearance` away on one side of their normals. Heights are
    /// relative to the middle: the floor's is `ground`, and no point lies below `least`.
    #[inline(always)]
    pub fn load(
        simd: S,
        row: &PointRow,
        packet: usize,
        [side, clearance]: [f64; 2],
        [ground, least]: [f64; 2],
        balls: Balls,
    ) -> Self {
        let range = packet * RAYS..(packet + 1) * RAYS;
        let lift = side * clearance;
        let mut planes = [[0.0_f32; RAYS]; 7];
        for axis in 0..3 {
            let (starts, normals) = (
                &row.start[axis][range.clone()],
                &row.normal[axis][range.clone()],
            );
            for lane in 0..RAYS {
                planes[axis][lane] = (starts[lane] + normals[lane] * lift) as f32;
                planes[3 + axis][lane] = (normals[lane] * side) as f32;
            }
        }
        let (heights, slopes) = (&row.start[1][range.clone()], &row.normal[1][range]);
        for lane in 0..RAYS {
            planes[6][lane] = ((heights[lane] + slopes[lane] * lift).max(least) - ground) as f32;
        }
        let [x, y, z, nx, ny, nz, above] = &planes;
        let (from, above) = (load(simd, &[x, y, z], 0), f32x16::from_slice(simd, above));
        let distance = dot(&from, &from).sqrt();
        Self {
            from,
            normal: load(simd, &[nx, ny, nz], 0),
            distance,
            error: (distance + balls.outer) * ROUNDINGS,
            above,
        }
    }

    /// Returns the points as a light sees them.
    #[inline(always)]
    pub fn seen(&self, simd: S, buffer: &LightBuffer) -> Seen {
        buffer.see(simd, &self.from, self.distance)
    }

    #[inline(always)]
    pub fn way_to(&self, simd: S, target: &Target) -> Vectors<S> {
        let place = target.place.as_vec3();
        if target.parallel {
            splat(simd, place)
        } else {
            self.way_from(simd, place)
        }
    }

    #[inline(always)]
    fn way_from(&self, simd: S, to: Vec3) -> Vectors<S> {
        sub(splat(simd, to), self.from)
    }

    /// Finds the points that face the source in these directions.
    #[inline(always)]
    pub fn facing(&self, simd: S, way: &Vectors<S>) -> u32 {
        bits(dot(way, &self.normal).simd_gt(f32x16::splat(simd, 0.0)))
    }

    /// Finds the points that the floor separates from a source.
    #[inline(always)]
    pub fn beyond_floor(&self, simd: S, target: &Target) -> u32 {
        let floor = self.above.simd_lt(f32x16::splat(simd, f32::INFINITY));
        bits((self.above * target.rise).simd_lt(f32x16::splat(simd, 0.0)) & floor)
    }

    /// Returns whether the floor separates any of the points from sources under it or above it, if there are any.
    #[inline(always)]
    pub fn floor_parts(&self, simd: S, [under, above]: [bool; 2]) -> bool {
        let zero = f32x16::splat(simd, 0.0);
        under && self.above.simd_gt(zero).any_true() || above && self.above.simd_lt(zero).any_true()
    }

    /// Finds the rays that certainly pass the balls, and those that certainly meet the object within.
    #[inline(always)]
    pub fn decide(&self, simd: S, way: &Vectors<S>, target: &Target, balls: Balls) -> [u32; 2] {
        let most = if target.parallel { f32::INFINITY } else { 1.0 };
        let (square, sound) = self.approach(simd, way, most, balls);
        let outer = self.error + balls.outer;
        let inner = f32x16::splat(simd, balls.inner) - self.error;
        let open = bits(square.simd_gt(outer * outer) & sound);
        let within = square.simd_lt(inner * inner) & inner.simd_gt(f32x16::splat(simd, 0.0));
        [
            open,
            if target.outside {
                bits(within & sound)
            } else {
                0
            },
        ]
    }

    /// Returns the squared distance from the middle at which rays pass it between t = 0 and t = `most`, and a mask of where
    /// that is reliable.
    #[inline(always)]
    fn approach(
        &self,
        simd: S,
        way: &Vectors<S>,
        most: f32,
        balls: Balls,
    ) -> (f32x16<S>, mask32x16<S>) {
        let length = dot(way, way);
        let t = (-dot(&self.from, way) / length)
            .max(f32x16::splat(simd, 0.0))
            .min(f32x16::splat(simd, most));
        let [x, y, z] = self.from;
        let near = [
            way[0].mul_add(t, x),
            way[1].mul_add(t, y),
            way[2].mul_add(t, z),
        ];
        let (least, greatest) = (
            f32x16::splat(simd, SQUARES[0]),
            f32x16::splat(simd, SQUARES[1]),
        );
        let sized = mask32x16::splat(simd, balls.outer > RADII[0] && balls.outer < RADII[1]);
        let far = (self.distance * self.distance).simd_lt(greatest);
        (
            dot(&near, &near),
            length.simd_gt(least) & length.simd_lt(greatest) & far & sized,
        )
    }

    /// Finds the points from which an area light is certainly invisible: the inner ball hides its corners, and so all of it.
    #[inline(always)]
    pub fn hidden(&self, simd: S, area: &AreaLight, balls: Balls) -> u32 {
        let mut hidden = if balls.inner > 0.0 { u32::MAX } else { 0 };
        for corner in &area.corners {
            if hidden == 0 {
                break;
            }
            let way = self.way_to(simd, corner);
            hidden &= self.decide(simd, &way, corner, balls)[1];
        }
        hidden
    }

    /// Finds the points from which all of an area light is certainly visible, as far as the object is concerned.
    #[inline(always)]
    pub fn clear(&self, simd: S, area: &AreaLight, balls: Balls) -> u32 {
        let way = self.way_from(simd, area.centre);
        let (square, sound) = self.approach(simd, &way, 1.0, balls);
        let outer = self.error + (balls.outer + area.reach);
        let mut clear = square.simd_gt(outer * outer);
        if area.flat {
            clear |= self.beside(simd, area, &way, balls);
        }
        bits(clear & sound)
    }

    /// Finds the points for which the ball lies beside the pyramid over a rectangle: beyond a plane through the shading
    /// point and an edge.
    #[inline(always)]
    fn beside(&self, simd: S, area: &AreaLight, way: &Vectors<S>, balls: Balls) -> mask32x16<S> {
        let one = f32x16::splat(simd, 1.0);
        let mut beside = mask32x16::splat(simd, false);
        let Some(last) = area.corners.last() else {
            return beside;
        };
        let mut last = self.way_to(simd, last);
        for corner in &area.corners {
            let next = self.way_to(simd, corner);
            let across = cross(last, next);
            // Outwards: away from the light's middle.
            let outwards = one.copysign(-dot(&across, way));
            let beyond = -dot(&across, &self.from) * outwards;
            let sides = (dot(&last, &last).sqrt() + self.distance)
                * (dot(&next, &next).sqrt() + self.distance);
            let far = dot(&across, &across).sqrt() * balls.outer + sides * self.error;
            beside |= beyond.simd_gt(far);
            last = next;
        }
        beside
    }
}
