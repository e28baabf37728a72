//! Which points need no ray to a light, because the light sees none of the object's outlines near them.
//!
//! What hides a point from a light changes only where an outline passes before it (A. Appel, *The notion of quantitative
//! invisibility*, 1967). The light's view of the object is divided into cells. A cell is open if no outline passes it or the cells
//! beside it; the number of sheets of surface in such a block of nine is the same everywhere. It is the winding number of the
//! outlines, summed along each row of cells.
//!
//! - No sheet: nothing in the block meets a ray from the light, so all its points are lit.
//! - A sheet that lies wholly above the floor: the floor's points are in shadow.
//! - One sheet that faces the light, and those that face away lie behind it: the object's own points that face the light are lit.
//!   Such a point starts on a triangle of this sheet, for triangles that face away have no normal that faces the light; all
//!   others are taken for outlines. From there it is raised in a direction that its triangle's vertex normals span. All of these
//!   normals lie on the outer side of every triangle of the sheet in the block, and points whose lift might leave the block are
//!   not asked about. So the lift leads away from the sheet, towards the light, and meets it nowhere; the ray goes through
//!   the sheet once, and that is behind the point.
//!
//! Margins are wider than the rounding, and than the seam by which rays widen triangles.

use super::packet::{bits, dot, rays_of, splat};
use super::proof::{Points, RADII, Target};
use super::solid::{LIFT, Solid};
use fearless_simd::{f32x16, prelude::*};
use glam::{DVec2, DVec3, Vec3, Vec4};

/// Cells along a side of a light's view.
const SIDE: usize = 256;
/// Cells along a side of the larger ones in which the normals are compared.
const COARSE: usize = 2;
/// Cells that stay free along each border.
const BORDER: f64 = 2.0;
/// Where in its cell the sheets are counted: off the symmetries that objects and lights have.
const SAMPLE: DVec2 = DVec2::new(0.382, 0.618);
/// A light must be as many radii away, so that its view is not too distorted.
const NEAREST: f64 = 1.5;
/// From farther away, in radii, directions are rounded too much.
const FARTHEST_LIGHT: f64 = 1e9;
const FARTHEST_POINT: f64 = 64.0;
/// Farther from the origin of the world, in radii, points are rounded by as much as they are lifted.
const FARTHEST_OBJECT: f64 = 1e4;
/// Cosine of the least angle between a decided triangle's normal and the plane across the ray. A seam of 10⁻⁹ of the longest edge, two
/// radii, on a triangle seen that flat reaches less far than the lift of 10⁻⁶ radii times [`ALIKE`].
const EDGE_ON: f64 = 0.01;
/// Twice a triangle's area over the square of its longest edge; below, its normal and its seams are rounded too much.
const SLIVER: f64 = 1e-3;
/// The least cosine between any two normals of a block.
const ALIKE: f32 = 0.25;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Facing {
    Light,
    Away,
    Undecided,
}

/// A light's projection: perspective, or parallel for parallel rays. Places are relative to the ball's middle.
struct Projection {
    /// The light, or the unit vector towards it.
    place: DVec3,
    parallel: bool,
    /// Unit, from the middle of the ball to the light.
    nearer: DVec3,
    /// The same over the light's distance, 0 for parallel rays.
    shrink: DVec3,
    /// Cells per unit of length at the middle.
    right: DVec3,
    up: DVec3,
    /// Whether no lift of the object's own points leaves a block, or changes which triangles face the light.
    lifts: bool,
}

impl Projection {
    fn new(target: &Target, radius: f64) -> Option<Self> {
        let nearer = target.place.try_normalize()?;
        let inverse = if target.parallel {
            0.0
        } else {
            1.0 / target.place.length()
        };
        // The part of the light's distance that the radius is.
        let part = radius * inverse;
        let usual = inverse > 0.0 || target.parallel;
        if !usual || part * NEAREST > 1.0 || !target.parallel && part * FARTHEST_LIGHT < 1.0 {
            return None;
        }
        let extent = radius / (1.0 - part * part).sqrt();
        let scale = (0.5 * SIDE as f64 - BORDER) / extent;
        let right = nearer.any_orthonormal_vector();
        // The longest image of a unit of length within the ball, cells.
        let longest = scale * (1.0 + extent * inverse) / (1.0 - part);
        let turn = if target.parallel {
            f64::INFINITY
        } else {
            0.4 * EDGE_ON * (1.0 / inverse - radius)
        };
        Some(Self {
            place: if target.parallel {
                nearer
            } else {
                target.place
            },
            parallel: target.parallel,
            nearer,
            shrink: nearer * inverse,
            right: right * scale,
            up: nearer.cross(right) * scale,
            lifts: LIFT * radius < turn.min(0.9 / longest),
        })
    }

