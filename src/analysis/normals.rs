//! The normals of a scene's polygons and vertices, and the faces that a vertex normal comes from. A polygon is seen
//! from its front where N·(eye − centre) > 0; a vertex is visible if one of its polygons is, whichever way its normal
//! leans.

mod fine;
mod lit;
mod needles;
mod report;
mod sphere;

pub use lit::{LitVertex, draw_normals};
pub use needles::{Needle, NeedleKind, Needles};
pub use report::{FoundNormal, NormalsQuestion};

use crate::geometry::{Mesh, NormalOrigin, VertexMesh, angle};
use crate::render::Renderer;
use crate::scene::{NormalSource, Object, Projection, View, Weighting};
use glam::{DVec2, DVec3};
use serde::Serialize;
use std::sync::Arc;

/// Distance behind the surface that its pixel sees, in median edges, beyond which a point is hidden. Less is a
/// neighbouring polygon seen at a grazing angle, or the true surface in front of the polygons that approximate it.
const BEHIND: f64 = 0.5;

/// The polygons of an object with their normals, and its vertices with theirs.
#[derive(Clone, Debug)]
pub struct NormalField {
    mesh: Arc<Mesh>,
    vertices: VertexMesh,
    /// Source of the vertices' normals.
    pub source: NormalSource,
    /// Weighting of the polygons in an averaged normal.
    pub weighting: Weighting,
    /// Centre, world, and unit normal of each face.
    faces: Vec<[DVec3; 2]>,
    /// Median length of an edge, world units; 0 where there is none.
    pub median_edge: f64,
}

/// A vertex, its normal, and the faces that the normal comes from.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VertexNormal {
    /// Number of the vertex in the mesh, from 0.
    pub vertex: u32,
    /// Position in world coordinates.
    pub position: DVec3,
    /// Unit normal.
    pub normal: DVec3,
    /// Origin of the normal: averaged, given or the true surface's.
    pub origin: NormalOrigin,
    /// The faces that meet at the vertex.
    pub faces: Vec<VertexFace>,
    /// True if the faces' mirror images in x count as much.
    pub mirrored: bool,
    /// `Σ share·N`, before normalisation; zero where nothing is averaged.
    pub sum: DVec3,
    /// Length of the sum: 1 where the faces lie in one plane, 0 where their normals cancel.
    pub length: f64,
}

/// A face at a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct VertexFace {
    /// Number of the face in the mesh, from 0.
    pub face: u32,
    /// Mean of the corners, world.
    pub centre: DVec3,
    /// Unit normal; zero for a face without area.
    pub normal: DVec3,
    /// Weight: 1, the area in square world units, or the angle in degrees; zero where nothing is averaged.
    pub weight: f64,
    /// The weight divided by the sum of all weights.
    pub share: f64,
    /// Degrees between its normal and the vertex's.
    pub angle: f64,
}

/// A normal at its point, visible in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenNormal {
    /// Number of the face or vertex.
    pub index: u32,
    /// World position: a face's centre, or the vertex.
    pub point: DVec3,
    /// Unit normal.
    pub normal: DVec3,
    /// Position of the point in the picture, pixels.
    pub pixel: DVec2,
    /// Distance along the viewing direction, world units.
    pub depth: f64,
}

/// The normals of a field that face the eye in a picture, before occlusion is tested.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeenNormals {
    /// The faces' normals, at their centres.
    pub faces: Vec<SeenNormal>,
    /// The vertices' normals.
    pub vertices: Vec<SeenNormal>,
}

impl NormalField {
    /// Returns the normals of the object that `renderer` last drew, with `object`'s choice of source and weights.
    pub fn new(renderer: &Renderer, object: &Object) -> Self {
        Self::of_mesh(
            Arc::clone(renderer.mesh_shown()),
            object.normal_source(),
            object.weighting,
        )
    }

    /// Returns the normals of a mesh.
    pub fn of_mesh(mesh: Arc<Mesh>, source: NormalSource, weighting: Weighting) -> Self {
        let vertices = mesh.with_vertex_normals(source, weighting);
        let faces = (0..mesh.face_count())
            .map(|f| [mesh.face_centre(f), mesh.face_normal(f)])
            .collect();
        Self {
            median_edge: median_edge(&mesh),
            mesh,
            vertices,
            source,
            weighting,
            faces,
        }
    }

