//! The points that pixels see, in double precision: what rays start from.

use super::cover::{Band, BandPlace};
use super::facet::Facet;
use super::fragments::{Block, Fragment, fragment, is_seen};
use super::interpolate::Sources;
use super::lens::Lens;
use super::solid::Solid;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// A point that a pixel sees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sight {
    /// The point, world.
    pub point: DVec3,
    /// Its normal, unit, as the mode has it.
    pub normal: DVec3,
    /// Where rays start that leave to the side of the normal: lifted from the polygon to the rounding that its vertex
    /// normals stand for, so that a smooth surface's facets cast no shadow on each other.
    pub lifted: DVec3,
}

/// How a picture's pixels see the object.
#[derive(Clone, Copy)]
pub(super) struct Sights<'a> {
    pub lens: &'a Lens,
    pub sources: Sources<'a>,
    pub solid: Solid<'a>,
}

impl Sights<'_> {
    /// Calls `each` with column, row within the band and what is seen there, for every pixel of a band that sees the object.
    pub fn walk(&self, place: BandPlace, band: &Band, fragments: &[Block], mut each: impl FnMut(usize, usize, Sight)) {
        if self.solid.surface.is_some() {
            for (row, line) in fragments.chunks_exact(Block::count(place.width)).take(place.rows as usize).enumerate() {
                for x in band.extents[row].clone().map(|x| x as usize) {
                    let fragment = fragment(line, x);
                    if is_seen(fragment) {
                        each(x, row, self.of_fragment(pixel(x, place.first_row as usize + row), fragment));
                    }
                }
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
            for x in usize::from(run.x0)..usize::from(run.x1) {
                each(x, row, facet.at(pixel(x, place.first_row as usize + row)));
            }
        }
    }

    /// Calls `each` with row and columns of every run of a band's pixels that see the object.
    pub fn walk_covered(
        &self,
        place: BandPlace,
        band: &Band,
        fragments: &[Block],
        mut each: impl FnMut(usize, Range<usize>),
    ) {
        if self.solid.surface.is_some() {
            for (row, line) in fragments.chunks_exact(Block::count(place.width)).take(place.rows as usize).enumerate() {
                for x in band.extents[row].clone().map(|x| x as usize).filter(|x| is_seen(fragment(line, *x))) {
                    each(row, x..x + 1);
                }
            }
            return;
        }
        for run in &band.runs {
            each(usize::from(run.row), usize::from(run.x0)..usize::from(run.x1));
        }
    }

    /// What a fragment of the true surface stands for.
    pub fn of_fragment(&self, place: DVec2, [nx, ny, nz, key]: Fragment) -> Sight {
        let (start, direction) = self.lens.ray(place);
        let depth = self.lens.depth_from_key(f64::from(key));
        let point = self.lens.world(start + direction * depth);
        let normal = DVec3::new(f64::from(nx), f64::from(ny), f64::from(nz)).normalize_or(DVec3::Y);
        Sight { point, normal, lifted: point }
    }

    /// What a pixel sees of `triangle`, one of the model's or of the clipper's.
    pub fn of_triangle(&self, triangle: u32, place: DVec2) -> Sight {
        self.facet(triangle).at(place)
    }

    fn facet(&self, triangle: u32) -> Facet<'_> {
        let own = self.solid.model.triangles.len();
        let parents = &self.sources.clipped.parents;
        let triangle = parents.get((triangle as usize).wrapping_sub(own)).copied().unwrap_or(triangle);
        Facet::new(&self.solid, self.lens, triangle)
    }
}

/// The centre of a pixel.
fn pixel(x: usize, y: usize) -> DVec2 {
    DVec2::new(x as f64 + 0.5, y as f64 + 0.5)
}
