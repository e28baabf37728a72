//! The object as a light sees it: its triangles, sorted into the cells of a grid, so that a ray to the light is tested against
//! those of one cell (E. Haines and D. Greenberg, *The light buffer: a shadow-testing accelerator*, 1986).
//!
//! Space is mapped so that the rays to the light become parallel: with the unit vector W from the middle of the object to a light
//! at distance d, a place p has the coordinates (p·U, p·V, p·W) / (1 − p·W/d), which keep lines and planes as they are. A triangle
//! hides a point if it lies above the point. In single precision that is certain for most points; the others are decided
//! in double precision, as everywhere, so that a buffer changes no answer. Of a closed object the triangles that
//! face the light suffice, since a ray that meets the object on its way to the light leaves it through one of them.

use super::packet::{RAYS, Vectors, bits, dot, rays_of};
use crate::geometry::{cross, dot as dot3, load, splat, sub};
use crate::render::model::Model;
use crate::render::node::{Memory, capacity};
use crate::scene::{Light, LightKind, direction};
use fearless_simd::{Level, dispatch, f32x8, f32x16, f64x8, i32x16, prelude::*};
use glam::{DVec2, DVec3};
use rayon::prelude::*;

/// The distance of a light, in radii of the object, from which its buffer is a fair picture of the object.
const FAR_ENOUGH: f64 = 1.25;
/// The range of the object's radii whose products stay far from the ends of single precision.
const RADII: [f64; 2] = [1e-6, 1e9];
/// The most triangles, over all lights, that buffers are made of: finer meshes would take more memory than time is saved.
const MOST_TRIANGLES: usize = 1 << 18;
/// The cells to a triangle.
const CELLS: f64 = 0.5;
/// The most cells of a side.
const MOST_CELLS: f64 = 512.0;
/// The entries to a triangle beyond which a grid does not suit the mesh, and some to begin with.
const MOST_ENTRIES: [usize; 2] = [16, 4096];
/// The roundings of a point's coordinates and of its distance from a plane, generously, as a part of the distances.
const ROUNDINGS: f32 = 16.0 * f32::EPSILON;
/// The error of a point, as a part of the object's size, beyond which its cell is not known.
const MARGIN: f64 = 1.0 / 4096.0;
/// The roundings of a triangle's area as the light sees it, generously, as a part of the object's size times the length of its sides.
const AREA_ROUNDINGS: f64 = 1e-12;

/// The triangles that are tested together.
const EIGHT: usize = 8;

/// The numbers of a triangle: three edges ax + by + c, the distance from each, positive within; and ax + by + c − dk, the distance
/// beneath the plane.
const PLANES: usize = 13;

/// Eight triangles.
struct Pack {
    planes: [[f32; EIGHT]; PLANES],
    triangles: [u32; EIGHT],
}

impl Pack {
    /// Makes a pack of at most eight triangles; in place of the others there are some that hide nothing.
    fn new(triangles: &[u32], outlines: &[Outline]) -> Self {
        let mut pack = Self {
            planes: [[0.0; EIGHT]; PLANES],
            triangles: [0; EIGHT],
        };
        pack.planes[2][triangles.len()..].fill(f32::NEG_INFINITY);
        for (lane, triangle) in triangles.iter().enumerate() {
            let numbers = &outlines[*triangle as usize].planes;
            for (plane, number) in pack.planes.iter_mut().zip(numbers) {
                plane[lane] = *number;
            }
            pack.triangles[lane] = *triangle;
        }
        pack
    }

    /// Returns the least distance of a place within an edge, and that beneath the plane.
    #[inline(always)]
    fn within<S: Simd>(&self, simd: S, [x, y, k]: &[f32x8<S>; 3]) -> (f32x8<S>, f32x8<S>) {
        let (first, second, third) = (
            self.line(simd, 0, x, y),
            self.line(simd, 3, x, y),
            self.line(simd, 6, x, y),
        );
        let beneath = self.line(simd, 9, x, y) - self.plane(simd, 12) * *k;
        (first.min(second).min(third), beneath)
    }