    /// Returns whether the field equals what [`Self::new`] would create.
    pub fn holds(&self, renderer: &Renderer, object: &Object) -> bool {
        let same_weights = self.weighting == object.weighting || !self.weighs();
        Arc::ptr_eq(&self.mesh, renderer.mesh_shown())
            && self.source == object.normal_source()
            && same_weights
    }

    /// Returns whether points and faces have the same numbers as in the mesh last drawn, with any normals.
    pub fn of_equal_mesh(&self, renderer: &Renderer) -> bool {
        let (own, other) = (&self.mesh, renderer.mesh_shown());
        Arc::ptr_eq(own, other) || (own.starts == other.starts && own.corners == other.corners)
    }

    /// Returns whether the weighting affects the normals.
    pub fn weighs(&self) -> bool {
        matches!(self.source, NormalSource::Averaged | NormalSource::File)
    }

    /// Returns the number of vertices, one for each pair of a point and a normal.
    pub fn vertex_count(&self) -> usize {
        self.vertices.positions.len()
    }

    /// Returns the number of faces in the mesh.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// Returns the corners of a face, world.
    pub fn outline(&self, face: u32) -> Vec<DVec3> {
        self.vertices
            .face(face as usize)
            .iter()
            .map(|&v| self.position(v))
            .collect()
    }

    /// Projects the outlines of the faces whose front faces the eye, in pixels; those that reach behind the eye are
    /// left out.
    pub fn facing_outlines(&self, view: &View) -> Vec<Vec<DVec2>> {
        let outline = |face: usize| -> Option<Vec<DVec2>> {
            let corners = self.outline(u32::try_from(face).ok()?).into_iter();
            let points: Option<Vec<DVec2>> = corners
                .map(|corner| Some(view.project(corner)?.0))
                .collect();
            points.filter(|points| points.len() > 2 && runs_counter_clockwise(points))
        };
        (0..self.face_count()).filter_map(outline).collect()
    }

    /// Returns the point of the mesh at which a vertex lies; its number does not depend on the choice of normals.
    pub fn point_of(&self, vertex: u32) -> Option<u32> {
        self.mesh.point_of_vertex(&self.vertices, vertex)
    }

    /// Returns a vertex at a point of the mesh.
    pub fn vertex_at(&self, point: u32) -> Option<u32> {
        let corner = self
            .mesh
            .corners
            .iter()
            .position(|corner| corner.position == point)?;
        Some(self.vertices.corners[corner])
    }

    /// Returns a vertex with its normal and faces, if it exists; takes time in proportion to the mesh's corners.
    pub fn vertex(&self, vertex: u32) -> Option<VertexNormal> {
        let normal = self.vertices.normals.get(vertex as usize)?.as_dvec3();
        let shares = self
            .mesh
            .vertex_shares(&self.vertices, vertex, self.source, self.weighting);
        let degrees = self.weighting == Weighting::Angle && shares.origin == NormalOrigin::Averaged;
        let faces = shares.faces.iter().map(|share| VertexFace {
            face: share.face,
            centre: self.faces[share.face as usize][0],
            normal: share.normal,
            weight: if degrees {
                share.weight.to_degrees()
            } else {
                share.weight
            },
            share: share.share,
            angle: angle(share.normal, normal).to_degrees(),
        });
        Some(VertexNormal {
            vertex,
            position: self.position(vertex),
            normal,
            origin: shares.origin,
            faces: faces.collect(),
            mirrored: shares.mirrored,
            sum: shares.sum,
            length: shares.sum.length(),
        })
    }

