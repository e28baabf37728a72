//! The crossings of a scan line with a polygon: the points P and Q between which values are interpolated (Gouraud 1971).
//!
//! ```text
//!            a                         crossings from the left, in pairs: outside to inside, inside to outside
//!           ╱  ╲                       P divides its edge ab in the ratio α : 1−α
//!    ───── P━━━━Q ─────  line          a place beside all pairs has the value of the nearest crossing
//!         ╱       ╲
//!        b─────────c
//! ```
//!
//! The picture and the reference take their crossings from here. The grid of the picture's positions decides whether an
//! edge is crossed, so that both use the same pairs.

use super::cover::Band;
use super::grid::{BandExtent, GridPosition, HALF, SUBPIXELS};
use super::transform::{BAND_HEIGHT, MANY, edge_table, edges, is_whole};
use super::triangles::Triangles;
use std::collections::HashMap;

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The x coordinate, in the unit of the positions.
    pub x: f64,
    /// The edge's vertices, in the polygon's order.
    pub ends: [u32; 2],
    /// The position on the edge: 0 at its first vertex, 1 at its second.
    pub alpha: f64,
}

/// Returns the crossing of the line at height `y`, fixed point, with an edge.
#[inline(always)]
fn cross(ends: [u32; 2], places: &[GridPosition], y: f64) -> Option<Crossing> {
    let [a, b] = ends.map(|v| places[v as usize]);
    let (ya, yb) = (f64::from(a[1]), f64::from(b[1]));
    if (ya <= y) == (yb <= y) {
        return None;
    }
    let alpha = (y - ya) / (yb - ya);
    Some(Crossing {
        x: (1.0 - alpha) * f64::from(a[0]) + alpha * f64::from(b[0]),
        ends,
        alpha,
    })
}

/// Returns P and Q for a point of the line: the pair that it lies between, or the nearest.
#[inline(always)]
pub fn crossing_pair(crossings: &[Crossing], x: f64) -> Option<[&Crossing; 2]> {
    let pairs = crossings.as_chunks::<2>().0;
    let after = pairs.partition_point(|[p, _]| p.x <= x);
    let outside = |[p, q]: &[Crossing; 2]| (p.x - x).max(x - q.x);
    let nearer = match (after.checked_sub(1).map(|k| &pairs[k]), pairs.get(after)) {
        (Some(left), Some(right)) if outside(right) < outside(left) => right,
        (Some(left), _) => left,
        (None, right) => right?,
    };
    Some(nearer.each_ref())
}

/// The outline that the scan line crosses where a triangle is visible.
pub enum Outline<'a> {
    /// A triangle by itself: a clipped polygon has lost corners, so that its pieces are treated separately.
    Triangle([u32; 3]),
    Polygon(u32, &'a [u32]),
    /// A polygon of many corners, by its edges in each band.
    Many(u32, &'a [Vec<[u32; 2]>]),
}

impl<'a> Outline<'a> {
    pub fn of(triangles: &Triangles<'a>, triangle: u32) -> Self {
        let (placed, model) = (triangles.placed, triangles.model);
        let alone = Self::Triangle(triangles.vertices(triangle));
        if triangles.is_piece(triangle) {
            return alone;
        }
        let face = triangles.face(triangle);
        let polygon = model.face(face);
        if polygon.len() <= MANY {
            return if is_whole(polygon, &placed.places) {
                Self::Polygon(face, polygon)
            } else {
                alone
            };
        }
        let table = placed
            .edges
            .get_or_init(|| edge_table(model, &placed.places, placed.rows));
        table
            .get(&face)
            .and_then(Option::as_ref)
            .map_or(alone, |bands| Self::Many(face, bands))
    }

    /// Finds the crossings with the line at height `y`, fixed point, from the left.
    pub fn cross(&self, places: &[GridPosition], y: f64, crossings: &mut Vec<Crossing>) {
        let at = |ends| cross(ends, places, y);
        crossings.clear();
        match self {
            Self::Triangle(vertices) => crossings.extend(edges(vertices).filter_map(at)),
            Self::Polygon(_, vertices) => crossings.extend(edges(vertices).filter_map(at)),
            Self::Many(_, bands) => {
                let band = ((y / f64::from(BAND_HEIGHT)).max(0.0) as usize)
                    .min(bands.len().saturating_sub(1));
                crossings.extend(bands[band].iter().copied().filter_map(at));
            }
        }
        crossings.sort_unstable_by(|p, q| p.x.total_cmp(&q.x));
    }
}

/// The crossings of a band's polygons with its rows.
pub struct Outlines<'a> {
    triangles: Triangles<'a>,
    place: BandExtent,
    /// True if rows are looked up in ascending order.
    sorted: bool,
    /// The face and row that `crossings` belong to; `None` for those of a triangle.
    at: Option<(u32, i32)>,
    crossings: Vec<Crossing>,
    /// The crossings of polygons of many corners, row by row, computed at first use.
    many: HashMap<u32, Vec<Vec<Crossing>>>,
}

impl<'a> Outlines<'a> {
    pub fn new(triangles: Triangles<'a>, Band { place, sorted, .. }: &Band) -> Self {
        Self {
            triangles,
            place: *place,
            sorted: *sorted,
            at: None,
            crossings: Vec::new(),
            many: HashMap::new(),
        }
    }

    /// Returns the crossings of the outline where `triangle` is visible with pixel row `y`.
    pub fn crossings(&mut self, triangle: u32, y: i32) -> &[Crossing] {
        if !self.triangles.is_piece(triangle) && self.at == Some((self.triangles.face(triangle), y))
        {
            return &self.crossings;
        }
        let (places, line) = (
            &self.triangles.placed.places,
            f64::from(y * SUBPIXELS + HALF),
        );
        let outline = Outline::of(&self.triangles, triangle);
        self.at = match outline {
            Outline::Many(face, _) => {
                let rows = self
                    .many
                    .entry(face)
                    .or_insert_with(|| vec![Vec::new(); self.place.rows as usize]);
                let row = (y - self.place.first_row.cast_signed()) as usize;
                if rows[row].is_empty() {
                    if self.sorted {
                        rows[..row].fill(Vec::new());
                    }
                    outline.cross(places, line, &mut rows[row]);
                }
                return &rows[row];
            }
            Outline::Polygon(face, _) => Some((face, y)),
            Outline::Triangle(_) => None,
        };
        outline.cross(places, line, &mut self.crossings);
        &self.crossings
    }
}
