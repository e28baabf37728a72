//! The object that rays meet: the polygons, or the true surface where that is drawn; and the points of it that pixels show,
//! in double precision, from which rays start.

use super::bvh::Bvh;
use super::light_buffer::LightBuffer;
use super::packet::{Packet, RAYS, rays_of};
use super::proof::WIDER;
use super::traverse::meet;
use crate::geometry::{RAYS_TOGETHER, Ray, Surface, SurfaceHit};
use crate::render::lens::{Lens, pixel_centre};
use crate::render::model::Model;
use crate::render::raster::{Band, Block, Fragment, Triangles, fragment, is_seen};
use crate::scene::Rgb;
use fearless_simd::{Level, Simd, dispatch};
use glam::{DVec2, DVec3};
use std::ops::Range;

/// The clearance at which rays start, as a part of the object's radius, so that they do not meet the point they leave.
/// Polygons meet their own corners exactly, up to the rounding of double precision.
const CLEAR_OF_POLYGONS: f64 = 1e-6;
/// The clearance for the true surface: the teapot's patches are iterated to about 10⁻⁹.
const CLEAR_OF_SURFACE: f64 = 1e-5;
/// The roundings of a point on a ray, generously, as a part of the distances.
const ROUNDINGS: f64 = 16.0 * f64::EPSILON;

/// The object, prepared for rays.
#[derive(Clone, Copy)]
pub struct Solid<'a> {
    pub level: Level,
    pub model: &'a Model,
    pub bvh: &'a Bvh,
    /// The polygons as each light sees them, where that makes its shadows quicker; none for the true surface.
    pub buffers: &'a [Option<LightBuffer>],
    pub surface: Option<&'a Surface>,
    /// True if the normal is interpolated over a polygon.
    pub smooth: bool,
}

/// A point where a ray meets the object.
#[derive(Clone, Copy, Debug)]
pub struct SolidHit {
    /// The point, world.
    pub point: DVec3,
    /// The unit normal, outwards.
    pub normal: DVec3,
    /// The outward normal of the polygon itself, of any length; the true surface's normal.
    pub facing: DVec3,
    /// The index of the polygon's material.
    pub material: usize,
    /// The colour that tints Od.
    pub tint: Rgb,
}

