//! The edges of polygons of many corners, sorted into bands of rows once for all pictures of one view.

use super::grid::{BAND, Place, SUBPIXELS, UNPLACED};
use crate::render::memory::room;
use crate::render::model::Model;
use std::collections::HashMap;

/// Polygons of more corners than this have their edges sorted into bands, once for all pictures of one view.
pub const MANY: usize = 32;

/// The edges of a polygon, each by its two vertices.
pub fn edges(polygon: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    polygon.iter().zip(polygon.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// Whether a polygon has lost no corner to clipping.
pub fn is_whole(polygon: &[u32], places: &[Place]) -> bool {
    polygon.iter().all(|&v| places[v as usize][0] != UNPLACED)
}

/// The edges of polygons of many corners, by the bands of rows that they cross. Others are taken as they come.
#[derive(Default)]
pub struct EdgeTable {
    /// For each such face its edges, band by band; none where it has lost corners to clipping.
    pub faces: HashMap<u32, Option<Vec<Vec<[u32; 2]>>>>,
}

/// Height of a band, fixed point.
pub const BAND_HEIGHT: i32 = BAND.cast_signed() * SUBPIXELS;

impl EdgeTable {
    /// The table of a model's faces in a picture of so many rows.
    pub fn new(model: &Model, places: &[Place], rows: u32) -> Self {
        let many = (0..model.face_count() as u32).map(|face| (face, model.face(face)));
        let many = many.filter(|(_, polygon)| polygon.len() > MANY);
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
        Self { faces: many.map(|(face, polygon)| (face, is_whole(polygon, places).then(|| bands(polygon)))).collect() }
    }

    /// Bytes.
    pub fn room(&self) -> u64 {
        self.faces.values().flatten().flatten().map(room).sum()
    }
}
