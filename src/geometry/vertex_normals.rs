//! Vertex normals: from a mesh with shared points to vertices with one normal each, the faces that each normal comes from,
//! and their weights.

use super::buckets::Buckets;
use super::mesh::{Mesh, NO_NORMAL, VertexMesh};
use crate::scene::{NormalSource, Weighting};
use glam::{DVec3, DVec4, Vec3};
use serde::Serialize;
use std::collections::HashMap;
use std::f64::consts::TAU;

/// The share of their weights below which a sum of cancelling face normals is rounding and has no direction.
const CANCELLED: f64 = 1e-9;

/// The normal of a vertex at which no face has an area.
const NO_DIRECTION: Vec3 = Vec3::Z;

impl Mesh {
    /// Gives every vertex its normal, in time linear in the number of corners.
    ///
    /// - `Averaged`: one vertex per point; all faces that meet there count, by `weighting`. Faces without area do not.
    /// - `Exact` and `File`: the mesh's own `normals`, averaged ones at corners that have none. A vertex is a distinct
    ///   pair of point and normal.
    /// - `Facet`: every face has vertices of its own, with its own normal.
    ///
    /// A vertex at which faces of different materials or colours meet is one for each of them.
    ///
    /// # Guarantees
    /// Every normal has unit length. Where the average is zero (opposed faces), it is the normal of the first face there
    /// that has an area; where none has, +z.
    pub fn with_vertex_normals(&self, source: NormalSource, weighting: Weighting) -> VertexMesh {
        let vertices = match source {
            NormalSource::Facet => return self.faceted(),
            NormalSource::Averaged => {
                self.with_one_normal_per_point(self.averaged_normals(weighting))
            }
            NormalSource::Exact | NormalSource::File => self.with_given_normals(weighting),
        };
        vertices.with_one_look_per_vertex()
    }

    fn vertex_mesh(
        &self,
        positions: Vec<Vec3>,
        normals: Vec<Vec3>,
        corners: Vec<u32>,
    ) -> VertexMesh {
        VertexMesh {
            origin: self.origin,
            positions,
            normals,
            starts: self.starts.clone(),
            corners,
            cut: self.cut.clone(),
            mirrored: vec![],
            closed: self.closed,
            convex: self.convex,
            materials: self.materials.clone(),
            face_materials: self.face_materials.clone(),
            colors: self.colors.clone(),
            corner_colors: self.corner_colors.clone(),
            remarks: vec![],
        }
    }

    fn with_one_normal_per_point(&self, normals: Vec<Vec3>) -> VertexMesh {
        let indices = self.corners.iter().map(|corner| corner.position).collect();
        self.vertex_mesh(self.positions.clone(), normals, indices)
    }

    fn faceted(&self) -> VertexMesh {
        let positions = self
            .corners
            .iter()
            .map(|corner| self.positions[corner.position as usize])
            .collect();
        let mut normals = Vec::with_capacity(self.corners.len());
        for f in 0..self.face_count() {
            let normal = unit_or(self.face_normal(f), NO_DIRECTION);
            normals.extend(self.face(f).iter().map(|_| normal));
        }
        self.vertex_mesh(positions, normals, (0..self.corners.len() as u32).collect())
    }

    fn with_given_normals(&self, weighting: Weighting) -> VertexMesh {
        let complete = self.corners.iter().all(|corner| corner.normal != NO_NORMAL);
        let averaged = if complete {
            Vec::new()
        } else {
            self.averaged_normals(weighting)
        };
        let normal_at = |c: u32| {
            let corner = self.corners[c as usize];
            match self.normals.get(corner.normal as usize) {
                Some(&normal) => normal,
                None => averaged[corner.position as usize],
            }
        };
        match self.agreed_normals(normal_at) {
            Some(normals) => self.with_one_normal_per_point(normals),
            None => self.with_split_points(normal_at),
        }
    }

    /// Returns the normal of each point, if all corners that meet there have the same one.
    fn agreed_normals(&self, normal_at: impl Fn(u32) -> Vec3) -> Option<Vec<Vec3>> {
        const UNSEEN: Vec3 = Vec3::ZERO;
        let mut normals = vec![UNSEEN; self.positions.len()];
        for (c, corner) in self.corners.iter().enumerate() {
            let normal = normal_at(c as u32);
            let agreed = &mut normals[corner.position as usize];
            if *agreed == UNSEEN {
                *agreed = normal;
            } else if *agreed != normal {
                return None;
            }
        }
        normals
            .iter_mut()
            .filter(|normal| **normal == UNSEEN)
            .for_each(|normal| *normal = NO_DIRECTION);
        Some(normals)
    }