impl Solid<'_> {
    /// Returns the distance from the surface at which a ray starts, world units.
    pub fn clearance(&self) -> f64 {
        let part = if self.surface.is_some() {
            CLEAR_OF_SURFACE
        } else {
            CLEAR_OF_POLYGONS
        };
        part * self.model.radius
    }

    /// Returns whether no line leaves the object and enters it again.
    pub fn is_convex(&self) -> bool {
        self.model.closed && self.model.convex
    }

    /// Returns a ball that holds the object: centre and radius, world.
    pub fn ball(&self) -> (DVec3, f64) {
        match self.surface {
            Some(_) => (DVec3::ZERO, Surface::BOUND),
            None => (self.model.origin, self.model.radius),
        }
    }

    /// Returns the height of the lowest point, or a smaller one.
    pub fn lowest(&self) -> f64 {
        match self.surface {
            Some(_) => -Surface::BOUND,
            None => self.model.origin.y + self.bvh.lowest(),
        }
    }

    /// Returns whether a ray certainly passes the ball about the object; `start` is relative to its middle, `direction` unit.
    pub fn is_passed(&self, start: DVec3, direction: DVec3) -> bool {
        let (_, radius) = self.ball();
        let nearest = start + direction * (-start.dot(direction)).max(0.0);
        let outer = radius * WIDER + start.length() * ROUNDINGS;
        nearest.length_squared() > outer * outer
    }

    /// Returns the radius of a ball about the middle of [`Solid::ball`] that lies within the object, so that a ray from
    /// outside into it meets the object; 0 if none is known. A little smaller than one that touches, so that it lies before
    /// the surface on every ray.
    pub fn inner_radius(&self) -> f64 {
        match self.surface {
            Some(surface) => surface.inner_radius() * (1.0 - CLEAR_OF_SURFACE),
            None => self.bvh.inner_radius,
        }
    }

    /// Finds the rays blocked by the object among those whose bits are set in `requested`; the rays are relative to the ball's middle.
    #[inline(always)]
    pub fn blocked<S: Simd>(&self, simd: S, packet: &Packet, requested: u32) -> u32 {
        let Some(surface) = self.surface else {
            return self.bvh.blocked(simd, packet, requested);
        };
        let mut blocked = 0;
        self.meet_surface(surface, packet, requested, DVec3::ZERO, |ray, hit| {
            blocked |= u32::from(hit.is_some_and(|hit| hit.t < packet.t_max[ray])) << ray;
        });
        blocked
    }

    /// Returns whether a triangle blocks one ray, relative to the ball's middle.
    pub fn blocks(&self, triangle: u32, (origin, direction, t_max): (DVec3, DVec3, f64)) -> bool {
        let corners =
            self.model.triangles[triangle as usize].map(|vertex| self.model.place(vertex));
        meet(&corners, origin, direction, t_max).is_some()
    }

    /// Calls `each` with every ray whose bit is set in `requested` and its point on the surface; rays are relative to `middle`.
    fn meet_surface(
        &self,
        surface: &Surface,
        packet: &Packet,
        requested: u32,
        middle: DVec3,
        mut each: impl FnMut(usize, Option<SurfaceHit>),
    ) {
        let mut rays = [Ray::default(); RAYS];
        for (slot, ray) in rays.iter_mut().zip(rays_of(requested)) {
            let (origin, direction, _) = packet.ray(ray);
            *slot = Ray {
                origin: middle + origin,
                direction,
            };
        }
        let count = requested.count_ones() as usize;
        let hits = rays[..count]
            .chunks(RAYS_TOGETHER)
            .flat_map(|rays| surface.intersect_all(self.level, rays, 0.0));
        rays_of(requested)
            .zip(hits)
            .for_each(|(ray, hit)| each(ray, hit));
    }

    /// Calls `each` with every ray whose bit is set in `requested` and the first point that it meets; rays are relative to the middle.
    pub fn nearest(
        &self,
        packet: &Packet,
        requested: u32,
        mut each: impl FnMut(usize, Option<SolidHit>),
    ) {
        let (middle, _) = self.ball();
        if let Some(surface) = self.surface {
            self.meet_surface(surface, packet, requested, middle, |ray, hit| {
                let (start, direction, _) = packet.ray(ray);
                let seen = |hit: SurfaceHit| SolidHit {
                    point: middle + start + direction * hit.t,
                    normal: hit.normal,
                    facing: hit.normal,
                    material: 0,
                    tint: Rgb::ONE,
                };
                each(ray, hit.map(seen));
            });
            return;
        }
        let nearest = dispatch!(self.level, simd => self.bvh.nearest(simd, packet, requested));
        for ray in rays_of(requested) {
            let (origin, direction, _) = packet.ray(ray);
            let hit = |(t, triangle, weights): (f64, u32, [f64; 2])| {
                let [a, b, c] =
                    self.model.triangles[triangle as usize].map(|v| self.model.place(v).as_dvec3());
                let (point, facing) = (middle + origin + direction * t, (b - a).cross(c - a));
                SolidHit {
                    point,
                    normal: self.normal(triangle, weights),
                    facing,
                    material: self
                        .model
                        .face_materials
                        .of_face(self.model.faces[triangle as usize]),
                    tint: self.tint(triangle, weights),
                }
            };
            each(ray, nearest.hit(ray).map(hit));
        }
    }

    /// Returns the point where a ray from `start`, relative to the ball's middle, leaves the inner ball of a convex object;
    /// `start` itself if it misses that ball. From inside the object nothing is met before.
    pub fn past_inner_ball(&self, start: DVec3, direction: DVec3) -> DVec3 {
        let radius = self.inner_radius();
        if !self.is_convex() || radius <= 0.0 {
            return start;
        }
        let unit = direction.normalize();
        let middle = -start.dot(unit);
        let half_chord = radius * radius - (start + unit * middle).length_squared();
        if middle > 0.0 && half_chord > 0.0 {
            start + unit * (middle + half_chord.sqrt())
        } else {
            start
        }
    }

    /// Returns the tint of a triangle where its second and third corner have these weights.
    fn tint(&self, triangle: u32, [w1, w2]: [f64; 2]) -> Rgb {
        if !self.model.is_tinted() {
            return Rgb::ONE;
        }
        let tints = self.model.triangles[triangle as usize].map(|v| self.model.tint(v));
        mean(&tints, DVec3::new(1.0 - w1 - w2, w1, w2))
    }

    /// Returns the unit normal of a triangle where its second and third corner have these weights.
    fn normal(&self, triangle: u32, [w1, w2]: [f64; 2]) -> DVec3 {
        let face = || self.model.face_normal(self.model.faces[triangle as usize]);
        if !self.smooth {
            return face();
        }
        let [a, b, c] = self.model.triangles[triangle as usize].map(|v| self.model.normal(v));
        (a * (1.0 - w1 - w2) + b * w1 + c * w2)
            .try_normalize()
            .unwrap_or_else(face)
    }
}