    /// Returns the faces that turn their front to the eye and the vertices of such faces, where they appear in a
    /// picture of `size` pixels. Those that other parts hide are included: see [`NormalField::hidden`].
    pub fn facing(&self, view: &View, size: [u32; 2]) -> SeenNormals {
        let picture = DVec2::from_array(size.map(f64::from));
        let seen = |index: u32, point: DVec3, normal: DVec3| {
            let (pixel, depth) = view.project(point)?;
            let inside = pixel.cmpge(DVec2::ZERO).all() && pixel.cmplt(picture).all();
            inside.then_some(SeenNormal {
                index,
                point,
                normal,
                pixel,
                depth,
            })
        };
        let towards = |point: DVec3| match view.projection {
            Projection::Perspective => view.eye - point,
            Projection::Orthographic => -view.forward,
        };
        let mut faces = Vec::new();
        let mut on_front = vec![false; self.vertices.positions.len()];
        for (f, [centre, normal]) in (0u32..).zip(&self.faces) {
            if normal.dot(towards(*centre)) > 0.0 {
                faces.extend(seen(f, *centre, *normal));
                self.vertices
                    .face(f as usize)
                    .iter()
                    .for_each(|&v| on_front[v as usize] = true);
            }
        }
        let vertex = |v: u32| {
            seen(
                v,
                self.position(v),
                self.vertices.normals[v as usize].as_dvec3(),
            )
        };
        let vertices = (0u32..)
            .zip(&on_front)
            .filter(|(_, front)| **front)
            .filter_map(|(v, _)| vertex(v));
        SeenNormals {
            vertices: vertices.collect(),
            faces,
        }
    }

    /// Returns whether something hides a point in the picture that `renderer` last drew.
    pub fn hidden(&self, renderer: &Renderer, seen: &SeenNormal) -> bool {
        let before = renderer
            .evaluation_seen(seen.pixel)
            .map(|pixel| pixel.depth);
        before.is_some_and(|depth| depth + BEHIND * self.median_edge < seen.depth)
    }

    /// Returns the visible vertex nearest to `pixel`, within `reach` pixels; of several at a point that of the face
    /// seen there.
    pub fn vertex_near(
        &self,
        renderer: &Renderer,
        seen: &SeenNormals,
        pixel: DVec2,
        reach: f64,
    ) -> Option<SeenNormal> {
        let distance = |vertex: &SeenNormal| vertex.pixel.distance(pixel);
        let mut near: Vec<&SeenNormal> = seen
            .vertices
            .iter()
            .filter(|vertex| distance(vertex) <= reach)
            .collect();
        near.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        let nearest = near
            .iter()
            .position(|vertex| !self.hidden(renderer, vertex))?;
        let under = renderer.evaluation_seen(pixel).and_then(|pixel| pixel.face);
        let upon = |vertex: &&&SeenNormal| {
            under.is_some_and(|face| self.vertices.face(face as usize).contains(&vertex.index))
        };
        let same = |vertex: &&&SeenNormal| vertex.point == near[nearest].point;
        let chosen = near[nearest..]
            .iter()
            .take_while(same)
            .find(upon)
            .unwrap_or(&near[nearest]);
        Some(**chosen)
    }

    fn position(&self, vertex: u32) -> DVec3 {
        self.vertices.origin + self.vertices.positions[vertex as usize].as_dvec3()
    }
}

/// Returns the median length of an even selection of edges, so that a large mesh costs no more than a small one.
fn median_edge(mesh: &Mesh) -> f64 {
    const TAKEN: usize = 4096;
    let faces = mesh.face_count();
    let mut lengths: Vec<f64> = Vec::new();
    for f in (0..faces).step_by(faces.div_ceil(TAKEN).max(1)) {
        let points: Vec<DVec3> = mesh.face_points(f).collect();
        let next = points.iter().cycle().skip(1);
        lengths.extend(
            points
                .iter()
                .zip(next)
                .map(|(a, b)| a.distance(*b))
                .filter(|length| *length > 0.0),
        );
    }
    let middle = lengths.len() / 2;
    if lengths.is_empty() {
        0.0
    } else {
        *lengths.select_nth_unstable_by(middle, f64::total_cmp).1
    }
}
/// Returns whether points of a picture run counter-clockwise, as those of a polygon whose front faces the eye.
fn runs_counter_clockwise(points: &[DVec2]) -> bool {
    let next = points.iter().cycle().skip(1);
    let area: f64 = points.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum();
    area < 0.0
}