    fn project(&self, point: DVec3) -> DVec2 {
        let depth = 1.0 - self.shrink.dot(point);
        DVec2::new(self.right.dot(point), self.up.dot(point)) / depth + 0.5 * SIDE as f64
    }

    /// How a triangle faces the light; with vertex normals, how all points on it do that are raised along these.
    fn facing(&self, corners: &[DVec3; 3], normals: Option<&[DVec3; 3]>) -> Facing {
        let [a, b, c] = *corners;
        let ways = corners.map(|corner| {
            if self.parallel {
                self.place
            } else {
                self.place - corner
            }
        });
        let normal = (b - a).cross(c - a);
        let longest = (b - a)
            .length_squared()
            .max((c - a).length_squared())
            .max((c - b).length_squared());
        let area = normal.length();
        let cosine = normal.dot(ways[0]) / (area * ways[0].length());
        if !(area >= SLIVER * longest && cosine.abs() > EDGE_ON) {
            return Facing::Undecided;
        }
        let away = cosine < 0.0;
        if let Some(normals) = normals {
            let faces_away = |normal: &DVec3| {
                ways.iter()
                    .all(|way| normal.dot(*way) < -EDGE_ON * way.length())
            };
            let unit = normals.iter().all(|normal| normal.length_squared() > 0.99);
            if !unit || away && !normals.iter().all(faces_away) {
                return Facing::Undecided;
            }
        }
        if away { Facing::Away } else { Facing::Light }
    }
}

/// What is known of a cell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Cell {
    Unknown,
    Lit,
    /// Of the floor.
    Dark,
}

/// A cell while the map is made.
#[derive(Clone, Copy)]
struct Draft {
    outline: bool,
    /// Sheets that face the light and that face away, less those of the cell before.
    sheets: [i32; 2],
}

/// Bounds of the normals in a block that face the light; the last component has the least height towards the light of what
/// faces it, and the greatest of what faces away.
type Bounds = [Vec4; 2];

/// The cells of a light's view.
pub struct LightMap {
    shrink: Vec3,
    right: Vec3,
    up: Vec3,
    /// The greatest distance from the middle of the ball.
    reach: f32,
    /// The greatest height of a point of the floor.
    floor: f32,
    cells: Vec<Cell>,
}

impl LightMap {
    /// The map for the object's own points, or for all others; `ground` is the floor's height. None where the light is too near
    /// or a size out of range.
    pub fn new(solid: &Solid<'_>, target: &Target, ground: Option<f64>, own: bool) -> Option<Self> {
        let (middle, radius) = solid.ball();
        let sized = radius > f64::from(RADII[0]) && radius < f64::from(RADII[1]);
        let near = middle.length() < FARTHEST_OBJECT * radius;
        if !(sized && near) {
            return None;
        }
        let projection = Projection::new(target, radius)?;
        if own && !projection.lifts {
            return None;
        }
        let above = 2.0 * solid.clearance();
        let floor = ground.map_or(f64::INFINITY, |ground| ground - middle.y + above);
        let casts = if target.parallel {
            target.place.y > 0.0
        } else {
            target.place.y > floor
        };
        let floor = if casts { floor } else { f64::INFINITY };
        Some(Self {
            cells: draw(solid, &projection, floor, own)?,
            shrink: projection.shrink.as_vec3(),
            right: projection.right.as_vec3(),
            up: projection.up.as_vec3(),
            reach: (radius * FARTHEST_POINT) as f32,
            floor: (0.75 * above) as f32,
        })
    }