/// A point that a pixel shows.
#[derive(Clone, Copy, Debug)]
pub struct PrimaryHit {
    /// The point, world.
    pub point: DVec3,
    /// The unit normal according to the mode.
    pub normal: DVec3,
    /// The origin of rays that leave to the side of the normal: lifted from the polygon to the rounded shape that its
    /// vertex normals stand for, so that a smooth surface's facets cast no shadow on each other.
    pub lifted: DVec3,
    /// The index of the polygon's material.
    pub material: usize,
    /// The colour that tints Od.
    pub tint: Rgb,
}

/// The points of the object that a picture's pixels show.
#[derive(Clone, Copy)]
pub struct PrimaryHits<'a> {
    pub lens: &'a Lens,
    pub triangles: Triangles<'a>,
    pub solid: Solid<'a>,
}

impl PrimaryHits<'_> {
    /// Calls `each` with column, row within the band and the point shown, for every pixel of a band that shows the object.
    pub fn walk(
        &self,
        band: &Band,
        fragments: &[Block],
        mut each: impl FnMut(usize, usize, PrimaryHit),
    ) {
        let centre = |x: usize, row: usize| pixel_centre(x, band.place.first_row as usize + row);
        if self.solid.surface.is_some() {
            for (x, row, fragment) in seen_fragments(band, fragments) {
                each(x, row, self.of_fragment(centre(x, row), fragment));
            }
            return;
        }
        let mut seen: Option<(u32, Facet<'_>)> = None;
        for run in &band.runs {
            let facet = match &seen {
                Some((triangle, facet)) if *triangle == run.triangle => facet,
                _ => &seen.insert((run.triangle, self.facet(run.triangle))).1,
            };
            let row = usize::from(run.row);
            (usize::from(run.x0)..usize::from(run.x1))
                .for_each(|x| each(x, row, facet.at(centre(x, row))));
        }
    }

    /// Calls `each` with row and columns of every run of a band's pixels that show the object.
    pub fn walk_covered(
        &self,
        band: &Band,
        fragments: &[Block],
        mut each: impl FnMut(usize, Range<usize>),
    ) {
        if self.solid.surface.is_some() {
            seen_fragments(band, fragments).for_each(|(x, row, _)| each(row, x..x + 1));
        } else {
            band.runs.iter().for_each(|run| {
                each(
                    usize::from(run.row),
                    usize::from(run.x0)..usize::from(run.x1),
                );
            });
        }
    }

    /// Returns the point that a fragment of the true surface stands for.
    pub fn of_fragment(&self, place: DVec2, [nx, ny, nz, key]: Fragment) -> PrimaryHit {
        let (start, direction) = self.lens.ray(place);
        let depth = self.lens.depth_from_key(f64::from(key));
        let point = self.lens.world(start + direction * depth);
        let normal = DVec3::new(f64::from(nx), f64::from(ny), f64::from(nz)).normalize_or(DVec3::Y);
        PrimaryHit {
            point,
            normal,
            lifted: point,
            material: 0,
            tint: Rgb::ONE,
        }
    }

    /// Returns the point of `triangle`, one of the model's or of the clipper's, that a pixel shows.
    pub fn of_triangle(&self, triangle: u32, place: DVec2) -> PrimaryHit {
        self.facet(triangle).at(place)
    }

    fn facet(&self, triangle: u32) -> Facet<'_> {
        Facet::new(&self.solid, self.lens, self.triangles.whole(triangle))
    }
}

/// Returns column, row within the band and fragment of each pixel that shows the true surface.
fn seen_fragments(
    band: &Band,
    fragments: &[Block],
) -> impl Iterator<Item = (usize, usize, Fragment)> {
    let lines = fragments
        .chunks_exact(Block::count(band.place.width))
        .zip(&band.extents)
        .enumerate();
    let seen = lines.flat_map(|(row, (line, extent))| {
        extent
            .clone()
            .map(move |x| (x as usize, row, fragment(line, x as usize)))
    });
    seen.filter(|(_, _, fragment)| is_seen(*fragment))
}

