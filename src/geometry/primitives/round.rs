//! Shapes of revolution about the y axis.

use super::builder::Builder;
use super::sizes::{CONE_APEX, CONE_BASE, CONE_RADIUS, CYLINDER_HALF_HEIGHT, CYLINDER_RADIUS, TORUS_RING, TORUS_TUBE};
use crate::geometry::mesh::Mesh;
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;

/// (sin, cos) of the angle 2π·k/n, exact at the quarters.
fn turn(k: u32, n: u32) -> (f64, f64) {
    let quarters = 4 * u64::from(k);
    let n = u64::from(n);
    let (sin, cos) = (FRAC_PI_2 * (quarters % n) as f64 / n as f64).sin_cos();
    match quarters / n % 4 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// The directions round the y axis: azimuth 2π·i/segments from +z towards +x, as (x, z).
fn azimuths(segments: u32) -> Vec<DVec2> {
    (0..segments).map(|i| DVec2::from(turn(i, segments))).collect()
}

/// The point or vector with distance `radial` from the axis and height `y`.
fn revolved(radial: f64, y: f64, azimuth: DVec2) -> DVec3 {
    DVec3::new(radial * azimuth.x, y, radial * azimuth.y)
}

pub fn sphere(segments: u32, rings: u32) -> Mesh {
    let points = (segments as usize) * (rings as usize - 1) + 2;
    let mut builder = Builder::with_capacity(points, segments as usize * rings as usize);
    let azimuths = azimuths(segments);
    // A point of the unit sphere is its own normal, so both have the same index.
    let mut add = |point: DVec3| {
        builder.position(point);
        builder.normal(point)
    };
    let north = add(DVec3::Y);
    for j in 1..rings {
        let (sin, cos) = turn(j, 2 * rings);
        for &azimuth in &azimuths {
            add(revolved(sin, cos, azimuth));
        }
    }
    let south = add(DVec3::NEG_Y);

    let at = |i: u32, j: u32| 1 + j * segments + i % segments;
    let corner = |index| (index, index);
    for i in 0..segments {
        builder.face([north, at(i, 0), at(i + 1, 0)].map(corner));
    }
    builder.grid(segments, rings - 2, |i, j| corner(at(i, j)));
    for i in 0..segments {
        builder.face([at(i, rings - 2), south, at(i + 1, rings - 2)].map(corner));
    }
    builder.finish(true, true)
}

/// Vertex (i, j) is at azimuth 2π·i/segments and at the angle 2π·j/rings from +y outwards round the tube.
pub fn torus(segments: u32, rings: u32) -> Mesh {
    let count = segments as usize * rings as usize;
    let mut builder = Builder::with_capacity(count, count);
    let azimuths = azimuths(segments);
    for j in 0..rings {
        let (sin, cos) = turn(j, rings);
        for &azimuth in &azimuths {
            builder.position(revolved(TORUS_RING + TORUS_TUBE * sin, TORUS_TUBE * cos, azimuth));
            builder.normal(revolved(sin, cos, azimuth));
        }
    }
    let at = |i: u32, j: u32| j % rings * segments + i % segments;
    builder.grid(segments, rings, |i, j| (at(i, j), at(i, j)));
    builder.finish(true, false)
}

pub fn cylinder(segments: u32, rings: u32) -> Mesh {
    let points = segments as usize * (rings as usize + 1);
    let mut builder = Builder::with_capacity(points, segments as usize * rings as usize + segments as usize / 2 + 2);
    let azimuths = azimuths(segments);
    for j in 0..=rings {
        let y = CYLINDER_HALF_HEIGHT * (1.0 - 2.0 * f64::from(j) / f64::from(rings));
        for &azimuth in &azimuths {
            builder.position(revolved(CYLINDER_RADIUS, y, azimuth));
        }
    }
    let side = normals_round(&mut builder, &azimuths, 1.0, 0.0);
    builder.grid(segments, rings, |i, j| (j * segments + i % segments, side + i % segments));
    let top = builder.normal(DVec3::Y);
    builder.face((0..segments).map(|i| (i, top)));
    base(&mut builder, segments, segments * rings);
    builder.finish(true, true)
}

/// The apex is one point with a normal for each face there, that of the middle of the face: the true surface has none.
pub fn cone(segments: u32, rings: u32) -> Mesh {
    let points = segments as usize * rings as usize + 1;
    let mut builder = Builder::with_capacity(points, segments as usize * rings as usize + segments as usize / 4 + 1);
    let azimuths = azimuths(segments);
    let apex = builder.position(DVec3::Y * CONE_APEX);
    for j in 1..=rings {
        let share = f64::from(j) / f64::from(rings);
        for &azimuth in &azimuths {
            builder.position(revolved(CONE_RADIUS * share, CONE_APEX + (CONE_BASE - CONE_APEX) * share, azimuth));
        }
    }
    let slope = DVec2::new(CONE_APEX - CONE_BASE, CONE_RADIUS).normalize();
    let middles: Vec<DVec2> = (0..segments).map(|i| DVec2::from(turn(2 * i + 1, 2 * segments))).collect();
    let side = normals_round(&mut builder, &azimuths, slope.x, slope.y);
    let at_apex = normals_round(&mut builder, &middles, slope.x, slope.y);
    let at = |i: u32, j: u32| (1 + j * segments + i % segments, side + i % segments);
    for i in 0..segments {
        builder.face([(apex, at_apex + i), at(i, 0), at(i + 1, 0)]);
    }
    builder.grid(segments, rings - 1, at);
    base(&mut builder, segments, 1 + segments * (rings - 1));
    builder.finish(true, true)
}

/// Adds one normal per azimuth and returns the index of the first.
fn normals_round(builder: &mut Builder, azimuths: &[DVec2], radial: f64, y: f64) -> u32 {
    let indices: Vec<u32> = azimuths.iter().map(|&azimuth| builder.normal(revolved(radial, y, azimuth))).collect();
    indices[0]
}

/// Closes the ring of points from `first` on with one polygon that faces down.
fn base(builder: &mut Builder, segments: u32, first: u32) {
    let down = builder.normal(DVec3::NEG_Y);
    builder.face((0..segments).rev().map(|i| (first + i, down)));
}
