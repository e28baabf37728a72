//! The transform of vertices to fixed-point positions in the picture.
//!
//! Positions are fixed-point with [`SUBPIXEL_BITS`] fractional bits, so that coverage is decided in exact arithmetic. A vertex
//! that is nearer than the near plane or farther out than the guard band has no position and sends its triangles to the clipper.

use super::grid::{BAND, GUARD, GridPosition, SUBPIXELS, UNPLACED};
use crate::illumination::{LANES, Lanes, Real, V3};
use crate::render::lens::{Lens, NEAR};
use crate::render::model::Model;
use crate::render::node::{Memory, capacity};
use fearless_simd::{Level, dispatch, i32x16, mask32x16, prelude::*};
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::OnceLock;

/// The vertices that one task transforms: some microseconds of work.
const CHUNK: usize = 4096;

/// The transform stage's output.
#[derive(Default)]
pub struct Placed {
    /// The position of each vertex, padding included; after them those that clipping adds.
    pub places: Vec<GridPosition>,
    /// The depth key of each, see [`Lens::key_from_depth`].
    pub keys: Vec<f32>,
    pub rows: u32,
    /// The edges that scan lines cross, computed at first use.
    pub edges: OnceLock<EdgeTable>,
}

impl Placed {
    pub fn count(&self, memory: &mut Memory) {
        let edges = self
            .edges
            .get()
            .into_iter()
            .flat_map(|table| table.values().flatten().flatten());
        memory.vertices +=
            capacity(&self.places) + capacity(&self.keys) + edges.map(capacity).sum::<u64>();
    }

    #[inline(always)]
    pub fn corners(&self, [a, b, c]: [u32; 3]) -> [GridPosition; 3] {
        [
            self.places[a as usize],
            self.places[b as usize],
            self.places[c as usize],
        ]
    }

    pub fn run(&mut self, level: Level, lens: &Lens, model: &Model, height: u32) {
        (self.rows, self.edges) = (height, OnceLock::new());
        let rows = Rows::new(lens, model);
        self.places.clear();
        self.places.resize(model.padded_len(), [UNPLACED; 2]);
        self.keys.clear();
        self.keys.resize(model.padded_len(), 0.0);
        let places = self.places.par_chunks_mut(CHUNK);
        let keys = self.keys.par_chunks_mut(CHUNK);
        places
            .zip(keys)
            .enumerate()
            .for_each(|(chunk, (places, keys))| {
                let start = chunk * CHUNK;
                let position = model
                    .position
                    .each_ref()
                    .map(|plane| &plane[start..start + places.len()]);
                dispatch!(level, simd => transform(simd, &rows, position, places, keys));
            });
    }
}

/// The affine map from the model's coordinates to view components, and the lens.
struct Rows {
    /// The right, up and forward rows.
    rows: [[f32; 4]; 3],
    focal: f32,
    middle: [f32; 2],
    perspective: bool,
}

impl Rows {
    /// Prepares the map. The offset is computed in double precision: a model far from the world's origin loses nothing.
    fn new(lens: &Lens, model: &Model) -> Self {
        let offset = lens.view_from_world(model.origin);
        let axes = [
            (lens.right, offset.x),
            (lens.up, offset.y),
            (lens.forward, offset.z),
        ];
        let rows =
            axes.map(|(axis, offset)| (axis / lens.unit).extend(offset).as_vec4().to_array());
        let (focal, middle) = (lens.focal as f32, lens.middle.as_vec2().to_array());
        Self {
            rows,
            focal,
            middle,
            perspective: lens.perspective,
        }
    }
}

#[inline(always)]
fn component<S: Simd>(p: V3<Lanes<S>>, [a, b, c, d]: [f32; 4]) -> Lanes<S> {
    p.x.mul_add(
        p.x.constant(a),
        p.y.mul_add(
            p.x.constant(b),
            p.z.mul_add(p.x.constant(c), p.x.constant(d)),
        ),
    )
}

/// Converts pixels to fixed point; [`UNPLACED`] where `outside`.
#[inline(always)]
fn fixed<S: Simd>(v: Lanes<S>, outside: mask32x16<S>) -> i32x16<S> {
    let rounded = Lanes((v * SUBPIXELS as f32).0.round_ties_even());
    i32x16::truncate_from(Lanes::select(outside, v.constant(UNPLACED as f32), rounded).0)
}

#[inline(always)]
fn transform<S: Simd>(
    simd: S,
    rows: &Rows,
    position: [&[f32]; 3],
    places: &mut [GridPosition],
    keys: &mut [f32],
) {
    let [right, up, forward] = rows.rows;
    let one = Lanes::splat(simd, 1.0);
    let guard = Lanes::splat(simd, GUARD as f32);
    let near = Lanes::splat(simd, NEAR as f32);
    for start in (0..places.len()).step_by(LANES) {
        let [px, py, pz] = position;
        let p = V3::new(
            Lanes::<S>::load(simd, &px[start..]),
            Lanes::load(simd, &py[start..]),
            Lanes::load(simd, &pz[start..]),
        );
        let depth = component(p, forward);
        let (scale, key) = if rows.perspective {
            let inverse = one / depth;
            (inverse * rows.focal, inverse)
        } else {
            (Lanes::splat(simd, rows.focal), -depth)
        };
        let x = component(p, right).mul_add(scale, Lanes::splat(simd, rows.middle[0]));
        let y = Lanes::splat(simd, rows.middle[1]) - component(p, up) * scale;
        let outside =
            near.greater_than(depth) | !guard.greater_than(x.abs()) | !guard.greater_than(y.abs());
        let (fx, fy) = (fixed(x, outside), fixed(y, outside));
        key.0.store_slice(&mut keys[start..start + LANES]);
        for (lane, place) in places[start..start + LANES].iter_mut().enumerate() {
            *place = [fx[lane], fy[lane]];
        }
    }
}

/// The number of corners above which a polygon's edges are sorted into bands, once for all pictures of one view.
pub const MANY: usize = 32;

/// Returns the edges of a polygon, each by its two vertices.
pub fn edges(polygon: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    polygon
        .iter()
        .zip(polygon.iter().cycle().skip(1))
        .map(|(&a, &b)| [a, b])
}

/// Returns whether a polygon has lost no corner to clipping.
pub fn is_whole(polygon: &[u32], places: &[GridPosition]) -> bool {
    polygon.iter().all(|&v| places[v as usize][0] != UNPLACED)
}

/// The edges of polygons of many corners, band by band of the rows that they cross; `None` for a clipped polygon.
pub type EdgeTable = HashMap<u32, Option<Vec<Vec<[u32; 2]>>>>;

pub const BAND_HEIGHT: i32 = BAND.cast_signed() * SUBPIXELS;

/// Builds the table of a model's faces in a picture of `rows` rows.
pub fn edge_table(model: &Model, places: &[GridPosition], rows: u32) -> EdgeTable {
    let last = rows.div_ceil(BAND).cast_signed() - 1;
    let bands = |polygon: &[u32]| {
        let mut bands = vec![Vec::new(); rows.div_ceil(BAND) as usize];
        for ends in edges(polygon) {
            let [a, b] = ends.map(|v| places[v as usize][1].div_euclid(BAND_HEIGHT));
            for band in a.min(b).max(0)..=a.max(b).min(last) {
                bands[band as usize].push(ends);
            }
        }
        bands
    };
    let faces = (0..model.face_count() as u32).map(|face| (face, model.face(face)));
    let many = faces.filter(|(_, polygon)| polygon.len() > MANY);
    many.map(|(face, polygon)| (face, is_whole(polygon, places).then(|| bands(polygon))))
        .collect()
}
