//! The points that pixels see, in double precision: what rays start from.

use super::cover::{Band, BandPlace};
use super::interpolate::{Fragment, GAP, Sources};
use super::lens::Lens;
use super::solid::Solid;
use glam::{DVec2, DVec3};

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
    pub fn walk(
        &self,
        place: BandPlace,
        band: &Band,
        fragments: &[Fragment],
        mut each: impl FnMut(usize, usize, Sight),
    ) {
        if self.solid.surface.is_some() {
            let width = place.width as usize;
            for (row, line) in fragments.chunks_exact(width).take(place.rows as usize).enumerate() {
                for x in band.extents[row].clone().map(|x| x as usize) {
                    if line[x][3] > GAP[3] {
                        each(x, row, self.of_fragment(pixel(x, place.first_row as usize + row), line[x]));
                    }
                }
            }
            return;
        }
        for run in &band.runs {
            let row = usize::from(run.row);
            for x in usize::from(run.x0)..usize::from(run.x1) {
                each(x, row, self.of_triangle(run.triangle, pixel(x, place.first_row as usize + row)));
            }
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
        let model = self.solid.model;
        let own = model.triangles.len();
        let parents = &self.sources.clipped.parents;
        let triangle = parents.get((triangle as usize).wrapping_sub(own)).copied().unwrap_or(triangle);
        let vertices = model.triangles[triangle as usize];
        let corners = vertices.map(|v| model.position(v));
        let weights = self.lens.weights_in_space(corners, place);
        let share = [1.0 - weights[0] - weights[1], weights[0], weights[1]];
        let point = corners[0] * share[0] + corners[1] * share[1] + corners[2] * share[2];
        let normal = self.solid.normal(triangle, weights);
        let lifted =
            if self.solid.smooth { lift(point, corners, vertices.map(|v| model.normal(v)), share) } else { point };
        Sight { point, normal, lifted }
    }
}

/// The centre of a pixel.
fn pixel(x: usize, y: usize) -> DVec2 {
    DVec2::new(x as f64 + 0.5, y as f64 + 0.5)
}

/// The point raised onto the tangent planes at the corners, weighted as the corners are (J. Hanika, *Hacking the shadow
/// terminator*, Ray Tracing Gems II, 2021). Where the surface is hollow the planes lie below and nothing is raised.
fn lift(point: DVec3, corners: [DVec3; 3], normals: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
    let onto = |k: usize| {
        let below = (point - corners[k]).dot(normals[k]).min(0.0);
        (point - normals[k] * below) * weights[k]
    };
    onto(0) + onto(1) + onto(2)
}
