//! The teapot as polygons.

use super::shapes::Builder;
use crate::geometry::bezier::on_curve;
use crate::geometry::mesh::Mesh;
use crate::geometry::teapot::{Shell, TEAPOT, Teapot};
use glam::DVec3;
use std::collections::HashMap;

/// Returns the teapot with each of its 32 patches as `along` × `round` quads, triangles at the poles of lid and bottom.
/// Handle and spout consist of two halves, which with one quad each would lie flat on one another; they have at least two.
pub fn teapot(along: u32, round: u32) -> Mesh {
    let per_patch = along as usize * round as usize;
    let builder = Builder::with_capacity(
        32 * per_patch + 2 * (along + round) as usize,
        32 * per_patch,
    );
    let mut seams = Seams {
        builder,
        corners: HashMap::new(),
        edges: HashMap::new(),
        normals: HashMap::new(),
    };
    for patch in 0..TEAPOT.patches.len() {
        let min = if matches!(Teapot::shell(patch), Shell::Handle | Shell::Spout) {
            2
        } else {
            1
        };
        add_patch(&mut seams, patch, along, round.max(min));
    }
    seams.builder.finish(false, false)
}

fn add_patch(seams: &mut Seams, patch: usize, along: u32, round: u32) {
    let points = points_of(seams, patch, along, round);
    let shape = TEAPOT.patch(patch);
    let mut corners = Vec::with_capacity(points.len());
    for (index, &point) in points.iter().enumerate() {
        let (k, j) = (index as u32 / (round + 1), index as u32 % (round + 1));
        let normal = shape.normal(
            f64::from(k) / f64::from(along),
            f64::from(j) / f64::from(round),
        );
        let inside = k > 0 && k < along && j > 0 && j < round;
        let normal = if inside {
            seams.builder.normal(normal)
        } else {
            seams.normal(point, normal)
        };
        corners.push((point, normal));
    }
    let at = |k: u32, j: u32| corners[(k * (round + 1) + j) as usize];
    for k in 0..along {
        for j in 0..round {
            let [a, b, c, d] = [at(k, j), at(k, j + 1), at(k + 1, j + 1), at(k + 1, j)];
            if a.0 == b.0 {
                seams.builder.face([a, c, d]);
            } else {
                seams.builder.face([a, b, c, d]);
            }
        }
    }
}

/// Returns the points of the grid over a patch, row by row, those on its edges shared with its neighbours.
fn points_of(seams: &mut Seams, patch: usize, along: u32, round: u32) -> Vec<u32> {
    let shell = Teapot::shell(patch);
    let p = TEAPOT.patches[patch];
    let top = seams.edge(shell, [p[0], p[1], p[2], p[3]], round);
    let bottom = seams.edge(shell, [p[12], p[13], p[14], p[15]], round);
    let left = seams.edge(shell, [p[0], p[4], p[8], p[12]], along);
    let right = seams.edge(shell, [p[3], p[7], p[11], p[15]], along);
    let shape = TEAPOT.patch(patch);
    let mut points = top;
    for k in 1..along {
        points.push(left[k as usize]);
        for j in 1..round {
            let point = shape.at(
                f64::from(k) / f64::from(along),
                f64::from(j) / f64::from(round),
            );
            points.push(seams.builder.position(point));
        }
        points.push(right[k as usize]);
    }
    points.extend(bottom);
    points
}

/// The points and normals that patches share. Edges are identified by their control points, so neighbours meet exactly,
/// without a tolerance.
struct Seams {
    builder: Builder,
    corners: HashMap<(Shell, u16), u32>,
    /// The points along each edge, in the direction in which its control points are the lower list.
    edges: HashMap<(Shell, [u16; 4]), Vec<u32>>,
    /// The normals given to points on edges, by point.
    normals: HashMap<u32, Vec<(DVec3, u32)>>,
}

impl Seams {
    /// Returns the points along the edge with these control points, cut into `count` parts.
    fn edge(&mut self, shell: Shell, controls: [u16; 4], count: u32) -> Vec<u32> {
        let mut reversed = controls;
        reversed.reverse();
        let key = (shell, controls.min(reversed));
        if !self.edges.contains_key(&key) {
            let points = self.new_edge(shell, key.1, count);
            self.edges.insert(key, points);
        }
        let mut points = self.edges[&key].clone();
        if key.1 != controls {
            points.reverse();
        }
        points
    }

    fn new_edge(&mut self, shell: Shell, controls: [u16; 4], count: u32) -> Vec<u32> {
        let first = self.corner(shell, controls[0]);
        if controls.iter().all(|&control| control == controls[0]) {
            return vec![first; count as usize + 1];
        }
        let last = self.corner(shell, controls[3]);
        let curve = controls.map(|control| TEAPOT.points[control as usize]);
        let mut points = vec![first];
        points.extend((1..count).map(|k| {
            self.builder
                .position(on_curve(curve, f64::from(k) / f64::from(count)))
        }));
        points.push(last);
        points
    }

    fn corner(&mut self, shell: Shell, control: u16) -> u32 {
        let builder = &mut self.builder;
        *self
            .corners
            .entry((shell, control))
            .or_insert_with(|| builder.position(TEAPOT.points[control as usize]))
    }

    /// Returns the index of a normal at a point on an edge: the same for both patches where they join smoothly.
    fn normal(&mut self, point: u32, normal: DVec3) -> u32 {
        /// The squared distance of unit normals that differ by rounding only.
        const SAME: f64 = 1e-16;
        let known = self.normals.entry(point).or_default();
        if let Some((_, index)) = known
            .iter()
            .find(|(other, _)| other.distance_squared(normal) < SAME)
        {
            return *index;
        }
        let index = self.builder.normal(normal);
        known.push((normal, index));
        index
    }
}
