//! One bounce: light that the object and the floor have scattered once, gathered from all sides.
//!
//! What arrives at a point is the mean of what is seen in directions spread as the cosine to its normal, which is what a
//! diffuse surface weighs them by. It is gathered on a grid of pixels and carried to the others by weights that fall with
//! the distance in the picture and vanish on another surface (after W. J. Ward et al., *A ray tracing solution for diffuse
//! interreflection*, 1988: indirect light changes slowly but at creases).

use super::shadow::Shadows;
use super::surroundings::{Beyond, Surroundings, lit};
use crate::illumination::Equation;
use crate::scene::Rgb;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Directions from a point: rows times columns.
const DIRECTIONS: [u32; 2] = [8, 8];
/// Points of the grid along the picture's longer side: light from other surfaces changes over the object, not over pixels.
const POINTS: usize = 72;
/// Weights below this tell nothing; the pixel gathers for itself.
const LEAST_WEIGHT: f32 = 0.02;

/// A point to gather at.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Receiver {
    /// Relative to the eye, camera distances.
    pub place: Vec3,
    /// Unit; zero where there is nothing.
    pub normal: Vec3,
}

impl Receiver {
    fn is_there(&self) -> bool {
        self.normal != Vec3::ZERO
    }
}

/// What light is gathered from.
#[derive(Clone, Copy)]
pub(super) struct Gathering<'a> {
    pub shadows: Shadows<'a>,
    pub surroundings: &'a Surroundings<'a>,
    /// The object's diffuse reflection without its ambient light, and the floor's.
    pub object: &'a Equation<f64>,
    pub floor: &'a Equation<f64>,
}

impl Gathering<'_> {
    /// The mean intensity that arrives from other surfaces at every pixel of a picture `width` wide; `world` gives a
    /// receiver's point.
    pub fn gather(&self, receivers: &[Receiver], width: usize, world: impl Fn(Vec3) -> DVec3 + Sync) -> Vec<Vec3> {
        if receivers.is_empty() || width == 0 {
            return Vec::new();
        }
        let height = receivers.len() / width;
        let step = (width.max(height) / POINTS).max(1);
        let columns = width.div_ceil(step);
        let at = |receiver: &Receiver, salt: usize, scratch: &mut Vec<u64>| {
            self.at(world(receiver.place), receiver.normal.as_dvec3(), salt, scratch).min(Rgb::splat(1e36)).as_vec3()
        };
        let pick = |column: usize, row: usize| {
            let (x, y) = ((column * step + step / 2).min(width - 1), (row * step + step / 2).min(height - 1));
            receivers[y * width + x]
        };
        let grid: Vec<(Receiver, Vec3)> = (0..height.div_ceil(step) * columns)
            .into_par_iter()
            .map_init(Vec::new, |scratch, cell| {
                let receiver = pick(cell % columns, cell / columns);
                let light = if receiver.is_there() { at(&receiver, cell, scratch) } else { Vec3::ZERO };
                (receiver, light)
            })
            .collect();
        let mut gathered = vec![Vec3::ZERO; receivers.len()];
        gathered.par_chunks_mut(width).enumerate().for_each_init(Vec::new, |scratch, (y, line)| {
            for (x, light) in line.iter_mut().enumerate() {
                let receiver = receivers[y * width + x];
                if receiver.is_there() {
                    let near = carried(&grid, [columns, step], [x, y], &receiver);
                    *light = near.unwrap_or_else(|| at(&receiver, y * width + x, scratch));
                }
            }
        });
        gathered
    }

    /// The mean intensity from other surfaces at a point with normal `n`. `salt` turns the directions, so that their
    /// number does not show as steps.
    fn at(&self, point: DVec3, n: DVec3, salt: usize, scratch: &mut Vec<u64>) -> Rgb {
        let (tangent, bitangent) = n.any_orthonormal_pair();
        let start = point + n * self.shadows.solid.clearance();
        let [rows, columns] = DIRECTIONS;
        let turn = [0.754_877_666, 0.569_840_291].map(|golden: f64| (salt as f64 * golden).fract());
        let mut sum = Rgb::ZERO;
        for row in 0..rows {
            for column in 0..columns {
                let height = (f64::from(row) + turn[0]) / f64::from(rows);
                let angle = TAU * (f64::from(column) + turn[1]) / f64::from(columns);
                // Even over the disc under the half-sphere: spread as the cosine over the half-sphere.
                let (radius, (sine, cosine)) = (height.sqrt(), angle.sin_cos());
                let direction = tangent * (radius * cosine) + bitangent * (radius * sine) + n * (1.0 - height).sqrt();
                sum += self.arriving(start, direction, scratch);
            }
        }
        sum / f64::from(rows * columns)
    }

    /// What another surface of the scene scatters back along a ray.
    fn arriving(&self, start: DVec3, direction: DVec3, scratch: &mut Vec<u64>) -> Rgb {
        if let Some(hit) = self.shadows.solid.nearest(start, direction) {
            return lit(self.object, Some(&self.shadows), hit.point, hit.normal, scratch);
        }
        match self.surroundings.meet(start, direction) {
            Beyond::Floor(point) => lit(self.floor, Some(&self.shadows), point, DVec3::Y, scratch),
            Beyond::Elsewhere(_) => Rgb::ZERO,
        }
    }
}

/// The weighted mean of the grid's points about a pixel, if any of them lies on the same surface.
fn carried(
    grid: &[(Receiver, Vec3)],
    [columns, step]: [usize; 2],
    [x, y]: [usize; 2],
    receiver: &Receiver,
) -> Option<Vec3> {
    let rows = grid.len() / columns;
    let (column, row) = (x / step, y / step);
    let (mut sum, mut weights) = (Vec3::ZERO, 0.0);
    for r in row.saturating_sub(2)..(row + 3).min(rows) {
        for c in column.saturating_sub(2)..(column + 3).min(columns) {
            let (other, light) = &grid[r * columns + c];
            let weight = tent(c, x, step) * tent(r, y, step) * likeness(receiver, other);
            sum += *light * weight;
            weights += weight;
        }
    }
    (weights > LEAST_WEIGHT).then(|| sum / weights)
}

/// Falls from 1 at the cell's middle to 0 two and a half cells away.
fn tent(cell: usize, pixel: usize, step: usize) -> f32 {
    let distance = (cell * step + step / 2) as f32 - pixel as f32;
    (1.0 - distance.abs() / (2.5 * step as f32)).max(0.0)
}

/// 1 for points in one plane, towards 0 where the normals or the planes part.
fn likeness(a: &Receiver, b: &Receiver) -> f32 {
    let normals = a.normal.dot(b.normal).max(0.0).powi(16);
    let apart = (a.place - b.place).dot(a.normal).abs() / (1e-6 + 0.01 * a.place.length());
    normals / (1.0 + apart * apart * apart * apart)
}