    /// Returns ax + by + c, whose numbers follow each other from `first` on.
    #[inline(always)]
    fn line<S: Simd>(&self, simd: S, first: usize, x: &f32x8<S>, y: &f32x8<S>) -> f32x8<S> {
        let [a, b, c] = [first, first + 1, first + 2];
        let rest = self.plane(simd, b).mul_add(*y, self.plane(simd, c));
        self.plane(simd, a).mul_add(*x, rest)
    }

    #[inline(always)]
    fn plane<S: Simd>(&self, simd: S, index: usize) -> f32x8<S> {
        f32x8::from_slice(simd, &self.planes[index])
    }
}

/// The buffer of one light.
pub struct LightBuffer {
    /// U, V and W.
    axes: [DVec3; 3],
    /// 1/d; 0 for parallel rays.
    nearness: f64,
    /// The largest coordinate of the object.
    extent: f32,
    /// The lowest and the highest coordinates of the object.
    low: [f32; 3],
    high: [f32; 3],
    grid: Grid,
    /// The first pack of each cell, and the end of the last.
    starts: Vec<u32>,
    packs: Vec<Pack>,
}

/// Sixteen points as the light sees them.
pub struct Seen {
    place: [[f32; RAYS]; 3],
    error: [f32; RAYS],
    cell: [i32; RAYS],
    /// The points that certainly have nothing above them.
    pub clear: u32,
    /// The points for which the buffer has an answer.
    pub sound: u32,
}

/// Makes a buffer for each light that there is, where that makes its shadows quicker: of convex objects few rays are left to
/// follow. The memory of those before is used again.
pub fn update_light_buffers(
    buffers: &mut Vec<Option<LightBuffer>>,
    level: Level,
    model: &Model,
    lights: &[Option<Light>],
) {
    let few = model.triangles.len() * lights.len() <= MOST_TRIANGLES;
    if !few || model.closed && model.convex {
        *buffers = Vec::new();
        return;
    }
    buffers.resize_with(lights.len(), || None);
    let pairs = buffers.par_iter_mut().zip(lights);
    pairs.for_each(|(buffer, light)| {
        let used = buffer.take().map(|used| used.packs).unwrap_or_default();
        let new = |light| LightBuffer::new(level, model, light, used);
        *buffer = light.as_ref().and_then(new);
    });
}