/// One triangle of the model, seen through a lens: everything common to its pixels is computed once.
///
/// The weights of its corners are quotients of functions linear in the position (J. Blinn, *Hyperbolic interpolation*, 1992):
/// with the ray p + s·d, the edges e1, e2 and f = p − a these are f·(d × e2) and d·(f × e1), over e1·(d × e2). One of p
/// and d is the same for all pixels, so each is linear in the other.
struct Facet<'a> {
    lens: &'a Lens,
    corners: [DVec3; 3],
    normals: [DVec3; 3],
    material: usize,
    /// The corners' tints, where they have any.
    tints: Option<[Rgb; 3]>,
    /// The one normal of a facet that is not smooth.
    flat: Option<DVec3>,
    /// The two numerators and the denominator: their dot products with the vector that differs from pixel to pixel, and constants.
    slopes: [DVec3; 3],
    constants: [f64; 3],
    /// The height of corner j above the tangent plane at corner k: `above[k][j]`.
    above: [DVec3; 3],
}

impl<'a> Facet<'a> {
    pub fn new(solid: &Solid<'_>, lens: &'a Lens, triangle: usize) -> Self {
        let model = solid.model;
        let vertices = model.triangles[triangle];
        let corners = vertices.map(|v| model.position(v));
        let normals = vertices.map(|v| model.normal(v));
        let flat = (!solid.smooth).then(|| model.face_normal(model.faces[triangle]));
        let [a, b, c] = corners.map(|corner| (corner - lens.eye) / lens.unit);
        let (e1, e2) = (b - a, c - a);
        let (slopes, constants) = if lens.perspective {
            // p is the eye, f = −a.
            ([a.cross(e2), e1.cross(a), e2.cross(e1)], [0.0; 3])
        } else {
            let d = lens.forward;
            let (first, second) = (d.cross(e2), e1.cross(d));
            (
                [first, second, DVec3::ZERO],
                [-a.dot(first), -a.dot(second), e1.dot(first)],
            )
        };
        let above = |k: usize| {
            DVec3::from_array(corners.map(|corner| (corner - corners[k]).dot(normals[k])))
        };
        let above = if flat.is_some() {
            [DVec3::ZERO; 3]
        } else {
            [above(0), above(1), above(2)]
        };
        Self {
            lens,
            corners,
            normals,
            material: model.face_materials.of_face(model.faces[triangle]),
            tints: model.is_tinted().then(|| vertices.map(|v| model.tint(v))),
            flat,
            slopes,
            constants,
            above,
        }
    }

    /// Returns the point shown at a position in the picture; the plane's middle stands for a triangle that is seen edge-on.
    #[inline(always)]
    pub fn at(&self, place: DVec2) -> PrimaryHit {
        let (p, d) = self.lens.ray(place);
        let differing = if self.lens.perspective { d } else { p };
        let [first, second, whole] =
            [0, 1, 2].map(|k| self.slopes[k].dot(differing) + self.constants[k]);
        let inverse = 1.0 / whole;
        let (mut w1, mut w2) = (first * inverse, second * inverse);
        if !(w1.is_finite() && w2.is_finite()) {
            (w1, w2) = (1.0 / 3.0, 1.0 / 3.0);
        }
        let share = DVec3::new(1.0 - w1 - w2, w1, w2);
        let point = mean(&self.corners, share);
        let tint = self.tints.map_or(Rgb::ONE, |tints| mean(&tints, share));
        match self.flat {
            Some(normal) => PrimaryHit {
                point,
                normal,
                lifted: point,
                material: self.material,
                tint,
            },
            None => {
                let normal = mean(&self.normals, share)
                    .try_normalize()
                    .unwrap_or_else(|| {
                        // Vertex normals that cancel each other.
                        let [a, b, c] = self.corners;
                        (b - a).cross(c - a).normalize_or_zero()
                    });
                PrimaryHit {
                    point,
                    normal,
                    lifted: self.lifted(point, share),
                    material: self.material,
                    tint,
                }
            }
        }
    }

    /// Raises a point onto the tangent planes at the corners, weighted as the corners are (J. Hanika, *Hacking the shadow
    /// terminator*, Ray Tracing Gems II, 2021). Where the surface is hollow the planes lie below and nothing is raised.
    fn lifted(&self, point: DVec3, share: DVec3) -> DVec3 {
        let mut lifted = point;
        for k in 0..3 {
            let below = self.above[k].dot(share).min(0.0);
            lifted -= self.normals[k] * (below * share[k]);
        }
        lifted
    }
}

fn mean(vectors: &[DVec3; 3], share: DVec3) -> DVec3 {
    vectors[0] * share.x + vectors[1] * share.y + vectors[2] * share.z
}
