//! The cube and the plane.

use super::builder::Builder;
use super::sizes::CUBE_HALF_EDGE;
use crate::geometry::mesh::Mesh;
use glam::DVec3;

/// The square −1 ≤ x, y ≤ 1 at z = 0: `columns` across, `rows` from the top down.
pub fn plane(columns: u32, rows: u32) -> Mesh {
    let points = (columns as usize + 1) * (rows as usize + 1);
    let mut builder = Builder::with_capacity(points, columns as usize * rows as usize);
    for j in 0..=rows {
        for i in 0..=columns {
            builder.position(DVec3::new(between(i, columns), -between(j, rows), 0.0));
        }
    }
    let normal = builder.normal(DVec3::Z);
    builder.grid(columns, rows, |i, j| (j * (columns + 1) + i, normal));
    builder.finish(false, false)
}

/// −1 to 1 in `count` equal steps.
fn between(k: u32, count: u32) -> f64 {
    2.0 * f64::from(k) / f64::from(count) - 1.0
}

/// The cube, `columns` to a side round the y axis and `rows` from the top down.
pub fn cube(columns: u32, rows: u32) -> Mesh {
    let lattice = Lattice { columns, rows };
    let (n, m) = (columns as usize, rows as usize);
    let points = 4 * n * (m + 1) + 2 * (n - 1) * (n - 1);
    let mut builder = Builder::with_capacity(points, 4 * n * m + 2 * n * n);
    lattice.add_points(&mut builder);

    let normal = builder.normal(DVec3::Y);
    builder.grid(columns, columns, |i, k| (lattice.in_level(i, k, 0), normal));
    for side in 0..4 {
        let normal = builder.normal([DVec3::Z, DVec3::X, DVec3::NEG_Z, DVec3::NEG_X][side as usize]);
        builder.grid(columns, rows, |i, j| (lattice.on_side(side * columns + i, j), normal));
    }
    let normal = builder.normal(DVec3::NEG_Y);
    for k in 0..columns {
        for i in 0..columns {
            let cell = [(i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1)];
            builder.face(cell.map(|(i, k)| (lattice.in_level(i, k, rows), normal)));
        }
    }
    builder.finish(true, true)
}

/// The points on the surface of the cube, each once: the four sides level by level, then the inside of the top, then
/// that of the bottom.
struct Lattice {
    columns: u32,
    rows: u32,
}

impl Lattice {
    fn add_points(&self, builder: &mut Builder) {
        let n = self.columns;
        for j in 0..=self.rows {
            for i in 0..4 * n {
                let (side, along) = (i / n, between(i % n, n));
                let (x, z) = [(along, 1.0), (1.0, -along), (-along, -1.0), (-1.0, along)][side as usize];
                builder.position(CUBE_HALF_EDGE * DVec3::new(x, -between(j, self.rows), z));
            }
        }
        for y in [1.0, -1.0] {
            for k in 1..n {
                for i in 1..n {
                    builder.position(CUBE_HALF_EDGE * DVec3::new(between(i, n), y, between(k, n)));
                }
            }
        }
    }

    /// Point i round the axis, from the corner (−x, +z) towards (+x, +z), at level j from the top.
    fn on_side(&self, i: u32, j: u32) -> u32 {
        4 * self.columns * j + i % (4 * self.columns)
    }

    /// Point i from −x and k from −z at level j, which is the top or the bottom.
    fn in_level(&self, i: u32, k: u32, j: u32) -> u32 {
        let n = self.columns;
        if k == n {
            self.on_side(i, j)
        } else if i == n {
            self.on_side(2 * n - k, j)
        } else if k == 0 {
            self.on_side(3 * n - i, j)
        } else if i == 0 {
            self.on_side(3 * n + k, j)
        } else {
            let inside = (k - 1) * (n - 1) + i - 1;
            let top = 4 * n * (self.rows + 1);
            top + inside + if j == 0 { 0 } else { (n - 1) * (n - 1) }
        }
    }
}