impl LightBuffer {
    /// Makes the buffer of a light in `packs`, whatever they hold; none for an area light, for one too near, and where a grid does
    /// not suit the mesh.
    fn new(level: Level, model: &Model, light: &Light, mut packs: Vec<Pack>) -> Option<Self> {
        let radius = model.radius;
        let (towards, nearness) = match light.kind {
            LightKind::Area => return None,
            LightKind::Directional => (-direction(light.direction)?, 0.0),
            LightKind::Point | LightKind::Spot => {
                let place = light.position - model.origin;
                (direction(place)?, 1.0 / place.length())
            }
        };
        if radius * nearness > 1.0 / FAR_ENOUGH || !(RADII[0]..RADII[1]).contains(&radius) {
            return None;
        }
        let (u, v) = towards.any_orthonormal_pair();
        let axes = [u, v, towards];
        let places: Vec<DVec3> = (0..model.vertex_count as u32)
            .map(|vertex| mapped(&axes, nearness, model.place(vertex).as_dvec3()))
            .collect();
        let corners = |triangle: &[u32; 3]| triangle.map(|vertex| places[vertex as usize]);
        let used = model.triangles.iter().flat_map(corners);
        let (low, high) = used.fold(
            (DVec3::INFINITY, DVec3::NEG_INFINITY),
            |(low, high), place| (low.min(place), high.max(place)),
        );
        let extent = low.abs().max_element().max(high.abs().max_element());
        let margin = extent * MARGIN;
        let side = (model.triangles.len() as f64 * CELLS)
            .sqrt()
            .clamp(1.0, MOST_CELLS) as usize;
        let cell = (high - low).truncate().max(DVec2::splat(margin)) / side as f64;
        let grid = Grid {
            low: low.truncate().as_vec2().to_array(),
            cell: cell.as_vec2().to_array(),
            scale: (1.0 / cell).as_vec2().to_array(),
            side,
            margin: margin as f32,
        };
        let handedness = u.cross(v).dot(towards).signum();
        let outlines = outlines(level, model, &places, [handedness, extent * AREA_ROUNDINGS]);
        let most = model.triangles.len() * MOST_ENTRIES[0] + MOST_ENTRIES[1];
        let mut ends = vec![0_u32; side * side];
        let mut entries = Vec::with_capacity(4 * model.triangles.len());
        for (triangle, outline) in (0_u32..).zip(&outlines) {
            if model.closed && outline.faces_away {
                continue;
            }
            grid.each_cell(outline, |cell| {
                ends[cell] += 1;
                entries.push((cell as u32, triangle));
            });
            if entries.len() > most {
                return None;
            }
        }
        let count: usize = ends
            .iter()
            .map(|count| count.div_ceil(EIGHT as u32) as usize)
            .sum();
        // Sorted by cells, those of a cell from its end on backwards.
        let mut sum = 0;
        for end in &mut ends {
            sum += *end;
            *end = sum;
        }
        let mut sorted = vec![0; entries.len()];
        for (cell, triangle) in entries.into_iter().rev() {
            let at = &mut ends[cell as usize];
            *at -= 1;
            sorted[*at as usize] = triangle;
        }
        // By now these are the beginnings.
        let mut starts = Vec::with_capacity(ends.len() + 1);
        packs.clear();
        packs.shrink_to(2 * count);
        packs.reserve_exact(count);
        for (cell, first) in ends.iter().enumerate() {
            starts.push(packs.len() as u32);
            let next = ends
                .get(cell + 1)
                .map_or(sorted.len(), |next| *next as usize);
            let of_cell = &sorted[*first as usize..next];
            packs.extend(
                of_cell
                    .chunks(EIGHT)
                    .map(|of_pack| Pack::new(of_pack, &outlines)),
            );
        }
        starts.push(packs.len() as u32);
        Some(Self {
            axes,
            nearness,
            extent: extent as f32,
            low: low.as_vec3().to_array(),
            high: high.as_vec3().to_array(),
            grid,
            starts,
            packs,
        })
    }

    /// Adds the memory held.
    pub fn count(&self, memory: &mut Memory) {
        memory.triangles += capacity(&self.starts) + capacity(&self.packs);
    }

    /// Maps sixteen points, given relative to the middle of the object with their distance from it.
    #[inline(always)]
    pub fn see<S: Simd>(&self, simd: S, from: &Vectors<S>, distance: f32x16<S>) -> Seen {
        // Not with `map`, in whose closures the compiler does not inline a level's instructions.
        let [u, v, w] = self.axes;
        let across = dot(from, &splat(simd, u.as_vec3()));
        let up = dot(from, &splat(simd, v.as_vec3()));
        let towards = dot(from, &splat(simd, w.as_vec3()));
        let one = f32x16::splat(simd, 1.0);
        let shrunk = one - towards * (self.nearness as f32);
        let scale = one / shrunk;
        let place = [across * scale, up * scale, towards * scale];
        let error = distance.mul_add(scale, f32x16::splat(simd, self.extent)) * ROUNDINGS;
        let margin = f32x16::splat(simd, self.grid.margin);
        let sound = shrunk.simd_gt(f32x16::splat(simd, 0.0)) & error.simd_le(margin * 0.5);
        let mut clear = place[2].simd_gt(margin + self.high[2]);
        for ((place, low), high) in place.iter().zip(self.low).zip(self.high).take(2) {
            clear |=
                place.simd_gt(margin + high) | place.simd_lt(f32x16::splat(simd, low) - margin);
        }
        let mut seen = Seen {
            place: [[0.0; RAYS]; 3],
            error: [0.0; RAYS],
            cell: [0; RAYS],
            clear: bits(clear & sound),
            sound: bits(sound),
        };
        for (stored, lanes) in seen.place.iter_mut().zip(place) {
            lanes.store_slice(stored);
        }
        error.store_slice(&mut seen.error);
        let (column, row) = (
            self.grid.indices(simd, place[0], 0),
            self.grid.indices(simd, place[1], 1),
        );
        (row * self.grid.side as i32 + column).store_slice(&mut seen.cell);
        seen
    }