    /// Which of the points asked about are certainly lit, and which certainly in shadow.
    #[inline(always)]
    pub fn decide<S: Simd>(&self, simd: S, points: &Points<S>, asked: u32) -> [u32; 2] {
        let along = |axis: Vec3| dot(&points.from, &splat(simd, axis));
        let number = |x: f32| f32x16::splat(simd, x);
        let (zero, side) = (number(0.0), number(SIDE as f32));
        let depth = number(1.0) - along(self.shrink);
        let x = along(self.right) / depth + side * 0.5;
        let y = along(self.up) / depth + side * 0.5;
        let sound = depth.simd_gt(number(0.2)) & points.distance.simd_lt(number(self.reach));
        let within = x.simd_ge(zero) & x.simd_lt(side) & y.simd_ge(zero) & y.simd_lt(side);
        let on_floor = bits(points.above.simd_le(number(self.floor)));
        let [mut lit, mut dark] = [0, 0];
        for lane in rays_of(asked & bits(sound & within)) {
            let cell = self.cells[y[lane] as usize * SIDE + x[lane] as usize];
            lit |= u32::from(cell == Cell::Lit) << lane;
            dark |= u32::from(cell == Cell::Dark) << lane;
        }
        [lit, dark & on_floor]
    }
}

/// The cells of the view; none if anything of the object is nowhere in it. What lies wholly above `floor` shadows the floor.
fn draw(solid: &Solid<'_>, projection: &Projection, floor: f64, own: bool) -> Option<Vec<Cell>> {
    let bvh = solid.bvh;
    let neighbours = &bvh.adjacency().0;
    let normals_of = |index: usize| {
        let vertices = solid.model.triangles[bvh.order[index] as usize];
        vertices.map(|vertex| solid.model.normal(vertex))
    };
    let corners_of = |index: usize| bvh.corners[index].map(|corner| corner.as_dvec3());
    let facing_of = |index: usize| {
        let normals = own.then(|| normals_of(index));
        projection.facing(&corners_of(index), normals.as_ref())
    };
    let facings: Vec<Facing> = (0..bvh.corners.len()).map(facing_of).collect();
    let mut cells = vec![
        Draft {
            outline: false,
            sheets: [0; 2]
        };
        SIDE * SIDE
    ];
    let empty = [Vec4::INFINITY, Vec4::NEG_INFINITY];
    let mut bounds: Vec<Bounds> = vec![empty; if own { (SIDE / COARSE).pow(2) } else { 0 }];
    // Whether any of what faces the light, or faces away, reaches down to the floor.
    let mut low = [floor == f64::INFINITY; 2];
    for (index, &facing) in facings.iter().enumerate() {
        let corners = corners_of(index);
        let places = corners.map(|corner| projection.project(corner));
        if !places.iter().all(|place| place.is_finite()) {
            return None;
        }
        if facing == Facing::Undecided {
            spans(&places, 1, |range| {
                cells[range].iter_mut().for_each(|cell| cell.outline = true);
            });
            continue;
        }
        let away = facing == Facing::Away;
        low[usize::from(away)] |= corners.iter().any(|corner| corner.y <= floor);
        for edge in 0..3 {
            let other = neighbours[index][edge] as usize;
            if facings.get(other) != Some(&facing) {
                let ends = [places[edge], places[(edge + 1) % 3]];
                spans(&ends, 1, |range| {
                    cells[range].iter_mut().for_each(|cell| cell.outline = true);
                });
                wind(ends, away, &mut cells);
            }
        }
        if own {
            let [least, greatest] = bounds_of(&corners, &normals_of(index), away, projection);
            spans(&places, COARSE, |range| {
                for [low, high] in &mut bounds[range] {
                    (*low, *high) = (low.min(least), high.max(greatest));
                }
            });
        }
    }
    let margin = (2.0 * LIFT * solid.ball().1) as f32;
    let mut sheets = [0; 2];
    let known = |(index, draft): (usize, &Draft)| {
        if index % SIDE == 0 {
            sheets = [0; 2];
        }
        sheets = [0, 1].map(|side| sheets[side] + draft.sheets[side]);
        let single = || {
            own && sheets[0] == 1 && {
                let (row, column) = (index / SIDE / COARSE, index % SIDE / COARSE);
                is_single(&bounds[row * (SIDE / COARSE) + column], margin)
            }
        };
        let shadows = || !own && (0..2).any(|side| sheets[side] > 0 && !low[side]);
        match draft.outline {
            true => Cell::Unknown,
            false if sheets == [0; 2] || single() => Cell::Lit,
            false if shadows() => Cell::Dark,
            false => Cell::Unknown,
        }
    };
    Some(cells.iter().enumerate().map(known).collect())
}

