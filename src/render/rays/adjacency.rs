//! Which triangles of a mesh are neighbours, by the places of their corners.

use glam::Vec3;
use std::collections::HashMap;

/// What stands for no neighbour, or more than one.
const NONE: u32 = u32::MAX;

/// The neighbour of each triangle across each of its edges, in the order of the leaves: the one that goes along the edge the
/// other way. None at borders, and where more than two meet or two go the same way.
pub struct Adjacency(pub Vec<[u32; 3]>);

impl Adjacency {
    pub fn new(corners: &[[Vec3; 3]]) -> Self {
        let mut places = HashMap::new();
        let mut edges = Vec::with_capacity(3 * corners.len());
        for (triangle, corners) in corners.iter().enumerate() {
            let ends = corners.map(|corner| {
                let next = places.len() as u32;
                // Without the sign of zero.
                *places
                    .entry((corner + 0.0).to_array().map(f32::to_bits))
                    .or_insert(next)
            });
            for edge in 0..3 {
                let (from, to) = (ends[edge], ends[(edge + 1) % 3]);
                let number = (3 * triangle + edge) as u32;
                edges.push(([from.min(to), from.max(to)], number, from > to));
            }
        }
        edges.sort_unstable();
        let mut neighbours = vec![[NONE; 3]; corners.len()];
        for same in edges.chunk_by(|(one, ..), (other, ..)| one == other) {
            if let [(_, one, way), (_, other, back)] = same
                && way != back
            {
                neighbours[*one as usize / 3][*one as usize % 3] = other / 3;
                neighbours[*other as usize / 3][*other as usize % 3] = one / 3;
            }
        }
        Self(neighbours)
    }
}