    /// Returns whether a triangle hides the point `ray` of those seen, where that is known: not at an edge, for which another
    /// triangle may decide that is not here. `meets` decides for a triangle whose plane is near.
    #[inline(always)]
    pub fn hides<S: Simd>(
        &self,
        simd: S,
        seen: &Seen,
        ray: usize,
        mut meets: impl FnMut(u32) -> bool,
    ) -> Option<bool> {
        let cell = seen.cell[ray] as usize;
        let packs = &self.packs[self.starts[cell] as usize..self.starts[cell + 1] as usize];
        let at = |axis: usize| f32x8::splat(simd, seen.place[axis][ray]);
        let place = [at(0), at(1), at(2)];
        let error = f32x8::splat(simd, seen.error[ray]);
        let mut uncertain = false;
        for pack in packs {
            let (inside, beneath) = pack.within(simd, &place);
            let within = inside.min(beneath);
            if within.simd_gt(error).any_true() {
                return Some(true);
            }
            uncertain |= within.simd_ge(-error).any_true();
        }
        if !uncertain {
            return Some(false);
        }
        let mut at_edge = false;
        for pack in packs {
            let (inside, beneath) = pack.within(simd, &place);
            let near = inside.min(beneath).simd_ge(-error);
            for lane in rays_of(near.to_bitmask() as u32) {
                if meets(pack.triangles[lane]) {
                    return Some(true);
                }
            }
            at_edge |= (near & inside.simd_le(error)).any_true();
        }
        (!at_edge).then_some(false)
    }
}

/// Maps a place, relative to the middle of the object.
fn mapped(axes: &[DVec3; 3], nearness: f64, place: DVec3) -> DVec3 {
    let [across, up, towards] = axes.map(|axis| axis.dot(place));
    DVec3::new(across, up, towards) / (1.0 - towards * nearness)
}

/// A triangle as the light sees it: its bounds, and its numbers in a [`Pack`].
#[derive(Clone, Copy, Default)]
struct Outline {
    /// True if it certainly shows the light its back.
    faces_away: bool,
    low: [f32; 2],
    high: [f32; 2],
    planes: [f32; PLANES],
}

/// Returns the outlines of all triangles, whose corners are at these mapped places. A triangle that faces the light has an area of the
/// sign of the first of `sign_and_rounding`; the second is the rounding of an area over the length of the sides.
fn outlines(
    level: Level,
    model: &Model,
    places: &[DVec3],
    sign_and_rounding: [f64; 2],
) -> Vec<Outline> {
    let mut outlines = vec![Outline::default(); model.triangles.len()];
    for (triangles, outlines) in model
        .triangles
        .chunks(EIGHT)
        .zip(outlines.chunks_mut(EIGHT))
    {
        let mut corners = [[[0.0; EIGHT]; 3]; 3];
        for (lane, triangle) in triangles.iter().enumerate() {
            for (corner, vertex) in corners.iter_mut().zip(triangle) {
                let place = places[*vertex as usize];
                for (axis, plane) in corner.iter_mut().enumerate() {
                    plane[lane] = place[axis];
                }
            }
        }
        dispatch!(level, simd => outline(simd, &corners, sign_and_rounding, outlines));
    }
    outlines
}

