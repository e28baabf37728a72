//! Area lights as sets of points.

use crate::scene::{AreaShape, Light};
use glam::DVec3;
use std::f64::consts::TAU;
use std::ops::Range;

/// The golden section turns each row of a sphere's samples against the last.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// The points that replace an area light, world: the middles of `light.samples` strata of equal area.
///
/// The unit square is cut into about √N rows as high as their number of cells, so that all N cells have equal areas. It is
/// laid over the rectangle, or over the sphere by Archimedes' projection. The midpoint rule's error falls as 1/N where the
/// integrand is smooth. A sphere of one sample shines from its centre: a point of its surface would light one side alone.
pub fn area_samples(light: &Light) -> Vec<DVec3> {
    let middles = strata(light.samples);
    match light.shape {
        AreaShape::Rectangle => {
            let [across, up] = rectangle_axes(light);
            let at = |[u, v]: [f64; 2], _: usize| light.position + across * (u - 0.5) + up * (v - 0.5);
            middles.into_iter().map(|(place, row)| at(place, row)).collect()
        }
        AreaShape::Sphere if light.samples == 1 => vec![light.position],
        AreaShape::Sphere => {
            let at = |[u, v]: [f64; 2], row: usize| {
                let height = 1.0 - 2.0 * v;
                let (sine, cosine) = (TAU * (u + GOLDEN * row as f64)).sin_cos();
                let level = (1.0 - height * height).max(0.0).sqrt();
                light.position + light.radius * DVec3::new(level * cosine, height, level * sine)
            };
            middles.into_iter().map(|(place, row)| at(place, row)).collect()
        }
    }
}

/// The two sides of a rectangular light, world units long: its width runs level, unless it faces straight up or down.
pub fn rectangle_axes(light: &Light) -> [DVec3; 2] {
    let facing = light.direction.normalize_or(DVec3::NEG_Z);
    let level = DVec3::Y.cross(facing).try_normalize().unwrap_or(DVec3::X);
    let up = facing.cross(level);
    [level * light.extent[0], up * light.extent[1]]
}

/// The samples of each row of a rectangular light of `count` samples: those of a row lie on a line.
pub fn area_rows(count: u32) -> impl Iterator<Item = Range<u32>> {
    let rows = row_count(count);
    let end = move |row: u32| (u64::from(count) * u64::from(row) / u64::from(rows)) as u32;
    (0..rows).map(move |row| end(row)..end(row + 1))
}

fn row_count(count: u32) -> u32 {
    (f64::from(count).sqrt().round() as u32).clamp(1, count.max(1))
}

/// Corners of a polyhedron that holds an area light: a rectangle's own, in their order; those of the cube about a sphere.
pub fn area_hull(light: &Light) -> Vec<DVec3> {
    match light.shape {
        AreaShape::Rectangle => {
            let [across, up] = rectangle_axes(light).map(|side| side * 0.5);
            [across + up, across - up, -across - up, up - across].map(|corner| light.position + corner).to_vec()
        }
        AreaShape::Sphere => {
            let sign = |bit: u32, k: u32| if k >> bit & 1 == 0 { -light.radius } else { light.radius };
            (0..8).map(|k| light.position + DVec3::new(sign(0, k), sign(1, k), sign(2, k))).collect()
        }
    }
}

/// The middles of `count` cells of equal area in the unit square, and the row that each stands in.
fn strata(count: u32) -> Vec<([f64; 2], usize)> {
    let mut middles = Vec::with_capacity(count as usize);
    for (row, range) in area_rows(count).enumerate() {
        let cells = range.len();
        let v = (f64::from(range.start) + 0.5 * cells as f64) / f64::from(count);
        middles.extend((0..cells).map(|cell| ([(cell as f64 + 0.5) / cells as f64, v], row)));
    }
    middles
}
