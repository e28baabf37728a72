//! Covers pixels by rays that meet the true surface itself, in double precision.

use super::cover::Band;
use super::fragments::{self, Block};
use super::grid::BandPlace;
use crate::geometry::{Ray, Surface, SurfaceHit};
use crate::render::lens::{Lens, NEAR};
use glam::{DVec2, DVec3};

/// Where the ray through a place in the picture meets the surface: the depth in camera distances and the hit.
pub fn meet(lens: &Lens, surface: &Surface, place: DVec2) -> Option<(DVec3, SurfaceHit)> {
    let (point, direction) = lens.ray(place);
    let ray = Ray { origin: lens.world(point), direction: direction * lens.unit };
    let hit = surface.intersect(&ray, NEAR)?;
    Some((ray.origin + ray.direction * hit.t, hit))
}

/// Fills the fragments of a band and its extents.
#[expect(clippy::cast_possible_truncation, reason = "fragments are single precision")]
pub fn meet_band(lens: &Lens, surface: &Surface, place: BandPlace, band: &mut Band, fragments: &mut [Block]) {
    band.begin(place);
    for (row, line) in fragments.chunks_exact_mut(Block::count(place.width)).take(place.rows as usize).enumerate() {
        let y = f64::from(place.first_row) + row as f64 + 0.5;
        let extent = &mut band.extents[row];
        fragments::open(line);
        for x in 0..place.width as usize {
            let Some((_, hit)) = meet(lens, surface, DVec2::new(x as f64 + 0.5, y)) else { continue };
            let [nx, ny, nz] = hit.normal.as_vec3().to_array();
            fragments::put(line, x, [nx, ny, nz, lens.key_from_depth(hit.t) as f32]);
            let x = x as u32;
            extent.start = extent.start.min(x);
            extent.end = extent.end.max(x + 1);
            band.covered += 1;
        }
    }
}