    /// Makes one vertex for each distinct normal at each point.
    fn with_split_points(&self, normal_at: impl Fn(u32) -> Vec3) -> VertexMesh {
        let corners = (0..)
            .zip(&self.corners)
            .map(|(c, corner)| (corner.position, c));
        let mut around = Buckets::new(self.positions.len(), corners);
        let mut positions = Vec::with_capacity(self.positions.len());
        let mut normals: Vec<Vec3> = Vec::with_capacity(self.positions.len());
        let mut indices = vec![0; self.corners.len()];
        for (p, &position) in self.positions.iter().enumerate() {
            let corners = around.at_mut(p);
            // Sorting brings equal normals together however many there are; searching would take quadratic time.
            corners.sort_unstable_by_key(|&c| normal_at(c).to_array().map(f32::to_bits));
            let first_here = normals.len();
            for &mut c in corners {
                let normal = normal_at(c);
                if normals.len() == first_here || normals.last() != Some(&normal) {
                    positions.push(position);
                    normals.push(normal);
                }
                indices[c as usize] = normals.len() as u32 - 1;
            }
        }
        self.vertex_mesh(positions, normals, indices)
    }

    fn averaged_normals(&self, weighting: Weighting) -> Vec<Vec3> {
        let mut sums = vec![DVec4::ZERO; self.positions.len()];
        for f in 0..self.face_count() {
            let Some((normal, area)) = self.normal_and_area(f) else {
                continue;
            };
            for (k, corner) in self.face(f).iter().enumerate() {
                sums[corner.position as usize] +=
                    weighted(normal, self.corner_weight(f, k, (normal, area), weighting));
            }
        }
        for &point in &self.mirrored {
            sums[point as usize].x = 0.0;
        }
        let mut normals: Vec<Vec3> = sums
            .iter()
            .map(|&sum| direction_of(sum).unwrap_or(Vec3::ZERO))
            .collect();
        if normals.contains(&Vec3::ZERO) {
            self.fill_from_faces(&mut normals);
        }
        normals
    }

    /// Returns the weight of face `f`, of this normal and area, in the average at its corner `k`: 1, its area, or its
    /// interior angle there in radians.
    #[inline]
    fn corner_weight(
        &self,
        f: usize,
        k: usize,
        (normal, area): (DVec3, f64),
        weighting: Weighting,
    ) -> f64 {
        match weighting {
            Weighting::Equal => 1.0,
            Weighting::Area => area,
            Weighting::Angle => {
                let corners = self.face(f);
                let at = |k: usize| {
                    self.positions[corners[k % corners.len()].position as usize].as_dvec3()
                };
                interior_angle(at(k + corners.len() - 1), at(k), at(k + 1), normal)
            }
        }
    }

    /// Gives each point whose normal is still zero that of the first face there with an area, or else +z.
    fn fill_from_faces(&self, normals: &mut [Vec3]) {
        for f in 0..self.face_count() {
            for corner in self.face(f) {
                let normal = &mut normals[corner.position as usize];
                if *normal == Vec3::ZERO {
                    *normal = unit_or(self.face_normal(f), Vec3::ZERO);
                }
            }
        }
        normals
            .iter_mut()
            .filter(|normal| **normal == Vec3::ZERO)
            .for_each(|normal| *normal = NO_DIRECTION);
    }
}

impl VertexMesh {
    /// Splits the vertices at which faces of different materials, or corners of different colours, meet. The first one's vertex
    /// stays; the others are appended.
    fn with_one_look_per_vertex(mut self) -> Self {
        if self.face_materials.is_empty() && self.corner_colors.is_empty() {
            return self;
        }
        let mut own = vec![None; self.positions.len()];
        let mut others: HashMap<(u32, (u16, [u32; 3])), u32> = HashMap::new();
        for f in 0..self.face_count() {
            let material = self.face_material(f);
            for c in self.starts[f] as usize..self.starts[f + 1] as usize {
                let vertex = self.corners[c];
                let look = (material, self.corner_color(c).to_array().map(f32::to_bits));
                if *own[vertex as usize].get_or_insert(look) == look {
                    continue;
                }
                self.corners[c] = *others.entry((vertex, look)).or_insert_with(|| {
                    self.positions.push(self.positions[vertex as usize]);
                    self.normals.push(self.normals[vertex as usize]);
                    self.positions.len() as u32 - 1
                });
            }
        }
        self
    }
}

