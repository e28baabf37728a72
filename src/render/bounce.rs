//! One bounce: light that the object and the floor have scattered once, gathered from all sides.
//!
//! What arrives at a point is the mean of what is seen in directions spread as the cosine to its normal, which is what a
//! diffuse surface weighs them by. It is gathered on a grid of pixels and carried to the others by weights that fall with
//! the distance in the picture and vanish on another surface (after W. J. Ward et al., *A ray tracing solution for diffuse
//! interreflection*, 1988: indirect light changes slowly but at creases).

mod carry;

use self::carry::Grid;
use super::floor::FloorView;
use super::shadow::Shadows;
use super::surroundings::{Beyond, Surroundings, lit};
use crate::illumination::Equation;
use crate::scene::Rgb;
use fearless_simd::{Level, dispatch};
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Directions from a point: rows times columns.
const DIRECTIONS: [u32; 2] = [8, 8];
/// Points of the grid along the picture's longer side: light from other surfaces changes over the object, not over pixels.
const POINTS: usize = 72;

/// A point to gather at.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Receiver {
    /// Relative to the eye, camera distances.
    pub place: Vec3,
    /// Unit; zero where there is nothing.
    pub normal: Vec3,
    pub on_object: bool,
}

impl Receiver {
    pub fn is_there(&self) -> bool {
        self.normal != Vec3::ZERO
    }
}

/// What light is gathered from.
#[derive(Clone, Copy)]
pub(super) struct Gathering<'a> {
    pub shadows: Shadows<'a>,
    pub surroundings: &'a Surroundings<'a>,
    /// The floor, if there is one, as rows of pixels see it.
    pub floor_view: Option<&'a FloorView<'a>>,
    /// The object's diffuse reflection without its ambient light, and the floor's.
    pub object: &'a Equation<f64>,
    pub floor: &'a Equation<f64>,
}

impl Gathering<'_> {
    /// The mean intensity that arrives from other surfaces at every pixel of a picture `width` wide; `world` gives a
    /// receiver's point.
    pub fn gather(
        &self,
        level: Level,
        receivers: &[Receiver],
        width: usize,
        world: impl Fn(Vec3) -> DVec3 + Sync,
        gathered: &mut Vec<Vec3>,
    ) {
        gathered.resize(receivers.len(), Vec3::ZERO);
        if receivers.is_empty() || width == 0 {
            return;
        }
        let height = receivers.len() / width;
        let step = (width.max(height) / POINTS).max(1);
        let columns = width.div_ceil(step);
        let at = |receiver: &Receiver, salt: usize, scratch: &mut Vec<u64>| {
            self.at(receiver, world(receiver.place), salt, scratch).min(Rgb::splat(1e36)).as_vec3()
        };
        let pick = |column: usize, row: usize| {
            let (x, y) = ((column * step + step / 2).min(width - 1), (row * step + step / 2).min(height - 1));
            receivers[y * width + x]
        };
        let points: Vec<(Receiver, Vec3)> = (0..height.div_ceil(step) * columns)
            .into_par_iter()
            .map_init(Vec::new, |scratch, cell| {
                let receiver = pick(cell % columns, cell / columns);
                let light = if receiver.is_there() { at(&receiver, cell, scratch) } else { Vec3::ZERO };
                (receiver, light)
            })
            .collect();
        let grid = Grid { points, columns, step };
        let lines = gathered.par_chunks_mut(width).zip(receivers.par_chunks(width)).enumerate();
        lines.for_each_init(Vec::new, |scratch, (y, (line, receivers))| {
            dispatch!(level, simd => grid.carry_row(simd, y, receivers, line));
            for (x, (light, receiver)) in line.iter_mut().zip(receivers).enumerate() {
                if !receiver.is_there() {
                    *light = Vec3::ZERO;
                } else if light.is_nan() {
                    *light = at(receiver, y * width + x, scratch);
                }
            }
        });
    }

    /// The mean intensity from other surfaces at a receiver's point, world. `salt` turns the directions, so that their
    /// number does not show as steps.
    fn at(&self, receiver: &Receiver, point: DVec3, salt: usize, scratch: &mut Vec<u64>) -> Rgb {
        let n = receiver.normal.as_dvec3();
        // A convex solid lies behind the tangent plane of each of its points.
        let alone = receiver.on_object && self.shadows.solid.is_convex();
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
                sum += self.arriving(start, direction, alone, scratch);
            }
        }
        sum / f64::from(rows * columns)
    }

    /// What another surface of the scene scatters back along a ray, which meets no object if the point it leaves is `alone`.
    fn arriving(&self, start: DVec3, direction: DVec3, alone: bool, scratch: &mut Vec<u64>) -> Rgb {
        let hit = if alone { None } else { self.shadows.solid.nearest(start, direction) };
        if let Some(hit) = hit {
            return lit(self.object, Some(&self.shadows), hit.point, hit.normal, scratch);
        }
        match self.surroundings.meet(start, direction) {
            Beyond::Floor(point) => lit(self.floor, Some(&self.shadows), point, DVec3::Y, scratch),
            Beyond::Elsewhere(_) => Rgb::ZERO,
        }
    }
}