/// What a triangle adds to the bounds of the blocks that it touches.
fn bounds_of(
    corners: &[DVec3; 3],
    normals: &[DVec3; 3],
    away: bool,
    projection: &Projection,
) -> Bounds {
    let heights = DVec3::from_array(corners.map(|corner| corner.dot(projection.nearer))).as_vec3();
    if away {
        let greatest = Vec3::NEG_INFINITY.extend(heights.max_element());
        return [Vec4::INFINITY, greatest];
    }
    let [a, b, c] = *corners;
    let normal = (b - a).cross(c - a).normalize_or_zero().as_vec3();
    let [p, q, r] = normals.map(|normal| normal.as_vec3());
    let least = normal.min(p).min(q).min(r).extend(heights.min_element());
    let greatest = normal.max(p).max(q).max(r).extend(f32::NEG_INFINITY);
    [least, greatest]
}

/// Whether all normals of a block's sheet are alike, and what faces away lies behind it.
fn is_single(&[low, high]: &Bounds, margin: f32) -> bool {
    let least = (low * high).min(low * low).min(high * high);
    least.truncate().element_sum() > ALIKE && high.w + margin < low.w
}

/// Calls `each` with the cells of each row, `size` by `size` of the view's in one, that a convex polygon passes less than a cell of
/// the view away.
fn spans(corners: &[DVec2], size: usize, mut each: impl FnMut(std::ops::Range<usize>)) {
    // Whatever is no number lies in the first cell.
    let cell = |x: f64| x.clamp(0.0, SIDE as f64 - 1.0) as usize / size;
    let (low, high) = corners
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), corner| {
            (low.min(corner.y), high.max(corner.y))
        });
    for row in cell(low - 1.0)..=cell(high + 1.0) {
        let begin = (row * size) as f64;
        let strip = [(begin - 1.0, 0.0), (begin + size as f64 + 1.0, 1.0)];
        let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
        for (k, &corner) in corners.iter().enumerate() {
            let next = corners[(k + 1) % corners.len()];
            let (p, q) = if corner.y <= next.y {
                (corner, next)
            } else {
                (next, corner)
            };
            if q.y < strip[0].0 || p.y > strip[1].0 {
                continue;
            }
            for (y, end) in strip {
                let part = (y.max(p.y).min(q.y) - p.y) / (q.y - p.y);
                // A level edge has both its ends in the strip.
                let x = p.x + (q.x - p.x) * if part.is_nan() { end } else { part };
                (first, last) = (first.min(x), last.max(x));
            }
        }
        if first <= last {
            let row = row * (SIDE / size);
            each(row + cell(first - 1.0)..row + cell(last + 1.0) + 1);
        }
    }
}

/// Adds an edge of the region that faces the light, or faces away, to the sheets that are counted along the rows it crosses.
fn wind([p, q]: [DVec2; 2], away: bool, cells: &mut [Draft]) {
    let row = |y: f64| (y - SAMPLE.y).ceil().clamp(0.0, SIDE as f64) as usize;
    // A region goes round counter-clockwise if it faces the light: it begins, from left to right, where its edges lead down.
    let begins = (q.y < p.y) != away;
    for row in row(p.y.min(q.y))..row(p.y.max(q.y)) {
        let part = (row as f64 + SAMPLE.y - p.y) / (q.y - p.y);
        let x = p.x + (q.x - p.x) * part;
        let column = (x - SAMPLE.x).ceil().clamp(0.0, SIDE as f64 - 1.0) as usize;
        cells[row * SIDE + column].sheets[usize::from(away)] += if begins { 1 } else { -1 };
    }
}

#[cfg(test)]
mod tests;
