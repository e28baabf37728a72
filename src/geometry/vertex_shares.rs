//! Which faces a vertex normal comes from, and what each of them counts for.
//!
//! The weights and the sum are those of the averaging itself ([`super::vertex_normals`]), for one vertex at a time.

use super::mesh::{Mesh, NO_NORMAL, VertexMesh};
use super::vertex_normals::{direction_of, weighted};
use crate::scene::{NormalSource, Weighting};
use glam::{DVec3, DVec4};

/// Where the normal of one vertex comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalOrigin {
    /// The mean of the faces' normals, each with its weight.
    Averaged,
    /// Given with the mesh: the true surface's, or the file's.
    Given,
    /// That of the one face to which the vertex belongs.
    Facet,
    /// The faces' normals cancel; it is that of the first face there with an area.
    FirstFace,
    /// No face there has an area.
    Nowhere,
}

/// A face that meets a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceShare {
    pub face: u32,
    /// Unit; zero for a face without area.
    pub normal: DVec3,
    /// The weight as the rule has it: 1, the area in square world units, or the interior angle in radians. Zero where the
    /// face does not count.
    pub weight: f64,
    /// The weight divided by the sum of all, 0 to 1.
    pub share: f64,
}

/// The faces round a vertex and the sum of their normals.
#[derive(Clone, Debug, PartialEq)]
pub struct VertexShares {
    pub origin: NormalOrigin,
    /// In the order of the mesh. Where the normal is given, all that meet at the point, without weights.
    pub faces: Vec<FaceShare>,
    /// Whether the mirror images in x of these faces count as much: the shape goes on beyond its border.
    pub mirrored: bool,
    /// `Σ share·N`, before it is made a unit vector; zero where nothing is averaged.
    pub sum: DVec3,
}

impl Mesh {
    /// The point of vertex `vertex` of `vertices`, which [`Mesh::with_vertex_normals`] made of this mesh. Nothing for a
    /// vertex of no face.
    pub fn point_of_vertex(&self, vertices: &VertexMesh, vertex: u32) -> Option<u32> {
        let corner = vertices.indices.iter().position(|index| *index == vertex)?;
        Some(self.corners[corner].position)
    }

    /// Where the normal of vertex `vertex` of `vertices` comes from: `vertices` is what [`Mesh::with_vertex_normals`] made
    /// of this mesh by the same `source` and `weighting`. Takes time in proportion to the number of corners.
    pub fn vertex_shares(
        &self,
        vertices: &VertexMesh,
        vertex: u32,
        source: NormalSource,
        weighting: Weighting,
    ) -> VertexShares {
        let Some(point) = self.point_of_vertex(vertices, vertex) else {
            return VertexShares { origin: NormalOrigin::Nowhere, faces: vec![], mirrored: false, sum: DVec3::ZERO };
        };
        match source {
            NormalSource::Facet => self.shares_of(vertices, vertex, NormalOrigin::Facet),
            NormalSource::Averaged => self.averaged_shares(point, weighting),
            NormalSource::Exact | NormalSource::File => {
                let own = |(c, _): &(usize, _)| vertices.indices[*c] == vertex;
                let given = self.corners.iter().enumerate().find(own).is_some_and(|(_, c)| c.normal != NO_NORMAL);
                if given {
                    self.shares_of(vertices, vertex, NormalOrigin::Given)
                } else {
                    self.averaged_shares(point, weighting)
                }
            }
        }
    }

    /// The corners at which `chosen` holds, with their face and their number in it.
    fn corners_where(&self, chosen: impl Fn(usize) -> bool) -> impl Iterator<Item = (usize, usize)> {
        let corners = (0..self.corners.len()).filter(move |c| chosen(*c));
        corners.map(|c| {
            let face = self.starts.partition_point(|start| *start as usize <= c) - 1;
            (face, c - self.starts[face] as usize)
        })
    }

    /// The faces that have `vertex` itself among their corners; a facet counts whole, any other not at all.
    fn shares_of(&self, vertices: &VertexMesh, vertex: u32, origin: NormalOrigin) -> VertexShares {
        let one = f64::from(u8::from(origin == NormalOrigin::Facet));
        let corners = self.corners_where(|c| vertices.indices[c] == vertex);
        let share = |(f, _)| FaceShare { face: f as u32, normal: self.face_normal(f), weight: one, share: one };
        let faces: Vec<FaceShare> = corners.map(share).collect();
        let sum = faces.iter().map(|face| face.normal * face.share).sum();
        VertexShares { origin, faces, mirrored: false, sum }
    }

    /// The faces at a point with their weights, added as the averaging adds them.
    fn averaged_shares(&self, point: u32, weighting: Weighting) -> VertexShares {
        let mut sum = DVec4::ZERO;
        let mut faces = Vec::new();
        for (f, k) in self.corners_where(|c| self.corners[c].position == point) {
            let known = self.normal_and_area(f);
            let weight = known.map_or(0.0, |known| self.corner_weight(f, k, known, weighting));
            let normal = known.map_or(DVec3::ZERO, |(normal, _)| normal);
            sum += weighted(normal, weight);
            faces.push(FaceShare { face: f as u32, normal, weight, share: 0.0 });
        }
        let mirrored = self.mirrored.contains(&point);
        if mirrored {
            sum.x = 0.0;
        }
        if sum.w > 0.0 {
            faces.iter_mut().for_each(|face| face.share = face.weight / sum.w);
        }
        let origin = match (direction_of(sum), sum.w > 0.0) {
            (Some(_), _) => NormalOrigin::Averaged,
            (None, true) => NormalOrigin::FirstFace,
            (None, false) => NormalOrigin::Nowhere,
        };
        let sum = if sum.w > 0.0 { sum.truncate() / sum.w } else { DVec3::ZERO };
        VertexShares { origin, faces, mirrored, sum }
    }
}