/// Returns the angle inside a polygon with unit normal `normal` at `corner`, 0 to 2π.
///
/// For a plane polygon it is the angle between the edges. Where the corner's own plane is tilted by δ against the normal,
/// as on a warped polygon, an angle a between the edges counts as `atan2(cos δ·sin a, cos a)`.
fn interior_angle(previous: DVec3, corner: DVec3, next: DVec3, normal: DVec3) -> f64 {
    let (out, back) = (next - corner, previous - corner);
    let angle = normal.dot(out.cross(back)).atan2(out.dot(back));
    if angle < 0.0 { angle + TAU } else { angle }
}

/// Returns a normal times its weight, with the weight as the fourth number.
#[inline]
fn weighted(normal: DVec3, weight: f64) -> DVec4 {
    (normal * weight).extend(weight)
}

/// Returns the unit vector along a sum of [`weighted`] normals; `None` where they cancel.
fn direction_of(sum: DVec4) -> Option<Vec3> {
    let (normal, weight) = (sum.truncate(), sum.w);
    let length = normal.length();
    (length > CANCELLED * weight).then(|| (normal / length).as_vec3())
}

fn unit_or(normal: DVec3, fallback: Vec3) -> Vec3 {
    if normal == DVec3::ZERO {
        fallback
    } else {
        normal.as_vec3()
    }
}

/// The origin of a vertex's normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum NormalOrigin {
    /// The mean of the faces' normals, each with its weight.
    Averaged,
    /// The normal given with the mesh: the true surface's, or the file's.
    Given,
    /// The normal of the one face to which the vertex belongs.
    Facet,
    /// The normal of the first face there with an area, because the faces' normals cancel.
    FirstFace,
    /// None: no face there has an area.
    #[serde(rename = "none")]
    Nowhere,
}

/// A face that meets a vertex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FaceShare {
    /// The face's number in the mesh, from 0.
    pub face: u32,
    /// The unit normal; zero for a face without area.
    pub normal: DVec3,
    /// The weight by the rule: 1, the area in square world units, or the interior angle in radians. Zero where the face
    /// does not count.
    pub weight: f64,
    /// The weight divided by the sum of all, 0 to 1.
    pub share: f64,
}

/// The faces round a vertex and the sum of their normals.
#[derive(Clone, Debug, PartialEq)]
pub struct VertexShares {
    /// The origin of the vertex's normal.
    pub origin: NormalOrigin,
    /// The faces in the order of the mesh; where the normal is given, all that meet at the point, without weights.
    pub faces: Vec<FaceShare>,
    /// True if the mirror images in x of these faces count as much, because the shape continues beyond its border.
    pub mirrored: bool,
    /// `Σ share·N` before normalisation; zero where nothing is averaged.
    pub sum: DVec3,
}

impl Mesh {
    /// Returns the point of vertex `vertex` of `vertices`, which [`Mesh::with_vertex_normals`] made of this mesh; `None`
    /// for a vertex of no face.
    pub fn point_of_vertex(&self, vertices: &VertexMesh, vertex: u32) -> Option<u32> {
        let corner = vertices.corners.iter().position(|index| *index == vertex)?;
        Some(self.corners[corner].position)
    }

    /// Returns the faces behind the normal of vertex `vertex` of `vertices`, which [`Mesh::with_vertex_normals`] made of
    /// this mesh by the same `source` and `weighting`. Takes time in proportion to the number of corners.
    pub fn vertex_shares(
        &self,
        vertices: &VertexMesh,
        vertex: u32,
        source: NormalSource,
        weighting: Weighting,
    ) -> VertexShares {
        let Some(point) = self.point_of_vertex(vertices, vertex) else {
            return VertexShares {
                origin: NormalOrigin::Nowhere,
                faces: vec![],
                mirrored: false,
                sum: DVec3::ZERO,
            };
        };
        match source {
            NormalSource::Facet => self.shares_of(vertices, vertex, NormalOrigin::Facet),
            NormalSource::Averaged => self.averaged_shares(point, weighting),
            NormalSource::Exact | NormalSource::File => {
                let mut corners = self.corners.iter().zip(&vertices.corners);
                let own = corners.find(|(_, index)| **index == vertex);
                if own.is_some_and(|(corner, _)| corner.normal != NO_NORMAL) {
                    self.shares_of(vertices, vertex, NormalOrigin::Given)
                } else {
                    self.averaged_shares(point, weighting)
                }
            }
        }
    }

