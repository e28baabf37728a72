//! The built-in shapes except the teapot, face by face, and the polygons that a scene lists itself.

use crate::geometry::mesh::{Corner, FAR, Mesh, NO_NORMAL};
use crate::geometry::sizes::{
    CORRUGATED_HALF_HEIGHT, CUBE_HALF_EDGE, Frustum, TORUS_RING, TORUS_TUBE, corrugated_normal,
    corrugated_point,
};
use crate::scene::Polygons;
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;

/// A mesh under construction about the world's origin.
pub(crate) struct Builder {
    mesh: Mesh,
}

impl Builder {
    /// Returns an empty mesh with capacity for `points` points and `faces` faces of four corners.
    pub fn with_capacity(points: usize, faces: usize) -> Self {
        let mut mesh = Mesh::default();
        mesh.positions.reserve_exact(points);
        mesh.normals.reserve(points);
        mesh.starts.reserve_exact(faces + 1);
        mesh.corners.reserve_exact(4 * faces);
        mesh.starts.push(0);
        Self { mesh }
    }

    pub fn position(&mut self, position: DVec3) -> u32 {
        self.mesh.positions.push(position.as_vec3());
        self.mesh.positions.len() as u32 - 1
    }

    /// Adds a normal, of unit length, and returns its index.
    pub fn normal(&mut self, normal: DVec3) -> u32 {
        self.mesh.normals.push(normal.as_vec3());
        self.mesh.normals.len() as u32 - 1
    }

    /// Adds a face with `(position, normal)` at each corner, counter-clockwise from outside.
    pub fn face(&mut self, corners: impl IntoIterator<Item = (u32, u32)>) {
        self.mesh.corners.extend(
            corners
                .into_iter()
                .map(|(position, normal)| Corner { position, normal }),
        );
        self.mesh.starts.push(self.mesh.corners.len() as u32);
    }

    /// Adds the quads of a grid, row by row: between columns i, i + 1 and rows j, j + 1 of the corners that `at(i, j)` gives.
    pub fn grid(&mut self, columns: u32, rows: u32, at: impl Fn(u32, u32) -> (u32, u32)) {
        for j in 0..rows {
            for i in 0..columns {
                self.face([at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)]);
            }
        }
    }

    pub fn finish(mut self, closed: bool, convex: bool) -> Mesh {
        (self.mesh.closed, self.mesh.convex) = (closed, convex);
        self.mesh
    }
}

/// Returns the square −1 ≤ x, y ≤ 1 at z = 0: `columns` across, `rows` from the top down.
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

/// Returns step `k` of `count` equal ones from −1 to 1.
fn between(k: u32, count: u32) -> f64 {
    2.0 * f64::from(k) / f64::from(count) - 1.0
}