/// Computes the outlines of eight triangles or fewer.
#[inline(always)]
fn outline<S: Simd>(
    simd: S,
    corners: &[[[f64; EIGHT]; 3]; 3],
    [sign, rounding]: [f64; 2],
    outlines: &mut [Outline],
) {
    let [a, b, c] = corners;
    let (a, b, c): ([f64x8<S>; 3], _, _) = (load(simd, a, 0), load(simd, b, 0), load(simd, c, 0));
    let zero = f64x8::splat(simd, 0.0);
    let bounds = |axis: usize, bound: fn(f64x8<S>, f64x8<S>) -> f64x8<S>| {
        narrow(bound(bound(a[axis], b[axis]), c[axis]))
    };
    let (e1, e2) = (sub(b, a), sub(c, a));
    let normal = cross(e1, e2);
    // Counter-clockwise from the light.
    let area = normal[2];
    let turn = f64x8::splat(simd, 1.0).copysign(area);
    // An edge or a plane without extent has no sides: all is on it.
    let inverse = |square: f64x8<S>| {
        square
            .simd_gt(zero)
            .select(f64x8::splat(simd, 1.0) / square.sqrt(), zero)
    };
    let mut planes = [[0.0; EIGHT]; PLANES];
    for (edge, (from, to)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
        let [x, y, _] = sub(to, from);
        let scale = inverse(x * x + y * y) * turn;
        let (x, y) = (-y * scale, x * scale);
        planes[3 * edge] = narrow(x);
        planes[3 * edge + 1] = narrow(y);
        planes[3 * edge + 2] = narrow(-(x * from[0] + y * from[1]));
    }
    let scale = inverse(dot3(normal, normal)) * turn;
    let normal = [normal[0] * scale, normal[1] * scale, normal[2] * scale];
    planes[9] = narrow(-normal[0]);
    planes[10] = narrow(-normal[1]);
    planes[11] = narrow(dot3(normal, a));
    planes[12] = narrow(normal[2]);
    let sides = e1[0].abs() + e1[1].abs() + e2[0].abs() + e2[1].abs();
    let away = (area * sign).simd_lt(-(sides * rounding)).to_bitmask();
    let low = [bounds(0, f64x8::min), bounds(1, f64x8::min)];
    let high = [bounds(0, f64x8::max), bounds(1, f64x8::max)];
    for (lane, outline) in outlines.iter_mut().enumerate() {
        outline.faces_away = away >> lane & 1 == 1;
        outline.low = [low[0][lane], low[1][lane]];
        outline.high = [high[0][lane], high[1][lane]];
        for (number, plane) in outline.planes.iter_mut().zip(&planes) {
            *number = plane[lane];
        }
    }
}

/// Returns the numbers in single precision.
#[inline(always)]
fn narrow<S: Simd>(numbers: f64x8<S>) -> [f32; EIGHT] {
    let mut wide = [0.0_f64; EIGHT];
    numbers.store_slice(&mut wide);
    wide.map(|number| number as f32)
}

/// The cells of a buffer.
struct Grid {
    low: [f32; 2],
    cell: [f32; 2],
    scale: [f32; 2],
    side: usize,
    margin: f32,
}

impl Grid {
    /// Returns the column or row of a place, the nearest one of a place beside the grid.
    #[inline(always)]
    fn index(&self, at: f32, axis: usize) -> usize {
        (((at - self.low[axis]) * self.scale[axis]) as usize).min(self.side - 1)
    }

    /// Returns the columns or rows of sixteen places.
    #[inline(always)]
    fn indices<S: Simd>(&self, simd: S, at: f32x16<S>, axis: usize) -> i32x16<S> {
        let last = f32x16::splat(simd, (self.side - 1) as f32);
        let index = (at - self.low[axis]) * self.scale[axis];
        i32x16::truncate_from(index.max(f32x16::splat(simd, 0.0)).min(last))
    }

