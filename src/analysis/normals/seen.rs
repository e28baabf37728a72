//! Which normals a picture shows.

use super::NormalField;
use crate::render::Renderer;
use crate::scene::{Projection, View};
use glam::{DVec2, DVec3};

/// A point that lies farther behind what its pixel sees than this many median edges is hidden. Less is a neighbouring
/// polygon seen at a grazing angle, or the true surface before the polygons that stand for it.
const BEHIND: f64 = 0.5;

/// A normal at its point, which the picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeenNormal {
    /// The face's or the vertex' number.
    pub index: u32,
    /// World: a face's centre, or the vertex.
    pub point: DVec3,
    /// Unit.
    pub normal: DVec3,
    /// Where the point appears, pixels.
    pub pixel: DVec2,
    /// Distance along the viewing direction, world units.
    pub depth: f64,
}

/// What a picture shows of a field, before it is asked what hides what.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeenNormals {
    pub faces: Vec<SeenNormal>,
    pub vertices: Vec<SeenNormal>,
}

impl NormalField {
    /// The faces that turn their front to the eye and the vertices of such faces, where they appear in a picture of `size`
    /// pixels. Those that other parts hide are among them: see [`NormalField::hidden`].
    pub fn facing(&self, view: &View, size: [u32; 2]) -> SeenNormals {
        let picture = DVec2::from_array(size.map(f64::from));
        let seen = |index: u32, point: DVec3, normal: DVec3| {
            let (pixel, depth) = view.project(point)?;
            let inside = pixel.cmpge(DVec2::ZERO).all() && pixel.cmplt(picture).all();
            inside.then_some(SeenNormal { index, point, normal, pixel, depth })
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
                self.vertices.face(f as usize).iter().for_each(|&v| on_front[v as usize] = true);
            }
        }
        let front = (0u32..).zip(&on_front).filter(|(_, front)| **front);
        let vertices =
            front.filter_map(|(v, _)| seen(v, self.position(v), self.vertices.normals[v as usize].as_dvec3()));
        SeenNormals { vertices: vertices.collect(), faces }
    }

    /// Whether what `renderer` last drew has something else before a point.
    pub fn hidden(&self, renderer: &Renderer, seen: &SeenNormal) -> bool {
        let before = renderer.evaluation_seen(seen.pixel).map(|pixel| pixel.depth);
        before.is_some_and(|depth| depth + BEHIND * self.median_edge() < seen.depth)
    }

    /// The vertex whose place in the picture is next to `pixel`, within `reach` pixels, of those that are seen. Where
    /// several share a point it is that of the face under the pixel.
    pub fn vertex_near(&self, renderer: &Renderer, seen: &SeenNormals, pixel: DVec2, reach: f64) -> Option<SeenNormal> {
        let distance = |vertex: &SeenNormal| vertex.pixel.distance(pixel);
        let mut near: Vec<&SeenNormal> = seen.vertices.iter().filter(|vertex| distance(vertex) <= reach).collect();
        near.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        let nearest = near.iter().position(|vertex| !self.hidden(renderer, vertex))?;
        let under = renderer.evaluation_seen(pixel).and_then(|pixel| pixel.face);
        let upon =
            |vertex: &&&SeenNormal| under.is_some_and(|face| self.vertices.face(face as usize).contains(&vertex.index));
        let same = |vertex: &&&SeenNormal| vertex.point == near[nearest].point;
        let chosen = near[nearest..].iter().take_while(same).find(upon).unwrap_or(&near[nearest]);
        Some(**chosen)
    }
}