/// Returns the cube, `columns` to a side round the y axis and `rows` from the top down.
pub fn cube(columns: u32, rows: u32) -> Mesh {
    let lattice = Lattice { columns, rows };
    let (n, m) = (columns as usize, rows as usize);
    let points = 4 * n * (m + 1) + 2 * (n - 1) * (n - 1);
    let mut builder = Builder::with_capacity(points, 4 * n * m + 2 * n * n);
    lattice.add_points(&mut builder);

    let normal = builder.normal(DVec3::Y);
    builder.grid(columns, columns, |i, k| (lattice.in_level(i, k, 0), normal));
    for side in 0..4 {
        let normal =
            builder.normal([DVec3::Z, DVec3::X, DVec3::NEG_Z, DVec3::NEG_X][side as usize]);
        builder.grid(columns, rows, |i, j| {
            (lattice.on_side(side * columns + i, j), normal)
        });
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
                let (x, z) =
                    [(along, 1.0), (1.0, -along), (-along, -1.0), (-1.0, along)][side as usize];
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

    /// Returns point i round the axis, from the corner (−x, +z) towards (+x, +z), at level j from the top.
    fn on_side(&self, i: u32, j: u32) -> u32 {
        4 * self.columns * j + i % (4 * self.columns)
    }

    /// Returns point i from −x and k from −z at level j, which is the top or the bottom.
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

/// Returns the corrugated sheet: `slopes` planes from one ridge or trough to the next, each divided into `strips`.
///
/// A trough and a ridge of equal slopes have the mean normal +z. The two borders end in the middle of a ridge or a trough:
/// the sheet is cut out of one that continues there as its own mirror image.
pub fn corrugated(slopes: u32, strips: u32) -> Mesh {
    let columns = slopes * strips;
    let mut builder = Builder::with_capacity(2 * (columns as usize + 1), columns as usize);
    for column in 0..=columns {
        let place = corrugated_point(
            slopes,
            column / strips,
            f64::from(column % strips) / f64::from(strips),
        );
        for y in [CORRUGATED_HALF_HEIGHT, -CORRUGATED_HALF_HEIGHT] {
            builder.position(DVec3::new(place.x, y, place.y));
        }
    }
    let normals = [0, 1].map(|slope| builder.normal(corrugated_normal(slopes, slope)));
    for column in 0..columns {
        let normal = normals[(column / strips % 2) as usize];
        builder.face([0, 1, 3, 2].map(|k| (2 * column + k, normal)));
    }
    Mesh {
        mirrored: vec![0, 1, 2 * columns, 2 * columns + 1],
        ..builder.finish(false, false)
    }
}

/// Returns (sin, cos) of the angle 2π·k/n, exact at the quarters.
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

/// Returns the directions round the y axis: azimuth 2π·i/segments from +z towards +x, as (x, z).
fn azimuths(segments: u32) -> Vec<DVec2> {
    (0..segments)
        .map(|i| DVec2::from(turn(i, segments)))
        .collect()
}

/// Returns the point or vector at distance `radial` from the axis and height `y`.
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
        azimuths
            .iter()
            .for_each(|&azimuth| _ = add(revolved(sin, cos, azimuth)));
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

/// Returns the torus. Vertex (i, j) is at azimuth 2π·i/segments and at the angle 2π·j/rings from +y outwards round the tube.
pub fn torus(segments: u32, rings: u32) -> Mesh {
    let count = segments as usize * rings as usize;
    let mut builder = Builder::with_capacity(count, count);
    let azimuths = azimuths(segments);
    for j in 0..rings {
        let (sin, cos) = turn(j, rings);
        for &azimuth in &azimuths {
            builder.position(revolved(
                TORUS_RING + TORUS_TUBE * sin,
                TORUS_TUBE * cos,
                azimuth,
            ));
            builder.normal(revolved(sin, cos, azimuth));
        }
    }
    let at = |i: u32, j: u32| j % rings * segments + i % segments;
    builder.grid(segments, rings, |i, j| (at(i, j), at(i, j)));
    builder.finish(true, false)
}

/// Returns a cylinder or a cone. A cone's apex is one point with a normal for each face there, that of the middle of the
/// face, since the true surface has none.
pub fn frustum(shape: &Frustum, segments: u32, rings: u32) -> Mesh {
    let apex = u32::from(shape.top == 0.0);
    let points = segments as usize * (rings + 1 - apex) as usize + apex as usize;
    let mut builder = Builder::with_capacity(
        points,
        segments as usize * rings as usize + segments as usize / 2 + 2,
    );
    let azimuths = azimuths(segments);
    if apex == 1 {
        builder.position(DVec3::Y * shape.high);
    }
    for j in apex..=rings {
        let share = f64::from(j) / f64::from(rings);
        let radius = shape.top + (shape.bottom - shape.top) * share;
        let y = shape.high + (shape.low - shape.high) * share;
        azimuths
            .iter()
            .for_each(|&azimuth| _ = builder.position(revolved(radius, y, azimuth)));
    }
    let outwards = DVec2::new(1.0, shape.slope()).normalize();
    let mut normals_round = |azimuths: &[DVec2]| {
        let normals = azimuths
            .iter()
            .map(|&azimuth| builder.normal(revolved(outwards.x, outwards.y, azimuth)));
        normals.min().unwrap_or(0)
    };
    let side = normals_round(&azimuths);
    let at = |i: u32, j: u32| (apex + j * segments + i % segments, side + i % segments);
    if apex == 1 {
        let middles: Vec<DVec2> = (0..segments)
            .map(|i| DVec2::from(turn(2 * i + 1, 2 * segments)))
            .collect();
        let at_apex = normals_round(&middles);
        for i in 0..segments {
            builder.face([(0, at_apex + i), at(i, 0), at(i + 1, 0)]);
        }
    }
    builder.grid(segments, rings - apex, at);
    if apex == 0 {
        let up = builder.normal(DVec3::Y);
        builder.face((0..segments).map(|i| (i, up)));
    }
    let down = builder.normal(DVec3::NEG_Y);
    builder.face((0..segments).rev().map(|i| (at(i, rings - apex).0, down)));
    builder.finish(true, true)
}

impl From<&Polygons> for Mesh {
    /// Converts any number of polygons. Faces share the points that they name by the same number, and no others: a vertex
    /// upon another, or upon an edge, is a vertex of its own. Faces that name an unknown vertex, or fewer than three, are
    /// left out.
    fn from(polygons: &Polygons) -> Self {
        let Polygons {
            vertices,
            faces,
            normals,
        } = polygons;
        let origin = match vertices.first() {
            Some(first) if first.is_finite() && first.abs().max_element() > FAR => first.round(),
            _ => DVec3::ZERO,
        };
        let mut mesh = Self {
            origin,
            starts: vec![0],
            ..Self::default()
        };
        mesh.positions = vertices
            .iter()
            .map(|vertex| (vertex - origin).as_vec3())
            .collect();
        if normals.len() == vertices.len() {
            mesh.normals = normals
                .iter()
                .map(|normal| normal.normalize_or(DVec3::Z).as_vec3())
                .collect();
        }
        let given = !mesh.normals.is_empty();
        let corner = |&v: &u32| Corner {
            position: v,
            normal: if given { v } else { NO_NORMAL },
        };
        for face in faces
            .iter()
            .filter(|face| face.len() >= 3 && face.iter().all(|&v| (v as usize) < vertices.len()))
        {
            mesh.corners.extend(face.iter().map(corner));
            mesh.starts.push(mesh.corners.len() as u32);
        }
        mesh.with_concave_faces_cut().with_closedness_detected()
    }
}