    /// Calls `each` with the cells that hold a part of a triangle, or come near one.
    #[inline(always)]
    fn each_cell(&self, outline: &Outline, mut each: impl FnMut(usize)) {
        let first = [0, 1].map(|axis| self.index(outline.low[axis] - self.margin, axis));
        let last = [0, 1].map(|axis| self.index(outline.high[axis] + self.margin, axis));
        let few = last[0] - first[0] < 2 && last[1] - first[1] < 2;
        let centre =
            [0, 1].map(|axis| self.low[axis] + self.cell[axis] * (first[axis] as f32 + 0.5));
        let half = self.cell.map(|side| 0.5 * side + 2.0 * self.margin);
        let edges = [0, 3, 6].map(|first| [0, 1, 2].map(|of| outline.planes[first + of]));
        // The greatest distance within each edge that any place of the first cell has.
        let greatest = edges.map(|[x, y, c]| {
            x * centre[0] + y * centre[1] + c + x.abs() * half[0] + y.abs() * half[1]
        });
        for row in first[1]..=last[1] {
            for column in first[0]..=last[0] {
                let (across, up) = (
                    (column - first[0]) as f32 * self.cell[0],
                    (row - first[1]) as f32 * self.cell[1],
                );
                let touches = |(greatest, [x, y, _]): (&f32, &[f32; 3])| {
                    greatest + x * across + y * up >= 0.0
                };
                if few || greatest.iter().zip(&edges).all(touches) {
                    each(row * self.side + column);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::bvh::Bvh;
    use super::super::packet::{Packet, rays_of};
    use super::super::traverse::meet;
    use super::super::traverse::tests::model;
    use super::*;
    use crate::scene::ObjectKind;

    fn lights() -> [Light; 4] {
        let lamp = |position: DVec3| Light {
            kind: LightKind::Point,
            position,
            ..Light::default()
        };
        [
            lamp(DVec3::new(2.2, 2.4, 1.4)),
            lamp(DVec3::new(0.0, -2.6, 0.2)),
            lamp(DVec3::new(-3e8, 2e8, 1e8)),
            Light {
                kind: LightKind::Directional,
                direction: DVec3::new(0.2, -1.0, 0.4),
                ..Light::default()
            },
        ]
    }

    /// Returns the way from a point, relative to the middle of the object, to a light, and the end of its parameter.
    fn way(model: &Model, light: &Light, from: DVec3) -> (DVec3, f64) {
        match light.kind {
            LightKind::Directional => (-light.direction, f64::MAX),
            _ => (light.position - model.origin - from, 1.0),
        }
    }

    /// Asserts that the buffer's answers are those of the boxes; returns how many points are hidden, have an answer, and have none.
    fn compare(model: &Model, buffer: &LightBuffer, light: &Light, points: &[DVec3]) -> [u32; 3] {
        let bvh = Bvh::new(model);
        let [mut hidden, mut known, mut unknown] = [0; 3];
        for points in points.chunks(RAYS) {
            let mut packet = Packet::default();
            let mut planes = [[0.0_f32; RAYS]; 3];
            for (ray, origin) in points.iter().enumerate() {
                for (plane, place) in planes.iter_mut().zip(origin.to_array()) {
                    plane[ray] = place as f32;
                }
                let (direction, t_max) = way(model, light, *origin);
                packet.set(ray, *origin, direction, t_max);
            }
            let all = u32::MAX >> (32 - points.len());
            for level in [Level::new(), Level::baseline()] {
                let blocked = dispatch!(level, simd => bvh.blocked(simd, &packet, all));
                let (mut found, mut none) = (0, 0);
                let seen = dispatch!(level, simd => {
                    let from: Vectors<_> = load(simd, &planes, 0);
                    buffer.see(simd, &from, dot(&from, &from).sqrt())
                });
                for ray in rays_of(seen.sound & !seen.clear & all) {
                    let meets = |triangle: u32| {
                        let corners = model.triangles[triangle as usize].map(|v| model.place(v));
                        let (origin, direction, t_max) = packet.ray(ray);
                        meet(&corners, origin, direction, t_max).is_some()
                    };
                    match dispatch!(level, simd => buffer.hides(simd, &seen, ray, meets)) {
                        Some(hides) => found |= u32::from(hides) << ray,
                        None => none |= 1 << ray,
                    }
                }
                let answered = seen.sound & all & !none;
                assert_eq!(found, blocked & answered, "{:?}", light.position);
                hidden += found.count_ones();
                known += answered.count_ones();
                unknown += none.count_ones();
            }
        }
        [hidden, known, unknown]
    }

    #[test]
    fn a_buffer_hides_what_the_boxes_hide() {
        let part = |k: usize, factor: f64| (k as f64 * factor).fract() * 2.0 - 1.0;
        let point = |k: usize| {
            // Near the object, and some far below.
            let far = if k.is_multiple_of(7) { 20.0 } else { 1.6 };
            DVec3::new(part(k, 0.618_034), part(k, 0.754_877), part(k, 0.569_84)) * far
        };
        let points: Vec<DVec3> = (1..=4000).map(point).collect();
        for kind in [ObjectKind::Torus, ObjectKind::Teapot, ObjectKind::Plane] {
            let model = model(kind);
            let mut used = Vec::new();
            for light in lights() {
                let buffer =
                    LightBuffer::new(Level::new(), &model, &light, used).expect("a buffer");
                let [hidden, known, _] = compare(&model, &buffer, &light, &points);
                assert!(
                    hidden > 100 && known > 7000,
                    "{kind:?}: {hidden} of {known}"
                );
                used = buffer.packs;
            }
        }
    }

    #[test]
    fn a_buffer_has_no_answer_where_a_triangle_that_it_lacks_may_decide() {
        let model = model(ObjectKind::Torus);
        for light in lights() {
            let buffer = LightBuffer::new(Level::new(), &model, &light, vec![]).expect("a buffer");
            let mut points = Vec::new();
            for triangle in &model.triangles {
                let corners = triangle.map(|vertex| model.place(vertex).as_dvec3());
                for (from, to) in
                    [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (corners[from], corners[to]))
                {
                    let on_edge = from.lerp(to, 0.37);
                    let (towards, _) = way(&model, &light, on_edge);
                    let aside = (to - from).cross(towards).normalize_or_zero();
                    // Around the distance by which the boxes' test widens a triangle.
                    for distance in (1..24).map(|k| 1e-10 * f64::from(k)) {
                        let near = on_edge + aside * distance * (to - from).length();
                        points.push(near - towards.normalize());
                        points.push(near - aside * distance * 2.0 - towards.normalize());
                    }
                }
            }
            let [hidden, known, unknown] = compare(&model, &buffer, &light, &points);
            assert!(
                hidden > 100 && unknown > 100,
                "{hidden} of {known}, {unknown}"
            );
        }
    }

    #[test]
    fn what_no_grid_suits_has_no_buffer() {
        let torus = model(ObjectKind::Torus);
        let [lamp, ..] = lights();
        let near = Light {
            position: DVec3::new(0.0, 1.1 * torus.radius, 0.0),
            ..lamp.clone()
        };
        let area = Light {
            kind: LightKind::Area,
            ..lamp.clone()
        };
        for light in [near, area] {
            assert!(
                LightBuffer::new(Level::new(), &torus, &light, vec![]).is_none(),
                "{:?}",
                light.kind
            );
        }
        let sphere = model(ObjectKind::Sphere);
        let mut buffers = Vec::new();
        for (model, expected) in [(&torus, 1), (&sphere, 0)] {
            update_light_buffers(&mut buffers, Level::new(), model, &[Some(lamp.clone())]);
            assert_eq!(buffers.iter().flatten().count(), expected);
        }
        // Long thin triangles, each over many cells.
        let count = 20_000;
        let mut needles = Model {
            vertex_count: 3 * count,
            radius: 1.5,
            ..Model::default()
        };
        for k in 0..count as u32 {
            let turn = f64::from(k) * 2.399_963;
            let away = DVec3::new(turn.cos(), 0.0, turn.sin());
            for place in [away, -away, -away + DVec3::new(0.0, 1e-3, 0.0)] {
                for axis in 0..3 {
                    needles.position[axis].push(place[axis] as f32);
                }
            }
            needles.triangles.push([3 * k, 3 * k + 1, 3 * k + 2]);
        }
        assert!(LightBuffer::new(Level::new(), &needles, &lamp, vec![]).is_none());
    }
}