    /// Returns the corners at which `chosen` holds, as their face and their number in it.
    fn corners_where(
        &self,
        chosen: impl Fn(usize) -> bool,
    ) -> impl Iterator<Item = (usize, usize)> {
        let corners = (0..self.corners.len()).filter(move |c| chosen(*c));
        corners.map(|c| {
            let face = self.starts.partition_point(|start| *start as usize <= c) - 1;
            (face, c - self.starts[face] as usize)
        })
    }

    /// Returns the faces that have `vertex` itself among their corners; a facet counts in full, any other not at all.
    fn shares_of(&self, vertices: &VertexMesh, vertex: u32, origin: NormalOrigin) -> VertexShares {
        let one = f64::from(u8::from(origin == NormalOrigin::Facet));
        let corners = self.corners_where(|c| vertices.corners[c] == vertex);
        let share = |(f, _)| FaceShare {
            face: f as u32,
            normal: self.face_normal(f),
            weight: one,
            share: one,
        };
        let faces: Vec<FaceShare> = corners.map(share).collect();
        let sum = faces.iter().map(|face| face.normal * face.share).sum();
        VertexShares {
            origin,
            faces,
            mirrored: false,
            sum,
        }
    }

    /// Returns the faces at a point with their weights, added in the order of the averaging.
    fn averaged_shares(&self, point: u32, weighting: Weighting) -> VertexShares {
        let mut sum = DVec4::ZERO;
        let mut faces = Vec::new();
        for (f, k) in self.corners_where(|c| self.corners[c].position == point) {
            let known = self.normal_and_area(f);
            let weight = known.map_or(0.0, |known| self.corner_weight(f, k, known, weighting));
            let normal = known.map_or(DVec3::ZERO, |(normal, _)| normal);
            sum += weighted(normal, weight);
            faces.push(FaceShare {
                face: f as u32,
                normal,
                weight,
                share: 0.0,
            });
        }
        let mirrored = self.mirrored.contains(&point);
        if mirrored {
            sum.x = 0.0;
        }
        if sum.w > 0.0 {
            faces
                .iter_mut()
                .for_each(|face| face.share = face.weight / sum.w);
        }
        let origin = match (direction_of(sum), sum.w > 0.0) {
            (Some(_), _) => NormalOrigin::Averaged,
            (None, true) => NormalOrigin::FirstFace,
            (None, false) => NormalOrigin::Nowhere,
        };
        let sum = if sum.w > 0.0 {
            sum.truncate() / sum.w
        } else {
            DVec3::ZERO
        };
        VertexShares {
            origin,
            faces,
            mirrored,
            sum,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

    #[test]
    fn the_angle_of_a_tilted_corner_is_seen_along_the_polygons_normal_in_its_sine() {
        let at =
            |degrees: f64| DVec3::new(degrees.to_radians().cos(), degrees.to_radians().sin(), 0.0);
        let angle = |a: f64, normal: DVec3| interior_angle(at(a), DVec3::ZERO, at(0.0), normal);
        assert!((angle(60.0, DVec3::Z) - FRAC_PI_3).abs() < 1e-12);
        assert!(
            (angle(270.0, DVec3::Z) - 3.0 * FRAC_PI_2).abs() < 1e-12,
            "concave"
        );
        for tilt in [10.0_f64, 40.0, 70.0] {
            let normal = DVec3::new(0.0, tilt.to_radians().sin(), tilt.to_radians().cos());
            let expected = (normal.z * 60_f64.to_radians().sin()).atan2(60_f64.to_radians().cos());
            assert!((angle(60.0, normal) - expected).abs() < 1e-12, "{tilt}");
            assert!(
                (angle(90.0, normal) - FRAC_PI_2).abs() < 1e-12,
                "a right angle stays one"
            );
        }
    }
}
