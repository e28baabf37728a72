//! The corrugated sheet.

use super::builder::Builder;
use super::sizes::{CORRUGATED_HALF_HEIGHT, CORRUGATED_HALF_WIDTH, CORRUGATED_RIDGE};
use crate::geometry::mesh::Mesh;
use glam::{DVec2, DVec3};

/// `slopes` planes from one ridge or trough to the next, each divided into `strips`.
///
/// A trough and a ridge of equal slopes have the mean normal +z. The two borders end in the middle of a ridge or of a
/// trough: there the sheet is cut out of one that goes on as its own mirror image.
pub fn corrugated(slopes: u32, strips: u32) -> Mesh {
    let columns = slopes * strips;
    let mut builder = Builder::with_capacity(2 * (columns as usize + 1), columns as usize);
    for column in 0..=columns {
        let place = bend(slopes, column / strips, f64::from(column % strips) / f64::from(strips));
        for y in [CORRUGATED_HALF_HEIGHT, -CORRUGATED_HALF_HEIGHT] {
            builder.position(DVec3::new(place.x, y, place.y));
        }
    }
    let normals = [0, 1].map(|slope| builder.normal(normal(slopes, slope)));
    for column in 0..columns {
        let normal = normals[(column / strips % 2) as usize];
        builder.face([0, 1, 3, 2].map(|k| (2 * column + k, normal)));
    }
    for border in [0, columns] {
        builder.mirror([2 * border, 2 * border + 1]);
    }
    builder.finish(false, false)
}

/// Where slope `slope` is after the part `t` of it: x and z.
pub(crate) fn bend(slopes: u32, slope: u32, t: f64) -> DVec2 {
    let z = |k: u32| if k.is_multiple_of(2) { -CORRUGATED_RIDGE } else { CORRUGATED_RIDGE };
    let x = (2.0 * (f64::from(slope) + t) / f64::from(slopes) - 1.0) * CORRUGATED_HALF_WIDTH;
    DVec2::new(x, z(slope) * (1.0 - t) + z(slope + 1) * t)
}

/// The normal of a slope, towards +z.
pub(crate) fn normal(slopes: u32, slope: u32) -> DVec3 {
    let run = 2.0 * CORRUGATED_HALF_WIDTH / f64::from(slopes);
    let rise = if slope.is_multiple_of(2) { 2.0 * CORRUGATED_RIDGE } else { -2.0 * CORRUGATED_RIDGE };
    DVec3::new(-rise, 0.0, run).normalize()
}
